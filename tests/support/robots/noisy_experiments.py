"""Experiments on random machines whose poses and forces are noisy."""

from functools import cache

import numpy as np
from machines import random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
NOISE = 1e-4
SAMPLES = 80


@cache
def robot(seed: int) -> Robot:
    return random_robot(np.random.default_rng(seed))


@cache
def excited(seed: int) -> ss.Excitation:
    return ss.choose_excitation(robot(seed), samples=SAMPLES, candidates=5)


@cache
def experiment(seed: int) -> ss.Experiment:
    return ss.simulate_experiment(robot(seed), excited(seed), 1.0, seed, NOISE, NOISE)


def change(machine: Robot, other: Robot, motion: ss.Motion) -> Array:
    """What the other machine's forces are more."""
    return ss.inverse_dynamics(other, motion).F - ss.inverse_dynamics(machine, motion).F


# Bodies


def truth(machine: Robot) -> tuple[ss.BaseParametersResult, Array]:
    base = ss.base_parameters(machine)
    return base, base.matrix @ ss.inertial_parameters(machine).values
