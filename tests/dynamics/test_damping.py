"""Damped forces are finite where H is singular, say what they leave wanting, and touch no other pose."""

import dataclasses
import warnings

import numpy as np
import pytest
from machines import Array
from motion_fields import UNLOADED, stacked
from unsolvable_poses import BACKENDS, at_rest, leg_along_its_axis, singular, zero_length_leg

import stewart_sym as ss
from stewart_sym.dynamics.damped_least_squares import SHARE, damped_least_squares
from stewart_sym.results import JOINT_SINGULAR, OK, SINGULAR, ZERO_LENGTH


def together(*motions: ss.Motion) -> ss.Motion:
    return stacked(motions, UNLOADED)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_a_singular_pose_gets_forces_and_says_what_they_leave_wanting(backend, formulation) -> None:
    robot, pose = singular()
    with warnings.catch_warnings(action="error"):
        found = ss.inverse_dynamics(robot, pose, formulation, backend, on_singular="damped")
    assert found.status == SINGULAR
    np.testing.assert_allclose(found.F, found.D - found.x, rtol=1e-13)
    np.testing.assert_allclose(found.wrench_error, found.c - found.H @ found.x, atol=1e-11)
    np.testing.assert_allclose(found.H, ss.wrench_matrix(robot, pose), atol=1e-14)
    lost = ss.singularity(robot, pose)
    load = found.c @ lost.twist
    assert abs(load) > 1.0
    np.testing.assert_allclose(found.wrench_error, load * lost.wrench, atol=1e-9 * abs(load))
    assert np.abs(found.F).max() < 1e4


@pytest.mark.parametrize("backend", BACKENDS)
def test_all_other_poses_are_the_same_bits(backend) -> None:
    robot, bad = singular()
    rng = np.random.default_rng(0)
    good = [dataclasses.replace(at_rest([0.1, 0.0, z]), v=rng.normal(size=3)) for z in (0.6, 0.8, 1.1)]
    mixed = together(good[0], bad, good[1], good[2], bad)
    damped = ss.inverse_dynamics(robot, mixed, backend=backend, on_singular="damped")
    plain = ss.inverse_dynamics(robot, mixed, backend=backend, on_singular="nan")
    assert list(damped.status) == list(plain.status) == [0, SINGULAR, 0, 0, SINGULAR]
    for name in ("F", "D", "x", "K", "H", "c"):
        np.testing.assert_array_equal(getattr(damped, name)[[0, 2, 3]], getattr(plain, name)[[0, 2, 3]])
        assert np.isfinite(getattr(damped, name)).all()
    assert (damped.wrench_error[[0, 2, 3]] == 0.0).all()
    assert plain.wrench_error is None
    np.testing.assert_array_equal(damped.F[1], damped.F[4])


@pytest.mark.parametrize(
    ("make", "code", "text"),
    [(zero_length_leg, ZERO_LENGTH, "length zero"), (leg_along_its_axis, JOINT_SINGULAR, "universal")],
)
def test_legs_without_direction_or_frame_are_still_rejected(make, code: int, text: str) -> None:
    robot, bad = make()
    both = together(at_rest([0.13, 0.04, 0.6]), bad)
    with pytest.warns(ss.SingularPoseWarning, match=rf"motion\[1\].*{text}"):
        found = ss.inverse_dynamics(robot, both, on_singular="damped")
    assert list(found.status) == [OK, code]
    assert np.isnan(found.F[1]).all()
    assert np.isnan(found.wrench_error[1]).all()
    for function in (ss.joint_reactions, ss.ForceKernel(robot).forces):
        arguments = (robot, both) if function is ss.joint_reactions else (both,)
        with pytest.warns(ss.SingularPoseWarning, match=rf"motion\[1\].*{text}"):
            function(*arguments, on_singular="damped")


@pytest.mark.parametrize("precision", ["double", "float"])
def test_the_force_kernel_takes_damped_forces_from_the_full_road(precision) -> None:
    robot, bad = singular()
    mixed = together(at_rest([0.1, 0.0, 0.6]), bad)
    kernel = ss.ForceKernel(robot, precision=precision)
    F = kernel.forces(mixed, on_singular="damped")
    assert F.dtype == kernel.dtype
    expected = ss.inverse_dynamics(robot, mixed, on_singular="damped").F
    np.testing.assert_allclose(F[1], expected[1], rtol=1e-6)
    np.testing.assert_array_equal(F[0], kernel.forces(mixed, on_singular="nan")[0])
    np.testing.assert_array_equal(kernel.forces(bad, on_singular="damped"), F[1])


@pytest.mark.parametrize("backend", BACKENDS)
def test_reactions_are_those_of_the_damped_forces(backend) -> None:
    robot, bad = singular()
    mixed = together(at_rest([0.1, 0.0, 0.6]), bad)
    found = ss.joint_reactions(robot, mixed, backend=backend, on_singular="damped")
    forces = ss.inverse_dynamics(robot, mixed, backend=backend, on_singular="damped")
    s = np.swapaxes(forces.H, -1, -2)[..., :3]
    np.testing.assert_allclose(found.F_s, forces.x[..., None] * s + forces.K, atol=1e-9)
    np.testing.assert_allclose(np.sum(found.F_p * s, axis=-1), forces.F, atol=1e-9)
    plain = ss.joint_reactions(robot, mixed, backend=backend, on_singular="nan")
    np.testing.assert_array_equal(found.F_u[0], plain.F_u[0])
    assert list(found.status) == [0, SINGULAR]


# the solution itself


def matrices(smallest: float, count: int = 40) -> tuple[Array, Array, Array]:
    """Random H of length 1 m with singular values from 1 to 0.2 and a smallest one, c, and u_6."""
    rng = np.random.default_rng(9)
    U, V = (np.linalg.qr(rng.normal(size=(count, 6, 6)))[0] for _ in range(2))
    s = np.array([1.0, 0.8, 0.6, 0.4, 0.2, smallest])
    return (U * s) @ np.swapaxes(V, -1, -2), rng.normal(size=(count, 6)), U[..., -1]


@pytest.mark.parametrize("smallest", [1e-1, 2e-4])
def test_above_its_threshold_the_solution_is_the_plain_one(smallest: float) -> None:
    H, c, _ = matrices(smallest)
    x, error = damped_least_squares(H, c, 1.0)
    np.testing.assert_allclose(x, np.linalg.solve(H, c[..., None])[..., 0], rtol=1e-9)
    assert np.abs(error).max() < 1e-10


@pytest.mark.parametrize("smallest", [1e-4, 1e-10, 0.0])
def test_below_it_forces_stay_bounded_and_only_the_lost_wrench_is_missing(smallest: float) -> None:
    H, c, u = matrices(smallest)
    x, error = damped_least_squares(H, c, 1.0)
    assert (np.linalg.norm(x, axis=-1) <= np.linalg.norm(c, axis=-1) * (1 / SHARE + 5.0)).all()
    missing = np.sum(u * c, axis=-1) * (1.0 - (smallest / SHARE) ** 2)
    np.testing.assert_allclose(error, missing[..., None] * u, atol=1e-9)
