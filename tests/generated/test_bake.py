"""Kernels with a robot's numbers folded in compute the same forces from fewer operations."""

import ctypes
import dataclasses
import functools

import numpy as np
import pytest
from machines import dasgupta, random_motion, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION, operations_per_pose
from stewart_sym.calls.c_kernel import address
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.kit import Choice
from stewart_sym.kit.required_kernels import parts
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]


def baked_forces(robot: Robot, motion: Motion) -> Array:
    files = parts(robot, Choice(bake=True)).files
    call = getattr(native.load("baked", files, ["-O0"]), f"{robot_symbol(robot.name)}_forces_batch")
    count = motion.t.shape[0]
    F, status = np.full((count, 6), np.nan), np.zeros(count, dtype=np.int32)
    arrays = [np.ascontiguousarray(getattr(motion, name)) for name in MOTION]
    pointers = (ctypes.c_void_p * len(arrays))(*map(address, arrays))
    call(ctypes.c_size_t(count), pointers, address(F), address(status))
    assert (status == 0).all()
    return F


def motions(robot: Robot, count: int = 9) -> Motion:
    rng = np.random.default_rng(8)
    poses = [random_motion(rng, robot) for _ in range(count)]
    return Motion(**{name: np.stack([getattr(pose, name) for pose in poses]) for name in MOTION})


def simple_robot() -> Robot:
    """Planar base and platform, gravity straight down, identical slim legs, no friction."""
    robot = random_robot(np.random.default_rng(1), friction=False)
    flat = np.array([1.0, 1.0, 0.0])
    alike = {
        name: np.tile(getattr(robot, name)[:1], (6,) + (1,) * (getattr(robot, name).ndim - 1))
        for name in ("m_d", "m_u", "r_d0", "r_u0", "I_d0", "I_u0")
    }
    across = np.array([0.0, 1.0, 1.0])
    for name in ("r_d0", "r_u0"):
        alike[name] = alike[name] * np.array([1.0, 0.0, 0.0])
    for name in ("I_d0", "I_u0"):
        alike[name] = np.tile(np.diag(across * alike[name][0, 1, 1]), (6, 1, 1))
    return dataclasses.replace(
        robot,
        b=robot.b * flat,
        p=robot.p * flat,
        g=np.array([0.0, 0.0, -9.81]),
        R_0=np.zeros(3),
        I_p=np.diag(np.diag(robot.I_p)),
        **alike,
    )


def test_baking_the_papers_machine_saves_operations() -> None:
    made = parts(dasgupta(), Choice(fidelity="massless_static", bake=True))
    assert made.baked_operations is not None
    assert made.baked_operations < made.operations


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")
def test_terms_that_are_zero_for_a_robot_disappear_from_its_kernel() -> None:
    robot = simple_robot()
    cost = functools.partial(_baked_operations, robot)
    general, slim = cost("general"), cost("axisymmetric")
    # Friction, offsets and products of inertia are gone by themselves.
    assert general <= cost("frictionless") <= operations_per_pose(robot, fidelity="axisymmetric")
    assert general <= slim + 5
    motion = motions(robot)
    found, expected = baked_forces(robot, motion), ss.inverse_dynamics(robot, motion).F
    assert np.abs(found - expected).max() <= 1e-11 * np.abs(expected).max()


def _baked_operations(robot: Robot, level: str) -> int:
    count = parts(robot, Choice(fidelity=level, bake=True)).baked_operations
    assert count is not None
    return count
