"""Smooth path through via poses within limits, with a compromise between condition number and length."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from ..design.pose_limits import PoseLimits, need_clearance
from ..io.arguments import finite_array, instance, option, shown
from ..io.array_types import Array
from ..io.progress import Progress, silent
from ..io.toml_reader import not_negative
from ..motion.motion import Motion
from ..robot.robot import Robot
from ..singularities.path_singularities import singularity_crossings
from ..singularities.singular_poses import singularity
from .pose_costs import ROOM, PoseCosts
from .pose_path import Family, PosePath, ViaPose, by_coordinates, poses_of, scales

Objective = Literal["mean", "peak"]
OBJECTIVES: tuple[Objective, ...] = ("mean", "peak")
"""Statistics of the condition number that can be minimized."""

PRICE = 0.5
"""Default weight of length and bending relative to the condition number."""

# Exponent of the power mean that approximates the largest condition number along a path.
_PEAK_POWER = 16
# Singular value, relative to the smallest one of the via poses, below which a path counts as singular.
_NEAR = 0.1
# Weights of the squared violations of limits: one minimization for each, from the result of the previous one.
_PENALTIES = (10.0, 1e3, 1e5)
# Largest number of L-BFGS-B iterations of one minimization.
_STEPS = 60
# Number of initial guesses, and size of their random detours (characteristic lengths and radians).
_STARTS = 12
_SWING = 0.6
# Number of samples along a path for its condition numbers and for the check that it does not turn back.
_FINE = 2001
# Number of searches for the nearest reachable pose, and its largest violation of a limit due to rounding.
_TRIES = 8
_TOUCHES = 1e-3 * ROOM
# Rate of the pose at a via pose, relative to the largest rate, up to which the path turns back there.
_RESTS = 1e-6
# Shares of the best path in blends with the initial spline (1: best path, 0: initial spline), in test order.
_SHARES = (1.0, 0.9, 0.75, 0.5, 0.25, 0.1, 0.03, 0.01, 0.0)


@dataclass(frozen=True)
class Conditions:
    """Condition numbers of H along a path, with moments divided by the characteristic length.

    Attributes
    ----------
    mean : float
        Mean over the length of the path.
    peak : float
        Largest value; inf if det H changes its sign.
    length : float
        Length of the path; translations are divided by the characteristic length and combined with angles.
    """

    mean: float
    peak: float
    length: float


@dataclass(frozen=True, eq=False)
class PlannedPath:
    """Path through via poses.

    Attributes
    ----------
    path : PosePath
        Planned path.
    initial_path : PosePath
        Spline of least bending through the requested via poses.
    requested_poses, reached_poses : tuple of ViaPose
        Requested via poses, and poses on the path, which are within their tolerances.
    condition_numbers, initial_condition_numbers : Conditions
        Condition numbers along ``path`` and along ``initial_path``.
    """

    path: PosePath
    initial_path: PosePath
    requested_poses: tuple[ViaPose, ...]
    reached_poses: tuple[ViaPose, ...]
    condition_numbers: Conditions
    initial_condition_numbers: Conditions


def plan_path(
    robot: Robot,
    via_poses: Sequence[ViaPose],
    limits: PoseLimits | None = None,
    objective: Objective = "mean",
    smoothness_weight: float = PRICE,
    load: ArrayLike = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    progress: Progress = silent,
) -> PlannedPath:
    """Plan a smooth path through via poses of the tool, away from singular poses and within limits.

    Parameters
    ----------
    robot : Robot
        Robot with leg lengths, joint angles, and tool.
    via_poses : sequence of ViaPose
        At least two poses, in the order in which the path reaches them.
    limits : PoseLimits, optional
        Limits of leg lengths, joint angles, condition number, and clearance. The fields ``limits.forces``
        and ``limits.load`` have no effect, because ``parameterize_path`` limits the forces along a path.
    objective : {"mean", "peak"}, optional
        Statistic of the condition number that is minimized, see Notes. If the initial spline is within the
        limits, neither the mean nor the peak exceeds its value on the initial spline.
    smoothness_weight : float, optional
        Weight w of length and bending in the objective, see Notes. With 0 the path bends more and the forces
        increase.
    load : array_like, shape (6,), optional
        External wrench [F_ext; M_ext] at the reference point in the platform frame (N and N m). It has no
        effect on the path, but is part of its motions, so that ``parameterize_path`` includes it.
    progress : callable, optional
        Function that is called with a text and the completed fraction, 0 to 1.

    Returns
    -------
    PlannedPath
        Planned path, initial spline, and their condition numbers.

    Raises
    ------
    ValueError
        If an argument is invalid, a via pose is not reachable, or no path within the limits is found. The
        message names the via pose and the limit.

    See Also
    --------
    parameterize_path : Fastest motion along a path within limits.
    path_singularities : Singularities along a path.

    Notes
    -----
    The objective is K / K_0 + w E / E_0, where K_0 and E_0 belong to the initial spline. K is the power mean
    (mean of kappa^p)^(1/p) of the condition numbers kappa at the samples, with p = 1 for "mean" and p = 16
    for "peak". E is the mean square of the first derivative of the pose by the path parameter, plus the mean
    square of the second derivative divided by (pi (n - 1))^2 for n via poses. The pose consists of the
    translation divided by the characteristic length, and of twice the quaternion. Violations of limits are
    added as penalties.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> via_poses = [ss.ViaPose(np.eye(3), [0.1, 0.0, 0.4]), ss.ViaPose(np.eye(3), [0.3, 0.0, 0.6])]
    >>> plan = ss.plan_path(robot, via_poses)
    >>> plan.path(np.array([0.0, 1.0])).t.round(6)
    array([[0.1, 0. , 0.4],
           [0.3, 0. , 0.6]])
    >>> plan.condition_numbers.mean < plan.initial_condition_numbers.mean
    True
    """
    instance(robot, Robot, "robot")
    option(objective, OBJECTIVES, "objective")
    limits = PoseLimits() if limits is None else limits
    instance(limits, PoseLimits, "limits")
    need_clearance(robot, limits.min_clearance)
    smoothness_weight = not_negative(smoothness_weight, "smoothness_weight")
    wrench = finite_array(load, (6,), "load")
    if not isinstance(via_poses, Sequence):
        raise ValueError(f"via_poses: expected a list of ViaPose, got {shown(via_poses)}")
    via_poses = tuple(via_poses)
    need_poses(via_poses)
    search = _Search.of(robot, via_poses, limits, objective, smoothness_weight)
    straight = search.path(search.nothing, wrench)
    at_first = conditions_along(robot, straight)
    x = search.best(progress)
    # A blend of two paths that keep the limits can exceed them. The last blend is the initial spline itself.
    for share in _SHARES if not search.broken(0.0 * x) else (1.0,):
        if search.broken(share * x):
            continue
        path = search.path(share * x, wrench)
        found = conditions_along(robot, path)
        if max(found.mean / at_first.mean, found.peak / at_first.peak) <= 1.0:
            break
    need_passed(path, search.costs.length)
    shifts = search.family.shifts(search.split(share * x)[0])
    passed = tuple(pose.shifted(shift) for pose, shift in zip(via_poses, shifts, strict=True))
    return PlannedPath(path, straight, via_poses, passed, found, at_first)


def need_poses(poses: Sequence[ViaPose]) -> None:
    """Raise ValueError for fewer than two via poses or for two equal successive via poses."""
    for number, pose in enumerate(poses, start=1):
        instance(pose, ViaPose, f"via pose {number}")
    if len(poses) < 2:
        raise ValueError(f"via poses: expected at least 2, got {len(poses)}")
    for number, (before, after) in enumerate(itertools.pairwise(poses), start=2):
        if np.allclose(before.R, after.R, rtol=0.0, atol=1e-9) and np.allclose(
            before.t, after.t, rtol=1e-12, atol=0.0
        ):
            raise ValueError(f"via pose {number}: expected another pose than via pose {number - 1}")


def need_passed(path: PosePath, length: float) -> None:
    """Raise ValueError if a path reverses at a via pose; ``length`` is the characteristic length."""
    rates = _rates(path(np.concatenate([path.via, np.linspace(0.0, 1.0, _FINE)])), length)
    for k in np.flatnonzero(rates[: len(path.via)] <= _RESTS * rates.max()).tolist():
        raise ValueError(
            f"via pose {k + 1}: the path turns back at the pose; plan the ways to and from the pose "
            "separately, or move the previous or the next via pose"
        )


def _rates(motion: Motion, length: float) -> Array:
    """Return the norm of the derivative by s, shape (n,), with translations divided by a length."""
    shift = np.sum((motion.v / length) ** 2, axis=-1)
    return np.asarray(np.sqrt(shift + np.sum(motion.omega**2, axis=-1)))


def conditions_along(robot: Robot, path: PosePath, count: int = _FINE) -> Conditions:
    """Compute condition numbers along a path at evenly spaced parameters."""
    motion = path(np.linspace(0.0, 1.0, count))
    found = singularity(robot, motion)
    values, signs = found.condition_number, np.sign(found.determinant)
    weight = _rates(motion, found.characteristic_length)
    weight[[0, -1]] *= 0.5
    crossed = bool((signs[1:] != signs[:-1]).any())
    mean = float(values @ weight / weight.sum())
    return Conditions(mean, math.inf if crossed else float(values.max()), float(weight.sum() / (count - 1)))


@dataclass(frozen=True, eq=False)
class _Search:
    """Optimization of one path.

    The variables are the shifts of via poses within their tolerances, and the coordinates w of ``Family``,
    which move the spline between the via poses.
    """

    family: Family
    costs: PoseCosts
    power: int
    price: float
    scale: Array
    first: tuple[float, float]

    @classmethod
    def of(
        cls, robot: Robot, poses: tuple[ViaPose, ...], limits: PoseLimits, objective: Objective, price: float
    ) -> _Search:
        """Prepare the optimization, and check the via poses."""
        at = PoseCosts(robot, limits, robot.tool, 1.0, 0.0)
        family = Family.of(poses, at.length)
        R, t = poses_of(family.rows)
        found = singularity(robot, (R, t - R @ robot.tool))
        signs, smallest = np.sign(found.determinant), found.smallest_singular_value
        fixed = np.array([not pose.has_tolerance for pose in poses])
        need_reachable(at, poses, found.condition_number, signs)
        chosen = signs[fixed] if fixed.any() else signs
        side = float(chosen[0])
        least = _NEAR * float(np.min(smallest[signs == side]))
        costs = PoseCosts(robot, limits, robot.tool, side, least)
        power = 1 if objective == "mean" else _PEAK_POWER
        search = cls(family, costs, power, price, scales(at.length), (1.0, 1.0))
        coefficients = family.coefficients(*search.split(search.nothing))
        k = costs.conditions(*poses_of(family.B @ coefficients))[0]
        rows = coefficients * search.scale
        first = (float(np.mean(k**power) ** (1.0 / power)), float(np.sum(rows * (family.metric @ rows))))
        return replace(search, first=first)

    @property
    def nothing(self) -> Array:
        """Variables of the initial spline: no shift and least bending."""
        return np.zeros(len(self.family.free) + 7 * self.family.rest.shape[1])

    def path(self, x: Array, load: Array) -> PosePath:
        """Create the path of given variables."""
        return self.family.path(self.family.coefficients(*self.split(x)), self.costs.tool, load)

    def split(self, x: Array) -> tuple[Array, Array]:
        """Split the variables into shifts, shape (f,), and w, shape (m, 7)."""
        free = len(self.family.free)
        return x[:free], x[free:].reshape(-1, 7) / self.scale

    def best(self, progress: Progress) -> Array:
        """Find the variables of the best path; raise ValueError with the limiting constraint on failure."""
        start = self.nothing
        random = np.random.default_rng(0)
        worst: list[tuple[float, str, float]] = []
        for turn in range(_STARTS):
            progress("planning the path", turn / _STARTS)
            x = self.minimum(start)
            broken = self.broken(x)
            if not broken:
                path = self.path(x, np.zeros(6))
                crossed = singularity_crossings(self.costs.robot, path, np.union1d(self.family.s, [0.0, 1.0]))
                if not crossed:
                    return x
                broken = [(math.inf, "a singular pose", crossed[0].time)]
            worst.append(max(broken))
            start = self.nothing
            start[len(self.family.free) :] += self.swing(random)
        _, what, place = min(worst)
        segment = int(np.clip(np.searchsorted(self.family.via, place), 1, len(self.family.poses) - 1))
        raise ValueError(
            f"via pose {segment + 1}: no path from via pose {segment} was found (obstacle: {what}); move a "
            "via pose, or relax the limit"
        )

    def swing(self, random: np.random.Generator) -> Array:
        """Return a smooth random detour: one random translation and rotation for all free coefficients."""
        move = _SWING * random.normal(size=7)
        move[3:] *= 0.5
        return (self.family.rest.T @ np.ones((len(self.family.rest), 1)) * move).ravel()

    def minimum(self, x: Array) -> Array:
        """Find a local minimum with increasing penalties for the limits."""
        from scipy.optimize import minimize

        free = len(self.family.free)
        box = [*self.family.box(), *[(None, None)] * (len(x) - free)]
        for penalty in _PENALTIES:
            options = {"maxiter": _STEPS}
            x = minimize(self.value, x, (penalty,), "L-BFGS-B", jac=True, bounds=box, options=options).x
        return np.asarray(x)

    def value(self, x: Array, penalty: float) -> tuple[float, Array]:
        """Compute the objective with its gradient."""
        family, costs = self.family, self.costs
        values, w = self.split(x)
        c = family.coefficients(values, w)
        rows = family.B @ c
        R, t = poses_of(rows)
        n, p = len(rows), self.power
        k, by_twist = costs.conditions(R, t)
        total = float(np.mean(k**p) ** (1.0 / p))
        by_pose = (total ** (1 - p) * k ** (p - 1) / n)[:, None] * by_twist / self.first[0]
        value = total / self.first[0]
        for _, excess, by in costs.excesses(R, t, (k, by_twist)):
            over = np.maximum(excess, 0.0)
            value += penalty * float(np.sum(over**2)) / n
            by_pose += 2.0 * penalty / n * np.einsum("nk,nkj->nj", over, by)
        by_c = family.B.T @ by_coordinates(rows, by_pose)
        scaled = c * self.scale
        priced = family.metric @ scaled
        value += self.price * float(np.sum(scaled * priced)) / self.first[1]
        by_c += 2.0 * self.price / self.first[1] * priced * self.scale
        by_free, by_w = family.gradients(values, by_c)
        return value, np.concatenate([by_free, (by_w / self.scale).ravel()])

    def broken(self, x: Array) -> list[tuple[float, str, float]]:
        """Return the limits that the path violates, also between samples: violation, name, and parameter."""
        family = self.family
        rows = family.fine @ family.coefficients(*self.split(x))
        return broken_limits(self.costs, *poses_of(rows), family.between)


def broken_limits(costs: PoseCosts, R: Array, t: Array, s: Array) -> list[tuple[float, str, float]]:
    """Return the limits that poses at parameters s violate: largest violation, name, and parameter."""
    found = []
    for name, excess, _ in costs.excesses(R, t):
        most = excess.max(axis=-1)
        if most.max() > ROOM:
            found.append((float(most.max()), name, float(s[np.argmax(most)])))
    signs = np.sign(singularity(costs.robot, (R, t - R @ costs.tool)).determinant)
    if (signs != costs.side).any():
        found.append((math.inf, "a singular pose", float(s[np.argmax(signs != costs.side)])))
    return found


def need_reachable(costs: PoseCosts, poses: Sequence[ViaPose], values: Array, signs: Array) -> None:
    """Raise ValueError for via poses that are singular, exceed a limit, or are separated by singularities.

    A via pose with a tolerance is rejected if all poses within the tolerance are out of reach.
    """
    reach = replace(costs, limits=replace(costs.limits, max_condition=math.inf))
    for number, pose in enumerate(poses, start=1):
        if not pose.has_tolerance and not values[number - 1] < 1e12:
            raise ValueError(f"via pose {number}: expected a regular pose, got a singular pose")
        nearest = _nearest(reach, pose)
        who = "the nearest pose within its tolerance" if pose.has_tolerance else "the pose"
        for name, excess, _ in reach.excesses(nearest.R[None], nearest.t[None]):
            if excess.max() > ROOM + (_TOUCHES if pose.has_tolerance else 0.0):
                leg = f" of leg {int(np.argmax(excess[0])) + 1}" if excess.shape[1] == 6 else ""
                out, far = "", ""
                if name == "leg length":
                    out, far = "out of reach, ", f", {np.linalg.norm(nearest.t):.4g} m from the base's origin"
                raise ValueError(f"via pose {number}: {out}{who} exceeds the limit of {name}{leg}{far}")
        if not pose.has_tolerance and values[number - 1] > costs.limits.max_condition:
            raise ValueError(
                f"via pose {number}: expected a condition number of at most {costs.limits.max_condition:g}, "
                f"got {values[number - 1]:.4g}"
            )
    fixed = [k for k, pose in enumerate(poses) if not pose.has_tolerance]
    for before, after in itertools.pairwise(fixed):
        if signs[before] != signs[after]:
            raise ValueError(
                f"via pose {after + 1}: every path from via pose {before + 1} crosses a singular pose, "
                "because det H has opposite signs at the two poses"
            )


def _nearest(costs: PoseCosts, pose: ViaPose) -> ViaPose:
    """Return the pose within the tolerance with the smallest violation, from several initial guesses."""
    if not pose.has_tolerance:
        return pose
    from scipy.optimize import minimize

    free = pose.tolerance_high > pose.tolerance_low
    low, high = pose.tolerance_low[free], pose.tolerance_high[free]

    def moved(x: Array) -> ViaPose:
        shift = np.zeros(len(free))
        shift[free] = np.clip(x, low, high)
        return pose.shifted(shift)

    def broken(x: Array) -> float:
        at = moved(x)
        parts = (excess for _, excess, _ in costs.excesses(at.R[None], at.t[None]))
        return sum(float(np.sum(np.maximum(excess - ROOM, 0.0) ** 2)) for excess in parts)

    random, least, best = np.random.default_rng(0), math.inf, np.zeros(len(low))
    for start in (best, *random.uniform(low, high, (_TRIES, len(low)))):
        found = minimize(broken, start, method="L-BFGS-B", bounds=list(zip(low, high, strict=True)))
        if found.fun < least:
            least, best = float(found.fun), found.x
        if least <= _TOUCHES**2:
            break
    return moved(best)
