"""What ``size`` writes: what motions need of every actuator and joint, beside the robot's limits."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from ...design.size import Needs, exceeded, margin_missing
from ...io.array_types import Array
from ...motion.trajectory import PoseLog, Trajectory
from ...robot.robot import LEGS, Robot
from ...viewer.instants import of_trajectory
from ...viewer.view import View
from ..common.output import aligned, csv_text
from ..common.report import Report
from .size_plot import pictures


def report(robot: Robot, sources: Sequence[str], needs: Needs) -> Report:
    """Text, figures for programs, a row for each need as a table, and a picture."""
    text, tables = _text(robot, sources, needs), {"needs": _table(needs)}
    return Report(text, tables, _data(robot, sources, needs), pictures(robot, needs))


def views(
    robot: Robot, sources: Sequence[str], read: Sequence[Trajectory | PoseLog]
) -> dict[str, Callable[[], View]]:
    """What makes the view of each motion; files of the same name get numbers."""
    made: dict[str, Callable[[], View]] = {}
    for number, (source, trajectory) in enumerate(zip(sources, read, strict=True), 1):
        name = f"{source}, motion {number}" if sources.count(source) > 1 else source
        made[name] = functools.partial(_view, robot, trajectory)
    return made


def _view(robot: Robot, trajectory: Trajectory | PoseLog) -> View:
    return View(robot, of_trajectory(robot, trajectory))


def share_text(share: float) -> str:
    """A share of the time in words."""
    return "peak" if share == 1.0 else f"{100.0 * share:g} % of time"


def rows(needs: Needs) -> Iterator[tuple[str, str, Array]]:
    """Name, unit and value for each leg, (6,), of every need, without the margin."""
    of_motor = (("torque", "N m"), ("motor_speed", "rad/s"), ("current", "A"), ("motor_power", "W"))
    for name, unit in (("force", "N"), ("speed", "m/s"), ("power", "W"), *of_motor):
        values = getattr(needs, name)
        for share, at in zip(needs.quantiles, () if values is None else values, strict=values is not None):
            yield f"{name.replace('_', ' ')}, {share_text(float(share))}", unit, at
        if name == "force":
            yield "force, rms", unit, needs.rms_force
            yield "push", unit, needs.push
            yield "pull", unit, needs.pull
        if name == "power":
            yield "power into the leg", unit, needs.driving
            yield "power out of the leg", unit, needs.braking
        if name == "torque" and needs.rms_torque is not None:
            yield "torque, rms", unit, needs.rms_torque
    yield "stroke", "m", needs.stroke
    yield "shortest leg", "m", needs.length[:, 0]
    yield "longest leg", "m", needs.length[:, 1]
    yield "base joint", "degrees", np.degrees(needs.base_angle)
    yield "platform joint", "degrees", np.degrees(needs.platform_angle)


def _text(robot: Robot, sources: Sequence[str], needs: Needs) -> str:
    no_margin = ("shortest leg", "longest leg")
    more = 1.0 + needs.margin
    cells = [
        (
            f"{name}, {unit}",
            *(f"{value:.4g}" for value in values),
            "" if name in no_margin else f"{more * np.nanmax(values):.4g}",
        )
        for name, unit, values in rows(needs)
    ]
    legs = [f"leg {leg + 1}" for leg in range(LEGS)]
    neutral = "the home pose" if robot.home is not None else "the mean direction of each leg"
    lines = [
        f"robot   {robot.name}",
        f"motions {', '.join(sources)}: {needs.course.weight.sum():.6g} s",
        f"margin  {100.0 * needs.margin:g} %: the last column is the largest of a row with it",
        "",
        aligned(("need", *legs, "with margin"), cells),
        "",
        f"Joint angles are from {neutral}.",
    ]
    verdict = [f"Exceeded: {line}" for line in exceeded(robot, needs)]
    verdict += [f"Margin missing: {line}" for line in margin_missing(robot, needs)]
    return "\n".join([*lines, *(verdict or ["Every limit of the robot file suffices."])])


def _data(robot: Robot, sources: Sequence[str], needs: Needs) -> dict[str, Any]:
    names = ("force", "speed", "power", "push", "pull", "rms_force", "driving", "braking", "length", "stroke")
    angles = ("base_angle", "platform_angle")
    motors = ("torque", "motor_speed", "current", "motor_power", "rms_torque")
    units = dict.fromkeys(("force", "push", "pull", "rms_force"), "N")
    units |= dict.fromkeys(("power", "driving", "braking", "motor_power"), "W") | {"speed": "m/s"}
    units |= dict.fromkeys(("length", "stroke"), "m") | dict.fromkeys(angles, "rad")
    units |= {"torque": "N m", "rms_torque": "N m", "motor_speed": "rad/s", "current": "A"}
    found = {name: getattr(needs, name) for name in (*names, *angles, *motors)}
    kept = {name: value for name, value in found.items() if value is not None}
    return {
        "robot": robot.name,
        "motions": list(sources),
        "margin": needs.margin,
        "quantiles": needs.quantiles,
        **kept,
        "exceeded": exceeded(robot, needs),
        "margin_missing": margin_missing(robot, needs),
        "units": {name: units[name] for name in kept},
    }


def _table(needs: Needs) -> str:
    header = ("need", "unit", *(f"leg{leg + 1}" for leg in range(LEGS)))
    return csv_text([header, *((name, unit, *values.tolist()) for name, unit, values in rows(needs))])
