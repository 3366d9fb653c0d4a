"""Poses that a path passes, fixed or free within a box."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ..io.arguments import finite_array
from ..io.array_types import Array
from ..io.frozen import Frozen
from ..motion.motion import pose_of
from ..motion.rotation import quaternion_from_rotation, quaternion_product, rotation_from_vector

COORDINATES = ("x", "y", "z", "roll", "pitch", "yaw")
"""What may be free: shifts along base axes, m, and turns about the tool's own axes, rad."""


@dataclass(frozen=True, eq=False)
class ViaPose(Frozen):
    """A pose of the tool that a path passes.

    Attributes
    ----------
    R : array_like
        Orientation, platform to base, (3, 3).
    t : array_like
        Position of the tool, m, base frame, (3,).
    low, high : array_like, optional
        By how much the pose may differ, (6,): shifts along base axes, m, and a rotation vector in the
        platform's axes, rad: R becomes R exp([phi]x). Low is at most 0 and high at least 0.

    Raises
    ------
    ValueError
        Naming the argument.
    """

    R: Array
    t: Array
    low: Array = field(default_factory=lambda: np.zeros(6))
    high: Array = field(default_factory=lambda: np.zeros(6))

    def __post_init__(self) -> None:
        """Check pose and box."""
        for name, core in (("R", (3, 3)), ("t", (3,))):
            finite_array(getattr(self, name), core, name, batch=False)
        motion = pose_of((self.R, self.t), "pose", "a pose (R, t)")
        low, high = (finite_array(getattr(self, name), (6,), name, batch=False) for name in ("low", "high"))
        if (low > 0.0).any() or (high < 0.0).any():
            raise ValueError("low, high: expected six numbers <= 0 and six >= 0")
        self._set({"R": np.array(motion.R), "t": np.array(motion.t), "low": low, "high": high})

    @property
    def free(self) -> bool:
        """Whether the pose may differ at all."""
        return bool((self.high > self.low).any())

    def moved(self, shift: Array) -> ViaPose:
        """The pose that differs by a shift, with no freedom left.

        Parameters
        ----------
        shift : ndarray
            By how much it differs, in the coordinates of ``low`` and ``high``, m and rad, (6,).

        Returns
        -------
        ViaPose
            Its ``low`` and ``high`` are 0.
        """
        return ViaPose(self.R @ rotation_from_vector(shift[3:]), self.t + shift[:3])


def coordinates(poses: Sequence[ViaPose]) -> Array:
    """Positions and unit quaternions, (k, 7), each quaternion on the same side as the one before."""
    rows = [np.concatenate([pose.t, quaternion_from_rotation(pose.R)]) for pose in poses]
    for before, after in itertools.pairwise(rows):
        if before[3:] @ after[3:] < 0.0:
            after[3:] *= -1.0
    return np.array(rows)


def shifted(row: Array, shift: Array) -> Array:
    """Coordinates (7,) of a pose that differs by (6,)."""
    half = 0.5 * np.linalg.norm(shift[3:])
    turn = np.concatenate([[np.cos(half)], 0.5 * np.sinc(half / np.pi) * shift[3:]])
    return np.concatenate([row[:3] + shift[:3], quaternion_product(row[3:], turn)])
