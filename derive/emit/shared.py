"""C99: what files of kernels have in common: headers of shared functions, beginnings and ends, sources."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType

from ..kernel.layouts import Written
from ..kernel.prepare import LUMPED
from ..kernel.shared import Shared, shared
from ..kernel.tree import nodes as t
from ..kernel.tree.read import LANES as COUNT
from ..kernel.tree.read import POSES
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
_OF_BLOCKS = {**SIZES, POSES: "POSES", 9 * POSES: "9 * POSES"}
"""Names of dimensions; the forces' sources have blocks of their own size."""


@cache
def shared_headers(version: str, about_tip: bool = True) -> Mapping[str, str]:
    """File name -> text; about_tip: of kernels whose moments are about platform point 1."""
    found = shared(about_tip)
    texts = {
        ARITHMETIC: filled("arithmetic.h", version=version),
        SOLVE: filled("solve.h", version=version, functions=_printed(found, (LUMPED, *found.solve))),
        LANES: filled(
            "lanes.h",
            version=version,
            functions=_printed(found, (*found.lanes[:-3], *found.moments)),
            solve_block=_printed(found, found.lanes[-3:], "STEWART_NO_COPY "),
            blocks=filled("blocks.c"),
        ),
        OUTPUTS: filled(
            "outputs.h", version=version, functions=_printed(found, (found.platform_terms, *found.outputs))
        ),
    }
    return MappingProxyType(texts)


def _printed(found: Shared, parts: tuple[t.Structure | t.Function, ...], more: str = "") -> str:
    printer = C(found.by_name.values(), _OF_BLOCKS, static=f"STEWART_SHARED {more}", unread=("D",))
    return printer.source(*parts)


def header(template: str, file: str, version: str, /, **words: object) -> dict[str, str]:
    """``<file>.h`` of a template, framed as the headers of all kernels are.

    words: of the template; ``included``: the header that it includes, ``stewart.h`` unless given; ``rotors``:
    whether the legs have them.
    """
    included, rotors = words.pop("included", "stewart.h"), words.pop("rotors", False)
    needed = filled("rotors.h").rstrip() if rotors else ""
    frame = {
        "written": filled("header_written", version=version).rstrip(),
        "begin": filled("header_begin", guard=f"{file.upper()}_H", included=included, needed=needed).rstrip(),
        "end": filled("header_end").rstrip(),
    }
    return {f"{file}.h": filled(template, **frame, **words)}


def top(file: str, version: str, header: str, defined: str = "") -> str:
    """How a source begins; header: of those above, the one that it includes. defined: macros before it."""
    return filled("top.c", file=file, version=version, header=header, defined=defined)


Part = str | t.Structure | t.Table | t.Function


class Source(ABC):
    """The functions of one kernel; ``parts`` in their order, with structures, tables and fixed texts."""

    def __init__(self, texts: Written) -> None:
        """texts: with what the functions may call."""
        self.texts = texts
        self.parts = list(self._parts())
        self.functions = [each for each in self.parts if isinstance(each, t.Function)]

    @abstractmethod
    def _parts(self) -> Iterable[Part]:
        """Reads the functions."""

    def declared(self, *structures: t.Structure) -> str:
        """Structures and public functions as a header has them."""
        return C(self.functions).interface(*structures, *self.functions)

    def printed(self, before: str, fused: bool = True) -> str:
        """The source; before: how it begins; fused: products and sums as one."""
        return C(self.texts.functions.values(), _OF_BLOCKS, fused=fused).source(before, *self.parts)
