"""Families 1: H becomes singular in four ways; candidate solvers compared with the shipped kernels."""

import functools
from collections.abc import Callable
from dataclasses import replace

import mpmath
import numpy as np

from ...dynamics.damping import damped_least_squares
from ...io.array_types import Array
from ...kinematics.conditioning import characteristic_length, moments_over
from ...kinematics.inverse_kinematics import wrench_matrix
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_rpy, rotation_from_vector, rpy_from_rotation
from ...motion.straight_line import PAPER_PATHS
from ...precision.truth import digits
from ...reference.newton_euler import actuator_wrench
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ...singularities.path_singularities import singularity_crossings
from . import shipped
from .family import Curve, Family, distances
from .sweep.machines import flat, meeting_one_line, random_machine, random_motion, similar_hexagons

FAILS = "H singular"
REMEDY = "elimination with partial pivoting; status 4 if a pivot is at the rounding level of its row"

DAMPED = "damped least squares"
"""Solver of ``on_singular="damped"``, which returns bounded forces of another wrench."""


def families(seed: int = 6) -> list[Family]:
    """Return four families: crossing of Path III, similar hexagons at 90 degrees, six lines that meet one
    line, flat pose.
    """
    found = []
    for name, title, axis, make in (
        ("path_III", "Path III crosses a singular pose", "time from the crossing, s", lambda _: path_III()),
        ("hexagons", "Similar hexagons turned by 90 degrees", "angle from 90 degrees, rad", _hexagons),
        ("line", "Six legs meet one line", "turn away from that pose, rad", _line),
        ("flat", "Six legs in one plane", "height over the plane, m", _flat),
    ):
        cases = make(np.random.default_rng(seed))
        curves = (*solve_curves(*cases), *shipped.curves(*cases))
        found.append(Family(f"singular_{name}", title, FAILS, REMEDY, axis, curves))
    return found


def solve_curves(robots_: list[Robot], motions: list[Motion]) -> list[Curve]:
    """Compute the error of every candidate for H x = c in double, relative to 50 digits of the same H and
    c.
    """
    systems = [
        (wrench_matrix(robot, motion), actuator_wrench(robot, motion)[0])
        for robot, motion in zip(robots_, motions, strict=True)
    ]
    lengths = [characteristic_length(robot) for robot in robots_]
    scaled = [moments_over(H, length) for (H, _), length in zip(systems, lengths, strict=True)]
    condition = np.linalg.cond(np.array(scaled))
    truth = [_exact(H, c) for H, c in systems]
    found = []
    for name in (*CANDIDATES, DAMPED):
        error = np.full(len(systems), np.nan)
        for i, ((H, c), x) in enumerate(zip(systems, truth, strict=True)):
            if x is None:
                continue
            with np.errstate(all="ignore"):
                got = damped_least_squares(H, c, lengths[i])[0] if name == DAMPED else CANDIDATES[name](H, c)
            if np.isfinite(got).all():
                worst = max(abs(digits.mpf(float(a)) - b) for a, b in zip(got, x, strict=True))
                error[i] = float(worst / max(abs(b) for b in x))
        found.append(Curve(name, error, condition))
    return found


def crossing_of_path_III() -> float:
    """Return the time at which Path III crosses a singular pose, to rounding (s)."""
    path = PAPER_PATHS["III"].path
    return singularity_crossings(dasgupta1998(), path.sample, path.breakpoints())[0].time


def path_III() -> tuple[list[Robot], list[Motion]]:
    """Return poses of the robot of the paper near the crossing, on the tangent of Path III before it."""
    robot, path, crossing = dasgupta1998(), PAPER_PATHS["III"].path, crossing_of_path_III()
    moving = path.sample(crossing)
    theta = rpy_from_rotation(moving.R)
    # The tangent also extends beyond the ends of the path.
    before, after = (rpy_from_rotation(path.sample(crossing + h).R) for h in (-1e-3, 1e-3))
    theta_dot = (after - before) / 2e-3
    motions = []
    for distance in distances():
        R = rotation_from_rpy(theta - distance * theta_dot)
        motions.append(replace(moving, R=R, t=moving.t - distance * moving.v))
    return [robot] * len(motions), motions


def _hexagons(rng: np.random.Generator) -> tuple[list[Robot], list[Motion]]:
    robot = similar_hexagons(rng)
    moving = random_motion(rng, robot)
    turn = [rotation_from_vector(np.array([0.0, 0.0, 0.5 * np.pi - d])) for d in distances()]
    return [robot] * len(turn), [replace(moving, R=R) for R in turn]


def _line(rng: np.random.Generator) -> tuple[list[Robot], list[Motion]]:
    moving = random_motion(rng, random_machine(rng))
    robot = meeting_one_line(rng, moving)
    axis = np.array([0.6, 0.64, 0.48])
    motions = [replace(moving, R=rotation_from_vector(d * axis) @ moving.R) for d in distances()]
    return [robot] * len(motions), motions


def _flat(rng: np.random.Generator) -> tuple[list[Robot], list[Motion]]:
    robot = flat(rng)
    moving = random_motion(rng, robot)
    R = rotation_from_vector(np.array([0.0, 0.0, 0.4]))
    aside = np.array([0.1, 0.07, 0.0])
    motions = [replace(moving, R=R, t=aside + np.array([0.0, 0.0, d])) for d in distances()]
    return [robot] * len(motions), motions


def _exact(H: Array, c: Array) -> list[mpmath.mpf] | None:
    try:
        return list(digits.lu_solve(digits.matrix(H.tolist()), digits.matrix(c.tolist())))
    except ZeroDivisionError:
        return None


# --- ways to solve H x = c, written plainly ---------------------------------------------------


def _largest(A: Array, k: int, scale: Array) -> tuple[int, int]:
    """Return row and column of the largest remaining entry."""
    i, j = np.unravel_index(np.argmax(np.abs(A[k:, k:])), (len(A) - k, len(A) - k))
    return k + int(i), k + int(j)


_PIVOTS: dict[str, Callable[[Array, int, Array], tuple[int, int]]] = {
    "no pivoting": lambda A, k, scale: (k, k),
    "partial pivoting": lambda A, k, scale: (k + int(np.argmax(np.abs(A[k:, k]))), k),
    "scaled pivoting": lambda A, k, scale: (k + int(np.argmax(np.abs(A[k:, k]) / scale[k:])), k),
    "complete pivoting": _largest,
}
"""Function that returns row and column of the pivot of an elimination step; ``scale`` is the initial largest
entry of each row.
"""


def householder(A: Array, y: Array) -> Array:
    """Solve by QR factorization with the reflections of LAPACK."""
    Q, R = np.linalg.qr(A)
    return _back(R, Q.T @ y)


def singular_values(A: Array, y: Array) -> Array:
    """Solve by the complete singular value decomposition."""
    U, sigma, V_T = np.linalg.svd(A)
    return np.asarray(V_T.T @ ((U.T @ y) / sigma))


def refined(A: Array, y: Array) -> Array:
    """Solve by partial pivoting and one step of refinement with the residual in double."""
    x = _eliminated(A, y, _PIVOTS["partial pivoting"])
    return x + _eliminated(A, y - A @ x, _PIVOTS["partial pivoting"])


def _eliminated(A: Array, y: Array, pivot: Callable[[Array, int, Array], tuple[int, int]]) -> Array:
    A, y = A.copy(), y.copy()
    n = len(y)
    order, scale = np.arange(n), np.abs(A).max(axis=1)
    for k in range(n):
        i, j = pivot(A, k, scale)
        for rows in (A, y, scale):
            rows[[k, i]] = rows[[i, k]]
        A[:, [k, j]] = A[:, [j, k]]
        order[[k, j]] = order[[j, k]]
        factor = A[k + 1 :, k] / A[k, k]
        A[k + 1 :, k:] -= np.outer(factor, A[k, k:])
        y[k + 1 :] -= factor * y[k]
    x = np.empty(n)
    x[order] = _back(A, y)
    return x


def _back(A: Array, y: Array) -> Array:
    x = np.zeros_like(y)
    for k in reversed(range(len(y))):
        x[k] = (y[k] - A[k, k + 1 :] @ x[k + 1 :]) / A[k, k]
    return x


CANDIDATES: dict[str, Callable[[Array, Array], Array]] = {
    **{name: functools.partial(_eliminated, pivot=pivot) for name, pivot in _PIVOTS.items()},
    "Householder QR": householder,
    "SVD": singular_values,
    "partial, refined": refined,
}
