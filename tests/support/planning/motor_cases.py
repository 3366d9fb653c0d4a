"""Machines with drives whose limits bind along a path."""

import dataclasses
from functools import cache

import numpy as np
from machines import machine_size
from via_cases import straight, via_case, with_limits

from stewart_sym.drives.effort import DriveEffortResult, drive_effort
from stewart_sym.planning.path_parameterization import parameterize_path
from stewart_sym.planning.pose_path import PosePath
from stewart_sym.planning.timing.path_terms import PathLimits, terms_along
from stewart_sym.robot.drive import Drive
from stewart_sym.robot.robot import Robot

QUANTITIES = ("torque", "speed", "current", "power")


@cache
def unlimited_case(seed: int) -> tuple[Robot, PosePath, DriveEffortResult]:
    """A machine whose drives have no limits, a path, and what the fastest motion takes of the motors."""
    rng = np.random.default_rng(100 + seed)
    robot, poses = via_case(seed)
    path = straight(robot, poses)
    robot = with_limits(robot, path)
    force = robot.force_limit
    lead = 0.01 * float(np.linalg.norm(robot.b, axis=-1).mean())
    turns = 2.0 * np.pi / lead
    mass = robot.m_u.mean() * rng.uniform(0.05, 0.3)
    free = parameterize_path(robot, path, grid_size=50)
    speed = np.abs(free.sample(np.linspace(0.0, free.duration, 400)).v).max()
    drive = Drive(
        lead=lead * rng.permutation([1, 1, 1, -1, -1, -1]),
        rotor_inertia=mass / turns**2,
        efficiency=rng.uniform(0.6, 0.95, 6),
        backdrive_efficiency=rng.uniform(0.3, 0.9, 6),
        screw_coulomb=0.02 * force,
        motor_viscous=0.02 * force.mean() / speed / turns**2,
        motor_coulomb=0.01 * force / turns,
        stribeck_force=0.01 * force,
        stribeck_speed=0.05 * speed,
        regularization_speed=0.0 if seed % 2 else 0.02 * speed,
        torque_constant=0.1,
        resistance=0.2,
    )
    robot = dataclasses.replace(robot, drive=drive)
    free = parameterize_path(robot, path, grid_size=50)
    times = np.linspace(0.0, free.duration, 801)
    return robot, path, drive_effort(robot, free.sample(times), times)


def motor_case(seed: int, binding: tuple[str, ...] = QUANTITIES) -> tuple[Robot, PosePath]:
    """A machine whose motors' limits are below what its fastest motion within limits of force takes."""
    robot, path, found = unlimited_case(seed)
    assert robot.drive is not None
    weight = 2.0 * robot.force_limit / np.abs(robot.drive.transmission_ratio)
    shares = {"torque": 0.9, "current": 0.85, "speed": 0.8, "power": 0.6}
    limits = {f"{name}_limit": shares[name] * getattr(found, f"peak_{name}") for name in binding}
    for name, unit in (("torque", 1.0), ("current", 0.1)):
        if name in binding:
            limits[f"{name}_limit"] = np.maximum(limits[f"{name}_limit"], weight / unit / 2.5 * 1.1)
    return dataclasses.replace(robot, drive=dataclasses.replace(robot.drive, **limits)), path


def sweep_case(seed: int) -> tuple[Robot, PosePath]:
    """A machine whose drives have every term, limits above what slow motion takes, and a path.

    One path in four goes straight up or down, one in four from pose to pose, the others through more. From
    seed 100 on the motors are strong: forces through the screws change their signs.
    """
    rng = np.random.default_rng(7000 + seed)
    robot, poses = via_case(seed, count=(2, 2, 3, 5)[seed % 4])
    if seed % 4 == 0:
        up = np.array([0.0, 0.0, rng.uniform(0.05, 0.2) * machine_size(robot)])
        poses = (poses[0], dataclasses.replace(poses[0], t=poses[0].t + rng.choice([-1.0, 1.0]) * up))
    path = straight(robot, poses)
    robot = with_limits(robot, path)
    size, force = machine_size(robot), robot.force_limit
    lead, speed = 0.01 * size, np.sqrt(size * np.linalg.norm(robot.g))
    turns, loss = 2.0 * np.pi / lead, rng.uniform(0.0, 0.04, 4)
    drive = Drive(
        lead=lead * rng.permutation([1, 1, 1, -1, -1, -1]),
        rotor_inertia=robot.m_u.mean() * rng.uniform(0.05, 0.3) / turns**2,
        efficiency=rng.uniform(0.6, 0.95, 6),
        backdrive_efficiency=rng.uniform(0.3, 0.9, 6),
        screw_coulomb=loss[0] * force,
        motor_viscous=loss[1] * force.mean() / speed / turns**2,
        motor_coulomb=loss[2] * force / turns,
        stribeck_force=loss[3] * force * (seed % 3 > 0),
        stribeck_speed=0.05 * speed,
        regularization_speed=0.02 * speed * (seed % 5 == 0),
        torque_constant=0.1,
        resistance=0.2,
    )
    robot = dataclasses.replace(robot, drive=drive)
    terms = terms_along(robot, path, np.linspace(0.0, 1.0, 201), PathLimits(), "exact", motors=True)
    assert terms.motors is not None
    held = terms.motors._replace(effort=np.ones(6)).at_rest()[:, :6].max(axis=0)
    strong = 1.0 if seed < 100 else 3.0
    torque = strong * rng.uniform(1.2, 2.0, 6) * held / turns
    limits = {
        "torque_limit": torque,
        "current_limit": torque / 0.1 * rng.uniform(0.95, 1.1, 6),
        "speed_limit": turns * speed * strong * rng.uniform(0.2, 1.0, 6),
        "power_limit": torque * turns * speed * rng.uniform(0.1, 0.6, 6),
    }
    drive = dataclasses.replace(drive, **limits)
    return dataclasses.replace(robot, drive=drive, force_limit=strong * force), path
