"""Build files of a kit: a CMake project that installs and is found, and a plain Makefile.

The switches are those under which the kernels' error bounds hold.
"""

import re
from collections.abc import Sequence

from .text_format import template

FILES = ("CMakeLists.txt", "Config.cmake.in", "Makefile")
"""The second is what ``find_package(<symbol>)`` runs, as a template that the first reads."""
WRAPPER = "stewart.hpp"
"""File name of the C++ wrapper in a kit."""
EXAMPLE, SELFTEST = "example/main.c", "test/selftest.c"
"""Sources with a main of their own, in folders of their own: ``*.c`` of a kit is a library."""


def build_files(
    symbol: str,
    version: str,
    sources: Sequence[str],
    headers: Sequence[str],
    shared: Sequence[str] = (),
    precision: str = "double",
) -> dict[str, str]:
    """``FILES``, name -> text: the library ``lib<symbol>.a``, and two programs that link it.

    symbol: C identifier, name of library, package and CMake target, for CMake 3.15 or newer. version: of the
    generator. sources: ``.c`` files of the library; headers: those that callers include; shared: others, that
    sources include. precision: in the files alone, as stewart.h of a float kit defines float by itself.
    """
    # All that CMake takes: "0.2.0" of "0.2.0.dev1".
    number = re.match(r"\d+(\.\d+){0,3}", version)
    assert number is not None
    installed = (*headers, WRAPPER)
    words = {
        "symbol": symbol,
        "version": version,
        "number": number[0],
        "precision": precision,
        "source_lines": "\n".join(f"  {file}" for file in sources),
        "header_lines": "\n".join(f"  {file}" for file in installed),
        "shared_lines": "".join(f"  {file}\n" for file in shared),
        "sources": " ".join(sources),
        "objects": " ".join(source.removesuffix(".c") + ".o" for source in sources),
        "headers": " ".join((*headers, *shared)),
        "installed": " ".join(installed),
    }
    return {name: template(f"kit/{name}", words) for name in FILES}
