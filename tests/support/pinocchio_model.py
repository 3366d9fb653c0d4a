"""The machine in Pinocchio: six serial chains and a free body, joined by forces. An independent check.

Takes nothing from stewart_sym but the numbers of a Robot and of one Motion. Joint angles, rates and
accelerations come from Pinocchio's own Jacobians, with offset joints by Newton's steps begun at the leg
without offsets; forces from its recursive Newton-Euler over each chain, the torques of the passive joints
being zero, together with the platform's six equations.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
WORLD = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED


@dataclass(frozen=True)
class Answer:
    """What Pinocchio says of one pose: F, M_u (6,); F_s, F_u, F_p, M_p (base point), (6, 3), base frame.

    F_s: on the leg by the platform; F_u: on the leg at its fixed axis; M_u: along the normal to both axes,
    with offsets at the moving one. sliding, spin: position, rate and acceleration of sliding, and of the
    upper parts' turn where they do turn, (6, 3).
    """

    F: Array
    F_s: Array
    F_u: Array
    F_p: Array
    M_p: Array
    M_u: Array
    sliding: Array
    spin: Array


def pinocchio_inverse_dynamics(robot: Robot, motion: Motion) -> Answer:
    """Actuator forces and joint reactions of one pose (leading shape ())."""
    chain = _chain_of(robot)
    legs = [chain(robot, motion, i) for i in range(6)]
    n = len(legs[0].tip_jacobian)
    # Unknown: the force or wrench on each leg's end, n components, and the actuator's force F.
    rows, right = np.zeros((6 * (n + 1), 6 * (n + 1))), np.zeros(6 * (n + 1))
    balance = slice(6 * n, None)
    turn = np.zeros((6, 6))
    turn[:3, :3] = turn[3:, 3:] = motion.R
    right[balance] = turn @ _platform_wrench(robot, motion)
    for i, leg in enumerate(legs):
        own = slice(n * i, n * i + n)
        rows[own, own] = leg.tip_jacobian.T[leg.free]
        rows[own, 6 * n + i] = leg.actuated()[leg.free]
        right[own] = (leg.torques(np.zeros(n)) + leg.sliding_friction())[leg.free]
        rows[balance, own] = leg.on_platform
        right[balance] += np.concatenate([np.zeros(3), leg.f])
    found = np.linalg.solve(rows, right)
    wrenches, F = found[: 6 * n].reshape(6, n), found[6 * n :]
    for i, leg in enumerate(legs):
        left = leg.torques(wrenches[i]) - leg.actuated() * F[i] + leg.sliding_friction()
        np.testing.assert_allclose(left, 0, atol=1e-8 * (np.abs(F).max() + 1))
    F_u, M_u = zip(*(leg.base_reaction() for leg in legs), strict=True)
    F_p, M_p = zip(*(leg.prismatic_reaction() for leg in legs), strict=True)
    return Answer(
        F=F,
        F_s=wrenches[:, :3],
        F_u=np.array(F_u),
        F_p=np.array(F_p),
        M_p=np.array(M_p),
        M_u=np.array(M_u),
        sliding=np.array([leg.moved(leg.lower + 1) for leg in legs]),
        spin=np.array([leg.moved(leg.upper) for leg in legs]),
    )


def _platform_wrench(robot: Robot, motion: Motion) -> Array:
    """[force; moment] that the legs must take off the platform, platform frame, without joint friction."""
    model = pin.Model()
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    joint = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "platform")
    model.appendBodyToJoint(joint, pin.Inertia(robot.M, robot.R_0, robot.I_p), pin.SE3.Identity())
    R, v, omega = motion.R, motion.v, motion.omega
    a, alpha = _accelerations(motion)
    q = np.concatenate([motion.t, pin.Quaternion(R).coeffs()])
    rates = np.concatenate([R.T @ v, R.T @ omega])
    # Pinocchio's spatial acceleration differs from that of the reference point by omega x v.
    accelerations = np.concatenate([R.T @ (a - np.cross(omega, v)), R.T @ alpha])
    needed = pin.rnea(model, model.createData(), q, rates, accelerations)
    load = np.zeros(6)
    if motion.F_ext is not None:
        load[:3] = motion.F_ext
    if motion.M_ext is not None:
        load[3:] = motion.M_ext
    return np.asarray(load - needed)


def _accelerations(motion: Motion) -> tuple[Array, Array]:
    assert motion.a is not None
    assert motion.alpha is not None
    return motion.a, motion.alpha


class _Chain(ABC):
    """One leg: joints at the base, then the prismatic joint; the upper part's frame sits at the tip."""

    free = slice(None)
    """Coordinates that are independent and move the tip."""

    def __init__(self, robot: Robot, motion: Motion, i: int) -> None:
        self.robot, self.motion, self.i = robot, motion, i
        model = self.model = pin.Model()
        model.gravity = pin.Motion(robot.g, np.zeros(3))
        self.lower = self._base_joints()
        self.upper, self.last = self._upper_joints()
        self._append_lower(pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]))
        upper = pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i])
        model.appendBodyToJoint(self.upper, upper, pin.SE3.Identity())
        data = self.data = model.createData()

        self.lever = motion.R @ robot.p[i]
        S = motion.t + self.lever - robot.b[i]
        omega = motion.omega
        a, alpha = _accelerations(motion)
        Sdot = motion.v + np.cross(omega, self.lever)
        Sddot = a + np.cross(alpha, self.lever) + np.cross(omega, np.cross(omega, self.lever))
        self.q = self._configuration(S)
        self.tip_jacobian = self._tip_jacobian(self.q)
        np.testing.assert_allclose(data.oMi[self.last].translation, robot.b[i] + S, rtol=0, atol=1e-12)
        size = len(self.tip_jacobian)
        self.v = self._joint_rates(np.concatenate([Sdot, omega])[:size])
        pin.forwardKinematics(model, data, self.q, self.v, np.zeros(model.nv))
        drift = pin.getClassicalAcceleration(model, data, self.last, WORLD).vector
        self.a = self._joint_rates((np.concatenate([Sddot, alpha]) - drift)[:size])
        W = pin.getVelocity(model, data, self.lower, WORLD).angular
        self.base_friction = -robot.C_u[i] * W
        self.f = robot.C_s[i] * (pin.getVelocity(model, data, self.upper, WORLD).angular - omega)
        pin.forwardKinematics(model, data, self.q, self.v, self.a)

    @property
    def slide(self) -> int:
        """Place of the prismatic joint among the rates."""
        return int(self.model.joints[self.lower + 1].idx_v)

    def _append_lower(self, body: pin.Inertia) -> None:
        """Fasten the lower part."""
        self.model.appendBodyToJoint(self.lower, body, pin.SE3.Identity())

    def _upper_joints(self) -> tuple[int, int]:
        """Add the prismatic joint and what follows; numbers of the upper part's and of the tip's joint."""
        tip = self.model.addJoint(self.lower, pin.JointModelPX(), pin.SE3.Identity(), "prismatic")
        return tip, tip

    def _tip_jacobian(self, q: Array) -> Array:
        """Of the velocity of the tip; all joints are placed."""
        pin.computeJointJacobians(self.model, self.data, q)
        return np.asarray(pin.getJointJacobian(self.model, self.data, self.last, WORLD)[:3])

    @abstractmethod
    def _base_joints(self) -> int:
        """Add the joints at the base; the number of the one that carries the lower part."""

    @abstractmethod
    def _configuration(self, S: Array) -> Array:
        """Joint angles and length with the tip at S from the base point."""

    @abstractmethod
    def _joint_rates(self, tip: Array) -> Array:
        """Joint rates (or accelerations) that move the tip so."""

    @abstractmethod
    def _constraint_moment(self) -> float:
        """The part of the first joint's moment that no axis lets go."""

    def torques(self, wrench: Array) -> Array:
        """Torques and force of the joints when the tip feels a force or wrench; both ends have friction."""
        oMi = self.data.oMi
        on = [pin.Force.Zero() for _ in range(self.model.njoints)]
        none = np.zeros(3)
        ends = ((self.lower, none, self.base_friction), (self.upper, none, -self.f))
        for joint, force, moment in (*ends, (self.last, wrench[:3], wrench[3:] if len(wrench) > 3 else none)):
            back = oMi[joint].rotation.T
            on[joint] = on[joint] + pin.Force(back @ force, back @ moment)
        return np.array(pin.rnea(self.model, self.data, self.q, self.v, self.a, on))

    def base_reaction(self) -> tuple[Array, float]:
        """F_u in the base frame and M_u, after `torques` with what the tip feels."""
        return self.data.oMi[1].rotation @ self.data.f[1].linear, self._constraint_moment()

    def prismatic_reaction(self) -> tuple[Array, Array]:
        """F_p, and M_p about the base point, base frame, after `torques` with what the tip feels."""
        placement, reaction = self.data.oMi[self.lower + 1], self.data.f[self.lower + 1]
        force, moment = placement.rotation @ reaction.linear, placement.rotation @ reaction.angular
        lever = placement.translation - self.robot.b[self.i]
        friction = -self.robot.C_p[self.i] * self.v[self.slide] * placement.rotation[:, 0]
        return force - friction, moment + np.cross(lever, force)

    @property
    def on_platform(self) -> Array:
        """Wrench on the platform about its origin, of what each component at the end of the leg is."""
        columns = np.eye(6)
        columns[3:, :3] = pin.skew(self.lever)
        return columns[:, : len(self.tip_jacobian)]

    def actuated(self) -> Array:
        """Generalized forces of a unit force of the actuator."""
        e = np.zeros(self.model.nv)
        e[self.slide] = 1.0
        return e

    def sliding_friction(self) -> Array:
        """Generalized force against the friction of sliding."""
        return self.robot.C_p[self.i] * self.v[self.slide] * self.actuated()

    def moved(self, joint: int) -> Array:
        """Coordinate of a joint with its rate and acceleration."""
        at = self.model.joints[joint]
        return np.array([self.q[at.idx_q], self.v[at.idx_v], self.a[at.idx_v]])


def frame_along(x: Array) -> Array:
    """A frame with its x axis along a unit vector."""
    across = np.cross(x, np.eye(3)[np.argmin(np.abs(x))])
    across /= np.linalg.norm(across)
    return np.column_stack([x, across, np.cross(x, across)])


class UniversalChain(_Chain):
    """Base, revolute about k, revolute about y, prismatic along s."""

    def _base_joints(self) -> int:
        # A frame with its x axis along k; then s = Rk Rx(q1) Ry(q2) e_x.
        self.frame = frame_along(self.robot.k[self.i])
        at = pin.SE3(self.frame, self.robot.b[self.i])
        first = self.model.addJoint(0, pin.JointModelRX(), at, "fixed axis")
        return int(self.model.addJoint(first, pin.JointModelRY(), pin.SE3.Identity(), "moving axis"))

    def _configuration(self, S: Array) -> Array:
        L = np.linalg.norm(S)
        along, second, third = self.frame.T @ S / L
        return np.array([np.arctan2(second, -third), np.arccos(along), L])

    def _joint_rates(self, tip: Array) -> Array:
        return np.linalg.solve(self.tip_jacobian, tip)

    def _constraint_moment(self) -> float:
        # In the first joint's frame k is x and the second axis is y: the normal to both is z.
        return float(self.data.f[1].angular[2])


class OffsetChain(UniversalChain):
    """One leg: revolute about k, revolute about y, prismatic along s; three more revolutes of U-C-U legs."""

    def _base_joints(self) -> int:
        self.o, self.frame = self.robot.offsets, frame_along(self.robot.k[self.i])
        self.spins = self.o.platform_joint == "universal"
        at = pin.SE3(self.frame, self.robot.b[self.i])
        first = self.model.addJoint(0, pin.JointModelRX(), at, "fixed axis")
        # The moving axis is y of the first joint's frame, o = y x k its -z.
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -self.o.axis_offset[self.i]]))
        return int(self.model.addJoint(first, pin.JointModelRY(), at, "moving axis"))

    def _upper_joints(self) -> tuple[int, int]:
        model, o, i, none = self.model, self.o, self.i, pin.SE3.Identity()
        at = pin.SE3(np.eye(3), np.array([0.0, o.slide_offset_y[i], o.slide_offset_z[i]]))
        upper = model.addJoint(self.lower, pin.JointModelPX(), at, "sliding")
        if not self.spins:
            return upper, upper
        # The last joint's frame has its x axis along the second axis of the platform's joint.
        self.on = self.motion.R @ frame_along(o.platform_axis[i])
        upper = model.addJoint(upper, pin.JointModelRX(), none, "spin")
        wrist = model.addJoint(upper, pin.JointModelRY(), none, "first axis of the platform joint")
        at = pin.SE3(np.eye(3), np.array([0.0, 0.0, -o.wrist_offset[i]]))
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

    def _constraint_moment(self) -> float:
        # At the moving axis, along the normal k x y to both axes.
        rotation = self.data.oMi[2].rotation
        return float(rotation @ self.data.f[2].angular @ np.cross(self.robot.k[self.i], rotation[:, 1]))


class GearedChain(UniversalChain):
    """The same with the rotor as a body of its own, that turns on the lower part by N times the length.

    The lower part of the robot has the rotor in it, locked: here it is taken out of it. The gearing is a
    projection: joint torques and forces are those of the coordinates that are left.
    """

    free = slice(0, 3)
    MASS, ACROSS = 0.02, 0.8
    """Mass of a rotor, of its lower part's, and its inertia across its axis, of that about it."""

    def _append_lower(self, body: pin.Inertia) -> None:
        assert self.robot.drive is not None
        self.turns = 2 * np.pi / self.robot.drive.lead[self.i]
        axial = self.robot.drive.rotor_inertia[self.i]
        place = np.array([body.lever[0], 0.0, 0.0])
        inertia = axial * np.diag([1.0, self.ACROSS, self.ACROSS])
        rotor = pin.Inertia(self.MASS * body.mass, np.zeros(3), inertia)
        at = pin.SE3(np.eye(3), place)
        joint = self.model.addJoint(self.lower, pin.JointModelRX(), at, "rotor")
        self.model.appendBodyToJoint(joint, rotor, pin.SE3.Identity())
        mass = body.mass - rotor.mass
        center = (body.mass * body.lever - rotor.mass * place) / mass

        def steiner(mass: float, arm: Array) -> Array:
            return np.asarray(mass * (arm @ arm * np.eye(3) - np.outer(arm, arm)))

        about_base = (
            body.inertia + steiner(body.mass, body.lever) - rotor.inertia - steiner(rotor.mass, place)
        )
        rest = pin.Inertia(mass, center, about_base - steiner(mass, center))
        self.model.appendBodyToJoint(self.lower, rest, pin.SE3.Identity())

    def _configuration(self, S: Array) -> Array:
        own = super()._configuration(S)
        return np.append(own, self.turns * (own[2] - 0.1))

    def _joint_rates(self, tip: Array) -> Array:
        own = np.linalg.solve(self.tip_jacobian[:, :3], tip)
        return np.append(own, self.turns * own[2])

    def torques(self, wrench: Array) -> Array:
        fixed, moving, slide, rotor = super().torques(wrench)
        return np.array([fixed, moving, slide + self.turns * rotor, 0.0])


class SphericalChain(_Chain):
    """Base, spherical joint without spin, prismatic along s."""

    free = slice(1, None)

    def _base_joints(self) -> int:
        at = pin.SE3(np.eye(3), self.robot.b[self.i])
        return int(self.model.addJoint(0, pin.JointModelSpherical(), at, "base"))

    def _configuration(self, S: Array) -> Array:
        L = np.linalg.norm(S)
        turn = pin.Quaternion.FromTwoVectors(np.array([1.0, 0.0, 0.0]), S / L)
        return np.concatenate([turn.coeffs(), [L]])

    def _joint_rates(self, tip: Array) -> Array:
        # Rates of the spherical joint are in its own frame, whose x axis is the leg's: the first is the spin.
        spin = np.array([[1.0, 0.0, 0.0, 0.0]])
        return np.linalg.solve(np.vstack([spin, self.tip_jacobian]), np.concatenate([[0.0], tip]))

    def _constraint_moment(self) -> float:
        return float(self.data.f[1].angular[0])


def _chain_of(robot: Robot) -> type[_Chain]:
    if robot.offsets is not None:
        return OffsetChain
    if robot.has_rotors:
        return GearedChain
    return SphericalChain if robot.base_joint == "spherical" else UniversalChain
