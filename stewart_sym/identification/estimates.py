"""What identification hands back: base parameters with their covariance and a verdict on the fit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot
from .base_parameters import BaseParameters
from .drive_terms import DriveEstimate, seen_by_motors
from .parameters import Parameters, inertial_parameters
from .tails import departure


@dataclass(frozen=True, eq=False)
class Estimate:
    """Base parameters identified from forces, and whether model and stated noise explain the measurement.

    Attributes
    ----------
    base : BaseParameters
        What they are.
    values : ndarray
        SI, (rank,).
    covariance : ndarray
        (rank, rank), inflated by the square of ``inflation``; infinite on its diagonal if the fit is
        rejected.
    misfit : float
        RMS of the residual over its expectation, near 1 if model and noise are right.
    p_noise : float
        Probability of so large a residual under the stated noise.
    p_model : float
        Probability of so large a smooth part of the residual, or of one that a changing load explains so
        well; it does not depend on the stated size of the noise.
    inflation : float
        Factor on the deviations, at least 1, from the residual.
    verdict : str
        "consistent"; "misfit": one of the two is below 0.001; "rejected": inflation would be above 3, or the
        fit did not converge or is not linear within its deviations; "untested": no more forces than unknowns.
    doubts : tuple
        A line for each reason.
    impossible : tuple
        A line for each value that no machine can have, more than four deviations below zero.
    near_zero : tuple
        A line for each value that is below zero by less: not distinguishable from 0.
    motion : Motion
        Along which the parameters were estimated, (...).
    parameters : Parameters, optional
        Of possible bodies that have these values, (148,), if they were requested.
    free : Estimate, optional
        The estimate that was not kept to possible bodies, then.
    drive : DriveEstimate, optional
        Terms of the drives, if they were sought.
    """

    base: BaseParameters
    values: Array
    covariance: Array
    misfit: float
    p_noise: float
    p_model: float
    inflation: float
    verdict: str
    doubts: tuple[str, ...]
    impossible: tuple[str, ...]
    near_zero: tuple[str, ...]
    motion: Motion
    parameters: Parameters | None = None
    free: Estimate | None = None
    drive: DriveEstimate | None = None

    @property
    def sigma(self) -> Array:
        """Standard deviation of each value, (rank,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def departure(self, robot: Robot) -> tuple[Array, float]:
        """How far the values, of ``free`` where there is one, are from a robot's.

        Parameters
        ----------
        robot : Robot
            The machine. Where terms of drives were sought, viscous friction of its drives counts as that of
            the prismatic joints, of which forces of motors do not tell it apart.

        Returns
        -------
        off : ndarray
            Differences in standard deviations, positive where the estimate is larger, (rank,); 0 if the fit
            is rejected.
        p : float
            The p-value of all: the probability that a robot with its own parameters would be identified so
            far from these or farther; 1 if the fit is rejected.
        """
        if self.free is not None:
            return self.free.departure(robot)
        robot = robot if self.drive is None else seen_by_motors(robot)
        off = self.values - self.base.matrix @ inertial_parameters(robot).values
        if not np.isfinite(self.covariance).all():
            return np.zeros(len(off)), 1.0
        return departure(off, self.covariance)
