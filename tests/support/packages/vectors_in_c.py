"""What the C makes of test vectors, over their bounds."""

import ctypes
from functools import cache

import kits
import numpy as np
from numpy.typing import NDArray

from stewart_sym.backend import c_kernel, native
from stewart_sym.backend.c_kernel import address
from stewart_sym.backend.kernel import MOTION, kernel_name, robot_numbers
from stewart_sym.dynamics import closed_form
from stewart_sym.dynamics.forces import prepare
from stewart_sym.kit.choice import STEMS, TORQUE
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
    """What the C makes of a vector's inputs, as the answers are laid out."""
    kind = KIND[precision]
    if vector.function in KINEMATICS:
        return kinematics_in_c(robot, vector, precision)
    if vector.function in ROTATION:
        return rotation_in_c(vector, precision)
    motion = np.concatenate([vector.inputs[name] for name in MOTION]).astype(kind)
    found = np.full(sum(answer.size for answer in vector.answers.values()), np.nan, dtype=kind)
    further = [vector.inputs[name].astype(kind) for name in ("F", "bearing") if name in vector.inputs]
    if vector.function == "joint_reactions":
        further.append(np.empty(78, dtype=kind))  # the forces, F D x K H c
    if vector.function in WHOLE:
        name = kernel_name(formulation, robot.base_joint)
        library = c_kernel.library(name, ("STEWART_FLOAT",) if precision == "float" else ())
        model = robot_numbers(robot).astype(kind)
    else:
        level = fidelity if vector.function == "forces" else "general"
        prepared = prepare(robot, formulation, precision=precision, fidelity=level)
        name, model = prepared.name, prepared.model
        library = motion_library(precision) if vector.function in CLOSED_FORM else None
    function = f"stewart_{name}_{vector.function}"
    call = getattr(library, function) if library else prepared.function("forces")
    assert call(*map(address, (model, motion, *further, found))) == 0
    return split(vector, found)


def kinematics_in_c(robot: Robot, vector: Vector, precision: str) -> dict[str, Array]:
    """The same of the functions that ask for the machine's points alone."""
    kind, given = KIND[precision], vector.inputs
    constants = robot_numbers(robot).astype(kind)
    if vector.function == "inverse_kinematics":
        still = np.zeros(3)
        found = np.zeros(12, dtype=kind)
        motion = np.concatenate([given.get(name, still) for name in MOTION]).astype(kind)
        arguments = [motion, found[:6], found[6:]]
    elif vector.function == "forward_kinematics":
        found = np.concatenate([given["R_guess"], given["t_guess"]]).astype(kind)
        arguments = [given["L"].astype(kind), found]
    else:
        found = np.zeros(6, dtype=kind)
        pose = np.concatenate([given["R"], given["t"]]).astype(kind)
        arguments = [pose, given["L_dot"].astype(kind), found[:3], found[3:]]
    defines = {"STEWART_FLOAT": 1} if precision == "float" else {}
    library = native.load("stewart_kinematics", c_kernel.c_sources("kinematics"), defines=defines)
    assert getattr(library, f"stewart_{vector.function}")(*map(address, (constants, *arguments))) == 0
    return split(vector, found)


def rotation_in_c(vector: Vector, precision: str) -> dict[str, Array]:
    """The same of the functions of an orientation."""
    defines = {"STEWART_FLOAT": 1} if precision == "float" else {}
    library = native.load("stewart_rotation", c_kernel.c_sources("rotation"), defines=defines)
    motion = np.zeros(30, dtype=KIND[precision])
    given = [value.astype(KIND[precision]) for value in vector.inputs.values()]
    assert getattr(library, f"stewart_{vector.function}")(*map(address, (*given, motion))) == 0
    starts = dict(zip(MOTION, np.cumsum([0, 9, 3, 3, 3, 3, 3, 3]), strict=True))
    return {
        name: motion[starts[name] : starts[name] + answer.size].astype(np.float64)
        for name, answer in vector.answers.items()
    }


def split(vector: Vector, found: Array) -> dict[str, Array]:
    """Numbers as the answers are laid out."""
    cuts = np.cumsum([answer.size for answer in vector.answers.values()])[:-1]
    return dict(zip(vector.answers, np.split(found.astype(np.float64), cuts), strict=True))


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
