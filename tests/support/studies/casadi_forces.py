"""The `exact` equations in CasADi symbols, from which CasADi generates C for ``compare_engines.py``.

The equations are restated here in plain form. CasADi eliminates common subexpressions and solves the linear
system. This module must not depend on the derivation and the generated kernels, except the C structs.
"""

import itertools
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import casadi

from stewart_sym.generated.interface import STRUCTS

Matrix = Any
"""CasADi's SX, for which CasADi provides no types."""

Numbers = SimpleNamespace
"""Quantities by their names in the C structs."""

_SYMMETRIC = (0, 1, 2, 1, 3, 4, 2, 4, 5)
_FREE = ("INPUT", "OUTPUT", "PARAMETER", "CONST", "ASSIGN", "NEG")
"""Instructions without computation: moves and changes of sign."""


LegEquations = Callable[[Numbers, Numbers], Numbers]
"""Function of the constants of a leg and of the motion and gravity that returns q, s, K, D, and f of (18)."""


def program(equations: LegEquations) -> tuple[dict[str, str], int]:
    """Generate C code of the `exact` inverse dynamics with ``base_frame`` or ``leg_frame`` as leg equations.

    The inputs are numbers in the order of ``struct stewart_robot`` and ``struct stewart_motion``. Returns C
    files by name, with the function ``one_pose``, and the operations per pose counted by CasADi.
    """
    of_leg, of_platform, of_motion = (sum(_sizes(name).values()) for name in ("leg", "platform", "motion"))
    robot, motion = casadi.SX.sym("robot", 6 * of_leg + of_platform), casadi.SX.sym("motion", of_motion)
    legs = casadi.vertsplit(robot[: 6 * of_leg], of_leg)
    F = casadi.cse(_forces(legs, robot[6 * of_leg :], motion, equations))
    function = casadi.Function("casadi_forces", [robot, motion], [F])
    generator = casadi.CodeGenerator("casadi_forces.c")
    generator.add(function)
    one_pose = (
        "\nint one_pose(const double *machine, const double *motion, double *F)\n{\n"
        f"    const double *arg[{function.sz_arg()}] = {{machine, motion}};\n"
        f"    double *res[{function.sz_res()}] = {{F}};\n"
        f"    long long int iw[{function.sz_iw()} + 1];\n"
        f"    double w[{function.sz_w()} + 1];\n"
        "    return casadi_forces(arg, res, iw, w, 0);\n}\n"
    )
    free = {getattr(casadi, f"OP_{name}") for name in _FREE}
    operations = sum(function.instruction_id(i) not in free for i in range(function.n_instructions()))
    return {"casadi_forces.c": generator.dump() + one_pose}, operations


def _forces(legs: list[Matrix], platform: Matrix, motion: Matrix, equations: LegEquations) -> Matrix:
    """Compute F, (30)-(37)."""
    body, at = _named(platform, "platform"), _named(motion, "motion")
    at.g = body.g
    done = [equations(_named(leg, "leg"), at) for leg in legs]
    M, R_0, I_p, g = body.M, body.R_0, body.I_p, body.g
    R, omega, alpha = at.R, at.omega, at.alpha

    R_c = R @ R_0  # (30)
    a = casadi.cross(alpha, R_c) + casadi.cross(omega, casadi.cross(omega, R_c)) + at.a  # (31)
    I = R @ I_p @ R.T  # (32)  # noqa: E741
    force = R @ at.F_ext + M * (g - a)  # (33)
    moment = M * casadi.cross(R_c, g - a) - I @ alpha - casadi.cross(omega, I @ omega) + R @ at.M_ext  # (34)
    for leg in done:  # (35)
        force -= leg.K
        moment -= casadi.cross(leg.q, leg.K) - leg.f
    H = casadi.horzcat(*(casadi.vertcat(leg.s, casadi.cross(leg.q, leg.s)) for leg in done))  # (36)
    D = casadi.vertcat(*(leg.D for leg in done))
    # For SX, CasADi's solve is an expanded QR factorization. It is faster than the inverse by minors and than
    # the run-time QR; CasADi's LDL^T requires symmetric matrices.
    return D - casadi.solve(H, casadi.vertcat(force, moment))  # (37)


def base_frame(leg: Numbers, at: Numbers) -> Numbers:
    """Compute equations (1)-(24), corrected, with vectors in the base frame."""
    cross, dot = casadi.cross, casadi.dot
    omega, alpha, g = at.omega, at.alpha, at.g
    q = at.R @ leg.p  # (1)
    S = at.t + q - leg.b  # (2)
    L = casadi.sqrt(dot(S, S))
    s = S / L  # (3)
    Sdot = cross(omega, q) + at.v  # (4)
    Ldot = dot(s, Sdot)  # (5)
    Sddot = cross(alpha, q) + cross(omega, cross(omega, q)) + at.a  # (7)

    k_x_s = cross(leg.k, s)
    y = k_x_s / casadi.sqrt(dot(k_x_s, k_x_s))
    T = casadi.horzcat(s, y, cross(s, y))  # (10)
    n = cross(leg.k, y)
    W = cross(s, Sdot) / L
    W = W - dot(W, n) / dot(s, n) * s  # (6): W.n = 0
    W_s = dot(s, W)
    W_t = W - W_s * s
    Lddot = dot(s, Sddot) + L * dot(W_t, W_t)  # (8)
    A = (cross(s, Sddot) - 2 * Ldot * W_t) / L - W_s * cross(s, W)
    A = A - (dot(A, n) + dot(W, cross(leg.k, cross(W, y)))) / dot(s, n) * s  # (9): d/dt (W.n) = 0

    r_d = T @ leg.r_d0  # (11)
    r_u = T @ (casadi.vertcat(L, 0, 0) + leg.r_u0)  # (12)
    I = T @ (leg.I_d0 + leg.I_u0) @ T.T  # (15), (16)  # noqa: E741
    f = leg.C_s * (W - omega)  # in (18)
    a_u, C = _moment(leg, Numbers(s=s, r_d=r_d, r_u=r_u, I=I, W=W, A=A, Ldot=Ldot, Lddot=Lddot, g=g, f=f))
    M_u = dot(s, C) / dot(s, n)  # (29)
    K = cross(C - M_u * n, s) / L  # (21)
    D = leg.m_u * dot(s, a_u - g) + leg.C_p * Ldot  # (24)
    return Numbers(q=q, s=s, K=K, D=D, f=f)


def leg_frame(leg: Numbers, at: Numbers) -> Numbers:
    """Compute the same leg in its own frame T, in which the inertias are constant and S = (L, 0, 0)."""
    cross, dot = casadi.cross, casadi.dot
    q = at.R @ leg.p
    S = at.t + q - leg.b
    L = casadi.sqrt(dot(S, S))
    s = S / L
    k_x_s = cross(leg.k, s)
    k1, k3 = dot(leg.k, s), casadi.sqrt(dot(k_x_s, k_x_s))
    kappa = k1 / k3
    y = k_x_s / k3
    T = casadi.horzcat(s, y, cross(s, y))
    u = T.T @ (cross(at.omega, q) + at.v)
    e = T.T @ (cross(at.alpha, q) + cross(at.omega, cross(at.omega, q)) + at.a)
    g = T.T @ at.g

    Ldot, Wy, Wz = u[0], -u[2] / L, u[1] / L
    W = casadi.vertcat(kappa * Wz, Wy, Wz)
    Lddot = e[0] + L * (Wy**2 + Wz**2)
    Ay = -(e[2] + 2 * Ldot * Wy) / L + W[0] * Wz
    Az = (e[1] - 2 * Ldot * Wz) / L - W[0] * Wy
    A = casadi.vertcat(kappa * Az - Wy * Wz / k3**2, Ay, Az)

    x = casadi.SX([1, 0, 0])
    r_d, r_u = leg.r_d0, L * x + leg.r_u0
    I = leg.I_d0 + leg.I_u0  # noqa: E741
    f = leg.C_s * (W - T.T @ at.omega)
    a_u, C = _moment(leg, Numbers(s=x, r_d=r_d, r_u=r_u, I=I, W=W, A=A, Ldot=Ldot, Lddot=Lddot, g=g, f=f))
    K = T @ casadi.vertcat(0, (C[2] + kappa * C[0]) / L, -C[1] / L)
    D = leg.m_u * (a_u[0] - g[0]) + leg.C_p * Ldot
    return Numbers(q=q, s=s, K=K, D=D, f=T @ f)


def _moment(leg: Numbers, at: Numbers) -> tuple[Matrix, Matrix]:
    """Compute the acceleration of the upper part (14) and the right side of (20) in any frame."""
    cross, W, A = casadi.cross, at.W, at.A
    a_d = cross(A, at.r_d) + cross(W, cross(W, at.r_d))  # (13)
    a_u = at.Lddot * at.s + cross(A, at.r_u) + cross(W, cross(W, at.r_u)) + 2 * at.Ldot * cross(W, at.s)
    weights = leg.m_d * cross(at.r_d, a_d - at.g) + leg.m_u * cross(at.r_u, a_u - at.g)
    return a_u, weights + at.I @ A + cross(W, at.I @ W) + leg.C_u * W + at.f


def _sizes(struct: str) -> dict[str, int]:
    """Return the number of components of each member of a C struct; only the matrix R has nine."""
    return {name: 9 if name == "R" else (1, 3, 6)[len(shape)] for name, shape in STRUCTS[struct].items()}


def _named(numbers: Matrix, struct: str) -> Numbers:
    """Split numbers into the members of a C struct; nine or six numbers are a matrix."""
    sizes = _sizes(struct)
    parts: list[Matrix] = casadi.vertsplit(numbers, [0, *itertools.accumulate(sizes.values())])
    found = dict(zip(sizes, parts, strict=True))
    for name, part in found.items():
        if part.numel() > 3:
            rows = part if part.numel() == 9 else part[list(_SYMMETRIC)]
            found[name] = casadi.reshape(rows, 3, 3).T
    return Numbers(**found)
