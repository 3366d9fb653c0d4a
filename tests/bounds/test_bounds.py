"""The bound of the forces' rounding error: never below the true error, seldom far above; and its condition.

Truth is the derived equations with 50 digits.
"""

import ctypes
import functools
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from drawn_poses import LEAST, PATH, drawn
from fifty_digits import errors as errors_of
from machines import dasgupta, machine_in_motion, random_motion, random_robot
from near_singular import DTYPE, PRECISIONS, case, wild
from numpy.typing import NDArray
from sweeps import share
from unsolvable_poses import singular

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.c_kernel import address, c_sources, library, prepared_model
from stewart_sym.backend.kernel import MOTION
from stewart_sym.dynamics import force_error_bounds
from stewart_sym.generated.interface import MODELS
from stewart_sym.results import BAD_ARGUMENT, JOINT_SINGULAR, OK, SINGULAR

FAR = 1000.0
"""How far above the true error a bound may lie in 95 % of cases."""
UNITS = 100.0
"""Units in the last place, times the condition number of H, that forces may err."""


# ---------------------------------------------------------------- cases


@dataclass(frozen=True)
class Figures:
    """What one case says of one precision.

    least: smallest bound over true error of the six forces. pose: largest bound over largest error. units:
    largest error in units in the last place of the largest force, over the scaled condition number.
    """

    least: float
    pose: float
    units: float


def figures(robot: ss.Robot, motion: ss.Motion, precision: str) -> Figures | None:
    """None where H is singular to the rounding of float."""
    on_singular = "nan" if precision == "float" else "raise"
    found = ss.force_error_bounds(robot, motion, precision, on_singular)
    if found.status == SINGULAR:
        return None
    errors = np.abs(errors_of(found.F, robot, motion, DTYPE[precision]))
    bound = found.bound.astype(np.float64)
    condition = ss.scaled_condition_number(ss.wrench_matrix(robot, motion), ss.characteristic_length(robot))
    unit = float(np.spacing(np.abs(found.F).max()))
    with np.errstate(divide="ignore"):
        ratios = bound / errors
    return Figures(
        float(ratios.min()), float(bound.max() / errors.max()), float(errors.max() / unit / condition)
    )


@functools.cache
def swept(cases: int) -> dict[str, list[Figures]]:
    rng = np.random.default_rng(5)
    drawn = [case(rng, number) for number in range(cases)]
    found = {p: [figures(robot, motion, p) for robot, motion in drawn] for p in PRECISIONS}
    solved = {p: [each for each in all_of_them if each is not None] for p, all_of_them in found.items()}
    assert len(solved["float"]) > 0.99 * cases
    return solved


def holds(found: list[Figures]) -> None:
    assert min(f.least for f in found) >= 1.0
    assert np.mean([f.pose <= FAR for f in found]) >= 0.95
    assert max(f.units for f in found) <= UNITS


# ---------------------------------------------------------------- the bound


@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_is_never_below_the_true_error_and_seldom_far_above(precision: str) -> None:
    holds(swept(60)[precision])


@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_holds_over_ten_thousand_cases(precision: str) -> None:
    holds(swept(share(10_000))[precision])


@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_prepared_kernel_to_the_last_bit(precision: Any) -> None:
    rng = np.random.default_rng(0)
    for robot in (dasgupta(), random_robot(rng), random_robot(rng, friction=False)):
        for load in (True, False):
            motion = random_motion(rng, robot, (3, 7), load)
            found = ss.force_error_bounds(robot, motion, precision)
            wanted = ss.ForceKernel(robot, precision=precision).forces(motion)
            assert found.F.dtype == found.bound.dtype == found.rcond.dtype == wanted.dtype
            np.testing.assert_array_equal(found.F, wanted)


@pytest.mark.slow
def test_bound_holds_where_products_are_fused_into_sums(monkeypatch: pytest.MonkeyPatch) -> None:
    """In float, whose bounds round as coarsely as the forces."""
    flags = ("-O1", "-ffp-contract=fast")
    fused = native.load("fused", c_sources("exact_bounds"), flags, {"STEWART_FLOAT": 1})
    monkeypatch.setattr(
        force_error_bounds, "function", lambda *names: getattr(fused, f"stewart_{names[0]}_{names[-1]}")
    )
    rng = np.random.default_rng(1)
    for number in range(20):
        found = figures(*case(rng, number), "float")
        assert found.least >= 1.0


@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_holds_for_wild_rates_and_loads_and_legs_near_their_axes(precision: Any) -> None:
    rng = np.random.default_rng(11)
    for number in range(40):
        robot, motion = wild(rng, *case(rng, number))
        found = ss.force_error_bounds(robot, motion, precision, on_singular="nan")
        if found.status == OK:
            errors = np.abs(errors_of(found.F, robot, motion, DTYPE[precision]))
            assert (errors <= found.bound).all()


def test_bound_counts_how_far_R_is_from_a_rotation() -> None:
    rng = np.random.default_rng(2)
    robot, motion = machine_in_motion(rng)
    off = ss.Motion(
        R=motion.R + 1e-10 * rng.uniform(-1, 1, (3, 3)),
        **{name: getattr(motion, name) for name in ("t", "omega", "v", "alpha", "a", "F_ext", "M_ext")},
    )
    near, far = (ss.force_error_bounds(robot, m) for m in (motion, off))
    errors = np.abs(errors_of(far.F, robot, off))
    assert (errors <= far.bound).all()
    assert errors.max() > 100 * near.bound.max()
    assert far.bound.max() < FAR * errors.max()


def test_bound_is_infinite_where_float_is_too_coarse_for_any() -> None:
    """Toward a singular pose the bound grows until there is none: sooner in float than in double."""
    robot, at = singular()
    away = np.array([1e-2, 1e-4, 1e-6])
    theta = np.outer(np.pi / 2 - away, [0.0, 0.0, 1.0])
    zero = np.zeros(3)
    motion = ss.Motion.from_rpy(at.t, theta, zero, zero, zero, zero)
    coarse = ss.force_error_bounds(robot, motion, "float", on_singular="nan")
    fine = ss.force_error_bounds(robot, motion)
    assert (coarse.status[:2] == OK).all()
    assert np.isfinite(coarse.bound[0]).all()
    assert not np.isfinite(coarse.bound[2]).any()
    assert np.isfinite(fine.bound).all()
    assert (np.diff(fine.bound.max(axis=-1)) > 0).all()
    assert (np.diff(fine.rcond) < 0).all()


# ---------------------------------------------------------------- condition and statuses


@pytest.mark.parametrize("precision", PRECISIONS)
def test_rcond_is_that_of_the_wrench_matrix_about_the_reference_point(precision: Any) -> None:
    rng = np.random.default_rng(4)
    for number in range(20):
        robot, motion = case(rng, number)
        scale = np.array([1.0, 1.0, 1.0, *[ss.characteristic_length(robot)] * 3])[:, None]
        wanted = 1 / np.linalg.cond(ss.wrench_matrix(robot, motion) / scale, 1)
        found = float(ss.force_error_bounds(robot, motion, precision).rcond)
        assert found == pytest.approx(wanted, rel=100 * np.finfo(DTYPE[precision]).eps / wanted)


def test_any_leading_shape_with_and_without_load() -> None:
    rng = np.random.default_rng(6)
    robot = random_robot(rng)
    for load in (True, False):
        motion = random_motion(rng, robot, (2, 3), load)
        found = ss.force_error_bounds(robot, motion)
        assert (found.F.shape, found.bound.shape) == ((2, 3, 6), (2, 3, 6))
        assert (found.rcond.shape, found.status.shape) == ((2, 3), (2, 3))
        one = ss.force_error_bounds(robot, motion[1, 2])
        np.testing.assert_array_equal(one.bound, found.bound[1, 2])
    none = ss.force_error_bounds(robot, motion[:0])
    assert none.bound.shape == (0, 3, 6)


def test_poses_without_an_answer_raise_warn_or_are_nan() -> None:
    robot, bad = singular()
    rejects(re.escape("motion: H is singular"), ss.force_error_bounds, robot, bad)
    with pytest.warns(ss.SingularPoseWarning, match="H is singular") as caught:
        ss.force_error_bounds(robot, bad, on_singular="warn")
    assert caught[0].filename == __file__
    found = ss.force_error_bounds(robot, bad, on_singular="nan")
    assert found.status == SINGULAR
    for values in (found.F, found.bound, found.rcond):
        assert np.isnan(values).all()


def test_robots_that_float_cannot_hold_are_rejected() -> None:
    rng = np.random.default_rng(9)
    robot = random_robot(rng, scale=1e20)
    with pytest.raises(ValueError, match=r"robot: .* range of float; use"):
        ss.force_error_bounds(robot, random_motion(rng, robot), "float")


def test_c_takes_one_pose_and_outputs_that_nobody_wants() -> None:
    robot, motion = machine_in_motion(10)
    wanted = ss.force_error_bounds(robot, motion)
    prepare = force_error_bounds.function("exact", "bounds", "double", "bounds_prepare")
    model = prepared_model(prepare, robot, MODELS["exact_bounds"], "double")
    call = library("exact_bounds").stewart_exact_forces_bounded
    numbers = np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION])
    F, bound, rcond = np.zeros(6), np.zeros(6), np.zeros(1)
    null = ctypes.c_void_p(None)
    assert call(address(model), address(numbers), address(F), address(bound), address(rcond)) == OK
    np.testing.assert_array_equal(F, wanted.F)
    np.testing.assert_array_equal(bound, wanted.bound)
    assert rcond[0] == wanted.rcond
    F[:] = 0
    assert call(address(model), address(numbers), address(F), null, null) == OK
    np.testing.assert_array_equal(F, wanted.F)
    assert call(null, address(numbers), address(F), null, null) == BAD_ARGUMENT
    numbers[0] = np.nan
    bound[:] = 7.0
    assert call(address(model), address(numbers), address(F), address(bound), null) != OK
    assert (bound == 7.0).all()


# ---------------------------------------------------------------- near joint singularities


def swept_near_joint(precision: Any, cases: int) -> dict[str, int]:
    """How many cases were solved on either path and not; every one is compared."""
    rng = np.random.default_rng(12)
    seen = {"near": 0, "far": 0, "singular": 0}
    for _ in range(cases):
        robot, motion, sine = drawn(rng, precision)
        found = ss.force_error_bounds(robot, motion, precision, on_singular="nan")
        kernel = ss.ForceKernel(robot, precision=precision)
        assert found.status == kernel.status(motion)
        if found.status != OK:
            assert found.status == JOINT_SINGULAR
            assert sine < 2 * LEAST * np.finfo(DTYPE[precision]).eps
            seen["singular"] += 1
            continue
        seen["near" if sine < PATH else "far"] += 1
        np.testing.assert_array_equal(found.F, kernel.forces(motion))
        errors: NDArray[np.float64] = np.abs(errors_of(found.F, robot, motion, DTYPE[precision]))
        assert (errors <= found.bound).all()
        assert np.isfinite(found.bound).all() or sine < 1e3 * LEAST * np.finfo(DTYPE[precision]).eps
    return seen


@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_kernel_and_within_their_bound(precision: str) -> None:
    assert min(swept_near_joint(precision, 60).values()) > 0


@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_kernel_and_within_their_bound_over_ten_thousand(precision: str) -> None:
    swept_near_joint(precision, share(10_000, 50))
