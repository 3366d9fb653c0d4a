"""The recipe for a reduced model: a line of ``FIDELITIES`` gives a kernel in C, and its forces are right.

``test_new_output`` and ``test_kernel_tree`` in ``tests/kernel`` do the same for an output and a language.
"""

import ctypes

import numpy as np
import pytest
from machines import random_motion, random_robot
from reduced_machines import as_simple_as, at_rest

import stewart_sym as ss
from stewart_sym.backend import c_kernel, kernel, native
from stewart_sym.derive import generate
from stewart_sym.derive.mechanics.reduced_models import AXISYMMETRIC, FIDELITIES, Fidelity

LEVEL = Fidelity("axisymmetric_at_rest", AXISYMMETRIC, False, False, "at rest, axisymmetric legs")


@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.PhysicalityWarning")
def test_a_line_gives_a_kernel_in_c_with_the_forces_of_such_a_machine(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert LEVEL.name not in FIDELITIES
    monkeypatch.setattr(generate, "FIDELITIES", {LEVEL.name: LEVEL})
    monkeypatch.setattr(generate, "DRIVE_FIDELITIES", {})
    made = generate._fidelities("test")
    files = made.files
    ((name, size),) = made.models.items()
    assert LEVEL.meaning in files["fidelities.py"]

    sources = {path.removeprefix("c/"): text for path, text in files.items() if path.startswith("c/")}
    library = native.load(name, c_kernel.c_sources("exact") | sources, ("-O0",))
    rng = np.random.default_rng(3)
    robot = as_simple_as(random_robot(rng), LEVEL)
    motion = random_motion(rng, robot)
    numbers = np.concatenate([np.ravel(getattr(motion, part)) for part in kernel.MOTION])
    model, F = np.zeros(size), np.zeros(6)
    given = [kernel.robot_numbers(robot), model, numbers, F]
    pointers = [each.ctypes.data_as(ctypes.c_void_p) for each in given]
    assert getattr(library, f"stewart_{name}_prepare")(*pointers[:2]) == 0
    assert getattr(library, f"stewart_{name}_forces")(*pointers[1:]) == 0
    expected = ss.inverse_dynamics(robot, at_rest(motion))
    np.testing.assert_allclose(F, expected.F, rtol=0, atol=1e-12 * np.abs(expected.F).max())
