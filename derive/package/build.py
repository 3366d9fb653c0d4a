"""Build files of a kit: a CMake project that installs and is found, and a plain Makefile.

The switches are those under which the kernels' error bounds hold.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass

from .words import template

CONFIG_IN = "Config.cmake.in"
"""What ``find_package(<symbol>)`` runs, as a template that CMakeLists.txt reads."""
WRAPPER = "stewart.hpp"
"""File name of the C++ wrapper in a kit."""
EXAMPLE, SELFTEST = "example/main.c", "test/selftest.c"
"""Sources with a main of their own, in folders of their own: ``*.c`` of a kit is a library."""

_WARNINGS = "-Wall -Wextra -pedantic -Wconversion -Wdouble-promotion"


@dataclass(frozen=True)
class Package:
    """What is built: the library ``lib<symbol>.a`` and two programs that link it.

    symbol: C identifier, name of library, package and CMake target. version: of the generator.
    sources: ``.c`` files of the library; headers: those that callers include; shared: others, that sources
    include. precision: "double" or "float", in the files alone, as stewart.h of a float kit defines float by
    itself.
    """

    symbol: str
    version: str
    sources: tuple[str, ...]
    headers: tuple[str, ...]
    shared: tuple[str, ...] = ()
    precision: str = "double"

    @property
    def installed(self) -> tuple[str, ...]:
        """Every header that an install carries."""
        return *self.headers, WRAPPER


def build_files(package: Package) -> dict[str, str]:
    """``CMakeLists.txt``, ``Config.cmake.in`` and ``Makefile``: file name -> text."""
    return {
        "CMakeLists.txt": cmake_lists(package),
        CONFIG_IN: _filled(CONFIG_IN, package),
        "Makefile": makefile(package),
    }


def cmake_lists(package: Package) -> str:
    """``CMakeLists.txt``: static library ``<symbol>``, alias ``<symbol>::<symbol>``, programs, install.

    For CMake 3.15 or newer; needs ``CONFIG_IN`` beside it.
    """
    return _filled(
        "CMakeLists.txt",
        package,
        number=_number(package.version),
        sources=_listed(package.sources),
        headers=_listed(package.installed),
        shared="".join(f"  {file}\n" for file in package.shared),
        config=CONFIG_IN,
    )


def makefile(package: Package) -> str:
    """``Makefile`` for any make: library, self-test, example, report of stack, install."""
    return _filled(
        "Makefile",
        package,
        warnings=_WARNINGS,
        sources=" ".join(package.sources),
        objects=" ".join(source.removesuffix(".c") + ".o" for source in package.sources),
        headers=" ".join((*package.headers, *package.shared)),
        installed=" ".join(package.installed),
    )


def _filled(name: str, package: Package, **values: str) -> str:
    given = {"symbol": package.symbol, "version": package.version, "precision": package.precision}
    return template(f"kit/{name}", given | values)


def _number(version: str) -> str:
    """The leading numbers of a version, all that CMake takes: "0.2.0" of "0.2.0.dev1"."""
    found = re.match(r"\d+(\.\d+){0,3}", version)
    if found is None:
        raise ValueError(f"version: expected one that begins with a number, got {version!r}")
    return found[0]


def _listed(files: Iterable[str]) -> str:
    return "\n".join(f"  {file}" for file in files)
