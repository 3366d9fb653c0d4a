"""Machines with offset joints in Pinocchio: chains of joints with placements, closed by forces.

Takes nothing from stewart_sym but the numbers of a Robot and of one Motion. Joint coordinates come from
Newton's steps with Pinocchio's Jacobians, begun at the leg without offsets: no closed form is used.
"""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from pinocchio_model import WORLD, UniversalChain, _platform_wrench, frame_along

from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Answer:
    """What Pinocchio says of one pose: forces (6, 3), all else (6,).

    F_s: on the leg by the platform; F_u: on the leg at its fixed axis; M_u: at the moving axis, along k x y.
    """

    F: Array
    F_s: Array
    F_u: Array
    F_p: Array
    M_u: Array
    L: Array
    L_dot: Array
    L_ddot: Array
    spin: Array
    spin_dot: Array
    spin_ddot: Array


def pinocchio_offsets(robot: Robot, motion: Motion, lead: Array | None = None) -> Answer:
    """Forces of one pose; lead: m per turn of screws whose nuts turn the upper parts, (6,)."""
    legs = [OffsetChain(robot, motion, i) for i in range(6)]
    n = len(legs[0].tip_jacobian)
    share = np.zeros(6) if lead is None else lead / (2 * np.pi)
    # Unknown: the wrench on each leg's end, n components, and the actuator's force F.
    rows, right = np.zeros((6 * (n + 1), 6 * (n + 1))), np.zeros(6 * (n + 1))
    balance = slice(6 * n, None)
    wanted = _platform_wrench(robot, motion)
    turn = np.zeros((6, 6))
    turn[:3, :3] = turn[3:, 3:] = motion.R
    right[balance] = turn @ wanted
    for i, leg in enumerate(legs):
        own, free = slice(n * i, n * i + n), slice(n * i, n * i + n)
        rows[free, own] = leg.tip_jacobian.T
        rows[free, 6 * n + i] = leg.actuated(share[i])
        right[free] = leg.torques(np.zeros(6)) + leg.sliding_friction()
        rows[balance, own] = leg.on_platform
        right[balance] += np.concatenate([np.zeros(3), leg.f])
    found = np.linalg.solve(rows, right)
    wrenches, F = found[: 6 * n].reshape(6, n), found[6 * n :]
    for i, leg in enumerate(legs):
        tau = leg.torques(wrenches[i]) - leg.actuated(share[i]) * F[i]
        tau += leg.sliding_friction()
        np.testing.assert_allclose(tau, 0, atol=1e-8 * (np.abs(F).max() + 1))
    return Answer(
        F=F,
        F_s=wrenches[:, :3],
        F_u=np.array([leg.base_reaction()[0] for leg in legs]),
        F_p=np.array([leg.prismatic_reaction()[0] for leg in legs]),
        M_u=np.array([leg.base_reaction()[1] for leg in legs]),
        **{name: np.array([getattr(leg, at)[2] for leg in legs]) for name, at in _LENGTHS.items()},
        **{
            name: np.array([getattr(leg, at)[3] if n == 6 else 0.0 for leg in legs])
            for name, at in _SPINS.items()
        },
    )


_LENGTHS = {"L": "q", "L_dot": "v", "L_ddot": "a"}
_SPINS = {"spin": "q", "spin_dot": "v", "spin_ddot": "a"}


class OffsetChain(UniversalChain):
    """One leg: revolute about k, revolute about y, prismatic along s; three more revolutes of U-C-U legs."""

    def _base_joints(self) -> int:
        self.o, self.frame = self.robot.offsets, frame_along(self.robot.k[self.i])
        self.spins = self.o.platform_joint == "universal"
        at = pin.SE3(self.frame, self.robot.b[self.i])
        first = self.model.addJoint(0, pin.JointModelRX(), at, "fixed axis")
        # The moving axis is y of the first joint's frame, o = y x k its -z.
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -self.o.cross[self.i]]))
        return int(self.model.addJoint(first, pin.JointModelRY(), at, "moving axis"))

    def _upper_joints(self) -> tuple[int, int]:
        model, o, i, none = self.model, self.o, self.i, pin.SE3.Identity()
        at = pin.SE3(np.eye(3), np.array([0.0, o.along[i], o.across[i]]))
        upper = model.addJoint(self.lower, pin.JointModelPX(), at, "sliding")
        if not self.spins:
            return upper, upper
        # The last joint's frame has its x axis along the second axis of the platform's joint.
        self.on = self.motion.R @ frame_along(o.platform_axis[i])
        upper = model.addJoint(upper, pin.JointModelRX(), none, "spin")
        wrist = model.addJoint(upper, pin.JointModelRY(), none, "first axis of the platform joint")
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -o.wrist[i]]))
        return upper, model.addJoint(wrist, pin.JointModelRX(), at, "second axis")

    def _append_lower(self, body: pin.Inertia) -> None:
        super()._append_lower(body)
        i, o = self.i, self.o
        # Of the cross the axes o, y, k are -z, y, x of the first joint; only the inertia about k acts.
        center = np.array([o.cross_center[i][2], o.cross_center[i][1], -o.cross_center[i][0]])
        about = np.diag([o.cross_inertia[i], 0.3 * o.cross_inertia[i], 0.9 * o.cross_inertia[i]])
        if o.cross_mass[i] > 0:
            self.model.appendBodyToJoint(1, pin.Inertia(o.cross_mass[i], center, about), pin.SE3.Identity())

    def _configuration(self, S: Array) -> Array:
        return self._solved(self._guess(S), S + self.robot.b[self.i])

    @property
    def on_platform(self) -> Array:
        """Wrench on the platform about its origin, of what each component at the end of the leg is."""
        columns = np.eye(6)
        columns[3:, :3] = pin.skew(self.lever)
        return columns[:, : len(self.tip_jacobian)]

    def _guess(self, S: Array) -> Array:
        q = super()._configuration(S)
        if not self.spins:
            return q
        s, k = S / np.linalg.norm(S), self.on[:, 0]
        y = np.cross(k, s) / np.linalg.norm(np.cross(k, s))
        q = np.concatenate([q, np.zeros(3)])
        pin.forwardKinematics(self.model, self.data, q)
        T = self.data.oMi[3].rotation
        q[3] = np.arctan2(T[:, 2] @ y, T[:, 1] @ y)
        q[4] = np.arctan2(-np.linalg.norm(np.cross(k, s)), k @ s)
        pin.forwardKinematics(self.model, self.data, q)
        rest = self.data.oMi[self.last].rotation.T @ self.on
        q[5] = np.arctan2(rest[2, 1], rest[1, 1])
        return q

    def _solved(self, q: Array, point: Array) -> Array:
        for _ in range(60):
            J = self._tip_jacobian(q)
            at = self.data.oMi[self.last]
            miss = point - at.translation
            if self.spins:
                miss = np.concatenate([miss, pin.log3(self.on @ at.rotation.T)])
            q = q + np.linalg.solve(J, miss)
        scale = np.abs(point).max() + np.abs(self.robot.b[self.i]).max()
        assert np.abs(miss).max() < 1e-13 * max(1.0, scale), np.abs(miss).max()
        return q

    def _tip_jacobian(self, q: Array) -> Array:
        velocity = super()._tip_jacobian(q)
        return pin.getJointJacobian(self.model, self.data, self.last, WORLD) if self.spins else velocity

    def actuated(self, share: float) -> Array:
        """Generalised forces of a unit force of the actuator; share: lead over 2 pi."""
        e = np.zeros(self.model.nv)
        e[2] = 1.0
        if self.spins:
            e[3] = share
        return e

    def sliding_friction(self) -> Array:
        """Generalised force against the friction of sliding."""
        e = np.zeros(self.model.nv)
        e[2] = self.robot.C_p[self.i] * self.v[2]
        return e

    def _constraint_moment(self) -> float:
        # At the moving axis, along the normal k x y to both axes.
        rotation = self.data.oMi[2].rotation
        return float(rotation @ self.data.f[2].angular @ np.cross(self.robot.k[self.i], rotation[:, 1]))
