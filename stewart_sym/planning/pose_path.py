"""Smooth paths of poses: position and quaternion of a point of the platform as one spline of degree 5.

The quaternion is made a unit one, so no orientation is special; rates up to the fourth are continuous.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, real_array, shown
from ..io.array_types import Array
from ..io.extras import needed_for
from ..io.frozen import Frozen
from ..motion.interpolation import DEGREE
from ..motion.motion import Motion

# By how much sums of steps may end beyond the last parameter.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class PosePath(Frozen):
    """A path of the platform; called with parameters s it returns its motion by s.

    Attributes
    ----------
    knots : ndarray
        Of the B-splines of degree 5, the first and last six times, (n + 6,).
    coefficients : ndarray
        Of the tool's position, m, base frame, and of a quaternion, scalar first, (n, 7).
    via : ndarray
        Parameters of the via poses, from 0 to 1, (k,).
    tool : ndarray
        Point whose position that is, m, platform frame, (3,).
    load : ndarray
        External wrench [F_ext; M_ext] at the reference point, N and N m, platform frame, (6,).
    """

    knots: Array
    coefficients: Array
    via: Array
    tool: Array
    load: Array

    def __post_init__(self) -> None:
        """Freeze copies of the arrays."""
        shapes = {"knots": (), "coefficients": (7,), "via": (), "tool": (3,), "load": (6,)}
        self._set(
            {
                name: finite_array(getattr(self, name), core, name)
                if core
                else real_array(getattr(self, name), name)
                for name, core in shapes.items()
            }
        )

    def __call__(self, s: ArrayLike) -> Motion:
        """Return poses at parameters s in [0, 1], (n,), with first and second derivatives by s.

        Raises ValueError for others.
        """
        at = real_array(s, "s")
        if at.ndim != 1 or not np.all(np.abs(at - 0.5) <= 0.5 + _ROUNDING):
            raise ValueError(f"s: expected parameters in [0, 1], (n,), got {shown(s)}")
        at = np.clip(at, 0.0, 1.0)
        y, y_1, y_2 = (b_spline_values(self.knots, at, order) @ self.coefficients for order in range(3))
        motion = Motion.from_quaternion(y[:, :3], y[:, 3:], y_1[:, :3], y_1[:, 3:], y_2[:, :3], y_2[:, 3:])
        motion = motion.about_point(-self.tool) if self.tool.any() else motion
        loads = (np.broadcast_to(part, motion.t.shape) for part in (self.load[:3], self.load[3:]))
        return Motion.unchecked(
            motion.R,
            motion.t,
            motion.omega,
            motion.v,
            motion.alpha,
            motion.a,
            *(loads if self.load.any() else ()),
        )


def b_spline_values(knots: Array, s: Array, order: int) -> Array:
    """B-splines of the knots, or derivatives of an order, at s, (len(s), n)."""
    with needed_for("a path"):
        from scipy.interpolate import BSpline
    count = len(knots) - DEGREE - 1
    spline = BSpline(knots, np.eye(count), DEGREE)
    return np.asarray(spline(s) if order == 0 else spline.derivative(order)(s))


def knots_between(via: Array, cells: int) -> Array:
    """Knots with a number of cells from each via pose to the next."""
    inner = [np.linspace(a, b, cells + 1)[:-1] for a, b in itertools.pairwise(via)]
    return np.concatenate([np.zeros(DEGREE), *inner, np.ones(DEGREE + 1)])
