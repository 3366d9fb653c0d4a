"""Limits of a robot beside what motions need: exceeded, not decided at the noise of logs, margin missing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..drives.verdicts import EXCEEDED, WITHIN, Sides, amount_text, farthest, verdicts
from ..io.array_types import Array
from ..robot.robot import Robot
from .size import Needs, sides

_DEGREES = 180.0 / np.pi


class _Limited(NamedTuple):
    """A limit: its name, unit, factor from SI to it, sizes and their deviations, (n, 6), and limits, (6,)."""

    name: str
    unit: str
    scale: float
    sizes: Array
    sd: Sides | None
    limits: Array


class _Found(NamedTuple):
    """A verdict on a leg, counted from 0; needed: the size that makes it; sd: None without noise."""

    limited: _Limited
    leg: int
    verdict: str
    needed: float
    sd: float | None

    @property
    def text(self) -> str:
        """What is limited and what is needed, legs numbered from 1."""
        name, unit, scale = self.limited[:3]
        sd = None if self.sd is None else self.sd * scale
        limit = f"{self.limited.limits[self.leg] * scale:g} {unit}"
        needed = f"{amount_text(self.needed * scale, sd)} {unit}"
        return f"{name} of leg {self.leg + 1}: {limit}, needed {needed}"


def exceeded(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that a need exceeds, legs numbered from 1."""
    lines = [each.text for each in _found(robot, needs) if each.verdict == EXCEEDED]
    return lines + [line for verdict, line in _lengths(robot, needs) if verdict == EXCEEDED]


def not_decided(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that noise of a log leaves open, legs numbered from 1."""
    found = [(each.verdict, each.text) for each in _found(robot, needs)] + _lengths(robot, needs)
    return [f"{verdict}: {line}" for verdict, line in found if verdict not in (EXCEEDED, WITHIN)]


def margin_missing(robot: Robot, needs: Needs) -> list[str]:
    """One line for each limit of the robot that suffices, but not with the margin, legs numbered from 1."""
    more = 1.0 + needs.margin
    return [
        f"{each.text}, with the margin {each.needed * more * each.limited.scale:g} {each.limited.unit}"
        for each in _found(robot, needs)
        if each.verdict == WITHIN and each.needed * more > each.limited.limits[each.leg]
    ]


def _found(robot: Robot, needs: Needs) -> Iterator[_Found]:
    for limited in _limited(robot, needs):
        _, _, _, sizes, sd, limits = limited
        there = needs.course.replaced if len(sizes) > 1 else None
        for leg, verdict in enumerate(verdicts(sizes, limits, sd, there)):
            off = None if sd is None else (sd[0][:, leg], sd[1][:, leg])
            # Of limits that are kept the peak is shown, whatever is possible.
            i = farthest(sizes[:, leg], None if verdict == WITHIN else off, verdict)
            yield _Found(
                limited,
                leg,
                verdict,
                float(sizes[i, leg]),
                None if off is None else float(max(off[0][i], off[1][i])),
            )


def _lengths(robot: Robot, needs: Needs) -> list[tuple[str, str]]:
    """Verdict on the lengths of each leg, and a line about them."""
    (low, high), course = robot.length_limits.T, needs.course
    sd = None if course.deviations is None else np.tile(course.deviations["L"], (2, 1))
    there = None if course.replaced is None else np.tile(course.replaced, 2)
    beyond = np.concatenate([low - course.L, course.L - high])
    lines = []
    for i, verdict in enumerate(verdicts(beyond, np.zeros(6), sd, there)):
        off = (None, None) if needs.deviations is None else needs.deviations["length"][i]
        least, most = (amount_text(*each) for each in zip(needs.length[i], off, strict=True))
        limits, needed = f"{low[i]:g} to {high[i]:g} m", f"needed {least} to {most} m"
        lines.append((verdict, f"length_limits of leg {i + 1}: {limits}, {needed}"))
    return lines


def _limited(robot: Robot, needs: Needs) -> Iterator[_Limited]:
    """What a robot may limit."""
    course, drive = needs.course, robot.drive
    low, high = robot.length_limits.T

    def peak(name: str) -> tuple[Array, Sides | None]:
        values = getattr(course, name)
        sizes = np.zeros((1, 6)) if values is None else np.abs(values)
        sd = None if course.deviations is None or values is None else sides(course.deviations, name)
        return sizes, sd

    def whole(need: Array, name: str) -> tuple[Array, Sides | None]:
        sd = None if needs.deviations is None else needs.deviations[name][None]
        return need[None], None if sd is None else (sd, sd)

    yield _Limited("force_limit", "N", 1.0, *peak("F"), robot.force_limit)
    yield _Limited("speed_limit", "m/s", 1.0, *peak("L_dot"), robot.speed_limit)
    yield _Limited("stroke", "m", 1.0, *whole(needs.stroke, "stroke"), high - low)
    for end, limits in zip(("base", "platform"), robot.joint_angle_limit.T, strict=True):
        yield _Limited(f"joint_angle_limit at the {end}", "degrees", _DEGREES, *peak(end), limits)
    if drive is not None and needs.rms_torque is not None:
        rms = whole(needs.rms_torque, "rms_torque")
        yield _Limited("drive.torque_limit", "N m", 1.0, *peak("torque"), np.asarray(drive.torque_limit))
        yield _Limited("drive.rated_torque", "N m", 1.0, *rms, np.asarray(drive.rated_torque))
        yield _Limited("drive.speed_limit", "rad/s", 1.0, *peak("motor_speed"), np.asarray(drive.speed_limit))
        yield _Limited("drive.current_limit", "A", 1.0, *peak("current"), np.asarray(drive.current_limit))
        yield _Limited("drive.power_limit", "W", 1.0, *peak("motor_power"), np.asarray(drive.power_limit))
