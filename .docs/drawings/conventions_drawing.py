"""Drawing of the conventions: frames, fixed axis, leg frame, centers of mass, and sign of F.

The drawing is computed from the kinematics of a machine with clear proportions. The page
``.docs/conventions.md`` explains it.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from drawing_sheet import AXIS, BASE, FORCE, GRAY, LOWER, PAPER, PLATFORM, Array

from stewart_sym.motion.rotation import rotation_from_rpy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEG = 0
"""Index of the leg that is drawn with its frame."""

_BASE, _PLATFORM = 1.0, 0.62
_POSE = (np.array([0.1, 0.12, 1.35]), np.array([0.12, -0.1, 0.15]))


def _hexagon(radius: float, angles: Array) -> Array:
    return radius * np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=1)


def _machine() -> tuple[Array, Array, Array, Array]:
    """Return base points, platform points in the base frame, and R and t of the platform."""
    angles = np.radians(np.repeat([-60.0, 60.0, 180.0], 2))
    b = _hexagon(_BASE, angles + np.radians(np.tile([-14.0, 14.0], 3)))
    p = _hexagon(_PLATFORM, angles + np.radians(np.tile([-42.0, 42.0], 3)))
    t, theta = _POSE
    R = rotation_from_rpy(theta)
    return b, t + p @ R.T, R, t


def figure() -> "Figure":
    """Draw the machine, 8 by 7.2 inches."""
    from matplotlib.figure import Figure

    drawing = Figure(figsize=(8.0, 7.2), facecolor=PAPER)
    axes: Any = drawing.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d", facecolor=PAPER)
    axes.set_axis_off()
    axes.view_init(elev=17.0, azim=-52.0)
    b, tips, R, t = _machine()
    for points, color in ((b, BASE), (tips, PLATFORM)):
        ring = np.vstack([points, points[:1]])
        axes.plot(*ring.T, color=color, linewidth=2.0)
    for i in range(6):
        axes.plot(*np.stack([b[i], tips[i]]).T, color="#b0b0b0" if i != LEG else LOWER, linewidth=2.4)
    _frame(axes, np.zeros(3), np.eye(3), 0.45, ("X", "Y", "Z"), BASE)
    _frame(axes, t, R, 0.42, ("x$_P$", "y$_P$", "z$_P$"), PLATFORM)
    _label(axes, [0.1, -0.25, -0.08], "base frame", BASE)
    _label(
        axes,
        t + np.array([0.12, 0.0, 0.42]),
        "platform frame: its origin, the\nreference point, may be any point",
        PLATFORM,
    )
    _arrow(axes, np.zeros(3), t, GRAY, "t", dashed=True)
    _leg(axes, b[LEG], tips[LEG])
    axes.set_box_aspect((1.0, 1.0, 0.95), zoom=1.22)
    axes.set(xlim=(-0.95, 0.95), ylim=(-0.95, 0.95), zlim=(-0.2, 1.68))
    return drawing


def _leg(axes: Any, base: Array, tip: Array) -> None:
    """Draw one leg: its ends, fixed axis k, frame, centers of mass, and actuator force."""
    S = tip - base
    L = float(np.linalg.norm(S))
    s = S / L
    k = np.array([0.9, -0.35, 0.0]) / np.hypot(0.9, 0.35)
    y = np.cross(k, s) / np.linalg.norm(np.cross(k, s))
    z = np.cross(s, y)
    axes.scatter(*np.stack([base, tip]).T, color=LOWER, s=36)
    left = np.array([-0.06, -0.02, 0.0])
    _label(axes, base + left + [0.0, 0.0, -0.1], "base point b$_1$", LOWER, "right")
    _label(axes, tip + left - [0.0, 0.0, 0.04], "platform point p$_1$", LOWER, "right")
    _arrow(axes, base, base + 0.4 * k, AXIS, "k, fixed axis of the\nuniversal joint")
    _frame(axes, base, np.stack([s, y, z], axis=1), 0.38, ("x = s", "y = k x s / |k x s|", "z"), LOWER)
    for share, part, place in ((0.36, "lower", "x > 0 from b$_1$"), (0.72, "upper", "x < 0 from p$_1$")):
        at = base + share * S
        axes.scatter(*at[:, None], color=PAPER, edgecolors=LOWER, s=70, linewidths=2.0)
        _label(axes, at + left, f"center of mass, {part} part:\n{place}", LOWER, "right")
    _arrow(axes, tip, tip + 0.34 * s, FORCE, "")
    _arrow(axes, base, base - 0.22 * s, FORCE, "")
    _label(
        axes,
        tip + 0.36 * s + left,
        "F > 0 extends the leg and\npushes the platform away",
        FORCE,
        "right",
    )


def _label(axes: Any, at: Any, text: str, color: str, side: str = "left") -> None:
    box = {"facecolor": PAPER, "edgecolor": "none", "alpha": 0.8, "pad": 0.6}
    axes.text(*at, text, color=color, ha=side, va="center", fontsize=10.5, bbox=box, zorder=10)


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
