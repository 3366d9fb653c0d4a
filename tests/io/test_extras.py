"""Each module and subcommand needs the extras of its own work alone, and says in one line what is missing."""

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.io.extras import EXTRAS, install

PACKAGE = Path(ss.__file__).parent
MODULES = sorted(
    ".".join(("stewart_sym", *path.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__")
    for path in PACKAGE.rglob("*.py")
)
IMPORT_ALL = """
import importlib, json, sys
hidden, modules = json.loads(sys.argv[1])
sys.modules.update(dict.fromkeys(hidden))
errors = {}
for name in modules:
    try:
        importlib.import_module(name)
    except Exception as error:
        errors[name] = f"{type(error).__name__}: {error}"
print(json.dumps(errors))
"""


@pytest.mark.slow
def test_every_module_imports_with_numpy_sympy_and_scipy_alone_or_names_its_extra() -> None:
    hidden = sorted(set(EXTRAS) - {"scipy"})
    command = [sys.executable, "-c", IMPORT_ALL, json.dumps([hidden, MODULES])]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    errors: dict[str, str] = json.loads(done.stdout)
    assert errors, "some compare"
    for name, error in errors.items():
        assert error.startswith("ImportError: "), f"{name}: {error}"
        assert " needs " in error, f"{name}: {error}"
    assert not [name for name in errors if "benchmark" not in name]


RUN_ALL = """
import contextlib, io, json, sys
hidden, commands = json.loads(sys.argv[1])
sys.modules.update(dict.fromkeys(hidden))
from stewart_sym.backend import native
from stewart_sym.cli.main import main
from stewart_sym.cli.machine import forces, identify
def work(*_, **__):
    raise AssertionError("work began")
for module, name in ((forces, "in_parts"), (identify, "from_measurement")):
    setattr(module, name, work)
def told(command):
    with contextlib.redirect_stderr(io.StringIO()) as stream:
        code = main(command)
    return [code, stream.getvalue()]
print(json.dumps([told(command) for command in commands]))
"""


@pytest.mark.slow
def test_a_missing_scipy_is_said_in_one_line_before_the_work(tmp_path: Path) -> None:
    robot = str(PAPERS)
    log, scene, forces = (tmp_path / name for name in ("log.csv", "scene.toml", "forces.csv"))
    rows = (f"{0.1 * i!r},{0.2 + 0.01 * math.sin(i)!r},0.0,0.5,0.0,0.0,0.0" for i in range(60))
    log.write_text("\n".join(["time,t_x,t_y,t_z,theta_x,theta_y,theta_z", *rows]) + "\n")
    scene.write_text("schema = 1\n")
    out = ["-o", str(tmp_path / "out")]
    measured = ["identify", robot, *out, "--measured", str(log), str(forces)]
    commands = {
        "a trajectory without derivatives": [["forces", robot, str(log), *out]],
        "simulation": [["simulate", str(scene), *out]],
        "an estimate kept to bodies that can exist": [[*measured, "--enforce-physical"]],
        "a smooth motion without a period": [[*measured, "--position-std", "1e-4", "--angle-std", "1e-4"]],
    }
    hidden = [sorted(set(EXTRAS)), [command for group in commands.values() for command in group]]
    command = [sys.executable, "-c", RUN_ALL, json.dumps(hidden)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    whats = [what for what, group in commands.items() for _ in group]
    for what, (code, line) in zip(whats, json.loads(done.stdout), strict=True):
        assert code == 2, line
        assert line.startswith(f"stewart-sym: error: {what} needs SciPy: {install('sim')}")
        assert line.count("\n") == 1
    assert not (tmp_path / "out").exists()
