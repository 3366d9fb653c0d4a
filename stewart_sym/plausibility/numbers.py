"""Plausibility of single numbers: units of points and other lengths, exchanged points, bodies, and drives."""

from collections.abc import Iterator

import numpy as np

from ..io.array_types import Array
from ..kinematics.mounting_side import radius
from ..robot.robot import Robot, legs_text
from ..robot.units import Units
from .finding import Finding, finding, in_file, smaller_unit

MOST_GRAVITY = 50.0
"""Largest plausible gravity (m/s^2): twice Jupiter's; the Moon's is 1,620 in mm/s^2 and 162 in cm/s^2."""
MOST_SIZE = 25.0
"""Largest plausible RMS radius of points (m); larger machines are rarer than files in millimeters."""
LEAST_LENGTH = 1e-3
"""Smallest plausible length over machine size, if not 0; meters in a file of millimeters are smaller."""
MOST_PROPORTION = (2.5, 200.0)
"""Largest ratio of platform to base: of exchanged points, and of points in another unit."""
SLENDER = (1.5, 0.4, 0.5, 1.5)
"""Ratio of platform to base, and limits of the radius of gyration, of a body that fits the ring of the base.

The second number is the largest one over the platform radius, and the others are both over the base radius.
"""
DENSEST = 22590.0
"""Density of osmium (kg/m^3); a ball around the points of a platform exceeds it with a mass in grams."""
MOST_GYRATION = 5.0
"""Largest plausible radius of gyration over machine size; kg cm^2 for kg m^2 makes it 100 times larger."""
LEAST_GYRATION = (0.02, 0.002)
"""Smallest plausible radius of gyration: platform over its size, leg part (rod: 0.1) over machine size."""
MOST_SPEED = 50.0
"""Largest plausible leg speed limit (m/s)."""
MOST_STROKE_TIME = 300.0
"""Largest plausible time for the whole stroke at the speed limit (s); slow positioning stages need 100 s."""
LEAST_LEAD = 5e-5
"""Smallest plausible change of the leg length per turn of the screw (m); micrometer screws have 2.5e-4 m."""
MOST_MOTOR_SPEED = 3200.0
"""Largest plausible motor speed (rad/s), 30,000 revolutions per minute."""


def of_numbers(robot: Robot) -> Iterator[Finding]:
    """Yield findings about single numbers; with points in a wrong unit, only gravity and speeds are."""
    gravity = float(np.linalg.norm(robot.g))
    size = radius(robot.b) + radius(robot.p)
    if gravity > MOST_GRAVITY:
        yield finding("gravity", f"gravity: {gravity:g} m/s^2", "given in mm/s^2 or cm/s^2")
    yield from list(_of_points(robot)) or [*_of_bodies(robot, size), *_of_short_lengths(robot, size)]
    yield from _of_speeds(robot)


def _of_points(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about points in a wrong unit, or exchanged ones."""
    base, platform = radius(robot.b), radius(robot.p)
    ratio = float(np.divide(platform, base))
    exchanged, unit = MOST_PROPORTION
    most, thin, low, high = SLENDER
    gyration = _gyration(robot.I_p, robot.M)
    slender = gyration < thin * platform and low < gyration / base < high
    sizes = f"base points {in_file(robot, base)}, platform points {in_file(robot, platform)} in RMS radius"
    if max(base, platform) > MOST_SIZE and 1.0 / unit < ratio < unit:
        yield finding("length-unit", sizes, f"points in {smaller_unit(robot)}, expected {robot.length_unit}")
    elif not 1.0 / unit <= ratio <= unit:
        names = ("platform", "base") if ratio > unit else ("base", "platform")
        cause = f"{names[0]} points in millimeters, or {names[1]} points in meters in a file of millimeters"
        yield finding("proportion", sizes, cause)
    elif ratio > exchanged or (ratio > most and slender):
        yield finding("proportion", sizes, "base_point and platform_point exchanged (the base is fixed)")


def _of_short_lengths(robot: Robot, size: float) -> Iterator[Finding]:
    """Yield findings about vectors that are too short for the machine, in a file of a unit other than m."""
    vectors: dict[str, tuple[str, Array]] = {
        "home_position": ("home", np.zeros(3) if robot.home_position is None else robot.home_position),
        "tool": ("tool", robot.tool),
        "center_of_mass of a lower part": ("center-of-mass", robot.r_d0),
        "center_of_mass of an upper part": ("center-of-mass", robot.r_u0),
    }
    for place, (name, vector) in vectors.items():
        away = np.atleast_1d(np.linalg.norm(vector, axis=-1))
        short = away[(away > 0.0) & (away < LEAST_LENGTH * size)]
        if robot.length_unit != "m" and short.size:
            text = f"{place} {in_file(robot, short[0])} long, on a machine of {in_file(robot, size)}"
            yield finding(name, text, f"given in a larger unit, expected {robot.length_unit}")


def _of_bodies(robot: Robot, size: float) -> Iterator[Finding]:
    """Yield findings about masses, radii of gyration, and the center of mass of the platform."""
    gyration = float(_gyration(robot.I_p, robot.M))
    middle = robot.p.mean(axis=0)
    extent = float(np.linalg.norm(robot.p - middle, axis=-1).max())
    reach = max(extent, 2.0 * gyration)
    density = float(robot.M / (4.0 / 3.0 * np.pi * np.float64(reach) ** 3))
    if density > DENSEST and reach > 0.0 and not gyration > MOST_GYRATION * size:
        text = f"platform: {robot.M:g} kg within {in_file(robot, reach)}, {density / DENSEST:.2g} times as "
        cause = f"mass in grams, or points in a larger unit than {robot.length_unit}"
        yield finding("mass", f"{text}dense as the densest metal", cause)
        return
    least = LEAST_GYRATION[1] * size
    bodies = [("platform", np.array([robot.M]), robot.I_p[None], LEAST_GYRATION[0] * extent)]
    bodies += [("lower part", robot.m_d, robot.I_d0, least), ("upper part", robot.m_u, robot.I_u0, least)]
    for body in bodies:
        yield from _of_gyration(robot, size, *body)
    far = float(np.linalg.norm(robot.R_0 - middle))
    if far > 10.0 * size > 0.0:
        text = f"platform: center_of_mass {in_file(robot, far)} from the middle of the platform points, on a "
        text += f"machine of {in_file(robot, size)}"
        yield finding("center-of-mass", text, f"given in {smaller_unit(robot)} or in the base frame")


def _of_gyration(
    robot: Robot, size: float, name: str, masses: Array, inertias: Array, least: float
) -> Iterator[Finding]:
    """Yield a finding about radii of gyration beyond the machine, or below ``least`` (m)."""
    gyration = _gyration(inertias, masses)
    wide, narrow = gyration > MOST_GYRATION * size, (0.0 < gyration) & (gyration < least)
    legs = np.flatnonzero(wide if wide.any() else narrow).tolist()
    if not legs or not size > 0.0:
        return
    cause = "inertia converted from kg mm^2 twice, masses in grams, or dimensions in a larger unit"
    if wide.any():
        cause = "inertia in kg mm^2, g cm^2 or kg cm^2, or about a point that is not the center of mass"
    text = name if name == "platform" else f"{name} of {legs_text(legs)}"
    text += f": inertia of a body of {masses[legs[0]]:g} kg with a radius of gyration of "
    text += f"{in_file(robot, gyration[legs[0]])}, on a machine of {in_file(robot, size)}"
    yield finding("inertia-size", text, cause)


def _gyration(inertias: Array, masses: Array | float) -> Array:
    """Return the largest radii of gyration of bodies (m)."""
    if np.isnan(inertias).any():
        return np.full(np.shape(masses), np.nan)
    return np.asarray(np.sqrt(np.linalg.eigvalsh(inertias)[..., -1].clip(min=0.0) / masses))


def _of_speeds(robot: Robot) -> Iterator[Finding]:
    """Yield findings about speed limits of legs, and about the lead or the speed limits of the drives."""
    stroke = np.ptp(robot.length_limits, axis=1)
    # Legs of usual machines change by about half of the base radius; implausible limits are found elsewhere.
    stroke = np.where(np.isfinite(stroke), np.minimum(stroke, 2.0 * radius(robot.b)), 0.5 * radius(robot.b))
    cause = "given in mm/s" if robot.length_unit == "m" else "given in a smaller unit"
    yield from _of_speed(robot, robot.speed_limit, "m/s", stroke, MOST_SPEED, cause)
    drive = robot.drive
    if drive is None:
        return
    # A wrong lead explains the other numbers of the drives.
    if fine := np.flatnonzero(np.abs(drive.lead) < LEAST_LEAD).tolist():
        text = f"lead of {legs_text(fine)}: {in_file(robot, drive.lead[fine[0]])}"
        yield finding("drive-lead", text, f"given in a larger unit, expected {robot.length_unit}")
    else:
        angle = stroke * np.abs(drive.transmission_ratio)
        cause = "revolutions given, expected angle_unit a second"
        yield from _of_speed(robot, drive.speed_limit, "rad/s", angle, MOST_MOTOR_SPEED, cause)


def _of_speed(
    robot: Robot, limit: Array, unit: str, stroke: Array, most: float, cause: str
) -> Iterator[Finding]:
    """Yield a finding about speed limits above ``most``, or with which the stroke lasts too long."""
    name, owner = ("drive-speed", "the drives of ") if unit == "rad/s" else ("speed-limit", "")
    times = stroke / limit
    fast = np.flatnonzero(np.isfinite(limit) & (limit > most)).tolist()
    legs = fast or np.flatnonzero(times > MOST_STROKE_TIME).tolist()
    if legs:
        text = f"speed_limit of {owner}{legs_text(legs)}: {in_file(robot, limit[legs[0]], unit)}"
        if not fast:
            text += f", {times[legs[0]]:.3g} s for the stroke"
            cause = f"given in a larger unit, expected {Units.of(robot).of_unit(unit)[1]}"
        yield finding(name, text, cause)
