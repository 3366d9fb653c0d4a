"""Limits of the legs and of the motors, compared with a motion part by part."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..io.arguments import real_array
from ..io.array_types import Array, Flags
from ..kinematics.clearance import angles_from, neutral_directions
from ..motion.motion import Motion
from ..motion.sample_times import elapsed, least_step, time_text
from ..motion.trajectory import Replaced, Trajectory
from ..robot.robot import LEGS, Robot, legs_text
from ..robot.units import Units
from .limit_status import (
    EXCEEDED,
    INCONCLUSIVE_NOISE,
    INCONCLUSIVE_REPLACED_ROWS,
    SURE,
    USED_UP,
    VERDICTS,
    Extremes,
    amount_text,
    sides,
    status_codes,
)
from .noise import reached_legs

# Largest number of replaced rows in one line.
_MOST_NAMED = 4


class Limit(NamedTuple):
    """Limit of the legs or motors: name, SI unit, and the quantity that it limits.

    end: column of the bounds; None for one bound of the magnitude. sign: -1 for a lower bound. what: name of
    the quantity in messages, if the name of the limit is not enough.
    """

    name: str
    unit: str
    values: str
    end: int | None = None
    sign: float = 1.0
    what: str = ""

    def bound(self, robot: Robot) -> Array:
        """Return the bound of the magnitudes of each leg, shape (6,)."""
        part, _, name = self.name.partition(" ")[0].rpartition(".")
        limits = np.asarray(getattr(getattr(robot, part) if part else robot, name))
        return limits if self.end is None else self.sign * limits[:, self.end]

    def is_stated(self, robot: Robot) -> bool:
        """Return True if a leg has this limit; a shortest length of 0 is none."""
        bound = self.bound(robot)
        return bool((np.isfinite(bound) & (bound != 0.0)).any())

    def most(self, robot: Robot, tolerance: float = USED_UP) -> Array:
        """Return the bound with a relative tolerance, by default for rounding, shape (6,)."""
        bound = self.bound(robot)
        return np.asarray(bound * (1.0 + tolerance * np.sign(bound)))

    def sizes(self, values: Array) -> Array:
        """Return the values that are compared with the bound, shape (n, 6)."""
        return np.abs(values) if self.end is None else self.sign * values


FORCE, SPEED, LONGEST, SHORTEST, BASE, PLATFORM = LEG_LIMITS = (
    Limit("force_limit", "N", "F"),
    Limit("speed_limit", "m/s", "L_dot"),
    Limit("length_limits", "m", "L", 1),
    Limit("length_limits", "m", "L", 0, sign=-1.0),
    Limit("joint_angle_limit at the base", "rad", "base", 0),
    Limit("joint_angle_limit at the platform", "rad", "platform", 1),
)
PEAKS = {"torque": "N m", "speed": "rad/s", "current": "A", "power": "W"}
"""Motor quantities with a limit of their magnitude, and their units."""
RATED = Limit("drive.rated_torque", "N m", "rms_torque", what="root mean square of torque ")
# The prefix distinguishes drive.speed_limit from the speed limit of the legs.
MOTOR_LIMITS = {
    name: Limit(f"drive.{name}_limit", unit, name, what=f"{name} ") for name, unit in PEAKS.items()
} | {"rated_torque": RATED}


def limits_of(robot: Robot) -> tuple[Limit, ...]:
    """Return the limits that the robot may have."""
    return LEG_LIMITS if robot.drive is None else (*LEG_LIMITS, *MOTOR_LIMITS.values())


def limited_angles(robot: Robot, motion: Motion) -> dict[str, Array]:
    """Return joint angles at base and platform (rad), (n, 6), NaN without direction; {} if not limited."""
    if not robot.has_joint_angle_limits:
        return {}
    angles = angles_from(neutral_directions(robot), reached_legs(robot, motion)[2], motion.R)
    return dict(zip(("base", "platform"), angles, strict=True))


def limit_codes(
    robot: Robot,
    values: Mapping[str, Array | None],
    sd: Mapping[str, Array] | None = None,
    there: Flags | None = None,
) -> dict[str, NDArray[np.uint8]]:
    """Return ``status_codes`` of limited quantities by name, (n, 6); arguments as in ``LimitTracker.add``."""
    found: dict[str, NDArray[np.uint8]] = {}
    for limit in limits_of(robot):
        given = values.get(limit.values)
        if given is not None:
            codes = status_codes(limit.sizes(given), limit.most(robot), sides(sd, limit.values), there)
            found[limit.values] = np.maximum(found.get(limit.values, codes), codes)
    return found


class LimitTracker:
    """Status of the limits of legs and motors along a motion, with root mean squares and energy of motors."""

    def __init__(
        self,
        robot: Robot,
        time: Array | None,
        replaced: tuple[Replaced, ...] = (),
        weights: Array | None = None,
    ) -> None:
        """Start with all times (s), shape (n,), or None; ``replaced`` are the replaced rows of the log.

        ``weights`` are the weights of the samples in integrals (s), shape (n,), required without times.
        """
        self.robot, self.replaced, self.units = robot, replaced, Units.of(robot)
        self._time, self._step = time, 0.0 if time is None else least_step(time)
        self.weights = trapezoids(elapsed(np.asarray(time))) if weights is None else weights
        self._extremes = {limit: Extremes() for limit in limits_of(robot)}
        # Time beyond each limit, number of samples, and integrals of power and squared torque.
        self._span = {limit: np.zeros((2, LEGS)) for limit in self._extremes}
        self.energy, self._squares = np.zeros((2, LEGS))
        # Upper bounds: errors of all samples are added, because their correlation is unknown.
        self.energy_sd, self._square_sd, self.noisy = np.zeros(LEGS), np.zeros(LEGS), False

    def add(
        self,
        where: slice,
        values: Mapping[str, Array | None],
        sd: Mapping[str, Array] | None = None,
        there: Flags | None = None,
    ) -> None:
        """Add the limited quantities of some samples by name, shape (n, 6) each.

        Names are F, L, L_dot, the names of ``limited_angles``, and the fields of ``MotorStates``. ``sd``
        contains standard deviations, and ``there`` marks samples at replaced rows of a log.
        """
        weights, first = self.weights[where, None], where.start or 0
        self.noisy |= sd is not None
        for limit, extremes in self._extremes.items():
            given = values.get(limit.values)
            if given is not None and len(given):
                sizes = limit.sizes(given)
                over = sizes > limit.most(self.robot)
                self._span[limit] += [np.sum(weights * over, axis=0), np.count_nonzero(over, axis=0)]
                extremes.add(sizes, given, first, sides(sd, limit.values), there)
        torque, power = values.get("torque"), values.get("electrical_power")
        if torque is None:
            return
        good = np.isfinite(torque) & (weights > 0.0)

        def integral(of: Array) -> Array:
            return np.asarray(np.sum(weights * np.where(good, of, 0.0), axis=0))

        self._squares = self._squares + integral(torque**2)
        self._square_sd = self._square_sd + (0.0 if sd is None else integral(sd["torque"] ** 2))
        if power is not None:
            self.energy = self.energy + integral(power)
            self.energy_sd = self.energy_sd + (0.0 if sd is None else integral(sd["electrical_power"]))

    def _rms(self, squares: Array) -> Array:
        span = float(self.weights.sum())
        return np.asarray(np.sqrt(squares / span)) if span > 0.0 else np.zeros(LEGS)

    @property
    def rms_torque(self) -> Array:
        """Root mean square torque (N m), shape (6,)."""
        return self._rms(self._squares)

    @property
    def rms_torque_sd(self) -> Array | None:
        """Upper bound of the standard deviation of ``rms_torque`` (N m), or None without noise."""
        return self._rms(self._square_sd) if self.noisy else None

    @property
    def peak_sd(self) -> dict[str, Array]:
        """Standard deviations of the peaks of the motors by quantity, shape (6,) each."""
        found = {name: self.peaks(MOTOR_LIMITS[name])[1] for name in PEAKS}
        return {name: sd for name, sd in found.items() if sd is not None}

    def exceeded(self, tolerance: float = USED_UP) -> list[str]:
        """Return the lines of ``told``."""
        return [line for _, line in self.told(tolerance)]

    def told(self, tolerance: float = USED_UP) -> Iterator[tuple[str, str]]:
        """Yield status and text of each limit that is exceeded, by more than a fraction, or inconclusive."""
        for limit in self._extremes:
            verdicts = self.verdicts(limit, tolerance)
            for verdict in (EXCEEDED, INCONCLUSIVE_NOISE, INCONCLUSIVE_REPLACED_ROWS):
                legs = [leg for leg in range(LEGS) if verdicts[leg] == verdict]
                if legs:
                    yield verdict, self._line(limit, verdict, legs, limit.most(self.robot, tolerance))

    def _line(self, limit: Limit, verdict: str, legs: list[int], most: Array) -> str:
        """Return the text about a limit and its legs."""
        worst, i, value, sd = self.worst(limit, verdict, legs, most)
        scale, unit = self.units.of_unit(limit.unit)
        bound = scale * limit.sign * limit.bound(self.robot)[worst]
        span, count = self._span[limit][:, worst]
        text = f"{limit.name} {verdict.replace('_', ' ')} by {legs_text(legs)}: "
        text += "" if len(legs) == 1 else f"worst leg {worst + 1}: "
        text += f"{limit.what}{amount_text(scale * value, None if sd is None else scale * sd)} {unit}"
        if self._time is None:
            text += "" if limit is RATED else f" at sample {i}"
        elif limit is not RATED:
            text += f" at {time_text(self._time[i], self._step)} s"
        text += f", limit {bound:g} {unit}"
        if count and self._time is not None:
            text += f"; beyond it for {span:.3g} s, at {int(count)} of {len(self._time)} samples"
        if verdict != EXCEEDED and sd and np.isfinite(sd):
            share = abs(most[worst] - limit.sizes(np.asarray(value))) / (SURE * sd)
            text += f"; needs noise below {100.0 * share:.2g} % of the noise here"
        if verdict == INCONCLUSIVE_REPLACED_ROWS and not count:
            text += f"; because of replaced rows ({replaced_names(self.replaced)})"
        return text

    def all_verdicts(self) -> dict[str, str]:
        """Return the worst status of the legs for each limit that the robot file states, by name."""
        found: dict[str, list[str]] = {}
        for limit in self._extremes:
            if limit.is_stated(self.robot):
                found.setdefault(limit.name, []).extend(self.verdicts(limit))
        return {name: max(verdicts, key=VERDICTS.index) for name, verdicts in found.items()}

    def verdicts(self, limit: Limit, tolerance: float = USED_UP) -> list[str]:
        """Return the status of each leg."""
        return self._of(limit).verdicts(limit.most(self.robot, tolerance))

    def worst(
        self, limit: Limit, verdict: str, legs: list[int], most: Array | None = None
    ) -> tuple[int, int, float, float | None]:
        """Return the leg farthest beyond its limit, the index of the sample, value, and deviation if any."""
        most = limit.most(self.robot) if most is None else most
        return self._of(limit).worst(verdict, legs, most)

    def peaks(self, limit: Limit) -> tuple[Array, Array | None]:
        """Return the largest magnitudes, or extreme lengths, and their standard deviations or None, (6,)."""
        found = self._of(limit)
        peaks = np.maximum(found.largest, 0.0) if limit.values != "L" else limit.sign * found.largest
        return peaks, found.peak_sd

    def forces(self) -> tuple[Array, Array, Flags, Array | None]:
        """Return times of possible peak forces (s), (k,), the forces (N), (k, 6), ``there``, and ``sd``."""
        index, F, there, sd = self._of(FORCE).samples
        return np.asarray(self._time)[index], F, there, sd

    def _of(self, limit: Limit) -> Extremes:
        if limit is not RATED:
            return self._extremes[limit]
        found, rms, sd = Extremes(), self.rms_torque[None], self.rms_torque_sd
        found.add(rms, rms, 0, None if sd is None else (sd[None], sd[None]))
        return found


def times_of(motion: Motion, time: ArrayLike, name: str = "time", least: int = 1) -> Array:
    """Return the finite, increasing times (s) of at least ``least`` samples of a motion, shape (n,)."""
    when = real_array(time, name, "times of shape (n,)")
    if motion.shape != when.shape or when.ndim != 1 or len(when) < least:
        expected = f"expected a time for each sample of a motion of shape (n,), n >= {least}"
        raise ValueError(f"{name}: {expected}, got {when.shape} and {motion.shape}")
    if np.any(wrong := ~(np.diff(when, prepend=-np.inf) > 0.0) | ~np.isfinite(when)):
        i = int(np.argmax(wrong))
        raise ValueError(f"{name}: expected finite, increasing times, got {when[i]} at index {i}")
    return when


def trapezoids(time: Array) -> Array:
    """Return the weight of each sample in the trapezoidal rule (s), for times of shape (n,)."""
    half = 0.5 * np.diff(time)
    return np.asarray(np.concatenate([half, [0.0]]) + np.concatenate([[0.0], half]))


def replaced_rows(trajectory: Trajectory) -> tuple[Replaced, ...]:
    """Return the rows of its log that a trajectory replaces."""
    return () if trajectory.noise is None else trajectory.noise.replaced


def replaced_names(replaced: tuple[Replaced, ...]) -> str:
    """Return the names of replaced rows as text, shortened if there are many."""
    names = list(dict.fromkeys(name for span in replaced for name in span.rows))
    return ", ".join(names[:_MOST_NAMED]) + (
        f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
    )
