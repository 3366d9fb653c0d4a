"""One leg: kinematics (1)-(9), frame (10), inertia (11)-(16), the twelve equations of motion, their solution.

The motion of the platform comes in, everything the leg gives to the platform goes out. Vectors of the leg
are written in the leg frame T = [x y z], where S = (L, 0, 0) and k = (k1, 0, k3): that keeps the closed
form short. The equations are set up as equations and solved by SymPy; the printed results (21), (24), (27),
(29) are what the tests compare with.
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
    """What the leg frame sees: S = (L, 0, 0), k = (k1, 0, k3), and base-frame vectors by components.

    u, e, gamma, w: first and second derivative of S, gravity, and the platform's angular velocity.
    inv_L, inv_k3, kappa: 1/L, 1/k3 and k1/k3.
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
    """Constants of one leg: bodies, friction, rotor, as they enter the equations (some may be zero)."""

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
    """The leg's equations solved, all in the leg frame; vectors are 3x1 matrices.

    L_dot, W, A: sliding velocity, angular velocity and acceleration of the leg.
    D: (24); K: (21), without axial part; f: friction moment at the spherical joint.
    reactions: F_s, F_u, F_p, F_c, M_p, M_u by name, linear in the axial force x.
    """

    L_dot: sp.Expr
    W: sp.Matrix
    A: sp.Matrix
    D: sp.Expr
    K: sp.Matrix
    f: sp.Matrix
    reactions: dict[str, sp.Expr | sp.Matrix]


def constants(friction: bool = True, axisymmetric: bool = False, rotor: Rotor = NONE) -> LegConstants:
    """The leg's constants as symbols; without friction, or about the axis, those that vanish are zero."""
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
    """What axial symmetry leaves of a center of mass or of an inertia."""
    if value.shape == (3, 1):
        return sp.Matrix([value[0], 0, 0])
    return sp.diag(value[0, 0], value[1, 1], value[1, 1])


def cross(p: sp.Matrix, q: sp.Matrix) -> sp.Matrix:
    """Vector product of two 3x1 matrices."""
    return p.cross(q)


def skew(w: sp.Matrix) -> sp.Matrix:
    """[w]x of a 3x1 matrix, so that [w]x v is w x v."""
    return sp.Matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


# ---------------------------------------------------------------- position, velocity and acceleration of S


def tip_vector(build: Builder) -> tuple[sp.Matrix, sp.Matrix]:
    """q and S of (1), base frame."""
    q = build.vector("q", n.R.value * n.p.value, "(1)", "platform point from the reference point")
    S = build.vector("S", q + n.t.value - n.b.value, "(1)", "leg vector")
    return q, S


def leg_vector(build: Builder) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr, sp.Matrix]:
    """q, S, L, 1/L and s of (1)-(3), base frame."""
    q, S = tip_vector(build)
    L = build.scalar("L", sp.sqrt(S.dot(S)), "(2)", "leg length")
    inv_L = build.scalar("inv_L", 1 / L)
    s = build.vector("s", S * inv_L, "(3)", "unit vector along the leg")
    return q, S, L, inv_L, s


def platform_point_motion(build: Builder, q: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """First and second time derivative of S, (4) and (7), base frame."""
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
    """L_dot and L_ddot of (5) and (8), from the motion of the platform point in the base frame."""
    rate = build.scalar("rate", s.dot(S_dot), "(5)", "sliding velocity")
    across = build.vector("across", S_dot - rate * s, "", "part of S_dot across the leg, of length L |W|")
    return rate, build.scalar("second", s.dot(S_ddot) + across.dot(across) * inv_L, "(8)")


def leg_frame(build: Builder, s: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr]:
    """T = [x y z] of (10), the axis k in it, 1 / k3, and kappa = k1 / k3."""
    k = n.k.value
    ks = build.vector("k_cross_s", cross(k, s), "(10)", "normal to the fixed axis and the leg")
    y, z, k3, inv_k3 = axes(build, s, ks, "k3", "k = (k1, 0, k3) in the leg frame")
    k1 = build.scalar("k1", k.dot(s), "(10)", "k = (k1, 0, k3) in the leg frame")
    kappa = build.scalar("kappa", k1 * inv_k3, "", "spin of the leg about s for each turn about z")
    return sp.Matrix.hstack(s, y, z), sp.Matrix([k1, 0, k3]), inv_k3, kappa


def axes(
    build: Builder, s: sp.Matrix, normal: sp.Matrix, size: str, meaning: str
) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr]:
    """y and z of (10) from a normal along k x s, its length, named ``size``, and one over it.

    The smaller |k x s|, the more rounding leaves of the normal along s. s x normal has no such part, and z
    and y made of it are perpendicular to s and to each other to all digits.
    """
    across = build.vector("s_cross_normal", cross(s, normal), "(10)", "along the third axis of the leg")
    length = build.scalar(size, sp.sqrt(across.dot(across)), "(10)", meaning)
    inverse = build.scalar(f"inv_{size}", 1 / length)
    z = build.vector("z", across * inverse, "(10)", "third axis of the leg frame")
    return build.vector("y", cross(z, s), "(10)", "rotating axis of the universal joint"), z, length, inverse


# ---------------------------------------------------------------- rotation of the leg


def spin_axis(form: Formulation, k: sp.Matrix, W: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix]:
    """The direction about which the leg cannot turn, and its time derivative.

    Printed: the leg itself, which turns with W. In truth the normal n = k x y to both axes of the universal
    joint, where k is fixed and y turns with the leg.
    """
    if form.no_spin or form.base_joint == SPHERICAL:
        return X_AXIS, cross(W, X_AXIS)
    return cross(k, Y_AXIS), cross(k, cross(W, Y_AXIS))


def solve_one(equation: sp.Expr, unknown: sp.Symbol) -> sp.Expr:
    """The value of ``unknown`` that makes a linear ``equation`` zero."""
    (solution,) = sp.linsolve([equation], [unknown])
    return solution[0]


def rotation(
    build: Builder, form: Formulation, m: LegFrameMotion
) -> tuple[sp.Expr, sp.Matrix, sp.Expr, sp.Matrix]:
    """L_dot, W, L_ddot and A of the leg, (5)-(9), from the motion of its tip and the joint's condition."""
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
    # What the spin adds to A_y and A_z cancels further on, and is large near the joint singularity: no name.
    own = "angular acceleration of the leg but for its spin, leg frame"
    turned_z, turned_y = (solve_one(acceleration[i], A[j]) for i, j in ((1, 2), (2, 1)))
    spun_z, spun_y = -W[0] * W[1], W[0] * W[2]
    A_z = build.scalar("A_z_own", _tidy(turned_z - spun_z, m), "(9)", own) + spun_z
    A_y = build.scalar("A_y_own", _tidy(turned_y - spun_y, m), "(9)", own) + spun_y
    condition = (A.dot(axis) + W.dot(axis_dot)).subs({A[1]: A_y, A[2]: A_z})
    A_x = build.scalar("A_x", _tidy(solve_one(condition, A[0]), m), "(9)", about)
    return L_dot, W, L_ddot, sp.Matrix([A_x, A_y, A_z])


def _tidy(expr: sp.Expr, m: LegFrameMotion) -> sp.Expr:
    """Write 1/L and k1/k3 by their names."""
    expr = sp.expand(expr)
    if not m.k.is_zero_matrix and not m.k[2].is_number:
        expr = sp.expand(expr.subs(m.k[0], m.kappa * m.k[2]))
        expr = expr.subs(1 / m.k[2], m.inv_k3)
    expr = expr.subs(1 / m.L, m.inv_L)
    return sp.collect(sp.collect(expr, m.inv_L), m.kappa) if m.kappa.is_Symbol else sp.collect(expr, m.inv_L)


# ---------------------------------------------------------------- forces


@dataclass(frozen=True)
class PartForces:
    """Newton's and Euler's right-hand sides of the two parts, leg frame.

    N_d, N_u: m (a - g), N; r_d, r_u: centers of mass from the base point, m;
    E_d, E_u: I A + W x I W, and the rotor's part, N m; f: friction moment at the spherical joint, N m.
    """

    r_d: sp.Matrix
    r_u: sp.Matrix
    N_d: sp.Matrix
    N_u: sp.Matrix
    E_d: sp.Matrix
    E_u: sp.Matrix
    f: sp.Matrix


def inertias(form: Formulation, c: LegConstants, L: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """I_d of (15) and I_u of (16), leg frame."""
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
    """r_d, r_u, N_d, N_u and f: (11)-(14), then m (a - g), and the friction of (18)."""
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
    """I A + W x I W."""
    return _spin_gathered(inertia * A + cross(W, inertia * W), W)


def _spin_gathered(vector: sp.Matrix, W: sp.Matrix) -> sp.Matrix:
    """The vector with the products of the leg's angular velocity collected, so that what cancels is gone."""
    products = list(dict.fromkeys(W[i] * W[j] for i in range(3) for j in range(i, 3)))
    return vector.applyfunc(lambda entry: sp.collect(sp.expand(entry), [p for p in products if p != 0]))


@dataclass(frozen=True)
class LegEquations:
    """The twelve equations of a leg: expressions that vanish, and their twelve unknowns beside x.

    newton_lower (25), euler_lower (17), newton_upper (23), euler_upper (18): 3x1 matrices, leg frame.
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
    """Direction of the constraint moment of the base joint: printed along s, in truth along n = k x y."""
    if form.base_joint == SPHERICAL:
        return sp.zeros(3, 1)
    return X_AXIS if form.moment_along_leg else cross(k, Y_AXIS)


def leg_equations(
    form: Formulation, c: LegConstants, m: LegFrameMotion, L_dot: sp.Expr, W: sp.Matrix, part: PartForces
) -> LegEquations:
    """Newton's and Euler's equations for the two parts, (17), (18), (23), (25)."""
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
    """(19), the sum of (17) and (18), and its known part C of (20): M_u n + S x F_s = C."""
    total = (equations.euler_lower + equations.euler_upper).applyfunc(sp.expand)
    nothing = dict.fromkeys((AXIAL, *equations.unknowns), 0)
    return total, -total.subs(nothing)


def eliminate(form: Formulation, equations: LegEquations, C: sp.Matrix) -> dict[sp.Symbol, sp.Expr]:
    """Solve the twelve equations for the twelve unknowns in terms of x; C stands for the known part of (19).

    With a spherical base joint the sum of the axial moments says how the leg's free spin changes; it is left
    out, as in the paper, and eleven equations remain for eleven unknowns.
    """
    total, known = whole_leg(equations)
    moments = list(total + known - C)
    if form.base_joint == SPHERICAL:
        moments = moments[1:]
    rows = [*equations.newton_lower, *equations.euler_lower, *equations.newton_upper, *moments]
    matrix, right = sp.linear_eq_to_matrix(rows, equations.unknowns)
    return dict(zip(equations.unknowns, matrix.LUsolve(right), strict=True))


def rotor_moment(build: Builder, rotor: Rotor, L_dot: sp.Expr, L_ddot: sp.Expr, W: sp.Matrix) -> sp.Matrix:
    """Rate of the angular momentum j_r L_dot s, leg frame; zero without a rotor."""
    if rotor.momentum == 0:
        return sp.zeros(3, 1)
    rate = rotor.momentum * (L_ddot * X_AXIS + L_dot * cross(W, X_AXIS))
    return build.vector("E_r", rate, "(17)", "rate of the rotor's angular momentum relative to the leg")


def leg_dynamics(
    build: Builder, form: Formulation, c: LegConstants, m: LegFrameMotion, with_reactions: bool
) -> LegDynamics:
    """Set up and solve one leg, naming the paper's quantities on the way.

    with_reactions: name E_d by itself, which M_p needs; otherwise I_d + I_u is formed at once, as in (19).
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
    C = build.vector("C", whole_leg(equations)[1], "(20)", "moment that the joints' forces must make")
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
