"""Inverse dynamics along a trajectory for ``forces`` and ``view``: columns, limits, and a summary."""

import warnings
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ...drives import limits
from ...drives.limit_status import SURE, counts_text, unknown_forces
from ...drives.motor_states import motor_states
from ...drives.noise import Deviations, at_replaced, deviations_in_parts
from ...dynamics.inverse_dynamics import Backend, Formulation, first_fault, inverse_dynamics, joint_reactions
from ...io.array_types import Array, Flags
from ...io.progress import Progress
from ...kinematics.conditioning import condition_number
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...motion.sample_times import least_step, time_text
from ...motion.trajectory import Trajectory, noise_text
from ...results import NOT_FINITE, OK, ZERO_LENGTH, JointReactionsResult, SingularPoseWarning
from ...robot.robot import LEGS, Robot
from ...viewer.view import Viewer
from ..common.drawing import Figure
from ..common.text_tables import Columns, amounts, by_leg, csv_lines, leg_table, of_axes, of_legs
from .leg_plot import leg_figure
from .leg_tables import at_rows, drive_columns, extreme_texts, largest, leg_data, motor_table

_FORCES, _STD = (",".join(f"F_{leg + 1}{ending}" for leg in range(LEGS)) for ending in ("", "_std"))
HEADERS = [f"time,{_FORCES},{after}" for after in ("L_1,", _STD)]
"""Beginnings of the CSV files, without and with standard deviations."""

NOISE_THRESHOLD = 0.02
"""Fraction of the peak force that ``SURE`` standard deviations may reach without a warning."""

# Number of samples that are computed at a time, because the outputs of all samples could exceed the memory.
_PART = 1 << 14
# Distance (samples) and least number of condition numbers between which others are interpolated, and largest
# relative error of interpolation over twice the distance.
_INTERPOLATED, _FEWEST_INTERPOLATED, _INTERPOLATION_ERROR = 4, 256, 1e-6
# Number of written digits of the largest value of a column, if a log has noise.
_DIGITS = 10


class ForceReport:
    """Forces along a trajectory, computed in parts, with the data of summary, warnings, and plot."""

    def __init__(
        self,
        robot: Robot,
        trajectory: Trajectory,
        formulation: Formulation = "exact",
        backend: Backend = "c",
        reactions: bool = False,
        allow_singular: bool = False,
    ) -> None:
        self.robot, self.trajectory, self.time = robot, trajectory, trajectory.time
        self._formulation, self._backend, self._reactions = formulation, backend, reactions
        self._must_warn, self._allow_singular = True, allow_singular
        self.replaced, self.step = limits.replaced_rows(trajectory), least_step(self.time)
        self.limits = limits.LimitTracker(robot, self.time, self.replaced)
        # Time and value of the largest condition number.
        self.worst = float(self.time[0]), np.nan
        self.F, self.torque, self.speed = np.full((3, len(self.time), LEGS), np.nan, dtype=np.float32)

    def rows(self, progress: Progress) -> Iterator[str]:
        """Compute all samples, and yield the text of the CSV file."""
        count, deviations = len(self.time), None
        progress(f"computing {count} samples", 0.0)
        if self.trajectory.noise is not None:
            deviations = deviations_in_parts(self.robot, self.trajectory, self._formulation, self._backend)
        for start in range(0, count, _PART):
            where = slice(start, start + _PART)
            columns = self._part(where, deviations)
            digits = None if deviations is None else _DIGITS
            yield from csv_lines(columns, header=start == 0, digits=digits)
            progress(f"computing {count} samples", min(1.0, where.stop / count))

    def _part(self, where: slice, deviations: Callable[..., Deviations] | None) -> Columns:
        """Compute some samples; return their columns (n,) by name, in SI units."""
        robot, motion, time = self.robot, self.trajectory.at(where), self.time[where]
        how: Any = {"formulation": self._formulation, "backend": self._backend, "on_singular": "nan"}
        found = inverse_dynamics(robot, motion, **how)
        good = ~np.isin(found.status, (ZERO_LENGTH, NOT_FINITE))
        L, L_dot = np.full((2, *motion.shape, LEGS), np.nan)
        if np.any(good):
            legs = inverse_kinematics(robot, motion[good])
            L[good], L_dot[good] = legs.L, legs.L_dot
        sd = None if deviations is None else deviations(where, motion, found.F)
        condition = condition_number(found.H) if sd is None else _condition_numbers(found.H)
        status, more = found.status, Columns()
        values = {"F": found.F, "L": L, "L_dot": L_dot, **limits.limited_angles(robot, motion)}
        if robot.drive is not None:
            sides = self._sides(where, L_dot) if robot.offsets is None else None
            effort = motor_states(robot, robot.drive, motion, found.F, L_dot, sides)
            self.torque[where], self.speed[where] = effort.torque, effort.speed
            values |= effort._asdict()
            more |= drive_columns(effort, sd)
        if self._reactions:
            reactions = joint_reactions(robot, motion, **how)
            status = np.where(status == OK, reactions.status, status)
            more |= _reaction_columns(reactions)
        if status.any() and self._must_warn:
            at, reason = first_fault(status, robot, motion)
            line = self.trajectory.rows[(where.start or 0) + at[0]]
            text = f"{self.trajectory.source}: line {line}: {reason}"
            if not self._allow_singular:
                raise ValueError(text)
            warnings.warn(text, SingularPoseWarning, stacklevel=2)
            self._must_warn = False
        self.limits.add(where, values, sd, None if sd is None else at_replaced(self.trajectory, time))
        self.F[where] = found.F
        i = int(largest(condition))
        if not condition[i] <= self.worst[1]:
            self.worst = float(time[i]), float(condition[i])
        columns: Columns = {"time": time} | of_legs("F", found.F)
        columns |= {} if sd is None else of_legs("F", sd["F"], "_std")
        return columns | of_legs("L", L) | {"condition_number": condition, "status": status} | more

    def _sides(self, where: slice, L_dot: Array) -> Array:
        """Return the signs of the rates (n, 6); at rest at an end of the motion, the signs next to this end.

        Friction opposes the motion that begins, or the motion that ends.
        """
        signs = np.sign(L_dot)
        if len(signs) > 1:
            ends = {0: 1} if not where.start else {}
            ends |= {-1: -2} if where.stop >= len(self.time) else {}
            for end, beside in ends.items():
                signs[end] = np.where(signs[end] == 0.0, signs[beside], signs[end])
        return np.asarray(signs)

    def doubts(self, noise_share: float) -> list[str]:
        """Return a line for each exceeded or inconclusive limit, and for noise above a fraction of a peak."""
        times, F, there, F_sd = self.limits.forces()
        beyond = self.limits.exceeded()
        if F_sd is None:
            return beyond
        names = limits.replaced_names(self.replaced)
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
        tracker, units, peak = self.limits, self.limits.units, largest(F)
        ends = [extreme_texts(tracker, limit) for limit in (limits.SHORTEST, limits.LONGEST)]
        columns = {
            "peak force, N": amounts(at_rows(F, peak), None if F_sd is None else at_rows(F_sd, peak), 6),
            "at, s": [time_text(when, self.step) for when in time[peak]],
            "force_limit, N": [
                f"{most:g}" + (f" {verdict.replace('_', ' ')}" if np.isfinite(most) else "")
                for most, verdict in zip(self.robot.force_limit, tracker.verdicts(limits.FORCE), strict=True)
            ],
            f"length, {units.length}": [" to ".join(both) for both in zip(*ends, strict=True)],
            f"speed, {units.length}/s": extreme_texts(tracker, limits.SPEED),
        }
        if self.robot.has_joint_angle_limits:
            angles = [extreme_texts(tracker, limit) for limit in (limits.BASE, limits.PLATFORM)]
            columns[f"joint angles, {units.angle}"] = [", ".join(both) for both in zip(*angles, strict=True)]
        first, last, when = (time_text(each, self.step) for each in (*self.time[[0, -1]], self.worst[0]))
        text = (
            f"{counts_text(tracker.all_verdicts())}\n"
            f"{len(self.time)} sample{'s' if len(self.time) > 1 else ''}, {first} to {last} s; condition "
            f"number of H up to {self.worst[1]:.4g} (at {when} s)\n"
            f"{leg_table('leg', columns)}"
        )
        text += "" if self.robot.drive is None else f"\n\n{motor_table(tracker)}"
        noise = self.trajectory.noise
        if noise is not None and noise.sigma.any():
            std = noise_text(noise.sigma, self.trajectory.has_lengths, units.length, units.angle)
            text += f"\n{std}; F_std is the remaining standard deviation"
        return text

    def as_json(self) -> dict[str, Any]:
        """Return the numbers of the summary for the JSON data."""
        found = {"samples": len(self.time), "start_s": self.time[0], "end_s": self.time[-1]}
        found |= dict(zip(("condition_number_peak_time_s", "condition_number_peak"), self.worst, strict=True))
        return found | {"legs": by_leg(leg_data(self.limits))}


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


def _noisy(when: list[str], F: Array, F_sd: Array, share: float, cause: str, there: Flags) -> str | None:
    """Return a warning about the leg with the most uncertain peak, if it is above ``share`` of the peak."""
    nominal = np.nan_to_num(np.abs(F))
    possible = np.nan_to_num(np.abs(F) + SURE * np.where(there[:, None], F_sd, 0.0))
    peaks = nominal.max(axis=0)
    ratio = (possible.max(axis=0) - peaks) / np.maximum(peaks, np.finfo(float).tiny)
    leg = int(np.argmax(ratio))
    if not ratio[leg] > share:
        return None
    i, peak = int(np.argmax(possible[:, leg])), int(np.argmax(nominal[:, leg]))
    much = f"{100.0 * ratio[leg]:.3g} %" if ratio[leg] <= 10.0 else "more than ten times"
    others = np.count_nonzero(ratio > share) - 1
    return (
        f"leg {leg + 1}: the peak force may be {much} higher than computed because of {cause}: "
        f"{peaks[leg]:.6g} N computed (at {when[peak]} s), up to {possible[i, leg]:.6g} N possible "
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
    shown = view.history
    return {
        "motion": shown.name,
        "samples": len(shown.time),
        "start_s": shown.time[0],
        "end_s": shown.time[-1],
        "scaled_condition_number_peak": shown.condition.max(),
        "peak_force_N": {name: np.fmax.reduce(np.abs(F), axis=0) for name, F in shown.forces.items()},
        "legs": by_leg(leg_data(view.limits.tracker)),
        "warnings": [line for _, line in view.limits.told],
        "marked": [{"time_s": e.time, "singular": e.singular, "twist": e.at.twist} for e in shown.events],
        "units": {"twist": "m/s and rad/s"},
    }
