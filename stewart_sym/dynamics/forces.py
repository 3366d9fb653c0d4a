"""Actuator forces by C kernels whose constants are prepared once per robot, and bounds of their errors."""

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import FORMULATIONS, MOTION, force_kernel_name
from ..calls.c_kernel import CKernel, OnePose, function, prepared, prepared_model, results_of, run_batch
from ..io.arguments import instance, option, shown
from ..io.array_types import Frozen
from ..io.error_policy import warn
from ..motion.motion import Motion
from ..results import NOT_FINITE, ON_FAULT, UNREACHABLE, OnFault
from ..robot.offset_chains import codes
from ..robot.robot import Robot
from .inverse_dynamics import (
    Backend,
    Formulation,
    inverse_dynamics,
    need_motion,
    need_universal,
    report_faults,
    with_compiler,
)
from .neglected_physics import neglected_physics

Array = NDArray[Any]
Precision = Literal["double", "float"]
_SHAPES = {**MOTION, "F": (6,)}
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
        model = prepared_model(self._function("prepare"), self.robot, self.name, self.precision)
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
        on_singular: OnFault = "raise",
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
        on_singular : {"raise", "warn", "nan"}, optional
            Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
            ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.
        out : tuple of ndarray, optional
            Output arrays for forces, (n, 6), and statuses, int32, (n,). No array is copied: all arrays except
            the statuses have the type ``dtype`` and are C-contiguous, or all are views of columns. Then ``t``
            is the transpose of an array (3, n), F of an array (6, n), and R a view of (9, n); all have the
            same distance between columns, for example slices ``[:, first:last]`` of longer arrays. For a pose
            without a solution, the forces do not change, the status is not 0, and no error is raised.

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
            stride = _distance_of_columns(arrays, F, status, self.dtype)
            code = self._function("forces_columns" if stride else "forces_batch")
            run_batch(code, self.model, arrays, [F], status, apart=True, threads=threads, stride=stride)
            return F
        instance(motion, Motion, "motion")
        motion = cast("Motion", motion)
        option(on_singular, ON_FAULT, "on_singular")
        F, status = self.forces_and_status(motion, threads)
        report_faults(status, self.robot, motion, on_singular)
        return F

    def single_pose(self) -> OnePose:
        """Create buffers for single poses, for loops in which microseconds matter.

        Returns
        -------
        OnePose
            Buffers of type ``dtype``; inputs are 0 and F is NaN.
        """
        return OnePose(self._function("forces"), self.model, np.full(6, np.nan, dtype=self.dtype))

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
        code, shapes = self._function("forces_batch"), {"F": (6,)}
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

    def _function(self, name: str) -> Any:
        """Return the C function ``stewart_<kernel>_<name>``."""
        return function(self.name, name, "_forces", self.precision)


def _distance_of_columns(arrays: Sequence[Array | None], F: Array, status: Any, dtype: Any) -> int:
    """Return the distance between columns in numbers, 0 for rows; ValueError for an array that C cannot use.

    ``arrays`` are in the order of ``MOTION``. The outputs must not share memory with another array.
    """
    if len(arrays) != len(MOTION):
        raise ValueError(f"arrays: expected {len(MOTION)}, {', '.join(MOTION)}, got {len(arrays)}")
    R, stride, kind = np.asarray(arrays[0]), 0, np.dtype(dtype)
    if R.ndim == 3 and not R.flags.c_contiguous:
        stride = max(len(R), R.strides[2] // R.itemsize)
    pairs = zip(_SHAPES, (*arrays, F), strict=True)
    given = {name: array for name, array in pairs if array is not None or name not in _OPTIONAL}
    lead = R.shape[:-2]
    for name, array in given.items():
        _need(name, array, lead + _SHAPES[name], kind, stride)
    _need("status", status, lead, np.dtype(np.int32))
    for name, own in (("F", F), ("status", status)):
        if not own.flags.writeable:
            raise ValueError(f"{name}: expected a writeable array")
    # Arrays that own their data share no memory.
    if not all(each.flags.owndata for each in (*given.values(), status)):
        for (name, own), (other, array) in itertools.product((("status", status), ("F", F)), given.items()):
            if array is not own and np.shares_memory(own, array):
                raise ValueError(f"{name}: expected separate memory, got memory of {other}")
    return stride


def _need(name: str, array: Any, shape: tuple[int, ...], dtype: np.dtype[Any], stride: int = 0) -> None:
    """Raise ValueError for another shape, type, or layout: rows, or columns with a distance in numbers."""
    if isinstance(array, np.ndarray) and array.shape == shape and array.dtype == dtype:
        flags = array.flags
        if flags.aligned and (_is_column(array, stride) if stride else flags.c_contiguous):
            return
    # Texts only for an error, because the text of a large array takes longer than the forces.
    got = shown(array)
    if isinstance(array, np.ndarray):
        got = f"{array.shape} of {array.dtype} with strides {array.strides}, aligned: {array.flags.aligned}"
    layout = f"columns {stride} numbers apart" if stride else "C-contiguous"
    raise ValueError(f"{name}: expected an aligned array {shape} of {dtype}, {layout}, got {got}")


def _is_column(array: Array, stride: int) -> bool:
    """Return True if the components of a pose are at this distance in numbers, and poses are adjacent."""
    size = array.itemsize
    steps = (3 * stride * size, stride * size) if array.ndim == 3 else (stride * size,)
    return bool(array.strides == (size, *steps))


def forces_of(robot: Robot, formulation: Formulation, backend: Backend) -> Callable[[Motion], Array]:
    """Return a function that computes forces (n, 6), NaN for unsolvable poses, by the fastest kernel."""

    def full(motion: Motion) -> Array:
        return inverse_dynamics(robot, motion, formulation, backend, on_singular="nan").F

    spins = robot.offsets is not None and robot.offsets.has_spinning_parts
    if spins or not isinstance(backend, str) or backend != "c":
        return full  # Checks the options and supports all robots, in contrast to the force kernels.
    kernel = with_compiler(lambda: ForceKernel(robot, formulation), lambda: None)
    return full if kernel is None else lambda motion: kernel.forces_and_status(motion)[0]


@dataclass(frozen=True, eq=False)
class ForceErrorBoundsResult:
    """Actuator forces with bounds of their rounding errors.

    ``(...)`` is the shape of the motion. Numbers have the type of the precision and are NaN if the status is
    not 0.

    Attributes
    ----------
    F : ndarray, shape (..., 6)
        Actuator forces (N), positive when they extend the leg, (37).
    bound : ndarray, shape (..., 6)
        Bounds (N) of the differences between F and the exact forces for the same inputs. Infinite if H is so
        nearly singular that this precision gives no bound.
    rcond : ndarray, shape (...)
        Reciprocal condition number of H in the maximum column sum norm, at most 1. Moments are about the
        reference point and divided by the characteristic length.
    status : ndarray of int, shape (...)
        Status of each pose: 0 if it was solved, otherwise a code of ``STATUS_TEXT``.
    """

    F: Array
    bound: Array
    rcond: Array
    status: NDArray[np.int32]


def force_error_bounds(
    robot: Robot, motion: Motion, precision: Precision = "double", on_singular: OnFault = "raise"
) -> ForceErrorBoundsResult:
    """Compute actuator forces with a rigorous bound of the rounding error of each force.

    Parameters
    ----------
    robot : Robot
        Robot model with universal base joints without offsets.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
    precision : {"double", "float"}, optional
        Type of the numbers in C.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    ForceErrorBoundsResult
        Forces ``F`` (N) and bounds ``bound`` (N), shape (..., 6); reciprocal condition numbers ``rcond`` and
        ``status``, shape (...).

    Raises
    ------
    ValueError
        If an option is unknown, the robot has spherical or offset base joints, or the precision cannot
        represent its constants. Also if the motion has no accelerations, or if a pose has no solution and
        ``on_singular`` is "raise".
    CompilerError
        If there is no working C compiler.

    See Also
    --------
    inverse_dynamics : Compute the forces without bounds.
    force_std : Compute the effect of measurement noise.

    Notes
    -----
    The bounds are rigorous except for overflow and underflow. They count the rounding of every operation,
    weighted by the derivative of the force with respect to its result. This is running error analysis
    (Higham, Accuracy and Stability of Numerical Algorithms, 3.3). The solution of H x = c is enclosed as in
    Rump, Acta Numerica 19 (2010), 10. Inputs count as exact after they are rounded to the precision, except
    that R denotes the rotation nearest to it. The kernel is the formulation "exact".

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> result = ss.force_error_bounds(robot, motion)
    >>> bool((result.bound < 1e-10).all())
    True
    >>> round(float(result.rcond), 3)
    0.024
    """
    option(precision, ("double", "float"), "precision")
    option(on_singular, ON_FAULT, "on_singular")
    need_universal(robot)
    need_motion(robot, motion)
    kernel = prepared(CKernel, robot, "exact", "_bounds", precision)
    found = ForceErrorBoundsResult(**kernel.run("forces_bounded", motion))
    report_faults(found.status, robot, motion, on_singular)
    return found
