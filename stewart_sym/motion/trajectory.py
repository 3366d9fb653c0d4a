"""Trajectories: poses or leg lengths over time, with their uncertainty and the line of each sample."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array
from ..io.toml_reader import number
from . import rotation
from .motion import Motion
from .trajectory_format import ANGLE_UNITS, LENGTH_UNITS

Index = slice | NDArray[np.int64] | NDArray[np.bool_]


@dataclass(frozen=True)
class SmoothingOptions:
    """Known properties of the noise of a log.

    Attributes
    ----------
    position_std, angle_std : float, optional
        Standard deviation of each coordinate (m and rad); leg lengths are positions. By default estimated.
    cutoff_frequency : float, optional
        Frequency (Hz) at which the amplitude is halved; by default the likeliest.
    enabled : bool, optional
        False interpolates all rows.

    Raises
    ------
    ValueError
        If an attribute is invalid; the message begins with its name.
    """

    position_std: float | None = None
    angle_std: float | None = None
    cutoff_frequency: float | None = None
    enabled: bool = True

    def __post_init__(self) -> None:
        for name in ("position_std", "angle_std", "cutoff_frequency"):
            if getattr(self, name) is not None and number(getattr(self, name), name) <= 0.0:
                raise ValueError(f"{name}: expected a number > 0, got {getattr(self, name):g}")


class Replaced(NamedTuple):
    """Span of time (s) in which rows are not used, and a text that names these rows."""

    start: float
    end: float
    rows: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Standard deviations of the six coordinates of a trajectory.

    Attributes
    ----------
    grid : ndarray, shape (g,)
        Times (s) of the covariances.
    covariance : ndarray, shape (g, 6, 6)
        Covariance of value, rate, and second rate of each coordinate: the lower triangle row by row.
    sigma : ndarray, shape (6,)
        Standard deviation of the samples.
    replaced : tuple of Replaced
        Spans in which rows are not used.
    """

    grid: Array
    covariance: Array
    sigma: Array
    replaced: tuple[Replaced, ...] = ()

    def covariances(self, time: Array) -> Array:
        """Return the covariances at n times, shape (n, 6, 6)."""
        i = np.clip(np.searchsorted(self.grid, time, side="right") - 1, 0, len(self.grid) - 2)
        share = np.clip((time - self.grid[i]) / (self.grid[i + 1] - self.grid[i]), 0.0, 1.0)[:, None, None]
        return np.asarray(self.covariance[i] + share * (self.covariance[i + 1] - self.covariance[i]))


LEAST_NOISE = 1e-15
"""Noise (m, rad) below which a column is exact in messages."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Poses or leg lengths at n times.

    A trajectory contains a motion of the reference point, or coordinates in a third of the memory, from which
    motions are computed on demand. Poses that are computed from leg lengths have both.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Increasing times (s).
    given_motion : Motion or None
        Motion of the reference point, shape (n,); None if the coordinates determine it.
    source : str
        Name of the file, or another name for messages.
    rows : sequence of int, length n
        Line of each sample in the file.
    noise : Uncertainty or None
        Uncertainty of the coordinates; None if they are exact.
    coordinates : ndarray, shape (3, n, 6), or None
        Values, rates, and second rates of ``t`` and ``theta`` (m, rad), or of leg lengths (m).
    F_ext, M_ext : ndarray, shape (n, 3), or None
        External load (N, N m), platform frame, at the tool.
    has_lengths : bool
        True if the coordinates are leg lengths.
    tool : ndarray, shape (3,)
        Point (m, platform frame) of the poses and of the load.
    order : str
        Order of the rotations about ``theta``, "zyx" for (38).

    Examples
    --------
    >>> import stewart_sym as ss
    >>> path, step = ss.PAPER_PATHS["I"]
    >>> time = path.time_grid(10 * step)
    >>> planned = ss.Trajectory(time, path.sample(time))
    >>> planned.motion.t.shape == (len(time), 3)
    True
    """

    time: Array
    given_motion: Motion | None = None
    source: str = "trajectory"
    rows: Sequence[int] = ()
    noise: Uncertainty | None = None
    coordinates: Array | None = None
    F_ext: Array | None = None
    M_ext: Array | None = None
    has_lengths: bool = False
    tool: Array | None = None
    order: str = "zyx"

    @property
    def motion(self) -> Motion:
        """Motion of the reference point at all samples, shape (n,)."""
        return self.at(slice(None))

    def at(self, index: Index) -> Motion:
        """Return the motion of the reference point at some samples.

        Parameters
        ----------
        index : slice or ndarray
            Samples, as an index of an array.

        Returns
        -------
        Motion
            Motion at these samples.

        Raises
        ------
        ValueError
            If the trajectory contains leg lengths, whose poses ``motion_from_lengths`` computes.
        """
        if self.given_motion is not None:
            return self.given_motion[index]
        if self.has_lengths or self.coordinates is None:
            raise ValueError(
                f"{self.source}: leg lengths have no poses yet; use read_trajectory with the robot"
            )
        q, q_dot, q_ddot = self.coordinates[:, index]
        loads = (None if load is None else load[index] for load in (self.F_ext, self.M_ext))
        R, omega, alpha = rotation.motion_about_axes(q[..., 3:], q_dot[..., 3:], q_ddot[..., 3:], self.order)
        motion = Motion._unchecked(R, q[..., :3], omega, q_dot[..., :3], alpha, q_ddot[..., :3], *loads)
        return motion if self.tool is None else motion.at_point(-self.tool)

    @property
    def in_joints(self) -> bool:
        """True for leg lengths without poses."""
        return self.has_lengths and self.given_motion is None

    @property
    def lengths(self) -> Array:
        """Leg lengths, rates, and second rates (m), shape (3, n, 6)."""
        assert self.has_lengths
        assert self.coordinates is not None
        return self.coordinates


def noise_text(
    sigma: Array, has_lengths: bool, length_unit: str | None = None, angle_unit: str | None = None
) -> str:
    """Format the noise of a log, such as ``noise of 0.0002 m and 0.0001 rad``, by default in SI units."""
    length, angle = length_unit or "m", angle_unit or "rad"
    parts = [(slice(6), length)] if has_lengths else [(slice(3), length), (slice(3, 6), angle)]
    largest = [(float(sigma[part].max()), unit) for part, unit in parts]
    sizes = LENGTH_UNITS | ANGLE_UNITS
    texts = [f"{noise / sizes[unit]:.2g} {unit}" for noise, unit in largest if noise > LEAST_NOISE]
    return f"noise of {' and '.join(texts)} in the log"
