"""Forces at 50 digits: the derived equations of a fidelity, run before they are shared, printed or rounded.

What rounding errors are measured against; the numbers of robot and motion are taken as they are stored.
The equations are those of ``derive``, the digits SymPy's mpmath's.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from types import SimpleNamespace
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import kernel_name
from ..backend.numpy_kernel import loaded
from ..derive.kernel.outputs import FORCES, program
from ..derive.kernel.tree.constants import unchecked
from ..derive.kernel.tree.interpret import Arithmetic, Interpreter
from ..derive.mechanics import quantities as n
from ..derive.mechanics.formulation import BY_KERNEL, EXACT, Formulation
from ..derive.mechanics.legs.rotor import NONE
from ..derive.mechanics.reduced_models import Fidelity, fidelity_kernel, level_of
from ..formulas.trees import robot_structure, structure
from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot

DIGITS = 50

digits = mpmath.MPContext()
digits.dps = DIGITS
"""Arithmetic of 50 digits, nobody else's."""


ON_DIGITS = Arithmetic(
    digits.mpf, {name: digits.mpf(value) for name, value in unchecked(1e-45).items()}, digits.sqrt
)
"""The same for kernel trees."""


def number_of_digits(_: str, value: Any) -> Any:
    """A quantity's component as it is stored."""
    return digits.mpf(value)


@cache
def _forces(base_joint: str, formulation: str, fidelity: str, rotors: bool) -> Interpreter:
    kernel = fidelity_kernel(*form_and_level(base_joint, formulation, fidelity, rotors))
    return Interpreter(program(kernel), ON_DIGITS)


@dataclass(frozen=True, eq=False)
class Truth:
    """The equations of one fidelity of a formulation with a robot's numbers, at 50 digits."""

    robot: Robot
    formulation: str = "exact"
    fidelity: str = "general"

    def forces(self, motion: Motion) -> NDArray[np.object_]:
        """Actuator forces, N, of every pose of ``motion``, (..., 6), as 50-digit numbers: (35)-(37)."""
        poses = vars(loaded(motion))
        F = np.empty((*motion.shape, 6), dtype=object)
        for where in np.ndindex(motion.shape):
            F[where] = self.of_pose({name: value[where] for name, value in poses.items()})
        return F

    def of_pose(self, motion: Mapping[str, NDArray[Any]]) -> list[Any]:
        """Forces of one pose, whose numbers may have 50 digits."""
        given = structure(n.MOTION, motion, number_of_digits)
        found: list[Any] = self._interpreter.run(FORCES, self._model, given).F
        return found

    def deviation(self, F: NDArray[Any], motion: Motion) -> Array:
        """Errors, N, of forces, (..., 6), that somebody computed for ``motion``."""
        return deviation(F, self.forces(motion))

    @cached_property
    def _model(self) -> SimpleNamespace:
        robot = robot_structure(self.robot, number_of_digits)
        model: SimpleNamespace = self._interpreter.run("prepare", robot)
        return model

    @property
    def _interpreter(self) -> Interpreter:
        return _forces(self.robot.base_joint, self.formulation, self.fidelity, self.robot.has_rotors)


def form_and_level(
    base_joint: str, formulation: str, fidelity: str, rotors: bool
) -> tuple[Formulation, Fidelity]:
    """The level of a robot's forces, and the formulation that has it: with rotors where the level has them.

    rotors: whether the robot's legs have them.

    Reduced levels are those of legs with universal base joints, whatever the robot's base joints are.
    """
    level = level_of(fidelity, rotors)
    name = kernel_name(formulation, base_joint if level.name == "general" else EXACT.base_joint)
    return BY_KERNEL[f"{name}_drive" if level.rotor != NONE else name], level


def deviation(F: NDArray[Any], truth: NDArray[np.object_]) -> Array:
    """Errors of forces beside 50-digit ones, N, of their shape, rounded last."""
    difference = [
        float(digits.mpf(float(found)) - true) for found, true in zip(F.flat, truth.flat, strict=True)
    ]
    return np.array(difference).reshape(F.shape)
