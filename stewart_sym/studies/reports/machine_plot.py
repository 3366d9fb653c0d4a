"""Plots of a machine: home pose in perspective and from above, and a pose with its unconstrained twist."""

from typing import Any

import numpy as np

from ...dynamics.home_pose import HomePose
from ...io.array_types import Array
from ...kinematics.mounting_side import radius
from ...motion.motion import Motion
from ...robot.offset_chains import chains
from ...robot.robot import LEGS, Robot
from ...robot.units import Units
from ...singularities.singular_poses import SingularityResult
from ...viewer.content import around
from ..common import drawing
from ..common.drawing import Z_DOWN, Axes, Figure, as_written, name_points, new_figure, vertical

PLATFORM, BASE, LEG, MARK = drawing.BLUE, drawing.DARK, drawing.GRAY, drawing.RED
OFFSET = "#2a7f3f"

# Length of axes and arrows, and distance below which points coincide, relative to the size of the machine.
_AXIS, _SAME = 0.12, 1e-3


def figure(robot: Robot, home: HomePose) -> Figure:
    """Draw both views next to each other."""
    drawn = new_figure(12.0, 5.6)
    drawn.set_layout_engine("constrained", w_pad=0.2, h_pad=0.1, wspace=0.08)
    tips = home.t + robot.p
    in_space: Any = drawn.add_subplot(1, 2, 1, projection="3d")
    extent = _draw_legs(in_space, robot, tips) + _marks_in_space(in_space, robot, home, tips)
    above = drawn.add_subplot(1, 2, 2)
    along = "z" if vertical(robot) == Z_DOWN else "-z"
    above.set_title(
        f"{as_written(robot.name)}: home pose, seen along {along}\nbase black, platform blue", fontsize=9.0
    )
    _from_above(above, robot, tips)
    _frame(in_space, robot, np.concatenate(extent))
    return drawn


def twist_figure(robot: Robot, pose: Motion, at: SingularityResult, title: str) -> Figure:
    """Draw the machine at a pose with the velocities of the platform points under its unconstrained twist."""
    figure = new_figure(6.6, 5.8)
    axes: Any = figure.add_subplot(projection="3d")
    points = pose.t + robot.p @ pose.R.T
    extent = _draw_legs(axes, robot, points)
    size = float(np.max(np.ptp(np.concatenate(extent), axis=0)))
    velocities = at.twist[:3] + np.cross(at.twist[3:], points - pose.t)
    arrows = 2.5 * _AXIS * size * velocities / np.max(np.linalg.norm(velocities, axis=-1))
    axes.quiver(*points.T, *arrows.T, color=MARK, linewidth=1.6, arrow_length_ratio=0.25)
    extent.append(points + arrows)
    screw = "a translation"
    if np.isfinite(at.screw_pitch):
        units = Units.of(robot)
        pitch = float(at.screw_pitch) * units.radians / units.meters
        screw = f"screw axis dashed, pitch {pitch:.4g} {units.length}/{units.angle}"
        line = at.screw_point + np.outer([-0.45 * size, 0.45 * size], at.screw_axis)
        if np.linalg.norm(at.screw_point - pose.t) < size:
            axes.plot(*line.T, color=MARK, linewidth=1.0, linestyle=(0, (4, 2)))
            extent.append(line)
    motion = "unconstrained twist" if at.lost_dof else "twist that the legs resist least"
    axes.set_title(f"{as_written(title)}\n{motion}, {screw}", fontsize=9.0)
    _frame(axes, robot, np.concatenate(extent))
    return figure


def _draw_legs(axes: Any, robot: Robot, tips: Array) -> list[Array]:
    """Draw the base and platform polygons (6, 3) and the numbered legs; return the drawn points."""
    base, (axis, down) = robot.b, vertical(robot)
    size = float(np.max(np.ptp(np.concatenate([base, tips]), axis=0)))
    below = (0.05 if down else -0.05) * size * np.eye(3)[axis]
    for corners, color in ((base, BASE), (tips, PLATFORM)):
        axes.plot(*_ring(corners).T, color=color, linewidth=1.6)
    for leg in range(LEGS):
        axes.plot(*np.stack([base[leg], tips[leg]]).T, color=LEG, linewidth=1.4)
        axes.text(*(base[leg] + below), str(leg + 1), fontsize=8.0, ha="center", va="top")
    return [base, tips]


def _ring(corners: Array) -> Array:
    """Return the corners of a polygon in order, first and last equal."""
    order = around(corners)
    return np.asarray(corners[[*order, order[0]]])


def _frame(axes: Any, robot: Robot, extent: Array) -> None:
    """Set equal scales for the drawn points, shape (n, 3), and the vertical axis."""
    low, high = extent.min(axis=0), extent.max(axis=0)
    half = 0.54 * float(np.max(high - low))
    for name, middle in zip("xyz", 0.5 * (low + high), strict=True):
        getattr(axes, f"set_{name}lim")(middle - half, middle + half)
        getattr(axes, f"set_{name}label")(f"{name}, {robot.length_unit}", fontsize=8.0)
        _number_in_units(getattr(axes, f"{name}axis"), robot)
        axes.locator_params(name, nbins=4)
        axes.tick_params(name, labelsize=7.0)
    axes.set_box_aspect((1.0, 1.0, 1.0), zoom=0.9)
    axis, down = vertical(robot)
    axes.view_init(elev=18.0, azim=-60.0, vertical_axis="xyz"[axis])
    up, left, right = (getattr(axes, f"{'xyz'[(axis + i) % 3]}axis") for i in range(3))
    # Two axes are inverted, so that the view is rotated and not mirrored.
    for each in (up, right) if down else ():
        each.set_inverted(True)
    # Tick labels of both lower edges do not cover the corner between the edges.
    for each, side in ((left, "right"), (right, "left")):
        for label in each.get_ticklabels():
            label.set_horizontalalignment(side)


def _number_in_units(axis: Any, robot: Robot) -> None:
    """Set tick labels of an axis in m to the length unit of the robot file."""
    axis.set_major_formatter(lambda value, _: f"{value / Units.of(robot).meters:.4g}")


def _marks_in_space(axes: Any, robot: Robot, home: HomePose, tips: Array) -> list[Array]:
    """Draw the fixed axes of the universal joints, the center of mass with gravity, and the tool point."""
    size, captions = radius(robot.b) + radius(robot.p), []
    bars = np.stack([robot.b - _AXIS * size * robot.k, robot.b + _AXIS * size * robot.k], axis=1)
    if robot.base_joint == "universal":
        captions.append("red: fixed axes of the universal joints")
        for bar in bars:
            axes.plot(*bar.T, color=MARK, linewidth=1.2)
    drawn = [bars.reshape(-1, 3), *_offset_legs(axes, robot, home)]
    if len(drawn) > 1:
        captions.append("green: lines of sliding and the offsets to them")
    # Without masses, gravity acts at the platform points' mean in the drawing.
    center = home.t + (robot.p.mean(axis=0) if robot.missing_bodies else robot.R_0)
    captions.append("arrow: gravity" if robot.missing_bodies else "dot: center of mass of the platform")
    if not robot.missing_bodies:
        axes.plot(*center[:, None], marker="o", color=PLATFORM, markersize=5.0, linestyle="")
    if np.any(robot.g):
        arrow = 3.0 * _AXIS * size * robot.g / np.linalg.norm(robot.g)
        axes.quiver(*center, *arrow, color=BASE, linewidth=1.2, arrow_length_ratio=0.25)
        drawn.append(np.stack([center, center + arrow]))
        captions[-1] += "" if robot.missing_bodies else ", with gravity"
    if robot.tool.any():
        line = np.stack([tips.mean(axis=0), home.t + robot.tool])
        axes.plot(*line.T, color=PLATFORM, linewidth=0.8, linestyle=(0, (4, 2)))
        axes.plot(*line[1:].T, marker="x", color=PLATFORM, markersize=6.0, linestyle="")
        drawn.append(line)
        captions.append("cross: point of the trajectories' poses")
    axes.set_title("\n".join(captions), fontsize=8.0)
    return drawn


def _offset_legs(axes: Any, robot: Robot, home: HomePose) -> list[Array]:
    """Draw base point, moving axis, sliding line, and platform point of each leg with offsets."""
    if robot.offsets is None:
        return []
    at = chains(robot, Motion._unchecked(np.eye(3), home.t, np.zeros(3), np.zeros(3)))
    foot = at.T - at.L * at.s
    corners = robot.b[:, None] + np.stack([np.zeros_like(at.A), at.A, foot, at.T, at.P], axis=1)
    if not np.isfinite(corners).all():
        return []
    for leg in corners:
        axes.plot(*leg.T, color=OFFSET, linewidth=1.6)
    return [corners.reshape(-1, 3)]


def _from_above(axes: Axes, robot: Robot, tips: Array) -> None:
    """Draw the projection along z: polygons, legs, and the numbers of both ends of each leg."""
    names, (base, platform) = [], ([(x, y) for x, y, _ in corners.tolist()] for corners in (robot.b, tips))
    bars = list(zip(base, platform, strict=True))
    for corners, color in ((robot.b, BASE), (tips, PLATFORM)):
        axes.plot(*_ring(corners).T[:2], color=color, linewidth=1.2)
        axes.plot(*corners.T[:2], marker="o", color=color, markersize=4.0, linestyle="")
        names += [(text, at, color) for text, at in _numbers(corners)]
    for one, other in bars:
        axes.plot(*zip(one, other, strict=True), color=LEG, linewidth=1.2)
    axes.set_aspect("equal")
    axes.margins(0.12)
    axes.set(xlabel=f"x, {robot.length_unit}", ylabel=f"y, {robot.length_unit}")
    for axis in (axes.xaxis, axes.yaxis):
        _number_in_units(axis, robot)
    if vertical(robot) == Z_DOWN:
        axes.invert_yaxis()
    name_points(axes, names, [*base, *platform], bars, size=9.0)


def _numbers(points: Array) -> list[tuple[str, tuple[float, float]]]:
    """Return the numbers of the legs at points seen along z; coincident points have a common label."""
    apart = np.linalg.norm(points[:, None, :2] - points[:, :2], axis=-1) >= _SAME * (radius(points) or 1.0)
    groups: dict[tuple[int, ...], tuple[float, float]] = {}
    for row, (x, y, _) in zip(apart, points.tolist(), strict=True):
        groups.setdefault(tuple(np.flatnonzero(~row).tolist()), (x, y))
    return [(", ".join(str(leg + 1) for leg in legs), place) for legs, place in groups.items()]
