"""Forces and masses of random machines in MJCF and URDF, compared with MuJoCo and Pinocchio."""

import json
import re
import warnings
from pathlib import Path

import mujoco
import numpy as np
import pytest
from exported_models import written
from model_family import TOP, Family, family, grows, mjcf, urdf
from model_statics import InMujoco, InPinocchio
from numpy.typing import NDArray
from sweeps import share, sweep

import stewart_sym as ss

MODELS, URDFS, PART = 320, 120, 12
SAME, SAME_MASS = 1e-8, 1e-12
ONE_LEG = re.compile(r"model\.\w+: (robot: )?leg \d: [^\n]*$")
STATED = re.compile(r"are off by up to (\S+) N")


def imported_or_rejected(made: Family, file: ss.ExportedModel, path: Path) -> ss.ImportedModel | None:
    """The imported machine, or None if a machine with a fault is rejected in one line that names the leg."""
    try:
        with warnings.catch_warnings(action="ignore"):
            return ss.import_model(written(file, path))
    except ValueError as error:
        if made.fault and ONE_LEG.search(str(error)):
            return None
        raise


def forces(found: ss.ImportedModel, R: NDArray[np.float64], t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Forces at rest of the legs as they are numbered in the file, (6,)."""
    zero = np.zeros(3)
    F = ss.inverse_dynamics(found.robot, ss.Motion(R=R, t=t, omega=zero, v=zero, alpha=zero, a=zero)).F
    numbers = re.findall(r"\d 'lower(\d)' 'upper\d'", found.assumptions[0])
    return F[[numbers.index(str(i)) for i in range(1, 7)]]


def need_same_forces(
    made: Family, found: ss.ImportedModel, engine: InMujoco | InPinocchio, seed: int
) -> None:
    slides = [f"slide{i}" for i in range(1, 7)]
    signs = np.array([grows(made, i) for i in range(6)])
    R_0, t_0 = engine.frame(TOP)
    np.testing.assert_allclose(found.robot.home_position, t_0, rtol=0, atol=1e-12)
    stated = [float(each) for line in found.assumptions for each in STATED.findall(line)]
    assert bool(stated) <= (made.off or made.fault)
    rng = np.random.default_rng([seed, 4])
    for moved in [False] if stated else [False, True]:
        if moved:
            engine.move(rng, 0.05)
        R, t = engine.frame(TOP)
        truth = signs * engine.forces(slides)
        error = np.abs(forces(found, R @ R_0.T, t) - truth).max()
        assert error < SAME * np.abs(truth).max() + 1.005 * sum(stated)
        assert error > 0.99 * sum(stated)


def need_same_mass(robot: ss.Robot, mass: float) -> None:
    np.testing.assert_allclose(robot.M + robot.m_d.sum() + robot.m_u.sum(), mass, rtol=SAME_MASS)


def moving_mass(made: Family) -> float:
    return sum(part.mass for part in made.parts.values() if not part.name.startswith(("base", "foot")))


@sweep
@pytest.mark.parametrize("seed", range(share(MODELS, PART)))
def test_a_random_mjcf_has_the_forces_of_mujoco_and_its_mass(seed: int, tmp_path: Path) -> None:
    made = family(seed)
    text = mjcf(made, seed)
    mujoco.MjModel.from_xml_string(text)
    found = imported_or_rejected(made, ss.ExportedModel(text), tmp_path / "model.xml")
    if found is None:
        return
    need_same_mass(found.robot, moving_mass(made))
    need_same_forces(made, found, InMujoco(text), seed)


@sweep
@pytest.mark.parametrize("seed", range(share(URDFS, PART)))
def test_a_random_urdf_has_the_forces_of_pinocchio_and_its_mass(seed: int, tmp_path: Path) -> None:
    made = family(seed, urdf=True)
    text, loops = urdf(made, seed, drake=False)
    found = imported_or_rejected(made, ss.ExportedModel(text, loops), tmp_path / "model.urdf")
    if found is None:
        return
    need_same_mass(found.robot, moving_mass(made))
    need_same_forces(made, found, InPinocchio(text, json.loads(loops)), seed)
