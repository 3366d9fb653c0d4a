"""Plausibility of legs: weak or slow motors, friction, stroke, and lengths of leg parts."""

from collections.abc import Iterator

import numpy as np

from ..drives.friction import constant_part, viscous
from ..io.array_types import Array
from ..robot.drive import Drive
from ..robot.robot import Robot, legs_text
from .level_poses import Finding, Home

SLOW = 0.3
"""Smallest plausible leg speed at the motor speed limit, relative to the leg speed limit."""
MOST_MOTOR_SPEED = 3200.0
"""Largest plausible motor speed (rad/s), 30,000 revolutions per minute."""
LONGEST_STROKE = 300.0
"""Longest plausible time of a stroke at the speed limit (s).

Telescopes have 60 s. An entry in m/s instead of mm/s changes 0.5 s to 500 s.
"""
LEAST_STROKE = 5e-4
"""Smallest plausible stroke, relative to the leg length.

Piezo stacks have 1e-3. An entry in meters instead of millimeters changes 0.3 to 3e-4.
"""
FASTER = 100.0
"""Largest plausible leg speed at the motor speed limit, relative to the leg speed limit."""
LEAST_ANGLE, LEAST_SHARE = 0.5 * np.pi * np.pi / 180.0, 0.25
"""Smallest plausible joint angle limit (rad), and its smallest ratio to stroke over length.

Smaller limits are radians instead of degrees.
"""
LEAST_CURRENT, MOST_CURRENT, MOST_VOLTAGE = 0.005, 3e3, 5e3
"""Plausible currents (A) and voltage (V) of a motor at its torque and speed limits.

A torque constant in mN m/A instead of N m/A changes them by a factor of 1000.
"""


LEAST_LEAD = 6e-5
"""Smallest plausible lead (m). A lead of 50 mm in meters is as small in a file in millimeters."""


def of_torques(robot: Robot, F: Array) -> Iterator[Finding]:
    """Yield a finding if motors with friction are too weak for the forces F (N), (6,), at rest."""
    drive = robot.drive
    if drive is None:
        return
    turns = np.abs(drive.transmission_ratio)
    friction = drive.screw_coulomb + drive.stribeck_force + turns * drive.motor_coulomb
    torque = (drive.backdrive_efficiency * np.abs(F) - friction) / turns
    for name in ("torque_limit", "rated_torque"):
        limit = getattr(drive, name)
        with np.errstate(invalid="ignore"):
            weak = np.flatnonzero(torque > limit).tolist()
        if weak:
            worst = max(weak, key=lambda i: float(torque[i] / limit[i]))
            yield Finding(
                "drive-limit",
                f"{name} of the drives of {legs_text(weak)}: {limit[worst]:.4g} N m, but {torque[worst]:.4g} "
                "N m hold the machine at rest at the home pose; likely cause: a missing gear ratio, lead in "
                "another unit, or motors too weak",
            )
            return


def of_slowness(robot: Robot) -> Iterator[Finding]:
    """Yield a finding if viscous friction at the speed limit exceeds the force limit of legs."""
    with np.errstate(invalid="ignore"):
        force = robot.C_p * robot.speed_limit
    slow = np.flatnonzero((force > robot.force_limit) & np.isfinite(robot.speed_limit)).tolist()
    if slow:
        i = slow[0]
        yield Finding(
            "friction",
            f"C_p of {legs_text(slow)}: {robot.C_p[i]:.4g} N s/m, {force[i]:.4g} N at the speed_limit, where "
            f"force_limit is {robot.force_limit[i]:.4g} N; likely cause: another unit",
        )


def of_drive_friction(robot: Robot) -> Iterator[Finding]:
    """Yield a finding if dry friction, or viscous friction at the speed limit, exceeds the torque limit."""
    drive = robot.drive
    if drive is None:
        return
    turns = np.abs(drive.transmission_ratio)
    at_rest = constant_part(drive, np.zeros(len(turns))) / turns
    speed = np.minimum(robot.speed_limit, drive.speed_limit / turns)
    moving = np.where(np.isfinite(speed), viscous(drive) / turns * speed, 0.0)
    for torque, which in ((at_rest, "dry"), (moving, "viscous")):
        legs = np.flatnonzero(torque > drive.torque_limit).tolist()
        if legs:
            i = legs[0]
            where = "" if which == "dry" else " at the speed limit"
            yield Finding(
                "friction",
                f"{which} friction of the drives of {legs_text(legs)}: {torque[i]:.4g} N m of the "
                f"motor{where}, where torque_limit is {drive.torque_limit[i]:.4g} N m; likely cause: another "
                "unit, or friction of the motor given for the screw",
            )
            return


def of_stroke(robot: Robot) -> Iterator[Finding]:
    """Yield findings about strokes, about speeds that are too slow for them, and about joint angle limits."""
    low, high = robot.length_limits.T
    stroke = np.where(np.isfinite(high), high - low, 0.0)
    short = np.flatnonzero((stroke > 0.0) & (stroke < LEAST_STROKE * high)).tolist()
    if short:
        i = short[0]
        yield Finding(
            "length-limits",
            f"length_limits of {legs_text(short)}: a stroke of {stroke[i]:.3g} m in legs of {high[i]:.4g} m; "
            "likely cause: stroke or limits given in m in a file of another length_unit",
        )
        return
    slow = np.flatnonzero(stroke > LONGEST_STROKE * robot.speed_limit).tolist()
    if slow:
        i = slow[0]
        yield Finding(
            "speed-limit",
            f"speed_limit of {legs_text(slow)}: {robot.speed_limit[i]:.4g} m/s, {stroke[i]:.4g} m of stroke "
            f"take {stroke[i] / robot.speed_limit[i]:.3g} s; likely cause: given in m/s in a file of another "
            "length_unit",
        )
    elif robot.drive is not None:
        speed = robot.drive.speed_limit / np.abs(robot.drive.transmission_ratio)
        slow = np.flatnonzero(np.isfinite(speed) & (speed > FASTER * robot.speed_limit)).tolist()
        if slow:
            i = slow[0]
            yield Finding(
                "speed-limit",
                f"speed_limit of {legs_text(slow)}: {robot.speed_limit[i]:.4g} m/s, the motor drives leg "
                f"{i + 1} at up to {speed[i]:.4g} m/s; likely cause: given in m/s in a file of another "
                "length_unit",
            )
    share = np.divide(stroke, high, out=np.zeros(len(high)), where=np.isfinite(high))
    least = robot.joint_angle_limit.min(axis=1)
    tight = np.flatnonzero((least < LEAST_ANGLE) & (least < LEAST_SHARE * share)).tolist()
    if tight:
        i = tight[0]
        yield Finding(
            "joint-angle",
            f"joint_angle_limit of {legs_text(tight)}: {np.degrees(least[i]):.3g} degrees with a stroke of "
            f"{stroke[i]:.4g} m; likely cause: radians given, expected angle_unit",
        )


def has_small_leads(drive: Drive) -> bool:
    """Return True if a lead is too small for any screw, belt, or rack."""
    return bool(np.any(np.abs(drive.lead) < LEAST_LEAD))


def of_leads(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about leads that no screw, belt, or rack has."""
    if robot.drive is None:
        return
    lead = np.abs(robot.drive.lead)
    small = np.flatnonzero(lead < LEAST_LEAD).tolist()
    if small:
        yield Finding(
            "drive-speed",
            f"lead of {legs_text(small)}: {lead[small].min():.4g} m per turn; likely cause: given in m in a "
            "file of another length_unit",
        )


def of_speeds(robot: Robot) -> Iterator[Finding]:
    """Yield findings about motor speed limits that are impossible or too slow for the leg speed limits."""
    if robot.drive is None:
        return
    limit = robot.drive.speed_limit
    fast = np.flatnonzero((limit > MOST_MOTOR_SPEED) & np.isfinite(limit)).tolist()
    if fast:
        most = float(limit[fast].max())
        yield Finding(
            "drive-speed",
            f"speed_limit of the drives of {legs_text(fast)}: {most:.4g} rad/s, {most * 30.0 / np.pi:.4g} "
            "revolutions a minute; likely cause: revolutions a minute given, expected angle_unit a second",
        )
    if has_small_leads(robot.drive):
        return
    speed = limit / np.abs(robot.drive.transmission_ratio)
    slow = np.flatnonzero((speed < SLOW * robot.speed_limit) & np.isfinite(robot.speed_limit)).tolist()
    if slow:
        i = min(slow, key=lambda leg: float(speed[leg] / robot.speed_limit[leg]))
        yield Finding(
            "drive-speed",
            f"speed_limit of the drives of {legs_text(slow)}: {speed[i]:.4g} m/s of leg {i + 1}, whose "
            f"speed_limit is {robot.speed_limit[i]:.4g} m/s; likely cause: revolutions given, expected "
            "angle_unit a second, or a gear counted twice",
        )


def of_currents(robot: Robot) -> Iterator[Finding]:
    """Yield findings about torque constants that require implausible currents or voltages."""
    drive = robot.drive
    if drive is None:
        return
    constant = np.where(drive.torque_constant > 0.0, drive.torque_constant, np.nan)
    torque = np.minimum(drive.torque_limit, drive.rated_torque)
    current = np.where(np.isfinite(torque), torque / constant, np.nan)
    speed = np.minimum(drive.speed_limit, np.abs(drive.transmission_ratio) * robot.speed_limit)
    voltage = np.where(np.isfinite(speed), constant * speed, np.nan)
    drop = current * drive.resistance
    of_torque = ("torque_constant", constant, "N m/A")
    for unlike, (name, values, unit), given, need in (
        ((current > MOST_CURRENT) | (current < LEAST_CURRENT), of_torque, (torque, "N m"), (current, "A")),
        (voltage > MOST_VOLTAGE, of_torque, (speed, "rad/s"), (voltage, "V")),
        (drop > MOST_VOLTAGE, ("resistance", drive.resistance, "ohm"), (current, "A"), (drop, "V")),
    ):
        legs = np.flatnonzero(unlike).tolist()
        if legs:
            i = legs[0]
            yield Finding(
                "torque-constant",
                f"{name} of the drives of {legs_text(legs)}: {values[i]:.4g} {unit}, with which "
                f"{given[0][i]:.4g} {given[1]} need {need[0][i]:.3g} {need[1]}; likely cause: another unit",
            )
            return


# Lengths of parts

LEAST_REACH, MOST_LENGTH = 0.8, 1.0 + 1e-9
"""Smallest plausible length of both parts over the longest leg, and largest of one part over the shortest.

Joints, which simple shapes omit, may cover the remaining length.
"""


def of_part_lengths(robot: Robot, home: Home) -> Iterator[Finding]:
    """Yield findings about parts that separate in the longest leg, or that are longer than the shortest leg.

    The lengths are the limits, or the leg at home if there are none. With offsets, only the limits are used.
    """
    low, high = robot.length_limits.T
    at_home = np.full((2, len(home.L)), np.nan) if robot.offsets is not None else np.stack([home.L, home.L])
    shortest = np.where(low > 0.0, low, at_home[0])
    longest = np.where(np.isfinite(high), high, at_home[1])
    lower, upper = robot.lower_length, robot.upper_length
    stated = (lower > 0.0) & (upper > 0.0)
    short = np.flatnonzero(stated & (lower + upper < LEAST_REACH * longest)).tolist()
    if short:
        i = short[0]
        yield Finding(
            "part-length",
            f"lower and upper parts of {legs_text(short)}: {lower[i]:.4g} m and {upper[i]:.4g} m long, which "
            f"are too short for a leg of {longest[i]:.4g} m; likely cause: the length of a part left out, "
            "or not measured from its joint",
        )
    for part, length in (("lower", lower), ("upper", upper)):
        long = np.flatnonzero(length > MOST_LENGTH * shortest).tolist()
        if long:
            i = long[0]
            yield Finding(
                "part-length",
                f"{part} part of {legs_text(long)}: {length[i]:.4g} m long, longer than a leg of "
                f"{shortest[i]:.4g} m; likely cause: the length in another unit, or of the whole leg",
            )
