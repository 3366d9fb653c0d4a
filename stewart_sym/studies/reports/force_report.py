"""Inverse dynamics along a trajectory for ``forces`` and ``view``: columns, limits, and a summary."""

import warnings
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...drives.limit_status import SURE, amount_text, counts_text, unknown_forces
from ...drives.limits import (
    BASE,
    FORCE,
    LONGEST,
    PLATFORM,
    SHORTEST,
    SPEED,
    Limit,
    LimitTracker,
    limited_angles,
    replaced_names,
)
from ...drives.motor_states import MotorStates, motor_states
from ...drives.noise import Deviations, at_replaced, deviations_in_parts
from ...dynamics.inverse_dynamics import Backend, Formulation, first_fault, inverse_dynamics, joint_reactions
from ...io.arguments import status_text
from ...io.array_types import Array, Codes, Flags
from ...io.progress import Progress
from ...kinematics.conditioning import condition_number
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.sample_times import least_step, time_text
from ...motion.trajectory import Replaced, Trajectory
from ...results import NOT_FINITE, OK, ZERO_LENGTH, JointReactionsResult, SingularPoseWarning
from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ...viewer.view import Viewer
from ..common.drawing import Figure
from ..common.text_tables import Columns, by_leg, csv_lines, leg_table, of_axes, of_legs
from .drives import drive_columns, motor_data, motor_table
from .leg_plot import leg_figure

NOISE_THRESHOLD = 0.02
"""Fraction of the peak force that ``SURE`` standard deviations may reach without a warning."""

# Number of samples that are computed at a time, because the outputs of all samples could exceed the memory.
_PART = 1 << 14
# Distance (samples) and least number of condition numbers between which others are interpolated, and largest
# relative error of interpolation over twice the distance.
_INTERPOLATED, _FEWEST_INTERPOLATED, _INTERPOLATION_ERROR = 4, 256, 1e-6
# Number of written digits of the largest value of a column, if a log has noise.
_DIGITS = 10


class Part(NamedTuple):
    """Samples ``where`` of a trajectory with their dynamics (N, m, s); others as in ``LimitTracker.add``."""

    where: slice
    time: Array
    F: Array
    L: Array
    L_dot: Array
    condition: Array
    status: Codes
    reactions: JointReactionsResult | None = None
    effort: MotorStates | None = None
    sd: Deviations | None = None
    there: Flags | None = None
    angles: Mapping[str, Array] | None = None

    @property
    def columns(self) -> Columns:
        """Written columns (n,) by name, in SI units; noise, a drive, and reactions add columns."""
        sd = self.sd
        found: Columns = {"time": self.time} | of_legs("F", self.F)
        found |= {} if sd is None else of_legs("F", sd["F"], "_std")
        found |= of_legs("L", self.L) | {"condition_number": self.condition, "status": self.status}
        if self.effort is not None:
            found |= drive_columns(self.effort, sd)
        return found if self.reactions is None else found | _reaction_columns(self.reactions)


def header_lines() -> list[str]:
    """Return the beginning of the header of CSV files, without and with standard deviations."""
    F, F_std, L = (
        ",".join(of_legs(name, np.zeros((0, LEGS)), ending))
        for name, ending in (("F", ""), ("F", "_std"), ("L", ""))
    )
    rest = f"{L},condition_number,status"
    return [f"time,{F},{rest}", f"time,{F},{F_std},{rest}"]


def in_parts(
    robot: Robot,
    trajectory: Trajectory,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    reactions: bool = False,
    allow_singular: bool = False,
) -> Iterator[Part]:
    """Compute the dynamics of a trajectory in parts; an unsolvable pose is an error or a row of nan."""
    deviations, told = None, False
    if trajectory.noise is not None:
        deviations = deviations_in_parts(robot, trajectory, formulation, backend)
    for start in range(0, max(1, len(trajectory.time)), _PART):
        where = slice(start, start + _PART)
        motion = trajectory.at(where)
        found = inverse_dynamics(robot, motion, formulation, backend, on_singular="nan")
        good = ~np.isin(found.status, (ZERO_LENGTH, NOT_FINITE))
        L, L_dot = np.full((2, *motion.shape, LEGS), np.nan)
        if np.any(good):
            legs = inverse_kinematics(robot, motion[good])
            L[good], L_dot[good] = legs.L, legs.L_dot
        status, more = found.status, None
        if reactions:
            more = joint_reactions(robot, motion, formulation, backend, on_singular="nan")
            status = np.where(status == OK, more.status, status)
        if status.any() and not told:
            at, reason = first_fault(status, robot, motion)
            text = f"{trajectory.source}: line {trajectory.rows[start + at[0]]}: {reason}"
            if not allow_singular:
                raise ValueError(text)
            warnings.warn(text, SingularPoseWarning, stacklevel=2)
            told = True
        sd = None if deviations is None else deviations(where, motion, found.F)
        time = trajectory.time[where]
        condition = condition_number(found.H) if deviations is None else _condition_numbers(found.H)
        effort = None if robot.drive is None else motor_states(robot, robot.drive, motion, found.F, L_dot)
        there = None if sd is None else at_replaced(trajectory, time)
        angles = limited_angles(robot, motion)
        yield Part(where, time, found.F, L, L_dot, condition, status, more, effort, sd, there, angles)


def _condition_numbers(H: Array) -> Array:
    """Return the condition numbers of samples (n,) of a noisy log, interpolated if they change slowly.

    The spline through every eighth sample must pass through the samples between them.
    """
    some = np.arange(0, len(H), _INTERPOLATED)
    values = condition_number(H[some])
    if len(some) > _FEWEST_INTERPOLATED and np.isfinite(values).all():
        from scipy.interpolate import CubicSpline

        checked = CubicSpline(some[::2], values[::2])(some)
        if np.all(np.abs(checked - values) <= _INTERPOLATION_ERROR * values):
            return np.asarray(CubicSpline(some, values)(np.arange(len(H))))
    return condition_number(H)


_LIMITS = {
    "min_length": (SHORTEST, "m", "length_limits_m", "min_length_limit"),
    "max_length": (LONGEST, "m", "length_limits_m", "max_length_limit"),
    "peak_speed": (SPEED, "m_per_s", "speed_limit_m_per_s", "speed_limit"),
    "peak_base_angle": (BASE, "rad", "base_angle_limit_rad", "base_angle_limit"),
    "peak_platform_angle": (PLATFORM, "rad", "platform_angle_limit_rad", "platform_angle_limit"),
}
"""Extreme values of the legs in the JSON data: limit, unit, key of the limit, and key of its status."""


class Digest:
    """Data for the summary, the warnings, and the plot of a run."""

    def __init__(self, robot: Robot, time: Array, replaced: tuple[Replaced, ...] = ()) -> None:
        """Start a run at all these times (s), shape (n,); ``replaced`` are the replaced rows of the log."""
        self.robot, self.time, self.replaced, self.step = robot, time, replaced, least_step(time)
        self.limits = LimitTracker(robot, time, replaced)
        # Time and value of the largest condition number of each part.
        self.conditions: list[tuple[float, float]] = []
        self.F, self.torque, self.speed = np.full((3, len(time), LEGS), np.nan, dtype=np.float32)

    def rows(self, parts: Iterable[Part], progress: Progress) -> Iterator[str]:
        """Add all parts, and yield the text of their CSV file."""
        count = len(self.time)
        progress(f"computing {count} samples", 0.0)
        for part in parts:
            digits = None if part.sd is None else _DIGITS
            yield from csv_lines(part.columns, header=part.where.start == 0, digits=digits)
            self.add(part)
            progress(f"computing {count} samples", min(1.0, part.where.stop / count))

    def add(self, part: Part) -> None:
        """Add the next part."""
        values: dict[str, Array | None] = {"F": part.F, "L": part.L, "L_dot": part.L_dot}
        if part.effort is not None:
            values |= part.effort._asdict()
            self.torque[part.where], self.speed[part.where] = part.effort.torque, part.effort.speed
        self.limits.add(part.where, {**values, **(part.angles or {})}, part.sd, part.there)
        self.F[part.where] = part.F
        i = int(_largest(part.condition))
        self.conditions.append((float(part.time[i]), float(part.condition[i])))

    def doubts(self, noise_share: float) -> list[str]:
        """Return a line for each exceeded or inconclusive limit, and for noise above a fraction of a peak."""
        times, F, there, F_sd = self.limits.forces()
        beyond = self.limits.exceeded()
        if F_sd is None:
            return beyond
        names = replaced_names(self.replaced)
        causes = [("noise in the log", ~there)]
        causes += [(f"replaced rows ({names})", there)] if self.replaced else []
        when = [time_text(time, self.step) for time in times]
        noisy = [_noisy(when, F, F_sd, noise_share, cause, at) for cause, at in causes]
        unknown = unknown_forces(F, np.where(there[:, None], 0.0, F_sd))
        return [line for line in (unknown, *beyond, *noisy) if line]

    def figure(self) -> Figure:
        """Plot the forces, and with drives the motor torques, with their limits."""
        motors = None if self.robot.drive is None else (self.torque, self.speed)
        return leg_figure(self.robot, self.time, self.F, motors)

    def summary(self) -> str:
        """Format the summary as lines of text."""
        time, F, _, F_sd = self.limits.forces()
        verdicts, limit, units = self.limits.verdicts(FORCE), self.robot.force_limit, Units.of(self.robot)
        peak = _largest(F)
        lengths = self._texts(SHORTEST, units.meters), self._texts(LONGEST, units.meters)
        columns = {
            "peak force, N": _texts(_at(F, peak), None if F_sd is None else _at(F_sd, peak), 6),
            "at, s": [time_text(when, self.step) for when in time[peak]],
            "force_limit, N": [
                f"{most:g}" + (f" {status_text(verdict)}" if np.isfinite(most) else "")
                for most, verdict in zip(limit, verdicts, strict=True)
            ],
            f"length, {units.length}": [" to ".join(ends) for ends in zip(*lengths, strict=True)],
            f"speed, {units.length}/s": self._texts(SPEED, units.meters),
        }
        if self.robot.has_joint_angle_limits:
            angles = self._texts(BASE, units.radians), self._texts(PLATFORM, units.radians)
            columns[f"joint angles, {units.angle}"] = [", ".join(both) for both in zip(*angles, strict=True)]
        first, last, when = (time_text(each, self.step) for each in (*self.time[[0, -1]], self._worst()[0]))
        text = (
            f"{counts_text(self.limits.all_verdicts())}\n"
            f"{len(self.time)} sample{'s' if len(self.time) > 1 else ''}, {first} to {last} s; condition "
            f"number of H up to {self._worst()[1]:.4g} (at {when} s)\n"
            f"{leg_table('leg', columns)}"
        )
        return text if self.robot.drive is None else f"{text}\n\n{motor_table(self.limits)}"

    def as_json(self) -> dict[str, Any]:
        """Return the numbers of the summary for the JSON data."""
        time, F, _, F_sd = self.limits.forces()
        when, condition = self._worst()
        peak, robot = _largest(F), self.robot
        legs = {
            "peak_force_N": _at(F, peak),
            "peak_force_std_N": [None] * LEGS if F_sd is None else _at(F_sd, peak),
            "peak_force_time_s": time[peak],
            "force_limit_N": robot.force_limit,
            "force_limit": self.limits.verdicts(FORCE),
        }
        for name, (limit, unit, key, status) in _LIMITS.items():
            if limit not in (BASE, PLATFORM) or robot.has_joint_angle_limits:
                peaks, sd = self.limits.peaks(limit)
                legs |= {f"{name}_{unit}": peaks, status: self.limits.verdicts(limit)}
                legs |= {} if sd is None else {f"{name}_std_{unit}": sd}
                legs[key] = robot.length_limits if limit.values == "L" else limit.bound(robot)
        legs |= {} if robot.drive is None else motor_data(self.limits)
        found = {"samples": len(self.time), "start_s": self.time[0], "end_s": self.time[-1]}
        found |= {"condition_number_peak": condition, "condition_number_peak_time_s": when}
        return found | {"legs": by_leg(legs)}

    def _texts(self, limit: Limit, unit: float) -> list[str]:
        """Format the extreme value of each leg in a unit (m or rad)."""
        peaks, sd = self.limits.peaks(limit)
        return _texts(peaks / unit, None if sd is None else sd / unit, 4)

    def _worst(self) -> tuple[float, float]:
        """Return the time of the largest condition number (s) and its value."""
        return self.conditions[int(_largest(np.array(self.conditions)[:, 1]))]


def _texts(values: Array, sd: Array | None, digits: int) -> list[str]:
    """Format the value of each leg with its standard deviation, if any."""
    deviations = [None] * LEGS if sd is None else sd
    return [amount_text(value, off, digits) for value, off in zip(values, deviations, strict=True)]


def _largest(values: Array) -> NDArray[np.int64]:
    """Return the indices, shape (...), of the largest magnitudes of values, shape (n, ...)."""
    return np.asarray(np.argmax(np.nan_to_num(np.abs(values), nan=-1.0), axis=0))


def _at(values: Array, rows: NDArray[np.int64]) -> Array:
    """Return the value of each leg, shape (6,), in its row of values, shape (n, 6)."""
    return np.asarray(values[rows, np.arange(LEGS)])


def peak_noise(F: Array, F_sd: Array) -> Array:
    """Return the fraction of each peak force, shape (6,), by which noise may conceal a larger force."""
    peak = np.nan_to_num(np.abs(F)).max(axis=0)
    possible = np.nan_to_num(np.abs(F) + SURE * F_sd).max(axis=0)
    return np.asarray((possible - peak) / np.maximum(peak, np.finfo(float).tiny))


def _noisy(when: list[str], F: Array, F_sd: Array, share: float, cause: str, there: Flags) -> str | None:
    """Return a warning about the leg with the most uncertain peak, if it is above ``share`` of the peak."""
    spread = np.where(there[:, None], F_sd, 0.0)
    ratio = peak_noise(F, spread)
    leg = int(np.argmax(ratio))
    if not ratio[leg] > share:
        return None
    largest, possible = (np.nan_to_num(x[:, leg]) for x in (np.abs(F), np.abs(F) + SURE * spread))
    i, peak = int(np.argmax(possible)), int(np.argmax(largest))
    much = f"{100.0 * ratio[leg]:.3g} %" if ratio[leg] <= 10.0 else "more than ten times"
    others = np.count_nonzero(ratio > share) - 1
    return (
        f"leg {leg + 1}: the peak force may be {much} higher than computed because of {cause}: "
        f"{largest[peak]:.6g} N computed (at {when[peak]} s), up to {possible[i]:.6g} N possible "
        f"({F[i, leg]:.6g} N with {SURE:g} standard deviations of {F_sd[i, leg]:.3g} N at {when[i]} s); "
        f"a warning beyond {100.0 * share:.3g} % (--noise-threshold {share:g})"
        + (f"; {others} more leg{'s' if others > 1 else ''} likewise" if others else "")
    )


def _reaction_columns(found: JointReactionsResult) -> Columns:
    columns: Columns = {}
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_s"):
        values = getattr(found, name)
        for leg in range(0 if values is None else 6):
            columns |= of_axes(f"{name}_{leg + 1}", values[:, leg])
    return columns | of_legs("M_u", found.M_u)


def view_data(view: Viewer) -> dict[str, object]:
    """Return the numbers of a view for JSON, with peaks over the samples that have finite forces."""
    shown, found = view.history, view.limits
    # The legs are compared with their limits as in `forces`.
    sd, there = (None, None) if shown.noise is None else (shown.noise.sd, shown.noise.there)
    status = np.zeros(len(shown.time), dtype=np.int32)
    whole = Part(slice(None), shown.time, found.F, shown.L, shown.L_dot, shown.condition, status)
    digest = Digest(view.robot, shown.time)
    angles = limited_angles(view.robot, shown.motion)
    digest.add(whole._replace(effort=found.motors, sd=sd, there=there, angles=angles))
    # NumPy warns of legs without a finite force at any sample.
    with warnings.catch_warnings(action="ignore", category=RuntimeWarning):
        peaks = {name: np.nanmax(np.abs(F), axis=0) for name, F in shown.forces.items()}
    return {
        "motion": shown.name,
        "samples": len(shown.time),
        "start_s": shown.time[0],
        "end_s": shown.time[-1],
        "scaled_condition_number_peak": shown.condition.max(),
        "peak_force_N": peaks,
        "legs": digest.as_json()["legs"],
        "warnings": [line for _, line in view.limits.told],
        "marked": [{"time_s": e.time, "singular": e.singular, "twist": e.at.twist} for e in shown.events],
        "units": {"twist": "m/s and rad/s"},
    }
