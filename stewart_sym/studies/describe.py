"""What ``check`` says of a robot: sizes, masses, limits, and its condition at a home pose at rest.

Reads a checked Robot; prints nothing.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..conditioning import characteristic_length, condition_number, scaled_condition_number
from ..dynamics import inverse_dynamics
from ..motion import Motion
from ..results import STATUS_TEXT
from ..robot import Robot

Array = NDArray[np.float64]

_HEIGHTS = 400


@dataclass(frozen=True, eq=False)
class HomePose:
    """The level platform at rest, its points centred above the base points (along z of the base frame).

    rule: how the height was chosen. t: position of the reference point, m, (3,). L: leg lengths, m, (6,).
    F: forces that hold it there, N, (6,), NaN if none can. condition, scaled_condition: of H. status: a code
    of ``STATUS_TEXT``.
    """

    rule: str
    t: Array
    L: Array
    F: Array
    condition: float
    scaled_condition: float
    status: int


def home_pose(robot: Robot) -> HomePose:
    """Choose a height: legs in the middle of their length limits, or where there are none H at its best."""
    centre = robot.b.mean(axis=0) - robot.p.mean(axis=0)
    size = _radius(robot.b) + _radius(robot.p)
    up = np.linspace(0.05, 3.0, _HEIGHTS)[:, None] * size * np.array([0.0, 0.0, 1.0])
    t = centre + up
    L = _lengths(robot, t)
    forces = inverse_dynamics(robot, _resting(t), backend="numpy", on_singular="nan")
    scaled = scaled_condition_number(forces.H, characteristic_length(robot))
    if np.all(np.isfinite(robot.length_limits)):
        rule = "the height that puts the legs, on average, in the middle of their length limits"
        best = int(np.argmin(np.abs(L.mean(axis=-1) - robot.length_limits.mean())))
    else:
        rule = "no length limits are given: the height with the least scaled condition number"
        best = int(np.argmin(np.nan_to_num(scaled, nan=np.inf)))
    return HomePose(
        rule=rule,
        t=t[best],
        L=L[best],
        F=forces.F[best],
        condition=float(condition_number(forces.H[best])),
        scaled_condition=float(scaled[best]),
        status=int(forces.status[best]),
    )


def description(robot: Robot) -> str:
    """Everything about the robot in lines of text, SI units."""
    rows = [
        ("name", robot.name),
        ("joints", f"{robot.base_joint} below, spherical above"),
        ("gravity", f"{_vector(robot.g)} m/s^2"),
        ("platform", f"{robot.M:g} kg, centre of mass {_vector(robot.R_0)} m"),
        (
            "legs",
            f"{_range(robot.m_d + robot.m_u)} kg each (lower {_range(robot.m_d)}, upper {_range(robot.m_u)})",
        ),
        ("mass ratio", f"platform to one leg {robot.M / np.mean(robot.m_d + robot.m_u):.3g}"),
        (
            "size",
            f"base points {_radius(robot.b):.4g} m, platform points {_radius(robot.p):.4g} m (RMS radius)",
        ),
        ("friction", _friction(robot)),
        ("limits", _limits(robot)),
        ("inertias", _inertias(robot)),
    ]
    return "\n".join([*_rows(rows), "", *_home_lines(robot, home_pose(robot))])


def _home_lines(robot: Robot, home: HomePose) -> list[str]:
    shortest, longest = robot.length_limits.T
    outside = (home.L < shortest) | (home.L > longest)
    legs = ", ".join(str(i + 1) for i in np.flatnonzero(outside))
    rows = [
        ("position", f"{_vector(home.t)} m, level, at rest"),
        ("leg lengths", f"{_vector(home.L)} m" + (f"; outside their limits: leg {legs}" if legs else "")),
    ]
    if home.status:
        rows.append(("condition", f"no answer here: {STATUS_TEXT[home.status]}"))
    else:
        length = characteristic_length(robot)
        scaled = f"{home.scaled_condition:.4g} with moments divided by {length:.4g} m"
        rows.append(("condition", f"condition number of H {home.condition:.4g}; {scaled}"))
        rows.append(("holding", f"{_vector(home.F)} N"))
    return [f"home pose: platform centred above the base; {home.rule}", *_rows(rows)]


def _rows(rows: list[tuple[str, str]]) -> list[str]:
    return [f"{name:<12} {text}" for name, text in rows]


def _friction(robot: Robot) -> str:
    coefficients = {"universal": robot.C_u, "prismatic": robot.C_p, "spherical": robot.C_s}
    if not any(np.any(C) for C in coefficients.values()):
        return "off"
    units = {"universal": "N m s", "prismatic": "N s/m", "spherical": "N m s"}
    base = {"universal": "base joint", "prismatic": "prismatic", "spherical": "spherical"}
    return "on: " + ", ".join(f"{base[name]} {_range(C)} {units[name]}" for name, C in coefficients.items())


def _limits(robot: Robot) -> str:
    parts = []
    for name, low, high, unit in (
        ("length", robot.length_limits[:, 0], robot.length_limits[:, 1], "m"),
        ("force", None, robot.force_limit, "N"),
        ("speed", None, robot.speed_limit, "m/s"),
    ):
        legs = int(np.count_nonzero(np.isfinite(high)))
        if not legs:
            parts.append(f"{name} none")
            continue
        some = "" if legs == len(high) else f" ({legs} of 6 legs)"
        given = np.isfinite(high)
        span = _range(high[given]) if low is None else f"{_range(low[given])} to {_range(high[given])}"
        parts.append(f"{name} {span} {unit}{some}")
    return "; ".join(parts)


def _inertias(robot: Robot) -> str:
    count = len(robot.physicality())
    return f"{count} that no rigid body can have (see the warnings)" if count else "physically possible"


def _range(values: Array) -> str:
    low, high = float(np.min(values)), float(np.max(values))
    return f"{low:g}" if low == high else f"{low:g}-{high:g}"


def _vector(values: Array) -> str:
    return "(" + ", ".join(f"{round(value, 4) + 0.0:g}" for value in values.tolist()) + ")"


def _radius(points: Array) -> float:
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=-1))))


def _lengths(robot: Robot, t: Array) -> Array:
    return np.asarray(np.linalg.norm(t[:, None, :] + robot.p - robot.b, axis=-1))


def _resting(t: Array) -> Motion:
    zero = np.zeros(3)
    return Motion(np.eye(3), t, zero, zero, zero, zero)
