"""Closed-form kernels for one robot, in C or NumPy: equations of motion, forward dynamics, and derivatives.

They accept checked robots and motions with universal base joints, in formulation `exact`.
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ..backend.calls import address, function, library, loaded, results_of
from ..backend.kernel import module, robot_kernel
from ..generated.interface import OUTPUTS as _OUTPUTS
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot
from .arrays import robot_structure, stacked
from .forces import ForceKernel

OUTPUTS: Mapping[str, Mapping[str, tuple[int, ...]]] = {
    what: _OUTPUTS[what]
    for what in (
        "equations",
        "bias_and_friction",
        "forward_dynamics",
        "joint_inertia",
        "derivatives",
        "linearization",
    )
}
"""Outputs that sweeps compare with higher precision, with the shape of each result at one pose."""


class CClosedForm:
    """C closed form with the prepared constants of one robot. Calls release the global interpreter lock."""

    def __init__(self, robot: Robot) -> None:
        self._name = robot_kernel(robot, "exact")
        library(f"{self._name}_motion")
        self._model = ForceKernel(robot, "exact").model

    def run(self, what: str, motion: Motion, F: Array | None = None) -> dict[str, Any]:
        """Return the results by name, and the status (...); results are NaN if the status is not 0.

        ``what`` is an output of ``derive.kernel.outputs.RESULTS`` except "forces". F (N) has the shape (...,
        6) with the shape of the motion.
        """
        forces = [] if F is None else [F]
        return results_of(self._name, "_motion", what, self._model, motion, *forces)

    def one_state(self) -> Callable[[Motion, Array], tuple[Array, int]]:
        """Return a function for the forward dynamics of single states; see ``ForwardDynamics.one_state``."""
        arrays = (self._model, np.zeros(30), np.zeros(6), np.empty(6))
        R, t, omega, v, _, _, F_ext, M_ext = np.split(arrays[1], np.arange(9, 30, 3))
        nothing, code = np.zeros(3), function(self._name, "forward_dynamics", "_motion")
        addresses = [address(array) for array in arrays]

        def solve(motion: Motion, F: Array) -> tuple[Array, int]:
            # This reference keeps the arrays alive as long as the function.
            _, _, forces, x = arrays
            R[:], t[:], omega[:], v[:] = motion.R.ravel(), motion.t, motion.omega, motion.v
            F_ext[:] = nothing if motion.F_ext is None else motion.F_ext
            M_ext[:] = nothing if motion.M_ext is None else motion.M_ext
            forces[:] = F
            status = int(code(*addresses))
            return (x.copy() if status == OK else np.full(6, np.nan)), status

        return solve


class NumpyClosedForm:
    """NumPy closed form for one robot, bit-identical to C without fused multiply-add."""

    def __init__(self, robot: Robot) -> None:
        self._source: Any = module(f"{robot_kernel(robot, 'exact')}_arrays")
        self._on = module("arithmetic").Arithmetic(np, np.float64)
        with np.errstate(all="ignore"):
            self._model = self._source.prepare(self._on, robot_structure(self._source.Robot(), robot))

    def run(self, what: str, motion: Motion, F: Array | None = None) -> dict[str, Any]:
        """Return the results by name, as in ``CClosedForm.run``."""
        given = self._source.motion_of(self._on, **loaded(motion))
        forces = [] if F is None else [[F[..., i] for i in range(6)]]
        with np.errstate(all="ignore"):
            result = getattr(self._source, what)(self._on, self._model, given, *forces)
        shape = motion.t.shape[:-1]
        found = {name: stacked(np, value, shape) for name, value in vars(result).items()}
        if "alpha" in found:
            found["acceleration"] = np.concatenate([found.pop("a"), found.pop("alpha")], axis=-1)
        return {name: found[name] for name in _OUTPUTS[what]} | {"status": found["status"].astype(np.int32)}


ClosedForm = CClosedForm | NumpyClosedForm
