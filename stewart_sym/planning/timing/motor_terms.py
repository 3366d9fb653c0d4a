"""Motor limits along a path (torque, current, and power) as bounds that are linear in s''.

The motor force (motor torque times transmission ratio) is rotor + F_t + friction. F_t = F - rotor is the
force through the screw. Because of the efficiency, the motor force in the direction of motion, that is times
L_dot / |L_dot|, is the larger one of two branches

    G = max(G_p, G_q),    slopes p = 1 / eta (motor drives the leg), q = eta' (leg drives the motor).

Each branch is linear in s'', s'^2, and s', except for the smoothed sign, the Stribeck force, and the torque
limit P / |L_dot| of a power limit. The first two are evaluated at the rates of the previous motion. The third
is replaced by its tangent there, which is never above it. The bound G <= limit is G_p <= limit and
G_q <= limit. The bound G >= -limit is G_p >= -limit or G_q >= -limit, two forms of one row. At a zero of the
rate of a leg the sign of dL/ds differs on both sides at any speed, so there are separate bounds before and
after it.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...drives.friction import (
    constant_part,
    dry_sign,
    friction_force,
    load_share,
    losses,
    smooth_sign,
    viscous,
)
from ...drives.rotors import leg_rates, product, rotors_by_acceleration
from ...io.array_types import Array, Flags, Indices
from ...motion.motion import Motion
from ...robot.drive import Drive
from ...robot.robot import LEGS, Robot

# Relative rate below which a leg may move in either direction.
_STILL = 1e-9
_SLOWER, _SLOWEST = 0.85, 1e-3


class Rows(NamedTuple):
    """Bounds low <= a s'' + b s'^2 + d s' + e <= high at n parameters, in one of two forms.

    The arrays a, b, d, and e have shape (n, r, 2), low and high have shape (n, r). The forms differ only in
    rows without an upper bound.
    """

    a: Array
    b: Array
    d: Array
    e: Array
    low: Array
    high: Array

    @classmethod
    def of_one_form(cls, parts: Sequence[Array], low: Array, high: Array) -> "Rows":
        """Create rows with equal forms from the parts a, b, d, e, shape (n, r) each."""
        a, b, d, e = (np.stack([part, part], axis=-1) for part in parts)
        return cls(a, b, d, e, low, high)

    @classmethod
    def together(cls, parts: Sequence["Rows"]) -> "Rows":
        """Concatenate rows."""
        return cls(*(np.concatenate(each, axis=1) for each in zip(*parts, strict=True)))

    def form_at(self, square: Array, second: Array) -> tuple[Array, ...]:
        """Return a, b, d, e, shape (n, r), of the larger form at s'^2 and s'', shape (n,)."""
        x, u = square[:, None, None], second[:, None, None]
        larger = np.argmax(self.a * u + self.b * x + self.d * np.sqrt(x) + self.e, axis=-1)[..., None]
        return tuple(np.take_along_axis(part, larger, axis=-1)[..., 0] for part in self[:4])


class MotorTerms(NamedTuple):
    """Coefficients of the motors at n parameters.

    Attributes
    ----------
    drive : Drive
        Drive of the robot.
    force : ndarray, shape (4, n, 6)
        Coefficients a, b, d, e of the leg forces.
    rotor : ndarray, shape (2, n, 6)
        Coefficients a, b of the rotor forces.
    rate : ndarray, shape (n, 6)
        Derivatives of the leg lengths by s.
    effort, power : ndarray, shape (6,)
        Limits of the motor force (N) and of the power (W).
    """

    drive: Drive
    force: Array
    rotor: Array
    rate: Array
    effort: Array
    power: Array

    @classmethod
    def of(cls, robot: Robot, by_parameter: Motion, force: Array, rate: Array) -> "MotorTerms":
        """Create the terms of a motion by parameter; without a drive the motor force is the leg force."""
        drive = Drive(lead=np.array(2.0 * np.pi)) if robot.drive is None else robot.drive
        by_current = np.where(drive.torque_constant > 0.0, drive.torque_constant, 1.0) * drive.current_limit
        effort = np.abs(drive.transmission_ratio) * np.minimum(drive.torque_limit, by_current)
        return cls(drive, force, rotor_terms(robot, by_parameter), rate, effort, drive.power_limit)

    def at(self, index: Indices) -> "MotorTerms":
        """Return the terms at some of the parameters."""
        parts = {name: getattr(self, name)[:, index] for name in ("force", "rotor")}
        return self._replace(**parts, rate=self.rate[index])

    @property
    def limited(self) -> bool:
        """True if a motor has a limit other than speed."""
        return bool(np.isfinite(self.effort).any() or np.isfinite(self.power).any())

    @property
    def names(self) -> list[str]:
        """Names of the limited quantities."""
        return [
            f"{what} of the motor of leg {leg + 1}" for what in ("torque", "power") for leg in range(LEGS)
        ]

    @property
    def signs(self) -> Array:
        """Signs of the leg rates, shape (n, 6); 0 for legs that may move in either direction."""
        return np.where(np.abs(self.rate) <= _STILL * np.abs(self.rate).max(), 0.0, np.sign(self.rate))

    @property
    def crossings(self) -> Array:
        """Quantities whose zeros change the rows, shape (n, k)."""
        if not losses(self.drive):
            return np.asarray(self.force[0])
        slopes = [self.rotor[0] + x * (self.force[0] - self.rotor[0]) for x in self._slopes(np.array(1.0))]
        return np.concatenate([self.rate, *slopes], axis=-1)

    def used(self, square: Array, second: Array) -> Array:
        """Compute the utilization of torque or current and of power at samples of cells, shape (c, k, 12).

        The arrays ``square`` and ``second`` are s'^2 and s'', shape (c, k), from one end of each cell to the
        other. Both ends belong to the cell: friction has the same sign as inside. A sample includes the
        points up to the next sample at which the efficiency changes or a leg reverses.
        """
        x, u = square[..., None], second[..., None]
        (a, b, d, e), (r_a, r_b), rate = (
            part.reshape(*part.shape[:-2], *square.shape, LEGS)
            for part in (self.force, self.rotor, self.rate)
        )
        rotor, speed, sides = r_a * u + r_b * x, rate * np.sqrt(x), directions(rate)
        through = a * u + b * x + d * np.sqrt(x) + e - rotor

        def effort(sides: Array, load: Array) -> Array:
            sign = dry_sign(self.drive, speed, sides)
            return np.asarray(rotor + load + friction_force(self.drive, load, speed, sign))

        found, unloaded, size = effort(sides, through), effort(sides, np.zeros_like(through)), np.abs(speed)
        torque, power = np.abs(found), np.abs(found) * size
        torque[:, :-1] = np.maximum(torque[:, :-1], _at_zeros(through, unloaded, unloaded))
        power[:, :-1] = np.maximum(power[:, :-1], _at_zeros(through, *[unloaded * size] * 2))
        if np.any(sides[:, 1:] != sides[:, :-1]):
            before = effort(np.concatenate([sides[:, :1], sides[:, :-1]], axis=1), through)
            after = effort(np.concatenate([sides[:, 1:], sides[:, -1:]], axis=1), through)
            for first, last in ((found, before), (after, found)):
                torque[:, :-1] = np.maximum(torque[:, :-1], _at_zeros(rate, first, last))
        return np.concatenate([torque / self.effort, power / self.power], axis=-1)

    def share_within_power(self, x: Array, second: Array) -> float:
        """Return a factor on s' at the nodes that satisfies the power limits; ``x`` is s'^2."""
        share = 1.0
        while (
            share > _SLOWEST
            and self.used(*(share**2 * part[None] for part in (x, second)))[..., LEGS:].max() > 1.0
        ):
            share *= _SLOWER
        return share

    def at_rest(self) -> Array:
        """Compute the utilization of the torque limits in very slow motion, shape (n, 12)."""
        F = self.force[3]
        sign = np.sign(self.rate)
        p, q = self._slopes(np.array(1.0))
        dry = constant_part(self.drive, np.zeros(LEGS))
        effort = np.maximum(np.abs(F), np.abs(np.where(F * sign > 0.0, p, q) * F + sign * dry))
        return np.concatenate([effort / self.effort, np.zeros_like(effort)], axis=-1)

    def rows(self, rate: Array, second: Array, room: Array, signs: Array) -> Rows:
        """Return the rows, linearized at s' and s'' of the previous motion, shape (n,), or 0 without one.

        Parameters
        ----------
        rate, second : ndarray, shape (n,)
            s' and s'' of the previous motion.
        room : ndarray, shape (n, 12)
            Factors of the limits.
        signs : ndarray, shape (n, 6)
            Signs of the leg rates; 0 for legs that may move in either direction.
        """
        side, size, still, dry, damping = self._friction(rate, signs)
        effort, power = self.effort * room[:, :LEGS], self.power * room[:, LEGS:]
        most, slope = _tangent(power, np.abs(self.rate), rate[:, None], still)
        branches = [self._branch(each, side, damping, dry * ~still) for each in self._slopes(size)]
        kink = self._kink(rate[:, None], side, dry, damping)
        below = kink < -np.minimum(effort, most - slope * rate[:, None])
        # If both branches rise from the kink, a limit above the kink separates two feasible intervals of s'';
        # the interval of the previous motion is used.
        opposite = branches[0][0] * branches[1][0] < 0.0
        p, q = (
            a * second[:, None] + b * rate[:, None] ** 2 + d * rate[:, None] + e for a, b, d, e in branches
        )
        lower = np.stack(
            [np.where(opposite & (p < q), *branches[::-1]), np.where(opposite & (p >= q), *branches)], axis=-1
        )
        upper = branches if self._lossy else branches[1:]
        free = opposite & ~(below & rate.any())
        # The friction of a leg that may move in either direction reduces both limits.
        effort = np.where(still, effort - dry, effort)
        rising = np.array([0.0, 0.0, 1.0, 0.0])[:, None, None] * slope
        torque = _rows(upper, lower, effort, free)
        tangents = _rows([branch + rising for branch in upper], lower - rising[..., None], most, free)
        return Rows.together([torque, tangents])

    @property
    def _lossy(self) -> bool:
        """True if the branches differ."""
        return bool(np.any(self.drive.efficiency != 1.0) or np.any(self.drive.backdrive_efficiency != 1.0))

    def _slopes(self, size: Array) -> tuple[Array, Array]:
        """Return p and q for magnitudes of the smoothed sign."""
        one = np.ones(LEGS)
        driving, driven = (load_share(self.drive, way * one, one) for way in (1.0, -1.0))
        return 1.0 + size * driving, 1.0 - size * driven

    def _friction(self, rate: Array, signs: Array) -> tuple[Array, Array, Flags, Array, Array]:
        """Return sign and smoothed magnitude of the rate, resting legs, dry friction, viscous friction."""
        still = signs == 0.0
        # If all legs rest, an eased path begins or ends, and friction is continuous there.
        still = still & ~still.all(axis=-1, keepdims=True)
        # At rest the sign is the direction in which the motion begins or ends.
        away = np.abs(self.rate * np.maximum(rate, np.finfo(np.float64).tiny)[:, None])
        smoothed = smooth_sign(away, np.asarray(self.drive.regularization_speed))
        size = np.where(still | (np.asarray(self.drive.regularization_speed) == 0.0), 1.0, smoothed)
        dry = size * constant_part(self.drive, self.rate * rate[:, None])
        side = np.where(still, 1.0, signs)
        return side, size, still, dry, viscous(self.drive) * np.abs(self.rate)

    def _branch(self, slope: Array, side: Array, damping: Array, dry: Array) -> Array:
        """Return a, b, d, e of the branch of G with one slope, shape (4, n, 6)."""
        rotor = np.concatenate([self.rotor, np.zeros_like(self.rotor)])
        found = side * (rotor + slope * (self.force - rotor))
        found[2] += damping
        found[3] += dry
        return np.asarray(found)

    def _kink(self, z: Array, side: Array, dry: Array, damping: Array) -> Array:
        """Compute G at the sign change of F_t (N), shape (n, 6); NaN if s'' does not change F_t."""
        (a, b, d, e), (r_a, r_b) = self.force, self.rotor
        with np.errstate(divide="ignore", invalid="ignore"):
            second = -((b - r_b) * z**2 + d * z + e) / (a - r_a)
            return np.asarray(side * (r_a * second + r_b * z**2) + dry + damping * z)


def directions(rate: Array) -> Array:
    """Return the signs of leg rates at samples of cells, (c, k, 6), with the inner signs at both ends.

    Legs whose rates are rounding errors everywhere have the sign 0.
    """
    size, signs = np.abs(rate), np.sign(rate)
    still = _STILL * size.max()
    for end, inner in ((0, 1), (-1, -2)):
        signs[:, end] = np.where(size[:, end] <= still, signs[:, inner], signs[:, end])
    return np.where(size.max(axis=(0, 1)) <= still, 0.0, signs)


def _at_zeros(zero: Array, first: Array, last: Array) -> Array:
    """Interpolate magnitudes at the zeros of ``zero``, (c, k, 6), between samples, (c, k - 1, 6); else 0.

    ``first`` and ``last`` are the values of each sample as the first and as the last one of two.
    """
    low, high = zero[:, :-1], zero[:, 1:]
    passes = low * high < 0.0
    share = low / np.where(passes, low - high, 1.0)
    return np.where(passes, np.abs(first[:, :-1] + share * (last[:, 1:] - first[:, :-1])), 0.0)


def beside(signs: Array) -> tuple[Array, Array]:
    """Return the signs before and after each node, shape (n, m); a sign of 0 is replaced by its neighbor."""
    padded = np.concatenate([signs[1:2], signs, signs[-2:-1]])
    before, after = (np.where(signs == 0.0, part, signs) for part in (padded[:-2], padded[2:]))
    return before, after


def _tangent(power: Array, speed: Array, rate: Array, still: Flags) -> tuple[Array, Array]:
    """Return most and slope: G <= most - slope s' is the tangent of G <= power / (speed s').

    The values are inf and 0 without a power limit.
    """
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        limit = power / (speed * rate)
        slope = limit / rate
    none = ~(np.isfinite(limit) & np.isfinite(slope)) | still
    return np.where(none, np.inf, 2.0 * limit), np.where(none, 0.0, slope)


def _rows(upper: list[Array], lower: Array, limit: Array, free: Flags) -> Rows:
    """Return upper bounds of branches, and a lower bound for one of two forms unless ``free``."""
    none = np.full_like(limit, np.inf)
    below = [Rows.of_one_form(tuple(branch), -none, limit) for branch in upper]
    a, b, d, e = lower
    return Rows.together([*below, Rows(a, b, d, e, np.where(free, -np.inf, -limit), none)])


def rotor_terms(robot: Robot, by_parameter: Motion) -> Array:
    """Compute a and b of the rotor forces, shape (2, n, 6), of a motion by parameter."""
    if not robot.has_rotors:
        return np.zeros((2, *by_parameter.shape, LEGS))
    assert by_parameter.a is not None
    assert by_parameter.alpha is not None
    alone, per = rotors_by_acceleration(robot, leg_rates(robot, by_parameter))
    twist = np.concatenate([by_parameter.v, by_parameter.omega], axis=-1)
    acceleration = np.concatenate([by_parameter.a, by_parameter.alpha], axis=-1)
    return np.stack([product(per, twist), alone + product(per, acceleration)])
