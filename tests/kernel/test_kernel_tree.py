"""Kernels as trees: one text gives the same numbers as the C in every language, and its reader is strict.

What the reader makes of a text the committed files show, which ``derive --check`` compares.
"""

from dataclasses import replace
from fractions import Fraction
from math import isqrt
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from leaning_legs import leaning
from machines import dasgupta, machine_in_motion, random_motion, random_robot_of
from sweeps import FULL

import stewart_sym as ss
from stewart_sym.calls.numpy_kernel import loaded
from stewart_sym.derive.generated_files import reduced_fidelity, reduced_forces
from stewart_sym.derive.kernel.outputs import program
from stewart_sym.derive.mechanics import quantities as n
from stewart_sym.derive.mechanics.formulation import EXACT, EXACT_DRIVE, FORMULATIONS, PAPER
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES
from stewart_sym.derive.trace import read
from stewart_sym.derive.trace.constants import constants
from stewart_sym.derive.trace.interpret import Arithmetic, Interpreter
from stewart_sym.derive.trace.nodes import Program
from stewart_sym.formulas.trees import robot_structure
from stewart_sym.kit import Choice, write_kit

ON_ARRAYS = Arithmetic(
    np.asarray,
    {"NAN": np.nan, **constants("double")},
    np.sqrt,
    np.abs,
    lambda one, other: np.where(one > other, one, other),
    np.where,
    lambda test: bool(np.any(test)),
)


def forces_of(tree: Program, robot: ss.Robot, motion: ss.Motion) -> tuple[np.ndarray, np.ndarray]:
    run, stored = Interpreter(tree, ON_ARRAYS), loaded(motion)
    # Components first and poses last.
    at = SimpleNamespace(**{q.name: [stored[q.name][(..., *key)] for key in q.keys] for q in n.MOTION})
    with np.errstate(all="ignore"):
        found = run.run("forces", run.run("prepare", robot_structure(robot, lambda _, value: value)), at)
    return np.stack(np.broadcast_arrays(*found.F), axis=-1), np.asarray(found.status)


@pytest.mark.slow
@pytest.mark.parametrize(
    "form", FORMULATIONS if FULL else (EXACT, EXACT_DRIVE, PAPER), ids=lambda form: form.name
)
@pytest.mark.usefixtures("rounded_twice")
def test_forces_are_those_of_the_c_batch_to_the_bit(form: Any) -> None:
    tree = program(reduced_forces(form))
    rng = np.random.default_rng(5)
    for _ in range(4):
        robot = random_robot_of(rng, form)
        motion = random_motion(rng, robot, (9,))
        kernel = ss.ForceKernel(robot, form.name)
        F, status = forces_of(tree, robot, motion)
        expected, codes = kernel.forces_and_status(motion)
        np.testing.assert_array_equal(status, codes)
        np.testing.assert_array_equal(F, expected)


@pytest.mark.usefixtures("rounded_twice")
def test_near_and_at_a_joint_singularity_forces_and_statuses_are_those_of_the_c() -> None:
    tree = program(reduced_forces(EXACT))
    rng = np.random.default_rng(6)
    seen = set()
    for sine in (0.2, 0.015, 1e-4, 1e-9, 0.0):
        robot, motion = machine_in_motion(rng)
        robot = leaning(robot, motion, sine)
        F, status = forces_of(tree, robot, motion)
        expected, codes = ss.ForceKernel(robot).forces_and_status(motion)
        np.testing.assert_array_equal(status, codes)
        np.testing.assert_array_equal(F, expected)
        seen.add(int(codes))
    assert seen == {0, 3}


@pytest.mark.slow
@pytest.mark.usefixtures("rounded_twice")
def test_fidelities_have_trees_as_well() -> None:
    robot, motion = machine_in_motion(8, (5,))
    for name in ("slender_friction",) if not FULL else set(FIDELITIES) - {"general"}:
        F, status = forces_of(program(reduced_fidelity(EXACT, FIDELITIES[name])), robot, motion)
        expected, codes = ss.ForceKernel(robot, fidelity=name).forces_and_status(motion)
        np.testing.assert_array_equal(status, codes)
        np.testing.assert_array_equal(F, expected, name)


@pytest.mark.parametrize(
    ("choice", "line"),
    [
        (
            Choice(("reactions",), language="rust"),
            "functions: rust: expected some of forces, motion, derivatives, kinematics, got 'reactions'",
        ),
        (Choice(language="matlab", precision="float"), "precision: matlab: expected double, got float"),
        (Choice(language="rust", bake=True), "bake: expected language c, got rust"),
        (Choice(language="cobol"), "language: expected"),
        (
            Choice(("forces", "motion"), fidelity="slender", language="rust"),
            "fidelity: rust: expected general with the function motion, got slender",
        ),
    ],
)
def test_what_a_language_lacks_is_named(choice: Choice, line: str, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=f"^{line}"):
        write_kit(dasgupta(), tmp_path, choice)
    assert not list(tmp_path.iterdir())


def with_while(x: "array(6)") -> "Real":  # noqa: F821
    """Not allowed."""
    while x[0] > 0:
        x[0] = 0.0
    return x[0]


def with_power(x: "array(6)") -> "Real":  # noqa: F821
    """Not allowed."""
    return x[0] ** 2


def smallest_share(x: "Real", y: "Real") -> "Real":  # noqa: F821
    """A quotient where there is one."""
    root = where(y >= 0.0, sqrt(y), 0.0)  # noqa: F821
    return where(root > 0.0, x / root, least(x))  # noqa: F821


def least(x: "Real") -> "Real":  # noqa: F821
    """Another function, which can be replaced."""
    return x - 1.0


def test_where_a_test_is_decided_what_is_not_taken_may_be_undefined() -> None:
    functions = {"least": read.function(least, {}, {})}
    functions["smallest_share"] = read.function(smallest_share, {}, functions)
    tree = Program("", (), tuple(functions.values()))
    on = Arithmetic(Fraction, {}, lambda y: Fraction(isqrt(int(y))))
    assert [Interpreter(tree, on).run("smallest_share", 3, y) for y in (-1, 0, 4)] == [2, 2, Fraction(3, 2)]
    assert Interpreter(tree, on, {"least": lambda x: 10 * x}).run("smallest_share", 3, -1) == 30
    with pytest.raises(ValueError, match="nonnegative"):
        Interpreter(tree, replace(on, where=lambda test, yes, no: no)).run("smallest_share", 3, AnyTest(-1))


class AnyTest(Fraction):
    """A number of which comparisons are not decided, as those of symbols and arrays are not."""

    def __ge__(self, other: object) -> Any:
        return "undecided"


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (with_while, "expected .* got while"),
        (with_power, r"expected one of \+ - \* / & \|, got x\[0\] \*\* 2"),
    ],
)
def test_python_that_not_every_language_has_is_named(text: Any, named: str) -> None:
    with pytest.raises(ValueError, match=f"^{text.__name__}: {named}"):
        read.function(text, {}, {})
