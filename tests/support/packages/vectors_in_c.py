"""What the C makes of test vectors, over their bounds."""

import ctypes
from functools import cache

import kits
import numpy as np
from numpy.typing import NDArray

from stewart_sym.backend import c_kernel, native
from stewart_sym.backend.c_kernel import address
from stewart_sym.backend.kernel import kernel_name, robot_numbers
from stewart_sym.derive.kernel.interface import CALLS, STRUCTS
from stewart_sym.dynamics import closed_form
from stewart_sym.dynamics.forces import ForceKernel
from stewart_sym.kit.kit_options import STEMS, TORQUE
from stewart_sym.kit.vectors import CLOSED_FORM, FUNCTIONS, KINEMATICS, ROTATION, Vector, vectors
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]

KIND = {"double": np.float64, "float": np.float32}
WHOLE = ("inverse_dynamics", "joint_reactions")


def functions_of(robot: Robot, formulation: str = "exact") -> tuple[str, ...]:
    """All functions in C that there are for a machine without a drive."""
    closed = formulation == "exact" and robot.base_joint == "universal"
    left_out = STEMS[TORQUE] if closed else (*CLOSED_FORM, *STEMS[TORQUE])
    return tuple(function for function in FUNCTIONS if function not in left_out)


@cache
def motion_library(precision: str) -> ctypes.CDLL:
    if precision == "double":
        return closed_form.library()
    return native.load("stewart_exact_motion", closed_form.c_sources(), ["-O0"], {"STEWART_FLOAT": 1})


def in_c(robot: Robot, vector: Vector, formulation: str, precision: str, fidelity: str) -> dict[str, Array]:
    """What the C makes of a vector's inputs, by member."""
    kind, function = KIND[precision], vector.function
    first, found = [robot_numbers(robot)], {}
    if function in (*KINEMATICS, *ROTATION, *WHOLE):
        name = kernel_name(formulation, robot.base_joint)
        file = name if function in WHOLE else "rotation" if function in ROTATION else "kinematics"
        library = c_kernel.library(file, ("STEWART_FLOAT",) if precision == "float" else ())
        call = getattr(library, f"stewart_{f'{name}_' if function in WHOLE else ''}{function}")
        first = [] if function in ROTATION else first
    else:
        level = fidelity if function == "forces" else "general"
        prepared = ForceKernel(robot, formulation, precision=precision, fidelity=level)
        first, call = [prepared.model], prepared.c_function("forces")
        if function in CLOSED_FORM:
            call = getattr(motion_library(precision), f"stewart_{prepared.name}_{function}")
    passed = [each.astype(kind) for each in first]
    for argument in CALLS[function].arguments:
        members = STRUCTS[argument.struct] if argument.struct else argument.takes or argument.gives
        parts = [np.zeros(member.count) for member in members]
        for i, member in enumerate(members if argument.is_motion else argument.takes):
            parts[i] = vector.inputs.get(member.name, parts[i])
        numbers = np.concatenate(parts).astype(kind)
        passed.append(numbers)
        cuts = np.cumsum([member.count for member in members])[:-1]
        held = dict(zip((member.name for member in members), np.split(numbers, cuts), strict=True))
        found |= {member.name: held[member.name] for member in argument.gives}
    assert call(*map(address, passed)) == 0
    return {name: numbers.astype(np.float64) for name, numbers in found.items()}


def ratios(vector: Vector, found: dict[str, Array], precision: str) -> Array:
    """Errors over their bounds."""
    epsilon = float(np.finfo(KIND[precision]).eps)
    return np.concatenate(
        [
            np.abs(found[name] - answer) / (vector.bounds[name] * epsilon)
            for name, answer in vector.answers.items()
        ]
    )


def ratios_in_c(
    robot: Robot,
    functions: tuple[str, ...],
    formulation: str,
    precision: str,
    fidelity: str = "general",
    count: int = 8,
) -> dict[str, Array]:
    made = vectors(robot, functions, formulation, fidelity, precision, count)
    return {
        function: np.concatenate(
            [
                ratios(v, in_c(robot, v, formulation, precision, fidelity), precision)
                for v in made
                if v.function == function
            ]
        )
        for function in functions
    }


@cache
def machine(base_joint: str = "universal") -> Robot:
    return kits.machine("random" if base_joint == "universal" else base_joint)
