"""Robot files: the paper's, which comes with the package, and one of any robot."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np

import stewart_sym as ss
from stewart_sym.io.output import toml_text

PAPERS = Path(ss.robots.__file__).parent / "dasgupta1998.toml"
PRESS = """\
schema = 2
name = "press"
length_unit = "mm"
angle_unit = "deg"
home_position = [0, 0, 700]
base = { radius = 600, angles = [10, 110, 130, 230, 250, 350] }

[platform]
radius = 300
angles = [50, 70, 170, 190, 290, 310]
body = { shape = "plate", radius = 320, thickness = 20, density = 2700 }

[legs]
universal_axis = "tangential"
lower = { shape = "tube", radius = 30, inner_radius = 25, length = 500, density = 7800 }
upper = { shape = "rod", radius = 20, length = 450, mass = 3.5 }

"""
"""A machine of six shapes, without limits or friction."""


def written(robot: ss.Robot, path: Path) -> Path:
    """The robot as a file that can be read."""
    path.write_text(toml_text(robot.to_dict()), encoding="utf-8")
    return path


def same(one: ss.Robot, other: ss.Robot) -> bool:
    """Whether two robots agree to the last bit."""
    return all(
        np.array_equal(getattr(one, each.name), getattr(other, each.name)) for each in dataclasses.fields(one)
    )


def scene_of(text: str, folder: Path) -> Path:
    """A scene or budget as a file, the paper's robot in a folder beside it."""
    (folder / "robots").mkdir()
    shutil.copy(PAPERS, folder / "robots" / "robot.toml")
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


HANGING = """\
schema = 2
name = "hanging"
length_unit = "mm"
angle_unit = "deg"
gravity = [0.0, 0.0, 9.81]
home_position = [0.0, 0.0, 700.0]
base = { radius = 500.0, angles = [-10.0, 10.0, 110.0, 130.0, 230.0, 250.0] }

[platform]
radius = 250.0
angles = [-50.0, 50.0, 70.0, 170.0, 190.0, 290.0]
body = { shape = "plate", radius = 300.0, thickness = 20.0, density = 2700.0 }

[legs]
universal_axis = "tangential"
lower = { shape = "tube", radius = 30.0, inner_radius = 25.0, length = 400.0, density = 7800.0 }
upper = { shape = "rod", radius = 20.0, length = 400.0, density = 7800.0 }
stroke = [-150.0, 150.0]
force_limit = 300.0
joint_angle_limit = [30.0, 22.0]
"""
"""Machine in mm and degrees whose z axis points down."""
