"""Terms of the drives in forces of motors, beside the bodies: reflected mass, Coulomb, viscous, offset."""

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
from ..io.array_types import Array, Flags
from ..io.frozen import Frozen
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.drive import Drive
from ..robot.robot import LEGS, Robot
from .least_squares import departure
from .parameters import rotor_regressor

DRIVE_TERMS = {"reflected_mass": "kg", "coulomb": "N", "offset": "N", "viscous": "N s/m"}
"""Terms that can be sought, in this order, and their units."""

# A column of which others leave less than this share of its length is a combination of these.
_SAME = 1e-7
# Columns with at least this share in such a combination are named.
_NAMED = 0.05
# Deviations of a rate from 0 beyond which its sign is sure.
_SURE = 4.0


@dataclass(frozen=True, eq=False)
class DriveIdentificationResult(Frozen):
    """Terms of the drives identified from forces of the motors.

    The motor's force is that of the bodies and reflected_mass L_ddot + coulomb sgn(L_dot) + offset +
    viscous L_dot for each leg. Where the robot has a drive, its lead gives what else a rotor does.

    Attributes
    ----------
    names : tuple
        Of the terms with the number of the leg, ``coulomb3``; without it where legs share them.
    units : tuple
        Of each.
    values : ndarray
        (n,); NaN where the motion does not tell.
    covariance : ndarray
        (n, n), as that of ``IdentificationResult``; inf on its diagonal where the motion does not tell.
    identifiable : ndarray of bool
        Which terms the motion tells apart from all else, (n,).
    unidentifiable : tuple
        A line for each other one: which terms and parameters do the same.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    values: Array
    covariance: Array
    identifiable: Flags
    unidentifiable: tuple[str, ...]

    @property
    def std(self) -> Array:
        """Standard deviation of each value, (n,)."""
        return np.sqrt(np.diagonal(self.covariance))

    def compare_with(self, given: Array) -> tuple[Array, float]:
        """How far the values are from given ones, as ``IdentificationResult.departure`` of the bodies.

        Parameters
        ----------
        given : ndarray
            Of each term, (n,); NaN where there is none to compare with.

        Returns
        -------
        off : ndarray
            Differences in standard deviations, (n,); 0 where nothing is compared.
        p : float
            The p-value of all; NaN where nothing is compared.
        """
        compared = self.identifiable & np.isfinite(given) & np.isfinite(self.std)
        off, p = np.zeros(len(self.values)), math.nan
        if compared.any():
            spread = self.covariance[np.ix_(compared, compared)]
            off[compared], p = departure((self.values - given)[compared], spread)
        return off, p


class Terms(NamedTuple):
    """Terms sought: names, units, forces of each, N, (..., 6, n); which are identifiable, and why not.

    sought: as ``drive_terms`` was given them, with ``shared``.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    columns: Array
    identifiable: Flags
    sought: tuple[str, ...]
    shared: bool
    confused: tuple[str, ...] = ()

    @property
    def of_rotors(self) -> bool:
        """Whether the rotors are among them."""
        return any(name.startswith("reflected_mass") for name in self.names)

    def along(self, robot: Robot, motion: Motion) -> Array:
        """Forces of those that are identifiable, (..., 6, m), along a motion near that of the columns.

        A leg turns back where it does in the latter: friction does not step to and fro while a fit looks for
        the motion.
        """
        there = drive_terms(robot, motion, self.sought, self.shared).columns
        steady = [name.startswith(("coulomb", "offset")) for name in self.names]
        return np.asarray(np.where(steady, self.columns, there)[..., self.identifiable])

    def by_leg(self, name: str, values: Array) -> Array:
        """Numbers of a term by leg, (6,), of the values, (m,), of identifiable ones; 0 of all others."""
        found = np.zeros(len(self.names))
        found[self.identifiable] = values
        own = [each.startswith(name) for each in self.names]
        return np.broadcast_to(found[own] if any(own) else 0.0, LEGS)

    def estimate(self, values: Array, covariance: Array) -> DriveIdentificationResult:
        """The estimate by values, (m,), and covariance, (m, m), of the identifiable terms."""
        found, spread = np.full(len(self.names), np.nan), np.diag(np.full(len(self.names), np.inf))
        found[self.identifiable] = values
        spread[np.ix_(self.identifiable, self.identifiable)] = covariance
        return DriveIdentificationResult(
            self.names, self.units, found, spread, self.identifiable, self.confused
        )


def need_terms(drive: object, where: str = "drive_terms") -> tuple[str, ...]:
    """Names of terms in the order of ``DRIVE_TERMS``, each once; ValueError for what is none."""
    expected = f"some of {', '.join(DRIVE_TERMS)}"
    if isinstance(drive, str) or not isinstance(drive, Sequence) or not drive:
        raise ValueError(f"{where}: expected {expected}, got {shown(drive)}")
    for name in drive:
        if not isinstance(name, str) or name not in DRIVE_TERMS:
            raise ValueError(f"{where}: expected {expected}, got {shown(name)}")
    return tuple(name for name in DRIVE_TERMS if name in drive)


def drive_terms(robot: Robot, motion: Motion, drive: Sequence[str], shared: bool) -> Terms:
    """Forces of the terms along a motion; ``shared``: all legs have the same."""
    legs = inverse_kinematics(robot, motion)
    within = np.zeros(LEGS) if robot.drive is None else np.asarray(robot.drive.regularization_speed)
    factors = {
        "reflected_mass": legs.L_ddot,
        "coulomb": smooth_sign(legs.L_dot, within),
        "offset": np.ones_like(legs.L_dot),
        "viscous": legs.L_dot,
    }
    names, units, columns = [], [], []
    for name in need_terms(drive):
        each = np.asarray(factors[name])[..., None] * np.eye(LEGS)
        if name == "reflected_mass" and robot.drive is not None:
            each = rotor_forces(robot, motion, robot.drive)
        of_leg = each.sum(axis=-1, keepdims=True) if shared else each
        columns.append(of_leg)
        names += [name] if shared else [f"{name}{leg}" for leg in range(1, LEGS + 1)]
        units += [DRIVE_TERMS[name]] * of_leg.shape[-1]
    stacked = np.concatenate(columns, axis=-1)
    every = np.ones(len(names), dtype=np.bool_)
    return Terms(tuple(names), tuple(units), stacked, every, need_terms(drive), shared)


def turning_legs(robot: Robot, motion: Motion, rates: Array) -> Flags:
    """Instants and legs, (n, 6), that may move either way; rates: deviations of those of the pose, (n, 6)."""
    H = inverse_dynamics(robot, motion).H
    deviation = np.linalg.norm(H * rates[:, :, None], axis=1)
    return np.asarray(np.abs(inverse_kinematics(robot, motion).L_dot) < _SURE * deviation)


def seen_by_motors(robot: Robot) -> Robot:
    """The robot as forces of its motors show it: viscous friction of its drives is in that of its joints."""
    if robot.drive is None or not np.any(viscous(robot.drive)):
        return robot
    none = np.zeros(LEGS)
    bare = dataclasses.replace(robot.drive, screw_viscous=none, motor_viscous=none)
    return dataclasses.replace(robot, C_p=robot.C_p + viscous(robot.drive), drive=bare)


def terms_of(robot: Robot, names: Sequence[str]) -> Array:
    """Return terms of a robot's drives by name, (n,), NaN for a shared term that differs between legs.

    Names are those of ``DriveIdentificationResult``.
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
    """Forces of rotors of 1 kg of reflected mass each, moments on the legs included, (..., 6, 6)."""
    Y = rotor_regressor(robot, motion)
    H = inverse_dynamics(robot, motion).H
    return np.asarray(np.linalg.solve(H, Y[..., :LEGS] + Y[..., LEGS:] / drive.transmission_ratio))


def told_apart(terms: Terms, A: Array, names: Sequence[str]) -> Terms:
    """The terms with what the motion tells of them.

    A: forces of the base parameters, (..., 6, rank); names: of these. A term is identifiable unless base
    parameters and the terms before it do the same along the motion.
    """
    known, found, confused = list(names), [], []
    span = _unit(A.reshape(-1, A.shape[-1]))
    columns = _unit(terms.columns.reshape(-1, len(terms.names)))
    Q = np.linalg.qr(span)[0]
    for i, name in enumerate(terms.names):
        rest = columns[:, i] - Q @ (Q.T @ columns[:, i])
        if np.linalg.norm(rest) > _SAME:
            rest = _unit((rest - Q @ (Q.T @ rest))[:, None])
            Q, span, known = np.hstack([Q, rest]), np.column_stack([span, columns[:, i]]), [*known, name]
            found.append(True)
            continue
        shares, *_ = np.linalg.lstsq(span, columns[:, i], rcond=None)
        large = np.flatnonzero(np.abs(shares) > _NAMED * np.abs(shares).max(initial=0.0))
        same = ", ".join(known[k] for k in large[np.argsort(-np.abs(shares[large]), kind="stable")][:4])
        confused.append(f"{name}: not identifiable along this motion, acts as {same or 'nothing'}")
        found.append(False)
    return terms._replace(identifiable=np.array(found, dtype=np.bool_), confused=tuple(confused))


def _unit(columns: Array) -> Array:
    lengths = np.linalg.norm(columns, axis=0)
    return np.asarray(columns / np.where(lengths > 0.0, lengths, 1.0))
