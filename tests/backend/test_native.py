"""Compiling, caching and loading C: on any machine, a sound library or one line that says why not."""

import ctypes
import os
import shlex
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from logged_compiler import ADD, CHILD, LoggedCompiler, load_adder, obey_permissions, run_child

from stewart_sym.backend import native

# --- cache


def test_threads_share_one_compilation(cache: Path, compiler: LoggedCompiler) -> None:
    libraries: list[ctypes.CDLL] = []
    threads = [threading.Thread(target=lambda: libraries.append(load_adder())) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(libraries) == 8
    assert len(set(map(id, libraries))) == 1
    assert len(compiler.calls) == 1


def test_threads_compile_different_libraries_side_by_side(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Each compiler waits until the other has started, and fails if that one never does.
    here = shlex.quote(str(tmp_path))
    wait = f"""case "$*" in *--version*) ;; *)
    mktemp {here}/started.XXXXXX > /dev/null
    n=0
    while [ $(ls {here} | grep -c started) -lt 2 ]; do
        n=$((n + 1)); [ $n -gt 600 ] && exit 1; sleep 0.05
    done;;
esac"""
    waiting = LoggedCompiler(tmp_path, wait)
    monkeypatch.setenv("CC", shlex.quote(str(waiting.path)))
    with ThreadPoolExecutor(2) as pool:
        made = [pool.submit(native.load, name, ADD) for name in ("adder", "other")]
        assert [library.result().add(2, 3) for library in made] == [5, 5]


def test_compiling_anew_passes_by_the_cache(cache: Path, compiler: LoggedCompiler, tmp_path: Path) -> None:
    load_adder()
    folder = tmp_path / "anew"
    folder.mkdir()
    for calls in (2, 3):
        library = native.compiled(folder, "adder", ADD)
        assert library.parent == folder
        assert ctypes.CDLL(str(library)).add(2, 3) == 5
        assert len(compiler.calls) == calls
    assert len(set(compiler.calls)) == 1


def test_a_tool_tells_what_it_printed_or_why_it_did_not(tmp_path: Path) -> None:
    assert native.ran(("sh", "-c", "pwd"), tmp_path).strip() == str(tmp_path)
    with pytest.raises(native.CompilerError, match=r"^sh fails: error: no$") as failed:
        native.ran(("sh", "-c", "echo error: no; exit 3"), tmp_path)
    assert failed.value.log == "error: no\n"
    with pytest.raises(native.CompilerError, match=r"^nosuchtool does not run: "):
        native.ran(("nosuchtool",), tmp_path)


def test_change_of_source_header_flag_or_macro_compiles_again(cache: Path, compiler: LoggedCompiler) -> None:
    libraries = [
        load_adder(),
        load_adder(sources=ADD | {"adder.c": ADD["adder.c"] + "\n"}),
        load_adder(sources=ADD | {"adder.h": ADD["adder.h"] + "\n"}),
        load_adder(flags=("-O1",)),
        native.load("adder", ADD, defines={"N": 1}),
        native.load("adder", ADD, defines={"N": 2}),
    ]
    assert len(set(map(id, libraries))) == 6
    assert len({library._name for library in libraries}) == 6
    assert len(compiler.calls) == 6


def test_change_of_processor_compiles_again(
    cache: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = load_adder()
    monkeypatch.setattr(native, "_processor", lambda: "another processor")
    assert load_adder() is not here
    assert len(compiler.calls) == 2


def test_processor_key_is_steady_and_names_the_instruction_sets() -> None:
    first = native._processor()
    native._processor.cache_clear()
    assert native._processor() == first
    if sys.platform == "linux":
        assert any(line.startswith(("flags", "Features", "isa", "cpu")) for line in first.splitlines())
        assert "MHz" not in first


def test_change_of_compiler_or_its_version_compiles_again(
    cache: Path, compiler: LoggedCompiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = run_child()
    other = LoggedCompiler(tmp_path, name="other-cc")
    monkeypatch.setenv("CC", str(other.path))
    second = run_child()
    updated = 'case "$*" in *--version*) echo "other 2.0"; exit 0 ;; esac'
    LoggedCompiler(tmp_path, before=updated, name="other-cc")
    third = run_child()
    monkeypatch.setenv("CC", f"{other.path} -g")
    fourth = run_child()
    assert len({first, second, third, fourth}) == 4
    assert (len(compiler.calls), len(other.calls)) == (1, 3)


def test_processes_starting_at_once_on_an_empty_cache_compile_once(
    cache: Path, tmp_path: Path, compiler: LoggedCompiler
) -> None:
    code = (
        "import pathlib, sys, time\nfrom stewart_sym.backend import native\n"
        "folder = pathlib.Path(sys.argv[1])\n(folder / sys.argv[2]).touch()\n"
        "while not (folder / 'go').exists(): time.sleep(0.001)\n" + CHILD
    )
    meeting = tmp_path / "meeting"
    meeting.mkdir()
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", code, str(meeting), str(number)], stdout=-1, stderr=-1, text=True
        )
        for number in range(6)
    ]
    deadline = time.monotonic() + 300
    while len(list(meeting.iterdir())) < 6 and time.monotonic() < deadline:
        time.sleep(0.001)
    (meeting / "go").touch()
    results = [process.communicate(timeout=600) for process in processes]
    assert [process.returncode for process in processes] == [0] * 6, results
    files = [Path(output.strip()) for output, _ in results]
    assert set(files) == set(cache.resolve().iterdir())
    assert run_child() in files
    assert len(compiler.calls) == 1


@pytest.mark.parametrize("damage", ["truncated", "garbage", "empty", "one bit"])
def test_damaged_library_is_rebuilt_and_never_mapped(
    cache: Path, compiler: LoggedCompiler, damage: str
) -> None:
    library = run_child()
    sound = library.read_bytes()
    flipped = bytearray(sound)
    flipped[len(flipped) // 2] ^= 1
    damaged = {"truncated": sound[: len(sound) // 4], "garbage": b"\x5a" * len(sound), "empty": b""}
    library.write_bytes(damaged.get(damage, bytes(flipped)))
    again = run_child()
    assert again.parent == cache.resolve()
    assert len(compiler.calls) == 2
    assert run_child() == again
    assert len(compiler.calls) == 2
    assert [again] == list(cache.resolve().iterdir())


def test_folder_in_the_place_of_a_library_is_survived(
    cache: Path, temporary: Path, compiler: LoggedCompiler
) -> None:
    library = run_child()
    library.unlink()
    library.mkdir()
    assert run_child(without=cache).is_relative_to(temporary.resolve())


def test_library_that_others_may_write_is_not_loaded(cache: Path, compiler: LoggedCompiler) -> None:
    library = run_child()
    library.chmod(0o777)
    assert run_child() == library
    assert len(compiler.calls) == 2
    assert library.stat().st_mode & 0o777 == 0o700


def test_sound_library_that_does_not_load_is_one_line(cache: Path) -> None:
    with pytest.raises(
        native.CompilerError, match=r"^the compiled library orphan can't be stored or loaded: .*nowhere"
    ):
        native.load("orphan", {"orphan.c": "int nowhere(void);\nint call(void) { return nowhere(); }\n"})


def test_build_folders_are_removed(cache: Path, compiler: LoggedCompiler) -> None:
    load_adder()
    with pytest.raises(native.CompilerError):
        native.load("wrong", {"wrong.c": "int f( {"})
    assert [path.suffix for path in cache.iterdir()] == [native._SUFFIX]


def test_leftovers_of_killed_processes_are_swept_when_old(cache: Path) -> None:
    old, young = cache / "build-old", cache / "build-young"
    for folder in (old, young):
        folder.mkdir(parents=True)
        (folder / "x.c").touch()
    cache.chmod(0o700)
    (cache / "build-old.lock").touch()
    for left in (old, cache / "build-old.lock"):
        os.utime(left, (0, 0))
    native.load("swept", {"swept.c": "int f(void) { return 1; }\n"})
    assert [path for path in cache.iterdir() if path.suffix != native._SUFFIX] == [young]


def test_what_a_killed_process_left_goes_with_the_next_build(
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
    assert {path.suffix for path in cache.iterdir()} == {"", ".lock"}
    assert [run_child()] == list(cache.resolve().iterdir())


# --- where the cache is


def test_new_cache_is_the_users_alone(cache: Path, compiler: LoggedCompiler) -> None:
    before = os.umask(0)
    try:
        load_adder()
    finally:
        os.umask(before)
    assert cache.stat().st_mode & 0o777 == 0o700
    assert [path.stat().st_mode & 0o777 for path in cache.iterdir()] == [0o700]


def test_home_with_spaces_and_letters_beyond_ascii(
    tmp_path: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = tmp_path / "Jürgen Größe 日本 $x 'q' [a]*"
    home.mkdir()
    monkeypatch.delenv("STEWART_SYM_CACHE", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setenv("HOME", str(home))
    library = run_child()
    assert library.is_relative_to(home.resolve())
    assert library.exists()
    assert run_child() == library
    assert len(compiler.calls) == 1


def test_order_of_cache_locations(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("STEWART_SYM_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", "relative/is/ignored")
    assert native._cache_location() == tmp_path / ".cache" / "stewart-sym"
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert native._cache_location() == tmp_path / "xdg" / "stewart-sym"
    monkeypatch.setenv("STEWART_SYM_CACHE", str(tmp_path / "own"))
    assert native._cache_location() == tmp_path / "own"


@pytest.mark.parametrize("place", ["below a file", "a file", "/dev/null/x"])
def test_impossible_cache_gives_a_temporary_folder_that_is_removed(
    place: str, tmp_path: Path, temporary: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "file"
    file.touch()
    places = {"below a file": file / "x", "a file": file, "/dev/null/x": Path("/dev/null/x")}
    monkeypatch.setenv("STEWART_SYM_CACHE", str(places[place]))
    library = run_child(without=places[place])
    assert library.is_relative_to(temporary.resolve())
    assert list(temporary.iterdir()) == []
    assert len(compiler.calls) == 1


def test_read_only_cache_serves_what_it_holds_and_no_more(
    cache: Path, temporary: Path, compiler: LoggedCompiler
) -> None:
    cache.mkdir(mode=0o500)
    try:
        rejected = f"import os\nassert not os.access({str(cache)!r}, os.W_OK, effective_ids=True)\n" + CHILD
        assert run_child(rejected, obey_permissions, cache).is_relative_to(temporary.resolve())
        assert len(compiler.calls) == 1
        cache.chmod(0o700)
        held = run_child()
        assert len(compiler.calls) == 2
        cache.chmod(0o500)
        assert run_child(rejected, obey_permissions) == held
        assert len(compiler.calls) == 2
    finally:
        cache.chmod(0o700)


@pytest.mark.parametrize("mode", [0o770, 0o707, 0o1777])
def test_cache_that_others_may_write_is_not_used(
    mode: int, cache: Path, temporary: Path, compiler: LoggedCompiler
) -> None:
    cache.mkdir()
    cache.chmod(mode)
    assert run_child(without=cache).is_relative_to(temporary.resolve())
    assert list(cache.iterdir()) == []


def test_cache_of_another_user_is_not_used(cache: Path, temporary: Path, compiler: LoggedCompiler) -> None:
    assert run_child().parent == cache.resolve()
    stranger = f"import os\nos.geteuid = lambda: {os.geteuid() + 1}\n" + CHILD
    assert run_child(stranger, without=cache).is_relative_to(temporary.resolve())
    assert len(compiler.calls) == 2


POOL = """
import multiprocessing

def work(_):
    library = native.load("adder", SOURCES)
    return library.add(2, 3)

if __name__ == "__main__":
    with multiprocessing.get_context("fork").Pool(3) as pool:
        assert pool.map(work, range(6)) == [5] * 6
    print("/")
"""


def test_no_temporary_folder_outlives_the_load_in_forked_pools_neither(
    temporary: Path, compiler: LoggedCompiler, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("STEWART_SYM_CACHE", "/dev/null/x")
    run_child(
        f"from stewart_sym.backend import native\nSOURCES = {ADD!r}\n{POOL}", without=Path("/dev/null/x")
    )
    assert compiler.calls
    assert list(temporary.iterdir()) == []


FORKED_WHILE_COMPILING = """
import os, threading, time
thread = threading.Thread(target=lambda: native.load("adder", SOURCES))
thread.start()
while not os.path.exists(STARTED):
    time.sleep(0.01)
child = os.fork()
if child == 0:
    assert native.load("adder", SOURCES).add(2, 3) == 5
    os._exit(0)
thread.join()
assert os.waitpid(child, 0)[1] == 0
print("/")
"""


def test_a_child_forked_while_a_thread_compiles_can_load(cache: Path, tmp_path: Path) -> None:
    started = tmp_path / "started"
    slow = LoggedCompiler(tmp_path, f'case "$*" in *--version*) ;; *) touch {started}; sleep 0.3 ;; esac')
    code = f"import os\nos.environ['CC'] = {str(slow.path)!r}\nfrom stewart_sym.backend import native\n"
    run_child(f"{code}SOURCES, STARTED = {ADD!r}, {str(started)!r}\n{FORKED_WHILE_COMPILING}")


FORKED_WHILE_STARTING = """
import os, signal, subprocess, threading, time
start, begun = subprocess._fork_exec, threading.Event()

def slowly(*arguments):
    child = start(*arguments)
    if threading.current_thread() is thread:
        begun.set()
        time.sleep(0.3)
    return child

native.find_compiler()
subprocess._fork_exec = slowly
thread = threading.Thread(target=lambda: native.load("adder", SOURCES))
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    signal.alarm(30)
    assert native.load("adder", SOURCES).add(2, 3) == 5
    os._exit(0)
thread.join()
assert os.waitpid(child, 0)[1] == 0
print("/")
"""


def test_a_child_forked_while_a_compiler_starts_keeps_nobody_waiting(cache: Path) -> None:
    run_child(f"from stewart_sym.backend import native\nSOURCES = {ADD!r}\n{FORKED_WHILE_STARTING}")


FORKED_WHILE_IMPORTING = """
import os, signal, sys, threading, time
import stewart_sym as ss

class Slow:
    def find_spec(self, name, path=None, target=None):
        if name == "stewart_sym.motion.motion" and threading.current_thread() is thread:
            begun.set()
            time.sleep(0.3)

begun = threading.Event()
sys.meta_path.insert(0, Slow())
thread = threading.Thread(target=lambda: ss.Motion)
thread.start()
begun.wait()
child = os.fork()
if child == 0:
    signal.alarm(30)
    os._exit(0 if ss.Motion.__name__ == "Motion" else 1)
thread.join()
assert os.waitpid(child, 0)[1] == 0
"""


def test_a_child_forked_while_a_thread_imports_can_import() -> None:
    run = subprocess.run([sys.executable, "-c", FORKED_WHILE_IMPORTING], capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (0, "")
