"""Which compiler is taken, with which flags, and what is said where it fails."""

import ctypes
import os
import select
import shlex
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from command_line import rejects
from logged_compiler import ADD, CHILD, LoggedCompiler, load_adder, run_child, script

from stewart_sym.backend import native

# --- compilers


def test_no_compiler_is_one_line_that_says_what_to_do(no_compiler: None) -> None:
    assert native.find_compiler() is None
    with pytest.raises(native.CompilerError) as caught:
        native.load("adder", ADD)
    expected = "no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`"
    assert str(caught.value) == expected


def test_order_of_compilers(no_compiler: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def install(folder: Path, name: str, code: int = 0) -> Path:
        folder.mkdir(parents=True, exist_ok=True)
        script(folder / name, f"echo '{name} 1.0'\necho more\nexit {code}")
        return folder

    found = []
    for name in ("clang", "gcc", "cc"):
        path = install(tmp_path / name, name)
        monkeypatch.setenv("PATH", f"{path}{os.pathsep}{os.environ['PATH']}")
        assert native.find_compiler() == native.Compiler((str(path / name),), f"{name} 1.0")
        found.append(path)
    # A `cc` that is only a stub is passed over.
    stub = install(tmp_path / "stub", "cc", code=1)
    monkeypatch.setenv("PATH", os.pathsep.join([str(stub), str(found[1])]))
    assert native.find_compiler() == native.Compiler((str(found[1] / "gcc"),), "gcc 1.0")
    monkeypatch.setenv("CC", f"{found[0] / 'clang'} -m64 '-DA=\"b c\"'")
    chosen = native.find_compiler()
    assert chosen is not None
    assert chosen.command == (str(found[0] / "clang"), "-m64", '-DA="b c"')


def test_ziglang_wheel_serves_when_there_is_nothing_else(
    cache: Path, tmp_path: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "wheels" / "ziglang"
    package.mkdir(parents=True)
    (package / "__init__.py").touch()
    (package / "__main__.py").write_text(
        f"import os, sys\nassert sys.argv[1] == 'cc'\nos.environ['PATH'] = {os.environ['PATH']!r}\n"
        "assert os.path.isdir(os.environ['ZIG_GLOBAL_CACHE_DIR'])\n"
        f"os.execv({str(compiler.path)!r}, ['cc', *sys.argv[2:]])\n"
    )
    (tmp_path / "empty").mkdir()
    monkeypatch.setenv("PATH", str(tmp_path / "empty"))
    monkeypatch.setenv("PYTHONPATH", str(package.parent), prepend=os.pathsep)
    monkeypatch.delenv("ZIG_GLOBAL_CACHE_DIR", raising=False)
    monkeypatch.delenv("CC")
    code = CHILD + "assert native.find_compiler().command[1:] == ('-m', 'ziglang', 'cc')\n"
    assert run_child(code).parent == cache.resolve()
    assert len(compiler.calls) == 1


@pytest.mark.parametrize(
    "broken", ["no-such-compiler -m64", "/no/such/compiler", "'unclosed", "''", "failing"]
)
def test_broken_cc_is_named_and_nothing_else_is_tried(
    broken: str, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if broken == "failing":
        broken = str(script(tmp_path / "failing", "echo 'licence expired'\nexit 3"))
    monkeypatch.setenv("CC", broken)
    with pytest.raises(native.CompilerError) as caught:
        load_adder()
    assert str(caught.value).startswith(f"CC={broken!r} is not a working C compiler: ")
    assert "\n" not in str(caught.value)


def test_environment_without_path_still_compiles(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PATH")
    assert run_child().parent == cache.resolve()


def test_blank_cc_is_no_cc(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CC", raising=False)
    usual = native.find_compiler()
    assert usual is not None
    monkeypatch.setenv("CC", "  ")
    assert native.find_compiler() == usual


def test_compile_error_shows_the_first_error_and_keeps_the_log(cache: Path, compiler: LoggedCompiler) -> None:
    source = "int f(void) { return no_such_name; }\nint g(void) { return nor_this; }\n"
    with pytest.raises(native.CompilerError) as caught:
        native.load("wrong", {"wrong.c": source})
    message = str(caught.value)
    assert "can't compile wrong: wrong.c:1:" in message
    assert "no_such_name" in message
    assert "\n" not in message
    assert "nor_this" in caught.value.log
    assert "nor_this" not in message


def test_compiler_that_writes_no_library_is_an_error(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", str(script(tmp_path / "idle", "exit 0")))
    with pytest.raises(native.CompilerError, match="compiled adder but wrote no library"):
        load_adder()


def test_flags_are_strict_arithmetic(cache: Path, compiler: LoggedCompiler) -> None:
    load_adder(flags=("-O2",))
    (call,) = compiler.calls
    words = call.split()
    arithmetic = ("-O3", "-fno-math-errno", "-ffp-contract=off", "-march=native")
    assert {*arithmetic, "-std=c99", "-fPIC", "-shared", "-lm"} <= set(words)
    assert words.index("-O3") < words.index("-O2")
    assert not any("fast" in word for word in words)


def test_fast_math_is_rejected_wherever_it_stands(
    compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    rejects(r"^flags: -ffast-math changes the arithmetic", load_adder, flags=("-ffast-math",))
    monkeypatch.setenv("CC", f"{compiler.path} -Ofast")
    rejects(r"^CC: -Ofast changes the arithmetic", load_adder)
    assert compiler.calls == []


def test_compiler_that_does_not_know_march_native(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = 'case "$*" in *-march=native*) echo "error: bad value for -march" >&2; exit 1 ;; esac'
    logged = LoggedCompiler(tmp_path, before)
    monkeypatch.setenv("CC", str(logged.path))
    first = run_child()
    assert run_child() == first
    (call,) = logged.calls
    assert "-march" not in call


def test_hanging_compiler_is_killed_with_its_children(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    alive = tmp_path / "alive"
    os.mkfifo(alive)
    reader = os.open(alive, os.O_RDONLY | os.O_NONBLOCK)
    hang = f"(echo started; exec sleep 600) > {shlex.quote(str(alive))} & wait"
    logged = LoggedCompiler(tmp_path, before=f'case "$*" in *--version*) ;; *) {hang} ;; esac')
    monkeypatch.setenv("CC", str(logged.path))
    monkeypatch.setattr(native, "COMPILE_TIMEOUT", 3.0)
    with pytest.raises(native.CompilerError, match="took longer than 3 s to compile adder"):
        load_adder()
    assert list(cache.iterdir()) == []
    assert os.read(reader, 100) == b"started\n"
    # The pipe ends when the last process that holds it is gone; until then a read would block.
    assert select.select([reader], [], [], 300) == ([reader], [], [])
    assert os.read(reader, 100) == b""
    os.close(reader)


def test_compiler_has_no_standard_input(cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    logged = LoggedCompiler(tmp_path, before=f"cat > {shlex.quote(str(tmp_path / 'input'))}")
    monkeypatch.setenv("CC", str(logged.path))
    child = subprocess.Popen([sys.executable, "-c", CHILD], stdin=subprocess.PIPE, stdout=-1, stderr=-1)
    # The child's own input stays open until it is done: a compiler that shared it would wait for ever.
    assert child.wait(timeout=600) == 0
    child.communicate()
    assert (tmp_path / "input").read_bytes() == b""


# --- arguments and calls


def test_foreign_call_lets_other_threads_run(cache: Path) -> None:
    source = """
    #include <time.h>
    int meet(volatile int *entered, volatile int *go)
    {
        time_t limit = time(0) + 30;
        *entered = 1;
        while (!*go && time(0) < limit) { }
        return *go;
    }
    """
    library = native.load("meet", {"meet.c": source})
    entered, go = ctypes.c_int(0), ctypes.c_int(0)

    def answer() -> None:
        while not entered.value:
            time.sleep(0.001)
        go.value = 1

    thread = threading.Thread(target=answer)
    thread.start()
    # With the interpreter lock held, the thread could not see `entered` before the call gives up.
    assert library.meet(ctypes.byref(entered), ctypes.byref(go)) == 1
    thread.join()
