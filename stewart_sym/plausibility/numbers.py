"""Plausibility of single numbers: units of points and the tool, exchanged points, bodies, and drives."""

from collections.abc import Iterator

import numpy as np

from ..io.array_types import Array
from ..kinematics.mounting_side import radius
from ..robot.robot import Robot, legs_text
from .finding import Finding, finding, in_file

MOST_GRAVITY = 50.0
"""Largest plausible gravity (m/s^2): twice Jupiter's; the Moon's is 1,620 in mm/s^2 and 162 in cm/s^2."""
MOST_SIZE = 50.0
"""Largest plausible RMS radius of points (m); larger machines are rarer than files in millimeters."""
LEAST_SIZE = 0.01
"""Smallest plausible machine size (m) of a file whose points are not in a larger unit."""
MOST_PROPORTION = (2.5, 200.0)
"""Largest ratio of platform to base: of exchanged points, and of points in another unit."""
SLENDER = (1.5, 0.4, 0.5, 1.5)
"""Ratio of platform to base, and limits of the radius of gyration, of a body that fits the ring of the base.

The second number is the largest one over the platform radius, and the others are both over the base radius.
"""
DENSEST = 22590.0
"""Density of osmium (kg/m^3); a ball around the points of a platform exceeds it with a mass in grams."""
LEAST_DENSITY = 0.01
"""Smallest plausible density (kg/m^3), a hundredth of air; millimeters make it 1e9 times smaller."""
MOST_GYRATION = 5.0
"""Largest plausible radius of gyration over machine size; kg cm^2 for kg m^2 makes it 100 times larger."""
LEAST_GYRATION = (0.02, 0.002)
"""Smallest plausible radius of gyration: platform over its size, leg part (rod: 0.1) over machine size."""
MOST_SPEED = 50.0
"""Largest plausible leg speed limit (m/s)."""
MOST_STROKE_TIME = 300.0
"""Largest plausible time for the whole stroke at the speed limit (s); slow positioning stages need 100 s."""
LEAST_TOOL = 2e-3
"""Smallest plausible distance of the tool from the platform frame over the platform radius, if not 0."""
LEAST_LEAD = 5e-5
"""Smallest plausible change of the leg length per turn of the screw (m); micrometer screws have 2.5e-4 m."""
MOST_MOTOR_SPEED = 3200.0
"""Largest plausible motor speed (rad/s), 30,000 revolutions per minute."""


def of_numbers(robot: Robot) -> Iterator[Finding]:
    """Yield findings about single numbers; with points in a wrong unit, bodies are not examined."""
    gravity = float(np.linalg.norm(robot.g))
    if gravity > MOST_GRAVITY:
        yield finding("gravity", f"gravity: {gravity:g} m/s^2", "given in mm/s^2 or cm/s^2")
    yield from list(_of_points(robot)) or _of_bodies(robot, radius(robot.b) + radius(robot.p))
    away, size = float(np.linalg.norm(robot.tool)), radius(robot.p)
    if robot.length_unit != "m" and 0.0 < away < LEAST_TOOL * size:
        text = f"tool {in_file(robot, away)} from the platform frame, on a platform of {in_file(robot, size)}"
        yield finding("tool", text, f"given in a larger unit, expected {robot.length_unit}")
    yield from _of_speeds(robot)


def _of_points(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about points in a wrong unit, or exchanged ones."""
    base, platform = radius(robot.b), radius(robot.p)
    ratio, density = float(np.divide(platform, base)), _density(robot.M, _reach(robot))
    exchanged, unit = MOST_PROPORTION
    most, thin, low, high = SLENDER
    gyration = _gyration(robot.I_p, robot.M)
    slender = gyration < thin * platform and low < gyration / base < high
    sizes = f"base points {in_file(robot, base)}, platform points {in_file(robot, platform)} in RMS radius"
    cause = f"points in {_smaller(robot)}, expected {robot.length_unit}"
    if max(base, platform) > MOST_SIZE and 1.0 / unit < ratio < unit:
        yield finding("length-unit", sizes, cause)
    elif not 1.0 / unit <= ratio <= unit:
        names = ("platform", "base") if ratio > unit else ("base", "platform")
        cause = f"{names[0]} points in millimeters, or {names[1]} points in meters in a file of millimeters"
        yield finding("proportion", sizes, cause)
    elif ratio > exchanged or (ratio > most and slender):
        yield finding("proportion", sizes, "base_point and platform_point exchanged (the base is fixed)")
    elif density < LEAST_DENSITY:
        ball = f"{robot.M:g} kg, {density:.2g} kg/m^3 all over a ball around its points"
        yield finding("length-unit", f"{sizes}, platform {ball}", cause)


def _smaller(robot: Robot) -> str:
    """Return the probable unit of lengths that are too large."""
    return "millimeters" if robot.length_unit == "m" else "a smaller unit"


def _reach(robot: Robot) -> float:
    """Return the distance of the farthest platform point from the mean of the platform points (m)."""
    return float(np.linalg.norm(robot.p - robot.p.mean(axis=0), axis=-1).max())


def _density(mass: float, r: float) -> float:
    """Return the density of a ball (kg/m^3)."""
    return float(mass / (4.0 / 3.0 * np.pi * np.float64(r) ** 3))


def _of_bodies(robot: Robot, size: float) -> Iterator[Finding]:
    """Yield findings about masses, radii of gyration, and the center of mass of the platform."""
    gyration = float(_gyration(robot.I_p, robot.M))
    reach = max(_reach(robot), 2.0 * gyration)
    density = _density(robot.M, reach)
    if density > DENSEST and reach > 0.0 and not gyration > MOST_GYRATION * size:
        larger = f"points in a larger unit, expected {robot.length_unit}, or " if size < LEAST_SIZE else ""
        text = f"platform: {robot.M:g} kg within {in_file(robot, reach)}, {density / DENSEST:.2g} times as "
        yield finding("mass", f"{text}dense as the densest metal", f"{larger}mass in grams")
        return
    least = LEAST_GYRATION[1] * size
    bodies = [("platform", np.array([robot.M]), robot.I_p[None], LEAST_GYRATION[0] * _reach(robot))]
    bodies += [("lower part", robot.m_d, robot.I_d0, least), ("upper part", robot.m_u, robot.I_u0, least)]
    for body in bodies:
        yield from _of_gyration(robot, size, *body)
    far = float(np.linalg.norm(robot.R_0 - robot.p.mean(axis=0)))
    if far > 10.0 * size > 0.0:
        text = f"platform: center_of_mass {in_file(robot, far)} from the middle of the platform points, on a "
        text += f"machine of {in_file(robot, size)}"
        yield finding("center-of-mass", text, f"given in {_smaller(robot)} or in the base frame")


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
    text += (
        f": inertia of a body of {masses[legs[0]]:g} kg with {in_file(robot, gyration[legs[0]])} in radius "
    )
    yield finding("inertia-size", f"{text}of gyration, on a machine of {in_file(robot, size)}", cause)


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
    larger, limit = "given in a larger unit, expected", robot.speed_limit
    times = stroke / limit
    if fast := _above(limit, MOST_SPEED):
        cause = "given in mm/s" if robot.length_unit == "m" else "given in a smaller unit"
        yield finding("speed-limit", _limited(robot, fast, limit), cause)
    elif slow := _above(times, MOST_STROKE_TIME):
        yield finding("speed-limit", _limited(robot, slow, limit, times), f"{larger} {robot.length_unit}/s")
    if robot.drive is None:
        return
    limit, lead = robot.drive.speed_limit, robot.drive.lead
    times = stroke * np.abs(robot.drive.transmission_ratio) / limit
    # A wrong lead explains the other numbers of the drives.
    if fine := _above(LEAST_LEAD / np.abs(lead), 1.0):
        text = f"lead of {legs_text(fine)}: {in_file(robot, lead[fine[0]])}"
        yield finding("drive-lead", text, f"{larger} {robot.length_unit}")
    elif slow := _above(times, MOST_STROKE_TIME):
        text = _limited(robot, slow, limit, times, "rad/s")
        yield finding("drive-speed", text, f"{larger} {robot.angle_unit}/s")
    elif fast := _above(limit, MOST_MOTOR_SPEED):
        text = _limited(robot, fast, limit, unit="rad/s")
        yield finding("drive-speed", text, "revolutions given, expected angle_unit a second")


def _limited(
    robot: Robot, legs: list[int], limit: Array, times: Array | None = None, unit: str = "m/s"
) -> str:
    """Return the text about a speed limit of legs or drives, with the time (s) for the stroke if given."""
    owner = "the drives of " if unit == "rad/s" else ""
    stroke = "" if times is None else f", {times[legs[0]]:.3g} s for the stroke"
    return f"speed_limit of {owner}{legs_text(legs)}: {in_file(robot, limit[legs[0]], unit, 4)}{stroke}"


def _above(limit: Array, most: float) -> list[int]:
    """Return the indices of finite limits above a value."""
    return [int(i) for i in np.flatnonzero(np.isfinite(limit) & (limit > most))]
