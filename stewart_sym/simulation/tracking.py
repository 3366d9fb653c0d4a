"""Tracking error: difference between a simulated motion and the reference motion of its force law."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..io.arguments import instance
from ..io.array_types import Array
from ..motion.motion import Motion
from ..motion.rotation import vector_from_rotation
from .state_history import StateHistory


@dataclass(frozen=True, eq=False)
class TrackingError:
    """Differences from the reference to the simulated poses over time, base frame.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Time (s).
    reference : Motion, shape (n,)
        Reference motion.
    position : ndarray, shape (n, 3)
        Difference of the positions of the reference point (m).
    rotation : ndarray, shape (n, 3)
        Rotation vector (rad) that turns the reference orientation to the simulated orientation.
    """

    time: Array
    reference: Motion
    position: Array
    rotation: Array

    @property
    def rms(self) -> Array:
        """Root mean square over time along x, y, z (m) and about x, y, z (rad), shape (6,)."""
        from scipy.integrate import trapezoid

        error, duration = np.hstack([self.position, self.rotation]), self.time[-1] - self.time[0]
        if duration <= 0.0:
            return np.asarray(np.abs(error[0]))
        return np.asarray(np.sqrt(trapezoid(error**2, self.time, axis=0) / duration))

    @property
    def peak(self) -> Array:
        """Largest magnitude along x, y, z (m) and about x, y, z (rad), shape (6,)."""
        return np.asarray(np.abs(np.hstack([self.position, self.rotation])).max(axis=0))

    @property
    def peak_time(self) -> Array:
        """Time (s) of each peak, shape (6,)."""
        return np.asarray(self.time[np.abs(np.hstack([self.position, self.rotation])).argmax(axis=0)])


def tracking_error(history: StateHistory, reference: Callable[[Array], Motion]) -> TrackingError:
    """Compare the states of a simulation with a reference motion.

    Parameters
    ----------
    history : StateHistory
        Result of ``simulate``, or states at other times such as its ``dense_history``.
    reference : callable
        Function of times (s), shape (n,), that returns the reference motion of shape (n,), for example
        the result of ``interpolate`` or the method ``sample`` of a path.

    Returns
    -------
    TrackingError
        Errors over time, with RMS and peak of each axis.

    Raises
    ------
    ValueError
        If ``history`` is not a history, or if the reference does not return one pose for each time.

    See Also
    --------
    simulate : Simulate a robot under a force law.
    ComputedTorque : Tracking control by inverse dynamics.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> path = ss.PAPER_PATHS["I"].path
    >>> law = ss.ComputedTorque(robot, path.sample, k_p=400.0, k_d=40.0)
    >>> run = ss.simulate(robot, "path", law, duration=0.2, control_rate=500.0)
    >>> error = ss.tracking_error(run, path.sample)
    >>> bool(error.peak[:3].max() < 1e-4)
    True
    """
    instance(history, StateHistory, "history")
    if not callable(reference):
        raise ValueError(f"reference: expected a function of times, got {type(reference).__name__}")
    planned = reference(history.time)
    instance(planned, Motion, "reference")
    if planned.shape != history.time.shape:
        raise ValueError(
            f"reference: expected a motion of shape {history.time.shape} at these times, got {planned.shape}"
        )
    turn = vector_from_rotation(history.R @ np.swapaxes(planned.R, -1, -2))
    return TrackingError(history.time, planned, history.t - planned.t, turn)
