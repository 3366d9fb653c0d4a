"""Picture of a machine at its home pose: in perspective and from above, legs numbered."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...dynamics.home_pose import HomePose, radius
from ...io.array_types import Array
from ...motion.motion import Motion
from ...robot.offset_chains import chains
from ...robot.robot import LEGS, Robot
from ..common.drawing import BLUE, DARK, GREY, RED, Axes, Figure, as_written, name_points, new_figure
from ..common.report import SMALL, Picture

BASE, PLATFORM, LEG, MARK, OFFSET = DARK, BLUE, GREY, RED, "#2a7f3f"

# A machine is drawn with z down if more than this share of gravity acts along z.
_DOWN = 0.5
# Length of axes and arrows, and distance within which points are one, shares of the machine's size.
_AXIS, _SAME = 0.12, 1e-3


def picture(robot: Robot, home: HomePose) -> Picture:
    """The machine at its home pose."""
    return Picture(lambda: figure(robot, home), SMALL)


def figure(robot: Robot, home: HomePose) -> Figure:
    """Both views, side by side."""
    drawn = new_figure(12.0, 5.6)
    drawn.set_layout_engine("constrained", w_pad=0.2, h_pad=0.1, wspace=0.08)
    tips = home.t + robot.p
    in_space: Any = drawn.add_subplot(1, 2, 1, projection="3d")
    z_down = bool(robot.g[2] > _DOWN * np.linalg.norm(robot.g))
    extent = draw_legs(in_space, robot.b, tips, z_down) + _marks_in_space(in_space, robot, home, tips)
    frame(in_space, np.concatenate(extent), z_down)
    above = drawn.add_subplot(1, 2, 2)
    along = "z" if z_down else "-z"
    above.set_title(
        f"{as_written(robot.name)}: home pose, seen along {along}\nbase black, platform blue", fontsize=9.0
    )
    _from_above(above, robot, tips)
    if z_down:
        above.invert_yaxis()
    return drawn


def draw_legs(axes: Any, base: Array, tips: Array, z_down: bool = False) -> list[Array]:
    """Draw both rings of points (6, 3) and the legs between them, numbered; returns what was drawn."""
    size = float(np.max(np.ptp(np.concatenate([base, tips]), axis=0)))
    below = np.array([0.0, 0.0, 0.05 * size if z_down else -0.05 * size])
    for corners, color in ((base, BASE), (tips, PLATFORM)):
        ring = corners[_around(corners)]
        axes.plot(*np.concatenate([ring, ring[:1]]).T, color=color, linewidth=1.6)
    for leg in range(LEGS):
        axes.plot(*np.stack([base[leg], tips[leg]]).T, color=LEG, linewidth=1.4)
        axes.text(*(base[leg] + below), str(leg + 1), fontsize=8.0, ha="center", va="top")
    return [base, tips]


def frame(axes: Any, extent: Array, z_down: bool = False) -> None:
    """Limits and names of the axes for what is drawn, (n, 3); with z down, y is turned round as well."""
    low, high = extent.min(axis=0), extent.max(axis=0)
    pad = 0.04 * float(np.max(high - low))
    for name, a, b in zip("xyz", low - pad, high + pad, strict=True):
        getattr(axes, f"set_{name}lim")(a, b)
        getattr(axes, f"set_{name}label")(f"{name}, m", fontsize=8.0)
    if z_down:
        axes.invert_yaxis()
        axes.invert_zaxis()
    axes.set_box_aspect(high - low + 2.0 * pad)
    axes.locator_params(nbins=4)
    axes.tick_params(labelsize=7.0, pad=0.0)
    axes.view_init(elev=18.0, azim=-60.0)


def _marks_in_space(axes: Any, robot: Robot, home: HomePose, tips: Array) -> list[Array]:
    """Draw fixed axes of the universal joints, centre of mass with gravity and the tool point."""
    size = radius(robot.b) + radius(robot.p)
    bars = np.stack([robot.b - _AXIS * size * robot.k, robot.b + _AXIS * size * robot.k], axis=1)
    for bar in bars if robot.base_joint == "universal" else ():
        axes.plot(*bar.T, color=MARK, linewidth=1.2)
    drawn_joints = _offset_legs(axes, robot, home)
    center = home.t + robot.R_0
    axes.plot(*center[:, None], marker="o", color=PLATFORM, markersize=5.0, linestyle="")
    drawn = [bars.reshape(-1, 3), center[None], *drawn_joints]
    text = "red: fixed axes of the universal joints\n" if robot.base_joint == "universal" else ""
    text += "green: lines of sliding and the offsets to them\n" if drawn_joints else ""
    text += "dot: centre of mass of the platform"
    if np.any(robot.g):
        arrow = 3.0 * _AXIS * size * robot.g / np.linalg.norm(robot.g)
        axes.quiver(*center, *arrow, color=BASE, linewidth=1.2, arrow_length_ratio=0.25)
        drawn.append((center + arrow)[None])
        text += ", with gravity"
    if robot.tool.any():
        tool = home.t + robot.tool
        axes.plot(
            *np.stack([tips.mean(axis=0), tool]).T, color=PLATFORM, linewidth=0.8, linestyle=(0, (4, 2))
        )
        axes.plot(*tool[:, None], marker="x", color=PLATFORM, markersize=6.0, linestyle="")
        drawn.append(tool[None])
        text += "\ncross: point of the trajectories' poses"
    axes.set_title(text, fontsize=8.0)
    return drawn


def _offset_legs(axes: Any, robot: Robot, home: HomePose) -> list[Array]:
    """Draw base point, moving axis, line of sliding and platform point of each leg with offsets."""
    if robot.offsets is None:
        return []
    still = np.zeros(3)
    at = chains(robot, Motion.unchecked(np.eye(3), home.t, still, still))
    foot = at.T - at.L * at.s
    corners = robot.b[:, None] + np.stack([np.zeros_like(at.A), at.A, foot, at.T, at.P], axis=1)
    for leg in corners if np.isfinite(corners).all() else ():
        axes.plot(*leg.T, color=OFFSET, linewidth=1.6)
    return [corners.reshape(-1, 3)] if np.isfinite(corners).all() else []


def _from_above(axes: Axes, robot: Robot, tips: Array) -> None:
    """Project along z: rings, legs and the numbers of both ends of each."""
    places, names = [], []
    bars = [(_place(one), _place(other)) for one, other in zip(robot.b, tips, strict=True)]
    for corners, color in ((robot.b, BASE), (tips, PLATFORM)):
        ring = corners[_around(corners)]
        axes.plot(*np.concatenate([ring, ring[:1]]).T[:2], color=color, linewidth=1.2)
        axes.plot(*corners.T[:2], marker="o", color=color, markersize=4.0, linestyle="")
        places += [_place(corner) for corner in corners]
        names += [(text, at, color) for text, at in _numbers(corners)]
    for one, other in bars:
        axes.plot(*zip(one, other, strict=True), color=LEG, linewidth=1.2)
    axes.set_aspect("equal")
    axes.margins(0.12)
    axes.set(xlabel="x, m", ylabel="y, m")
    name_points(axes, names, places, bars, size=9.0)


def _place(point: Array) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def _numbers(points: Array) -> list[tuple[str, tuple[float, float]]]:
    """Numbers of the legs at points seen along z, those of points in one place together."""
    left, found = list(range(LEGS)), []
    size = radius(points) or 1.0
    while left:
        same = [i for i in left if np.linalg.norm((points[i] - points[left[0]])[:2]) < _SAME * size]
        found.append((", ".join(str(i + 1) for i in same), _place(points[left[0]])))
        left = [i for i in left if i not in same]
    return found


def _around(corners: Array) -> NDArray[np.int64]:
    """Order of points by their angle about their middle, in the plane that fits them best."""
    from_middle = corners - corners.mean(axis=0)
    across = from_middle @ np.linalg.svd(from_middle)[2][:2].T
    return np.argsort(np.arctan2(across[:, 1], across[:, 0]))
