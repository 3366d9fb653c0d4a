"""Machines near the joint singularity of a leg, and what a rounding unit of every number does to each answer.

Truth is the closed form in ``long double`` with the sensitivity that the stability study measures.
"""

import dataclasses
import math

import numpy as np
from leaning_legs import leaning
from machines import Array, machine_in_motion

import stewart_sym as ss
from stewart_sym.dynamics.closed_form import OUTPUTS
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.robustness.oracle import cases_of, truth_of

EPSILON = np.finfo(np.float64).eps
KINDS = (
    *("lean", "two lean", "all lean", "short", "heavy", "short and heavy", "lean and heavy"),
    *("axisymmetric", "slender"),
)
BLOCKS = {f"{what}.{name}": shape for what, parts in OUTPUTS.items() for name, shape in parts.items()}
"""Every output, with the shape of a pose's part."""


def shortened(robot: Robot, motion: Motion, leg: int, length: float) -> Robot:
    """The machine with the base point of a leg moved along the leg until it is this long, m."""
    found = ss.inverse_kinematics(robot, motion)
    b = robot.b.copy()
    b[leg] += (found.L[leg] - length) * found.s[leg]
    return dataclasses.replace(robot, b=b)


def heavier(robot: Robot, leg: int, times: float) -> Robot:
    """The machine with the masses and inertias of a leg multiplied."""
    parts = {name: getattr(robot, name).copy() for name in ("m_d", "m_u", "I_d0", "I_u0")}
    for part in parts.values():
        part[leg] *= times
    return dataclasses.replace(robot, **parts)


def axisymmetric(robot: Robot, axial_inertia: float) -> Robot:
    """The machine with legs that are axisymmetric, their axial inertias times a number."""
    I_d0, I_u0 = (
        np.array([np.diag([axial_inertia * own[0, 0], own[1, 1], own[1, 1]]) for own in each])
        for each in (robot.I_d0, robot.I_u0)
    )
    axial = np.array([1.0, 0.0, 0.0])
    return dataclasses.replace(robot, I_d0=I_d0, I_u0=I_u0, r_d0=robot.r_d0 * axial, r_u0=robot.r_u0 * axial)


def random_case(rng: np.random.Generator, kind: str, deepest: float = 12.0) -> tuple[Robot, Motion, Array]:
    """A machine near a degenerate leg, its motion and actuator forces of the size that the motion needs."""
    robot, motion = machine_in_motion(rng, friction=bool(rng.integers(2)))
    if rng.integers(4) == 0:
        motion = dataclasses.replace(motion, omega=np.zeros(3), v=np.zeros(3))
    sine = 10 ** -rng.uniform(0.0, deepest)
    legs = rng.permutation(6)[: {"two lean": 2, "all lean": 6}.get(kind, 1)]
    if kind in ("axisymmetric", "slender"):
        robot = axisymmetric(robot, float(kind == "axisymmetric"))
    if "short" in kind:
        robot = shortened(robot, motion, legs[0], 10 ** -rng.uniform(0.0, 7.0))
    if kind not in ("short", "heavy", "short and heavy"):
        for leg in legs:
            share = 1 if leg == legs[0] else rng.uniform(0.1, 1)
            robot = leaning(robot, motion, sine * share, leg, rng.normal(size=3))
    if "heavy" in kind:
        robot = heavier(robot, legs[0], 10 ** rng.uniform(0.0, 6.0))
    F = ss.inverse_dynamics(robot, motion).F
    return robot, motion, F + 0.1 * np.abs(F).max() * rng.normal(size=6)


@dataclasses.dataclass(frozen=True, eq=False)
class Truth:
    """Status of each function, and by output the value in long double, and the sensitivity."""

    status: dict[str, int]
    value: dict[str, Array]
    sensitivity: dict[str, Array]


def truth(robot: Robot, motion: Motion, F: Array, samples: int = -1) -> Truth:
    """Every output in long double, and what one rounding unit of each input number does to it.

    samples: -1 for the sum over all numbers of absolute changes; else that many changes of all at once with
    random signs, the largest of which is taken: never more than the sum, and cheaper.
    """
    cases = dataclasses.replace(cases_of([robot], [motion]), forces=F[None])
    status, value, sensitivity = {}, {}, {}
    for what, parts in OUTPUTS.items():
        found = truth_of(cases, what, samples=samples)
        status[what] = int(found.status[0])
        ends = np.cumsum([math.prod(shape) for shape in parts.values()])[:-1]
        for name, values, changes in zip(
            parts, np.split(found.values[0], ends), np.split(found.change[0], ends), strict=True
        ):
            value[f"{what}.{name}"], sensitivity[f"{what}.{name}"] = values, EPSILON * changes
    return Truth(status, value, sensitivity)


def blocks(name: str, value: Array) -> list[Array]:
    """Parts of an output that have one unit: threes of rows and of columns, but where these are legs."""
    value = value.reshape(BLOCKS[name])
    what, _, output = name.partition(".")
    rows = [value] if what in ("derivatives", "joint_inertia") else np.split(value, len(value) // 3)
    if value.ndim == 1 or what == "joint_inertia" or output in ("B", "H", "H_dot"):
        return rows
    return [part for row in rows for part in np.split(row, value.shape[1] // 3, axis=1)]


def excess(true: Truth, found: dict[str, Array]) -> dict[str, float]:
    """Error of each output over the sensitivity, the worst of its blocks: inf where it is not finite."""
    worst = {}
    for name, value in found.items():
        error = np.abs(np.ravel(value) - true.value[name])
        sizes = (error, true.sensitivity[name], np.abs(true.value[name]))
        parts = zip(*(blocks(name, each) for each in sizes), strict=True)
        ratios = [_ratio(e, max(s.max(), EPSILON * v.max())) for e, s, v in parts]
        worst[name] = max(ratios)
    return worst


def _ratio(error: Array, allowed: float) -> float:
    if not np.isfinite(error).all():
        return np.inf
    return float(error.max() / allowed) if allowed > 0 else float(0 if error.max() == 0 else np.inf)


def of_reference(robot: Robot, motion: Motion, F: Array) -> tuple[dict[str, Array], dict[str, int]]:
    """What the vector reference has of the same, by the same names, and each function's status."""
    terms = ss.equations_of_motion(robot, motion, backend="reference", on_singular="nan")
    inertia = ss.joint_space_inertia(robot, motion, backend="reference", on_singular="nan")
    a, alpha = ss.forward_dynamics(robot, motion, F, backend="reference", on_singular="nan")
    found = {
        f"equations.{name}": getattr(terms, name)
        for name in ("M", "C", "g", "friction", "bias", "bias_and_friction")
    }
    found |= {
        "bias_and_friction.bias_and_friction": terms.bias_and_friction,
        "joint_inertia.inertia": inertia,
    }
    found |= {"forward_dynamics.acceleration": np.concatenate([a, alpha])}
    status = dict.fromkeys(
        ("equations", "bias_and_friction", "joint_inertia", "forward_dynamics"), int(terms.status)
    )
    return found, status
