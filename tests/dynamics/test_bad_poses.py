"""Unsolvable poses and bad arguments: one clear line, or a status and NaN; others of a batch keep bits."""

import dataclasses
import re
import threading
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import Array, dasgupta, machine_in_motion, random_motion, random_robot
from motion_fields import FIELDS, UNLOADED, stacked
from numpy.typing import NDArray
from unsolvable_poses import BACKENDS, CASES, at_rest, semiregular

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.calls import threads as on_threads
from stewart_sym.calls.c_kernel import CKernel
from stewart_sym.calls.numpy_kernel import NumpyKernel
from stewart_sym.dynamics.forward_dynamics import closed_form_of
from stewart_sym.results import JOINT_SINGULAR, NOT_FINITE, SINGULAR, ZERO_LENGTH
from stewart_sym.studies.robustness.oracle import CLOSED


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("case", CASES)
def test_a_pose_without_an_answer_is_one_clear_line_or_nan_that_leaves_its_neighbors(
    backend, case: str
) -> None:
    make, code, text = CASES[case]
    robot, bad = make()
    for function in (ss.inverse_dynamics, ss.joint_reactions):
        rejects(re.escape(text), function, robot, bad, backend=backend)
    good = at_rest([0.13, 0.04, 0.6])
    both = stacked([good, bad, good], UNLOADED)
    found = ss.inverse_dynamics(robot, both, backend=backend, on_singular="nan")
    assert list(found.status) == [0, code, 0]
    assert np.isnan([*found.F[1], *found.H[1].ravel()]).all()
    alone = ss.inverse_dynamics(robot, good, backend=backend).F
    np.testing.assert_allclose(found.F[[0, 2]], [alone, alone], rtol=1e-12)
    with pytest.warns(ss.SingularPoseWarning, match=r"motion\[1\]"):
        ss.inverse_dynamics(robot, both, backend=backend, on_singular="warn")
    reactions = ss.joint_reactions(robot, both, backend=backend, on_singular="nan")
    assert np.isnan([*reactions.F_u[1].ravel(), *reactions.M_u[1]]).all()
    assert np.isfinite(reactions.F_u[[0, 2]]).all()


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("shape", [(), (3,)])
def test_reactions_that_overflow_are_reported(backend, shape: tuple[int, ...]) -> None:
    robot = dasgupta()
    motion = ss.Motion(
        R=np.eye(3),
        t=np.broadcast_to([0.13, 0.04, 0.6], (*shape, 3)),
        omega=np.zeros(3),
        v=np.zeros(3),
        alpha=np.zeros(3),
        a=np.zeros(3),
    )
    with warnings.catch_warnings(action="error"):
        found = ss.joint_reactions(robot, motion, backend=backend, bearing_distance=1e308, on_singular="nan")
    assert np.all(found.status == results.NOT_FINITE)
    for name in ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u"):
        assert np.isnan(getattr(found, name)).all()
    rejects("a result overflows", ss.joint_reactions, robot, motion, backend=backend, bearing_distance=1e308)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
def test_a_leg_of_length_zero_is_seen_wherever_the_base_stands(backend, base_joint: str) -> None:
    """Of S = q + t - b only rounding is left, of the size of the base's distance and not of the leg's."""
    rng = np.random.default_rng(7)
    robot, poses = machine_in_motion(rng, (18,), base_joint, load=False)
    for i in range(6):
        offset = 10 ** rng.uniform(-2, 4) * rng.uniform(-1, 1, 3)
        away, leg = dataclasses.replace(robot, b=robot.b + offset), i % 6
        pose = dataclasses.replace(poses[i], t=away.b[leg] - poses.R[i] @ robot.p[leg])
        found = ss.inverse_dynamics(away, pose, backend=backend, on_singular="nan")
        assert found.status == results.ZERO_LENGTH, offset


def test_without_a_compiler_numpy_serves_and_says_so_once(monkeypatch) -> None:
    from stewart_sym.backend import native
    from stewart_sym.calls import c_kernel
    from stewart_sym.dynamics import inverse_dynamics

    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    c_kernel.library.cache_clear()
    inverse_dynamics._say_once.cache_clear()
    robot, motion = dasgupta(), at_rest([0.1, 0, 0.5])
    with pytest.warns(RuntimeWarning, match="NumPy kernels are used"):
        first = ss.inverse_dynamics(robot, motion).F
    with warnings.catch_warnings(action="error"):
        second = ss.inverse_dynamics(robot, motion).F
    assert (first == second).all()
    assert (first == ss.inverse_dynamics(robot, motion, backend="numpy").F).all()
    c_kernel.library.cache_clear()


POSES = 1003
FORCED = ("forward_dynamics", "linearization")


def machine() -> ss.Robot:
    """Flat and of threefold symmetry: turned by 90 degrees about its axis, H is singular."""
    rng = np.random.default_rng(70)
    base, plate = (
        semiregular([-12, 12, 108, 132, 228, 252], 1.0),
        semiregular([-45, 45, 75, 165, 195, 285], 0.5),
    )
    return dataclasses.replace(random_robot(rng, scale=1.0), b=base, p=plate)


def poisoned(robot: ss.Robot) -> tuple[ss.Motion, ss.Motion, NDArray[np.int32]]:
    """A sound batch, the same with its poison, and the status of each pose, -1 for any but 0."""
    rng = np.random.default_rng(71)
    sound = random_motion(rng, robot, (POSES,))
    parts = {name: getattr(sound, name).copy() for name in FIELDS}
    status = np.zeros(POSES, dtype=np.int32)
    places = rng.permutation(POSES)[: POSES // 100 + 6]
    for kind, i in enumerate(places):
        if kind < 8:
            parts[FIELDS[kind]][i].flat[-1] = (np.nan, np.inf, -np.inf)[kind % 3]
            status[i] = NOT_FINITE
        elif kind < 11:
            leg = kind - 8
            parts["t"][i] = robot.b[leg] - parts["R"][i] @ robot.p[leg]
            status[i] = ZERO_LENGTH
        elif kind < 14:
            leg = kind - 8
            parts["t"][i] = robot.b[leg] + robot.k[leg] - parts["R"][i] @ robot.p[leg]
            status[i] = JOINT_SINGULAR
        elif kind == 14:
            parts["R"][i] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
            parts["t"][i] = (0, 0, 1)
            status[i] = SINGULAR
        else:
            parts["t"][i] = 1e200
            status[i] = NOT_FINITE
    return sound, ss.Motion._unchecked(**parts), status


ROBOT = machine()
SOUND, POISONED, STATUS = poisoned(ROBOT)
GOOD = STATUS == 0


def same_bits(left: Array, right: Array) -> bool:
    return np.ascontiguousarray(left).tobytes() == np.ascontiguousarray(right).tobytes()


def check(run: Callable[[ss.Motion], tuple[dict[str, Any], NDArray[np.int32]]], codes: bool = True) -> None:
    """run: motion -> results by name, and status."""
    clean, none = run(SOUND)
    spoilt, status = run(POISONED)
    assert not none.any()
    assert ((status == 0) == GOOD).all()
    assert not codes or (status == STATUS).all()
    for name, value in clean.items():
        assert np.isfinite(value).all(), name
        assert same_bits(spoilt[name][GOOD], value[GOOD]), name
        assert np.isnan(spoilt[name][~GOOD]).all(), name


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("precision", ["double", "float"])
def test_forces_of_sound_poses_keep_every_bit(
    precision: Any, threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(on_threads, "MIN_POSES_PER_THREAD", 100)
    kernel = ss.ForceKernel(ROBOT, precision=precision)

    def run(motion: ss.Motion) -> tuple[dict[str, Any], NDArray[np.int32]]:
        with np.errstate(all="ignore"):
            F, status = kernel.forces_and_status(motion, threads)
        return {"F": F}, status

    # In float a pose on the axis to rounding of double is beside it, or the other way round.
    check(run, codes=precision == "double")


@pytest.mark.parametrize("kind", [CKernel, NumpyKernel])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
def test_every_output_of_sound_poses_keeps_every_bit(kind: Any, formulation: str) -> None:
    kernel = kind(ROBOT, formulation)
    for output, *given in (("inverse_dynamics",), ("joint_reactions", np.full(6, 0.1))):

        def run(
            motion: ss.Motion, output: str = output, given: Any = given
        ) -> tuple[dict[str, Any], NDArray[np.int32]]:
            with np.errstate(all="ignore"):
                found = kernel.run(output, motion, *given)
            return found, found.pop("status")

        check(run)


@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize("what", CLOSED)
def test_the_closed_form_of_sound_poses_keeps_every_bit(backend: str, what: str) -> None:
    kernel = closed_form_of(ROBOT, "exact", backend)
    assert kernel is not None
    F = [np.random.default_rng(72).normal(size=(POSES, 6))] if what in FORCED else []

    # Not all functions read accelerations or loads, or solve with H.
    clean, spoilt = (dict(kernel.run(what, motion, *F)) for motion in (SOUND, POISONED))
    none, status = clean.pop("status"), spoilt.pop("status")
    assert not none.any()
    assert not status[GOOD].any()
    assert np.isin(status, [*(0, NOT_FINITE, ZERO_LENGTH, JOINT_SINGULAR, SINGULAR)]).all()
    always = np.isin(STATUS, (ZERO_LENGTH, JOINT_SINGULAR))
    assert (status[always] == STATUS[always]).all()
    for name, value in clean.items():
        assert same_bits(spoilt[name][GOOD], value[GOOD]), name
        assert np.isfinite(spoilt[name][status == 0]).all(), name
        assert np.isnan(spoilt[name][status != 0]).all(), name


# --- threads


def hammered(calls: list[Callable[[], bytes]], threads: int = 6, rounds: int = 12) -> bool:
    """Whether many threads at once get what one alone gets, each in an order of its own."""
    expected = [call() for call in calls]
    wrong: list[tuple[int, int]] = []
    start = threading.Barrier(threads)

    def work(number: int) -> None:
        order = np.random.default_rng(number).permutation(np.repeat(np.arange(len(calls)), rounds))
        start.wait()
        wrong.extend((number, int(i)) for i in order if calls[i]() != expected[i])

    workers = [threading.Thread(target=work, args=(number,)) for number in range(threads)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return not wrong


@pytest.mark.slow
def test_threads_share_force_kernels_whose_batches_are_shared_themselves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(on_threads, "MIN_POSES_PER_THREAD", 50)
    kernels = [
        ss.ForceKernel(robot, precision=precision)
        for robot in (ROBOT, dasgupta())
        for precision in ("double", "float")
    ]

    def call(kernel: ss.ForceKernel, motion: ss.Motion, threads: int) -> Callable[[], bytes]:
        def bits() -> bytes:
            with np.errstate(all="ignore"):
                return b"".join(part.tobytes() for part in kernel.forces_and_status(motion, threads))

        return bits

    assert hammered([call(k, m, n) for k in kernels for m in (SOUND, POISONED) for n in (1, 3)])
