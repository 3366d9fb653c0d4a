"""Status codes and arithmetic constants, in one table for the reader, the interpreter, and all languages."""

from math import sqrt

STATUSES = (
    ("OK", 0, "solved"),
    ("NOT_FINITE", 1, "an input is not finite, or a result overflows"),
    ("ZERO_LENGTH", 2, "a leg has length zero"),
    ("JOINT_SINGULAR", 3, "a leg lies along the fixed axis of its universal joint"),
    ("SINGULAR", 4, "H is singular: no leg forces can hold the platform"),
    (
        "BAD_ARGUMENT",
        5,
        "an argument is invalid: a pointer is null, stride < count, or an index is out of range",
    ),
    ("MASS_MATRIX_INDEFINITE", 6, "the mass matrix M is not positive definite: no body has such inertias"),
    ("NOT_CONVERGED", 7, "no pose with these leg lengths was found"),
)
"""Name, code and meaning of each status."""

STATUS = {
    name: (code, meaning) for name, code, meaning in STATUSES if name not in ("BAD_ARGUMENT", "NOT_CONVERGED")
}
"""Code and meaning by name, of what kernels without pointers and searches return."""

SEARCH = {
    "NOT_CONVERGED": next((code, says) for name, code, says in STATUSES if name == "NOT_CONVERGED"),
    "MAX_STEPS": (30, "steps after which a search of a pose ends"),
    "MAX_SEARCHES": (3, "searches of a pose that may not be the nearest to the guess"),
}
INTEGERS = STATUS | SEARCH
"""Whole numbers that written functions may use."""

SMALLEST, LARGEST = 0.125, 16.0
"""Sizes of platforms, m, between which forces and moments in meters compare well enough.

Of 10^4 poses none loses more than 6.1 rounding units times its condition number at 1/8 m, 2 at 1 m and above,
but 10 at 1/16 m. In float, pivots that are rounding error of moments come near
``STEWART_SUSPECT`` at 64 m.
"""

PRECISIONS = {
    "double": (2.0**-52, float.fromhex("0x1.fffffffffffffp1023")),
    "float": (2.0**-23, float.fromhex("0x1.fffffep127")),
}
"""Rounding unit and largest number."""


def constants(precision: str) -> dict[str, float]:
    """Return the constants of "double" or "float" by name, as in the C sources, which describe each."""
    epsilon, largest = PRECISIONS[precision]
    double = precision == "double"
    return {
        "EPSILON": epsilon,
        "MAX": largest,
        "ROUNDING": 16 * epsilon,
        "JOINT_SINGULAR_SINE": 4096 * epsilon,
        "NEAR_JOINT_SINGULAR": 2.0**-5,
        "SHORTEST": sqrt(1 / largest / epsilon),
        "SUSPECT": 2.0**-13 if double else 2.0**-7,
        "BLOCK_GROWTH": 16.0,
        "BLOCK_LEAST": 2.0**-11,
        "BLOCK_SINGULAR": 2.0**-17 if double else 2.0**-12,
        "SHORT_SHARE": 64 * sqrt(epsilon) if double else 2.0**-4,
        "SMALLEST": SMALLEST,
        "LARGEST": LARGEST,
        "KEPT": 2.0**-4,
        "LEANING": 2.0**-3,
    }


def unchecked(epsilon: float) -> dict[str, float]:
    """Return constants for an arithmetic of many digits in which every pose is regular.

    ``epsilon`` is the tolerance of searches.
    """
    known = {"EPSILON": epsilon, "ROUNDING": 16 * epsilon, "MAX": float("inf"), "NAN": float("nan")}
    return dict.fromkeys(constants("double"), 0.0) | {"SMALLEST": SMALLEST, "LARGEST": LARGEST} | known


NAMES = ("NAN", "LANES", "POSES", "BAD_ARGUMENT", *constants("double"))
"""Names of the constants that written functions may use."""
