"""Kits of robots whose legs have rotors prove themselves, whatever they hold."""

from pathlib import Path

import numpy as np
import pytest
from kits import proves_itself
from machines import random_robot, with_random_drives

from stewart_sym.kit.choice import FUNCTIONS, Choice
from stewart_sym.kit.files import kit_names
from stewart_sym.kit.write import write_kit

CHOICES = {
    "pose of a controller": Choice(bake=True, scalar=True, precision="float"),
    "everything": Choice(FUNCTIONS, fmu=True),
    "everything in float": Choice(FUNCTIONS, fidelity="reflected", precision="float"),
    "slender legs": Choice(fidelity="reflected_slender", scalar=True),
    "no rotors": Choice(("forces", "motion"), fidelity="no_rotor", bake=True),
    "spherical joints": Choice(("forces", "reactions"), bake=True),
}


@pytest.mark.parametrize(
    "name",
    [
        name if name == "pose of a controller" else pytest.param(name, marks=pytest.mark.slow)
        for name in CHOICES
    ],
)
def test_kits_with_rotors_prove_themselves(tmp_path: Path, name: str) -> None:
    rng = np.random.default_rng(0)
    joint = "spherical" if name == "spherical joints" else "universal"
    robot = with_random_drives(rng, random_robot(rng, joint))
    made, _ = write_kit(robot, tmp_path / "kit", CHOICES[name])
    assert list(made.files) == kit_names(robot, CHOICES[name])
    assert "m_r" in made.files["stewart.h"].decode()
    proves_itself(tmp_path / "kit", "gcc", "-O0")
