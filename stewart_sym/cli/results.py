"""Where a subcommand writes: never over its inputs nor over files of others."""

import argparse
import contextlib
import itertools
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType

from ..io.extras import needed_for


def results_folder(
    arguments: argparse.Namespace, *names: str, read: Iterable[Path] = ()
) -> contextlib.AbstractContextManager[Path]:
    """The folder of a subcommand's results.

    names: of files in it, so that a clash is said at once. read: inputs that are no arguments by themselves.
    """
    from ..io.writing import result_folder

    given = (value if isinstance(value, list) else [value] for value in vars(arguments).values())
    inputs = [path for path in itertools.chain(*given) if isinstance(path, Path) and path != arguments.output]
    return result_folder(arguments.output, arguments.force, [*inputs, *read], names)


def reject_inputs(output: Path, *inputs: Path) -> None:
    """ValueError if the file to write is one of the inputs."""
    for path in inputs:
        if output.exists() and path.exists() and output.samefile(path):
            raise ValueError(f"-o {output}: is an input, name another file")


def drawing() -> ModuleType:
    """The pictures of Figs. 4-10; ImportError names the extra where Matplotlib is missing."""
    with needed_for("drawing", ", or give --no-pictures"):
        import matplotlib  # noqa: F401
    from ..studies.paper import plots

    return plots
