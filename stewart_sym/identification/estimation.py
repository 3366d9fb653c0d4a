"""Identification: base parameters with their standard deviations from measured actuator forces.

    F = H^-1 (Y pi - [R F_ext; R M_ext]) + noise

is linear in the base parameters, so weighted least squares finds them along a motion that is known exactly.
Poses measured with noise are errors in the regressor: there the motion is a series with unknown
coefficients, fitted together with the parameters to poses and forces (maximum likelihood). Of the robot
file only geometry and gravity are used. Every fit is tested by its residual; ``IdentificationResult.verdict``
says with what result.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse_dynamics import inverse_dynamics, need_motion, need_universal
from ..io.arguments import deviations, finite_array, instance, truth
from ..io.array_types import Array
from ..io.extras import need
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..motion.smooth_motion import WITHOUT_PERIOD, PoseNoise, smoothed
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult, need_base
from .base_parameters import base_parameters as parameters_of
from .drive_terms import drive_terms as terms_along
from .drive_terms import need_terms, told_apart, turning_legs
from .estimates import EXACT, LEVEL, IdentificationResult, tested_estimate
from .excitation import Excitation, force_regressor, need_seed
from .fits import Data, exact_fit, joint_fit
from .least_squares import tail
from .parameters import inertial_parameters
from .physical import POSSIBLE, possible_fit


@dataclass(frozen=True, eq=False)
class Experiment:
    """A simulated measurement and the estimate from it.

    Attributes
    ----------
    excitation : Excitation
        The motion.
    measured_motion : Motion
        Its poses as measured, with noise if there is any.
    F : ndarray
        Noisy forces, N, (n, 6).
    force_std : float
        Their standard deviation, N.
    pose_noise : PoseNoise
        Of the poses, None if they are exact.
    true_values : ndarray
        The base parameters of the robot, (rank,).
    estimate : IdentificationResult
        From F.
    """

    excitation: Excitation
    measured_motion: Motion
    F: Array
    force_std: float
    pose_noise: PoseNoise | None
    true_values: Array
    estimate: IdentificationResult

    @property
    def z_scores(self) -> Array:
        """Error of each estimate in its standard deviations, (rank,); NaN where the fit gives none."""
        sigma = self.estimate.std
        return np.asarray(
            (self.estimate.values - self.true_values) / np.where(np.isfinite(sigma), sigma, np.nan)
        )


def identify(
    robot: Robot,
    motion: Motion,
    F: ArrayLike,
    force_std: ArrayLike,
    base_parameters: BaseParametersResult | None = None,
    pose_noise: PoseNoise | None = None,
    enforce_physical: bool = False,
    identical_legs: bool = False,
    drive_terms: Sequence[str] | None = None,
) -> IdentificationResult:
    """Estimate the base parameters by weighted least squares, and test the residual.

    All noise is taken as normal and independent.

    Parameters
    ----------
    robot : Robot
        Its geometry, gravity and rotors count, the rest may be wrong.
    motion : Motion
        Measured, with any load, (...).
    F : array_like
        Measured actuator forces, N, (..., 6); where the robot has rotors the motors', N times torque.
    force_std : array_like
        Standard deviation of each force, N, broadcasts to F's shape.
    base_parameters : BaseParametersResult, optional
        None for ``base_parameters(robot)``; of a machine of the same geometry and gravity.
    pose_noise : PoseNoise, optional
        Of the poses at n instants, of which only these and the load then count; the rates are those of the
        smooth motion that explains poses and forces best, and the deviations hold the noise of both. None:
        the motion, with its accelerations, is taken as exact.
    enforce_physical : bool, optional
        Keep to bodies that can exist; what the forces do not decide is then as near as can be to the robot's
        own bodies, all 148 parameters are given, and the deviations take that into account. Needs SciPy.
    identical_legs : bool, optional
        As for ``base_parameters``, without ``base_parameters``.
    drive_terms : sequence of str, optional
        Terms of the drives to seek as well, where F are forces of the motors, N times torque: some of
        "reflected_mass", "coulomb", "offset" and "viscous", which is the same as ``C_p`` where that is
        sought; ``IdentificationResult.drive`` has what is identifiable. With ``pose_noise`` and "coulomb", a
        force does not count where the direction of its leg is not sure.

    Returns
    -------
    IdentificationResult
        Values with their covariance, and what the residual shows.

    Raises
    ------
    ValueError
        For wrong shapes, for sigma not > 0, for unsolvable poses, and for a motion that does not excite every
        base parameter; pass ``base_parameters(robot, motion)`` to identify what it does excite.
    """
    need_universal(robot)
    truth(enforce_physical, "enforce_physical")
    if enforce_physical:
        need("scipy", POSSIBLE)
    if isinstance(pose_noise, PoseNoise) and pose_noise.period is None:
        need("scipy", WITHOUT_PERIOD)
    if pose_noise is None:
        need_motion(robot, motion)
    if base_parameters is not None and identical_legs:
        raise ValueError("identical_legs: expected False with base_parameters, which state it")
    if base_parameters is None:
        base_parameters = parameters_of(robot, identical_legs=identical_legs)
    instance(motion, Motion, "motion")
    need_base(base_parameters, robot)
    forces = finite_array(F, (LEGS,), "F")
    if forces.shape != (*motion.shape, LEGS):
        raise ValueError(f"F: expected forces of shape {(*motion.shape, LEGS)}, got {forces.shape}")
    if pose_noise is not None:
        instance(pose_noise, PoseNoise, "pose_noise")
    data = Data(
        robot,
        motion,
        forces,
        deviations(force_std, "force_std", forces.shape, f"> 0 N that broadcast with F, {forces.shape}"),
        base_parameters,
    )
    if drive_terms is not None:
        data = _with_terms(data, need_terms(drive_terms), pose_noise)
    if pose_noise is not None:
        found = tested_estimate(data, joint_fit(data, pose_noise), ())
    else:
        found = tested_estimate(data, exact_fit(data, motion), EXACT)
    return _possible(robot, found) if enforce_physical and found.verdict != "rejected" else found


def _with_terms(data: Data, drive: tuple[str, ...], noise: PoseNoise | None) -> Data:
    """The data with terms of the drives, told apart from the base parameters.

    Of measured poses forces do not count where friction that steps may be that of either direction.
    """
    along, counted = data.motion, np.ones(data.forces.shape)
    if noise is not None:
        along, rates = smoothed(data.motion, noise)
        if "coulomb" in drive:
            counted[turning_legs(data.robot, along, rates)] = 0.0
            if not counted.any():
                said = "the noise of the poses hides every direction"
                raise ValueError(f'motion: expected legs that move, for "coulomb": {said}')
    terms = terms_along(data.robot, along, drive, data.base.identical_legs)
    terms = terms._replace(columns=terms.columns * counted[..., None])
    A = force_regressor(data.robot, along, data.base) * counted[..., None]
    deviations = np.where(counted > 0.0, data.deviations, np.inf)
    return data._replace(terms=told_apart(terms, A, data.base.names), deviations=deviations)


def simulate_experiment(
    robot: Robot,
    excitation: Excitation,
    force_std: float,
    seed: int = 0,
    position_std: float = 0.0,
    angle_std: float = 0.0,
) -> Experiment:
    """Measure the robot's forces along a motion with normal noise and identify it from them.

    Parameters
    ----------
    robot : Robot
        The machine.
    excitation : Excitation
        Motion, as from ``choose_excitation``.
    force_std : float
        Standard deviation of every force, N, > 0.
    seed : int, optional
        Of the noise, which is independent of what ``choose_excitation`` draws from the same seed.
    position_std, angle_std : float, optional
        Of the measured poses, m and rad, both 0 or both > 0; with noise, only poses are measured.

    Returns
    -------
    Experiment
        Motion, forces, estimate and true values.
    """
    instance(excitation, Excitation, "excitation")
    need_seed(seed)
    exact = inverse_dynamics(robot, excitation.motion).F
    deviation = float(deviations(force_std, "force_std", (), "> 0 N that broadcast with F"))
    rng = np.random.default_rng((seed, 1))
    F = exact + deviation * rng.normal(size=exact.shape)
    motion, path, noise = excitation.motion, excitation.path, None
    if position_std != 0.0 or angle_std != 0.0:
        noise = PoseNoise(excitation.time, position_std, angle_std, path.period, len(path.sine))
        shift, turn = rng.normal(size=(2, len(excitation.time), 3))
        R = rotation_from_vector(noise.angle * turn) @ motion.R
        motion = Motion(R=R, t=motion.t + noise.position * shift, omega=motion.omega, v=motion.v)
    estimate = identify(robot, motion, F, deviation, excitation.base, noise)
    right = excitation.base.matrix @ inertial_parameters(robot).values
    return Experiment(excitation, motion, F, deviation, noise, right, estimate)


def _possible(robot: Robot, found: IdentificationResult) -> IdentificationResult:
    """The estimate kept to possible bodies; a misfit if these explain the forces much worse."""
    fit = possible_fit(robot, found.base, found.values, found.covariance)
    ratio = fit.squares / found.base.rank
    verdict, doubts = found.verdict, found.warnings
    if tail(ratio, found.base.rank) < LEVEL:
        verdict = "misfit"
        doubts = (
            *doubts,
            f"bodies: possible ones are {math.sqrt(ratio):.3g} times as far from the estimate as by noise",
        )
    return replace(
        found,
        values=fit.values,
        covariance=fit.covariance,
        verdict=verdict,
        warnings=doubts,
        nonphysical=(),
        near_zero=(),
        parameters=fit.parameters,
        unconstrained=found,
    )
