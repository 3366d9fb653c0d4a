"""Families 7: machines of any size, mass, and proportion, with very different masses, and at the ends of the
range.
"""

import dataclasses

import numpy as np

from ...io.array_types import Array
from ...motion.motion import Motion
from ...robot.robot import Robot
from . import shipped
from .family import Family
from .sweep.machines import random_machine, random_motion

POINTS = 43
REMEDIES = dict.fromkeys(("scale_platform", "scale_leg"), "moments are taken about a point of the platform")


def families(seed: int = 7) -> list[Family]:
    """Return families of lengths, masses, leg-to-platform mass ratios, proportions, and the ends of the
    range.
    """
    lengths, masses = np.logspace(3, -4, POINTS), np.logspace(6, -6, POINTS)
    platforms, legs = np.logspace(0, -5, POINTS), np.logspace(4, 0, POINTS)
    found = []
    for name, title, axis, factors, make in (
        ("scale_length", "Machines of 1e-4 to 1e3 m", "radius of the base, m", lengths, _sized),
        (
            "scale_mass",
            "Machines of 1e-6 to 1e6 kg",
            "mass of the platform, kg",
            masses,
            lambda mass, seed: _sized(1.0, seed, mass),
        ),
        ("scale_mixed", "Legs of 1e-6 to 1e6 times their mass", "factor of the legs' masses", masses, _mixed),
        (
            "scale_platform",
            "Platforms from the base's size to 1e-5 of it",
            "size of the platform, share",
            platforms,
            _small,
        ),
        ("scale_leg", "One leg up to 1e4 times as long as the others", "factor of its length", legs, _long),
    ):
        pairs = [make(float(factor), seed) for factor in factors]
        robots, motions = [list(each) for each in zip(*pairs, strict=True)]
        curves = shipped.curves(robots, motions, in_float=True)
        found.append(
            Family(
                name,
                title,
                title[0].lower() + title[1:],
                REMEDIES.get(name, "nothing to do: elimination and thresholds are relative"),
                axis,
                curves,
                factors,
            )
        )
    return [*found, _extreme(seed)]


def _extreme(seed: int) -> Family:
    """Change lengths from 1e200 to 1e-200 m at constant shape, with the time scale of the motion."""
    factors = np.logspace(200, -200, 81)
    # Larger machines are lighter, so that their inertias remain within the range of double.
    pairs = [_sized(float(factor), seed, float(1.0 / factor)) for factor in factors]
    robots, motions = [list(each) for each in zip(*pairs, strict=True)]
    curves = shipped.curves(robots, motions)
    notes = []
    for curve in curves:
        if curve.shipped and curve.status is not None:
            good = factors[curve.answered]
            codes = sorted({int(code) for code in curve.status if code})
            notes.append(
                f"{curve.method}: answers from {good.min():.0e} to {good.max():.0e} m, beyond: {codes}."
            )
    return Family(
        "scale_extreme",
        "Machines of 1e-200 to 1e200 m: overflow and subnormal numbers",
        "overflow, underflow",
        "status 1 if a result or a square exceeds the range of double",
        "radius of the base, m",
        curves,
        factors,
        notes=tuple(notes),
        beyond_range=True,
    )


def _sized(size: float, seed: int, mass: float = 10.0) -> tuple[Robot, Motion]:
    rng = np.random.default_rng(seed)
    robot = random_machine(rng, size, mass)
    return robot, random_motion(rng, robot)


def _mixed(factor: float, seed: int) -> tuple[Robot, Motion]:
    robot, motion = _sized(1.0, seed)
    heavier: dict[str, Array] = {
        name: factor * getattr(robot, name) for name in ("m_d", "m_u", "I_d0", "I_u0")
    }
    return dataclasses.replace(robot, **heavier), motion  # type: ignore[arg-type]


def _small(share: float, seed: int) -> tuple[Robot, Motion]:
    robot, motion = _sized(1.0, seed)
    shrunk = dataclasses.replace(robot, p=share * robot.p, R_0=share * robot.R_0, I_p=share**2 * robot.I_p)
    return shrunk, dataclasses.replace(motion, M_ext=None if motion.M_ext is None else share * motion.M_ext)


def _long(factor: float, seed: int) -> tuple[Robot, Motion]:
    robot, motion = _sized(1.0, seed)
    tip = robot.p[0] @ motion.R.T + motion.t
    b = robot.b.copy()
    b[0] = tip - factor * (tip - b[0])
    return dataclasses.replace(robot, b=b), motion
