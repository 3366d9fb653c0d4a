"""Derive the kernels and write their files.

The folder contains only digests of kernels that are derived at first use. --kernel writes one of them.
Exit code: 0, 1 if --check finds differences, 2 for an error.

Example: stewart-sym derive --check
"""

import ast
from importlib.resources import files
from pathlib import Path
from typing import Any

from ...io.arguments import shown
from ...io.output import ResultFolder, write_file
from ...studies.common.report import Report
from ..command import Arguments, Parser, hint, results

_LABELS = {"differ": "differs", "missing": "missing", "not_generated": "not generated"}


def add_arguments(parser: Parser) -> None:
    parser.flag("check", "write no files, and list files that differ")
    text = "only kernel to write, such as stewart_exact_bounds; requires --output"
    parser.valued("kernel", str, text, metavar="NAME")
    parser.output("DIR", "folder of the kernels", otherwise="the installed kernels")


def run(arguments: Arguments) -> int:
    from ...calls.threads import CORES
    from ...derive.generated_files import generated_files
    from ...derive.on_demand import committed, differences

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
            names = differences(directory, texts)
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
    return kernel_files(name)


def _operations(module: str) -> int | None:
    """Return the total operations with friction of a generated module, or None if it lacks them."""
    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            return int(sum(ast.literal_eval(node.value)["friction"]["total"]))
    return None
