"""Identification: base parameters with their standard deviations from measured actuator forces.

    F = H^-1 (Y pi - [R F_ext; R M_ext]) + noise

is linear in the base parameters, so weighted least squares finds them along a motion that is known exactly.
Poses measured with noise are errors in the regressor: there the motion is a series with unknown
coefficients, fitted together with the parameters to poses and forces (maximum likelihood). Of the robot
file only geometry and gravity are used. Every fit is tested by its residual; ``Estimate.verdict`` says with
what result.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from ..dynamics.inverse import inverse_dynamics, need_motion, need_universal
from ..io.arguments import deviations, finite_array, instance, truth
from ..io.array_types import Array
from ..io.extras import need
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_vector
from ..motion.smooth_motion import WITHOUT_PERIOD, PoseNoise, smoothed
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParameters, base_parameters, need_base
from .drive_terms import drive_terms, need_terms, told_apart, turning_legs
from .estimates import EXACT, LEVEL, Estimate, tested_estimate
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
    measured : Motion
        Its poses as measured, with noise if there is any.
    F : ndarray
        Noisy forces, N, (n, 6).
    sigma : float
        Their standard deviation, N.
    noise : PoseNoise
        Of the poses, None if they are exact.
    truth : ndarray
        The base parameters of the robot, (rank,).
    estimate : Estimate
        From F.
    """

    excitation: Excitation
    measured: Motion
    F: Array
    sigma: float
    noise: PoseNoise | None
    truth: Array
    estimate: Estimate

    @property
    def deviation(self) -> Array:
        """Error of each estimate in its standard deviations, (rank,); NaN where the fit gives none."""
        sigma = self.estimate.sigma
        return np.asarray((self.estimate.values - self.truth) / np.where(np.isfinite(sigma), sigma, np.nan))


def identify(
    robot: Robot,
    motion: Motion,
    F: ArrayLike,
    sigma: ArrayLike,
    base: BaseParameters | None = None,
    noise: PoseNoise | None = None,
    physical: bool = False,
    shared: str | None = None,
    drive: Sequence[str] | None = None,
) -> Estimate:
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
    sigma : array_like
        Standard deviation of each force, N, broadcasts to F's shape.
    base : BaseParameters, optional
        None for ``base_parameters(robot)``; of a machine of the same geometry and gravity.
    noise : PoseNoise, optional
        Of the poses at n instants, of which only these and the load then count; the rates are those of the
        smooth motion that explains poses and forces best, and the deviations hold the noise of both. None:
        the motion, with its accelerations, is taken as exact.
    physical : bool, optional
        Keep to bodies that can exist; what the forces do not decide is then as near as can be to the robot's
        own bodies, all 148 parameters are given, and the deviations take that into account. Needs SciPy.
    shared : {"legs"}, optional
        As for ``base_parameters``, without ``base``.
    drive : sequence of str, optional
        Terms of the drives to seek as well, where F are forces of the motors, N times torque: some of
        "reflected_mass", "coulomb", "offset" and "viscous", which is the same as ``C_p`` where that is
        sought; ``Estimate.drive`` has what is identifiable. With ``noise`` and "coulomb", a force does not
        count where the direction of its leg is not sure.

    Returns
    -------
    Estimate
        Values with their covariance, and what the residual shows.

    Raises
    ------
    ValueError
        For wrong shapes, for sigma not > 0, for unsolvable poses, and for a motion that does not excite every
        base parameter; pass ``base_parameters(robot, motion)`` to identify what it does excite.
    """
    need_universal(robot)
    truth(physical, "physical")
    if physical:
        need("scipy", POSSIBLE)
    if isinstance(noise, PoseNoise) and noise.period is None:
        need("scipy", WITHOUT_PERIOD)
    if noise is None:
        need_motion(robot, motion)
    if base is not None and shared is not None:
        raise ValueError(f'shared: expected None beside base, got "{shared}"')
    if base is None:
        base = base_parameters(robot, shared=shared)
    instance(motion, Motion, "motion")
    need_base(base, robot)
    forces = finite_array(F, (LEGS,), "F")
    if forces.shape != (*motion.shape, LEGS):
        raise ValueError(f"F: expected forces of shape {(*motion.shape, LEGS)}, got {forces.shape}")
    if noise is not None:
        instance(noise, PoseNoise, "noise")
    data = Data(
        robot,
        motion,
        forces,
        deviations(sigma, forces.shape, f"> 0 N that broadcast with F, {forces.shape}"),
        base,
    )
    if drive is not None:
        data = _with_terms(data, need_terms(drive), noise)
    if noise is not None:
        found = tested_estimate(data, joint_fit(data, noise), ())
    else:
        found = tested_estimate(data, exact_fit(data, motion), EXACT)
    return _possible(robot, found) if physical and found.verdict != "rejected" else found


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
    terms = drive_terms(data.robot, along, drive, data.base.shared is not None)
    terms = terms._replace(columns=terms.columns * counted[..., None])
    A = force_regressor(data.robot, along, data.base) * counted[..., None]
    deviations = np.where(counted > 0.0, data.deviations, np.inf)
    return data._replace(terms=told_apart(terms, A, data.base.names), deviations=deviations)


def simulated_experiment(
    robot: Robot,
    excited: Excitation,
    sigma: float,
    seed: int = 0,
    noise_position: float = 0.0,
    noise_angle: float = 0.0,
) -> Experiment:
    """Measure the robot's forces along a motion with normal noise and identify it from them.

    Parameters
    ----------
    robot : Robot
        The machine.
    excited : Excitation
        Motion, as from ``choose_excitation``.
    sigma : float
        Standard deviation of every force, N, > 0.
    seed : int, optional
        Of the noise, which is independent of what ``choose_excitation`` draws from the same seed.
    noise_position, noise_angle : float, optional
        Of the measured poses, m and rad, both 0 or both > 0; with noise, only poses are measured.

    Returns
    -------
    Experiment
        Motion, forces, estimate and true values.
    """
    instance(excited, Excitation, "excited")
    need_seed(seed)
    exact = inverse_dynamics(robot, excited.motion).F
    deviation = float(deviations(sigma, (), "> 0 N that broadcast with F"))
    rng = np.random.default_rng((seed, 1))
    F = exact + deviation * rng.normal(size=exact.shape)
    motion, path, noise = excited.motion, excited.path, None
    if noise_position != 0.0 or noise_angle != 0.0:
        noise = PoseNoise(excited.time, noise_position, noise_angle, path.period, len(path.sine))
        shift, turn = rng.normal(size=(2, len(excited.time), 3))
        R = rotation_from_vector(noise.angle * turn) @ motion.R
        motion = Motion(R, motion.t + noise.position * shift, motion.omega, motion.v)
    estimate = identify(robot, motion, F, deviation, excited.base, noise)
    right = excited.base.matrix @ inertial_parameters(robot).values
    return Experiment(excited, motion, F, deviation, noise, right, estimate)


def _possible(robot: Robot, found: Estimate) -> Estimate:
    """The estimate kept to possible bodies; a misfit if these explain the forces much worse."""
    fit = possible_fit(robot, found.base, found.values, found.covariance)
    ratio = fit.squares / found.base.rank
    verdict, doubts = found.verdict, found.doubts
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
        doubts=doubts,
        impossible=(),
        near_zero=(),
        parameters=fit.parameters,
        free=found,
    )
