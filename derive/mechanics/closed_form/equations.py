"""Equations of motion as blocks: M, C, g and friction; the bias; and forward dynamics."""

import sympy as sp

from ...program.block import Block, Builder
from .. import lumped_constants as p
from .. import quantities as n
from ..legs import tip
from ..legs.joint_coordinates import friction_moment, gravity_torques, joint_inertia, joint_rates, tip_force
from ..legs.leg import cross, skew
from ..legs.rotor import Rotor
from . import common_steps, terms


def bias_kernel(rotor: Rotor) -> terms.SumKernel:
    """Derive C twist + g + friction without forming C."""
    build = Builder()
    force, moment = common_steps.platform_bias(common_steps.platform_of(build))
    pose = build.block(
        "bias_of_platform",
        "the platform's part of C twist + g + friction",
        common_steps.POSE_INPUTS,
        [(terms.B_0, common_steps.centripetal(build)), *zip(terms.BIAS, (force, moment), strict=True)],
    )
    build = Builder()
    leg = common_steps.leg_of(build, early=True, rotor=rotor)
    tau, f = common_steps.tip_bias(build, leg)
    D, K = tip_force(build, leg.at, tau)
    R = build.vector("R_tip", K + D * leg.at.s, "", "force at the tip")
    block = build.block(
        "bias_of_leg",
        "one leg's part of C twist + g + friction",
        common_steps.LEG_INPUTS,
        [*zip(terms.BIAS, common_steps.wrench(R, leg.at.q, f), strict=True), *common_steps.checked(leg.at)],
    )
    return terms.SumKernel("bias", terms.BIAS, pose, block)


def forward_kernel(rotor: Rotor) -> terms.SumKernel:
    """Derive M, and the right-hand side H F + external wrench - bias."""
    pose = _forward_of_platform("forward_of_platform")
    build = Builder()
    leg = common_steps.leg_of(build, early=True, rotor=rotor)
    tau, f = common_steps.tip_bias(build, leg)
    D, K = tip_force(build, leg.at, tau)
    push = build.vector(
        "push", (terms.F_LEG.value - D) * leg.at.s - K, "", "force on the platform at the tip"
    )
    m, _ = common_steps.tip_inertia(build, leg)
    block = build.block(
        "forward_of_leg",
        "one leg's part of M and of the right side",
        common_steps.LEG_INPUTS,
        [
            *common_steps.leg_inertia(build, m, leg.at.q),
            *zip(terms.RIGHT, common_steps.wrench(push, leg.at.q, -f), strict=True),
            *common_steps.checked(leg.at),
        ],
    )
    return terms.SumKernel("forward_dynamics", (*terms.INERTIA, *terms.RIGHT), pose, block)


def _forward_of_platform(name: str, alone: bool = False) -> Block:
    """Derive the platform's part of M and of the right-hand side."""
    build = Builder()
    at = common_steps.platform_of(build, alone)
    bias, load = common_steps.platform_bias(at), common_steps.external()
    return build.block(
        name,
        "the platform's part of M and of the right side",
        common_steps.POSE_INPUTS,
        [
            (terms.B_0, common_steps.centripetal(build)),
            *common_steps.platform_inertia(at),
            *((q, outer - inner) for q, outer, inner in zip(terms.RIGHT, load, bias, strict=True)),
        ],
    )


def joint_rows_kernel(rotor: Rotor) -> terms.SumKernel:
    """Derive forward dynamics with the inertia of the legs in joint coordinates instead of in M.

    M = M_platform + sum of G^T M_xi G with G = [row_v row_w]. The right-hand side lacks G^T tau. The upper
    part belongs to its leg: if a heavy upper part were lumped with the platform, the result would lose
    accuracy.
    """
    build = Builder()
    leg = common_steps.leg_of(build, rotor=rotor)
    at = leg.at
    tau, f = common_steps.tip_bias(build, leg)
    fall = build.vector(
        "fall",
        terms.B_0.value * at.q - n.g.value,
        "",
        "acceleration of the platform point relative to free fall, a = alpha = 0",
    )
    m_u, to_tip = n.m_u.value, common_steps.by_joints(at)
    own = to_tip.T * m_u * build.vector("fall_T", leg.T.T * fall)
    rows = sp.Matrix.vstack(at.s.T, -at.inv_L * leg.z.T, at.inv_rho * at.y.T)
    rows = build.matrix("row_v", rows)
    nothing = [(q, sp.zeros(*q.shape)) for q in terms.INERTIA]
    block = build.block(
        "joint_rows_of_leg",
        "one leg's inertia and generalized forces in its joint coordinates, and their gradients",
        common_steps.LEG_INPUTS,
        [
            *nothing,
            *zip(terms.RIGHT, (sp.zeros(3, 1), f), strict=True),
            (terms.M_XI, joint_inertia(build, at).matrix() + m_u * to_tip.T * to_tip),
            *zip(terms.ROWS, (rows, -rows * skew(at.q)), strict=True),
            (terms.TAU, sp.Matrix([tau.along - terms.F_LEG.value, tau.about_y, tau.about_k]) + own),
            *common_steps.checked(at),
        ],
    )
    pose = _forward_of_platform("joint_rows_of_platform", alone=True)
    return terms.SumKernel("joint_rows", (*terms.INERTIA, *terms.RIGHT), pose, block)


def equations_kernel(rotor: Rotor) -> terms.SumKernel:
    """Derive M, C, g, and friction separately, with H and its time derivative."""
    summed = (*terms.INERTIA, *terms.CORIOLIS, *terms.GRAVITY, *terms.FRICTION)
    return terms.SumKernel(
        "equations", summed, _equations_of_platform(), equations_of_leg(near=False, rotor=rotor)
    )


def _equations_of_platform() -> Block:
    build = Builder()
    at = common_steps.platform_of(build)
    omega, g = n.omega.value, n.g.value
    half_trace = build.scalar("half_trace", (at.J[0, 0] + at.J[1, 1] + at.J[2, 2]) / 2)
    turn = skew(omega)
    zero = sp.zeros(3, 3)
    coriolis = (zero, -skew(at.w_h), zero, turn * at.J - half_trace * turn)
    return build.block(
        "equations_of_platform",
        "the platform's part of M, C, g and friction",
        common_steps.POSE_INPUTS,
        [
            *common_steps.platform_inertia(at),
            *zip(terms.CORIOLIS, coriolis, strict=True),
            *zip(terms.GRAVITY, (-p.M_P.value * g, -cross(at.h, g)), strict=True),
            *zip(terms.FRICTION, (sp.zeros(3, 1), p.C_P.value * omega), strict=True),
        ],
    )


def equations_of_leg(near: bool, rotor: Rotor) -> Block:
    """Derive one leg's part; ``near`` selects the form for legs near their joint singularity."""
    build = Builder()
    leg = common_steps.leg_of(build, early=not near, leaning=False, rotor=rotor)
    at, q = leg.at, leg.at.q
    rates = joint_rates(build, at, leg.S_dot)
    m, M = common_steps.tip_inertia(build, leg)
    C_tip = common_steps.rotated(
        build,
        "C_tip",
        leg.T,
        common_steps.local_matrix(
            build, "C_leg", _coriolis_near(build, leg) if near else _coriolis(build, M, rotor)
        ),
        "Coriolis matrix at the tip, base frame",
    )
    w_q = leg.w_q
    C_vw = build.matrix("C_q", -C_tip * skew(q) - m * skew(w_q))
    turn = skew(q)
    about_y, about_k = gravity_torques(build, at)
    held = build.vector(
        "held",
        common_steps.from_torques(build, leg, sp.S.Zero, about_y, about_k),
        "",
        "force at the tip that balances gravity",
    )
    f = friction_moment(at, rates)
    omega, C_s, C_us = n.omega.value, n.C_s.value, p.C_us.value
    resistance = build.vector(
        "resistance",
        common_steps.from_torques(
            build,
            leg,
            n.C_p.value * rates.L,
            C_us * rates.theta - C_s * at.y.dot(omega),
            C_us * rates.phi - C_s * n.k.value.dot(omega),
        ),
        "",
        "force at the tip that balances friction",
    )
    s_dot = build.vector("s_dot", at.inv_L * (leg.S_dot - rates.L * at.s), "(3)", "derivative of s")
    return build.block(
        "equations_of_leg_near" if near else "equations_of_leg",
        "one leg's part of M, C, g and friction, its column of H and the column's rate",
        common_steps.LEG_INPUTS,
        [
            *common_steps.leg_inertia(build, m, q),
            *zip(terms.CORIOLIS, (C_tip, C_vw, turn * C_tip, turn * C_vw), strict=True),
            *zip(terms.GRAVITY, common_steps.wrench(held, q), strict=True),
            *zip(terms.FRICTION, common_steps.wrench(resistance, q, f), strict=True),
            *common_steps.columns_of_H(at),
            *zip(terms.H_DOT, (s_dot, cross(w_q, at.s) + cross(q, s_dot)), strict=True),
            *common_steps.checked(at),
        ],
    )


def _coriolis(build: Builder, M: sp.Matrix, rotor: Rotor) -> sp.Matrix:
    """Compute the Coriolis matrix at the tip, leg frame, from the named M of the joint coordinates."""
    inner = tip.gradients()
    C = common_steps.local_matrix(build, "C_xi", tip.christoffel(tip.inertia(rotor)))
    rate = common_steps.local_matrix(build, "G_dot", inner.rate)
    return inner.value.T * (C * inner.value + M * rate)


def _coriolis_near(build: Builder, leg: common_steps.Leg) -> sp.Matrix:
    """Compute the Coriolis matrix at the tip without large terms that cancel near the joint singularity."""
    inner, M = tip.gradients(), tip.inertia(leg.at.rotor)
    common_steps.name_finite_rates(build, leg)
    return tip.gathered(inner.value.T * (tip.christoffel(M) * inner.value + M * inner.rate))
