"""The elimination that SymPy carries out gives the paper's printed results, and PHYSICS' corrected ones."""

import pytest
import sympy as sp

from stewart_sym.derive.mechanics import platform
from stewart_sym.derive.mechanics.formulation import EXACT, EXACT_SPHERICAL, FORMULATIONS, PAPER, Formulation
from stewart_sym.derive.mechanics.legs import leg
from stewart_sym.derive.mechanics.legs.base_frame import Transverse, scalar_form, vector_form
from stewart_sym.derive.program.block import Builder

L = sp.Symbol("L", positive=True)
K1, K3, KAPPA = sp.symbols("k1 k3 kappa", real=True)
C = sp.Matrix(sp.symbols("C_x C_y C_z", real=True))
S_HAT = sp.Matrix([1, 0, 0])


def vector(name: str) -> sp.Matrix:
    return sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z", real=True))


def leg_frame_motion() -> leg.LegFrameMotion:
    k = sp.Matrix([K1, 0, K3])
    return leg.LegFrameMotion(L, 1 / L, k, 1 / K3, K1 / K3, *map(vector, ("u", "e", "gamma", "w")))


def solved(form: Formulation) -> tuple[dict[str, sp.Expr], leg.PartForces, leg.LegConstants, sp.Expr]:
    """The twelve unknowns by name, in terms of C, x and the named forces."""
    m = leg_frame_motion()
    part = leg.PartForces(*(vector(name) for name in ("r_d", "r_u", "N_d", "N_u", "E_d", "E_u", "f")))
    constants = leg.constants()
    L_dot = sp.Symbol("L_dot", real=True)
    equations = leg.leg_equations(form, constants, m, L_dot, vector("W"), part)
    answer = leg.eliminate(form, equations, C)
    return {symbol.name: value for symbol, value in answer.items()}, part, constants, L_dot


def same(left: sp.Matrix, right: sp.Matrix) -> bool:
    return (left - right).applyfunc(sp.simplify).is_zero_matrix


def component(answer: dict[str, sp.Expr], name: str) -> sp.Matrix:
    return sp.Matrix([answer[f"{name}_{axis}"] for axis in "xyz"])


@pytest.mark.parametrize("form", FORMULATIONS, ids=lambda form: form.kernel_name)
def test_twelve_equations_have_thirteen_unknowns(form: Formulation) -> None:
    part = leg.PartForces(*(vector(name) for name in ("r_d", "r_u", "N_d", "N_u", "E_d", "E_u", "f")))
    equations = leg.leg_equations(
        form, leg.constants(), leg_frame_motion(), sp.Symbol("L_dot"), vector("W"), part
    )
    rows = [equations.newton_lower, equations.euler_lower, equations.newton_upper, equations.euler_upper]
    assert sum(len(row) for row in rows) == 12
    assert 1 + len(equations.unknowns) == (13 if form.base_joint == "universal" else 12)


def test_paper_elimination_gives_equation_21_and_29() -> None:
    answer, *_ = solved(PAPER)
    assert same(sp.Matrix([0, answer["F_s_y"], answer["F_s_z"]]), C.cross(S_HAT) / L)
    assert sp.simplify(answer["M_u"] - S_HAT.dot(C)) == 0


def test_exact_elimination_gives_the_corrected_K_and_moment() -> None:
    answer, *_ = solved(EXACT)
    assert sp.simplify(answer["M_u"] + C[0] / K3) == 0
    assert sp.simplify(answer["F_s_y"] - (C[2] + K1 / K3 * C[0]) / L) == 0
    assert sp.simplify(answer["F_s_z"] + C[1] / L) == 0


@pytest.mark.parametrize("form", [EXACT, PAPER, EXACT_SPHERICAL], ids=lambda form: form.kernel_name)
def test_elimination_gives_equations_24_26_and_27(form: Formulation) -> None:
    answer, part, constants, L_dot = solved(form)
    F_s = sp.Matrix([leg.AXIAL, answer["F_s_y"], answer["F_s_z"]])
    F_p = part.N_u - F_s + constants.C_p * L_dot * S_HAT
    assert same(component(answer, "F_p"), F_p)
    assert same(component(answer, "F_u"), part.N_d + part.N_u - F_s)
    D = part.N_u[0] + constants.C_p * L_dot
    assert sp.simplify(answer["F_p_x"] - (D - leg.AXIAL)) == 0


@pytest.mark.parametrize("form", [EXACT, PAPER], ids=lambda form: form.kernel_name)
def test_known_part_of_the_whole_leg_is_C_of_equation_20(form: Formulation) -> None:
    _, part, constants, L_dot = solved(form)
    W = vector("W")
    equations = leg.leg_equations(form, constants, leg_frame_motion(), L_dot, W, part)
    printed = (
        part.r_d.cross(part.N_d) + part.r_u.cross(part.N_u) + part.E_d + part.E_u + constants.C_u * W + part.f
    )
    assert same(leg.whole_leg(equations)[1], printed)


def rotation(form: Formulation) -> tuple[sp.Expr, sp.Matrix, sp.Expr, sp.Matrix]:
    """L_dot, W, L_ddot, A as expressions of u, e, L, k1, k3."""
    build = Builder()
    found = leg.rotation(build, form, leg_frame_motion())
    back = build.substitution()
    return tuple(value.xreplace(back) for value in found)  # type: ignore[return-value]


def test_paper_rotation_is_equations_5_to_9() -> None:
    u, e = vector("u"), vector("e")
    L_dot, W, L_ddot, A = rotation(PAPER)
    assert sp.simplify(L_dot - S_HAT.dot(u)) == 0
    assert same(W, S_HAT.cross(u) / L)
    assert sp.simplify(L_ddot - (S_HAT.dot(e) + L * W.dot(W))) == 0
    assert same(A, (S_HAT.cross(e) - 2 * L_dot * W) / L)


@pytest.mark.parametrize("form", [EXACT, PAPER], ids=lambda form: form.kernel_name)
def test_rotation_moves_the_tip_as_the_platform_does(form: Formulation) -> None:
    L_dot, W, L_ddot, A = rotation(form)
    S = L * S_HAT
    assert same(L_dot * S_HAT + W.cross(S), vector("u"))
    tip = L_ddot * S_HAT + W.cross(W.cross(S)) + 2 * L_dot * W.cross(S_HAT) + A.cross(S)
    assert same(tip, vector("e"))


def test_exact_rotation_is_the_closed_form_with_kappa() -> None:
    _, W, _, A = rotation(EXACT)
    on_sphere = {K1: KAPPA * K3}
    W, A = W.subs(on_sphere), A.subs(on_sphere)
    assert sp.simplify(W[0] - KAPPA * W[2]) == 0
    unit = {KAPPA: sp.sqrt(1 - K3**2) / K3}
    assert sp.simplify((A[0] - KAPPA * A[2] + W[1] * W[2] / K3**2).subs(unit)) == 0


def test_exact_without_spin_terms_is_paper() -> None:
    _, W, _, A = rotation(EXACT)
    _, W_paper, _, A_paper = rotation(PAPER)
    assert same(W.subs(K1, 0), W_paper)
    assert same(A.subs(K1, 0)[1:, :], A_paper[1:, :])


def test_universal_joint_keeps_W_normal_to_n_as_the_leg_turns() -> None:
    """The condition holds at the next instant too: A satisfies the derivative of W.n = 0."""
    _, W, _, A = rotation(EXACT)
    k, y = sp.Matrix([K1, 0, K3]), sp.Matrix([0, 1, 0])
    assert sp.simplify(W.dot(k.cross(y))) == 0
    assert sp.simplify(A.dot(k.cross(y)) + W.dot(k.cross(W.cross(y)))) == 0


def test_double_counted_transport_is_fault_3() -> None:
    c = leg.constants()
    (_, right), (_, printed) = leg.inertias(EXACT, c, L), leg.inertias(PAPER, c, L)
    assert right == c.I_u0
    assert printed - right == c.m_u * L**2 * sp.diag(0, 1, 1)


def test_platform_equations_give_H_and_c_of_equation_35() -> None:
    N, R_G, F, E, M = (vector(name) for name in ("N", "R_G", "F", "E", "M"))
    found = platform.equations_of_motion(N, R_G, F, E, M)
    c = sp.Matrix([*(F + N), *(R_G.cross(N) - E + M)])
    for i in platform.LEGS:
        s, q, K, f = (
            sp.Matrix(sp.symbols(f"{name}_x_{i} {name}_y_{i} {name}_z_{i}", real=True)) for name in "sqKf"
        )
        assert same(found.H[:, i - 1], sp.Matrix([*s, *q.cross(s)]))
        c -= sp.Matrix([*K, *(q.cross(K) - f)])
    assert same(found.c, c)


def test_legs_that_enter_differently_are_rejected() -> None:
    N, R_G, F, E, M = (vector(name) for name in ("N", "R_G", "F", "E", "M"))
    found = platform.equations_of_motion(N, R_G, F, E, M)
    twisted = platform.PlatformEquations(found.H * sp.diag(1, 1, 1, 1, 1, 2), found.x, found.c)
    with pytest.raises(ValueError, match="alike"):
        platform.leg_share(twisted)


def transverse(name: str) -> Transverse:
    y, z = sp.symbols(f"{name}_y {name}_z", real=True)
    return Transverse(name, y, z, vector(f"{name}_base"))


def test_isotropic_vector_is_written_in_base_vectors() -> None:
    v, a = transverse("v"), sp.Symbol("a", real=True)
    local = sp.Matrix([a * v.y - 3 * v.z, a * v.z + 3 * v.y])
    build = Builder()
    found = vector_form(build, "Q", local, (v,), vector("s"))
    assert same(found, a * v.base + 3 * vector("s").cross(v.base))


def test_anisotropic_results_are_rejected() -> None:
    v = transverse("v")
    with pytest.raises(ValueError, match="not isotropic in v"):
        vector_form(Builder(), "Q", sp.Matrix([2 * v.y, v.z]), (v,), vector("s"))
    with pytest.raises(ValueError, match="belongs to no vector"):
        vector_form(Builder(), "Q", sp.Matrix([v.y + 1, v.z]), (v,), vector("s"))
    with pytest.raises(ValueError, match="not a function of"):
        scalar_form(v.y**2 + 2 * v.z**2, v, sp.Symbol("vv"))
