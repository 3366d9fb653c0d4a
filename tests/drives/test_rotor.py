"""Rotors of the drives: forces, reactions and equations of motion are those of Pinocchio with the rotors as
bodies of their own, and of MuJoCo with reflected masses; without rotor inertia nothing is different."""

import dataclasses
from functools import cache
from typing import Any, Literal

import numpy as np
import pytest
from machines import Array, random_motion, random_robot, rotation, with_random_rotors
from numpy.typing import NDArray
from pinocchio_model import Answer, pinocchio_inverse_dynamics
from reduced_machines import as_simple_as
from sweeps import slow_but

import stewart_sym as ss
from stewart_sym.derive.mechanics.reduced_models import DRIVE_FIDELITIES as DERIVED
from stewart_sym.generated.fidelities import DRIVE_FIDELITIES
from stewart_sym.reference import equations_of_motion as oracle
from stewart_sym.reference import newton_euler

RELATIVE = 1e-10
MACHINES, POSES = 6, 2
BACKENDS: tuple[Literal["c", "numpy", "reference"], ...] = ("c", "numpy", "reference")
REFLECTED = [each for each in DRIVE_FIDELITIES if each.startswith("reflected")]
QUANTITIES = ("F", "F_s", "F_u", "F_p", "M_p", "M_u")


@cache
def _case(seed: int) -> tuple[ss.Robot, ss.Motion, list[Answer]]:
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


@pytest.mark.slow
def test_the_kernels_of_the_forces_alone_are_right_and_their_bounds_hold() -> None:
    for seed in range(MACHINES):
        robot, motion, truth = _case(seed)
        expected = np.array([answer.F for answer in truth])
        peak = np.abs(expected).max()
        assert np.abs(ss.ForceKernel(robot).forces(motion) - expected).max() < RELATIVE * peak
        bounded = ss.force_error_bounds(robot, motion)
        assert np.all(np.abs(bounded.F - expected) < bounded.bound + 1e-13 * peak)
        assert bounded.bound.max() < 1e-9 * peak


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_equations_of_motion_are_those_of_rotors_as_bodies(backend: Any) -> None:
    for seed in range(2):
        robot, motion, _ = _case(seed)
        found = ss.equations_of_motion(robot, motion[:1], backend=backend)
        expected = _pinocchio_equations(seed)
        for name in ("M", "C", "g", "friction", "bias", "bias_and_friction"):
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

    def wrench(robot: ss.Robot, motion: ss.Motion) -> tuple[Array, NDArray[np.int32]]:
        H = ss.inverse_dynamics(robot, motion, backend="reference").H
        F = np.empty((*motion.shape, 6))
        for i in np.ndindex(motion.shape):
            F[i] = pinocchio_inverse_dynamics(robot, motion[i]).F
        return (H @ F[..., None])[..., 0], np.zeros(motion.shape, dtype=np.int32)

    return oracle.by_linearity(wrench, robot, motion[:1])


def _without_momentum(robot: ss.Robot) -> ss.Robot:
    """The same reflected masses of rotors without angular momentum: tiny ones that turn very fast."""
    share = 1e-9
    drive = ss.Drive(lead=share * robot.drive.lead, rotor_inertia=share**2 * robot.drive.rotor_inertia)
    return dataclasses.replace(robot, drive=drive)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_derivatives_are_those_of_the_reference(backend: Any) -> None:
    for seed in range(2):
        robot, motion, _ = _case(seed)
        motion = motion[0]
        found = ss.force_derivatives(robot, motion, backend=backend)

        def F(robot: ss.Robot, motion: ss.Motion) -> Array:
            return newton_euler.inverse_dynamics(robot, motion).F

        for name, fields in (
            ("pose", ("t", "R")),
            ("twist", ("v", "omega")),
            ("acceleration", ("a", "alpha")),
        ):
            slopes = getattr(found, f"by_{name}")
            expected = np.column_stack(
                [_slope(F, robot, motion, field, axis) for field in fields for axis in range(3)]
            )
            assert np.abs(slopes - expected).max() < 1e-7 * np.abs(expected).max(), (seed, name)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_linearized_motion_is_that_of_forward_dynamics(backend: Any) -> None:
    for seed in range(2):
        robot, motion, truth = _case(seed)
        motion, forces = motion[0], truth[0].F

        def solved(robot: ss.Robot, motion: ss.Motion, forces: Array = forces) -> Array:
            a, alpha = ss.forward_dynamics(robot, motion, forces, backend="reference")[:2]
            return np.concatenate([a, alpha])

        found = ss.linearize(robot, motion, forces, backend=backend)
        expected = np.column_stack(
            [
                _slope(solved, robot, motion, field, axis)
                for field in ("t", "R", "v", "omega")
                for axis in range(3)
            ]
        )
        assert np.abs(found.A[6:] - expected).max() < 1e-6 * np.abs(expected).max(), seed


def _slope(function: Any, robot: ss.Robot, motion: ss.Motion, field: str, axis: int) -> Array:
    """Derivative by one component, by differences of the fourth order."""
    step = 1e-3 * (1.0 if field == "R" else max(float(np.abs(getattr(motion, field)).max()), 1e-2))

    def at(times: int) -> Array:
        by = times * step
        if field == "R":
            turn = rotation(by * np.eye(3)[axis])
            return np.asarray(function(robot, dataclasses.replace(motion, R=turn @ motion.R)))
        value = getattr(motion, field) + by * np.eye(3)[axis]
        return np.asarray(function(robot, dataclasses.replace(motion, **{field: value})))

    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step)


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_of_legs_that_may_spin_the_reflected_mass_is_left(backend: Any) -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        plain = random_robot(rng, "spherical")
        robot, motion = with_random_rotors(rng, plain), random_motion(rng, plain, (POSES,))
        assert not np.any(robot.rotor_momentum)
        found = ss.inverse_dynamics(robot, motion, backend=backend)
        bare = ss.inverse_dynamics(plain, motion, backend=backend)
        needed = robot.reflected_mass * ss.inverse_kinematics(robot, motion).L_ddot
        np.testing.assert_allclose(found.F, bare.F + needed, rtol=0, atol=1e-12 * np.abs(found.F).max())
        np.testing.assert_allclose(found.K, bare.K, rtol=0, atol=1e-12 * np.abs(found.F).max())
        assert np.abs(ss.ForceKernel(robot).forces(motion) - found.F).max() < 1e-12 * np.abs(found.F).max()
        F_p = ss.joint_reactions(robot, motion, backend=backend).F_p
        assert (
            np.abs(F_p - ss.joint_reactions(plain, motion, backend=backend).F_p).max()
            < 1e-11 * np.abs(F_p).max()
        )


@pytest.mark.parametrize("name", slow_but(REFLECTED[:1], REFLECTED))
@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")
def test_reflected_levels_equal_the_general_one_where_the_machine_is_that_simple(name: str) -> None:
    level = DERIVED[name]
    for seed in range(3):
        robot, _, _ = _case(seed)
        robot = _without_momentum(as_simple_as(robot, level))
        motion = random_motion(np.random.default_rng(seed), robot)
        found, expected = (
            ss.ForceKernel(robot, fidelity=name).forces(motion),
            ss.inverse_dynamics(robot, motion),
        )
        size = max(np.abs(values).max() for values in (expected.F, expected.D, expected.x))
        assert np.abs(found - expected.F).max() <= 1e-8 * size


def test_the_regressor_of_rotors_stands_beside_that_of_the_bodies() -> None:
    for seed in range(5):
        robot, motion, truth = _case(seed)
        H = ss.inverse_dynamics(robot, motion).H
        F = np.array([answer.F for answer in truth])
        needed = (H @ F[..., None])[..., 0] + motion.external_wrench()
        bodies = ss.regressor(robot, motion) @ ss.inertial_parameters(robot).values
        rotors = ss.rotor_regressor(robot, motion) @ np.concatenate(
            [robot.reflected_mass, robot.rotor_momentum]
        )
        assert np.abs(bodies + rotors - needed).max() < RELATIVE * np.abs(needed).max()
        assert np.abs(rotors).max() > 1e-3 * np.abs(needed).max()
