"""Sensitivity of the forces to a change of one constant, relative to their rounding errors, for many motions.

The blocks of a baked force kernel run in double precision: once in ``RunningArrays`` for the error bound of
each force, then once for every constant, with that constant changed. The change of the solution of H x = c is
computed to first order. The printed code is not used.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ..derive.mechanics import quantities as n
from ..derive.mechanics.actuator_forces import ForceKernel
from ..derive.program.block import Block, Quantity
from ..io.array_types import Array
from ..robot.robot import LEGS
from .running import HALF_UNIT, RunningArrays, factor_sizes

Values = Mapping[str, Any]
Rows = list[Any]

# The arm of leg 1 is exactly zero, without a rounding error.
_ARMS = np.array([[0.0], *[[1.0]] * (LEGS - 1)])


class Change(NamedTuple):
    """Constants of a kernel, one of them with a relative change.

    Attributes
    ----------
    names : tuple of str
        One name of a constant that all legs share, or six names of a constant of each leg, which is changed
        in one leg at a time. A name is empty if the constant is zero, because zero has no relative change.
    constants : dict of str to ndarray
        Values of all constants.
    """

    names: tuple[str, ...]
    constants: dict[str, Any]


def constants_of(kernel: ForceKernel) -> dict[str, Any]:
    """Return the baked constants of a kernel: shape (6, 1) for the legs, then numbers that all legs share."""
    assert kernel.constants is not None
    of_legs = {q.name: np.array(values)[:, None] for q, values in kernel.constants.items() if len(values) > 1}
    return of_legs | {q.name: np.float64(value) for q, value in kernel.literals().items()}


def changes(kernel: ForceKernel, share: float) -> Iterator[Change]:
    """Yield each baked constant of a kernel with the relative change ``share``."""
    own = constants_of(kernel)
    for name, value in own.items():
        of_legs = (f"{name} of leg {i + 1}" if each else "" for i, each in enumerate(np.ravel(value)))
        names = tuple(of_legs) if np.ndim(value) else (name,)
        yield Change(names, {**own, name: value * (1.0 + share)})


class Forces:
    """Forces of a baked kernel for m motions, their error bounds, and their sensitivity to constants.

    Parameters
    ----------
    kernel : ForceKernel
        Kernel with the constants of a robot.
    motions : mapping of str to ndarray
        Arrays by name with the motions on the last axis: R (3, 3, m), others (3, m).
    near : bool
        True uses the block for legs near their joint singularity.

    Attributes
    ----------
    F : ndarray, shape (m, 6)
        Forces in double precision (N); nan if H is singular.
    bound : ndarray, shape (m, 6)
        Error bounds of the forces (rounding units); nan if H is singular.
    load : ndarray, shape (m, 6)
        Wrench of the actuators on the platform (N, and N m about the reference point).
    """

    def __init__(self, kernel: ForceKernel, motions: Mapping[str, Array], near: bool) -> None:
        """Solve for the forces, and bound their errors."""
        block = kernel.leg_near_singular if near else kernel.leg
        assert block is not None
        self._kernel, self._leg = kernel, block
        self._motion = {
            name: motions[q.name][key] for q in n.MOTION for name, key in zip(q.names, q.keys, strict=True)
        }
        self._legs = (LEGS, motions["t"].shape[-1])
        self._tip: Rows = []
        self._solve()

    def moved(self, change: Change) -> Array:
        """Compute the absolute changes of the forces (N), shape (names, m, 6), for each constant of a
        change.
        """
        new, old = self._in_double(change.constants), self._unchanged
        D, H, c, platform = (one - other for one, other in zip(new, old, strict=True))
        columns = c - H * self._x.T
        alone = len(change.names) == 1
        if alone:
            columns = (columns.sum(axis=1) + platform)[:, None]
        x = np.einsum("mij,jlm->lmi", self._inverse, columns)
        if alone:
            x -= D.T
        else:
            x[np.arange(LEGS), :, np.arange(LEGS)] -= D
        return np.asarray(np.abs(x))

    def _solve(self) -> None:
        own = constants_of(self._kernel)
        once = {name: RunningArrays(value, 0.0, rounded=True) for name, value in own.items()}
        known, columns, of_legs, total = self._rows(once, RunningArrays.sqrt)
        spread = RunningArrays(np.zeros(self._legs))
        for i in range(LEGS):
            total = [row + (more + spread)[i] for row, more in zip(total, of_legs, strict=True)]
        D, dD = (each[0].T for each in _with_errors([known], self._legs))
        H, dH = (each.transpose(2, 0, 1) for each in _with_errors(columns, self._legs))
        c, dc = (each.T for each in _with_errors(total, self._legs[1:]))
        good = np.asarray(np.isfinite(H).all(axis=(1, 2)) & np.isfinite(c).all(axis=1))
        good[good] &= np.linalg.cond(H[good]) < 1.0 / np.finfo(np.float64).eps
        H = np.where(good[:, None, None], H, np.eye(6))
        self._inverse = np.linalg.inv(H)
        self._x = np.linalg.solve(H, c[..., None])[..., 0]
        factors = dH + 6 * HALF_UNIT * factor_sizes(H)
        dx = np.abs(self._inverse) @ (factors @ np.abs(self._x)[..., None] + dc[..., None])
        self.F = np.where(good[:, None], D - self._x, np.nan)
        self.bound = np.where(good[:, None], dD + dx[..., 0] + HALF_UNIT * np.abs(self.F), np.nan)
        force = c[:, :3]
        moment = c[:, 3:] + np.cross(np.transpose(self._tip), force)
        self.load = np.concatenate([force, moment], axis=1)

    @cached_property
    def _unchanged(self) -> tuple[Array, ...]:
        return self._in_double(constants_of(self._kernel))

    def _in_double(self, constants: dict[str, Any]) -> tuple[Array, ...]:
        """Compute D (6, m), H and c of the legs (6, 6, m), rows first, and c of the platform (6, m)."""
        D, *rows = self._rows(constants, np.sqrt)
        shapes = (self._legs, self._legs, self._legs[1:])
        return np.broadcast_to(D, self._legs), *map(_stacked, rows, shapes)

    def _rows(self, constants: dict[str, Any], sqrt: Callable[[Any], Any]) -> tuple[Any, Rows, Rows, Rows]:
        """Compute D, the rows of H and c of the legs, and the rows of c of the platform.

        Moments are about the position of platform point 1 for the constants of the first call.
        """
        known = self._motion | constants
        pose = _run(self._kernel.shared, known, sqrt)
        leg = _run(self._leg, known | pose, sqrt)
        H, c, c_moment = (_of(leg, q) for q in (n.H_force, n.c_force, n.c_moment))
        force, moment = (_of(pose, q) for q in (n.c_force, n.c_moment))
        tip, arms = self._arms(_of(leg, n.q))
        moment = _less(moment, _cross(tip, force))
        c_moment = [one + other for one, other in zip(_cross(arms, c), c_moment, strict=True)]
        return leg.get(n.D.name, 0.0), H + _cross(arms, H), c + c_moment, force + moment

    def _arms(self, q: Rows) -> tuple[Rows, Rows]:
        """Compute platform point 1, and the arms of the legs relative to it."""
        if self._tip:
            return self._tip, _less(q, self._tip)
        first = [RunningArrays.of(each)[0] for each in q]
        self._tip = [each.value for each in first]
        return first, [each * _ARMS for each in _less(q, first)]


def _run(block: Block, values: Values, sqrt: Callable[[Any], Any]) -> dict[str, Any]:
    """Run a block, and return its outputs component by component."""
    found = block.run(values, sqrt)
    pairs = ((q.names, found[q.name]) for q in block.made)
    return {name: value for names, parts in pairs for name, value in zip(names, parts, strict=True)}


def _of(found: Values, quantity: Quantity) -> Rows:
    """Return the components of a quantity, or zeros if a block does not compute it."""
    return [found.get(name, 0.0) for name in quantity.names]


def _less(rows: Rows, others: Rows) -> Rows:
    return [one - other for one, other in zip(rows, others, strict=True)]


def _cross(a: Rows, b: Rows) -> Rows:
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def _stacked(rows: Rows, shape: tuple[int, ...]) -> Array:
    return np.array([np.broadcast_to(row, shape) for row in rows])


def _with_errors(rows: Rows, shape: tuple[int, ...]) -> tuple[Array, Array]:
    numbers = [RunningArrays.of(row) for row in rows]
    values, errors = ([getattr(each, what) for each in numbers] for what in ("value", "error"))
    return _stacked(values, shape), _stacked(errors, shape)
