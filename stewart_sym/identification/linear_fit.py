"""The linear fit of base parameters to forces along a known motion, and what every fit hands on."""

from typing import NamedTuple

import numpy as np

from ..dynamics.inverse import inverse_dynamics
from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from .base_parameters import BaseParameters
from .drive_terms import Terms, rotor_forces
from .excitation import force_regressor

# Singular values below this share of the largest say that the motion does not excite all parameters.
_ROUNDING = 1e-12
# Parameters of the platform that a payload taken up, dropped or shifted changes.
LOAD = ("M", "h_P_x", "h_P_y", "h_P_z")


class Data(NamedTuple):
    """What ``identify`` was given; forces with an infinite deviation do not count."""

    robot: Robot
    motion: Motion
    forces: Array
    deviations: Array
    base: BaseParameters
    terms: Terms | None = None

    @property
    def unknowns(self) -> int:
        """How many base parameters and terms of the drives are sought."""
        return self.base.rank + (0 if self.terms is None else int(self.terms.identifiable.sum()))

    @property
    def left_out(self) -> int:
        """How many forces do not count."""
        return int(np.isinf(self.deviations).sum())


class Fit(NamedTuple):
    """A least-squares fit about its solution.

    parts: residual over deviations, of the forces and, in a joint fit, of the poses, (n, 6) each. values: of
    base parameters and terms of the drives, (m,). covariance: (m, m). span: orthonormal basis of what the
    unknowns can explain, (rows, unknowns).
    curvature: as ``_curvature`` returns.
    """

    parts: tuple[Array, ...]
    values: Array
    covariance: Array
    span: Array
    motion: Motion
    converged: bool = True
    curvature: float = 0.0


def exact_fit(data: Data, motion: Motion) -> Fit:
    """Fit along a motion that is known exactly."""
    A, y = linear_system(data, motion)
    J = A.reshape(-1, A.shape[-1])
    felt = _felt(J[:, : data.base.rank])
    if felt < data.base.rank:
        raise ValueError(f"motion: excites {felt} of {data.base.rank} base parameters, expected all of them")
    span, back = factors(J)
    values = back @ (span.T @ y.ravel())
    return Fit(((y - A @ values).reshape(-1, LEGS),), values, back @ back.T, span, motion)


def _felt(J: Array) -> int:
    """Rank of J, its columns of length 1."""
    lengths = np.linalg.norm(J, axis=0)
    values = np.linalg.svd(
        np.linalg.qr(J / np.where(lengths > 0.0, lengths, 1.0), mode="r"), compute_uv=False
    )
    return int(np.count_nonzero(values > _ROUNDING * values[0])) if values.size else 0


def linear_system(data: Data, motion: Motion) -> tuple[Array, Array]:
    """A and y of A values = y, both over the deviations: (..., 6, rank and terms) and (..., 6)."""
    with np.errstate(over="ignore", invalid="ignore"):
        A = force_regressor(data.robot, motion, data.base)
        if data.terms is not None:
            A = np.concatenate([A, data.terms.along(data.robot, motion)], axis=-1)
        A = A / data.deviations[..., None]
        known = _load_forces(data.robot, motion) - _forces_of_rotors(data, motion)
        y = (data.forces + known) / data.deviations
    if not (np.isfinite(A).all() and np.isfinite(y).all()):
        raise ValueError("sigma: expected standard deviations beside which the forces do not overflow")
    return A, y


def _load_forces(robot: Robot, motion: Motion) -> Array:
    """H^-1 [R F_ext; R M_ext], (..., 6)."""
    if motion.F_ext is None and motion.M_ext is None:
        return np.zeros((*motion.shape, LEGS))
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, motion.external_wrench()[..., None])[..., 0])


def _forces_of_rotors(data: Data, motion: Motion) -> Array:
    """What the rotors of the robot file take of the motors' forces, (..., 6), unless they are sought."""
    robot = data.robot
    if robot.drive is None or not robot.has_rotors or (data.terms is not None and data.terms.of_rotors):
        return np.zeros((*motion.shape, LEGS))
    return np.asarray(rotor_forces(robot, motion, robot.drive) @ robot.m_r)


def factors(J: Array) -> tuple[Array, Array]:
    """Orthonormal basis of the range of J, of full rank, and B such that B basis^T is the pseudoinverse."""
    lengths = np.linalg.norm(J, axis=0)
    Q, corner = np.linalg.qr(J / lengths)
    return Q, np.linalg.inv(corner) / lengths[:, None]
