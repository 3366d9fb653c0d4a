"""Singular machines are rejected, good poses are not; near joint singularities and out of proportion answers
lose no more than the problem itself does: every kernel, by wider arithmetic.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scalar_kernels import prepared
from sweep_machines import (
    NEAR_JOINT,
    PRECISIONS,
    WITHIN,
    case,
    cases_near,
    differentiated,
    fifty_digits,
    given,
    joined,
    numpy_outputs,
    rounded,
    size_and_mass,
)
from sweeps import FULL, share
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

import stewart_sym as ss
from stewart_sym.precision.exact_forces import digits
from stewart_sym.results import OK
from stewart_sym.studies.robustness import study
from stewart_sym.studies.robustness.failures import FAR, MACHINE, UNLIKE, random_cases
from stewart_sym.studies.robustness.machines import LEGS, random_motion
from stewart_sym.studies.robustness.oracle import BLOCKS, CLOSED, FORCES, Cases, Truth, check, judge, truth_of
from stewart_sym.studies.robustness.singular_machines import FAMILIES, singular_machine

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]

KINDS = (*NEAR_JOINT, *UNLIKE)
MACHINES = 2 * len(LEGS)
"""Number of machines, of all kinds of legs, of one meter and of any size."""
FAR_WITHIN = 100.0
FORCES_WITHIN = 20.0
"""Limit of the forces, whose condition number counts changes of each number by itself."""

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


def test_no_kernel_of_the_sweep_answers_for_a_singular_machine() -> None:
    """Every kernel, both precisions."""
    counts = study.sweep(share(100_000, 80), seed=23, kinds=(MACHINE,))["counts"]
    kernels = {"one pose", "batch", "every output", "joint inertia", "derivatives"}
    assert {count["kernel"] for count in counts} == kernels
    assert [count for count in counts if count["answered"]] == []


@pytest.mark.parametrize("family", FAMILIES)
def test_no_backend_answers_for_a_singular_machine(family: str) -> None:
    assert backends_that_answer(family, share(20), share(240)) == {}


def backends_that_answer(family: str, machines: int, poses: int) -> dict[str, int]:
    """Answers with status ok by kernel and backend; none is right."""
    rng = np.random.default_rng(24)
    found: dict[str, int] = {}
    for number in range(machines):
        robot = singular_machine(rng, family, *size_and_mass(rng, number), legs=LEGS[number % len(LEGS)])
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
        found.append((f"joint_space_inertia, {backend}", given(inertia)))
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


# --- good poses ---------------------------------------------------------------------------------


# --- near joint singularities, and out of proportion ----------------------------------------------


def within(kind: str, kernel: str) -> float:
    """Largest error of a kernel over its condition number, rounding units.

    The inertia that actuators feel is made of M about the reference point, whose entries grow with the square
    of that point's distance.
    """
    if kernel in FORCES:
        return FORCES_WITHIN
    return FAR_WITHIN if kind == FAR and kernel in ("joint_inertia", "derivatives") else WITHIN


@pytest.mark.parametrize("precision", PRECISIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_kernel_is_as_good_as_its_problem_allows(kind: str, precision: str) -> None:
    cases = share(4_000, 250)
    decades = 16.6 if precision == "double" else 7.9
    drawn = random_cases(kind, np.random.default_rng(29), cases, cases // MACHINES, decades)
    found = check(drawn, (*FORCES, *CLOSED), precision, floor=kind in UNLIKE, samples=8)
    worst = {kernel: float(each.ratio.max()) for kernel, each in found.items()}
    assert {kernel: ratio for kernel, ratio in worst.items() if ratio > within(kind, kernel)} == {}
    assert {kernel for kernel, each in found.items() if each.rejected_good(precision).any()} == set()


@pytest.mark.parametrize("kind", KINDS)
def test_numpy_is_as_good_as_its_problem_allows(kind: str) -> None:
    cases = cases_near(kind, 32, 24 if FULL else 2)
    found = [numpy_outputs(*case(cases, index)) for index in range(len(cases.distance))]
    for kernel in CLOSED:
        values, status = (np.array([each[kernel][i] for each in found]) for i in range(2))
        truth = truth_of(cases, kernel, samples=-1)
        verdict = judge(kernel, values, status, truth, cases, floor=kind in UNLIKE)
        assert np.max(verdict.ratio) <= within(kind, kernel), kernel


# --- the truth itself -----------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
def test_wider_arithmetic_agrees_with_fifty_digits_of_the_derived_equations(kind: str) -> None:
    cases = cases_near(kind, 33, 3)
    # Exact numbers: the derived equations take k for a unit vector and R for a rotation, which a heavy
    # leg feels.
    if kind == "heavy leg":
        cases.motion["R"] = np.eye(3)
    if kind in UNLIKE:
        cases.legs["k"][:] = np.eye(3)[[0, 1, 1, 0, 0, 1]]
    agrees(cases, fifty_digits)


@pytest.mark.parametrize("kind", KINDS)
def test_wider_arithmetic_agrees_with_differences_of_the_derived_equations(kind: str) -> None:
    # M cancels to the square of the sine, and differences need digits of their own.
    with digits.workdps(150):
        agrees(cases_near(kind, 36, 3 if FULL else 1), differentiated)


def agrees(cases: Cases, exactly: Callable[..., dict[tuple[str, str], Any]]) -> None:
    """Compare the blocks of the truth with other numbers of more digits."""
    truths = {kernel: truth_of(cases, kernel, samples=8) for kernel in CLOSED}
    solved = np.flatnonzero(
        [not any(truths[kernel].status[i] for kernel in CLOSED) for i in range(len(cases.distance))]
    )
    assert solved.size
    for index in solved:
        for (kernel, block), value in exactly(*case(cases, int(index))).items():
            truth, one = truths[kernel], slice(index, index + 1)
            places = BLOCKS[kernel][block][0]
            values = truth.values[one].copy()
            values[0, places] = rounded(value)
            own = Truth(*(each[one] for each in vars(truth).values()))
            # In units of 2e-16, and R and k are what they should be to such a unit.
            assert judge(kernel, values, own.status, own, cases[one]).ratio[0] < 2.0, (block, index)
