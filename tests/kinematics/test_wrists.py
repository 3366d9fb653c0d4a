"""Long wrists of U-C-U legs: the chain closes where a root finder closes it, and is unreachable elsewhere."""

import dataclasses

import numpy as np
import pytest
from machines import Array, machine_in_motion, offsets_of
from pinocchio_model import pinocchio_inverse_dynamics
from scipy.optimize import least_squares
from sweeps import share

import stewart_sym as ss
from stewart_sym.results import UNREACHABLE


def _case(seed: int, ratio: tuple[float, float], offsets: float = 0.0) -> tuple[ss.Robot, ss.Motion]:
    """A U-C-U machine whose platform axes are 2 to 60 degrees from its legs.

    ratio: range of the wrist over the distance from the platform axis to the end of the leg. offsets: others,
    as a share of the machine's size.
    """
    rng = np.random.default_rng(seed)
    robot, motion = machine_in_motion(rng)
    legs = robot.p @ motion.R.T + motion.t - robot.b
    length = np.linalg.norm(legs, axis=1, keepdims=True)
    s = legs / length
    across = np.cross(s, rng.normal(size=(6, 3)))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    angle = np.radians(rng.uniform(2.0, 60.0, (6, 1)))
    axes = np.cos(angle) * s + np.sin(angle) * across
    drawn = rng.uniform(*ratio, (6, 1))
    wrist = (length * np.sin(angle) * drawn / (1.0 + drawn))[:, 0]
    found = offsets_of(rng, robot, "universal", offsets)
    changed = dataclasses.replace(found, platform_axis=axes @ motion.R, wrist_offset=wrist)
    return dataclasses.replace(robot, offsets=changed), motion


def _turned(vector: Array, axis: Array, angle: float) -> Array:
    return vector * np.cos(angle) + np.cross(axis, vector) * np.sin(angle)


def _closed_chain(robot: ss.Robot, motion: ss.Motion, i: int) -> Array:
    """Two angles, length, spin, and angle of the wrist at which a root finder closes the chain of a leg."""
    o, k = robot.offsets, robot.k[i]
    point, axis = motion.R @ robot.p[i] + motion.t - robot.b[i], motion.R @ o.platform_axis[i]
    o_0 = np.cross(k, np.eye(3)[np.argmin(np.abs(k))])
    o_0 /= np.linalg.norm(o_0)

    def frame(q: Array) -> tuple[Array, Array, Array, Array]:
        outward = _turned(o_0, k, q[0])
        y = np.cross(k, outward)
        s = _turned(k, y, q[1])
        return outward, y, s, np.cross(s, y)

    def miss(q: Array, part: float) -> Array:
        outward, y, s, z = frame(q)
        first = np.cos(q[3]) * y + np.sin(q[3]) * z
        second = np.cos(q[4]) * s + np.sin(q[4]) * np.cross(s, first)
        end = (
            part * (o.axis_offset[i] * outward + o.slide_offset_y[i] * y + o.slide_offset_z[i] * z) + q[2] * s
        )
        wrist = part * o.wrist_offset[i] * np.cross(first, second)
        return np.concatenate([(end + wrist - point) / size, second - axis])

    size = float(np.linalg.norm(point))
    outward = point - point @ k * k
    outward /= np.linalg.norm(outward)
    start = np.array([np.arctan2(np.cross(o_0, outward) @ k, o_0 @ outward), 0.0, size, 0.0, 0.0])
    start[1] = np.arctan2(point @ outward, point @ k)
    _, y, s, z = frame(start)
    first = np.cross(axis, s)
    start[3] = np.arctan2(first @ z, first @ y)
    start[4] = np.arctan2(np.linalg.norm(first), axis @ s)
    # From the leg without offsets on, so that of two solutions the same is found.
    for part in (0.0, 0.5, 1.0):
        found = least_squares(miss, start, args=(part,), xtol=1e-15, ftol=1e-15, gtol=1e-15)
        start = found.x
    assert np.abs(found.fun).max() < 1e-13
    return start


@pytest.mark.slow
def test_chains_close_as_a_root_finder_closes_them() -> None:
    for seed in range(share(100, 50)):
        for ratio in ((0.05, 0.95), (0.55, 0.95), (1.0, 5.0)):
            robot, motion = _case(seed, ratio, 0.01 * (seed % 2))
            found = ss.inverse_kinematics(robot, motion).L
            truth = np.array([_closed_chain(robot, motion, i)[2] for i in range(6)])
            np.testing.assert_allclose(
                found, truth, rtol=0, atol=1e-12 * truth.max(), err_msg=f"{seed} {ratio}"
            )


def test_forces_with_long_wrists_agree_with_pinocchio() -> None:
    for seed in range(4):
        robot, motion = _case(seed, (0.55, 0.95), 0.01 * (seed % 2))
        truth = pinocchio_inverse_dynamics(robot, motion).F
        error = np.abs(ss.inverse_dynamics(robot, motion).F - truth).max() / np.abs(truth).max()
        assert error < 1e-9, seed


def test_wrists_longer_than_the_distance_from_the_axis_are_unreachable() -> None:
    for seed in range(6):
        robot, motion = _case(seed, (0.5, 0.95))
        reach = robot.p @ motion.R.T + motion.t - robot.b
        distance = np.linalg.norm(np.cross(robot.offsets.platform_axis @ motion.R.T, reach), axis=1)
        leg = seed % 6
        for times, reachable in ((0.999, True), (1.001, False), (3.0, False)):
            wrist = robot.offsets.wrist_offset.copy()
            wrist[leg] = times * distance[leg]
            longer = dataclasses.replace(
                robot, offsets=dataclasses.replace(robot.offsets, wrist_offset=wrist)
            )
            status = int(ss.inverse_dynamics(longer, motion, on_singular="nan").status)
            assert (status != UNREACHABLE) == reachable, (seed, times)
