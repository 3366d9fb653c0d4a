"""The fastest motion along a path within the limits of forces, speeds and accelerations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..dynamics.inverse import Formulation
from ..io.arguments import finite_array, instance, option, real_array, shown, whole_number
from ..io.array_types import Array
from ..io.progress import Progress, silent
from ..motion.motion import Motion
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot
from .grid import Grid
from .path_terms import Limits, Path, Terms, terms_along, travelled
from .phase_plane import fastest
from .profile import Profile

CELLS = 1000
"""Cells of the first grid; those in which no limit is active, or one is exceeded, are divided."""


_DIVISIONS = 3
_ROUNDS = 15
_AT_ENDS = 20
# A machine that can just about hold its own weight at a pose of the path takes for ever to pass it.
_HOLD = 1.0 - 1e-6
_RESTS = 1e-12


@dataclass(frozen=True, eq=False)
class TimedPath:
    """A path and how fast it is travelled.

    Attributes
    ----------
    robot : Robot
        The machine.
    path : callable
        Parameters s, (n,), -> motion whose rates are derivatives by s.
    limits : Limits
        What was kept to, beside the robot's own limits.
    formulation : str
        Of the forces.
    profile : Profile
        Parameter over time.
    """

    robot: Robot
    path: Path
    limits: Limits
    formulation: Formulation
    profile: Profile

    @property
    def duration(self) -> float:
        """Of the motion, s."""
        return self.profile.duration

    def sample(self, times: ArrayLike) -> Motion:
        """Return the motion at times from 0 to the duration, s, (n,); ValueError for times outside."""
        when = real_array(times, "times")
        if when.size and not (when.min() >= 0.0 and when.max() <= self.duration):
            raise ValueError(f"times: expected times in [0, {self.duration:.9g}] s")
        place = self.profile.at(when)
        return travelled(self.path(place.s), place.rate, place.second)


def time_path(
    robot: Robot,
    path: Path,
    span: tuple[float, float] = (0.0, 1.0),
    limits: Limits | None = None,
    formulation: Formulation = "exact",
    cells: int = CELLS,
    progress: Progress = silent,
) -> TimedPath:
    """Find the fastest motion along a path, from rest to rest, within all limits.

    Forces are those of inverse dynamics, viscous friction included. Where a limit is exceeded between the
    nodes of the grid it is tightened by as much, until none is.

    Parameters
    ----------
    robot : Robot
        The machine with its limits of force and speed.
    path : callable
        Parameters s, (n,), -> ``Motion`` whose rates and accelerations are first and second derivatives by s,
        such as a ``PosePath``; its loads are kept. It rests nowhere.
    span : tuple of float, optional
        First and last s.
    limits : Limits, optional
        Limits that replace or add to the robot's.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    cells : int, optional
        Of the first grid, 10 to 100,000.
    progress : callable, optional
        Called with what is being done.

    Returns
    -------
    TimedPath
        Path and parameter over time.

    Raises
    ------
    ValueError
        Naming the argument, or the limit that stands in the way and where: the machine must be able to stand
        still at every pose of the path.
    """
    instance(robot, Robot, "robot")
    need_no_offsets(robot)
    if not callable(path):
        raise ValueError(f"path: expected a function of a parameter, got {shown(path)}")
    ends = finite_array(span, (2,), "span")
    if ends.ndim != 1:
        raise ValueError(f"span: expected the first and the last parameter, got {shown(span)}")
    option(formulation, FORMULATIONS, "formulation")
    limits = Limits() if limits is None else limits
    instance(limits, Limits, "limits")
    whole_number(cells, "cells", 10, "a whole number from 10 to 100,000", 100_000)

    def source(s: Array) -> Terms:
        return terms_along(robot, path, s, limits, formulation)

    nodes = _first_nodes(float(ends[0]), float(ends[1]), cells)
    need_bounded(source(nodes), nodes)
    grid = Grid.of(source, nodes)
    for turn in range(_ROUNDS):
        progress("finding the fastest motion", turn / _ROUNDS)
        profile = Profile.of(fastest(grid.s, grid.bounds()))
        used = grid.used(profile)
        if turn < _DIVISIONS:
            grid = grid.divided(profile)
        elif used.max() <= 1.0:
            break
        else:
            grid = grid.tightened(used)
    return TimedPath(robot, path, limits, formulation, profile)


def _first_nodes(start: float, end: float, cells: int) -> Array:
    """Even nodes, and more in the first and the last cell: friction grows with the root of the way there."""
    even = np.linspace(start, end, cells + 1)
    more = (even[1] - even[0]) * (np.arange(1, _AT_ENDS) / _AT_ENDS) ** 3
    return np.concatenate([even[:1], start + more, even[1:-1], end - more[::-1], even[-1:]])


def need_bounded(terms: Terms, s: Array) -> None:
    """Reject a path that no limit bounds or that rests, and poses at which the machine can't stand still."""
    if not np.isfinite(terms.caps).all() and not np.isfinite(terms.limit).any():
        raise ValueError("limits: expected a limit of force, speed or acceleration, there is none")
    effect = np.abs(terms.a).max(axis=-1)
    if effect.min() <= _RESTS * effect.max():
        where = s[np.argmin(effect)]
        raise ValueError(f"path: expected a path that rests nowhere, it does at s = {where:.6g}")
    held = np.abs(terms.e) / terms.limit
    if held.max() >= _HOLD:
        i, k = np.unravel_index(int(np.argmax(held)), held.shape)
        raise ValueError(
            f"limits: {terms.names[k]} is {abs(terms.e[i, k]):.6g} at rest at s = {s[i]:.6g} of the path, "
            f"expected less than its limit, {terms.limit[k]:.6g}"
        )
