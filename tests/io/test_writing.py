"""A file is replaced by a whole one only, and a folder is filled all or nothing."""

import os
from pathlib import Path

import pytest
from command_line import folder_state

from stewart_sym.io.writing import replaced_file, staged_folder


def write_file(path: Path, text: str, failure: Exception | None = None) -> None:
    with replaced_file(path) as stream:
        stream.write(text)
        if failure:
            raise failure


def fill_folder(path: Path, names: str, failure: Exception | None = None) -> None:
    with staged_folder(path) as folder:
        for name in names:
            (folder / name).write_text(name)
        if failure:
            raise failure


def test_a_file_is_replaced_only_by_a_whole_one(tmp_path: Path) -> None:
    target = tmp_path / "f.csv"
    target.write_text("old")
    with pytest.raises(RuntimeError):
        write_file(target, "half", RuntimeError())
    assert folder_state(tmp_path) == {"f.csv": b"old"}
    write_file(target, "whole")
    assert folder_state(tmp_path) == {"f.csv": b"whole"}


def test_writing_follows_links_and_leaves_devices_alone(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("old")
    (tmp_path / "link").symlink_to("real")
    write_file(tmp_path / "link", "new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "new"
    write_file(Path(os.devnull), "gone")
    assert not Path(os.devnull).is_file()


@pytest.mark.skipif(not Path("/proc/self/fd").is_dir(), reason="no names of open files")
def test_a_pipe_is_written_by_the_name_that_a_shell_gives_it() -> None:
    read, write = os.pipe()
    with open(read, encoding="utf-8") as end:
        write_file(Path(f"/proc/self/fd/{write}"), "through")
        os.close(write)
        assert end.read() == "through"


def test_a_folder_is_filled_all_or_nothing(tmp_path: Path) -> None:
    target = tmp_path / "a" / "b"
    with pytest.raises(RuntimeError):
        fill_folder(target, "x", RuntimeError())
    assert not list(tmp_path.iterdir())
    fill_folder(target, "xy")
    assert folder_state(target) == {"x": b"x", "y": b"y"}
    (target / "z").mkdir()
    with pytest.raises(IsADirectoryError):
        fill_folder(target, "wz")
    assert folder_state(target) == {"x": b"x", "y": b"y", "z": b"folder"}


@pytest.mark.parametrize("fault", [OSError(5, "Input/output error"), KeyboardInterrupt()])
@pytest.mark.parametrize("call", range(1, 6))
def test_a_folder_whose_filling_fails_is_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, call: int, fault: BaseException
) -> None:
    """Five moves: an old x aside and a new one in, an old y aside and a new one in, a new z in."""
    target = tmp_path / "a"
    fill_folder(target, "xyw")
    (target / "x").write_text("old")
    before = folder_state(tmp_path)
    real, calls = Path.rename, iter(range(1, 100))

    def failing(self: Path, to: Path) -> Path:
        if next(calls) == call:
            raise fault
        return real(self, to)

    monkeypatch.setattr(Path, "rename", failing)
    with pytest.raises((OSError, KeyboardInterrupt)) as caught:
        fill_folder(target, "xyz")
    assert folder_state(tmp_path) == before
    if isinstance(caught.value, OSError):
        assert caught.value.filename == str(target / "xxyyz"[call - 1])
