"""The best motion along a path within all limits: the fastest, or one of a duration."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..drives.friction import viscous
from ..dynamics.inverse_dynamics import Formulation
from ..io.arguments import finite_array, instance, option, real_array, shown, whole_number
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.extras import needed_for
from ..io.progress import Progress, silent
from ..io.toml_reader import positive
from ..motion.motion import Motion
from ..robot.offsets import need_no_offsets
from ..robot.robot import LEGS, Robot
from .smooth.costs import EnergyCost
from .smooth.smooth_time import SmoothPath, eased, length_rates
from .timing.grid import AIM, Grid, Source
from .timing.path_rates import need_motions, need_rates
from .timing.path_terms import Path, PathLimits, Terms, force_limits, terms_along, traveled
from .timing.phase_plane import Ease, Profile

Minimize = Literal["time", "energy", "peak_force"]
MINIMIZE: tuple[Minimize, ...] = ("time", "energy", "peak_force")
"""What a motion along a path can have least of."""

CELLS = 400
"""Cells of the first grid; those in which no limit is active, or one is exceeded, are divided."""
SMOOTH_CELLS = 300
"""Most cells of the spline of a smooth motion."""

# Places along the path at which its rates are held against its poses.
_PLACES = 8193
_DIVISIONS = 3
_ROUNDS = 15
# Share of a limit that holding the machine takes from which on two ways to the fastest motion are tried.
_TIGHT = 0.9
# Bounds by friction and power depend on the motion: how often they are updated in one round.
_FEW_TURNS = 2
# Parts of the first and of the last cell.
_AT_ENDS = 20
# A machine that can just about hold its own weight at a pose of the path takes for ever to pass it.
_HOLD = 1.0 - 1e-6
_RESTS = 1e-12
_ROUGH_CELLS = 200
# The least peak force that is looked for, over the largest force at rest, and to what share.
_ABOVE_REST = 1.0 + 1e-3
_SAME_FORCE = 1e-5
# A duration so near the least time of smooth motions leaves nothing to choose.
_NO_ROOM = 1e-3
_SAME_TIME = 1e-12


@dataclass(frozen=True, eq=False)
class TimedPath:
    """A path and how fast it is traveled.

    Attributes
    ----------
    robot : Robot
        The machine.
    path : callable
        Parameters s, (n,), -> motion whose rates are derivatives by s.
    limits : PathLimits
        What was kept to, beside the robot's own limits.
    formulation : str
        Of the forces.
    profile : Profile
        Parameter over time.
    """

    robot: Robot
    path: Path
    limits: PathLimits
    formulation: Formulation
    profile: Profile

    @property
    def duration(self) -> float:
        """Duration of the motion, s."""
        return self.profile.duration

    def time_grid(self, count: int) -> Array:
        """Return even instants, and both sides of every jump of the accelerations between them.

        Parameters
        ----------
        count : int
            How many even ones.

        Returns
        -------
        ndarray
            From 0 to the duration, s, (n,), n >= count.
        """
        nodes = self.profile.times[1:-1]
        even = np.linspace(0.0, self.duration, count)
        return np.unique(np.concatenate([even, np.nextafter(nodes, 0.0), nodes]))

    def sample(self, time: ArrayLike) -> Motion:
        """Return the motion at given times.

        Parameters
        ----------
        time : array_like
            From 0 to the duration, s, (...).

        Returns
        -------
        Motion
            Of their shape.

        Raises
        ------
        ValueError
            For times outside.
        """
        when = real_array(time, "time")
        # A duration that was asked for is kept to rounding.
        if when.size and not (when.min() >= 0.0 and when.max() <= self.duration * (1.0 + _SAME_TIME)):
            raise ValueError(f"time: expected times in [0, {self.duration:.9g}] s")
        place = self.profile.at(np.minimum(when.ravel(), self.duration))
        motion = traveled(self.path(place.s), place.rate, place.second)
        return motion[np.arange(when.size).reshape(when.shape)]


def parameterize_path(
    robot: Robot,
    path: Path,
    span: tuple[float, float] = (0.0, 1.0),
    limits: PathLimits | None = None,
    formulation: Formulation = "exact",
    grid_size: int = CELLS,
    progress: Progress = silent,
    minimize: Minimize = "time",
    duration: float | None = None,
) -> TimedPath:
    """Find the best motion along a path, from rest to rest, within all limits: the fastest, or of a duration.

    Forces are those of inverse dynamics, viscous friction included; torque, speed, current and power of a
    drive's motors are those of ``drive_effort``, all its friction included. Where a limit is exceeded between
    the nodes of the grid it is tightened by as much, until none is.

    Parameters
    ----------
    robot : Robot
        The machine with its limits of force and speed.
    path : callable
        Parameters s, (n,), -> ``Motion`` whose rates and accelerations are first and second derivatives by s,
        such as a ``PosePath``; its loads are kept. It rests nowhere, and its rates do not jump.
    span : tuple of float, optional
        First and last s, the first less than the last.
    limits : PathLimits, optional
        Limits that replace or add to the robot's.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    grid_size : int, optional
        Of the first grid, 10 to 100,000.
    progress : callable, optional
        Called with what is being done.

    minimize : {"time", "energy", "peak_force"}, optional
        What is made least. Energy: electrical, as ``drive_effort`` states it, work at the motors' shafts,
        given back where it is negative, and heat of their windings; without a drive the work of the leg
        forces. Peak force: the largest of any leg while the machine moves, which may be less than at rest.
    duration : float, optional
        Of the motion, s; needed for least energy and peak force.

    Returns
    -------
    TimedPath
        Path and parameter over time.

    Raises
    ------
    ValueError
        Naming the argument, or the limit that stands in the way and where: the machine must be able to stand
        still at every pose of the path. For a path whose rates contradict its poses, or jump, by more than
        some thousandths, or whose accelerations are of other rates: naming a leg and where. For a duration
        below the least time, which it names.

    Warns
    -----
    UserWarning
        Where speeds alone are limited, so that forces of the fastest motion have no bound.
    """
    instance(robot, Robot, "robot")
    need_no_offsets(robot)
    if not callable(path):
        raise ValueError(f"path: expected a function of a parameter, got {shown(path)}")
    ends = finite_array(span, (2,), "span", batch=False)
    if not ends[0] < ends[1]:
        raise ValueError(f"span: expected a first s less than the last, got {shown(span)}")
    option(formulation, FORMULATIONS, "formulation")
    limits = PathLimits() if limits is None else limits
    instance(limits, PathLimits, "limits")
    whole_number(grid_size, "grid_size", 10, "a whole number from 10 to 100,000", 100_000)
    option(minimize, MINIMIZE, "minimize")
    need_duration(minimize, duration)
    need_motions(path, ends)
    task = _Task(robot, path, (float(ends[0]), float(ends[1])), limits, formulation, grid_size, progress)
    if not task.need_possible() and minimize == "time":
        warn(
            "limits: expected a limit of force, acceleration, or jerk in addition to speed, got none: "
            "forces of the fastest motion have no bound"
        )
    profile = task.fastest(limits)
    if duration is not None:
        given = positive(duration, "duration")
        if given < profile.duration * (1.0 - 1e-9):
            raise ValueError(
                f"duration: expected at least the least time, {profile.duration:.6g} s, got {given:g}"
            )
        found = task.thriftiest(given) if minimize == "energy" else task.gentlest(profile, given)
        slow = profile if found is None else found
        profile = slow.slowed(slow.duration / given)
    return TimedPath(robot, path, limits, formulation, profile)


class _Task(NamedTuple):
    """What is to be timed; arguments of ``parameterize_path``."""

    robot: Robot
    path: Path
    span: tuple[float, float]
    limits: PathLimits
    formulation: Formulation
    cells: int
    progress: Progress

    def source(self, limits: PathLimits) -> Source:
        return lambda s: terms_along(self.robot, self.path, s, limits, self.formulation)

    def need_possible(self) -> bool:
        """Reject a path that cannot be traveled or limits nothing; whether more than speeds is limited."""
        nodes, jerk = _first_nodes(*self.span, self.cells), self.limits.jerk is not None
        terms = self.source(self.limits)(nodes)
        need_bounded(terms, nodes, jerk)
        need_rates(self.robot, self.path, np.linspace(*self.span, _PLACES))
        return jerk or terms.motors is not None or bool(np.isfinite(terms.limit).any())

    def fastest(self, limits: PathLimits) -> Profile:
        found = None
        if limits.jerk is None:
            grid, found = self._in_phase_plane(limits)
            if found is not None and (grid.terms.motors is None or grid.terms.held().max() < _TIGHT):
                return found
        # Where holding the machine takes nearly all of a limit, bounds at nodes leave out fast motions.
        smooth = self.smooth(limits)
        other = smooth.profile(smooth.fastest(partial(self.progress, "finding the fastest smooth motion")))
        return other if found is None or other.duration < found.duration else found

    def _in_phase_plane(self, limits: PathLimits) -> tuple[Grid, Profile | None]:
        """The fastest motion without a limit of jerk, None where it exceeds others, and its grid."""
        grid = Grid.of(self.source(limits), _first_nodes(*self.span, self.cells))
        if grid.terms.motors is not None:
            grid = grid.after(self._replace(cells=min(self.cells, _ROUGH_CELLS)).rough(limits))
        for turn in range(_ROUNDS):
            self.progress("finding the fastest motion", turn / _ROUNDS)
            grid, profile = grid.fastest(_FEW_TURNS)
            used = grid.used(profile)
            if turn < _DIVISIONS:
                grid = grid.divided(used).after(profile)
            elif used.max() <= 0.5 * (1.0 + AIM):
                return grid, profile
            else:
                grid = grid.tightened(used, turn + 1 - _DIVISIONS)
        return grid, None

    def smooth(self, limits: PathLimits) -> SmoothPath:
        """What the path takes of the machine, by an eased parameter."""
        cells = min(self.cells, SMOOTH_CELLS)
        ease = Ease(*self.span, 1 if limits.jerk is None else 2)
        path = eased(self.path, ease)

        def source(x: Array) -> Terms:
            return terms_along(self.robot, path, x, limits, self.formulation)

        jerk = np.array(limits.jerk or [np.inf] * LEGS)
        found = SmoothPath.of(source, lambda x: length_rates(self.robot, path, x), ease, cells, jerk)
        need_held(found.between, found.places)
        return found

    def thriftiest(self, duration: float) -> Profile | None:
        """The motion of least energy in a duration; None where that is too short for a smooth one."""
        need_losses(self.robot)
        shown = partial(self.progress, "finding the motion of least energy")
        shown()
        smooth, start = self._faster(duration, shown)
        if start is None:
            return None
        path = eased(self.path, smooth.ease)
        terms = terms_along(self.robot, path, smooth.nodes, self.limits, self.formulation, motors=True)
        assert terms.motors is not None
        return smooth.profile(smooth.cheapest(EnergyCost.of(terms.motors), start, duration, shown))

    def _faster(self, duration: float, shown: Callable[..., None]) -> tuple[SmoothPath, Array | None]:
        """The fastest smooth motion's coefficients, None where it takes a duration or longer."""
        smooth = self.smooth(self.limits)
        start = smooth.fastest(shown)
        return smooth, start if smooth.profile(start).duration <= duration * (1.0 - _NO_ROOM) else None

    def gentlest(self, quickest: Profile, duration: float) -> Profile:
        """The motion of least peak force in a duration, or a little faster one, from the fastest of all."""
        with needed_for("a motion"):
            from scipy.optimize import brentq
        own, nodes = force_limits(self.robot, self.limits), quickest.nodes
        terms = self.source(self.limits)(nodes.s)
        at_rest = np.abs(terms.e[:, :LEGS]).max(axis=-1)
        held, at_ends = float(at_rest.max()), float(max(at_rest[0], at_rest[-1]))
        highest = self._peak(quickest)
        tries = itertools.count(1)

        def limited(force: float) -> tuple[_Task, PathLimits]:
            text = f"finding the motion of least peak force, try {next(tries)}"
            self.progress(text)
            task = self._replace(progress=lambda _, share=None: self.progress(text, share))
            return task, replace(self.limits, force=np.minimum(own, force))

        def excess(force: float) -> float:
            task, limits = limited(force)
            return task._replace(cells=_ROUGH_CELLS).rough(limits).duration ** -2 - duration**-2

        lowest = min(held * _ABOVE_REST, highest)
        # About 1 / time^2 grows with the force above what the machine takes at rest.
        if excess(lowest) >= 0.0:
            task, limits = limited(lowest)
            profile = task.fastest(limits)
            if profile.duration <= duration:
                passes = held > at_ends * _ABOVE_REST
                return self._below_rest(profile, duration) if passes else profile
            force = lowest * (1.0 + _SAME_FORCE)
        elif excess(highest) <= 0.0:
            return quickest
        else:
            force = float(brentq(excess, lowest, highest, rtol=_SAME_FORCE))
        while force < highest:
            task, limits = limited(force)
            profile = task.fastest(limits)
            if profile.duration <= duration:
                return profile
            force *= 1.0 + 2.0 * max(profile.duration / duration - 1.0, _SAME_FORCE)
        return quickest

    def _below_rest(self, profile: Profile, duration: float) -> Profile:
        """The motion of less peak force in a duration than a faster one within the largest force at rest.

        Less is possible where the machine moves on through the poses that take most at rest.
        """
        shown = partial(self.progress, "finding the motion of least peak force")
        smooth, start = self._faster(duration, shown)
        if start is None:
            return profile
        found = smooth.profile(smooth.gentlest(start, duration, shown))
        return min((each.slowed(each.duration / duration) for each in (profile, found)), key=self._peak)

    def _peak(self, profile: Profile) -> float:
        """The largest force of a leg, N, at the nodes of a motion."""
        nodes = profile.nodes
        values = self.source(self.limits)(nodes.s).values(nodes.rate**2, nodes.second)
        return float(np.abs(values[:, :LEGS]).max())

    def rough(self, limits: PathLimits) -> Profile:
        if limits.jerk is not None:
            return self.fastest(limits)
        return Grid.at(self.source(limits), _first_nodes(*self.span, self.cells)).fastest()[1]


def need_duration(least: Minimize, duration: float | None) -> None:
    """Reject a duration of a motion of least time, and another motion without one."""
    if least == "time" and duration is not None:
        raise ValueError(f'duration: applies to minimize "energy" or "peak_force", got "{least}"')
    if least != "time" and duration is None:
        raise ValueError(f'minimize: expected a duration for "{least}"')


def need_losses(robot: Robot) -> None:
    """Reject a machine whose every motion takes the same energy, but for Stribeck's part of friction."""
    losses, drive = [robot.C_u, robot.C_p, robot.C_s], robot.drive
    if drive is not None:
        losses += [drive.resistance, viscous(drive), 1.0 - drive.efficiency, 1.0 - drive.backdrive_efficiency]
    if not any(np.any(loss) for loss in losses):
        raise ValueError(
            "robot: expected viscous friction, a resistance of windings or an efficiency below 1, without "
            "them every motion along the path takes the same energy"
        )


def _first_nodes(start: float, end: float, cells: int) -> Array:
    """Even nodes, and more in the first and the last cell: friction grows with the root of the way there."""
    even = np.linspace(start, end, cells + 1)
    more = (even[1] - even[0]) * (np.arange(1, _AT_ENDS) / _AT_ENDS) ** 3
    return np.concatenate([even[:1], start + more, even[1:-1], end - more[::-1], even[-1:]])


def need_bounded(terms: Terms, s: Array, bounded: bool) -> None:
    """Reject a path that no limit bounds, one that rests, and poses at which the machine can't stand still.

    bounded: whether the jerk is limited, which the terms do not say.
    """
    if not (bounded or np.isfinite(terms.caps).all() or np.isfinite(terms.limit).any() or terms.motors):
        raise ValueError("limits: expected a limit of force, speed or acceleration, there is none")
    effect = np.abs(terms.a).max(axis=-1)
    if effect.min() <= _RESTS * effect.max():
        where = s[np.argmin(effect)]
        raise ValueError(f"path: expected a path that rests nowhere, it does at s = {where:.6g}")
    need_held(terms, s)


def need_held(terms: Terms, s: Array) -> None:
    """Reject poses at which the machine can't stand still."""
    held = np.abs(terms.e) / terms.limit
    if held.max() >= _HOLD:
        i, k = np.unravel_index(int(np.argmax(held)), held.shape)
        raise ValueError(
            f"limits: {terms.names[k]} is {abs(terms.e[i, k]):.6g} at rest at s = {s[i]:.6g} of the path, "
            f"expected less than its limit, {terms.limit[k]:.6g}"
        )
    if terms.motors is not None and (moved := terms.motors.at_rest()).max() >= _HOLD:
        i, k = np.unravel_index(int(np.argmax(moved)), moved.shape)
        raise ValueError(
            f"limits: {terms.motors.names[k]} is {moved[i, k]:.4g} times its limit at rest or in slow motion "
            f"at s = {s[i]:.6g} of the path"
        )
