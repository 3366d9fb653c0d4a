"""Identification of base parameters and their standard deviations from measured actuator forces.

    F = H^-1 (Y pi - [R F_ext; R M_ext]) + noise

This equation is linear in the base parameters, so weighted least squares solves it along an exactly known
motion. Noise of measured poses causes errors in the regressor. For measured poses the motion is therefore a
series with unknown coefficients, which is fitted to poses and forces together with the parameters (maximum
likelihood). Only the geometry and gravity of the robot file are used. The residual of every fit is tested;
``IdentificationResult.verdict`` contains the result of the tests.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse_dynamics import inverse_dynamics, need_motion, need_universal
from ..io.arguments import deviations, finite_array, instance, truth
from ..io.array_types import Array
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParametersResult, need_base
from .base_parameters import base_parameters as parameters_of
from .drive_terms import Terms, need_terms, told_apart, turning_legs
from .estimates import IdentificationResult, tested_estimate
from .excitation import Excitation, force_regressor, need_seed
from .fits import Data, robust_fit
from .motion_basis import PoseNoise, smoothed
from .parameters import inertial_parameters
from .possible_bodies import possible_estimate


@dataclass(frozen=True, eq=False)
class Experiment:
    """Simulated measurement and the estimate from it.

    Attributes
    ----------
    excitation : Excitation
        Exact motion.
    measured_motion : Motion
        Measured poses, with noise unless ``pose_noise`` is None.
    F : ndarray, shape (n, 6)
        Noisy forces (N).
    force_std : float
        Standard deviation of the forces (N).
    pose_noise : PoseNoise, optional
        Noise of the poses; None for exact poses.
    true_values : ndarray, shape (rank,)
        Base parameters of the robot.
    estimate : IdentificationResult
        Estimate from ``F``.
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
        """Error of each estimate in standard deviations, shape (rank,); NaN if the fit is rejected."""
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

    All noise is assumed to be normal and independent.

    Parameters
    ----------
    robot : Robot
        Robot with correct geometry, gravity, and rotors; its other parameters are not used.
    motion : Motion
        Measured motion, shape (...), with any load.
    F : array_like, shape (..., 6)
        Measured actuator forces (N). For a robot with rotors these are motor forces (motor torque times
        transmission ratio).
    force_std : array_like
        Standard deviation of each force (N); it broadcasts to the shape of ``F``.
    base_parameters : BaseParametersResult, optional
        Base parameters of a robot with the same geometry and gravity; by default ``base_parameters(robot)``.
    pose_noise : PoseNoise, optional
        Noise of the poses at n times. Only poses and load of ``motion`` are then used; the rates belong to
        the smooth motion that best explains poses and forces, and the standard deviations include both
        noises. By default the motion and its accelerations are exact.
    enforce_physical : bool, optional
        Restrict the estimate to physically possible bodies. Parameters that the forces do not determine are
        then as close as possible to the robot's own, all 148 parameters are returned, and the standard
        deviations account for the restriction.
    identical_legs : bool, optional
        Estimate one set of parameters for all legs; not with ``base_parameters``.
    drive_terms : sequence of str, optional
        Drive terms to identify from motor forces: "reflected_mass", "coulomb", "offset", and "viscous", which
        is equivalent to ``C_p`` if both are identified. With ``pose_noise`` and "coulomb", forces of legs
        with an uncertain direction of motion are ignored.

    Returns
    -------
    IdentificationResult
        Values with their covariance, and the results of the tests.

    Raises
    ------
    ValueError
        If an argument is invalid, if a pose has no solution, or if the motion does not excite every base
        parameter. ``base_parameters(robot, motion)`` contains the excited parameters only.

    See Also
    --------
    base_parameters : Identifiable combinations of the inertial parameters.
    choose_excitation : Motion with a well-conditioned regressor.
    simulate_experiment : Identification from simulated measurements.

    Notes
    -----
    The model is F = H^-1 (Y pi - [R F_ext; R M_ext]) with the regressor Y (``regressor``). Wensing, Kim, and
    Slotine (2018) derive the conditions of physically possible bodies.

    References
    ----------
    P. M. Wensing, S. Kim, and J.-J. E. Slotine, "Linear matrix inequalities for physically consistent
    inertial parameter identification", IEEE Robotics and Automation Letters 3(1), 2018.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> excitation = ss.choose_excitation(robot, samples=50, candidates=1, identical_legs=True)
    >>> noise = np.random.default_rng(0).normal(size=(50, 6))
    >>> F = ss.inverse_dynamics(robot, excitation.motion).F + noise
    >>> base = excitation.base
    >>> result = ss.identify(robot, excitation.motion, F=F, force_std=1.0, base_parameters=base)
    >>> result.verdict, result.values.shape
    ('consistent', (25,))
    """
    need_universal(robot)
    truth(enforce_physical, "enforce_physical")
    if pose_noise is None:
        need_motion(robot, motion)
    if base_parameters is not None and identical_legs:
        raise ValueError("identical_legs: expected False with base_parameters, which already define it")
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
    found = tested_estimate(*robust_fit(data, pose_noise))
    return possible_estimate(robot, found) if enforce_physical and found.verdict != "rejected" else found


def _with_terms(data: Data, drive: tuple[str, ...], noise: PoseNoise | None) -> Data:
    """Add the drive terms to the data, with the identifiable ones marked.

    For measured poses, forces with an uncertain sign of the Coulomb friction are ignored.
    """
    along, counted = data.motion, np.ones(data.forces.shape)
    if noise is not None:
        along, rates = smoothed(data.motion, noise)
        if "coulomb" in drive:
            counted[turning_legs(data.robot, along, rates)] = 0.0
            if not counted.any():
                reason = "at this pose noise every direction of motion is uncertain"
                raise ValueError(f'motion: expected legs that move, for "coulomb": {reason}')
    terms = Terms(drive, data.base.identical_legs)
    columns = terms.columns(data.robot, along) * counted[..., None]
    A = force_regressor(data.robot, along, data.base) * counted[..., None]
    deviations = np.where(counted > 0.0, data.deviations, np.inf)
    return data._replace(terms=told_apart(terms, A, columns, data.base.names), deviations=deviations)


def simulate_experiment(
    robot: Robot,
    excitation: Excitation,
    force_std: float,
    seed: int = 0,
    position_std: float = 0.0,
    angle_std: float = 0.0,
) -> Experiment:
    """Simulate noisy forces along a motion, and identify the base parameters from them.

    Parameters
    ----------
    robot : Robot
        Robot model.
    excitation : Excitation
        Motion, for example the result of ``choose_excitation``.
    force_std : float
        Standard deviation of every force (N), > 0.
    seed : int, optional
        Random seed of the noise. The noise is independent of the motion of ``choose_excitation`` with the
        same seed.
    position_std, angle_std : float, optional
        Standard deviations of the measured poses (m and rad), both 0 or both > 0. With pose noise, the rates
        of the motion are not used.

    Returns
    -------
    Experiment
        Motion, forces, true values, and the estimate.

    Raises
    ------
    ValueError
        If an argument is invalid.

    See Also
    --------
    choose_excitation : Motion with a well-conditioned regressor.
    identify : Identification from measured forces.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> excitation = ss.choose_excitation(robot, samples=50, candidates=1, identical_legs=True)
    >>> experiment = ss.simulate_experiment(robot, excitation, force_std=1.0)
    >>> experiment.estimate.verdict
    'consistent'
    >>> bool(abs(experiment.z_scores).max() < 4.0)
    True
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
