"""Machines and motions of the study: general and special, of any size and mass, with different legs."""

import dataclasses
from collections.abc import Sequence

import numpy as np

from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_vector
from ...robot.robot import Robot

GRAVITY = 9.81
LEGS = ("general", "axisymmetric", "slender", "nearly massless")
"""Kinds of legs of a random machine."""

_BASE, _PLATFORM = (-12.0, 12.0, 108.0, 132.0, 228.0, 252.0), (-48.0, 48.0, 72.0, 168.0, 192.0, -72.0)
# Corners of a hexagon with two side lengths, and of the same hexagon rotated by 60 degrees, leg by leg.
_PAIRS, _PAIRS_TURNED = (-20.0, 20.0, 100.0, 140.0, 220.0, 260.0), (-40.0, 40.0, 80.0, 160.0, 200.0, 280.0)


def random_machine(
    rng: np.random.Generator, size: float = 1.0, mass: float = 10.0, legs: str = "general"
) -> Robot:
    """Generate a machine with a radius of the base (m), mass of the platform (kg), and one of ``LEGS``."""
    b, p = (
        radius * (_ring(angles) + 0.08 * rng.normal(size=(6, 3)))
        for radius, angles in ((size, _BASE), (0.6 * size, _PLATFORM))
    )
    m_d, m_u = mass * 10.0 ** rng.uniform(-1.0, 1.0, (2, 6)) * (1e-12 if legs == LEGS[3] else 1.0)
    general = float(legs == LEGS[0])
    along = rng.uniform(0.1, 0.6, (2, 6))
    off = 0.1 * general * rng.normal(size=(2, 6, 2))
    damping = general * mass * np.sqrt(GRAVITY / size) * rng.uniform(0.02, 0.2, (3, 6))
    home = b.mean(axis=0) + np.array([0.0, 0.0, 1.1 * size]) + p - b
    return Robot(
        name=f"random, {legs} legs",
        base_joint="universal",
        g=GRAVITY * _unit(np.array([0.0, 0.0, -1.0]) + 0.5 * rng.normal(size=3)),
        M=mass,
        R_0=0.2 * size * rng.normal(size=3),
        I_p=mass * size * size * _inertia(rng, LEGS[0]),
        b=b,
        p=p,
        k=np.array([_across(rng, direction) for direction in home]),
        m_d=m_d,
        r_d0=size * np.column_stack([along[0], off[0]]),
        I_d0=np.array([m * size * size * _inertia(rng, legs) for m in m_d]),
        m_u=m_u,
        r_u0=size * np.column_stack([-along[1], off[1]]),
        I_u0=np.array([m * size * size * _inertia(rng, legs) for m in m_u]),
        C_u=damping[0] * size * size,
        C_p=damping[1],
        C_s=damping[2] * size * size,
    )


def random_motion(rng: np.random.Generator, robot: Robot) -> Motion:
    """Generate a pose near the home pose with rates of the time scale of the machine and a load, shape ()."""
    from_mean, weight = robot.b - robot.b.mean(axis=0), robot.M * GRAVITY
    # The largest component is divided out first, because squares of lengths may exceed the range of double.
    largest = float(np.abs(from_mean).max())
    size = largest * float(np.sqrt(np.mean(np.sum((from_mean / largest) ** 2, axis=-1))))
    rate = float(np.sqrt(GRAVITY / size))
    at_home = robot.b.mean(axis=0) + np.array([0.0, 0.0, 1.1 * size])
    return Motion(
        R=rotation_from_vector(0.2 * rng.normal(size=3)),
        t=at_home + 0.15 * size * rng.normal(size=3),
        omega=0.5 * rate * rng.normal(size=3),
        v=0.5 * rate * size * rng.normal(size=3),
        alpha=0.5 * rate**2 * rng.normal(size=3),
        a=0.5 * rate**2 * size * rng.normal(size=3),
        F_ext=weight * rng.normal(size=3),
        M_ext=weight * size * rng.normal(size=3),
    )


def similar_hexagons(rng: np.random.Generator) -> Robot:
    """Generate a general machine with similar planar hexagons, rotated by 60 degrees at home.

    Rotated from there by 90 degrees about the normal, it is singular at any position (Fichter, 1986).
    """
    return dataclasses.replace(random_machine(rng), b=_ring(_PAIRS), p=0.6 * _ring(_PAIRS_TURNED))


def _ring(degrees: Sequence[float]) -> Array:
    angles = np.radians(degrees)
    return np.column_stack([np.cos(angles), np.sin(angles), np.zeros(6)])


def _across(rng: np.random.Generator, direction: Array) -> Array:
    while True:
        k = _unit(rng.normal(size=3))
        if np.linalg.norm(np.cross(k, _unit(direction))) > np.sqrt(0.5):
            return k


def _inertia(rng: np.random.Generator, legs: str) -> Array:
    """Compute a physical inertia of four mass points, divided by mass and size squared."""
    points = 0.15 * rng.normal(size=(4, 3)) * (np.array([1.0, 0.0, 0.0]) if legs == "slender" else 1.0)
    if legs != LEGS[0]:
        along, across = np.mean(points[:, 0] ** 2), np.mean(points[:, 1:] ** 2)
        return np.diag([2.0 * across, along + across, along + across])
    second = np.einsum("ni,nj->ij", points, points) / 4.0
    return np.asarray(np.trace(second) * np.eye(3) - second)


def _unit(vector: Array) -> Array:
    # As in ``random_motion``.
    vector = vector / np.abs(vector).max()
    return np.asarray(vector / np.linalg.norm(vector))
