"""Workspace volume of a robot within its limits, estimated by stratified random sampling."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.home_pose import home_pose
from ..io.arguments import finite_array, instance, option, whole_number
from ..io.array_types import Array, Flags, Frozen
from ..io.error_policy import warn
from ..io.progress import Progress, silent
from ..kinematics.conditioning import characteristic_length
from ..motion.rotation import rotation_from_rpy
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot
from . import parallel, stratified_sampling
from .pose_limits import REASONS, PoseExaminer, PoseLimits, at_reference
from .stratified_sampling import Cells, Tally

Kind = Literal["constant_orientation", "orientation", "six_dof"]

KINDS = ("constant_orientation", "orientation", "six_dof")
UNITS = {"constant_orientation": "m^3", "orientation": "rad^3", "six_dof": "m^3 rad^3"}
"""Units of the volume. The measure of rotations is independent of the axes; all rotations measure 8 pi^2."""

WHOLE_TURN = np.array([[-math.pi, math.pi], [-0.5 * math.pi, 0.5 * math.pi], [-math.pi, math.pi]])
"""Roll, pitch, and yaw of all rotations (rad), shape (3, 2)."""

_ELSEWHERE = {
    "constant_orientation": "other rpy (rad)",
    "orientation": "another position (m)",
    "six_dof": "other bounds",
}
"""Remedies if no pose is within the limits."""

_MOST = 10**12


class WorkspaceWarning(UserWarning):
    """Issued if a workspace result may be misleading."""


@dataclass(frozen=True, eq=False)
class WorkspaceResult(Frozen):
    """Set of poses within all limits, with its volume and its limiting constraints.

    Attributes
    ----------
    kind : {"constant_orientation", "orientation", "six_dof"}
        Positions at one orientation, rotations at one position, or both.
    volume : float
        Volume in ``unit``. For rotations this is the integral of cos(theta_y) over roll, pitch, and yaw.
    error : float
        Three standard deviations of the volume in ``unit``, but at least three sampling cells.
    unit : str
        "m^3", "rad^3", or "m^3 rad^3".
    bounds : ndarray, shape (3, 2) or (6, 2)
        Search bounds: minimum and maximum of the varying coordinates t_x, t_y, t_z (m) and theta_x, theta_y,
        theta_z (rad).
    extent : ndarray, shape (3, 2) or (6, 2)
        Bounds of the poses within the limits, as in ``bounds``; NaN if no such pose was found. The workspace
        extends at least this far.
    position, rpy : ndarray, shape (3,)
        Center pose: position of the tool (m) and roll, pitch, yaw (rad).
    distance_to_limit : float
        Distance from the center pose to the nearest sampled pose that violates a limit (m, or rad for
        rotations). It is an upper bound that decreases with the number of samples. 0 if the center pose
        violates a limit, infinite if no sampled pose does, NaN for kind "six_dof".
    limit_fractions : dict of float
        Fraction of the sampled poses by the first limit that each violates; the keys are ``REASONS``.
    samples : int
        Number of sampled poses.
    tool : ndarray, shape (3,)
        Platform point whose positions are given (m), in the platform frame.
    """

    kind: str
    volume: float
    error: float
    unit: str
    bounds: Array
    extent: Array
    position: Array
    rpy: Array
    distance_to_limit: float
    limit_fractions: dict[str, float]
    samples: int
    tool: Array

    @property
    def is_known(self) -> bool:
        """True if the volume exceeds its error."""
        return self.volume > self.error


def workspace(
    robot: Robot,
    kind: Kind = "constant_orientation",
    limits: PoseLimits | None = None,
    position: ArrayLike | None = None,
    rpy: ArrayLike = (0.0, 0.0, 0.0),
    position_bounds: ArrayLike | None = None,
    rpy_bounds: ArrayLike | None = None,
    samples: int = 1_000_000,
    seed: int = 0,
    scheduler: str | None = None,
    progress: Progress = silent,
) -> WorkspaceResult:
    """Estimate the workspace volume, its uncertainty, and the limiting constraints.

    The search box is divided into cells. Cells that are certainly beyond the leg lengths or on the other side
    of the base are discarded; two random poses are tested in each remaining cell. Positions refer to the
    robot's tool.

    Parameters
    ----------
    robot : Robot
        Robot with limits.
    kind : {"constant_orientation", "orientation", "six_dof"}, optional
        Varying coordinates: positions, rotations, or both.
    limits : PoseLimits, optional
        Limits to apply, with a load that acts at the tool; by default the limits of the robot.
    position : array_like, shape (3,), optional
        Position of the tool in the center pose (m); by default the home position.
    rpy : array_like, shape (3,), optional
        Roll, pitch, and yaw of the center pose (rad); by default parallel to the base.
    position_bounds : array_like, shape (3, 2), optional
        Minimum and maximum of t_x, t_y, t_z (m); by default the positions that the longest legs reach.
    rpy_bounds : array_like, shape (3, 2), optional
        Minimum and maximum of roll, pitch, and yaw (rad); by default all rotations.
    samples : int, optional
        Number of random poses. The error of a volume of positions is proportional to samples^(-2/3).
    seed : int, optional
        Random seed. Equal seeds give bit-identical results on every scheduler.
    scheduler : str, optional
        "local" for one Dask worker per core, or the address of a Dask scheduler. None runs in this process.
    progress : callable, optional
        Called with a text and the completed fraction.

    Returns
    -------
    WorkspaceResult
        Volume, extent, and limiting constraints.

    Raises
    ------
    ValueError
        If an argument is invalid, or if neither leg lengths nor ``position_bounds`` bound the positions.

    Warns
    -----
    WorkspaceWarning
        If no pose within the limits is found, or if the error exceeds the volume.

    See Also
    --------
    capability_polytope : Wrenches and accelerations within the force limits at a pose.
    path_singularities : Find singular poses along a path.

    Notes
    -----
    The kinds are the constant-orientation workspace, the orientation workspace, and the six-dimensional set
    of all poses.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> result = ss.workspace(ss.robots.load("rubin_camera"), samples=4_000)
    >>> f"{1e9 * result.volume:.0f} +- {1e9 * result.error:.0f} mm^3"
    '31845 +- 780 mm^3'
    >>> {name: round(fraction, 2) for name, fraction in result.limit_fractions.items() if fraction}
    {'feasible': 0.55, 'leg_length': 0.45}
    """
    instance(robot, Robot, "robot")
    need_no_offsets(robot)
    option(kind, KINDS, "kind")
    limits = PoseLimits() if limits is None else limits
    instance(limits, PoseLimits, "limits")
    count = whole_number(samples, "samples", 100, "a whole number from 100 to 10^12", _MOST)
    seed = whole_number(seed, "seed", 0, "a whole number from 0 to 2^63 - 1", 2**63 - 1)
    examined = Region(PoseExaminer(robot, at_reference(robot, limits)), kind, *middle(robot, position, rpy))
    search = examined.box(position_bounds, rpy_bounds)
    progress("discarding unreachable poses")
    grid = stratified_sampling.cells_of(search, count, examined.weights, examined.surely_broken)
    look = functools.partial(stratified_sampling.tally, examine=examined.examine, codes=len(REASONS))
    tallies = parallel.run(
        stratified_sampling.jobs_of(grid, seed), look, scheduler, progress, f"examining {count} poses"
    )
    found = stratified_sampling.total(tallies, len(search), len(REASONS))
    if not found.codes[0]:
        reason = "" if position_bounds is None else examined.out_of_reach(search)
        remedy = reason or f"; state {_ELSEWHERE[kind]}, wider limits, or more samples"
        warn(f"workspace: no pose within the limits was found{remedy}", WorkspaceWarning)
    result = examined.workspace(grid, found, position_bounds is None)
    if found.codes[0] and not result.is_known:
        sizes = f"{result.error:.2g} and {result.volume:.2g} {result.unit}"
        warn(
            f"workspace: the error exceeds the volume ({sizes}), {found.codes[0]} of {result.samples} poses "
            "are within the limits; volume and extents are unknown; use more samples or narrower bounds",
            WorkspaceWarning,
        )
    return result


def middle(robot: Robot, position: ArrayLike | None, rpy: ArrayLike) -> tuple[Array, Array]:
    """Return the tool position (m) and the roll, pitch, and yaw (rad) of the center pose, shape (3,) each."""
    if position is None:
        t = home_pose(robot).t + robot.tool
    else:
        t = finite_array(position, (3,), "position", batch=False)
    return t.copy(), finite_array(rpy, (3,), "rpy", batch=False)


@dataclass(frozen=True, eq=False)
class Region(Frozen):
    """Poses of one kind in coordinates with a uniform measure: tool position; roll, sin(pitch), and yaw."""

    examiner: PoseExaminer
    kind: Kind
    position: Array
    angles: Array
    rotation: Array = field(init=False)

    def __post_init__(self) -> None:
        """Compute the rotation of the center pose."""
        self._set({"rotation": rotation_from_rpy(self.angles)})

    def box(self, box: ArrayLike | None, turns: ArrayLike | None) -> Array:
        """Return the bounds of the search coordinates, shape (3, 2) or (6, 2)."""
        if box is not None and self.kind == "orientation":
            raise ValueError("position_bounds: expected None, positions do not vary for this kind")
        if turns is not None and self.kind == "constant_orientation":
            raise ValueError("rpy_bounds: expected None, rotations do not vary for this kind")
        parts = []
        if self.kind != "orientation":
            parts.append(self._reach() if box is None else _ranges(box, "position_bounds", "m"))
        if self.kind != "constant_orientation":
            given = WHOLE_TURN if turns is None else _ranges(turns, "rpy_bounds", "rad")
            if np.any(given < WHOLE_TURN[:, :1]) or np.any(given > WHOLE_TURN[:, 1:]):
                raise ValueError(
                    "rpy_bounds: expected roll and yaw within -pi and pi, pitch within -pi/2 and pi/2"
                )
            parts.append(_with_pitch(given, np.sin))
        return np.concatenate(parts)

    def out_of_reach(self, box: Array) -> str:
        """Return a text about the first axis on which a box (m), (3, 2) or (6, 2), is beyond the reach."""
        try:
            reach = self._reach()
        except ValueError:
            return ""
        for axis, (low, high), (least, most) in zip("xyz", box, reach, strict=False):
            if low > most or high < least:
                finding = f"t_{axis} from {low:.4g} to {high:.4g} m is beyond the reach of the legs"
                return f"; position_bounds: {finding}, {least:.4g} to {most:.4g} m; state other bounds, in m"
        return ""

    def _reach(self) -> Array:
        """Return a box around the positions that the longest legs can reach (m), shape (3, 2)."""
        robot, limits = self.examiner.robot, self.examiner.limits
        longest = robot.length_limits[:, 1] if limits.lengths else np.full(len(robot.b), math.inf)
        arm = (robot.p - robot.tool) @ self.rotation.T
        centers, radii = robot.b - arm, longest
        if self.kind == "six_dof":
            centers, radii = robot.b, longest + np.linalg.norm(arm, axis=-1)
        low, high = np.max(centers - radii[:, None], axis=0), np.min(centers + radii[:, None], axis=0)
        if not np.all(np.isfinite(low) & np.isfinite(high)):
            raise ValueError("robot: length_limits: no leg has an upper limit, expected position_bounds")
        if np.any(high <= low):
            raise ValueError("robot: length_limits: the longest legs reach no common position")
        return np.stack([low, high], axis=-1)

    def poses(self, coordinates: Array) -> tuple[Array, Array]:
        """Return R (n, 3, 3) and t of the reference point (m), shape (n, 3), for coordinates (n, d)."""
        n = len(coordinates)
        at_tool = np.broadcast_to(self.position, (n, 3)) if self.kind == "orientation" else coordinates[:, :3]
        if self.kind == "constant_orientation":
            return np.broadcast_to(self.rotation, (n, 3, 3)), at_tool - self.arm
        theta = coordinates[:, -3:].copy()
        theta[:, 1] = _pitch(theta[:, 1])
        R = rotation_from_rpy(theta)
        return R, at_tool - R @ self.examiner.robot.tool

    def examine(self, coordinates: Array) -> tuple[NDArray[np.int8], Array]:
        """Return each pose's first violated limit and its distance from the center (m or rad), shape (n,)."""
        R, t = self.poses(coordinates)
        return self.examiner.broken_limits(R, t), self._distances(R, t)

    @property
    def arm(self) -> Array:
        """Vector from the reference point to the tool in the center pose (m), base frame, shape (3,)."""
        return np.asarray(self.rotation @ self.examiner.robot.tool)

    def _distances(self, R: Array, t: Array) -> Array:
        if self.kind == "constant_orientation":
            return np.asarray(np.linalg.norm(t + self.arm - self.position, axis=-1))
        if self.kind == "orientation":
            # |R - R_0| in the Frobenius norm is 2 sqrt(2) sin(angle / 2).
            apart = np.linalg.norm(R - self.rotation, axis=(-2, -1)) / math.sqrt(8.0)
            return np.asarray(2.0 * np.arcsin(np.minimum(apart, 1.0)))
        return np.full(len(t), math.nan)

    @property
    def weights(self) -> Array:
        """Displacement of the platform joints per unit of each coordinate (m), shape (d,)."""
        arm = characteristic_length(self.examiner.robot) or 1.0
        parts = {"constant_orientation": [1.0], "orientation": [arm], "six_dof": [1.0, arm]}[self.kind]
        return np.repeat(parts, 3)

    def surely_broken(self, low: Array, high: Array) -> Flags:
        """Return True for boxes, bounds (n, d), in which every pose violates a limit, shape (n,)."""
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        turn = np.zeros(len(low))
        if self.kind != "constant_orientation":
            pitch = _pitch(np.stack([low[:, -2], high[:, -2]]))
            middle[:, -2] = np.sin(pitch.mean(axis=0))
            turn = half[:, -3] + 0.5 * (pitch[1] - pitch[0]) + half[:, -1]
        shift = turn * 0.0 if self.kind == "orientation" else np.linalg.norm(half[:, :3], axis=-1)
        return self.examiner.surely_broken(*self.poses(middle), shift, turn, self.examiner.robot.tool)

    def workspace(self, grid: Cells, found: Tally, within_reach: bool) -> WorkspaceResult:
        """Build the result; ``within_reach`` is True if the grid contains all reachable positions."""
        size, error = stratified_sampling.volume(grid, found)
        examined = max(1, int(found.codes.sum()))
        own = self.examiner.broken_limits(self.rotation[None], (self.position - self.arm)[None])[0]
        clear = 0.0 if own else found.nearest
        if within_reach and self.kind == "constant_orientation":
            clear = min(clear, float(np.min(np.abs(grid.box - self.position[:, None]))))
        return WorkspaceResult(
            kind=self.kind,
            volume=size,
            error=error,
            unit=UNITS[self.kind],
            bounds=self._as_angles(grid.box),
            extent=self._as_angles(np.where(np.isfinite(found.extent), found.extent, math.nan)),
            position=self.position.copy(),
            rpy=self.angles.copy(),
            distance_to_limit=math.nan if self.kind == "six_dof" else clear,
            limit_fractions={
                name: count / examined for name, count in zip(REASONS, found.codes.tolist(), strict=True)
            },
            samples=examined,
            tool=self.examiner.robot.tool.copy(),
        )

    def _as_angles(self, box: Array) -> Array:
        """Convert the sine of the pitch to the pitch (rad) in bounds of shape (d, 2)."""
        return box.copy() if self.kind == "constant_orientation" else _with_pitch(box, _pitch)


def _ranges(value: ArrayLike, name: str, unit: str) -> Array:
    found = finite_array(value, (3, 2), name, batch=False)
    if np.any(found[:, 1] <= found[:, 0]):
        low, high = found[np.argmax(found[:, 1] <= found[:, 0])]
        raise ValueError(f"{name}: expected least < greatest, got {low:g} and {high:g} {unit}")
    return found


def _with_pitch(box: Array, change: Callable[[Array], Array]) -> Array:
    """Apply ``change`` to the pitch row of bounds of shape (3, 2) or (6, 2)."""
    found = box.copy()
    found[-2] = change(found[-2])
    return found


def _pitch(sine: Array) -> Array:
    """Return the pitch (rad) for its sine, which may exceed 1 by rounding."""
    return np.asarray(np.arcsin(np.clip(sine, -1.0, 1.0)))
