"""Forces at 50 digits: the derived equations of a fidelity, run before they are shared, printed or rounded.

What rounding errors are measured against; the numbers of robot and motion are taken as they are stored. Asks
``derive`` for the equations and SymPy's mpmath for the digits; knows no generated code.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from ..derive import notation as n
from ..derive.block import Block, Quantity
from ..derive.fidelity import FIDELITIES, fidelity_kernel
from ..derive.formulation import EXACT, FORMULATIONS
from ..derive.prepared import ADDED, arm_c, c_tip
from ..derive.regroup import ForceKernel
from ..kernel import kernel_name, loaded
from ..motion import Motion
from ..robot import Robot

Array = NDArray[np.float64]
Values = dict[str, Any]

DIGITS = 50
LEGS = range(6)

digits = mpmath.MPContext()
digits.dps = DIGITS
"""Arithmetic of 50 digits, nobody else's."""


@dataclass(frozen=True, eq=False)
class Truth:
    """The equations of one fidelity of a formulation with a robot's numbers, at 50 digits."""

    robot: Robot
    formulation: str = "exact"
    fidelity: str = "general"

    def forces(self, motion: Motion) -> NDArray[np.object_]:
        """Actuator forces, N, of every pose of ``motion``, (..., 6), as 50-digit numbers."""
        poses = loaded(motion)
        F = np.empty((*motion.shape, 6), dtype=object)
        for where in np.ndindex(motion.shape):
            F[where] = self._pose({q.name: getattr(poses, q.name)[where] for q in n.MOTION})
        return F

    def deviation(self, F: NDArray[Any], motion: Motion) -> Array:
        """Errors, N, of forces, (..., 6), that somebody computed for ``motion``."""
        return deviation(F, self.forces(motion))

    def _pose(self, motion: Mapping[str, Array]) -> list[Any]:
        """F = D - x with H x = c, (35)-(37)."""
        D, H, c = self._terms.at(motion)
        x = digits.lu_solve(digits.matrix(H), digits.matrix(c))
        return list(digits.matrix(D) - x)

    @cached_property
    def _terms(self) -> "ForceTerms":
        kernel = derived_kernel(self.robot.base_joint, self.formulation, self.fidelity)
        return ForceTerms(kernel, self.robot, lambda _, value: digits.mpf(value), digits.sqrt)


def derived_kernel(base_joint: str, formulation: str, fidelity: str) -> ForceKernel:
    """The blocks of the forces alone, before sharing."""
    # Reduced legs are those of EXACT on any base joint: there are none that know another.
    name = kernel_name(formulation, base_joint if fidelity == "general" else EXACT.base_joint)
    return _derived(name, fidelity)


@cache
def _derived(name: str, fidelity: str) -> ForceKernel:
    form = next(form for form in FORMULATIONS if form.kernel_name == name)
    return fidelity_kernel(form, FIDELITIES[fidelity])


@dataclass(frozen=True, eq=False)
class ForceTerms:
    """D, H and c of (35)-(37) from derived blocks, in any arithmetic.

    robot: what has the fields of ``Robot``. number: makes a number of the arithmetic of a quantity's name and
    a stored component of it; sqrt: the square root of such a number.
    """

    kernel: ForceKernel
    robot: Any
    number: Callable[[str, Any], Any]
    sqrt: Callable[[Any], Any]

    def at(self, motion: Mapping[str, Array]) -> tuple[list[Any], list[list[Any]], list[Any]]:
        """D (6,), H (6, 6), c (6,) of one pose, given as arrays by name; moments about the kernel's point."""
        robot, legs, platform = self._constants
        pose = robot | self._named(n.MOTION, motion)
        turn = platform | self._components(self._kernel.shared, pose | platform)
        found = [self._components(self._kernel.leg, pose | turn | constants) for constants in legs]
        # A fidelity leaves out what is zero.
        D = [leg.get(n.D.name, 0) for leg in found]
        H = [[leg[row] for leg in found] for row in _COLUMN]
        tip = c_tip.names if self.kernel.about_tip else n.c_moment.names
        c = [turn[row] for row in (*n.c_force.names, *tip)]
        for rows, place in ((n.c_force, 0), (n.c_moment, 3), (arm_c, 3)):
            for j, row in enumerate(rows.names):
                c[place + j] = sum((leg.get(row, 0) for leg in found), c[place + j])
        return D, H, c

    @cached_property
    def _kernel(self) -> ForceKernel:
        """The kernel with moments in its blocks."""
        return self.kernel.whole() if self.kernel.about_tip else self.kernel

    @cached_property
    def _constants(self) -> tuple[Values, list[Values], Values]:
        """The robot's numbers that all legs share, those of each leg, and the prepared ones."""
        robot, kernel = self.robot, self._kernel
        whole = self._named(n.PLATFORM, {q.name: getattr(robot, q.name) for q in n.PLATFORM})
        whole |= self._named([n.p_1], {n.p_1.name: robot.p[0]})
        legs = []
        for i in LEGS:
            raw = self._named(n.LEG, {q.name: getattr(robot, q.name)[i] for q in n.LEG})
            legs.append(raw | self._components(kernel.prepare_leg, whole | raw))
        added = {name: sum(leg.get(name, 0) for leg in legs) for q in ADDED for name in q.names}
        return whole, legs, self._components(kernel.prepare_platform, whole | legs[0] | added)

    def _named(self, quantities: Iterable[Quantity], values: Mapping[str, Array]) -> Values:
        """Components by name."""
        return {
            name: self.number(quantity.name, np.asarray(values[quantity.name])[key])
            for quantity in quantities
            for name, key in zip(quantity.names, quantity.keys, strict=True)
        }

    def _components(self, block: Block, values: Values) -> Values:
        """What a block hands out, component by component."""
        found = block.run(values, self.sqrt)
        return {
            name: value
            for out in block.outputs
            for name, value in zip(out.quantity.names, found[out.quantity.name], strict=True)
        }


def deviation(F: NDArray[Any], truth: NDArray[np.object_]) -> Array:
    """Errors of forces beside 50-digit ones, N, of their shape, rounded last."""
    difference = [
        float(digits.mpf(float(found)) - true) for found, true in zip(F.flat, truth.flat, strict=True)
    ]
    return np.array(difference).reshape(F.shape)


_COLUMN = (*n.H_force.names, *n.H_moment.names)
