"""Rounding errors of the forces compared with their bounds, in double and float, for one machine.

The reference is quadruple precision (``quad``).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...dynamics.force_error_bounds import force_error_bounds
from ...dynamics.forces import Precision
from ...dynamics.home_pose import radius
from ...io.array_types import Array, Flags
from ...io.progress import Progress, silent, tracked
from ...precision.quad import error, quad_forces
from ...results import OK
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ..common.drawing import BLUE, DARK, RED, Axes, Figure, as_written, legend_below, log_numbers, new_figure
from ..common.output import csv_text
from ..common.random_motions import Spread, random_motions

CASES = 2000
SPREAD = Spread(0.3, 0.5, 0.5)
"""Spread of the motions; the time scale of a machine without gravity is one second."""

FAR = 1000.0
"""Ratio of bound to error that should not be exceeded."""

_PRECISIONS: dict[Precision, type[np.floating[Any]]] = {"double": np.float64, "float": np.float32}
_MARKS = {"double": (BLUE, "o"), "float": (RED, "^")}


@dataclass(frozen=True, eq=False)
class Precise:
    """Errors and bounds in one precision for n poses; poses without a solution or a bound are omitted.

    Attributes
    ----------
    error : ndarray, shape (n,)
        Largest error of the six forces (N).
    bound : ndarray, shape (n,)
        Largest bound of the six forces (N).
    rcond : ndarray, shape (n,)
        Reciprocal condition number of H.
    covered : ndarray of bool, shape (n,)
        True if every force is within its own bound.
    robot : str
        Name of the robot.
    left_out : int
        Number of omitted poses.
    """

    error: Array
    bound: Array
    rcond: Array
    covered: Flags
    robot: str
    left_out: int

    @property
    def ratio(self) -> Array:
        """Ratio of bound to error, shape (n,); inf if no force has an error."""
        with np.errstate(divide="ignore"):
            return np.asarray(self.bound / self.error)


Bounds = Mapping[Precision, Precise]


def bounds_study(
    progress: Progress = silent, cases: int = CASES, robot: Robot | None = None, seed: int = 0
) -> Bounds:
    """Compute errors and bounds for random motions of a robot, by precision.

    Parameters
    ----------
    progress : Progress
        Display of the progress.
    cases : int
        Number of motions.
    robot : Robot or None
        Robot with universal base joints; None means the robot of the paper.
    seed : int
        Random seed.

    Returns
    -------
    mapping of str to Precise
        Errors and bounds by precision.

    Raises
    ------
    ValueError
        If the bounds do not support the robot.
    native.CompilerError
        If no compiler supports quadruple precision.
    """
    robot = dasgupta1998() if robot is None else robot
    gravity = float(np.linalg.norm(robot.g)) or radius(robot.b)
    motion = random_motions(np.random.default_rng(seed), robot, cases, SPREAD, gravity)
    found: dict[Precision, Precise] = {}
    for precision, dtype in tracked(
        progress, _PRECISIONS.items(), lambda each: f"bounding the rounding errors of {each[0]}"
    ):
        given = force_error_bounds(robot, motion, precision, on_singular="nan")
        errors = np.abs(error(given.F, quad_forces(robot, motion, dtype)))
        bound = given.bound.astype(np.float64)
        kept = (given.status == OK) & np.isfinite(bound).all(axis=-1) & np.isfinite(errors).all(axis=-1)
        errors, bound = errors[kept], bound[kept]
        found[precision] = Precise(
            error=errors.max(axis=-1),
            bound=bound.max(axis=-1),
            rcond=given.rcond[kept].astype(np.float64),
            covered=(errors <= bound).all(axis=-1),
            robot=robot.name,
            left_out=int(np.count_nonzero(~kept)),
        )
    return found


def csv_rows(data: Bounds) -> str:
    """Format the poses as CSV: precision, error and bound (N), and rcond with all digits."""
    rows = [
        (precision, *row)
        for precision, found in data.items()
        for row in zip(found.error.tolist(), found.bound.tolist(), found.rcond.tolist(), strict=True)
    ]
    return csv_text([("precision", "error", "bound", "rcond"), *rows])


def figure(data: Bounds) -> Figure:
    """Plot bound over true error of every pose, with lines at 1 and 1000 times the error."""
    picture = new_figure(6.4, 5.6)
    axes = picture.subplots()
    for precision, found in data.items():
        color, mark = _MARKS[precision]
        # A logarithmic axis cannot display an error of zero.
        seen = found.error > 0.0
        undrawn, every = found.left_out + int(np.count_nonzero(~seen)), found.left_out + found.error.size
        axes.loglog(
            found.error[seen],
            found.bound[seen],
            mark,
            color=color,
            markersize=2.6,
            markeredgewidth=0.0,
            alpha=0.45,
            label=f"{precision}: bound {np.median(found.ratio):.0f} times the error in the median\n"
            f"{undrawn} of {every} poses left out: no force, bound or error",
        )
    _draw_limits(axes, data)
    axes.set(xlabel="true rounding error, largest of six forces, N", ylabel="bound, largest of six, N")
    (name,) = {found.robot for found in data.values()}
    axes.set_title(f"Rounding error of the forces and its bound\n{as_written(name)}", fontsize=10.0)
    for axis in (axes.xaxis, axes.yaxis):
        log_numbers(axis)
    legend_below(picture, fontsize=8.0, markerscale=2.5)
    return picture


def _draw_limits(axes: Axes, data: Bounds) -> None:
    """Draw the lines between which the points should be, with labels on their outer sides."""
    errors = np.concatenate([found.error[found.error > 0.0] for found in data.values()])
    ends = np.array([errors.min() / 3, errors.max() * 3])
    middle = float(np.sqrt(ends[0] * ends[1]))
    for times, text, dash, sides in (
        (1.0, "bound = error", "-", ("left", "top")),
        (FAR, f"{FAR:.0f} times the error", "--", ("right", "bottom")),
    ):
        axes.loglog(ends, times * ends, dash, color=DARK, linewidth=1.0, zorder=1)
        across, up = sides
        offset = (5, -2) if across == "left" else (-5, 2)
        axes.annotate(
            text,
            (middle, times * middle),
            xytext=offset,
            textcoords="offset points",
            ha=across,
            va=up,
            fontsize=8.5,
            color=DARK,
        )
    axes.set_xlim(*ends)
