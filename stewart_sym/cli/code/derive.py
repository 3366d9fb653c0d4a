"""``stewart-sym derive``: derive the kernels and write their files."""

import argparse
from importlib.resources import files
from pathlib import Path
from typing import Any

from ...io.progress import Progress
from ..options import output
from ..output import results

HELP = "derive the kernels and write their files"
EXAMPLE = "stewart-sym derive --check"
MORE = "Exit code: 0, 1 if --check finds differences, 2 for an error."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--check", action="store_true", help="write no files, and list files that differ")
    output(parser, "DIR", "folder of the kernels", "the installed kernels")


def run(arguments: argparse.Namespace) -> int:
    from ...io.atomic_write import result_folder, staged_folder
    from ...studies.common.report import Report

    directory = arguments.output or Path(str(files("stewart_sym.generated")))
    if arguments.check and not directory.is_dir():
        raise NotADirectoryError(20, "expected a folder of generated files", str(directory))
    with results(arguments) as (take, progress):
        if arguments.check:
            kernels, texts = _derived(progress)
            lines, data = _compared(directory, texts)
        else:
            own = arguments.output is None
            with staged_folder(directory) if own else result_folder(directory, arguments.force) as folder:
                kernels, texts = _derived(progress)
                for name, text in texts.items():
                    (folder / name).parent.mkdir(exist_ok=True)
                    (folder / name).write_text(text, encoding="utf-8", newline="\n")
            lines, data = [f"{len(texts)} files written to {directory}"], {}
        every = [*map(_line, kernels), *lines]
        figures = {"files": len(texts), "kernels": kernels, **data}
        take(Report("\n".join(every), data=figures))
    return 1 if any(data.values()) else 0


def _line(kernel: dict[str, Any]) -> str:
    """Format the name, the time, and, if counted, the operations per pose of a kernel."""
    name, seconds, operations = kernel.values()
    counts = "" if operations is None else f"operations per pose: {operations}"
    return f"{name:<16} {seconds:6.1f} s   {counts}".rstrip()


def _derived(progress: Progress) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """Derive all kernels; return the time and the operations of each kernel, and the texts of all files."""
    from ...derive.generate import generated_files
    from ...dynamics.forces import CORES

    seconds: dict[str, float] = {}

    def note(name: str, time_s: float, share: float) -> None:
        progress(f"derived {name}", share)
        seconds[name] = time_s

    texts: dict[str, str] = generated_files(note, CORES)
    kernels = [
        {"name": name, "time_s": time_s, "operations_per_pose": _operations(texts.get(f"{name}.py", ""))}
        for name, time_s in seconds.items()
    ]
    return kernels, texts


def _operations(module: str) -> int | None:
    """Return the total operations with friction of a generated module, or None if it lacks them."""
    import ast

    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            return int(sum(ast.literal_eval(node.value)["friction"]["total"]))
    return None


def _compared(directory: Path, texts: dict[str, str]) -> tuple[list[str], dict[str, list[str]]]:
    """Return report lines and names of the files that differ, are missing, or are not generated."""
    present = {
        path.relative_to(directory).as_posix()
        for pattern in ("*.py", "c/*.[ch]")
        for path in directory.glob(pattern)
    }
    different = [
        name
        for name in sorted(texts)
        if not (directory / name).is_file() or (directory / name).read_bytes() != texts[name].encode("utf-8")
    ]
    missing = [name for name in different if name not in present]
    stray = sorted(present - texts.keys())
    lines = [f"missing: {name}" if name in missing else f"differs: {name}" for name in different]
    lines += [f"not generated: {name}" for name in stray]
    names = {"differ": sorted({*different} - {*missing}), "missing": missing, "not_generated": stray}
    return lines or [f"{directory}: all {len(texts)} files are as derived"], names
