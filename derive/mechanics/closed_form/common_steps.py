"""Common parts of the blocks of the closed form: the platform, the frame of a leg, its inertia at the tip."""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder, Quantity
from .. import lumped_constants as p
from .. import quantities as n
from ..actuator_forces import rotary
from ..legs import tip
from ..legs.joint_coordinates import (
    JointForces,
    JointFrame,
    friction_moment,
    joint_accelerations,
    joint_forces,
    joint_frame,
    joint_inertia,
    joint_rates,
)
from ..legs.leg import cross, skew
from ..legs.rotor import NONE, Rotor
from .terms import AXIAL, B_0, F_LEG, M_VV, M_VW, M_WW, NET, TURNED


@dataclass(frozen=True)
class Platform:
    """Mass properties of the platform about the reference point, base frame.

    Attributes
    ----------
    mass : Expr
        Mass (kg).
    h : Matrix, shape (3, 1)
        First moment (kg m).
    J : Matrix, shape (3, 3)
        Inertia (kg m^2).
    w_h, J_w : Matrix, shape (3, 1)
        omega x h (kg m/s), and J omega (kg m^2/s).
    """

    mass: sp.Expr
    h: sp.Matrix
    J: sp.Matrix
    w_h: sp.Matrix
    J_w: sp.Matrix


def platform_of(build: Builder, alone: bool = False) -> Platform:
    """Name the mass properties of the platform, with the lumped upper parts unless ``alone``."""
    R, omega = n.R.value, n.omega.value
    mass, first, tensor = p.M_P.value, p.h_P.value, p.J_P.value
    if alone:
        mass, first = n.M.value, n.M.value * n.R_0.value
        tensor = build.tensor("J_0", n.I_p.value + p.point_inertia(mass, n.R_0.value))
    h = build.vector("h_base", R * first, "(30)", "first moment of the platform, base frame")
    J = build.tensor("J_base", R * tensor * R.T, "(32)", "inertia of the platform, base frame")
    w_h = build.vector("w_h", cross(omega, h), "(31)", "omega x h")
    J_w = build.vector("J_w", J * omega, "(34)", "I omega")
    return Platform(mass, h, J, w_h, J_w)


def platform_inertia(at: Platform) -> list[tuple[Quantity, sp.Matrix]]:
    """Return the platform's part of M."""
    return [(M_VV, at.mass * sp.eye(3)), (M_VW, -skew(at.h)), (M_WW, at.J)]


def platform_bias(at: Platform) -> tuple[sp.Matrix, sp.Matrix]:
    """Compute force and moment C twist + g + friction of the platform and the lumped masses, base frame."""
    omega, g = n.omega.value, n.g.value
    moment = cross(omega, at.J_w) - cross(at.h, g) + p.C_P.value * omega
    return cross(omega, at.w_h) - at.mass * g, moment


def external() -> tuple[sp.Matrix, sp.Matrix]:
    """Return the external force and moment, base frame."""
    return n.R.value * n.F_ext.value, n.R.value * n.M_ext.value


OWN_MASSES = (n.M, n.R_0, n.I_p, n.m_u)
"""Numbers of the robot that are needed if the platform and the upper parts are separate."""

PREPARED = (*OWN_MASSES, p.h_P, p.J_P)
"""Numbers of a prepared model that the closed form reads in addition to the forces."""

POSE_INPUTS = (*n.MOTION, p.M_P, p.h_P, p.J_P, p.C_P, n.g, *OWN_MASSES[:3])


def centripetal(build: Builder) -> sp.Matrix:
    """Name the entries of [omega]x [omega]x."""
    return rotary(build, n.omega.value, sp.zeros(3, 1))


@dataclass(frozen=True)
class Leg:
    """Geometry and tip velocity of a leg, base frame.

    Attributes
    ----------
    at : JointFrame
        Leg frame with third axis z.
    w_q : Matrix, shape (3, 1)
        omega x q (m/s).
    S_dot : Matrix, shape (3, 1)
        Velocity of the tip (m/s).
    """

    at: JointFrame
    w_q: sp.Matrix
    S_dot: sp.Matrix

    @property
    def z(self) -> sp.Matrix:
        """Third axis of the leg frame, shape (3, 1)."""
        assert self.at.z is not None
        return self.at.z

    @property
    def T(self) -> sp.Matrix:
        """Leg frame with the columns s, y, z, shape (3, 3)."""
        return sp.Matrix.hstack(self.at.s, self.at.y, self.z)


def leg_of(build: Builder, early: bool = False, leaning: bool = True, rotor: Rotor = NONE) -> Leg:
    """Name the frame of a leg and the velocity of its tip; ``early``, ``leaning`` as in ``joint_frame``."""
    at = joint_frame(build, with_z=True, early=early, leaning=leaning, rotor=rotor)
    w_q = build.vector("w_q", cross(n.omega.value, at.q), "(4)", "omega x q")
    S_dot = build.vector("S_dot", w_q + n.v.value, "(4)", "velocity of the platform point")
    return Leg(at, w_q, S_dot)


def checked(at: JointFrame) -> list[tuple[Quantity, sp.Expr | sp.Matrix]]:
    """Return the outputs by which a leg is checked: q, L, k3."""
    return [(n.q, at.q), (n.L, at.L), (n.k3, at.k3)]


def by_joints(at: JointFrame) -> sp.Matrix:
    """Return the derivative of the platform point by L, theta, and phi, 3x3, leg frame."""
    return tip.of_tip().xreplace({tip.L: at.L, tip.k3: at.k3})


def columns_of_H(at: JointFrame) -> list[tuple[Quantity, sp.Matrix]]:
    """Return the leg's column of H."""
    return [(n.H_force, at.s), (n.H_moment, cross(at.q, at.s))]


LEG_INPUTS = (*n.OF_LEG, *p.LEG, *n.MOTION, p.B, B_0, F_LEG, NET, TURNED, AXIAL, n.g)


def tip_inertia(build: Builder, leg: Leg) -> tuple[sp.Matrix, sp.Matrix]:
    """Name m at the tip in the base frame and M of (L, theta, phi), both 3x3 and symmetric."""
    at = leg.at
    inner = joint_inertia(build, at)
    meaning = "inertia at the tip, leg frame"
    y, z = at.inv_rho, -at.inv_L
    m_sy = build.scalar("m_leg_sy", inner.L_phi * y, "", meaning)
    m_sz = build.scalar("m_leg_sz", inner.L_theta * z, "", meaning)
    m_yy = build.scalar("m_leg_yy", inner.phi * y * y, "", meaning)
    m_yz = build.scalar("m_leg_yz", inner.mixed * y * z, "", meaning)
    m_zz = build.scalar("m_leg_zz", inner.theta * z * z, "", meaning)
    local = sp.Matrix([[inner.L, m_sy, m_sz], [m_sy, m_yy, m_yz], [m_sz, m_yz, m_zz]])
    m = rotated(build, "m", leg.T, local, "inertia at the tip, base frame", symmetric=True)
    return m, inner.matrix()


def rotated(
    build: Builder, name: str, T: sp.Matrix, local: sp.Matrix, meaning: str, symmetric: bool = False
) -> sp.Matrix:
    """Name the entries of T local T^T."""
    half = sp.Matrix(
        3, 3, lambda i, j: build.scalar(f"{name}_T_{'xyz'[i]}{'syz'[j]}", (T[i, :] * local[:, j])[0])
    )
    if symmetric:
        return build.tensor(name, half * T.T, "", meaning)
    return build.matrix(name, half * T.T, "", meaning)


def leg_inertia(build: Builder, m: sp.Matrix, q: sp.Matrix) -> list[tuple[Quantity, sp.Matrix]]:
    """Name the leg's part J^T m J of M."""
    mq = build.matrix("m_q", m * skew(q), "", "m [q]x")
    return [(M_VV, m), (M_VW, -mq), (M_WW, -skew(q) * mq)]


def wrench(force: sp.Matrix, q: sp.Matrix, less: sp.Matrix | None = None) -> list[sp.Matrix]:
    """Convert a force at the tip to force and moment on the platform; subtract the moment ``less``."""
    moment = cross(q, force)
    return [force, moment if less is None else moment - less]


def tip_bias(build: Builder, leg: Leg) -> tuple[JointForces, sp.Matrix]:
    """Derive the generalized forces and f of the leg for zero acceleration of the platform."""
    at = leg.at
    rates = joint_rates(build, at, leg.S_dot)
    S_ddot = build.vector(
        "S_ddot", B_0.value * at.q, "(7)", "acceleration of the platform point, a = alpha = 0"
    )
    accelerations = joint_accelerations(build, at, rates, S_ddot)
    return joint_forces(build, at, rates, accelerations), friction_moment(at, rates)


def from_torques(build: Builder, leg: Leg, axial: sp.Expr, about_y: sp.Expr, about_k: sp.Expr) -> sp.Matrix:
    """Compute Gamma^T tau, base frame."""
    return axial * leg.at.s - leg.at.inv_L * about_y * leg.z + leg.at.inv_rho * about_k * leg.at.y


def local_matrix(build: Builder, name: str, value: sp.Matrix) -> sp.Matrix:
    """Name the entries of a matrix in the leg frame or in joint coordinates; zeros remain zeros."""
    return sp.Matrix(*value.shape, lambda i, j: build.scalar(f"{name}_{i + 1}{j + 1}", value[i, j]))


def name_finite_rates(build: Builder, leg: Leg) -> None:
    """Name the symbols of the leg and its rates that ``tip.gathered`` uses."""
    joint_rates(build, leg.at, leg.S_dot)
    build.scalar(tip.inv_k3.name, leg.at.L * leg.at.inv_rho)
    build.scalar(
        tip.W_z.name, leg.at.inv_L * leg.at.y.dot(leg.S_dot), "(6)", "angular velocity of the leg about z"
    )


def centripetal_acceleration(build: Builder, at: JointFrame) -> sp.Matrix:
    """Compute omega x (omega x q), base frame."""
    omega = n.omega.value
    return cross(omega, build.vector("w_q", cross(omega, at.q), "(4)", "omega x q"))


def name_omega(build: Builder, at: JointFrame) -> sp.Matrix:
    """Name the components of omega along k x y, y, and k, which ``tip`` uses; return k x y."""
    k, omega, meaning = n.k.value, n.omega.value, "omega along k x y, y and k"
    normal = build.vector("normal", cross(k, at.y), "", "k x y")
    build.scalar(tip.OMEGA_N.name, normal.dot(omega), "", meaning)
    build.scalar(tip.OMEGA_Y.name, at.y.dot(omega), "", meaning)
    build.scalar(tip.OMEGA_K.name, k.dot(omega), "", meaning)
    return normal
