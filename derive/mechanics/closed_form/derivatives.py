"""Derivatives of the wrench by pose, twist, and acceleration, as blocks."""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Block, Builder
from .. import lumped_constants as p
from .. import quantities as n
from ..actuator_forces import rotary
from ..legs import tip
from ..legs.joint_coordinates import gravity_torques, joint_accelerations, joint_inertia, joint_rates
from ..legs.leg import cross, skew
from ..legs.rotor import Rotor
from . import common_steps
from .terms import AXIAL, BY_POSE, BY_TWIST, F_LEG, INERTIA, NET, TAU_BY, TURNED, SumKernel


def derivatives_kernel(rotor: Rotor) -> SumKernel:
    """Derive the derivatives of the wrench by pose, twist, and acceleration; the last one is M."""
    summed = (*INERTIA, *BY_POSE, *BY_TWIST)
    return SumKernel("derivatives", summed, _derivatives_of_platform(), derivatives_of_leg(False, rotor))


def _derivatives_of_platform(name: str = "derivatives", alone: bool = False) -> Block:
    """Derive the platform's part of the derivatives."""
    build = Builder()
    at = common_steps.platform_of(build, alone)
    omega, alpha = n.omega.value, n.alpha.value
    turn, J = skew(omega), at.J
    B = rotary(build, omega, alpha)
    J_alpha = build.vector("J_alpha", J * alpha)
    rise = build.vector("rise", n.a.value - n.g.value, "(33)", "a - g")
    F_load, M_load = (
        build.vector(name, v) for name, v in zip(("F_load", "M_load"), common_steps.external(), strict=True)
    )
    spin = build.matrix("spin", J * turn - skew(at.J_w), "", "derivative of I omega by dphi at fixed omega")
    by_omega = turn * J - skew(at.J_w) + p.C_P.value * sp.eye(3)
    zero = sp.zeros(3, 3)
    pose = (
        zero,
        -B * skew(at.h) + skew(F_load),
        zero,
        skew(rise) * skew(at.h) + J * skew(alpha) - skew(J_alpha) + turn * spin + skew(M_load),
    )
    twist = (zero, -skew(at.w_h) - turn * skew(at.h), zero, by_omega)
    return build.block(
        f"{name}_of_platform",
        "the platform's part of the derivatives of the wrench",
        common_steps.POSE_INPUTS,
        [
            (p.B, B),
            *common_steps.platform_inertia(at),
            *zip(BY_POSE, pose, strict=True),
            *zip(BY_TWIST, twist, strict=True),
        ],
    )


@dataclass(frozen=True)
class _Slopes:
    """Derivatives of the force at the tip and of the friction moment f, base frame.

    Attributes
    ----------
    S, S_dot, S_ddot, omega : Matrix, shape (3, 3)
        Derivatives of the force by S, S_dot, S_ddot, and omega.
    f_S, f_S_dot : Matrix, shape (3, 3)
        Derivatives of f by S and S_dot.
    force : Matrix, shape (3, 1)
        Force at the tip less the actuator force (N).
    """

    S: sp.Matrix
    S_dot: sp.Matrix
    S_ddot: sp.Matrix
    omega: sp.Matrix
    f_S: sp.Matrix
    f_S_dot: sp.Matrix
    force: sp.Matrix


def derivatives_of_leg(near: bool, rotor: Rotor) -> Block:
    """Derive one leg's part; ``near`` selects the form for legs near their joint singularity."""
    build = Builder()
    leg = common_steps.leg_of(build, early=not near, leaning=False, rotor=rotor)
    q, turn = leg.at.q, skew(leg.at.q)
    by = _tip_slopes(build, leg, near)
    W = skew(n.omega.value)
    w_q = leg.w_q
    reach = build.matrix(
        "X",
        by.S + by.S_dot * W + by.S_ddot * p.B.value,
        "",
        "derivative of the force by rotation about the tip",
    )
    pace = build.matrix("Y", by.S_dot + by.S_ddot * W)
    fr = build.matrix("Z", -reach * turn)
    fw = build.matrix("V", -pace * turn - by.S_ddot * skew(w_q) + by.omega)
    mw, mt, mv = turn * fw, turn * by.S, turn * by.S_dot
    moment = skew(by.force) + by.f_S + by.f_S_dot * W - turn * reach
    mt, mr = (
        mt - by.f_S,
        build.matrix("Q", moment, "", "derivative of the moment by rotation about the tip") * turn,
    )
    mv, mw = mv - by.f_S_dot, mw + by.f_S_dot * turn
    return build.block(
        "derivatives_of_leg_near" if near else "derivatives_of_leg",
        "one leg's part of the derivatives of the wrench",
        common_steps.LEG_INPUTS,
        [
            *common_steps.leg_inertia(build, by.S_ddot, q),
            *zip(BY_POSE, (by.S, fr, mt, mr), strict=True),
            *zip(BY_TWIST, (by.S_dot, fw, mv, mw), strict=True),
            *common_steps.columns_of_H(leg.at),
            *common_steps.checked(leg.at),
        ],
    )


@dataclass(frozen=True)
class _TorqueSlopes:
    """Derivatives of the leg's generalized forces, leg frame.

    Attributes
    ----------
    S, S_dot : Matrix, shape (3, 3)
        Derivatives by S and S_dot.
    bend : Matrix, shape (3, 3)
        Sum of the net forces times the Hessians of L, theta, phi.
    inertia : Matrix, shape (3, 3)
        Mass matrix M of the joint coordinates, the derivative by their accelerations.
    force : Matrix, shape (3, 1)
        Gamma^T net, base frame (N).
    normal : Matrix, shape (3, 1)
        k x y, base frame.
    """

    S: sp.Matrix
    S_dot: sp.Matrix
    bend: sp.Matrix
    inertia: sp.Matrix
    force: sp.Matrix
    normal: sp.Matrix


def _torque_slopes(
    build: Builder, leg: common_steps.Leg, near: bool, net: sp.Matrix | None = None
) -> _TorqueSlopes:
    """Derive the derivatives of the generalized forces by the formulas in ``tip``.

    Parameters
    ----------
    near : bool
        True to use the symbols of ``tip.gathered`` and no names.
    net : Matrix, shape (3, 1), optional
        Generalized forces less the actuator force. If None, they are computed.
    """
    rotor = leg.at.rotor
    inner, raw, M = tip.gradients(), tip.torques(True, rotor), tip.inertia(rotor)
    gravity_torques(build, leg.at)
    normal = common_steps.name_omega(build, leg.at)
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
        rate, second = (
            common_steps.local_matrix(build, "G_dot", rate),
            common_steps.local_matrix(build, "G_ddot", second),
        )
        by_rate, by_place = (
            common_steps.local_matrix(build, "tau_rate", by_rate),
            common_steps.local_matrix(build, "tau_place", by_place),
        )
    return _TorqueSlopes(
        S=M * second + by_rate * rate + by_place * inner.value,
        S_dot=2 * M * rate + by_rate * inner.value,
        bend=_bend(bent),
        inertia=M,
        force=build.vector(
            "R_tip",
            common_steps.from_torques(build, leg, net[0], net[1], net[2]),
            "",
            "force at the tip, less the actuator's",
        ),
        normal=normal,
    )


def _bend(net: sp.Matrix) -> sp.Matrix:
    """Compute the sum of the net forces times the Hessians of L, theta, phi."""
    names = sp.Matrix(sp.symbols("net_L net_theta net_phi", real=True))
    return tip.hessian(names).xreplace(dict(zip(names, net, strict=True)))


def _name_finite_motion(build: Builder, leg: common_steps.Leg, turned: bool) -> None:
    """Name the symbols of the leg, its rates, and its accelerations that ``tip.gathered`` uses.

    ``turned`` reads the effect of the platform's accelerations in joint coordinates, because rounding errors
    of the platform's accelerations would be relatively large.
    """
    at, rates = leg.at, joint_rates(build, leg.at, leg.S_dot)
    common_steps.name_finite_rates(build, leg)
    if turned:
        S_ddot, (along, about_y, about_k) = common_steps.centripetal_acceleration(build, at), TURNED.value
    else:
        S_ddot = p.B.value * at.q + n.a.value
        along = about_y = about_k = sp.S.Zero
    S_ddot = build.vector("S_ddot", S_ddot, "(7)", "acceleration of the platform point")
    along += at.s.dot(S_ddot) + at.L * (rates.theta2 + at.k3**2 * rates.phi2)
    build.scalar(tip.accelerations[0].name, along, "(8)", "acceleration of the length")
    meaning = "angular accelerations of the leg about y and z without the rotation of the frame about s"
    about_y += -at.inv_L * leg.z.dot(S_ddot) - 2 * rates.theta * rates.L_share
    about_z = at.k3 * about_k + at.inv_L * at.y.dot(S_ddot) - 2 * tip.W_z * rates.L_share
    build.scalar(tip.OWN_Y.name, about_y, "(9)", meaning)
    build.scalar(tip.OWN_Z.name, about_z, "(9)", meaning)


def _friction_slopes(build: Builder, leg: common_steps.Leg, normal: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Derive the derivatives of f = C_s (phi_dot k + theta_dot y - omega) by S and S_dot, base frame.

    ``normal`` is k x y, the derivative of y by phi.
    """
    at, k, C_s = leg.at, n.k.value, n.C_s.value
    rate = common_steps.local_matrix(build, "G_dot", tip.gradients().rate)
    by_theta, by_phi = (
        build.vector(f"{name}_by_S", C_s * (leg.T * rate[i, :].T), "", "slope of a rate, times C_s")
        for i, name in ((1, "theta_dot"), (2, "phi_dot"))
    )
    theta = build.vector("C_s_theta", -C_s * at.inv_L * leg.z, "", "gradient of theta, times C_s")
    phi = build.vector("C_s_phi", C_s * at.inv_rho * at.y, "", "gradient of phi, times C_s")
    turned = build.vector("y_by_phi", tip.rates[1] * normal)
    f_S = k * by_phi.T + at.y * by_theta.T + turned * phi.T
    return (
        build.matrix("f_S", f_S, "", "friction moment by S"),
        build.matrix("f_S_dot", k * phi.T + at.y * theta.T, "", "friction moment by S_dot"),
    )


def _tip_slopes(build: Builder, leg: common_steps.Leg, near: bool) -> _Slopes:
    """Derive the derivatives at the tip by the formulas in ``tip``.

    The actuator force enters through the second derivative of L.
    """
    if near:
        _name_finite_motion(build, leg, turned=False)
    else:
        rates, moved = joint_rates(build, leg.at, leg.S_dot), p.B.value * leg.at.q + n.a.value
        S_ddot = build.vector("S_ddot", moved, "(7)", "acceleration of the platform point")
        joint_accelerations(build, leg.at, rates, S_ddot)
    m, _ = common_steps.tip_inertia(build, leg)
    by = _torque_slopes(build, leg, near)
    T, value = leg.T, tip.gradients().value
    f_S, f_S_dot = _friction_slopes(build, leg, by.normal)
    A_0, A_1 = value.T * by.S + by.bend, value.T * by.S_dot
    if near:
        A_0, A_1 = tip.gathered(A_0), tip.gathered(A_1)
    return _Slopes(
        S=common_steps.rotated(
            build, "A_0", T, common_steps.local_matrix(build, "A_0_leg", A_0), "force at the tip by S"
        ),
        S_dot=common_steps.rotated(
            build, "A_1", T, common_steps.local_matrix(build, "A_1_leg", A_1), "force at the tip by S_dot"
        ),
        S_ddot=m,
        # Friction is symmetric: the force depends on omega as f depends on S_dot, with opposite sign.
        omega=-f_S_dot.T,
        f_S=f_S,
        f_S_dot=f_S_dot,
        force=by.force,
    )


def joint_slopes_kernel(rotor: Rotor) -> SumKernel:
    """Derive the derivatives of the wrench, with those along the rows of ``joint_rows_kernel`` separate.

    The derivative of the wrench is the sum of the ``summed`` outputs and of [row_v row_w]^T tau_by over the
    legs.
    """
    build = Builder()
    leg = common_steps.leg_of(build, rotor=rotor)
    q, turn, T = leg.at.q, skew(leg.at.q), leg.T
    _name_finite_motion(build, leg, turned=True)
    by = _torque_slopes(build, leg, near=True, net=NET.value)
    fall = T.T * build.vector("fall", common_steps.centripetal_acceleration(build, leg.at) - n.g.value)
    fall = n.m_u.value * build.vector(
        "fall_T",
        fall + common_steps.by_joints(leg.at) * TURNED.value,
        "",
        "m_u times the acceleration of the platform point relative to free fall, leg frame",
    )
    turning, bend = _turning_with_leg(fall, NET.value, tip.torques(True, rotor))
    S, S_dot, S_ddot = (
        build.matrix(
            name,
            common_steps.local_matrix(build, f"{name}_leg", tip.gathered(value)) * T.T,
            "",
            "derivatives of the generalized forces by the tip's motion",
        )
        for name, value in (
            ("tau_S", by.S + turning),
            ("tau_S_dot", by.S_dot),
            ("tau_S_ddot", by.inertia * tip.gradients().value + n.m_u.value * tip.of_tip().T),
        )
    )
    # Separate from the other terms of S: a term that cancels for AXIAL = 1 would leave a rounding error.
    bent = common_steps.local_matrix(build, "bent_leg", common_steps.by_joints(leg.at).T * bend)
    S = build.matrix(
        "tau_place",
        S + bent * T.T,
        "",
        "derivative of the generalized forces by the tip's position, with the rotation of the rows",
    )
    W, w_q = skew(n.omega.value), build.vector("w_q", cross(n.omega.value, q), "(4)", "omega x q")
    reach = build.matrix("X", S + S_dot * W + S_ddot * p.B.value)
    pace = build.matrix("Y", S_dot + S_ddot * W)
    zero = sp.zeros(3, 3)
    f_S, f_S_dot = _friction_slopes(build, leg, by.normal)
    by_omega = -n.C_s.value * sp.Matrix.vstack(sp.zeros(1, 3), leg.at.y.T, n.k.value.T)
    block = build.block(
        "joint_slopes_of_leg",
        "one leg's part of the derivatives of the wrench, and its generalized forces' derivatives",
        common_steps.LEG_INPUTS,
        [
            *((quantity, zero) for quantity in INERTIA),
            *zip(BY_POSE, (zero, zero, -f_S, (skew(by.force) + f_S + f_S_dot * W) * turn), strict=True),
            *zip(BY_TWIST, (zero, zero, -f_S_dot, f_S_dot * turn), strict=True),
            *zip(
                TAU_BY, (S, -reach * turn, S_dot, -pace * turn - S_ddot * skew(w_q) + by_omega), strict=True
            ),
            *common_steps.columns_of_H(leg.at),
            *common_steps.checked(leg.at),
        ],
    )
    pose = _derivatives_of_platform("joint_slopes", alone=True)
    return SumKernel("joint_slopes", (*INERTIA, *BY_POSE, *BY_TWIST), pose, block)


def _turning_with_leg(fall: sp.Matrix, net: sp.Matrix, forces: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Derive two effects of the leg's rotation on the derivatives by S.

    The first effect is the rotation of the generalized forces of a mass at the tip, the second the rotation
    of the rows. Near the joint singularity the leg frame rotates fast about the leg, so both are large. The
    transverse forces of a thin rod contribute equal and opposite parts. AXIAL = 0 omits these parts. AXIAL =
    1, for a leg with inertia about its own axis, keeps them, because ``net`` is then small although its terms
    are not.

    Parameters
    ----------
    fall : Matrix, shape (3, 1)
        Mass at the tip times its acceleration relative to free fall, leg frame (N).
    net : Matrix, shape (3, 1)
        Generalized forces less the actuator force.
    forces : Matrix, shape (3, 1)
        Result of ``tip.torques``.
    """
    rod = tip.of_rod(forces)
    across = (1 - AXIAL.value) * (tip.gradients().value.T * rod + fall)
    turning = tip.by_place_of_force(fall - sp.Matrix([0, across[1], across[2]]))
    apart = AXIAL.value * net + (1 - AXIAL.value) * (forces - rod).applyfunc(tip.gathered)
    return turning, _bend(sp.Matrix([net[0], apart[1], apart[2]]))
