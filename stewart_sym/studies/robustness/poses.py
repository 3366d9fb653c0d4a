"""Family 5: forward kinematics near a singular pose, its certificate, and the basins of Newton's method."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array, Flags
from ...kinematics.conditioning import characteristic_length, scaled_condition_number
from ...kinematics.forward_kinematics import forward_kinematics
from ...kinematics.inverse_kinematics import leg_vectors
from ...kinematics.pose_certificate import certify_pose
from ...kinematics.pose_search import newton, rates_per_twist, solve
from ...motion.rotation import orthonormal, rotation_from_vector
from ...motion.straight_line import PAPER_PATHS
from ...precision.truth import digits
from ...robot.robot import Robot
from ...robots import dasgupta1998
from .family import Curve, Family, distances, exact
from .singular import path_III

RIGHT, OTHER, LOST = 0, 1, 2
OUTCOMES = ("the pose asked for", "another pose with these lengths", "no pose found")
GRID = 81
"""Number of start poses along each side of the plot."""


@dataclass(frozen=True, eq=False)
class Basins:
    """Outcomes of start poses that are rotated about two axes, by method.

    Attributes
    ----------
    roll, yaw : ndarray, shape (n,)
        Angles of the start relative to the requested pose (rad).
    outcome : dict of str to ndarray, shape (n, n)
        Indices of ``OUTCOMES`` for each method, with rows of equal yaw.
    proven : float
        Fraction of a sample of the found poses that ``certify_pose`` proves.
    poses : int
        Number of different poses found for these lengths.
    """

    roll: Array
    yaw: Array
    outcome: dict[str, NDArray[np.int64]]
    proven: float
    poses: int

    def share(self, method: str, outcome: int) -> float:
        """Return the fraction of the starts with this outcome."""
        return float(np.mean(self.outcome[method] == outcome))


def families() -> list[Family]:
    """Compute poses near the crossing of Path III from their leg lengths."""
    robots, motions = path_III()
    robot = robots[0]
    n = len(motions)
    error, status = np.full(n, np.nan), np.zeros(n, dtype=np.int32)
    position, asked = np.full(n, np.nan), np.full(n, np.nan)
    condition = np.empty(n)
    for i, motion in enumerate(motions):
        L = leg_vectors(robot, motion.R, motion.t)[2]
        H = np.swapaxes(rates_per_twist(robot, motion.R, motion.t), -1, -2)
        condition[i] = scaled_condition_number(H, characteristic_length(robot))
        found = forward_kinematics(robot, L, (motion.R, motion.t + 1e-6), "nan")
        status[i] = found.status
        if found.status:
            continue
        error[i] = _distance(robot, _exact_pose(robot, L, found.R, found.t), (found.R, found.t))
        proof = certify_pose(robot, L, (found.R, found.t))
        if proof.proven:
            position[i], asked[i] = proof.position_bound, proof.angle_bound
    size = float(np.abs(robot.b).max())
    held = bool(np.all(~np.isfinite(position) | (error * size <= position + size * asked)))
    nearest = distances()[np.isfinite(position)].min()
    curve = Curve("forward kinematics", error, condition, status, shipped=True)
    return [
        Family(
            "forward_kinematics",
            "Forward kinematics toward the crossing of Path III",
            "forward kinematics at the meeting of two poses",
            "status 4 from a condition number of 4e6; `certify_pose` proves a pose",
            "time from the crossing, s",
            (curve,),
            growth={"proven bound of the position, m": position, "proven bound of the angle, rad": asked},
            growth_axis="proven bound",
            notes=(
                f"certificate: {int(np.isfinite(position).sum())} of {int((status == 0).sum())} proven, "
                f"down to {nearest:.1e} s; every error below its bound: {'yes' if held else 'NO'}.",
            ),
            error_axis="error over the machine's reach",
            growth_title="the certificate",
        )
    ]


def basins(grid: int = GRID, proofs: int = 40) -> Basins:
    """Rotate the start about x and z away from a pose of the robot of the paper, over the full range of
    angles.
    """
    robot = dasgupta1998()
    motion = PAPER_PATHS["I"].path.sample(0.0)
    L = leg_vectors(robot, motion.R, motion.t)[2]
    angles = np.linspace(-np.pi, np.pi, grid)
    yaw, roll = (axis.ravel() for axis in np.meshgrid(angles, angles, indexing="ij"))
    x, z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    R = rotation_from_vector(yaw[:, None] * z) @ rotation_from_vector(roll[:, None] * x) @ motion.R
    t = np.broadcast_to(motion.t, (len(R), 3))
    lengths = np.broadcast_to(L, (len(R), 6))
    outcome: dict[str, NDArray[np.int64]] = {}
    found_R, found_t, _, _, converged = newton(robot, lengths, R, t)
    plain_R, plain_t, plain = _plain_newton(robot, lengths, R, t)
    for name, at_R, at_t, good in (
        ("Newton as it is", plain_R, plain_t, plain),
        ("damped, as shipped", found_R, found_t, converged),
    ):
        near = (
            np.linalg.norm(at_t - motion.t, axis=-1) + np.linalg.norm(at_R - motion.R, axis=(-2, -1)) < 1e-6
        )
        ends = np.where(good, np.where(near, RIGHT, OTHER), LOST)
        outcome[name] = ends.reshape(grid, grid)
    sample = np.flatnonzero(converged)[:: max(1, int(converged.sum()) // proofs)]
    proven = certify_pose(robot, L, (found_R[sample], found_t[sample])).proven
    modes = np.unique(
        np.round(np.concatenate([found_t[converged], found_R[converged][:, 0]], axis=-1), 5), axis=0
    )
    return Basins(angles, angles, outcome, float(np.mean(proven)), len(modes))


def _plain_newton(robot: Robot, L: Array, R: Array, t: Array) -> tuple[Array, Array, Flags]:
    """Apply thirty full, undamped Newton steps."""
    R, t = R.copy(), t.copy()
    with np.errstate(all="ignore"):
        for _ in range(30):
            J = rates_per_twist(robot, R, t)
            good = np.asarray(np.isfinite(J).all(axis=(-2, -1)))
            miss = np.where(good[:, None], L - leg_vectors(robot, R, t)[2], 0.0)
            step, _ = solve(np.where(good[:, None, None], J, np.eye(6)), miss)
            R = orthonormal(rotation_from_vector(step[:, 3:]) @ R)
            t = t + step[:, :3]
        miss = np.abs(L - leg_vectors(robot, R, t)[2]).max(axis=-1)
    return R, t, np.asarray(miss < 1e-12)


def _exact_pose(robot: Robot, L: Array, R: Array, t: Array) -> tuple[NDArray[Any], NDArray[Any]]:
    """Compute the pose with exactly these lengths near a found one in 50-digit arithmetic."""
    turn, place, p, b, lengths = map(exact, (R, t, robot.p, robot.b, L))
    unit = exact(np.eye(3))
    for _ in range(4):
        turn = turn @ (3 * unit - turn.T @ turn) / 2
    for _ in range(60):
        q = p @ turn.T
        S = q + place - b
        J, miss = np.hstack([S, np.cross(q, S)]), (lengths**2 - (S * S).sum(axis=-1)) / 2
        step = np.array(list(digits.lu_solve(digits.matrix(J.tolist()), digits.matrix(miss.tolist()))))
        place = place + step[:3]
        turn = np.array(digits.expm(digits.matrix(np.cross(step[3:], unit).T.tolist())).tolist()) @ turn
        if np.abs(step).max() < digits.mpf(10) ** -35:
            break
    return turn, place


def _distance(robot: Robot, truth: tuple[NDArray[Any], NDArray[Any]], found: tuple[Array, Array]) -> float:
    """Return the largest component of the differences of position, relative to the reach, and of rotation."""
    turn, place = (np.abs(one - exact(other)).max() for one, other in zip(truth, found, strict=True))
    return float(max(place / float(np.abs(robot.b).max()), turn))
