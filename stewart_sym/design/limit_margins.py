"""Comparison of a robot's limits with actuator requirements, without and with the margin."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..drives.limit_status import EXCEEDED, WITHIN, amount_text, limit_status
from ..drives.limits import RATED, Limit, LimitTracker, limits_of
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .actuator_requirements import NAMES, ActuatorHistory, ActuatorRequirementsResult


class LimitMargins(NamedTuple):
    """Texts about limits that are exceeded or may be exceeded, without and with the margin."""

    exceeded: list[str]
    inconclusive: list[str]
    margin_missing: list[str]
    margin_inconclusive: list[str]

    def add(self, verdict: str, line: str, margin: str = "") -> None:
        """Add the status of a limit; ``margin`` precedes the status if it includes the margin."""
        sure, possible = self[2:] if margin else self[:2]
        if verdict == EXCEEDED:
            sure.append(line)
        elif verdict != WITHIN:
            possible.append(f"{margin}{verdict.replace('_', ' ')}: {line}")


def compared(robot: Robot, needs: ActuatorRequirementsResult) -> LimitMargins:
    """Compare the requirements with the robot's limits; limits that are sufficient also with the margin."""
    found, more, units = LimitMargins([], [], [], []), 1.0 + needs.margin, Units.of(robot)
    tracker = _tracker(robot, needs.history)
    for limit in limits_of(robot):
        alone, margin = (tracker.verdicts(limit, *share) for share in ((), (1.0 / more - 1.0,)))
        for leg in range(LEGS):
            if alone[leg] != WITHIN:
                found.add(alone[leg], _line(tracker, limit, leg, alone[leg]))
            elif limit.values != "L":
                found.add(margin[leg], _line(tracker, limit, leg, margin[leg], more), "margin ")
    scale, unit = units.of_unit("m")
    stroke, limits = needs.stroke, np.ptp(robot.length_limits, axis=1)
    # A stroke beyond the limits exceeds a limit of the lengths, which is listed.
    most = np.where(stroke > limits, np.inf, limits)
    std = None if needs.std is None else more * needs.std["stroke"][None]
    for leg, verdict in enumerate(limit_status(more * stroke[None], most, std)):
        needed, both = (f"{scale * share * stroke[leg]:.6g} {unit}" for share in (1.0, more))
        line = f"stroke of leg {leg + 1}: {scale * limits[leg]:g} {unit}, needed {needed}"
        found.add(verdict, f"{line}, with the margin {both}", "margin ")
    return found


def states_limits(robot: Robot) -> bool:
    """Return True if the robot has a limit that requirements can exceed."""
    return any(limit.is_stated(robot) for limit in limits_of(robot))


def _tracker(robot: Robot, course: ActuatorHistory) -> LimitTracker:
    """Return the status of the limits over all samples."""
    tracker = LimitTracker(robot, None, weights=course.time_weight)
    names = {limit.values for limit in limits_of(robot) if limit is not RATED}
    values = {name: getattr(course, NAMES.get(name, name)) for name in names}
    std = course.std
    if std is not None:
        std = {**std, **{name: std[key] for name, key in NAMES.items() if key in std}}
    tracker.add(slice(None), values, std, course.replaced)
    return tracker


def _line(tracker: LimitTracker, limit: Limit, leg: int, verdict: str, more: float | None = None) -> str:
    """Return the text of a limit with the requirement that determines its status.

    ``more`` is the factor of the margin.
    """
    scale, unit = tracker.units.of_unit(limit.unit)
    _, _, value, sd = tracker.worst(limit, verdict, [leg])

    def amount(share: float) -> str:
        return f"{amount_text(share * abs(value), None if sd is None else share * sd)} {unit}"

    bound = scale * limit.sign * limit.bound(tracker.robot)[leg]
    line = f"{limit.name} of leg {leg + 1}: {bound:g} {unit}, needed {amount(scale)}"
    return line if more is None else f"{line}, with the margin {amount(more * scale)}"
