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
    BLOCK_H,
    NEAR_JOINT,
    PRECISIONS,
    WITHIN,
    _given,
    _size_and_mass,
    block_error,
    case,
    differentiated,
    fifty_digits,
    joined,
    machines_of,
    numpy_outputs,
    wider,
)
from sweeps import FULL, share
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import c_sources
from stewart_sym.derive.kernel.tree.constants import constants
from stewart_sym.dynamics import forces as force_kernels
from stewart_sym.precision.truth import digits
from stewart_sym.results import OK
from stewart_sym.studies.robustness.sweep import oracle
from stewart_sym.studies.robustness.sweep.machines import LEGS, random_motion
from stewart_sym.studies.robustness.sweep.singular_machines import FAMILIES, singular_machine
from stewart_sym.studies.robustness.sweep.sweep import GOOD, condition_of, random_machines
from stewart_sym.studies.robustness.sweep.sweep import sweep as random_sweep

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("sweep_library")]

FAR = "far reference point"
UNLIKE = ("proportions", FAR)
"""Kinds whose moments count over a length."""
KINDS = (*NEAR_JOINT, *UNLIKE)
MACHINES = 2 * len(LEGS)
"""Of all kinds of legs, of one meter and of any size."""
FAR_WITHIN = 100.0

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


def test_no_kernel_of_the_sweep_answers_for_a_singular_machine() -> None:
    """Every kernel, both precisions."""
    found = random_sweep(share(100_000, 80), seed=23, kinds=(oracle.MACHINE,))
    counts = found.figures["counts"]
    assert {count["kernel"] for count in counts} == {*oracle.KERNELS, "joint inertia", "derivatives"}
    assert [count for count in counts if count["answered"]] == []


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


# --- good poses ---------------------------------------------------------------------------------


def test_good_poses_are_answered() -> None:
    """Statuses by kernel and precision on poses up to the condition number where they must have an answer."""
    cases = share(1_000_000, 1_000)
    each = min(500, cases // 20)
    numbers, sizes = random_machines(np.random.default_rng(25), -(-cases // each), False)
    found: dict[tuple[str, str], int] = {}
    for precision in PRECISIONS:
        forces = oracle.check_random("singular", numbers, sizes, each, 26, precision, samples=0)
        good = np.maximum(condition_of(forces), forces["frames"]) < GOOD[precision]
        good &= (forces["made"] == 1) & (forces["truth"] == OK)
        assert good.sum() > 0.25 * cases
        closed = oracle.closed_form_errors(
            "singular", numbers, sizes, max(1, each // 20), 26, precision, 0, ("joint_inertia", "derivatives")
        )
        fine = np.maximum(closed["scaled"], closed["frames"]) < GOOD[precision]
        for column, name in enumerate(oracle.KERNELS):
            found[name, precision] = int(np.sum(good & (forces["status"][:, column] != OK)))
        for column in (3, 4):
            of_kernel = fine & (closed["made"] == 1) & (closed["truth"][:, column] == OK)
            status = closed["status"][:, column]
            found[oracle.CLOSED_KERNELS[column], precision] = int(np.sum(of_kernel & (status != OK)))
    assert {name: count for name, count in found.items() if count} == {}


def test_random_changes_of_the_inputs_do_not_understate_a_condition_number() -> None:
    """An error that is within the limit by the changes of every input is, whichever changes are drawn."""
    rng = np.random.default_rng([11, oracle.KINDS.index(FAR)])
    numbers, sizes = random_machines(rng, 3, False)
    mine, motion = oracle.random_case(FAR, numbers, sizes, 60, 11, 131)
    column = oracle.CLOSED_KERNELS.index("joint_inertia")

    def error(seed: int, samples: int) -> float:
        found = oracle.closed_form_errors(
            FAR, mine[None], sizes[2:], 1, seed, "double", samples, ("joint_inertia",), motions=motion[None]
        )
        return float(found["error"][0, column])

    assert 0.0 < error(0, -1) <= WITHIN
    assert max(error(seed, oracle.SAMPLES) for seed in range(24)) <= WITHIN


@pytest.mark.parametrize("backend", ["numpy", "reference"])
def test_other_backends_answer_the_good_poses_too(backend: Any) -> None:
    numbers, sizes, robots = machines_of(27, 12)
    each = share(40, 8)
    found = oracle.check_random("singular", numbers, sizes, each, 28, samples=0)
    good = np.maximum(condition_of(found), found["frames"]) < GOOD["double"]
    for index in np.flatnonzero(good & (found["made"] == 1)):
        robot, motion = case("singular", numbers, sizes, robots, each, 28, int(index))
        status = ss.inverse_dynamics(robot, motion, backend=backend, on_singular="nan").status
        assert status == OK, (index, condition_of(found)[index])


# --- near joint singularities, and out of proportion ----------------------------------------------


@pytest.mark.parametrize("precision", PRECISIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_kernel_is_as_good_as_its_problem_allows(kind: str, precision: str) -> None:
    assert beyond(kind, precision, share(4_000, 250)) == []


def within(kind: str, kernel: str) -> float:
    """Largest error of a kernel over its condition number, rounding units.

    The inertia that actuators feel is made of M about the reference point, whose entries grow with the square
    of that point's distance.
    """
    return FAR_WITHIN if kind == FAR and kernel in ("joint_inertia", "derivatives") else WITHIN


def beyond(kind: str, precision: str, cases: int) -> list[str]:
    """Kernels that err by more than ``within``, or reject a good pose: the worst case of each in a line."""
    seed, each = 29, cases // MACHINES
    numbers, sizes = random_machines(np.random.default_rng(seed), MACHINES, False)
    forces = oracle.check_random(kind, numbers, sizes, each, seed, precision, 8, WITHIN)
    closed = oracle.closed_form_errors(
        kind, numbers, sizes, each, seed, precision, samples=8, in_quad=True, doubtful=WITHIN
    )
    good = np.maximum(closed["scaled"], closed["frames"]) < GOOD[precision]
    lines = []
    for column, kernel in enumerate((*oracle.KERNELS, *oracle.CLOSED_KERNELS)):
        of_forces = column < len(oracle.KERNELS)
        place = column if of_forces else column - len(oracle.KERNELS)
        status = (forces if of_forces else closed)["status"][:, place]
        truth = forces["truth"] if of_forces else closed["truth"][:, place]
        ratio = forces["error"][:, place] / condition_of(forces) if of_forces else closed["error"][:, place]
        ratio = np.where(status == OK, np.where(ratio >= 0.0, ratio, np.inf), 0.0)
        rejected = (closed["made"] == 1) & (status != OK) & (truth == OK) & good
        worst = int(np.argmax(ratio))
        block = "" if of_forces else f" ({list(oracle.BLOCKS)[closed['block'][worst, place]]})"
        limit = within(kind, kernel)
        if ratio[worst] > limit:
            lines.append(
                f"{kernel}{block}: {int(np.sum(ratio > limit))} of {len(ratio)} beyond, worst "
                f"{ratio[worst]:.3g} at distance {closed['distance'][worst]:.2g}, case {worst}"
            )
        if rejected.any():
            lines.append(
                f"{kernel}: {rejected.sum()} good poses rejected, first {np.flatnonzero(rejected)[0]}"
            )
    return lines


@pytest.mark.parametrize("kind", KINDS)
def test_numpy_is_as_good_as_its_problem_allows(kind: str) -> None:
    numbers, sizes, robots = machines_of(31, 6 if FULL else 2)
    worst: dict[str, float] = {}
    limits = {name: within(kind, oracle.CLOSED_KERNELS[part[0]]) for name, part in oracle.BLOCKS.items()}
    each = 4 if FULL else 1
    for index in range(len(robots) * each):
        robot, motion = case(kind, numbers, sizes, robots, each, 32, index)
        F = robot.M * 9.81 * np.random.default_rng(index).normal(size=6)
        high, low, change, status = wider(robot, motion, F)
        length = ss.characteristic_length(robot)
        scaled = ss.scaled_condition_number(high[BLOCK_H].reshape(6, 6), length) if kind in UNLIKE else 1.0
        flat, codes = numpy_outputs(robot, motion, F)
        for name, part in oracle.BLOCKS.items():
            kernel = part[0]
            if codes[kernel] == OK and status[kernel] == OK:
                error = block_error(part, length, scaled, flat, high, low, change)
                if error > limits[name]:
                    change = wider(robot, motion, F, samples=-1)[2]
                    error = block_error(part, length, scaled, flat, high, low, change)
                worst[name] = max(worst.get(name, 0.0), error)
    assert worst.keys() == oracle.BLOCKS.keys()
    assert {name: ratio for name, ratio in worst.items() if ratio > limits[name]} == {}


# --- the truth itself -----------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
def test_wider_arithmetic_agrees_with_fifty_digits_of_the_derived_equations(kind: str) -> None:
    numbers, sizes, robots = machines_of(33, 3)
    for index in range(3):
        robot, motion = case(kind, numbers, sizes, robots, 1, 34, index)
        # Exact numbers: the derived equations take k for a unit vector and R for a rotation, which a heavy
        # leg feels.
        motion = dataclasses.replace(motion, R=np.eye(3)) if kind == "heavy leg" else motion
        robot = dataclasses.replace(robot, k=np.eye(3)[[0, 1, 1, 0, 0, 1]]) if kind in UNLIKE else robot
        F = robot.M * 9.81 * np.random.default_rng(index).normal(size=6)
        high, low, change, status = wider(robot, motion, F)
        if status.any():
            continue
        for name, truth in fifty_digits(robot, motion, F).items():
            part = oracle.BLOCKS[name]
            error = block_error(part, ss.characteristic_length(robot), 1.0, truth, high, low, change)
            # In units of 2e-16, and R and k are what they should be to such a unit.
            assert error < 2.0, (name, index)


@pytest.mark.parametrize("kind", KINDS)
def test_wider_arithmetic_agrees_with_differences_of_the_derived_equations(kind: str) -> None:
    numbers, sizes, robots = machines_of(35, 3)
    answered = 0
    for index in range(3 if FULL else 1):
        robot, motion = case(kind, numbers, sizes, robots, 1, 36, index)
        F = robot.M * 9.81 * np.random.default_rng(index).normal(size=6)
        high, low, change, status = wider(robot, motion, F)
        if status.any():
            continue
        answered += 1
        # M cancels to the square of the sine, and differences need digits of their own.
        with digits.workdps(150):
            slopes = differentiated(robot, motion, F)
        for name, truth in slopes.items():
            part = oracle.BLOCKS[name]
            error = block_error(part, ss.characteristic_length(robot), 1.0, truth, high, low, change)
            assert error < 2.0, (name, index)
    assert answered
