"""The reference against Pinocchio, an engine that shares nothing with it: random machines, everything on."""

from functools import cache

import numpy as np
import pytest
from machines import machine_in_motion
from pinocchio_model import Answer, pinocchio_inverse_dynamics
from sweeps import share

from stewart_sym.motion.motion import Motion
from stewart_sym.reference import newton_euler
from stewart_sym.reference.newton_euler import EXACT, PAPER
from stewart_sym.robot.robot import Robot

RELATIVE = 1e-10
POSES = 3
SEEDS = range(share(60, 10))
QUANTITIES = ("F", "F_s", "F_u", "F_p", "M_p", "M_u")

# Each fault, the least it moves the forces by on every machine below, and whether it moves M_u. Fault 3 adds
# no inertia about the leg's axis and fault 4 is one of the platform: neither of them can.
SINGLE_FAULTS = [(1, 1e-3, True), (2, 1e-3, True), (3, 1e-2, False), (4, 1e-1, False)]


def test_exact_agrees_with_pinocchio() -> None:
    for seed in SEEDS:
        errors = _errors(*_universal(seed), EXACT)
        assert max(errors.values()) < RELATIVE, (seed, errors)


def test_paper_differs_from_pinocchio_in_every_force() -> None:
    for seed in SEEDS:
        errors = _errors(*_universal(seed), PAPER)
        assert min(errors.values()) > 1e-2, (seed, errors)


@pytest.mark.parametrize(("fault", "least", "moves_M_u"), SINGLE_FAULTS, ids=["1", "2", "3", "4"])
def test_each_fault_alone_differs_from_pinocchio(fault: int, least: float, moves_M_u: bool) -> None:
    for seed in SEEDS:
        errors = _errors(*_universal(seed), frozenset({fault}))
        assert min(errors["F"], errors["F_s"], errors["F_u"]) > least, (seed, errors)
        if moves_M_u:
            assert errors["M_u"] > least, (seed, errors)
        else:
            assert errors["M_u"] < RELATIVE, (seed, errors)


@pytest.mark.parametrize("faults", [EXACT, frozenset({1, 2})], ids=["exact", "faults 1 and 2"])
def test_legs_with_two_spherical_joints_agree_with_pinocchio(faults: frozenset[int]) -> None:
    for seed in range(100, 105):
        robot, motion, truth = _case(seed, "spherical", False)
        errors = _errors(robot, motion, truth, faults)
        assert max(errors[name] for name in QUANTITIES if name != "M_u") < RELATIVE, (seed, errors)
        assert np.all(newton_euler.joint_reactions(robot, motion, faults).M_u == 0)
        scale = max(np.abs(answer.M_p).max() for answer in truth)
        assert max(np.abs(answer.M_u).max() for answer in truth) < RELATIVE * scale


def _universal(seed: int) -> tuple[Robot, Motion, list[Answer]]:
    return _case(seed, "universal", True)


@cache
def _case(seed: int, base_joint: str, friction: bool) -> tuple[Robot, Motion, list[Answer]]:
    """A machine, some motions of it and Pinocchio's answers; an external wrench is always on."""
    robot, motion = machine_in_motion(seed, (POSES,), base_joint, friction=friction)
    return robot, motion, [pinocchio_inverse_dynamics(robot, motion[i]) for i in range(POSES)]


def _errors(robot: Robot, motion: Motion, truth: list[Answer], faults: frozenset[int]) -> dict[str, float]:
    """Largest error of each quantity over the poses, relative to the largest entry of the pose."""
    forces = newton_euler.inverse_dynamics(robot, motion, faults)
    reactions = newton_euler.joint_reactions(robot, motion, faults)
    assert np.all(forces.status == 0)
    errors = {}
    for name in QUANTITIES:
        computed = getattr(forces if name == "F" else reactions, name)
        errors[name] = max(
            float(np.abs(computed[i] - getattr(answer, name)).max() / np.abs(getattr(answer, name)).max())
            for i, answer in enumerate(truth)
            if np.any(getattr(answer, name))
        )
    return errors
