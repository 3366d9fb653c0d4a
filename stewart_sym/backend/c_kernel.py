"""Calls of the C kernels by ctypes: arrays of poses as input, arrays of results and statuses as output."""

import ctypes
import functools
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..generated.interface import HEADERS, MODELS, OUTPUTS
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK, InverseDynamicsResult, JointReactionsResult
from ..robot.robot import Robot
from . import native
from .kernel import MOTION, overflows, robot_kernel, robot_numbers, takes_rotors
from .kernel_sources import generated_text


def c_sources(name: str) -> dict[str, str]:
    """Return the generated C sources of one kernel, text by file name; motion kernels contain the forces."""
    stems = dict.fromkeys((name.replace("_motion", "_forces"), name))
    names = (*HEADERS, *(f"stewart_{stem}.{kind}" for stem in stems for kind in "hc"))
    return {file: generated_text(f"c/{file}") for file in names}


@functools.cache
def library(name: str, precision: str = "double") -> ctypes.CDLL:
    """Compile and load the C code of one kernel for "double" or "float"; raises as ``native.load``."""
    flags = [*rotor_flags(name), *(["-DSTEWART_FLOAT"] if precision == "float" else [])]
    return native.load(f"stewart_{name}", c_sources(name), flags)


@functools.cache
def function(name: str, suffix: str, part: str = "", precision: str = "double") -> Any:
    """Return the C function ``stewart_<name>_<suffix>`` of a kernel, or of a part such as "_forces"."""
    return getattr(library(f"{name}{part}", precision), f"stewart_{name}_{suffix}")


def rotor_flags(name: str) -> list[str]:
    """Return the compiler flags that the C code of a kernel requires."""
    return ["-DSTEWART_ROTORS"] if takes_rotors(name) else []


class CKernel:
    """C kernel of one formulation with the constants of one robot; calls release the interpreter lock."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        """Compile the kernel or load it from the cache, and store the constants of the robot."""
        self._name = robot_kernel(robot, formulation)
        library(self._name)
        self._numbers = robot_numbers(robot, takes_rotors(self._name))

    def forces(self, motion: Motion) -> InverseDynamicsResult:
        """Compute the inverse dynamics of every pose; results are NaN if the status is not 0."""
        return InverseDynamicsResult(**self._run("inverse_dynamics", motion))

    def reactions(self, motion: Motion, bearing: Array) -> JointReactionsResult:
        """Compute the joint reactions of every pose; ``bearing`` (m) has shape (6,)."""
        return JointReactionsResult(**self._run("joint_reactions", motion, bearing))

    def _run(self, name: str, motion: Motion, *given: Array) -> dict[str, Any]:
        code = function(self._name, f"{name}_batch")
        return results_of(code, self._numbers, motion, OUTPUTS[name], given)


def results_of(
    function: Any,
    model: Array,
    motion: Motion,
    shapes: Mapping[str, tuple[int, ...]],
    given: Iterable[Array] = (),
    apart: bool = False,
) -> dict[str, Any]:
    """Call a C function for many poses; return its results, NaN if the status is not 0, and the status.

    ``shapes`` are the shapes of the results for one pose, and ``given`` the arrays after the motion. With
    ``apart``, the function takes the result arrays as separate arguments instead of a structure.
    """
    found = {name: np.full((*motion.shape, *of), np.nan, dtype=model.dtype) for name, of in shapes.items()}
    status = np.zeros(motion.shape, dtype=np.int32)
    targets = map(address, found.values()) if apart else [pointers(found.values())]
    arrays = [np.ascontiguousarray(array) for array in given]
    call(function, model, motion, *map(address, arrays), *targets, address(status))
    return {**found, "status": status}


def call(function: Any, model: Array, motion: Motion, *arguments: Any) -> Any:
    """Call a C function for many poses, and return its value; the motion gets the type of the constants."""
    with np.errstate(over="ignore"):
        arrays = (getattr(motion, name) for name in MOTION)
        inputs = [None if each is None else np.ascontiguousarray(each, model.dtype) for each in arrays]
    return function(address(model), ctypes.c_size_t(math.prod(motion.shape)), pointers(inputs), *arguments)


def prepared_model(prepare: Any, robot: Robot, name: str, precision: str) -> NDArray[Any]:
    """Prepare the constants of a robot with the function ``prepare`` of a kernel in MODELS, read-only.

    Raises ValueError if a constant overflows.
    """
    dtype, count = np.dtype(np.float64 if precision == "double" else np.float32), MODELS[name]
    with np.errstate(over="ignore"):
        numbers = robot_numbers(robot, takes_rotors(name), robot.offsets is not None).astype(dtype)
    # The constants are aligned to a cache line, so that no vector register load crosses a line.
    room = np.zeros(count + 64 // dtype.itemsize, dtype)
    first = -room.ctypes.data % 64 // dtype.itemsize
    model = room[first : first + count]
    if prepare(address(numbers), address(model)) != OK:
        raise overflows(precision)
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
