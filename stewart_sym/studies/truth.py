"""Forces at 50 digits: the derived equations of a fidelity, run before they are shared, printed or rounded.

What rounding errors are measured against; the numbers of robot and motion are taken as they are stored. Asks
``derive`` for the equations and SymPy's mpmath for the digits; knows no generated code.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from ..derive import notation as n
from ..derive.block import Block, Quantity
from ..derive.fidelity import FIDELITIES, fidelity_kernel
from ..derive.formulation import EXACT, FORMULATIONS
from ..derive.prepared import ADDED
from ..derive.regroup import ForceKernel
from ..kernel import kernel_name, loaded
from ..motion import Motion
from ..robot import Robot

Array = NDArray[np.float64]
Values = dict[str, Any]

DIGITS = 50
LEGS = range(6)

_digits = mpmath.MPContext()
_digits.dps = DIGITS


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
        robot, legs, platform = self._constants
        pose = robot | _named(n.MOTION, motion)
        turn = platform | _components(self._kernel.shared, pose | platform)
        D, H = _digits.matrix(6, 1), _digits.matrix(6, 6)
        c = _digits.matrix([turn[name] for name in _WRENCH])
        for i, constants in enumerate(legs):
            leg = _components(self._kernel.leg, pose | turn | constants)
            # A fidelity leaves out what is zero.
            D[i] = leg.get(n.D.name, 0)
            for row, (column, share) in enumerate(zip(_COLUMN, _WRENCH, strict=True)):
                H[row, i] = leg[column]
                c[row] += leg.get(share, 0)
        return list(D - _digits.lu_solve(H, c))

    @cached_property
    def _kernel(self) -> ForceKernel:
        level = FIDELITIES[self.fidelity]
        # Reduced legs are those of EXACT on any base joint: there are none that know another.
        joint = self.robot.base_joint if self.fidelity == "general" else EXACT.base_joint
        name = kernel_name(self.formulation, joint)
        return fidelity_kernel(next(form for form in FORMULATIONS if form.kernel_name == name), level)

    @cached_property
    def _constants(self) -> tuple[Values, list[Values], Values]:
        """The robot's numbers that all legs share, those of each leg, and the prepared ones."""
        robot, kernel = self.robot, self._kernel
        whole = _named(n.PLATFORM, {q.name: getattr(robot, q.name) for q in n.PLATFORM})
        whole |= _named([n.b_1], {n.b_1.name: robot.b[0]})
        legs = []
        for i in LEGS:
            raw = _named(n.LEG, {q.name: getattr(robot, q.name)[i] for q in n.LEG})
            legs.append(raw | _components(kernel.prepare_leg, whole | raw))
        added = {name: sum(leg.get(name, 0) for leg in legs) for q in ADDED for name in q.names}
        return whole, legs, _components(kernel.prepare_platform, whole | legs[0] | added)


def deviation(F: NDArray[Any], truth: NDArray[np.object_]) -> Array:
    """Errors of forces beside 50-digit ones, N, of their shape, rounded last."""
    difference = [
        float(_digits.mpf(float(found)) - true) for found, true in zip(F.flat, truth.flat, strict=True)
    ]
    return np.array(difference).reshape(F.shape)


_COLUMN = (*n.H_force.names, *n.H_moment.names)
_WRENCH = (*n.c_force.names, *n.c_moment.names)


def _named(quantities: Iterable[Quantity], values: Mapping[str, Array]) -> Values:
    """Components by name, exactly as stored."""
    return {
        name: _digits.mpf(float(np.asarray(values[quantity.name])[key]))
        for quantity in quantities
        for name, key in zip(quantity.names, quantity.keys, strict=True)
    }


def _components(block: Block, values: Values) -> Values:
    """What a block hands out, component by component."""
    found = block.run(values, _digits.sqrt)
    return {
        name: value
        for out in block.outputs
        for name, value in zip(out.quantity.names, found[out.quantity.name], strict=True)
    }
