"""Report of ``workspace``: volume, limiting constraints, and slices through the center pose."""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...design import pose_limits
from ...design.axis_travel import axis_travel
from ...design.pose_limits import INSIDE, REASONS, PoseExaminer, PoseLimits, at_reference
from ...design.workspace import WorkspaceResult
from ...io.array_types import Array
from ...io.progress import Progress, tracked
from ...kinematics.inverse_kinematics import leg_lengths
from ...motion.rotation import rotation_from_rpy
from ...robot.robot import Robot
from ...robot.units import Units
from ..common.axis_table import axis_data, axis_text
from ..common.drawing import DARK, Z_DOWN, Axes, Figure, as_written, legend_below, new_figure, vertical
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Columns, aligned

POINTS = 121
"""Number of poses of a slice along each axis."""

AXES = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")
_FARTHEST = np.array([math.inf, math.inf, math.inf, math.pi, 0.5 * math.pi, math.pi])
"""Largest values of the axes."""
_PAIRS = ((0, 1), (0, 2), (1, 2), (3, 4), (3, 5), (4, 5))
_KINDS = {
    "constant_orientation": (slice(0, 3), "m", "constant orientation, roll, pitch, yaw ({theta}) {angle}"),
    "orientation": (slice(3, 6), "rad", "orientation, at ({t}) {length}"),
    "six_dof": (slice(0, 6), "", "six degrees of freedom, positions and orientations"),
}
"""Varying axes, unit of the distance to a limit, and title of each kind of workspace."""
# Fraction of the width by which a slice extends beyond the poses within the limits, on each side.
_MARGIN = 0.12

_NAMES = [f"{name}, {'m' if name[1] == '_' else 'rad'}" for name in AXES]
_DATA = ("volume", "error", "unit", "bounds", "extent", "distance_to_limit", "limit_fractions", "samples")

_OUTSIDE = ("#ffffff", "#d9d9d9", "#c6d8ee", "#e6cfe8", "#f3d9b1", "#f4c2c2", "#d5e8c8")
"""Colors of the limits in the order of ``REASONS``."""
_MOST = 100.0
# Smallest ratio of the condition numbers that the color scale spans.
_LEAST_RATIO = 1.5
# Width of a row of panels (inches), and smallest and largest ratio of width to height of a panel.
_WIDTH, _SHAPES = 9.4, (0.4, 2.5)


class Slice(NamedTuple):
    """Plane in which two of ``AXES`` vary: first violated limits, scaled condition numbers, shape (n, m)."""

    axes: tuple[int, int]
    first: Array
    second: Array
    codes: NDArray[np.int8]  # indices of REASONS
    condition: Array


def center_doubt(robot: Robot, limits: PoseLimits, found: WorkspaceResult) -> str:
    """Describe the limit that the center pose violates."""
    examiner = PoseExaminer(robot, at_reference(robot, limits))
    R = rotation_from_rpy(found.rpy[None])
    t = found.position - R @ found.tool
    code = int(examiner.broken_limits(R, t)[0])
    text = REASONS[code].replace("_", " ")
    if code == pose_limits.LENGTH:
        L = leg_lengths(examiner.robot, R, t)
        units = Units.of(robot)
        lengths = f"{L.min() / units.meters:.6g} to {L.max() / units.meters:.6g} {units.length}"
        angles = "" if np.abs(found.rpy).max() <= math.pi else " and --rpy (rad, not degrees)"
        return f"its legs are {lengths} long: change --position (m){angles}"
    if code == pose_limits.CONDITION:
        number, most = float(examiner.conditions(R, t)[0]), examiner.limits.max_condition
        if number <= most:
            return f"{text}: det H has another sign than at the home pose"
        return f"{text}: expected at most {most:g}, got {number:.4g}"
    return text


def slices(robot: Robot, limits: PoseLimits, found: WorkspaceResult, progress: Progress) -> list[Slice]:
    """Compute the planes through the center pose for each pair of varying positions or varying angles."""
    varying, examiner, made = _KINDS[found.kind][0], PoseExaminer(robot, at_reference(robot, limits)), []
    center, extent = np.concatenate([found.position, found.rpy]), np.full((6, 2), np.nan)
    unknown = np.isnan(found.extent).any(axis=1, keepdims=True)
    extent[varying] = np.where(unknown, found.bounds, found.extent)
    low, high = np.minimum(extent[:, 0], center), np.maximum(extent[:, 1], center)
    low, high = low - _MARGIN * (high - low), high + _MARGIN * (high - low)
    values = np.linspace(np.maximum(low, -_FARTHEST), np.minimum(high, _FARTHEST), POINTS)
    pairs = [pair for pair in _PAIRS if {*pair} <= {*range(6)[varying]}]
    for axes in tracked(progress, pairs, lambda axes: f"plane of {' and '.join(AXES[i] for i in axes)}"):
        one, other = values[:, axes[0]], values[:, axes[1]]
        poses = np.tile(center, (POINTS, POINTS, 1))
        poses[..., axes[0]], poses[..., axes[1]] = one[:, None], other
        R = rotation_from_rpy(poses[..., 3:].reshape(-1, 3))
        t = poses[..., :3].reshape(-1, 3) - R @ found.tool
        codes, condition = examiner.broken_limits(R, t), examiner.conditions(R, t)
        shape = (POINTS, POINTS)
        made.append(Slice(axes, one, other, codes.reshape(shape), condition.reshape(shape)))
    return made


def report(robot: Robot, limits: PoseLimits, found: WorkspaceResult, planes: list[Slice]) -> Report:
    """Create the report: text, data, and the planes as a table and a plot, and the axis travel from home."""
    varying, unit, _ = _KINDS[found.kind]
    travel = axis_travel(robot, limits)
    data = {
        "robot": robot.name,
        "kind": found.kind,
        "limits": {
            "lengths": limits.lengths,
            "joint_angles": limits.joint_angles,
            "forces": limits.forces,
            "max_condition": limits.max_condition,
            "min_clearance_m": limits.min_clearance,
            "load_N_N_m": limits.load,
        },
        **{name: getattr(found, name) for name in _DATA},
        **{"tool_m": found.tool, "position_m": found.position, "rpy_rad": found.rpy},
        "units": {"bounds": _NAMES[varying], "extent": _NAMES[varying], "distance_to_limit": unit},
        "axis_travel": axis_data(travel),
    }
    figures = {"slices": Picture(lambda: figure(robot, found, planes), SMALL)}
    text = f"{_text(robot, limits, found)}\n\n{axis_text(travel, Units.of(robot))}"
    return Report(text, {"slices": _table(planes)}, data, figures)


def _title(found: WorkspaceResult, units: Units) -> str:
    """Describe the kind of workspace."""
    pairs = (found.position, units.meters), (found.rpy, units.radians)
    t, theta = (", ".join(f"{x / size:.4g}" for x in values) for values, size in pairs)
    return _KINDS[found.kind][2].format(t=t, theta=theta, length=units.length, angle=units.angle)


def _text(robot: Robot, limits: PoseLimits, found: WorkspaceResult) -> str:
    """Format the limits, the volume, the coordinates, and the fractions of the limits."""
    units, (varying, unit, _) = Units.of(robot), _KINDS[found.kind]
    lines = [f"robot      {robot.name}", f"workspace  {_title(found, units)}"]
    if found.tool.any():
        point = f"{units.lengths(found.tool)} {units.length}"
        lines.append(f"point      tool of the robot file, {point}, platform frame: positions and load")
    lines.append(f"limits     {', '.join(_limits(robot, limits)) or 'none'}")
    lines.append(f"volume     {_size(found, units)}, from {found.samples:,} random poses")
    if unit and np.isfinite(found.distance_to_limit):
        scale, unit = units.of_unit(unit)
        distance = f"{scale * found.distance_to_limit:.4g} {unit}"
        lines.append(f"distance   at most {distance} from the center pose to the nearest pose beyond a limit")
    elif unit and found.volume > 0.0:
        lines.append("distance   no random pose is beyond a limit")
    rows = []
    for axis in range(6)[varying]:
        scale, unit = units.of_unit("m" if axis < 3 else "rad")
        ends = scale * np.concatenate([found.extent, found.bounds], axis=1)[axis - varying.start]
        rows.append((f"{AXES[axis]}, {unit}", *("-" if np.isnan(end) else f"{end:.4g}" for end in ends)))
    header = ("coordinate", "at least from", "to", "searched from", "to")
    fractions = found.limit_fractions.items()
    shares = [(name.replace("_", " "), f"{100.0 * share:.2f}") for name, share in fractions]
    tables = aligned(header, rows), aligned(("first limit that breaks", "% of poses"), shares)
    return "\n\n".join(["\n".join(lines), *tables])


def _size(found: WorkspaceResult, units: Units) -> str:
    """Return the volume with its error; only an upper bound if the error is larger."""
    sizes = [units.of_unit(part.removesuffix("^3")) for part in found.unit.split()]
    scale, unit = math.prod(size**3 for size, _ in sizes), " ".join(f"{name}^3" for _, name in sizes)
    volume, error = scale * found.volume, scale * found.error
    if not found.is_known:
        return f"at most {volume + error:.2g} {unit}"
    return f"{volume:.6g} +- {error:.1g} {unit}"


def _limits(robot: Robot, limits: PoseLimits) -> Iterator[str]:
    if limits.lengths and np.any((robot.length_limits[:, 0] > 0.0) | np.isfinite(robot.length_limits[:, 1])):
        yield "leg lengths"
    if limits.joint_angles and robot.has_joint_angle_limits:
        yield "joint angles"
    if limits.min_clearance > 0.0:
        units = Units.of(robot)
        yield f"leg clearance {limits.min_clearance / units.meters:g} {units.length}"
    if limits.max_condition < math.inf:
        yield f"scaled condition number {limits.max_condition:g}"
    if pose_limits.applies_forces(robot, limits):
        yield "actuator forces at rest" + (" under the load" if limits.load.any() else "")
    elif limits.forces and np.isfinite(robot.force_limit).any():
        yield f"not actuator forces: {robot.missing_bodies[0]} is missing"


def _table(planes: list[Slice]) -> Columns:
    """Return one row for each pose of the planes."""
    parts = []
    for plane in planes:
        first, second = np.meshgrid(plane.first, plane.second, indexing="ij")
        axes = np.full(first.shape, "-".join(AXES[i] for i in plane.axes))
        parts.append((axes, first, second, np.array(REASONS)[plane.codes], plane.condition))
    names = ("axes", "first", "second", "first_limit", "scaled_condition")
    columns = zip(*parts, strict=True)
    return {name: np.stack(values).ravel() for name, values in zip(names, columns, strict=True)}


def figure(robot: Robot, found: WorkspaceResult, planes: list[Slice]) -> Figure:
    """Draw a panel for each plane, with t_z vertical according to gravity."""
    shapes = np.array([np.ptp(plane.first) / np.ptp(plane.second) for plane in planes])
    shapes = shapes.clip(*_SHAPES).reshape(-1, 3)
    # All rows have the width of the plot, and panels of one row have the same height.
    widths = _WIDTH * shapes.mean(axis=0) / shapes.mean(axis=0).sum()
    heights = (widths / shapes).max(axis=1)
    drawn = new_figure(12.0, 1.6 + float(np.sum(heights + 0.6)))
    from matplotlib.colors import LogNorm
    from matplotlib.patches import Patch
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    ratios: Any = {"width_ratios": widths.tolist(), "height_ratios": heights.tolist()}
    panels = drawn.subplots(len(shapes), 3, squeeze=False, **ratios)
    inside = np.concatenate([plane.condition[plane.codes == INSIDE] for plane in planes])
    inside = inside[np.isfinite(inside)]
    low = float(inside.min(initial=_MOST))
    high = float(np.quantile(inside, 0.99)) if inside.size else _MOST
    norm = LogNorm(low, max(min(high, _MOST), _LEAST_RATIO * low))
    center = np.concatenate([found.position, found.rpy])
    for axes, plane in zip(panels.ravel(), planes, strict=True):
        mesh = _draw(axes, plane, norm, robot, center)
    bar = drawn.colorbar(mesh, ax=panels, label="scaled condition number", shrink=0.8, extend="max")
    bar.ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.4g}"))
    bar.ax.yaxis.set_minor_formatter(NullFormatter())
    size = _size(found, Units.of(robot)).replace("+-", "±").replace("^3", "³")
    title = f"{as_written(robot.name)}: {_title(found, Units.of(robot))}"
    drawn.suptitle(f"{title}\n{size}; planes through the pose marked +", fontsize=10.0)
    broken = sorted({int(code) for plane in planes for code in np.unique(plane.codes)} - {INSIDE})
    handles = [Patch(facecolor=_OUTSIDE[code], label=REASONS[code].replace("_", " ")) for code in broken]
    if handles:
        legend_below(drawn, handles, title="first limit that breaks")
    return drawn


def _draw(axes: Axes, plane: Slice, norm: Any, robot: Robot, center: Array) -> Any:
    """Draw limits and condition numbers of a plane, with the center pose; return the mesh of the numbers."""
    from matplotlib.colors import ListedColormap

    scale, unit = Units.of(robot).of_unit("m" if plane.axes[0] < 3 else "rad")
    at = scale * plane.first, scale * plane.second
    colors: Any = {"cmap": ListedColormap(list(_OUTSIDE)), "vmin": -0.5, "vmax": len(_OUTSIDE) - 0.5}
    axes.grid(False)
    axes.pcolormesh(*at, plane.codes.T, rasterized=True, **colors)
    inside = plane.codes == INSIDE
    shown = np.ma.masked_where(~inside, plane.condition)
    mesh = axes.pcolormesh(*at, shown.T, cmap="viridis_r", norm=norm, rasterized=True)
    if 0 < np.count_nonzero(inside) < inside.size:
        axes.contour(*at, inside.T.astype(float), levels=[0.5], colors=DARK, linewidths=0.9)
    axes.plot(*(scale * center[list(plane.axes)]), marker="+", color=DARK, markersize=9.0)
    axes.set_aspect("equal")
    names = [AXES[i] if i < 3 else ("roll", "pitch", "yaw")[i - 3] for i in plane.axes]
    axes.set(xlabel=f"{names[0]}, {unit}", ylabel=f"{names[1]}, {unit}")
    if names[1] == "t_z" and vertical(robot) == Z_DOWN:
        axes.invert_yaxis()
        axes.set_ylabel(f"t_z, {unit} (z points down)")
    return mesh
