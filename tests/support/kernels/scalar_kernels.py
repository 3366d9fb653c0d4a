"""One-pose kernels compiled and prepared."""

import ctypes
import dataclasses
import functools
from dataclasses import dataclass
from typing import Any

import numpy as np
from machines import random_motion, random_robot
from numpy.typing import NDArray

from stewart_sym.backend import native
from stewart_sym.backend.kernel import resolve_level, robot_numbers
from stewart_sym.calls.numpy_kernel import loaded
from stewart_sym.kit import Choice
from stewart_sym.kit.required_kernels import parts
from stewart_sym.motion.motion import Motion
from stewart_sym.results import OK
from stewart_sym.robot.robot import Robot

Array = NDArray[np.float64]
UNTOUCHED = -1.25


@dataclass(frozen=True)
class Kernel:
    """A compiled one-pose kernel with a robot prepared for it, if it takes one."""

    library: ctypes.CDLL
    prefix: str
    precision: str
    model: Array | None

    @property
    def dtype(self) -> Any:
        return np.float32 if self.precision == "float" else np.float64

    def one(self, numbers: Array) -> tuple[int, Array]:
        given, F = np.asarray(numbers, dtype=self.dtype), np.full(6, UNTOUCHED, dtype=self.dtype)
        arguments = [given.ctypes.data, F.ctypes.data]
        if self.model is not None:
            arguments.insert(0, self.model.ctypes.data)
        status = getattr(self.library, f"{self.prefix}_forces")(*map(ctypes.c_void_p, arguments))
        return status, F

    def forces_and_status(self, motion: Motion) -> tuple[Array, NDArray[np.int32]]:
        """F, NaN where the status is not 0, and status of every pose, (n,)."""
        found = [self.one(numbers(motion[i])) for i in range(motion.shape[0])]
        F, status = np.array([F for _, F in found]), np.array([code for code, _ in found])
        assert (F[status != OK] == UNTOUCHED).all()
        F[status != OK] = np.nan
        return F, status


def numbers(motion: Motion) -> Array:
    return np.concatenate([*map(np.ravel, loaded(motion).values())])


def compiled(robot: Robot, precision: str, **choice: Any) -> tuple[ctypes.CDLL, str]:
    """The kernel of a kit, and the prefix of its functions."""
    made = parts(robot, Choice(scalar=True, precision=precision, **choice))
    (forces,) = made.parts[0].functions
    sources = {name: text for name, text in made.files.items() if "rotation" not in name}
    library = native.load("scalar", sources, ["-O0", "-ffp-contract=off"])
    return library, forces.symbol.removesuffix("_forces")


@functools.cache
def library(formulation: str, joint: str, level: str, precision: str) -> tuple[ctypes.CDLL, str]:
    robot = random_robot(np.random.default_rng(0), joint)
    return compiled(robot, precision, formulation=formulation, fidelity=level)


def prepared(
    robot: Robot, formulation: str = "exact", level: str = "general", precision: str = "double"
) -> Kernel:
    level = resolve_level(robot, formulation, level)
    joint = robot.base_joint if level == "general" else "universal"
    found, prefix = library(formulation, joint, level, precision)
    dtype = np.float32 if precision == "float" else np.float64
    raw, model = robot_numbers(robot).astype(dtype), np.full(1000, np.nan, dtype=dtype)
    call = getattr(found, f"{prefix}_prepare")
    assert call(ctypes.c_void_p(raw.ctypes.data), ctypes.c_void_p(model.ctypes.data)) == OK
    return Kernel(found, prefix, precision, model)


BOUND = 100.0


def any_machine(rng: np.random.Generator) -> tuple[Robot, Motion]:
    """From 1 mm to 10 m, platform and legs from 1e-6 to 1e6 kg, each by itself."""
    joint = "universal" if rng.random() < 0.7 else "spherical"
    robot = random_robot(rng, joint, friction=rng.random() < 0.7, scale=float(10 ** rng.uniform(-3, 1)))
    platform, legs = 10 ** rng.uniform(-6, 6, 2) / (robot.M, max(robot.m_d.max(), robot.m_u.max()))
    heavier = {name: getattr(robot, name) * platform for name in ("M", "I_p", "C_u", "C_p", "C_s")}
    parts = {name: getattr(robot, name) * legs for name in ("m_d", "m_u", "I_d0", "I_u0")}
    robot = dataclasses.replace(robot, **heavier, **parts)
    return robot, random_motion(rng, robot)
