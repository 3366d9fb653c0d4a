"""Plausibility of single numbers: units of points, exchanged points, masses, inertias, speeds, and leads."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import radius
from ..io.array_types import Array
from ..robot.robot import Robot, legs_text
from .finding import Finding

MOST_GRAVITY = 50.0
"""Largest plausible gravity (m/s^2): twice Jupiter's; the Moon's is 1,620 in mm/s^2 and 162 in cm/s^2."""
MOST_SIZE = 50.0
"""Largest plausible RMS radius of points (m); larger machines are rarer than files in millimeters."""
LEAST_SIZE = 0.01
"""Smallest plausible machine size (m) of a file whose points are not in a larger unit."""
MOST_PROPORTION = (2.5, 200.0)
"""Largest ratio of platform to base: of exchanged points, and of points in another unit."""
SLENDER = (1.5, 0.4, 0.5, 1.5)
"""Thresholds of a body that fits the ring of the base and is much smaller than its own ring.

They are the ratio of platform to base, the largest radius of gyration over the platform radius, and the
smallest and largest radius of gyration over the base radius.
"""
DENSEST = 22590.0
"""Density of osmium (kg/m^3), compared with a ball around the platform points.

Even light platforms exceed it if their mass is given in grams.
"""
LEAST_DENSITY = 0.01
"""Smallest plausible density (kg/m^3), a hundredth of the density of air.

In millimeters, the volume of a platform is 1e9 times too large.
"""
MOST_GYRATION = 5.0
"""Largest plausible radius of gyration over machine size; kg cm^2 for kg m^2 makes it 100 times larger."""
LEAST_GYRATION = (0.02, 0.002)
"""Smallest plausible radius of gyration: platform over its own size, and leg part over machine size.

Rods have 0.1; an inertia that is too small by 1e-6 makes it 1000 times smaller.
"""
MOST_SPEED = 50.0
"""Largest plausible leg speed limit (m/s)."""
MOST_STROKE_TIME = 300.0
"""Largest plausible time for the whole stroke at the speed limit (s); slow positioning stages need 100 s."""
LEAST_LEAD = 5e-5
"""Smallest plausible change of the leg length per turn of the screw (m); micrometer screws have 2.5e-4 m."""
MOST_MOTOR_SPEED = 3200.0
"""Largest plausible motor speed (rad/s), 30,000 revolutions per minute."""


def of_numbers(robot: Robot) -> Iterator[Finding]:
    """Yield findings about single numbers; with points in a wrong unit, bodies are not examined."""
    gravity = float(np.linalg.norm(robot.g))
    if gravity > MOST_GRAVITY:
        yield Finding("gravity", f"gravity: {gravity:g} m/s^2; likely cause: given in mm/s^2 or cm/s^2")
    lengths = list(_of_points(robot))
    yield from lengths
    if not lengths:
        yield from _of_bodies(robot, radius(robot.b) + radius(robot.p))
    yield from _of_speeds(robot)


def _of_points(robot: Robot) -> Iterator[Finding]:
    base, platform = radius(robot.b), radius(robot.p)
    sizes = f"base points {base:.3g} m, platform points {platform:.3g} m in RMS radius"
    if max(base, platform) > MOST_SIZE and min(base, platform) * MOST_PROPORTION[1] > max(base, platform):
        yield Finding("length-unit", f"{sizes}; likely cause: points in millimeters, expected meters")
    else:
        yield from list(_of_proportion(robot, float(np.divide(platform, base)), sizes)) or _of_lightness(
            robot, sizes
        )


def _of_proportion(robot: Robot, ratio: float, sizes: str) -> Iterator[Finding]:
    exchanged, unit = MOST_PROPORTION
    gyration = _gyration(robot.I_p, robot.M)
    most, thin, low, high = SLENDER
    slender = gyration < thin * radius(robot.p) and low < gyration / radius(robot.b) < high
    if not 1.0 / unit <= ratio <= unit:
        larger, smaller = ("platform", "base") if ratio > unit else ("base", "platform")
        cause = f"{larger} points in millimeters, or {smaller} points in meters in a file of millimeters"
        yield Finding("proportion", f"{sizes}; likely cause: {cause}")
    elif ratio > exchanged or (ratio > most and slender):
        cause = "base_point and platform_point exchanged (the base is fixed)"
        yield Finding("proportion", f"{sizes}; likely cause: {cause}")


def _of_lightness(robot: Robot, sizes: str) -> Iterator[Finding]:
    density = _density(robot.M, _reach(robot))
    if density < LEAST_DENSITY:
        yield Finding(
            "length-unit",
            f"{sizes}, platform {robot.M:g} kg, {density:.2g} kg/m^3 all over a ball around its points; "
            "likely cause: points in millimeters or centimeters, expected meters",
        )


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
        cause = "mass in grams"
        if size < LEAST_SIZE:
            cause = f"points in a larger unit, expected {robot.length_unit}, or {cause}"
        yield Finding(
            "mass",
            f"platform: {robot.M:g} kg within {reach:.3g} m, {density / DENSEST:.2g} times as dense as "
            f"the densest metal; likely cause: {cause}",
        )
        return
    least = LEAST_GYRATION[0] * _reach(robot), LEAST_GYRATION[1] * size
    yield from _of_gyration("platform", np.array([robot.M]), robot.I_p[None], size, least[0])
    yield from _of_gyration("lower part", robot.m_d, robot.I_d0, size, least[1])
    yield from _of_gyration("upper part", robot.m_u, robot.I_u0, size, least[1])
    far = np.linalg.norm(robot.R_0 - robot.p.mean(axis=0))
    if far > 10.0 * size > 0.0:
        yield Finding(
            "center-of-mass",
            f"platform: center_of_mass {far:.3g} m from the middle of the platform points, on a machine of "
            f"{size:.3g} m; likely cause: given in millimeters or in the base frame",
        )


def _of_gyration(name: str, masses: Array, inertias: Array, size: float, least: float) -> Iterator[Finding]:
    """Yield a finding about radii of gyration beyond the machine, or below ``least`` (m)."""
    gyration = _gyration(inertias, masses)
    wide, narrow = gyration > MOST_GYRATION * size, (0.0 < gyration) & (gyration < least)
    legs = np.flatnonzero(wide if wide.any() else narrow).tolist()
    if not legs or not size > 0.0:
        return
    cause = "inertia converted from kg mm^2 twice, masses in grams, or dimensions in a larger unit"
    if wide.any():
        cause = "inertia in kg mm^2, g cm^2 or kg cm^2, or about a point that is not the center of mass"
    where = name if name == "platform" else f"{name} of {legs_text(legs)}"
    yield Finding(
        "inertia-size",
        f"{where}: inertia of a body of {masses[legs[0]]:g} kg with {gyration[legs[0]]:.3g} m in radius of "
        f"gyration, on a machine of {size:.3g} m; likely cause: {cause}",
    )


def _gyration(inertias: Array, masses: Array | float) -> Array:
    """Return the largest radii of gyration of bodies (m)."""
    if np.isnan(inertias).any():
        return np.full(np.shape(masses), np.nan)
    return np.asarray(np.sqrt(np.linalg.eigvalsh(inertias)[..., -1].clip(min=0.0) / masses))


def _of_speeds(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about implausible speed limits of legs or motors, and about implausible leads."""
    stroke = np.ptp(robot.length_limits, axis=1)
    # Legs of usual machines change by about half of the base radius; implausible limits are found elsewhere.
    stroke = np.where(np.isfinite(stroke), np.minimum(stroke, 2.0 * radius(robot.b)), 0.5 * radius(robot.b))
    cause = f"likely cause: given in a larger unit, expected {robot.length_unit}"
    if fast := _above(robot.speed_limit, MOST_SPEED):
        worst = robot.speed_limit[fast[0]]
        text = f"speed_limit of {legs_text(fast)}: {worst:.4g} m/s; likely cause: given in mm/s"
        yield Finding("speed-limit", text)
    elif slow := _above(stroke / robot.speed_limit, MOST_STROKE_TIME):
        worst, time = (float(each[slow[0]]) for each in (robot.speed_limit, stroke / robot.speed_limit))
        text = f"speed_limit of {legs_text(slow)}: {worst:.4g} m/s, {time:.3g} s for the stroke; "
        yield Finding("speed-limit", f"{text}{cause}/s")
    if robot.drive is None:
        return
    times = stroke * np.abs(robot.drive.transmission_ratio) / robot.drive.speed_limit
    if slow := _above(times, MOST_STROKE_TIME):
        text = f"speed_limit of the drives of {legs_text(slow)}: {robot.drive.speed_limit[slow[0]]:.4g} rad/s"
        text += f", {times[slow[0]]:.3g} s for the stroke; likely cause: given in a larger unit, expected "
        yield Finding("drive-speed", f"{text}{robot.angle_unit}/s")
    elif fast := _above(robot.drive.speed_limit, MOST_MOTOR_SPEED):
        yield Finding(
            "drive-speed",
            f"speed_limit of the drives of {legs_text(fast)}: {robot.drive.speed_limit[fast[0]]:.4g} rad/s; "
            "likely cause: revolutions given, expected angle_unit a second",
        )
    if fine := _above(LEAST_LEAD / np.abs(robot.drive.lead), 1.0):
        text = f"lead of {legs_text(fine)}: {robot.drive.lead[fine[0]]:.3g} m; "
        yield Finding("drive-lead", text + cause)


def _above(limit: Array, most: float) -> list[int]:
    """Return the indices of finite limits above a value."""
    return [int(i) for i in np.flatnonzero(np.isfinite(limit) & (limit > most))]
