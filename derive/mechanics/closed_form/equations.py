"""The equations of motion as blocks: M, C, g and friction, the bias, and forward dynamics."""

import sympy as sp

from ...program.block import Block, Builder
from .. import lumped_constants as p
from .. import quantities as n
from ..legs import tip
from ..legs.joint_coordinates import friction_moment, gravity_torques, joint_inertia, joint_rates, tip_force
from ..legs.leg import cross
from .parts import (
    LEG_INPUTS,
    POSE_INPUTS,
    Leg,
    base_matrix,
    by_joints,
    centripetal,
    checked,
    columns_of_H,
    external,
    from_torques,
    leg_inertia,
    leg_of,
    local_matrix,
    name_finite_rates,
    platform_bias,
    platform_inertia,
    platform_of,
    rotated,
    tip_bias,
    tip_inertia,
    wrench,
)
from .terms import (
    B_0,
    BIAS,
    CORIOLIS,
    F_LEG,
    FRICTION,
    GRAVITY,
    H_DOT,
    INERTIA,
    M_XI,
    RIGHT,
    ROWS,
    TAU,
    SumKernel,
)


def bias_kernel(friction: bool) -> SumKernel:
    """C twist + g + friction without C."""
    build = Builder()
    force, moment = platform_bias(platform_of(build), friction)
    pose = build.block(
        "bias_of_platform",
        "the platform's part of C twist + g + friction",
        POSE_INPUTS,
        [(B_0, centripetal(build)), *zip(BIAS, (force, moment), strict=True)],
    )
    build = Builder()
    leg = leg_of(build)
    tau, f = tip_bias(build, leg, friction)
    D, K = tip_force(build, leg.at, tau)
    R = build.vector("R_tip", K + D * leg.at.s, "", "force at the tip")
    block = build.block(
        "bias_of_leg",
        "one leg's part of C twist + g + friction",
        LEG_INPUTS,
        [*zip(BIAS, wrench(R, leg.at.q, f), strict=True), *checked(leg.at)],
    )
    return SumKernel("bias", BIAS, pose, block)


def forward_kernel(friction: bool) -> SumKernel:
    """M, and the right side H F + external wrench - bias."""
    pose = _forward_of_platform("forward_of_platform", friction)
    build = Builder()
    leg = leg_of(build)
    tau, f = tip_bias(build, leg, friction)
    D, K = tip_force(build, leg.at, tau)
    push = build.vector("push", (F_LEG.value - D) * leg.at.s - K, "", "force on the platform at the tip")
    m, _ = tip_inertia(build, leg)
    block = build.block(
        "forward_of_leg",
        "one leg's part of M and of the right side",
        LEG_INPUTS,
        [
            *leg_inertia(build, m, leg.at.q),
            *zip(RIGHT, wrench(push, leg.at.q, -f), strict=True),
            *checked(leg.at),
        ],
    )
    return SumKernel("forward_dynamics", (*INERTIA, *RIGHT), pose, block)


def _forward_of_platform(name: str, friction: bool, alone: bool = False) -> Block:
    build = Builder()
    at = platform_of(build, alone)
    bias, load = platform_bias(at, friction), external()
    return build.block(
        name,
        "the platform's part of M and of the right side",
        POSE_INPUTS,
        [
            (B_0, centripetal(build)),
            *platform_inertia(at),
            *((q, outer - inner) for q, outer, inner in zip(RIGHT, load, bias, strict=True)),
        ],
    )


def joint_rows_kernel(friction: bool) -> SumKernel:
    """The same without the legs in M: what they have of it by the joint coordinates, which M would add up.

    M = M_platform + sum of G^T M_xi G with G = [row_v row_w], and the right side lacks G^T tau. An upper part
    stays with its leg: lumped with the platform, a heavy one's mass would cost digits.
    """
    build = Builder()
    leg = leg_of(build)
    at = leg.at
    tau, f = tip_bias(build, leg, friction)
    fall = build.vector("fall", B_0.value * at.q - n.g.value, "", "of the platform point, from free fall")
    m_u, to_tip = n.m_u.value, by_joints(at)
    own = to_tip.T * m_u * build.vector("fall_T", leg.T.T * fall)
    rows = sp.Matrix.vstack(at.s.T, -at.inv_L * leg.z.T, at.inv_rho * at.y.T)
    rows = base_matrix(build, "row_v", rows)
    nothing = [(q, sp.zeros(*q.shape)) for q in INERTIA]
    block = build.block(
        "joint_rows_of_leg",
        "one leg's inertia and generalised forces in its joint coordinates, and their gradients",
        LEG_INPUTS,
        [
            *nothing,
            *zip(RIGHT, (sp.zeros(3, 1), f), strict=True),
            (M_XI, joint_inertia(build, at).matrix() + m_u * to_tip.T * to_tip),
            *zip(ROWS, (rows, -rows * tip.skew(at.q)), strict=True),
            (TAU, sp.Matrix([tau.along - F_LEG.value, tau.about_y, tau.about_k]) + own),
            *checked(at),
        ],
    )
    pose = _forward_of_platform("joint_rows_of_platform", friction, alone=True)
    return SumKernel("joint_rows", (*INERTIA, *RIGHT), pose, block)


def equations_kernel(friction: bool) -> SumKernel:
    """M, C, g and friction apart, H and its rate."""
    summed = (*INERTIA, *CORIOLIS, *GRAVITY, *FRICTION)
    return SumKernel(
        "equations", summed, _equations_of_platform(friction), equations_of_leg(friction, near=False)
    )


def _equations_of_platform(friction: bool) -> Block:
    build = Builder()
    at = platform_of(build)
    omega, g = n.omega.value, n.g.value
    half_trace = build.scalar("half_trace", (at.J[0, 0] + at.J[1, 1] + at.J[2, 2]) / 2)
    turn = tip.skew(omega)
    zero = sp.zeros(3, 3)
    coriolis = (zero, -tip.skew(at.w_h), zero, turn * at.J - half_trace * turn)
    rub = p.C_P.value * omega if friction else sp.zeros(3, 1)
    return build.block(
        "equations_of_platform",
        "the platform's part of M, C, g and friction",
        POSE_INPUTS,
        [
            *platform_inertia(at),
            *zip(CORIOLIS, coriolis, strict=True),
            *zip(GRAVITY, (-p.M_P.value * g, -cross(at.h, g)), strict=True),
            *zip(FRICTION, (sp.zeros(3, 1), rub), strict=True),
        ],
    )


def equations_of_leg(friction: bool, near: bool) -> Block:
    """One leg's part; near: written for legs near their joint singularity."""
    build = Builder()
    leg = leg_of(build)
    at, q = leg.at, leg.at.q
    rates = joint_rates(build, at, leg.S_dot)
    m, M = tip_inertia(build, leg)
    C_tip = rotated(
        build,
        "C_tip",
        leg.T,
        local_matrix(build, "C_leg", _coriolis_near(build, leg) if near else _coriolis(build, M)),
        "Coriolis matrix at the tip, base frame",
    )
    w_q = leg.w_q
    C_vw = base_matrix(build, "C_q", -C_tip * tip.skew(q) - m * tip.skew(w_q))
    turn = tip.skew(q)
    about_y, about_k = gravity_torques(build, at)
    held = build.vector("held", from_torques(build, leg, sp.S.Zero, about_y, about_k), "", "against gravity")
    rub, f = sp.zeros(3, 1), friction_moment(at, rates, friction)
    if friction:
        omega, C_s, C_us = n.omega.value, n.C_s.value, p.C_us.value
        rub = build.vector(
            "rubbed",
            from_torques(
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
        LEG_INPUTS,
        [
            *leg_inertia(build, m, q),
            *zip(CORIOLIS, (C_tip, C_vw, turn * C_tip, turn * C_vw), strict=True),
            *zip(GRAVITY, wrench(held, q), strict=True),
            *zip(FRICTION, wrench(rub, q, f), strict=True),
            *columns_of_H(at),
            *zip(H_DOT, (s_dot, cross(w_q, at.s) + cross(q, s_dot)), strict=True),
            *checked(at),
        ],
    )


def _coriolis(build: Builder, M: sp.Matrix) -> sp.Matrix:
    """Coriolis matrix at the tip, leg frame, from the named M of the joint coordinates."""
    inner = tip.gradients()
    C = local_matrix(build, "C_xi", tip.christoffel(tip.inertia()))
    rate = local_matrix(build, "G_dot", inner.rate)
    return inner.value.T * (C * inner.value + M * rate)


def _coriolis_near(build: Builder, leg: Leg) -> sp.Matrix:
    """The same without large parts that cancel near the joint singularity."""
    inner, M = tip.gradients(), tip.inertia()
    name_finite_rates(build, leg)
    return tip.gathered(inner.value.T * (tip.christoffel(M) * inner.value + M * inner.rate))
