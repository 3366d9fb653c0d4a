"""``stewart-sym derive``: derive the kernels again and write them."""

import argparse
import time
from importlib.resources import files
from pathlib import Path

from ..options import output
from ..results import results_folder
from ..terminal import progress_line

HELP = "derive the kernels again and write them"
EXAMPLE = "stewart-sym derive --check"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``derive``."""
    output(parser, "DIR", "folder to write to", "the installed kernels")
    parser.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 with the names of files that differ"
    )


def run(arguments: argparse.Namespace) -> int:
    """Run ``derive``; returns the exit code."""
    from ...io.writing import staged_folder

    directory = arguments.output or _generated_folder()
    if arguments.check:
        if not directory.is_dir():
            raise NotADirectoryError(20, "expected a folder of generated files", str(directory))
        return _compare(directory, _derived())
    own = arguments.output is None
    with staged_folder(directory) if own else results_folder(arguments) as folder:
        texts = _derived()
        for name, text in texts.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
    print(f"{len(texts)} files written to {directory}")
    return 0


def _generated_folder() -> Path:
    return Path(str(files("stewart_sym.generated")))


def _derived() -> dict[str, str]:
    """Derive every kernel and print what was derived, how long it took and what it costs."""
    from ...derive.generate import generated_files

    starts: list[tuple[str, float]] = []
    with progress_line() as progress:

        def note(text: str) -> None:
            progress(text)
            starts.append((text, time.perf_counter()))

        texts: dict[str, str] = generated_files(note)
    ends = [start for _, start in starts[1:]] + [time.perf_counter()]
    for (text, start), end in zip(starts, ends, strict=True):
        name = text.removeprefix("deriving ")
        counts = _operations(texts.get(f"{name}.py", ""))
        print(f"{name:<16} {end - start:6.1f} s   {counts}".rstrip())
    return texts


def _operations(module: str) -> str:
    """Totals in the text of a generated module, in words; empty if it has none."""
    import ast

    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            counts = ast.literal_eval(node.value)
            with_friction, without = (sum(counts[key]["total"]) for key in ("friction", "frictionless"))
            return f"operations per pose: {with_friction} with friction, {without} without"
    return ""


def _compare(directory: Path, texts: dict[str, str]) -> int:
    """Name the files that differ, are missing or are not generated; 1 if there are any."""
    present = {
        path.relative_to(directory).as_posix()
        for pattern in ("*.py", "c/*.[ch]")
        for path in directory.glob(pattern)
    }
    different = [name for name in sorted(texts) if _differs(directory / name, texts[name])]
    stray = sorted(present - texts.keys())
    for name in different:
        print(f"differs: {name}" if name in present else f"missing: {name}")
    for name in stray:
        print(f"not generated: {name}")
    if different or stray:
        return 1
    print(f"{directory}: all {len(texts)} files are as derived")
    return 0


def _differs(path: Path, text: str) -> bool:
    try:
        return path.read_bytes() != text.encode("utf-8")
    except FileNotFoundError:
        return True
