"""Calls of the C kernels by ctypes: arrays of poses as input, arrays of results and statuses as output."""

import ctypes
import functools
import math
import struct
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend import native
from ..backend.kernel import MOTION, generated_text, overflows, robot_kernel, robot_numbers
from ..generated.interface import HEADERS, MODELS, OUTPUTS
from ..io.array_types import Array
from ..motion.motion import Motion
from ..results import OK
from ..robot.robot import Robot
from .threads import in_parts


def c_sources(name: str) -> dict[str, str]:
    """Return the generated C sources of one kernel, text by file name; motion kernels contain the forces."""
    stems = dict.fromkeys((name.replace("_motion", "_forces"), name))
    names = (*HEADERS, *(f"stewart_{stem}.{kind}" for stem in stems for kind in "hc"))
    return {file: generated_text(f"c/{file}") for file in names}


@functools.lru_cache(64)
def prepared(kind: Callable[..., Any], robot: Robot, *options: Any) -> Any:
    """Create a kernel for a robot, or return the one that an earlier call created; robots never change."""
    return kind(robot, *options)


@functools.cache
def library(name: str, precision: str = "double") -> ctypes.CDLL:
    """Compile and load the C code of one kernel for "double" or "float"; raises as ``native.load``."""
    flags = {"-DSTEWART_ROTORS": "_drive" in name, "-DSTEWART_FLOAT": precision == "float"}
    return native.load(f"stewart_{name}", c_sources(name), [flag for flag in flags if flags[flag]])


@functools.cache
def function(name: str, suffix: str, part: str = "", precision: str = "double") -> Any:
    """Return the C function ``stewart_<name>_<suffix>`` of a kernel, or of a part such as "_forces"."""
    return getattr(library(f"{name}{part}", precision), f"stewart_{name}_{suffix}")


class CKernel:
    """C functions of one kernel with the constants of one robot; calls release the interpreter lock."""

    def __init__(self, robot: Robot, formulation: str, part: str = "", precision: str = "double") -> None:
        """Compile a part of the kernel or load it from the cache, and prepare the constants of the robot.

        ``part`` is "" for inverse dynamics and joint reactions, "_motion" for the closed form, or "_bounds".
        Raises ValueError for a robot without this kernel or with constants that overflow.
        """
        self._name, self._part, self._precision = robot_kernel(robot, formulation), part, precision
        library(f"{self._name}{part}", precision)
        if part:
            prefix, name = ("bounds_", f"{self._name}_bounds") if part == "_bounds" else ("", self._name)
            self._model = prepared_model(self.function(f"{prefix}prepare"), robot, name, precision)
        else:
            self._model = robot_numbers(robot, self._name)

    def function(self, suffix: str) -> Any:
        """Return the C function of the kernel with this suffix."""
        return function(self._name, suffix, self._part, self._precision)

    def run(self, output: str, motion: Motion, *given: Array) -> dict[str, Any]:
        """Return the results of an output by name, NaN if the status is not 0, and the status (...).

        ``given`` are the arrays after the motion: the distances of the bearings (m), (6,), or the forces (N),
        (..., 6), with the shape of the motion.
        """
        shapes, apart = _SHAPES[output], output not in _STRUCTURES
        return results_of(self.function(f"{output}_batch"), self._model, motion, shapes, given, apart)

    def single_pose(self, output: str, *arrays: Array) -> "OnePose":
        """Return buffers for one pose; ``arrays`` are the other inputs and the result."""
        return OnePose(self.function(output), self._model, *arrays)


_SHAPES = {**OUTPUTS, "forces_bounded": {"F": (6,), "bound": (6,), "rcond": ()}}
# Outputs whose results are members of a structure; other results are separate arguments.
_STRUCTURES = ("inverse_dynamics", "joint_reactions", "equations", "derivatives", "linearization")


def results_of(
    function: Any,
    model: Array,
    motion: Motion,
    shapes: Mapping[str, tuple[int, ...]],
    given: Sequence[Any] = (),
    apart: bool = False,
    threads: int = 1,
) -> dict[str, Any]:
    """Call a C function for many poses; return its results, NaN if the status is not 0, and the status.

    ``shapes`` are the shapes of the results for one pose. For other arguments see ``run_batch``.
    """
    lead = motion.shape
    found = {name: np.empty((*lead, *of), model.dtype) for name, of in shapes.items()}
    status = np.zeros(lead, dtype=np.int32)
    arrays = [getattr(motion, name) for name in MOTION]
    run_batch(function, model, arrays, [*found.values()], status, given, apart, threads)
    if np.count_nonzero(status):
        for values in found.values():
            values[status != OK] = np.nan
    return {**found, "status": status}


def run_batch(
    function: Any,
    model: Array,
    motion: Sequence[Array | None],
    results: Sequence[Array],
    status: NDArray[np.int32],
    given: Sequence[Any] = (),
    apart: bool = False,
    threads: int = 1,
    stride: int | None = None,
) -> None:
    """Call a C function for many poses, in parts on threads, and write results and statuses.

    ``motion`` contains arrays in the order of ``MOTION``, which get the type of the constants. ``given`` are
    the arguments after the motion: arrays with a row for each pose, or arguments that all poses share. With
    ``apart``, the function takes the result arrays as separate arguments instead of a structure. With a
    ``stride``, all arrays have the type and layout of C: 0 for rows, otherwise views of columns with this
    distance in numbers.
    """
    count, dtype = status.size, model.dtype
    ready = stride is not None or all(
        each is None or (each.dtype == dtype and each.flags.c_contiguous) for each in motion
    )
    if status.ndim > 1:
        motion, results = ([_rows(each, count) for each in arrays] for arrays in (motion, results))
        given, status = (
            [_rows(each, count) if _has_rows(each) else each for each in given],
            status.reshape(count),
        )
    constants, strides = address(model), [ctypes.c_size_t(stride)] if stride else []

    def run(start: int, poses: int) -> None:
        inputs, outputs, others, codes = motion, results, given, status
        if poses < count:
            part = slice(start, start + poses)
            inputs = [each if each is None else each[part] for each in motion]
            outputs, codes = [each[part] for each in results], status[part]
            others = [each[part] if _has_rows(each) else each for each in given]
        if not ready:
            with np.errstate(over="ignore"):
                inputs = [each if each is None else np.ascontiguousarray(each, dtype) for each in inputs]
        others = [np.ascontiguousarray(each) if isinstance(each, np.ndarray) else each for each in others]
        function(
            constants,
            ctypes.c_size_t(poses),
            *strides,
            pointers(inputs),
            *(address(each) if isinstance(each, np.ndarray) else each for each in others),
            *(map(address, outputs) if apart else [pointers(outputs)]),
            address(codes),
        )

    in_parts(count, threads, run, bounded=not ready)


def _rows(array: Array | None, count: int) -> Any:
    """Return an array with one row for each pose."""
    return None if array is None else array.reshape(count, array.size // max(count, 1))


def _has_rows(argument: Any) -> bool:
    """Return True for an array with a row for each pose, in contrast to arguments that all poses share."""
    return isinstance(argument, np.ndarray) and argument.ndim > 1


_NOTHING = np.zeros(3)


class OnePose:
    """Buffers of one pose: set the inputs R, t, omega, ..., M_ext in place, call ``solve``, and read ``F``.

    The inputs are views of ``numbers``, (30,), with the order of ``stewart_motion``. ``solve`` returns the
    status; results do not change if the status is not 0.
    """

    R: Array
    t: Array
    omega: Array
    v: Array
    alpha: Array
    a: Array
    F_ext: Array
    M_ext: Array

    def __init__(self, function: Any, model: Array, *arrays: Array) -> None:
        """Store the addresses of the buffers; ``arrays`` follow the motion in C, F is the first of them."""
        ends = np.cumsum([math.prod(shape) for shape in MOTION.values()])
        self.numbers, self.F = np.zeros(ends[-1], dtype=model.dtype), arrays[0]
        for (name, shape), part in zip(MOTION.items(), np.split(self.numbers, ends), strict=False):
            setattr(self, name, part.reshape(shape))
        # These references keep the arrays alive as long as this object.
        self._function, self._arrays = function, (model, self.numbers, *arrays)
        self._addresses = [address(array) for array in self._arrays]
        self._inputs = [(name, getattr(self, name)) for name in MOTION]

    def load(self, motion: Motion) -> None:
        """Set the inputs to a motion of shape (); missing accelerations and loads are zero."""
        for name, own in self._inputs:
            value = getattr(motion, name)
            own[...] = _NOTHING if value is None else value

    def solve(self) -> int:
        """Compute the results from the current numbers; return the status."""
        return int(self._function(*self._addresses))


def prepared_model(prepare: Any, robot: Robot, name: str, precision: str) -> NDArray[Any]:
    """Prepare the constants of a robot with the function ``prepare`` of a kernel in MODELS, read-only.

    Raises ValueError if a constant overflows.
    """
    dtype, count = np.dtype(np.float64 if precision == "double" else np.float32), MODELS[name]
    with np.errstate(over="ignore"):
        numbers = robot_numbers(robot, name).astype(dtype)
    # The constants are aligned to a cache line, so that no vector register load crosses a line.
    room = np.zeros(count + 64 // dtype.itemsize, dtype)
    first = -room.ctypes.data % 64 // dtype.itemsize
    model = room[first : first + count]
    if prepare(address(numbers), address(model)) != OK:
        raise overflows(precision)
    for each in (room, model):
        each.setflags(write=False)
    return model


def pointers(arrays: Iterable[Array | None]) -> bytes:
    """Return the addresses of arrays as a C structure of pointers."""
    found = [0 if array is None else _location(array) for array in arrays]
    return struct.pack(f"{len(found)}P", *found)


def address(array: NDArray[Any] | None) -> ctypes.c_void_p:
    """Return the address of an array, or NULL for None."""
    return ctypes.c_void_p(None if array is None else _location(array))


def _location(array: NDArray[Any]) -> int:
    """Return the address of an array as a number."""
    if array.flags.carray and array.size > 0:
        # This is much faster than the array interface, which is required only for read-only or empty arrays.
        return ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    return int(array.__array_interface__["data"][0])
