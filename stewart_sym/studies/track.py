"""A trajectory run through the dynamics, as ``forces`` writes it: columns, limits exceeded, a summary.

Takes a Robot and a Trajectory; reads and writes no file.
"""

import warnings
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..conditioning import condition_number
from ..dynamics import (
    Backend,
    Formulation,
    first_fault,
    inverse_dynamics,
    joint_reactions,
)
from ..faults import SingularPoseWarning
from ..force_noise import force_deviations
from ..kinematics import LegKinematics, inverse_kinematics
from ..motion import Motion
from ..results import NOT_FINITE, OK, SHORT_LEG, Reactions
from ..robot import Robot
from ..trajectory import Trajectory
from .table import aligned

Array = NDArray[np.float64]
Columns = dict[str, NDArray[Any]]


SURE = 3.0
"""Deviations within which a force is taken to lie: 99.7 % of normal errors."""

NOISE_SHARE = 0.02
"""Share of a leg's peak force that noise may make of it, ``SURE`` deviations, without a warning."""


_PART = 1 << 16


class Track(NamedTuple):
    """A trajectory run through the dynamics.

    columns: (n,) by name, as written. doubts: one line for each limit exceeded or not decided, and for noise.
    summary: what it comes to, lines of text.
    """

    columns: Columns
    doubts: list[str]
    summary: str


def track(
    robot: Robot,
    trajectory: Trajectory,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    reactions: bool = False,
    allow_singular: bool = False,
    noise_share: float = NOISE_SHARE,
) -> Track:
    """Run a trajectory of n instants.

    Columns are in SI units: time, F1..F6, with noise in the log F1_sd..F6_sd, L1..L6, condition_number,
    status and, with ``reactions``, the components of F_s, F_u, F_p, F_c, M_p (about the base point) and M_u
    leg by leg.  Raises ValueError, naming file and row, for an unsolvable pose; ``allow_singular``
    leaves nan and a status there and warns instead.
    """
    time, motion = trajectory.time, trajectory.motion
    F, condition, status, L, L_dot = _in_parts(robot, motion, formulation, backend)
    more = None
    if reactions:
        more = joint_reactions(robot, motion, formulation, backend, on_singular="nan")
        status = np.where(status == OK, more.status, status)
    if status.any():
        _tell(trajectory, *first_fault(status, robot, motion), allow_singular)
    F_sd = None
    if trajectory.noise is not None:
        F_sd = force_deviations(robot, trajectory, formulation, backend)
    columns: Columns = {"time": time}
    columns |= {f"F{i + 1}": F[:, i] for i in range(6)}
    if F_sd is not None:
        columns |= {f"F{i + 1}_sd": F_sd[:, i] for i in range(6)}
    columns |= {f"L{i + 1}": L[:, i] for i in range(6)}
    columns |= {"condition_number": condition, "status": status}
    if more is not None:
        columns |= _reaction_columns(more)
    doubts = exceeded(robot, time, F, L, L_dot, F_sd)
    if F_sd is not None:
        doubts += _noisy(time, F, F_sd, noise_share)
    return Track(columns, doubts, _summary(robot, time, F, F_sd, L, L_dot, condition))


def _in_parts(
    robot: Robot, motion: Motion, formulation: Formulation, backend: Backend
) -> tuple[Array, Array, NDArray[np.int32], Array, Array]:
    """F, condition number of H, status, L and L_dot; all outputs of the kernels at once would fill memory."""
    parts = []
    for start in range(0, max(1, motion.shape[0]), _PART):
        part = motion[start : start + _PART]
        found = inverse_dynamics(robot, part, formulation, backend, on_singular="nan")
        lengths = _lengths_and_rates(robot, part, ~np.isin(found.status, (SHORT_LEG, NOT_FINITE)))
        parts.append((found.F, condition_number(found.H), found.status, *lengths))
    F, condition, status, L, L_dot = (np.concatenate(each) for each in zip(*parts, strict=True))
    return F, condition, status, L, L_dot


def exceeded(
    robot: Robot, time: Array, F: Array, L: Array, L_dot: Array, F_sd: Array | None = None
) -> list[str]:
    """One line for each limit and leg: its worst value, when and how long; arrays (n, 6).

    With deviations F_sd a force limit is exceeded where the force is beyond it by ``SURE`` of them, and not
    decided where it is nearer.
    """
    low, high = robot.length_limits.T
    beyond = np.abs(F) - robot.force_limit
    verdicts = force_verdicts(robot, F, F_sd)
    lines = [
        _worst(f"force_limit {verdicts[leg]}", leg, beyond[:, leg], time, F, F_sd, robot.force_limit, "N")
        for leg in range(6)
        if verdicts[leg] != WITHIN
    ]
    for name, excess, values, limit, unit in (
        ("speed_limit", np.abs(L_dot) - robot.speed_limit, L_dot, robot.speed_limit, "m/s"),
        ("length_limits", L - high, L, high, "m"),
        ("length_limits", low - L, L, low, "m"),
    ):
        lines += [
            _worst(f"{name} exceeded", int(leg), excess[:, leg], time, values, None, limit, unit)
            for leg in np.flatnonzero((excess > 0.0).any(axis=0))
        ]
    return lines


def length_doubt(robot: Robot, lengths: Array) -> str | None:
    """One line about distances, m, that are no machine's of the robot's size; None for plausible ones."""
    size = max(float(np.ptp(robot.b, axis=0).max()), float(np.ptp(robot.p, axis=0).max()))
    typical = float(np.median(np.abs(lengths)))
    if typical <= _FAR * size:
        return None
    return (
        f"lengths of {typical:.4g} m beside a machine of {size:.4g} m: "
        "are they in another unit (--length-unit mm)?"
    )


_FAR = 20.0
WITHIN, EXCEEDED, NOT_DECIDED = "kept", "exceeded", "not decided at this noise"


def force_verdicts(robot: Robot, F: Array, F_sd: Array | None = None) -> list[str]:
    """``WITHIN``, ``EXCEEDED`` or ``NOT_DECIDED`` for each leg's force_limit; F, F_sd: N, (n, 6)."""
    spread = np.zeros_like(F) if F_sd is None else SURE * F_sd
    sure = np.any(np.abs(F) - spread > robot.force_limit, axis=0)
    maybe = np.any(np.abs(F) + spread > robot.force_limit, axis=0)
    return [EXCEEDED if sure[i] else NOT_DECIDED if maybe[i] else WITHIN for i in range(6)]


def _worst(
    what: str, leg: int, excess: Array, time: Array, values: Array, sd: Array | None, limit: Array, unit: str
) -> str:
    over = excess > 0.0
    i = int(np.nanargmax(excess if sd is None or over.any() else excess + SURE * sd[:, leg]))
    spread = "" if sd is None else f" +- {sd[i, leg]:.3g}"
    value = f"{values[i, leg]:.6g}{spread} {unit} at {time[i]:g} s"
    text = f"{what} by leg {leg + 1}: {value}, limit {limit[leg]:g} {unit}"
    if not over.any():
        return text
    span = _weights(time)[over].sum()
    return f"{text}; beyond it for {span:.3g} s, at {np.count_nonzero(over)} of {len(time)} instants"


def _weights(time: Array) -> Array:
    """How long each instant stands for: half the way to both neighbours."""
    return np.gradient(time) if len(time) > 1 else np.zeros(1)


def _peaks(F: Array) -> NDArray[np.int64]:
    """Index of each leg's largest force, (6,)."""
    return np.asarray(np.argmax(np.nan_to_num(np.abs(F), nan=-1.0), axis=0))


def peak_noise(F: Array, F_sd: Array) -> Array:
    """Share of each leg's peak force, (6,), by which noise may hide a larger one, at any instant."""
    peak = np.nan_to_num(np.abs(F)).max(axis=0)
    possible = np.nan_to_num(np.abs(F) + SURE * F_sd).max(axis=0)
    return np.asarray((possible - peak) / np.maximum(peak, np.finfo(float).tiny))


def _noisy(time: Array, F: Array, F_sd: Array, share: float) -> list[str]:
    """One line about the leg whose peak is least sure, if that is less sure than the share."""
    ratio = peak_noise(F, F_sd)
    leg = int(np.argmax(ratio))
    if not ratio[leg] > share:
        return []
    i = int(np.argmax(np.nan_to_num(np.abs(F) + SURE * F_sd)[:, leg]))
    return [
        f"noise in the log leaves {ratio[leg]:.2g} of leg {leg + 1}'s peak force open, more than {share:g} "
        f"({SURE:g} deviations): {F[i, leg]:.6g} +- {F_sd[i, leg]:.3g} N at {time[i]:g} s; "
        f"so for {np.count_nonzero(ratio > share)} of 6 legs"
    ]


def _summary(
    robot: Robot, time: Array, F: Array, F_sd: Array | None, L: Array, L_dot: Array, condition: Array
) -> str:
    peaks, verdicts, known = _peaks(F), force_verdicts(robot, F, F_sd), np.isfinite(L).all(axis=-1)
    rows = [
        (
            str(leg + 1),
            f"{F[i, leg]:.6g}" + ("" if F_sd is None else f" +- {F_sd[i, leg]:.2g}"),
            f"{time[i]:g}",
            f"{robot.force_limit[leg]:g}"
            + (f" {verdicts[leg]}" if np.isfinite(robot.force_limit[leg]) else ""),
            f"{L[known, leg].min(initial=np.inf):.4g} to {L[known, leg].max(initial=-np.inf):.4g}",
            f"{np.abs(L_dot[known, leg]).max(initial=0.0):.4g}",
        )
        for leg, i in enumerate(peaks)
    ]
    worst = int(np.argmax(np.nan_to_num(condition, nan=-1.0)))
    return "\n".join(
        [
            f"{len(time)} instants, {time[0]:g} to {time[-1]:g} s; condition number of H up to "
            f"{condition[worst]:.4g} (at {time[worst]:g} s)",
            aligned(("leg", "peak force, N", "at, s", "force_limit, N", "length, m", "speed, m/s"), rows),
        ]
    )


def _tell(trajectory: Trajectory, where: tuple[int, ...], reason: str, allowed: bool) -> None:
    text = f"{trajectory.source}: row {trajectory.rows[where[0]]}: {reason}"
    if not allowed:
        raise ValueError(text)
    warnings.warn(text, SingularPoseWarning, stacklevel=3)


def _lengths_and_rates(robot: Robot, motion: Motion, good: NDArray[np.bool_]) -> tuple[Array, Array]:
    L, L_dot = np.full((2, *motion.shape, 6), np.nan)
    if np.any(good):
        legs: LegKinematics = inverse_kinematics(robot, motion[good])
        L[good], L_dot[good] = legs.L, legs.L_dot
    return L, L_dot


def _reaction_columns(found: Reactions) -> Mapping[str, Array]:
    columns: dict[str, Array] = {}
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p"):
        values = getattr(found, name)
        for leg in range(6):
            columns |= {f"{name}{leg + 1}_{axis}": values[:, leg, j] for j, axis in enumerate("xyz")}
    return columns | {f"M_u{leg + 1}": found.M_u[:, leg] for leg in range(6)}
