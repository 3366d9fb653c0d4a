"""Base parameters: which combinations of a machine's inertial parameters its forces depend on.

On every machine the mass of a lower part has no effect, the two inertias of a leg act as their sum, and the
mass of an upper part acts as a point fixed to the platform at p: 100 of the 148 columns of Y are
independent (``MERGED`` holds the formulas). All six components of a leg's inertia count, since the
universal joint spins the leg. On a special machine fewer parameters are identifiable, such as no h_d_y
where the axes point along gravity, and along a given motion fewer still; the rank of Y over a stack of
poses decides. Legs that are built alike share their parameters: 25 are left then.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ..dynamics.home_pose import home_pose, radius, upright
from ..dynamics.inverse_dynamics import need_universal
from ..generated import exact_regressor
from ..io.arguments import instance, truth
from ..io.array_types import Array, Flags
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import inverse_kinematics, joint_sines
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_rpy
from ..robot.robot import LEGS, Robot
from .parameters import is_friction, leg_name, parameter_names, regressor

MERGED: Mapping[str, str] = MappingProxyType(dict(exact_regressor.MERGED))
"""Base parameters of every machine that take up others, with formulas; sum runs over the legs."""

# Below this share of the largest, a singular value or a column is rounding error: far above what rounding
# leaves (1e-15), far below what the slowest of the paper's paths excites (1e-7).
_ROUNDING = 1e-11
# A coefficient below this share of its terms is rounding error.
_NOTHING = 1e-9
# A parameter is preferred to be given up if its share in a change of parameters without effect exceeds this.
_CLEAR = 1e-2
# Share of its size by which a machine's geometry may differ from another's and count as the same.
_SAME = 1e-6
_POSES = 100
_MOST_DRAWS = 20
# Sine of the least angle between a leg and its universal axis, and the least length beside the base's radius.
_REGULAR = 0.1


@dataclass(frozen=True, eq=False)
class BaseParametersResult:
    """The combinations of pi that a machine's wrench depends on: Y pi = Y lift (matrix pi).

    Attributes
    ----------
    rank : int
        How many there are.
    independent_columns : ndarray of int
        Columns of Y that stay, int, (rank,): Y lift = Y[..., kept]. Where legs share their parameters, those
        of leg 1, to which the others' are added.
    matrix : ndarray
        From pi to the base parameters, (rank, 148); 1 at the kept ones. Where legs share their parameters,
        these are the means of the legs'.
    expansion : ndarray
        From base parameters to one of the pi that have them, (148, rank).
    names : tuple
        Of the kept parameters.
    formulas : tuple
        Each base parameter as text, coefficients to six digits.
    units : tuple
        Of each.
    singular_values : ndarray
        Of the stack with columns of length 1, falling, (148,), or (33,) where legs share their parameters.
    rank_gap : float
        Ratio of the last that counts to the first that is rounding error; below about 1e3 the rank is not to
        be trusted.
    identical_legs : bool
        Whether all legs share their parameters, whose names have no number then.
    robot : Robot
        The machine, of which geometry and gravity count.
    """

    rank: int
    independent_columns: NDArray[np.intp]
    matrix: Array
    names: tuple[str, ...]
    formulas: tuple[str, ...]
    units: tuple[str, ...]
    singular_values: Array
    rank_gap: float
    expansion: Array
    identical_legs: bool
    robot: Robot

    def required_columns(self) -> NDArray[np.intp]:
        """Which columns of Y count.

        Returns
        -------
        ndarray of int
            Their indices, (n,): ``independent_columns``, or where legs share their parameters also those of
            the other legs.
        """
        return (
            self.independent_columns
            if not self.identical_legs
            else np.flatnonzero(self.expansion.any(axis=1))
        )

    def reduce(self, Y: Array) -> Array:
        """Y of the base parameters, from the columns of Y that count.

        Parameters
        ----------
        Y : ndarray
            Those columns of Y that ``required_columns`` names, (..., 6, n).

        Returns
        -------
        ndarray
            Columns of the base parameters, (..., 6, rank).
        """
        return Y if not self.identical_legs else np.asarray(Y @ self.expansion[self.required_columns()])


def base_parameters(
    robot: Robot, motion: Motion | None = None, friction: bool = True, identical_legs: bool = False
) -> BaseParametersResult:
    """Find the base parameters by the singular values of Y, stacked over many poses.

    Parameters that merge on every machine are given up first (m_d, J_d, m_u of each leg), so that the names
    left stand for the formulas of ``MERGED``.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion, optional
        With accelerations; all its instants are taken: what this motion excites. None: random poses about the
        home pose with random rates and accelerations, fixed seed: what any motion can excite.
    friction : bool, optional
        False for a model whose joints have none.
    identical_legs : bool, optional
        For legs that are built alike, with the same parameters in the leg frame: these are sought once, not
        leg by leg.

    Returns
    -------
    BaseParametersResult
        Combinations of the parameters that the forces depend on.

    Raises
    ------
    ValueError
        For spherical base joints, for poses without a regressor, and for a machine about whose home pose no
        regular pose is found.
    """
    need_universal(robot)
    truth(friction, "friction")
    if motion is not None:
        instance(motion, Motion, "motion")
        if 0 in motion.shape:
            raise ValueError("motion: expected poses, got none")
    truth(identical_legs, "identical_legs")
    stack = _stacked(robot, _random_motion(robot) if motion is None else motion)
    names, units = parameter_names()
    spread, dependent = np.eye(len(names)), _of_all_legs(exact_regressor.DEPENDENT)
    if identical_legs:
        spread, names, units = _shared_by_legs()
        stack, dependent = stack @ spread, set(exact_regressor.DEPENDENT)
    if not friction:
        stack[:, is_friction(names)] = 0.0
    lengths = _lengths(stack, units)
    values, directions = _singular(stack / np.where(lengths > 0.0, lengths, np.inf))
    rank = int(np.count_nonzero(values > _ROUNDING * values[0])) if values[0] > 0.0 else 0
    unfelt = directions[rank:].T
    lost = _given_up(unfelt, np.flatnonzero([name in dependent for name in names]))
    kept = np.setdiff1d(np.arange(len(names)), lost)
    shares = np.linalg.solve(unfelt[lost].T, -unfelt[kept].T).T
    shares = np.where(np.abs(shares) > _NOTHING, shares, 0.0)
    matrix = np.zeros((rank, len(names)))
    matrix[np.arange(rank), kept] = 1.0
    matrix[:, lost] = shares * lengths[lost] / lengths[kept, None]
    return BaseParametersResult(
        rank=rank,
        independent_columns=np.argmax(spread[:, kept], axis=0),
        matrix=matrix if not identical_legs else matrix @ (spread / spread.sum(axis=0)).T,
        names=tuple(names[i] for i in kept),
        formulas=tuple(_formula(i, row, names) for i, row in zip(kept.tolist(), matrix, strict=True)),
        units=tuple(units[i] for i in kept),
        singular_values=values,
        rank_gap=float(values[rank - 1] / values[rank])
        if 0 < rank < len(values) and values[rank]
        else math.inf,
        expansion=spread[:, kept],
        identical_legs=identical_legs,
        robot=robot,
    )


def need_base(base: BaseParametersResult, robot: Robot) -> None:
    """Reject base parameters of a machine of other geometry or gravity."""
    instance(base, BaseParametersResult, "base_parameters")
    for name in ("b", "p", "k", "g"):
        own, other = (np.asarray(getattr(each, name)) for each in (robot, base.robot))
        if name == "k":
            # An axis either way round.
            other = other * np.where(np.sum(own * other, axis=-1) < 0.0, -1.0, 1.0)[:, None]
        if np.abs(own - other).max() > _SAME * np.abs(own).max():
            raise ValueError(f"base: found for a machine of another {name}, expected base_parameters(robot)")


def alike(pi: Array) -> Array:
    """Parameters in which every leg has the mean of all legs', (148,)."""
    spread, _, _ = _shared_by_legs()
    return np.asarray(spread @ (spread.T @ pi / spread.sum(axis=0)))


def _of_all_legs(names: Iterable[str]) -> set[str]:
    return {leg_name(name, leg) for name in names for leg in range(1, LEGS + 1)}


def _shared_by_legs() -> tuple[Array, tuple[str, ...], tuple[str, ...]]:
    """From parameters that all legs share, and the platform's, to pi, (148, 33); their names and units."""
    of_leg, of_platform = exact_regressor.LEG_PARAMETERS, exact_regressor.PLATFORM_PARAMETERS
    rows = (*of_leg, *of_platform)
    each = np.eye(len(rows))
    spread = np.concatenate([np.tile(each[: len(of_leg)], (LEGS, 1)), each[len(of_leg) :]])
    return spread, tuple(name for name, _ in rows), tuple(unit for _, unit in rows)


def _stacked(robot: Robot, motion: Motion) -> Array:
    """Y of all instants below each other, moments over the machine's length."""
    length = characteristic_length(robot) or 1.0
    scale = np.array([1.0, 1.0, 1.0, length, length, length])
    Y = regressor(robot, motion) / scale[:, None]
    return np.asarray(Y.reshape(-1, Y.shape[-1]))


def _lengths(stack: Array, units: Sequence[str]) -> Array:
    """Length of each column, 0 where it is rounding error beside the longest of its unit."""
    lengths = np.linalg.norm(stack, axis=0)
    kinds = np.array(units)
    longest = np.array([np.max(lengths[kinds == unit]) for unit in units])
    return np.where(lengths > _ROUNDING * longest, lengths, 0.0)


def _singular(stack: Array) -> tuple[Array, Array]:
    """All singular values by columns, zeros where rows lack, and right singular vectors as rows."""
    short = stack.shape[1] - stack.shape[0]
    padded = np.pad(stack, ((0, max(short, 0)), (0, 0)))
    # R of QR has the singular values and vectors of the stack, however many poses there are.
    _, values, directions = np.linalg.svd(np.linalg.qr(padded, mode="r"))
    return values, directions


def _given_up(unfelt: Array, preferred: NDArray[np.intp]) -> NDArray[np.intp]:
    """Parameters to give up: one for each direction that no force depends on, (148, n).

    Each is the one with the largest share in what remains of the directions, among the preferred ones as long
    as one of them has a clear share.
    """
    left = unfelt.copy()
    chosen: list[int] = []
    for _ in range(unfelt.shape[1]):
        size = np.linalg.norm(left, axis=1)
        best = int(preferred[np.argmax(size[preferred])])
        pick = best if size[best] > _CLEAR else int(np.argmax(size))
        row = left[pick] / size[pick]
        left = left - np.outer(left @ row, row)
        chosen.append(pick)
    return np.sort(np.array(chosen, dtype=np.intp))


def _formula(own: int, row: Array, names: Sequence[str]) -> str:
    text = names[own]
    for i in np.flatnonzero(row).tolist():
        if i != own:
            size = f"{abs(row[i]):.6g}"
            factor = "" if size == "1" else f"{size}*"
            text += f" {'-' if row[i] < 0.0 else '+'} {factor}{names[i]}"
    return text


def _random_motion(robot: Robot) -> Motion:
    """Regular poses about the home pose with rates in proportion to gravity and size."""
    rng = np.random.default_rng(0)
    size, home = radius(robot.b), home_pose(robot).t
    rate = math.sqrt(float(np.linalg.norm(robot.g)) / size) or 1.0
    for _ in range(_MOST_DRAWS):
        theta, t, omega, v, alpha, a = rng.normal(size=(6, 2 * _POSES, 3)) @ upright(robot).T
        motion = Motion(
            R=rotation_from_rpy(0.2 * theta),
            t=home + 0.15 * size * t,
            omega=0.5 * rate * omega,
            v=0.5 * rate * size * v,
            alpha=0.5 * rate**2 * alpha,
            a=0.5 * rate**2 * size * a,
        )
        regular = motion[_regular(robot, motion, size)]
        if regular.shape[0] >= _POSES:
            return regular[:_POSES]
    raise ValueError("robot: found too few regular poses about its home pose, give a motion")


def _regular(robot: Robot, motion: Motion, size: float) -> Flags:
    legs = inverse_kinematics(robot, motion)
    return np.asarray(np.all((joint_sines(robot, legs.s) > _REGULAR) & (legs.L > _REGULAR * size), axis=-1))
