"""Machines as simple as a reduced model takes them for."""

import dataclasses

import numpy as np
from numpy.typing import NDArray

from stewart_sym.derive.mechanics.reduced_models import Fidelity
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]


def on_axis(points: Array) -> Array:
    return points * np.array([1.0, 0.0, 0.0])


def diagonal(axial: Array, across: Array) -> Array:
    return np.stack([np.diag([a, t, t]) for a, t in zip(axial, across, strict=True)])


def as_simple_as(robot: Robot, level: Fidelity) -> Robot:
    """The machine with legs that truly are what the level says."""
    changes: dict[str, Array] = {}
    if level.legs != "general":
        # A robot's masses are positive; these weigh nothing beside rounding.
        heavy = 1e-40 if level.legs == "massless" else 1.0
        thick = 1.0 if level.legs == "axisymmetric" else 0.0
        long = 0.0 if level.legs in ("massless", "point_masses") else 1.0
        for mass, center, inertia in (("m_d", "r_d0", "I_d0"), ("m_u", "r_u0", "I_u0")):
            tensors = getattr(robot, inertia)
            changes[mass] = heavy * getattr(robot, mass)
            changes[center] = on_axis(getattr(robot, center))
            changes[inertia] = diagonal(thick * tensors[:, 0, 0], long * tensors[:, 1, 1])
    if not level.friction:
        changes |= {name: np.zeros(6) for name in ("C_u", "C_p", "C_s")}
    return dataclasses.replace(robot, **changes)


def at_rest(motion: Motion) -> Motion:
    zero = np.zeros_like(motion.t)
    return dataclasses.replace(motion, omega=zero, v=zero, alpha=zero, a=zero)
