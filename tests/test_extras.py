"""Each module and subcommand needs the extras of its own work alone, and says in one line what is missing."""

import json
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import stewart_sym as ss
from stewart_sym.extras import EXTRAS

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


def errors_without(hidden: set[str]) -> dict[str, str]:
    """What importing each module of the package raises in a process without the hidden packages."""
    command = [sys.executable, "-c", IMPORT_ALL, json.dumps([sorted(hidden), MODULES])]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def of_extras(*extras: str) -> set[str]:
    return {package for package, (_, extra) in EXTRAS.items() if extra in extras}


def test_every_module_imports_with_numpy_sympy_and_scipy_alone_or_names_its_extra() -> None:
    errors = errors_without(set(EXTRAS) - {"scipy"})
    assert errors, "some draw, some compare"
    for name, error in errors.items():
        assert error.startswith("MissingExtraError: "), f"{name}: {error}"
        assert 'pip install "stewart-sym[' in error, f"{name}: {error}"
    drawing = ("bench", "drawing", "peers", "plot", "pictures", "labels", "workspace")
    assert not [name for name in errors if not any(part in name for part in drawing)]


def test_what_the_readme_installs_serves_all_but_the_comparisons() -> None:
    errors = errors_without(of_extras("bench", "casadi", "cluster"))
    assert {name.rpartition(".")[2] for name in errors} == {
        *("peers_casadi", "peers_constraints_mujoco", "peers_constraints_pinocchio", "peers_pinocchio"),
        "workspace",
    }


@pytest.mark.parametrize("package", sorted(set(EXTRAS) - {"mpl_toolkits", "distributed"}))
def test_each_optional_package_is_in_the_extra_that_is_named_for_it(package: str) -> None:
    project = tomllib.loads((PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needs = project["optional-dependencies"][EXTRAS[package][1]]
    assert any(need.startswith({"pinocchio": "pin"}.get(package, package)) for need in needs)
