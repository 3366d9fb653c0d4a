"""The actuator forces in quadruple precision, 113 bits: truth for what double and float round away.

Compiles the plain elimination kernel, which shares neither regrouping nor preparation with the fast one, for
gcc's ``__float128``; needs libquadmath. Knows the layout of ``stewart.h`` and no equation.
"""

import ctypes
import functools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import native
from ..kernel import MOTION, address, c_sources, contiguous, kernel_name, robot_numbers
from ..motion import Motion
from ..robot import Robot

Array = NDArray[np.float64]

_MACROS = {
    "STEWART_REAL": "__float128",
    "STEWART_SQRT": "sqrtq",
    "STEWART_FABS": "fabsq",
    "STEWART_EPSILON": "FLT128_EPSILON",
    "STEWART_MAX": "FLT128_MAX",
}
# Of the linker's libraries that stand before the sources, only those kept by force are linked.
_FLAGS = ("-include", "quadmath.h", "-Wl,--no-as-needed", "-lquadmath")


def quad_forces(
    robot: Robot, motion: Motion, dtype: type[np.floating[Any]] = np.float64, as_given: bool = False
) -> tuple[Array, Array]:
    """Actuator forces as unevaluated sums high + low, N, (..., 6) each, of the exact formulation.

    dtype: to which the inputs are rounded first. R is replaced by the rotation nearest to it and k by the
    unit vector along it, unless as_given. NaN for poses without an answer.

    Raises native.CompilerError where there is no compiler with ``__float128``.
    """
    name = kernel_name("exact", robot.base_joint)
    numbers = _rounded(robot_numbers(robot), dtype)
    inputs = [_rounded(getattr(motion, field), dtype) for field in MOTION]
    high, low = (np.full((*motion.shape, 6), np.nan) for _ in range(2))
    _library(name).quad_forces(
        address(numbers),
        ctypes.c_size_t(high.size // 6),
        (ctypes.c_void_p * len(inputs))(*map(address, inputs)),
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


@functools.cache
def _library(name: str) -> ctypes.CDLL:
    sources = c_sources(name) | {"stewart_quad.c": _SOURCE.replace("@NAME@", name)}
    return native.load(f"stewart_{name}_quad", sources, _FLAGS, _MACROS)


_SOURCE = """\
#include "stewart_@NAME@.h"

typedef struct {
    const double *R, *t, *omega, *v, *alpha, *a, *F_ext, *M_ext;
} double_motions;

static void widen(__float128 *to, const double *from, size_t count)
{
    size_t i;
    for (i = 0; i < count; ++i) {
        to[i] = from ? from[i] : 0;
    }
}

static void normalise(__float128 k[3])
{
    const __float128 size = sqrtq(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
    int i;
    for (i = 0; i < 3 && size > 0; ++i) {
        k[i] = k[i] / size;
    }
}

/* Newton-Schulz: R (3 - R^T R) / 2 squares the distance to the nearest rotation. */
static void nearest_rotation(__float128 R[9])
{
    int step, i, j, k, m;
    for (step = 0; step < 5; ++step) {
        __float128 next[9];
        for (i = 0; i < 3; ++i) {
            for (j = 0; j < 3; ++j) {
                next[3 * i + j] = 3 * R[3 * i + j] / 2;
                for (k = 0; k < 3; ++k) {
                    for (m = 0; m < 3; ++m) {
                        next[3 * i + j] -= R[3 * i + k] * R[3 * m + k] * R[3 * m + j] / 2;
                    }
                }
            }
        }
        for (i = 0; i < 9; ++i) {
            R[i] = next[i];
        }
    }
}

void quad_forces(
    const double *numbers, size_t count, const double_motions *motions, int ideal, double *high, double *low)
{
    stewart_robot robot;
    stewart_forces forces;
    size_t pose;
    int i;
    widen((__float128 *)&robot, numbers, sizeof robot / sizeof robot.M);
    for (i = 0; i < 6 && ideal; ++i) {
        normalise(robot.leg[i].k);
    }
    for (pose = 0; pose < count; ++pose) {
        stewart_motion at;
        widen(at.R, motions->R + 9 * pose, 9);
        widen(at.t, motions->t + 3 * pose, 3);
        widen(at.omega, motions->omega + 3 * pose, 3);
        widen(at.v, motions->v + 3 * pose, 3);
        widen(at.alpha, motions->alpha + 3 * pose, 3);
        widen(at.a, motions->a + 3 * pose, 3);
        widen(at.F_ext, motions->F_ext ? motions->F_ext + 3 * pose : 0, 3);
        widen(at.M_ext, motions->M_ext ? motions->M_ext + 3 * pose : 0, 3);
        if (ideal) {
            nearest_rotation(at.R);
        }
        if (stewart_@NAME@_inverse_dynamics(&robot, &at, &forces) != STEWART_OK) {
            continue;
        }
        for (i = 0; i < 6; ++i) {
            high[6 * pose + (size_t)i] = (double)forces.F[i];
            low[6 * pose + (size_t)i] = (double)(forces.F[i] - high[6 * pose + (size_t)i]);
        }
    }
}
"""
