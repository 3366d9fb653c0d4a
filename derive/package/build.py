"""Build files of a kit: a CMake project with an installable package, and a plain makefile.

The tolerances of the self-test are valid for the compiler options in these files.
"""

import re
from collections.abc import Sequence

from .text_format import template

FILES = ("CMakeLists.txt", "Config.cmake.in", "Makefile")
"""Build files. CMake fills the template ``Config.cmake.in``, which ``find_package(<symbol>)`` runs."""
WRAPPER = "stewart.hpp"
"""File name of the C++ wrapper in a kit."""
EXAMPLE, SELFTEST = "example/main.c", "test/selftest.c"
"""Sources with a main function. They have separate folders, so that ``*.c`` of a kit is a library."""


def build_files(
    symbol: str,
    version: str,
    sources: Sequence[str],
    headers: Sequence[str],
    shared: Sequence[str] = (),
    precision: str = "double",
) -> dict[str, str]:
    """Return ``FILES``, name -> text, for the library ``lib<symbol>.a`` and two programs that link it.

    Parameters
    ----------
    symbol : str
        C identifier: name of the library, the package, and the CMake target, for CMake 3.15 or newer.
    version : str
        Version of the generator.
    sources : sequence of str
        ``.c`` files of the library.
    headers : sequence of str
        Headers that callers include.
    shared : sequence of str
        Other headers, which the sources include.
    precision : str
        "double" or "float", only for texts, because stewart.h of a float kit defines float itself.
    """
    # CMake accepts only the numeric part: "0.2.0" of "0.2.0.dev1".
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
