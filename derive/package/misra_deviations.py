"""Where a kit's C departs from MISRA C:2012, rule by rule, with the reason.

Data for a kit's README: every rule for which the MISRA addon of cppcheck 2.10 reports something, summarized
in words of our own.
"""

from collections.abc import Collection
from dataclasses import dataclass

LANES = ("forces", "forces baked")
SCALAR = ("forces scalar", "forces scalar baked")
CLOSED_FORM = ("motion", "derivatives")
KINDS = (*LANES, *SCALAR, "reactions", *CLOSED_FORM, "kinematics", "axial", "torque", "rotation", "robot")
"""Kinds of sources: forces in lanes or scalar, with a model or baked; the others by their group of functions;
"robot" has the robot's constants."""


@dataclass(frozen=True)
class Deviation:
    """One rule that the sources of some kinds depart from.

    rule: number. what: what it is about. reason: why it is left so. kinds: out of KINDS.
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
        "stewart.h holds the types of all kernels; a source uses some",
        KINDS,
    ),
    Deviation("2.4", "struct definitions that a source does not use", "as 2.3", KINDS),
    Deviation(
        "2.5",
        "macros that a source does not use",
        "status codes, and one list of arithmetic macros, for all kernels",
        KINDS,
    ),
    Deviation(
        "8.7",
        "functions with external linkage called in their own source alone",
        "the interface: batches and the linearization call functions that users call as well",
        (*LANES, *CLOSED_FORM),
    ),
    Deviation(
        "8.14",
        "restrict",
        "without it compilers make no vector instructions of the loops over lanes; all pointers so marked "
        "are to different local objects or arguments",
        (*LANES, *CLOSED_FORM),
    ),
    Deviation(
        "2.2",
        "dead code",
        "one text serves every row of a block: the first adds zero to its index",
        CLOSED_FORM,
    ),
    Deviation(
        "9.3",
        "arrays initialized in part",
        "there is none: the checker takes a structure that a call returns for a list",
        CLOSED_FORM,
    ),
    Deviation(
        "10.3",
        "an expression assigned to a narrower or another type",
        "whether two conditions hold is kept as 1 or 0, as for poses side by side",
        CLOSED_FORM,
    ),
    Deviation(
        "10.4",
        "operands of an operator of different types",
        "whether two conditions hold is compared as 1 or 0",
        CLOSED_FORM,
    ),
    Deviation(
        "10.6",
        "an expression assigned to a wider type",
        "a status is chosen of two constants",
        (*CLOSED_FORM, "kinematics"),
    ),
    Deviation(
        "11.3",
        "pointers to one type of object cast to another",
        "a struct of nothing but stewart_real is read as its numbers, to find one that is not finite",
        ("forces", "reactions"),
    ),
    Deviation(
        "11.8",
        "const or volatile cast away",
        "there is none: the checker takes the pointers held by a const struct for pointers to const",
        ("reactions", *CLOSED_FORM),
    ),
    Deviation(
        "12.1",
        "brackets where precedence decides",
        "formulas are printed as they are written: a product before a sum",
        tuple(kind for kind in _CODE if kind != "axial"),
    ),
    Deviation(
        "12.3",
        "the comma operator",
        "there is none, clang's -Wcomma finds nothing: the checker counts commas between declarations",
        tuple(kind for kind in _CODE if kind != "torque"),
    ),
    Deviation(
        "15.5",
        "more than one return in a function",
        "a bad status returns at once, so that nothing is computed from what is not finite",
        tuple(kind for kind in _CODE if kind not in ("rotation", "torque")),
    ),
)


TOGETHER = Deviation(
    "5.9",
    "static names that several sources use",
    "static functions of a header are each source's own, and the same helper has the same name in each",
    tuple(kind for kind in _CODE if kind != "rotation"),
)
"""The rule from which only several sources together depart."""


def deviations(kinds: Collection[str]) -> tuple[Deviation, ...]:
    """The deviations of a kit whose sources are of these kinds."""
    several = len(set(kinds) & set(TOGETHER.kinds)) > 1
    return tuple(
        each for each in (*DEVIATIONS, *([TOGETHER] if several else [])) if set(kinds) & set(each.kinds)
    )
