"""Actuator forces by C kernels whose constants are prepared once per robot, with threads."""

import ctypes
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..backend.kernel import FORMULATIONS, MOTION, force_kernel_name
from ..calls.c_kernel import OnePose, address, function, pointers, prepared_model, results_of, run_batch
from ..calls.threads import in_parts, parts_of
from ..io.arguments import instance, option, real_array, shown
from ..io.array_types import Frozen
from ..io.error_policy import warn
from ..motion.motion import Motion
from ..results import NOT_FINITE, OK, ON_SINGULAR, SINGULAR, UNREACHABLE, OnSingular
from ..robot.offset_chains import codes
from ..robot.robot import Robot
from .inverse_dynamics import (
    Backend,
    Formulation,
    damped_terms,
    inverse_dynamics,
    need_motion,
    report_faults,
    with_compiler,
)
from .neglected_physics import neglected_physics

Array = NDArray[Any]
Precision = Literal["double", "float"]
_OPTIONAL = ("F_ext", "M_ext")


@dataclass(frozen=True, eq=False)
class ForceKernel(Frozen):
    """Robot prepared for the fast computation of actuator forces at one precision and fidelity level.

    Threads may share a kernel.

    With precision "float", the linear solver divides moments by a power of two near the size of the platform.
    Therefore the size of the machine, from 1 mm to 10 m, does not affect the accuracy. Motions and forces are
    in SI units.

    Attributes
    ----------
    robot : Robot
        Robot model.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    precision : {"double", "float"}, optional
        Type of the numbers in C.
    fidelity : str, optional
        Fidelity level, the physics of the legs that the kernel includes; "general" includes everything.
    warns : bool, optional
        False suppresses the warning about physics of the robot that the fidelity level omits.
    model : ndarray
        Numbers of the C structure ``stewart_<kernel>_model``.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> kernel = ss.ForceKernel(ss.robots.load("dasgupta1998"))
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> kernel.forces(motion).round(2).tolist()
    [373.49, -1058.71, 1347.93, -569.37, -77.71, 382.36]
    """

    robot: Robot
    formulation: Formulation = "exact"
    precision: Precision = "double"
    fidelity: str = "general"
    warns: bool = field(default=True, kw_only=True, repr=False)
    model: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        instance(self.robot, Robot, "robot")
        option(self.formulation, FORMULATIONS, "formulation")
        option(self.precision, ("double", "float"), "precision")
        model = prepared_model(self.c_function("prepare"), self.robot, self.name, self.precision)
        # The memory layout is kept, because a copy would be slower.
        object.__setattr__(self, "model", model)
        if self.warns and self.fidelity != "general":
            self._warn_of_omitted_physics()

    def _warn_of_omitted_physics(self) -> None:
        """Warn if the fidelity level omits physics of the robot, with the effect on the forces."""
        # The estimate has double precision, so that it contains no rounding.
        reduced = replace(self, precision="double", warns=False)
        missing = neglected_physics(self.robot, self.formulation, self.fidelity, reduced.forces)
        if missing:
            warn(f'{missing}; for all of it use fidelity="general"')

    @property
    def dtype(self) -> type[np.floating[Any]]:
        """NumPy type of the numbers of the kernel."""
        return np.float64 if self.precision == "double" else np.float32

    def forces(
        self,
        motion: Motion | Sequence[Array | None],
        threads: int = 1,
        on_singular: OnSingular = "raise",
        *,
        out: tuple[Array, NDArray[np.int32]] | None = None,
    ) -> Array:
        """Compute the actuator forces of every pose of a motion, (37).

        Parameters
        ----------
        motion : Motion, shape (...)
            Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
            With ``out``, it may be a sequence of arrays: R (n, 3, 3) and t, omega, v, alpha, a, F_ext, M_ext
            (n, 3); F_ext and M_ext may be None.
        threads : int, optional
            Largest number of threads, including the caller. The result does not depend on it, and small
            batches use one thread.
        on_singular : {"raise", "warn", "nan", "damped"}, optional
            Action for poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
            ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning. With "damped",
            which requires fidelity "general", F is computed by damped least squares as in
            ``inverse_dynamics``.
        out : tuple of ndarray, optional
            Output arrays for forces, (n, 6), and statuses, int32, (n,). No array is copied: all arrays except
            the statuses must be C-contiguous and of type ``dtype``. For a pose without a solution, the forces
            do not change, the status is not 0, and no error is raised.

        Returns
        -------
        ndarray, shape (..., 6)
            Actuator forces (N) of type ``dtype``, positive when they extend the leg; the first array of
            ``out`` if given.

        Raises
        ------
        ValueError
            If an option is unknown, if the motion has no accelerations, or if a pose has no solution and
            ``on_singular`` is "raise". With ``out``, if an array has another type or layout, or if an output
            shares memory with another array.
        """
        if out is not None:
            if on_singular != "raise":
                raise ValueError("on_singular: does not apply with out, whose statuses name unsolvable poses")
            arrays = [getattr(motion, name) for name in MOTION] if isinstance(motion, Motion) else motion
            F, status = out
            _need_layout(arrays, F, status, self.dtype)
            code = self.c_function("forces_batch")
            run_batch(code, self.model, arrays, [F], status, apart=True, threads=threads)
            return F
        instance(motion, Motion, "motion")
        motion = cast("Motion", motion)
        option(on_singular, ON_SINGULAR, "on_singular")
        if on_singular == "damped" and self.fidelity != "general":
            raise ValueError(f'on_singular: "damped" needs fidelity "general", this one is "{self.fidelity}"')
        need_motion(self.robot, motion)
        F, status = self.forces_and_status(motion, threads)
        if on_singular == "damped" and (singular := status == SINGULAR).any():
            F[singular] = damped_terms(self.robot, motion[singular], self.formulation)["F"]
            status = np.where(np.isfinite(F).all(axis=-1), OK, status).astype(np.int32)
        report_faults(status, self.robot, motion, on_singular)
        return F

    def single_pose(self) -> OnePose:
        """Create buffers for single poses, for loops in which microseconds matter.

        Returns
        -------
        OnePose
            Buffers of type ``dtype``; inputs are 0 and F is NaN.
        """
        return OnePose(self.c_function("forces"), self.model, np.full(6, np.nan, dtype=self.dtype))

    def forces_soa(
        self,
        R: ArrayLike,
        t: ArrayLike,
        omega: ArrayLike,
        v: ArrayLike,
        alpha: ArrayLike,
        a: ArrayLike,
        F_ext: ArrayLike | None = None,
        M_ext: ArrayLike | None = None,
        threads: int = 1,
        *,
        out: tuple[Array, NDArray[np.int32]] | None = None,
    ) -> tuple[Array, NDArray[np.int32]]:
        """Compute the actuator forces of motions in columns, with consecutive values of each component.

        The arrays must have one column per pose; for n = 3 this cannot be checked. Arrays of another type, or
        with different distances between rows, are copied. Access is fastest if every row starts at a multiple
        of 64 bytes, and the distance between rows is not a multiple of 4096 bytes.

        Parameters
        ----------
        R : array_like, shape (3, 3, n) or (9, n)
            Orientations, from the platform frame to the base frame, row-major.
        t, omega, v, alpha, a : array_like, shape (3, n)
            Positions of the reference point (m), angular velocities (rad/s), velocities (m/s), angular
            accelerations (rad/s^2), and accelerations (m/s^2), base frame.
        F_ext, M_ext : array_like, shape (3, n), optional
            External forces (N) and moments (N m) at the reference point, platform frame.
        threads : int, optional
            Largest number of threads, as for ``forces``.
        out : tuple of ndarray, optional
            Output arrays for F, (6, n), and statuses, int32, (n,). No array is copied: R has the shape (9,
            n), and all arrays have the type ``dtype``. All arrays except the statuses have the same distance
            between rows, for example column slices of longer arrays. Forces of poses without a solution do
            not change.

        Returns
        -------
        F : ndarray, shape (6, n)
            Actuator forces (N), positive when they extend the leg, (37). NaN if the status is not 0, except
            in ``out``.
        status : ndarray of int32, shape (n,)
            Codes of ``results.STATUS_TEXT``. The code is 1 also if a leg with offset joints cannot reach its
            platform point.

        Raises
        ------
        ValueError
            If an array has another shape; the message names the array. With ``out``, also if an array has
            another type or layout, or if an output shares memory with another array.
        """
        arrays: Sequence[Array | None] = (R, t, omega, v, alpha, a, F_ext, M_ext)  # type: ignore[assignment]
        if out is None:
            arrays, count = _in_columns(arrays, self.dtype)
            out = np.full((6, count), np.nan, dtype=self.dtype), np.zeros(count, dtype=np.int32)
        F, status = out
        stride = _need_layout(arrays, F, status, self.dtype, columns=True)
        code = self.c_function("forces_columns")

        def run(start: int, poses: int) -> None:
            sizes = ctypes.c_size_t(poses), ctypes.c_size_t(stride)
            inputs = pointers(None if each is None else each[:, start:] for each in arrays)
            code(address(self.model), *sizes, inputs, address(F[:, start:]), address(status[start:]))

        in_parts(parts_of(status.size, threads), threads, run)
        return F, status

    def forces_and_status(self, motion: Motion, threads: int = 1) -> tuple[Array, NDArray[np.int32]]:
        """Compute the forces and the status of every pose of a motion.

        Parameters
        ----------
        motion : Motion, shape (...)
            Poses, velocities, and accelerations, as for ``forces``.
        threads : int, optional
            Largest number of threads, as for ``forces``.

        Returns
        -------
        F : ndarray, shape (..., 6)
            Actuator forces (N) of type ``dtype``; NaN if the status is not 0.
        status : ndarray of int, shape (...)
            Codes of ``results.STATUS_TEXT``.

        Raises
        ------
        ValueError
            If the motion has no accelerations.
        """
        need_motion(self.robot, motion)
        code, shapes = self.c_function("forces_batch"), {"F": (6,)}
        found = results_of(code, self.model, motion, shapes, apart=True, threads=threads)
        F, status = found["F"], found["status"]
        if self.robot.offsets is not None and (lost := status == NOT_FINITE).any():
            # If a leg cannot reach its point, the kernel computes the square root of a negative number.
            of_legs = codes(self.robot, motion[lost])
            status[lost] = np.where((of_legs == UNREACHABLE).any(axis=-1), UNREACHABLE, NOT_FINITE)
        return F, status

    @cached_property
    def name(self) -> str:
        """Name of the generated kernel, as in ``stewart_<name>_forces.c``."""
        return force_kernel_name(self.robot, self.formulation, self.fidelity)

    def c_function(self, name: str) -> Any:
        """Return a C function of the compiled library of the kernel.

        Parameters
        ----------
        name : str
            Last part of the function name ``stewart_<kernel>_<name>``.

        Returns
        -------
        callable
            Function of ``ctypes``.
        """
        return function(self.name, name, "_forces", self.precision)


def _in_columns(values: Sequence[Any], dtype: Any) -> tuple[list[Array | None], int]:
    """Convert the arrays of a motion to contiguous columns for C, and return the number of poses.

    ``values`` are in the order of ``MOTION``: R has the shape (3, 3, n) or (9, n), the others have (3, n).
    """
    found: list[Array | None] = []
    for name, value in zip(MOTION, values, strict=True):
        if value is None and name in _OPTIONAL:
            found.append(None)
            continue
        array = real_array(value, name)
        if array.shape[:2] == (3, 3) and array.ndim == 3:
            array = array.reshape(9, -1)
        with np.errstate(over="ignore"):
            found.append(np.ascontiguousarray(array, dtype))
    assert found[0] is not None
    return found, found[0].size // 9


def _need_layout(
    arrays: Sequence[Array | None], F: Array, status: Any, dtype: Any, columns: bool = False
) -> int:
    """Return the distance between columns in numbers; raise ValueError for an array that C cannot use.

    ``arrays`` are in the order of ``MOTION``. Poses are rows with the shape of the status, or columns of
    equal distance. The outputs must not share memory with another array.
    """
    if len(arrays) != len(MOTION):
        raise ValueError(f"arrays: expected {len(MOTION)}, {', '.join(MOTION)}, got {len(arrays)}")
    given = {name: each for name, each in zip((*MOTION, "F"), (*arrays, F), strict=True) if each is not None}
    R = np.atleast_2d(given.get("R", np.nan))
    shape = R.shape[-1:] if columns else R.shape[:-2]
    stride = max(*shape, R.strides[0] // R.itemsize) if columns else 0
    for name, one in (*MOTION.items(), ("F", (6,))):
        if name in given or name not in _OPTIONAL:
            wanted = (math.prod(one), *shape) if columns else (*shape, *one)
            _need(name, given.get(name), wanted, dtype, stride)
    _need("status", status, shape, np.int32)
    for name, own in (("F", F), ("status", status)):
        if not own.flags.writeable:
            raise ValueError(f"{name}: expected a writeable array")
        for other, array in given.items():
            if array is not own and np.shares_memory(own, array):
                raise ValueError(f"{name}: expected separate memory, got memory of {other}")
    return stride


def _need(name: str, array: Any, shape: tuple[int, ...], dtype: Any, stride: int = 0) -> None:
    """Raise ValueError for another shape, type, or layout: columns with a distance in numbers, or C order."""
    size, is_array = np.dtype(dtype).itemsize, isinstance(array, np.ndarray)
    if is_array and array.shape == shape and array.dtype == dtype and array.flags.aligned:
        along = array.strides[-1] == size or array.shape[-1] < 2
        fits = along and array.strides[0] == stride * size if stride else array.flags.c_contiguous
        if fits or not array.size:
            return
    # Texts only for an error, because the text of a large array takes longer than the forces.
    layout = f"rows {stride * size} bytes apart" if stride else "C-contiguous"
    got = shown(array)
    if is_array:
        got = f"{array.shape} of {array.dtype} with strides {array.strides}, aligned: {array.flags.aligned}"
    raise ValueError(f"{name}: expected an aligned array {shape} of {np.dtype(dtype)}, {layout}, got {got}")


def forces_of(robot: Robot, formulation: Formulation, backend: Backend) -> Callable[[Motion], Array]:
    """Return a function that computes forces (n, 6), NaN for unsolvable poses, by the fastest kernel."""

    def full(motion: Motion) -> Array:
        return inverse_dynamics(robot, motion, formulation, backend, on_singular="nan").F

    spins = robot.offsets is not None and robot.offsets.has_spinning_parts
    if spins or not isinstance(backend, str) or backend != "c":
        return full  # Checks the options and supports all robots, in contrast to the force kernels.
    kernel = with_compiler(lambda: ForceKernel(robot, formulation), lambda: None)
    return full if kernel is None else lambda motion: kernel.forces_and_status(motion)[0]
