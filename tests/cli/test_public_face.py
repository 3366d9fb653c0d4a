"""What a reader of help(ss), dir(ss) and of a result at the prompt sees."""

import signal
import subprocess
import sys
import types

import pytest

import stewart_sym as ss


def test_dir_shows_what_is_public_and_nothing_else() -> None:
    assert set(dir(ss)) == {*ss.__all__, "__version__"}
    assert not any(
        isinstance(getattr(ss, name), types.ModuleType) for name in set(dir(ss)) - {"results", "robots"}
    )


def interruptible() -> None:
    """A job in the background has interrupts ignored, and so would its children."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def run(code: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, timeout=600, preexec_fn=interruptible)


def test_importing_the_package_imports_none_of_its_modules_and_no_numpy() -> None:
    done = run(
        "import sys, stewart_sym as ss; dir(ss)\n"
        "print(sorted(m for m in sys.modules if m == 'numpy' or m.startswith('stewart_sym.')))"
    )
    assert done.stdout == "[]\n", done.stderr


def test_a_command_line_that_cannot_be_imported_is_one_line() -> None:
    done = run("""
import sys
class Failing:
    def find_spec(self, name, path=None, target=None):
        if name == "numpy":
            raise MemoryError("no room\\nfor it")
sys.meta_path.insert(0, Failing())
from stewart_sym.__main__ import main
sys.argv = ["stewart-sym", "--version"]
sys.exit(main())
""")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "stewart-sym: error: cannot start: MemoryError: no room for it\n"


@pytest.mark.parametrize("module", ["stewart_sym.cli.main", "importlib.metadata"])
def test_an_interrupt_while_the_command_line_is_imported_is_a_clean_exit(module: str) -> None:
    done = run(f"""
import os, signal, sys
class Interrupting:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            os.kill(os.getpid(), signal.SIGINT)
from stewart_sym.__main__ import main
sys.modules.pop({module!r}, None)
sys.meta_path.insert(0, Interrupting())
sys.argv = ["stewart-sym", "--version"]
sys.exit(main())
""")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
