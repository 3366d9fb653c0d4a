"""Base parameters: the identifiable combinations of the inertial parameters of a robot.

For every robot the mass of a lower leg part has no effect, and the two inertias of a leg act as their sum.
The mass of an upper part acts as a point mass on the platform at p. Therefore 100 of the 148 columns of Y are
independent (``MERGED`` contains the formulas). All six components of the inertia of a leg matter, because the
universal joint rotates the leg about its axis.

The rank is lower for special robots (for example without h_d_y if the axes are parallel to gravity) and for a
given motion. It is the numerical rank of Y stacked over many poses. Identical legs share their parameters;
25 base parameters remain then.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import qr

from ..dynamics.home_pose import home_pose
from ..dynamics.inverse_dynamics import need_universal
from ..generated import exact_regressor
from ..io.arguments import instance, truth
from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length
from ..kinematics.inverse_kinematics import inverse_kinematics, joint_sines
from ..kinematics.mounting_side import radius, upright
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_rpy
from ..robot.robot import LEGS, Robot
from .parameters import is_friction, leg_name, parameter_names, regressor

MERGED: Mapping[str, str] = MappingProxyType(dict(exact_regressor.MERGED))
"""Base parameters of every robot that include other parameters, with formulas; sums run over the legs."""

# Relative size below which a singular value or a column is rounding error. It is far above the rounding
# errors (1e-15) and far below the excitation of the slowest path of the paper (1e-7).
_ROUNDING = 1e-11
# Relative size below which a coefficient is rounding error.
_NOTHING = 1e-9
# Relative size in the null space from which a dependent parameter is eliminated first.
_CLEAR = 1e-2
# Relative difference up to which two geometries count as equal.
_SAME = 1e-6
_POSES = 100
_MOST_DRAWS = 20
# Smallest joint sine of a regular pose, and its smallest leg length relative to the radius of the base.
_REGULAR = 0.1


@dataclass(frozen=True, eq=False)
class BaseParametersResult:
    """Combinations B pi that determine the wrench of a robot: Y pi = Y E (B pi).

    Attributes
    ----------
    rank : int
        Number of base parameters.
    independent_columns : ndarray of int, shape (rank,)
        Indices of independent columns of Y: Y E = Y[..., independent_columns]. With identical legs these are
        columns of leg 1, to which the columns of the other legs are added.
    matrix : ndarray, shape (rank, 148)
        Matrix B from pi to the base parameters, with ones at the independent columns. With identical legs the
        base parameters are means over the legs.
    expansion : ndarray, shape (148, rank)
        Matrix E from base parameters to one pi that has them.
    names : tuple of str
        Names of the independent parameters.
    formulas : tuple of str
        Formula of each base parameter, with six digits.
    units : tuple of str
        Unit of each base parameter.
    singular_values : ndarray, shape (148,) or (33,)
        Singular values of the stacked Y with columns of length 1, in descending order; 33 with identical
        legs.
    rank_gap : float
        Ratio of the last significant singular value to the next one. Below about 1000 the rank is uncertain.
    identical_legs : bool
        True if all legs share their parameters; their names have no number then.
    robot : Robot
        Robot whose geometry and gravity were used.
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
        """Return the indices of the required columns of Y.

        Returns
        -------
        ndarray of int, shape (n,)
            ``independent_columns``; with identical legs also the corresponding columns of the other legs.
        """
        return (
            self.independent_columns
            if not self.identical_legs
            else np.flatnonzero(self.expansion.any(axis=1))
        )

    def reduce(self, Y: Array) -> Array:
        """Combine the required columns of Y into the columns of the base parameters.

        Parameters
        ----------
        Y : ndarray, shape (..., 6, n)
            Columns ``required_columns()`` of Y.

        Returns
        -------
        ndarray, shape (..., 6, rank)
            Columns of the base parameters.
        """
        return Y if not self.identical_legs else np.asarray(Y @ self.expansion[self.required_columns()])


def base_parameters(
    robot: Robot, motion: Motion | None = None, friction: bool = True, identical_legs: bool = False
) -> BaseParametersResult:
    """Compute the base parameters from the singular values of Y, stacked over many poses.

    Parameters
    ----------
    robot : Robot
        Robot model; only its geometry and gravity are used.
    motion : Motion, optional
        Motion with accelerations; the result contains the parameters that it excites. By default the poses
        are random poses near the home pose with random rates and accelerations (fixed seed); the result
        contains the parameters that any motion can excite.
    friction : bool, optional
        False for joints without friction.
    identical_legs : bool, optional
        True for legs with the same parameters in the leg frames; one set of leg parameters is then returned.

    Returns
    -------
    BaseParametersResult
        Rank, formulas, and matrices of the base parameters.

    Raises
    ------
    ValueError
        If the base joints are spherical, if a pose has no regressor, or if too few regular poses are near the
        home pose.

    See Also
    --------
    identify : Estimation of the base parameters from measured forces.
    regressor : Matrix Y of the equations of motion.

    Notes
    -----
    The parameters that are dependent for every robot (m_d, J_d, and m_u of each leg) are eliminated first, so
    that the remaining names agree with the formulas of ``MERGED``.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> base = ss.base_parameters(robot, identical_legs=True)
    >>> base.rank
    25
    >>> base.formulas[-10]
    'M + 6*m_u'
    """
    need_universal(robot)
    truth(friction, "friction")
    if motion is not None:
        instance(motion, Motion, "motion")
        if 0 in motion.shape:
            raise ValueError("motion: expected poses, got none")
    truth(identical_legs, "identical_legs")
    stack = _stacked(robot, _random_motion(robot) if motion is None else motion)
    (names, units), spread = parameter_names(), np.eye(stack.shape[1])
    dependent = {leg_name(name, leg) for name in exact_regressor.DEPENDENT for leg in range(1, LEGS + 1)}
    if identical_legs:
        spread, names, units = _shared_by_legs()
        stack, dependent = stack @ spread, set(exact_regressor.DEPENDENT)
    if not friction:
        stack[:, is_friction(names)] = 0.0
    lengths = _lengths(stack, units)
    values, directions = _singular(stack / np.where(lengths > 0.0, lengths, np.inf))
    rank = int(np.count_nonzero(values > _ROUNDING * values[0])) if values[0] > 0.0 else 0
    null_space = directions[rank:].T
    # The columns that a pivoted QR decomposition chooses first are eliminated, preferably dependent ones.
    preference = np.where([name in dependent for name in names], 1.0 / _CLEAR, 1.0)
    order = qr((preference[:, None] * null_space).T, mode="r", pivoting=True)[1]
    lost, kept = np.sort(order[: len(names) - rank]), np.sort(order[len(names) - rank :])
    shares = np.linalg.solve(null_space[lost].T, -null_space[kept].T).T
    shares = np.where(np.abs(shares) > _NOTHING, shares, 0.0)
    matrix = np.zeros((rank, len(names)))
    matrix[np.arange(rank), kept] = 1.0
    matrix[:, lost] = shares * lengths[lost] / lengths[kept, None]
    gap = float(values[rank - 1] / values[rank]) if 0 < rank < len(values) and values[rank] else math.inf
    return BaseParametersResult(
        rank=rank,
        independent_columns=np.argmax(spread[:, kept], axis=0),
        matrix=matrix if not identical_legs else matrix @ (spread / spread.sum(axis=0)).T,
        names=tuple(names[i] for i in kept),
        formulas=tuple(_formula(i, row, names) for i, row in zip(kept.tolist(), matrix, strict=True)),
        units=tuple(units[i] for i in kept),
        singular_values=values,
        rank_gap=gap,
        expansion=spread[:, kept],
        identical_legs=identical_legs,
        robot=robot,
    )


def need_base(base: BaseParametersResult, robot: Robot) -> None:
    """Raise ValueError if base parameters belong to another geometry or gravity."""
    instance(base, BaseParametersResult, "base_parameters")
    for name in ("b", "p", "k", "g"):
        own, other = (np.asarray(getattr(each, name)) for each in (robot, base.robot))
        if name == "k":
            # The sign of an axis is arbitrary.
            other = other * np.where(np.sum(own * other, axis=-1) < 0.0, -1.0, 1.0)[:, None]
        if np.abs(own - other).max() > _SAME * np.abs(own).max():
            raise ValueError(
                f"base_parameters: expected the {name} of the robot, got another; use base_parameters(robot)"
            )


def alike(pi: Array) -> Array:
    """Replace the parameters of each leg, in pi of shape (148,), by their means over the legs."""
    spread, _, _ = _shared_by_legs()
    return np.asarray(spread @ (spread.T @ pi / spread.sum(axis=0)))


def _shared_by_legs() -> tuple[Array, tuple[str, ...], tuple[str, ...]]:
    """Return the matrix, shape (148, 33), from shared parameters to pi, with their names and units."""
    of_leg, of_platform = exact_regressor.LEG_PARAMETERS, exact_regressor.PLATFORM_PARAMETERS
    rows = (*of_leg, *of_platform)
    each = np.eye(len(rows))
    spread = np.concatenate([np.tile(each[: len(of_leg)], (LEGS, 1)), each[len(of_leg) :]])
    return spread, tuple(name for name, _ in rows), tuple(unit for _, unit in rows)


def _stacked(robot: Robot, motion: Motion) -> Array:
    """Return Y of all samples, stacked, with moments divided by the characteristic length."""
    length = characteristic_length(robot) or 1.0
    scale = np.array([1.0, 1.0, 1.0, length, length, length])
    Y = regressor(robot, motion) / scale[:, None]
    return np.asarray(Y.reshape(-1, Y.shape[-1]))


def _lengths(stack: Array, units: Sequence[str]) -> Array:
    """Return the length of each column; 0 if it is rounding error compared with columns of its unit."""
    lengths = np.linalg.norm(stack, axis=0)
    kinds = np.array(units)
    longest = np.array([np.max(lengths[kinds == unit]) for unit in units])
    return np.where(lengths > _ROUNDING * longest, lengths, 0.0)


def _singular(stack: Array) -> tuple[Array, Array]:
    """Return the singular values, with zeros for missing rows, and the right singular vectors as rows."""
    missing = max(stack.shape[1] - stack.shape[0], 0)
    # R of the QR decomposition has the same singular values and is small for any number of poses.
    R = np.linalg.qr(np.pad(stack, ((0, missing), (0, 0))), mode="r")
    return np.linalg.svd(R)[1:]


def _formula(own: int, row: Array, names: Sequence[str]) -> str:
    """Return the formula of a base parameter."""
    text = names[own]
    for i in np.flatnonzero(row).tolist():
        if i != own:
            size = f"{abs(row[i]):.6g}"
            factor = "" if size == "1" else f"{size}*"
            text += f" {'-' if row[i] < 0.0 else '+'} {factor}{names[i]}"
    return text


def _random_motion(robot: Robot) -> Motion:
    """Return regular poses near the home pose, with rates scaled by gravity and size."""
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
        legs = inverse_kinematics(robot, motion)
        regular = (joint_sines(robot, legs.s) > _REGULAR) & (legs.L > _REGULAR * size)
        motion = motion[np.all(regular, axis=-1)]
        if motion.shape[0] >= _POSES:
            return motion[:_POSES]
    raise ValueError("robot: too few regular poses near the home pose; pass a motion")
