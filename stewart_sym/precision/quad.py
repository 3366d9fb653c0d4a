"""The actuator forces in quadruple precision, 113 bits: truth for what double and float round away.

Compiles the plain elimination kernel, which shares neither regrouping nor preparation with the fast one,
for gcc's ``__float128``; needs libquadmath.
"""

import ctypes
import functools
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend import native
from ..backend.c_kernel import address, c_sources, contiguous, pointers
from ..backend.kernel import MOTION, defines_of, robot_kernel, robot_numbers, takes_rotors
from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot

_MACROS = {
    "STEWART_REAL": "__float128",
    "STEWART_SQRT": "sqrtq",
    "STEWART_FABS": "fabsq",
    "STEWART_EPSILON": "FLT128_EPSILON",
    "STEWART_MAX": "FLT128_MAX",
}
# Optimizing does not shorten operations that are calls of a library. A library named before the sources is
# dropped, as nothing needs it yet, unless the linker must keep it.
_FLAGS = ("-O1", "-include", "quadmath.h", "-Wl,--no-as-needed", "-lquadmath")


def quad_forces(
    robot: Robot, motion: Motion, dtype: type[np.floating[Any]] = np.float64, as_given: bool = False
) -> tuple[Array, Array]:
    """Actuator forces as unevaluated sums high + low, N, (..., 6) each, of the exact formulation.

    dtype: to which the inputs are rounded first. R is replaced by the rotation nearest to it and k by the
    unit vector along it, unless as_given. NaN for unsolvable poses.

    Raises native.CompilerError where there is no compiler with ``__float128``.
    """
    name = robot_kernel(robot, "exact")
    numbers = _rounded(robot_numbers(robot, takes_rotors(name)), dtype)
    inputs = [_rounded(getattr(motion, field), dtype) for field in MOTION]
    high, low = (np.full((*motion.shape, 6), np.nan) for _ in range(2))
    _library(name).quad_forces(
        address(numbers),
        ctypes.c_size_t(high.size // 6),
        pointers(inputs),
        ctypes.c_int(not as_given),
        address(high),
        address(low),
    )
    return high, low


def error(found: NDArray[Any], truth: tuple[Array, Array]) -> Array:
    """found minus high + low, in double, without losing what they have in common."""
    high, low = truth
    return (np.asarray(found, dtype=np.float64) - high) - low


def _rounded(array: Array | None, dtype: type[np.floating[Any]]) -> Array | None:
    return None if array is None else contiguous(array.astype(dtype).astype(np.float64))


def sources(name: str) -> dict[str, str]:
    """File name -> text of the C around the kernel of that name."""
    kernel = f'#include "stewart_{name}.h"\n#define INVERSE_DYNAMICS stewart_{name}_inverse_dynamics\n'
    own = (files(__package__) / "quad.c").read_text(encoding="utf-8")
    return c_sources(name) | {"kernel.h": kernel, "quad.c": own}


@functools.cache
def _library(name: str) -> ctypes.CDLL:
    return native.load(
        f"stewart_{name}_quad", sources(name), _FLAGS, {**_MACROS, **dict.fromkeys(defines_of(name), 1)}
    )
