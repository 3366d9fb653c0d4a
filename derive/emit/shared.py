"""Common parts of the C99 files of kernels: headers of shared functions, first and last lines, sources."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType

from ..kernel.layouts import Written
from ..kernel.prepare import LUMPED
from ..kernel.shared import Shared, shared
from ..print.c import C
from ..print.template import filled
from ..trace import nodes as t
from ..trace.read import LANES as COUNT
from ..trace.read import POSES

ARITHMETIC, SOLVE = "stewart_arithmetic.h", "stewart_solve.h"
LANES, OUTPUTS = "stewart_lanes.h", "stewart_outputs.h"
INCLUDED = {
    ARITHMETIC: (ARITHMETIC,),
    SOLVE: (ARITHMETIC, SOLVE),
    LANES: (ARITHMETIC, SOLVE, LANES),
    OUTPUTS: (ARITHMETIC, SOLVE, OUTPUTS),
}
"""Headers that a source requires in addition to its own and ``stewart.h``, by the header that it includes."""
SIZES = {COUNT: "LANES"}
_OF_BLOCKS = {**SIZES, POSES: "POSES", 9 * POSES: "9 * POSES"}
"""Names of dimensions; the sources of forces have blocks of a different size."""


@cache
def shared_headers(version: str, about_tip: bool = True) -> Mapping[str, str]:
    """Return file name -> text of the shared headers; ``about_tip``: moments about platform point 1."""
    found = shared(about_tip)
    texts = {
        ARITHMETIC: filled("arithmetic.h", version=version),
        SOLVE: filled("solve.h", version=version, functions=_printed(found, (LUMPED, *found.solve))),
        LANES: filled(
            "lanes.h", version=version, functions=_printed(found, found.lanes), blocks=filled("blocks.c")
        ),
        OUTPUTS: filled(
            "outputs.h", version=version, functions=_printed(found, (found.platform_terms, *found.outputs))
        ),
    }
    return MappingProxyType(texts)


def _printed(found: Shared, parts: tuple[t.Structure | t.Function, ...]) -> str:
    printer = C(found.by_name.values(), _OF_BLOCKS, static="STEWART_SHARED ")
    return printer.source(*parts)


def header(template: str, file: str, version: str, /, **words: object) -> dict[str, str]:
    """Return ``<file>.h`` of a template with the common frame of all headers.

    ``words`` are the words of the template. Two of them are special: ``included``, the included header
    (default ``stewart.h``), and ``rotors``, True if the legs have rotors.
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
    """Return the beginning of a source, which includes ``header`` after the macros ``defined``."""
    return filled("top.c", file=file, version=version, header=header, defined=defined)


Part = str | t.Structure | t.Table | t.Function


class Source(ABC):
    """Functions of one kernel: ``parts`` in order, with structures, tables, and fixed texts."""

    def __init__(self, texts: Written) -> None:
        """Set the texts of the functions that may be called."""
        self.texts = texts
        self.parts = list(self._parts())
        self.functions = [each for each in self.parts if isinstance(each, t.Function)]

    @abstractmethod
    def _parts(self) -> Iterable[Part]:
        """Yield the parts of the source."""

    def declared(self, *structures: t.Structure) -> str:
        """Print structures and public functions for a header."""
        return C(self.functions).interface(*structures, *self.functions)

    def printed(self, before: str, fused: bool = True) -> str:
        """Print the source after the text ``before``, with products and sums fused if ``fused``."""
        return C(self.texts.functions.values(), _OF_BLOCKS, fused=fused).source(before, *self.parts)
