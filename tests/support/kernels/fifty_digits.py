"""Blocks, kernels and generated functions at 50 digits."""

import dataclasses
import functools
from typing import Any

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from stewart_sym.backend.kernel import MOTION
from stewart_sym.calls.numpy_kernel import loaded
from stewart_sym.derive.mechanics.actuator_forces import ForceKernel
from stewart_sym.derive.mechanics.formulation import Formulation
from stewart_sym.derive.mechanics.inverse_dynamics import kernel
from stewart_sym.derive.mechanics.lumped_constants import ADDED
from stewart_sym.derive.mechanics.regressor import regressor
from stewart_sym.derive.program.block import Block
from stewart_sym.kit.required_kernels import fields
from stewart_sym.motion.motion import Motion
from stewart_sym.precision.exact_forces import Truth, deviation, digits
from stewart_sym.robot.robot import Robot, of_symbol

DIGITS = 50
derived = functools.cache(kernel)


def named(name: str, array: NDArray[np.float64]) -> dict[str, mp.mpf]:
    """Entries of a scalar, vector or matrix under the names of the blocks."""
    return {
        name + ("_" + "".join("xyz"[i] for i in key) if key else ""): mp.mpf(array[key])
        for key in np.ndindex(array.shape)
    }


def block_inputs(robot: Robot, motion: Motion, leg: int) -> dict[str, mp.mpf]:
    values: dict[str, mp.mpf] = {}
    of_leg = ("b", "p", "k", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0", "C_u", "C_p", "C_s", "m_r", "j_r")
    for name in of_leg:
        values |= named(name, np.asarray(of_symbol(robot, name)[leg]))
    for name in ("M", "R_0", "I_p", "g"):
        values |= named(name, np.asarray(of_symbol(robot, name)))
    for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext"):
        values |= named(name, getattr(motion, name))
    return values


def truth(form: Formulation, robot: Robot, motion: Motion) -> dict[str, mp.matrix]:
    """D, K, H, c, x, F from the blocks as they were derived, without sharing, at 50 digits."""
    blocks = derived(form)
    raw = [block_inputs(robot, motion, i) for i in range(6)]
    own = blocks.platform.run(raw[0], mp.sqrt)
    c = mp.matrix([*own["c_force"], *own["c_moment"]])
    D, K, H = mp.matrix(6, 1), mp.matrix(6, 3), mp.matrix(6, 6)
    for i in range(6):
        leg = blocks.leg.run(raw[i], mp.sqrt)
        D[i] = leg["D"][0]
        c += mp.matrix([*leg["c_force"], *leg["c_moment"]])
        for j in range(3):
            K[i, j] = leg["K"][j]
            H[j, i], H[j + 3, i] = leg["H_force"][j], leg["H_moment"][j]
    x = mp.lu_solve(H, c)
    return {"D": D, "K": K, "H": H, "c": c, "x": x, "F": D - x}


def errors(found: NDArray[Any], robot: Robot, motion: Motion, dtype: Any = np.float64) -> NDArray[np.float64]:
    """Errors (N) of the forces of one pose; inputs are rounded to ``dtype``, R to the nearest rotation."""
    numbers = {
        name: value.astype(dtype).astype(np.float64)
        for name, value in vars(robot).items()
        if isinstance(value, np.ndarray) and name not in ("k", "offsets", "drive")
    }
    own = dataclasses.replace(robot, M=float(dtype(robot.M)), **numbers)
    given = {name: np.asarray(value, dtype).astype(np.float64) for name, value in loaded(motion).items()}
    R = np.vectorize(digits.mpf, otypes=[object])(given["R"])
    for _ in range(6):
        R = R @ (3 * np.eye(3, dtype=object) - R.T @ R) / 2
    return deviation(found, np.array(Truth(own).of_pose(given | {"R": R}), dtype=object))


def by_name(block: Block, outputs: dict[str, tuple[Any, ...]]) -> dict[str, mp.mpf]:
    """The outputs of a block under the names of their components."""
    return {
        name: value
        for out in block.outputs
        for name, value in zip(out.quantity.names, outputs[out.quantity.name], strict=True)
    }


def forces(kernel: ForceKernel, robot: Robot, motion: Motion) -> mp.matrix:
    """F from the regrouped blocks, in the working precision."""
    kernel = kernel.whole()
    first = named("p_1", robot.p[0])
    raw = [block_inputs(robot, motion, leg) | first for leg in range(6)]
    legs = [by_name(kernel.prepare_leg, kernel.prepare_leg.run(values, mp.sqrt)) for values in raw]
    added = {name: sum(leg[name] for leg in legs) for quantity in ADDED for name in quantity.names}
    platform = by_name(kernel.prepare_platform, kernel.prepare_platform.run(raw[0] | added, mp.sqrt))
    shared = kernel.shared.run(raw[0] | platform, mp.sqrt)
    turn = by_name(kernel.shared, shared)
    nothing = {"D": (0,), "c_force": (0,) * 3, "c_moment": (0,) * 3, "arm_c": (0,) * 3}
    c = mp.matrix([*shared["c_force"], *shared["c_tip"]])
    D, H = mp.matrix(6, 1), mp.matrix(6, 6)
    for i, leg in enumerate(legs):
        found = nothing | kernel.leg.run(raw[i] | turn | leg, mp.sqrt)
        D[i] = found["D"][0]
        c += mp.matrix([*found["c_force"], *found["c_moment"]])
        c += mp.matrix([0, 0, 0, *found["arm_c"]])
        for j in range(3):
            H[j, i], H[j + 3, i] = found["H_force"][j], found["H_moment"][j]
    return D - mp.lu_solve(H, c)


Numbers = dict[str, NDArray[Any]]


def as_stored(robot: Robot, motion: Motion) -> tuple[Numbers, Numbers]:
    """Numbers of a robot without rotors and of a motion, flat, as ``KitInterpreter`` takes them."""
    numbers = {name: np.asarray(of_symbol(robot, name), dtype=np.float64) for name in fields(rotors=False)}
    return numbers, {name: np.ravel(getattr(motion, name)) for name in MOTION}


def orthonormal(robot: Robot, motion: Motion) -> tuple[Numbers, Numbers]:
    """The same, with axes and a rotation that are of length one to the last digit."""
    numbers, at = as_stored(robot, motion)
    R = digits.matrix(motion.R.tolist())
    for _ in range(6):
        R = R * (3 * digits.eye(3) - R.T * R) / 2
    if robot.base_joint == "universal":
        axes = [digits.matrix(axis.tolist()) for axis in robot.k]
        numbers["k"] = np.array([list(axis / digits.norm(axis)) for axis in axes])
    at = {name: np.array([*map(digits.mpf, value)]) for name, value in at.items()}
    return numbers, at | {"R": np.array(list(R))}


def orthonormal_inputs(robot: Robot, motion: Motion) -> list[dict[str, mp.mpf]]:
    """Inputs of each leg's blocks with these axes and rotation."""
    numbers, at = orthonormal(robot, motion)
    R = named("R", at["R"].reshape(3, 3))
    return [block_inputs(robot, motion, leg) | R | named("k", numbers["k"][leg]) for leg in range(6)]


regressor_blocks = functools.cache(regressor)


def columns(raw: list[dict[str, mp.mpf]]) -> tuple[list[dict[str, mp.matrix]], dict[str, mp.matrix]]:
    """Columns of the regressor by parameter of each leg and of the platform, from the blocks."""

    def found(block: Block, values: dict[str, mp.mpf]) -> dict[str, mp.matrix]:
        parts = block.run(values, mp.sqrt)
        names = [name.removeprefix("force_") for name in parts if name.startswith("force_")]
        return {name: mp.matrix([*parts[f"force_{name}"], *parts[f"moment_{name}"]]) for name in names}

    of_leg, of_platform = regressor_blocks().leg, regressor_blocks().platform
    return [found(of_leg, values) for values in raw], found(of_platform, raw[0])


def whole_regressor(raw: list[dict[str, mp.mpf]]) -> NDArray[np.object_]:
    """Y, (6, 148)."""
    legs, platform = columns(raw)
    return np.array([list(column) for part in (*legs, platform) for column in part.values()], dtype=object).T


def further(at: Numbers, **steps: NDArray[Any]) -> Numbers:
    """A motion with these added to some of its vectors; of R a turn, by Cayley's formula, base frame."""
    found = at | {name: at[name] + step for name, step in steps.items() if name != "R"}
    if "R" in steps:
        x, y, z = by = steps["R"]
        turn = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        R = at["R"].reshape(3, 3)
        found["R"] = (R + (turn + turn @ turn / 2) @ R / (1 + by @ by / 4)).ravel()
    return found
