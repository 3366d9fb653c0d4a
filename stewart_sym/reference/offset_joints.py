"""Legs with offset joints in plain vectors: joint chains, and the forces that a motion requires.

The joints of each leg are a rotation about the fixed axis k, a rotation about the moving axis y, and a
translation along s. Universal platform joints add rotations about s, about the axis on the upper part, and
about the axis on the platform. Joint rates and accelerations follow from the motion of the platform, inertial
forces from Newton and Euler, and the joint forces from the power of each joint rate (Kane 1985). Shapes are
as in ``newton_euler``.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from ..motion.motion import Motion
from ..motion.rotation import cross as vector_product
from ..results import OK, InverseDynamicsResult, JointReactionsResult
from ..robot import offset_chains as chain
from ..robot.offset_chains import SLIDING, SPIN, JointMotion, applied, transposed
from ..robot.offset_positions import Chains, dot
from ..robot.robot import Robot
from . import newton_euler
from .newton_euler import Array, Codes, all_finite, platform_wrench, solve_linear, with_status


@dataclass(frozen=True, eq=False)
class _Body:
    """One part: mass, center relative to the base point, acceleration, and rate of angular momentum.

    v_of, omega_of: velocity of the center and angular velocity per joint rate, (..., 6, n, 3).
    """

    m: Array
    c: Array
    a: Array
    spun: Array
    v: Array
    I: Array  # noqa: E741
    omega: Array
    v_of: Array
    omega_of: Array


@dataclass(frozen=True, eq=False)
class Legs:
    """Motion of the joint chains and the required forces.

    tau: generalized joint forces for inertia, weight, and friction, (..., 6, n). column: generalized forces
    of a unit actuator force. f: friction moment at the platform joint. W: angular velocity of the lower part.
    bodies: cross, lower part, and upper part. F_rotor: force that accelerates the motor (N), (..., 6).
    """

    moving: JointMotion
    tau: Array
    column: Array
    f: Array
    W: Array
    bodies: tuple[_Body, ...]
    F_rotor: Array

    @property
    def at(self) -> Chains:
        """Positions of the joints."""
        return self.moving.at

    @property
    def rates(self) -> Array:
        """Rates of the joints, (..., 6, n)."""
        return self.moving.rates


def inverse_dynamics(robot: Robot, motion: Motion) -> InverseDynamicsResult:
    """Compute the actuator forces of a robot with offset joints.

    The columns of H map the twist to the rates of the leg lengths. F = D - x as usual. K is the force at the
    platform joint except x times the force of the column.
    """
    with np.errstate(all="ignore"):
        return _solved(robot, motion)[1]


def joint_reactions(
    robot: Robot, motion: Motion, bearing_distance: ArrayLike | None = None
) -> JointReactionsResult:
    """Compute the forces and moments in the joints.

    F_s: on the leg at the platform joint. F_u: on the cross at the fixed axis. M_u: on the lower part at the
    moving axis, along k x y. M_p: about the point at ``bearing_distance`` (m) on the sliding axis.
    """
    with np.errstate(all="ignore"):
        legs, forces = _solved(robot, motion)
        return JointReactionsResult(
            **with_status(_reactions(robot, legs, forces.F, bearing_distance), forces.status)
        )


def reactions_of(
    robot: Robot, motion: Motion, x: Array, bearing: ArrayLike | None = None
) -> dict[str, Array]:
    """Compute the joint reactions by name for axial forces x (N), (..., 6), without a status."""
    with np.errstate(all="ignore"):
        found = legs(robot, motion)
        return _reactions(robot, found, found.tau[..., SLIDING] - x, bearing)


def terms(robot: Robot, motion: Motion) -> dict[str, Array]:
    """Compute D, K, H, and c of every pose without solving, so that H may be singular; no status."""
    with np.errstate(all="ignore"):
        _, H, D, K, c, _ = _equations(robot, motion)
        return {"D": D, "K": K, "H": H, "c": c}


def rotor_force(robot: Robot, motion: Motion) -> Array:
    """Compute the part of the actuator forces (N), (..., 6), that accelerates the rotors."""
    return legs(robot, motion).F_rotor


def massless_forces(robot: Robot, motion: Motion) -> Array:
    """Compute the actuator forces (N), (..., 6), for massless legs and joints without friction."""
    with np.errstate(all="ignore"):
        _, H, _, _, _, status = _equations(robot, motion)
        return -solve_linear(robot, H, platform_wrench(robot, motion), status)[0]


def _reactions(robot: Robot, legs: Legs, F: Array, bearing: ArrayLike | None) -> dict[str, Array]:
    where = np.broadcast_to(0.0 if bearing is None else np.asarray(bearing), 6)[:, None]
    at, g = legs.at, robot.g
    wrench = _ends(legs, F)
    F_s, own = wrench[..., :3], {"M_s": wrench[..., 3:]} if wrench.shape[-1] == 6 else {}
    M_s = own.get("M_s", np.zeros(at.P.shape))
    needed = [body.m * (body.a - g) for body in legs.bodies]
    F_p = needed[2] - F_s + robot.C_p[:, None] * legs.rates[..., SLIDING, None] * at.s

    def moment(about: Array, bodies: slice) -> Array:
        """Return the moment about a point that parts require for their motion and the force at the end."""
        parts = zip(legs.bodies[bodies], needed[bodies], strict=True)
        own = sum((vector_product(body.c - about, force) + body.spun for body, force in parts), np.zeros(3))
        return np.asarray(own - vector_product(at.P - about, F_s) - M_s + legs.f)

    M = moment(at.A, slice(1, 3)) + robot.C_u[:, None] * legs.W
    return {
        "F_s": F_s,
        "F_u": np.asarray(sum(needed) - F_s),
        "F_p": F_p,
        "F_c": F_p - (F - legs.F_rotor)[..., None] * at.s,
        "M_p": moment(at.T + (where - at.L) * at.s, slice(2, 3)),
        "M_u": dot(M, vector_product(robot.k, at.y))[..., 0],
        **own,
    }


def actuator_wrench(robot: Robot, motion: Motion) -> tuple[Array, Codes]:
    """Compute the wrench H F = H D - c of the actuators, (..., 6), and the status, without solving."""
    with np.errstate(all="ignore"):
        _, H, D, _, c, status = _equations(robot, motion)
        return newton_euler.blank(applied(H, D) - c, status != OK), status


def energy(robot: Robot, motion: Motion) -> Array:
    """Compute the kinetic and potential energy (J), (...), of the platform, crosses, and leg parts."""
    with np.errstate(all="ignore"):
        found = legs(robot, _without_accelerations(motion))
        total = np.zeros(motion.shape)
        if robot.drive is not None:
            speed = chain.motor_motion(robot, found.rates)
            about = speed * (speed / 2 + dot(found.at.s, found.W)[..., 0])
            total += np.sum(robot.drive.rotor_inertia * about, axis=-1)
        for body in found.bodies:
            kinetic = (body.m * dot(body.v, body.v) + dot(body.omega, applied(body.I, body.omega))) / 2
            total += np.sum(kinetic - body.m * dot(robot.b + body.c, robot.g), axis=(-2, -1))
        return np.asarray(total + newton_euler.platform_energy(robot, motion))


def friction_power(robot: Robot, motion: Motion) -> Array:
    """Compute the power (W), (...), that joint friction dissipates; it is never negative."""
    with np.errstate(all="ignore"):
        found = legs(robot, _without_accelerations(motion))
        slip = found.bodies[2].omega - motion.omega[..., None, :]
        power = robot.C_u[:, None] * dot(found.W, found.W) + robot.C_s[:, None] * dot(slip, slip)
        return np.asarray(np.sum(power[..., 0] + robot.C_p * found.rates[..., SLIDING] ** 2, axis=-1))


def worst_leg(code: int, robot: Robot, motion: Motion) -> int:
    """Return the index of the first leg of one pose with a code."""
    return int(np.argmax(chain.codes(robot, motion) == code))


# ---------------------------------------------------------------- motion


@np.errstate(all="ignore")
def legs(robot: Robot, motion: Motion) -> Legs:
    """Compute the motion of the chains and the generalized forces; NaN if the offsets allow no solution."""
    moving = chain.joint_motion(robot, motion)
    if moving.accelerations is None:
        raise ValueError("motion: accelerations expected, but alpha or a is None")
    at, rates = moving.at, moving.rates
    bodies = tuple(_bodies(robot, at, rates, moving.accelerations))
    W, omega = bodies[1].omega, motion.omega[..., None, :]
    f = robot.C_s[:, None] * (bodies[2].omega - omega)
    torque, carried = _rotors(robot, moving)
    bodies = (bodies[0], replace(bodies[1], spun=bodies[1].spun + carried), bodies[2])
    tau = applied(bodies[1].omega_of, robot.C_u[:, None] * W) + applied(bodies[2].omega_of, f)
    for body in bodies:
        tau = tau + applied(body.v_of, body.m * (body.a - robot.g)) + applied(body.omega_of, body.spun)
    tau[..., SLIDING] += robot.C_p * rates[..., SLIDING]
    F_rotor = torque * (0.0 if robot.drive is None else robot.drive.transmission_ratio)
    tau[..., SLIDING] += F_rotor
    if rates.shape[-1] > SPIN and robot.drive is not None:
        tau[..., SPIN] += torque * robot.drive.gear_ratio
    return Legs(moving, tau, chain.actuated(robot, rates.shape[-1]), f, W, bodies, F_rotor)


def _rotors(robot: Robot, moving: JointMotion) -> tuple[Array, Array]:
    """Compute the motor torques (N m), (..., 6), and the angular momentum rates relative to the lower part.

    A motor angle is N L, plus the gear ratio times the spin if the upper part rotates in its nut.
    """
    at, rates, seconds = moving.at, moving.rates, moving.accelerations
    if not robot.has_rotors or seconds is None:
        return np.zeros(at.L.shape[:-1]), np.zeros_like(at.s)
    speed, quick = (chain.motor_motion(robot, each)[..., None] for each in (rates, seconds))
    lower = chain.lower_motion(robot, at, rates, seconds)
    inertia = 0.0 if robot.drive is None else np.asarray(robot.drive.rotor_inertia)[:, None]
    torque = inertia * (quick + dot(at.s, lower.alpha))
    return torque[..., 0], inertia * (quick * at.s + speed * vector_product(lower.omega, at.s))


def _bodies(robot: Robot, at: Chains, rates: Array, seconds: Array) -> Iterator[_Body]:
    """Yield the cross, the lower part, and the upper part."""
    offsets, k = chain.offsets_of(robot), np.broadcast_to(robot.k, at.s.shape)
    none = np.zeros_like(at.s)
    n = rates.shape[-1]
    turns = {0: [k], 1: [k, at.y], 2: [k, at.y, none, at.s][: 4 if n == 6 else 3]}
    lower = np.stack([at.s, at.y, at.z], axis=-1)
    C = np.stack([at.o, at.y, k], axis=-1)
    about_k = offsets.cross_inertia[:, None, None] * np.diag([0.0, 0.0, 1.0])
    parts = (
        (offsets.cross_mass, none, C, offsets.cross_center, about_k, chain.cross_motion),
        (robot.m_d, at.A, lower, robot.r_d0, robot.I_d0, chain.lower_motion),
        (robot.m_u, at.T, at.U, robot.r_u0, robot.I_u0, chain.upper_motion),
    )
    for i, (mass, origin, axes, center, inertia, motion) in enumerate(parts):
        r, I = applied(axes, center), axes @ inertia @ transposed(axes)  # noqa: E741
        moving = motion(robot, at, rates, seconds)
        omega, alpha, c = moving.omega, moving.alpha, origin + r
        # The cross rotates about the base point, which is fixed.
        v, a = (none, none) if i == 0 else (moving.v, moving.a)
        omega_of = np.stack([*turns[i], *[none] * (n - len(turns[i]))], axis=-2)
        arms = [c, c - at.A, c - at.T, c - at.T]
        v_of = np.stack(
            [vector_product(turn, arm) for turn, arm in zip(turns[i], arms, strict=False)]
            + [none] * (n - len(turns[i])),
            axis=-2,
        )
        if i == 2:
            v_of[..., SLIDING, :] = at.s
        yield _Body(
            m=mass[:, None],
            c=c,
            a=a + chain.swung(omega, alpha, r),
            spun=applied(I, alpha) + vector_product(omega, applied(I, omega)),
            v=v + vector_product(omega, r),
            I=I,
            omega=omega,
            v_of=v_of,
            omega_of=omega_of,
        )


# ---------------------------------------------------------------- balance


def _ends(legs: Legs, F: Array) -> Array:
    """Compute the wrench on each leg at the platform joint, (..., 6, n)."""
    right = legs.tau - F[..., None] * legs.column
    J_T = transposed(legs.moving.J)
    bad = np.asarray(~np.isfinite(J_T).all(axis=(-2, -1)) | ~np.isfinite(right).all(axis=-1))
    found = np.linalg.solve(np.where(bad[..., None, None], np.eye(J_T.shape[-1]), J_T), right[..., None])
    return np.asarray(found[..., 0])


def _equations(robot: Robot, motion: Motion) -> tuple[Legs, Array, Array, Array, Array, Codes]:
    """Compute the legs, H, D, K, c, and a status that does not depend on the rank of H."""
    found = legs(robot, motion)
    G = found.moving.G
    H = chain.columns_of_H(robot, G)
    D = found.tau[..., SLIDING]
    rest = found.tau - D[..., None] * found.column
    taken = np.einsum("...ij,...ijk->...k", rest, G)
    K = _ends(found, D)[..., :3]
    c = platform_wrench(robot, motion) - taken
    c[..., 3:] += np.sum(found.f, axis=-2)
    finite = all_finite(H, 2) & all_finite(c, 1) & all_finite(D, 1)
    status = newton_euler.status_of_legs(chain.codes_of(robot, motion, found.at), finite)
    return found, H, D, K, c, status


def _solved(robot: Robot, motion: Motion) -> tuple[Legs, InverseDynamicsResult]:
    found, H, D, K, c, status = _equations(robot, motion)
    x, status = solve_linear(robot, H, c, status)
    return found, InverseDynamicsResult(
        **with_status({"F": D - x, "D": D, "x": x, "K": K, "H": H, "c": c}, status)
    )


def _without_accelerations(motion: Motion) -> Motion:
    none = np.zeros_like(motion.t)
    return Motion._unchecked(motion.R, motion.t, motion.omega, motion.v, none, none)
