"""The fast force kernels: right, the same whatever the batch, and never disturbed by a bad neighbor."""

import dataclasses
import gc
import tracemalloc

import numpy as np
import pytest
from command_line import rejects
from machines import dasgupta, machine_in_motion, random_motion, random_robot
from motion_fields import FIELDS

import stewart_sym as ss
from stewart_sym.calls import threads


def relative(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    return np.abs(left - right).max(axis=-1) / np.abs(right).max(axis=-1)


@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_forces_agree_with_the_reference_to_rounding(formulation, base_joint: str) -> None:
    rng = np.random.default_rng(20)
    for friction in (True, False):
        for _ in range(4):
            robot, motion = machine_in_motion(rng, (9,), base_joint, friction=friction)
            truth = ss.inverse_dynamics(robot, motion, formulation, "reference")
            found = ss.ForceKernel(robot, formulation).forces(motion)
            assert (relative(found, truth.F) <= 1e-13 * ss.condition_number(truth.H)).all()


@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_float_forces_agree_to_float_rounding(formulation) -> None:
    rng = np.random.default_rng(21)
    for _ in range(4):
        robot, motion = machine_in_motion(rng, (9,), scale=1.0)
        truth = ss.inverse_dynamics(robot, motion, formulation)
        found = ss.ForceKernel(robot, formulation, "float").forces(motion)
        assert found.dtype == np.float32
        assert (relative(found, truth.F) <= 2e-5 * ss.condition_number(truth.H)).all()


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_results_are_bit_identical_whatever_batch_position_and_threads(
    precision, base_joint: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(threads, "MIN_POSES_PER_THREAD", 1)
    robot, motion = machine_in_motion(22, (37,), base_joint)
    kernel = ss.ForceKernel(robot, precision=precision)
    whole = kernel.forces(motion)
    assert all((kernel.forces(motion[i]) == whole[i]).all() for i in range(37))
    for start, stop in ((0, 1), (1, 10), (5, 37), (8, 16), (30, 37)):
        assert (kernel.forces(motion[start:stop]) == whole[start:stop]).all()
    for count in (2, 3, 5, 64):
        assert (kernel.forces(motion, threads=count) == whole).all()


def test_empty_and_many_dimensional_batches_work() -> None:
    rng = np.random.default_rng(25)
    robot = random_robot(rng)
    kernel = ss.ForceKernel(robot)
    assert kernel.forces(random_motion(rng, robot, (0,))).shape == (0, 6)
    motion = random_motion(rng, robot, (2, 3, 5))
    flat = kernel.forces(motion, threads=2).reshape(-1, 6)
    assert (flat[17] == kernel.forces(motion[1, 0, 2])).all()


@pytest.mark.parametrize("how", ["broadcast", "in columns"], ids=lambda how: how.replace(" ", "_"))
def test_batches_take_no_memory_beyond_inputs_and_outputs(how: str) -> None:
    count = 200_000
    path, _ = ss.PAPER_PATHS["I"]
    motion = path.sample(np.linspace(0, 6, count))
    if how == "broadcast":
        rest = np.broadcast_to(np.zeros(3), (count, 3))
        motion = ss.Motion._unchecked(R=motion.R, t=motion.t, omega=rest, v=rest, alpha=rest, a=rest)
    if how == "in columns":
        fields = {name: getattr(motion, name) for name in FIELDS}
        motion = ss.Motion._unchecked(**{**fields, "t": np.asfortranarray(motion.t)})
    kernel = ss.ForceKernel(dasgupta())
    kernel.forces(motion[:8])
    tracemalloc.start()
    F, status = kernel.forces_and_status(motion)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak <= F.nbytes + status.nbytes + 16 * 2**20
    assert (F[-3:] == kernel.forces(motion[-3:])).all()


def test_buffers_live_as_long_as_the_bound_call() -> None:
    robot, motion = machine_in_motion(27)
    slot = ss.ForceKernel(robot).single_pose()
    for name in FIELDS:
        getattr(slot, name)[...] = getattr(motion, name)
    assert slot.solve() == 0
    assert (slot.F == ss.ForceKernel(robot).forces(motion)).all()
    solve = slot.solve
    del slot
    # Of the young: all that the process holds takes a second.
    gc.collect(0)
    assert solve() == 0


def test_given_arrays_that_do_not_fit_are_named() -> None:
    robot, motion = machine_in_motion(29, (4,))
    kernel = ss.ForceKernel(robot)
    arrays = [np.ascontiguousarray(getattr(motion, name)) for name in FIELDS]
    F, status = np.zeros((4, 6)), np.zeros(4, dtype=np.int32)
    assert kernel.forces(arrays, out=(F, status)) is F
    assert (F == kernel.forces(motion)).all()
    assert kernel.forces(motion, out=(np.zeros((4, 6)), status)).tobytes() == F.tobytes()
    rejects("on_singular: does not apply with out", kernel.forces, motion, 1, "nan", out=(F, status))
    rejects("motion: expected a Motion", kernel.forces, arrays)
    frozen = F.copy()
    frozen.setflags(write=False)
    bad = [
        ("R", ([None, *arrays[1:]], F, status)),
        ("t", ([arrays[0], arrays[1].astype(np.float32), *arrays[2:]], F, status)),
        ("omega", ([*arrays[:2], arrays[2][:3], *arrays[3:]], F, status)),
        ("F", (arrays, F[:3], status)),
        ("F", (arrays, frozen, status)),
        ("status", (arrays, F, status.astype(np.int64))),
    ]
    for name, (given, *out) in bad:
        rejects(rf"^{name}: expected", kernel.forces, given, out=tuple(out))


def test_constants_that_overflow_the_precision_are_rejected() -> None:
    robot = dasgupta()
    heavy = dataclasses.replace(robot, M=1e39)
    ss.ForceKernel(heavy)
    rejects("exceed the range of float", ss.ForceKernel, heavy, precision="float")
