"""The C kernels through ctypes: arrays of poses in, arrays and statuses out."""

import ctypes
import functools
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..generated.interface import HEADERS, OUTPUTS
from ..io.array_types import Array
from ..io.frozen import Frozen, read_only
from ..motion.motion import Motion
from ..results import OK, InverseDynamicsResult, JointReactionsResult
from ..robot.robot import Robot
from . import native
from .kernel import MOTION, defines_of, offset_numbers, overflows, robot_kernel, robot_numbers, takes_rotors


def c_sources(name: str) -> dict[str, str]:
    """File name -> text of the generated C of one kernel."""
    return {file: generated_c(file) for file in (*HEADERS, f"stewart_{name}.h", f"stewart_{name}.c")}


def generated_c(file: str) -> str:
    """Text of a file of the generated C."""
    return (files("stewart_sym.generated") / "c" / file).read_text(encoding="utf-8")


@functools.cache
def library(name: str, defines: tuple[str, ...] = (), flags: tuple[str, ...] = ()) -> ctypes.CDLL:
    """The compiled C of one kernel, with macros defined; flags: after those of every library.

    Raises native.CompilerError where there is no working compiler.
    """
    macros = dict.fromkeys((*defines, *defines_of(name)), 1)
    return native.load(f"stewart_{name}", c_sources(name), flags, macros)


@dataclass(frozen=True, eq=False)
class CKernel(Frozen):
    """The C kernel of one formulation with one robot's numbers. Calls release the interpreter lock."""

    name: str
    numbers: Array

    @classmethod
    def prepare(cls, robot: Robot, formulation: str) -> "CKernel":
        """Compile or find the kernel and lay out the robot."""
        name = robot_kernel(robot, formulation)
        library(name)
        return cls(name, read_only(robot_numbers(robot, takes_rotors(name))))

    def forces(self, motion: Motion) -> InverseDynamicsResult:
        """Inverse dynamics of every pose; NaN where the status is not 0."""
        return InverseDynamicsResult(**self._run("inverse_dynamics", motion))

    def reactions(self, motion: Motion, bearing: Array) -> JointReactionsResult:
        """Joint reactions of every pose; ``bearing`` (6,), m. NaN where the status is not 0."""
        return JointReactionsResult(**self._run("joint_reactions", motion, np.ascontiguousarray(bearing)))

    def _run(self, function: str, motion: Motion, *given: Array) -> dict[str, Any]:
        code = getattr(library(self.name), f"stewart_{self.name}_{function}_batch")
        return results_of(code, self.numbers, motion, OUTPUTS[function], given)


def results_of(
    function: Any,
    model: Array,
    motion: Motion,
    shapes: Mapping[str, tuple[int, ...]],
    given: Iterable[Array | None] = (),
    apart: bool = False,
) -> dict[str, Any]:
    """What a C function of many poses writes, by name: arrays, NaN where the status is not 0, and the status.

    shapes: of the parts of one pose. given: arrays that the function takes after the motion. apart: whether
    it takes the results one by one and not as a structure.
    """
    found = {name: np.full((*motion.shape, *of), np.nan, dtype=model.dtype) for name, of in shapes.items()}
    status = np.zeros(motion.shape, dtype=np.int32)
    targets = map(address, found.values()) if apart else [pointers(found.values())]
    call(function, model, motion, *map(address, given), *targets, address(status))
    return {**found, "status": status}


def call(function: Any, model: Array, motion: Motion, *arguments: Any) -> Any:
    """Call a C function of many poses with a robot's numbers, a motion in their precision, and what follows.

    Returns what the function returns.
    """
    with np.errstate(over="ignore"):
        inputs = [contiguous(getattr(motion, name), model.dtype) for name in MOTION]
    return function(address(model), ctypes.c_size_t(math.prod(motion.shape)), pointers(inputs), *arguments)


@functools.cache
def function(name: str, part: str, precision: str, what: str) -> Any:
    """The C function ``stewart_<name>_<what>`` of the library of a kernel's part, for "double" or "float"."""
    defines = ("STEWART_FLOAT",) if precision == "float" else ()
    return getattr(library(f"{name}_{part}", defines), f"stewart_{name}_{what}")


def prepared_model(
    prepare: Any, robot: Robot, count: int, precision: str, rotors: bool = False, offsets: bool = False
) -> NDArray[Any]:
    """So many constants that a C function prepares from a robot, with its rotors where the kernel takes them.

    offsets: whether the kernel is that of offset joints. They are read-only, where C reads them fastest.
    Raises ValueError where they overflow.
    """
    dtype = np.float64 if precision == "double" else np.float32
    with np.errstate(over="ignore"):
        given = offset_numbers(robot) if offsets else robot_numbers(robot, rotors)
        numbers = given.astype(dtype)
    # They begin with a line of the cache, so that no vector of constants lies in two.
    size = count * np.dtype(dtype).itemsize
    room = np.zeros(size + 63, dtype=np.uint8)
    first = -room.ctypes.data % 64
    model = room[first : first + size].view(dtype)
    if prepare(address(numbers), address(model)) != OK:
        raise overflows(robot, precision)
    for each in (room, model):
        each.setflags(write=False)
    return model


def pointers(arrays: Iterable[Array | None]) -> Any:
    """The addresses of arrays as C takes them: a structure of pointers."""
    found = [address(array) for array in arrays]
    return (ctypes.c_void_p * len(found))(*found)


def contiguous(array: Array | None, dtype: Any = None) -> Array | None:
    """The array as C takes it, of another type if one is given; None for None."""
    return None if array is None else np.ascontiguousarray(array, dtype=dtype)


def address(array: NDArray[Any] | None, entries: int = 0) -> ctypes.c_void_p:
    """Where an entry of a contiguous array lies; null for None."""
    if array is None:
        return ctypes.c_void_p(None)
    if array.flags.carray and array.size > 0:
        # Far quicker than the array's interface, which has to serve where an array is read-only or empty.
        start = ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    else:
        start = array.__array_interface__["data"][0]
    return ctypes.c_void_p(start + entries * array.itemsize)
