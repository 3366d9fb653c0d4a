"""The generated kernels by name: their sources and modules, and a robot's numbers as they take them."""

import importlib
from collections.abc import Sequence
from types import ModuleType

import numpy as np

from ..generated.interface import STRUCTS
from ..io.arguments import option
from ..io.array_types import Array
from ..robot.offsets import JointOffsets, need_no_offsets
from ..robot.robot import Robot, of_symbol

FORMULATIONS = ("exact", "paper")
MOTION = STRUCTS["motion"]
"""Arrays of a motion in the order of ``stewart_motion``, with the shape of a pose's part."""
LEG, ROTOR, PLATFORM = (tuple(STRUCTS[name]) for name in ("leg", "rotor", "platform"))
_UPPER = np.triu_indices(3)


OFFSET_KERNEL = "exact_offset"
"""The kernel of legs with offset joints: the actuator forces alone."""
OFFSETS = ("cross", "along", "across", "cross_mass", "cross_center", "cross_inertia")
"""What it takes of ``robot.Offsets``, in its order."""


def kernel_name(formulation: str, base_joint: str) -> str:
    """Name of the generated kernel. Raises ValueError for an unknown formulation."""
    option(formulation, FORMULATIONS, "formulation")
    return formulation if base_joint == "universal" else f"{formulation}_{base_joint}"


def robot_kernel(robot: Robot, formulation: str) -> str:
    """Name of the kernel of a robot with all that it has, rotors of its legs included.

    Raises ValueError for an unknown formulation and for rotors where the formulation has none.
    """
    name = kernel_name(formulation, robot.base_joint)
    need_no_offsets(robot)
    if not robot.has_rotors:
        return name
    if formulation == "paper":
        raise ValueError(
            'formulation: expected "exact" for a robot whose drive has rotor_inertia, got "paper"'
        )
    return f"{name}_drive"


def offset_kernel(robot: Robot, formulation: str) -> str:
    """``OFFSET_KERNEL``, for robots with offset joints that it covers.

    Raises ValueError for another formulation than "exact" and for universal platform joints.
    """
    need_offset_formulation(formulation)
    if robot.offsets is not None and robot.offsets.has_spinning_parts:
        raise ValueError(
            'robot: offsets: platform_joint: expected "spherical", since no kernel has other ones; '
            "inverse_dynamics computes them"
        )
    return OFFSET_KERNEL


def need_offset_formulation(formulation: str) -> None:
    """Reject, by ValueError, what legs with offset joints are not computed by."""
    option(formulation, FORMULATIONS, "formulation")
    if formulation != "exact":
        raise ValueError(f'formulation: expected "exact" for a robot with offset joints, got "{formulation}"')


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
    need_no_offsets(robot)
    names = (*LEG, *ROTOR) if rotors else LEG
    return _numbers(robot, [columns(of_symbol(robot, name)) for name in names])


def offset_numbers(robot: Robot) -> Array:
    """The robot as the numbers of ``struct stewart_offset_robot``, in its order."""
    offsets = JointOffsets() if robot.offsets is None else robot.offsets
    own = [columns(of_symbol(robot, name)) for name in (*LEG, *ROTOR)]
    return _numbers(robot, own + [columns(of_symbol(offsets, name)) for name in OFFSETS])


def _numbers(robot: Robot, of_legs: Sequence[Array]) -> Array:
    legs = np.concatenate(of_legs, axis=1)
    platform = [np.ravel(stored(np.asarray(of_symbol(robot, name)))) for name in PLATFORM]
    return np.concatenate([legs.ravel(), *platform])


def need_representable(robot: Robot, precision: str) -> None:
    """Raise ValueError naming the first constant that is too large for ``precision``, "double" or "float"."""
    largest = float(np.finfo(np.float64 if precision == "double" else np.float32).max)
    for name in (*LEG, *ROTOR, *PLATFORM):
        values = np.asarray(of_symbol(robot, name))
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
