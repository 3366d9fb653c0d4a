"""The generated kernels by name: their sources and modules, and a robot's numbers as they take them."""

import importlib
from types import ModuleType

import numpy as np

from ..generated.interface import STRUCTS
from ..io.arguments import option
from ..io.array_types import Array
from ..robot.robot import Robot

FORMULATIONS = ("exact", "paper")
MOTION = STRUCTS["motion"]
"""Arrays of a motion in the order of ``stewart_motion``, with the shape of a pose's part."""
LEG, ROTOR, PLATFORM = (tuple(STRUCTS[name]) for name in ("leg", "rotor", "platform"))
_UPPER = np.triu_indices(3)


def kernel_name(formulation: str, base_joint: str) -> str:
    """Name of the generated kernel. Raises ValueError for an unknown formulation."""
    option(formulation, FORMULATIONS, "formulation")
    return formulation if base_joint == "universal" else f"{formulation}_{base_joint}"


def robot_kernel(robot: Robot, formulation: str) -> str:
    """Name of the kernel of a robot with all that it has, rotors of its legs included.

    Raises ValueError for an unknown formulation and for rotors where the formulation has none.
    """
    name = kernel_name(formulation, robot.base_joint)
    if not robot.has_rotors:
        return name
    if formulation == "paper":
        raise ValueError(
            'formulation: expected "exact" for a robot whose drive has rotor_inertia, got "paper"'
        )
    return f"{name}_drive"


def takes_rotors(name: str) -> bool:
    """Whether the legs of a kernel have rotors, by its name."""
    return "_drive" in name


def defines_of(name: str) -> tuple[str, ...]:
    """Macros that the C of a kernel needs."""
    return ("STEWART_ROTORS",) if takes_rotors(name) else ()


def module(name: str) -> ModuleType:
    """The generated NumPy module of one kernel."""
    return importlib.import_module(f"stewart_sym.generated.{name}")


def robot_numbers(robot: Robot, rotors: bool = False) -> Array:
    """The robot as the numbers of ``struct stewart_robot``, in its order; rotors: with those of its legs."""
    names = (*LEG, *ROTOR) if rotors else LEG
    legs = np.concatenate([columns(getattr(robot, name)) for name in names], axis=1)
    platform = [np.ravel(stored(np.asarray(getattr(robot, name)))) for name in PLATFORM]
    return np.concatenate([legs.ravel(), *platform])


def need_representable(robot: Robot, precision: str) -> None:
    """Raise ValueError naming the first constant that is too large for ``precision``, "double" or "float"."""
    largest = float(np.finfo(np.float64 if precision == "double" else np.float32).max)
    for name in (*LEG, *ROTOR, *PLATFORM):
        values = np.asarray(getattr(robot, name))
        for index in np.argwhere(np.abs(values) > largest):
            where = f"leg {index[0] + 1}: {name}" if name in (*LEG, *ROTOR) else name
            got = f"{values[tuple(index)]:g}"
            raise ValueError(f"robot: {where}: expected a number that {precision} can hold, got {got}")


def overflows(robot: Robot, precision: str) -> ValueError:
    """The error for constants that were too large to be prepared."""
    need_representable(robot, precision)
    return ValueError(f"robot: expected constants whose products {precision} can hold, some overflow")


def columns(values: Array) -> Array:
    """A robot's numbers of all legs, (6, n), symmetric tensors as stored."""
    return stored(values).reshape(6, -1)


def stored(values: Array) -> Array:
    """A symmetric tensor as its six stored components; anything else unchanged."""
    return values[..., *_UPPER] if values.shape[-2:] == (3, 3) else values
