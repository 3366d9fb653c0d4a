"""Random machines with offset joints."""

import dataclasses

import numpy as np
from machines import machine_size, random_motion, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
JOINTS = ("spherical", "universal")


def offsets_of(
    rng: np.random.Generator, robot: Robot, joint: str = "spherical", share: float = 0.05
) -> ss.Offsets:
    """Every offset and a cross; share: of the machine's size."""
    size = machine_size(robot)
    parts = {name: share * size * rng.normal(size=6) for name in ("cross", "along", "across")}
    if joint == "universal":
        parts["platform_axis"] = robot.k + 0.3 * rng.normal(size=(6, 3))
        parts["wrist"] = share * size * rng.normal(size=6)
    return ss.Offsets(
        platform_joint=joint,
        cross_mass=0.3 * robot.m_d,
        cross_center=share * size * rng.normal(size=(6, 3)),
        cross_inertia=0.003 * robot.m_d * size**2,
        **parts,
    )


def offset_case(
    seed: int, joint: str = "spherical", shape: tuple[int, ...] = (), screws: bool = False
) -> tuple[Robot, Motion]:
    """A machine and motions of it; screws: with a drive, three of whose screws are left-handed."""
    rng = np.random.default_rng(seed)
    plain = random_robot(rng)
    motion = random_motion(rng, plain, shape)
    drive = None
    if screws:
        size = machine_size(plain)
        lead = size * rng.uniform(0.02, 0.1, 6) * np.tile([1.0, -1.0], 3)
        drive = ss.Drive(lead=lead, rotor_inertia=1e-5 * plain.M * size**2)
    return dataclasses.replace(plain, offsets=offsets_of(rng, plain, joint), drive=drive), motion
