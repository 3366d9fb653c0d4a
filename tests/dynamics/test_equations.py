"""Equations of motion: they restate inverse dynamics, and have the structure that mechanics gives them."""

import dataclasses
from typing import Any

import numpy as np
import pytest
from machines import Array, machine_in_motion, machine_size, rotation
from motion_fields import acceleration

import stewart_sym as ss
from stewart_sym.reference import newton_euler
from stewart_sym.reference.equations_of_motion import equations_of_motion as oracle

BACKENDS = ("c", "numpy", "reference")
FORMULATIONS = ("exact", "paper")
JOINTS = ("universal", "spherical")


def machines(base_joint: str, count: int = 2) -> list[tuple[ss.Robot, ss.Motion]]:
    return [machine_in_motion(seed, (4,), base_joint) for seed in range(count)]


def load_of(motion: ss.Motion) -> Array:
    """W_ext = [R F_ext; R M_ext], (..., 6)."""
    return np.concatenate([(motion.R @ x[..., None])[..., 0] for x in (motion.F_ext, motion.M_ext)], axis=-1)


def twist(motion: ss.Motion) -> Array:
    return np.concatenate([motion.v, motion.omega], axis=-1)


def times(A: Array, x: Array) -> Array:
    return np.asarray((A @ x[..., None])[..., 0])


def in_one_unit(robot: ss.Robot, wrench: Array) -> Array:
    """Moments over the machine's size, so that forces and moments may be compared."""
    return wrench / np.repeat([1.0, machine_size(robot)], 3)


def worst(robot: ss.Robot, found: Array, true: Array) -> float:
    """Largest difference of wrenches beside the largest of each pose."""
    found, true = in_one_unit(robot, found), in_one_unit(robot, true)
    return float(np.max(np.abs(found - true).max(axis=-1) / np.abs(true).max(axis=-1)))


@pytest.mark.parametrize("base_joint", JOINTS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("backend", BACKENDS)
def test_the_terms_add_up_to_inverse_dynamics(backend: Any, formulation: Any, base_joint: str) -> None:
    for robot, motion in machines(base_joint):
        e = ss.equations_of_motion(robot, motion, formulation, backend)
        r = ss.inverse_dynamics(robot, motion, formulation, "reference")
        left = times(e.M, acceleration(motion)) + times(e.C, twist(motion)) + e.g + e.friction
        right = times(r.H, r.F) + load_of(motion)
        assert worst(robot, left, right) < 1e-13 * ss.condition_number(r.H).max()
        assert worst(robot, times(e.C, twist(motion)) + e.g, e.bias) < 1e-12
        assert worst(robot, e.bias + e.friction, e.bias_and_friction) < 1e-12


@pytest.mark.parametrize("base_joint", JOINTS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_backends_agree_with_the_oracle(backend: Any, formulation: Any, base_joint: str) -> None:
    faults = newton_euler.PAPER if formulation == "paper" else newton_euler.EXACT
    for robot, motion in machines(base_joint):
        found = ss.equations_of_motion(robot, motion, formulation, backend)
        true = oracle(robot, motion, faults)
        for name in ("M", "g", "friction", "bias", "bias_and_friction"):
            a, b = getattr(found, name), getattr(true, name)
            np.testing.assert_allclose(a, b, rtol=1e-11, atol=1e-12 * np.abs(b).max(), err_msg=name)


@pytest.mark.parametrize("base_joint", JOINTS)
@pytest.mark.parametrize("backend", BACKENDS)
def test_exact_M_is_symmetric_positive_definite_and_makes_the_kinetic_energy(
    backend: Any, base_joint: str
) -> None:
    for robot, motion in machines(base_joint):
        M = ss.equations_of_motion(robot, motion, backend=backend).M
        np.testing.assert_allclose(M, np.swapaxes(M, -1, -2), rtol=1e-12, atol=1e-13 * np.abs(M).max())
        assert np.linalg.eigvalsh(M).min() > 0
        rest = ss.Motion(R=motion.R, t=motion.t, omega=0 * motion.omega, v=0 * motion.v)
        kinetic = newton_euler.energy(robot, motion) - newton_euler.energy(robot, rest)
        of_M = np.einsum("ni,nij,nj->n", twist(motion), M, twist(motion)) / 2
        np.testing.assert_allclose(of_M, kinetic, rtol=1e-10)


@pytest.mark.parametrize("base_joint", JOINTS)
@pytest.mark.parametrize("backend", BACKENDS)
def test_rate_of_exact_M_is_C_plus_its_transpose(backend: Any, base_joint: str) -> None:
    """So that dM/dt - 2 C is skew. The rate is a fourth-order difference along the motion."""
    for seed in range(2):
        robot, motion = machine_in_motion(seed, scale=1.0, base_joint=base_joint)
        h = 1e-3 * np.sqrt(machine_size(robot) / 9.81)

        def at(time: float, motion: ss.Motion = motion, robot: ss.Robot = robot) -> Array:
            R = rotation(time * motion.omega) @ motion.R
            moved = ss.Motion(R=R, t=motion.t + time * motion.v, omega=motion.omega, v=motion.v)
            return ss.equations_of_motion(robot, moved, backend=backend).M

        rate = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h)
        C = ss.equations_of_motion(robot, motion, backend=backend).C
        np.testing.assert_allclose(C + C.T, rate, atol=1e-8 * np.abs(rate).max())
        assert np.abs(C - C.T).max() > 1e-3 * np.abs(C).max()


@pytest.mark.parametrize("base_joint", JOINTS)
@pytest.mark.parametrize("formulation", FORMULATIONS)
@pytest.mark.parametrize("backend", BACKENDS)
def test_forward_dynamics_inverts_inverse_dynamics(backend: Any, formulation: Any, base_joint: str) -> None:
    for robot, motion in machines(base_joint, 3):
        F = ss.inverse_dynamics(robot, motion, formulation, "reference").F
        free = dataclasses.replace(motion, alpha=None, a=None)
        a, alpha = ss.forward_dynamics(robot, free, F, formulation, backend)
        e = ss.equations_of_motion(robot, motion, formulation, backend)
        size = np.repeat([1.0, machine_size(robot)], 3)
        # In one unit of length, as the condition number of M mixes kg and kg m^2 otherwise.
        condition = np.linalg.cond(e.M / np.outer(size, size))
        found, true = (np.concatenate(x, axis=-1) * size for x in ((a, alpha), (motion.a, motion.alpha)))
        error = np.abs(found - true).max(axis=-1) / np.abs(true).max(axis=-1)
        held = in_one_unit(robot, e.bias_and_friction - load_of(motion))
        # What cancels may be larger than what remains.
        large = 1 + np.abs(held).max(axis=-1) / np.abs(
            in_one_unit(robot, times(e.M, acceleration(motion)))
        ).max(axis=-1)
        assert (error < 1e-12 * condition * large).all()


@pytest.mark.parametrize("backend", BACKENDS)
def test_poses_without_an_answer_are_named_or_nan(backend: Any) -> None:
    robot, good = machine_in_motion(8, scale=1.0)
    t = np.stack([good.t, robot.b[3] - good.R @ robot.p[3]])
    motion = ss.Motion(R=good.R, t=t, omega=good.omega, v=good.v)
    F = np.ones(6)
    with pytest.raises(ValueError, match=r"^motion\[1\]: a leg has length zero \(leg 4\)$"):
        ss.forward_dynamics(robot, motion, F, backend=backend)
    with pytest.raises(ValueError, match=r"^motion\[1\]: a leg has length zero \(leg 4\)$"):
        ss.equations_of_motion(robot, motion, backend=backend)
    a, alpha = ss.forward_dynamics(robot, motion, F, backend=backend, on_singular="nan")
    assert np.isfinite(a[0]).all()
    assert np.isnan(a[1]).all()
    assert np.isnan(alpha[1]).all()
    e = ss.equations_of_motion(robot, motion, backend=backend, on_singular="nan")
    assert e.status.tolist() == [0, 2]
    assert np.isnan(e.M[1]).all()
    with pytest.warns(ss.SingularPoseWarning):
        ss.forward_dynamics(robot, motion, F, backend=backend, on_singular="warn")
