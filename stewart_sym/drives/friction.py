"""Friction of a drive: difference between the motor force and the leg force, as a function of the leg rate.

All forces act along the leg. N is the transmission ratio, F the axial force between the leg parts, and sgn
the sign of L_dot:

    friction = sgn (f_c + f_s exp(-(L_dot / v_s)^2) + |N| tau_c + mu |F|) + (c + N^2 b) L_dot

f_c and c belong to the screw, tau_c and b to the motor, and f_s and v_s are the Stribeck parameters. The
efficiency acts as friction proportional to the force: mu is 1 / eta - 1 if the motor drives the leg, F L_dot
> 0, and 1 - eta' if the leg drives the motor. Without the other terms, N tau is F / eta or F eta'.
"""

import numpy as np

from ..io.array_types import Array
from ..robot.drive import Drive


def smooth_sign(rate: Array, within: Array) -> Array:
    """Return the sign of a rate, replaced by an odd cubic with zero end slopes from -within to within."""
    with np.errstate(divide="ignore", invalid="ignore"):
        x = np.clip(np.where(within > 0.0, rate / within, np.sign(rate)), -1.0, 1.0)
    return np.asarray(0.5 * x * (3.0 - x * x))


def dry_sign(drive: Drive, L_dot: Array, side: Array) -> Array:
    """Return the sign of dry friction from the signs of the rates next to a sample, ``side``, (..., 6)."""
    within = np.asarray(drive.regularization_speed)
    return np.where(within > 0.0, smooth_sign(L_dot, within), side)


def load_share(drive: Drive, F: Array, sign: Array) -> Array:
    """Return mu, the friction per magnitude of the leg force, for forces F and rate signs, shape (..., 6)."""
    driving = F * sign > 0.0
    return np.where(driving, 1.0 / drive.efficiency - 1.0, 1.0 - drive.backdrive_efficiency)


def constant_part(drive: Drive, L_dot: Array) -> Array:
    """Return the magnitude of the friction without viscous and load-dependent terms (N)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        decay = np.where(drive.stribeck_force > 0.0, np.exp(-((L_dot / drive.stribeck_speed) ** 2)), 0.0)
    return np.asarray(
        drive.screw_coulomb
        + np.abs(drive.transmission_ratio) * drive.motor_coulomb
        + drive.stribeck_force * decay
    )


def viscous(drive: Drive) -> Array:
    """Return the viscous friction coefficient of the leg rate (N s/m), shape (6,)."""
    return np.asarray(drive.screw_viscous + drive.transmission_ratio**2 * drive.motor_viscous)


def friction_force(drive: Drive, F: Array, L_dot: Array, sign: Array | None = None) -> Array:
    """Return the friction of the drives along the legs (N), (..., 6), positive against an extending leg."""
    if sign is None:
        sign = smooth_sign(L_dot, np.asarray(drive.regularization_speed))
    dry = constant_part(drive, L_dot) + load_share(drive, F, sign) * np.abs(F)
    return np.asarray(sign * dry + viscous(drive) * L_dot)


def losses(drive: Drive) -> list[str]:
    """Return the names of the drive fields that cause losses."""
    lossless = dict.fromkeys(("efficiency", "backdrive_efficiency"), 1.0)
    lossless |= dict.fromkeys(
        ("screw_coulomb", "screw_viscous", "motor_coulomb", "motor_viscous", "stribeck_force"), 0.0
    )
    return [name for name, value in lossless.items() if np.any(getattr(drive, name) != value)]


def drive_numbers(drive: Drive) -> dict[str, Array]:
    """Return the members of the C struct ``stewart_drives`` for the torques, shape (6,) each."""
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
