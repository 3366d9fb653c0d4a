"""What ``workspace`` writes: volume, what bounds it, and planes through the pose in the middle."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...design.pose_limits import REASONS, PoseExaminer, PoseLimits
from ...design.workspace import Workspace
from ...io.array_types import Array
from ...io.progress import Progress, tracked
from ...motion.rotation import rotation_from_rpy
from ...robot.robot import Robot
from ..common.output import aligned, csv_text
from ..common.report import Picture, Report

POINTS = 121
"""How many poses a slice has along each axis."""

AXES = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")
_ENDS = np.array([[-math.inf, math.inf]] * 3 + [[-math.pi, math.pi]] * 3)
_ENDS[4] *= 0.5
# A slice reaches beyond the poses within the limits, on each side by this share of their width.
_MARGIN = 0.12


@dataclass(frozen=True, eq=False)
class Slice:
    """Poses of a plane through the pose in the middle.

    axes: which two of ``AXES`` vary. first, second: their values, m or rad, (n,) and (m,). codes: first
    broken limits, indices of ``REASONS``, (n, m). condition: scaled condition numbers, (n, m).
    """

    axes: tuple[int, int]
    first: Array
    second: Array
    codes: NDArray[np.int8]
    condition: Array


def slices(robot: Robot, limits: PoseLimits, found: Workspace, progress: Progress) -> list[Slice]:
    """Planes through the pose in the middle, of each two positions and of each two angles that vary."""
    varying = {"constant": [0], "orientation": [3], "total": [0, 3]}[found.kind]
    pairs = [(i + start, j + start) for start in varying for i, j in itertools.combinations(range(3), 2)]
    examiner, first = PoseExaminer(robot, limits), varying[0]
    made = []
    for axes in tracked(progress, pairs, lambda axes: f"plane of {' and '.join(AXES[i] for i in axes)}"):
        ends = [_ends(found, axis, axis - first) for axis in axes]
        one, other = (np.linspace(low, high, POINTS) for low, high in ends)
        poses = np.tile(np.concatenate([found.position, found.angles]), (POINTS, POINTS, 1))
        poses[..., axes[0]], poses[..., axes[1]] = one[:, None], other
        flat = poses.reshape(-1, 6)
        R, t = rotation_from_rpy(flat[:, 3:]), flat[:, :3]
        shape = (POINTS, POINTS)
        codes, condition = examiner.broken_limits(R, t), examiner.conditions(R, t)
        made.append(Slice(axes, one, other, codes.reshape(shape), condition.reshape(shape)))
    return made


def _ends(found: Workspace, axis: int, row: int) -> Array:
    """Where a slice begins and ends along an axis."""
    extent = found.box[row] if np.isnan(found.extent[row]).any() else found.extent[row]
    middle = float(np.concatenate([found.position, found.angles])[axis])
    low, high = min(extent[0], middle), max(extent[1], middle)
    wider = _MARGIN * (high - low)
    return np.asarray(np.clip([low - wider, high + wider], *_ENDS[axis]))


def report(
    robot: Robot, limits: PoseLimits, found: Workspace, planes: list[Slice], figures: Mapping[str, Picture]
) -> Report:
    """Text, figures for programs, the planes as a table, and the pictures given."""
    data = {
        "robot": robot.name,
        "kind": found.kind,
        "limits": {
            "lengths": limits.lengths,
            "joint_angles": limits.joint_angles,
            "forces": limits.forces,
            "scaled_condition_number": limits.condition,
            "clearance_m": limits.clearance,
            "load_N_N_m": limits.load,
        },
        "volume": found.volume,
        "error": found.error,
        "unit": found.unit,
        "box": found.box,
        "extent": found.extent,
        "position_m": found.position,
        "angles_rad": found.angles,
        "clear": found.clear,
        "reasons": found.reasons,
        "poses": found.poses,
        "units": {"box": _names(found), "extent": _names(found), "clear": _clear_unit(found)},
    }
    return Report(_text(robot, limits, found), {"slices": _table(planes)}, data, figures)


def title(found: Workspace) -> str:
    """Which workspace it is, in words."""
    t, theta = (", ".join(f"{x:.4g}" for x in values) for values in (found.position, found.angles))
    return {
        "constant": f"constant orientation, roll, pitch, yaw ({theta}) rad",
        "orientation": f"orientation, at ({t}) m",
        "total": "total, positions and orientations",
    }[found.kind]


def _text(robot: Robot, limits: PoseLimits, found: Workspace) -> str:
    lines = [
        f"robot      {robot.name}",
        f"workspace  {title(found)}",
        f"limits     {', '.join(_limits(robot, limits)) or 'none'}",
        f"volume     {found.volume:.6g} +- {found.error:.1g} {found.unit}, of {found.poses:,} poses",
    ]
    if found.kind != "total":
        lines.append(
            f"clear      at most {found.clear:.4g} {_clear_unit(found)} from the pose in the middle, to the "
            "nearest that was found beyond a limit"
        )
    rows = [
        (name, f"{low:.4g}", f"{high:.4g}", f"{least:.4g}", f"{most:.4g}")
        for name, (low, high), (least, most) in zip(_names(found), found.extent, found.box, strict=True)
    ]
    header = ("coordinate", "within from", "to", "looked from", "to")
    lines += ["", aligned(header, rows), ""]
    shares = [(name, f"{100.0 * share:.2f}") for name, share in found.reasons.items()]
    return "\n".join([*lines, aligned(("first limit that breaks", "% of poses"), shares)])


def _limits(robot: Robot, limits: PoseLimits) -> Iterator[str]:
    if limits.lengths and np.any((robot.length_limits[:, 0] > 0.0) | np.isfinite(robot.length_limits[:, 1])):
        yield "leg lengths"
    if limits.joint_angles and np.isfinite(robot.joint_angle_limit).any():
        yield "joint angles"
    if limits.clearance > 0.0:
        yield f"leg clearance {limits.clearance:g} m"
    if limits.condition < math.inf:
        yield f"scaled condition number {limits.condition:g}"
    if limits.forces and np.isfinite(robot.force_limit).any():
        yield "actuator forces at rest" + (" under the load" if limits.load.any() else "")


def _names(found: Workspace) -> list[str]:
    names = [f"{name}, {'m' if name[1] == '_' else 'rad'}" for name in AXES]
    return {"constant": names[:3], "orientation": names[3:], "total": names}[found.kind]


def _clear_unit(found: Workspace) -> str:
    return {"constant": "m", "orientation": "rad", "total": ""}[found.kind]


def _table(planes: list[Slice]) -> str:
    """One row for each pose of the planes."""
    rows: list[Sequence[object]] = [("axes", "first", "second", "first_limit", "scaled_condition")]
    for plane in planes:
        axes = "-".join(AXES[i] for i in plane.axes)
        first, second = np.meshgrid(plane.first, plane.second, indexing="ij")
        numbers = (each.ravel().tolist() for each in (first, second, plane.codes, plane.condition))
        rows += [(axes, a, b, REASONS[code], kappa) for a, b, code, kappa in zip(*numbers, strict=True)]
    return csv_text(rows)
