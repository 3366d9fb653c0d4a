"""Plots of the singular poses of a path: curves along it, and the machine with its unconstrained twist."""

import functools
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ...io.array_types import Array
from ...motion.motion import Motion
from ...robot.robot import LEGS, Robot
from ...singularities.singular_poses import SingularityResult
from ..common.drawing import BLUE, DARK, RED, Axes, Figure, as_written, log_numbers, new_figure, plot_legs
from ..common.output import Columns
from ..common.report import Picture
from .machine_plot import draw_legs, frame
from .singularities import Examination, curves

MOST = 6
"""Largest number of drawn crossings; an oscillating path may have many."""

# Length of the longest arrow relative to the size of the machine.
_ARROW = 0.3


def pictures(found: Examination) -> dict[str, Picture]:
    """Return the plot ``path``, and ``crossing_<n>`` for each crossing, or ``nearest`` without crossings."""
    # The curves are computed only for plots, because they require some time.
    columns = functools.cache(lambda: curves(found))

    def picture(figure: Callable[..., Figure], *of_pose: Any) -> Picture:
        return Picture(lambda: figure(found, columns(), *of_pose))

    return {"path": picture(path_figure)} | {
        name: picture(pose_figure, time, at, title) for name, time, at, title in _poses(found)
    }


def path_figure(found: Examination, columns: Columns) -> Figure:
    """Plot condition number, signed smallest singular value, and the largest force over the whole path."""
    figure = new_figure(9.0, 7.2)
    panels = figure.subplots(3, 1, sharex=True)
    time = columns["time"]
    largest = np.max(np.abs(_forces(columns)), axis=-1)
    panels[0].semilogy(time, columns["scaled_condition"], color=BLUE, linewidth=1.2)
    panels[0].set_ylabel("scaled condition\nnumber of H")
    panels[1].plot(time, columns["smallest_singular_value"], color=BLUE, linewidth=1.2)
    panels[1].axhline(0.0, color=DARK, linewidth=0.7)
    panels[1].set_ylabel("smallest singular value,\nsign of det H")
    panels[2].semilogy(time, largest, color=BLUE, linewidth=1.2)
    panels[2].set(ylabel="largest leg force, N", xlabel="time, s", xlim=(time[0], time[-1]))
    for axes, values in zip(panels, (columns["scaled_condition"], time, largest), strict=True):
        _if_empty(axes, values)
        if axes.get_yscale() == "log":
            log_numbers(axes.yaxis)
        for crossing in found.along.crossings:
            axes.axvline(crossing.time, color=RED, linewidth=0.9, linestyle=(0, (4, 2)))
    count = len(found.along.crossings)
    where = f"{count} crossing{'' if count == 1 else 's'} of a singular pose"
    if found.along.spans:
        where += ", and a way along singular poses"
    figure.suptitle(as_written(f"{found.robot.name}, path {found.name}: {where}"), fontsize=11.0)
    return figure


def pose_figure(
    found: Examination, columns: Columns, time: float, at: SingularityResult, title: str
) -> Figure:
    """Plot singular value and leg forces near a pose, and the machine with its unconstrained twist."""
    figure = new_figure(12.0, 5.8)
    panes: Any = figure.subfigures(1, 2, width_ratios=(1.0, 1.05))
    left, right = panes
    upper, lower = left.subplots(2, 1, sharex=True, height_ratios=(1.0, 1.7))
    window = (0.05 if found.along.crossings else 1.0) * (found.along.end - found.along.start)
    low, high = max(found.along.start, time - window), min(found.along.end, time + window)
    crossed = [crossing.time for crossing in found.along.crossings if low <= crossing.time <= high]
    inside = (columns["time"] >= low) & (columns["time"] <= high)
    # No line connects the branches before and after a crossing.
    when, *rest = _broken(
        crossed, columns["time"][inside], columns["smallest_singular_value"][inside], _forces(columns)[inside]
    )
    upper.plot(when, rest[0], color=BLUE, linewidth=1.3)
    upper.axhline(0.0, color=DARK, linewidth=0.7)
    upper.set_ylabel("smallest singular\nvalue, sign of det H")
    plot_legs(lower, when, rest[1], linewidth=1.2)
    bound = _bound(np.abs(when[:, None] - np.array([*crossed, np.inf])).min(axis=-1), rest[1], window)
    lower.axhline(0.0, color=DARK, linewidth=0.7)
    lower.set_ylim(-bound, bound)
    _if_empty(lower, rest[1])
    lower.ticklabel_format(axis="y", scilimits=(-2, 5), useMathText=True)
    lower.set(ylabel="leg force, N", xlabel="time, s", xlim=(low, high))
    lower.locator_params(axis="x", nbins=6)
    lower.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=LEGS, fontsize=8.0,
                 handlelength=1.2, columnspacing=1.0)  # fmt: skip
    for axes in (upper, lower):
        for mark in crossed:
            axes.axvline(mark, color=RED, linewidth=0.9, linestyle=(0, (4, 2)))
    machine = right.add_subplot(projection="3d")
    figure.suptitle(as_written(title), fontsize=11.0)
    draw_machine(machine, found.robot, found.path(np.array([time]))[0], at)
    return figure


def draw_machine(axes: Any, robot: Robot, pose: Motion, at: SingularityResult) -> None:
    """Draw the machine at a pose, and the velocities of the platform points and screw axis of its twist."""
    points = pose.t + robot.p @ pose.R.T
    both = np.concatenate([robot.b, points])
    size = float(np.max(np.ptp(both, axis=0)))
    draw_legs(axes, robot, points)
    v, omega = at.twist[:3], at.twist[3:]
    velocities = v + np.cross(omega, points - pose.t)
    arrows = velocities * _ARROW * size / np.max(np.linalg.norm(velocities, axis=-1))
    axes.quiver(*points.T, *arrows.T, color=RED, linewidth=1.6, arrow_length_ratio=0.25)
    extent = [both, points + arrows]
    if np.isfinite(at.screw_pitch) and np.linalg.norm(at.screw_point - pose.t) < size:
        line = at.screw_point + np.outer([-0.45 * size, 0.45 * size], at.screw_axis)
        axes.plot(*line.T, color=RED, linewidth=1.0, linestyle=(0, (4, 2)))
        extent.append(line)
    screw = "a translation"
    if np.isfinite(at.screw_pitch):
        screw = f"screw axis dashed, pitch {float(at.screw_pitch):.4g} m/rad"
    motion = "unconstrained twist" if at.lost_dof else "twist that the legs resist least"
    axes.set_title(f"{motion}: velocities of the platform points\n{screw}", fontsize=9.0)
    frame(axes, robot, np.concatenate(extent))


def _poses(found: Examination) -> Iterator[tuple[str, float, SingularityResult, str]]:
    """Yield file name, time, pose, and title of each plot of the machine."""
    along = found.along
    for number, crossing in enumerate(along.crossings[:MOST], 1):
        title = f"path {found.name}: H singular at {crossing.time:.9f} s"
        yield f"crossing_{number}", crossing.time, crossing.singularity, title
    if not along.crossings:
        title = f"path {found.name}: nearest to a singular pose at {along.nearest.time:.6f} s"
        yield "nearest", along.nearest.time, along.nearest.singularity, title


def _forces(columns: Columns) -> Array:
    return np.stack([columns[f"F_{leg}"] for leg in range(1, LEGS + 1)], axis=-1)


def _broken(breaks: list[float], time: Array, *values: Array) -> tuple[Array, ...]:
    """Return times and values, shape (n, ...), with a gap at each of the breaks."""
    at = np.searchsorted(time, breaks)
    return np.insert(time, at, breaks), *(np.insert(value, at, np.nan, axis=0) for value in values)


def _bound(distance: Array, F: Array, window: float) -> float:
    """Return a bound of the forces, (n, 6), except near a crossing (fraction of the window, s)."""
    largest = float(np.nanmax(np.where((distance > 0.05 * window)[:, None], np.abs(F), 0.0), initial=0.0))
    return 1.1 * largest or 1.0


def _if_empty(axes: Axes, values: Array) -> None:
    """Write the reason for an empty plot."""
    if not np.isfinite(values).any():
        text = "none: H is singular throughout"
        axes.text(0.5, 0.55, text, transform=axes.transAxes, ha="center", va="bottom", color=DARK)
        axes.set_yticks([], minor=False)
        axes.set_yticks([], minor=True)
