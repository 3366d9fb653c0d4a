"""Selection of test motions on which an incorrect constant changes a force by more than the bound of that
force.

The search starts with a pool of motions in which only a few terms act: poses at rest, free fall, large loads,
and extreme velocities or accelerations along one or two axes. The search adds variations of the motions that
are most sensitive to the weakest constants. It then selects a few motions that together reveal every
constant. In most motions an external wrench carries the platform, so that the actuator forces, and thus their
rounding errors, are small. Random numbers have a fixed seed and few digits, so that equal robots have equal
motions on all platforms.
"""

import itertools
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import MOTION
from ..derive.mechanics.actuator_forces import ForceKernel
from ..drives.friction import drive_numbers
from ..dynamics.sample_poses import MAX_CONDITION, WHOLE, rounded, sample, significant, size_of, whole_turn
from ..io.array_types import Array
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import inverse_kinematics, wrench_matrix
from ..motion.motion import Motion
from ..robot.robot import Robot, of_symbol
from .interpreter import NEAR_JOINT_SINGULAR
from .kit_options import PRECISIONS
from .parts import fields, folded_kernel
from .running import FORCES_MARGIN
from .sensitivity import Change, Forces, changes

Arrays = dict[str, Array]

SHARE = {"double": 1e-9, "float": 1e-3}
"""Relative change of a constant."""

SHOWN = 1.5
"""Smallest change of a force, in bounds of that force, that reveals a change of a constant.

The rounding errors of the code may be half a bound; measured errors are at most a tenth of a bound.
"""

_AT_REST, _MOVING = 300, 30
"""Number of poses of the pool at rest and in motion."""
_NEAR = 12
_NEAR_MOTIONS = 3
_GENERATIONS, _CHILDREN = 6, 8
_ENOUGH, _HOPELESS = 4.0, 0.02
_RATES = ("omega", "v", "alpha", "a")
# A sine near the threshold may round to either side of it. Below the smallest sine the joint is degenerate.
_CLEAR, _BESIDE, _LEAST = 1.05, 0.95, 8192.0
_SHIFTS = (0.0, 0.002, 0.02, 0.3)
_SINES = (0.006, 0.009, 0.012, 0.0145)
_SEED = 1998


@dataclass(frozen=True)
class Selection:
    """Motions that reveal every detectable constant, some of them near a joint singularity.

    Attributes
    ----------
    motions : tuple of dict of str to ndarray
        Flat arrays by name, numbers of the precision.
    hidden : tuple of str
        Names of constants whose change remains within the bounds of all forces for all examined motions.
    """

    motions: tuple[Arrays, ...]
    hidden: tuple[str, ...]


@dataclass(frozen=True)
class Numbered:
    """Robot that is equal to every robot with equal constants, regardless of its name."""

    robot: Robot = field(compare=False)
    numbers: tuple[bytes, ...]
    base_joint: str

    @classmethod
    def of(cls, robot: Robot) -> Self:
        """Create the record from the constants of a robot, including its limits."""
        names = (*fields(robot.has_rotors), "length_limits")
        numbers = [np.asarray(of_symbol(robot, name)) for name in names]
        numbers += [] if robot.drive is None else [*drive_numbers(robot.drive).values()]
        return cls(robot, tuple(each.tobytes() for each in numbers), robot.base_joint)


@lru_cache(maxsize=64)
def selection(numbered: Numbered, formulation: str, fidelity: str, precision: str) -> Selection:
    """Select the motions for the tests of the force kernel of a robot, in addition to ordinary motions.

    The motions reveal the constants of the baked kernel, whether a kit contains baked constants or prepares
    them. ``fidelity`` is an available level. Raises ValueError for a robot without a suitable pose.
    """
    robot = numbered.robot
    kernel = folded_kernel(robot, formulation, fidelity)
    search = _Search(robot, kernel, precision, sample(robot, formulation))
    ratios, motions = search.shown(near=False)
    hidden = _hidden(ratios)
    chosen = [_flat(motions, i) for i in _cover(ratios)]
    if kernel.leg_near_singular is not None:
        ratios, motions = search.shown(near=True)
        beside = {name: row for name, row in ratios.items() if name in hidden}
        needed, good = _cover(beside), _cover(ratios)
        chosen += [_flat(motions, i) for i in dict.fromkeys([*needed, *good[:_NEAR_MOTIONS]])]
        hidden &= _hidden(ratios)
    return Selection(tuple(chosen), tuple(name for name in ratios if name in hidden))


def _hidden(ratios: Mapping[str, Array]) -> set[str]:
    """Return the constants that no motion reveals."""
    best = _coarse(ratios).max(axis=1, initial=0.0)
    return {name for name, ratio in zip(ratios, best, strict=True) if ratio < SHOWN}


def _cover(ratios: Mapping[str, Array]) -> list[int]:
    """Select motions that together reveal each detectable constant; the most sensitive motion is first."""
    rows = _coarse(ratios)
    best = rows.max(axis=1, initial=0.0)
    shows = rows >= np.clip(0.8 * best, SHOWN, _ENOUGH)[:, None]
    open_ = best >= SHOWN
    chosen: list[int] = []
    while open_.any():
        chosen.append(int(np.argmax(shows[open_].sum(axis=0))))
        open_ &= ~shows[:, chosen[-1]]
    return chosen


def _coarse(ratios: Mapping[str, Array]) -> Array:
    """Truncate numbers to six bits, so that their rounding errors do not change the selection."""
    rows = np.array(list(ratios.values())).reshape(len(ratios), -1 if ratios else 0)
    fraction, exponent = np.frexp(rows)
    return np.asarray(np.ldexp(np.floor(64.0 * fraction), exponent - 6))


def _flat(pool: Arrays, i: int) -> Arrays:
    return {name: pool[name][i].ravel() for name in MOTION}


@dataclass(frozen=True, eq=False)
class _Search:
    """Search for the kernel of one robot; ``first`` is the motion of the example."""

    robot: Robot
    kernel: ForceKernel
    precision: str
    first: Motion

    def shown(self, near: bool) -> tuple[dict[str, Array], Arrays]:
        """Compute the sensitivity to each constant (bounds) by name, and the motions, shape (n,)."""
        draw = np.random.RandomState(_SEED)
        pool, forces = self._sound(self._pool(draw, near), near)
        ratios = self._ratios(forces, near)
        for _ in range(0 if near else _GENERATIONS):
            # Constants that are barely revealed, but may be revealed by a variation.
            weak = {name: row for name, row in ratios.items() if _HOPELESS < row.max(initial=0.0) < _ENOUGH}
            if not weak:
                break
            parents = np.unique(np.argmax(_coarse(weak), axis=1))
            children, forces = self._sound(self._children(draw, pool, parents), near)
            pool = {name: np.concatenate([pool[name], children[name]]) for name in pool}
            # The other constants are already revealed by earlier motions.
            new = dict.fromkeys(ratios, np.zeros(len(children["t"]))) | self._ratios(forces, near, weak)
            ratios = {name: np.concatenate([row, new[name]]) for name, row in ratios.items()}
        return ratios, pool

    # ------------------------------------------------------------ sensitivities

    def _ratios(self, forces: Forces, near: bool, only: Container[str] | None = None) -> dict[str, Array]:
        """Compute the largest ratio of force change to bound for each (or some) constant, shape (n,)."""
        tolerance = FORCES_MARGIN * forces.bound * float(np.finfo(PRECISIONS[self.precision]).eps)
        # Near a joint singularity, bounds may be so large that incorrect results pass.
        wide = tolerance.max(axis=-1) > SHARE[self.precision] * np.abs(forces.F).max(axis=-1)
        counted = ~wide if near else np.ones_like(wide)
        found: dict[str, Array] = {}
        for change in self._changes:
            if only is not None and not any(name in only for name in change.names):
                continue
            with np.errstate(all="ignore"):
                moved = np.nan_to_num((forces.moved(change) / tolerance).max(axis=-1), posinf=0.0) * counted
            found |= {name: row for name, row in zip(change.names, moved, strict=True) if name}
        return found

    def _forces(self, pool: Arrays, near: bool) -> Forces:
        return Forces(self.kernel, {name: np.moveaxis(pool[name], 0, -1) for name in MOTION}, near)

    @cached_property
    def _changes(self) -> list[Change]:
        return list(changes(self.kernel, SHARE[self.precision]))

    # ------------------------------------------------------------ motions

    def _sound(self, pool: Arrays, near: bool) -> tuple[Arrays, Forces]:
        """Select well-conditioned motions, apply the compensating loads, and compute the forces."""
        kind = PRECISIONS[self.precision]
        pool = {name: rounded(value, kind) for name, value in pool.items()}
        good = np.all([np.isfinite(pool[name].reshape(len(pool["t"]), -1)).all(axis=1) for name in MOTION], 0)
        pool = _some(pool, good)
        motion = Motion._unchecked(**{name: pool[name] for name in MOTION})
        legs = inverse_kinematics(self.robot, motion)
        with np.errstate(all="ignore"):
            H = wrench_matrix(self.robot, motion)
        solves = scaled_condition_number(H, characteristic_length(self.robot)) <= MAX_CONDITION
        if self.robot.base_joint == "universal":
            k = self.robot.k / np.linalg.norm(self.robot.k, axis=1)[:, None]
            sines = np.linalg.norm(np.cross(k, legs.s), axis=-1).min(axis=-1)
            least = _LEAST * np.finfo(kind).eps
            solves &= (
                (sines > least) & (sines < _BESIDE * NEAR_JOINT_SINGULAR)
                if near
                else sines > _CLEAR * NEAR_JOINT_SINGULAR
            )
        pool = _some(pool, solves)
        return self._unloaded(pool, near)

    def _unloaded(self, pool: Arrays, near: bool) -> tuple[Arrays, Forces]:
        """Add external wrenches of four digits that carry the platform to the motions that request them."""
        kind = PRECISIONS[self.precision]
        load = self._forces(pool, near).load
        wrench = {"F_ext": load[:, :3], "M_ext": load[:, 3:]}
        off = pool["unloaded"] > 0
        without = {
            name: pool[name] - significant(np.einsum("mji,mj->mi", pool["R"], value), 4) * off[:, None]
            for name, value in wrench.items()
        }
        pool = pool | {name: rounded(value, kind) for name, value in without.items()}
        forces = self._forces(pool, near)
        finite = np.isfinite(forces.bound).all(axis=1) & np.isfinite(load).all(axis=1)
        if finite.all():
            return pool, forces
        pool = _some(pool, finite)
        return pool, self._forces(pool, near)

    def _pool(self, draw: Any, near: bool) -> Arrays:
        still, moving = self._kinds()
        groups = [(_NEAR, [*still, *moving])] if near else [(_AT_REST, still), (_MOVING, moving)]
        rows: dict[str, list[Any]] = {name: [] for name in (*MOTION, "unloaded")}
        for count, kinds in groups:
            for (R, t), kind in itertools.product(list(self._places(draw, count, near)), kinds):
                given = {"R": R, "t": t} | kind
                for name, row in rows.items():
                    row.append(given.get(name, 1.0 if name == "unloaded" else np.zeros(3)))
        return {name: np.array(row) + 0.0 for name, row in rows.items()}

    def _kinds(self) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
        """Return accelerations and loads at rest or in free fall, and rates in motion (SI, three digits)."""
        size, g = self._size, self.robot.g
        pace = float(significant(np.sqrt(np.linalg.norm(g) / size), 2)) or 1.0
        weight = float(significant(self.robot.M * pace**2 * size, 2)) or 1.0
        loads = itertools.product((("F_ext", 1.0), ("M_ext", size)), np.eye(3))
        still: list[dict[str, Any]] = [{}, {"a": g}]
        still += [{name: 1e3 * weight * arm * axis, "unloaded": 0.0} for (name, arm), axis in loads]
        moving: list[dict[str, Any]] = []
        for axis in range(6):
            pairs = [(axis,), *((axis, other) for other in range(axis))]
            slow = itertools.product((0.6, 1.5), ({}, {"a": g}))
            moving.append(_along(("alpha", "a"), 1e4 * pace**2, size, axis))
            moving += [_along(("omega", "v"), 1e3 * pace, size, *pair) for pair in pairs]
            moving += [_along(("omega", "v"), share * pace, size, axis) | fall for share, fall in slow]
        return still, moving

    @property
    def _size(self) -> float:
        return size_of(self.robot)

    def _places(self, draw: Any, count: int, near: bool) -> Iterator[tuple[Array, Array]]:
        """Yield rotations, and positions near the example or with a leg near the fixed axis of its joint."""
        center = self.robot.p.mean(axis=0)
        for _ in range(count):
            turn, over = whole_turn(int(draw.randint(3, 31)), *map(int, draw.randint(-4, 5, 3)))
            R = (turn @ np.rint(self.first.R * WHOLE)) / (over * WHOLE)
            if not near:
                t = self.first.t + (self.first.R - R) @ center + self._size * draw.randint(-16, 17, 3) / 20.0
                yield R, significant(t, 6)
                continue
            leg, end = int(draw.randint(6)), 2.0 * draw.randint(2) - 1.0
            k = end * self.robot.k[leg] / np.linalg.norm(self.robot.k[leg])
            across = np.cross(k, draw.randint(-50, 51, 3) + np.array([0.1, 0.2, 0.3]))
            s = k + _SINES[draw.randint(len(_SINES))] * across / np.linalg.norm(across)
            away = self._size * draw.randint(6, 30) / 10.0 * s
            yield R, significant(self.robot.b[leg] + away - R @ self.robot.p[leg], 12)

    def _children(self, draw: Any, pool: Arrays, parents: NDArray[np.int64]) -> Arrays:
        """Generate variations of motions: scale, change, or omit rates, and shift the position."""
        made = {name: np.repeat(value[parents], _CHILDREN, axis=0) for name, value in pool.items()}
        count = len(made["t"])
        for name in _RATES:
            what = draw.randint(4, size=(count, 1))
            factor, shares = draw.random_sample((count, 1)), draw.random_sample((count, 3))
            scale = np.select(
                [what == 0, what == 1, what == 2],
                [0.2 + 4.0 * factor**2, 0.6 + 0.8 * shares, shares < 0.7],
                1.0,
            )
            made[name] = significant(made[name] * scale, 3) + 0.0
        reach = np.array(_SHIFTS)[draw.randint(len(_SHIFTS), size=(count, 1))]
        shift = reach * (draw.random_sample((count, 3)) - 0.5)
        made["t"] = significant(made["t"] + self._size * shift, 12)
        off = made["unloaded"] > 0
        for name in ("F_ext", "M_ext"):
            made[name] = np.where(off[:, None], 0.0, made[name])
        return made


def _along(names: tuple[str, str], amount: float, size: float, *axes: int) -> dict[str, Any]:
    """Return rates about the first three axes, and rates times the machine size along the others."""
    turn, shift = (np.isin(np.arange(first, first + 3), axes) for first in (0, 3))
    return {names[0]: significant(amount * turn, 3), names[1]: significant(amount * size * shift, 3)}


def _some(pool: Arrays, which: Any) -> Arrays:
    return {name: value[which] for name, value in pool.items()}
