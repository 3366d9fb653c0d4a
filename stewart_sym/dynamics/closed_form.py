"""The closed form's kernels bound to a robot: equations of motion, forward dynamics, derivatives; C or NumPy.

Takes checked robots and motions, hands arrays to the generated code and its results back. Formulation
`exact` with universal base joints.
"""

import ctypes
import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from ..backend import c_kernel, native
from ..backend.c_kernel import address, call, contiguous, pointers
from ..backend.kernel import defines_of, module, robot_kernel
from ..backend.numpy_kernel import loaded
from ..generated.interface import OUTPUTS as _OUTPUTS
from ..generated.interface import STRUCTS
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot
from .arrays import robot_structure, stacked
from .forces import ForceKernel, prepare

OUTPUTS: Mapping[str, Mapping[str, tuple[int, ...]]] = {
    what: _OUTPUTS[what]
    for what in ("equations", "bias", "forward_dynamics", "joint_inertia", "derivatives", "linearisation")
}
"""What the functions hand out that sweeps hold against wider arithmetic, with the shape of a pose's part."""


class ClosedForm(Protocol):
    """A robot bound to the closed form's functions."""

    def run(self, what: str, motion: Motion, F: Array | None = None) -> dict[str, Any]:
        """Results by name and status (...), NaN where that is not 0.

        what: an output of ``derive.kernel.outputs.RESULTS`` but "forces". F: (..., 6), of the motion's shape.
        """


def c_sources(name: str = "exact") -> dict[str, str]:
    """File name -> text of the generated C of the closed form and of the force kernel it stands on.

    name: of the kernel, "exact" or "exact_drive".
    """
    return c_kernel.c_sources(f"{name}_forces") | c_kernel.c_sources(f"{name}_motion")


@functools.cache
def library(name: str = "exact") -> ctypes.CDLL:
    """The compiled C. Raises native.CompilerError where there is no working compiler."""
    return native.load(f"stewart_{name}_motion", c_sources(name), defines=dict.fromkeys(defines_of(name), 1))


@dataclass(frozen=True, eq=False)
class CClosedForm:
    """The C of the closed form with one robot's prepared constants. Calls release the interpreter lock."""

    robot: Robot
    _forces: ForceKernel = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Compile or find the kernels and prepare the robot's constants."""
        library(robot_kernel(self.robot, "exact"))
        object.__setattr__(self, "_forces", prepare(self.robot, "exact"))

    def run(self, what: str, motion: Motion, F: Array | None = None) -> dict[str, Any]:
        """See ``ClosedForm``."""
        outputs = {name: np.full((*motion.shape, *shape), np.nan) for name, shape in _OUTPUTS[what].items()}
        status = np.zeros(motion.shape, dtype=np.int32)
        forces = [] if F is None else [contiguous(F)]
        targets = [pointers(outputs.values())] if what in STRUCTS else [*map(address, outputs.values())]
        code = self._function(f"{what}_batch")
        call(code, self._forces.model, motion, *map(address, forces), *targets, address(status))
        return {**outputs, "status": status}

    def _function(self, what: str) -> Any:
        name = robot_kernel(self.robot, "exact")
        return getattr(library(name), f"stewart_{name}_{what}")

    def one_state(self) -> Callable[[Motion, Array], tuple[Array, int]]:
        """Forward dynamics of one state at a time, for loops: see ``ForwardDynamics.one_state``."""
        arrays = (self._forces.model, np.zeros(30), np.zeros(6), np.empty(6))
        R, t, omega, v, _, _, F_ext, M_ext = np.split(arrays[1], np.arange(9, 30, 3))
        nothing, code = np.zeros(3), self._function("forward_dynamics")
        addresses = [address(array) for array in arrays]

        def solve(motion: Motion, F: Array) -> tuple[Array, int]:
            # Named here, so that the arrays live as long as this function.
            _, _, forces, x = arrays
            R[:], t[:], omega[:], v[:] = motion.R.ravel(), motion.t, motion.omega, motion.v
            F_ext[:] = nothing if motion.F_ext is None else motion.F_ext
            M_ext[:] = nothing if motion.M_ext is None else motion.M_ext
            forces[:] = F
            status = int(code(*addresses))
            return (x.copy() if status == OK else np.full(6, np.nan)), status

        return solve


@dataclass(frozen=True, eq=False)
class NumpyClosedForm:
    """The NumPy kernels of the closed form with one robot: those of arrays, with the C's bits.

    real: type of real numbers.
    """

    robot: Robot
    real: type[np.floating[Any]] = np.float64
    _on: Any = field(init=False, repr=False)
    _model: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Prepare the robot's constants."""
        source, on = self._source, module("arithmetic").Arithmetic(np, self.real)
        with np.errstate(all="ignore"):
            model = source.prepare(on, robot_structure(source.Robot(), self.robot))
        object.__setattr__(self, "_on", on)
        object.__setattr__(self, "_model", model)

    @property
    def _source(self) -> Any:
        return module(f"{robot_kernel(self.robot, 'exact')}_arrays")

    def run(self, what: str, motion: Motion, F: Array | None = None) -> dict[str, Any]:
        """See ``ClosedForm``."""
        source = self._source
        given = source.motion_of(self._on, **vars(loaded(motion)))
        forces = [] if F is None else [[F[..., i] for i in range(6)]]
        with np.errstate(all="ignore"):
            result = getattr(source, what)(self._on, self._model, given, *forces)
        shape = motion.t.shape[:-1]
        found = {name: stacked(np, value, shape) for name, value in vars(result).items()}
        if "alpha" in found:
            found["acceleration"] = np.concatenate([found.pop("a"), found.pop("alpha")], axis=-1)
        return {name: found[name] for name in _OUTPUTS[what]} | {"status": found["status"].astype(np.int32)}
