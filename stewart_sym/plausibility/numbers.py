"""Plausibility of single numbers: units of points, exchanged points, masses, inertias, and speeds."""

from collections.abc import Iterator

import numpy as np

from ..dynamics.home_pose import radius
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot, legs_text
from .level_poses import Finding

MOST_GRAVITY = 50.0
"""Largest plausible gravity (m/s^2): twice Jupiter's; the Moon's is 1,620 in mm/s^2 and 162 in cm/s^2."""
MOST_SIZE = 50.0
"""Largest plausible RMS radius of points (m); larger machines are rarer than files in millimeters."""
LEAST_SIZE, STRAY = 1e-4, 50.0
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
LONGEST_STROKE = 300.0
"""Longest plausible time of a stroke at the speed limit (s).

Telescopes have 60 s. An entry in m/s instead of mm/s changes 0.5 s to 500 s.
"""
MOST_MOTOR_SPEED = 3200.0
"""Largest plausible motor speed (rad/s), 30,000 revolutions per minute."""
LEAST_LEAD = 6e-5
"""Smallest plausible lead (m). A lead of 50 mm in meters is as small in a file in millimeters."""
SLOW, FASTER = 0.3, 100.0
"""Range of plausible leg speeds at the motor speed limit, relative to the leg speed limit."""


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
    strays = [
        f"{what} of leg {i + 1}"
        for what, points in (("base_point", robot.b), ("platform_point", robot.p))
        for i in _strays(points)
    ]
    if strays:
        yield Finding(
            "stray-point",
            f"{', '.join(strays)}: more than {STRAY:g} times as far out as the others; likely cause: given "
            "in millimeters, or a decimal point lost",
        )
    elif max(base, platform) > MOST_SIZE and min(base, platform) * MOST_PROPORTION[1] > max(base, platform):
        yield Finding("length-unit", f"{sizes}; likely cause: points in millimeters, expected meters")
    elif 0.0 < max(base, platform) < LEAST_SIZE:
        yield Finding("length-unit", f"{sizes}; likely cause: points in kilometers, expected meters")
    elif platform > 0.0 and base > 0.0:
        yield from list(_of_proportion(robot, platform / base, sizes)) or _of_lightness(robot, sizes)


def _strays(points: Array) -> list[int]:
    """Return the indices of points that are far from the mean of the others, relative to their radius."""
    found = []
    for i in range(LEGS):
        others = np.delete(points, i, axis=0)
        size = radius(others)
        if size > 0.0 and np.linalg.norm(points[i] - others.mean(axis=0)) > STRAY * size:
            found.append(i)
    return found


def _of_proportion(robot: Robot, ratio: float, sizes: str) -> Iterator[Finding]:
    exchanged, unit = MOST_PROPORTION
    gyration = float(np.sqrt(np.linalg.eigvalsh(robot.I_p)[-1].clip(min=0.0) / robot.M))
    most, thin, low, high = SLENDER
    slender = gyration < thin * radius(robot.p) and low < gyration / radius(robot.b) < high
    if ratio > unit or ratio < 1.0 / unit:
        larger, smaller = ("platform", "base") if ratio > unit else ("base", "platform")
        cause = f"{larger} points in millimeters, or {smaller} points in meters in a file of millimeters"
        yield Finding("proportion", f"{sizes}; likely cause: {cause}")
    elif ratio > exchanged or (ratio > most and slender):
        body = "" if ratio > exchanged else f", {gyration:.3g} m in radius of gyration of the platform"
        yield Finding(
            "proportion",
            f"{sizes}{body}; likely cause: base_point and platform_point exchanged (the base is fixed)",
        )


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
    gyration = float(np.sqrt(np.linalg.eigvalsh(robot.I_p)[-1].clip(min=0.0) / robot.M))
    reach = max(_reach(robot), 2.0 * gyration)
    density = _density(robot.M, reach)
    if density > DENSEST and reach > 0.0 and not gyration > MOST_GYRATION * size:
        yield Finding(
            "mass",
            f"platform: {robot.M:g} kg within {reach:.3g} m, {density / DENSEST:.2g} times as dense as "
            "the densest metal; likely cause: mass in grams",
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
    largest = np.linalg.eigvalsh(inertias)[:, -1].clip(min=0.0)
    gyration = np.sqrt(largest / masses)
    wide, narrow = gyration > MOST_GYRATION * size, (0.0 < gyration) & (gyration < least)
    legs = np.flatnonzero(wide if wide.any() else narrow).tolist()
    if not legs or not size > 0.0:
        return
    cause = (
        "inertia in kg mm^2, g cm^2 or kg cm^2, or about a point that is not the center of mass"
        if wide.any()
        else "inertia converted from kg mm^2 twice, or masses in grams"
    )
    where = name if name == "platform" else f"{name} of {legs_text(legs)}"
    yield Finding(
        "inertia-size",
        f"{where}: inertia {largest[legs[0]]:.3g} kg m^2 at {masses[legs[0]]:g} kg is that of a body "
        f"{gyration[legs[0]]:.3g} m in radius of gyration, on a machine of {size:.3g} m; likely "
        f"cause: {cause}",
    )


def _of_speeds(robot: Robot) -> Iterator[Finding]:
    """Yield findings about speed limits of legs and motors that do not fit the stroke or each other."""
    low, high = robot.length_limits.T
    # Limits in another unit, which the home pose reveals, are no reason to question speeds.
    size = radius(robot.b) + radius(robot.p)
    limit, stroke = robot.speed_limit, np.where(np.isfinite(high), np.minimum(high - low, 3.0 * size), 0.0)
    fast, slow = np.isfinite(limit) & (limit > MOST_SPEED), stroke > LONGEST_STROKE * limit
    legs = np.flatnonzero(fast if fast.any() else slow).tolist()
    if legs:
        i = legs[0]
        seen = "" if fast.any() else f", {stroke[i]:.4g} m of stroke take {stroke[i] / limit[i]:.3g} s"
        cause = "given in mm/s" if fast.any() else "given in m/s in a file of another length_unit"
        yield Finding(
            "speed-limit",
            f"speed_limit of {legs_text(legs)}: {limit[i]:.4g} m/s{seen}; likely cause: {cause}",
        )
    elif robot.drive is not None and np.any(np.abs(robot.drive.lead) < LEAST_LEAD):
        lead = np.abs(robot.drive.lead)
        small = np.flatnonzero(lead < LEAST_LEAD).tolist()
        yield Finding(
            "drive-speed",
            f"lead of {legs_text(small)}: {lead[small].min():.4g} m per turn; likely cause: given in m in a "
            "file of another length_unit",
        )
    elif robot.drive is not None:
        motor = robot.drive.speed_limit
        speed = np.abs(motor / robot.drive.transmission_ratio)
        fast = np.isfinite(motor) & ((speed > FASTER * limit) | (motor > MOST_MOTOR_SPEED))
        legs = np.flatnonzero(fast | (np.isfinite(limit) & (speed < SLOW * limit))).tolist()
        if legs:
            i = legs[0]
            yield Finding(
                "drive-speed",
                f"speed_limit of the drives of {legs_text(legs)}: {motor[i]:.4g} rad/s, {speed[i]:.4g} m/s "
                f"of leg {i + 1}, whose speed_limit is {limit[i]:.4g} m/s; likely cause: revolutions given, "
                "expected angle_unit a second, a gear counted twice, or lead or speed_limit in another unit",
            )
