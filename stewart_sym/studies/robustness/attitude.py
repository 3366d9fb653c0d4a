"""Family 4: roll-pitch-yaw angles at theta_y = 90 degrees, compared with inputs without a singularity.

One motion is expressed in each kind of input, with its numbers rounded last. Errors are errors of its forces.
"""

import dataclasses

import numpy as np

from ...backend.numpy_kernel import loaded
from ...dynamics.inverse_dynamics import inverse_dynamics
from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import (
    quaternion_from_rotation,
    quaternion_product,
    rotation_from_rpy,
    vector_from_rotation,
    vector_rate,
    vector_second_rate,
)
from ...precision.truth import Truth, deviation, digits
from .family import Curve, Family, distances
from .sweep.machines import random_machine, random_motion
from .sweep.oracle import check_poses
from .sweep.sweep import condition_of

INPUTS = ("roll-pitch-yaw", "rotation matrix", "quaternion", "rotation vector")
"""Representations of an orientation and its rates."""


def families(seed: int = 4) -> list[Family]:
    """Compute the errors for a pitch near 90 degrees, with the rotation as angles, matrix, quaternion, and
    vector.
    """
    rng = np.random.default_rng(seed)
    robot = random_machine(rng)
    moving = random_motion(rng, robot)
    angles = [np.array([0.3, 0.5 * np.pi - distance, 0.2]) for distance in distances()]
    rates = [_angle_rates(theta, moving) for theta in angles]
    poses = [dataclasses.replace(moving, R=rotation_from_rpy(theta)) for theta in angles]
    checked = check_poses([robot] * len(poses), poses)
    # Rounding of the angle rates changes alpha, and thus the forces, by more than rounding of alpha.
    fastest = np.array([np.abs(second).max() + np.abs(first).max() ** 2 for first, second in rates])
    lost = 1.0 + fastest / np.abs(loaded(moving).alpha).max()
    exact = Truth(robot)
    truths = [exact.forces(pose) for pose in poses]
    curves = []
    for name in INPUTS:
        error = []
        for pose, theta, rate, truth in zip(poses, angles, rates, truths, strict=True):
            given = _rewritten(name, pose, theta, *rate)
            found = inverse_dynamics(robot, given, on_singular="nan").F
            error.append(float(np.abs(deviation(found, truth)).max()))
        condition = condition_of(checked) * (lost if name == INPUTS[0] else 1.0)
        curves.append(Curve(name, np.array(error) / checked["size"], condition, shipped=True))
    second_rate = np.array([np.abs(second).max() for _, second in rates])
    return [
        Family(
            "attitude",
            "Orientation near a pitch of 90 degrees, by kind of input",
            "roll-pitch-yaw at theta_y = 90 degrees",
            "give a rotation matrix, quaternion or rotation vector: they have no singularity; no status",
            "pitch from 90 degrees, rad",
            tuple(curves),
            growth={"largest second rate of the angles": second_rate},
            growth_axis="largest second rate of the angles, rad/s^2",
            notes=(
                f"angles: second rates grow to {second_rate.max():.1e} rad/s^2 for the same motion, and "
                "rounding them moves alpha; no kernel sees angles.",
            ),
        )
    ]


def _rewritten(name: str, pose: Motion, theta: Array, first: Array, second: Array) -> Motion:
    """Convert the motion to another kind of input."""
    given = loaded(pose)
    omega, alpha, a = given.omega, given.alpha, given.a
    load = {"F_ext": pose.F_ext, "M_ext": pose.M_ext}
    if name == "roll-pitch-yaw":
        return Motion.from_rpy(pose.t, theta, pose.v, first, a, second, **load)
    if name == "quaternion":
        e = quaternion_from_rotation(pose.R)
        pure_omega, pure_alpha = (np.concatenate([[0.0], part]) for part in (omega, alpha))
        e_dot = 0.5 * quaternion_product(pure_omega, e)
        e_ddot = 0.5 * (quaternion_product(pure_alpha, e) + quaternion_product(pure_omega, e_dot))
        return Motion.from_quaternion(pose.t, e, pose.v, e_dot, a, e_ddot, **load)
    if name == "rotation vector":
        phi = vector_from_rotation(pose.R)
        phi_dot = vector_rate(phi, omega)
        phi_ddot = vector_second_rate(phi, omega, alpha)
        return Motion.from_rotation_vector(pose.t, phi, pose.v, phi_dot, a, phi_ddot, **load)
    return pose


def _angle_rates(theta: Array, motion: Motion) -> tuple[Array, Array]:
    """Compute theta' and theta'' from omega = E theta', alpha = E theta'' + E' theta' with 50 digits."""
    y, z = (digits.mpf(float(angle)) for angle in theta[1:])
    sy, cy, sz, cz = digits.sin(y), digits.cos(y), digits.sin(z), digits.cos(z)
    E = digits.matrix([[cz * cy, -sz, 0], [sz * cy, cz, 0], [-sy, 0, 1]])
    omega, alpha = (digits.matrix(part.tolist()) for part in (motion.omega, loaded(motion).alpha))
    first = digits.lu_solve(E, omega)
    dy, dz = first[1], first[2]
    E_dot = digits.matrix(
        [
            [-sz * cy * dz - cz * sy * dy, -cz * dz, 0],
            [cz * cy * dz - sz * sy * dy, -sz * dz, 0],
            [-cy * dy, 0, 0],
        ]
    )
    second = digits.lu_solve(E, alpha - E_dot * first)
    return np.array([float(x) for x in first]), np.array([float(x) for x in second])
