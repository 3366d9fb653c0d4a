"""Via poses and paths through them: position and quaternion of the tool as a spline of degree 5.

The quaternion is normalized, so no orientation is singular; derivatives up to the fourth are continuous. The
paths through given via poses form a family, whose parameters are the variables of an optimization.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import finite_array, real_array, shown
from ..io.array_types import Array, Frozen, Indices
from ..motion import rotation
from ..motion.motion import Motion, pose_of
from ..motion.spline import DEGREE

COORDINATES = ("x", "y", "z", "roll", "pitch", "yaw")
"""Coordinates of a tolerance: translations in the base frame (m), rotations in the tool frame (rad)."""
CELLS = 4
"""Spline cells between two via poses."""
SAMPLES = 20
"""Poses in each cell at which costs are evaluated."""
_FINER = 5
_STEP = 1e-6
# Tolerance for sums of steps that exceed the last parameter by rounding errors.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class ViaPose(Frozen):
    """Via pose of the tool, with optional tolerances.

    Attributes
    ----------
    R : array_like, shape (3, 3)
        Rotation matrix from the platform frame to the base frame.
    t : array_like, shape (3,)
        Position of the tool in the base frame (m).
    tolerance_low, tolerance_high : array_like, shape (6,), optional
        Lower (<= 0) and upper (>= 0) tolerance: translations along the base axes (m), and a rotation vector
        phi in the platform frame (rad), with which R becomes R exp([phi]x).

    Raises
    ------
    ValueError
        If an argument is invalid.
    """

    R: Array
    t: Array
    tolerance_low: Array = field(default_factory=lambda: np.zeros(6))
    tolerance_high: Array = field(default_factory=lambda: np.zeros(6))

    def __post_init__(self) -> None:
        """Check the arguments."""
        for name, core in (("R", (3, 3)), ("t", (3,))):
            finite_array(getattr(self, name), core, name, batch=False)
        motion = pose_of((self.R, self.t), "pose", "a pose (R, t)")
        low, high = (
            finite_array(getattr(self, name), (6,), name, batch=False)
            for name in ("tolerance_low", "tolerance_high")
        )
        if (low > 0.0).any() or (high < 0.0).any():
            raise ValueError("tolerance_low, tolerance_high: expected six numbers <= 0 and six >= 0")
        self._set(
            {"R": np.array(motion.R), "t": np.array(motion.t), "tolerance_low": low, "tolerance_high": high}
        )

    @property
    def has_tolerance(self) -> bool:
        """True if the pose has a tolerance."""
        return bool((self.tolerance_high > self.tolerance_low).any())

    def shifted(self, shift: Array) -> ViaPose:
        """Return the pose displaced by a shift, without tolerance.

        Parameters
        ----------
        shift : ndarray, shape (6,)
            Translation (m) and rotation vector (rad), in the coordinates of the tolerances.

        Returns
        -------
        ViaPose
            Displaced pose; its tolerances are 0.
        """
        return ViaPose(self.R @ rotation.rotation_from_vector(shift[3:]), self.t + shift[:3])


def coordinates(poses: Sequence[ViaPose]) -> Array:
    """Return positions and unit quaternions, shape (k, 7), with continuous signs of the quaternions."""
    rows = [np.concatenate([pose.t, rotation.quaternion_from_rotation(pose.R)]) for pose in poses]
    for before, after in itertools.pairwise(rows):
        if before[3:] @ after[3:] < 0.0:
            after[3:] *= -1.0
    return np.array(rows)


def shifted(row: Array, shift: Array) -> Array:
    """Return the coordinates, shape (7,), of a pose displaced by a shift, shape (6,)."""
    half = 0.5 * np.linalg.norm(shift[3:])
    turn = np.concatenate([[np.cos(half)], 0.5 * np.sinc(half / np.pi) * shift[3:]])
    return np.concatenate([row[:3] + shift[:3], rotation.quaternion_product(row[3:], turn)])


@dataclass(frozen=True, eq=False)
class PosePath(Frozen):
    """Path of the platform, a function of s that returns a motion with derivatives with respect to s.

    Attributes
    ----------
    knots : ndarray, shape (n + 6,)
        Knots of the B-splines of degree 5; the first and last have multiplicity 6.
    coefficients : ndarray, shape (n, 7)
        Coefficients of the tool position in the base frame (m) and of a quaternion, scalar first.
    via : ndarray, shape (k,)
        Parameters of the via poses, from 0 to 1.
    tool : ndarray, shape (3,)
        Tool point in the platform frame (m).
    load : ndarray, shape (6,)
        External wrench [F_ext; M_ext] at the reference point in the platform frame (N and N m).
    """

    knots: Array
    coefficients: Array
    via: Array
    tool: Array
    load: Array

    def __post_init__(self) -> None:
        """Check the arguments."""
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
        """Return the motion at parameters s in [0, 1], shape (n,), with first and second derivatives by s.

        Raises
        ------
        ValueError
            If a parameter is outside [0, 1].
        """
        at = real_array(s, "s")
        if at.ndim != 1 or not np.all(np.abs(at - 0.5) <= 0.5 + _ROUNDING):
            raise ValueError(f"s: expected parameters in [0, 1], (n,), got {shown(s)}")
        at = np.clip(at, 0.0, 1.0)
        y, y_1, y_2 = (spline_values(self.knots, self.coefficients, at, order) for order in range(3))
        motion = Motion.from_quaternion(y[:, :3], y[:, 3:], y_1[:, :3], y_1[:, 3:], y_2[:, :3], y_2[:, 3:])
        motion = motion.at_point(-self.tool) if self.tool.any() else motion
        if not self.load.any():
            return motion
        F_ext, M_ext = (np.broadcast_to(part, motion.t.shape) for part in (self.load[:3], self.load[3:]))
        return Motion._unchecked(**(vars(motion) | {"F_ext": F_ext, "M_ext": M_ext}))


def spline_values(knots: Array, coefficients: Array, s: Array, order: int) -> Array:
    """Return a spline with coefficients (c, k), or its derivative of an order, at s, shape (len(s), k)."""
    from scipy.interpolate import BSpline

    spline = BSpline(knots, coefficients, DEGREE)
    return np.asarray(spline(s) if order == 0 else spline.derivative(order)(s))


def b_spline_values(knots: Array, s: Array, order: int) -> Array:
    """Return the B-splines of knots, or their derivatives of an order, at s, shape (len(s), n)."""
    return spline_values(knots, np.eye(len(knots) - DEGREE - 1), s, order)


def knots_between(via: Array, cells: int) -> Array:
    """Return knots with a number of cells between successive via poses."""
    inner = [np.linspace(a, b, cells + 1)[:-1] for a, b in itertools.pairwise(via)]
    return np.concatenate([np.zeros(DEGREE), *inner, np.ones(DEGREE + 1)])


@dataclass(frozen=True, eq=False)
class Family:
    """All splines through via poses, with parameters.

    The parameters are the shifts within the tolerances, shape (f,), and coordinates w, shape (m, 7).

    Attributes
    ----------
    s : ndarray, shape (n,)
        Samples.
    B : ndarray, shape (n, c)
        B-splines at the samples.
    between, fine : ndarray
        Samples and B-splines of a finer grid that includes the via poses.
    metric : ndarray, shape (c, c)
        Quadratic form of length and bending.
    through, rest : ndarray
        Matrices that give the coefficients through @ via + rest @ w.
    """

    poses: tuple[ViaPose, ...]
    via: Array
    knots: Array
    s: Array
    B: Array
    between: Array
    fine: Array
    metric: Array
    through: Array
    rest: Array
    rows: Array

    @classmethod
    def of(cls, poses: Sequence[ViaPose], length: float) -> Family:
        """Create the splines; the parameter is proportional to the distances of the poses."""
        rows = coordinates(poses)
        chords = np.linalg.norm(np.diff(rows * scales(length), axis=0), axis=-1)
        via = np.concatenate([[0.0], np.cumsum(chords) / chords.sum()])
        via[-1] = 1.0
        knots = knots_between(via, CELLS)
        edges = knots_between(via, CELLS * SAMPLES)[DEGREE:-DEGREE]
        s = 0.5 * (edges[1:] + edges[:-1])
        weights = np.diff(edges)
        rates = [b_spline_values(knots, s, order) for order in (1, 2)]
        speeds, bends = (rate.T @ (weights[:, None] * rate) for rate in rates)
        at_via = b_spline_values(knots, via, 0)
        through, rest = _through(at_via, bends)
        between = knots_between(via, CELLS * SAMPLES * _FINER)[DEGREE:-DEGREE]
        B, fine = (b_spline_values(knots, x, 0) for x in (s, between))
        metric = speeds + bends / (np.pi * (len(via) - 1)) ** 2
        return cls(tuple(poses), via, knots, s, B, between, fine, metric, through, rest, rows)

    @property
    def free(self) -> Indices:
        """Indices (via pose, coordinate) of all coordinates with a tolerance, shape (f, 2)."""
        return np.argwhere([pose.tolerance_high > pose.tolerance_low for pose in self.poses])

    def box(self) -> list[tuple[float, float]]:
        """Return the bounds of the coordinates with a tolerance."""
        return [
            (float(self.poses[k].tolerance_low[i]), float(self.poses[k].tolerance_high[i]))
            for k, i in self.free
        ]

    def shifts(self, values: Array) -> Array:
        """Return the shifts of all via poses, shape (k, 6), from the shifts within the tolerances."""
        found = np.zeros((len(self.poses), 6))
        found[tuple(self.free.T)] = values
        return found

    def coefficients(self, values: Array, w: Array) -> Array:
        """Return the coefficients of the spline, shape (c, 7)."""
        rows = np.array(
            [shifted(row, shift) for row, shift in zip(self.rows, self.shifts(values), strict=True)]
        )
        return np.asarray(self.through @ rows + self.rest @ w)

    def gradients(self, values: Array, by_coefficients: Array) -> tuple[Array, Array]:
        """Convert a gradient by coefficients, (c, 7), to gradients by shifts, (f,), and by w, (m, 7)."""
        by_rows, shifts = self.through.T @ by_coefficients, self.shifts(values)
        found = np.zeros(len(values))
        for number, (k, i) in enumerate(self.free):
            step = _STEP * np.eye(6)[i]
            ends = (shifted(self.rows[k], shifts[k] + sign * step) for sign in (1.0, -1.0))
            found[number] = by_rows[k] @ np.subtract(*ends) / (2.0 * _STEP)
        return found, self.rest.T @ by_coefficients

    def path(self, coefficients: Array, tool: Array, load: Array) -> PosePath:
        """Create the path with given coefficients."""
        return PosePath(self.knots, coefficients, self.via, tool, load)


def scales(length: float) -> Array:
    """Return factors, shape (7,), that convert coordinates to lengths relative to ``length``, and angles."""
    return np.repeat([1.0 / length, 2.0], [3, 4])


def poses_of(rows: Array) -> tuple[Array, Array]:
    """Return R and t from rows of coordinates, shape (n, 7)."""
    return rotation.rotation_from_quaternion(rows[:, 3:]), rows[:, :3]


def by_coordinates(rows: Array, by_twist: Array) -> Array:
    """Convert derivatives by twists, (n, 6), to coordinates, (n, 7): dphi is the vector of 2 de e^-1."""
    e = rows[:, 3:] / np.sum(rows[:, 3:] ** 2, axis=-1, keepdims=True)
    w, v, m = e[:, :1], e[:, 1:], by_twist[:, 3:]
    turn = 2.0 * np.concatenate([-np.sum(v * m, axis=-1, keepdims=True), w * m - np.cross(v, m)], axis=-1)
    return np.concatenate([by_twist[:, :3], turn], axis=-1)


def _through(at_via: Array, bends: Array) -> tuple[Array, Array]:
    """Return coefficients of least bending, (c, k), and the null space of the via poses, (c, c - k)."""
    _, _, vh = np.linalg.svd(at_via)
    rest = vh[len(at_via) :].T
    least: Array = np.linalg.pinv(at_via).astype(np.float64)
    bent = rest.T @ bends
    least_bent: Array = least - rest @ np.linalg.pinv(bent @ rest, hermitian=True) @ bent @ least
    return least_bent, rest
