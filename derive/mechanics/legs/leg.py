"""Equations of one leg: kinematics (1)-(9), leg frame (10), and equations of motion (11)-(29).

Equations (11)-(14) are the centers of mass and their accelerations, (15) and (16) the inertias. Inputs are
the platform's motion, outputs the leg's terms in the equations of the platform. Positions and the motion of
the platform point are in the base frame, the equations of motion in the leg frame T = [x y z], in which S =
(L, 0, 0) and k = (k1, 0, k3) keep the closed form short. SymPy solves the twelve equations of motion. The
tests compare the solution with the printed results (21), (24), (27), (29).
"""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder
from .. import quantities as n
from ..formulation import SPHERICAL, Formulation
from .rotor import NONE, Rotor

X_AXIS = sp.Matrix([1, 0, 0])
Y_AXIS = sp.Matrix([0, 1, 0])


@dataclass(frozen=True)
class LegFrameMotion:
    """Motion of a leg in the leg frame, in which S = (L, 0, 0) and k = (k1, 0, k3).

    Attributes
    ----------
    L, inv_L : Expr
        Leg length (m), and 1 / L.
    k : Matrix, shape (3, 1)
        Fixed axis of the universal joint.
    inv_k3, kappa : Expr
        1 / k3, and k1 / k3.
    u, e : Matrix, shape (3, 1)
        Velocity (m/s) and acceleration (m/s^2) of the platform point: base-frame derivatives of S, in
        leg-frame components.
    gamma : Matrix, shape (3, 1)
        Gravity (m/s^2).
    w : Matrix, shape (3, 1)
        Angular velocity of the platform (rad/s).
    """

    L: sp.Expr
    inv_L: sp.Expr
    k: sp.Matrix
    inv_k3: sp.Expr
    kappa: sp.Expr
    u: sp.Matrix
    e: sp.Matrix
    gamma: sp.Matrix
    w: sp.Matrix


@dataclass(frozen=True)
class LegConstants:
    """Constants of one leg as they enter the equations: bodies, friction, and rotor. Some may be zero."""

    m_d: sp.Expr
    r_d0: sp.Matrix
    I_d0: sp.Matrix
    m_u: sp.Expr
    r_u0: sp.Matrix
    I_u0: sp.Matrix
    C_u: sp.Expr
    C_p: sp.Expr
    C_s: sp.Expr
    rotor: Rotor = NONE


@dataclass(frozen=True)
class LegDynamics:
    """Solution of the equations of one leg, leg frame.

    Attributes
    ----------
    L_dot : Expr
        Sliding velocity (m/s), (5).
    W, A : Matrix, shape (3, 1)
        Angular velocity (rad/s) and angular acceleration (rad/s^2) of the leg, (6), (9).
    D : Expr
        Known part of the actuator force (N), (24).
    K : Matrix, shape (3, 1)
        Transverse force at the spherical joint (N), (21), without axial component.
    f : Matrix, shape (3, 1)
        Friction moment of the spherical joint on the platform (N m), (18). The moment on the leg is -f.
    reactions : dict
        F_s, F_u, F_p, F_c, M_p, M_u by name, linear in the axial force x. M_p is only valid with
        ``with_reactions``.
    """

    L_dot: sp.Expr
    W: sp.Matrix
    A: sp.Matrix
    D: sp.Expr
    K: sp.Matrix
    f: sp.Matrix
    reactions: dict[str, sp.Expr | sp.Matrix]


def constants(friction: bool = True, axisymmetric: bool = False, rotor: Rotor = NONE) -> LegConstants:
    """Return the constants of a leg as symbols; constants that vanish are zero.

    Friction constants vanish without ``friction``. Transverse centers of mass and products of inertia vanish
    if ``axisymmetric``.
    """
    C_u, C_p, C_s = (q.value if friction else sp.S.Zero for q in n.FRICTION)
    keep = _about_axis if axisymmetric else lambda value: value
    return LegConstants(
        m_d=n.m_d.value,
        r_d0=keep(n.r_d0.value),
        I_d0=keep(n.I_d0.value),
        m_u=n.m_u.value,
        r_u0=keep(n.r_u0.value),
        I_u0=keep(n.I_u0.value),
        C_u=C_u,
        C_p=C_p,
        C_s=C_s,
        rotor=rotor,
    )


def _about_axis(value: sp.Matrix) -> sp.Matrix:
    """Reduce a center of mass or an inertia to an axisymmetric body."""
    if value.shape == (3, 1):
        return sp.Matrix([value[0], 0, 0])
    return sp.diag(value[0, 0], value[1, 1], value[1, 1])


def cross(p: sp.Matrix, q: sp.Matrix) -> sp.Matrix:
    """Compute the cross product of two 3x1 matrices."""
    return p.cross(q)


def skew(w: sp.Matrix) -> sp.Matrix:
    """Return [w]x of a 3x1 matrix, so that [w]x v = w x v."""
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


# ---------------------------------------------------------------- position, velocity and acceleration of S


def tip_vector(build: Builder) -> tuple[sp.Matrix, sp.Matrix]:
    """Name q and S of (1), base frame."""
    q = build.vector("q", n.R.value * n.p.value, "(1)", "platform point from the reference point")
    S = build.vector("S", q + n.t.value - n.b.value, "(1)", "leg vector")
    return q, S


def leg_vector(build: Builder) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr, sp.Matrix]:
    """Name q, S, L, 1/L, and s of (1)-(3), base frame."""
    q, S = tip_vector(build)
    L = build.scalar("L", sp.sqrt(S.dot(S)), "(2)", "leg length")
    inv_L = build.scalar("inv_L", 1 / L)
    s = build.vector("s", S * inv_L, "(3)", "unit vector along the leg")
    return q, S, L, inv_L, s


def platform_point_motion(build: Builder, q: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Name the first and second time derivative of S, (4) and (7), base frame."""
    w_q = build.vector("w_q", cross(n.omega.value, q), "(4)", "omega x q")
    S_dot = build.vector("S_dot", w_q + n.v.value, "(4)", "velocity of the platform point")
    S_ddot = build.vector(
        "S_ddot",
        cross(n.alpha.value, q) + cross(n.omega.value, w_q) + n.a.value,
        "(7)",
        "acceleration of the platform point",
    )
    return S_dot, S_ddot


def sliding(
    build: Builder, s: sp.Matrix, inv_L: sp.Expr, S_dot: sp.Matrix, S_ddot: sp.Matrix
) -> tuple[sp.Expr, sp.Expr]:
    """Name L_dot (5) and L_ddot (8) from the motion of the platform point in the base frame."""
    rate = build.scalar("rate", s.dot(S_dot), "(5)", "sliding velocity")
    across = build.vector("across", S_dot - rate * s, "", "transverse part of S_dot")
    return rate, build.scalar("second", s.dot(S_ddot) + across.dot(across) * inv_L, "(8)")


def leg_frame(build: Builder, s: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr]:
    """Name T = [x y z] of (10), k in this frame, 1 / k3, and kappa = k1 / k3."""
    k = n.k.value
    ks = build.vector("k_cross_s", cross(k, s), "(10)", "normal to the fixed axis and the leg")
    y, z, k3, inv_k3 = axes(build, s, ks, "k3", "k = (k1, 0, k3) in the leg frame")
    k1 = build.scalar("k1", k.dot(s), "(10)", "k = (k1, 0, k3) in the leg frame")
    kappa = build.scalar("kappa", k1 * inv_k3, "", "spin of the leg about s per rotation about z")
    return sp.Matrix.hstack(s, y, z), sp.Matrix([k1, 0, k3]), inv_k3, kappa


def axes(
    build: Builder, s: sp.Matrix, normal: sp.Matrix, size: str, meaning: str
) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr]:
    """Name y and z of (10), the length of ``normal`` as ``size``, and its reciprocal, base frame.

    The vector ``normal`` is parallel to k x s. Its component along s is a rounding error, which is relatively
    larger for smaller |k x s|. The vector s x normal has no such component. So z and y, which are computed
    from it, are perpendicular to s and to each other to full precision.
    """
    across = build.vector("s_cross_normal", cross(s, normal), "(10)", "along the third axis of the leg")
    length = build.scalar(size, sp.sqrt(across.dot(across)), "(10)", meaning)
    inverse = build.scalar(f"inv_{size}", 1 / length)
    z = build.vector("z", across * inverse, "(10)", "third axis of the leg frame")
    return build.vector("y", cross(z, s), "(10)", "rotating axis of the universal joint"), z, length, inverse


# ---------------------------------------------------------------- rotation of the leg


def spin_axis(form: Formulation, k: sp.Matrix, W: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """Return the direction about which the leg cannot rotate, and its time derivative, leg frame.

    In the printed equations and for a spherical base joint, the direction is s with the derivative W x s. In
    the corrected equations it is n = k x y, the normal to both axes of the universal joint. Its derivative is
    k x (W x y), because k is fixed to the base and y rotates with the leg.
    """
    if form.no_spin or form.base_joint == SPHERICAL:
        return X_AXIS, cross(W, X_AXIS)
    return cross(k, Y_AXIS), cross(k, cross(W, Y_AXIS))


def solve_one(equation: sp.Expr, unknown: sp.Symbol) -> sp.Expr:
    """Solve a linear equation for one unknown."""
    (solution,) = sp.linsolve([equation], [unknown])
    return solution[0]


def rotation(
    build: Builder, form: Formulation, m: LegFrameMotion
) -> tuple[sp.Expr, sp.Matrix, sp.Expr, sp.Matrix]:
    """Derive L_dot, W, L_ddot, and A of the leg (5)-(9), leg frame.

    The unknowns follow from the motion of the platform point and from the condition of the base joint on the
    spin.
    """
    W = sp.Matrix(sp.symbols("W_x W_y W_z", real=True))
    A = sp.Matrix(sp.symbols("A_x A_y A_z", real=True))
    L_dot, L_ddot = sp.symbols("L_dot L_ddot", real=True)
    S = m.L * X_AXIS
    axis, axis_dot = spin_axis(form, m.k, W)

    velocity = L_dot * X_AXIS + cross(W, S) - m.u
    L_dot = build.scalar("L_dot", solve_one(velocity[0], L_dot), "(5)", "sliding velocity")
    about = "angular velocity of the leg, leg frame"
    W_z = build.scalar("W_z", _tidy(solve_one(velocity[1], W[2]), m), "(6)", about)
    W_y = build.scalar("W_y", _tidy(solve_one(velocity[2], W[1]), m), "(6)", about)
    known = {W[1]: W_y, W[2]: W_z}
    W_x = build.scalar("W_x", _tidy(solve_one(W.dot(axis), W[0]).subs(known), m), "(6)", about)
    known[W[0]] = W_x
    W = W.subs(known)
    axis, axis_dot = axis.subs(known), axis_dot.subs(known)

    acceleration = L_ddot * X_AXIS + cross(W, cross(W, S)) + 2 * L_dot * cross(W, X_AXIS) + cross(A, S) - m.e
    L_ddot = build.scalar("L_ddot", solve_one(acceleration[0], L_ddot), "(8)", "sliding acceleration")
    about = "angular acceleration of the leg, leg frame"
    # The spin terms of A_y and A_z have no name, because they cancel later and may be large.
    own = "angular acceleration of the leg without the spin terms, leg frame"
    turned_z, turned_y = (solve_one(acceleration[i], A[j]) for i, j in ((1, 2), (2, 1)))
    spun_z, spun_y = -W[0] * W[1], W[0] * W[2]
    A_z = build.scalar("A_z_own", _tidy(turned_z - spun_z, m), "(9)", own) + spun_z
    A_y = build.scalar("A_y_own", _tidy(turned_y - spun_y, m), "(9)", own) + spun_y
    condition = (A.dot(axis) + W.dot(axis_dot)).subs({A[1]: A_y, A[2]: A_z})
    A_x = build.scalar("A_x", _tidy(solve_one(condition, A[0]), m), "(9)", about)
    return L_dot, W, L_ddot, sp.Matrix([A_x, A_y, A_z])


def _tidy(expr: sp.Expr, m: LegFrameMotion) -> sp.Expr:
    """Replace 1/L and k1/k3 by their names."""
    expr = sp.expand(expr)
    if not m.k.is_zero_matrix and not m.k[2].is_number:
        expr = sp.expand(expr.subs(m.k[0], m.kappa * m.k[2]))
        expr = expr.subs(1 / m.k[2], m.inv_k3)
    expr = expr.subs(1 / m.L, m.inv_L)
    return sp.collect(sp.collect(expr, m.inv_L), m.kappa) if m.kappa.is_Symbol else sp.collect(expr, m.inv_L)


# ---------------------------------------------------------------- forces


@dataclass(frozen=True)
class PartForces:
    """Known terms of Newton's and Euler's equations for the two parts, leg frame.

    Attributes
    ----------
    r_d, r_u : Matrix, shape (3, 1)
        Centers of mass of the lower and upper part from the base point (m).
    N_d, N_u : Matrix, shape (3, 1)
        m (a - g) (N), with the acceleration a of the center of mass.
    E_d, E_u : Matrix, shape (3, 1)
        Rate of the angular momentum about the center of mass, I A + W x I W (N m). E_d includes the term of
        the rotor.
    f : Matrix, shape (3, 1)
        Friction moment of the spherical joint on the platform (N m). The moment on the upper part is -f.
    """

    r_d: sp.Matrix
    r_u: sp.Matrix
    N_d: sp.Matrix
    N_u: sp.Matrix
    E_d: sp.Matrix
    E_u: sp.Matrix
    f: sp.Matrix


def inertias(form: Formulation, c: LegConstants, L: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """Return I_d (15) and I_u (16), leg frame."""
    return c.I_d0, c.I_u0 + (c.m_u * L**2 * sp.diag(0, 1, 1) if form.transport_twice else sp.zeros(3))


def center_forces(
    build: Builder,
    c: LegConstants,
    m: LegFrameMotion,
    L_dot: sp.Expr,
    W: sp.Matrix,
    L_ddot: sp.Expr,
    A: sp.Matrix,
) -> tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix, sp.Matrix]:
    """Name r_d, r_u, N_d, N_u, and f: (11)-(14), m (a - g), and the friction in (18), leg frame."""
    r_d = c.r_d0
    r_u = build.vector(
        "r_u", m.L * X_AXIS + c.r_u0, "(12)", "center of mass of the upper part from the base point"
    )
    a_d = build.vector(
        "a_d",
        _spin_gathered(cross(A, r_d) + cross(W, cross(W, r_d)), W),
        "(11), (13)",
        "acceleration of the lower center of mass",
    )
    a_u = build.vector(
        "a_u",
        L_ddot * X_AXIS
        + _spin_gathered(cross(A, r_u) + cross(W, cross(W, r_u)), W)
        + 2 * L_dot * cross(W, X_AXIS),
        "(14)",
        "acceleration of the upper center of mass",
    )
    N_d = build.vector("N_d", c.m_d * (a_d - m.gamma), "(25)", "m_d (a_d - g)")
    N_u = build.vector("N_u", c.m_u * (a_u - m.gamma), "(23)", "m_u (a_u - g)")
    f = build.vector("f_leg", c.C_s * (W - m.w), "(18)", "friction moment at the spherical joint, leg frame")
    return r_d, r_u, N_d, N_u, f


def euler_term(inertia: sp.Matrix, A: sp.Matrix, W: sp.Matrix) -> sp.Matrix:
    """Compute I A + W x I W."""
    return _spin_gathered(inertia * A + cross(W, inertia * W), W)


def _spin_gathered(vector: sp.Matrix, W: sp.Matrix) -> sp.Matrix:
    """Collect the products of the components of W, so that terms cancel symbolically."""
    products = list(dict.fromkeys(W[i] * W[j] for i in range(3) for j in range(i, 3)))
    return vector.applyfunc(lambda entry: sp.collect(sp.expand(entry), [p for p in products if p != 0]))


@dataclass(frozen=True)
class LegEquations:
    """Twelve equations of one leg in the leg frame, as expressions that are zero.

    Attributes
    ----------
    newton_lower : Matrix, shape (3, 1)
        Force balance of the lower part (25).
    euler_lower : Matrix, shape (3, 1)
        Moment balance of the lower part (17).
    newton_upper : Matrix, shape (3, 1)
        Force balance of the upper part (23).
    euler_upper : Matrix, shape (3, 1)
        Moment balance of the upper part (18).
    unknowns : tuple of Symbol
        Twelve unknowns in addition to the axial force x; eleven with a spherical base joint.
    """

    newton_lower: sp.Matrix
    euler_lower: sp.Matrix
    newton_upper: sp.Matrix
    euler_upper: sp.Matrix
    unknowns: tuple[sp.Symbol, ...]


AXIAL = sp.Symbol("x", real=True)
_F_s = sp.Matrix([AXIAL, *sp.symbols("F_s_y F_s_z", real=True)])
_F_p = sp.Matrix(sp.symbols("F_p_x F_p_y F_p_z", real=True))
_F_u = sp.Matrix(sp.symbols("F_u_x F_u_y F_u_z", real=True))
_M_p = sp.Matrix(sp.symbols("M_p_x M_p_y M_p_z", real=True))
_M_u = sp.Symbol("M_u", real=True)


def moment_axis(form: Formulation, k: sp.Matrix) -> sp.Matrix:
    """Return the direction of the constraint moment of the base joint: printed s, corrected n = k x y."""
    if form.base_joint == SPHERICAL:
        return sp.zeros(3, 1)
    return X_AXIS if form.moment_along_leg else cross(k, Y_AXIS)


def leg_equations(
    form: Formulation, c: LegConstants, m: LegFrameMotion, L_dot: sp.Expr, W: sp.Matrix, part: PartForces
) -> LegEquations:
    """Set up Newton's and Euler's equations of the two parts, (17), (18), (23), (25), leg frame."""
    r = n.bearing.value * X_AXIS
    slide = c.C_p * L_dot * X_AXIS
    unknowns = (*_F_s[1:], *_F_p, *_F_u, *_M_p) + (() if form.base_joint == SPHERICAL else (_M_u,))
    return LegEquations(
        newton_lower=_F_u - _F_p + slide - part.N_d,
        euler_lower=-cross(part.r_d, part.N_d)
        - part.E_d
        + _M_u * moment_axis(form, m.k)
        - cross(r, _F_p)
        - _M_p
        - c.C_u * W,
        newton_upper=_F_p + _F_s - slide - part.N_u,
        euler_upper=-cross(part.r_u, part.N_u)
        - part.E_u
        + cross(m.L * X_AXIS, _F_s)
        + cross(r, _F_p)
        + _M_p
        - part.f,
        unknowns=unknowns,
    )


def whole_leg(equations: LegEquations) -> tuple[sp.Matrix, sp.Matrix]:
    """Return two vectors: (19), which is the sum of (17) and (18), and C of (20).

    Equation (20) is (19) with the unknowns on the left-hand side: M_u n + S x F_s = C.
    """
    total = (equations.euler_lower + equations.euler_upper).applyfunc(sp.expand)
    nothing = dict.fromkeys((AXIAL, *equations.unknowns), 0)
    return total, -total.subs(nothing)


def eliminate(form: Formulation, equations: LegEquations, C: sp.Matrix) -> dict[sp.Symbol, sp.Expr]:
    """Solve the twelve equations for the twelve unknowns as functions of x.

    (20) replaces (18), and C is its right-hand side. With a spherical base joint there is no M_u, and the
    axial component of (20) would determine the acceleration of the free spin. This component is omitted, as
    in the paper, so eleven equations remain for eleven unknowns.
    """
    total, known = whole_leg(equations)
    moments = list(total + known - C)
    if form.base_joint == SPHERICAL:
        moments = moments[1:]
    rows = [*equations.newton_lower, *equations.euler_lower, *equations.newton_upper, *moments]
    matrix, right = sp.linear_eq_to_matrix(rows, equations.unknowns)
    return dict(zip(equations.unknowns, matrix.LUsolve(right), strict=True))


def rotor_moment(build: Builder, rotor: Rotor, L_dot: sp.Expr, L_ddot: sp.Expr, W: sp.Matrix) -> sp.Matrix:
    """Name the rate of the angular momentum j_r L_dot s, leg frame; zero without a rotor."""
    if rotor.momentum == 0:
        return sp.zeros(3, 1)
    rate = rotor.momentum * (L_ddot * X_AXIS + L_dot * cross(W, X_AXIS))
    return build.vector("E_r", rate, "(17)", "rate of the rotor's angular momentum relative to the leg")


def leg_dynamics(
    build: Builder, form: Formulation, c: LegConstants, m: LegFrameMotion, with_reactions: bool
) -> LegDynamics:
    """Set up and solve the equations of one leg, and name the quantities of the paper.

    With ``with_reactions``, E_d is computed for M_p. Otherwise only I_d + I_u is formed, as in (19), and M_p
    is not valid. The other results are the same, because they depend only on E_d + E_u.
    """
    L_dot, W, L_ddot, A = rotation(build, form, m)
    r_d, r_u, N_d, N_u, f = center_forces(build, c, m, L_dot, W, L_ddot, A)
    I_d, I_u = inertias(form, c, m.L)
    inertia = build.tensor("I", I_d + I_u, "(15), (16), (19)", "I_d + I_u")
    E = build.vector("E", euler_term(inertia, A, W), "(19)", "I A + W x I W")
    E_d = (
        build.vector("E_d", euler_term(I_d, A, W), "(17)", "I_d A + W x I_d W")
        if with_reactions
        else sp.zeros(3, 1)
    )

    part = PartForces(r_d, r_u, N_d, N_u, E_d + rotor_moment(build, c.rotor, L_dot, L_ddot, W), E - E_d, f)
    equations = leg_equations(form, c, m, L_dot, W, part)
    C = build.vector("C", whole_leg(equations)[1], "(20)", "moment that the joint forces must balance")
    solved = {key: _tidy(value, m) for key, value in eliminate(form, equations, C).items()}

    F_s, F_p = _F_s.subs(solved), _F_p.subs(solved)
    F_rotor = c.rotor.mass * L_ddot + c.rotor.momentum * A[0]
    D = build.scalar("D", sp.expand(F_p[0] + AXIAL) + F_rotor, "(24)", "known part of the actuator force")
    K = build.vector(
        "K_leg", F_s.subs(AXIAL, 0), "(21)", "transverse force at the spherical joint, leg frame"
    )
    reactions = {
        "F_s": AXIAL * X_AXIS + K,
        "F_u": _F_u.subs(solved),
        "F_p": F_p,
        "F_c": F_p - F_p[0] * X_AXIS,
        "M_p": _M_p.subs(solved),
        "M_u": solved.get(_M_u, sp.S.Zero),
    }
    return LegDynamics(L_dot, W, A, D, K, f, reactions)
