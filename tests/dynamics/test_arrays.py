"""Kernels on arrays of NumPy, the array API standard and JAX: the C's numbers, statuses and derivatives."""

import copy
import pickle
from dataclasses import replace
from typing import Any

import array_api_strict
import numpy as np
import pytest
from command_line import rejects
from machines import (
    MACHINES,
    dasgupta,
    machine_in_motion,
    random_motion,
    random_robot,
    upside_down_in_millimeters,
    with_random_drives,
)
from motion_fields import FIELDS
from sweeps import FULL

import stewart_sym as ss

EPSILON = 2.0**-52
RATES = FIELDS[:4]


def fields(motion: ss.Motion, names: tuple[str, ...] = FIELDS) -> dict[str, Any]:
    return {name: getattr(motion, name) for name in names}


@pytest.mark.parametrize(
    ("machine", "xp"), [*((name, np) for name in MACHINES), (next(iter(MACHINES)), array_api_strict)]
)
@pytest.mark.usefixtures("rounded_twice")
def test_numbers_on_arrays_are_those_of_the_c(machine: str, xp: Any) -> None:
    robot = MACHINES[machine]()
    motion = random_motion(np.random.default_rng(32), robot, (3, 2))
    kernel = ss.ArrayKernel(robot, xp)
    F = kernel.forces(**fields(motion))
    np.testing.assert_array_equal(np.asarray(F.F), ss.ForceKernel(robot).forces(motion))
    assert F.status.shape == (3, 2)
    found, expected = kernel.equations(**fields(motion, RATES)), ss.equations_of_motion(robot, motion)
    for name in ("M", "C", "g", "friction", "bias", "bias_and_friction"):
        answer = getattr(expected, name)
        np.testing.assert_allclose(
            np.asarray(getattr(found, name)), answer, rtol=0, atol=1e-14 * np.abs(answer).max()
        )
    moved = kernel.forward_dynamics(F=F.F, **fields(motion, (*RATES, "F_ext", "M_ext")))
    by_force = np.abs(ss.linearize(robot, motion, np.asarray(F.F)).B).max() * np.abs(np.asarray(F.F)).max()
    np.testing.assert_allclose(np.asarray(moved.a), motion.a, rtol=0, atol=30 * EPSILON * by_force)


@pytest.mark.parametrize("xp", [np, array_api_strict], ids=["numpy", "array_api_strict"])
def test_lengths_rates_and_torques_on_arrays_are_those_of_numpy(xp: Any) -> None:
    rng = np.random.default_rng(34)
    for joint in ("universal", "spherical"):
        robot = with_random_drives(rng, random_robot(rng, joint), rotors=True)
        motion = random_motion(rng, robot, (3, 2))
        kernel = ss.ArrayKernel(robot, xp)
        legs, effort = ss.inverse_kinematics(robot, motion), ss.drive_effort(robot, motion)
        found = kernel.torques(**fields(motion))
        assert found.status.shape == (3, 2)
        for values, expected in (
            (kernel.lengths(motion.R, motion.t), legs.L),
            (kernel.rates(**fields(motion, RATES)), legs.L_dot),
            (found.torque, effort.torque),
        ):
            atol = 1e-12 * np.abs(expected).max()
            np.testing.assert_allclose(np.asarray(values), expected, rtol=0, atol=atol)
        one = kernel.torques(R=motion.R[0, 0], t=motion.t).torque
        assert one.shape == (3, 2, 6)
    rejects(
        "^robot: drive: missing", ss.ArrayKernel(replace(robot, drive=None), np).torques, np.eye(3), motion.t
    )


def test_statuses_on_arrays_are_those_of_the_c_and_numbers_are_nan_there() -> None:
    robot, motion = machine_in_motion(34, (3,))
    t = motion.t.copy()
    t[0, 0] = np.inf
    t[1] = robot.b[2] - motion.R[1] @ robot.p[2]
    given = fields(motion) | {"t": t}
    found = ss.ArrayKernel(robot, np).forces(**given)
    codes = ss.ForceKernel(robot).forces_and_status(ss.Motion._unchecked(**given))[1]
    np.testing.assert_array_equal(found.status, codes)
    assert list(codes) == [1, 2, 0]
    np.testing.assert_array_equal(np.isnan(found.F).all(axis=-1), codes != 0)
    flat = replace(robot, b=robot.b * [1.0, 0.0, 0.0])
    np.testing.assert_array_equal(ss.ArrayKernel(flat, np).forces(**fields(motion)).status, 4)


def test_copies_and_pickles_have_the_same_numbers() -> None:
    kernel = ss.ArrayKernel(dasgupta(), np)
    poses = {"R": np.eye(3), "t": [0.2, 0.0, 0.8]}
    for other in (pickle.loads(pickle.dumps(kernel)), copy.deepcopy(kernel)):
        np.testing.assert_array_equal(other.forces(**poses).F, kernel.forces(**poses).F)


def test_what_is_no_namespace_and_constants_that_overflow_are_one_line() -> None:
    with pytest.raises(
        ValueError, match=r"^xp: expected an array namespace such as numpy or jax\.numpy, got str"
    ):
        ss.ArrayKernel(dasgupta(), "numpy")
    with pytest.raises(ValueError, match=r"^robot: "), np.errstate(all="ignore"):
        ss.ArrayKernel(replace(dasgupta(), R_0=np.full(3, 1e200)), np)


def test_single_precision_on_arrays_errs_as_single_precision_does() -> None:
    robot, motion = machine_in_motion(35, (20,))
    found = ss.ArrayKernel(robot, np, dtype=np.float32).forces(**fields(motion))
    assert found.F.dtype == np.float32
    expected = ss.ForceKernel(robot).forces(motion)
    assert 0 < np.abs(found.F - expected).max() < 1e-3 * np.abs(expected).max()


@pytest.mark.full
@pytest.mark.slow
def test_gradients_by_jax_of_mapped_poses_are_the_derivatives_of_the_forces() -> None:
    import jax
    import jax.numpy as jnp

    rng = np.random.default_rng(36)
    with jax.enable_x64(True):
        for robot in (upside_down_in_millimeters(), *([dasgupta()] if FULL else [])):
            motion = random_motion(rng, robot, (5,))
            kernel = ss.ArrayKernel(robot, jnp)
            weights = rng.normal(size=(5, 6))

            def weighed(step: Any, twist: Any, rate: Any, at: Any, weights: Any, of: Any = kernel) -> Any:
                x, y, z = step[3:]
                turn = jnp.array([[1.0, -z, y], [z, 1.0, -x], [-y, x, 1.0]])
                rates = {"v": twist[:3], "omega": twist[3:], "a": rate[:3], "alpha": rate[3:]}
                loads = {name: at[name] for name in ("F_ext", "M_ext")}
                return of.forces(R=turn @ at["R"], t=at["t"] + step[:3], **rates, **loads).F @ weights

            given = {name: jnp.asarray(value) for name, value in fields(motion).items()}
            twist = jnp.concatenate([given["v"], given["omega"]], axis=-1)
            rate = jnp.concatenate([given["a"], given["alpha"]], axis=-1)
            mapped = jax.vmap(jax.grad(weighed, argnums=(0, 1, 2)))
            by = mapped(jnp.zeros((5, 6)), twist, rate, given, jnp.asarray(weights))
            expected = ss.force_derivatives(robot, motion)
            slopes = (expected.by_pose, expected.by_twist, expected.by_acceleration)
            for found, slope in zip(by, slopes, strict=True):
                answer = np.einsum("ni,nij->nj", weights, slope)
                scale = np.einsum("ni,nij->nj", np.abs(weights), np.abs(slope)).max()
                np.testing.assert_allclose(found, answer, rtol=0, atol=1e-9 * scale)
