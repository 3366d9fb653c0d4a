"""Calls of the NumPy kernels: arrays of poses as input, arrays of results and statuses as output."""

import math
from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..backend.kernel import MOTION, legs_side_by_side, module, robot_kernel
from ..generated.interface import OUTPUTS, Shape
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot

# Number of poses in one call, because larger arrays do not fit into the cache.
_AT_ONCE = 1024
# Numbers of all intermediate results of one call.
_INTERMEDIATE = 1 << 21


class NumpyKernel:
    """NumPy kernel of one formulation with one robot."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Select the module, and convert the robot."""
        self._module: Any = module(robot_kernel(robot, formulation))
        self._robot = legs_side_by_side(robot)

    def run(self, output: str, motion: Motion, *given: Array) -> dict[str, Any]:
        """Return the results by name of inverse dynamics or joint reactions, as ``CKernel.run``."""
        found = self.terms(motion)
        if output == "joint_reactions":
            found = {**self.reactions_of(motion, found["x"], *given), "status": found["status"]}
        for name in found.keys() - {"status"}:
            found[name][found["status"] != OK] = np.nan
        return found

    def terms(self, motion: Motion) -> dict[str, Any]:
        """Compute terms and status of every pose; D, K, H, and c are finite if H is singular."""

        def solved(on: Any, part: Any, _: slice) -> Any:
            found = self._module.solved(on, self._robot, part)
            return {**vars(found.terms), **vars(found)}

        def checked(on: Any, part: Any, _: slice) -> Any:
            return vars(self._module.inverse_dynamics(on, self._robot, part))

        found = on_arrays(solved, motion, {**OUTPUTS["inverse_dynamics"], "suspect": ()})
        suspect = found.pop("suspect") == 1.0
        if suspect.any():
            # The check whether H is singular takes longer than all terms, so it is made only for these poses.
            found["status"][suspect] = on_arrays(checked, motion[suspect], {})["status"]
        return found

    def reactions_of(self, motion: Motion, x: Array, bearing: Array) -> dict[str, Array]:
        """Compute joint reactions by name for axial forces ``x`` (N), (..., 6); ``bearing`` (m) is (6,)."""
        axial = x.reshape(-1, 6)

        def run(on: Any, part: Any, at: slice) -> Any:
            arguments = (self._robot.leg, self._robot, part, axial[at].T, bearing[:, None])
            return vars(self._module.leg_reactions(on, *arguments))

        # The legs are on the last axis of the generated code.
        shapes = {name: shape[::-1] for name, shape in OUTPUTS["joint_reactions"].items()}
        found = on_arrays(run, motion, shapes)
        return {name: np.moveaxis(found[name], -1, len(motion.shape)) for name in shapes}


def on_arrays(run: Callable[..., Any], motion: Motion, shapes: Mapping[str, Shape]) -> dict[str, Any]:
    """Evaluate a function of a generated module for every pose; return its results by name with the status.

    ``run`` takes the arithmetic, a motion, and the slice of its poses, and returns results by name.
    ``shapes`` are the shapes of the results for one pose. Results of any status are returned.
    """
    count = math.prod(motion.shape)
    found: dict[str, Any] = {name: np.empty((count, *shape)) for name, shape in shapes.items()}
    found["status"] = np.zeros(count, dtype=np.int32)
    given = loaded(motion)
    rows = {name: given[name].reshape(count, math.prod(shape)) for name, shape in MOTION.items()}
    arithmetic = module("arithmetic").Arithmetic(np)
    # After this block is freed, glibc keeps the memory of intermediate results. Otherwise each call returns
    # it to the system and receives it again page by page, which takes half of the time.
    np.empty(_INTERMEDIATE)
    for first in range(0, count, _AT_ONCE):
        at = slice(first, first + _AT_ONCE)
        part = SimpleNamespace(**{name: np.ascontiguousarray(each[at].T) for name, each in rows.items()})
        with np.errstate(all="ignore"):
            made = {"status": OK, **run(arithmetic, part, at)}
        for name, target in found.items():
            _store(target[at], made[name])
    return {name: each.reshape((*motion.shape, *each.shape[1:])) for name, each in found.items()}


def _store(target: Array, value: Any) -> None:
    """Store nested lists of component arrays in an array of poses; leg axes precede the pose axis."""
    if isinstance(value, list):
        for i, each in enumerate(value):
            _store(target[:, i], each)
    else:
        target[...] = np.transpose(value)


def loaded(motion: Motion) -> dict[str, Array]:
    """Return the arrays of a motion by name, with zeros for a missing load."""
    given, zero = {name: getattr(motion, name) for name in MOTION}, np.zeros((*motion.shape, 3))
    return {name: zero if value is None else value for name, value in given.items()}
