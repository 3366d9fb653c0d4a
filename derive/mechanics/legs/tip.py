"""One leg as a mechanism with three degrees of freedom at its tip: mass matrix, Coriolis matrix, derivatives.

The tip is the platform point of the leg. The joint coordinates xi = (L, theta, phi) of ``joint_coordinates``
are functions of S. Gamma is the gradient of xi, so xi_dot = Gamma S_dot, and the force at the tip is F =
Gamma^T tau:

    m = Gamma^T M Gamma,   C_tip = Gamma^T (C_xi Gamma + M Gamma_dot),
    dF/dS_ddot = m,   dF/dS_dot = Gamma^T (2 M Gamma_dot + tau_rate Gamma),
    dF/dS = Gamma^T (M Gamma_ddot + tau_rate Gamma_dot + tau_place Gamma) + sum of tau_a Hess xi_a.

These formulas use dxi_dot/dS = Gamma_dot, dxi_ddot/dS = Gamma_ddot, and dxi_ddot/dS_dot = 2 Gamma_dot, which
are valid for any coordinates. All matrices are in the leg frame, in which Gamma has three nonzero entries.
C_xi consists of Christoffel symbols, so that m_dot - 2 C_tip is skew-symmetric.
"""

from dataclasses import dataclass

import sympy as sp

from ...program.block import Builder
from .. import lumped_constants as p
from .. import quantities as n
from .joint_coordinates import JointFrame, joint_inertia
from .leg import skew
from .rotor import NONE, Rotor

L, k1, k3, inv_L, inv_rho, kappa = sp.symbols("L k1 k3 inv_L inv_rho kappa", real=True)
rates = sp.symbols("L_dot theta_dot phi_dot", real=True)
accelerations = sp.symbols("L_ddot theta_ddot phi_ddot", real=True)

_SLOPES: tuple[dict[sp.Symbol, sp.Expr], ...] = (
    {L: 1, inv_L: -(inv_L**2), inv_rho: -inv_L * inv_rho},
    {k1: -k3, k3: k1, inv_rho: -kappa * inv_rho, kappa: -1 - kappa**2},
    {},
)
"""Derivatives of the leg's geometry by L, theta, phi, with k1 = cos theta, k3 = sin theta, kappa = k1 / k3.
"""


def along(expr: sp.Expr | sp.Matrix, coordinate: int) -> sp.Expr | sp.Matrix:
    """Differentiate by L, theta, or phi (coordinate 0, 1, or 2)."""
    slopes = [expr.diff(symbol) * slope for symbol, slope in _SLOPES[coordinate].items()]
    return sum(slopes[1:], slopes[0]) if slopes else 0 * expr


def inertia(rotor: Rotor = NONE) -> sp.Matrix:
    """Compute the mass matrix M of (L, theta, phi), 3x3, from J and h.

    The mass of the upper part is lumped with the platform.
    """
    build = Builder()
    nowhere = sp.zeros(3, 1)
    frame = JointFrame(nowhere, nowhere, nowhere, L, inv_L, inv_rho, k1, k3, kappa, rotor=rotor)
    M = joint_inertia(build, frame).matrix().xreplace(build.substitution())
    return M.xreplace({quantity.value: value for quantity, value in p.COMBINED.items()})


def christoffel(M: sp.Matrix) -> sp.Matrix:
    """Compute C_xi, 3x3: C_ij = sum over k of (M_ij,k + M_ik,j - M_jk,i) xi_dot_k / 2."""
    by = [along(M, coordinate) for coordinate in range(3)]
    half = sp.Rational(1, 2)
    return sp.Matrix(
        3,
        3,
        lambda i, j: sum(half * (by[k][i, j] + by[j][i, k] - by[i][j, k]) * rates[k] for k in range(3)),
    )


def gravity() -> sp.Matrix:
    """Compute the generalized force that balances gravity, 3x1, with gamma as in ``joint_coordinates``."""
    wx, wy, wz = p.w.value
    w_k, w_n = k1 * wx + k3 * wz, k3 * wx - k1 * wz
    return sp.Matrix([0, w_n * p.g_k.value + w_k * GAMMA_N, -wy * GAMMA_N - w_n * GAMMA_Y])


GAMMA_N, GAMMA_Y = sp.symbols("gamma_n gamma_y", real=True)
OMEGA_N, OMEGA_Y, OMEGA_K = sp.symbols("w_n_omega w_y_omega w_k_omega", real=True)


def friction() -> sp.Matrix:
    """Compute the generalized force of the joint friction, 3x1.

    OMEGA_Y and OMEGA_K are the components of omega along y and k.
    """
    C_s, C_us = n.C_s.value, p.C_us.value
    return sp.Matrix(
        [
            n.C_p.value * rates[0],
            C_us * rates[1] - C_s * OMEGA_Y,
            C_us * rates[2] - C_s * OMEGA_K,
        ]
    )


def torques(with_friction: bool, rotor: Rotor = NONE) -> sp.Matrix:
    """Compute Lagrange's generalized forces, 3x1: M xi_ddot + C_xi xi_dot + gravity + friction."""
    M = inertia(rotor)
    tau = M * sp.Matrix(accelerations) + christoffel(M) * sp.Matrix(rates) + gravity()
    return tau + friction() if with_friction else tau


def place(expr: sp.Matrix) -> sp.Matrix:
    """Differentiate generalized forces by L, theta, phi at fixed rates and accelerations, 3x3.

    Vectors that are fixed in the base frame rotate relative to the leg as phi grows: d gamma_y / d phi =
    gamma_n and d gamma_n / d phi = -gamma_y, and likewise for omega; d gamma / d theta = 0.
    """
    turned = (
        expr.diff(GAMMA_Y) * GAMMA_N
        - expr.diff(GAMMA_N) * GAMMA_Y
        + expr.diff(OMEGA_Y) * OMEGA_N
        - expr.diff(OMEGA_N) * OMEGA_Y
    )
    return sp.Matrix.hstack(along(expr, 0), along(expr, 1), turned)


def of_rod(forces: sp.Matrix) -> sp.Matrix:
    """Reduce the generalized forces of ``torques`` to a thin rod along the leg, without friction."""
    (_, hy, hz), (_, wy, wz), J = p.h.value, p.w.value, p.J.value
    others = (hy, hz, wy, wz, J[0, 0], J[0, 1], J[0, 2], J[1, 2], p.C_us.value, n.C_s.value, n.C_p.value)
    return forces.xreplace(dict.fromkeys((*others, n.j_r.value), sp.S.Zero))


@dataclass(frozen=True)
class Gradients:
    """Gradient of L, theta, phi by S and its time derivatives, leg frame.

    The rows belong to L, theta, phi, the columns to s, y, z.

    Attributes
    ----------
    value, rate, second : Matrix, shape (3, 3)
        Gamma, Gamma_dot, and Gamma_ddot.
    """

    value: sp.Matrix
    rate: sp.Matrix
    second: sp.Matrix


def of_tip() -> sp.Matrix:
    """Return Gamma^-1, the derivative of the tip position by L, theta, and phi, 3x3, leg frame."""
    return sp.Matrix([[1, 0, 0], [0, 0, L * k3], [0, -L, 0]])


def by_place_of_force(force: sp.Matrix) -> sp.Matrix:
    """Differentiate the generalized forces Gamma^-T force by S, 3x3, leg frame.

    ``force`` acts at the tip and is fixed in the base frame. Gamma^-1 rotates with the leg and varies with
    its length.
    """
    f_s, f_y, f_z = force
    return sp.Matrix(
        [
            [0, inv_L * f_y, inv_L * f_z],
            [-f_z, k1 * inv_k3 * f_y, f_s],
            [k3 * f_y, k1 * f_z - k3 * f_s, -k1 * f_y],
        ]
    )


def gradients() -> Gradients:
    """Compute the gradients of L, theta, phi for a leg that rotates with W = phi_dot k + theta_dot y."""
    W = sp.Matrix([k1 * rates[2], rates[1], k3 * rates[2]])
    value = sp.Matrix([[1, 0, 0], [0, 0, -inv_L], [0, inv_rho, 0]])
    rate = _rate(value) - value * skew(W)
    return Gradients(value, rate, _rate(rate) - rate * skew(W))


def _rate(expr: sp.Matrix) -> sp.Matrix:
    """Differentiate leg-frame entries by time."""
    by_place = sum((along(expr, i) * rates[i] for i in range(3)), sp.zeros(*expr.shape))
    return by_place + sum((expr.diff(rates[i]) * accelerations[i] for i in range(3)), sp.zeros(*expr.shape))


# Unlike the rates of theta and phi, these remain finite near the joint singularity: the leg's
# rotation about y and z, with accelerations that exclude the frame's rotation about s.
inv_k3, W_z, OWN_Y, OWN_Z = sp.symbols("inv_k3 W_z own_y own_z", real=True)


def gathered(expr: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """Rewrite an expression in quantities that remain finite near the joint singularity.

    These are ``W_z``, ``OWN_Y``, ``OWN_Z``, and powers of 1 / L and 1 / k3, with inertial constants
    collected. Terms that cancel for all legs are removed. For axisymmetric legs the constants of each power
    of 1 / k3 cancel. So near the joint singularity no small result is the difference of large terms.
    """
    if isinstance(expr, sp.MatrixBase):
        return expr.applyfunc(gathered)
    spin = W_z * inv_k3
    finite = {
        accelerations[1]: OWN_Y + k1 * W_z * spin,
        accelerations[2]: OWN_Z * inv_k3 - 2 * k1 * inv_k3 * spin * rates[1],
        inv_rho: inv_L * inv_k3,
        kappa: k1 * inv_k3,
        rates[2]: spin,
    }
    expr = sp.expand(sp.sympify(expr).xreplace(finite).xreplace({rates[2]: spin}))
    constants = {symbol for quantity in _CONSTANTS for symbol in quantity.symbols}
    others = [s for s in sorted(expr.free_symbols, key=str) if s not in {*constants, *_GEOMETRY}]
    total: dict[tuple[int, ...], sp.Expr] = {}
    for powers, factor in sp.Poly(expr, *_GEOMETRY, *others).terms():
        for reduced, sign in _reduced(powers):
            total[reduced] = total.get(reduced, 0) + sign * factor
    symbols = (*_GEOMETRY, *others)
    return sp.Add(
        *(
            sp.Mul(*(s**power for s, power in zip(symbols, powers, strict=True))) * sp.expand(factor)
            for powers, factor in total.items()
        )
    )


_CONSTANTS = (p.J, p.h, p.w, p.C_us, n.C_s, n.C_p, n.m_u, *n.ROTOR)
_GEOMETRY = (L, inv_L, k1, k3, inv_k3)


def _reduced(powers: tuple[int, ...]) -> list[tuple[tuple[int, ...], int]]:
    """Simplify a monomial by L / L = k3 / k3 = 1 and k1^2 = 1 - k3^2; return monomials and signs."""
    length, per_length, cosine, sine, per_sine, *rest = powers
    if cosine >= 2:
        return [
            (found, sign * factor)
            for more, factor in ((0, 1), (2, -1))
            for found, sign in _reduced((length, per_length, cosine - 2, sine + more, per_sine, *rest))
        ]
    a, b = min(length, per_length), min(sine, per_sine)
    return [((length - a, per_length - a, cosine, sine - b, per_sine - b, *rest), 1)]


def hessian(tau: sp.Matrix) -> sp.Matrix:
    """Compute the sum of tau_a times the second derivative of xi_a by S, 3x3, leg frame.

    The rows of Gamma_dot are linear in S_dot, which gives the second derivatives. ``tau``, 3x1, must not
    contain rates.
    """
    u = sp.Matrix(sp.symbols("u_x u_y u_z", real=True))
    by_tip = dict(zip(rates, gradients().value * u, strict=True))
    push = (gradients().rate.T * tau).xreplace(by_tip)
    return push.jacobian(u).applyfunc(sp.expand)
