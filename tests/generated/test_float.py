"""The float kernels: no double in the object code, and as good as float can be on machines of any size."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scalar_kernels
import toolchain
from attack_build import FEW, SOME, SOME_WITH_ROTORS, sources
from builds import written
from machines import random_motion, random_robot, with_random_drives
from numpy.typing import NDArray
from scalar_kernels import BOUND, any_machine, numbers
from sweeps import FULL, share, slow_but

import stewart_sym as ss
from stewart_sym.generated.fidelities import DRIVE_FIDELITIES, FIDELITIES
from stewart_sym.motion.motion import Motion
from stewart_sym.results import OK
from stewart_sym.robot.robot import Robot

LEVELS = list(FIDELITIES) if FULL else ["general", "slender", "axisymmetric_friction", "massless_static"]
ROTOR_LEVELS = list(DRIVE_FIDELITIES)[:: 1 if FULL else 4]
EPSILON = float(np.finfo(np.float32).eps)


@pytest.mark.slow
@pytest.mark.skipif(bool(toolchain.missing()), reason=toolchain.missing() or "all tools are there")
@pytest.mark.parametrize(
    "stem", slow_but(FEW[2:], [*SOME, *SOME_WITH_ROTORS] if FULL else [*FEW, *SOME_WITH_ROTORS[2:]])
)
def test_float_object_code_holds_no_double(stem: str, tmp_path: Path) -> None:
    """For a Cortex-M4F, whose unit has floats alone; a promotion is a warning, thus an error."""
    source = written(sources(stem), tmp_path / "c") / f"{stem}.c"
    flags = ["-DSTEWART_FLOAT", *(["-DSTEWART_ROTORS"] if "_drive" in stem else [])]
    made = toolchain.compiled(toolchain.CORES["float"], source, flags)
    assert toolchain.double_arithmetic(made) == set()
    own = {"stewart_exact_forces", "stewart_exact_forces_batch"}
    assert toolchain.asked_for(made) <= own | toolchain.HARMLESS


# --- accuracy ---------------------------------------------------------------------------------


def in_lanes(robot: Robot, motion: Motion, formulation: str) -> NDArray[Any]:
    return ss.ForceKernel(robot, formulation, "float").forces(motion)


def one_pose(robot: Robot, motion: Motion, formulation: str) -> NDArray[Any]:
    status, F = scalar_kernels.prepared(robot, formulation, "general", "float").one(numbers(motion))
    assert status == OK
    return F


@pytest.mark.slow
@pytest.mark.parametrize("forces", [in_lanes, one_pose])
def test_float_forces_are_within_100_units_times_condition_on_machines_of_any_size(forces: Any) -> None:
    """Inputs rounded to float too."""
    rng = np.random.default_rng(60)
    for _ in range(share(500)):
        robot, motion = any_machine(rng)
        formulation = "exact" if rng.random() < 0.7 else "paper"
        truth = ss.inverse_dynamics(robot, motion, formulation)
        found = forces(robot, motion, formulation)
        assert found.dtype == np.float32
        condition = ss.scaled_condition_number(truth.H, ss.characteristic_length(robot))
        largest = max(np.abs(values).max() for values in (truth.F, truth.D, truth.x))
        assert np.abs(found - truth.F).max() <= BOUND * EPSILON * condition * largest


@pytest.mark.parametrize(
    ("fidelity", "rotors"),
    [
        *slow_but(("general", "slender"), ((level, False) for level in LEVELS), lambda case: case[0]),
        *slow_but((), ((level, True) for level in ROTOR_LEVELS)),
    ],
)
def test_every_level_in_float_is_within_100_units_times_condition_of_its_double(
    fidelity: str, rotors: bool
) -> None:
    rng = np.random.default_rng(65)
    for scale in (1e-3, 0.1, 10.0):
        robot = random_robot(rng, scale=scale)
        if rotors:
            robot = with_random_drives(rng, robot)
        motion = random_motion(rng, robot, (20,))
        expected = ss.ForceKernel(robot, fidelity=fidelity).forces(motion)
        found = ss.ForceKernel(robot, precision="float", fidelity=fidelity).forces(motion)
        full = ss.inverse_dynamics(robot, motion)
        condition = ss.scaled_condition_number(full.H, ss.characteristic_length(robot))
        largest = np.max([np.abs(values).max(axis=-1) for values in (full.F, full.D, full.x)], axis=0)
        assert (np.abs(found - expected).max(axis=-1) <= BOUND * EPSILON * condition * largest).all()
