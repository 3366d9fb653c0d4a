"""The generated kernels, bound to a robot: C through ctypes, and NumPy.

Takes a checked Robot and Motion, hands arrays to the generated code and its results back. Knows the layout of
stewart.h and nothing of the equations.
"""

import ctypes
import functools
import importlib
from dataclasses import dataclass
from importlib.resources import files
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import native
from .checks import option
from .frozen import Frozen, read_only
from .generated.interface import HEADERS, OUTPUTS, STRUCTS
from .motion import Motion
from .results import Forces, Reactions
from .robot import Robot

Array = NDArray[np.float64]

FORMULATIONS = ("exact", "paper")
MOTION = STRUCTS["motion"]
"""Arrays of a motion in the order of ``stewart_motion``, with the shape of a pose's part."""

_LEG, _PLATFORM = (tuple(STRUCTS[name]) for name in ("leg", "platform"))
_UPPER = np.triu_indices(3)


def kernel_name(formulation: str, base_joint: str) -> str:
    """Name of the generated kernel. Raises ValueError for an unknown formulation."""
    option(formulation, FORMULATIONS, "formulation")
    return formulation if base_joint == "universal" else f"{formulation}_{base_joint}"


def c_sources(name: str) -> dict[str, str]:
    """File name -> text of the generated C of one kernel."""
    folder = files("stewart_sym.generated") / "c"
    return {
        file: (folder / file).read_text(encoding="utf-8")
        for file in (*HEADERS, f"stewart_{name}.h", f"stewart_{name}.c")
    }


def module(name: str) -> ModuleType:
    """The generated NumPy module of one kernel."""
    return importlib.import_module(f"stewart_sym.generated.{name}")


@functools.cache
def library(name: str, defines: tuple[str, ...] = ()) -> ctypes.CDLL:
    """The compiled C of one kernel, with macros defined.

    Raises native.CompilerError where there is no working compiler.
    """
    return native.load(f"stewart_{name}", c_sources(name), defines=dict.fromkeys(defines, 1))


def robot_numbers(robot: Robot) -> Array:
    """The robot as the numbers of ``struct stewart_robot``, in its order."""
    legs = np.concatenate([_columns(getattr(robot, name)) for name in _LEG], axis=1)
    platform = [np.ravel(stored(np.asarray(getattr(robot, name)))) for name in _PLATFORM]
    return np.concatenate([legs.ravel(), *platform])


def need_held(robot: Robot, precision: str) -> None:
    """Raise ValueError naming the first constant that is too large for ``precision``, "double" or "float"."""
    largest = float(np.finfo(np.float64 if precision == "double" else np.float32).max)
    for name in (*_LEG, *_PLATFORM):
        values = np.asarray(getattr(robot, name))
        for index in np.argwhere(np.abs(values) > largest):
            where = f"leg {index[0] + 1}: {name}" if name in _LEG else name
            got = f"{values[tuple(index)]:g}"
            raise ValueError(f"robot: {where}: expected a number that {precision} can hold, got {got}")


def overflows(robot: Robot, precision: str) -> ValueError:
    """The error for constants that were too large to be prepared."""
    need_held(robot, precision)
    return ValueError(f"robot: expected constants whose products {precision} can hold, some overflow")


def _columns(values: Array) -> Array:
    return stored(values).reshape(6, -1)


def stored(values: Array) -> Array:
    """A symmetric tensor as its six stored components; anything else unchanged."""
    return values[..., *_UPPER] if values.shape[-2:] == (3, 3) else values


@dataclass(frozen=True, eq=False)
class CKernel(Frozen):
    """The C kernel of one formulation with one robot's numbers. Calls release the interpreter lock."""

    name: str
    numbers: Array

    @classmethod
    def prepare(cls, robot: Robot, formulation: str) -> "CKernel":
        """Compile or find the kernel and lay out the robot."""
        name = kernel_name(formulation, robot.base_joint)
        library(name)
        return cls(name, read_only(robot_numbers(robot)))

    def forces(self, motion: Motion) -> Forces:
        """Inverse dynamics of every pose; NaN where the status is not 0."""
        outputs, status = self._run("inverse_dynamics", motion, None)
        return Forces(**outputs, status=status)

    def reactions(self, motion: Motion, bearing: Array) -> Reactions:
        """Joint reactions of every pose; ``bearing`` (6,), m. NaN where the status is not 0."""
        outputs, status = self._run("joint_reactions", motion, np.ascontiguousarray(bearing))
        return Reactions(**outputs, status=status)

    def _run(
        self, function: str, motion: Motion, bearing: Array | None
    ) -> tuple[dict[str, Array], NDArray[np.int32]]:
        inputs = [contiguous(getattr(motion, name)) for name in MOTION]
        outputs = {
            name: np.full((*motion.shape, *shape), np.nan) for name, shape in OUTPUTS[function].items()
        }
        status = np.zeros(motion.shape, dtype=np.int32)
        call = getattr(library(self.name), f"stewart_{self.name}_{function}_batch")
        call(
            address(self.numbers),
            ctypes.c_size_t(status.size),
            (ctypes.c_void_p * len(inputs))(*[address(array) for array in inputs]),
            *([] if bearing is None else [address(bearing)]),
            (ctypes.c_void_p * len(outputs))(*[address(array) for array in outputs.values()]),
            address(status),
        )
        return outputs, status


def contiguous(array: Array | None) -> Array | None:
    """The array as C takes it; None for None."""
    return None if array is None else np.ascontiguousarray(array)


def address(array: NDArray[Any] | None, entries: int = 0) -> ctypes.c_void_p:
    """Where an entry of a contiguous array lies; null for None."""
    if array is None:
        return ctypes.c_void_p(None)
    try:
        # Far quicker than the array's interface, which has to serve where an array is read-only or empty.
        start = ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    except (TypeError, ValueError):
        start = array.__array_interface__["data"][0]
    return ctypes.c_void_p(start + entries * array.itemsize)


@dataclass(frozen=True, eq=False)
class NumpyKernel:
    """The NumPy kernel of one formulation with one robot."""

    name: str
    robot: Robot

    @classmethod
    def prepare(cls, robot: Robot, formulation: str) -> "NumpyKernel":
        """Choose the module."""
        return cls(kernel_name(formulation, robot.base_joint), robot)

    def forces(self, motion: Motion) -> Forces:
        """Inverse dynamics of every pose; NaN where the status is not 0."""
        return Forces(**module(self.name).inverse_dynamics(self.robot, loaded(motion)))

    def terms(self, motion: Motion) -> dict[str, Array]:
        """D, K, H and c of every pose, nothing solved: numbers where H is singular, no status."""
        source, pose = module(self.name), loaded(motion)
        with np.errstate(all="ignore"):
            leg, platform = source.leg_dynamics(self.robot, pose), source.platform_wrench(self.robot, pose)
            wrenches = np.concatenate([leg["c_force"], leg["c_moment"]], axis=-1)
            c = np.concatenate([platform["c_force"], platform["c_moment"]], axis=-1) + wrenches.sum(axis=-2)
        H = np.concatenate([leg["H_force"], leg["H_moment"]], axis=-1).swapaxes(-1, -2)
        return {"D": leg["D"], "K": leg["K"], "H": H, "c": c}

    def reactions_of(self, motion: Motion, x: Array, bearing: Array) -> dict[str, Array]:
        """Joint reactions by name under axial forces x, N, (..., 6); ``bearing`` (6,), m. No status."""
        found: dict[str, Array] = module(self.name).joint_reactions(self.robot, loaded(motion), x, bearing)
        return found

    def reactions(self, motion: Motion, bearing: Array) -> Reactions:
        """Joint reactions of every pose; ``bearing`` (6,), m. NaN where the status is not 0."""
        forces = self.forces(motion)
        found = self.reactions_of(motion, forces.x, bearing)
        bad = forces.status != 0
        blank = {
            name: np.where(bad[(..., *(None,) * (value.ndim - bad.ndim))], np.nan, value)
            for name, value in found.items()
        }
        return Reactions(**blank, status=forces.status)


def loaded(motion: Motion) -> SimpleNamespace:
    """The motion with zeros for a load that is not given."""
    given = {name: getattr(motion, name) for name in MOTION}
    return SimpleNamespace(
        **{name: np.zeros((*motion.shape, 3)) if value is None else value for name, value in given.items()}
    )
