"""Forces of motions in columns: the bits and statuses of the ordinary batch, at any length and layout."""

import ctypes
import dataclasses
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import random_motion, random_robot
from motion_fields import FIELDS
from numpy.typing import NDArray
from unsolvable_poses import semiregular

import stewart_sym as ss
from stewart_sym.calls import threads as on_threads
from stewart_sym.calls.c_kernel import address, function, pointers
from stewart_sym.dynamics.forces import ForceKernel, Precision
from stewart_sym.generated.fidelities import FIDELITIES
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[Any]
LOADS = ("F_ext", "M_ext")
SIZES = (0, 1, 8, 9, 300)


def flat(rng: np.random.Generator, base_joint: str = "universal") -> Robot:
    """Of threefold symmetry: turned by 90 degrees about its axis, H is singular."""
    turns = ([-12, 12, 108, 132, 228, 252], 1.0), ([-45, 45, 75, 165, 195, 285], 0.5)
    base, plate = (semiregular(*each) for each in turns)
    return dataclasses.replace(random_robot(rng, base_joint, scale=1.0), b=base, p=plate)


def with_faults(rng: np.random.Generator, robot: Robot, count: int) -> Motion:
    """Regular poses, and of every hundred some with each fault: NaN, infinity, length zero, near the joint
    singularity and in it, H singular."""
    motion = random_motion(rng, robot, (count,))
    parts = {name: getattr(motion, name).copy() for name in FIELDS}
    for i in range(0, count, 100):
        for kind, place in enumerate(rng.permutation(min(100, count - i))[:7] + i):
            reach = robot.b[2] - parts["R"][place] @ robot.p[2]
            if kind == 0:
                parts[FIELDS[i // 100 % len(FIELDS)]][place].flat[-1] = np.nan
            elif kind == 1:
                parts["a"][place, 1] = np.inf
            elif kind == 5:
                parts["R"][place], parts["t"][place] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], (0, 0, 1)
            elif kind == 6:
                parts["t"][place] = 1e200
            else:
                along = {2: np.zeros(3), 3: robot.k[2], 4: robot.k[2] + [0.01, 0.01, -0.01]}[kind]
                parts["t"][place] = reach + along
    return Motion._unchecked(**parts)


def columns(motion: Motion, dtype: Any, stride: int | None = None) -> list[Array]:
    """Arrays of a motion in columns, so far apart."""
    found = []
    with np.errstate(over="ignore"):
        for name in FIELDS:
            width = 9 if name == "R" else 3
            array = getattr(motion, name).reshape(-1, width).astype(dtype)
            room = np.empty((array.shape[1], max(stride or 0, len(array))), dtype=dtype)
            room[:, : len(array)] = array.T
            found.append(room[:, : len(array)])
    return found


def views(R: Array, *others: Array | None) -> list[Array | None]:
    """Poses as rows, (n, 3, 3) and (n, 3), that share the memory of columns, (9, n) and (3, n)."""
    count = R.shape[1]
    turned = np.lib.stride_tricks.as_strided(
        R, (count, 3, 3), (R.strides[1], 3 * R.strides[0], R.strides[0]), writeable=False
    )
    return [turned, *(None if each is None else each.T for each in others)]


def forces_of(kernel: ForceKernel, arrays: list[Array], threads: int = 1) -> tuple[Array, NDArray[np.int32]]:
    """Forces of columns in columns like theirs, (6, n), NaN where a pose has no solution, and statuses."""
    R, count = arrays[0], arrays[0].shape[1]
    stride = max(count, R.strides[0] // R.itemsize)
    F = np.full((6, stride), np.nan, dtype=kernel.dtype)[:, :count]
    status = np.zeros(count, dtype=np.int32)
    kernel.forces(views(*arrays), threads, out=(F.T, status))
    return F, status


def check(kernel: ForceKernel, motion: Motion, stride: int | None = None, threads: int = 1) -> None:
    """The columns' bits and statuses are those of the ordinary batch."""
    with np.errstate(over="ignore"):
        F, status = kernel.forces_and_status(motion)
    found, codes = forces_of(kernel, columns(motion, kernel.dtype, stride), threads)
    assert (codes == status).all()
    assert np.ascontiguousarray(found.T).tobytes() == F.tobytes()


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("count", SIZES)
def test_columns_have_the_bits_and_statuses_of_the_batch(count: int, precision: Precision) -> None:
    rng = np.random.default_rng(160 + count)
    robot = flat(rng, "spherical" if count == 9 else "universal")
    motion = with_faults(rng, robot, count)
    for formulation in ("exact", "paper"):
        kernel = ss.ForceKernel(robot, formulation, precision)
        check(kernel, motion)
        check(kernel, motion, stride=1024)
    if count >= 100:
        with np.errstate(over="ignore"):
            codes = set(ss.ForceKernel(robot, precision=precision).forces_and_status(motion)[1])
        assert codes >= {0, 1, 2} | ({3, 4} if precision == "double" else set())


@pytest.mark.parametrize("fidelity", list(FIDELITIES)[1::3])
def test_columns_of_reduced_kernels_do_too(fidelity: str) -> None:
    rng = np.random.default_rng(161)
    robot = flat(rng)
    check(ss.ForceKernel(robot, fidelity=fidelity), with_faults(rng, robot, 109))


@pytest.mark.parametrize("threads", [3, 64])
def test_threads_and_parts_of_longer_arrays_change_no_bit(
    threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(on_threads, "MIN_POSES_PER_THREAD", 10)
    rng = np.random.default_rng(163)
    robot = flat(rng)
    motion, kernel = with_faults(rng, robot, 203), ss.ForceKernel(robot)
    check(kernel, motion, threads=threads)
    whole = columns(motion, np.float64)
    F, status = forces_of(kernel, whole)
    part, codes = forces_of(kernel, [array[:, 5:97] for array in whole])
    assert np.ascontiguousarray(part).tobytes() == np.ascontiguousarray(F[:, 5:97]).tobytes()
    assert (codes == status[5:97]).all()


def test_no_load_is_none_and_unsolvable_poses_keep_what_they_had() -> None:
    rng = np.random.default_rng(164)
    robot = flat(rng)
    kernel, motion = ss.ForceKernel(robot), with_faults(rng, robot, 19)
    arrays: list[Array | None] = [*columns(motion, np.float64, 24)[:-2], None, None]
    unloaded = Motion._unchecked(**{name: getattr(motion, name) for name in FIELDS if name not in LOADS})
    expected, wanted = kernel.forces_and_status(unloaded)
    F, status = np.full((6, 24), 7.5), np.full(19, -1, dtype=np.int32)
    kernel.forces(views(*arrays), out=(F[:, :19].T, status))
    assert (status == wanted).all()
    assert status.any()
    assert (F[:, :19][:, status == 0] == expected[status == 0].T).all()
    assert (F[:, :19][:, status != 0] == 7.5).all()
    assert (F[:, 19:] == 7.5).all()


def test_arrays_that_do_not_fit_are_named_in_one_line() -> None:
    rng = np.random.default_rng(166)
    robot = random_robot(rng)
    kernel, motion = ss.ForceKernel(robot), random_motion(rng, robot, (4,))
    arrays = columns(motion, np.float64)
    F, status = np.zeros((6, 4)), np.zeros(4, dtype=np.int32)
    frozen, room = np.zeros((6, 4)), np.zeros((9, 4))
    frozen.setflags(write=False)
    moved = np.zeros(3 * 4 * 8 + 1, dtype=np.uint8)[1:].view(np.float64).reshape(3, 4)
    bad_ones: list[tuple[str, Any]] = [
        ("t: expected ", ([arrays[0], np.zeros((3, 8))[:, :4], *arrays[2:]], F, status)),
        ("t: expected ", ([arrays[0], arrays[1].T.copy().T, *arrays[2:]], F, status)),
        ("t: expected ", ([arrays[0], None, *arrays[2:]], F, status)),
        ("t: expected an aligned array", ([arrays[0], moved, *arrays[2:]], F, status)),
        ("a: expected ", ([*arrays[:5], arrays[5].astype(np.float32), *arrays[6:]], F, status)),
        ("F: expected .*, columns 4 numbers apart", (arrays, F.T.copy().T, status)),
        ("F: expected ", (arrays, frozen, status)),
        ("F: expected separate memory, got memory of R", ([room, *arrays[1:]], room[:6], status)),
        (
            "status: expected .* of int32, .* got .* of int64",
            (arrays, F, status.astype(np.int64)),
        ),
        (r"status: expected an aligned array \(4,\) ", (arrays, F, status[:3])),
    ]
    for said, (given, to, codes) in bad_ones:
        rejects(rf"^{said}.*\Z", kernel.forces, views(*given), out=(to.T, codes))
    rejects(r"^threads: expected .*\Z", kernel.forces, views(*arrays), 0, out=(F.T, status))
    # Interleaved rows share no memory.
    halves = np.hstack([arrays[0], np.zeros((9, 4))])
    others = [np.hstack([array, array])[:, :4] for array in arrays[1:]]
    kernel.forces(views(halves[:, :4], *others), out=(halves[:6, 4:].T, status))
    assert (halves[:6, 4:] == forces_of(kernel, arrays)[0]).all()


def test_c_rejects_null_and_strides_below_the_count() -> None:
    rng = np.random.default_rng(167)
    robot = random_robot(rng)
    kernel, motion = ss.ForceKernel(robot), random_motion(rng, robot, (3,))
    arrays, F = columns(motion, np.float64), np.zeros((6, 3))

    def code(count: int, stride: int, given: list[Any]) -> int:
        call = function(kernel.name, "forces_columns", "_forces")
        sizes = ctypes.c_size_t(count), ctypes.c_size_t(stride)
        return int(call(address(kernel.model), *sizes, pointers(given), address(F), None))

    assert code(3, 3, arrays) == 0
    assert code(3, 2, arrays) == code(3, 3, [None, *arrays[1:]]) == 5
    assert code(3, 3, [*arrays[:-2], None, None]) == 0
