"""Data of a page: the robot as numbers with drawing sizes, and the motion as columns."""

from __future__ import annotations

import base64
import html
import itertools
import json
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..drives.limit_status import EXCEEDED, VERDICTS, shows
from ..drives.limits import PEAKS, RATED
from ..io.arguments import safe_text
from ..io.array_types import Array
from ..io.output import plain
from ..kinematics.conditioning import characteristic_length
from ..kinematics.mounting_side import platform_side, radius
from ..motion.rotation import quaternion_from_rotation
from ..motion.sample_times import least_step, time_text
from ..robot.offset_chains import chains
from ..robot.robot import Robot
from ..robot.units import Units
from .motion_history import Event, LimitReport, MotionHistory

# Drawn radius of a lower part and length of the axes, relative to the machine size; amplitude of a twist,
# relative to the characteristic length.
_THICK, _AXIS, _SWING = 0.028, 0.22, 0.25
# Largest radius of a lower part, relative to the shortest leg.
_THICK_OF_LEG = 0.06
# Default length of a lower part: at most these fractions of the shortest and the longest leg.
_LOWER, _LOWER_OF_LONGEST = 0.9, 0.62
# Overlap of the upper part with the lower part, and its largest length, relative to the shortest leg.
_WITHIN, _UPPER = 0.15, 0.93
# If the largest force exceeds the quantile by this factor, as near a singular pose, the colors end there.
_QUANTILE, _PEAK = 0.9, 4.0
# Number of displayed digits; lengths have one more.
_DIGITS = 5


def content(robot: Robot, shown: MotionHistory, limits: LimitReport) -> dict[str, Any]:
    """Return all data for the scripts of the page."""
    (scale, cut), units = _scale(shown), Units.of(robot)
    columns = {
        "time": _column(shown.time, "f8"),
        "t": _column(shown.motion.t),
        "q": _column(quaternion_from_rotation(shown.motion.R)),
        "L": _column(shown.L),
        "L_dot": _column(shown.L_dot),
        "condition": _column(shown.condition),
        **{f"F_{name}": _column(F) for name, F in shown.forces.items()},
        **_chain_columns(robot, shown),
        **_motor_columns(robot, limits),
        **{f"{name}_std": _column(sd) for name, sd in _deviations(robot, shown, limits)},
    }
    return {
        "machine": _machine(robot, shown),
        "units": {"length": 1.0 / units.meters, "lengthName": units.length},
        "forces": list(shown.forces),
        "motors": _motors(limits),
        "verdicts": {name: [*_runs(codes)] for name, codes in limits.codes.items() if codes.any()},
        "scale": scale,
        "cut": cut,
        "columns": columns,
        "events": [_event(event, least_step(shown.time), units) for event in shown.events],
    }


def data_text(data: dict[str, Any]) -> str:
    """Return data as JSON that is safe in an HTML block: no character in it can end the block."""
    text = json.dumps(plain(data), ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def parts_text(robot: Robot) -> str:
    """Return a sentence about the lengths of the drawn leg parts: from the robot file, or assumed."""
    stated = np.stack([robot.lower_length, robot.upper_length]) > 0.0
    if stated.all():
        return "The leg parts have the lengths of the robot file."
    which = "Some lengths" if stated.any() else "Lengths"
    return f"{which} of the leg parts are assumed: the robot file does not contain them."


def noise_html(shown: MotionHistory) -> str:
    """Return a paragraph about the noise of a log, or ""."""
    if shown.noise is None or not shown.noise.text:
        return ""
    text = html.escape(safe_text(shown.noise.text))
    return f'<p id="noise">{text}; \u00b1 is the remaining standard deviation</p>'


def limits_html(limits: LimitReport) -> str:
    """Return a section about exceeded and inconclusive limits of the robot file, or "" without limits."""
    if not limits.stated:
        return ""
    lines = [
        f'<li class="{"beyond" if verdict == EXCEEDED else "doubtful"}">{html.escape(safe_text(line))}</li>'
        for verdict, line in limits.told
    ]
    known = "forces, lengths, speeds, and motors" if np.isfinite(limits.F).any() else "lengths and speeds"
    kept = f"<p>The motion is within the limits of {known} in the robot file.</p>"
    said = f"<ul>{''.join(lines)}</ul>" if lines else kept
    return f'<section id="limits" aria-label="Limits"><h2>Limits</h2>{said}</section>'


def _column(values: Array, kind: str = "f4") -> dict[str, str]:
    """Encode numbers in base 64; single precision is enough for displayed digits, but not for times."""
    with np.errstate(over="ignore"):
        numbers = np.ascontiguousarray(values, dtype=f"<{kind}")
    return {"kind": kind, "data": base64.b64encode(numbers.tobytes()).decode()}


def _chain_columns(robot: Robot, shown: MotionHistory) -> dict[str, dict[str, str]]:
    """Return points and axes of the leg chains in the base frame, (n, 6, 3), for a robot with offset joints.

    moving: intersection of the moving axis and the common normal. foot, end: ends of the prismatic joint
    axis. lower, upper: axes across the leg parts, which turn with them.
    """
    if robot.offsets is None:
        return {}
    with np.errstate(all="ignore"):
        at = chains(robot, shown.motion)
    points = {"moving": at.A, "foot": at.T - at.L * at.s, "end": at.T}
    columns = {name: _column(robot.b + point) for name, point in points.items()}
    return columns | {"lower": _column(at.y), "upper": _column(at.U[..., 1])}


def _motor_columns(robot: Robot, limits: LimitReport) -> dict[str, dict[str, str]]:
    """Return the motor torques, from which the page computes current and power; with offsets also speeds."""
    if limits.motors is None:
        return {}
    found = {"torque": _column(limits.motors.torque)}
    return found if robot.offsets is None else found | {"speed": _column(limits.motors.speed)}


def _deviations(robot: Robot, shown: MotionHistory, limits: LimitReport) -> Iterator[tuple[str, Array]]:
    """Yield names and standard deviations of columns, if they affect displayed digits."""
    if shown.noise is None:
        return
    sd, motors = shown.noise.sd, limits.motors
    found = {f"F_{name}": F for name, F in shown.forces.items()} | {"L": shown.L, "L_dot": shown.L_dot}
    if motors is not None:
        names = ("torque", "power") if robot.offsets is None else ("torque", "power", "speed")
        found |= {name: getattr(motors, name) for name in names}
    for name, values in found.items():
        peak, most = (np.nan_to_num(np.abs(x), nan=0.0).max(axis=0, initial=0.0) for x in (values, sd[name]))
        if shows(peak, most, _DIGITS + (name == "L")).any():
            yield name, sd[name]


def _runs(codes: NDArray[np.uint8]) -> Iterator[list[int]]:
    """Yield leg, first sample, end, and status code of each run of samples outside a limit."""
    for leg, column in enumerate(codes.T):
        edges = [0, *(np.flatnonzero(np.diff(column)) + 1).tolist(), len(column)]
        for first, after in itertools.pairwise(edges):
            if column[first]:
                yield [leg, first, after, int(column[first])]


def _motors(limits: LimitReport) -> dict[str, Any] | None:
    """Return motor data: conversion factors of speeds and currents, limits, and RMS torques."""
    found, drive = limits.tracker, limits.tracker.robot.drive
    if drive is None:
        return None
    known = np.isfinite(limits.F).any(axis=0) & (found.weights.sum() > 0.0)
    return {
        "turns": drive.transmission_ratio,
        "constant": drive.torque_constant,
        "limits": {name: getattr(drive, f"{name}_limit") for name in PEAKS},
        "rated": drive.rated_torque,
        "rms": np.where(known, found.rms_torque, np.nan),
        "rmsDeviation": found.rms_torque_sd,
        "rmsVerdict": [VERDICTS.index(each) for each in found.verdicts(RATED)],
    }


def _machine(robot: Robot, shown: MotionHistory) -> dict[str, Any]:
    size = _size(robot)
    lower, upper = _parts(robot, shown.L)
    extent = _extent(robot, shown)
    with np.errstate(all="ignore"):
        thick = min(_THICK * size, _THICK_OF_LEG * float(np.nanmin(shown.L, initial=np.inf)))
    middle = 0.5 * (extent.min(axis=0) + extent.max(axis=0))
    return {
        "b": robot.b,
        "p": robot.p,
        "k": robot.k if robot.base_joint == "universal" else _across(robot, shown),
        "universal": robot.base_joint == "universal",
        "tool": robot.tool,
        "up": _up(robot),
        "baseRing": around(robot.b),
        "platformRing": around(robot.p),
        "lower": lower,
        "upper": upper,
        "forceLimit": robot.force_limit,
        "speedLimit": robot.speed_limit,
        "lengthLimits": robot.length_limits,
        "extent": extent,
        "middle": middle,
        "reach": float(np.linalg.norm(extent - middle, axis=-1).max()),
        "thick": thick or _THICK * size,
        "axis": _AXIS * size,
        "swing": _SWING * (characteristic_length(robot) or 1.0),
    }


def _size(robot: Robot) -> float:
    """Return the sum of the radii of base and platform (m)."""
    return (radius(robot.b) + radius(robot.p)) or 1.0


def _up(robot: Robot) -> Array:
    """Return the direction opposite to gravity, or, without gravity, toward the platform."""
    weight = float(np.linalg.norm(robot.g))
    return -robot.g / weight if weight > 0.0 else platform_side(robot).direction


def _parts(robot: Robot, L: Array) -> tuple[Array, Array]:
    """Return the lengths of lower and upper parts (m), (6,); default parts slide into each other."""
    with np.errstate(all="ignore"):
        shortest, longest = np.nanmin(L, axis=0), np.nanmax(L, axis=0)
    low, high = robot.length_limits.T
    shortest = np.where(low > 0.0, np.minimum(low, shortest), shortest)
    longest = np.where(np.isfinite(high), np.maximum(high, longest), longest)
    assumed = np.minimum(_LOWER * shortest, _LOWER_OF_LONGEST * longest)
    lower = np.where(robot.lower_length > 0.0, robot.lower_length, assumed)
    assumed = np.minimum(_UPPER * shortest, longest - lower + _WITHIN * shortest)
    return lower, np.where(robot.upper_length > 0.0, robot.upper_length, assumed)


def _extent(robot: Robot, shown: MotionHistory) -> Array:
    """Return points that must be visible (m), (n, 3): joints, tool, and axes in some of the poses."""
    some = np.linspace(0, len(shown.time) - 1, min(len(shown.time), 16)).astype(np.int64)
    R, t = shown.motion.R[some], shown.motion.t[some]
    points = np.concatenate([robot.p, robot.tool[None], _AXIS * _size(robot) * np.eye(3)])
    tips = np.einsum("njk,ik->nij", R, points) + t[:, None]
    return np.concatenate([robot.b, tips.reshape(-1, 3)])


def _across(robot: Robot, shown: MotionHistory) -> Array:
    """Return directions normal to the legs at the first pose, (6, 3), for spherical base joints."""
    S = shown.motion.R[0] @ robot.p.T + shown.motion.t[0][:, None] - robot.b.T
    least = np.eye(3)[np.argmin(np.abs(S), axis=0)]
    across = np.cross(S.T, least)
    return np.asarray(across / np.linalg.norm(across, axis=-1, keepdims=True))


def around(points: Array) -> NDArray[np.int64]:
    """Return the order of points by their angle about their mean, in the plane that fits them best."""
    from_middle = points - points.mean(axis=0)
    across = from_middle @ np.linalg.svd(from_middle)[2][:2].T
    return np.argsort(np.arctan2(across[:, 1], across[:, 0]), kind="stable")


def _scale(shown: MotionHistory) -> tuple[float, float | None]:
    """Return the force (N) at which the colors end, and the force at which curves are cut, or None."""
    sizes = np.abs(np.concatenate([F.ravel() for F in shown.forces.values()] or [np.zeros(1)]))
    sizes = sizes[np.isfinite(sizes)]
    if not sizes.size:
        return 1.0, None
    most, usual = float(sizes.max()), float(np.quantile(sizes, _QUANTILE))
    if usual > 0.0 and most > _PEAK * usual:
        return usual, _PEAK * usual
    return most or 1.0, None


def _event(event: Event, step: float, units: Units) -> dict[str, Any]:
    at, pitch = event.at, float(event.at.screw_pitch) * units.radians / units.meters
    turns = bool(np.isfinite(at.screw_pitch))
    screw = (
        f"rotation about {_triple(at.screw_axis)} through {_triple(at.screw_point / units.meters)} "
        f"{units.length}, pitch {pitch:.4g} {units.length}/{units.angle}"
        if turns
        else f"translation along {_triple(at.screw_axis)}"
    )
    return {
        "time": event.time,
        "text": time_text(event.time, step),
        "singular": event.singular,
        "pose": {"t": event.motion.t, "R": event.motion.R},
        "twist": at.twist,
        "axis": at.screw_axis if turns else None,
        "point": at.screw_point if turns else None,
        "words": f"{'unconstrained' if event.singular else 'least-rate'} twist: {screw}; condition number "
        f"{float(at.condition_number):.4g}".replace("inf", "\u221e"),
    }


def _triple(values: Array) -> str:
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.4g}" for value in values) + ")"
