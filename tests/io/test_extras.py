"""Each module and subcommand needs the extras of its own work alone, and says in one line what is missing."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

import stewart_sym as ss
from stewart_sym.io.error_policy import EXTRAS

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
def test_every_module_imports_with_numpy_sympy_and_scipy_alone() -> None:
    hidden = sorted(EXTRAS)
    command = [sys.executable, "-c", IMPORT_ALL, json.dumps([hidden, MODULES])]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == {}
