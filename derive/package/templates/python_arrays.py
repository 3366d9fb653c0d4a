"""Dynamics of the Stewart platform on arrays of the array API: NumPy, JAX, PyTorch and others.

Written by stewart-sym $version; do not edit.
SPDX-License-Identifier: 0BSD

Every number of a structure may be an array with one value for each pose. ``on`` is the arithmetic: selections,
square roots and constants. Where a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

OK, NOT_FINITE, SHORT_LEG, POLE, SINGULAR = range(5)
INDEFINITE = 6


class Arithmetic:
    """Functions of an array namespace, and the constants of its real numbers.

    xp: the namespace, such as ``numpy`` or ``jax.numpy``; real: its type of real numbers; None: ``xp.float64``.
    """

    def __init__(self, xp: Any, real: Any = None) -> None:
        self.xp = xp
        self.type = xp.float64 if real is None else real
        limits = xp.finfo(self.type)
        self.EPSILON, self.MAX = float(limits.eps), float(limits.max)
        self.NAN = float("nan")
        self.ROUNDING = 16 * self.EPSILON
        self.POLE_SINE = 4096 * self.EPSILON
        self.NEAR_POLE = 2.0**-6
        self.SHORTEST = (1 / self.MAX / self.EPSILON) ** 0.5
        self.SUSPECT = 4 * self.EPSILON**0.5
        self.SHORT_SHARE = 16 * self.SUSPECT
        self.KEPT, self.LEANING = 2.0**-5, 2.0**-3

    def real(self, value: Any) -> Any:
        """A number as an array."""
        return value if hasattr(value, "shape") else self.xp.asarray(value, dtype=self.type)

    def sqrt(self, value: Any) -> Any:
        """The square root."""
        return self.xp.sqrt(self.real(value))

    def size(self, value: Any) -> Any:
        """The absolute value."""
        return self.xp.abs(value) if hasattr(value, "shape") else abs(value)

    def larger(self, one: Any, other: Any) -> Any:
        """The larger of two numbers; the other one where one is NaN."""
        return self.where(one > other, one, other)

    def where(self, test: Any, yes: Any, no: Any) -> Any:
        """``yes`` where the test holds, else ``no``: of numbers, and of lists and structures part by part."""
        if isinstance(test, bool):
            return yes if test else no
        if isinstance(yes, list):
            return [self.where(test, one, other) for one, other in zip(yes, no, strict=True)]
        if hasattr(yes, "__dict__") and not hasattr(yes, "shape"):
            made = type(yes)()
            for name, value in vars(yes).items():
                setattr(made, name, self.where(test, value, getattr(no, name)))
            return made
        whole = all(isinstance(each, int) or "int" in str(getattr(each, "dtype", "")) for each in (yes, no))
        kind = self.xp.int32 if whole else self.type
        return self.xp.where(test, *(self.xp.asarray(each, dtype=kind) for each in (yes, no)))

    def anywhere(self, test: Any) -> bool:
        """Whether a test holds for any pose; true where arrays have no values yet, as while JAX traces."""
        try:
            return bool(self.xp.any(test)) if hasattr(test, "shape") else bool(test)
        except TypeError:
            return True

$program


def motion_of(on: Arithmetic, **fields: Any) -> Motion:
    """A motion from arrays: R (..., 9) or (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3).

    What is not given is zero; all share their leading shape.
    """
    made = Motion()
    for name, value in fields.items():
        array = on.xp.asarray(value, dtype=on.type)
        if name == "R" and array.shape[-1] == 3:
            array = on.xp.reshape(array, (*array.shape[:-2], 9))
        setattr(made, name, [array[..., i] for i in range(array.shape[-1])])
    return made
