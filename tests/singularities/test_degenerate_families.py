"""Singular machines are rejected, good poses are not; near joint singularities and out of proportion answers
lose no more than the problem itself does: every kernel, by wider arithmetic.
"""

import dataclasses
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scalar_kernels import prepared
from sweep_machines import (
    PRECISIONS,
    _given,
    _size_and_mass,
    joined,
)
from sweeps import share
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import c_sources
from stewart_sym.derive.kernel.tree.constants import constants
from stewart_sym.dynamics import forces as force_kernels
from stewart_sym.results import OK
from stewart_sym.studies.robustness.sweep.machines import LEGS, random_motion
from stewart_sym.studies.robustness.sweep.singular_machines import FAMILIES, singular_machine

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]


# --- machines that are singular at every pose -----------------------------------------------------


def exact_determinant(robot: ss.Robot, R: NDArray[np.float64], t: NDArray[np.float64]) -> Any:
    """det of the six [S; q x S] of the stored numbers, in rational arithmetic: 0 where det H is."""
    R_, t_, b, p = (np.vectorize(Fraction, otypes=[object])(each) for each in (R, t, robot.b, robot.p))
    q = p @ R_.T
    S = q + t_ - b
    moments = [q[:, i - 2] * S[:, i - 1] - q[:, i - 1] * S[:, i - 2] for i in range(3)]
    return DomainMatrix(np.column_stack([S, *moments]).tolist(), (6, 6), QQ).det()


@pytest.mark.parametrize("family", FAMILIES)
def test_every_pose_of_a_family_is_singular_in_rational_arithmetic(family: str) -> None:
    rng = np.random.default_rng(21)
    for size in (1.0, 0.03, 200.0):
        robot = singular_machine(rng, family, size)
        for points in (robot.b, robot.p):
            assert (points.astype(np.float32) == points).all()
        motion = random_motion(rng, robot)
        # Whatever the orientation, and were it no rotation to the last bit.
        for R in (np.eye(3), motion.R, motion.R + 1e-3 * rng.normal(size=(3, 3))):
            assert exact_determinant(robot, R, motion.t) == 0


def test_a_machine_off_its_family_is_not_singular() -> None:
    rng = np.random.default_rng(22)
    for family in FAMILIES:
        robot = singular_machine(rng, family)
        b, p = (points + 1e-12 * rng.normal(size=(6, 3)) for points in (robot.b, robot.p))
        beside = dataclasses.replace(robot, b=b, p=p)
        motion = random_motion(rng, robot)
        assert exact_determinant(beside, motion.R, motion.t) != 0


@pytest.mark.parametrize("family", FAMILIES)
def test_no_backend_answers_for_a_singular_machine(family: str) -> None:
    assert backends_that_answer(family, share(20), share(240)) == {}


@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_quarter_of_the_limit_of_a_small_pivot_would_find_singular_machines(
    precision: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert answered_with_limit(monkeypatch, precision, 0.25, machines=share(60, 60)) == 0
    assert answered_with_limit(monkeypatch, precision, 0.0, machines=1) > 0


def answered_with_limit(
    monkeypatch: pytest.MonkeyPatch, precision: str, factor: float, machines: int, poses: int = 20
) -> int:
    """Poses of so many machines of each family that the force kernel answers with another pivot limit."""
    defines: dict[str, str | int] = {
        "STEWART_SUSPECT": f"((stewart_real){factor * constants(precision)['SUSPECT']!r})"
    }
    if precision == "float":
        defines["STEWART_FLOAT"] = 1

    def function(name: str, part: str, _: str, what: str) -> Any:
        library = native.load(f"stewart_{name}_limit", c_sources(f"{name}_{part}"), ["-O0"], defines)
        return getattr(library, f"stewart_{name}_{what}")

    monkeypatch.setattr(force_kernels, "function", function)
    rng = np.random.default_rng(41)
    answered = 0
    for number in range(machines):
        for family in FAMILIES:
            robot = singular_machine(rng, family, *_size_and_mass(rng, number), LEGS[number % len(LEGS)])
            motion = joined([random_motion(rng, robot) for _ in range(poses)])
            status = ss.ForceKernel(robot, "exact", precision).forces_and_status(motion)[1]
            answered += int(np.sum(status == OK))
    return answered


def backends_that_answer(family: str, machines: int, poses: int) -> dict[str, int]:
    """Answers with status ok by kernel and backend; none is right."""
    rng = np.random.default_rng(24)
    found: dict[str, int] = {}
    for number in range(machines):
        robot = singular_machine(rng, family, *_size_and_mass(rng, number), legs=LEGS[number % len(LEGS)])
        motion = joined([random_motion(rng, robot) for _ in range(poses)])
        for name, status in statuses(robot, motion):
            found[name] = found.get(name, 0) + int(np.sum(status == OK))
    return {name: count for name, count in found.items() if count}


def statuses(robot: ss.Robot, motion: ss.Motion) -> list[tuple[str, NDArray[Any]]]:
    """Every way to what solves with H, and its statuses."""
    found = []
    quiet: Any = {"on_singular": "nan"}
    for backend in ("c", "numpy", "reference"):
        for formulation in ("exact", "paper"):
            call: Any = {"formulation": formulation, "backend": backend, **quiet}
            name = f"{backend}, {formulation}"
            found.append((f"inverse_dynamics, {name}", ss.inverse_dynamics(robot, motion, **call).status))
            found.append((f"joint_reactions, {name}", ss.joint_reactions(robot, motion, **call).status))
        inertia = ss.joint_space_inertia(robot, motion, backend=backend, **quiet)
        found.append((f"joint_space_inertia, {backend}", _given(inertia)))
    for backend in ("c", "numpy"):
        derivatives = ss.force_derivatives(robot, motion, backend=backend, **quiet)
        found.append((f"force_derivatives, {backend}", derivatives.status))
    for precision in PRECISIONS:
        for formulation in ("exact", "paper"):
            kernel = ss.ForceKernel(robot, formulation, precision)
            found.append((f"forces, {precision}, {formulation}", kernel.forces_and_status(motion)[1]))
        bounds = ss.force_error_bounds(robot, motion, precision, on_singular="nan")
        found.append((f"force_error_bounds, {precision}", bounds.status))
        found.append(
            (f"scalar, {precision}", prepared(robot, precision=precision).forces_and_status(motion)[1])
        )
    return found
