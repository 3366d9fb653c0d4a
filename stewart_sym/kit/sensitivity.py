"""How much a change of one constant moves the forces, compared with their rounding errors, on many motions.

Runs the blocks of a force kernel in double: once in ``RunningArrays`` for the error bound of each force,
then once for every constant, with that constant changed. The change of the solution of H x = c is taken to
first order. Does not use the printed code.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
import sympy as sp

from ..derive.mechanics import quantities as n
from ..derive.mechanics.actuator_forces import ForceKernel
from ..derive.mechanics.lumped_constants import ADDED
from ..derive.program.block import Block, Quantity
from ..io.array_types import Array
from .running import HALF_UNIT, RunningArrays, factor_sizes

Values = Mapping[str, Any]
Numbers = Mapping[str, Array]

LEGS = 6


@dataclass(frozen=True)
class Constants:
    """What a kernel reads besides a motion, by component name.

    leg: (6, 1). platform: scalars, or (6, 1) where each leg's change makes another platform.
    """

    leg: dict[str, Any]
    platform: dict[str, Any]


@dataclass(frozen=True)
class Change:
    """A constant changed by a share of itself.

    names: one, of a constant of the platform or of all legs together; or six, of a constant that each leg has
    for itself, changed in one leg at a time.
    """

    names: tuple[str, ...]
    constants: Constants


def _folded(kernel: ForceKernel) -> Constants:
    assert kernel.constants is not None
    leg = {q.name: _column(values) for q, values in kernel.constants.items() if len(values) > 1}
    return Constants(leg, {q.name: np.float64(value) for q, value in kernel.literals().items()})


@dataclass(frozen=True, eq=False)
class KernelConstants:
    """The constants as a kernel's code holds them: folded in, or prepared from a robot's numbers.

    robot: fields of the robot; a baked kernel reads none.
    """

    kernel: ForceKernel
    robot: Numbers

    @cached_property
    def plain(self) -> Constants:
        """The constants in double."""
        return (
            _prepared(self.kernel, _raw(self.robot))
            if self.kernel.constants is None
            else _folded(self.kernel)
        )

    @cached_property
    def rounded(self) -> Constants:
        """The same with their rounding errors: of folded ones one each, else those of the preparation."""
        if self.kernel.constants is not None:
            of_leg, of_platform = (
                {name: RunningArrays(value, 0.0, rounded=True) for name, value in of.items()}
                for of in (self.plain.leg, self.plain.platform)
            )
            return Constants(of_leg, of_platform)
        raw = _raw(self.robot)
        given = {name: RunningArrays(value) for name, value in (raw.leg | raw.platform | _first(raw)).items()}
        leg = _run(self.kernel.prepare_leg, given, RunningArrays.sqrt)
        none = RunningArrays(np.zeros((LEGS, 1)))
        added: dict[str, Any] = {}
        for name in (name for q in ADDED for name in q.names):
            of_legs = none + leg[name]
            added[name] = sum((of_legs[i, 0] for i in range(1, LEGS)), of_legs[0, 0])
        return Constants(leg, _run(self.kernel.prepare_platform, given | added, RunningArrays.sqrt))


def changes(constants: KernelConstants, share: float) -> Iterator[Change]:
    """Every constant that is not zero, of a baked kernel's code or else of the robot, changed by a share."""
    kernel, folded = constants.kernel, constants.kernel.constants is not None
    own = constants.plain if folded else _raw(constants.robot)
    for name, value in own.leg.items():
        changed = Constants({**own.leg, name: value * (1.0 + share)}, own.platform)
        if folded or np.any(value):
            yield Change(_of_legs(name, value), changed if folded else _prepared(kernel, changed, own))
    for name, value in own.platform.items():
        changed = Constants(own.leg, {**own.platform, name: value * (1.0 + share)})
        if folded or value:
            yield Change((name,), changed if folded else _prepared(kernel, changed))


def _of_legs(name: str, value: Array) -> tuple[str, ...]:
    """Names of a constant of the legs, "" where it is zero and has no share to be changed by."""
    return tuple(f"{name} of leg {i + 1}" if value[i, 0] else "" for i in range(LEGS))


def _column(values: Any) -> Array:
    return np.asarray(values, dtype=np.float64).reshape(LEGS, 1)


def _raw(robot: Numbers) -> Constants:
    """The robot's numbers by component."""
    leg = {
        name: _column([of_leg[key] for of_leg in robot[q.name]])
        for q in n.of_leg(robot)
        for name, key in zip(q.names, q.keys, strict=True)
    }
    return Constants(leg, _components_of(n.PLATFORM, robot))


def _first(raw: Constants) -> dict[str, Any]:
    """Platform point 1, from which lumped masses are measured: no constant depends on it."""
    return {name: raw.leg[own][0, 0] for name, own in zip(n.p_1.names, n.p.names, strict=True)}


def _components_of(quantities: tuple[Quantity, ...], values: Numbers) -> dict[str, Any]:
    return {name: values[q.name][key] for q in quantities for name, key in zip(q.names, q.keys, strict=True)}


def _prepared(kernel: ForceKernel, raw: Constants, others: Constants | None = None) -> Constants:
    """Prepared constants; others: the numbers of the legs that are not changed when one of them is."""
    first = _first(others or raw)
    leg = _run(kernel.prepare_leg, raw.leg | raw.platform | first)
    rest = leg if others is None else _run(kernel.prepare_leg, others.leg | others.platform | first)
    added = {name: _sum_with(leg[name], rest[name]) for q in ADDED for name in q.names}
    if others is None:
        added = {name: np.sum(np.broadcast_to(leg[name], (LEGS, 1))) for name in added}
    platform = _run(kernel.prepare_platform, raw.platform | first | added)
    return Constants({name: np.broadcast_to(value, (LEGS, 1)) for name, value in leg.items()}, platform)


def _sum_with(changed: Any, others: Any) -> Array:
    """Sums over the legs, (6, 1), with one leg's number changed in each."""
    new, old = (np.broadcast_to(each, (LEGS, 1)) for each in (changed, others))
    return np.asarray(old.sum() - old + new)


def _run(block: Block, values: Values, sqrt: Any = np.sqrt) -> dict[str, Any]:
    """What a block hands out, component by component."""
    names = [name for out in block.outputs for name in out.quantity.names]
    if sqrt is np.sqrt:
        given, function = _compiled(block)
        return dict(zip(names, function(*(values[name] for name in given)), strict=True))
    found = block.run(values, sqrt)
    return dict(
        zip(names, (value for out in block.outputs for value in found[out.quantity.name]), strict=True)
    )


@lru_cache(maxsize=64)
def _compiled(block: Block) -> tuple[list[str], Callable[..., list[Any]]]:
    """Names of what a block reads, and a function of them for arrays."""
    symbols = [symbol for q in block.inputs for symbol in q.symbols]
    steps = [(step.symbol, step.expr) for step in block.steps]
    exprs = [sp.sympify(expr) for out in block.outputs for expr in out.exprs]
    function = sp.lambdify(symbols, exprs, "numpy", cse=lambda given: (steps, given))
    return [symbol.name for symbol in symbols], function


@dataclass(frozen=True, eq=False)
class Terms:
    """D (6, m), H (6, 6, m) leg by leg in its second axis, c (6, 6, m) of the legs and the platform's (6, m)
    or, where each leg has a platform of its own, (6, 6, m): rows first, m motions last."""

    D: Any
    H: Any
    c: Any
    platform: Any


class Forces:
    """The forces of a kernel on m motions, their bounds, and what changed constants do to them.

    motions: arrays by name with the motions last: R (3, 3, m), others (3, m). near: by the block for legs
    near their joint singularity.

    Attributes: F (m, 6), N, as double has it, bound (m, 6), in rounding units, both nan where H is singular;
    load (m, 6), the wrench, N and N m about the reference point, that the actuators exert on the platform.
    """

    def __init__(self, constants: KernelConstants, motions: Numbers, near: bool) -> None:
        """Solve for the forces, and bound their errors."""
        kernel = constants.kernel
        block = kernel.leg_near_singular if near else kernel.leg
        assert block is not None
        self._kernel, self._block = kernel, block
        self._constants, self._motion = constants.plain, _components_of(n.MOTION, motions)
        self._count = motions["t"].shape[-1]
        self._base: Terms | None = None
        self._solve(self._terms(constants.rounded, None))

    def moved(self, change: Change) -> Array:
        """Sizes, N, of the changes (names, m, 6) of the forces by each of a change's constants."""
        if self._base is None:
            self._base = self._terms(self._constants, self._tip)
        new, old = self._terms(change.constants, self._tip), self._base
        D, H, c = new.D - old.D, new.H - old.H, new.c - old.c
        platform = new.platform - (old.platform[:, None] if new.platform.ndim == 3 else old.platform)
        columns = c - H * self._x.T
        if len(change.names) == 1:
            total = columns.sum(axis=1) + platform
            x = np.einsum("mij,jm->mi", self._inverse, total)
            return np.asarray(np.abs(D.T - x)[None])
        columns = columns + (platform if platform.ndim == 3 else platform[:, None])
        x = np.einsum("mij,jlm->lmi", self._inverse, columns)
        x[np.arange(LEGS), :, np.arange(LEGS)] -= D
        return np.asarray(np.abs(x))

    def _solve(self, terms: Terms) -> None:
        total = terms.platform
        for i in range(LEGS):
            total = [row + leg[i] for row, leg in zip(total, terms.c, strict=True)]
        shape = (LEGS, self._count)
        H, dH = (_stacked(terms.H, what, shape).transpose(2, 0, 1) for what in ("value", "error"))
        c, dc = (_stacked(total, what, shape[1:]).T for what in ("value", "error"))
        D, dD = (_stacked([terms.D], what, shape)[0].T for what in ("value", "error"))
        good = np.asarray(np.isfinite(H).all(axis=(1, 2)) & np.isfinite(c).all(axis=1))
        good[good] &= np.linalg.cond(H[good]) < 1.0 / np.finfo(np.float64).eps
        H = np.where(good[:, None, None], H, np.eye(6))
        self._inverse = np.linalg.inv(H)
        self._x = np.linalg.solve(H, c[..., None])[..., 0]
        factors = dH + 6 * HALF_UNIT * factor_sizes(H)
        dx = np.abs(self._inverse) @ (factors @ np.abs(self._x)[..., None] + dc[..., None])
        self.F = np.where(good[:, None], D - self._x, np.nan)
        self.bound = np.where(good[:, None], dD + dx[..., 0] + HALF_UNIT * np.abs(self.F), np.nan)
        force, moment = c[:, :3], c[:, 3:]
        if self._kernel.about_tip:
            moment = moment + np.cross(np.transpose(self._tip), force)
        self.load = np.concatenate([force, moment], axis=1)

    def _terms(self, constants: Constants, tip: Any) -> Terms:
        """Terms with moments about ``tip``, or about platform point 1 where that is None.

        Numbers are arrays, or ``RunningArrays`` where the constants are.
        """
        sqrt = np.sqrt if tip is not None else RunningArrays.sqrt
        shared = _run(self._kernel.shared, self._motion | constants.platform, sqrt)
        given = self._motion | shared | constants.platform | constants.leg
        leg = _run(self._block, given, sqrt)
        H_force, c_force, c_moment = (
            [leg.get(name, 0.0) for name in q.names] for q in (n.H_force, n.c_force, n.c_moment)
        )
        force, moment = ([shared.get(name, 0.0) for name in q.names] for q in (n.c_force, n.c_moment))
        if self._kernel.about_tip:
            q = [leg[name] for name in n.q.names]
            if tip is None:
                first = [RunningArrays.of(each)[0] for each in q]
                self._tip = tip = [each.value for each in first]
                arms = [_zero_of_leg_1(each - one) for each, one in zip(q, first, strict=True)]
            else:
                first, arms = tip, [each - one for each, one in zip(q, tip, strict=True)]
            moment = [one - other for one, other in zip(moment, _cross(first, force), strict=True)]
            H_moment = _cross(arms, H_force)
            c_moment = [a + b for a, b in zip(_cross(arms, c_force), c_moment, strict=True)]
        else:
            self._tip = tip = [np.zeros(self._count)] * 3
            H_moment = [leg[name] for name in n.H_moment.names]
        found = [leg.get(n.D.name, 0.0)], H_force + H_moment, c_force + c_moment, force + moment
        D: Any
        H: Any
        c: Any
        if sqrt is not np.sqrt:
            D, H, c, platform = ([RunningArrays.of(each) for each in rows] for rows in found)
            full = np.zeros((LEGS, self._count))
            return Terms(D[0], H, [each + RunningArrays(full) for each in c], platform)
        D, H, c = (
            np.array([np.broadcast_to(each, (LEGS, self._count)) for each in rows]) for rows in found[:3]
        )
        shape = np.broadcast_shapes((self._count,), *(np.shape(each) for each in found[3]))
        return Terms(D[0], H, c, np.array([np.broadcast_to(each, shape) for each in found[3]]))


def _zero_of_leg_1(arm: RunningArrays) -> RunningArrays:
    """The arm's component with that of leg 1 exactly zero."""
    error = np.array(np.broadcast_to(arm.error, arm.value.shape))
    error[0] = 0.0
    return RunningArrays(arm.value, error)


def _cross(a: list[Any], b: list[Any]) -> list[Any]:
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def _stacked(rows: list[RunningArrays], what: str, shape: tuple[int, ...]) -> Array:
    return np.array([np.broadcast_to(getattr(row, what), shape) for row in rows])
