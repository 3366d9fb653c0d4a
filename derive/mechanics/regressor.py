"""Regressor Y: H F + external wrench = Y pi, linear in the inertial and friction parameters pi.

The inertial parameters of a body are its mass, first moment, and inertia. For the lower part of a leg they
are about the base point, for the upper part about the platform point, for the platform about the reference
point. The friction coefficients of the leg follow. Lagrange's torques of ``tip`` are linear in pi, so the
columns of a leg are the derivatives of its torques, transformed to the tip. The upper part's mass is lumped
with the platform as a point mass. ``dependencies`` lists the columns that are linear combinations of others
for every robot. The formulation is `exact` with universal base joints.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from ..program.block import Block, Builder, Quantity, component_name, rebuilt
from . import lumped_constants as p
from . import quantities as n
from .closed_form.common_steps import name_omega
from .legs import tip
from .legs.joint_coordinates import JointFrame, gravity_torques, joint_accelerations, joint_frame, joint_rates
from .legs.leg import cross, platform_point_motion
from .legs.rotor import FULL

# Parameters of one leg and of the platform, in the order of their columns in Y.
h_d = Quantity("h_d", (3,), "kg m", "first moment of the lower part about the base point, frame D")
J_d = Quantity("J_d", (3, 3), "kg m^2", "inertia of the lower part about the base point, frame D", True)
h_u = Quantity("h_u", (3,), "kg m", "first moment of the upper part about the platform point, frame U")
J_u = Quantity("J_u", (3, 3), "kg m^2", "inertia of the upper part about the platform point, frame U", True)
h_P = Quantity("h_P", (3,), "kg m", "first moment of the platform about the reference point, platform frame")
J_P = Quantity(
    "J_P", (3, 3), "kg m^2", "inertia of the platform about the reference point, platform frame", True
)
LEG_PARAMETERS = (n.m_d, h_d, J_d, n.m_u, h_u, J_u, n.C_u, n.C_p, n.C_s)
PLATFORM_PARAMETERS = (n.M, h_P, J_P)

Column = tuple[sp.Matrix, sp.Matrix]


@dataclass(frozen=True)
class Regressor:
    """Blocks whose outputs are columns of Y.

    Outputs come in pairs: the force rows and the moment rows of the column of one parameter (``column``).

    Attributes
    ----------
    leg, platform : Block
        Columns of one leg, and of the platform.
    """

    leg: Block
    platform: Block


def column(parameter: str) -> tuple[Quantity, Quantity]:
    """Return the outputs of a parameter's component: force rows and moment rows of its column."""
    return (
        Quantity(f"force_{parameter}", (3,), "", f"column of {parameter}, force rows, base frame"),
        Quantity(f"moment_{parameter}", (3,), "", f"column of {parameter}, moment rows, base frame"),
    )


def names_of(parameters: Iterable[Quantity]) -> list[str]:
    """Return the names of the parameters' components in the order of the columns."""
    return [component_name(q.name, key) for q in parameters for key in q.keys]


def regressor() -> Regressor:
    """Derive the columns of one leg and of the platform."""
    return Regressor(_leg(LEG_PARAMETERS), _platform())


def rotor_columns() -> Block:
    """Derive the columns of the rotor constants of one leg, which ``regressor`` does not contain."""
    whole = _leg(n.ROTOR)
    kept = [out for out in whole.outputs if out.quantity.name.startswith(("force_", "moment_"))]
    return rebuilt(whole, whole.steps, kept, whole.inputs)


def dependencies() -> dict[str, dict[str, sp.Expr]]:
    """Return the columns of a leg that are sums of others for every robot.

    The result maps a parameter to {parameter: coefficient}. The lower part rotates about a fixed point, so
    its mass has no effect. Both parts rotate alike, so only the sum of their inertias matters. The upper
    part's mass acts at its platform point p as if it were fixed to the platform. On random robots all other
    columns are independent.
    """
    at_tip = p.point_inertia(sp.S.One, n.p.value)
    lumped = {n.M.name: sp.S.One}
    lumped |= dict(zip(h_P.names, n.p.value, strict=True))
    lumped |= {name: at_tip[key] for name, key in zip(J_P.names, J_P.keys, strict=True)}
    alike = {lower: {upper: sp.S.One} for lower, upper in zip(J_d.names, J_u.names, strict=True)}
    return {n.m_d.name: {}, n.m_u.name: lumped, **alike}


# ---------------------------------------------------------------- one leg


def _leg(parameters: tuple[Quantity, ...]) -> Block:
    build = Builder()
    at = joint_frame(build, with_z=True)
    q = at.q
    S_dot, S_ddot = platform_point_motion(build, q)
    rates = joint_rates(build, at, S_dot)
    joint_accelerations(build, at, rates, S_ddot)
    _projections(build, at)
    assert at.z is not None
    T = sp.Matrix.hstack(at.s, -at.inv_L * at.z, at.inv_rho * at.y)
    slopes = {name: _named_torques(build, name, torques) for name, torques in _torques_by_parameter().items()}
    W = build.vector("W", rates.phi * n.k.value + rates.theta * at.y, "(6)", "angular velocity of the leg")
    forces = {
        name: build.vector(f"R_{name}", T * torques, "", f"force at the tip by {name}")
        for name, torques in slopes.items()
    }
    forces[n.m_u.name] = build.vector("rise", S_ddot - n.g.value, "(18)", "S_ddot - g")
    columns = {name: (force, cross(q, force)) for name, force in forces.items()}
    force, moment = columns[n.C_s.name]
    columns[n.C_s.name] = force, moment + n.omega.value - W
    columns |= {lower: columns[upper] for lower, upper in zip(J_d.names, J_u.names, strict=True)}
    columns[n.m_d.name] = sp.zeros(3, 1), sp.zeros(3, 1)
    return build.block(
        "regressor_of_leg",
        "columns of one leg's parameters",
        (*n.LEG, *n.MOTION, n.g),
        [*_outputs(parameters, columns), (n.q, q), (n.L, at.L), (n.k3, at.k3)],
    )


def _projections(build: Builder, at: JointFrame) -> None:
    """Name the projections that ``tip`` uses: gravity and omega along the axes of the joint."""
    k, g = n.k.value, n.g.value
    build.scalar("g_k", g.dot(k), "", p.g_k.meaning)
    build.vector("g_x_k", cross(g, k), "", p.g_x_k.meaning)
    gravity_torques(build, at)
    name_omega(build, at)


def _torques_by_parameter() -> dict[str, sp.Matrix]:
    """Differentiate Lagrange's torques, 3x1, by the parameters of a leg."""
    torques = tip.torques(True, FULL)

    def by(symbol: sp.Symbol) -> sp.Matrix:
        return torques.diff(symbol).applyfunc(_without_turning)

    found = {name: by(symbol) for name, symbol in zip(h_d.names, p.w.symbols, strict=True)}
    for name, lower, own in zip(h_u.names, h_d.names, p.h.symbols, strict=True):
        found[name] = found[lower] + by(own)
    found |= {name: by(symbol) for name, symbol in zip(J_u.names, p.J.symbols, strict=True)}
    C_us = by(p.C_us.value)
    found |= {q.name: by(q.value) for q in n.ROTOR}
    return found | {
        n.C_u.name: C_us,
        n.C_p.name: by(n.C_p.value),
        n.C_s.name: C_us + by(n.C_s.value),
    }


def _without_turning(torque: sp.Expr) -> sp.Expr:
    """Return a torque as a function of the own accelerations of ``JointAccelerations`` if it is shorter.

    The effect of the frame's rotation then cancels symbolically. Near the joint singularity it is much larger
    than the remaining terms.
    """
    (_, theta_dot, phi_dot), (_, theta_ddot, phi_ddot) = tip.rates, tip.accelerations
    own_theta, own_phi = sp.symbols("own_theta_ddot own_phi_ddot", real=True)
    turning = {
        theta_ddot: own_theta + tip.k1 * tip.k3 * phi_dot**2,
        phi_ddot: own_phi - 2 * tip.k1 / tip.k3 * theta_dot * phi_dot,
    }
    whole = sp.expand(torque)
    own = sp.expand(whole.xreplace(turning))
    return min(whole, own, key=sp.count_ops)


def _named_torques(build: Builder, name: str, torques: sp.Matrix) -> sp.Matrix:
    """Name a parameter's torques along L, theta, phi."""
    return sp.Matrix(
        [
            build.scalar(f"tau_{coordinate}_{name}", torque, "(20)", f"torques by {name}")
            for coordinate, torque in zip(("L", "theta", "phi"), torques, strict=True)
        ]
    )


# ---------------------------------------------------------------- the platform


def _platform() -> Block:
    build = Builder()
    R, omega, alpha = n.R.value, n.omega.value, n.alpha.value
    rise = build.vector("rise", n.a.value - n.g.value, "(33)", "a - g")
    omega_P = build.vector("omega_P", R.T * omega, "", "angular velocity, platform frame")
    alpha_P = build.vector("alpha_P", R.T * alpha, "", "angular acceleration, platform frame")
    columns: dict[str, Column] = {n.M.name: (rise, sp.zeros(3, 1))}
    for axis, name in enumerate(h_P.names):
        arm = R[:, axis]
        spin = build.vector(f"w_{name}", cross(omega, arm), "(31)", "omega x an axis of the platform")
        columns[name] = cross(alpha, arm) + cross(omega, spin), cross(arm, rise)
    for name in J_P.names:
        unit = J_P.value.diff(sp.Symbol(name, real=True))
        euler = build.vector(
            f"E_{name}",
            unit * alpha_P + cross(omega_P, unit * omega_P),
            "(34)",
            f"I alpha + omega x I omega by {name}",
        )
        columns[name] = sp.zeros(3, 1), R * euler
    return build.block(
        "regressor_of_platform",
        "columns of the platform's parameters",
        (*n.MOTION, n.g),
        _outputs(PLATFORM_PARAMETERS, columns),
    )


def _outputs(
    parameters: tuple[Quantity, ...], columns: dict[str, Column]
) -> list[tuple[Quantity, sp.Matrix]]:
    names = names_of(parameters)
    return [pair for name in names for pair in zip(column(name), columns[name], strict=True)]
