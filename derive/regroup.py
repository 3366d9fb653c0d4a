"""Regrouping: the actuator forces alone, from fewer operations. Stands beside ``kernels``.

Three changes leave the forces as they are. Constants that enter together are prepared once per robot: of a
leg, the inertia of the lower part about the base point and of the upper part about the platform point add up
to one constant tensor J, and the first moments h (upper part) and w (both parts) remain. The mass of an
upper part rides on the platform as a point at the spherical joint. And the force K on the leg may carry any
part along s, since x takes up the rest: F = D - x with D changed to match.

``exact`` legs are written in the coordinates of their joints: phi about the fixed axis k, theta about y with
k = (cos theta, 0, sin theta) in the leg frame, and L; the generalised forces are Lagrange's. `paper` legs,
whose printed rotation comes from no coordinates, are written in the leg frame. The tests prove both equal to
the elimination. Knows nothing of sharing or printing.
"""

from dataclasses import dataclass

import sympy as sp

from . import notation as n
from .block import Block, Builder, Quantity
from .formulation import SPHERICAL, Formulation
from .kernels import leg_block
from .leg import cross, leg_vector
from .platform import LegShare, platform

HALF = sp.Rational(1, 2)

# Prepared constants of one leg.
h = Quantity("h", (3,), "kg m", "first moment of the upper part about the platform point, leg frame")
h2_x = Quantity("h2_x", (), "kg m", "2 h_x")
h2_z = Quantity("h2_z", (), "kg m", "2 h_z")
w = Quantity(
    "w", (3,), "kg m", "first moments of both parts, about the base and the platform point, leg frame"
)
J = Quantity("J", (3, 3), "kg m^2", "inertias of the parts about base and platform point, leg frame", True)
dJ = Quantity("dJ", (3,), "kg m^2", "J_zz - J_yy, J_xx - J_zz, J_yy - J_xx")
J2_xz = Quantity("J2_xz", (), "kg m^2", "2 J_xz")
dJ_zx = Quantity("dJ_zx", (), "kg m^2", "J_zz - J_xx")
g_k = Quantity("g_k", (), "m/s^2", "gravity along the fixed axis")
g_x_k = Quantity("g_x_k", (3,), "m/s^2", "g x k, base frame")
C_us = Quantity("C_us", (), "N m s", "C_u + C_s")
m_L2 = Quantity("m_L2", (), "kg", "m_u, which (16) counts twice")
LEG = (n.b, n.p, n.k, h, h2_x, h2_z, w, J, dJ, J2_xz, dJ_zx, g_k, g_x_k, C_us, n.C_p, n.C_s, m_L2)

# What one leg hands to the platform's constants.
M_add = Quantity("M_add", (), "kg", "mass that rides on the platform")
h_add = Quantity("h_add", (3,), "kg m", "its first moment, platform frame")
J_add = Quantity("J_add", (3, 3), "kg m^2", "its inertia about the reference point, platform frame", True)
C_add = Quantity("C_add", (), "N m s", "friction of the leg's spherical joint")
ADDED = (M_add, h_add, J_add, C_add)

# Prepared constants of the platform.
M_P = Quantity("M_P", (), "kg", "mass of the platform with the upper parts")
h_P = Quantity("h_P", (3,), "kg m", "its first moment, platform frame")
J_P = Quantity("J_P", (3, 3), "kg m^2", "its inertia about the reference point, platform frame", True)
dJ_P = Quantity("dJ_P", (3,), "kg m^2", "J_P_zz - J_P_yy, J_P_xx - J_P_zz, J_P_yy - J_P_xx")
C_P = Quantity("C_P", (), "N m s", "friction of all spherical joints")
PLATFORM = (M_P, h_P, J_P, dJ_P, C_P, n.g)

# What the pose hands to the legs.
Bm = Quantity("B", (3, 3), "1/s^2", "[alpha]x + [omega]x [omega]x: S_ddot = B q + a")


@dataclass(frozen=True)
class ForceKernel:
    """The blocks from which the actuator forces are computed.

    prepare_leg, prepare_platform: constants, once per robot; shared: what the pose has for all legs, with the
    platform's part of c; leg: D, a column of H and a part of c of one leg.
    """

    formulation: Formulation
    friction: bool
    prepare_leg: Block
    prepare_platform: Block
    shared: Block
    leg: Block


def force_kernel(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive the regrouped blocks of a formulation."""
    _, share = platform()
    if form.base_joint == SPHERICAL:
        leg = _plain_leg(form, share, friction)
    else:
        leg = _leg_in_joint_coordinates(friction) if not form.no_spin else _leg_in_its_frame(form, friction)
    riding = form.base_joint != SPHERICAL
    return ForceKernel(
        form,
        friction,
        prepare_leg(leg, riding, friction),
        prepare_platform(),
        shared(friction and riding),
        leg,
    )


# ---------------------------------------------------------------- constants


def point_inertia(mass: sp.Expr, r: sp.Matrix) -> sp.Matrix:
    """Inertia of a point mass about the origin: m (r.r E - r r^T)."""
    return mass * (r.dot(r) * sp.eye(3) - r * r.T)


def prepare_leg(leg: Block, riding: bool, friction: bool) -> Block:
    """The constants that ``leg`` reads, and what the leg adds to the platform, from the robot's numbers.

    riding: whether the upper part's mass rides on the platform.
    """
    build = Builder()
    m_u, r_u = n.m_u.value, n.r_u0.value
    first = build.vector("h", m_u * r_u)
    both = build.vector("w", n.m_d.value * n.r_d0.value + first)
    tensor = build.tensor(
        "J",
        n.I_d0.value + n.I_u0.value + point_inertia(n.m_d.value, n.r_d0.value) + point_inertia(m_u, r_u),
    )
    values: dict[Quantity, sp.Expr | sp.Matrix] = {
        h: first,
        h2_x: 2 * first[0],
        h2_z: 2 * first[2],
        w: both,
        J: tensor,
        dJ: differences(tensor),
        J2_xz: 2 * tensor[0, 2],
        dJ_zx: tensor[2, 2] - tensor[0, 0],
        g_k: n.g.value.dot(n.k.value),
        g_x_k: cross(n.g.value, n.k.value),
        C_us: n.C_u.value + n.C_s.value,
        m_L2: m_u,
    }
    mass = m_u if riding else sp.S.Zero
    added = [
        (M_add, mass),
        (h_add, mass * n.p.value),
        (J_add, point_inertia(mass, n.p.value)),
        (C_add, n.C_s.value if riding and friction else sp.S.Zero),
    ]
    outputs = [(q, values.get(q, q.value)) for q in leg.inputs if q not in (*n.MOTION, Bm, n.g)]
    return build.block(
        "prepare_leg",
        "constants of one leg, and what it adds to the platform",
        (*n.LEG, n.g),
        [*outputs, *added],
    )


def differences(tensor: sp.Matrix) -> sp.Matrix:
    """(zz - yy, xx - zz, yy - xx)."""
    xx, yy, zz = (tensor[i, i] for i in range(3))
    return sp.Matrix([zz - yy, xx - zz, yy - xx])


def prepare_platform() -> Block:
    """Constants of the platform with what the legs add, from the robot's numbers and sums over the legs."""
    build = Builder()
    M, R_0 = n.M.value, n.R_0.value
    tensor = build.tensor("J_P", n.I_p.value + point_inertia(M, R_0) + J_add.value)
    outputs = [
        (M_P, M + M_add.value),
        (h_P, M * R_0 + h_add.value),
        (J_P, tensor),
        (dJ_P, differences(tensor)),
        (C_P, C_add.value),
        (n.g, n.g.value),
    ]
    return build.block("prepare_platform", "constants of the platform", (*n.PLATFORM, *ADDED), outputs)


# ---------------------------------------------------------------- pose and platform


def rotary(build: Builder, omega: sp.Matrix, alpha: sp.Matrix) -> sp.Matrix:
    """B = [alpha]x + [omega]x [omega]x, named entry by entry."""
    square = {
        (i, j): build.scalar(f"omega_{'xyz'[i]}{'xyz'[j]}", omega[i] * omega[j], "", "products of omega")
        for i in range(3)
        for j in range(i, 3)
    }
    turn = sp.Matrix([[0, -alpha[2], alpha[1]], [alpha[2], 0, -alpha[0]], [-alpha[1], alpha[0], 0]])

    def entry(i: int, j: int) -> sp.Expr:
        if i != j:
            return square[min(i, j), max(i, j)] + turn[i, j]
        return -sum(square[m, m] for m in range(3) if m != i)

    return sp.Matrix(
        3, 3, lambda i, j: build.scalar(f"B_{'xyz'[i]}{'xyz'[j]}", entry(i, j), "(7)", "S_ddot = B q + a")
    )


def euler(build: Builder, inertia: sp.Matrix, d: sp.Matrix, omega: sp.Matrix, alpha: sp.Matrix) -> sp.Matrix:
    """I alpha + omega x I omega, with the products of omega shared and the differences d prepared."""
    x, y, z = omega
    xy, xz, yz = (build.scalar(name, e) for name, e in (("P_xy", x * y), ("P_xz", x * z), ("P_yz", y * z)))
    xx, yy, zz = (build.scalar(name, e) for name, e in (("P_xx", x * x), ("P_yy", y * y), ("P_zz", z * z)))
    return sp.Matrix(
        [
            inertia[0, 0] * alpha[0]
            + inertia[0, 1] * (alpha[1] - xz)
            + inertia[0, 2] * (alpha[2] + xy)
            + d[0] * yz
            + inertia[1, 2] * (yy - zz),
            inertia[0, 1] * (alpha[0] + yz)
            + inertia[1, 1] * alpha[1]
            + inertia[1, 2] * (alpha[2] - xy)
            + d[1] * xz
            + inertia[0, 2] * (zz - xx),
            inertia[0, 2] * (alpha[0] - yz)
            + inertia[1, 2] * (alpha[1] + xz)
            + inertia[2, 2] * alpha[2]
            + d[2] * xy
            + inertia[0, 1] * (xx - yy),
        ]
    )


def shared(friction: bool) -> Block:
    """What a pose has for all legs: B, and the platform's part of c, (30)-(35)."""
    build = Builder()
    R, omega, alpha = n.R.value, n.omega.value, n.alpha.value
    turn = rotary(build, omega, alpha)
    moment_arm = build.vector("h_base", R * h_P.value, "(30)", "first moment of the platform, base frame")
    fall = build.vector("fall", n.g.value - n.a.value, "(33)", "g - a")
    force = R * n.F_ext.value + M_P.value * fall - turn * moment_arm
    omega_P = build.vector("omega_P", R.T * omega, "", "angular velocity, platform frame")
    alpha_P = build.vector("alpha_P", R.T * alpha, "", "angular acceleration, platform frame")
    load = build.vector(
        "M_P_load",
        n.M_ext.value - euler(build, J_P.value, dJ_P.value, omega_P, alpha_P),
        "(34)",
        "external moment less I alpha + omega x I omega, platform frame",
    )
    moment = cross(moment_arm, fall) + R * load
    if friction:
        moment -= C_P.value * omega
    return build.block(
        "shared_terms",
        "B and the platform's part of c, (7), (30)-(35)",
        (*n.MOTION, *PLATFORM),
        [(Bm, turn), (n.c_force, force), (n.c_moment, moment)],
    )


# ---------------------------------------------------------------- legs


def _outputs(
    q: sp.Matrix, s: sp.Matrix, L: sp.Expr, k3: sp.Expr | None, D: sp.Expr, K: sp.Matrix, f: sp.Matrix
) -> list[tuple[Quantity, sp.Expr | sp.Matrix]]:
    return [
        (n.q, q),
        (n.L, L),
        *([] if k3 is None else [(n.k3, k3)]),
        (n.D, D),
        (n.H_force, s),
        (n.H_moment, cross(q, s)),
        (n.c_force, -K),
        (n.c_moment, f - cross(q, K)),
    ]


def _plain_leg(form: Formulation, share: LegShare, friction: bool) -> Block:
    """The leg as ``kernels`` has it, without the outputs that the forces do not need."""
    leg = leg_block(form, share, friction)
    kept = tuple(out for out in leg.outputs if out.quantity != n.K)
    return Block(leg.name, leg.meaning, leg.inputs, leg.steps, kept)


def _tip_motion(build: Builder, q: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """S_dot and S_ddot, (4) and (7), with B shared by all legs."""
    S_dot = build.vector(
        "S_dot", cross(n.omega.value, q) + n.v.value, "(4)", "velocity of the platform point"
    )
    S_ddot = build.vector("S_ddot", Bm.value * q + n.a.value, "(7)", "acceleration of the platform point")
    return S_dot, S_ddot


def _leg_in_joint_coordinates(friction: bool) -> Block:
    build = Builder()
    hx, hy, hz = h.value
    q, s, normal, L, inv_L, inv_rho = _leg_vector_about_axis(build)
    k = n.k.value
    k1, k3, kappa = sp.symbols("k1 k3 kappa", real=True)
    inv_rho2 = build.scalar("inv_rho2", inv_rho * inv_rho)
    S_dot, S_ddot = _tip_motion(build, q)

    rates = "rates of the joint coordinates: L, phi about k, theta about y"
    L_dot = build.scalar("L_dot", s.dot(S_dot), "(5)", rates)
    phi_dot = build.scalar("phi_dot", inv_rho2 * normal.dot(S_dot), "(6)", rates)
    theta_dot = build.scalar("theta_dot", inv_rho * (k1 * L_dot - k.dot(S_dot)), "(6)", rates)
    theta2 = build.scalar("theta_dot2", theta_dot**2)
    phi2 = build.scalar("phi_dot2", phi_dot**2)
    k33 = build.scalar("k33", k3**2)
    k13 = build.scalar("k13", k1 * k3)
    twice = build.scalar("two_L_dot", 2 * L_dot)
    shrink = build.scalar("shrink", inv_L * twice)
    lean = build.scalar("lean", kappa * theta_dot)
    carry = build.scalar("carry", shrink + lean)
    rates = "accelerations of the joint coordinates"
    L_ddot = build.scalar("L_ddot", s.dot(S_ddot) + L * (theta2 + k33 * phi2), "(8)", rates)
    theta_ddot = build.scalar(
        "theta_ddot", inv_rho * (k1 * L_ddot - k.dot(S_ddot)) - theta_dot * carry, "(9)", rates
    )
    phi_ddot = build.scalar(
        "phi_ddot", inv_rho2 * normal.dot(S_ddot) - phi_dot * (carry + lean), "(9)", rates
    )

    inertia = "inertia of the joint coordinates"
    Lh = build.scalar("L_h2", L * h2_x.value)
    a1 = build.scalar("a1", dJ_zx.value + Lh)
    a2 = build.scalar("a2", J2_xz.value - L * h2_z.value)
    Jv = J.value
    M_phi = build.scalar("M_phi", Jv[0, 0] + k33 * a1 + k13 * a2, "(19)", inertia)
    M_theta = build.scalar("M_theta", Jv[1, 1] + Lh, "(19)", inertia)
    a3 = build.scalar("a3", Jv[0, 1] - L * hy)
    M_mixed = build.scalar("M_mixed", k1 * a3 + k3 * Jv[1, 2], "(19)", inertia)
    k3h = build.scalar("k3_h", k3 * hy)
    k1h = build.scalar("k1_h", k1 * hy)
    slopes = "slopes of M_phi / 2 along theta and L, of M_mixed along theta"
    slope = build.scalar("M_phi_theta", k13 * a1 + a2 * (HALF - k33), "(19)", slopes)
    slope_L = build.scalar("M_phi_L", k33 * hx - k13 * hz, "(19)", slopes)
    mixed = build.scalar("M_mixed_theta", k1 * Jv[1, 2] - k3 * a3, "(19)", slopes)

    gamma_n = build.scalar(
        "gamma_n", inv_rho * normal.dot(g_x_k.value), "", "gravity along k x y and along y"
    )
    gamma_y = build.scalar("gamma_y", inv_rho * normal.dot(n.g.value), "", "gravity along k x y and along y")
    wx, wy, wz = w.value
    w_k = build.scalar("w_k", k1 * wx + k3 * wz, "", "first moment along k and against k x y")
    w_n = build.scalar("w_n", k3 * wx - k1 * wz, "", "first moment along k and against k x y")
    bend = build.scalar("bend", twice * theta_dot)
    torque = "generalised forces about y and about k"
    about_y = (
        hz * L_ddot
        + M_theta * theta_ddot
        + M_mixed * phi_ddot
        + hx * bend
        - slope * phi2
        + w_n * g_k.value
        + w_k * gamma_n
    )
    about_k = (
        M_mixed * theta_ddot
        + M_phi * phi_ddot
        - k3h * L_ddot
        + mixed * theta2
        - k1h * bend
        + 2 * phi_dot * (slope_L * L_dot + slope * theta_dot)
        - wy * gamma_n
        - w_n * gamma_y
    )
    along = hz * theta_ddot - k3h * phi_ddot - hx * theta2 - slope_L * phi2
    f = sp.zeros(3, 1)
    if friction:
        C_s = n.C_s.value
        about_y += C_us.value * theta_dot - C_s * inv_rho * normal.dot(n.omega.value)
        about_k += C_us.value * phi_dot - C_s * k.dot(n.omega.value)
        along += n.C_p.value * L_dot
        f = C_s * phi_dot * k + C_s * theta_dot * inv_rho * normal
    tau_y = build.scalar("tau_y", about_y, "(20)", torque)
    tau_k = build.scalar("tau_k", about_k, "(20)", torque)
    Q_k = build.scalar("Q_k", -inv_rho * tau_y, "(21)", "K = Q_k k + Q_n (k x S), up to a part along s")
    Q_n = build.scalar("Q_n", inv_rho2 * tau_k, "(21)", "K = Q_k k + Q_n (k x S), up to a part along s")
    K = build.vector("K", Q_k * k + Q_n * normal, "(21)", "force at the spherical joint, base frame")
    D = build.scalar("D", along - k1 * Q_k, "(24)", "known part of the actuator force, to match")
    return build.block(
        "leg_terms_of",
        "one leg in joint coordinates: D, its column of H and its part of c",
        (*LEG, *n.MOTION, Bm, n.g),
        _outputs(q, s, L, k3, D, K, f),
    )


def _leg_vector_about_axis(
    build: Builder,
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Expr, sp.Expr, sp.Expr]:
    """q, s, k x S, L, 1/L, 1/|k x S|; names k1, k3 and kappa on the way."""
    k = n.k.value
    q = build.vector("q", n.R.value * n.p.value, "(1)", "platform point from the reference point")
    S = build.vector("S", q + n.t.value - n.b.value, "(1)", "leg vector")
    zeta = build.scalar("zeta", k.dot(S), "(10)", "leg vector along the fixed axis, and normal to both")
    normal = build.vector(
        "k_cross_S", cross(k, S), "(10)", "leg vector along the fixed axis, and normal to both"
    )
    rho2 = build.scalar("rho2", normal.dot(normal))
    L = build.scalar("L", sp.sqrt(rho2 + zeta**2), "(2)", "leg length, and distance of its tip from the axis")
    rho = build.scalar("rho", sp.sqrt(rho2), "(2)", "leg length, and distance of its tip from the axis")
    inv_L = build.scalar("inv_L", 1 / L)
    inv_rho = build.scalar("inv_rho", 1 / rho)
    s = build.vector("s", S * inv_L, "(3)", "unit vector along the leg")
    build.scalar("k1", zeta * inv_L, "(10)", "k = (k1, 0, k3) in the leg frame")
    build.scalar("k3", rho * inv_L, "(10)", "k = (k1, 0, k3) in the leg frame")
    build.scalar("kappa", zeta * inv_rho, "(10)", "k1 / k3")
    return q, s, normal, L, inv_L, inv_rho


def _leg_in_its_frame(form: Formulation, friction: bool) -> Block:
    """The printed leg: s.W = 0, moment along s, transport counted twice if the formulation says so."""
    build = Builder()
    q, _, L, inv_L, s = leg_vector(build)
    k = n.k.value
    normal = build.vector("k_cross_s", cross(k, s), "(10)", "normal to the fixed axis and the leg")
    k3 = build.scalar("k3", sp.sqrt(normal.dot(normal)), "(10)", "|k x s|")
    y = build.vector("y", normal * build.scalar("inv_k3", 1 / k3), "(10)", "second axis of the leg frame")
    z = build.vector("z", cross(s, y), "(10)", "third axis of the leg frame")
    S_dot, S_ddot = _tip_motion(build, q)

    def in_leg_frame(name: str, vector: sp.Matrix, equation: str, meaning: str) -> sp.Matrix:
        parts = sp.Matrix([axis.dot(vector) for axis in (s, y, z)])
        return build.vector(name, parts, equation, meaning)

    u = in_leg_frame("u", S_dot, "(4), (5)", "velocity of the platform point, leg frame; u_x is L_dot")
    e = in_leg_frame("e", S_ddot, "(7)", "acceleration of the platform point, leg frame")
    gamma = in_leg_frame("gamma", n.g.value, "", "gravity, leg frame")
    spin = "angular velocity of the leg, leg frame"
    W_y = build.scalar("W_y", -inv_L * u[2], "(6)", spin)
    W_z = build.scalar("W_z", inv_L * u[1], "(6)", spin)
    shrink = build.scalar("shrink", 2 * inv_L * u[0])
    spin = "angular acceleration of the leg, leg frame"
    A_y = build.scalar("A_y", -inv_L * e[2] - shrink * W_y, "(9)", spin)
    A_z = build.scalar("A_z", inv_L * e[1] - shrink * W_z, "(9)", spin)
    yy, zz, yz = (
        build.scalar(name, p) for name, p in (("W_yy", W_y**2), ("W_zz", W_z**2), ("W_yz", W_y * W_z))
    )
    hx, hy, hz = h.value
    tip = "force that moves the upper part about the platform point, leg frame"
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
        tip,
    )
    turn = cross(h.value, e) - cross(w.value, gamma)
    Jv = J.value
    C_y = Jv[1, 1] * A_y + Jv[1, 2] * A_z + Jv[0, 1] * yz + Jv[0, 2] * zz + turn[1]
    C_z = Jv[1, 2] * A_y + Jv[2, 2] * A_z - Jv[0, 2] * yz - Jv[0, 1] * yy + turn[2]
    if form.transport_twice:
        double = build.scalar("m_L2_twice", m_L2.value * L * L, "(16)", "m_u L^2, counted twice")
        C_y, C_z = C_y + double * A_y, C_z + double * A_z
    D, f = N[0], sp.zeros(3, 1)
    if friction:
        C_s, omega = n.C_s.value, n.omega.value
        C_y += C_us.value * W_y - C_s * y.dot(omega)
        C_z += C_us.value * W_z - C_s * z.dot(omega)
        D += n.C_p.value * u[0]
        f = C_s * W_y * y + C_s * W_z * z
    C_y = build.scalar("C_y", C_y, "(20)", "moment that the joints' forces must make")
    C_z = build.scalar("C_z", C_z, "(20)", "moment that the joints' forces must make")
    K_y = build.scalar("K_y_leg", N[1] + inv_L * C_z, "(21)", "transverse force, leg frame")
    K_z = build.scalar("K_z_leg", N[2] - inv_L * C_y, "(21)", "transverse force, leg frame")
    K = build.vector("K", K_y * y + K_z * z, "(21)", "transverse force, base frame")
    return build.block(
        "leg_terms_of",
        "one leg in its frame: D, its column of H and its part of c",
        (*LEG, *n.MOTION, Bm, n.g),
        _outputs(q, s, L, k3, build.scalar("D", D, "(24)", "known part of the actuator force"), K, f),
    )
