"""Drive terms of the motor forces: reflected mass, Coulomb friction, offset, and viscous friction."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from ..drives.friction import constant_part, smooth_sign, viscous
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.arguments import shown
from ..io.array_types import Array, Flags, Frozen
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from .least_squares import departure
from .parameters import rotor_regressor

DRIVE_TERMS = {"reflected_mass": "kg", "coulomb": "N", "offset": "N", "viscous": "N s/m"}
"""Drive terms that can be identified, in this order, with their units."""

# Relative length of the residual below which a column is a linear combination of other columns.
_SAME = 1e-7
# Relative coefficient from which a column of such a combination is listed in the message.
_NAMED = 0.05
# Number of standard deviations from zero beyond which the sign of a rate is certain.
_SURE = 4.0


@dataclass(frozen=True, eq=False)
class DriveIdentificationResult(Frozen):
    """Drive terms identified from motor forces.

    The motor force of each leg is the force of the bodies plus reflected_mass L_ddot + coulomb sgn(L_dot) +
    offset + viscous L_dot. If the robot has a drive, the other effects of a rotor are computed from its lead.

    Attributes
    ----------
    names : tuple of str
        Names of the terms with the number of the leg, for example ``coulomb3``; without a number if the legs
        are identical.
    units : tuple of str
        Unit of each term.
    values : ndarray, shape (n,)
        Values; NaN if the motion does not identify the term.
    covariance : ndarray, shape (n, n)
        Covariance, scaled as in ``IdentificationResult``; inf on the diagonal if the motion does not identify
        the term.
    identifiable : ndarray of bool, shape (n,)
        True for terms that the motion identifies.
    unidentifiable : tuple of str
        One message for each other term, with the equivalent terms and parameters.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    covariance: Array
    identifiable: Flags
    unidentifiable: tuple[str, ...]

    @property
    def std(self) -> Array:
        """Standard deviation of each value, shape (n,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def compare_with(self, given: Array) -> tuple[Array, float]:
        """Compare the values with given values, like ``IdentificationResult.compare_with`` for the bodies.

        Parameters
        ----------
        given : ndarray, shape (n,)
            Value of each term; NaN for terms that are not compared.

        Returns
        -------
        off : ndarray, shape (n,)
            Differences in standard deviations; 0 for terms that are not compared.
        p : float
            Joint p-value of all differences; NaN if nothing is compared.
        """
        compared = self.identifiable & np.isfinite(given) & np.isfinite(self.std)
        off, p = np.zeros(len(self.values)), math.nan
        if compared.any():
            spread = self.covariance[np.ix_(compared, compared)]
            off[compared], p = departure((self.values - given)[compared], spread)
        return off, p


class Terms(NamedTuple):
    """Requested drive terms, with names in the order of ``DRIVE_TERMS``.

    With ``shared`` all legs have the same values. ``confused`` has a message for each unidentifiable term.
    """

    sought: tuple[str, ...]
    shared: bool
    identifiable: Flags = np.zeros(0, dtype=np.bool_)
    confused: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the terms, with the number of the leg unless they are shared."""
        legs = [""] if self.shared else range(1, LEGS + 1)
        return tuple(f"{name}{leg}" for name in self.sought for leg in legs)

    @property
    def of_rotors(self) -> bool:
        """True if the rotors are among the terms."""
        return "reflected_mass" in self.sought

    def columns(self, robot: Robot, motion: Motion) -> Array:
        """Compute the forces of all terms (N) for a value of 1, shape (..., 6, n), along a motion."""
        legs = inverse_kinematics(robot, motion)
        within = np.zeros(LEGS) if robot.drive is None else np.asarray(robot.drive.regularization_speed)
        factors = {
            "reflected_mass": legs.L_ddot,
            "coulomb": smooth_sign(legs.L_dot, within),
            "offset": np.ones_like(legs.L_dot),
            "viscous": legs.L_dot,
        }
        columns = []
        for name in self.sought:
            each = np.asarray(factors[name])[..., None] * np.eye(LEGS)
            if name == "reflected_mass" and robot.drive is not None:
                each = rotor_forces(robot, motion, robot.drive)
            columns.append(each.sum(axis=-1, keepdims=True) if self.shared else each)
        return np.concatenate(columns, axis=-1)

    def along(self, robot: Robot, motion: Motion) -> Array:
        """Compute the forces of the identifiable terms, shape (..., 6, m), along a motion."""
        return np.asarray(self.columns(robot, motion)[..., self.identifiable])

    def estimate(self, values: Array, covariance: Array) -> DriveIdentificationResult:
        """Create the result from values (m,) and covariance (m, m) of the identifiable terms."""
        found, spread = np.full(len(self.names), np.nan), np.diag(np.full(len(self.names), np.inf))
        found[self.identifiable] = values
        spread[np.ix_(self.identifiable, self.identifiable)] = covariance
        units = tuple(DRIVE_TERMS[name.rstrip("123456")] for name in self.names)
        return DriveIdentificationResult(self.names, units, found, spread, self.identifiable, self.confused)


def need_terms(drive: object, where: str = "drive_terms") -> tuple[str, ...]:
    """Return distinct names of terms in the order of ``DRIVE_TERMS``; raise ValueError for other names."""
    expected = f"some of {', '.join(DRIVE_TERMS)}"
    if isinstance(drive, str) or not isinstance(drive, Sequence) or not drive:
        raise ValueError(f"{where}: expected {expected}, got {shown(drive)}")
    for name in drive:
        if not isinstance(name, str) or name not in DRIVE_TERMS:
            raise ValueError(f"{where}: expected {expected}, got {shown(name)}")
    return tuple(name for name in DRIVE_TERMS if name in drive)


def turning_legs(robot: Robot, motion: Motion, rates: Array) -> Flags:
    """Return samples and legs, shape (n, 6), with uncertain direction at given std of the pose rates."""
    H = inverse_dynamics(robot, motion).H
    deviation = np.linalg.norm(H * rates[:, :, None], axis=1)
    return np.asarray(np.abs(inverse_kinematics(robot, motion).L_dot) < _SURE * deviation)


def seen_by_motors(robot: Robot) -> Robot:
    """Return the robot with the viscous friction of its drives moved to its prismatic joints.

    Motor forces do not distinguish between the two.
    """
    if robot.drive is None or not np.any(viscous(robot.drive)):
        return robot
    none = np.zeros(LEGS)
    bare = dataclasses.replace(robot.drive, screw_viscous=none, motor_viscous=none)
    return dataclasses.replace(robot, C_p=robot.C_p + viscous(robot.drive), drive=bare)


def terms_of(robot: Robot, names: Sequence[str]) -> Array:
    """Return drive terms of a robot by name, shape (n,); NaN for a shared term that differs between legs.

    The names are the same as in ``DriveIdentificationResult``.
    """
    if robot.drive is None:
        return np.full(len(names), np.nan)
    legs = {
        "reflected_mass": robot.drive.reflected_mass,
        "coulomb": constant_part(robot.drive, np.full(LEGS, np.inf)),
        "offset": np.zeros(LEGS),
        "viscous": viscous(robot.drive),
    }
    found = []
    for name in names:
        term = name.rstrip("123456")
        values = legs[term]
        shared = values[0] if np.ptp(values) == 0.0 else np.nan
        found.append(shared if term == name else values[int(name[len(term) :]) - 1])
    return np.array(found)


def rotor_forces(robot: Robot, motion: Motion, drive: Drive) -> Array:
    """Compute the forces, shape (..., 6, 6), of rotors with 1 kg reflected mass, including leg moments."""
    Y = rotor_regressor(robot, motion)
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, Y[..., :LEGS] + Y[..., LEGS:] / drive.transmission_ratio))


def told_apart(terms: Terms, A: Array, columns: Array, names: Sequence[str]) -> Terms:
    """Determine the identifiable terms.

    A term is identifiable unless it is a linear combination of the base parameters and the terms before it
    along the motion. ``A``, shape (..., 6, rank), are the forces of the base parameters with these names, and
    ``columns`` the forces of the terms.
    """
    known = [*names, *terms.names]
    columns = np.concatenate([A, columns], axis=-1).reshape(-1, len(known))
    lengths = np.linalg.norm(columns, axis=0)
    R = np.asarray(np.linalg.qr(columns / np.where(lengths > 0.0, lengths, 1.0), mode="r"))
    new = np.abs(np.diagonal(R)) > _SAME
    new[: len(names)] = True
    confused = []
    for i in np.flatnonzero(~new).tolist():
        before = np.flatnonzero(new[:i])
        shares = np.abs(np.linalg.lstsq(R[:, before], R[:, i])[0])
        order = np.argsort(-shares, kind="stable")[:4]
        same = [known[before[k]] for k in order if shares[k] > _NAMED * shares.max()]
        acts_as = ", ".join(same) or "nothing"
        confused.append(f"{known[i]}: not identifiable along this motion, acts as {acts_as}")
    return terms._replace(identifiable=new[len(names) :], confused=tuple(confused))
