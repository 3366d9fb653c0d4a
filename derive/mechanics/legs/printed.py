"""Leg of ``paper`` with regrouped constants in the leg frame: s.W = 0, and the constraint moment along s.

The printed rotation does not follow from joint coordinates, so Lagrange's equations do not apply. The printed
equations use the sums of constants in ``lumped_constants``.
"""

import sympy as sp

from ...program.block import Builder
from .. import lumped_constants as p
from .. import quantities as n
from ..formulation import Formulation
from .leg import axes, cross, leg_vector


def printed_leg(
    build: Builder, form: Formulation, friction: bool, near_singular: bool = False
) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr, sp.Expr, sp.Matrix, sp.Matrix]:
    """Derive q, s, L, k3, D, K, and f of the leg, (1)-(24), base frame.

    ``near_singular`` makes y perpendicular to s again, which is accurate near the joint singularity.
    """
    q, _, L, inv_L, s = leg_vector(build)
    y, z, k3 = _frame(build, s, near_singular)
    S_dot, S_ddot = p.tip_motion(build, q)

    def in_leg_frame(name: str, vector: sp.Matrix, equation: str, meaning: str) -> sp.Matrix:
        parts = sp.Matrix([axis.dot(vector) for axis in (s, y, z)])
        return build.vector(name, parts, equation, meaning)

    u = in_leg_frame("u", S_dot, "(4), (5)", "velocity of the platform point, leg frame; u_x is L_dot")
    e = in_leg_frame("e", S_ddot, "(7)", "acceleration of the platform point, leg frame")
    gamma = in_leg_frame("gamma", n.g.value, "", "gravity, leg frame")
    W, A = _rotation(build, inv_L, u, e)
    N, C = _forces(build, form, L, W, A, e, gamma)
    D, f = N[0], sp.zeros(3, 1)
    if friction:
        C_s, omega = n.C_s.value, n.omega.value
        C = [part + p.C_us.value * W[i] - C_s * (y, z)[i].dot(omega) for i, part in enumerate(C)]
        D += n.C_p.value * u[0]
        f = C_s * W[0] * y + C_s * W[1] * z
    C_y, C_z = (
        build.scalar(name, part, "(20)", "moment that the joint forces must balance")
        for name, part in zip(("C_y", "C_z"), C, strict=True)
    )
    K_y = build.scalar("K_y_leg", N[1] + inv_L * C_z, "(21)", "transverse force, leg frame")
    K_z = build.scalar("K_z_leg", N[2] - inv_L * C_y, "(21)", "transverse force, leg frame")
    K = build.vector("K", K_y * y + K_z * z, "(21)", "transverse force, base frame")
    return q, s, L, k3, build.scalar("D", D, "(24)", "known part of the actuator force"), K, f


def _frame(build: Builder, s: sp.Matrix, near_singular: bool) -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
    """Name y, z, and k3 of (10)."""
    normal = build.vector("k_cross_s", cross(n.k.value, s), "(10)", "normal to the fixed axis and the leg")
    if near_singular:
        y, z, k3, _ = axes(build, s, normal, "k3", "|k x s|")
        return y, z, k3
    k3 = build.scalar("k3", sp.sqrt(normal.dot(normal)), "(10)", "|k x s|")
    y = build.vector("y", normal * build.scalar("inv_k3", 1 / k3), "(10)", "second axis of the leg frame")
    return y, build.vector("z", cross(s, y), "(10)", "third axis of the leg frame"), k3


def _rotation(
    build: Builder, inv_L: sp.Expr, u: sp.Matrix, e: sp.Matrix
) -> tuple[tuple[sp.Expr, sp.Expr], tuple[sp.Expr, sp.Expr]]:
    """Name (W_y, W_z) of (6) and (A_y, A_z) of (9)."""
    meaning = "angular velocity of the leg, leg frame"
    W_y = build.scalar("W_y", -inv_L * u[2], "(6)", meaning)
    W_z = build.scalar("W_z", inv_L * u[1], "(6)", meaning)
    shrink = build.scalar("shrink", 2 * inv_L * u[0])
    meaning = "angular acceleration of the leg, leg frame"
    A_y = build.scalar("A_y", -inv_L * e[2] - shrink * W_y, "(9)", meaning)
    A_z = build.scalar("A_z", inv_L * e[1] - shrink * W_z, "(9)", meaning)
    return (W_y, W_z), (A_y, A_z)


def _forces(
    build: Builder,
    form: Formulation,
    L: sp.Expr,
    W: tuple[sp.Expr, sp.Expr],
    A: tuple[sp.Expr, sp.Expr],
    e: sp.Matrix,
    gamma: sp.Matrix,
) -> tuple[sp.Matrix, list[sp.Expr]]:
    """Name the force N that accelerates the upper part, and return (C_y, C_z) without friction."""
    (W_y, W_z), (A_y, A_z) = W, A
    yy, zz, yz = (
        build.scalar(name, product)
        for name, product in (("W_yy", W_y**2), ("W_zz", W_z**2), ("W_yz", W_y * W_z))
    )
    hx, hy, hz = p.h.value
    N = build.vector(
        "N",
        sp.Matrix(
            [
                hz * A_y - hy * A_z - hx * (yy + zz),
                hx * A_z - hy * zz + hz * yz,
                hy * yz - hx * A_y - hz * yy,
            ]
        ),
        "(14)",
        "force that accelerates the upper part about the platform point, leg frame",
    )
    turn = cross(p.h.value, e) - cross(p.w.value, gamma)
    J = p.J.value
    C_y = J[1, 1] * A_y + J[1, 2] * A_z + J[0, 1] * yz + J[0, 2] * zz + turn[1]
    C_z = J[1, 2] * A_y + J[2, 2] * A_z - J[0, 2] * yz - J[0, 1] * yy + turn[2]
    if form.transport_twice:
        double = build.scalar("m_L2_twice", p.m_L2.value * L * L, "(16)", "m_u L^2, counted twice")
        C_y, C_z = C_y + double * A_y, C_z + double * A_z
    return N, [C_y, C_z]
