"""Derive the kernels and write their files.

Exit code: 0, 1 if --check finds differences, 2 for an error.

Example: stewart-sym derive --check
"""

import ast
from importlib.resources import files
from pathlib import Path

from ...io.atomic_write import ResultFolder, write_file
from ...studies.common.report import Report
from ..command import Arguments, Parser, results


def add_arguments(parser: Parser) -> None:
    parser.flag("check", "write no files, and list files that differ")
    parser.output("DIR", "folder of the kernels", otherwise="the installed kernels")


def run(arguments: Arguments) -> int:
    from ...derive.generated_files import generated_files
    from ...dynamics.forces import CORES

    installed = Path(str(files("stewart_sym.generated")))
    directory = arguments.output or installed
    with results(arguments) as (take, progress):
        # The installed kernels have no record, because they are part of this program.
        own = arguments.check or directory == installed
        folder = None if own else ResultFolder(directory, arguments.force)
        seconds: dict[str, float] = {}

        def note(name: str, time_s: float, share: float) -> None:
            progress(f"derived {name}", share)
            seconds[name] = time_s

        texts: dict[str, str] = generated_files(note, CORES)
        lines, kernels = [], []
        for name, time_s in seconds.items():
            count = _operations(texts.get(f"{name}.py", ""))
            kernels.append({"name": name, "time_s": time_s, "operations_per_pose": count})
            counts = "" if count is None else f"   operations per pose: {count}"
            lines.append(f"{name:<16} {time_s:6.1f} s{counts}")
        data: dict[str, list[str]] = {}
        if arguments.check:
            more, data = _compared(directory, texts)
        else:
            for name, text in texts.items():
                if folder is None:
                    write_file(directory / name, text)
                else:
                    folder.write(name, text)
            more = [f"{len(texts)} files written to {directory}"]
        take(Report("\n".join(lines + more), data={"files": len(texts), "kernels": kernels, **data}))
    return 1 if any(data.values()) else 0


def _operations(module: str) -> int | None:
    """Return the total operations with friction of a generated module, or None if it lacks them."""
    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            return int(sum(ast.literal_eval(node.value)["friction"]["total"]))
    return None


def _compared(directory: Path, texts: dict[str, str]) -> tuple[list[str], dict[str, list[str]]]:
    """Return report lines and names of the files that differ, are missing, or are not generated."""
    paths = [path for pattern in ("*.py", "c/*.[ch]") for path in directory.glob(pattern)]
    present = {path.relative_to(directory).as_posix(): path.read_bytes() for path in paths}
    names = {
        "differ": sorted(name for name in texts.keys() & present if present[name] != texts[name].encode()),
        "missing": sorted(texts.keys() - present),
        "not_generated": sorted(present.keys() - texts),
    }
    told = {"differ": "differs", "missing": "missing", "not_generated": "not generated"}
    lines = [f"{told[kind]}: {name}" for kind, each in names.items() for name in each]
    return lines or [f"{directory}: all {len(texts)} files are as derived"], names
