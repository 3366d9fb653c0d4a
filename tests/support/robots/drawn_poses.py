"""Poses drawn near a joint singularity."""

import dataclasses

import numpy as np
from machines import machine_in_motion
from near_singular import DTYPE

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

LEAST = 4096
"""Rounding units of the sine below which a leg is at its joint singularity."""
PATH = 1 / 32
"""Sine below which the kernels take their code path near the joint singularity."""


def drawn(rng: np.random.Generator, precision: str) -> tuple[Robot, Motion, float]:
    """A machine with some of its legs at one sine from their joint singularity, and that sine.

    From half the least sine that has a solution to 0.5; a quarter of them where the code path changes.
    """
    least = LEAST * float(np.finfo(DTYPE[precision]).eps)
    sine = np.exp(rng.uniform(np.log(0.5 * least), np.log(0.5)))
    if rng.random() < 0.25:
        sine = PATH * (1 + 1e-6 * rng.normal())
    robot, motion = machine_in_motion(rng)
    s = ss.inverse_kinematics(robot, motion).s
    across = np.cross(s, rng.normal(size=(6, 3)))
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    near = rng.random(6) < rng.choice([0.2, 1.0])
    k = np.where(near[:, None], np.sqrt(1 - sine**2) * s + sine * across, robot.k)
    return dataclasses.replace(robot, k=k), motion, sine if near.any() else 1.0
