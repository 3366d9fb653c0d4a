"""Pinocchio as a candidate of ``bench``: recursive Newton-Euler over the machine's tree, then a 6x6 solve.

Shares no dynamics with the other candidates. Joint angles, rates, accelerations, friction and the Jacobians
of the closed loops are prepared beforehand and not timed.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...backend.numpy_kernel import loaded
from ...io.extras import needed_for
from ...motion.motion import Motion
from ...motion.rotation import cross_matrix, quaternion_from_rotation
from ...robot.robot import Robot
from .baselines_tree import Legs, base_frames, legs_of, turned

with needed_for("the comparison with Pinocchio"):
    import pinocchio as pin

Array = NDArray[np.float64]

QUATERNION_W_LAST = [1, 2, 3, 0]

_SOLVED = 1024
"""Systems in one call of the solve, so that the call itself costs nothing a system."""


class PinocchioMachine:
    """Six chains and a platform as one tree, with the poses of ``motion``, (n,), prepared."""

    def __init__(self, robot: Robot, motion: Motion) -> None:
        """Build the tree and prepare every pose; base joints must be universal."""
        self._model, upper = model_of_legs(robot)
        platform = self._model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "platform")
        inertia = pin.Inertia(robot.M, robot.R_0, robot.I_p)
        self._model.appendBodyToJoint(platform, inertia, pin.SE3.Identity())
        self._data, self._poses = self._model.createData(), motion.shape[0]
        self._nothing = pin.Model(), pin.Model().createData(), _forces(1)
        legs = legs_of(robot, motion)
        self._states = _states(robot, motion, legs, self._model.njoints, upper)
        # F Ldot is the power of all joints; Ldot and the joints' rates are of the twist.
        arms = np.concatenate(
            [np.broadcast_to(np.eye(3), (*legs.q.shape, 3)), -cross_matrix(legs.q)], axis=-1
        )
        joints = np.linalg.inv(legs.jacobian) @ arms
        turns = np.array([np.kron(np.eye(2), R.T) for R in motion.R])
        tau = np.array([pin.rnea(self._model, self._data, *state) for state in self._states])
        every = np.concatenate([joints.reshape(self._poses, -1, 6), turns], axis=1)
        several = np.resize(np.arange(self._poses), _SOLVED)
        self._matrices = np.swapaxes(joints[:, :, 2], -1, -2)[several]
        self._right = np.einsum("nji,nj->ni", every, tau)[several, :, None]
        self._friction = robot.C_p * legs.rates[..., 2]

    def newton_euler(self, repeats: int) -> None:
        """Run ``rnea`` over all poses, ``repeats`` times."""
        rnea, model, data = pin.rnea, self._model, self._data
        for _ in range(repeats):
            for q, v, a, outside in self._states:
                rnea(model, data, q, v, a, outside)

    def empty_calls(self, repeats: int) -> None:
        """Run ``rnea`` as often over a model without joints: what a call costs before it computes."""
        rnea, (model, data, outside) = pin.rnea, self._nothing
        states = [3 * (np.zeros(0),) for _ in self._states]
        for _ in range(repeats):
            for q, v, a in states:
                rnea(model, data, q, v, a, outside)

    solves = _SOLVED
    """Systems of six equations in one repeat of ``solve``."""

    def solve(self, repeats: int) -> None:
        """Solve the poses' 6x6 systems, ``solves`` in one call of LAPACK's gesv through NumPy."""
        for _ in range(repeats):
            np.linalg.solve(self._matrices, self._right)

    def F(self) -> Array:
        """Actuator forces, N, (n, 6)."""
        F = np.linalg.solve(self._matrices, self._right)[: self._poses, :, 0]
        return np.array(F + self._friction)


def model_of_legs(robot: Robot) -> tuple[Any, list[int]]:
    """Six chains, revolute about k, revolute about y, prismatic along s, and the joints of the upper parts.

    The joint of a lower part is the one before that of its upper part.
    """
    model, here = pin.Model(), pin.SE3.Identity()
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    uppers = []
    for i, frame in enumerate(base_frames(robot)):
        first = model.addJoint(0, pin.JointModelRX(), pin.SE3(frame, robot.b[i]), f"fixed axis {i + 1}")
        lower = model.addJoint(first, pin.JointModelRY(), here, f"moving axis {i + 1}")
        upper = model.addJoint(lower, pin.JointModelPX(), here, f"actuator {i + 1}")
        model.appendBodyToJoint(lower, pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), here)
        model.appendBodyToJoint(upper, pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), here)
        uppers.append(upper)
    return model, uppers


def _states(robot: Robot, motion: Motion, legs: Legs, joints: int, upper: list[int]) -> list[tuple[Any, ...]]:
    """Every pose as ``rnea`` takes it: q, v, a and the forces from outside."""
    given = loaded(motion)
    R_T, omega, moving = np.swapaxes(motion.R, -1, -2), motion.omega, motion.omega[:, None]
    Sddot = (
        given.a[:, None] + np.cross(given.alpha[:, None], legs.q) + np.cross(moving, np.cross(moving, legs.q))
    )
    drift, _ = legs.accelerations(np.zeros_like(legs.S))
    second = np.linalg.solve(legs.jacobian, (Sddot - drift)[..., None])
    quaternions = quaternion_from_rotation(motion.R)[:, QUATERNION_W_LAST]
    q = np.hstack([legs.coordinates.reshape(len(R_T), -1), motion.t, quaternions])
    v = np.hstack([legs.rates.reshape(len(R_T), -1), turned(R_T, motion.v), turned(R_T, omega)])
    # Pinocchio's spatial acceleration differs from that of the reference point by omega x v.
    platform = [turned(R_T, given.a - np.cross(omega, motion.v)), turned(R_T, given.alpha)]
    a = np.hstack([second.reshape(len(R_T), -1), *platform])
    # Load, and friction of universal and spherical joints, in the frames of the bodies they act on.
    inward = np.swapaxes(legs.upper, -1, -2)
    f = robot.C_s[:, None] * (legs.W - moving)
    below, above = turned(inward, -robot.C_u[:, None] * legs.W), turned(inward, -f)
    moment = given.M_ext + turned(R_T, f.sum(axis=1))
    states = []
    for i, state in enumerate(zip(q, v, a, strict=True)):
        forces = _forces(joints)
        for leg, joint in enumerate(upper):
            forces[joint - 1] = pin.Force(np.zeros(3), below[i, leg])
            forces[joint] = pin.Force(np.zeros(3), above[i, leg])
        forces[joints - 1] = pin.Force(given.F_ext[i], moment[i])
        states.append((*state, forces))
    return states


def _forces(count: int) -> Any:
    forces = pin.StdVec_Force()
    for _ in range(count):
        forces.append(pin.Force.Zero())
    return forces
