"""Leg of ``exact`` whose joint axes do not intersect, in joint coordinates, by Lagrange's equations.

The chain from the base point is: phi about k, the offset a along o = y x k, theta about y, the offsets e
along y and d along z, the length L along s. The tip is at S = r o + e y + zeta k with r = a + k3 L - k1 d and
zeta = k1 L + k3 d. From S this gives r, L, k1, and k3 in closed form; the solution with r > 0 and L > 0 is
used. The inertial constants enter as in ``joint_coordinates``, and the offsets change them once per robot.
"""

from dataclasses import dataclass, replace

import sympy as sp

from ...program.block import Builder, Quantity
from .. import lumped_constants as p
from .. import quantities as n
from .joint_coordinates import (
    JointAccelerations,
    JointForces,
    JointFrame,
    JointInertia,
    JointRates,
    joint_forces,
    joint_inertia,
    with_products,
)
from .leg import cross, tip_vector
from .rotor import FULL

# Constants of one leg in addition to ``quantities.LEG``.
a = Quantity("cross", (), "m", "offset from the fixed to the moving axis, along o = y x k")
e = Quantity("along", (), "m", "offset along y from o to the line of sliding")
d = Quantity("across", (), "m", "offset from the moving axis to the line of sliding, along z = s x y")
m_c = Quantity("cross_mass", (), "kg", "mass of the body between fixed and moving axis")
r_c = Quantity(
    "cross_center", (3,), "m", "center of mass of this body from the base point, along o, y, and k"
)
I_c = Quantity("cross_inertia", (), "kg m^2", "inertia of this body about its center of mass, axis k")
RAW = (a, e, d, m_c, r_c, I_c)

# Prepared constants.
d2 = Quantity("across2", (), "m^2", "across^2")
e2 = Quantity("along2", (), "m^2", "along^2")
a2 = Quantity("cross2", (), "m", "2 cross")
w_o = Quantity("w_o", (), "kg m", "first moment along o of the bodies that rotate about k only")
PREPARED = (a, e, d, d2, e2, a2, w_o)


@dataclass(frozen=True)
class OffsetFrame:
    """Geometry of a leg with offset joints, base frame.

    Attributes
    ----------
    at : JointFrame
        Leg frame with z; ``at.inv_rho`` is 1 / r.
    S : Matrix, shape (3, 1)
        Vector from the base point to the platform point (m).
    o : Matrix, shape (3, 1)
        Unit vector from the fixed axis toward the platform.
    r : Expr
        Distance of the tip from the fixed axis along o (m).
    sine : Expr
        (r / L) (r / rho)^2, by which the leg is checked for the joint singularity; rho = |k x S|.
    column : Matrix, shape (3, 1)
        Force rows of the leg's column of H: the gradient of L by S.
    """

    at: JointFrame
    S: sp.Matrix
    o: sp.Matrix
    r: sp.Expr
    sine: sp.Expr
    column: sp.Matrix


def offset_frame(build: Builder) -> OffsetFrame:
    """Name the geometry of a leg with offsets, (1)-(3) and (10)."""
    k = n.k.value
    q, S = tip_vector(build)
    meaning = "leg vector: component along the fixed axis, normal to both, and part across the fixed axis"
    zeta = build.scalar("zeta", k.dot(S), "(10)", meaning)
    normal = build.vector("k_cross_S", cross(k, S), "(10)", meaning)
    beside = build.vector("S_across", S - zeta * k, "(10)", meaning)
    rho2 = build.scalar("rho2", normal.dot(normal))
    r = build.scalar("r", sp.sqrt(rho2 - e2.value), "(10)", "distance of the tip from the fixed axis along o")
    inv_rho2 = build.scalar("inv_rho2", 1 / rho2)
    share, along = (
        build.scalar(name, expr)
        for name, expr in (("r_share", r * inv_rho2), ("e_share", e.value * inv_rho2))
    )
    y = build.vector("y", share * normal + along * beside, "(10)", "moving axis of the universal joint")
    o = build.vector("o", cross(y, k), "(10)", "from the fixed axis toward the platform")
    out = build.scalar(
        "r_out", r - a.value, "", "distance of the tip from the moving axis: along o, and squared"
    )
    reach2 = build.scalar("reach2", out**2 + zeta**2)
    L = build.scalar("L", sp.sqrt(reach2 - d2.value), "(2)", "leg length")
    inv_L, inv_r = build.scalar("inv_L", 1 / L), build.scalar("inv_r", 1 / r)
    inv_reach2 = build.scalar("inv_reach2", 1 / reach2)
    meaning = "k = (k1, 0, k3) in the leg frame"
    k1 = build.scalar("k1", (L * zeta - d.value * out) * inv_reach2, "(10)", meaning)
    k3 = build.scalar("k3", (d.value * zeta + L * out) * inv_reach2, "(10)", meaning)
    s = build.vector("s", k1 * k + k3 * o, "(3)", "unit vector along the line of sliding")
    z = build.vector("z", k3 * k - k1 * o, "(10)", "third axis of the leg frame")
    meaning = "gradient of L by the tip: the leg's column of H"
    h_z = build.scalar("column_of_z", d.value * inv_L)
    h_y = build.scalar("column_of_y", e.value * (k3 - k1 * h_z) * inv_r)
    column = build.vector("column", s + h_y * y + h_z * z, "(22)", meaning)
    at = JointFrame(q, s, y, L, inv_L, inv_rho=inv_r, k1=k1, k3=k3, kappa=sp.S.Zero, z=z, rotor=FULL)
    meaning = "r / L, scaled by (r / rho)^2 because the rounding error of r grows near the least distance"
    sine = build.scalar("sine", r * inv_L * (r * share), "(10)", meaning)
    return OffsetFrame(at, S, o, r, sine, column)


def offset_rates(build: Builder, leg: OffsetFrame, S_dot: sp.Matrix) -> tuple[JointRates, sp.Expr]:
    """Name the rates of the joint coordinates, (5), (6), and the rate of r."""
    at, meaning = leg.at, "rates of the joint coordinates: L, phi about k, theta about y"
    assert at.z is not None
    phi_dot = build.scalar("phi_dot", at.inv_rho * at.y.dot(S_dot), "(6)", meaning)
    swept = build.scalar("e_phi_dot", e.value * phi_dot)
    theta_dot = build.scalar("theta_dot", at.inv_L * (at.k1 * swept - at.z.dot(S_dot)), "(6)", meaning)
    L_dot = build.scalar("L_dot", at.s.dot(S_dot) - d.value * theta_dot + at.k3 * swept, "(5)", meaning)
    r_dot = build.scalar("r_dot", leg.o.dot(S_dot) + swept, "", "rate of r")
    return with_products(build, L_dot, theta_dot, phi_dot), r_dot


def offset_accelerations(
    build: Builder, leg: OffsetFrame, rates: JointRates, r_dot: sp.Expr, S_ddot: sp.Matrix
) -> JointAccelerations:
    """Name the accelerations of the joint coordinates, (8), (9)."""
    at, meaning = leg.at, "accelerations of the joint coordinates"
    assert at.z is not None
    about_k = at.y.dot(S_ddot) - rates.phi_twice * r_dot + e.value * rates.phi2
    phi_ddot = build.scalar("phi_ddot", at.inv_rho * about_k, "(9)", meaning)
    turning = build.scalar(
        "turning", leg.r * rates.phi2 + e.value * phi_ddot, "", "part of r_ddot by phi only"
    )
    across = at.k1 * turning - at.z.dot(S_ddot) - 2 * rates.L * rates.theta - d.value * rates.theta2
    theta_ddot = build.scalar("theta_ddot", at.inv_L * across, "(9)", meaning)
    along = at.s.dot(S_ddot) + at.k3 * turning - d.value * theta_ddot + at.L * rates.theta2
    return JointAccelerations(build.scalar("L_ddot", along, "(8)", meaning), theta_ddot, phi_ddot)


def offset_inertia(build: Builder, at: JointFrame) -> JointInertia:
    """Name the mass matrix of the joint coordinates, (19), with the offset terms that vary with the pose."""
    m = joint_inertia(build, at)
    wx, _, wz = p.w.value
    hx, _, hz = p.h.value
    w_k, w_n = build.scalar("w_k", at.k1 * wx + at.k3 * wz), build.scalar("w_n", at.k3 * wx - at.k1 * wz)
    h_k, h_n = build.scalar("h_k", at.k1 * hx + at.k3 * hz), build.scalar("h_n", at.k3 * hx - at.k1 * hz)
    return replace(
        m,
        phi=build.scalar("M_phi_offset", m.phi + a2.value * w_n),
        phi_by_theta=build.scalar("M_phi_theta_offset", m.phi_by_theta + a.value * w_k),
        mixed=build.scalar("M_mixed_offset", m.mixed - e.value * h_k),
        mixed_by_theta=build.scalar("M_mixed_theta_offset", m.mixed_by_theta + e.value * h_n),
    )


def offset_forces(
    build: Builder, at: JointFrame, rates: JointRates, accelerations: JointAccelerations
) -> JointForces:
    """Derive Lagrange's equations of the leg, (17)-(20), (23)."""
    found = joint_forces(build, at, rates, accelerations, inertia=offset_inertia(build, at))
    weight = w_o.value * at.y.dot(n.g.value)
    return replace(found, about_k=build.scalar("tau_k_offset", found.about_k - weight, "(20)"))


def offset_tip_force(build: Builder, at: JointFrame, forces: JointForces) -> tuple[sp.Expr, sp.Matrix]:
    """Name D and K at the platform joint, (21), (24), base frame; K has no component along s."""
    assert at.z is not None
    meaning = "K = Q_y y + Q_z z"
    Q_z = build.scalar("Q_z", -at.inv_L * forces.about_y, "(21)", meaning)
    about_k = forces.about_k - e.value * at.k1 * Q_z
    Q_y = build.scalar("Q_y", at.inv_rho * about_k, "(21)", meaning)
    K = build.vector("K", Q_y * at.y + Q_z * at.z, "(21)", "force at the platform joint, base frame")
    return build.scalar("D", forces.along, "(24)", "known part of the actuator force"), K
