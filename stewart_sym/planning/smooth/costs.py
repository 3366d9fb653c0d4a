"""Costs of a motion along a path, energy or peak force, with derivatives with respect to the rate spline."""

from dataclasses import dataclass

import numpy as np

from ...drives.friction import constant_part, load_share, viscous
from ...io.array_types import Array
from ...robot.robot import LEGS
from ..timing.motor_terms import MotorTerms
from ..timing.path_terms import Terms
from .rate_spline import WEIGHTS, in_cells

# Relative load of a leg below which the kink of its torque at a change of the efficiency is smoothed.
_ROUNDED = 1e-2


@dataclass(frozen=True, eq=False)
class EnergyCost:
    """Electrical energy (J) as in ``drive_effort``: work at the motor shafts plus heat of the windings.

    The motor force G (motor torque times transmission ratio) is positive in the direction of motion. The
    energy is the time integral of |L_dot| G + heat G^2. ``axial`` and ``rotor`` contain the coefficients of
    the axial forces and rotor forces, with the same sign convention, for (x'', y, sqrt(y), 1).
    """

    axial: Array
    rotor: Array
    rate: Array
    mean: Array
    half: Array
    dry: Array
    damping: Array
    heat: Array
    rounded: Array

    @classmethod
    def of(cls, motors: MotorTerms) -> "EnergyCost":
        """Create the cost from terms at the ends of all parts of cells, without the Stribeck force."""
        drive, side = motors.drive, np.sign(motors.rate)
        rotor = np.concatenate([motors.rotor, np.zeros_like(motors.rotor)])
        axial = side * (motors.force - rotor)
        one = np.ones(LEGS)
        p, q = 1.0 + load_share(drive, one, one), 1.0 - load_share(drive, -one, one)
        known = drive.torque_constant > 0.0
        per_force = drive.transmission_ratio * np.where(known, drive.torque_constant, np.inf)
        still = np.full(LEGS, np.inf)
        return cls(
            axial=np.stack([in_cells(x) for x in axial]),
            rotor=np.stack([in_cells(x) for x in side * rotor]),
            rate=in_cells(np.abs(motors.rate)),
            mean=0.5 * (p + q),
            half=0.5 * (p - q),
            dry=constant_part(drive, still),
            damping=in_cells(viscous(drive) * np.abs(motors.rate)),
            heat=drive.resistance / per_force**2,
            rounded=_ROUNDED * np.abs(axial[3]).mean(axis=0) + np.finfo(np.float64).tiny,
        )

    def __call__(self, v: Array) -> tuple[float, Array, Array]:
        """Compute the energy, its gradient, and a positive semidefinite Hessian by y, y', and y''."""
        y, y_1 = v[..., 0, None], v[..., 1, None]
        root = np.sqrt(y)
        a, b, d, e = self.axial
        F = 0.5 * a * y_1 + b * y + d * root + e
        size = np.sqrt(F * F + self.rounded**2)
        slope = self.mean + self.half * F / size
        r_a, r_b = self.rotor[:2]
        G = 0.5 * r_a * y_1 + r_b * y + self.mean * F + self.half * size + self.dry + self.damping * root
        F_v = np.stack([b + 0.5 * d / root, 0.5 * a], axis=-1)
        G_v = slope[..., None] * F_v + np.stack([r_b + 0.5 * self.damping / root, 0.5 * r_a], axis=-1)
        weight = (WEIGHTS / len(v))[:, None]
        heat, work = weight * self.heat, weight * self.rate
        value = float(np.sum(work * G + heat * G**2 / root))
        by, twice = np.zeros_like(v), np.zeros((*v.shape, 3))
        push = work + 2.0 * heat * G / root
        by[..., :2] = np.einsum("ikl,ikla->ika", push, G_v)
        by[..., 0] -= 0.5 * np.sum(heat * G**2, axis=-1) / y[..., 0] ** 1.5
        kink = np.maximum(push, 0.0) * self.half * self.rounded**2 / size**3
        twice[..., :2, :2] = np.einsum("ikl,ikla,iklb->ikab", kink, F_v, F_v)
        twice[..., :2, :2] += np.einsum("ikl,ikla,iklb->ikab", 2.0 * heat / root, G_v, G_v)
        mixed = -np.einsum("ikl,ikla->ika", heat * G / y**1.5, G_v)
        twice[..., :2, 0] += mixed
        twice[..., 0, :2] += mixed
        twice[..., 0, 0] += 0.75 * np.sum(heat * G**2, axis=-1) / y[..., 0] ** 2.5
        return value, by, twice


# Weight of the distance to the usual motion, relative to the error of the smooth maximum.
_USUAL = 1.0


@dataclass(frozen=True, eq=False)
class PeakCost:
    """Smooth approximation of the peak force (N): log(mean of exp(sharpness force)) / sharpness.

    The approximation improves with the sharpness. A small multiple of the mean of y / usual + usual / y
    selects, among motions with the same peak, one close to a usual motion, which does not stop.

    Attributes
    ----------
    form : ndarray, shape (4, cells, 5, 6)
        Coefficients of the forces (N) for (x'', y, sqrt(y), 1).
    sharpness : float
        Sharpness (1/N).
    usual : ndarray, shape (cells, 5)
        Values y of the usual motion.
    """

    form: Array
    sharpness: float
    usual: Array

    @classmethod
    def of(cls, terms: Terms, usual: Array, v: Array, sharpness: float) -> "PeakCost":
        """Create the cost from terms at the ends of all parts of cells, and from two motions.

        The motions are y with derivatives. ``usual`` is the usual motion; ``sharpness`` is relative to the
        peak force of the motion ``v``.
        """
        form = np.stack([in_cells(x[:, :LEGS]) for x in (terms.a, terms.b, terms.d, terms.e)])
        return cls(form, sharpness / float(np.abs(_forces(form, v)).max()), usual[..., 0])

    def __call__(self, v: Array) -> tuple[float, Array, Array]:
        """Compute the cost, its gradient, and a positive semidefinite Hessian by y, y', and y''."""
        a, b, d, _ = self.form
        y, F = v[..., 0, None], _forces(self.form, v)
        side, size, sharpness = np.sign(F), np.abs(F), self.sharpness
        largest = float(size.max())
        each = np.exp(sharpness * (size - largest))
        share = each / each.sum()
        slope = side[..., None] * np.stack([b + 0.5 * d / np.sqrt(y), 0.5 * a], axis=-1)
        by, twice = np.zeros_like(v), np.zeros((*v.shape, 3))
        by[..., :2] = np.einsum("ikl,ikla->ika", share, slope)
        twice[..., :2, :2] = np.einsum("ikl,ikla,iklb->ikab", sharpness * share, slope, slope)
        twice[..., 0, 0] += np.sum(share * np.maximum(-0.25 * side * d * y**-1.5, 0.0), axis=-1)
        weight, ratio = _USUAL / sharpness / self.usual.size, v[..., 0] / self.usual
        by[..., 0] += weight * (1.0 - ratio**-2) / self.usual
        twice[..., 0, 0] += weight * 2.0 * ratio**-3 / self.usual**2
        apart = weight * float(np.sum(ratio + 1.0 / ratio - 2.0))
        return apart + largest + float(np.log(each.mean())) / sharpness, by, twice


def _forces(form: Array, v: Array) -> Array:
    """Compute the leg forces at the samples (N), shape (cells, 5, 6)."""
    a, b, d, e = form
    y, y_1 = v[..., 0, None], v[..., 1, None]
    return np.asarray(0.5 * a * y_1 + b * y + d * np.sqrt(y) + e)
