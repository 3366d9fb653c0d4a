"""Smooth motions fitted to measured poses: Fourier series or splines, linear in their coefficients.

The coordinates are position and roll-pitch-yaw angles, q(t) = basis(t) c. Differentiating the basis in
place of the measured poses keeps their noise out of the accelerations; ``chain`` says what each coefficient
moves.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import instance, number_in, real_array, shown, whole_number
from ..io.array_types import Array, Indices
from ..io.extras import needed_for
from .motion import Motion
from .rotation import cross_matrix, rpy_from_rotation, vector_from_rotation
from .sample_times import elapsed

WITHOUT_PERIOD = "a smooth motion without a period"
"""What needs SciPy, in words."""


# Pitch angles beyond this, rad, leave roll and yaw too poorly determined to be smoothed.
_STEEPEST = 1.4
_DEGREE = 5
DISTINCT = 1e-4
"""Share of a column's length that those before it leave of it, above which normal equations have digits
enough."""
# Poses that the smallest spline goes through.
_FEWEST = 7
# Larger bases tried without a gain before the search for a basis ends.
_IN_VAIN = 4
# Scatter of poses over their stated noise from which on the noise is stated too small.
_TOO_SMALL = 2.0


@dataclass(frozen=True, eq=False)
class PoseNoise:
    """Noise of measured poses.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Increasing times (s).
    position, angle : float
        Standard deviations of each coordinate of the position (m) and of the rotation about each axis (rad).
        Samples are independent.
    period : float, optional
        Period (s). A periodic motion is modeled by a Fourier series, other motions by a spline of degree 5.
    harmonics : int, optional
        Number of harmonics of the series. None: chosen from the measurement.

    Raises
    ------
    ValueError
        If an argument is invalid. The message names it.
    """

    time: Array
    position: float
    angle: float
    period: float | None = None
    harmonics: int | None = None

    def __post_init__(self) -> None:
        time = real_array(self.time, "time", "increasing times, s, (n,)")
        if time.ndim != 1 or not np.isfinite(time).all() or not np.all(np.diff(time) > 0.0):
            raise ValueError(f"time: expected increasing times, s, (n,), got {shown(self.time)}")
        time.setflags(write=False)
        object.__setattr__(self, "time", time)
        for name, unit in (("position", "m"), ("angle", "rad")):
            number_in(getattr(self, name), name, f"a standard deviation > 0 {unit}")
        if self.period is not None:
            number_in(self.period, "period", "a duration > 0 s or None")
        if self.harmonics is None:
            return
        if self.period is None:
            raise ValueError("harmonics: expected None for a motion without a period")
        most = (len(time) - 1) // 2
        expected = f"a whole number from 1 to {most} for {len(time)} samples, or None"
        whole_number(self.harmonics, "harmonics", 1, expected, most)

    @property
    def weights(self) -> Array:
        """Reciprocal standard deviation of each coordinate (1/m, 1/rad), shape (6,)."""
        return 1.0 / np.repeat([self.position, self.angle], 3)


class Basis(NamedTuple):
    """Functions of time and their first two derivatives at n samples, (n, m) each.

    start: the first of the ``_DEGREE`` + 1 functions that are not zero at each sample, (n,); None for all.
    """

    value: Array
    first: Array
    second: Array
    start: Indices | None = None

    @property
    def size(self) -> int:
        """Number of functions, m."""
        return int(self.value.shape[1])

    @property
    def local(self) -> tuple[Array, Array, Array]:
        """Those that are not zero, (n, ``_DEGREE`` + 1) each, or all."""
        if self.start is None:
            return self[:3]
        near = self.start[:, None] + np.arange(_DEGREE + 1)
        value, first, second = (np.take_along_axis(part, near, axis=1) for part in self[:3])
        return value, first, second

    def motion(self, c: Array, load: Motion) -> Motion:
        """The motion of the coefficients c, (m, 6), under the load of another, (n,)."""
        q, q_dot, q_ddot = (part @ c for part in self[:3])
        t, v, a = (y[:, :3] for y in (q, q_dot, q_ddot))
        theta, theta_dot, theta_ddot = (y[:, 3:] for y in (q, q_dot, q_ddot))
        return Motion.from_rpy(t, theta, v, theta_dot, a, theta_ddot, load.F_ext, load.M_ext)


def estimate_pose_noise(
    time: ArrayLike, motion: Motion, period: float | None = None, harmonics: int | None = None
) -> PoseNoise:
    """Estimate the noise of measured poses from their scatter about a fitted smooth motion.

    The number of fitted functions grows as long as another function reduces the residual by more than noise
    does.

    Parameters
    ----------
    time : array_like, shape (n,)
        Increasing times (s).
    motion : Motion
        Measured poses, shape (n,); rates are ignored.
    period : float, optional
        Period (s); None for a motion that is not periodic.
    harmonics : int, optional
        Number of harmonics of the Fourier series. None: chosen from the measurement.

    Returns
    -------
    PoseNoise
        Times, standard deviations, and period.

    Raises
    ------
    ValueError
        If an argument is invalid, or if the poses do not scatter.
    """
    scale = PoseNoise(time, 1.0, 1.0, period, harmonics)  # type: ignore[arg-type]
    q = coordinates(motion, scale)
    if len(q) <= _FEWEST:
        raise ValueError(f"motion: expected more than {_FEWEST} poses, got {len(q)}")
    seen = _scatter(scale, q)
    if not min(seen) > 1e-12 * (1.0 + np.max(np.abs(q))):
        raise ValueError("motion: expected measured poses that scatter about a smooth motion, got exact ones")
    return PoseNoise(scale.time, float(seen[0]), float(seen[1]), period, harmonics)


def _scatter(noise: PoseNoise, q: Array, in_vain: float = math.inf) -> Array:
    """Deviations of position and angle about the fit with as many functions as noise calls for, (2,).

    in_vain: larger bases tried without a gain before the search ends.
    """
    least, best, vain = math.inf, np.zeros(2), 0
    for basis in bases(noise):
        squares = np.sum((q - basis.value @ pose_fit(basis, q)) ** 2, axis=0).reshape(2, 3).sum(axis=1)
        spare = 3 * (len(q) - basis.size)
        if spare <= 0:
            break
        with np.errstate(divide="ignore"):
            criterion = float(1.5 * len(q) * np.sum(np.log(squares)) + 6 * basis.size)
        vain += 1
        if criterion < least:
            least, best, vain = criterion, np.sqrt(squares / spare), 0
        elif vain > in_vain:
            break
    return best


def weights_of_choice(noise: PoseNoise, q: Array) -> Array:
    """Weights, (6,), by which a basis for measured coordinates, (n, 6), is chosen.

    Those of the stated noise, or of the scatter where this is far more: else the largest basis would be.
    """
    stated, seen = np.array([noise.position, noise.angle]), _scatter(noise, q, _IN_VAIN)
    return 1.0 / np.repeat(np.where(seen > _TOO_SMALL * stated, seen, stated), 3)


def coordinates(motion: Motion, noise: PoseNoise) -> Array:
    """Position and unwrapped angles of the measured poses, (n, 6).

    Raises ValueError for another number of samples, and for pitch angles near a right angle.
    """
    instance(motion, Motion, "motion")
    if motion.shape != noise.time.shape:
        raise ValueError(f"motion: expected {len(noise.time)} samples as in time, got shape {motion.shape}")
    theta = rpy_from_rotation(motion.R)
    steepest = float(np.max(np.abs(theta[:, 1]), initial=0.0))
    if steepest > _STEEPEST:
        raise ValueError(f"motion: expected theta_y within {_STEEPEST:g} rad of 0, got {steepest:.3g}")
    return np.concatenate([motion.t, np.unwrap(theta, axis=0)], axis=1)


def from_best(noise: PoseNoise, q: Array) -> Iterator[Basis]:
    """The bases from that on which explains measured coordinates, (n, 6), best for its size (Akaike)."""
    found: list[tuple[float, Basis]] = []
    weights, rest = weights_of_choice(noise, q), bases(noise)
    for basis in rest:
        off = (q - basis.value @ pose_fit(basis, q)) * weights
        found.append((float(np.sum(off**2)) + 2.0 * 6 * basis.size, basis))
        best = min(range(len(found)), key=lambda i: found[i][0])
        if len(found) > best + _IN_VAIN:
            break
    yield from (basis for _, basis in found[best:])
    yield from rest


def smoothed(motion: Motion, noise: PoseNoise) -> tuple[Motion, Array]:
    """The smooth motion that explains the measured poses alone best, under the load of the measured one.

    Also the deviations of its rates of position and angles, m/s and rad/s, (n, 6). Raises ValueError as
    ``coordinates``.
    """
    q = coordinates(motion, noise)
    basis = next(from_best(noise, q))
    _, corner = np.linalg.qr(basis.value)
    rates = np.linalg.norm(basis.first @ np.linalg.pinv(corner), axis=1)[:, None] / noise.weights
    return basis.motion(pose_fit(basis, q), motion), rates


def pose_fit(basis: Basis, q: Array) -> Array:
    """Coefficients by least squares, (m, 6)."""
    found = by_normal_equations(basis.value, q)
    return np.asarray(np.linalg.lstsq(basis.value, q, rcond=None)[0]) if found is None else found


def by_normal_equations(A: Array, y: Array) -> Array | None:
    """x of A x = y by least squares, y (n,) or (n, c); None where columns of A are nearly dependent.

    Its residual is corrected once, which gives back the digits that squares lose.
    """
    lengths = np.linalg.norm(A, axis=0)
    if not lengths.all():
        return None
    unit = A / lengths
    squares = unit.T @ unit
    try:
        G = np.linalg.cholesky(squares)
    except np.linalg.LinAlgError:
        return None
    if G.diagonal().min() < DISTINCT:
        return None
    x = np.zeros((A.shape[1], *y.shape[1:]))
    for _ in range(2):
        x += np.linalg.solve(squares, unit.T @ (y - unit @ x))
    return np.asarray((x.T / lengths).T)


def bases(noise: PoseNoise) -> Iterator[Basis]:
    """Bases to choose from, by rising size, at most three quarters as many functions as samples.

    Samples of several periods that are at one phase count once.
    """
    if noise.harmonics is not None and noise.period is not None:
        yield _fourier(noise.time, noise.period, noise.harmonics)
        return
    count = len(noise.time)
    if noise.period is not None:
        count = len(np.unique(np.rint(elapsed(noise.time) / noise.period % 1.0 * count)))
    size, most = 3, max(3 * count // 4, 7)
    while size <= most:
        if noise.period is not None:
            yield _fourier(noise.time, noise.period, (size - 1) // 2)
        elif size > _DEGREE:
            yield _spline(noise.time, size)
        size = max(size + 2, int(1.2 * size))


def residual(basis: Basis, c: Array, motion: Motion, noise: PoseNoise) -> Array:
    """Measured poses less those of the coefficients, over their deviations, (n, 6); turns as vectors."""
    smooth = basis.motion(c, motion)
    turn = vector_from_rotation(motion.R @ np.swapaxes(smooth.R, -1, -2))
    return np.concatenate([motion.t - smooth.t, turn], axis=1) * noise.weights


def chain(
    basis: Basis, c: Array, motion: Motion
) -> tuple[tuple[Array, ...], tuple[Array, ...], tuple[Array, ...]]:
    """What the coordinates and their derivatives move: maps to pose, twist and acceleration.

    motion: of the coefficients. Returns for the pose [dt; dphi], twist and acceleration the matrices (n, 6,
    6) by q; by q, q_dot; and by q, q_dot, q_ddot. A turn dphi = E dq changes the angular velocity by
    d(dphi)/dt - omega x dphi, and this in turn the angular acceleration by its rate.
    """
    q, q_dot, q_ddot = (part @ c for part in basis[:3])
    E, E_dot, E_ddot = _turns(q[:, 3:], q_dot[:, 3:], q_ddot[:, 3:])
    W, A = cross_matrix(motion.omega), cross_matrix(np.asarray(motion.alpha))
    one, zero = np.broadcast_to(np.eye(3), E.shape), np.zeros(E.shape)

    def both(position: Array, turn: Array) -> Array:
        return np.block([[position, zero], [zero, turn]])

    pose = (both(one, E),)
    twist = (both(zero, E_dot - W @ E), both(one, E))
    second = (
        both(zero, E_ddot - A @ E - W @ E_dot),
        both(zero, 2.0 * E_dot - W @ E),
        both(one, E),
    )
    return pose, twist, second


def _turns(theta: Array, rate: Array, second: Array) -> tuple[Array, Array, Array]:
    """E of omega = E theta_dot and its first two derivatives by time, (n, 3, 3)."""
    e_z = np.broadcast_to([0.0, 0.0, 1.0], theta.shape)
    (sin_y, sin_z), (cos_y, cos_z) = (f(theta[:, 1:]).T for f in (np.sin, np.cos))
    e_y = np.stack([-sin_z, cos_z, np.zeros_like(sin_z)], axis=-1)
    e_x = np.stack([cos_y * cos_z, cos_y * sin_z, -sin_y], axis=-1)
    about_y = rate[:, 2:] * e_z
    about_x = about_y + rate[:, 1:2] * e_y
    about_y_dot = second[:, 2:] * e_z
    about_x_dot = about_y_dot + second[:, 1:2] * e_y + rate[:, 1:2] * np.cross(about_y, e_y)
    columns = [
        (e, np.cross(w, e), np.cross(w_dot, e) + np.cross(w, np.cross(w, e)))
        for e, w, w_dot in ((e_x, about_x, about_x_dot), (e_y, about_y, about_y_dot))
    ]
    columns.append((e_z, np.zeros(e_z.shape), np.zeros(e_z.shape)))
    E, E_dot, E_ddot = (np.stack(parts, axis=-1) for parts in zip(*columns, strict=True))
    return E, E_dot, E_ddot


def _fourier(time: Array, period: float, harmonics: int) -> Basis:
    rate = 2.0 * math.pi / period * np.arange(1, harmonics + 1)
    angle = rate * elapsed(time)[:, None]
    sin, cos = np.sin(angle), np.cos(angle)
    one, zero = np.ones((len(time), 1)), np.zeros((len(time), 1))
    return Basis(
        np.hstack([one, sin, cos]),
        np.hstack([zero, rate * cos, -rate * sin]),
        np.hstack([zero, -(rate**2) * sin, -(rate**2) * cos]),
    )


def _spline(time: Array, size: int) -> Basis:
    """B-splines whose knots lie among the samples as densely as these do."""
    with needed_for(WITHOUT_PERIOD):
        from scipy.interpolate import BSpline
    since = elapsed(time)
    inner = np.interp(np.linspace(0.0, len(time) - 1.0, size - _DEGREE + 1), np.arange(len(time)), since)
    knots = np.concatenate([np.repeat(since[0], _DEGREE), inner, np.repeat(since[-1], _DEGREE)])
    functions = BSpline(knots, np.eye(size), _DEGREE)
    start = np.clip(np.searchsorted(inner, since, side="right") - 1, 0, size - _DEGREE - 1)
    value, first, second = (np.asarray(functions(since, order)) for order in range(3))
    return Basis(value, first, second, start)
