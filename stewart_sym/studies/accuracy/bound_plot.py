"""True rounding error of the forces against the bound that comes with them, double and float, on one machine.

Truth is quadruple precision (``quad``).
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
"""How far the motions spread; without gravity they take a second as the machine's own time."""

FAR = 1000.0
"""A bound should not exceed the error by more than this factor."""

_PRECISIONS: dict[Precision, type[np.floating[Any]]] = {"double": np.float64, "float": np.float32}
_MARKS = {"double": (BLUE, "o"), "float": (RED, "^")}


@dataclass(frozen=True, eq=False)
class Precise:
    """What one precision says of n poses; those without an answer or without a bound are left out.

    error: largest error of the six forces, N, (n,). bound: largest bound, N, (n,). rcond: reciprocal
    condition of H, (n,). covered: whether every force lies within its own bound, (n,). robot: its name.
    left_out: how many poses.
    """

    error: Array
    bound: Array
    rcond: Array
    covered: Flags
    robot: str
    left_out: int

    @property
    def ratio(self) -> Array:
        """Bound over error, (n,); inf where no force errs."""
        with np.errstate(divide="ignore"):
            return np.asarray(self.bound / self.error)


Bounds = Mapping[Precision, Precise]


def bounds_study(
    progress: Progress = silent, cases: int = CASES, robot: Robot | None = None, seed: int = 0
) -> Bounds:
    """Errors and bounds at random motions of a robot, by precision.

    cases: how many motions. robot: with universal base joints; None: the paper's machine.

    Raises ValueError for a robot that the bounds do not serve; native.CompilerError where no compiler has
    quadruple precision.
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
    """The poses as CSV, precision, error and bound in N and rcond, with all their digits."""
    rows = [
        (precision, *row)
        for precision, found in data.items()
        for row in zip(found.error.tolist(), found.bound.tolist(), found.rcond.tolist(), strict=True)
    ]
    return csv_text([("precision", "error", "bound", "rcond"), *rows])


def figure(data: Bounds) -> Figure:
    """Bound over true error of every pose, with the lines of 1 and of 1000 times the error."""
    picture = new_figure(6.4, 5.6)
    axes = picture.subplots()
    for precision, found in data.items():
        color, mark = _MARKS[precision]
        # A logarithmic axis has no place for an error of zero.
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
    """The lines between which the points should lie, named on their outer sides, midway."""
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
