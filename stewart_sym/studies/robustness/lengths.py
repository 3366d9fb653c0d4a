"""Families 3: a leg's length goes to zero, and to the limits of the robot."""

import dataclasses

import numpy as np

from ...kinematics.forward import forward_kinematics
from ...kinematics.inverse import leg_vectors
from ...motion.motion import Motion
from ...results import OK, OUT_OF_LIMITS
from ...robot.robot import Robot
from . import shipped
from .family import Curve, Family, distances
from .sweep.machines import random_machine, random_motion


def families(seed: int = 3) -> list[Family]:
    """A leg of length zero; lengths within and beyond a limit by ever less."""
    return [_short(seed), _limits(seed)]


def _short(seed: int) -> Family:
    rng = np.random.default_rng(seed)
    robot = random_machine(rng)
    motion = random_motion(rng, robot)
    q, _, _ = leg_vectors(robot, motion.R, motion.t)
    tip, way = q[0] + motion.t, np.array([0.36, -0.48, 0.8])
    robots = []
    for distance in distances():
        b = robot.b.copy()
        b[0] = tip - distance * way
        robots.append(dataclasses.replace(robot, b=b))
    motions = [motion] * len(robots)
    return Family(
        "zero_length",
        "Forces where a leg's length goes to zero",
        "leg of length zero",
        "status 2 where the length is rounding error of its terms",
        "length of leg 1, m",
        shipped.curves(robots, motions),
        growth={"condition of the pose": shipped.pose_condition(robots, motions)},
        growth_axis="condition number",
    )


def _limits(seed: int) -> Family:
    """Forward kinematics of lengths beside a limit: the error is 0 where the status is right, else 1."""
    rng = np.random.default_rng(seed)
    robot: Robot = random_machine(rng)
    motion: Motion = random_motion(rng, robot)
    L = leg_vectors(robot, motion.R, motion.t)[2]
    curves = []
    for name, side, sign in (
        ("upper limit, within", 1, 1.0),
        ("upper limit, beyond", 1, -1.0),
        ("lower limit, within", 0, -1.0),
        ("lower limit, beyond", 0, 1.0),
    ):
        status = np.zeros(len(distances()), dtype=np.int32)
        error = np.zeros(len(status))
        for i, distance in enumerate(distances()):
            limit = float(L[0] * (1.0 + sign * distance * (0.5 if sign < 0.0 else 1.0)))
            limits = np.column_stack([0.1 * L, 10.0 * L])
            limits[0, side] = limit
            bounded = dataclasses.replace(robot, length_limits=limits)
            status[i] = forward_kinematics(bounded, L, (motion.R, motion.t), "nan").status
            outside = L[0] > limits[0, 1] or L[0] < limits[0, 0]
            error[i] = 0.0 if status[i] == (OUT_OF_LIMITS if outside else OK) else 1.0
        condition = np.where(status == OK, 1.0, np.inf)
        curves.append(Curve(name, error, condition, status, shipped=True))
    return Family(
        "length_limits",
        "Leg lengths beside a limit",
        "leg length at its limit",
        "status 8 in forward kinematics, from the first rounding unit on",
        "share of the length to the limit",
        tuple(curves),
        error_axis="status of forward kinematics",
        by_status=True,
    )
