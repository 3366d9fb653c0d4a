"""A trajectory run through the dynamics, as ``forces`` writes it: columns, limits exceeded, a summary."""

import dataclasses
import warnings
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...drives.effort import Instants, at_instants
from ...dynamics.force_noise import deviations_in_parts
from ...dynamics.home_pose import home_pose
from ...dynamics.inverse import Backend, Formulation, first_fault, inverse_dynamics, joint_reactions
from ...io.array_types import Array, Codes, Flags
from ...io.error_policy import SingularPoseWarning
from ...io.instants import elapsed, least_step, time_text
from ...kinematics.conditioning import condition_number
from ...kinematics.inverse import LegKinematics, inverse_kinematics
from ...motion.motion import Motion
from ...motion.trajectory import PoseLog, Replaced, Trajectory
from ...results import NOT_FINITE, OK, ZERO_LENGTH, Reactions
from ...robot.robot import Robot
from ..common.output import Columns, aligned, csv_lines, of_axes, of_legs
from .drives import DriveDigest, drive_columns, no_instants

SURE = 3.0
"""Deviations within which a force is taken to lie: 99.7 % of normal errors."""

NOISE_SHARE = 0.02
"""Share of a leg's peak force that noise may make of it, ``SURE`` deviations, without a warning."""


# So many instants are computed at a time: all outputs of all instants at once would fill memory.
_PART = 1 << 14


class Part(NamedTuple):
    """Some instants of a trajectory run through the dynamics, N, m and s, (n,), (n, 6).

    where: which of the trajectory's. F_sd: deviations of F by noise, None for a log without.
    """

    where: slice
    time: Array
    F: Array
    F_sd: Array | None
    L: Array
    L_dot: Array
    condition: Array
    status: Codes
    reactions: Reactions | None
    effort: Instants | None = None

    @property
    def columns(self) -> Columns:
        """Columns (n,) by name, as written.

        In SI units: time, F1..F6, with noise in the log F1_sd..F6_sd, L1..L6, condition_number, status; with
        a drive torque1.., motor_speed1.., current1.. and power1..; with reactions the components of F_s, F_u,
        F_p, F_c, M_p (about the base point), of U-C-U legs M_s, and M_u leg by leg.
        """
        found: Columns = {"time": self.time}
        for name, ending, values in (("F", "", self.F), ("F", "_sd", self.F_sd), ("L", "", self.L)):
            if values is not None:
                found |= of_legs(name, values, ending)
        found |= {"condition_number": self.condition, "status": self.status}
        if self.effort is not None:
            found |= drive_columns(self.effort)
        return found if self.reactions is None else found | _reaction_columns(self.reactions)


def header_lines() -> list[str]:
    """First line of the CSV file of each kind of run: with deviations or not, with reactions or not."""
    n, legs = np.zeros(0), np.zeros((0, 6))
    vectors = np.zeros((0, 6, 3))
    reactions = Reactions(vectors, vectors, vectors, vectors, vectors, legs, n.astype(np.int32))
    more_reactions = dataclasses.replace(reactions, M_s=vectors)
    return [
        next(csv_lines(Part(slice(0), n, legs, F_sd, legs, legs, n, n.astype(np.int32), more, e).columns))
        for F_sd in (None, legs)
        for more in (None, reactions, more_reactions)
        for e in (None, no_instants(False), no_instants(True))
    ]


def in_parts(
    robot: Robot,
    trajectory: Trajectory | PoseLog,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    reactions: bool = False,
    allow_singular: bool = False,
) -> Iterator[Part]:
    """Run a trajectory part after part.

    Raises ValueError, naming file and row, for an unsolvable pose; ``allow_singular`` leaves nan and a status
    there and warns of the first instead.
    """
    deviations, told = None, False
    if trajectory.noise is not None:
        deviations = deviations_in_parts(robot, trajectory, formulation, backend)
    for start in range(0, max(1, len(trajectory.time)), _PART):
        where = slice(start, start + _PART)
        motion = trajectory.at(where)
        found = inverse_dynamics(robot, motion, formulation, backend, on_singular="nan")
        L, L_dot = _lengths_and_rates(robot, motion, ~np.isin(found.status, (ZERO_LENGTH, NOT_FINITE)))
        status, more = found.status, None
        if reactions:
            more = joint_reactions(robot, motion, formulation, backend, on_singular="nan")
            status = np.where(status == OK, more.status, status)
        if status.any() and not told:
            at, reason = first_fault(status, robot, motion)
            if status[at] == NOT_FINITE and not allow_singular:
                row = f"row {trajectory.rows[start + at[0]]} of {trajectory.source}"
                _need_forces(robot, row)
            _tell(trajectory, start + at[0], reason, allow_singular)
            told = True
        F_sd = None if deviations is None else deviations(where)
        condition = condition_number(found.H)
        effort = None if robot.drive is None else at_instants(robot, robot.drive, motion, found.F, L_dot)
        yield Part(where, trajectory.time[where], found.F, F_sd, L, L_dot, condition, status, more, effort)


class Digest:
    """What the summary and the doubts about a run of instants need of it, whatever their number.

    Of each part the instants are kept at which something is extreme, and how long limits are exceeded.
    """

    def __init__(self, robot: Robot, time: Array, replaced: tuple[Replaced, ...] = ()) -> None:
        """Begin a run at all these times, s, (n,); ``replaced``: of the log's rows."""
        self.robot, self.time, self.weights, self.replaced = robot, time, _weights(time), replaced
        self.step = least_step(time)
        self.span, self.count = np.zeros((2, len(_LIMITS), 6))
        self.kept: list[Part] = []
        self.drive = None if robot.drive is None else DriveDigest(robot, time)

    def add(self, part: Part) -> None:
        """Take in the next part."""
        if self.drive is not None and part.effort is not None:
            self.drive.add(part.effort, part.where)
        for k, limit in enumerate(_LIMITS):
            over = limit.excess(self.robot, part) > 0.0
            self.span[k] += np.sum(self.weights[part.where, None] * over, axis=0)
            self.count[k] += np.count_nonzero(over, axis=0)
        spread = 0.0 if part.F_sd is None else SURE * part.F_sd
        known = np.isfinite(part.L).all(axis=-1, keepdims=True)
        large = [np.abs(part.F), np.abs(part.F) + spread, np.abs(part.F) - spread]
        if self.replaced:
            apart = np.where(self._at_replaced(part.time)[:, None], np.nan, spread)
            large += [np.abs(part.F) + apart, np.abs(part.F) - apart]
        large += [np.where(known, x, np.nan) for x in (part.L, -part.L, np.abs(part.L_dot))]
        extremes = np.hstack([*large, part.condition[:, None]])
        picked = np.argmax(np.where(np.isnan(extremes), -np.inf, extremes), axis=0)
        i = np.unique(picked)
        arrays = [None if x is None else x[i] for x in part[1:-2]]
        self.kept.append(Part(part.where, *arrays, None))  # type: ignore[arg-type,call-arg]

    def doubts(self, noise_share: float) -> list[str]:
        """One line for each limit exceeded or not decided, and for noise of more than a share of a peak.

        Replaced rows have a line of their own.
        """
        kept = self._joined()
        beyond = self.exceeded() + ([] if self.drive is None else self.drive.summary.exceeded())
        if kept.F_sd is None:
            return beyond
        there = self._at_replaced(kept.time)
        names = self._replaced_names()
        causes = [("noise in the log", ~there)]
        causes += [(f"replaced rows ({names})", there)] if self.replaced else []
        when = [time_text(time, self.step) for time in kept.time]
        noisy = [_noisy(when, kept.F, kept.F_sd, noise_share, cause, at) for cause, at in causes]
        return beyond + [line for line in noisy if line]

    def exceeded(self) -> list[str]:
        """One line for each limit: which legs go beyond it, the worst of them, when and how long."""
        kept = self._joined()
        forces = self._force_verdicts(kept)
        lines = []
        for k, limit in enumerate(_LIMITS):
            force = limit.name == "force_limit"
            verdicts = forces if force else [EXCEEDED if n else WITHIN for n in self.count[k]]
            for verdict in (EXCEEDED, NOT_DECIDED, AT_REPLACED):
                legs = [leg for leg in range(6) if verdicts[leg] == verdict]
                if legs:
                    lines.append(self._of_legs(k, limit, f"{limit.name} {verdict}", legs, kept))
        return lines

    def _of_legs(self, k: int, limit: "_Limit", what: str, legs: list[int], kept: Part) -> str:
        """One line about a limit and the legs in question."""
        bound, least = limit.bound(self.robot), np.finfo(float).tiny
        beyond = {leg: _excess(self.robot, limit, leg, kept) for leg in legs}
        worst = max(legs, key=lambda leg: beyond[leg][1] / max(abs(float(bound[leg])), least))
        i, sd = beyond[worst][0], kept.F_sd if limit.name == "force_limit" else None
        spread = "" if sd is None else f" +- {sd[i, worst]:.3g}"
        value = f"{getattr(kept, limit.values)[i, worst]:.6g}{spread} {limit.unit}"
        value += f" at {time_text(kept.time[i], self.step)} s, limit {bound[worst]:g} {limit.unit}"
        names = f"{'leg' if len(legs) == 1 else 'legs'} {', '.join(str(leg + 1) for leg in legs)}"
        most = "" if len(legs) == 1 else f"worst leg {worst + 1}: "
        text = f"{what} by {names}: {most}{value}"
        if self.count[k, worst]:
            share = f"at {int(self.count[k, worst])} of {len(self.time)} instants"
            text += f"; beyond it for {self.span[k, worst]:.3g} s, {share}"
        elif what.endswith(AT_REPLACED):
            text += f"; kept away from {self._replaced_names()}"
        return text

    def summary(self) -> str:
        """What it comes to, lines of text."""
        kept = self._joined()
        time, F, F_sd, L, L_dot, condition = kept[1:7]
        verdicts, limit = self._force_verdicts(kept), self.robot.force_limit
        known = np.isfinite(L).all(axis=-1)
        rows = [
            (
                str(leg + 1),
                f"{F[i, leg]:.6g}" + ("" if F_sd is None else f" +- {F_sd[i, leg]:.2g}"),
                time_text(time[i], self.step),
                f"{limit[leg]:g}" + (f" {verdicts[leg]}" if np.isfinite(limit[leg]) else ""),
                f"{L[known, leg].min(initial=np.inf):.4g} to {L[known, leg].max(initial=-np.inf):.4g}",
                f"{np.abs(L_dot[known, leg]).max(initial=0.0):.4g}",
            )
            for leg, i in enumerate(_largest(F))
        ]
        first, last = (time_text(self.time[i], self.step) for i in (0, -1))
        worst = int(_largest(condition))
        header = ("leg", "peak force, N", "at, s", "force_limit, N", "length, m", "speed, m/s")
        text = (
            f"{len(self.time)} instant{'s' if len(self.time) > 1 else ''}, {first} to {last} s; condition "
            f"number of H up to {condition[worst]:.4g} (at {time_text(time[worst], self.step)} s)\n"
            f"{aligned(header, rows)}"
        )
        return text if self.drive is None else f"{text}\n\n{self.drive.table()}"

    def _force_verdicts(self, part: Part) -> list[str]:
        """``force_verdicts``, and ``AT_REPLACED`` where replaced rows alone leave a limit open."""
        verdicts, there = force_verdicts(self.robot, part.F, part.F_sd), self._at_replaced(part.time)
        if part.F_sd is None or not there.any():
            return verdicts
        elsewhere = force_verdicts(self.robot, part.F, np.where(there[:, None], 0.0, part.F_sd))
        return [
            AT_REPLACED if one == NOT_DECIDED and other == WITHIN else one
            for one, other in zip(verdicts, elsewhere, strict=True)
        ]

    def _at_replaced(self, time: Array) -> Flags:
        """Instants, (n,), whose deviations hold what is changed by replaced rows."""
        found = np.zeros(len(time), dtype=bool)
        for span in self.replaced:
            found |= (span.start <= time) & (time <= span.end)
        return found

    def _replaced_names(self) -> str:
        names = list(dict.fromkeys(name for span in self.replaced for name in span.rows))
        return ", ".join(names[:_MOST_NAMED]) + (
            f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
        )

    def as_json(self) -> dict[str, Any]:
        """What the summary says, for programs."""
        kept = self._joined()
        worst = int(_largest(kept.condition))
        verdicts, known = self._force_verdicts(kept), np.isfinite(kept.L).all(axis=-1)
        return {
            "instants": len(self.time),
            "start_s": self.time[0],
            "end_s": self.time[-1],
            "condition_number_peak": kept.condition[worst],
            "condition_number_peak_time_s": kept.time[worst],
            "legs": [
                {
                    "leg": leg + 1,
                    "peak_force_N": kept.F[i, leg],
                    "peak_force_sd_N": None if kept.F_sd is None else kept.F_sd[i, leg],
                    "peak_force_time_s": kept.time[i],
                    "force_limit_N": self.robot.force_limit[leg],
                    "force_limit": verdicts[leg],
                    "least_length_m": kept.L[known, leg].min(initial=np.inf),
                    "greatest_length_m": kept.L[known, leg].max(initial=-np.inf),
                    "peak_speed_m_per_s": np.abs(kept.L_dot[known, leg]).max(initial=0.0),
                    **({} if self.drive is None else self.drive.of_leg(leg)),
                }
                for leg, i in enumerate(_largest(kept.F))
            ],
        }

    def _joined(self) -> Part:
        arrays = [
            None if x[0] is None else np.concatenate(x)
            for x in zip(*(p[1:-2] for p in self.kept), strict=True)
        ]
        return Part(slice(None), *arrays, None)  # type: ignore[arg-type,call-arg]


class _Limit(NamedTuple):
    """A limit of the robot's legs: its name, unit, and the values of a part that it limits.

    end: column of the lowest or highest value; None for the largest magnitude.
    """

    name: str
    unit: str
    values: str
    end: int | None = None

    def bound(self, robot: Robot) -> Array:
        """The limit of each leg, (6,)."""
        limits: Array = getattr(robot, self.name)
        return limits if self.end is None else limits[:, self.end]

    def excess(self, robot: Robot, part: Part) -> Array:
        """By how much values are beyond it, (n, 6)."""
        values: Array = getattr(part, self.values)
        if self.end is None:
            return np.abs(values) - self.bound(robot)
        return np.asarray((values - self.bound(robot)) * (1.0 if self.end else -1.0))


_LIMITS = (
    _Limit("force_limit", "N", "F"),
    _Limit("speed_limit", "m/s", "L_dot"),
    _Limit("length_limits", "m", "L", 1),
    _Limit("length_limits", "m", "L", 0),
)


def exceeded(robot: Robot, time: Array, F: Array, L: Array, L_dot: Array) -> list[str]:
    """One line for each limit that a run exceeds, as ``Digest.exceeded``; arrays (n, 6)."""
    digest, none = Digest(robot, time), np.zeros(len(time))
    digest.add(Part(slice(None), time, F, None, L, L_dot, none, none.astype(np.int32), None))
    return digest.exceeded()


WITHIN, EXCEEDED, NOT_DECIDED = "kept", "exceeded", "not decided at this noise"
AT_REPLACED = "not decided at replaced rows"
# One line names at most so many replaced rows.
_MOST_NAMED = 4


def replaced_rows(trajectory: Trajectory | PoseLog) -> tuple[Replaced, ...]:
    """Rows of its log that a trajectory does not have as they were."""
    return () if trajectory.noise is None else trajectory.noise.replaced


def force_verdicts(robot: Robot, F: Array, F_sd: Array | None = None) -> list[str]:
    """``WITHIN``, ``EXCEEDED`` or ``NOT_DECIDED`` for each leg's force_limit; F, F_sd: N, (n, 6)."""
    spread = np.zeros_like(F) if F_sd is None else SURE * F_sd
    sure = np.any(np.abs(F) - spread > robot.force_limit, axis=0)
    maybe = np.any(np.abs(F) + spread > robot.force_limit, axis=0)
    return [EXCEEDED if sure[i] else NOT_DECIDED if maybe[i] else WITHIN for i in range(6)]


def _excess(robot: Robot, limit: _Limit, leg: int, part: Part) -> tuple[int, float]:
    """Instant at which a leg is farthest beyond its limit, by noise if by nothing else; how far."""
    excess = limit.excess(robot, part)[:, leg]
    if limit.name == "force_limit" and part.F_sd is not None and not (excess > 0.0).any():
        excess = excess + SURE * part.F_sd[:, leg]
    i = int(np.nanargmax(excess))
    return i, float(excess[i])


def _weights(time: Array) -> Array:
    """How long each instant stands for: half the way to both neighbours."""
    return np.gradient(elapsed(time)) if len(time) > 1 else np.zeros(1)


def _largest(values: Array) -> NDArray[np.int64]:
    """Instants, (...), of the largest magnitudes of values (n, ...)."""
    return np.asarray(np.argmax(np.nan_to_num(np.abs(values), nan=-1.0), axis=0))


def peak_noise(F: Array, F_sd: Array) -> Array:
    """Share of each leg's peak force, (6,), by which noise may hide a larger one, at any instant."""
    peak = np.nan_to_num(np.abs(F)).max(axis=0)
    possible = np.nan_to_num(np.abs(F) + SURE * F_sd).max(axis=0)
    return np.asarray((possible - peak) / np.maximum(peak, np.finfo(float).tiny))


def _noisy(when: list[str], F: Array, F_sd: Array, share: float, cause: str, there: Flags) -> str | None:
    """One line about the leg whose peak is least sure, if a cause makes more than the share of it.

    when: the instants, s. there: those, (n,), at which the deviations are the cause's.
    """
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
        f"a warning beyond {100.0 * share:.3g} % (--noise-share {share:g})"
        + (f"; {others} more leg{'s' if others > 1 else ''} likewise" if others else "")
    )


def _need_forces(robot: Robot, where: str) -> None:
    """Reject a robot whose numbers are so large that forces overflow at home, at rates of 1 in SI units."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        slow = Motion(np.eye(3), home_pose(robot).t, *np.ones((4, 3)))
        found = inverse_dynamics(robot, slow, backend="numpy", on_singular="nan")
    if found.status == NOT_FINITE:
        raise ValueError(
            f"robot {robot.name}: expected numbers whose forces do not overflow, at {where} they do"
        )


def _tell(trajectory: Trajectory | PoseLog, i: int, reason: str, allowed: bool) -> None:
    text = f"{trajectory.source}: row {trajectory.rows[i]}: {reason}"
    if not allowed:
        raise ValueError(text)
    warnings.warn(text, SingularPoseWarning, stacklevel=3)


def _lengths_and_rates(robot: Robot, motion: Motion, good: Flags) -> tuple[Array, Array]:
    L, L_dot = np.full((2, *motion.shape, 6), np.nan)
    if np.any(good):
        legs: LegKinematics = inverse_kinematics(robot, motion[good])
        L[good], L_dot[good] = legs.L, legs.L_dot
    return L, L_dot


def _reaction_columns(found: Reactions) -> Columns:
    columns: Columns = {}
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_s"):
        values = getattr(found, name)
        for leg in range(0 if values is None else 6):
            columns |= of_axes(f"{name}{leg + 1}", values[:, leg])
    return columns | of_legs("M_u", found.M_u)
