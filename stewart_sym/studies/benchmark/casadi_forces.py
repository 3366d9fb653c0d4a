"""CasADi candidate of ``benchmark``: the `exact` equations in CasADi symbols, from which CasADi generates C.

The equations are restated here in plain form. CasADi eliminates common subexpressions and solves the linear
system. This module must not depend on the derivation and the generated kernels.
"""

import itertools
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from ...io.extras import needed_for

with needed_for("the comparison with CasADi"):
    import casadi

_LEG = {"b": 3, "p": 3, "k": 3, "m_d": 1, "r_d0": 3, "I_d0": 6, "m_u": 1, "r_u0": 3, "I_u0": 6}
_LEG |= dict.fromkeys(("C_u", "C_p", "C_s"), 1)
_PLATFORM = {"M": 1, "R_0": 3, "I_p": 6, "g": 3}
_MOTION = {"R": 9, **dict.fromkeys(("t", "omega", "v", "alpha", "a", "F_ext", "M_ext"), 3)}
"""Number of components of each quantity of a leg, of the platform with gravity, and of a motion, in their
order.
"""

LEG_NUMBERS, MOTION_NUMBERS = sum(_LEG.values()), sum(_MOTION.values())
ROBOT_NUMBERS = 6 * LEG_NUMBERS + sum(_PLATFORM.values())

Matrix = Any
"""CasADi's SX, for which CasADi provides no types."""

Numbers = SimpleNamespace
"""Quantities by their names in the layout."""

_SYMMETRIC = (0, 1, 2, 1, 3, 4, 2, 4, 5)
_FREE = ("INPUT", "OUTPUT", "PARAMETER", "CONST", "ASSIGN", "NEG")
"""Instructions without computation: moves and changes of sign."""


@dataclass(frozen=True)
class Program:
    """C files by name, with the function ``one_pose``, and the operations per pose counted by CasADi."""

    sources: Mapping[str, str]
    operations: int


LegEquations = Callable[[Numbers, Numbers], Numbers]
"""Equations of a leg as a function of its constants and of the motion, load, and gravity of the platform.

The results are the quantities that the platform requires: q, s, K, and D of (1), (3), (21), and (24), and the
friction moment f of (18).
"""


def program(equations: LegEquations) -> Program:
    """Generate C code of the `exact` inverse dynamics with ``base_frame`` or ``leg_frame`` as the leg
    equations.

    The inputs are the constants in the order of ``struct stewart_robot`` and the motion in the order of
    ``struct stewart_motion``.
    """
    robot, motion = casadi.SX.sym("robot", ROBOT_NUMBERS), casadi.SX.sym("motion", MOTION_NUMBERS)
    F = casadi.cse(_forces(robot, motion, equations))
    function = casadi.Function("casadi_forces", [robot, motion], [F])
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
    return Program({"casadi_forces.c": _emitted(function) + one_pose}, operations)


def _emitted(function: Any) -> str:
    generator = casadi.CodeGenerator("casadi_forces.c")
    generator.add(function)
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as folder:
        return Path(generator.generate(f"{folder}/")).read_text(encoding="utf-8")


def _forces(robot: Matrix, numbers: Matrix, equations: LegEquations) -> Matrix:
    """Compute F, (30)-(37)."""
    legs = casadi.vertsplit(robot[: 6 * LEG_NUMBERS], LEG_NUMBERS)
    platform, at = _named(robot[6 * LEG_NUMBERS :], _PLATFORM), _named(numbers, _MOTION)
    at.g = platform.g
    done = [equations(_named(leg, _LEG), at) for leg in legs]
    M, R_0, I_p, g = platform.M, platform.R_0, platform.I_p, platform.g
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
    a_d = cross(A, r_d) + cross(W, cross(W, r_d))  # (13)
    a_u = Lddot * s + cross(A, r_u) + cross(W, cross(W, r_u)) + 2 * Ldot * cross(W, s)  # (14)
    f = leg.C_s * (W - omega)  # in (18)
    C = (  # right side of (20)
        leg.m_d * cross(r_d, a_d - g)
        + leg.m_u * cross(r_u, a_u - g)
        + I @ A
        + cross(W, I @ W)
        + leg.C_u * W
        + f
    )
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
    a_d = cross(A, r_d) + cross(W, cross(W, r_d))
    a_u = Lddot * x + cross(A, r_u) + cross(W, cross(W, r_u)) + 2 * Ldot * cross(W, x)
    f = leg.C_s * (W - T.T @ at.omega)
    C = (
        leg.m_d * cross(r_d, a_d - g)
        + leg.m_u * cross(r_u, a_u - g)
        + I @ A
        + cross(W, I @ W)
        + leg.C_u * W
        + f
    )
    K = T @ casadi.vertcat(0, (C[2] + kappa * C[0]) / L, -C[1] / L)
    D = leg.m_u * (a_u[0] - g[0]) + leg.C_p * Ldot
    return Numbers(q=q, s=s, K=K, D=D, f=T @ f)


def _named(numbers: Matrix, sizes: Mapping[str, int]) -> Numbers:
    """Split numbers into quantities in the order of ``sizes``; nine or six numbers are a matrix."""
    parts: list[Matrix] = casadi.vertsplit(numbers, [0, *itertools.accumulate(sizes.values())])
    found = dict(zip(sizes, parts, strict=True))
    for name, part in found.items():
        if part.numel() > 3:
            rows = part if part.numel() == 9 else part[list(_SYMMETRIC)]
            found[name] = casadi.reshape(rows, 3, 3).T
    return Numbers(**found)
