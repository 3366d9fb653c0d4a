"""Formulas of one machine: their values are the C's, their steps have names, and M's LaTeX fits a page."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from command_line import rejects
from machines import dasgupta, machine_in_motion, random_motion
from motion_fields import FIELDS

import stewart_sym as ss


def value(formulas: ss.SymbolicResult, motion: ss.Motion, **more: Any) -> np.ndarray:
    given = {name: getattr(motion, name) for name in FIELDS if name in formulas.arguments}
    return formulas.function()(**given, **more)


def close(found: np.ndarray, answer: np.ndarray, condition: float = 1.0) -> None:
    np.testing.assert_allclose(found, answer, rtol=0, atol=1e-12 * condition * np.abs(answer).max())


@pytest.mark.slow
@pytest.mark.parametrize("what", ["F", "M"])
def test_formulas_of_the_papers_machine_have_the_values_of_the_c(what: str) -> None:
    robot = dasgupta()
    motion = random_motion(np.random.default_rng(39), robot)
    source = ss.equations_of_motion if what == "M" else ss.inverse_dynamics
    # Offsets of zero are none.
    close(
        value(ss.symbolic(replace(robot, offsets=ss.JointOffsets()), what), motion),
        getattr(source(robot, motion), what),
    )


@pytest.mark.slow
@pytest.mark.parametrize(("formulation", "joint"), [("exact", "spherical"), ("paper", "universal")])
def test_every_formulation_has_formulas_of_its_forces(formulation: Any, joint: str) -> None:
    robot, motion = machine_in_motion(41, base_joint=joint)
    expected = ss.inverse_dynamics(robot, motion, formulation=formulation)
    for name in ("F",):
        close(value(ss.symbolic(robot, name, formulation=formulation), motion), getattr(expected, name))


@pytest.mark.slow
def test_whole_formulas_hold_the_arguments_alone_and_the_same_values() -> None:
    robot = dasgupta()
    motion = random_motion(np.random.default_rng(42), robot)
    H = ss.symbolic(robot, "H")
    whole = H.substituted()
    pose = [symbol for name in ("R", "t") for symbol in H.arguments[name]]
    assert whole.free_symbols <= set(pose)
    numbers = [*motion.R.ravel(), *motion.t]
    found = np.array(whole.subs(dict(zip(pose, numbers, strict=True))), dtype=float)
    close(found, ss.inverse_dynamics(robot, motion).H)


def test_each_step_uses_arguments_constants_and_earlier_steps_and_has_a_use() -> None:
    formulas = ss.symbolic(dasgupta(), "M")
    known = set(formulas.constants).union(*(given.free_symbols for given in formulas.arguments.values()))
    used = set(formulas.result.free_symbols)
    for symbol, expr in formulas.steps:
        assert expr.free_symbols <= known, symbol
        known.add(symbol)
        used |= expr.free_symbols
    assert known & {symbol for symbol, _ in formulas.steps} <= used
    assert {"L_1", "L_6", "rho_3", "s_x_2"} <= {symbol.name for symbol, _ in formulas.steps}
    assert all(isinstance(entry, sp.Symbol) for entry in formulas.result)


@pytest.mark.slow
def test_a_derivative_by_its_steps_is_that_of_the_values() -> None:
    robot = dasgupta()
    motion = random_motion(np.random.default_rng(43), robot)
    gravity = ss.symbolic(robot, "g")
    for name, i in (("t", 2),):
        slope = value(gravity.derivative(gravity.arguments[name][i]), motion)
        step = np.zeros(getattr(motion, name).shape)
        step.flat[i] = 1e-6
        at = [{n: getattr(motion, n) for n in FIELDS} for _ in range(2)]
        for each, sign in zip(at, (1, -1), strict=True):
            each[name] = each[name] + sign * step
        evaluate = gravity.function()
        expected = (evaluate(**at[0]) - evaluate(**at[1])) / 2e-6
        np.testing.assert_allclose(slope, expected, rtol=0, atol=1e-7 * np.abs(expected).max())


@pytest.mark.parametrize("what", ["M"])
def test_every_constant_has_a_unit_and_a_meaning_in_the_text_as_well(what: str) -> None:
    formulas = ss.symbolic(dasgupta(), what)
    text = formulas.latex()
    for symbol in formulas.constants:
        name = re.sub(r"_[1-6]$", "", symbol.name)
        owner = next(each for each in (name, name.rpartition("_")[0]) if each in formulas.meanings)
        unit, meaning = formulas.meanings[owner]
        assert unit
        assert meaning
    assert formulas.meanings["J2_xz"] == ("kg m^2", "2 J_xz")
    assert "plus the masses m_u" in formulas.meanings["M_P"][1]
    assert r"$J_{2,xz}$ & kg\,m$^{2}$ & 2 $J_{xz}$ \\" in text
    # What stands in a pair of \left( and \right) cannot be broken at the end of a line.
    assert r"\left(" not in text.partition(r"\[")[0]
    assert text.count("$") % 2 == 0


@pytest.mark.parametrize(
    ("what", "line"), [("N", r'quantity: expected "F", .* or "alpha", got \'N\''), (3, "quantity: expected")]
)
def test_a_name_without_formulas_is_one_line(what: Any, line: str) -> None:
    rejects(f"^{line}", ss.symbolic, dasgupta(), what)


@pytest.mark.parametrize(
    ("wrong", "line"),
    [
        ({"t": np.zeros((2, 3))}, r"t of one pose: expected shape \(3,\), got \(2, 3\)"),
        ({"R": "a"}, "R of one pose: expected"),
        ({"t": [0.1, 0.0, np.nan]}, "t of one pose: expected finite"),
    ],
)
def test_arguments_that_do_not_fit_are_one_line(wrong: dict[str, Any], line: str) -> None:
    evaluate = ss.symbolic(dasgupta(), "H").function()
    rejects(f"^{line}", evaluate, **{"R": np.eye(3), "t": [0.1, 0.0, 0.5]} | wrong)
