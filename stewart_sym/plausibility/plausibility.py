"""Plausibility of a robot's numbers: values that the schema allows and hardly any machine has.

The checks of forces, legs, and joints use the home pose. Each threshold is between the values of real
machines and the result of the mistake that it detects. Values that may be right cause no finding.
"""

import warnings
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from ..dynamics.home_pose import radius
from ..io.array_types import Array
from ..kinematics.mounting import AssemblyModeWarning
from ..motion.rotation import rotation_from_quaternion
from ..robot.robot import LEGS, Robot, legs_text
from . import leg_parts
from .leg_order import of_order
from .level_poses import Finding, Home, centered_H, home_of, level_home, parts_of
from .points import MOST_LEGS, UNITS_OF_LIMITS, of_coincidence, of_exchange, of_limits, of_place, of_tool

MOST_GRAVITY = 50.0
"""Largest plausible gravity (m/s^2): twice Jupiter's; the Moon's is 1,620 in mm/s^2 and 162 in cm/s^2."""
MOST_SIZE = 50.0
"""Largest plausible RMS radius of points (m); larger machines are rarer than files in millimeters."""
LEAST_SIZE = 1e-4
MOST_PROPORTION = (2.5, 200.0)
"""Largest ratio of platform to base: of exchanged points, and of points in another unit."""
STRAY = 50.0
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
MOST_FRICTION = 1e3
"""Largest plausible ratio of viscous friction to weight, at the speed of a fall over the machine size."""
MOST_REFLECTED = 1e3
"""Largest plausible ratio of the reflected rotor mass to the mass of platform and legs.

A rotor inertia in kg cm^2 instead of kg m^2 makes it 10,000 times larger.
"""
MOST_SPEED = 50.0
"""Largest plausible leg speed limit (m/s)."""
SINGULAR_SHARE = 1e-3
"""Threshold of smallest over largest singular value of H; sound machines exceed it at some random pose."""
LEAST_SINE, LEAST_SINES = 0.03, 0.1
"""Smallest plausible sine of the angle between a leg and its universal axis at the home pose.

The first applies to any leg if length limits determine the home pose, the second to all six legs.
"""
MOST_OFFSET = (0.5, 0.15, 5.0)
"""Largest plausible distance of a center of mass from the leg axis, over the leg length.

The second value applies if the distance is also the third value times the coordinate along the axis.
"""
LEAST_OFFSET = (1e-6, 1e-3)
"""Bounds of the distance of a center of mass from its joint, over the leg length, that indicate a wrong unit.

Such values are meters in a file of millimeters. Values below the bounds are zero except for rounding.
"""
BEYOND = 0.05
"""Largest plausible distance of a center of mass beyond its joint, over the leg length."""
MOST_OVERLAP = 1.25
"""Largest plausible sum of the distances of both centers of mass from their joints, over the leg length.

Parts that just slide past each other have 1 at the shortest leg length.
"""


_OF_SPEED = ("drive-speed", "torque-constant")
"""Names of findings that do not explain findings about a machine at rest."""


def find_implausible(robot: Robot) -> list[Finding]:
    """Return the findings about a robot except the suppressed ones; impossible inertias are not included.

    A finding that explains others replaces them: with a wrong unit, or if all poses are singular, poses are
    not examined. Findings about motor speed limits explain no others.
    """
    with np.errstate(all="ignore"), warnings.catch_warnings():
        # No finding depends on the side of the base on which the platform is.
        warnings.simplefilter("ignore", AssemblyModeWarning)
        found = _found(robot)
    return found


def _found(robot: Robot) -> list[Finding]:
    def left(found: Iterable[Finding]) -> list[Finding]:
        return [doubt for doubt in found if doubt.name not in robot.suppressed_warnings]

    base, platform = radius(robot.b), radius(robot.p)
    if not np.isfinite(base + platform):
        text = "base or platform points so far out that distances overflow; likely cause: a wrong exponent"
        return left([Finding("length-unit", text)])
    reach = float(max(np.abs(robot.b).max(), np.abs(robot.p).max()))
    collapsed = min(base, platform) <= max(_SAME**2 * max(base, platform), _ROUNDING * reach)
    of_numbers = [] if collapsed else left(_of_numbers(robot))
    found = [doubt for doubt in of_numbers if doubt.name not in _OF_SPEED]
    if not found:
        found = left(_of_geometry(robot)) or left(of_coincidence(robot))
    if not found:
        t = level_home(robot)
        found = left(of_place(robot)) or left(of_order(robot, t)) or left(of_limits(robot))
        found = (found or left(_of_home(robot, home_of(robot, t)))) + left(of_tool(robot))
    return of_numbers + [doubt for doubt in found if doubt not in of_numbers]


# Single numbers


def _of_numbers(robot: Robot) -> Iterator[Finding]:
    gravity = float(np.linalg.norm(robot.g))
    if gravity > MOST_GRAVITY:
        yield Finding("gravity", f"gravity: {gravity:g} m/s^2; likely cause: given in mm/s^2 or cm/s^2")
    lengths = list(_of_lengths(robot))
    yield from lengths
    if not lengths:
        size = radius(robot.b) + radius(robot.p)
        yield from _of_masses(robot, size)
        yield from _of_friction(robot, size)
        yield from _of_rotors(robot)
        yield from leg_parts.of_drive_friction(robot)
        yield from leg_parts.of_leads(robot)
        yield from leg_parts.of_speeds(robot)
        yield from leg_parts.of_currents(robot)
    fast = np.flatnonzero(np.isfinite(robot.speed_limit) & (robot.speed_limit > MOST_SPEED))
    if fast.size:
        yield Finding(
            "speed-limit",
            f"speed_limit of {legs_text(fast.tolist())}: {robot.speed_limit[fast].max():g} m/s; likely "
            "cause: given in mm/s",
        )


def _of_lengths(robot: Robot) -> Iterator[Finding]:
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
        said = list(_of_proportion(platform / base, sizes)) or list(of_exchange(robot, sizes))
        yield from said or _of_lightness(robot, sizes)


def _strays(points: Array) -> list[int]:
    """Return the indices of points that are far from the mean of the others, relative to their radius."""
    found = []
    for i in range(LEGS):
        others = np.delete(points, i, axis=0)
        size = radius(others)
        if size > 0.0 and np.linalg.norm(points[i] - others.mean(axis=0)) > STRAY * size:
            found.append(i)
    return found


def _of_proportion(ratio: float, sizes: str) -> Iterator[Finding]:
    exchanged, unit = MOST_PROPORTION
    if ratio > unit or ratio < 1.0 / unit:
        larger, smaller = ("platform", "base") if ratio > unit else ("base", "platform")
        cause = f"{larger} points in millimeters, or {smaller} points in meters in a file of millimeters"
        yield Finding("proportion", f"{sizes}; likely cause: {cause}")
    elif ratio > exchanged:
        yield Finding(
            "proportion",
            f"{sizes}; likely cause: base_point and platform_point exchanged (the base is fixed)",
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


def _of_friction(robot: Robot, size: float) -> Iterator[Finding]:
    """Yield a finding about viscous friction (N s/m or N m s) that would stop the machine at once."""
    weight = 9.81 * (robot.M + robot.m_d.sum() + robot.m_u.sum())
    most = MOST_FRICTION * weight / np.sqrt(9.81 * size) if size > 0.0 else np.inf
    turning, sliding = ("N m s", size**2), ("N s/m", 1.0)
    joints = (("C_u", robot.C_u, *turning), ("C_p", robot.C_p, *sliding), ("C_s", robot.C_s, *turning))
    for name, values, unit, lever in joints:
        legs = np.flatnonzero(values > most * lever).tolist()
        if legs:
            yield Finding(
                "friction",
                f"{name} of {legs_text(legs)}: {values[legs].max():.3g} {unit}, {MOST_FRICTION:g} times the "
                f"weight and more at {np.sqrt(9.81 * size):.2g} m/s; likely cause: another unit, or dry "
                "friction given, expected viscous friction",
            )


def _of_rotors(robot: Robot) -> Iterator[Finding]:
    """Yield a finding about rotors that are far heavier than platform and legs."""
    moving = robot.M + float(robot.m_d.sum() + robot.m_u.sum())
    legs = np.flatnonzero(robot.reflected_mass > MOST_REFLECTED * moving).tolist()
    if robot.drive is not None and legs and not leg_parts.has_small_leads(robot.drive):
        worst = int(np.argmax(robot.reflected_mass))
        yield Finding(
            "rotor-inertia",
            f"rotor_inertia of {legs_text(legs)}: {robot.drive.rotor_inertia[worst]:.3g} kg m^2 resists as "
            f"{robot.reflected_mass[worst]:.3g} kg along the leg, "
            f"platform and legs have {moving:.3g} kg; likely cause: "
            "given in kg cm^2 or g cm^2, expected kg m^2, or a lead in another unit",
        )


def _of_masses(robot: Robot, size: float) -> Iterator[Finding]:
    bodies = [("platform", np.array([robot.M]), robot.I_p[None])]
    bodies += [("lower part", robot.m_d, robot.I_d0), ("upper part", robot.m_u, robot.I_u0)]
    for name, masses, inertias in bodies:
        largest = np.linalg.eigvalsh(inertias)[:, -1].clip(min=0.0)
        gyration = np.sqrt(largest / masses)
        least = LEAST_GYRATION[0] * _reach(robot) if name == "platform" else LEAST_GYRATION[1] * size
        wide, narrow = gyration > MOST_GYRATION * size, (0.0 < gyration) & (gyration < least)
        legs = np.flatnonzero(wide if wide.any() else narrow).tolist()
        where = f"{name}: " if name == "platform" else f"{name} of {legs_text(legs)}: "
        cause = (
            "inertia in kg mm^2, g cm^2 or kg cm^2, or about a point that is not the center of mass"
            if wide.any()
            else "inertia converted from kg mm^2 twice, or masses in grams"
        )
        reach = max(_reach(robot), 2.0 * float(gyration[0]))
        density = _density(robot.M, reach)
        if name == "platform" and density > DENSEST and reach > 0.0 and not wide.any():
            yield Finding(
                "mass",
                f"platform: {robot.M:g} kg within {reach:.3g} m, {density / DENSEST:.2g} times as dense as "
                "the densest metal; likely cause: mass in grams",
            )
            return
        if legs and size > 0.0:
            yield Finding(
                "inertia-size",
                f"{where}inertia {largest[legs[0]]:.3g} kg m^2 at {masses[legs[0]]:g} kg is that of a body "
                f"{gyration[legs[0]]:.3g} m in radius of gyration, on a machine of {size:.3g} m; likely "
                f"cause: {cause}",
            )
    far = np.linalg.norm(robot.R_0 - robot.p.mean(axis=0))
    if far > 10.0 * size > 0.0:
        yield Finding(
            "center-of-mass",
            f"platform: center_of_mass {far:.3g} m from the middle of the platform points, on a machine of "
            f"{size:.3g} m; likely cause: given in millimeters or in the base frame",
        )


# Geometry in all poses


def _of_geometry(robot: Robot) -> Iterator[Finding]:
    shares, rounding = _singular_shares(robot)
    if np.max(shares) < SINGULAR_SHARE:
        exact = bool(np.all(shares <= rounding))
        how = "singular in every pose" if exact else "singular in every pose except for digits of its points"
        yield Finding(
            "singular-everywhere",
            f"{how}: at {len(shares)} random poses the least singular value of H is at most "
            f"{np.max(shares):.1g} of the largest; likely cause: {_why_singular(robot)}",
        )


def _singular_shares(robot: Robot) -> tuple[Array, Array]:
    """Return smallest over largest singular value of H at random poses, (n,), and its rounding error.

    det H is a product of analytic functions: it vanishes everywhere or almost nowhere, so a few random poses
    suffice. Moments are about the platform center and divided by the platform radius. The error of an entry
    of H is a few rounding units of the coordinates that cancel in S = q + t - b, divided by L; 64 units are
    an ample bound.
    """
    rng = np.random.default_rng(0)
    count = 16
    size = radius(robot.b) + radius(robot.p)
    R = rotation_from_quaternion(rng.normal(size=(count, 4)))
    middle = robot.b.mean(axis=0) + size * rng.normal(size=(count, 3))
    t = middle - R @ robot.p.mean(axis=0)
    H, L = centered_H(robot.b, robot.p @ np.swapaxes(R, -1, -2), t, radius(robot.p))
    values = np.linalg.svd(H, compute_uv=False)
    reach = np.abs(t).max(axis=-1) + np.abs(robot.p).max() + np.abs(robot.b).max()
    shares = np.nan_to_num(values[:, -1] / values[:, 0])
    return shares, 64.0 * np.finfo(np.float64).eps * reach / L.min(axis=-1)


def _why_singular(robot: Robot) -> str:
    sets = (("base points", robot.b), ("platform points", robot.p))
    ends = np.concatenate([points / (radius(points) or 1.0) for _, points in sets], axis=-1)
    for i in range(LEGS):
        same = _near(ends, i)
        if len(same) > 1:
            return f"{legs_text(same)} coincide"
    for what, points in sets:
        scaled = points / (radius(points) or 1.0)
        groups = [group for i in range(LEGS) if len(group := _near(scaled, i)) > 3]
        if groups:
            return f"{what} of {legs_text(groups[0])} in one place"
        spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
        if spread[1] < _SAME * spread[0]:
            return f"{what} on one line"
    known = np.column_stack([robot.p, np.ones(LEGS)])
    image = known @ np.linalg.lstsq(known, robot.b, rcond=_SAME)[0]
    if np.abs(image - robot.b).max() < _SAME * radius(robot.b):
        return "base and platform points form similar hexagons; expected pairs of one above gaps of the other"
    return "points of no independent legs, in wrong order or on a surface of the second degree"


_SAME = 1e-3
# Radius, relative to the coordinates, below which it consists of rounding errors.
_ROUNDING = 1e-12


def _near(points: Array, i: int) -> list[int]:
    return np.flatnonzero(np.linalg.norm(points - points[i], axis=-1) < _SAME).tolist()


# The home pose


def _of_home(robot: Robot, home: Home) -> Iterator[Finding]:
    if robot.base_joint == "universal":
        yield from _of_axes(robot, home)
    # Legs that are too long for a machine of this size, although distant poses have them.
    too_long = np.mean(robot.length_limits[:, 0]) > MOST_LEGS * (radius(robot.b) + radius(robot.p))
    if not home.fits or too_long:
        yield _of_limits(robot, home)
        return
    parts = list(_of_parts(robot, home)) or list(_of_overlap(robot, home))
    parts = parts or list(leg_parts.of_part_lengths(robot, home))
    if parts:
        yield from parts
        return
    with np.errstate(invalid="ignore"):
        weak = np.flatnonzero(np.abs(home.F) > robot.force_limit).tolist()
    if weak:
        worst = max(weak, key=lambda i: abs(home.F[i]) / robot.force_limit[i])
        yield Finding(
            "force-limit",
            f"force_limit of {legs_text(weak)}: {robot.force_limit[worst]:.4g} N, but "
            f"{abs(home.F[worst]):.4g} N hold the machine at rest at the home pose; likely cause: "
            "force_limit in kN, masses in grams, or actuators too weak",
        )
    else:
        yield from leg_parts.of_slowness(robot)
    yield from leg_parts.of_torques(robot, home.F)
    yield from leg_parts.of_stroke(robot)


def _of_axes(robot: Robot, home: Home) -> Iterator[Finding]:
    s = (home.t + robot.p @ home.R.T - robot.b) / home.L[:, None]
    limited = bool(np.all(np.isfinite(robot.length_limits)))
    sine = np.linalg.norm(np.cross(s, robot.k), axis=-1)
    along = np.flatnonzero((sine < LEAST_SINE) & limited | np.all(sine < LEAST_SINES)).tolist()
    if along:
        yield Finding(
            "joint-singularity",
            f"universal_axis of {legs_text(along)}: {np.degrees(np.arcsin(sine[along].min())):.2g} degrees "
            "from the leg at the home pose, a joint singularity; likely cause: the leg's direction given, "
            "expected the axis fixed in the base, across the leg",
        )


def _of_limits(robot: Robot, home: Home) -> Finding:
    low, high = robot.length_limits.T
    finite = np.isfinite(high)
    ratio = float(np.mean(high[finite]) / np.mean(home.L[finite]))
    unit = next((unit for unit, share in _UNITS if _fits(robot, robot.length_limits * share)), "")
    larger = (unit for unit, share in UNITS_OF_LIMITS[:3] if _fits(robot, robot.length_limits * share))
    small = next(larger, "") if ratio < 0.5 else ""
    if small:
        cause = f"limits given in {small} in a file of another length_unit"
    elif unit or ratio > MOST_SIZE:
        cause = f"limits in {unit or 'millimeters'}"
    elif ratio < 0.9:
        cause = "the stroke given, expected the length from joint to joint"
    else:
        cause = "limits measured between other points than the joints, or points of another machine"
    size = radius(robot.b) + radius(robot.p)
    where = (
        f"legs so long on a machine of {size:.3g} m"
        if home.fits
        else "no pose was found with all legs within them, "
        f"{home.L.min():.4g} to {home.L.max():.4g} m long at the home pose"
    )
    limits = f"length_limits {low[finite].min():.4g} to {high[finite].max():.4g} m"
    return Finding("length-limits", f"{limits}: {where}; likely cause: {cause}")


_UNITS = (("millimeters", 1e-3), ("centimeters", 1e-2), ("inches", 0.0254))


def _fits(robot: Robot, limits: Array) -> bool:
    """Return True if a pose has all legs within other limits."""
    other = replace(robot, length_limits=limits)
    return home_of(other, level_home(other)).fits


def _of_parts(robot: Robot, home: Home) -> Iterator[Finding]:
    """Yield findings about centers of mass of leg parts outside the leg, on its wrong side, or far away."""
    off, least_off, times = MOST_OFFSET
    for part, r, sign, joint in (
        ("upper", robot.r_u0, "negative", "platform joint"),
        ("lower", -robot.r_d0, "positive", "base joint"),
    ):
        along, across, away = r[:, 0], np.linalg.norm(r[:, 1:], axis=-1), np.linalg.norm(r, axis=-1)
        far = away > 3.0 * home.L
        near = (away > LEAST_OFFSET[0] * home.L) & (away < LEAST_OFFSET[1] * home.L)
        beside = (across > least_off * home.L) & (across > times * np.abs(along))
        beside |= across > off * home.L
        wrong = along / home.L > BEYOND
        legs = np.flatnonzero(next((each for each in (far, near, beside) if each.any()), wrong)).tolist()
        if not legs:
            continue
        long = f"legs {home.L[legs].max():.3g} m long"
        if far.any():
            text = f"{away[legs].max():.3g} m from the {joint}, {long}"
            cause = "given in millimeters or in the base frame"
        elif near.any():
            text = f"{away[legs].min():.3g} m from the {joint}, {long}"
            cause = "given in meters in a file of millimeters"
        elif beside.any():
            text = f"{across[legs].max():.3g} m off the leg's axis, {long}"
            cause = "components in another order or in the base frame, expected the first along the leg"
        else:
            text = f"{along[legs].max():.3g} m beyond the {joint}, outside of the leg"
            cause = f"wrong sign, expected a {sign} first component, or a motor behind the joint"
        text = f"{part} part of {legs_text(legs)}: center_of_mass {text}; likely cause: {cause}"
        yield Finding("center-of-mass", text)


def _of_overlap(robot: Robot, home: Home) -> Iterator[Finding]:
    lower, upper = robot.r_d0[:, 0], -robot.r_u0[:, 0]
    over = parts_of(robot) > MOST_OVERLAP * home.L
    legs = np.flatnonzero(over).tolist()
    if legs:
        i = max(legs, key=lambda leg: float(parts_of(robot)[leg] / home.L[leg]))
        yield Finding(
            "overlap",
            f"lower and upper parts overlap at the home pose in {legs_text(legs)}: centers of mass "
            f"{lower[i]:.3g} m above the base joint and {upper[i]:.3g} m below the platform joint, leg "
            f"{home.L[i]:.3g} m; likely cause: both measured from one end, expected lower from the base, "
            "upper from the platform point",
        )
