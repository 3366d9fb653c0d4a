"""Plausibility at the home pose: its place, limits, centers of mass, forces, and motors."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array
from ..kinematics.inverse_kinematics import leg_lengths
from ..kinematics.mounting_side import radius
from ..motion.motion import at_rest
from ..robot.robot import Robot, legs_text
from .finding import Finding, finding, in_file, smaller_unit

MOST_LEGS = 5.0
"""Largest plausible shortest leg over machine size; machines have 0.2 to 2, limits in inches at least 8."""
OUTSIDE = 0.9
"""Ratio of the mean leg to the nearest mean limit below which no pose is likely to be within the limits."""
MOST_DISTANCE, BEYOND = 3.0, 0.05
"""Largest plausible distances of a center of mass from its joint, and beyond it, over the leg length."""
LEAST_STROKE = 1e-3
"""Smallest plausible stroke over the leg length; hexapods with piezo actuators have 2e-3."""
MOST_REFLECTED = 1e4
"""Largest plausible mass of a rotor reflected to its leg over the mass of the machine."""
IN_METERS = 0.05
"""Ratio of the limits to the legs below which limits are in meters in a file of another length_unit."""


def of_home(robot: Robot, t: Array) -> Iterator[Finding]:
    """Yield findings about limits, centers of mass, forces, and motors of the level pose at t (m)."""
    L = leg_lengths(robot, np.eye(3), t)
    found = list(_of_limits(robot, L)) or list(_of_parts(robot, L))
    yield from found
    if not found and not robot.missing_bodies:
        F = inverse_dynamics(robot, at_rest(np.eye(3), t), backend="numpy", on_singular="nan").F
        yield from _of_actuators(robot, np.abs(F))


def _of_limits(robot: Robot, L: Array) -> Iterator[Finding]:
    """Yield a finding about a home beyond the length limits, limits of no pose, or a stroke near zero."""
    low, high = robot.length_limits.T
    beyond = np.flatnonzero((low > L) | (high < L)).tolist()
    size, longest = radius(robot.b) + radius(robot.p), float(np.mean(high))
    limits = f"length_limits {_range(robot, low.min(), high.max())}: "
    limits += f"legs {_range(robot, L.min(), L.max())} long at the home pose"
    in_meters = longest < IN_METERS * np.mean(L)
    unit = "limits given in m in a file of another unit of length" if in_meters else ""
    if robot.home_position is not None and beyond:
        of_home = "home of another point than the platform frame's origin, or a stroke without 0 in it"
        i = max(beyond, key=lambda leg: float(max(low[leg] - L[leg], L[leg] - high[leg]) / L[leg]))
        text = f"{legs_text(beyond)} beyond length_limits at the home pose: {in_file(robot, L[i])}"
        yield finding("home", f"{text}, limits {_range(robot, low[i], high[i])}", unit or of_home)
    elif OUTSIDE * np.mean(low) > min(np.mean(L), OUTSIDE * MOST_LEGS * size):
        cause = "limits in millimeters, centimeters, or inches, or points of another machine"
        yield finding("length-limits", limits, cause)
    elif longest < OUTSIDE * np.mean(L):
        cause = unit or "the stroke given, expected the length from joint to joint"
        yield finding("length-limits", limits, cause)
    elif np.any(high - low < LEAST_STROKE * np.where(np.isfinite(high), high, 0.0)):
        cause = "stroke or limits given in m in a file of another unit of length"
        yield finding("length-limits", f"{limits}, a stroke of {in_file(robot, min(high - low))}", cause)


def _range(robot: Robot, low: float, high: float) -> str:
    """Format two lengths (m) in the unit of the file."""
    return f"{in_file(robot, low).partition(' ')[0]} to {in_file(robot, high)}"


def _of_parts(robot: Robot, L: Array) -> Iterator[Finding]:
    """Yield findings about centers of mass of leg parts far away or beyond the joint."""
    for part, r, sign, joint in (
        ("upper", robot.r_u0, "negative", "platform joint"),
        ("lower", -robot.r_d0, "positive", "base joint"),
    ):
        away = np.linalg.norm(r, axis=-1)
        far, wrong = away > MOST_DISTANCE * L, r[:, 0] > BEYOND * L
        legs = np.flatnonzero(far | wrong).tolist()
        if legs:
            i = legs[0]
            behind = f"wrong sign, expected a {sign} first component, or a motor behind the joint"
            cause = f"given in {smaller_unit(robot)}" if far[i] else behind
            beyond = f", {in_file(robot, r[i, 0])} beyond it" if r[i, 0] > 0.0 else ""
            text = f"{part} part of {legs_text(legs)}: center_of_mass {in_file(robot, away[i])} from the "
            text += f"{joint}{beyond}, in a leg {in_file(robot, L[i])} long"
            yield finding("center-of-mass", text, cause)


def _of_actuators(robot: Robot, F: Array) -> Iterator[Finding]:
    """Yield findings about limits below the magnitudes F (N), (6,), at rest, and about heavy rotors."""
    cause = "force_limit in kN, masses in grams, or actuators too weak"
    yield from _too_weak("force-limit", "force_limit", F, robot.force_limit, "N", cause)
    drive = robot.drive
    if drive is None:
        return
    turns = np.abs(drive.transmission_ratio)
    friction = drive.screw_coulomb + drive.stribeck_force + turns * drive.motor_coulomb
    torque = (drive.backdrive_efficiency * F - friction) / turns
    name = "rated_torque" if np.any(torque > drive.rated_torque) else "torque_limit"
    cause = "a missing gear ratio, lead in another unit, or motors too weak"
    yield from _too_weak("drive-limit", f"{name} of the drives", torque, getattr(drive, name), "N m", cause)
    reflected = drive.rotor_inertia * turns**2
    heavy = np.flatnonzero(reflected > MOST_REFLECTED * (robot.M + np.sum(robot.m_d + robot.m_u))).tolist()
    if heavy:
        inertia, mass = drive.rotor_inertia[heavy[0]], reflected[heavy[0]]
        text = f"rotor_inertia of {legs_text(heavy)}: {inertia:.4g} kg m^2, {mass:.3g} kg at the leg"
        yield finding("drive-inertia", text, "given in kg cm^2, kg mm^2, or g cm^2")


def _too_weak(
    name: str, owner: str, required: Array, limit: Array, unit: str, cause: str
) -> Iterator[Finding]:
    """Yield a finding about limits below the values (6,) for the machine at rest."""
    weak = np.flatnonzero(required > limit).tolist()
    if weak:
        worst = max(weak, key=lambda i: float(required[i] / limit[i]))
        text = (
            f"{owner} of {legs_text(weak)}: {limit[worst]:.4g} {unit}, but {required[worst]:.4g} {unit} hold "
        )
        yield finding(name, f"{text}the machine at rest at the home pose", cause)
