"""CasADi functions of one machine: the C's numbers and statuses and our derivatives."""

import dataclasses
import sys
from typing import Any

import casadi
import numpy as np
import pytest
from command_line import rejects
from leaning_legs import leaning
from machines import (
    MACHINES,
    dasgupta,
    machine_in_motion,
    random_motion,
    random_robot,
    with_random_drives,
)
from motion_fields import FIELDS
from sweeps import FULL, slow_but

import stewart_sym as ss

OF_MACHINES = pytest.mark.parametrize(
    ("machine", "checked"),
    [("paper", True), *slow_but((), [("random", False), ("upside down, mm", False)][: 2 if FULL else 1])],
)


def called(function: Any, motion: ss.Motion, **more: Any) -> dict[str, np.ndarray]:
    given = {name: getattr(motion, name) for name in FIELDS} | more
    found = function(**{name: given[name] for name in function.name_in()})
    return {name: np.squeeze(np.asarray(each)) for name, each in found.items()}


@pytest.mark.slow
@OF_MACHINES
def test_values_are_those_of_the_c(machine: str, checked: bool) -> None:
    robot = MACHINES[machine]()
    motion = random_motion(np.random.default_rng(50), robot)
    expected = ss.inverse_dynamics(robot, motion)
    condition = np.linalg.cond(expected.H)
    found = called(ss.casadi_function(robot, "forces", checked=checked), motion)
    np.testing.assert_allclose(
        found["F"], expected.F, rtol=0, atol=1e-14 * condition * np.abs(expected.F).max()
    )
    terms = called(ss.casadi_function(robot, "equations", checked=checked), motion)
    answers = ss.equations_of_motion(robot, motion)
    for name in ("M", "C", "g", "friction", "bias", "bias_and_friction"):
        answer = getattr(answers, name)
        np.testing.assert_allclose(terms[name], answer, rtol=0, atol=1e-14 * np.abs(answer).max())
    moved = called(ss.casadi_function(robot, "forward_dynamics", checked=checked), motion, F=expected.F)
    condition = np.linalg.cond(answers.M)
    answer = ss.forward_dynamics(robot, motion, expected.F)
    for name in ("a", "alpha"):
        scale = np.abs(getattr(answer, name)).max()
        np.testing.assert_allclose(moved[name], getattr(answer, name), rtol=0, atol=1e-14 * condition * scale)
    for results in (found, terms, moved):
        assert results.get("status", 0) == 0
        assert ("status" in results) is checked


@pytest.mark.parametrize("joint", ["universal", "spherical"])
def test_lengths_rates_and_torques_are_those_of_numpy(joint: str) -> None:
    rng = np.random.default_rng(54)
    robot = with_random_drives(rng, random_robot(rng, joint), rotors=True)
    motion = random_motion(rng, robot)
    legs, effort = ss.inverse_kinematics(robot, motion), ss.drive_effort(robot, motion)
    found = called(ss.casadi_function(robot, "lengths"), motion)
    found |= called(ss.casadi_function(robot, "rates"), motion)
    found |= called(ss.casadi_function(robot, "torques", checked=False), motion)
    for name, expected in (("L", legs.L), ("L_dot", legs.L_dot), ("torque", effort.torque)):
        np.testing.assert_allclose(found[name], expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    rejects(r"^robot: drive: missing", ss.casadi_function, dataclasses.replace(robot, drive=None), "torques")


@pytest.mark.slow
def test_statuses_are_those_of_the_c_and_numbers_are_nan_there() -> None:
    rng = np.random.default_rng(51)
    upright, motion = machine_in_motion(rng)
    for sine, status in ((0.01, 0), (1e-5, 0), (1e-14, 3)):
        robot = leaning(upright, motion, sine, 2, rng.normal(size=3))
        F, codes = ss.ForceKernel(robot).forces_and_status(motion)
        found = called(ss.casadi_function(robot), motion)
        assert found["status"] == codes == status
        np.testing.assert_allclose(found["F"], F, rtol=1e-9, equal_nan=True)


def moved(function: Any, robot: ss.Robot, motion: ss.Motion, **more: Any) -> tuple[Any, list[Any], Any]:
    """Results as expressions of [dt; dphi], [v; omega] and [a; alpha] about a motion."""
    step, twist, rate = (casadi.SX.sym(name, 6) for name in ("step", "twist", "rate"))
    given = {"F_ext": motion.F_ext, "M_ext": motion.M_ext, **more}
    given |= {"R": (casadi.SX.eye(3) + casadi.skew(step[3:])) @ motion.R, "t": motion.t + step[:3]}
    given |= {"v": twist[:3], "omega": twist[3:], "a": rate[:3], "alpha": rate[3:]}
    at = [np.zeros(6), np.r_[motion.v, motion.omega], np.r_[motion.a, motion.alpha]]
    found = function(**{name: given[name] for name in function.name_in()})
    return found, [step, twist, rate], at


@OF_MACHINES
def test_jacobians_are_our_derivatives(machine: str, checked: bool) -> None:
    robot = MACHINES[machine]()
    motion = random_motion(np.random.default_rng(52), robot)
    found, by, at = moved(ss.casadi_function(robot, checked=checked), robot, motion)
    slopes = casadi.Function("slopes", by, [casadi.jacobian(found["F"], each) for each in by])(*at)
    expected = ss.force_derivatives(robot, motion)
    answers = (expected.by_pose, expected.by_twist, expected.by_acceleration)
    for slope, answer in zip(slopes, answers, strict=True):
        np.testing.assert_allclose(slope, answer, rtol=0, atol=1e-9 * np.abs(answer).max())


def test_jacobians_of_forward_dynamics_are_the_linearization() -> None:
    robot = MACHINES["random"]()
    motion = random_motion(np.random.default_rng(53), robot)
    F = ss.ForceKernel(robot).forces(motion)
    force = casadi.SX.sym("force", 6)
    function = ss.casadi_function(robot, "forward_dynamics", checked=False)
    found, (step, twist, _), at = moved(function, robot, motion, F=force)
    rates = casadi.vertcat(found["a"], found["alpha"])
    by = [step, twist, force]
    slopes = casadi.Function("slopes", by, [casadi.jacobian(rates, each) for each in by])(*at[:2], F)
    expected = ss.linearize(robot, motion, F)
    answers = (expected.A[6:, :6], expected.A[6:, 6:], expected.B[6:])
    for slope, answer in zip(slopes, answers, strict=True):
        np.testing.assert_allclose(slope, answer, rtol=0, atol=1e-9 * np.abs(answer).max())


def test_a_missing_casadi_and_other_names_are_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(
        ValueError, match=r'^quantity: expected "forces", "equations", "forward_dynamics", "lengths", "rates"'
    ):
        ss.casadi_function(dasgupta(), "inertia")
    rejects(r"^checked: expected True or False", ss.casadi_function, dasgupta(), checked="no")
    monkeypatch.setitem(sys.modules, "casadi", None)
    with pytest.raises(
        ImportError, match=r'^a CasADi function needs CasADi: pip install "stewart-sym\[casadi\]"$'
    ):
        ss.casadi_function(dasgupta())
