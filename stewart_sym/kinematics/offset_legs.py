"""Kinematics of legs with offset joints: motions of the joints, lengths, and their derivatives."""

from __future__ import annotations

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK, STATUS_TEXT
from ..robot import offset_chains as chain
from ..robot.offset_chains import SLIDING, JointMotion, joint_motion
from ..robot.robot import Robot


def checked_motion(robot: Robot, motion: Motion) -> JointMotion:
    """Compute the joint motion; raise ValueError for the first leg without a solution."""
    with np.errstate(all="ignore"):
        moving = joint_motion(robot, motion)
        codes = chain.codes_of(robot, motion, moving.at)
    if (codes != OK).any():
        *pose, leg = (int(i) for i in np.argwhere(codes != OK)[0])
        where = f"motion[{', '.join(map(str, pose))}]" if pose else "motion"
        raise ValueError(f"{where}: leg {leg + 1}: {STATUS_TEXT[int(codes[(*pose, leg)])]}")
    return moving


def rate_of_H(robot: Robot, motion: Motion) -> Array:
    """Compute the time derivative of H along a motion, shape (..., 6, 6). Raises as ``checked_motion``."""
    G = checked_motion(robot, motion).G
    V = np.concatenate([motion.v, motion.omega], axis=-1)[..., None, :]
    size = np.abs(V).max(axis=-1, keepdims=True)
    size = np.where(size > 0.0, size, 1.0)
    W = size * np.eye(6)
    # The joint accelerations at a constant twist V are a quadratic form c(V) = B(V, V), and the rate of G W
    # is B(V, W). B(V, W) + B(W, V) follows from two values of c. B(V, W) - B(W, V) follows from the
    # commutator of the two rotations.
    both = 0.5 * (_at_twist(robot, motion, V + W) - _at_twist(robot, motion, V - W))
    turn = np.concatenate([np.zeros_like(W[..., 3:]), np.cross(W[..., 3:], V[..., 3:])], axis=-1)
    both += np.einsum("...ijk,...mk->...mij", G, turn)
    return chain.columns_of_H(robot, np.moveaxis(0.5 * both / size[..., None], -3, -1))


def _at_twist(robot: Robot, motion: Motion, twist: Array) -> Array:
    """Return the joint accelerations for each constant twist of the poses, twists of shape (..., m, 6)."""
    v, omega = twist[..., :3], twist[..., 3:]
    R, none = np.broadcast_to(motion.R[..., None, :, :], (*v.shape, 3)), np.zeros_like(v)
    t = np.broadcast_to(motion.t[..., None, :], v.shape)
    with np.errstate(all="ignore"):
        found = joint_motion(robot, Motion._unchecked(R, t, omega, v, none, none)).accelerations
    assert found is not None
    return found


def actuated_lengths(robot: Robot, R: Array, t: Array, screws: bool = False) -> tuple[Array, Array, Array]:
    """Return q, (..., 6, 3), the lengths (m), (..., 6), and their derivative by the twist, (..., 6, 6).

    With ``screws``, the lengths are motor angles divided by N, which include the spin of the upper leg parts,
    and the derivative is H^T. NaN if a leg has no solution.
    """
    none = np.zeros_like(t)
    with np.errstate(all="ignore"):
        moving = joint_motion(robot, Motion._unchecked(R, t, none, none))
        q, L = moving.at.q, moving.at.L[..., 0]
        if not screws:
            return q, L, moving.G[..., SLIDING, :]
        turned = L + chain.lead_share(robot) * moving.at.spin[..., 0]
        return q, turned, np.swapaxes(chain.columns_of_H(robot, moving.G), -1, -2)
