"""Constants that are prepared once per robot, and the blocks that prepare them.

The inertia of a leg's lower part about the base point and of its upper part about the platform point add up
to one constant tensor J. The first moments h (upper part) and w (both parts) remain. The mass of the upper
parts is added to the platform as point masses at the spherical joints.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from ..program.block import Block, Builder, Quantity
from . import quantities as n
from .legs.leg import cross

# Prepared constants of one leg.
h = Quantity("h", (3,), "kg m", "first moment of the upper part about the platform point, leg frame")
h2_x = Quantity("h2_x", (), "kg m", "2 h_x")
h2_y = Quantity("h2_y", (), "kg m", "2 h_y")
h2_z = Quantity("h2_z", (), "kg m", "2 h_z")
w = Quantity("w", (3,), "kg m", "sum m_d r_d0 + m_u r_u0 of the first moments of both parts, leg frame")
J = Quantity(
    "J",
    (3, 3),
    "kg m^2",
    "sum of the inertias of the lower part about the base point and the upper part about the platform point, "
    "leg frame",
    True,
)
J2_xz = Quantity("J2_xz", (), "kg m^2", "2 J_xz")
dJ_zx = Quantity("dJ_zx", (), "kg m^2", "J_zz - J_xx")
g_k = Quantity("g_k", (), "m/s^2", "component of g along the fixed axis k")
g_x_k = Quantity("g_x_k", (3,), "m/s^2", "g x k, base frame")
C_us = Quantity("C_us", (), "N m s", "C_u + C_s")
m_L2 = Quantity("m_L2", (), "kg", "m_u, counted twice in (16)")
h_s = Quantity("h_s", (), "kg m", "first moment of the upper part about the platform point, along the leg")
w_s = Quantity("w_s", (), "kg m", "component of w along the leg")
J_s = Quantity("J_s", (), "kg m^2", "inertia of both parts about the axis of the leg")
J_t = Quantity("J_t", (), "kg m^2", "transverse inertia (J_yy + J_zz) / 2 of both parts")
J_m = Quantity(
    "J_m", (), "kg m^2", "inertia m_d r_d0_x^2 + m_u r_u0_x^2 of both parts as points on the axis of the leg"
)
J_ts = Quantity("J_ts", (), "kg m^2", "J_t - J_s")
LEG = (h, h2_x, h2_y, h2_z, w, J, J2_xz, dJ_zx, g_k, g_x_k, C_us, m_L2, h_s, w_s, J_s, J_t, J_m, J_ts)

COMBINED: dict[Quantity, sp.Expr] = {
    **{double: 2 * single for double, single in zip((h2_x, h2_y, h2_z), h.symbols, strict=True)},
    J2_xz: 2 * J.value[0, 2],
    dJ_zx: J.value[2, 2] - J.value[0, 0],
}
"""Constants that are combinations of h and J."""

# Contributions of one leg to the constants of the platform.
M_add = Quantity("M_add", (), "kg", "mass of the leg that is added to the platform")
h_add = Quantity(
    "h_add", (3,), "kg m", "first moment of the mass M_add about platform point 1, platform frame"
)
J_add = Quantity(
    "J_add", (3, 3), "kg m^2", "inertia of the mass M_add about platform point 1, platform frame", True
)
C_add = Quantity("C_add", (), "N m s", "friction of the leg's spherical joint")
ADDED = (M_add, h_add, J_add, C_add)

# Prepared constants of the platform.
M_P = Quantity("M_P", (), "kg", "M plus the masses m_u of all legs (massless legs: M)")
W_P = Quantity(
    "W_P",
    (3,),
    "N",
    "weight of the platform with the upper parts of the legs (massless legs: M g), base frame",
)
h_P = Quantity("h_P", (3,), "kg m", "first moment of the mass M_P about the reference point, platform frame")
J_P = Quantity(
    "J_P", (3, 3), "kg m^2", "inertia of the mass M_P about the reference point, platform frame", True
)
r_C = Quantity(
    "r_C",
    (3,),
    "m",
    "center of mass of M_P, with the masses m_u at the platform points (massless legs: R_0), platform frame",
)
J_C = Quantity("J_C", (3, 3), "kg m^2", "inertia of the mass M_P about r_C, platform frame", True)
dJ_C = Quantity("dJ_C", (3,), "kg m^2", "J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx")
C_P = Quantity("C_P", (), "N m s", "sum of C_s of all legs")

# Terms of the pose that the legs read.
B = Quantity("B", (3, 3), "1/s^2", "[alpha]x + [omega]x [omega]x: S_ddot = B q + a")
t_b = Quantity("t_b", (3,), "m", "reference point from base point, base frame")
q_1 = Quantity("q_1", (3,), "m", "platform point 1 from the reference point, base frame")
c_tip = Quantity("c_tip", (3,), "N m", "the platform's part of c, moment rows, about platform point 1")
arm_c = Quantity("arm_c", (3,), "N m", "moment of the leg's part of c, force rows, about platform point 1")


def point_inertia(mass: sp.Expr, at: sp.Matrix) -> sp.Matrix:
    """Compute the inertia of a point mass about the origin: m (r.r E - r r^T)."""
    return mass * (at.dot(at) * sp.eye(3) - at * at.T)


def differences(tensor: sp.Matrix) -> sp.Matrix:
    """Return the differences (zz - yy, xx - zz, yy - xx) of the diagonal."""
    xx, yy, zz = (tensor[i, i] for i in range(3))
    return sp.Matrix([zz - yy, xx - zz, yy - xx])


@dataclass(frozen=True)
class Lumped:
    """Contributions of a leg that are lumped with the platform.

    Attributes
    ----------
    mass : bool
        Mass of the upper part.
    friction : bool
        Friction of the spherical joint.
    """

    mass: bool
    friction: bool


NOTHING_LUMPED = Lumped(mass=False, friction=False)


def lumped(prepare: Block) -> Lumped:
    """Return the lumped contributions of the block that prepares a leg."""
    added = prepare.exprs
    return Lumped(mass=added[M_add][0] != 0, friction=added[C_add][0] != 0)


def prepare_leg(needed: Iterable[Quantity], lumped: Lumped) -> Block:
    """Prepare the constants in ``needed`` and the leg's contribution to the platform.

    Parameters
    ----------
    needed : iterable of Quantity
        Prepared or raw constants of a leg; other quantities are ignored.
    lumped : Lumped
        Contributions that are lumped with the platform.
    """
    build = Builder()
    raw = n.k.value
    size = build.scalar("k_size", sp.sqrt(raw.dot(raw)))
    k = build.vector("k_unit", raw * build.scalar("inv_k_size", 1 / size), "", "fixed axis, of length one")
    m_u, r_u = n.m_u.value, n.r_u0.value
    first = build.vector("h", m_u * r_u)
    both = build.vector("w", n.m_d.value * n.r_d0.value + first)
    tensor = build.tensor(
        "J",
        n.I_d0.value + n.I_u0.value + point_inertia(n.m_d.value, n.r_d0.value) + point_inertia(m_u, r_u),
    )
    values: dict[Quantity, sp.Expr | sp.Matrix] = {q: q.value for q in n.OF_LEG} | {
        h: first,
        w: both,
        J: tensor,
        **COMBINED,
        n.k: k,
        g_k: n.g.value.dot(k),
        g_x_k: cross(n.g.value, k),
        C_us: n.C_u.value + n.C_s.value,
        m_L2: m_u,
        **_axial(first, both, tensor),
    }
    mass = m_u if lumped.mass else sp.S.Zero
    # From platform point 1, because a distant reference point would reduce the accuracy.
    arm = build.vector("arm", n.p.value - n.p_1.value, "", "platform point from platform point 1")
    added = [
        (M_add, mass),
        (h_add, mass * arm),
        (J_add, point_inertia(mass, arm)),
        (C_add, n.C_s.value if lumped.friction else sp.S.Zero),
    ]
    return build.block(
        "prepare_leg",
        "constants of one leg, and its contributions to the constants of the platform",
        (*n.OF_LEG, n.p_1, n.g),
        [*((q, values[q]) for q in needed if q in values), *added],
    )


def _axial(first: sp.Matrix, both: sp.Matrix, tensor: sp.Matrix) -> dict[Quantity, sp.Expr]:
    """Return the constants of an axisymmetric leg."""
    across = sp.Rational(1, 2) * (tensor[1, 1] + tensor[2, 2])
    return {
        h_s: first[0],
        w_s: both[0],
        J_s: tensor[0, 0],
        J_t: across,
        J_m: n.m_d.value * n.r_d0.value[0] ** 2 + n.m_u.value * n.r_u0.value[0] ** 2,
        J_ts: across - tensor[0, 0],
    }


def prepare_platform(needed: Iterable[Quantity]) -> Block:
    """Prepare the platform's constants in ``needed`` from the robot's numbers and from sums over the legs."""
    build = Builder()
    M, R_0, h = n.M.value, n.R_0.value, h_add.value
    mass = build.scalar("M_P", M + M_add.value)
    arm = build.vector(
        "arm",
        R_0 - n.p_1.value,
        "",
        "center of mass of the platform without the upper parts, from platform point 1",
    )
    e = build.vector("e", h - M_add.value * arm, "", "first moment of the lumped masses about this center")
    # Each term is as accurate as its inputs. A difference of centers would cancel if either mass is small.
    first = build.vector(
        "h_P", M * R_0 + (h + M_add.value * n.p_1.value), "", "first moment about the reference point"
    )
    center = build.vector("r_C", first / mass)
    # The inertia about a fixed point less M_P r r would cancel if nothing is lumped.
    r = build.vector("r", h / mass)
    u = build.vector("u", M / mass * (h + e) / 2)
    tensor = build.tensor(
        "J_C",
        n.I_p.value
        + J_add.value
        - (2 * arm.dot(u) * sp.eye(3) - arm * u.T - u * arm.T)
        - (h.dot(r) * sp.eye(3) - h * r.T),
    )
    values: dict[Quantity, sp.Expr | sp.Matrix] = {q: q.value for q in n.PLATFORM} | {
        M_P: mass,
        W_P: mass * n.g.value,
        r_C: center,
        J_C: tensor,
        dJ_C: differences(tensor),
        h_P: first,
        J_P: tensor + point_inertia(mass, center),
        C_P: C_add.value,
    }
    return build.block(
        "prepare_platform",
        "constants of the platform",
        (*n.PLATFORM, n.p_1, *ADDED),
        [(q, values[q]) for q in needed if q in values],
    )


def tip_motion(build: Builder, q: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Name S_dot (4) and S_ddot (7), base frame."""
    S_dot = build.vector(
        "S_dot", cross(n.omega.value, q) + n.v.value, "(4)", "velocity of the platform point"
    )
    S_ddot = build.vector("S_ddot", B.value * q + n.a.value, "(7)", "acceleration of the platform point")
    return S_dot, S_ddot
