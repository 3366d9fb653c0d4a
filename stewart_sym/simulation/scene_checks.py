"""Plausibility checks of the initial state of a scene: units, and assembly mode."""

import numpy as np

from ..kinematics.inverse_kinematics import leg_lengths
from ..kinematics.mounting_side import platform_side
from ..kinematics.trajectory_checks import LEAST_TURN, MOST_TURNS, impossible, meters_doubt
from ..motion.rotation import rotation_from_rpy
from ..robot.fields import DEFAULT_GRAVITY, vector_text
from .scene import Scene

# Ratio of an initial speed to the speed of a fall above which the speed is implausible.
_MOST_FALLS = 5.0


def start_doubts(scene: Scene) -> list[str]:
    """Return warnings, each with its key, about an implausible initial state or implausible springs."""
    robot, state, stated = scene.robot, scene.state, scene.stated
    L = leg_lengths(robot, state.R, state.t)
    # The reader of a path file has already issued warnings about the path.
    lengths = {"state.t": L} if "state.t" in stated else {}
    lengths |= {key: stated[key] for key in ("actuation.rest_length",) if key in stated}
    found = {key: doubt for key, each in lengths.items() if (doubt := meters_doubt(robot, each))}
    lines = [f"{key}: {doubt}" for key, doubt in found.items()]
    side, start = platform_side(robot), "state.t"
    center = state.t + state.R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)
    if start in stated and start not in found and side.certain and center @ side.direction < 0.0:
        lines.append(
            f"{start}: the platform starts on the other side of the base than "
            f"{vector_text(side.direction + 0.0)}, {side.rule}: does z point the other way than in the "
            "robot file?"
        )
    theta = stated.get("state.theta", np.zeros(3))
    if start not in found and np.abs(theta).max() > LEAST_TURN:
        turns = [rotation_from_rpy(np.stack([np.zeros(3), each])) for each in (theta, np.radians(theta))]
        how, degrees = (impossible(robot, np.stack([state.t, state.t]), R) for R in turns)
        if np.any(np.abs(theta) > MOST_TURNS) or (how is not None and degrees is None):
            axis = int(np.argmax(np.abs(theta)))
            text = f"{theta[axis]:.4g} rad about {'xyz'[axis]}: in degrees, expected radians?"
            lines.append(f"state.theta: {text}")
    length = float(np.median(L))
    fall = float(np.sqrt(2.0 * abs(DEFAULT_GRAVITY[2]) * length))
    for name, unit, other, usual in (
        ("v", "m/s", "in mm/s", fall),
        ("omega", "rad/s", "in degrees/s", fall / length),
    ):
        speed = float(np.linalg.norm(stated.get(f"state.{name}", 0.0)))
        if speed > _MOST_FALLS * usual:
            times = f"{speed / usual:.2g} times what a fall through the length of a leg gives"
            lines.append(f"state.{name}: {speed:.4g} {unit}, {times}: {other}, expected {unit}?")
    return lines
