"""Actuator forces with 50 digits from the derived equations, before subexpressions are shared and printed.

Rounding errors are measured against these forces. The numbers of robot and motion are exact inputs. The
equations of a fidelity level are from ``derive``, and the arithmetic is mpmath.
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
from ..calls.numpy_kernel import loaded
from ..derive.kernel.outputs import FORCES, program
from ..derive.mechanics import quantities as n
from ..derive.mechanics.formulation import BY_KERNEL, EXACT, Formulation
from ..derive.mechanics.legs.rotor import NONE
from ..derive.mechanics.reduced_models import Fidelity, fidelity_kernel, level_of
from ..derive.trace.constants import unchecked
from ..derive.trace.interpret import Arithmetic, Interpreter
from ..formulas.trees import robot_structure, structure
from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot

digits = mpmath.MPContext()
digits.dps = 50
"""Arithmetic of 50 digits, nobody else's."""

ON_DIGITS = Arithmetic(
    digits.mpf, {name: digits.mpf(value) for name, value in unchecked(1e-45).items()}, digits.sqrt
)
"""The same arithmetic for kernel trees."""


def number_of_digits(_: str, value: Any) -> Any:
    """Convert a component of a quantity to 50 digits."""
    return digits.mpf(value)


@cache
def _forces(base_joint: str, formulation: str, fidelity: str, rotors: bool) -> Interpreter:
    kernel = fidelity_kernel(*form_and_level(base_joint, formulation, fidelity, rotors))
    return Interpreter(program(kernel), ON_DIGITS)


@dataclass(frozen=True, eq=False)
class Truth:
    """Equations of one formulation and fidelity level with the numbers of a robot, with 50 digits."""

    robot: Robot
    formulation: str = "exact"
    fidelity: str = "general"

    def forces(self, motion: Motion) -> NDArray[np.object_]:
        """Compute the actuator forces (N) of every pose, (..., 6), as numbers of 50 digits, (35)-(37)."""
        poses = loaded(motion)
        F = np.empty((*motion.shape, 6), dtype=object)
        for where in np.ndindex(motion.shape):
            F[where] = self.of_pose({name: value[where] for name, value in poses.items()})
        return F

    def of_pose(self, motion: Mapping[str, NDArray[Any]]) -> list[Any]:
        """Compute the forces of one pose, whose numbers may have 50 digits."""
        given = structure(n.MOTION, motion, number_of_digits)
        found: list[Any] = self._interpreter.run(FORCES, self._model, given).F
        return found

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
    """Return a formulation and a fidelity level; reduced levels have legs with universal base joints."""
    level = level_of(fidelity, rotors)
    name = kernel_name(formulation, base_joint if level.name == "general" else EXACT.base_joint)
    return BY_KERNEL[f"{name}_drive" if level.rotor != NONE else name], level


def deviation(F: NDArray[Any], truth: NDArray[np.object_]) -> Array:
    """Return the errors of forces relative to forces with 50 digits (N), rounded last."""
    pairs = zip(F.flat, truth.flat, strict=True)
    return np.array([float(digits.mpf(float(found)) - true) for found, true in pairs]).reshape(F.shape)
