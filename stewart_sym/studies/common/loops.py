"""C sources of the studies, and loops that call functions for one pose after another."""

from collections.abc import Mapping
from importlib.resources import files


def loop_source(
    header: str, body: str, pose: str = "stewart_motion", number: str = "stewart_real"
) -> dict[str, str]:
    """Generate the C source of the loop ``drive`` as text by file name.

    ``body`` of a function of ``machine``, ``motion``, and ``F`` computes the forces F of one pose and returns
    a status. ``pose`` and ``number`` are the types of ``motion`` and ``F``.
    """
    arguments = f"const void *machine, const {pose} *motion, {number} *F"
    text = f'#include <string.h>\n#include "{header}"\nstatic int call({arguments})\n{{\n{body}\n}}\n'
    return loops(text, {"drive": "call(machine, motion, out)"}, pose, number)


def loops(
    before: str, calls: Mapping[str, str], pose: str = "stewart_motion", number: str = "stewart_real"
) -> dict[str, str]:
    """Generate the C source of several loops; ``calls`` are expressions of ``machine``, ``motion``, ``F``,
    and ``out``, by name.
    """
    each = (
        f'#define DRIVE {name}\n#define CALL(motion, F, out) {call}\n#include "loop.h"\n'
        for name, call in calls.items()
    )
    text = f"{before}#define POSE {pose}\n#define NUMBER {number}\n{''.join(each)}"
    return {"loop.h": own_source("loop.h"), "loop.c": text}


def own_source(name: str) -> str:
    """Read a C file of this package."""
    return (files(__package__) / name).read_text(encoding="utf-8")
