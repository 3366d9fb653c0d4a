"""The closed form: M [a; alpha] + C [v; omega] + g + friction = H F + external wrench, as blocks.

Every leg is a mechanism of three freedoms at its tip (``tip``, ``joint_leg``); the platform sees it through
J = [E, -[q]x]. Blocks here give what a pose has for all legs with the platform's own part, and one leg's part
of each sum: of M, C, g and friction; of M and the right side of forward dynamics; of the bias; and of the
derivatives of the wrench by pose, twist and acceleration. Poses move by [dt; dphi], R becoming
exp([dphi]x) R. Formulation `exact` with universal base joints. Knows nothing of sharing or printing.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp

from . import notation as n
from . import prepared as p
from . import tip
from .block import Block, Builder, Quantity
from .joint_leg import (
    JointForces,
    JointFrame,
    friction_moment,
    gravity_torques,
    joint_accelerations,
    joint_forces,
    joint_frame,
    joint_inertia,
    joint_rates,
    tip_force,
)
from .leg import cross
from .regroup import from_difference, rotary


def _matrix(name: str, unit: str, meaning: str, symmetric: bool = False) -> Quantity:
    return Quantity(name, (3, 3), unit, meaning, symmetric)


def _vector(name: str, unit: str, meaning: str) -> Quantity:
    return Quantity(name, (3,), unit, meaning)


# Inertia, rows and columns of v and omega.
M_VV = _matrix("M_vv", "kg", "inertia, force by a", True)
M_VW = _matrix("M_vw", "kg m", "inertia, force by alpha")
M_WW = _matrix("M_ww", "kg m^2", "inertia, moment by alpha", True)
INERTIA = (M_VV, M_VW, M_WW)

# Coriolis matrix, gravity, friction, bias, right side.
C_VV = _matrix("C_vv", "kg/s", "Coriolis matrix, force by v")
C_VW = _matrix("C_vw", "kg m/s", "Coriolis matrix, force by omega")
C_WV = _matrix("C_wv", "kg m/s", "Coriolis matrix, moment by v")
C_WW = _matrix("C_ww", "kg m^2/s", "Coriolis matrix, moment by omega")
CORIOLIS = (C_VV, C_VW, C_WV, C_WW)
GRAVITY = (_vector("g_force", "N", "gravity, force"), _vector("g_moment", "N m", "gravity, moment"))
FRICTION = (
    _vector("friction_force", "N", "friction, force"),
    _vector("friction_moment", "N m", "friction, moment"),
)
BIAS = (
    _vector("bias_force", "N", "C twist + g + friction, force"),
    _vector("bias_moment", "N m", "C twist + g + friction, moment"),
)
RIGHT = (
    _vector("right_force", "N", "H F + external wrench - bias, force"),
    _vector("right_moment", "N m", "H F + external wrench - bias, moment"),
)

# Derivatives of the wrench M [a; alpha] + bias - external wrench - H F at fixed F.
BY_POSE = (
    _matrix("W_ft", "N/m", "force by dt"),
    _matrix("W_fr", "N", "force by dphi"),
    _matrix("W_mt", "N", "moment by dt"),
    _matrix("W_mr", "N m", "moment by dphi"),
)
BY_TWIST = (
    _matrix("W_fv", "N s/m", "force by v"),
    _matrix("W_fw", "N s", "force by omega"),
    _matrix("W_mv", "N s", "moment by v"),
    _matrix("W_mw", "N m s", "moment by omega"),
)

# What the pose hands to the legs.
B_0 = _matrix("B_0", "1/s^2", "[omega]x [omega]x")
F_LEG = Quantity("F", (), "N", "actuator force of the leg")
NET = Quantity(
    "net", (3,), "N, N m", "generalised forces of the leg less the actuator's, along L, theta, phi"
)
H_DOT = (
    _vector("H_dot_force", "1/s", "rate of the leg's column of H, force rows"),
    _vector("H_dot_moment", "m/s", "rate of the leg's column of H, moment rows"),
)

TURNED = Quantity(
    "turned", (3,), "m/s^2, 1/s^2", "accelerations of L, theta, phi by those of the platform alone"
)

AXIAL = Quantity("axial", (), "1", "0 of a leaning leg with little inertia about its own axis, else 1")

# A leg's inertia kept apart from the directions in which it acts: M of (L, theta, phi), the gradients of
# L, theta, phi by the platform's position and rotation, generalised forces and their derivatives.
M_XI = _matrix("M_xi", "kg, kg m, kg m^2", "inertia of the joint coordinates, rows L, theta, phi", True)
ROWS = (
    _matrix("row_v", "1, 1/m", "gradients of L, theta, phi by position"),
    _matrix("row_w", "m, 1", "gradients of L, theta, phi by rotation"),
)
TAU = _vector("tau", "N, N m", "generalised forces less the actuator's without accelerations of the platform")
TAU_BY = tuple(
    _matrix(f"tau_{by}", "N, N m per unit", f"generalised forces by {meaning}, row for row")
    for by, meaning in (("t", "dt"), ("r", "dphi"), ("v", "v"), ("w", "omega"))
)


@dataclass(frozen=True)
class SumKernel:
    """A pose's part and one leg's part of sums over the machine.

    summed: quantities that both blocks hand out and that are added up; the leg's block also hands out its
    column of H where it is needed, and q, L, k3 by which the leg is judged. near: the leg's block for poses
    in which a leg is near its joint singularity, where the other loses digits.
    """

    name: str
    summed: tuple[Quantity, ...]
    pose: Block
    leg: Block
    near: Block | None = None

    def changed(self, change: Callable[[Block], Block]) -> "SumKernel":
        """The kernel with the blocks of a leg changed."""
        return replace(self, leg=change(self.leg), near=None if self.near is None else change(self.near))


NAMES = ("equations", "bias", "forward_dynamics", "derivatives", "joint_rows", "joint_slopes")
"""Of the kernels, in the order of the emitted file."""
OF_TWO_FORMS = ("equations", "derivatives")
"""Of those whose legs have a second block."""


def kernels(friction: bool = True) -> tuple[SumKernel, ...]:
    """All of them, as ``NAMES``."""
    return tuple(kernel(name, friction) for name in NAMES)


@cache
def kernel(name: str, friction: bool, near: bool = True) -> SumKernel:
    """One of ``NAMES``, derived once; near: with the leg's second block where there is one."""
    if near and name in OF_TWO_FORMS:
        leg = {"equations": _equations_of_leg, "derivatives": _derivatives_of_leg}[name]
        return replace(kernel(name, friction, False), near=from_difference(leg(friction, near=True)))
    derive = {
        "equations": equations_kernel,
        "bias": bias_kernel,
        "forward_dynamics": forward_kernel,
        "derivatives": derivatives_kernel,
        "joint_rows": joint_rows_kernel,
        "joint_slopes": joint_slopes_kernel,
    }[name]
    return derive(friction).changed(from_difference)


# ---------------------------------------------------------------- the platform's own part


@dataclass(frozen=True)
class _Platform:
    """Mass, first moment h, inertia J about the reference point, base frame, and omega x h, J omega."""

    mass: sp.Expr
    h: sp.Matrix
    J: sp.Matrix
    w_h: sp.Matrix
    J_w: sp.Matrix


def _platform(build: Builder, alone: bool = False) -> _Platform:
    """alone: without the masses of the upper parts, which legs then have themselves."""
    R, omega = n.R.value, n.omega.value
    mass, first, tensor = p.M_P.value, p.h_P.value, p.J_P.value
    if alone:
        mass, first = n.M.value, n.M.value * n.R_0.value
        tensor = build.tensor("J_0", n.I_p.value + p.point_inertia(mass, n.R_0.value))
    h = build.vector("h_base", R * first, "(30)", "first moment of the platform, base frame")
    J = build.tensor("J_base", R * tensor * R.T, "(32)", "inertia of the platform, base frame")
    w_h = build.vector("w_h", cross(omega, h), "(31)", "omega x h")
    J_w = build.vector("J_w", J * omega, "(34)", "I omega")
    return _Platform(mass, h, J, w_h, J_w)


def _platform_inertia(at: _Platform) -> list[tuple[Quantity, sp.Matrix]]:
    return [(M_VV, at.mass * sp.eye(3)), (M_VW, -tip.skew(at.h)), (M_WW, at.J)]


def _platform_bias(at: _Platform, friction: bool) -> tuple[sp.Matrix, sp.Matrix]:
    """C twist + g + friction of the platform with what rides on it, force and moment."""
    omega, g = n.omega.value, n.g.value
    moment = cross(omega, at.J_w) - cross(at.h, g)
    if friction:
        moment += p.C_P.value * omega
    return cross(omega, at.w_h) - at.mass * g, moment


def _external() -> tuple[sp.Matrix, sp.Matrix]:
    return n.R.value * n.F_ext.value, n.R.value * n.M_ext.value


OWN_MASSES = (n.M, n.R_0, n.I_p, n.m_u)
"""Numbers of the robot for what takes the platform and the upper parts apart."""

PREPARED = (*OWN_MASSES, p.h_P, p.J_P)
"""What the closed form reads of a prepared model besides what the forces do."""

_POSE_INPUTS = (*n.MOTION, p.M_P, p.h_P, p.J_P, p.C_P, n.g, *OWN_MASSES[:3])


def _centripetal(build: Builder) -> sp.Matrix:
    return rotary(build, n.omega.value, sp.zeros(3, 1))


# ---------------------------------------------------------------- one leg


@dataclass(frozen=True)
class _Leg:
    """A leg on its way: frame with third axis, omega x q, tip velocity."""

    at: JointFrame
    w_q: sp.Matrix
    S_dot: sp.Matrix

    @property
    def z(self) -> sp.Matrix:
        """Third axis of the leg frame."""
        assert self.at.z is not None
        return self.at.z

    @property
    def T(self) -> sp.Matrix:
        """Leg frame, columns s, y, z."""
        return sp.Matrix.hstack(self.at.s, self.at.y, self.z)


def _leg(build: Builder) -> _Leg:
    at = joint_frame(build, with_z=True)
    w_q = build.vector("w_q", cross(n.omega.value, at.q), "(4)", "omega x q")
    S_dot = build.vector("S_dot", w_q + n.v.value, "(4)", "velocity of the platform point")
    return _Leg(at, w_q, S_dot)


def _judged(at: JointFrame) -> list[tuple[Quantity, sp.Expr | sp.Matrix]]:
    return [(n.q, at.q), (n.L, at.L), (n.k3, at.k3)]


def _by_joints(at: JointFrame) -> sp.Matrix:
    """Motion of the platform point, leg frame, by L, theta and phi, 3x3."""
    return tip.of_tip().xreplace({tip.L: at.L, tip.k3: at.k3})


def _columns(at: JointFrame) -> list[tuple[Quantity, sp.Matrix]]:
    return [(n.H_force, at.s), (n.H_moment, cross(at.q, at.s))]


_LEG_INPUTS = (*n.LEG, *p.LEG, *n.MOTION, p.B, B_0, F_LEG, NET, TURNED, AXIAL, n.g)


def _tip_inertia(build: Builder, leg: _Leg) -> tuple[sp.Matrix, sp.Matrix]:
    """m at the tip, base frame, nothing along s alone, and M of (L, theta, phi), both 3x3 symmetric."""
    at = leg.at
    inner = joint_inertia(build, at)
    meaning = "inertia at the tip, leg frame"
    y, z = at.inv_rho, -at.inv_L
    m_sy = build.scalar("m_leg_sy", inner.L_phi * y, "", meaning)
    m_sz = build.scalar("m_leg_sz", inner.L_theta * z, "", meaning)
    m_yy = build.scalar("m_leg_yy", inner.phi * y * y, "", meaning)
    m_yz = build.scalar("m_leg_yz", inner.mixed * y * z, "", meaning)
    m_zz = build.scalar("m_leg_zz", inner.theta * z * z, "", meaning)
    local = sp.Matrix([[0, m_sy, m_sz], [m_sy, m_yy, m_yz], [m_sz, m_yz, m_zz]])
    m = _turned(build, "m", leg.T, local, "inertia at the tip, base frame", symmetric=True)
    return m, inner.matrix()


def _turned(
    build: Builder, name: str, T: sp.Matrix, local: sp.Matrix, meaning: str, symmetric: bool = False
) -> sp.Matrix:
    """T local T^T, its entries named."""
    half = sp.Matrix(
        3, 3, lambda i, j: build.scalar(f"{name}_T_{'xyz'[i]}{'syz'[j]}", (T[i, :] * local[:, j])[0])
    )
    if symmetric:
        return build.tensor(name, half * T.T, "", meaning)
    return _named(build, name, half * T.T, meaning)


def _named(build: Builder, name: str, value: sp.Matrix, meaning: str = "") -> sp.Matrix:
    return sp.Matrix(
        3, 3, lambda i, j: build.scalar(f"{name}_{'xyz'[i]}{'xyz'[j]}", value[i, j], "", meaning)
    )


def _leg_inertia(build: Builder, m: sp.Matrix, q: sp.Matrix) -> list[tuple[Quantity, sp.Matrix]]:
    """J^T m J."""
    mq = _named(build, "m_q", m * tip.skew(q), "m [q]x")
    return [(M_VV, m), (M_VW, -mq), (M_WW, -tip.skew(q) * mq)]


def _wrench(force: sp.Matrix, q: sp.Matrix, less: sp.Matrix | None = None) -> list[sp.Matrix]:
    moment = cross(q, force)
    return [force, moment if less is None else moment - less]


# ---------------------------------------------------------------- the kernels


def bias_kernel(friction: bool) -> SumKernel:
    """C twist + g + friction without C."""
    build = Builder()
    force, moment = _platform_bias(_platform(build), friction)
    pose = build.block(
        "bias_of_platform",
        "the platform's part of C twist + g + friction",
        _POSE_INPUTS,
        [(B_0, _centripetal(build)), *zip(BIAS, (force, moment), strict=True)],
    )
    build = Builder()
    leg = _leg(build)
    tau, f = _tip_bias(build, leg, friction)
    D, K = tip_force(build, leg.at, tau)
    R = build.vector("R_tip", K + D * leg.at.s, "", "force at the tip")
    block = build.block(
        "bias_of_leg",
        "one leg's part of C twist + g + friction",
        _LEG_INPUTS,
        [*zip(BIAS, _wrench(R, leg.at.q, f), strict=True), *_judged(leg.at)],
    )
    return SumKernel("bias", BIAS, pose, block)


def _tip_bias(build: Builder, leg: _Leg, friction: bool) -> tuple[JointForces, sp.Matrix]:
    """Generalised forces and f of the leg without accelerations of the platform."""
    at = leg.at
    rates = joint_rates(build, at, leg.S_dot)
    S_ddot = build.vector(
        "S_ddot", B_0.value * at.q, "(7)", "acceleration of the platform point, a = alpha = 0"
    )
    accelerations = joint_accelerations(build, at, rates, S_ddot)
    return joint_forces(build, at, rates, accelerations, friction), friction_moment(at, rates, friction)


def forward_kernel(friction: bool) -> SumKernel:
    """M, and the right side H F + external wrench - bias."""
    pose = _forward_of_platform("forward_of_platform", friction)
    build = Builder()
    leg = _leg(build)
    tau, f = _tip_bias(build, leg, friction)
    D, K = tip_force(build, leg.at, tau)
    push = build.vector("push", (F_LEG.value - D) * leg.at.s - K, "", "force on the platform at the tip")
    m, _ = _tip_inertia(build, leg)
    block = build.block(
        "forward_of_leg",
        "one leg's part of M and of the right side",
        _LEG_INPUTS,
        [
            *_leg_inertia(build, m, leg.at.q),
            *zip(RIGHT, _wrench(push, leg.at.q, -f), strict=True),
            *_judged(leg.at),
        ],
    )
    return SumKernel("forward_dynamics", (*INERTIA, *RIGHT), pose, block)


def _forward_of_platform(name: str, friction: bool, alone: bool = False) -> Block:
    build = Builder()
    at = _platform(build, alone)
    bias, load = _platform_bias(at, friction), _external()
    return build.block(
        name,
        "the platform's part of M and of the right side",
        _POSE_INPUTS,
        [
            (B_0, _centripetal(build)),
            *_platform_inertia(at),
            *((q, outer - inner) for q, outer, inner in zip(RIGHT, load, bias, strict=True)),
        ],
    )


def joint_rows_kernel(friction: bool) -> SumKernel:
    """The same without the legs in M: what they have of it by the joint coordinates, which M would add up.

    M = M_platform + sum of G^T M_xi G with G = [row_v row_w], and the right side lacks G^T tau. An upper part
    is with its leg as a whole: riding on the platform, a heavy one's mass would be in the way of its digits.
    """
    build = Builder()
    leg = _leg(build)
    at = leg.at
    tau, f = _tip_bias(build, leg, friction)
    fall = build.vector("fall", B_0.value * at.q - n.g.value, "", "of the platform point, from free fall")
    m_u, to_tip = n.m_u.value, _by_joints(at)
    own = to_tip.T * m_u * build.vector("fall_T", leg.T.T * fall)
    rows = sp.Matrix.vstack(at.s.T, -at.inv_L * leg.z.T, at.inv_rho * at.y.T)
    rows = _named(build, "row_v", rows)
    nothing = [(q, sp.zeros(*q.shape)) for q in INERTIA]
    block = build.block(
        "joint_rows_of_leg",
        "one leg's inertia and generalised forces in its joint coordinates, and their gradients",
        _LEG_INPUTS,
        [
            *nothing,
            *zip(RIGHT, (sp.zeros(3, 1), f), strict=True),
            (M_XI, joint_inertia(build, at).matrix() + m_u * to_tip.T * to_tip),
            *zip(ROWS, (rows, -rows * tip.skew(at.q)), strict=True),
            (TAU, sp.Matrix([tau.along - F_LEG.value, tau.about_y, tau.about_k]) + own),
            *_judged(at),
        ],
    )
    pose = _forward_of_platform("joint_rows_of_platform", friction, alone=True)
    return SumKernel("joint_rows", (*INERTIA, *RIGHT), pose, block)


def equations_kernel(friction: bool) -> SumKernel:
    """M, C, g and friction apart, H and its rate."""
    summed = (*INERTIA, *CORIOLIS, *GRAVITY, *FRICTION)
    return SumKernel(
        "equations", summed, _equations_of_platform(friction), _equations_of_leg(friction, near=False)
    )


def _equations_of_platform(friction: bool) -> Block:
    build = Builder()
    at = _platform(build)
    omega, g = n.omega.value, n.g.value
    half_trace = build.scalar("half_trace", (at.J[0, 0] + at.J[1, 1] + at.J[2, 2]) / 2)
    turn = tip.skew(omega)
    zero = sp.zeros(3, 3)
    coriolis = (zero, -tip.skew(at.w_h), zero, turn * at.J - half_trace * turn)
    rub = p.C_P.value * omega if friction else sp.zeros(3, 1)
    return build.block(
        "equations_of_platform",
        "the platform's part of M, C, g and friction",
        _POSE_INPUTS,
        [
            *_platform_inertia(at),
            *zip(CORIOLIS, coriolis, strict=True),
            *zip(GRAVITY, (-p.M_P.value * g, -cross(at.h, g)), strict=True),
            *zip(FRICTION, (sp.zeros(3, 1), rub), strict=True),
        ],
    )


def _equations_of_leg(friction: bool, near: bool) -> Block:
    build = Builder()
    leg = _leg(build)
    at, q = leg.at, leg.at.q
    rates = joint_rates(build, at, leg.S_dot)
    m, M = _tip_inertia(build, leg)
    C_tip = _turned(
        build,
        "C_tip",
        leg.T,
        _local(build, "C_leg", _coriolis_near(build, leg) if near else _coriolis(build, M)),
        "Coriolis matrix at the tip, base frame",
    )
    w_q = leg.w_q
    C_vw = _named(build, "C_q", -C_tip * tip.skew(q) - m * tip.skew(w_q))
    turn = tip.skew(q)
    about_y, about_k = gravity_torques(build, at)
    held = build.vector("held", _from_torques(build, leg, sp.S.Zero, about_y, about_k), "", "against gravity")
    rub, f = sp.zeros(3, 1), friction_moment(at, rates, friction)
    if friction:
        omega, C_s, C_us = n.omega.value, n.C_s.value, p.C_us.value
        rub = build.vector(
            "rubbed",
            _from_torques(
                build,
                leg,
                n.C_p.value * rates.L,
                C_us * rates.theta - C_s * at.y.dot(omega),
                C_us * rates.phi - C_s * n.k.value.dot(omega),
            ),
            "",
            "against friction",
        )
    s_dot = build.vector("s_dot", at.inv_L * (leg.S_dot - rates.L * at.s), "(3)", "rate of s")
    return build.block(
        "equations_of_leg_near" if near else "equations_of_leg",
        "one leg's part of M, C, g and friction, its column of H and the column's rate",
        _LEG_INPUTS,
        [
            *_leg_inertia(build, m, q),
            *zip(CORIOLIS, (C_tip, C_vw, turn * C_tip, turn * C_vw), strict=True),
            *zip(GRAVITY, _wrench(held, q), strict=True),
            *zip(FRICTION, _wrench(rub, q, f), strict=True),
            *_columns(at),
            *zip(H_DOT, (s_dot, cross(w_q, at.s) + cross(q, s_dot)), strict=True),
            *_judged(at),
        ],
    )


def _coriolis(build: Builder, M: sp.Matrix) -> sp.Matrix:
    """Coriolis matrix at the tip, leg frame, from the named M of the joint coordinates."""
    inner = tip.gradients()
    C = _local(build, "C_xi", tip.christoffel(tip.inertia()))
    rate = _local(build, "G_dot", inner.rate)
    return inner.value.T * (C * inner.value + M * rate)


def _coriolis_near(build: Builder, leg: _Leg) -> sp.Matrix:
    """The same without large parts that cancel near the joint singularity."""
    inner, M = tip.gradients(), tip.inertia()
    _name_finite_rates(build, leg)
    return tip.gathered(inner.value.T * (tip.christoffel(M) * inner.value + M * inner.rate))


def _from_torques(build: Builder, leg: _Leg, axial: sp.Expr, about_y: sp.Expr, about_k: sp.Expr) -> sp.Matrix:
    """Gamma^T tau, base frame."""
    return axial * leg.at.s - leg.at.inv_L * about_y * leg.z + leg.at.inv_rho * about_k * leg.at.y


def _local(build: Builder, name: str, value: sp.Matrix) -> sp.Matrix:
    """Entries of a matrix of the leg frame or of the joint coordinates, named; zeros stay zeros."""
    return sp.Matrix(
        *value.shape,
        lambda i, j: build.scalar(f"{name}_{i + 1}{j + 1}", value[i, j]),
    )


# ---------------------------------------------------------------- derivatives


def derivatives_kernel(friction: bool) -> SumKernel:
    """Derivatives of the wrench by pose, twist and acceleration, the last of which is M."""
    summed = (*INERTIA, *BY_POSE, *BY_TWIST)
    return SumKernel(
        "derivatives", summed, _derivatives_of_platform(friction), _derivatives_of_leg(friction, near=False)
    )


def _derivatives_of_platform(friction: bool, name: str = "derivatives", alone: bool = False) -> Block:
    build = Builder()
    at = _platform(build, alone)
    omega, alpha = n.omega.value, n.alpha.value
    turn, J = tip.skew(omega), at.J
    B = rotary(build, omega, alpha)
    J_alpha = build.vector("J_alpha", J * alpha)
    rise = build.vector("rise", n.a.value - n.g.value, "(33)", "a - g")
    F_load, M_load = (
        build.vector(name, v) for name, v in zip(("F_load", "M_load"), _external(), strict=True)
    )
    spin = _named(build, "spin", J * turn - tip.skew(at.J_w), "derivative of I omega by dphi at fixed omega")
    by_omega = turn * J - tip.skew(at.J_w)
    if friction:
        by_omega += p.C_P.value * sp.eye(3)
    zero = sp.zeros(3, 3)
    pose = (
        zero,
        -B * tip.skew(at.h) + tip.skew(F_load),
        zero,
        tip.skew(rise) * tip.skew(at.h)
        + J * tip.skew(alpha)
        - tip.skew(J_alpha)
        + turn * spin
        + tip.skew(M_load),
    )
    twist = (zero, -tip.skew(at.w_h) - turn * tip.skew(at.h), zero, by_omega)
    return build.block(
        f"{name}_of_platform",
        "the platform's part of the derivatives of the wrench",
        _POSE_INPUTS,
        [
            (p.B, B),
            *_platform_inertia(at),
            *zip(BY_POSE, pose, strict=True),
            *zip(BY_TWIST, twist, strict=True),
        ],
    )


@dataclass(frozen=True)
class _Slopes:
    """Derivatives of the tip's force by S, S_dot, S_ddot and omega, and of f by S and S_dot; base frame."""

    S: sp.Matrix
    S_dot: sp.Matrix
    S_ddot: sp.Matrix
    omega: sp.Matrix
    f_S: sp.Matrix
    f_S_dot: sp.Matrix
    force: sp.Matrix


def _derivatives_of_leg(friction: bool, near: bool) -> Block:
    build = Builder()
    leg = _leg(build)
    q, turn = leg.at.q, tip.skew(leg.at.q)
    by = _tip_slopes(build, leg, friction, near)
    W = tip.skew(n.omega.value)
    w_q = leg.w_q
    reach = _named(build, "X", by.S + by.S_dot * W + by.S_ddot * p.B.value, "force by rotation about the tip")
    pace = _named(build, "Y", by.S_dot + by.S_ddot * W)
    fr = _named(build, "Z", -reach * turn)
    fw = _named(build, "V", -pace * turn - by.S_ddot * tip.skew(w_q) + by.omega)
    mr, mw = turn * fr + tip.skew(by.force) * turn, turn * fw
    mt, mv = turn * by.S, turn * by.S_dot
    if friction:
        mt, mr = mt - by.f_S, mr + (by.f_S + by.f_S_dot * W) * turn
        mv, mw = mv - by.f_S_dot, mw + by.f_S_dot * turn
    return build.block(
        "derivatives_of_leg_near" if near else "derivatives_of_leg",
        "one leg's part of the derivatives of the wrench",
        _LEG_INPUTS,
        [
            *_leg_inertia(build, by.S_ddot, q),
            *zip(BY_POSE, (by.S, fr, mt, mr), strict=True),
            *zip(BY_TWIST, (by.S_dot, fw, mv, mw), strict=True),
            *_columns(leg.at),
            *_judged(leg.at),
        ],
    )


@dataclass(frozen=True)
class _TorqueSlopes:
    """Derivatives of the leg's generalised forces, 3x3, leg frame: by S, S_dot and S_ddot.

    inertia: M of the joint coordinates; bend: sum of the net forces times the Hessians of L, theta, phi;
    force: Gamma^T net, base frame.
    """

    S: sp.Matrix
    S_dot: sp.Matrix
    bend: sp.Matrix
    inertia: sp.Matrix
    force: sp.Matrix


def _torque_slopes(
    build: Builder, leg: _Leg, friction: bool, near: bool, net: sp.Matrix | None = None
) -> _TorqueSlopes:
    """See ``tip`` for the formulas. near: everything in the symbols of ``tip.gathered``, and without names.

    net: generalised forces less the actuator's, where they are given.
    """
    inner, raw, M = tip.gradients(), tip.torques(friction), tip.inertia()
    gravity_torques(build, leg.at)
    if friction:
        name_omega(build, leg.at)
    named = zip(("tau_L", "tau_theta", "tau_phi"), tip.gathered(raw) if near else raw, strict=True)
    if net is None:
        tau = [build.scalar(name, value) for name, value in named]
        net = sp.Matrix([tau[0] - F_LEG.value, tau[1], tau[2]])
        bent = sp.Matrix([raw[0] - F_LEG.value, raw[1], raw[2]]) if near else net
    else:
        bent = net
    rate, second, by_rate, by_place = inner.rate, inner.second, raw.jacobian(tip.rates), tip.place(raw)
    if not near:
        M = joint_inertia(build, leg.at).matrix()
        rate, second = _local(build, "G_dot", rate), _local(build, "G_ddot", second)
        by_rate, by_place = _local(build, "tau_rate", by_rate), _local(build, "tau_place", by_place)
    return _TorqueSlopes(
        S=M * second + by_rate * rate + by_place * inner.value,
        S_dot=2 * M * rate + by_rate * inner.value,
        bend=_bend(bent),
        inertia=M,
        force=build.vector(
            "R_tip",
            _from_torques(build, leg, net[0], net[1], net[2]),
            "",
            "force at the tip, less the actuator's",
        ),
    )


def _bend(net: sp.Matrix) -> sp.Matrix:
    """Sum of the net forces times the Hessians of L, theta, phi, whatever the forces are made of."""
    names = sp.Matrix(sp.symbols("net_L net_theta net_phi", real=True))
    return tip.hessian(names).xreplace(dict(zip(names, net, strict=True)))


def _name_finite_rates(build: Builder, leg: _Leg) -> None:
    """Names what ``tip.gathered`` takes as given of the leg and its rates."""
    joint_rates(build, leg.at, leg.S_dot)
    build.scalar(tip.inv_k3.name, leg.at.L * leg.at.inv_rho)
    build.scalar(tip.W_z.name, leg.at.inv_L * leg.at.y.dot(leg.S_dot), "(6)", "leg's turning about z")


def _name_joint_motion(build: Builder, leg: _Leg) -> None:
    """Names rates and accelerations of the joint coordinates."""
    rates = joint_rates(build, leg.at, leg.S_dot)
    S_ddot = build.vector(
        "S_ddot", p.B.value * leg.at.q + n.a.value, "(7)", "acceleration of the platform point"
    )
    joint_accelerations(build, leg.at, rates, S_ddot)


def _name_finite_motion(build: Builder, leg: _Leg, turned: bool) -> None:
    """Names what ``tip.gathered`` takes as given of the leg, its rates and accelerations.

    turned: what the platform's accelerations add is given by the joint coordinates, where rounding of the
    platform's would be large beside it.
    """
    at, rates = leg.at, joint_rates(build, leg.at, leg.S_dot)
    _name_finite_rates(build, leg)
    if turned:
        S_ddot, (along, about_y, about_k) = _centripetal_acceleration(build, at), TURNED.value
    else:
        S_ddot = p.B.value * at.q + n.a.value
        along = about_y = about_k = sp.S.Zero
    S_ddot = build.vector("S_ddot", S_ddot, "(7)", "acceleration of the platform point")
    along += at.s.dot(S_ddot) + at.L * (rates.theta2 + at.k3**2 * rates.phi2)
    build.scalar(tip.accelerations[0].name, along, "(8)", "acceleration of the length")
    meaning = "turning accelerations of the leg about y and z but for the turning of the frame about s"
    about_y += -at.inv_L * leg.z.dot(S_ddot) - 2 * rates.theta * rates.L_share
    about_z = at.k3 * about_k + at.inv_L * at.y.dot(S_ddot) - 2 * tip.W_z * rates.L_share
    build.scalar(tip.OWN_Y.name, about_y, "(9)", meaning)
    build.scalar(tip.OWN_Z.name, about_z, "(9)", meaning)


def _centripetal_acceleration(build: Builder, at: JointFrame) -> sp.Matrix:
    omega = n.omega.value
    return cross(omega, build.vector("w_q", cross(omega, at.q), "(4)", "omega x q"))


def _friction_slopes(build: Builder, leg: _Leg, friction: bool) -> tuple[sp.Matrix, sp.Matrix]:
    """Derivatives of f by S and S_dot, base frame."""
    if not friction:
        return sp.zeros(3, 3), sp.zeros(3, 3)
    inner = tip.gradients()
    rate = _local(build, "G_dot", inner.rate)
    k, y, normal = sp.Matrix([tip.k1, 0, tip.k3]), sp.Matrix([0, 1, 0]), sp.Matrix([-tip.k3, 0, tip.k1])
    C_s = n.C_s.value
    by_S = C_s * (k * rate[2, :] + y * rate[1, :] + tip.rates[1] * normal * inner.value[2, :])
    by_S_dot = C_s * (k * inner.value[2, :] + y * inner.value[1, :])
    f_S, f_S_dot = (
        _turned(build, name, leg.T, _local(build, f"{name}_leg", local), meaning)
        for name, local, meaning in (
            ("f_S", by_S, "friction moment by S"),
            ("f_S_dot", by_S_dot, "friction moment by S_dot"),
        )
    )
    return f_S, f_S_dot


def _tip_slopes(build: Builder, leg: _Leg, friction: bool, near: bool) -> _Slopes:
    """See ``tip`` for the formulas; the actuator's force enters through the second derivative of L."""
    if near:
        _name_finite_motion(build, leg, turned=False)
    else:
        _name_joint_motion(build, leg)
    m, _ = _tip_inertia(build, leg)
    by = _torque_slopes(build, leg, friction, near)
    T, value = leg.T, tip.gradients().value
    by_omega = sp.zeros(3, 3)
    if friction:
        y, k = sp.Matrix([0, 1, 0]), sp.Matrix([tip.k1, 0, tip.k3])
        by_omega = n.C_s.value * value.T * sp.Matrix.vstack(sp.zeros(1, 3), -y.T, -k.T)
        by_omega = _turned(build, "A_3", T, _local(build, "A_3_leg", by_omega), "force at the tip by omega")
    f_S, f_S_dot = _friction_slopes(build, leg, friction)
    A_0, A_1 = value.T * by.S + by.bend, value.T * by.S_dot
    if near:
        A_0, A_1 = tip.gathered(A_0), tip.gathered(A_1)
    return _Slopes(
        S=_turned(build, "A_0", T, _local(build, "A_0_leg", A_0), "force at the tip by S"),
        S_dot=_turned(build, "A_1", T, _local(build, "A_1_leg", A_1), "force at the tip by S_dot"),
        S_ddot=m,
        omega=by_omega,
        f_S=f_S,
        f_S_dot=f_S_dot,
        force=by.force,
    )


def joint_slopes_kernel(friction: bool) -> SumKernel:
    """Derivatives of the wrench, and apart from them those that act along the rows of ``joint_rows_kernel``.

    The derivative of the wrench is the sum of what is summed and of [row_v row_w]^T tau_by over the legs.
    """
    build = Builder()
    leg = _leg(build)
    q, turn, T = leg.at.q, tip.skew(leg.at.q), leg.T
    _name_finite_motion(build, leg, turned=True)
    by = _torque_slopes(build, leg, friction, near=True, net=NET.value)
    fall = T.T * build.vector("fall", _centripetal_acceleration(build, leg.at) - n.g.value)
    fall = n.m_u.value * build.vector(
        "fall_T",
        fall + _by_joints(leg.at) * TURNED.value,
        "",
        "acceleration of the platform point from free fall, leg frame",
    )
    turning, bend = _turning_with_leg(fall, NET.value, friction)
    S, S_dot, S_ddot = (
        _named(
            build,
            name,
            _local(build, f"{name}_leg", tip.gathered(value)) * T.T,
            "generalised forces by the tip's motion",
        )
        for name, value in (
            ("tau_S", by.S + turning),
            ("tau_S_dot", by.S_dot),
            ("tau_S_ddot", by.inertia * tip.gradients().value + n.m_u.value * tip.of_tip().T),
        )
    )
    # Not gathered with the rest of S: what AXIAL = 1 takes out of it would stay as rounding.
    bent = _local(build, "bent_leg", _by_joints(leg.at).T * bend)
    S = _named(build, "tau_place", S + bent * T.T, "generalised forces by the tip's place, as the rows turn")
    W, w_q = tip.skew(n.omega.value), build.vector("w_q", cross(n.omega.value, q), "(4)", "omega x q")
    reach = _named(build, "X", S + S_dot * W + S_ddot * p.B.value)
    pace = _named(build, "Y", S_dot + S_ddot * W)
    zero = sp.zeros(3, 3)
    mt, mr = zero, tip.skew(by.force) * turn
    mv = mw = by_omega = zero
    if friction:
        C_s, f_S, f_S_dot = n.C_s.value, *_friction_slopes(build, leg, friction)
        by_omega = -C_s * sp.Matrix.vstack(sp.zeros(1, 3), leg.at.y.T, n.k.value.T)
        mt, mr = -f_S, mr + (f_S + f_S_dot * W) * turn
        mv, mw = -f_S_dot, f_S_dot * turn
    block = build.block(
        "joint_slopes_of_leg",
        "one leg's part of the derivatives of the wrench, and its generalised forces' derivatives",
        _LEG_INPUTS,
        [
            *((quantity, zero) for quantity in INERTIA),
            *zip(BY_POSE, (zero, zero, mt, mr), strict=True),
            *zip(BY_TWIST, (zero, zero, mv, mw), strict=True),
            *zip(
                TAU_BY,
                (S, -reach * turn, S_dot, -pace * turn - S_ddot * tip.skew(w_q) + by_omega),
                strict=True,
            ),
            *_columns(leg.at),
            *_judged(leg.at),
        ],
    )
    pose = _derivatives_of_platform(friction, "joint_slopes", alone=True)
    return SumKernel("joint_slopes", (*INERTIA, *BY_POSE, *BY_TWIST), pose, block)


def _turning_with_leg(fall: sp.Matrix, net: sp.Matrix, friction: bool) -> tuple[sp.Matrix, sp.Matrix]:
    """What turning adds to the derivatives by S: of the generalised forces by a mass at the tip, of the rows.

    Near the joint singularity the leg frame turns fast about the leg. Both parts are then large, and what
    a thin rod's forces across the leg add to them cancels: with AXIAL = 0 it is in neither. Of a leg with
    inertia about its own axis it stays in both, as ``net`` is small where what it is the sum of is not.
    fall: mass at the tip times its acceleration from free fall, leg frame.
    """
    forces = tip.torques(friction)
    rod = tip.of_rod(forces)
    across = (1 - AXIAL.value) * (tip.gradients().value.T * rod + fall)
    turning = tip.by_place_of_force(fall - sp.Matrix([0, across[1], across[2]]))
    apart = AXIAL.value * net + (1 - AXIAL.value) * (forces - rod).applyfunc(tip.gathered)
    return turning, _bend(sp.Matrix([net[0], apart[1], apart[2]]))


def name_omega(build: Builder, at: JointFrame) -> None:
    """Names what ``tip`` takes as given of omega: its parts along k x y, y and k."""
    k, omega, meaning = n.k.value, n.omega.value, "omega along k x y, y and k"
    normal = build.vector("normal", cross(k, at.y), "", "k x y")
    build.scalar(tip.OMEGA_N.name, normal.dot(omega), "", meaning)
    build.scalar(tip.OMEGA_Y.name, at.y.dot(omega), "", meaning)
    build.scalar(tip.OMEGA_K.name, k.dot(omega), "", meaning)
