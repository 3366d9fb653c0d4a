"""A drawing of the conventions: frames, fixed axis, leg frame, centers of mass, sign of F.

Everything drawn comes from the kinematics of a machine with few clear proportions; the page
``.docs/conventions.md`` explains it.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stewart_sym.motion.rotation import rotation_from_rpy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

LEG = 0
"""The leg that is drawn with its frame."""

_BASE, _PLATFORM = 1.0, 0.62
_POSE = (np.array([0.1, 0.12, 1.35]), np.array([0.12, -0.1, 0.15]))
_BASE_COLOR, _PLATFORM_COLOR, _LEG_COLOR, _FORCE_COLOR = "#3a3a3a", "#1f4e9c", "#2a8a4a", "#c1440e"


def _hexagon(radius: float, angles: Array) -> Array:
    return radius * np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=1)


def _machine() -> tuple[Array, Array, Array, Array]:
    """Base points, platform points in the base frame, R and t of the platform."""
    turns = np.radians(np.repeat([-60.0, 60.0, 180.0], 2))
    b = _hexagon(_BASE, turns + np.radians(np.tile([-14.0, 14.0], 3)))
    p = _hexagon(_PLATFORM, turns + np.radians(np.tile([-42.0, 42.0], 3)))
    t, theta = _POSE
    R = rotation_from_rpy(theta)
    return b, t + p @ R.T, R, t


def figure() -> "Figure":
    """The drawing, 8 by 7.2 inches."""
    from matplotlib.figure import Figure

    drawing = Figure(figsize=(8.0, 7.2))
    axes: Any = drawing.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d")
    axes.set_axis_off()
    axes.view_init(elev=17.0, azim=-52.0)
    b, tips, R, t = _machine()
    for points, color in ((b, _BASE_COLOR), (tips, _PLATFORM_COLOR)):
        ring = np.vstack([points, points[:1]])
        axes.plot(*ring.T, color=color, linewidth=2.0)
    for i in range(6):
        axes.plot(*np.stack([b[i], tips[i]]).T, color="#b0b0b0" if i != LEG else _LEG_COLOR, linewidth=2.4)
    _frame(axes, np.zeros(3), np.eye(3), 0.45, ("X", "Y", "Z"), _BASE_COLOR)
    _frame(axes, t, R, 0.42, ("x$_P$", "y$_P$", "z$_P$"), _PLATFORM_COLOR)
    _label(axes, [0.1, -0.25, -0.08], "base frame", _BASE_COLOR)
    _label(
        axes,
        t + np.array([0.12, 0.0, 0.42]),
        "platform frame: its origin, the\nreference point, is yours to choose",
        _PLATFORM_COLOR,
    )
    _arrow(axes, np.zeros(3), t, "#8a8a8a", "t", dashed=True)
    _leg(axes, b[LEG], tips[LEG])
    axes.set_box_aspect((1.0, 1.0, 0.95), zoom=1.22)
    axes.set(xlim=(-0.95, 0.95), ylim=(-0.95, 0.95), zlim=(-0.12, 1.68))
    return drawing


def _leg(axes: Any, base: Array, tip: Array) -> None:
    """One leg: its ends, fixed axis k, frame, centers of mass and actuator force."""
    S = tip - base
    L = float(np.linalg.norm(S))
    s = S / L
    k = np.array([0.9, -0.35, 0.0]) / np.hypot(0.9, 0.35)
    y = np.cross(k, s) / np.linalg.norm(np.cross(k, s))
    z = np.cross(s, y)
    axes.scatter(*np.stack([base, tip]).T, color=_LEG_COLOR, s=36)
    left = np.array([-0.06, -0.02, 0.0])
    _label(axes, base + left + [0.0, 0.0, -0.1], "base point b$_1$", _LEG_COLOR, "right")
    _label(axes, tip + left - [0.0, 0.0, 0.04], "platform point p$_1$", _LEG_COLOR, "right")
    _arrow(axes, base, base + 0.4 * k, "#7a3fa0", "k, fixed axis of the\nuniversal joint")
    _frame(axes, base, np.stack([s, y, z], axis=1), 0.38, ("x = s", "y = k x s / |k x s|", "z"), _LEG_COLOR)
    for share, part, place in ((0.36, "lower", "x > 0 from b$_1$"), (0.72, "upper", "x < 0 from p$_1$")):
        at = base + share * S
        axes.scatter(*at[:, None], color="white", edgecolors=_LEG_COLOR, s=70, linewidths=2.0)
        _label(axes, at + left, f"center of mass, {part} part:\n{place}", _LEG_COLOR, "right")
    _arrow(axes, tip, tip + 0.34 * s, _FORCE_COLOR, "")
    _arrow(axes, base, base - 0.22 * s, _FORCE_COLOR, "")
    _label(
        axes,
        tip + 0.36 * s + left,
        "F > 0 extends the leg and\npushes the platform away",
        _FORCE_COLOR,
        "right",
    )


def _label(axes: Any, at: Any, text: str, color: str, side: str = "left") -> None:
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.6}
    axes.text(*at, text, color=color, ha=side, va="center", fontsize=9.5, bbox=box, zorder=10)


def _frame(axes: Any, origin: Array, R: Array, length: float, names: tuple[str, ...], color: str) -> None:
    for column, name in zip(R.T, names, strict=True):
        _arrow(axes, origin, origin + length * column, color, name)


def _arrow(axes: Any, start: Array, end: Array, color: str, name: str, dashed: bool = False) -> None:
    axes.quiver(
        *start,
        *(end - start),
        color=color,
        linewidth=1.6,
        arrow_length_ratio=0.09 if dashed else 0.16,
        linestyle="--" if dashed else "-",
    )
    place = start + (0.6 if dashed else 1.09) * (end - start) + (0.04 if dashed else 0.0)
    if name:
        left = name.startswith("y = ")
        _label(axes, place, name, color, "right" if left else "left")


def save(target: Path) -> None:
    """Write the drawing as PNG."""
    figure().savefig(target, dpi=110)
