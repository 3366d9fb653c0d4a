"""C99: the headers that sources of kernels share, with macros of the arithmetic and functions."""

from ..kernel.shared import Shared, shared
from ..kernel.tree.nodes import Function
from ..kernel.tree.read import LANES as COUNT
from ..print.c import C
from ..print.template import filled

ARITHMETIC, SOLVE = "stewart_arithmetic.h", "stewart_solve.h"
LANES, OUTPUTS = "stewart_lanes.h", "stewart_outputs.h"
INCLUDED = {
    ARITHMETIC: (ARITHMETIC,),
    SOLVE: (ARITHMETIC, SOLVE),
    LANES: (ARITHMETIC, SOLVE, LANES),
    OUTPUTS: (ARITHMETIC, SOLVE, OUTPUTS),
}
"""What a source needs beside its own header and ``stewart.h``, by the header that it includes."""
SIZES = {COUNT: "LANES"}


def shared_headers(version: str, about_tip: bool = True) -> dict[str, str]:
    """File name -> text; about_tip: of kernels whose moments are about platform point 1."""
    found = shared(about_tip)
    return {
        ARITHMETIC: filled("arithmetic.h", version=version),
        SOLVE: filled("solve.h", version=version, functions=_printed(found, found.solve)),
        LANES: filled(
            "lanes.h",
            version=version,
            functions=_printed(found, found.lanes[:-1]),
            solve_block=_printed(found, found.lanes[-1:], "STEWART_NO_COPY "),
            blocks=filled("blocks.c"),
        ),
        OUTPUTS: filled("outputs.h", version=version, functions=_printed(found, found.outputs)),
    }


def _printed(found: Shared, functions: tuple[Function, ...], more: str = "") -> str:
    printer = C(found.by_name.values(), SIZES, static=f"STEWART_SHARED {more}", unread=("D",))
    return printer.source(*functions)


def top(file: str, version: str, header: str, defined: str = "") -> str:
    """How a source begins; header: of those above, the one that it includes. defined: macros before it."""
    return filled("top.c", file=file, version=version, header=header, defined=defined)
