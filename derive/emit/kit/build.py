"""Build files of a kit: a CMake project that installs and is found, and a plain Makefile.

One of the kit's texts: takes names of files and hands back text. Knows compilers' switches, no kernel and no
robot. The switches are those under which the kernels' error bounds hold.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass

CONFIG_IN = "Config.cmake.in"
"""File name of ``config_in`` in a kit: its CMakeLists.txt asks for it."""
WRAPPER = "stewart.hpp"
"""File name of the C++ wrapper in a kit."""
EXAMPLE, SELFTEST = "example/main.c", "test/selftest.c"
"""Sources with a main of their own, in folders of their own: ``*.c`` of a kit is a library."""

_WARNINGS = "-Wall -Wextra -pedantic -Wconversion -Wdouble-promotion"


@dataclass(frozen=True)
class Package:
    """What is built: the library ``lib<symbol>.a`` and two programs that link it.

    symbol: C identifier, name of library, package and CMake target. version: of the generator.
    sources: ``.c`` files of the library; headers: all that it needs or that callers include. has_cpp: whether
    ``stewart.hpp`` is among the kit's files. precision: "double" or "float", told in the files alone, as
    stewart.h of a float kit asks for float by itself. example, selftest: files with a main of their own.
    """

    symbol: str
    version: str
    sources: tuple[str, ...]
    headers: tuple[str, ...]
    precision: str = "double"
    has_cpp: bool = False
    example: str = EXAMPLE
    selftest: str = SELFTEST

    @property
    def installed(self) -> tuple[str, ...]:
        """Every header that an install carries."""
        return (*self.headers, *([WRAPPER] if self.has_cpp else []))


def build_files(package: Package) -> dict[str, str]:
    """``CMakeLists.txt``, ``Config.cmake.in`` and ``Makefile``: file name -> text."""
    return {
        "CMakeLists.txt": cmake_lists(package),
        CONFIG_IN: config_in(package),
        "Makefile": makefile(package),
    }


def cmake_lists(package: Package) -> str:
    """``CMakeLists.txt``: static library ``<symbol>``, alias ``<symbol>::<symbol>``, programs, install.

    For CMake 3.15 or newer; needs ``CONFIG_IN`` beside it.
    """
    return _filled(
        _CMAKE,
        package,
        number=_number(package.version),
        sources=_listed(package.sources),
        headers=_listed(package.installed),
        config=CONFIG_IN,
    )


def config_in(package: Package) -> str:
    """What ``find_package(<symbol>)`` runs, as a template for CMake's package helpers."""
    return _filled(_CONFIG, package)


def makefile(package: Package) -> str:
    """``Makefile`` for any make: library, self-test, example, report of stack, install."""
    return _filled(
        _MAKEFILE,
        package,
        warnings=_WARNINGS,
        sources=" ".join(package.sources),
        objects=" ".join(source.removesuffix(".c") + ".o" for source in package.sources),
        headers=" ".join(package.headers),
        installed=" ".join(package.installed),
        example_object=package.example.removesuffix(".c") + ".o",
        selftest_object=package.selftest.removesuffix(".c") + ".o",
    )


def _filled(template: str, package: Package, **values: str) -> str:
    fields = ("symbol", "version", "precision", "example", "selftest")
    every = {name: str(getattr(package, name)) for name in fields} | values
    return re.sub(r"<(\w+)>", lambda match: every[match[1]], template)


def _number(version: str) -> str:
    """The leading numbers of a version, all that CMake takes: "0.2.0" of "0.2.0.dev1"."""
    found = re.match(r"\d+(\.\d+){0,3}", version)
    if found is None:
        raise ValueError(f"version: expected one that begins with a number, got {version!r}")
    return found[0]


def _listed(files: Iterable[str]) -> str:
    return "\n".join(f"  {file}" for file in files)


_CMAKE = """\
# CMakeLists.txt: the kit <symbol> as a static library, in <precision>.
#
#     cmake -S . -B build && cmake --build build && ctest --test-dir build
#
# Or from a project of yours, after an install or with the folder inside it:
#
#     find_package(<symbol> REQUIRED)   # or add_subdirectory(...), FetchContent_MakeAvailable(...)
#     target_link_libraries(controller PRIVATE <symbol>::<symbol>)
#
# Written by stewart-sym <version>; do not edit.
# SPDX-License-Identifier: 0BSD
cmake_minimum_required(VERSION 3.15...3.31)
project(<symbol> VERSION <number> LANGUAGES C)

if(CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  set(STEWART_KIT_ON_TOP ON)
else()
  set(STEWART_KIT_ON_TOP OFF)
endif()
# A bare-metal program needs start-up code and a linker script, which only its own project has.
if(STEWART_KIT_ON_TOP AND NOT CMAKE_SYSTEM_NAME STREQUAL "Generic")
  set(STEWART_KIT_RUNS ON)
else()
  set(STEWART_KIT_RUNS OFF)
endif()
option(STEWART_KIT_TESTS "Build the kit's self-test and example" ${STEWART_KIT_RUNS})
option(STEWART_KIT_INSTALL "Install the kit's library, headers and CMake package" ${STEWART_KIT_ON_TOP})

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(KIT_HEADERS
<headers>
)
add_library(<symbol> STATIC
<sources>
  ${KIT_HEADERS}
)
add_library(<symbol>::<symbol> ALIAS <symbol>)
target_include_directories(<symbol> PUBLIC
  "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>"
  "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/<symbol>>"
)
set_target_properties(<symbol> PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
if(CMAKE_C_COMPILER_ID MATCHES "GNU|Clang" AND NOT MSVC)
  # One pose and a batch agree to the last bit; without errno, sqrt is an instruction.
  target_compile_options(<symbol> PRIVATE -ffp-contract=off -fno-math-errno)
endif()
if(UNIX OR (CMAKE_C_COMPILER_ID MATCHES "^(GNU|Clang)$" AND NOT MSVC))
  target_link_libraries(<symbol> PRIVATE m)
endif()

if(STEWART_KIT_TESTS)
  enable_testing()
  # Named after the kit, so that a project can hold several.
  add_executable(<symbol>_selftest <selftest>)
  add_executable(<symbol>_example <example>)
  foreach(name selftest example)
    set_target_properties(<symbol>_${name} PROPERTIES
      OUTPUT_NAME ${name} C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
    target_link_libraries(<symbol>_${name} PRIVATE <symbol>)
  endforeach()
  add_test(NAME selftest COMMAND <symbol>_selftest)
endif()

if(STEWART_KIT_INSTALL)
  set(KIT_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/<symbol>")
  install(TARGETS <symbol> EXPORT <symbol>Targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(FILES ${KIT_HEADERS} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/<symbol>")
  install(EXPORT <symbol>Targets NAMESPACE <symbol>:: DESTINATION "${KIT_CMAKE_DIR}")
  configure_package_config_file(<config> "${CMAKE_CURRENT_BINARY_DIR}/<symbol>Config.cmake"
    INSTALL_DESTINATION "${KIT_CMAKE_DIR}" NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/<symbol>ConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
  install(FILES
    "${CMAKE_CURRENT_BINARY_DIR}/<symbol>Config.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/<symbol>ConfigVersion.cmake"
    DESTINATION "${KIT_CMAKE_DIR}")
endif()
"""

_CONFIG = """\
# What find_package(<symbol>) runs: defines the target <symbol>::<symbol>.
#
# Written by stewart-sym <version>; do not edit.
# SPDX-License-Identifier: 0BSD
@PACKAGE_INIT@

include("${CMAKE_CURRENT_LIST_DIR}/<symbol>Targets.cmake")
check_required_components(<symbol>)
"""

_MAKEFILE = """\
# Makefile: the kit <symbol>, in <precision>.
#
#     make                                     library, self-test and example; runs the self-test
#     make clean all CC=clang CFLAGS=-O3       the same by another compiler
#     make stack                               bytes of stack of each function (gcc, clang)
#     make install PREFIX=/opt/x DESTDIR=pkg   library and headers
#
# Written by stewart-sym <version>; do not edit.
# SPDX-License-Identifier: 0BSD
.POSIX:
.SUFFIXES:
.SUFFIXES: .c .o
.PHONY: all example check stack clean install

CC = cc
AR = ar
CFLAGS = -O2 <warnings>
# One pose and a batch agree to the last bit; without errno, sqrt is an instruction.
ARITHMETIC = -std=c99 -ffp-contract=off -fno-math-errno
LDFLAGS =
LDLIBS = -lm
PREFIX = /usr/local
DESTDIR =

LIBRARY = lib<symbol>.a
HEADERS = <headers>
SOURCES = <sources>
OBJECTS = <objects>

all: $(LIBRARY) example check

$(LIBRARY): $(OBJECTS)
\trm -f $(LIBRARY)
\t$(AR) -rcs $(LIBRARY) $(OBJECTS)

selftest: <selftest_object> $(LIBRARY)
\t$(CC) $(CFLAGS) $(LDFLAGS) -o selftest <selftest_object> $(LIBRARY) $(LDLIBS)

example: example/example

example/example: <example_object> $(LIBRARY)
\t$(CC) $(CFLAGS) $(LDFLAGS) -o example/example <example_object> $(LIBRARY) $(LDLIBS)

$(OBJECTS) <selftest_object> <example_object>: $(HEADERS)

.c.o:
\t$(CC) $(ARITHMETIC) $(CFLAGS) -I. -c -o $@ $<

check: selftest
\t./selftest

stack:
\t@rm -rf stack.tmp && mkdir stack.tmp
\t@for file in $(SOURCES); do \\
\t    $(CC) $(ARITHMETIC) $(CFLAGS) -fstack-usage -c \\
\t        -o "stack.tmp/$${file%.c}.o" $$file || exit 1; \\
\tdone
\t@cat stack.tmp/*.su | awk -F '\\t' \\
\t    '{ n = split($$1, at, ":"); print $$2 " bytes, " $$3 ": " at[n] }' | sort -rn
\t@rm -rf stack.tmp

install: $(LIBRARY)
\tmkdir -p $(DESTDIR)$(PREFIX)/lib $(DESTDIR)$(PREFIX)/include/<symbol>
\tcp $(LIBRARY) $(DESTDIR)$(PREFIX)/lib/
\tcp <installed> $(DESTDIR)$(PREFIX)/include/<symbol>/

clean:
\trm -rf stack.tmp
\trm -f $(LIBRARY) $(OBJECTS) <selftest_object> <example_object> selftest example/example
"""
