"""Kits of some robots, made once a process, and programs built of them without a warning."""

import dataclasses
import re
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import machines
import numpy as np
import pytest

from stewart_sym.kit import Choice, Kit, files, kit, languages, vectors
from stewart_sym.kit.kit_options import DEFAULT
from stewart_sym.kit.vectors import Vector
from stewart_sym.robot.robot import Robot

STRICT = ("-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Werror")
COMPILERS = {
    "gcc": ("gcc", "-std=c99"),
    "clang": ("clang", "-std=c99"),
    "g++": ("g++", "-x", "c++", "-std=c++11"),
    "clang++": ("clang++", "-x", "c++", "-std=c++11"),
}


@cache
def machine(which: str) -> Robot:
    """ "dasgupta", or a random one: "random", "spherical", and with "drive" or "rotors" after the joint."""
    rng = np.random.default_rng(11)
    if which == "dasgupta":
        return machines.dasgupta()
    robot = machines.random_robot(rng, "spherical" if "spherical" in which else "universal")
    if which.endswith(("drive", "rotors")):
        return machines.with_random_drives(rng, robot, which.endswith("rotors"))
    return robot


@cache
def renamed(name: str) -> Robot:
    return dataclasses.replace(machines.dasgupta(), name=name)


@contextmanager
def few_vectors() -> Iterator[None]:
    """Kits made meanwhile have one ordinary test motion: those that show wrong constants take a second."""

    def few(*given: Any, **options: Any) -> tuple[Vector, ...]:
        return vectors.vectors.__wrapped__(*given, **options | {"count": 1})

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(vectors, "extreme_motions", lambda *_: [])
        for module in (files, languages):
            patch.setattr(module, "vectors", few)
        yield


def c_of(made: Kit, pattern: str = r".*\.[ch]") -> dict[str, str]:
    """Headers and sources of a kit, or those whose whole names a pattern has."""
    return {name: text.decode() for name, text in made.files.items() if re.fullmatch(pattern, name)}


@cache
def kit_of(name: str = "Dasgupta & Mruthyunjaya 1998", choice: Choice = DEFAULT) -> Kit:
    """A kit of few vectors."""
    with few_vectors():
        return kit(renamed(name), choice)


def build(folder: Path, compiler: str, level: str = "-O1") -> dict[str, Path]:
    """Compile the kit with all warnings as errors and not a word printed; return its programs."""
    flags = (*COMPILERS[compiler], *STRICT, level, "-ffp-contract=off")
    objects = {}
    for source in sorted(folder.rglob("*.c")):
        objects[source.stem] = folder.parent / f"{compiler}-{source.stem}.o"
        silently([*flags, f"-I{folder}", "-c", str(source), "-o", str(objects[source.stem])])
    programs = ("selftest", "main")
    library = [str(path) for name, path in objects.items() if name not in programs]
    made = {}
    for name in programs:
        made[name] = folder.parent / f"{compiler}-{name}"
        silently([COMPILERS[compiler][0], str(objects[name]), *library, "-o", str(made[name]), "-lm"])
    return made


def silently(command: Sequence[str], folder: Path | None = None) -> None:
    """Runs a command that must succeed without a word."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


def run(program: Path) -> tuple[int, str]:
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def proves_itself(folder: Path, compiler: str = "gcc", level: str = "-O1") -> None:
    """Build and run self-test and example."""
    programs = build(folder, compiler, level)
    code, output = run(programs["selftest"])
    assert code == 0, output
    right = r"^selftest +(\d+) of +\1 right, worst error \S+ of its tolerance$"
    assert re.search(right, output, re.M), output
    assert run(programs["main"])[0] == 0


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }
