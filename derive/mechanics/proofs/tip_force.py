"""Force at the tip of a leg, derived in three ways: equations of the leg, Lagrange's equations, closed form.

With the actuator force F, the force on a leg at its spherical joint is F_s = x s + K with x = D - F. So the
force that moves the tip is D s + K, of which the actuator provides F s. It is a function of the tip's
velocity u and acceleration e, gravity gamma, and the platform's omega in the leg frame, without prepared
constants. The tests and the notebook prove that the three results are equal for `exact`.
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
    """Compute D s + K from the twelve equations of ``leg``, 3x1, leg frame."""
    build = Builder()
    seen = leg.LegFrameMotion(tip.L, tip.inv_L, k, inv_k3, tip.kappa, u, e, gamma, omega)
    found = leg.leg_dynamics(build, form, leg.constants(), seen, with_reactions=False)
    return (found.D * leg.X_AXIS + found.K).xreplace(build.substitution())


def by_lagrange() -> sp.Matrix:
    """Compute Gamma^T tau with tau from the energies of the two bodies, 3x1, leg frame."""
    return at_tip(tip.gradients().value.T * lagrange.torques(gamma, omega))


def by_closed_form() -> sp.Matrix:
    """Compute m S_ddot + C_tip S_dot + gravity + friction of ``tip``, 3x1, leg frame.

    The mass of the upper part is included.
    """
    G = tip.gradients().value
    force = inertia() * e + coriolis() * u + G.T * written_out(tip.gravity() + tip.friction())
    return at_tip(force - n.m_u.value * gamma)


def inertia() -> sp.Matrix:
    """Compute m of the closed form with the mass of the upper part, 3x3, leg frame."""
    G = tip.gradients().value
    return written_out(G.T * tip.inertia() * G) + n.m_u.value * sp.eye(3)


def coriolis() -> sp.Matrix:
    """Compute C_tip of the closed form, 3x3, leg frame; its entries contain the rates of L, theta, phi."""
    gradients, M = tip.gradients(), tip.inertia()
    return written_out(gradients.value.T * (tip.christoffel(M) * gradients.value + M * gradients.rate))


def at_tip(expr: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """Replace rates and accelerations of L, theta, phi by projections of u and e."""
    gradients = tip.gradients()
    seconds = gradients.value * e + gradients.rate * u
    return expr.xreplace(dict(zip(tip.accelerations, seconds, strict=True))).xreplace(
        dict(zip(tip.rates, gradients.value * u, strict=True))
    )


def rate(tensor: sp.Matrix) -> sp.Matrix:
    """Differentiate a 3x3 tensor by time in the leg frame, which rotates with W = phi_dot k + theta_dot y."""
    turn = leg.skew(tip.rates[2] * k + tip.rates[1] * leg.Y_AXIS)
    own = sum((tip.along(tensor, i) * tip.rates[i] for i in range(3)), sp.zeros(3))
    return own + turn * tensor - tensor * turn


def by_place(force: sp.Matrix) -> sp.Matrix:
    """Differentiate a force by S, 3x3, leg frame.

    S_dot, S_ddot, gravity, and omega are fixed in the base frame.
    """
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
    """Compute twice the vector of the antisymmetric part of a 3x3 matrix, in normal form.

    The result is zero if the matrix is symmetric.
    """
    return sp.Matrix(
        [matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1]]
    ).applyfunc(normal_form)


def prepared_constants() -> dict[sp.Symbol, sp.Expr]:
    """Express J, h, w, and C_u + C_s by the constants of the two parts."""
    wanted = (p.h, p.w, p.J, p.C_us)
    block = p.prepare_leg(wanted, p.Lumped(mass=True, friction=True))
    return {
        symbol: value
        for quantity in wanted
        for symbol, value in zip(quantity.symbols, block.formula(quantity.name), strict=True)
    }


def written_out(expr: sp.Matrix) -> sp.Matrix:
    """Replace prepared constants, and the projections of gravity and omega, by their definitions."""
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
