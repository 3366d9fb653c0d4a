"""Deviations of a kit's C code from MISRA C:2012, with the reason for each rule.

The README of a kit lists each rule for which the MISRA addon of cppcheck 2.10 reports a finding. The
summaries of the rules are our own words.
"""

from collections.abc import Collection
from dataclasses import dataclass

LANES = ("forces", "forces baked")
SCALAR = ("forces scalar", "forces scalar baked")
CLOSED_FORM = ("motion", "derivatives")
KINDS = (*LANES, *SCALAR, "reactions", *CLOSED_FORM, "kinematics", "axial", "torque", "rotation", "robot")
"""Kinds of sources.

Forces are in lanes or scalar, with a model or baked. Other kinds are groups of functions; "robot" has the
constants.
"""


@dataclass(frozen=True)
class Deviation:
    """Rule from which the sources of some kinds deviate.

    Attributes
    ----------
    rule, what : str
        Number and subject of the rule.
    reason : str
        Reason for the deviation.
    kinds : tuple of str
        Kinds of sources, out of KINDS.
    """

    rule: str
    what: str
    reason: str
    kinds: tuple[str, ...]


_CODE = tuple(kind for kind in KINDS if kind != "robot")

DEVIATIONS = (
    Deviation(
        "2.3",
        "types that a source does not use",
        "stewart.h contains the types of all kernels; a source uses some of them",
        KINDS,
    ),
    Deviation("2.4", "struct definitions that a source does not use", "as 2.3", KINDS),
    Deviation(
        "2.5",
        "macros that a source does not use",
        "status codes and arithmetic macros are common to all kernels",
        KINDS,
    ),
    Deviation(
        "8.7",
        "functions with external linkage called only in their own source",
        "batches and the linearization call functions of the interface, which users call too",
        (*LANES, *CLOSED_FORM),
    ),
    Deviation(
        "8.14",
        "restrict",
        "without it compilers do not vectorize the loops over lanes; all pointers with restrict "
        "point to different local objects or arguments",
        (*LANES, *CLOSED_FORM),
    ),
    Deviation(
        "2.2",
        "dead code",
        "all rows of a block use the same code: the first row adds zero to its index",
        CLOSED_FORM,
    ),
    Deviation(
        "9.3",
        "arrays initialized in part",
        "none exists: the checker mistakes a structure returned by a call for a list",
        CLOSED_FORM,
    ),
    Deviation(
        "10.3",
        "an expression assigned to a narrower or another type",
        "the result of two conditions is stored as 1 or 0, as in batches",
        CLOSED_FORM,
    ),
    Deviation(
        "10.4",
        "operands of an operator of different types",
        "the result of two conditions is compared as 1 or 0",
        CLOSED_FORM,
    ),
    Deviation(
        "10.6",
        "an expression assigned to a wider type",
        "a status is selected from two constants",
        (*CLOSED_FORM, "kinematics"),
    ),
    Deviation(
        "11.3",
        "pointers to one type of object cast to another",
        "a struct that contains only stewart_real is read as an array to find numbers that are not finite",
        ("forces", "reactions"),
    ),
    Deviation(
        "11.8",
        "const or volatile cast away",
        "none exists: the checker mistakes pointers in a const struct for pointers to const",
        ("reactions", *CLOSED_FORM),
    ),
    Deviation(
        "12.1",
        "parentheses around operands with other operators",
        "formulas use the usual precedence: a product before a sum",
        tuple(kind for kind in _CODE if kind != "axial"),
    ),
    Deviation(
        "12.3",
        "the comma operator",
        "none exists, and clang's -Wcomma reports none: the checker counts commas between declarations",
        tuple(kind for kind in _CODE if kind != "torque"),
    ),
    Deviation(
        "15.5",
        "more than one return in a function",
        "a bad status returns at once, so that numbers that are not finite are not used",
        tuple(kind for kind in _CODE if kind not in ("rotation", "torque")),
    ),
)


TOGETHER = Deviation(
    "5.9",
    "static names that several sources use",
    "each source has its own copy of the static functions of a header, under the same name",
    tuple(kind for kind in _CODE if kind != "rotation"),
)
"""Rule from which only several sources together deviate."""


def deviations(kinds: Collection[str]) -> tuple[Deviation, ...]:
    """Return the deviations of a kit with sources of these kinds."""
    several = len(set(kinds) & set(TOGETHER.kinds)) > 1
    return tuple(
        each for each in (*DEVIATIONS, *([TOGETHER] if several else [])) if set(kinds) & set(each.kinds)
    )
