"""Names and modules of the generated kernels, and the constants of a robot in the order of the kernels."""

from importlib import import_module
from types import ModuleType

import numpy as np

from ..generated.interface import STRUCTS
from ..io.arguments import option
from ..io.array_types import Array
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, need_masses, of_symbol
from .kernel_sources import PACKAGE

FORMULATIONS = ("exact", "paper")
MOTION = STRUCTS["motion"]
"""Arrays of a motion in the order of ``stewart_motion``, with their shapes for one pose."""
LEG, ROTOR, PLATFORM = (tuple(STRUCTS[name]) for name in ("leg", "rotor", "platform"))
_UPPER = np.triu_indices(3)

OFFSET_KERNEL = "exact_offset"
"""Name of the kernel of legs with offset joints, which computes only actuator forces."""
OFFSETS = ("cross", "along", "across", "cross_mass", "cross_center", "cross_inertia")
"""Constants of ``JointOffsets`` that the offset kernel takes, in its order."""


def kernel_name(formulation: str, base_joint: str) -> str:
    """Return the name of the generated kernel; raise ValueError for an unknown formulation."""
    option(formulation, FORMULATIONS, "formulation")
    return formulation if base_joint == "universal" else f"{formulation}_{base_joint}"


def robot_kernel(robot: Robot, formulation: str) -> str:
    """Return the name of the kernel of a robot with its rotors; raise ValueError if there is none."""
    name = kernel_name(formulation, robot.base_joint)
    need_no_offsets(robot)
    need_masses(robot)
    if not robot.has_rotors:
        return name
    need_exact(formulation, "whose drive has rotor_inertia")
    return f"{name}_drive"


def force_kernel(robot: Robot, formulation: str) -> str:
    """Return the name of the force kernel of a robot, which may have offsets; raise ValueError if none."""
    if robot.offsets is None:
        return robot_kernel(robot, formulation)
    need_masses(robot)
    need_exact(formulation, "with offset joints")
    if robot.offsets.has_spinning_parts:
        raise ValueError(
            'robot: offsets: platform_joint: expected "spherical", got "universal"; use inverse_dynamics'
        )
    return OFFSET_KERNEL


def need_exact(formulation: str, whose: str) -> None:
    """Raise ValueError unless the formulation is "exact"; ``whose`` describes the robot that requires it."""
    option(formulation, FORMULATIONS, "formulation")
    if formulation != "exact":
        raise ValueError(f'formulation: expected "exact" for a robot {whose}, got "{formulation}"')


def takes_rotors(name: str) -> bool:
    """Return True if the legs of the kernel with this name have rotors."""
    return "_drive" in name


def module(name: str) -> ModuleType:
    """Import the generated NumPy module of one kernel."""
    return import_module(f"{PACKAGE}.{name}")


def robot_numbers(robot: Robot, rotors: bool = False, offsets: bool = False) -> Array:
    """Return the constants of a robot in the order of ``stewart_robot`` or ``stewart_offset_robot``."""
    legs = [columns(of_symbol(robot, name)) for name in ((*LEG, *ROTOR) if rotors or offsets else LEG)]
    if offsets:
        legs += [columns(of_symbol(robot.offsets, name)) for name in OFFSETS]
    else:
        need_no_offsets(robot)
    platform = [np.ravel(stored(np.asarray(of_symbol(robot, name)))) for name in PLATFORM]
    return np.concatenate([np.concatenate(legs, axis=1).ravel(), *platform])


def overflows(precision: str) -> ValueError:
    """Return the error for constants that overflow during their preparation."""
    return ValueError(f"robot: constants or their products exceed the range of {precision}; use smaller ones")


def columns(values: Array) -> Array:
    """Return constants of all legs as shape (6, n), symmetric tensors in stored form."""
    return stored(values).reshape(6, -1)


def stored(values: Array) -> Array:
    """Return the six stored components of a symmetric tensor; return other arrays unchanged."""
    return values[..., *_UPPER] if values.shape[-2:] == (3, 3) else values
