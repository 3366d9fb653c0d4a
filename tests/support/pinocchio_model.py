"""The machine in Pinocchio: six serial chains and a free body, joined by forces. An independent check.

Takes nothing from stewart_sym but the numbers of a Robot and of one Motion. Joint angles, rates and
accelerations come from Pinocchio's own Jacobians; forces from its recursive Newton-Euler over each chain,
the torques of the passive joints being zero, together with the platform's six equations: eighteen equations
in the eighteen components of the forces at the spherical joints.
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
    """What Pinocchio says of one pose: F, M_u (6,); F_s, F_u, F_p, M_p (base point), (6, 3), base frame."""

    F: Array
    F_s: Array
    F_u: Array
    F_p: Array
    M_p: Array
    M_u: Array


def pinocchio_inverse_dynamics(robot: Robot, motion: Motion) -> Answer:
    """Actuator forces and joint reactions of one pose (leading shape ())."""
    plain = SphericalChain if robot.base_joint == "spherical" else UniversalChain
    chain = GearedChain if robot.has_rotors else plain
    legs = [chain(robot, motion, i) for i in range(6)]

    rows, right = np.zeros((18, 18)), np.zeros(18)
    right[12:] = _platform_wrench(robot, motion) + sum(
        np.concatenate([np.zeros(3), motion.R.T @ leg.f]) for leg in legs
    )
    for i, leg in enumerate(legs):
        tau_0 = leg.torques(np.zeros(3))
        J = leg.tip_jacobian
        rows[2 * i : 2 * i + 2, 3 * i : 3 * i + 3] = J.T[leg.passive]
        right[2 * i : 2 * i + 2] = tau_0[leg.passive]
        rows[12:15, 3 * i : 3 * i + 3] = motion.R.T
        rows[15:18, 3 * i : 3 * i + 3] = pin.skew(robot.p[i]) @ motion.R.T
    F_s = np.asarray(np.linalg.solve(rows, right).reshape(6, 3), dtype=np.float64)

    F, M_u = np.zeros(6), np.zeros(6)
    F_u, F_p, M_p = np.zeros((6, 3)), np.zeros((6, 3)), np.zeros((6, 3))
    for i, leg in enumerate(legs):
        tau = leg.torques(F_s[i])
        np.testing.assert_allclose(tau[:-1], 0, atol=1e-9 * leg.moment_scale(F_s[i]))
        F[i] = tau[-1] + robot.C_p[i] * leg.v[leg.slide]
        F_u[i], M_u[i] = leg.base_reaction()
        F_p[i], M_p[i] = leg.prismatic_reaction()
    return Answer(F=F, F_s=F_s, F_u=F_u, F_p=F_p, M_p=M_p, M_u=M_u)


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
        self.length = float(np.linalg.norm(S))

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

    def moment_scale(self, F_s: Array) -> float:
        """Of the moments that balance each other in the joints."""
        mass = self.robot.m_d[self.i] + self.robot.m_u[self.i] + self.robot.M
        force = mass * (np.linalg.norm(self.robot.g) + np.abs(self.a).max()) + np.linalg.norm(F_s)
        return float(self.length * force)


def frame_along(x: Array) -> Array:
    """A frame with its x axis along a unit vector."""
    across = np.cross(x, np.eye(3)[np.argmin(np.abs(x))])
    across /= np.linalg.norm(across)
    return np.column_stack([x, across, np.cross(x, across)])


class UniversalChain(_Chain):
    """Base, revolute about k, revolute about y, prismatic along s."""

    passive = slice(0, 2)

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


class GearedChain(UniversalChain):
    """The same with the rotor as a body of its own, that turns on the lower part by N times the length.

    The lower part of the robot has the rotor in it, locked: here it is taken out of it. The gearing is a
    projection: joint torques and forces are those of the coordinates that are left.
    """

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
        return np.array([fixed, moving, slide + self.turns * rotor])


class SphericalChain(_Chain):
    """Base, spherical joint without spin, prismatic along s."""

    passive = slice(1, 3)

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
