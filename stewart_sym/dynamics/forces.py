"""Actuator forces alone, from a robot prepared once: the fast path of the C kernels."""

import ctypes
import itertools
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import cache, cached_property, partial
from typing import Any, Literal, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..backend.c_kernel import address, function, prepared_model
from ..backend.fidelity import force_kernel_name
from ..backend.kernel import FORMULATIONS, MOTION, takes_rotors
from ..generated.interface import MODELS
from ..io.arguments import instance, option, whole_number
from ..io.error_policy import ON_SINGULAR, OnSingular, warn
from ..io.frozen import Frozen
from ..motion.motion import Motion
from ..results import NOT_FINITE, OK, SINGULAR, UNREACHABLE
from ..robot.offset_chains import codes
from ..robot.robot import Robot
from .columns import WIDTHS, as_columns, need_apart, need_rows, need_status, stride_of
from .inverse_dynamics import Formulation, damped_terms, need_motion, report_faults
from .left_out import left_out

Array = NDArray[Any]
Precision = Literal["double", "float"]

LANES = 8
LEAST_SHARE = 4_000
"""Poses that a thread gets at least: waking one takes 0.12 ms (2 virtual cores), as long as 1,200 poses."""

CONVERTED = 32_768
"""Poses whose arrays are converted at a time where they don't lie as the C takes them."""

CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
"""Cores that this process may run on."""

_WIDTHS = WIDTHS[:-1]
_NUMBERS = sum(_WIDTHS)


@dataclass(frozen=True, eq=False)
class ForceKernel(Frozen):
    """A robot's constants prepared for one formulation, precision and level of fidelity.

    Safe to share between threads.

    In float the solve takes its moments over a length, a power of two near the size of the platform, so that
    pivots are as good on a machine of a millimeter as on one of ten meters; motions and forces are in SI
    units.

    Attributes
    ----------
    robot : Robot
        The machine.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    precision : {"double", "float"}, optional
        Of the numbers in C.
    fidelity : str, optional
        How much of the legs' physics.
    warns : bool, optional
        False suppresses the warning about physics of the robot that the fidelity level omits.
    model : ndarray, optional
        The numbers of the C's ``stewart_<kernel>_model``.
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
        rotors, offsets = takes_rotors(self.name), self.robot.offsets is not None
        prepare = self.c_function("prepare")
        model = prepared_model(prepare, self.robot, MODELS[self.name], self.precision, rotors, offsets)
        # As it lies in memory; a copy would be slower.
        object.__setattr__(self, "model", model)
        if self.warns and self.fidelity != "general":
            self._warn_of_omitted_physics()

    def _warn_of_omitted_physics(self) -> None:
        """Warn if the fidelity level omits physics of the robot, with the effect on the forces."""
        # The estimate has double precision, so that it contains no rounding.
        reduced = replace(self, precision="double", warns=False)
        missing = left_out(self.robot, self.formulation, self.fidelity, reduced.forces)
        if missing:
            warn(f'{missing}; for all of it use fidelity="general"')

    @property
    def dtype(self) -> type[np.floating[Any]]:
        """Type of the numbers that the kernel computes with."""
        return np.float64 if self.precision == "double" else np.float32

    def forces(
        self,
        motion: Motion | Sequence[Array | None],
        threads: int = 1,
        on_singular: OnSingular = "raise",
        *,
        out: tuple[Array, NDArray[np.int32]] | None = None,
    ) -> Array:
        """Actuator forces of every pose of a motion, (37).

        Parameters
        ----------
        motion : Motion
            Motion of the platform, any leading shape. With ``out`` or a sequence of its arrays: R (n, 3, 3),
            t, omega, v, alpha, a, F_ext, M_ext (n, 3), the last two None for no load.
        threads : int, optional
            How many share the work at most, the caller one of them; the result does not depend on it, and a
            batch too small to gain is not shared.
        on_singular : {"raise", "nan", "warn", "damped"}, optional
            What to do about unsolvable poses: "raise" ValueError, "warn" and return NaN, or return "nan"
            without a warning; "damped" as for ``inverse_dynamics``, whose ``wrench_error`` is what F does not
            balance, with fidelity "general" alone.
        out : tuple of ndarray, optional
            Arrays that receive the forces, (n, 6), and the statuses, int32, (n,). No array is copied, and
            only layouts are checked: all arrays must be C-contiguous and of the kernel's ``dtype``.
            Unsolvable poses keep the forces they had, and raise no error.

        Returns
        -------
        ndarray
            Forces, N, (..., 6), of the kernel's ``dtype``; the first array of ``out`` if given.

        Raises
        ------
        ValueError
            For unknown options, for a motion without accelerations, and for unsolvable poses. With ``out``
            for an array of another type or layout, and for an output that shares memory with another array.
        """
        if out is not None:
            if on_singular != "raise":
                raise ValueError("on_singular: does not apply with out, whose statuses name unsolvable poses")
            arrays = [getattr(motion, name) for name in MOTION] if isinstance(motion, Motion) else motion
            need_rows(arrays, *out, self.dtype)
            need_apart(arrays, *out)
            self._shared(out[1].size, threads, partial(self._run, arrays, *out))
            return out[0]
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

    def status(self, motion: Motion, threads: int = 1) -> NDArray[np.int32]:
        """Status of every pose of a motion.

        Parameters
        ----------
        motion : Motion
            As for ``forces``.
        threads : int, optional
            As for ``forces``.

        Returns
        -------
        ndarray of int
            Codes of ``results.STATUS_TEXT``, (...).

        Raises
        ------
        ValueError
            For a motion without accelerations.
        """
        need_motion(self.robot, motion)
        return self.forces_and_status(motion, threads)[1]

    def single_pose(self) -> "OnePose":
        """Buffers for one pose at a time, for loops where every microsecond counts.

        Returns
        -------
        OnePose
            Of the kernel's ``dtype``, inputs 0 and F NaN.
        """
        return OnePose(self, np.full(6, np.nan, dtype=self.dtype), np.zeros(_NUMBERS, dtype=self.dtype))

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
        """Actuator forces of motions in columns, for programs that keep each component by itself.

        Nothing is transposed; arrays of another type, or in rows of different lengths, are copied. Three
        motions in rows have the shapes of three in columns: nothing tells them apart. Rows that begin at
        multiples of 64 bytes, and not at multiples of 4096 bytes from each other, are read fastest.

        Parameters
        ----------
        R : array_like, (3, 3, n) or (9, n)
            Orientations, platform frame to base frame, row-major.
        t, omega, v, alpha, a : array_like, (3, n)
            Positions of the reference point, m; angular velocities, rad/s; velocities of the reference
            point, m/s; angular accelerations, rad/s^2; accelerations, m/s^2; base frame.
        F_ext, M_ext : array_like, (3, n), optional
            External forces at the reference point, N, and moments about it, N m, platform frame.
        threads : int, optional
            How many share the work at most.
        out : tuple of ndarray, optional
            Arrays that receive F, (6, n), and the statuses, int32, (n,). No array is copied: R has shape
            (9, n), all arrays have the kernel's ``dtype``, and all rows but the statuses are equally far
            apart, as in parts ``[:, first:last]`` of longer arrays. Unsolvable poses keep their forces.

        Returns
        -------
        F : ndarray, (6, n)
            Actuator forces, N, positive when they extend the leg, (37); NaN where the status is not 0. The
            arrays of ``out`` if given.
        status : ndarray of int32, (n,)
            Codes of ``results.STATUS_TEXT``; 1 where a number is not finite, and where a leg with offset
            joints does not reach.

        Raises
        ------
        ValueError
            Naming the array of another shape; with ``out`` also of another type or layout, and an output that
            shares memory with another array.
        """
        given = (R, t, omega, v, alpha, a, F_ext, M_ext)
        if out is not None:
            self._columns_into(cast("tuple[Array | None, ...]", given), *out, threads)
            return out
        arrays = as_columns(given, self.dtype)
        first = next(array for array in arrays if array is not None)
        count = first.shape[-1]
        stride = max(count, first.strides[0] // first.itemsize)
        F = np.full((6, stride), np.nan, dtype=self.dtype)[:, :count]
        status = np.zeros(count, dtype=np.int32)
        self._columns_into(arrays, F, status, threads)
        return F, status

    def _columns_into(
        self, arrays: Sequence[Array | None], F: Array, status: NDArray[np.int32], threads: int
    ) -> None:
        """Write forces, (6, n), and statuses, (n,), of arrays in columns into given arrays."""
        need_status(status)
        if isinstance(F, np.ndarray) and F.shape[:-1] == (6,) and status.shape != F.shape[-1:]:
            raise ValueError(f"status: expected an array {F.shape[-1:]} for F {F.shape}, got {status.shape}")
        count = status.size
        stride = stride_of(arrays, F, count, self.dtype)
        need_apart(arrays, F, status)
        self._shared(count, threads, lambda start, n: self._run(arrays, F, status, start, n, stride))

    def _shared(self, count: int, threads: int, run: Callable[[int, int], None]) -> None:
        """Run parts of a batch, each given by its first pose and its length, on threads."""
        threads = min(
            whole_number(threads, "threads", 1, "a whole number of at least 1"), max(1, count // LEAST_SHARE)
        )
        if threads == 1:
            if count > 0:
                run(0, count)
            return
        parts = _parts(count, threads)
        turn = itertools.count()

        def work() -> None:
            while (part := next(turn)) < len(parts):
                run(*parts[part])

        others = min(threads, len(parts), CORES) - 1
        waiting = [_pool(others, os.getpid()).submit(work) for _ in range(others)]
        work()
        for other in waiting:
            other.result()

    def forces_and_status(self, motion: Motion, threads: int = 1) -> tuple[Array, NDArray[np.int32]]:
        """Forces and status of every pose of a motion.

        Parameters
        ----------
        motion : Motion
            As for ``forces``.
        threads : int, optional
            As for ``forces``.

        Returns
        -------
        F : ndarray
            Actuator forces, N, (..., 6), of the kernel's ``dtype``; NaN where the status is not 0.
        status : ndarray of int
            Codes of ``results.STATUS_TEXT``, (...).

        Raises
        ------
        ValueError
            For a motion without accelerations.
        """
        need_motion(self.robot, motion)
        F = np.full((*motion.shape, 6), np.nan, dtype=self.dtype)
        status = np.zeros(motion.shape, dtype=np.int32)
        for part in self._parts_to_convert(motion):
            arrays = [
                None if array is None else np.ascontiguousarray(array[part], dtype=self.dtype)
                for array in (getattr(motion, name) for name in MOTION)
            ]
            into = F[part], status[part]
            need_rows(arrays, *into, self.dtype)
            self._shared(into[1].size, threads, partial(self._run, arrays, *into))
        if self.robot.offsets is not None and (lost := status == NOT_FINITE).any():
            # Where no leg reaches, the kernel takes the root of a negative number.
            of_legs = codes(self.robot, motion[lost])
            status[lost] = np.where((of_legs == UNREACHABLE).any(axis=-1), UNREACHABLE, NOT_FINITE)
        return F, status

    def _parts_to_convert(self, motion: Motion) -> list[Any]:
        """All poses where the arrays can be taken as they lie, else parts, so that copies stay small."""
        arrays = [array for array in (getattr(motion, name) for name in MOTION) if array is not None]
        ready = all(
            array.dtype == self.dtype and array.flags.c_contiguous and array.flags.aligned for array in arrays
        )
        if ready or len(motion.shape) != 1:
            return [...]
        return [slice(start, start + CONVERTED) for start in range(0, motion.shape[0], CONVERTED)]

    def _run(
        self,
        arrays: Sequence[Array | None],
        F: Array,
        status: NDArray[np.int32],
        start: int,
        count: int,
        stride: int | None = None,
    ) -> None:
        """Some poses of a batch; stride: numbers from one column to the next, None of poses side by side."""
        widths = WIDTHS if stride is None else [1] * len(WIDTHS)
        places = [address(array, start * n) for array, n in zip((*arrays, F), widths, strict=True)]
        counts = [count] if stride is None else [count, stride]
        self.c_function("forces_batch" if stride is None else "forces_columns")(
            address(self.model),
            *map(ctypes.c_size_t, counts),
            (ctypes.c_void_p * len(arrays))(*places[:-1]),
            places[-1],
            address(status, start),
        )

    @cached_property
    def name(self) -> str:
        """Name of the generated kernel, as in ``stewart_<name>_forces.c``."""
        return force_kernel_name(self.robot, self.formulation, self.fidelity)

    def c_function(self, name: str) -> Any:
        """A C function of the kernel's compiled library.

        Parameters
        ----------
        name : str
            End of its name ``stewart_<kernel>_<name>``.

        Returns
        -------
        callable
            A function of ``ctypes``.
        """
        return function(self.name, "forces", self.precision, name)


@dataclass(frozen=True, eq=False)
class OnePose:
    """Buffers of one pose: fill R, t, omega, v, alpha, a, F_ext, M_ext in place, ``solve``, read ``F``.

    numbers: all thirty inputs as one array, (30,), in the order of ``stewart_motion``; the named views write
    into it. ``solve`` returns the status and leaves F as it was if that is not 0.
    """

    kernel: ForceKernel
    F: Array
    numbers: Array

    def __post_init__(self) -> None:
        """Look the function and the addresses up once; the buffers live as long as this object.

        Raises ValueError naming the buffer whose type, size or layout is another.
        """
        for name, array, size in (("F", self.F, 6), ("numbers", self.numbers, _NUMBERS)):
            wanted = np.dtype(self.kernel.dtype)
            if array.dtype != wanted or array.shape != (size,) or not array.flags.carray:
                raise ValueError(f"{name}: expected {size} writeable numbers of {wanted}")
        addresses = tuple(address(array, 0) for array in (self.kernel.model, self.numbers, self.F))
        object.__setattr__(self, "_call", self.kernel.c_function("forces"))
        object.__setattr__(self, "_addresses", addresses)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies and pickles get buffers, and so addresses, of their own."""
        return OnePose, (self.kernel, self.F.copy(), self.numbers.copy())

    def solve(self) -> int:
        """Compute F from the numbers in place; returns the status."""
        return int(self._call(*self._addresses))

    def __getattr__(self, name: str) -> Any:
        if name not in MOTION:
            raise AttributeError(name)
        at = list(MOTION).index(name)
        start = sum(_WIDTHS[:at])
        return self.numbers[start : start + _WIDTHS[at]].reshape(MOTION[name])


def _parts(count: int, threads: int) -> list[tuple[int, int]]:
    """First pose and number of poses of each part of a batch.

    Several parts for each thread, so that one whose core is disturbed keeps nobody waiting for long.
    """
    pieces = max(threads, min(4 * threads, count // LEAST_SHARE))
    share = max(LANES, -(-count // (pieces * LANES)) * LANES)
    return [(start, min(share, count - start)) for start in range(0, count, share)]


@cache
def _pool(threads: int, process: int) -> ThreadPoolExecutor:
    """Threads of a process that wait for work; starting them anew costs more than a small batch."""
    return ThreadPoolExecutor(threads, thread_name_prefix="stewart-sym")
