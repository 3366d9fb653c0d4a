"""Families 2 and 3: a leg along the fixed axis of its universal joint, of length zero, or at a length
limit.
"""

import dataclasses
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from ...io.array_types import Array
from ...kinematics.forward_kinematics import forward_kinematics
from ...kinematics.inverse_kinematics import leg_vectors
from ...motion.motion import Motion, at_rest
from ...precision.truth import digits
from ...results import OK, OUT_OF_LIMITS
from ...robot.robot import Robot
from . import shipped
from .family import Curve, Family, distances, exact
from .sweep.machines import LEGS, random_machine, random_motion
from .sweep.oracle import check_poses
from .sweep.sweep import condition_of

FAILS = "leg along its universal joint's fixed axis"


def axis_families(seed: int = 2) -> list[Family]:
    """Return the families near the joint singularity.

    The first family is the spin of a leg by the method for its sine. The others are the forces of a general
    machine in motion and at rest, and the closed form for the moving machine.
    """
    moving = _walk(seed, LEGS[0], rest=False)
    resting = _walk(seed, LEGS[1], rest=True)
    return [
        _spin(*moving),
        _forces(moving, resting),
        _family(
            "joint_singularity_at_rest",
            "Forces near a leg's joint singularity, axisymmetric legs at rest: well conditioned",
            "status 3 if the sine is at rounding level",
            shipped.curves(*resting),
            fails=f"{FAILS}, at rest",
        ),
        _family(
            "joint_singularity_closed_form",
            "Equations of motion, forward dynamics and derivatives near a leg's joint singularity",
            "forward dynamics solved in joint coordinates; status 3 if the sine is at rounding level",
            shipped.closed_form_curves(*moving),
            error_axis="error over each output's size",
        ),
    ]


def _family(
    name: str, title: str, remedy: str, curves: tuple[Curve, ...], fails: str = FAILS, **more: Any
) -> Family:
    """Return a family over the angle between a leg and its fixed axis; ``more`` are further fields."""
    axis = "angle between leg 1 and its fixed axis, rad"
    return Family(name, title, fails, remedy, axis, curves, **more)


def _walk(seed: int, legs: str, rest: bool) -> tuple[list[Robot], list[Motion]]:
    """Rotate the fixed axis of the first leg of a machine toward the leg."""
    rng = np.random.default_rng(seed)
    robot = random_machine(rng, legs=legs)
    motion = random_motion(rng, robot)
    if rest:
        motion = at_rest(motion.R, motion.t, motion.F_ext, motion.M_ext)
    _, S, L = leg_vectors(robot, motion.R, motion.t)
    s = S[0] / L[0]
    across = np.cross(s, robot.k[0])
    across /= np.linalg.norm(across)
    robots = []
    for distance in distances():
        k = robot.k.copy()
        k[0] = np.cos(distance) * s + np.sin(distance) * across
        robots.append(dataclasses.replace(robot, k=k))
    return robots, [motion] * len(robots)


def _forces(moving: tuple[list[Robot], list[Motion]], resting: tuple[list[Robot], list[Motion]]) -> Family:
    checked, calm = check_poses(*moving), check_poses(*resting)
    growth = {
        "largest force, moving, N": checked["size"],
        "largest force, axisymmetric at rest, N": calm["size"],
        "condition, moving": condition_of(checked),
        "condition, axisymmetric at rest": condition_of(calm),
    }
    fastest = float(checked["size"].max() / checked["size"][0])
    return _family(
        "joint_singularity_forces",
        "Forces near a leg's joint singularity, moving machine",
        "sine and frame from k x s; status 3 if the sine is at rounding level",
        shipped.curves(*moving),
        growth=growth,
        growth_axis="largest force, N, and condition number",
        notes=(
            f"physics: the moving machine's largest force grows {fastest:.1e}-fold, for the leg must "
            f"spin ever faster; at rest with axisymmetric legs it changes by "
            f"{float(np.ptp(calm['size']) / calm['size'][0]):.1e} of itself.",
        ),
    )


def _spin(robots: list[Robot], motions: list[Motion]) -> Family:
    truth = [_exact_spin(robot, motion) for robot, motion in zip(robots, motions, strict=True)]
    curves = []
    for name in SINES:
        error = np.full(len(robots), np.nan)
        for i, (robot, motion, (spin, _)) in enumerate(zip(robots, motions, truth, strict=True)):
            with np.errstate(all="ignore"):
                found = _spin_of(robot, motion, name)
            if np.isfinite(found):
                error[i] = float(abs(digits.mpf(float(found)) - spin) / abs(spin))
        condition = np.array([float(1 / k_3) for _, k_3 in truth])
        curves.append(Curve(name, error, condition))
    title = "Spin of a leg near its joint singularity, by how the sine is computed"
    return _family("joint_sine", title, "", tuple(curves), error_axis="error over the spin")


def _from_product(k: Array, s: Array) -> float:
    return float(np.linalg.norm(np.cross(k, s)))


SINES: dict[str, Callable[[Array, Array], float]] = {
    "sqrt(1 - (k.s)^2)": lambda k, s: float(np.sqrt(1.0 - (k @ s) ** 2)),
    "|k x s|": _from_product,
    "|k x s|, y made normal to s": _from_product,
}
"""Methods for the sine of the angle between a leg and its fixed axis."""


def _spin_of(robot: Robot, motion: Motion, name: str) -> float:
    """Compute s.W of leg 1: kappa Wz with kappa = k.s/|k x s| and Wz = y.Sdot/L."""
    q, S, L = leg_vectors(robot, motion.R, motion.t)
    k, s = robot.k[0], S[0] / L[0]
    S_dot = motion.v + np.cross(motion.omega, q[0])
    k_3 = SINES[name](k, s)
    y = np.cross(k, s) / k_3
    if name.endswith("normal to s"):
        y = y - (y @ s) * s
        y = y / np.linalg.norm(y)
    return float((k @ s) / k_3 * (y @ S_dot) / L[0])


def _exact_spin(robot: Robot, motion: Motion) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Compute the spin and the sine from the same numbers in 50-digit arithmetic."""
    given = (robot.k[0], robot.p[0], robot.b[0], motion.R, motion.t, motion.omega, motion.v)
    k, p, b, R, t, omega, v = map(exact, given)
    q = R @ p
    S = q + t - b
    L = digits.sqrt(S @ S)
    s = S / L
    normal = np.cross(k, s)
    k_3 = digits.sqrt(normal @ normal)
    return k @ s / k_3 * (normal @ (v + np.cross(omega, q))) / k_3 / L, k_3


# --- lengths ----------------------------------------------------------------------------------


def length_families(seed: int = 3) -> list[Family]:
    """Return the families of a leg of length zero, and of lengths increasingly close to a limit on both
    sides.
    """
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
        "Forces as a leg's length approaches zero",
        "leg of length zero",
        "status 2 if the length is at the rounding level of its terms",
        "length of leg 1, m",
        shipped.curves(robots, motions),
        growth={"condition of the pose": shipped.pose_condition(robots, motions)},
        growth_axis="condition number",
    )


def _limits(seed: int) -> Family:
    """Compute forward kinematics near a length limit; the error is 0 for the correct status, else 1."""
    rng = np.random.default_rng(seed)
    robot = random_machine(rng)
    motion = random_motion(rng, robot)
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
        "Leg lengths next to a limit",
        "leg length at its limit",
        "status 8 in forward kinematics, from the first rounding unit on",
        "share of the length to the limit",
        tuple(curves),
        error_axis="status of forward kinematics",
        by_status=True,
    )
