"""Path parameterization: the motion of least time, or of least energy or peak force in a given time."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..backend.kernel import FORMULATIONS
from ..drives.friction import viscous
from ..dynamics.inverse_dynamics import Formulation
from ..io.arguments import finite_array, instance, option, real_array, shown, whole_number
from ..io.array_types import Array
from ..io.error_policy import warn
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
"""Quantities that a motion along a path can minimize."""

CELLS = 400
"""Cells of the first grid. Cells without an active limit, or with a violated limit, are divided."""
SMOOTH_CELLS = 300
"""Largest number of spline cells of a smooth motion."""

# Number of samples in the comparison of the rates of the path with its poses.
_PLACES = 8193
_DIVISIONS = 3
_ROUNDS = 15
# Static utilization of a motor limit above which a smooth motion is also computed. The shorter motion is
# returned.
_TIGHT = 0.9
# Number of updates, in one round, of friction and power bounds, which depend on the motion.
_FEW_TURNS = 2
# Number of parts of the first and the last cell.
_AT_ENDS = 20
# Static utilization of a limit from which a pose is rejected. At 100 % the motion would need an infinite
# time there.
_HOLD = 1.0 - 1e-6
_RESTS = 1e-12
_ROUGH_CELLS = 200
# Smallest peak force of the search, divided by the largest static force.
_ABOVE_REST = 1.0 + 1e-3
# Relative tolerance of the peak force.
_SAME_FORCE = 1e-5
# Smallest relative margin between the given and the minimum duration. Below it nothing is optimized.
_NO_ROOM = 1e-3
_SAME_TIME = 1e-12


@dataclass(frozen=True, eq=False)
class TimedPath:
    """Path with its parameter as a function of time.

    Attributes
    ----------
    robot : Robot
        Robot model.
    path : callable
        Function: parameters s, shape (n,) -> motion with derivatives with respect to s.
    limits : PathLimits
        Limits that replace or extend the limits of the robot.
    formulation : {"exact", "paper"}
        Formulation of inverse dynamics.
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
        """Duration of the motion (s)."""
        return self.profile.duration

    def time_grid(self, count: int) -> Array:
        """Return evenly spaced times, and the times on both sides of each jump of the accelerations.

        Parameters
        ----------
        count : int
            Number of evenly spaced times.

        Returns
        -------
        ndarray, shape (n,)
            Times (s) from 0 to the duration, n >= count.
        """
        nodes = self.profile.times[1:-1]
        even = np.linspace(0.0, self.duration, count)
        return np.unique(np.concatenate([even, np.nextafter(nodes, 0.0), nodes]))

    def sample(self, time: ArrayLike) -> Motion:
        """Return the motion at given times.

        Parameters
        ----------
        time : array_like, shape (...)
            Times (s) from 0 to the duration.

        Returns
        -------
        Motion
            Motion with accelerations, shape (...).

        Raises
        ------
        ValueError
            If a time is outside the motion.
        """
        when = real_array(time, "time")
        # A requested duration is met up to rounding errors.
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
    """Compute the motion of least time, energy, or peak force along a path within all limits.

    The motion begins and ends at rest.

    Parameters
    ----------
    robot : Robot
        Robot with limits of force and speed, without joint offsets.
    path : callable
        Function: parameters s, shape (n,) -> ``Motion`` whose velocities and accelerations are first and
        second derivatives with respect to s, for example a ``PosePath``. Its loads are included. The first
        derivatives must be continuous and nonzero.
    span : tuple of float, optional
        First and last s, in ascending order.
    limits : PathLimits, optional
        Limits that replace or extend the limits of the robot.
    formulation : {"exact", "paper"}, optional
        Corrected equations or equations as printed.
    grid_size : int, optional
        Number of cells of the first grid, 10 to 100,000.
    progress : callable, optional
        Function that is called with a text and the completed fraction, 0 to 1.
    minimize : {"time", "energy", "peak_force"}, optional
        Minimized quantity. The energy is the electrical energy as in ``drive_effort``: work at the motor
        shafts, recovered if it is negative, and heat of the windings. Without a drive it is the work of the
        leg forces. The peak force is the largest force of any leg during the motion. It can be smaller than
        the largest static force on the path.
    duration : float, optional
        Duration of the motion (s); required for "energy" and "peak_force".

    Returns
    -------
    TimedPath
        Path with its parameter as a function of time.

    Raises
    ------
    ValueError
        If an argument is invalid, or if a pose of the path cannot be held at rest within the limits. If the
        velocities of the path contradict its poses, or jump by more than a few thousandths of the largest
        rate. If ``duration`` is below the minimum, which the message contains.

    Warns
    -----
    UserWarning
        If only speeds limit a motion of least time, so that its forces are unbounded.

    See Also
    --------
    plan_path : Smooth path through via poses.
    certify_plan : Independent verification of the result.

    Notes
    -----
    Forces are computed by inverse dynamics and include viscous friction. Torque, speed, current, and power of
    the motors are computed as in ``drive_effort`` and include all friction of the drives.

    Without a limit of jerk, the motion of least time is computed on a grid in the phase plane of s and s'.
    Limits that are exceeded between the nodes are tightened there. With a limit of jerk, for least energy, or
    if this grid finds no motion within the limits, the squared rate of an eased parameter is a spline.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> def path(s):
    ...     zero = np.zeros((len(s), 3))
    ...     t = np.array([0.1, 0.0, 0.4]) + np.outer(s, [0.2, 0.0, 0.2])
    ...     R = np.broadcast_to(np.eye(3), (len(s), 3, 3))
    ...     return ss.Motion(R=R, t=t, omega=zero, v=zero + [0.2, 0.0, 0.2], alpha=zero, a=zero)
    >>> limits = ss.PathLimits(force=3000.0, speed=0.5)
    >>> plan = ss.parameterize_path(robot, path, limits=limits, grid_size=20)
    >>> round(plan.duration, 3)
    0.594
    >>> plan.sample([0.0, 0.5 * plan.duration, plan.duration]).v[:, 0].round(2)
    array([0.  , 0.36, 0.  ])
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
    """Arguments of ``parameterize_path``, with the search for the motion."""

    robot: Robot
    path: Path
    span: tuple[float, float]
    limits: PathLimits
    formulation: Formulation
    cells: int
    progress: Progress

    def source(self, limits: PathLimits) -> Source:
        """Return the source of the terms for given limits."""
        return lambda s: terms_along(self.robot, self.path, s, limits, self.formulation)

    def need_possible(self) -> bool:
        """Check the path and the limits; return True if more than speeds is limited."""
        nodes = _first_nodes(*self.span, self.cells)
        terms = self.source(self.limits)(nodes)
        limited = self.limits.jerk is not None or terms.motors is not None or np.isfinite(terms.limit).any()
        if not limited and not np.isfinite(terms.caps).all():
            raise ValueError("limits: expected a limit of force, speed, or acceleration, got none")
        effect = np.abs(terms.a).max(axis=-1)
        if effect.min() <= _RESTS * effect.max():
            where = nodes[np.argmin(effect)]
            raise ValueError(f"path: expected nonzero velocities along the path, got zero at s = {where:.6g}")
        need_held(terms, nodes)
        need_rates(self.robot, self.path, np.linspace(*self.span, _PLACES))
        return bool(limited)

    def fastest(self, limits: PathLimits) -> Profile:
        """Compute the fastest motion within limits."""
        found = None
        if limits.jerk is None:
            grid, found = self._in_phase_plane(limits)
            if found is not None and (grid.terms.motors is None or grid.terms.held().max() < _TIGHT):
                return found
        # If the static load needs nearly all of a limit, bounds at the nodes exclude fast motions.
        smooth = self.smooth(limits)
        other = smooth.profile(smooth.fastest(partial(self.progress, "finding the fastest smooth motion")))
        return other if found is None or other.duration < found.duration else found

    def _in_phase_plane(self, limits: PathLimits) -> tuple[Grid, Profile | None]:
        """Compute the fastest motion without jerk limits, and its grid; None if it violates other limits."""
        grid = Grid.of(self.source(limits), _first_nodes(*self.span, self.cells))
        if grid.terms.motors is not None:
            nodes = _first_nodes(*self.span, min(self.cells, _ROUGH_CELLS))
            grid = grid.after(Grid.at(self.source(limits), nodes).fastest()[1])
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
        """Return the terms of the path with an eased parameter."""
        cells = min(self.cells, SMOOTH_CELLS)
        ease = Ease(*self.span, 1 if limits.jerk is None else 2)
        path, jerk = eased(self.path, ease), np.array(limits.jerk or [np.inf] * LEGS)
        source = self._replace(path=path).source(limits)
        found = SmoothPath.of(source, lambda x: length_rates(self.robot, path, x), ease, cells, jerk)
        need_held(found.between, found.places)
        return found

    def thriftiest(self, duration: float) -> Profile | None:
        """Compute the motion of least energy in a duration; None if it is too short for a smooth motion."""
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
        """Compute the fastest smooth motion; its coefficients are None if it is too slow."""
        smooth = self.smooth(self.limits)
        start = smooth.fastest(shown)
        return smooth, start if smooth.profile(start).duration <= duration * (1.0 - _NO_ROOM) else None

    def gentlest(self, quickest: Profile, duration: float) -> Profile:
        """Compute the motion of least peak force in a duration or slightly less."""
        from scipy.optimize import brentq

        own = force_limits(self.robot, self.limits)
        at_rest = np.abs(self.source(self.limits)(quickest.nodes.s).e[:, :LEGS]).max(axis=-1)
        held, at_ends = float(at_rest.max()), float(max(at_rest[0], at_rest[-1]))
        highest, tries = self._peak(quickest), itertools.count(1)
        lowest, best = min(held * _ABOVE_REST, highest), quickest

        @cache
        def excess(force: float) -> float:
            """Return 1 / time^2 minus its goal, roughly proportional to the force above the static force."""
            nonlocal best
            text = f"finding the motion of least peak force, try {next(tries)}"
            task = self._replace(progress=lambda _, share=None: self.progress(text, share))
            profile = task.fastest(replace(self.limits, force=np.minimum(own, force)))
            best = profile if duration >= profile.duration > best.duration else best
            return float(profile.duration**-2 - duration**-2)

        if excess(lowest) >= 0.0:
            return self._below_rest(best, duration) if held > at_ends * _ABOVE_REST else best
        if excess(highest) > 0.0:
            brentq(excess, lowest, highest, rtol=_SAME_FORCE)
        return best

    def _below_rest(self, profile: Profile, duration: float) -> Profile:
        """Return ``profile`` or a smooth motion with a smaller peak force.

        The peak can be smaller than the largest static force if the robot moves through the poses with the
        largest static force.
        """
        shown = partial(self.progress, "finding the motion of least peak force")
        smooth, start = self._faster(duration, shown)
        if start is None:
            return profile
        found = smooth.profile(smooth.gentlest(start, duration, shown))
        return min((each.slowed(each.duration / duration) for each in (profile, found)), key=self._peak)

    def _peak(self, profile: Profile) -> float:
        """Return the largest leg force (N) at the nodes of a motion."""
        nodes = profile.nodes
        values = self.source(self.limits)(nodes.s).values(nodes.rate**2, nodes.second)
        return float(np.abs(values[:, :LEGS]).max())


def need_duration(least: Minimize, duration: float | None) -> None:
    """Raise ValueError if least time has a duration, or if another objective has none."""
    if least == "time" and duration is not None:
        raise ValueError(f'duration: applies to minimize "energy" or "peak_force", got "{least}"')
    if least != "time" and duration is None:
        raise ValueError(f'minimize: expected a duration for "{least}"')


def need_losses(robot: Robot) -> None:
    """Raise ValueError if viscous friction, winding resistance, and efficiency losses are all zero."""
    losses, drive = [robot.C_u, robot.C_p, robot.C_s], robot.drive
    if drive is not None:
        losses += [drive.resistance, viscous(drive), 1.0 - drive.efficiency, 1.0 - drive.backdrive_efficiency]
    if not any(np.any(loss) for loss in losses):
        raise ValueError(
            "robot: expected viscous friction, a winding resistance, or an efficiency below 1; otherwise all "
            "motions along the path need the same energy"
        )


def _first_nodes(start: float, end: float, cells: int) -> Array:
    """Return even nodes, with more in the first and last cell, because friction changes rapidly there."""
    even = np.linspace(start, end, cells + 1)
    more = (even[1] - even[0]) * (np.arange(1, _AT_ENDS) / _AT_ENDS) ** 3
    return np.concatenate([even[:1], start + more, even[1:-1], end - more[::-1], even[-1:]])


def need_held(terms: Terms, s: Array) -> None:
    """Raise ValueError for poses that cannot be held at rest."""
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
