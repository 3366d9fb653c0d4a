"""Common part of the array modules: status codes, constants, and functions of an array namespace.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

OK = 0  # solved
NOT_FINITE = 1  # an input is not finite, or a result overflows
ZERO_LENGTH = 2  # a leg has length zero
JOINT_SINGULAR = 3  # a leg lies along the fixed axis of its universal joint
SINGULAR = 4  # H is singular: no leg forces can hold the platform
MASS_MATRIX_INDEFINITE = 6  # the mass matrix M is not positive definite: no body has such inertias

CONSTANTS = {
    'double': {'EPSILON': 2.220446049250313e-16, 'MAX': 1.7976931348623157e+308, 'ROUNDING': 3.552713678800501e-15, 'JOINT_SINGULAR_SINE': 9.094947017729282e-13, 'NEAR_JOINT_SINGULAR': 0.03125, 'SHORTEST': 5.0052077379577523e-147, 'SUSPECT': 0.0001220703125, 'BLOCK_GROWTH': 16.0, 'BLOCK_LEAST': 0.00048828125, 'BLOCK_SINGULAR': 7.62939453125e-06, 'SHORT_SHARE': 9.5367431640625e-07, 'SMALLEST': 0.125, 'LARGEST': 16.0, 'KEPT': 0.0625, 'LEANING': 0.125},
    'float': {'EPSILON': 1.1920928955078125e-07, 'MAX': 3.4028234663852886e+38, 'ROUNDING': 1.9073486328125e-06, 'JOINT_SINGULAR_SINE': 0.00048828125, 'NEAR_JOINT_SINGULAR': 0.03125, 'SHORTEST': 1.5700925054761787e-16, 'SUSPECT': 0.0078125, 'BLOCK_GROWTH': 16.0, 'BLOCK_LEAST': 0.00048828125, 'BLOCK_SINGULAR': 0.000244140625, 'SHORT_SHARE': 0.0625, 'SMALLEST': 0.125, 'LARGEST': 16.0, 'KEPT': 0.0625, 'LEANING': 0.125},
}


class Arithmetic:
    """Functions of an array namespace, and the constants of its real numbers.

    Parameters
    ----------
    xp : module
        Array namespace, such as ``numpy`` or ``jax.numpy``.
    real : dtype, optional
        Type of real numbers. If None, ``xp.float64`` or its replacement in the namespace.
    """

    NAN: float
    LANES: float
    POSES: float
    BAD_ARGUMENT: float
    EPSILON: float
    MAX: float
    ROUNDING: float
    JOINT_SINGULAR_SINE: float
    NEAR_JOINT_SINGULAR: float
    SHORTEST: float
    SUSPECT: float
    BLOCK_GROWTH: float
    BLOCK_LEAST: float
    BLOCK_SINGULAR: float
    SHORT_SHARE: float
    SMALLEST: float
    LARGEST: float
    KEPT: float
    LEANING: float

    def __init__(self, xp: Any, real: Any = None) -> None:
        self.xp = xp
        self.type = xp.asarray(0.0, dtype=xp.float64 if real is None else real).dtype
        self.whole = xp.int32
        double = float(xp.finfo(self.type).eps) < 2.0**-40
        self.NAN = float("nan")
        vars(self).update(CONSTANTS["double" if double else "float"])

    def real(self, value: Any) -> Any:
        """Convert a number to an array."""
        return value if hasattr(value, "shape") else self.xp.asarray(value, dtype=self.type)

    def arrays(self, value: Any) -> Any:
        """Convert the real numbers of a structure or list to arrays, so that division by zero is no error."""
        if isinstance(value, list):
            return [self.arrays(each) for each in value]
        if hasattr(value, "shape") or isinstance(value, int):
            return value
        if isinstance(value, float):
            return self.real(value)
        made = type(value)()
        for name, each in vars(value).items():
            setattr(made, name, self.arrays(each))
        return made

    def checked(self, made: Any, name: str, value: Any) -> Any:
        """Convert ``value`` to the structure and type of ``made``.

        A value with a status was returned by a function and is not checked.

        Raises
        ------
        ValueError
            If the structure or shape differs; the message begins with the name of the argument or member.
        """
        if isinstance(made, int | float):
            return value if isinstance(made, int) else self.number(value)
        if isinstance(made, list) and not hasattr(made[0], "__dict__"):
            return self.components(name, value, len(made))
        if isinstance(made, list):
            if len(value) != len(made):
                raise ValueError(f"{name}: expected {len(made)}, got {len(value)}")
            return [self.checked(one, name, each) for one, each in zip(made, value, strict=True)]
        if type(value) is not type(made):
            raise ValueError(f"{name}: expected {type(made).__name__}, got {type(value).__name__}")
        if hasattr(made, "status"):
            return value
        for member, each in vars(made).items():
            setattr(made, member, self.checked(each, member, getattr(value, member)))
        return made

    def number(self, value: Any) -> Any:
        """Convert a number to the type of real numbers."""
        known = hasattr(value, "dtype") and value.dtype == self.type
        return value if known else self.xp.asarray(value, dtype=self.type)

    def components(self, name: str, value: Any, count: int) -> Any:
        """Split a list, or the last axis of an array, to a list of components."""
        if isinstance(value, list | tuple):
            if len(value) != count or any(isinstance(each, list | tuple) for each in value):
                got = "nested lists" if len(value) == count else f"{len(value)}"
                raise ValueError(f"{name}: expected {count} numbers or arrays, got {got}")
            return [self.number(each) for each in value]
        array = self.number(value)
        if array.ndim == 0 or array.shape[-1] != count:
            raise ValueError(f"{name}: expected shape (..., {count}), got {tuple(array.shape)}")
        return [array[..., i] for i in range(count)]

    def agree(self, **given: Any) -> None:
        """Raise ValueError if the shape of an argument or member does not broadcast with the others."""
        shape: tuple[int, ...] = ()
        for name, each in self.parts(given.items()):
            own = tuple(getattr(each, "shape", ()))
            if own in (shape, ()):
                continue
            count = max(len(own), len(shape))
            pairs = [*zip((1,) * (count - len(own)) + own, (1,) * (count - len(shape)) + shape, strict=True)]
            if any(one != other and 1 not in (one, other) for one, other in pairs):
                raise ValueError(f"{name}: expected a leading shape that broadcasts with {shape}, got {own}")
            shape = tuple(other if one == 1 else one for one, other in pairs)

    def parts(self, named: Any) -> Any:
        """Yield each number of structures and lists with the name of its member or argument."""
        for name, value in named:
            if isinstance(value, list):
                yield from self.parts((name, each) for each in value)
            elif hasattr(value, "__dict__") and not hasattr(value, "shape"):
                yield from self.parts(vars(value).items())
            else:
                yield name, value

    def fill(self, made: Any, fields: Any) -> None:
        """Fill a structure from arrays with components along the last axis; R may be (..., 3, 3)."""
        if "R" not in fields:
            raise ValueError("R: expected shape (..., 3, 3) or (..., 9), got none")
        for name, value in fields.items():
            if name not in vars(made):
                raise ValueError(f"{name}: expected one of {', '.join(vars(made))}")
            try:
                array = self.xp.asarray(value, dtype=self.type)
            except (TypeError, ValueError) as error:
                raise ValueError(f"{name}: expected real numbers, {error}") from None
            if name == "R" and tuple(array.shape[-2:]) == (3, 3):
                array = self.xp.reshape(array, (*array.shape[:-2], 9))
            setattr(made, name, self.components(name, array, len(getattr(made, name))))

    def sqrt(self, value: Any) -> Any:
        """Compute the square root."""
        return self.xp.sqrt(self.real(value))

    def size(self, value: Any) -> Any:
        """Compute the absolute value."""
        return self.xp.abs(value) if hasattr(value, "shape") else abs(value)

    def larger(self, one: Any, other: Any) -> Any:
        """Return the larger of two numbers, or ``other`` if ``one`` is NaN."""
        return self.where(one > other, one, other)

    def where(self, test: Any, yes: Any, no: Any) -> Any:
        """Select ``yes`` if the test is true, else ``no``, for numbers, lists, and structures."""
        if isinstance(test, bool):
            return yes if test else no
        kind = getattr(yes, "dtype", None)
        if kind is not None and kind == getattr(no, "dtype", None):
            return self.xp.where(test, yes, no)
        if isinstance(yes, list):
            return [self.where(test, one, other) for one, other in zip(yes, no, strict=True)]
        if hasattr(yes, "__dict__") and not hasattr(yes, "shape"):
            made = type(yes)()
            for name, value in vars(yes).items():
                setattr(made, name, self.where(test, value, getattr(no, name)))
            return made
        kind = self.whole if self.is_whole(yes) and self.is_whole(no) else self.type
        return self.xp.where(test, self.xp.asarray(yes, dtype=kind), self.xp.asarray(no, dtype=kind))

    def is_whole(self, value: Any) -> bool:
        """Return True if a number or the elements of an array are integers."""
        kind = getattr(value, "dtype", None)
        return isinstance(value, int) or kind == self.whole or (kind != self.type and "int" in str(kind))

    def at(self, array: Any, first: Any, *others: Any) -> Any:
        """Return an element of an array; the index may differ between poses."""
        if isinstance(first, int):
            return self.at(array[first], *others) if others else array[first]
        found, *more = (self.at(each, *others) if others else each for each in array)
        for i, each in enumerate(more, 1):
            found = self.where(first == i, each, found)
        return found

    def put(self, array: Any, value: Any, first: Any, *others: Any) -> None:
        """Set an element of an array; the index may differ between poses."""
        for i in [first] if isinstance(first, int) else range(len(array)):
            here = True if isinstance(first, int) else first == i
            if others:
                self.put(array[i], self.where(here, value, self.at(array[i], *others)), *others)
            else:
                array[i] = self.where(here, value, array[i])

    def anywhere(self, test: Any) -> bool:
        """Return True if a test is true for any pose, or if arrays have no values, as in ``jit`` and ``vmap``."""
        try:
            return bool(self.xp.any(test)) if hasattr(test, "shape") else bool(test)
        except (TypeError, RuntimeError):
            return True
