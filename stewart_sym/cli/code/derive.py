"""Derive the kernels and write their files.

The folder contains only digests of kernels that are derived at first use. --kernel writes one of them.
Exit code: 0, 1 if --check finds differences, 2 for an error.

Example: stewart-sym derive --check
"""

import ast
import hashlib
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from ...io.arguments import shown
from ...io.atomic_write import ResultFolder, digest, write_file
from ...studies.common.report import Report
from ..command import Arguments, Parser, hint, results

_LABELS = {"differ": "differs", "missing": "missing", "not_generated": "not generated"}


def add_arguments(parser: Parser) -> None:
    parser.flag("check", "write no files, and list files that differ")
    text = "only kernel to write, such as stewart_exact_bounds; requires --output"
    parser.valued("kernel", str, text, metavar="NAME")
    parser.output("DIR", "folder of the kernels", otherwise="the installed kernels")


def run(arguments: Arguments) -> int:
    from ...backend.threads import CORES
    from ...derive.generated_files import generated_files
    from ...derive.on_demand import committed

    installed = Path(str(files("stewart_sym.generated")))
    directory = arguments.output or installed
    if arguments.kernel is not None and (arguments.check or directory == installed):
        raise ValueError("--kernel: must be given with --output and without --check")
    with results(arguments) as (take, progress):
        # The installed kernels have no record, because they are part of this program.
        own = arguments.check or directory == installed
        folder = None if own else ResultFolder(directory, arguments.force)
        kernels: list[dict[str, Any]] = []

        def note(name: str, time_s: float, share: float) -> None:
            progress(f"derived {name}", share)
            kernels.append({"name": name, "time_s": time_s})

        if arguments.kernel is not None:
            stored = texts = _one_kernel(arguments.kernel)
        else:
            texts = generated_files(note, CORES)
            stored = committed(texts)
        lines = []
        for kernel in kernels:
            count = kernel["operations_per_pose"] = _operations(texts.get(f"{kernel['name']}.py", ""))
            counts = "" if count is None else f"   operations per pose: {count}"
            lines.append(f"{kernel['name']:<16} {kernel['time_s']:6.1f} s{counts}")
        names: dict[str, list[str]] = {}
        if arguments.check:
            names = _compared(directory, texts, stored)
            more = [f"{_LABELS[kind]}: {name}" for kind, each in names.items() for name in each]
            lines += more or [f"{directory}: all {len(texts)} files are as derived"]
        else:
            for name, text in stored.items():
                if folder is None:
                    write_file(directory / name, text)
                else:
                    folder.write(name, text)
            lines.append(f"{len(stored)} files written to {directory}")
        take(Report("\n".join(lines), data={"files": len(texts), "kernels": kernels, **names}))
    return 1 if any(names.values()) else 0


def _one_kernel(name: str) -> dict[str, str]:
    """Derive one of the kernels that are derived at first use; raise ValueError for another name."""
    from ...derive.on_demand import ON_DEMAND, TABLE, kernel_files

    if name not in ON_DEMAND:
        expected = f"the name of a file in {TABLE} without suffix"
        raise ValueError(f"--kernel: expected {expected}, got {shown(name)}{hint(name, ON_DEMAND)}")
    texts: dict[str, str] = kernel_files(name)
    return texts


def _operations(module: str) -> int | None:
    """Return the total operations with friction of a generated module, or None if it lacks them."""
    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            return int(sum(ast.literal_eval(node.value)["friction"]["total"]))
    return None


def _compared(directory: Path, texts: Mapping[str, str], stored: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the names of files that differ from ``texts``, are missing, or are not generated.

    ``stored`` are the files of the folder, whose table contains the digests of the others.
    """
    from ...derive.on_demand import TABLE

    paths = [path for pattern in ("*.py", "c/*.[ch]") for path in directory.glob(pattern)]
    files = {path.relative_to(directory).as_posix(): digest(path) for path in paths}
    table = directory / TABLE
    rows = table.read_text(encoding="utf-8").splitlines() if table.is_file() else []
    present = files | {name: code for code, name in map(str.split, rows)}
    expected = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in texts.items()}
    return {
        "differ": sorted(name for name in expected.keys() & present if expected[name] != present[name]),
        "missing": sorted(expected.keys() - present),
        "not_generated": sorted((present.keys() - expected) | (files.keys() - stored.keys())),
    }
