"""Compiling, caching and loading C: a sound library, or one line that gives the reason."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from logged_compiler import ADD, CHILD, LoggedCompiler, load_adder, obey_permissions, run_child, script

from stewart_sym.backend import native

# --- compilers


def test_no_compiler_is_one_line_with_a_remedy(no_compiler: None) -> None:
    assert native.find_compiler() is None
    with pytest.raises(native.CompilerError) as caught:
        native.load("adder", ADD)
    expected = "no C compiler found; install gcc or clang, set CC, or run `pip install ziglang`"
    assert str(caught.value) == expected


def test_order_of_compilers(no_compiler: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "ziglang"
    package.mkdir()
    (package / "__main__.py").write_text("print('zig 1.0')\n")
    monkeypatch.delitem(sys.modules, "ziglang")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    zig = (sys.executable, "-m", "ziglang", "cc")
    assert native.find_compiler() == native.Compiler(zig, "zig 1.0")
    for name, code in (("gcc", 0), ("cc", 1)):
        (tmp_path / name).mkdir()
        script(tmp_path / name / name, f"echo '{name} 1.0'\necho more\nexit {code}")
    # A `cc` that is only a stub is passed over.
    monkeypatch.setenv("PATH", os.pathsep.join([str(tmp_path / "cc"), str(tmp_path / "gcc")]))
    native._check_compiler.cache_clear()
    gcc = str(tmp_path / "gcc" / "gcc")
    assert native.find_compiler() == native.Compiler((gcc,), "gcc 1.0")
    monkeypatch.setenv("CC", f"{gcc} -m64 '-DA=\"b c\"'")
    assert native.find_compiler() == native.Compiler((gcc, "-m64", '-DA="b c"'), "gcc 1.0")


@pytest.mark.parametrize("broken", ["no-such-compiler -m64", "'unclosed", "failing"])
def test_broken_cc_is_named_and_nothing_else_is_tried(
    broken: str, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if broken == "failing":
        broken = str(script(tmp_path / "failing", "echo 'license expired'\nexit 3"))
    monkeypatch.setenv("CC", broken)
    with pytest.raises(native.CompilerError) as caught:
        load_adder()
    assert str(caught.value).startswith(f"CC={broken!r} is not a working C compiler: ")
    assert "\n" not in str(caught.value)


def test_compile_error_shows_the_first_error(cache: Path, compiler: LoggedCompiler) -> None:
    source = "int f(void) { return no_such_name; }\nint g(void) { return nor_this; }\n"
    with pytest.raises(native.CompilerError, match=r"^can't compile wrong: .* fails: wrong\.c:1:") as caught:
        native.load("wrong", {"wrong.c": source})
    message = str(caught.value)
    assert "no_such_name" in message
    assert "\n" not in message
    assert list(cache.glob("*.so")) == []


def test_compiler_that_does_not_know_march_native(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = 'case "$*" in *-march=native*) echo "error: bad value for -march" >&2; exit 1 ;; esac'
    logged = LoggedCompiler(tmp_path, before)
    monkeypatch.setenv("CC", str(logged.path))
    load_adder()
    (call,) = logged.calls
    assert "-march" not in call


# --- cache


def test_processes_starting_at_once_on_an_empty_cache_compile_once(
    cache: Path, tmp_path: Path, compiler: LoggedCompiler
) -> None:
    wait = "import os, time\nwhile not os.path.exists('go'): time.sleep(0.001)\n" + CHILD
    run = [sys.executable, "-c", wait]
    processes = [subprocess.Popen(run, stdout=-1, stderr=-1, text=True, cwd=tmp_path) for _ in range(3)]
    (tmp_path / "go").touch()
    results = [process.communicate(timeout=600) for process in processes]
    assert [process.returncode for process in processes] == [0] * 3, results
    assert {Path(output.strip()) for output, _ in results} == set(cache.glob("*.so"))
    assert len(compiler.calls) == 1


def test_killed_process_leaves_a_cache_that_works(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hung = tmp_path / "hung"
    once = f"[ -e {hung} ] || {{ touch {hung}; exec sleep 5; }}"
    slow = LoggedCompiler(tmp_path, f'case "$*" in *--version*) ;; *) {once} ;; esac')
    monkeypatch.setenv("CC", str(slow.path))
    process = subprocess.Popen([sys.executable, "-c", CHILD])
    deadline = time.monotonic() + 300
    while not hung.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    process.kill()
    process.wait()
    assert Path(load_adder()._name) in cache.iterdir()


def test_every_input_is_part_of_the_key(
    cache: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    libraries = [load_adder(), load_adder(sources=ADD | {"adder.h": ADD["adder.h"] + "\n"})]
    libraries += [load_adder(flags=("-O1",)), load_adder(flags=("-DN=1",))]
    monkeypatch.setattr(native, "_processor", lambda: "another processor")
    libraries.append(load_adder())
    monkeypatch.setenv("CC", f"{compiler.path} -g")
    libraries.append(load_adder())
    assert len({library._name for library in libraries}) == 6
    assert load_adder()._name == libraries[-1]._name
    assert len(compiler.calls) == 6


def test_a_cache_that_cannot_be_written_is_an_error_with_a_remedy(
    cache: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    library = Path(load_adder()._name)
    cache.chmod(0o500)
    try:
        # A library that the folder already contains is loaded from there.
        assert run_child(CHILD, obey_permissions) == library
        library.unlink()
        code = CHILD.replace("library = ", "try:\n    ").replace(
            "assert library.add(2, 3) == 5\nprint(library._name)",
            "except native.CompilerError as error:\n    print(error)",
        )
        told = str(run_child(code, obey_permissions))
    finally:
        cache.chmod(0o700)
    assert told.startswith(f"cannot load {library}: ")
    assert told.endswith("; set STEWART_SYM_CACHE to a writable folder")
