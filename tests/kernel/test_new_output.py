"""A line of ``FIDELITIES`` gives a kernel with right forces; a result that is no array is named."""

import ctypes
import re

import numpy as np
import pytest
from command_line import rejects
from machines import random_motion, random_robot
from reduced_machines import as_simple_as, at_rest

import stewart_sym as ss
from stewart_sym.backend import kernel, native
from stewart_sym.backend.kernel import MOTION
from stewart_sym.calls import c_kernel
from stewart_sym.calls.c_kernel import address
from stewart_sym.derive import generated_files as generation
from stewart_sym.derive.kernel import interface, outputs
from stewart_sym.derive.kernel.prepare import result
from stewart_sym.derive.mechanics.reduced_models import AXISYMMETRIC, FIDELITIES, Fidelity
from stewart_sym.derive.trace.nodes import Array, Field, Integer, Real, Type


def in_c(
    library: ctypes.CDLL, prefix: str, name: str, size: int, robot: ss.Robot, motion: ss.Motion
) -> np.ndarray:
    """Six numbers of a function whose prepared model has this size."""
    numbers = np.concatenate([np.ravel(getattr(motion, part)) for part in MOTION])
    arrays = [kernel.robot_numbers(robot), np.zeros(size), numbers, np.zeros(6)]
    pointers = [address(each) for each in arrays]
    assert getattr(library, f"stewart_{prefix}_prepare")(*pointers[:2]) == 0
    assert getattr(library, f"stewart_{prefix}_{name}")(*pointers[1:]) == 0
    return arrays[-1]


@pytest.mark.parametrize("kind", [Real(), Array(Integer(), (1,))])
def test_a_member_that_is_no_array_of_numbers_is_named(kind: Type) -> None:
    energy = result("KineticEnergy", "Kinetic energy.", Field("energy", kind, "J: it"))
    expected = 'Field("energy", _numbers(n), ...), of one number _numbers(1)'
    text = f"RESULTS: kinetic_energy: energy: expected {expected}, got {kind}"
    rejects(f"^{re.escape(text)}$", outputs.check_arrays, outputs.RESULTS | {"kinetic_energy": energy})


def test_an_output_of_several_arrays_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    numbers = Array(Real(), (3,))
    both = result("Both", "Two arrays.", Field("one", numbers, "m: it"), Field("other", numbers, "m: it"))
    monkeypatch.setitem(outputs.RESULTS, "both", both)
    rejects(r"^RESULTS: both: expected one array, or .*, got 2 arrays$", interface._of_result, "both")


LEVEL = Fidelity("axisymmetric_at_rest", AXISYMMETRIC, False, False, "at rest, axisymmetric legs")


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")
def test_a_line_gives_a_kernel_in_c_with_the_forces_of_such_a_machine(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert LEVEL.name not in FIDELITIES
    monkeypatch.setattr(generation, "FIDELITIES", {LEVEL.name: LEVEL})
    monkeypatch.setattr(generation, "DRIVE_FIDELITIES", {})
    made = generation._fidelities("test")
    files = made.files
    ((name, size),) = made.models.items()
    assert LEVEL.meaning in files["fidelities.py"]

    sources = {path.removeprefix("c/"): text for path, text in files.items() if path.startswith("c/")}
    library = native.load(name, c_kernel.c_sources("exact") | sources, ("-O0",))
    rng = np.random.default_rng(3)
    robot = as_simple_as(random_robot(rng), LEVEL)
    motion = random_motion(rng, robot)
    F = in_c(library, name, "forces", size, robot, motion)
    expected = ss.inverse_dynamics(robot, at_rest(motion))
    np.testing.assert_allclose(F, expected.F, rtol=0, atol=1e-12 * np.abs(expected.F).max())
