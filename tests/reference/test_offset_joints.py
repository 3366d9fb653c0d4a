"""Legs with offset joints: against Pinocchio's chains, the work-energy theorem and the ordinary kernels."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from command_line import rejects
from machines import (
    PLATFORM_JOINTS,
    machine_in_motion,
    offset_case,
    random_path,
    random_robot,
)
from motion_fields import balance_of
from pinocchio_model import Answer, pinocchio_inverse_dynamics

import stewart_sym as ss
from stewart_sym.dynamics.equations import ForwardDynamics
from stewart_sym.dynamics.forward_dynamics import from_forces
from stewart_sym.reference import newton_euler, offset_joints
from stewart_sym.results import JOINT_SINGULAR, OK, SINGULAR, UNREACHABLE, ZERO_LENGTH

RELATIVE, ENERGY = 1e-10, 1e-12
MACHINES = range(6)
EPS = float(np.finfo(np.float64).eps)


@cache
def _case(seed: int, joint: str) -> tuple[ss.Robot, ss.Motion, Answer]:
    robot, motion = offset_case(seed, joint)
    return robot, motion, pinocchio_inverse_dynamics(robot, motion)


def _error(found: object, wanted: np.ndarray) -> float:
    return float(np.abs(np.asarray(found) - wanted).max() / np.abs(wanted).max())


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_forces_and_reactions_agree_with_pinocchio(joint: str) -> None:
    for seed in MACHINES:
        robot, motion, truth = _case(seed, joint)
        forces, reactions = ss.inverse_dynamics(robot, motion), ss.joint_reactions(robot, motion)
        assert _error(forces.F, truth.F) < RELATIVE, seed
        for name in ("F_s", "F_u", "F_p", "M_u"):
            assert _error(getattr(reactions, name), getattr(truth, name)) < RELATIVE, (seed, name)


def test_forces_and_moments_of_universal_platform_joints_balance_the_platform() -> None:
    for seed in MACHINES:
        robot, motion, _ = _case(seed, "universal")
        robot = dataclasses.replace(robot, C_s=np.zeros(6))
        found = ss.joint_reactions(robot, motion)
        moments = np.cross(robot.p @ motion.R.T, found.F_s) + found.M_s
        wrench = np.concatenate([found.F_s, moments], axis=-1).sum(axis=0)
        assert _error(wrench, newton_euler.platform_wrench(robot, motion)) < RELATIVE, seed
        assert ss.joint_reactions(_case(seed, "spherical")[0], _case(seed, "spherical")[1]).M_s is None


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_the_kernel_agrees_with_pinocchio(backend: str) -> None:
    for seed in MACHINES:
        robot, motion, truth = _case(seed, "spherical")
        if backend == "c":
            F = ss.ForceKernel(robot).forces(motion)
        else:
            parts = {name: getattr(motion, name) for name in ("R", "t", "omega", "v", "alpha", "a")}
            F = ss.ArrayKernel(robot, np).forces(**parts, F_ext=motion.F_ext, M_ext=motion.M_ext).F
        assert _error(F, truth.F) < RELATIVE, seed


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_lengths_and_spins_with_their_rates_agree_with_pinocchio(joint: str) -> None:
    for seed in MACHINES:
        robot, motion, truth = _case(seed, joint)
        legs = ss.inverse_kinematics(robot, motion)
        moving = offset_joints.legs(robot, motion).moving
        found = [(truth.sliding, legs.L, legs.L_dot, legs.L_ddot)]
        if joint == "universal":
            found.append(
                (truth.spin, moving.at.spin[..., 0], moving.rates[..., 3], moving.accelerations[..., 3])
            )
        for wanted, *orders in found:
            for order, value in enumerate(orders):
                assert _error(value, wanted[:, order]) < RELATIVE, (seed, order)


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_without_offsets_all_is_as_in_ordinary_legs(joint: str) -> None:
    for seed in range(6):
        robot, motion = machine_in_motion(seed, (4,))
        with_zeros = dataclasses.replace(robot, offsets=ss.JointOffsets())
        fast = ss.ForceKernel(with_zeros).forces(motion) - ss.ForceKernel(robot).forces(motion)
        forces, plain = ss.inverse_dynamics(with_zeros, motion), ss.inverse_dynamics(robot, motion)
        assert np.all(np.abs(fast) <= 100 * EPS * np.abs(plain.F).max(axis=-1, keepdims=True)), seed
        for name in ("F", "D", "x", "K", "H", "c"):
            assert _error(getattr(forces, name), getattr(plain, name)) < 1e-13, (seed, name)
        found, wanted = (
            ss.joint_reactions(with_zeros, motion, bearing_distance=0.1),
            ss.joint_reactions(robot, motion, bearing_distance=0.1),
        )
        for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u"):
            assert _error(getattr(found, name), getattr(wanted, name)) < 1e-12, (seed, name)


def test_offsets_that_are_left_out_change_the_forces() -> None:
    robot, motion, truth = _case(0, "spherical")
    for name in ("axis_offset", "slide_offset_y", "slide_offset_z", "cross_mass", "cross_inertia"):
        without = dataclasses.replace(robot.offsets, **{name: np.zeros(6)})
        changed = ss.ForceKernel(dataclasses.replace(robot, offsets=without)).forces(motion)
        assert _error(changed, truth.F) > 1e-6, name


@pytest.mark.parametrize("screws", [False, True], ids=["", "rotors"])
@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_work_is_energy(joint: str, screws: bool) -> None:
    for seed in range(3):
        rng = np.random.default_rng(seed)
        robot, _ = offset_case(seed, joint, screws=screws)

        def power(motion: ss.Motion, robot: ss.Robot = robot) -> np.ndarray:
            F = ss.inverse_dynamics(robot, motion).F
            if joint == "spherical":
                fast = ss.ForceKernel(robot).forces(motion)
                np.testing.assert_allclose(fast, F, rtol=0, atol=1e-12 * np.abs(F).max())
            twist = np.concatenate([motion.v, motion.omega], axis=-1)
            return np.einsum("...i,...ji,...j->...", F, ss.wrench_matrix(robot, motion), twist)

        balance = balance_of(robot, random_path(rng, robot), power, offset_joints)
        assert abs(balance.mismatch) < ENERGY * balance.turnover, seed
        assert balance.moved["friction"] > 0


@pytest.mark.parametrize("joint", PLATFORM_JOINTS)
def test_equations_of_motion_and_forward_dynamics_undo_inverse_dynamics(joint: str) -> None:
    robot, motion = offset_case(7, joint, (3,))
    forces = ss.inverse_dynamics(robot, motion)
    e = ss.equations_of_motion(robot, motion)
    acceleration = np.concatenate([motion.a, motion.alpha], axis=-1)
    needed = np.einsum("...ij,...j->...i", e.M, acceleration) + e.bias_and_friction
    given = np.einsum("...ij,...j->...i", forces.H, forces.F) + motion.external_wrench()
    assert _error(given, needed) < 1e-12
    assert _error(ss.forward_dynamics(robot, motion, F=forces.F).a, motion.a) < 1e-11
    assert np.abs(e.M - np.swapaxes(e.M, -1, -2)).max() < 1e-12 * np.abs(e.M).max()


def test_one_state_gives_what_the_batch_gives() -> None:
    for seed in MACHINES:
        for joint in PLATFORM_JOINTS:
            robot, motion, truth = _case(seed, joint)
            forward, F = ForwardDynamics(robot), 0.9 * truth.F
            a, alpha, status = forward.solve(motion, F)
            found, code = forward.one_state()(motion, F)
            assert code == status == OK
            assert _error(found, np.concatenate([a, alpha])) < RELATIVE, (seed, joint)


def test_compiled_forces_tell_accelerations_but_at_singular_poses() -> None:
    cases = [_case(seed, "spherical") for seed in MACHINES]
    told = [from_forces(robot)(motion, truth.F) is not None for robot, motion, truth in cases]
    assert sum(told) > 0.8 * len(told)
    robot, motion, truth = cases[0]
    plane = {"b": robot.b * [1.0, 1.0, 0.0], "p": robot.p * [1.0, 1.0, 0.0], "offsets": ss.JointOffsets()}
    flat = dataclasses.replace(robot, **plane)
    pose = dataclasses.replace(motion, R=np.eye(3), t=np.zeros(3))
    assert from_forces(flat)(pose, truth.F) is None


def test_one_pose_and_a_batch_agree_and_threads_as_well() -> None:
    robot, motion = offset_case(3, "spherical", (19,))
    kernel = ss.ForceKernel(robot)
    F = kernel.forces(motion)
    for i in (0, 7, 18):
        np.testing.assert_array_equal(kernel.forces(motion[i]), F[i])


# ---------------------------------------------------------------- statuses


def _bare(**offsets: float) -> ss.Robot:
    robot = random_robot(np.random.default_rng(1), scale=1.0)
    every = {name: np.full(6, value) for name, value in offsets.items()}
    return dataclasses.replace(robot, offsets=ss.JointOffsets(**every))


def _tip_of_leg_1(robot: ss.Robot, tip: np.ndarray) -> ss.Motion:
    """The platform level, so that leg 1 goes from its base point by ``tip``."""
    none = np.zeros(3)
    return ss.Motion(R=np.eye(3), t=robot.b[0] + tip - robot.p[0], omega=none, v=none, alpha=none, a=none)


@pytest.mark.parametrize(
    ("name", "offsets", "along", "out", "status"),
    [
        ("nearer the axis than along", {"slide_offset_y": 0.2}, 0.5, 0.1, UNREACHABLE),
        ("nearer than across", {"slide_offset_z": 0.3}, 0.1, 0.2, UNREACHABLE),
        ("on the axis", {"axis_offset": 0.2}, 0.4, 0.0, JOINT_SINGULAR),
        ("r = 0", {"slide_offset_y": 0.2}, 0.5, 0.2, JOINT_SINGULAR),
        ("no length", {"axis_offset": 0.2}, 0.0, 0.2, ZERO_LENGTH),
    ],
    ids=str,
)
def test_what_is_wrong_with_a_leg(
    name: str, offsets: dict[str, float], along: float, out: float, status: int
) -> None:
    robot = _bare(**offsets)
    k = robot.k[0]
    across = np.cross(k, np.eye(3)[np.argmin(np.abs(k))])
    motion = _tip_of_leg_1(robot, along * k + out * across / np.linalg.norm(across))
    # To rounding a tip at a limit may lie beyond it.
    status_set = {status, *([UNREACHABLE] if name in ("r = 0", "no length") else [])}
    found = ss.inverse_dynamics(robot, motion, on_singular="nan")
    assert int(found.status) in status_set
    assert np.isnan(found.F).all()
    assert int(ss.ForceKernel(robot).forces_and_status(motion)[1]) in {*status_set, SINGULAR}
    rejects(r"leg 1", ss.inverse_dynamics, robot, motion)
    rejects(r"leg 1", ss.inverse_kinematics, robot, motion)
