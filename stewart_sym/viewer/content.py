"""The data of a page: the machine as plain numbers with sizes to draw it by, and the motion as columns."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.instants import least_step, time_text
from ..io.json_text import plain
from ..kinematics.conditioning import characteristic_length
from ..kinematics.mounting import platform_side, radius
from ..motion.rotation import quaternion_from_rotation
from ..robot.offset_chains import chains
from ..robot.robot import Robot
from .instants import Event, Instants

# Radius of a lower part and length of the axes as drawn, over the machine's size; how far a twist swings the
# platform, over its characteristic length.
_THICK, _AXIS, _SWING = 0.028, 0.22, 0.25
# Largest radius of a lower part, over the shortest leg.
_THICK_OF_LEG = 0.06
# Length of a lower part where the file states none: at most these shares of the shortest and the longest leg.
_LOWER, _LOWER_OF_LONGEST = 0.9, 0.62
# How far an upper part stays within the lower one, and how long it is at most, over the shortest leg.
_WITHIN, _UPPER = 0.15, 0.93
# Where the largest force exceeds the quantile by this factor, as beside a singular pose, colours end there.
_QUANTILE, _PEAK = 0.9, 4.0
# Size below which machines are shown in millimetres, m.
_SMALL = 2.0


def content(robot: Robot, shown: Instants) -> dict[str, Any]:
    """Everything that the page's scripts read."""
    scale, cut = _scale(shown)
    columns = {
        "time": _column(shown.time, "f8"),
        "t": _column(shown.motion.t),
        "q": _column(quaternion_from_rotation(shown.motion.R)),
        "L": _column(shown.L),
        "L_dot": _column(shown.L_dot),
        "condition": _column(shown.condition),
        **{f"F_{name}": _column(F) for name, F in shown.forces.items()},
        **_chain_columns(robot, shown),
    }
    return {
        "machine": _machine(robot, shown),
        "units": units(robot),
        "forces": list(shown.forces),
        "scale": scale,
        "cut": cut,
        "columns": columns,
        "events": [_event(event, least_step(shown.time), units(robot)) for event in shown.events],
    }


def units(robot: Robot) -> dict[str, Any]:
    """Unit in which lengths are shown, and how many of it are a metre."""
    small = _size(robot) < _SMALL
    return {"length": 1e3 if small else 1.0, "lengthName": "mm" if small else "m"}


def data_text(data: dict[str, Any]) -> str:
    """Data as JSON that may stand in a block of HTML: nothing in it ends the block."""
    text = json.dumps(plain(data), ensure_ascii=True, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def parts_text(robot: Robot) -> str:
    """Whether the legs' parts are drawn as long as they are, in words."""
    stated = np.stack([robot.lower_length, robot.upper_length]) > 0.0
    if stated.all():
        return "The legs' parts have the lengths of the robot file."
    which = "Some lengths" if stated.any() else "Lengths"
    return f"{which} of the legs' parts are assumed: the robot file states none."


# Parts


def _column(values: Array, kind: str = "f4") -> dict[str, str]:
    """Numbers in base 64; single precision has the digits that are shown, times need all of theirs."""
    with np.errstate(over="ignore"):
        numbers = np.ascontiguousarray(values, dtype=f"<{kind}")
    return {"kind": kind, "data": base64.b64encode(numbers.tobytes()).decode()}


def _chain_columns(robot: Robot, shown: Instants) -> dict[str, dict[str, str]]:
    """Points and axes of the legs' chains, base frame, (n, 6, 3), of a robot with offset joints.

    moving: where the moving axis meets the common normal; foot, end: of the line of sliding; lower, upper:
    axes across the parts, which turn with them.
    """
    if robot.offsets is None:
        return {}
    with np.errstate(all="ignore"):
        at = chains(robot, shown.motion)
    points = {"moving": at.A, "foot": at.T - at.L * at.s, "end": at.T}
    columns = {name: _column(robot.b + point) for name, point in points.items()}
    return columns | {"lower": _column(at.y), "upper": _column(at.U[..., 1])}


def _machine(robot: Robot, shown: Instants) -> dict[str, Any]:
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
        "baseRing": _around(robot.b),
        "platformRing": _around(robot.p),
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
    """Radii of base and platform together, m."""
    return (radius(robot.b) + radius(robot.p)) or 1.0


def _up(robot: Robot) -> Array:
    """Against gravity: what hangs is shown hanging. Without gravity to the platform's side."""
    weight = float(np.linalg.norm(robot.g))
    return -robot.g / weight if weight > 0.0 else platform_side(robot).direction


def _parts(robot: Robot, L: Array) -> tuple[Array, Array]:
    """Lengths of lower and upper parts, m, (6,): as stated, else such that they slide into each other."""
    with np.errstate(all="ignore"):
        shortest, longest = np.nanmin(L, axis=0), np.nanmax(L, axis=0)
    low, high = robot.length_limits.T
    shortest = np.where(low > 0.0, np.minimum(low, shortest), shortest)
    longest = np.where(np.isfinite(high), np.maximum(high, longest), longest)
    assumed = np.minimum(_LOWER * shortest, _LOWER_OF_LONGEST * longest)
    lower = np.where(robot.lower_length > 0.0, robot.lower_length, assumed)
    assumed = np.minimum(_UPPER * shortest, longest - lower + _WITHIN * shortest)
    return lower, np.where(robot.upper_length > 0.0, robot.upper_length, assumed)


def _extent(robot: Robot, shown: Instants) -> Array:
    """Points that must be seen, m, (n, 3): joints, tool and axes in some of the poses."""
    some = np.linspace(0, len(shown.time) - 1, min(len(shown.time), 16)).astype(np.int64)
    R, t = shown.motion.R[some], shown.motion.t[some]
    points = np.concatenate([robot.p, robot.tool[None], _AXIS * _size(robot) * np.eye(3)])
    tips = np.einsum("njk,ik->nij", R, points) + t[:, None]
    return np.concatenate([robot.b, tips.reshape(-1, 3)])


def _across(robot: Robot, shown: Instants) -> Array:
    """Directions across the legs of the first pose, (6, 3): legs with spherical joints don't show a spin."""
    S = shown.motion.R[0] @ robot.p.T + shown.motion.t[0][:, None] - robot.b.T
    least = np.eye(3)[np.argmin(np.abs(S), axis=0)]
    across = np.cross(S.T, least)
    return np.asarray(across / np.linalg.norm(across, axis=-1, keepdims=True))


def _around(points: Array) -> NDArray[np.int64]:
    """Order of points by their angle about their middle, in the plane that fits them best."""
    from_middle = points - points.mean(axis=0)
    across = from_middle @ np.linalg.svd(from_middle)[2][:2].T
    return np.argsort(np.arctan2(across[:, 1], across[:, 0]), kind="stable")


def _scale(shown: Instants) -> tuple[float, float | None]:
    """Force at which the colours end, N, and the force at which curves are cut, None where none is."""
    sizes = np.abs(np.concatenate([F.ravel() for F in shown.forces.values()] or [np.zeros(1)]))
    sizes = sizes[np.isfinite(sizes)]
    if not sizes.size:
        return 1.0, None
    most, usual = float(sizes.max()), float(np.quantile(sizes, _QUANTILE))
    if usual > 0.0 and most > _PEAK * usual:
        return usual, _PEAK * usual
    return most or 1.0, None


def _event(event: Event, step: float, units: dict[str, Any]) -> dict[str, Any]:
    at, length, unit = event.at, units["length"], units["lengthName"]
    turns = bool(np.isfinite(at.pitch))
    screw = (
        f"turn about {_triple(at.axis)} through {_triple(length * at.point)} {unit}, "
        f"pitch {length * float(at.pitch):.4g} {unit}/rad"
        if turns
        else f"translation along {_triple(at.axis)}"
    )
    return {
        "time": event.time,
        "text": time_text(event.time, step),
        "singular": event.singular,
        "pose": {"t": event.motion.t, "R": event.motion.R},
        "twist": at.twist,
        "axis": at.axis if turns else None,
        "point": at.point if turns else None,
        "words": f"{'unconstrained' if event.singular else 'least held'} twist: {screw}; condition number "
        f"{float(at.condition):.4g}".replace("inf", "\u221e"),
    }


def _triple(values: Array) -> str:
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.4g}" for value in values) + ")"
