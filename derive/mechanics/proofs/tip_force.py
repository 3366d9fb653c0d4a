"""The force at a leg's tip derived in three ways: the leg's equations, Lagrange, closed form.

With F on its actuator a leg feels F_s = x s + K at its spherical joint, and x = D - F. So the force that
moves its tip is D s + K, of which the actuator bears F s. It is written in the leg frame with the tip's
velocity u, its acceleration e, gravity gamma and the platform's omega, and without prepared constants. The
tests and the notebook show that the three are equal for `exact`.
"""

import sympy as sp

from ...program.block import Builder
from .. import lumped_constants as p
from .. import quantities as n
from ..formulation import Formulation
from ..legs import leg, tip
from . import lagrange
from .normal_form import inv_k3, normal_form

u, e, gamma = (
    sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z", real=True)) for name in ("u", "e", "gamma")
)
omega = n.omega.value
k = sp.Matrix([tip.k1, 0, tip.k3])

_GIVEN = (u, e, gamma, omega)


def by_elimination(form: Formulation) -> sp.Matrix:
    """D s + K of the twelve equations of ``leg``, 3x1."""
    build = Builder()
    seen = leg.LegFrameMotion(tip.L, tip.inv_L, k, inv_k3, tip.kappa, u, e, gamma, omega)
    found = leg.leg_dynamics(build, form, leg.constants(), seen, with_reactions=False)
    return (found.D * leg.X_AXIS + found.K).xreplace(build.substitution())


def by_lagrange() -> sp.Matrix:
    """Gamma^T tau with tau from the energies of the two bodies, 3x1."""
    return at_tip(tip.gradients().value.T * lagrange.torques(gamma, omega))


def by_closed_form() -> sp.Matrix:
    """m S_ddot + C_tip S_dot + gravity + friction of ``tip``, 3x1, the upper part's mass put back."""
    G = tip.gradients().value
    force = inertia() * e + coriolis() * u + G.T * written_out(tip.gravity() + tip.friction())
    return at_tip(force - n.m_u.value * gamma)


def inertia() -> sp.Matrix:
    """m of the closed form with the upper part's mass, 3x3."""
    G = tip.gradients().value
    return written_out(G.T * tip.inertia() * G) + n.m_u.value * sp.eye(3)


def coriolis() -> sp.Matrix:
    """C_tip of the closed form, 3x3; its entries hold the rates of L, theta, phi."""
    gradients, M = tip.gradients(), tip.inertia()
    return written_out(gradients.value.T * (tip.christoffel(M) * gradients.value + M * gradients.rate))


def at_tip(expr: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """Rates and accelerations of L, theta, phi as projections of u and e."""
    gradients = tip.gradients()
    seconds = gradients.value * e + gradients.rate * u
    return expr.xreplace(dict(zip(tip.accelerations, seconds, strict=True))).xreplace(
        dict(zip(tip.rates, gradients.value * u, strict=True))
    )


def rate(tensor: sp.Matrix) -> sp.Matrix:
    """Time derivative of a 3x3 tensor in the leg frame, which turns with W = phi_dot k + theta_dot y."""
    turn = leg.skew(tip.rates[2] * k + tip.rates[1] * leg.Y_AXIS)
    own = sum((tip.along(tensor, i) * tip.rates[i] for i in range(3)), sp.zeros(3))
    return own + turn * tensor - tensor * turn


def by_place(force: sp.Matrix) -> sp.Matrix:
    """Derivative of a force by S, 3x3, leg frame; S_dot, S_ddot, gravity and omega are fixed in the base."""
    force = force.applyfunc(normal_form)
    columns = []
    for i in range(3):
        step = tip.gradients().value[:, i]
        turn = step[2] * k + step[1] * leg.Y_AXIS
        change = sum((tip.along(force, j) * step[j] for j in range(3)), turn.cross(force))
        for vector in _GIVEN:
            change -= force.jacobian(vector) * turn.cross(vector)
        columns.append(change)
    return sp.Matrix.hstack(*columns)


def antisymmetric(matrix: sp.Matrix) -> sp.Matrix:
    """Twice the vector of the antisymmetric part of a 3x3 matrix, in normal form: zero if it is symmetric."""
    return sp.Matrix(
        [matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]
    ).applyfunc(normal_form)


def prepared_constants() -> dict[sp.Symbol, sp.Expr]:
    """J, h, w and C_u + C_s in the constants of the two parts."""
    wanted = (p.h, p.w, p.J, p.C_us)
    block = p.prepare_leg(wanted, p.Lumped(mass=True, friction=True))
    return {
        symbol: value
        for quantity in wanted
        for symbol, value in zip(quantity.symbols, block.formula(quantity.name), strict=True)
    }


def written_out(expr: sp.Matrix) -> sp.Matrix:
    """Without prepared constants, and with gravity and omega by components."""
    y, normal = leg.Y_AXIS, k.cross(leg.Y_AXIS)
    return expr.xreplace(
        prepared_constants()
        | {
            tip.GAMMA_N: normal.dot(gamma),
            tip.GAMMA_Y: y.dot(gamma),
            p.g_k.value: k.dot(gamma),
            tip.OMEGA_N: normal.dot(omega),
            tip.OMEGA_Y: y.dot(omega),
            tip.OMEGA_K: k.dot(omega),
        }
    )
