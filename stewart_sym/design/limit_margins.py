"""Comparison of a robot's limits with actuator requirements, without and with the margin."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..drives.limit_status import EXCEEDED, WITHIN, Sides, amount_text, farthest, limit_status, sides
from ..drives.limits import LONGEST, RATED, limits_of
from ..io.array_types import Array
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .actuator_requirements import ActuatorRequirementsResult


class _Limited(NamedTuple):
    """Limit: name, SI unit, magnitudes and standard deviations (n, 6), and values (6,)."""

    name: str
    unit: str
    sizes: Array
    sd: Sides | None
    limits: Array


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
    for limited in _limited(robot, needs):
        there = needs.history.replaced if len(limited.sizes) > 1 else None
        alone, margin = (
            limit_status(limited.sizes, limited.limits / share, limited.sd, there) for share in (1.0, more)
        )
        for leg in range(LEGS):
            if alone[leg] == WITHIN:
                found.add(margin[leg], _line(limited, leg, margin[leg], units, more), "margin ")
            else:
                found.add(alone[leg], _line(limited, leg, alone[leg], units))
    for verdict, line in _lengths(robot, needs):
        found.add(verdict, line)
    return found


def states_limits(robot: Robot, needs: ActuatorRequirementsResult) -> bool:
    """Return True if the robot has a limit that requirements can exceed."""
    shortest = bool(np.any(robot.length_limits[:, 0] > 0.0))
    return shortest or any(np.isfinite(each.limits).any() for each in _limited(robot, needs))


def _line(limited: _Limited, leg: int, verdict: str, units: Units, more: float | None = None) -> str:
    """Return the text of a limit with the requirement that determines its status.

    ``more`` is the factor of the margin.
    """
    name, si_unit, sizes, sd, limits = limited
    scale, unit = units.of_unit(si_unit)
    off = None if sd is None else (sd[0][:, leg], sd[1][:, leg])
    i = int(farthest(sizes[:, leg], off, verdict))

    def amount(share: float) -> str:
        one = None if off is None else share * float(max(off[0][i], off[1][i]))
        return f"{amount_text(share * float(sizes[i, leg]), one)} {unit}"

    line = f"{name} of leg {leg + 1}: {limits[leg] * scale:g} {unit}, needed {amount(scale)}"
    return line if more is None else f"{line}, with the margin {amount(more * scale)}"


def _lengths(robot: Robot, needs: ActuatorRequirementsResult) -> Iterator[tuple[str, str]]:
    """Yield the status of each leg's length limits and a text."""
    (low, high), course = robot.length_limits.T, needs.history
    scale, unit = Units.of(robot).of_unit("m")
    sd = None if course.std is None else np.tile(course.std["L"], (2, 1))
    there = None if course.replaced is None else np.tile(course.replaced, 2)
    beyond = np.concatenate([low - course.L, course.L - high])
    for leg, verdict in enumerate(limit_status(beyond, np.zeros(LEGS), sd, there)):
        off = (None, None) if needs.std is None else needs.std["length"][leg]
        least, most = (
            amount_text(scale * end, None if spread is None else scale * spread)
            for end, spread in zip(needs.length[leg], off, strict=True)
        )
        limits = f"{scale * low[leg]:g} to {scale * high[leg]:g} {unit}"
        yield verdict, f"length_limits of leg {leg + 1}: {limits}, needed {least} to {most} {unit}"


_FIELDS = {"base": "base_angle", "platform": "platform_angle", "speed": "motor_speed", "power": "motor_power"}
"""Fields of ``ActuatorHistory`` whose names differ from the names of limited quantities."""


def _limited(robot: Robot, needs: ActuatorRequirementsResult) -> Iterator[_Limited]:
    """Yield the limits that a robot may have, except lengths."""
    std, (low, high) = needs.std or {}, robot.length_limits.T
    for limit in limits_of(robot):
        name, course = _FIELDS.get(limit.values, limit.values), needs.history
        if limit is LONGEST:
            yield _Limited("stroke", "m", needs.stroke[None], _row(std.get("stroke")), high - low)
            continue
        if limit is RATED and needs.rms_torque is not None:
            sizes, sd = needs.rms_torque[None], _row(std.get(name))
        elif limit is RATED or limit.values == "L" or getattr(course, name) is None:
            continue
        else:
            sizes, sd = np.abs(getattr(course, name)), sides(course.std, name)
        yield _Limited(limit.name, limit.unit, sizes, sd, limit.bound(robot))


def _row(sd: Array | None) -> Sides | None:
    return None if sd is None else (sd[None], sd[None])
