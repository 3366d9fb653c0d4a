"""A plain install carries everything: both folders beside the package, the C sources and the robot files."""

import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest
from installed import REPOSITORY, installed

CHECK = """
import sys, pathlib, warnings
sys.path.insert(0, sys.argv[1])
warnings.simplefilter("ignore")
import stewart_sym as ss
assert pathlib.Path(ss.__file__).is_relative_to(sys.argv[1]), ss.__file__
from stewart_sym.derive.generated_files import generated_files
path, _ = ss.PAPER_PATHS["I"]
print(ss.inverse_dynamics(ss.robots.dasgupta1998(), path.sample([0.0, 1.0])).F.shape)
"""


BUILD = """
import sys
from setuptools import build_meta
folder = sys.argv[1]  # setuptools changes sys.argv
build_meta.build_sdist(folder)
build_meta.build_wheel(folder)
"""
LARGEST_FILE = 512 * 1024
"""Largest file of a source archive (bytes)."""
LARGEST_SDIST = 4 * 1024**2
"""Largest source archive (bytes)."""


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Return the sdist and the wheel of a clone, so that nothing is written next to the package."""
    folder = tmp_path_factory.mktemp("archives")
    subprocess.run(["git", "clone", "-q", str(REPOSITORY), str(folder / "clone")], check=True)
    for name in ("pyproject.toml", "LICENSE", "LICENSE.0BSD", "README.md"):
        shutil.copy(REPOSITORY / name, folder / "clone")
    run = [sys.executable, "-c", BUILD, str(folder)]
    subprocess.run(run, check=True, capture_output=True, cwd=folder / "clone")
    (sdist,), (wheel,) = folder.glob("*.tar.gz"), folder.glob("*.whl")
    return sdist, wheel


@pytest.mark.slow
def test_tests_run_from_the_sdist(archives: tuple[Path, Path], tmp_path: Path) -> None:
    sdist, _ = archives
    shutil.unpack_archive(sdist, tmp_path, filter="data")
    unpacked = tmp_path / sdist.name.removesuffix(".tar.gz")
    assert [name for name in exported() if not (unpacked / name).exists()] == []
    test = [sys.executable, "-m", "pytest", "-q", "-n", "0", "tests/kinematics/test_kinematics.py"]
    subprocess.run(test, check=True, capture_output=True, cwd=unpacked)


def exported() -> list[str]:
    """Return the tracked files without the attribute ``export-ignore``."""
    found = git("check-attr", "export-ignore", "--", *git("ls-files"))
    names = [line.removesuffix(": export-ignore: set") for line in found]
    return [name.split(": ")[0] for name in names if ": " in name and not name.startswith("tests/docs/")]


def git(*words: str) -> list[str]:
    """Return the lines that a git command prints."""
    done = subprocess.run(["git", *words], check=True, capture_output=True, text=True, cwd=REPOSITORY)
    return done.stdout.splitlines()


@pytest.mark.slow
def test_archives_are_small_and_pass_the_checks_of_the_package_index(archives: tuple[Path, Path]) -> None:
    sdist, wheel = archives
    with tarfile.open(sdist) as archive:
        assert {member.name: member.size for member in archive if member.size > LARGEST_FILE} == {}
    assert sdist.stat().st_size < LARGEST_SDIST
    for words in (
        ["twine", "check", "--strict", str(sdist), str(wheel)],
        ["check_wheel_contents", str(wheel)],
    ):
        done = subprocess.run([sys.executable, "-m", *words], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.slow
def test_a_plain_install_carries_everything(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    target = installed(tmp_path_factory)
    run = [sys.executable, "-I", "-c", CHECK, str(target)]
    done = subprocess.run(run, check=True, capture_output=True, text=True, cwd=tmp_path)
    assert done.stdout == "(2, 6)\n"
    package = target / "stewart_sym"
    shipped = {str(path.relative_to(package)) for path in package.rglob("*") if path.is_file()}
    renamed = {"stewart_sym": "", "derive": "derive/", "generated": "generated/"}
    for folder, prefix in renamed.items():
        source = target.parent / "source" / folder
        for path in source.rglob("*"):
            if path.is_file() and path.suffix != ".pyc":
                assert prefix + str(path.relative_to(source)) in shipped


def test_a_clone_shadows_an_installed_package_completely() -> None:
    """Python in a clone, without an editable install: the folders next to the package belong to it."""
    check = """
import sys
sys.meta_path = [finder for finder in sys.meta_path if "editable" not in repr(finder).lower()]
import stewart_sym.generated.interface, stewart_sym.derive
import stewart_sym as ss
print(ss.InverseDynamicsResult.__name__, stewart_sym.generated.interface.__file__)
"""
    run = [sys.executable, "-c", check]
    done = subprocess.run(run, cwd=REPOSITORY, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["InverseDynamicsResult", str(REPOSITORY / "generated" / "interface.py")]
