"""Pinocchio as a contestant of ``bench``: recursive Newton-Euler over the machine's tree, then a 6x6 solve.

Takes the numbers of a Robot and of a Motion and shares no equation with the other contestants. Joint angles,
rates, accelerations, friction and the Jacobians of the closed loops are prepared beforehand and not timed:
what is left is what Pinocchio is good at.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.extras import needed_for
from ...motion.motion import Motion
from ...robot.robot import Robot

with needed_for("the comparison with Pinocchio"):
    import pinocchio as pin

Array = NDArray[np.float64]

_SOLVED = 1024
"""Systems in one call of the solve, so that the call itself costs nothing a system."""


@dataclass(frozen=True, eq=False)
class _Legs:
    """Joint numbers of the tree: six of each, and the platform's."""

    lower: tuple[int, ...]
    upper: tuple[int, ...]
    platform: int


@dataclass(frozen=True, eq=False)
class _Pose:
    """One pose as Pinocchio takes it, and how its joint forces come together at the actuators.

    state: q, v, a and the forces from outside, for ``rnea``. project (6, nv), Ldot_of_twist (6, 6) and Ldot
    (6,): Ldot_of_twist^T F = project tau, but for the friction C_p Ldot of the actuators.
    """

    state: tuple[Array, Array, Array, Any]
    project: Array
    Ldot_of_twist: Array
    Ldot: Array


class PinocchioMachine:
    """Six chains and a platform as one tree, with the poses of ``motion``, (n,), prepared."""

    def __init__(self, robot: Robot, motion: Motion) -> None:
        """Build the tree and prepare every pose; base joints must be universal."""
        self._robot = robot
        self._model, self._legs = _tree(robot)
        self._data = self._model.createData()
        self._poses = [self._prepared(motion[i]) for i in range(motion.shape[0])]
        self._nothing = pin.Model(), pin.Model().createData(), _forces(1)
        several = np.resize(np.arange(len(self._poses)), _SOLVED)
        self._matrices = np.array([pose.Ldot_of_twist.T for pose in self._poses])[several]
        self._right = np.array([self._right_side(pose) for pose in self._poses])[several]

    def newton_euler(self, repeats: int) -> None:
        """Run ``rnea`` over all poses, ``repeats`` times."""
        rnea, model, data = pin.rnea, self._model, self._data
        states = [pose.state for pose in self._poses]
        for _ in range(repeats):
            for q, v, a, outside in states:
                rnea(model, data, q, v, a, outside)

    def empty_calls(self, repeats: int) -> None:
        """Run ``rnea`` as often over a model without joints: what a call costs before it computes."""
        rnea, (model, data, outside) = pin.rnea, self._nothing
        states = [3 * (np.zeros(0),) for _ in self._poses]
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
        F = np.linalg.solve(self._matrices, self._right)[: len(self._poses), :, 0]
        return np.array(F + self._robot.C_p * np.array([pose.Ldot for pose in self._poses]))

    def _right_side(self, pose: _Pose) -> Array:
        tau = pin.rnea(self._model, self._data, *pose.state)
        return np.array(pose.project @ tau)[:, None]

    def _prepared(self, motion: Motion) -> _Pose:
        assert motion.a is not None
        assert motion.alpha is not None
        robot, model, data, legs = self._robot, self._model, self._data, self._legs
        R, omega = motion.R, motion.omega
        q_i = robot.p @ R.T
        S = motion.t + q_i - robot.b
        Sdot = motion.v + np.cross(omega, q_i)
        Sddot = motion.a + np.cross(motion.alpha, q_i) + np.cross(omega, np.cross(omega, q_i))

        q = np.concatenate([*map(_angles, robot.k, S), motion.t, pin.Quaternion(R).coeffs()])
        pin.computeJointJacobians(model, data, q)
        world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        tips = [pin.getJointJacobian(model, data, upper, world)[:3] for upper in legs.upper]
        inverses = [np.linalg.inv(tip[:, 3 * i : 3 * i + 3]) for i, tip in enumerate(tips)]

        rates = [J @ rate for J, rate in zip(inverses, Sdot, strict=True)]
        v = np.concatenate([*rates, R.T @ motion.v, R.T @ omega])
        pin.forwardKinematics(model, data, q, v, np.zeros(model.nv))
        drift = [pin.getClassicalAcceleration(model, data, upper, world).linear for upper in legs.upper]
        W = [np.array(pin.getVelocity(model, data, upper, world).angular) for upper in legs.upper]
        second = [J @ (e - d) for J, e, d in zip(inverses, Sddot, drift, strict=True)]
        # Pinocchio's spatial acceleration differs from that of the reference point by omega x v.
        platform = [R.T @ (motion.a - np.cross(omega, motion.v)), R.T @ motion.alpha]
        a = np.concatenate([*second, *platform])

        to_joints = [
            J @ np.hstack([np.eye(3), -pin.skew(lever)]) for J, lever in zip(inverses, q_i, strict=True)
        ]
        to_platform = np.kron(np.eye(2), R.T)
        project = np.vstack([*to_joints, to_platform]).T
        Ldot_of_twist = np.array([joints[2] for joints in to_joints])
        Ldot = np.array([rate[2] for rate in rates])
        return _Pose((q, v, a, self._outside(motion, np.array(W))), project, Ldot_of_twist, Ldot)

    def _outside(self, motion: Motion, W: Array) -> Any:
        """Load, and friction of universal and spherical joints, in the frames of the bodies they act on."""
        robot, legs, placements = self._robot, self._legs, self._data.oMi
        forces = _forces(self._model.njoints)
        f = robot.C_s[:, None] * (W - motion.omega)
        for i, (lower, upper) in enumerate(zip(legs.lower, legs.upper, strict=True)):
            forces[lower] = pin.Force(np.zeros(3), placements[lower].rotation.T @ (-robot.C_u[i] * W[i]))
            forces[upper] = pin.Force(np.zeros(3), placements[upper].rotation.T @ -f[i])
        none = np.zeros(3)
        F_ext = none if motion.F_ext is None else motion.F_ext
        M_ext = none if motion.M_ext is None else motion.M_ext
        forces[legs.platform] = pin.Force(F_ext, M_ext + motion.R.T @ f.sum(axis=0))
        return forces


def _forces(count: int) -> Any:
    forces = pin.StdVec_Force()
    for _ in range(count):
        forces.append(pin.Force.Zero())
    return forces


def _tree(robot: Robot) -> tuple[Any, _Legs]:
    """Six chains, revolute about k, revolute about y, prismatic along s; and the platform as a free body."""
    model = pin.Model()
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    here = pin.SE3.Identity()
    lower, upper = [], []
    for i in range(6):
        at = pin.SE3(_frame(robot.k[i]), robot.b[i])
        first = model.addJoint(0, pin.JointModelRX(), at, f"fixed axis {i + 1}")
        lower.append(model.addJoint(first, pin.JointModelRY(), here, f"moving axis {i + 1}"))
        upper.append(model.addJoint(lower[i], pin.JointModelPX(), here, f"actuator {i + 1}"))
        model.appendBodyToJoint(lower[i], pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), here)
        model.appendBodyToJoint(upper[i], pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), here)
    platform = model.addJoint(0, pin.JointModelFreeFlyer(), here, "platform")
    model.appendBodyToJoint(platform, pin.Inertia(robot.M, robot.R_0, robot.I_p), here)
    return model, _Legs(tuple(lower), tuple(upper), platform)


def _frame(k: Array) -> Array:
    """A frame with its x axis along k."""
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k))])
    across /= np.linalg.norm(across)
    return np.column_stack([k, across, np.cross(k, across)])


def _angles(k: Array, S: Array) -> Array:
    """Joint coordinates of a leg: s = frame Rx(q1) Ry(q2) e_x, then its length."""
    L = np.linalg.norm(S)
    along, second, third = _frame(k).T @ S / L
    return np.array([np.arctan2(second, -third), np.arccos(along), L])
