"""Machines with offset joints in Pinocchio: chains of joints with placements, closed by forces.

Takes nothing from stewart_sym but the numbers of a Robot and of one Motion. Joint coordinates come from
Newton's steps with Pinocchio's Jacobians, begun at the leg without offsets: no closed form is used.
"""

from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray
from pinocchio_model import _accelerations, _platform_wrench

from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
WORLD = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
SPRUNG = "spin"


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
    n = legs[0].tip.shape[0]
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
        rows[free, own] = leg.tip.T
        rows[free, 6 * n + i] = leg.actuated(share[i])
        right[free] = leg.torques(np.zeros(6)) + leg.sliding_friction()
        rows[balance, own] = leg.on_platform
        right[balance] += np.concatenate([np.zeros(3), leg.f])
    found = np.linalg.solve(rows, right)
    wrenches, F = found[: 6 * n].reshape(6, n), found[6 * n :]
    for i, leg in enumerate(legs):
        tau = leg.torques(leg.as_wrench(wrenches[i])) - leg.actuated(share[i]) * F[i]
        tau += leg.sliding_friction()
        np.testing.assert_allclose(tau, 0, atol=1e-8 * (np.abs(F).max() + 1))
    return Answer(
        F=F,
        F_s=wrenches[:, :3],
        F_u=np.array([leg.reaction(1)[0] for leg in legs]),
        F_p=np.array([leg.sliding() for leg in legs]),
        M_u=np.array([leg.constraint() for leg in legs]),
        **{name: np.array([getattr(leg, at)[2] for leg in legs]) for name, at in _LENGTHS.items()},
        **{
            name: np.array([getattr(leg, at)[3] if n == 6 else 0.0 for leg in legs])
            for name, at in _SPINS.items()
        },
    )


_LENGTHS = {"L": "q", "L_dot": "v", "L_ddot": "a"}
_SPINS = {"spin": "q", "spin_dot": "v", "spin_ddot": "a"}


class OffsetChain:
    """One leg: revolute about k, revolute about y, prismatic along s; three more revolutes of U-C-U legs."""

    def __init__(self, robot: Robot, motion: Motion, i: int) -> None:
        self.robot, self.motion, self.i, self.o = robot, motion, i, robot.offsets
        k = robot.k[i]
        # A frame with its x axis along k; the moving axis is y of the first joint's frame, o = y x k its -z.
        across = np.cross(k, np.eye(3)[np.argmin(np.abs(k))])
        across /= np.linalg.norm(across)
        self.frame = np.column_stack([k, across, np.cross(k, across)])
        model = self.model = pin.Model()
        model.gravity = pin.Motion(robot.g, np.zeros(3))
        self.spins = self.o.platform_joint == "universal"
        self._joints()
        self._bodies()
        self.data = model.createData()
        self._place()

    def _joints(self) -> None:
        model, o, i = self.model, self.o, self.i
        at = pin.SE3(self.frame, self.robot.b[i])
        first = model.addJoint(0, pin.JointModelRX(), at, "fixed axis")
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -o.cross[i]]))
        second = model.addJoint(first, pin.JointModelRY(), at, "moving axis")
        at = pin.SE3(np.eye(3), np.array([0.0, o.along[i], o.across[i]]))
        self.last = self.upper = model.addJoint(second, pin.JointModelPX(), at, "sliding")
        if not self.spins:
            return
        none = pin.SE3.Identity()
        self.upper = model.addJoint(self.upper, pin.JointModelRX(), none, "spin")
        wrist = model.addJoint(self.upper, pin.JointModelRY(), none, "first axis of the platform joint")
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -o.wrist[i]]))
        self.last = model.addJoint(wrist, pin.JointModelRX(), at, "second axis")

    def _bodies(self) -> None:
        robot, i, o, none = self.robot, self.i, self.o, pin.SE3.Identity()
        # Of the cross the axes o, y, k are -z, y, x of the first joint; only the inertia about k acts.
        center = np.array([o.cross_center[i][2], o.cross_center[i][1], -o.cross_center[i][0]])
        about = np.diag([o.cross_inertia[i], 0.3 * o.cross_inertia[i], 0.9 * o.cross_inertia[i]])
        if o.cross_mass[i] > 0:
            self.model.appendBodyToJoint(1, pin.Inertia(o.cross_mass[i], center, about), none)
        self.model.appendBodyToJoint(2, pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), none)
        self.model.appendBodyToJoint(
            self.upper, pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), none
        )

    def _place(self) -> None:
        robot, motion, i = self.robot, self.motion, self.i
        R, omega, (a, alpha) = motion.R, motion.omega, _accelerations(motion)
        self.lever = R @ robot.p[i]
        self.point = motion.t + self.lever
        speed = motion.v + np.cross(omega, self.lever)
        acceleration = a + np.cross(alpha, self.lever) + np.cross(omega, np.cross(omega, self.lever))
        self._platform_axes()
        self.q = self._solved(self._guess())
        rates, seconds = speed, acceleration
        if self.spins:
            rates, seconds = np.concatenate([speed, omega]), np.concatenate([acceleration, alpha])
        self.tip = self._tip_jacobian()
        self.v = np.linalg.solve(self.tip, rates)
        model, data = self.model, self.data
        pin.forwardKinematics(model, data, self.q, self.v, np.zeros(model.nv))
        drift = pin.getClassicalAcceleration(model, data, self.last, WORLD)
        drift = np.concatenate([drift.linear, drift.angular]) if self.spins else drift.linear
        self.a = np.linalg.solve(self.tip, seconds - drift)
        pin.forwardKinematics(model, data, self.q, self.v, self.a)
        W = pin.getVelocity(model, data, 2, WORLD).angular
        self.base_friction = -robot.C_u[i] * W
        self.f = robot.C_s[i] * (pin.getVelocity(model, data, self.upper, WORLD).angular - omega)
        self.on_platform = np.zeros((6, len(self.tip)))
        self.on_platform[:3, :3], self.on_platform[3:, :3] = np.eye(3), pin.skew(self.lever)
        if self.spins:
            self.on_platform[3:, 3:] = np.eye(3)

    def _platform_axes(self) -> None:
        """The last joint's frame in the platform's: its x axis along the second axis of the joint."""
        if not self.spins:
            return
        x = self.o.platform_axis[self.i]
        across = np.cross(x, np.eye(3)[np.argmin(np.abs(x))])
        across /= np.linalg.norm(across)
        self.on = self.motion.R @ np.column_stack([x, across, np.cross(x, across)])

    def _guess(self) -> Array:
        S = self.point - self.robot.b[self.i]
        L = float(np.linalg.norm(S))
        along, second, third = self.frame.T @ S / L
        q = np.array([np.arctan2(second, -third), np.arccos(along), L])
        if not self.spins:
            return q
        s, k = S / L, self.on[:, 0]
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

    def _solved(self, q: Array) -> Array:
        for _ in range(60):
            J = self._tip_jacobian(q)
            at = self.data.oMi[self.last]
            miss = self.point - at.translation
            if self.spins:
                miss = np.concatenate([miss, pin.log3(self.on @ at.rotation.T)])
            q = q + np.linalg.solve(J, miss)
        scale = np.abs(self.point).max() + np.abs(self.robot.b[self.i]).max()
        assert np.abs(miss).max() < 1e-13 * max(1.0, scale), np.abs(miss).max()
        return q

    def _tip_jacobian(self, q: Array | None = None) -> Array:
        pin.computeJointJacobians(self.model, self.data, self.q if q is None else q)
        J = pin.getJointJacobian(self.model, self.data, self.last, WORLD)
        return J if self.spins else J[:3]

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

    def as_wrench(self, wrench: Array) -> Array:
        """A wrench at the end of the leg, (6,)."""
        return wrench if self.spins else np.concatenate([wrench, np.zeros(3)])

    def torques(self, wrench: Array) -> Array:
        """Torques of the joints when the end feels a wrench, base axes; friction at both ends is on."""
        oMi = self.data.oMi
        on = [pin.Force.Zero() for _ in range(self.model.njoints)]

        def add(joint: int, force: Array, moment: Array) -> None:
            back = oMi[joint].rotation.T
            on[joint] = on[joint] + pin.Force(back @ force, back @ moment)

        add(2, np.zeros(3), self.base_friction)
        add(self.upper, np.zeros(3), -self.f)
        add(self.last, wrench[:3], wrench[3:])
        return np.array(pin.rnea(self.model, self.data, self.q, self.v, self.a, on))

    def reaction(self, joint: int) -> tuple[Array, Array]:
        """Force and moment that a joint's child feels at its origin, base axes, after ``torques``."""
        back, force = self.data.oMi[joint].rotation, self.data.f[joint]
        return back @ force.linear, back @ force.angular

    def constraint(self) -> float:
        """Moment at the moving axis along the normal k x y to both axes."""
        normal = np.cross(self.robot.k[self.i], self.data.oMi[2].rotation[:, 1])
        return float(self.reaction(2)[1] @ normal)

    def sliding(self) -> Array:
        """F_p, without what friction takes."""
        friction = -self.robot.C_p[self.i] * self.v[2] * self.data.oMi[3].rotation[:, 0]
        return self.reaction(3)[0] - friction
