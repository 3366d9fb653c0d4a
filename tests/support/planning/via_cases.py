"""Random machines with via poses, and limits of force that leave room above what weight takes."""

import dataclasses

import numpy as np
from machines import machine_in_motion

from stewart_sym.planning.plan_path import plan_path
from stewart_sym.planning.pose_path import Family, PosePath, ViaPose
from stewart_sym.planning.timing.path_terms import PathLimits, terms_along
from stewart_sym.robot.robot import Robot

ROOM = 2.5
"""Limits of force over the largest force at rest."""


def via_case(seed: int, count: int = 5, friction: bool = True) -> tuple[Robot, tuple[ViaPose, ...]]:
    """A machine without limits, and via poses."""
    robot, motion = machine_in_motion(seed, (count,), friction=friction, load=False)
    return robot, tuple(ViaPose(R, t) for R, t in zip(motion.R, motion.t, strict=True))


def straight(robot: Robot, poses: tuple[ViaPose, ...]) -> PosePath:
    """The spline of least bending."""
    family = Family.of(poses, 1.0)
    free, size = len(family.free), family.rest.shape[1]
    return family.path(family.coefficients(np.zeros(free), np.zeros((size, 7))), robot.tool, np.zeros(6))


def with_limits(robot: Robot, path: PosePath) -> Robot:
    """The machine with limits of force of the path."""
    terms = terms_along(robot, path, np.linspace(0.0, 1.0, 201), PathLimits(acceleration=1.0), "exact")
    return dataclasses.replace(robot, force_limit=ROOM * np.abs(terms.e[:, :6]).max(axis=0))


def limited_case(seed: int, friction: bool = True) -> tuple[Robot, PosePath]:
    """A machine with limits of force and a straight path of via poses."""
    robot, poses = via_case(seed, friction=friction)
    path = straight(robot, poses)
    return with_limits(robot, path), path


def planned_case(seed: int) -> tuple[Robot, PosePath]:
    """A machine with limits of force and a planned path of six via poses."""
    robot, poses = via_case(seed, 6)
    path = plan_path(robot, poses).path
    return with_limits(robot, path), path
