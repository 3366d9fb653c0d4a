"""Rotors of the drives: forces, reactions and equations of motion are those of Pinocchio with the rotors as
bodies of their own, and of MuJoCo with reflected masses; without rotor inertia nothing is different."""

import dataclasses
from functools import cache
from typing import Any, Literal

import numpy as np
import pytest
from machines import random_motion, random_robot, with_random_rotors
from motion_fields import acceleration
from numpy.typing import NDArray
from pinocchio_model import Answer, pinocchio_inverse_dynamics

import stewart_sym as ss
from stewart_sym.backend.fidelity import DRIVE_FIDELITIES
from stewart_sym.motion.motion import Motion
from stewart_sym.reference import equations_of_motion as oracle
from stewart_sym.reference import newton_euler
from stewart_sym.robot.drive import Drive
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

RELATIVE = 1e-10
MACHINES, POSES = 40, 3
BACKENDS: tuple[Literal["c", "numpy", "reference"], ...] = ("c", "numpy", "reference")
QUANTITIES = ("F", "F_s", "F_u", "F_p", "M_p", "M_u")


@cache
def _case(seed: int) -> tuple[Robot, Motion, list[Answer]]:
    rng = np.random.default_rng(seed)
    robot = with_random_rotors(rng, random_robot(rng))
    motion = random_motion(rng, robot, (POSES,))
    return robot, motion, [pinocchio_inverse_dynamics(robot, motion[i]) for i in range(POSES)]


@pytest.mark.parametrize("backend", BACKENDS)
def test_forces_and_reactions_are_those_of_rotors_as_bodies(backend: Any) -> None:
    for seed in range(MACHINES):
        robot, motion, truth = _case(seed)
        forces = ss.inverse_dynamics(robot, motion, backend=backend)
        reactions = ss.joint_reactions(robot, motion, backend=backend)
        for name in QUANTITIES:
            for found, answer in zip(getattr(forces if name == "F" else reactions, name), truth, strict=True):
                expected = getattr(answer, name)
                assert np.abs(found - expected).max() < RELATIVE * np.abs(expected).max(), (seed, name)


def test_the_kernels_of_the_forces_alone_are_right_and_their_bounds_hold() -> None:
    for seed in range(MACHINES):
        robot, motion, truth = _case(seed)
        expected = np.array([answer.F for answer in truth])
        peak = np.abs(expected).max()
        assert np.abs(ss.prepare(robot).forces(motion) - expected).max() < RELATIVE * peak
        bounded = ss.forces_with_bounds(robot, motion)
        assert np.all(np.abs(bounded.F - expected) < bounded.bound + 1e-13 * peak)
        assert bounded.bound.max() < 1e-9 * peak


def test_a_rotor_moves_every_force_and_its_momentum_those_across() -> None:
    for seed in range(MACHINES):
        robot, motion, _ = _case(seed)
        F, K = (getattr(ss.inverse_dynamics(robot, motion), name) for name in ("F", "K"))
        fast = ss.inverse_dynamics(_without_momentum(robot), motion)
        none = ss.inverse_dynamics(dataclasses.replace(robot, drive=None), motion)
        assert np.abs(F - none.F).max() > 1e-2 * np.abs(F).max()
        assert np.abs(F - fast.F).max() > 1e-5 * np.abs(F).max()
        assert np.abs(K - fast.K).max() > 1e-5 * np.abs(K).max()
        assert np.abs(fast.K - none.K).max() < 1e-7 * np.abs(K).max()


@pytest.mark.parametrize("backend", BACKENDS)
def test_equations_of_motion_are_those_of_rotors_as_bodies(backend: Any) -> None:
    for seed in range(MACHINES if backend == "c" else 4):
        robot, motion, _ = _case(seed)
        found = ss.equations_of_motion(robot, motion[:1], backend=backend)
        expected = _pinocchio_equations(seed)
        for name in ("M", "C", "g", "friction", "bias"):
            a, b = getattr(found, name), getattr(expected, name)
            assert np.abs(a - b).max() < RELATIVE * np.abs(b).max(), (seed, name)
        F = ss.inverse_dynamics(robot, motion[:1], backend=backend).F
        a, alpha = ss.forward_dynamics(robot, motion[:1], F, backend=backend)[:2]
        there = np.concatenate([a, alpha], axis=-1)
        needed = np.concatenate([np.asarray(motion[:1].a), np.asarray(motion[:1].alpha)], axis=-1)
        assert np.abs(there - needed).max() < RELATIVE * np.abs(needed).max()


@cache
def _pinocchio_equations(seed: int) -> Any:
    robot, motion, _ = _case(seed)

    def wrench(robot: Robot, motion: Motion) -> tuple[Array, NDArray[np.int32]]:
        H = ss.inverse_dynamics(robot, motion, backend="reference").H
        F = np.empty((*motion.shape, 6))
        for i in np.ndindex(motion.shape):
            F[i] = pinocchio_inverse_dynamics(robot, motion[i]).F
        return (H @ F[..., None])[..., 0], np.zeros(motion.shape, dtype=np.int32)

    return oracle.by_linearity(wrench, robot, motion[:1])


def _without_momentum(robot: Robot) -> Robot:
    """The same reflected masses of rotors without angular momentum: tiny ones that turn very fast."""
    assert robot.drive is not None
    share = 1e-9
    drive = Drive(lead=share * robot.drive.lead, rotor_inertia=share**2 * robot.drive.rotor_inertia)
    return dataclasses.replace(robot, drive=drive)
