"""The bound of the forces' rounding error: never below the true error, seldom far above; and its condition.

Truth is the derived equations with 50 digits.
"""

import ctypes
import re
from typing import Any, NamedTuple

import numpy as np
import pytest
from command_line import rejects
from drawn_poses import LEAST, PATH, drawn
from fifty_digits import errors as errors_of
from machines import dasgupta, machine_in_motion, random_motion, random_robot
from near_singular import DTYPE, PRECISIONS, case, wild
from numpy.typing import NDArray
from sweeps import share, sweep
from unsolvable_poses import singular

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION
from stewart_sym.calls import c_kernel, threads
from stewart_sym.calls.c_kernel import address, c_sources, function, prepared_model
from stewart_sym.results import BAD_ARGUMENT, JOINT_SINGULAR, OK, SINGULAR

FAR = 1000.0
"""How far above the true error a bound may lie in 95 % of cases."""
UNITS = 100.0
"""Units in the last place, times the condition number of H, that forces may err."""


class Figures(NamedTuple):
    """Smallest bound over error of a force, largest bound over largest error, and error in UNITS."""

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
        least = float((bound / errors).min())
    return Figures(least, float(bound.max() / errors.max()), float(errors.max() / unit / condition))


@pytest.mark.slow
@sweep
@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_is_never_below_the_true_error_and_seldom_far_above(precision: str) -> None:
    rng, cases = np.random.default_rng(5), share(10_000, 160)
    every = [figures(*case(rng, number), precision) for number in range(cases)]
    found = [each for each in every if each is not None]
    assert len(found) > 0.99 * cases
    assert min(f.least for f in found) >= 1.0
    assert np.mean([f.pose <= FAR for f in found]) >= 0.95
    assert max(f.units for f in found) <= UNITS


@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_of_any_shape_are_those_of_the_prepared_kernel_to_the_last_bit(precision: Any) -> None:
    rng = np.random.default_rng(0)
    for robot in (dasgupta(), random_robot(rng, friction=False)):
        for load in (True, False):
            motion = random_motion(rng, robot, (2, 3), load)
            found = ss.force_error_bounds(robot, motion, precision)
            wanted = ss.ForceKernel(robot, precision=precision).forces(motion)
            assert found.F.dtype == found.bound.dtype == found.rcond.dtype == wanted.dtype
            np.testing.assert_array_equal(found.F, wanted)
            assert found.rcond.shape == found.status.shape == (2, 3)
            one = ss.force_error_bounds(robot, motion[1, 2], precision)
            np.testing.assert_array_equal(one.bound, found.bound[1, 2])
    assert ss.force_error_bounds(robot, motion[:0]).bound.shape == (0, 3, 6)


def test_parts_of_a_batch_change_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, motion = machine_in_motion(12, (4, 5))
    whole = ss.force_error_bounds(robot, motion, "float")
    monkeypatch.setattr(threads, "LARGEST_PART", threads.LANES)
    found = ss.force_error_bounds(robot, motion, "float")
    for name, values in vars(whole).items():
        np.testing.assert_array_equal(getattr(found, name), values)


@pytest.mark.full
@pytest.mark.slow
def test_bound_holds_where_products_are_fused_into_sums(monkeypatch: pytest.MonkeyPatch) -> None:
    """In float, whose bounds round as coarsely as the forces."""
    flags = ("-O1", "-ffp-contract=fast")
    fused = native.load("fused", c_sources("exact_bounds"), [*flags, "-DSTEWART_FLOAT"])
    monkeypatch.setattr(
        c_kernel, "function", lambda name, suffix, *_: getattr(fused, f"stewart_{name}_{suffix}")
    )
    rng = np.random.default_rng(1)
    for number in range(12):
        found = figures(*case(rng, number), "float")
        assert found.least >= 1.0


@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_holds_for_wild_rates_and_loads_and_legs_near_their_axes(precision: Any) -> None:
    rng = np.random.default_rng(11)
    for number in range(25):
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
    robot, at = singular()
    theta = np.outer(np.pi / 2 - np.array([1e-2, 1e-4, 1e-6]), [0.0, 0.0, 1.0])
    motion = ss.Motion.from_rpy(at.t, theta, *np.zeros((4, 3)))
    coarse = ss.force_error_bounds(robot, motion, "float", on_singular="nan")
    assert np.isfinite(coarse.bound[0]).all()
    assert not np.isfinite(coarse.bound[2]).any()
    assert np.isfinite(ss.force_error_bounds(robot, motion).bound).all()


@pytest.mark.parametrize("precision", PRECISIONS)
def test_rcond_is_that_of_the_wrench_matrix_about_the_reference_point(precision: Any) -> None:
    rng = np.random.default_rng(4)
    for number in range(20):
        robot, motion = case(rng, number)
        scale = np.array([1.0, 1.0, 1.0, *[ss.characteristic_length(robot)] * 3])[:, None]
        wanted = 1 / np.linalg.cond(ss.wrench_matrix(robot, motion) / scale, 1)
        found = float(ss.force_error_bounds(robot, motion, precision).rcond)
        assert found == pytest.approx(wanted, rel=100 * np.finfo(DTYPE[precision]).eps / wanted)


def test_poses_without_an_answer_raise_or_are_nan() -> None:
    robot, bad = singular()
    rejects(re.escape("motion: H is singular"), ss.force_error_bounds, robot, bad)
    found = ss.force_error_bounds(robot, bad, on_singular="nan")
    assert found.status == SINGULAR
    assert np.isnan([*found.F, *found.bound, found.rcond]).all()


def test_c_takes_one_pose_and_outputs_that_nobody_wants() -> None:
    robot, motion = machine_in_motion(10)
    wanted = ss.force_error_bounds(robot, motion)
    prepare = function("exact", "bounds_prepare", "_bounds")
    model = prepared_model(prepare, robot, "exact_bounds", "double")
    call = function("exact", "forces_bounded", "_bounds")
    numbers = np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION])
    F, bound, rcond = np.zeros(6), np.zeros(6), np.zeros(1)
    null = ctypes.c_void_p(None)
    assert call(address(model), address(numbers), address(F), address(bound), address(rcond)) == OK
    np.testing.assert_array_equal(F, wanted.F)
    np.testing.assert_array_equal(bound, wanted.bound)
    assert rcond[0] == wanted.rcond
    assert call(address(model), address(numbers), address(F), null, null) == OK
    assert call(null, address(numbers), address(F), null, null) == BAD_ARGUMENT
    numbers[0] = np.nan
    assert call(address(model), address(numbers), address(F), address(bound), null) != OK
    np.testing.assert_array_equal(bound, wanted.bound)


@pytest.mark.slow
@sweep
@pytest.mark.parametrize("precision", PRECISIONS)
def test_forces_are_those_of_the_kernel_and_within_their_bound(precision: Any) -> None:
    rng = np.random.default_rng(12)
    seen = {"near": 0, "far": 0, "singular": 0}
    for _ in range(share(10_000, 200)):
        robot, motion, sine = drawn(rng, precision)
        found = ss.force_error_bounds(robot, motion, precision, on_singular="nan")
        kernel = ss.ForceKernel(robot, precision=precision)
        assert found.status == kernel.forces_and_status(motion)[1]
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
    assert min(seen.values()) > 0
