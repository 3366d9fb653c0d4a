"""A plain install carries everything: both folders beside the package, the C sources and the robot files."""

import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from installed import REPOSITORY, install

CHECK = """
import sys, pathlib, warnings
sys.path.insert(0, sys.argv[1])
warnings.simplefilter("ignore")
import stewart_sym as ss
assert pathlib.Path(ss.__file__).is_relative_to(sys.argv[1]), ss.__file__
from stewart_sym.derive.generate import generated_files
path, _ = ss.PAPER_PATHS["I"]
print(ss.inverse_dynamics(ss.robots.dasgupta1998(), path.sample([0.0, 1.0])).F.shape)
"""


SDIST = """
import sys
from setuptools import build_meta
print(build_meta.build_sdist(sys.argv[1]))
"""


@pytest.mark.slow
def test_tests_run_from_the_sdist(tmp_path: Path) -> None:
    """A copy of what git tracks, so that nothing is written beside the package."""
    if not (REPOSITORY / ".git").exists():
        pytest.skip("no git repository: setuptools-scm takes the list of files from it")
    subprocess.run(["git", "clone", "-q", str(REPOSITORY), str(tmp_path / "clone")], check=True)
    shutil.copy(REPOSITORY / "pyproject.toml", tmp_path / "clone")
    run = [sys.executable, "-c", SDIST, str(tmp_path)]
    subprocess.run(run, check=True, capture_output=True, cwd=tmp_path / "clone")
    (archive,) = tmp_path.glob("*.tar.gz")
    shutil.unpack_archive(archive, tmp_path)
    unpacked = tmp_path / archive.name.removesuffix(".tar.gz")
    tracked = subprocess.run(["git", "ls-files"], check=True, capture_output=True, text=True, cwd=REPOSITORY)
    missing = [name for name in tracked.stdout.splitlines() if not (unpacked / name).exists()]
    assert missing == []
    tests = ("tests/derive/test_conventions.py", "tests/kinematics/test_kinematics.py")
    test = [sys.executable, "-m", "pytest", "-q", "-n", "0", *tests]
    subprocess.run(test, check=True, capture_output=True, cwd=unpacked)


def test_licences_are_spdx_expressions_with_their_files(tmp_path: Path) -> None:
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text())["project"]
    assert project["license"] == "BSD-3-Clause"
    assert [REPOSITORY / name for name in project["license-files"]] == [REPOSITORY / "LICENSE"]


@pytest.mark.slow
def test_a_plain_install_carries_everything(tmp_path: Path) -> None:
    target = install(tmp_path)
    run = [sys.executable, "-I", "-c", CHECK, str(target)]
    done = subprocess.run(run, check=True, capture_output=True, text=True, cwd=tmp_path)
    assert done.stdout == "(2, 6)\n"
    package = target / "stewart_sym"
    shipped = {str(path.relative_to(package)) for path in package.rglob("*") if path.is_file()}
    renamed = {"stewart_sym": "", "derive": "derive/", "generated": "generated/"}
    for folder, prefix in renamed.items():
        source = tmp_path / "source" / folder
        for path in source.rglob("*"):
            if path.is_file() and path.suffix != ".pyc":
                assert prefix + str(path.relative_to(source)) in shipped
