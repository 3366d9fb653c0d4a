"""Inverse dynamics and joint reactions as users call them: any backend, either formulation, checked results.

Chooses the kernel, runs it, and turns a status into an error, a warning or NaN as the caller asks. Knows no
equation.
"""

import functools
import warnings
from collections.abc import Callable
from typing import Literal, Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import reference
from .kernel import CKernel, NumpyKernel, kernel_name
from .motion import Motion
from .native import CompilerError
from .results import POLE, SHORT_LEG, STATUS_TEXT, Forces, Reactions
from .robot import Robot

Array = NDArray[np.float64]
Formulation = Literal["exact", "paper"]
Backend = Literal["c", "numpy", "reference"]
OnSingular = Literal["raise", "warn", "nan"]


class SingularPoseWarning(UserWarning):
    """Some poses have no finite answer; their results are NaN and their status says why."""


class _Kernel(Protocol):
    def forces(self, motion: Motion) -> Forces: ...
    def reactions(self, motion: Motion, bearing: Array) -> Reactions: ...


class _Reference:
    """The vector reference behind the interface of the kernels."""

    def __init__(self, robot: Robot, formulation: str) -> None:
        kernel_name(formulation, robot.base_joint)
        self.robot = robot
        self.faults = reference.PAPER if formulation == "paper" else reference.EXACT

    def forces(self, motion: Motion) -> Forces:
        return reference.inverse_dynamics(self.robot, motion, self.faults)

    def reactions(self, motion: Motion, bearing: Array) -> Reactions:
        return reference.joint_reactions(self.robot, motion, self.faults, bearing)


def inverse_dynamics(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    on_singular: OnSingular = "raise",
) -> Forces:
    """Actuator forces that make the platform follow ``motion``, with D, x, K, H, c, (1)-(37).

    formulation: "exact", or "paper" for the equations as printed. backend: "c" (compiled on first use; NumPy
    serves where there is no compiler), "numpy" or "reference". on_singular: what to do about poses without
    an answer: "raise" ValueError, "warn" and return NaN there, or return "nan" silently; ``status`` tells.

    Returns Forces; shapes and units there. Raises ValueError for unknown options, for a motion without
    accelerations, and for poses without an answer.
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    return _checked(kernel.forces(motion), robot, motion, on_singular)


def joint_reactions(
    robot: Robot,
    motion: Motion,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    bearing: ArrayLike | None = None,
    on_singular: OnSingular = "raise",
) -> Reactions:
    """Forces and moments in the joints, (21), (26)-(29) and M_p of (17).

    bearing: where M_p is taken, distance along each leg from its base point, m, scalar or (6,); None: at the
    base point. Other arguments, errors: as for ``inverse_dynamics``. Returns Reactions.
    """
    kernel = _prepared(robot, motion, formulation, backend, on_singular)
    return _checked(kernel.reactions(motion, _bearing(bearing)), robot, motion, on_singular)


def massless_forces(robot: Robot, motion: Motion) -> Array:
    """F0 of (41): actuator forces if legs had no mass and joints no friction, N, (..., 6)."""
    _need_accelerations(motion)
    return reference.massless_forces(robot, motion)


def dynamic_fraction(robot: Robot, motion: Motion, F: Array) -> Array:
    """F_d / F of (42) and section 4.4, (..., 6): the share of leg inertia, leg weight and friction in F."""
    return (F - massless_forces(robot, motion)) / F


def _prepared(robot: Robot, motion: Motion, formulation: str, backend: str, on_singular: str) -> _Kernel:
    if on_singular not in ("raise", "warn", "nan"):
        raise ValueError(f'on_singular: expected "raise", "warn" or "nan", got {on_singular!r}')
    _need_accelerations(motion)
    kernels: dict[str, Callable[[Robot, str], _Kernel]] = {
        "c": _compiled_or_numpy,
        "numpy": NumpyKernel.prepare,
        "reference": _Reference,
    }
    if backend not in kernels:
        raise ValueError(f'backend: expected "c", "numpy" or "reference", got {backend!r}')
    return kernels[backend](robot, formulation)


def _need_accelerations(motion: Motion) -> None:
    if motion.alpha is None or motion.a is None:
        raise ValueError("motion: expected accelerations alpha and a, got none")


def _compiled_or_numpy(robot: Robot, formulation: str) -> _Kernel:
    kernel_name(formulation, robot.base_joint)
    try:
        return CKernel.prepare(robot, formulation)
    except CompilerError as error:
        _say_once(f"the NumPy kernels serve instead of C: {error}")
        return NumpyKernel.prepare(robot, formulation)


@functools.cache
def _say_once(text: str) -> None:
    warnings.warn(text, RuntimeWarning, stacklevel=5)


def _bearing(bearing: ArrayLike | None) -> Array:
    values = np.zeros(6) if bearing is None else np.asarray(bearing, dtype=np.float64)
    if values.shape not in ((), (6,)) or not np.isfinite(values).all():
        raise ValueError(f"bearing: expected one finite distance or six, got shape {values.shape}")
    return np.broadcast_to(values, (6,))


Result = TypeVar("Result", Forces, Reactions)


def _checked(result: Result, robot: Robot, motion: Motion, on_singular: str) -> Result:
    if on_singular != "nan" and result.status.any():
        text = _first_fault(result.status, robot, motion)
        if on_singular == "raise":
            raise ValueError(text)
        warnings.warn(text, SingularPoseWarning, stacklevel=3)
    return result


def _first_fault(status: NDArray[np.int32], robot: Robot, motion: Motion) -> str:
    """One line on the first pose without an answer."""
    where = tuple(int(i) for i in np.argwhere(status)[0])
    code = int(status[where])
    pose = f"motion[{', '.join(map(str, where))}]" if where else "motion"
    leg = f" (leg {_worst_leg(code, robot, motion[where]) + 1})" if code in (SHORT_LEG, POLE) else ""
    more = int(np.count_nonzero(status)) - 1
    others = f"; {more} more poses have no answer either" if more else ""
    return f"{pose}: {STATUS_TEXT[code]}{leg}{others}"


def _worst_leg(code: int, robot: Robot, motion: Motion) -> int:
    """Index of the shortest leg, or of the one nearest to its universal axis."""
    S = robot.p @ motion.R.T + motion.t - robot.b
    L = np.linalg.norm(S, axis=-1)
    return int(np.argmin(L if code == SHORT_LEG else np.linalg.norm(np.cross(robot.k, S), axis=-1) / L))
