"""Leg limits of force, speed, length, and joint angles, compared with a motion part by part."""

from collections.abc import Iterator, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.arguments import status_text
from ..io.array_types import Array, Flags
from ..kinematics.clearance import angles_from, neutral_directions
from ..motion.motion import Motion
from ..motion.sample_times import elapsed, least_step, time_text
from ..motion.trajectory import Replaced, Trajectory
from ..robot.robot import LEGS, Robot
from ..robot.units import Units
from .effort import trapezoids
from .limit_status import INCONCLUSIVE_REPLACED_ROWS, USED_UP, Beyond, Extremes, amount_text, status_codes
from .noise import Deviations, reached_legs

# Largest number of replaced rows in one line.
_MOST_NAMED = 4


class LegLimit(NamedTuple):
    """Limit of the legs: name, unit, and the quantity (F, L, L_dot, base, or platform) that it limits.

    end: column of the bounds; None for one bound of the magnitude. sign: -1 for a lower bound. unit: SI unit.
    """

    name: str
    unit: str
    values: str
    end: int | None = None
    sign: float = 1.0

    def bound(self, robot: Robot) -> Array:
        """Return the bound of the magnitudes of each leg, shape (6,)."""
        limits: Array = getattr(robot, self.name.partition(" ")[0])
        return limits if self.end is None else self.sign * limits[:, self.end]

    def is_stated(self, robot: Robot) -> bool:
        """Return True if a leg has this limit; a shortest length of 0 is none."""
        bound = self.bound(robot)
        return bool((np.isfinite(bound) & (bound != 0.0)).any())

    def most(self, robot: Robot) -> Array:
        """Return the bound with a tolerance for rounding, shape (6,)."""
        bound = self.bound(robot)
        return np.asarray(bound + USED_UP * np.abs(bound))

    def sizes(self, values: Array) -> Array:
        """Return the values that are compared with the bound, shape (n, 6)."""
        return np.abs(values) if self.end is None else self.sign * values


FORCE, SPEED, LONGEST, SHORTEST, BASE, PLATFORM = LEG_LIMITS = (
    LegLimit("force_limit", "N", "F"),
    LegLimit("speed_limit", "m/s", "L_dot"),
    LegLimit("length_limits", "m", "L", 1),
    LegLimit("length_limits", "m", "L", 0, sign=-1.0),
    LegLimit("joint_angle_limit at the base", "rad", "base", 0),
    LegLimit("joint_angle_limit at the platform", "rad", "platform", 1),
)


def limited_angles(robot: Robot, motion: Motion) -> dict[str, Array]:
    """Return the joint angles at base and platform (rad), (n, 6), or {} if the robot does not limit them.

    Angles are NaN if a leg has no direction.
    """
    if not robot.has_joint_angle_limits:
        return {}
    angles = angles_from(neutral_directions(robot), reached_legs(robot, motion)[2], motion.R)
    return dict(zip(("base", "platform"), angles, strict=True))


def leg_codes(
    robot: Robot, name: str, values: Array, sd: Array | None = None, there: Flags | None = None
) -> NDArray[np.uint8]:
    """Return ``status_codes`` of the values, shape (n, 6); ``sd`` and ``there`` as in ``status_codes``."""
    found = [
        status_codes(limit.sizes(values), limit.most(robot), sd, there)
        for limit in LEG_LIMITS
        if limit.values == name
    ]
    return np.asarray(np.max(found, axis=0))


class LegLimits:
    """Status of the leg limits along a motion, and the time during which they are exceeded."""

    def __init__(self, robot: Robot, time: Array, replaced: tuple[Replaced, ...] = ()) -> None:
        """Start with all times (s), shape (n,); ``replaced`` are the replaced rows of the log."""
        self.robot, self.time, self.replaced = robot, time, replaced
        self.step, self._weights = least_step(time), trapezoids(elapsed(time))
        self._span, self._count = np.zeros((2, len(LEG_LIMITS), LEGS))
        self._extremes = [Extremes() for _ in LEG_LIMITS]

    def add(
        self,
        where: slice,
        values: Mapping[str, Array],
        sd: Deviations | None = None,
        there: Flags | None = None,
    ) -> None:
        """Add F, L, L_dot, and ``limited_angles``, shape (n, 6) each, of some samples.

        ``sd`` and ``there`` are as in ``status_codes``.
        """
        time = self.time[where]
        for k, limit in enumerate(LEG_LIMITS):
            given = values.get(limit.values)
            if given is None or not len(given):
                continue
            sizes = limit.sizes(given)
            over = sizes > limit.most(self.robot)
            self._span[k] += np.sum(self._weights[where, None] * over, axis=0)
            self._count[k] += np.count_nonzero(over, axis=0)
            off = None if sd is None else getattr(sd, limit.values)
            self._extremes[k].add(sizes, partial(_rows, time, given), off, there)

    def exceeded(self) -> list[str]:
        """Return one line for each exceeded or inconclusive limit: legs, worst leg, time, and duration."""
        return [line for _, line in self.told()]

    def told(self) -> Iterator[tuple[str, str]]:
        """Yield the status and the line of each limit, as in ``exceeded``."""
        for k, limit in enumerate(LEG_LIMITS):
            for found in self._extremes[k].beyond(limit.most(self.robot)):
                yield found.verdict, self._line(k, limit, found)

    def _line(self, k: int, limit: LegLimit, found: Beyond) -> str:
        """Return the text about a limit and its legs."""
        worst, (time, values) = found.worst, found.when
        scale, unit = Units.of(self.robot).of_unit(limit.unit)
        bound = scale * limit.sign * limit.bound(self.robot)[worst]
        sd = None if found.sd is None else scale * found.sd
        value = f"{amount_text(scale * values[worst], sd)} {unit}"
        value += f" at {time_text(time, self.step)} s, limit {bound:g} {unit}"
        text = f"{limit.name} {status_text(found.verdict)} by {found.legs_text}: {found.worst_text}{value}"
        if self._count[k, worst]:
            share = f"at {int(self._count[k, worst])} of {len(self.time)} samples"
            text += f"; beyond it for {self._span[k, worst]:.3g} s, {share}"
        text += found.needed_noise(limit.most(self.robot)[worst])
        if found.verdict == INCONCLUSIVE_REPLACED_ROWS and not self._count[k, worst]:
            text += f"; because of replaced rows ({replaced_names(self.replaced)})"
        return text

    def all_verdicts(self) -> list[list[str]]:
        """Return the status of each leg for all limits of the robot."""
        stated = [limit for limit in LEG_LIMITS if limit.is_stated(self.robot)]
        return [self.verdicts(limit) for limit in stated]

    def verdicts(self, limit: LegLimit) -> list[str]:
        """Return the status of each leg."""
        return self._of(limit).verdicts(limit.most(self.robot))

    def peaks(self, limit: LegLimit) -> tuple[Array, Array | None]:
        """Return the largest magnitudes, or extreme lengths, and their standard deviations or None, (6,)."""
        found = self._of(limit)
        return found.peaks if limit.values != "L" else limit.sign * found.largest, found.peak_sd

    def forces(self) -> tuple[Array, Array, Flags, Array | None]:
        """Return times of possible peak forces (s), (k,), the forces (N), (k, 6), ``there``, and ``sd``."""
        when, there, sd = self._of(FORCE).samples
        time, F = zip(*when, strict=True)
        return np.array(time), np.array(F), there, sd

    def _of(self, limit: LegLimit) -> Extremes:
        return self._extremes[LEG_LIMITS.index(limit)]


def replaced_rows(trajectory: Trajectory) -> tuple[Replaced, ...]:
    """Return the rows of its log that a trajectory replaces."""
    return () if trajectory.noise is None else trajectory.noise.replaced


def replaced_names(replaced: tuple[Replaced, ...]) -> str:
    """Return the names of replaced rows as text, shortened if there are many."""
    names = list(dict.fromkeys(name for span in replaced for name in span.rows))
    return ", ".join(names[:_MOST_NAMED]) + (
        f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    )


def _rows(time: Array, values: Array, samples: list[int]) -> list[tuple[float, Array]]:
    # Copy the rows, because a view would keep the whole part in memory.
    return [(float(time[i]), values[i].copy()) for i in samples]
