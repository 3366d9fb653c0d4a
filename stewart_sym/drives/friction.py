"""Friction of a drive: what the force at the motor exceeds that of the leg by, from the rate of length.

Along the leg, with N the motor's turn per length, F the axial force between the leg's parts and sgn the sign
of L_dot:

    friction = sgn (f_c + f_s exp(-(L_dot / v_s)^2) + |N| tau_c + mu |F|) + (c + N^2 b) L_dot

f_c, c: of the screw; tau_c, b: of the motor; f_s, v_s: Stribeck's. The efficiency acts as friction in
proportion to the force: mu is 1 / eta - 1 where the motor drives the leg, F L_dot > 0, and 1 - eta' where the
leg drives the motor, so that N tau is F / eta or F eta' without the rest.
"""

import numpy as np

from ..io.array_types import Array
from ..robot.drive import Drive


def smooth_sign(rate: Array, within: Array) -> Array:
    """Sign of a rate; from -within to within an odd cubic that meets it with slope 0."""
    with np.errstate(divide="ignore", invalid="ignore"):
        x = np.clip(np.where(within > 0.0, rate / within, np.sign(rate)), -1.0, 1.0)
    return np.asarray(0.5 * x * (3.0 - x * x))


def dry_sign(drive: Drive, L_dot: Array, side: Array) -> Array:
    """Return the sign of dry friction from the signs of the rates next to an instant, ``side``, (..., 6).

    A leg that turns back has another sign before the instant than after it. Smoothed signs have no sides.
    """
    within = np.asarray(drive.regularization_speed)
    return np.where(within > 0.0, smooth_sign(L_dot, within), side)


def load_share(drive: Drive, F: Array, sign: Array) -> Array:
    """Friction per size of the leg's force, mu: (...,  6), for forces F and signs of the rate, (..., 6)."""
    driving = F * sign > 0.0
    return np.where(driving, 1.0 / drive.efficiency - 1.0, 1.0 - drive.backdrive_efficiency)


def constant_part(drive: Drive, L_dot: Array) -> Array:
    """Size of the friction that depends neither on force nor, but for Stribeck's part, on the rate, N."""
    with np.errstate(divide="ignore", invalid="ignore"):
        decay = np.where(drive.stribeck_force > 0.0, np.exp(-((L_dot / drive.stribeck_speed) ** 2)), 0.0)
    return np.asarray(
        drive.screw_coulomb
        + np.abs(drive.transmission_ratio) * drive.motor_coulomb
        + drive.stribeck_force * decay
    )


def viscous(drive: Drive) -> Array:
    """Friction per rate of length, N s/m, (6,)."""
    return np.asarray(drive.screw_viscous + drive.transmission_ratio**2 * drive.motor_viscous)


def friction_force(drive: Drive, F: Array, L_dot: Array, sign: Array | None = None) -> Array:
    """Friction of the drives along the legs, N, (..., 6), positive when it opposes an extending leg.

    F: axial force between the parts of each leg, N, (..., 6). L_dot: rate of its length, m/s, (..., 6); at a
    rate of 0 friction is 0, which is the middle of what it may be. sign: of dry friction, (..., 6); None:
    that of the rate.
    """
    if sign is None:
        sign = smooth_sign(L_dot, np.asarray(drive.regularization_speed))
    dry = constant_part(drive, L_dot) + load_share(drive, F, sign) * np.abs(F)
    return np.asarray(sign * dry + viscous(drive) * L_dot)


def losses(drive: Drive) -> list[str]:
    """Names of the fields by which something is lost between force and motor."""
    lossless = dict.fromkeys(("efficiency", "backdrive_efficiency"), 1.0)
    lossless |= dict.fromkeys(
        ("screw_coulomb", "screw_viscous", "motor_coulomb", "motor_viscous", "stribeck_force"), 0.0
    )
    return [name for name, value in lossless.items() if np.any(getattr(drive, name) != value)]


def drive_numbers(drive: Drive) -> dict[str, Array]:
    """Members of the C struct ``stewart_drives``: what torques are computed with, (6,) each."""
    lumped = {
        "turns": drive.transmission_ratio,
        "driving": 1.0 / drive.efficiency - 1.0,
        "driven": 1.0 - drive.backdrive_efficiency,
        "coulomb": drive.screw_coulomb + np.abs(drive.transmission_ratio) * drive.motor_coulomb,
        "viscous": viscous(drive),
    }
    alone = {
        "stribeck": drive.stribeck_force,
        "stribeck_speed": drive.stribeck_speed,
        "smoothing": drive.regularization_speed,
        "torque_constant": drive.torque_constant,
    }
    return lumped | {name: np.asarray(values) for name, values in alone.items()}
