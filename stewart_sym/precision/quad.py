"""Actuator forces in quadruple precision (113 bits), as a reference for rounding errors of double and float.

The module compiles the plain elimination kernel for ``__float128`` of gcc, which requires libquadmath. This
kernel shares neither regrouping nor preparation with the fast kernel.
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
# -O1 is sufficient, because the operations are library calls. Without --no-as-needed the linker would drop a
# library that is named before the sources.
_FLAGS = ("-O1", "-include", "quadmath.h", "-Wl,--no-as-needed", "-lquadmath")


def quad_forces(
    robot: Robot, motion: Motion, dtype: type[np.floating[Any]] = np.float64, as_given: bool = False
) -> tuple[Array, Array]:
    """Compute actuator forces (N) as unevaluated sums high + low, (..., 6) each, in formulation `exact`.

    ``dtype`` is the type to which the inputs are rounded first. Unless ``as_given``, R is replaced by the
    nearest rotation and k by the unit vector along it. NaN for poses without a solution.

    Raises native.CompilerError without a compiler that has ``__float128``.
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
    """Return found - (high + low) in double precision without cancellation."""
    high, low = truth
    return (np.asarray(found, dtype=np.float64) - high) - low


def _rounded(array: Array | None, dtype: type[np.floating[Any]]) -> Array | None:
    return None if array is None else contiguous(array.astype(dtype).astype(np.float64))


def sources(name: str) -> dict[str, str]:
    """Return the C sources around the kernel of a name, by file name."""
    kernel = f'#include "stewart_{name}.h"\n#define INVERSE_DYNAMICS stewart_{name}_inverse_dynamics\n'
    own = (files(__package__) / "quad.c").read_text(encoding="utf-8")
    return c_sources(name) | {"kernel.h": kernel, "quad.c": own}


@functools.cache
def _library(name: str) -> ctypes.CDLL:
    return native.load(
        f"stewart_{name}_quad", sources(name), _FLAGS, {**_MACROS, **dict.fromkeys(defines_of(name), 1)}
    )
