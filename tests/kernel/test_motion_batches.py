"""Batches of the closed form in C: every bit and status of one pose, wherever in a block a pose is."""

import ctypes
import dataclasses
from typing import Any

import numpy as np
import pytest
from machines import machine_in_motion

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.backend.c_kernel import address, call, pointers
from stewart_sym.backend.kernel import MOTION
from stewart_sym.dynamics.closed_form import OUTPUTS, library
from stewart_sym.dynamics.forces import ForceKernel
from stewart_sym.generated.interface import STRUCTS
from stewart_sym.io.array_types import Array

WHAT = ("equations", "bias_and_friction", "forward_dynamics", "derivatives", "linearization", "joint_inertia")
FORCED = ("forward_dynamics", "linearization")
COUNT = 27
"""Three blocks of eight poses, and three more."""
UNTOUCHED = -1.5

Results = dict[str, Array]


def cases() -> list[tuple[ss.Robot, ss.Motion]]:
    """Machines and motions: random ones, of which some have poses that fail in every way or nearly do."""
    found = []
    for seed in range(6):
        rng = np.random.default_rng(seed)
        robot, motion = machine_in_motion(rng, (COUNT,), scale=1e-3 if seed == 5 else None)
        if seed == 4:
            robot = dataclasses.replace(robot, p=robot.b)
        parts = {name: np.array(getattr(motion, name)) for name in MOTION}
        if seed > 1:
            for kind, i in enumerate(rng.permutation(COUNT)[:14]):
                spoil(robot, parts, kind, i)
        found.append((robot, ss.Motion._unchecked(**parts)))
    return found


def spoil(robot: ss.Robot, parts: dict[str, Array], kind: int, i: int) -> None:
    """One pose: a leg along its axis, or nearly, or without a length, all legs parallel, not finite."""
    leg, axis = kind % 6, robot.k[kind % 6]
    across = np.cross(axis, [0.6, 0.0, 0.8])
    base = robot.b[leg] - parts["R"][i] @ robot.p[leg]
    length = np.linalg.norm(robot.b[leg] - robot.b[0]) + np.linalg.norm(robot.p[leg])
    if kind < 5:
        lean = (0.0, 1e-13, 1e-9, 1e-3, 0.1)[kind]
        parts["t"][i] = base + length * (axis + lean * across)
    elif kind == 5:
        parts["t"][i] = base
    elif kind == 6:
        parts["R"][i], parts["t"][i] = np.eye(3), (0.0, 0.0, length)
    elif kind == 7:
        parts["R"][i] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
        parts["t"][i] = (0.0, 0.0, length)
    else:
        name = ("t", "omega", "v", "alpha", "a", "F_ext")[kind - 8]
        parts[name][i][kind % 3] = (np.nan, np.inf, 1e300)[kind % 3]


CASES = cases()


def one_pose(model: Array, what: str, motion: ss.Motion, F: Array) -> tuple[Array, int]:
    """All numbers of a result, one after the other, and the status."""
    found = np.full(sum(int(np.prod(shape)) for shape in OUTPUTS[what].values()), UNTOUCHED)
    numbers = np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION])
    forces = [address(np.ascontiguousarray(F))] if what in FORCED else []
    code = getattr(library(), f"stewart_exact_{what}")
    return found, code(address(model), address(numbers), *forces, address(found))


def batch(
    model: Array, what: str, motion: ss.Motion, F: Array, wanted: Any = None
) -> tuple[Results, Array, int]:
    """Results by name, statuses and the first of these that is not 0; wanted: names, all unless given."""
    count = motion.shape[0]
    made = {name: np.full((count, *shape), UNTOUCHED) for name, shape in OUTPUTS[what].items()}
    forces = [address(np.ascontiguousarray(F))] if what in FORCED else []
    targets = [each if wanted is None or name in wanted else None for name, each in made.items()]
    given = [ctypes.c_void_p() if each is None else address(each) for each in targets]
    to = [(ctypes.c_void_p * len(given))(*given)] if what in STRUCTS else given
    status = np.full(count, -1, dtype=np.int32)
    code = getattr(library(), f"stewart_exact_{what}_batch")
    first = call(code, model, motion, *forces, *to, address(status))
    return made, status, first


def row(found: Results, i: int) -> Array:
    """Numbers of one pose of a batch, one after the other."""
    return np.concatenate([np.ravel(each[i]) for each in found.values()])


@pytest.mark.parametrize("what", WHAT)
def test_a_pose_of_a_batch_has_every_bit_and_status_of_one(what: str) -> None:
    codes = set()
    for robot, motion in CASES:
        F = 1e2 * np.random.default_rng(1).normal(size=(COUNT, 6))
        model = ForceKernel(robot, "exact").model
        found, status, first = batch(model, what, motion, F)
        assert first == next((code for code in status if code), results.OK)
        for i in range(COUNT):
            alone, code = one_pose(model, what, motion[i], F[i])
            assert status[i] == code
            assert row(found, i).tobytes() == alone.tobytes()
            assert code == results.OK or (alone == UNTOUCHED).all()
        codes |= set(status.tolist())
    assert {results.OK, results.NOT_FINITE, results.ZERO_LENGTH, results.JOINT_SINGULAR} <= codes
    assert what not in ("derivatives", "joint_inertia") or results.SINGULAR in codes


@pytest.mark.parametrize("what", WHAT)
def test_a_pose_has_the_same_bits_wherever_it_is(what: str) -> None:
    robot, motion = CASES[3]
    F = 1e2 * np.random.default_rng(2).normal(size=(COUNT, 6))
    model = ForceKernel(robot, "exact").model
    found, status, _ = batch(model, what, motion, F)
    for first, last in ((0, 1), (0, 8), (1, 9), (5, 27), (26, 27), (0, 0)):
        part, codes, _ = batch(model, what, motion[first:last], F[first:last])
        assert (codes == status[first:last]).all()
        for i in range(first, last):
            assert row(part, i - first).tobytes() == row(found, i).tobytes()


@pytest.mark.parametrize("what", [each for each in WHAT if each in STRUCTS])
def test_what_is_not_wanted_changes_nothing_else(what: str) -> None:
    robot, motion = CASES[2]
    F = 1e2 * np.random.default_rng(3).normal(size=(COUNT, 6))
    model = ForceKernel(robot, "exact").model
    whole, status, _ = batch(model, what, motion, F)
    for name in OUTPUTS[what]:
        part, codes, _ = batch(model, what, motion, F, (name,))
        assert (codes == status).all()
        assert part[name].tobytes() == whole[name].tobytes()
        assert all((part[other] == UNTOUCHED).all() for other in part if other != name)


@pytest.mark.parametrize("what", WHAT)
def test_loads_and_unread_accelerations_may_be_null_and_are_zero(what: str) -> None:
    robot, motion = CASES[1]
    F = 1e2 * np.random.default_rng(4).normal(size=(COUNT, 6))
    model = ForceKernel(robot, "exact").model
    absent = {"F_ext", "M_ext"} | (set() if what == "derivatives" else {"alpha", "a"})
    parts = {name: np.array(getattr(motion, name)) for name in MOTION}
    parts |= {name: np.zeros((COUNT, 3)) for name in absent}
    expected, _, _ = batch(model, what, ss.Motion._unchecked(**parts), F)
    made = {name: np.full((COUNT, *shape), UNTOUCHED) for name, shape in OUTPUTS[what].items()}
    given = (ctypes.c_void_p * len(MOTION))(
        *(None if name in absent else parts[name].ctypes.data for name in MOTION)
    )
    forces = [address(F)] if what in FORCED else []
    to = [pointers(made.values())] if what in STRUCTS else [address(each) for each in made.values()]
    code = getattr(library(), f"stewart_exact_{what}_batch")
    assert code(address(model), ctypes.c_size_t(COUNT), given, *forces, *to, None) == results.OK
    assert all(made[name].tobytes() == expected[name].tobytes() for name in made)
