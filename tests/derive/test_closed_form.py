"""The closed form in symbols: equal to the elimination and to Lagrange's equations, and conservative."""

import dataclasses
import functools
from collections.abc import Sequence

import pytest
import sympy as sp

from stewart_sym.derive.mechanics import closed_form
from stewart_sym.derive.mechanics import lumped_constants as p
from stewart_sym.derive.mechanics import quantities as n
from stewart_sym.derive.mechanics.formulation import EXACT, PAPER, Formulation
from stewart_sym.derive.mechanics.legs import leg, tip
from stewart_sym.derive.mechanics.proofs import lagrange, tip_force
from stewart_sym.derive.mechanics.proofs.normal_form import cos_phi, inv_k3, normal_form, sin_phi, vanishes
from stewart_sym.derive.mechanics.proofs.tip_force import antisymmetric, e, gamma, u
from stewart_sym.derive.program.block import Block, Builder, Quantity, substitution

L, k1, k3 = tip.L, tip.k1, tip.k3
u_x, u_y, u_z = u
m_u = n.m_u.value
PREPARED = tip_force.prepared_constants()
NO_FRICTION = dict.fromkeys((symbol for q in n.FRICTION for symbol in q.symbols), 0)
STILL = dict.fromkeys(u, 0) | dict.fromkeys(e, 0)

FAULTS = {
    "spin": dataclasses.replace(EXACT, no_spin=True),
    "moment": dataclasses.replace(EXACT, moment_along_leg=True),
    "transport": dataclasses.replace(EXACT, transport_twice=True),
    "paper": PAPER,
}


@functools.cache
def eliminated(form: Formulation) -> sp.Matrix:
    """The force at the tip without friction."""
    return tip_force.by_elimination(form).xreplace(NO_FRICTION)


# ---------------------------------------------------------------- normal forms


def test_normal_form_knows_the_relations_of_the_geometry() -> None:
    assert vanishes(k1**4 - (1 - k3**2) ** 2)
    assert vanishes(tip.kappa * k3 - k1)
    assert vanishes(1 + tip.kappa**2 - inv_k3**2)
    assert vanishes(tip.inv_rho * L**2 - L / k3)
    assert vanishes(cos_phi**2 + sin_phi**2 - 1)


def test_normal_form_keeps_apart_what_differs() -> None:
    for expr in (k1 - k3, k1**2 - k3**2, tip.inv_L - inv_k3, tip.kappa - inv_k3, m_u * k1 / L - m_u * k1):
        assert not vanishes(expr)
    assert normal_form(k1**3) == k1 - k1 * k3**2
    assert not vanishes(sp.Matrix([0, k1]))


# ---------------------------------------------------------------- the force at the tip


def test_leg_feels_the_force_of_its_tip_less_the_actuators() -> None:
    build = Builder()
    seen = leg.LegFrameMotion(L, tip.inv_L, tip_force.k, inv_k3, tip.kappa, u, e, gamma, n.omega.value)
    found = leg.leg_dynamics(build, EXACT, leg.constants(), seen, with_reactions=True)
    F = found.reactions["F_p"][0].subs(build.substitution())
    F_s = found.reactions["F_s"].xreplace(build.substitution())
    assert vanishes(F_s + F * leg.X_AXIS - tip_force.by_elimination(EXACT))


def test_closed_form_is_the_elimination() -> None:
    assert vanishes(tip_force.by_closed_form() - tip_force.by_elimination(EXACT))


@pytest.mark.slow
def test_closed_form_is_lagranges_equations_of_two_bodies() -> None:
    assert vanishes(tip_force.by_closed_form() - tip_force.by_lagrange())


@pytest.mark.parametrize("form", FAULTS.values(), ids=FAULTS.keys())
def test_no_fault_is_in_the_closed_form(form: Formulation) -> None:
    assert not vanishes(tip_force.by_closed_form() - tip_force.by_elimination(form))


def test_inertia_at_the_tip_is_that_of_the_kinetic_energy() -> None:
    G = tip.gradients().value
    m = G.T * lagrange.inertia() * G
    assert vanishes(m - tip_force.inertia())
    assert vanishes(m - eliminated(EXACT).jacobian(e))


# ---------------------------------------------------------------- inertia and Coriolis matrix


def test_inertia_at_the_tip_is_symmetric_and_its_rate_less_twice_C_skew() -> None:
    m, C = tip_force.inertia(), tip_force.coriolis()
    assert vanishes(m - m.T)
    rest = tip_force.rate(m) - 2 * C
    assert vanishes(rest + rest.T)
    assert not vanishes(rest)


def kept(block: Block, *names: str) -> dict[str, sp.Matrix]:
    """What a block hands out, in terms of the steps of the quantities in ``names``."""
    back = substitution(step for step in block.steps if step.name.rpartition("_")[0] not in names)
    return {
        out.quantity.name: filled(out.quantity, [sp.sympify(entry).xreplace(back) for entry in out.exprs])
        for out in block.outputs
    }


def filled(quantity: Quantity, entries: Sequence[sp.Expr]) -> sp.Matrix:
    """The quantity with these entries in place of its symbols."""
    return quantity.value.xreplace(dict(zip(quantity.symbols, entries, strict=True)))


def tensor(name: str, symmetric: bool = False) -> sp.Matrix:
    return Quantity(name, (3, 3), "", "", symmetric).value


def whole(found: dict[str, sp.Matrix], name: str) -> sp.Matrix:
    """M or C, 6x6, of a block's outputs."""
    upper = found[f"{name}_vw"]
    lower = found.get(f"{name}_wv", upper.T)
    return sp.Matrix(sp.BlockMatrix([[found[f"{name}_vv"], upper], [lower, found[f"{name}_ww"]]]))


@pytest.mark.slow
def test_platform_sees_the_leg_through_J_and_the_sum_stays_skew() -> None:
    (block,) = (kernel.leg for kernel in closed_form.kernels() if kernel.name == "equations")
    found = kept(block, "m", "C_tip", "q", "w_q")
    m, C_tip = tensor("m", True), tensor("C_tip")
    q, w_q = n.q.value, sp.Matrix(sp.symbols("w_q_x w_q_y w_q_z", real=True))
    J = sp.Matrix.hstack(sp.eye(3), -leg.skew(q))
    J_dot = sp.Matrix.hstack(sp.zeros(3), -leg.skew(w_q))
    M, C = whole(found, "M"), whole(found, "C")
    assert vanishes(M - J.T * m * J)
    assert vanishes(C - J.T * (C_tip * J + m * J_dot))
    m_dot = C_tip + C_tip.T  # what skewness at the tip says
    rest = J_dot.T * m * J + J.T * m_dot * J + J.T * m * J_dot - 2 * C
    assert vanishes(rest + rest.T)


def test_platform_itself_follows_from_newton_and_euler_and_its_rest_is_skew() -> None:
    (block,) = (kernel.pose for kernel in closed_form.kernels() if kernel.name == "equations")
    found = kept(block, "h_base", "J_base")
    M, C = whole(found, "M"), whole(found, "C")
    omega, alpha, a, v, g = (q.value for q in (n.omega, n.alpha, n.a, n.v, n.g))
    h, J = sp.Matrix(sp.symbols("h_base_x h_base_y h_base_z", real=True)), tensor("J_base", True)
    mass, turn = p.M_P.value, leg.skew(omega)
    force = mass * (a - g) + alpha.cross(h) + omega.cross(omega.cross(h))
    moment = h.cross(a - g) + J * alpha + omega.cross(J * omega)
    motion_of = M * sp.Matrix([*a, *alpha]) + C * sp.Matrix([*v, *omega])
    gravity = sp.Matrix([*found["g_force"], *found["g_moment"]])
    assert vanishes(motion_of + gravity - sp.Matrix([*force, *moment]))
    h_dot, J_dot = omega.cross(h), turn * J - J * turn
    M_dot = sp.Matrix(sp.BlockMatrix([[sp.zeros(3), -leg.skew(h_dot)], [leg.skew(h_dot), J_dot]]))
    assert vanishes(M_dot - 2 * C + (M_dot - 2 * C).T)


def test_mass_at_the_platform_point_is_the_mass_lumped_with_it() -> None:
    block = p.prepare_leg((), p.Lumped(mass=True, friction=False))
    J = sp.Matrix.hstack(sp.eye(3), -leg.skew(n.p.value - n.p_1.value))
    M_add, h_add, J_add = (filled(q, block.formula(q.name)) for q in (p.M_add, p.h_add, p.J_add))
    lumped = sp.BlockMatrix([[M_add * sp.eye(3), -leg.skew(h_add)], [leg.skew(h_add), J_add]])
    assert vanishes(J.T * m_u * J - sp.Matrix(lumped))


# ---------------------------------------------------------------- derivatives


@pytest.mark.slow
def test_derivatives_at_the_tip_are_those_of_the_force() -> None:
    at, M = tip.gradients(), tip.inertia()
    raw = tip.torques(with_friction=True)
    by_rate, by_place = raw.jacobian(tip.rates), tip.place(raw)
    tau = sp.Matrix(sp.symbols("tau_L tau_theta tau_phi", real=True))
    bend = tip.hessian(tau).xreplace(dict(zip(tau, raw, strict=True)))
    by_S_dot = at.value.T * (2 * M * at.rate + by_rate * at.value)
    by_S = at.value.T * (M * at.second + by_rate * at.rate + by_place * at.value) + bend
    force = tip_force.by_closed_form() - m_u * (e - gamma)
    for derivative, expected in ((by_S_dot, force.jacobian(u)), (by_S, tip_force.by_place(force))):
        assert vanishes(tip_force.at_tip(tip_force.written_out(derivative)) - expected)


# ---------------------------------------------------------------- the faults


def lopsided(form: Formulation) -> sp.Matrix:
    """Antisymmetric part of the derivative by S_ddot."""
    return antisymmetric(eliminated(form).jacobian(e))


def curl(form: Formulation) -> sp.Matrix:
    """Antisymmetric part of the derivative of the leg's weight at its tip by S."""
    return antisymmetric(tip_force.by_place(eliminated(form).xreplace(STILL)))


def power_from_nothing(form: Formulation) -> sp.Expr:
    """Power of the force of inertia at constant velocity less the rate of S_dot.m S_dot / 2.

    Zero if and only if the force is C S_dot with a C that makes the rate of m less twice C skew.
    """
    force = eliminated(form)
    m = force.jacobian(e).applyfunc(normal_form)
    bias = force.xreplace(dict.fromkeys((*e, *gamma), 0))
    return normal_form(u.dot(bias) - (u.T * tip_force.at_tip(tip_force.rate((m + m.T) / 2)) * u)[0] / 2)


def same(found: sp.Expr | sp.Matrix, expected: sp.Expr | sp.Matrix) -> bool:
    """Whether two results agree, the second one in prepared constants."""
    return vanishes(found - expected.xreplace(PREPARED))


def test_exact_is_symmetric_conservative_and_makes_no_power() -> None:
    assert vanishes(lopsided(EXACT))
    assert vanishes(curl(EXACT))
    assert power_from_nothing(EXACT) == 0


def test_spin_or_moment_alone_make_the_inertia_lopsided_and_hide_each_other_in_paper() -> None:
    J, h = p.J.value, p.h.value
    amount = tip.kappa * (J[0, 1] - L * h[1]) / L**2 * leg.X_AXIS
    assert same(lopsided(FAULTS["spin"]), amount)
    assert same(lopsided(FAULTS["moment"]), -amount)
    assert vanishes(lopsided(FAULTS["transport"]))
    assert vanishes(lopsided(PAPER))


def test_moment_along_the_leg_makes_weight_that_no_potential_has() -> None:
    w = p.w.value
    swirl = (tip.kappa * w[1] * gamma[0] + w[2] * gamma[1] - w[1] * gamma[2]) / L**2 * leg.X_AXIS
    for form in FAULTS.values():
        assert same(curl(form), swirl if form.moment_along_leg else sp.zeros(3, 1))


def test_paper_makes_power_from_nothing() -> None:
    J, h = p.J.value, p.h.value
    turning = (J[1, 1] - J[2, 2]) * u_y * u_z - J[1, 2] * (u_y**2 - u_z**2)
    sliding = L * u_x * (h[1] * u_z - h[2] * u_y)
    transport = -m_u * u_x * (u_y**2 + u_z**2) / L
    assert same(power_from_nothing(PAPER), tip.kappa * u_y * (turning + sliding) / L**3 + transport)
    assert vanishes(power_from_nothing(FAULTS["transport"]) - transport)
    for alone in ("spin", "moment"):
        assert power_from_nothing(FAULTS[alone]) != 0
