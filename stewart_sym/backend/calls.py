"""Calls of the C and NumPy kernels: arrays of poses as input, arrays of results and statuses as output."""

import ctypes
import functools
import math
from collections.abc import Callable, Iterable, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..generated.interface import HEADERS, MODELS, OUTPUTS, STRUCTS, Shape
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK, InverseDynamicsResult, JointReactionsResult
from ..robot.robot import Robot
from . import kernel, native

# Number of poses in one call of a NumPy kernel, because larger arrays do not fit into the cache.
_AT_ONCE = 1024
_SHAPES = {**OUTPUTS, "forces_bounded": {"F": (6,), "bound": (6,), "rcond": ()}}


class Kernel:
    """Kernel of one formulation for one robot; ``_run`` returns the fields of a result."""

    _run: Callable[..., dict[str, Any]]

    def forces(self, motion: Motion) -> InverseDynamicsResult:
        """Compute the inverse dynamics of every pose; results are NaN if the status is not 0."""
        return InverseDynamicsResult(**self._run("inverse_dynamics", motion))

    def reactions(self, motion: Motion, bearing: Array) -> JointReactionsResult:
        """Compute the joint reactions of every pose; ``bearing`` (m) has shape (6,)."""
        return JointReactionsResult(**self._run("joint_reactions", motion, bearing))


class CKernel(Kernel):
    """C kernel; calls release the interpreter lock."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Compile the kernel or load it from the cache, and store the constants of the robot."""
        self._name = kernel.robot_kernel(robot, formulation)
        library(self._name)
        self._numbers = kernel.robot_numbers(robot, self._name)

    def _run(self, name: str, motion: Motion, *given: Array) -> dict[str, Any]:
        return results_of(self._name, "", name, self._numbers, motion, *given)


class NumpyKernel(Kernel):
    """NumPy kernel."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Select the module, and convert the robot."""
        self._module: Any = kernel.module(kernel.robot_kernel(robot, formulation))
        self._robot = kernel.legs_side_by_side(robot)

    def _run(self, name: str, motion: Motion, *bearing: Array) -> dict[str, Any]:
        found = self.terms(motion)
        if name == "joint_reactions":
            found = {**self.reactions_of(motion, found["x"], *bearing), "status": found["status"]}
        for each in found.keys() - {"status"}:
            found[each][found["status"] != OK] = np.nan
        return found

    def terms(self, motion: Motion) -> dict[str, Any]:
        """Compute terms and status of every pose; D, K, H, and c are finite if H is singular."""

        def run(on: Any, part: Any, _: slice) -> Any:
            found = self._module.inverse_dynamics(on, self._robot, part)
            return {**vars(found.terms), **vars(found)}

        return on_arrays(run, motion, OUTPUTS["inverse_dynamics"])

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


def c_sources(name: str) -> dict[str, str]:
    """Return the generated C sources of one kernel, text by file name; motion kernels contain the forces."""
    stems = dict.fromkeys((name.replace("_motion", "_forces"), name))
    names = (*HEADERS, *(f"stewart_{stem}.{kind}" for stem in stems for kind in "hc"))
    return {file: kernel.generated_text(f"c/{file}") for file in names}


@functools.cache
def library(name: str, precision: str = "double") -> ctypes.CDLL:
    """Compile and load the C code of one kernel for "double" or "float"; raises as ``native.load``."""
    flags = {"-DSTEWART_ROTORS": "_drive" in name, "-DSTEWART_FLOAT": precision == "float"}
    return native.load(f"stewart_{name}", c_sources(name), [flag for flag in flags if flags[flag]])


@functools.cache
def function(name: str, suffix: str, part: str = "", precision: str = "double") -> Any:
    """Return the C function ``stewart_<name>_<suffix>`` of a kernel, or of a part such as "_forces"."""
    return getattr(library(f"{name}{part}", precision), f"stewart_{name}_{suffix}")


def results_of(
    name: str, part: str, what: str, model: Array, motion: Motion, *given: Array
) -> dict[str, Any]:
    """Compute the output ``what`` of a part of a kernel for many poses; return the results and the status.

    Results are NaN if the status is not 0. ``given`` are the arrays after the motion. The results are members
    of a C structure if one has these members, or separate arguments.
    """
    code = function(name, f"{what}_batch", part, "float" if model.dtype == np.float32 else "double")
    shapes = _SHAPES[what]
    found = {each: np.full((*motion.shape, *of), np.nan, model.dtype) for each, of in shapes.items()}
    status = np.zeros(motion.shape, dtype=np.int32)
    targets = [pointers(found.values())] if shapes in STRUCTS.values() else map(address, found.values())
    arrays = [np.ascontiguousarray(array) for array in given]
    call(code, model, motion, *map(address, arrays), *targets, address(status))
    return {**found, "status": status}


def call(function: Any, model: Array, motion: Motion, *arguments: Any) -> Any:
    """Call a C function for many poses, and return its value; the motion gets the type of the constants."""
    with np.errstate(over="ignore"):
        arrays = (getattr(motion, name) for name in kernel.MOTION)
        inputs = [None if each is None else np.ascontiguousarray(each, model.dtype) for each in arrays]
    return function(address(model), ctypes.c_size_t(math.prod(motion.shape)), pointers(inputs), *arguments)


def prepared_model(prepare: Any, robot: Robot, name: str, precision: str) -> NDArray[Any]:
    """Prepare the constants of a robot by ``prepare`` of a kernel in MODELS; raise ValueError on overflow."""
    dtype, count = np.dtype(np.float64 if precision == "double" else np.float32), MODELS[name]
    with np.errstate(over="ignore"):
        numbers = kernel.robot_numbers(robot, name).astype(dtype)
    # The constants are aligned to a cache line, so that no vector register load crosses a line.
    room = np.zeros(count + 64 // dtype.itemsize, dtype)
    first = -room.ctypes.data % 64 // dtype.itemsize
    model = room[first : first + count]
    if prepare(address(numbers), address(model)) != OK:
        raise kernel.overflows(precision)
    for each in (room, model):
        each.setflags(write=False)
    return model


def pointers(arrays: Iterable[Array | None]) -> Any:
    """Return the addresses of arrays as a C structure of pointers."""
    found = [address(array) for array in arrays]
    return (ctypes.c_void_p * len(found))(*found)


def address(array: NDArray[Any] | None, entries: int = 0) -> ctypes.c_void_p:
    """Return the address of an entry of a contiguous array, or NULL for None."""
    if array is None:
        return ctypes.c_void_p(None)
    if array.flags.carray and array.size > 0:
        # This is much faster than the array interface, which is required only for read-only or empty arrays.
        start = ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    else:
        start = array.__array_interface__["data"][0]
    return ctypes.c_void_p(start + entries * array.itemsize)


def on_arrays(run: Callable[..., Any], motion: Motion, shapes: Mapping[str, Shape]) -> dict[str, Any]:
    """Evaluate a function of a generated module for every pose; return its results by name with the status.

    ``run`` takes the arithmetic, a motion, and the slice of its poses, and returns results by name.
    ``shapes`` are the shapes of the results for one pose. Results of any status are returned.
    """
    count = math.prod(motion.shape)
    found: dict[str, Any] = {name: np.empty((count, *shape)) for name, shape in shapes.items()}
    found["status"] = np.zeros(count, dtype=np.int32)
    given = loaded(motion)
    rows = {name: given[name].reshape(count, math.prod(shape)) for name, shape in kernel.MOTION.items()}
    arithmetic = kernel.module("arithmetic").Arithmetic(np)
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
    given, zero = {name: getattr(motion, name) for name in kernel.MOTION}, np.zeros((*motion.shape, 3))
    return {name: zero if value is None else value for name, value in given.items()}
