"""A plain install carries everything: both folders beside the package, the C sources and the robot files."""

import shutil
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).parent.parent
FOLDERS = ("stewart_sym", "derive", "generated")
CHECK = """
import sys, pathlib, warnings
sys.path.insert(0, sys.argv[1])
warnings.simplefilter("ignore")
import stewart_sym as ss
assert pathlib.Path(ss.__file__).is_relative_to(sys.argv[1]), ss.__file__
from stewart_sym.derive.generate import generated_files
path, _ = ss.PATHS["I"]
print(ss.inverse_dynamics(ss.robots.dasgupta1998(), path.sample([0.0, 1.0])).F.shape)
"""


def test_a_plain_install_carries_everything(tmp_path: Path) -> None:
    source, target = tmp_path / "source", tmp_path / "installed"
    for folder in FOLDERS:
        shutil.copytree(REPOSITORY / folder, source / folder, ignore=shutil.ignore_patterns("__pycache__"))
    for file in ("pyproject.toml", "README.md"):
        shutil.copy(REPOSITORY / file, source)
    install = ["-m", "pip", "install", "--quiet", "--no-deps", "--no-index", "--no-build-isolation"]
    subprocess.run([sys.executable, *install, "--target", str(target), str(source)], check=True, cwd=tmp_path)
    run = [sys.executable, "-I", "-c", CHECK, str(target)]
    done = subprocess.run(run, check=True, capture_output=True, text=True, cwd=tmp_path)
    assert done.stdout == "(2, 6)\n"
    package = target / "stewart_sym"
    shipped = {str(path.relative_to(package)) for path in package.rglob("*") if path.is_file()}
    renamed = {"stewart_sym": "", "derive": "derive/", "generated": "generated/"}
    for folder, prefix in renamed.items():
        for path in (source / folder).rglob("*"):
            if path.is_file() and path.suffix != ".pyc":
                assert prefix + str(path.relative_to(source / folder)) in shipped
