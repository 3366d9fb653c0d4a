"""Test motions of a kit's forces on which a wrong constant shows: it moves a force by more than its bound.

The search begins with a pool of motions in which few terms act at a time: poses at rest, falling platforms,
large loads, velocities or accelerations along one or two axes far beyond those of a machine. It adds
variations of the motions that show the weakest constants best, and then takes a few motions that together
show every constant. In most motions an external wrench holds the platform, so that the actuator forces, and
with them their rounding errors, are small. Numbers come from a generator with a fixed seed and have few
digits: the same robot gets the same motions everywhere.
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
"""By which share of itself a constant is changed."""

SHOWN = 1.5
"""A constant shows where its change moves a force by this many bounds. The code's own rounding errors may be
half a bound, and are a tenth of one at most wherever they were measured."""

_AT_REST, _MOVING = 300, 30
"""Poses of the pool at rest and in motion."""
_NEAR = 12
_NEAR_MOTIONS = 3
_GENERATIONS, _CHILDREN = 6, 8
_ENOUGH, _HOPELESS = 4.0, 0.02
_RATES = ("omega", "v", "alpha", "a")
# A sine near the threshold may fall on either side of it, by rounding; below the last one it is degenerate.
_CLEAR, _BESIDE, _LEAST = 1.05, 0.95, 8192.0
_SHIFTS = (0.0, 0.002, 0.02, 0.3)
_SINES = (0.006, 0.009, 0.012, 0.0145)
_SEED = 1998


@dataclass(frozen=True)
class Selection:
    """Motions that show every constant that shows at all, some of them near a joint singularity.

    motions: arrays by name, flat, numbers of the precision. hidden: names of constants of which a change
    stays within the bounds of all forces on all motions tried.
    """

    motions: tuple[Arrays, ...]
    hidden: tuple[str, ...]


@dataclass(frozen=True)
class Numbered:
    """A robot that is equal to others of the same numbers, whatever their names."""

    robot: Robot = field(compare=False)
    numbers: tuple[bytes, ...]
    base_joint: str

    @classmethod
    def of(cls, robot: Robot) -> Self:
        """The robot by its numbers, limits among them."""
        names = (*fields(robot.has_rotors), "length_limits")
        numbers = [np.asarray(of_symbol(robot, name)) for name in names]
        numbers += [] if robot.drive is None else [*drive_numbers(robot.drive).values()]
        return cls(robot, tuple(each.tobytes() for each in numbers), robot.base_joint)


@lru_cache(maxsize=64)
def selection(numbered: Numbered, formulation: str, fidelity: str, precision: str) -> Selection:
    """The motions on which a kernel of a robot's forces is tested, besides ordinary ones.

    They show the constants of the kernel with the robot's numbers folded in, whether a kit's code has them or
    prepares its own. fidelity: a level that there is. Raises ValueError for a robot without a good pose.
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
    """Constants that no motion shows."""
    best = _coarse(ratios).max(axis=1, initial=0.0)
    return {name for name, ratio in zip(ratios, best, strict=True) if ratio < SHOWN}


def _cover(ratios: Mapping[str, Array]) -> list[int]:
    """Motions, the one that shows most first, that together show each constant that shows at all."""
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
    """Rows of numbers cut to six bits: rounding of them changes no choice."""
    rows = np.array(list(ratios.values())).reshape(len(ratios), -1 if ratios else 0)
    fraction, exponent = np.frexp(rows)
    return np.asarray(np.ldexp(np.floor(64.0 * fraction), exponent - 6))


def _flat(pool: Arrays, i: int) -> Arrays:
    return {name: pool[name][i].ravel() for name in MOTION}


@dataclass(frozen=True, eq=False)
class _Search:
    """The search for one kernel of one robot; first: the example's motion."""

    robot: Robot
    kernel: ForceKernel
    precision: str
    first: Motion

    def shown(self, near: bool) -> tuple[dict[str, Array], Arrays]:
        """How far each constant shows, bounds by name, and on which motions (n,)."""
        draw = np.random.RandomState(_SEED)
        pool, forces = self._sound(self._pool(draw, near), near)
        ratios = self._ratios(forces, near)
        for _ in range(0 if near else _GENERATIONS):
            # Those that hardly show, but may.
            weak = {name: row for name, row in ratios.items() if _HOPELESS < row.max(initial=0.0) < _ENOUGH}
            if not weak:
                break
            parents = np.unique(np.argmax(_coarse(weak), axis=1))
            children, forces = self._sound(self._children(draw, pool, parents), near)
            pool = {name: np.concatenate([pool[name], children[name]]) for name in pool}
            # Elsewhere it is enough to know that the others show.
            new = dict.fromkeys(ratios, np.zeros(len(children["t"]))) | self._ratios(forces, near, weak)
            ratios = {name: np.concatenate([row, new[name]]) for name, row in ratios.items()}
        return ratios, pool

    # ------------------------------------------------------------ what shows

    def _ratios(self, forces: Forces, near: bool, only: Container[str] | None = None) -> dict[str, Array]:
        """Of each constant, or only some, the largest change of a force over its bound (n,)."""
        tolerance = FORCES_MARGIN * forces.bound * float(np.finfo(PRECISIONS[self.precision]).eps)
        # Beside a joint singularity bounds may be so wide that wrong answers pass.
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
        """Those in the precision that solve well, the load taken off where they ask for it; their forces."""
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
        """The pool with external wrenches, of four digits, that hold the platform, where they are wanted."""
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
        """What a platform may do at rest or falling, and in motion; SI units, of three digits."""
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
        """Turns, and positions about the example's; near: with a leg near the fixed axis of its joint."""
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
        """Motions beside others: rates scaled, changed or left out, the place shifted."""
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
    """Rates of that amount about the first three axes, times the machine's size along the other three."""
    turn, shift = (np.isin(np.arange(first, first + 3), axes) for first in (0, 3))
    return {names[0]: significant(amount * turn, 3), names[1]: significant(amount * size * shift, 3)}


def _some(pool: Arrays, which: Any) -> Arrays:
    return {name: value[which] for name, value in pool.items()}
