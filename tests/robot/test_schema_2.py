"""Robot files of schema 2: what people write is what is held, bodies by shape too; mistakes have a line."""

import dataclasses
import json
import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run
from robot_files import same, written

import stewart_sym as ss
from stewart_sym.robot.bodies import INERTIA_KEYS, Body, body, joined

TEXT = """\
schema = 2
name = "press"
length_unit = "mm"
angle_unit = "deg"
home_position = [0, 0, 700]

[base]
radius = 600
angles = [10, 110, 130, 230, 250, 350]

[platform]
radius = 300
angles = [50, 70, 170, 190, 290, 310]
z = -50
body = [
    { shape = "plate", radius = 320, thickness = 20, density = 2700 },
    { shape = "box", size = [100, 100, 80], mass = 20.0, center = [0, 0, 50] },
]

[legs]
universal_axis = "tangential"
lower = { shape = "tube", radius = 30, inner_radius = 25, length = 500, density = 7800 }
upper = { shape = "rod", radius = 20, length = 450, mass = 3.5 }
damping = { prismatic = 20.0 }
stroke = [-150, 150]
force_limit = 500.0
speed_limit = 600

[leg.3]
lower = { mass = 9.0, center_of_mass = [250, 0, 0], inertia = [0.005, 0.2, 0.2] }
damping.universal = 0.1

[trajectory]
tool = [0, 0, 300]
euler_order = "xyz"
length_mode = "relative"
"""


def file_of(text: str, folder: Path) -> Path:
    path = folder / "robot.toml"
    path.write_text(text, encoding="utf-8")
    return path


def robot_of(text: str, folder: Path) -> ss.Robot:
    return ss.Robot.from_toml(file_of(text, folder))


@pytest.fixture
def robot(tmp_path: Path) -> ss.Robot:
    return robot_of(TEXT, tmp_path)


def test_points_stand_on_their_circle_in_meters(robot: ss.Robot) -> None:
    turn = np.radians([10, 110, 130, 230, 250, 350])
    expected = np.stack([0.6 * np.cos(turn), 0.6 * np.sin(turn), 0 * turn], axis=-1)
    np.testing.assert_allclose(robot.b, expected, atol=1e-15)
    assert robot.p[:, 2] == pytest.approx(-0.05, abs=0.0)
    np.testing.assert_array_equal(robot.b[0] * [1, -1, 1], robot.b[5])
    np.testing.assert_array_equal(robot.home_position, [0.0, 0.0, 0.7])
    np.testing.assert_array_equal(robot.tool, [0.0, 0.0, 0.3])


def test_lengths_are_the_doubles_next_to_what_is_written(tmp_path: Path) -> None:
    for unit, shift in (("mm", -3), ("cm", -2)):
        text = TEXT.replace('"mm"', f'"{unit}"').replace("tool = [0, 0, 300]", "tool = [512.2, 0.1, 1e-7]")
        expected = [float(f"512.2e{shift}"), float(f"0.1e{shift}"), float(f"1e{shift - 7}")]
        assert robot_of(text, tmp_path).tool.tolist() == expected
    inches = TEXT.replace('"mm"', '"in"').replace("tool = [0, 0, 300]", "tool = [1, 0.1, 10]")
    assert robot_of(inches, tmp_path).tool.tolist() == [0.0254, 0.00254, 0.254]


def test_bodies_are_those_of_their_shapes(robot: ss.Robot) -> None:
    plate = 2700 * math.pi * 0.32**2 * 0.02
    assert robot.M == pytest.approx(plate + 20.0, rel=1e-15)
    np.testing.assert_allclose(robot.R_0, [0, 0, 20.0 * 0.05 / robot.M], rtol=1e-14)
    np.testing.assert_allclose(robot.r_d0[0], [0.25, 0.0, 0.0])
    np.testing.assert_allclose(robot.r_u0[0], [-0.225, 0.0, 0.0])
    assert robot.m_d[0] == pytest.approx(7800 * math.pi * (0.03**2 - 0.025**2) * 0.5)
    across = 3.5 * (0.02**2 / 4 + 0.45**2 / 12)
    np.testing.assert_allclose(robot.I_u0[0], np.diag([3.5 * 0.02**2 / 2, across, across]), rtol=1e-14)


def test_a_leg_of_its_own_keeps_what_the_others_share(robot: ss.Robot) -> None:
    assert robot.m_d[2] == 9.0
    np.testing.assert_array_equal(robot.I_d0[2], np.diag([0.005, 0.2, 0.2]))
    np.testing.assert_array_equal(robot.C_u, [0, 0, 0.1, 0, 0, 0])
    np.testing.assert_array_equal(robot.C_p, np.full(6, 20.0))
    np.testing.assert_array_equal(robot.C_s, np.zeros(6))
    np.testing.assert_array_equal(robot.speed_limit, np.full(6, 0.6))


@pytest.mark.parametrize("joint", ["universal", "spherical"])
def test_a_robot_goes_through_tables_and_files_to_the_bit(joint: str, tmp_path: Path) -> None:
    text = TEXT.replace("home_position = ", f'base_joint = "{joint}"\nhome_position = ')
    if joint == "spherical":
        text = text.replace('universal_axis = "tangential"\n', "")
    found = robot_of(text, tmp_path)
    # The tables have SI units.
    found = dataclasses.replace(found, length_unit="m", angle_unit="rad")
    assert same(ss.Robot.from_dict(json.loads(json.dumps(found.to_dict()))), found)
    assert found.to_dict()["schema"] == 2
    assert same(ss.Robot.from_toml(written(found, tmp_path / "again.toml")), found)
    none = {
        "lower_length": np.zeros(6),
        "upper_length": np.zeros(6),
        "home_position": None,
        "tool": np.zeros(3),
    }
    plain = dataclasses.replace(found, **none, trajectory_format=ss.TrajectoryFormat())
    assert plain.to_dict()["schema"] == 2
    assert same(ss.Robot.from_dict(plain.to_dict()), plain)


def test_axes_by_name_are_what_the_name_says(tmp_path: Path) -> None:
    for name in ("tangential", "radial", "horizontal"):
        found = robot_of(TEXT.replace('"tangential"', f'"{name}"'), tmp_path)
        legs = found.home_position + found.p - found.b
        across = {"tangential": found.b, "radial": np.cross([0, 0, 1], found.b), "horizontal": legs}[name]
        np.testing.assert_allclose(np.sum(found.k * across, axis=-1), 0.0, atol=1e-15)
        np.testing.assert_array_equal(found.k[:, 2], np.zeros(6))
        np.testing.assert_allclose(np.linalg.norm(found.k, axis=-1), 1.0, rtol=1e-15)


def test_points_one_by_one_and_of_one_leg_stand_in_for_the_circle(robot: ss.Robot, tmp_path: Path) -> None:
    points = "points = " + str((1e3 * robot.b).tolist())
    listed = TEXT.replace("radius = 600\nangles = [10, 110, 130, 230, 250, 350]", points)
    np.testing.assert_allclose(robot_of(listed, tmp_path).b, robot.b, rtol=1e-15)
    moved = robot_of(TEXT.replace("[leg.3]", "[leg.3]\nbase_point = [-400, 450, 10]"), tmp_path)
    np.testing.assert_array_equal(moved.b[2], [-0.4, 0.45, 0.01])
    np.testing.assert_array_equal(np.delete(moved.b, 2, axis=0), np.delete(robot.b, 2, axis=0))


def test_a_body_that_cannot_be_is_warned_of_and_may_be_accepted(tmp_path: Path) -> None:
    wrong = TEXT.replace("[0.005, 0.2, 0.2]", "[0.5, 0.2, 0.2]")
    with pytest.warns(ss.RobotWarning, match=r"lower part of leg 3: inertia.* \[lower-inertia\]"):
        robot_of(wrong, tmp_path)
    with warnings.catch_warnings(action="error"):
        robot_of(
            wrong.replace("home_position =", 'suppress_warnings = ["lower-inertia"]\nhome_position ='),
            tmp_path,
        )
        foam = TEXT.replace("2700", "40")
        robot_of(foam, tmp_path)
        robot_of(
            foam.replace("7800", "40").replace(
                "home_position =", 'suppress_warnings = ["density"]\nhome_position ='
            ),
            tmp_path,
        )


# Every mistake: what is replaced by what, the message, and words of the line that it names.
MISTAKES: list[tuple[str, str, str, str]] = [
    ('"mm"', '"ft"', 'length_unit: expected "m", "cm", "mm" or "in", got ', "length_unit"),
    (
        'length_unit = "mm"',
        'units = "mm"',
        'units: unknown key, did you mean "length_unit" or "angle_unit"?',
        "units",
    ),
    ('angle_unit = "deg"\n', "", "base.angles: expected at most 2 turns, got 350 rad: is angle_unit", "350]"),
    ("radius = 600", "radius = 0", "base.radius: expected a number > 0, got 0", "radius = 0"),
    ("radius = 600", "points = []\nradius = 600", "base.radius: expected points or radius and angles", "600"),
    ("250, 350]", "250]", "base.angles: expected 6 finite numbers, got [10, 110", "250]"),
    ("mass = 20.0, ", "", "platform.body 2: mass: missing, expected mass or density", "[100, 100, 80]"),
    ("[100, 100, 80]", "[100, 100]", "platform.body 2: size: expected 3 finite numbers", "[100, 100]"),
    ('"plate"', '"disc"', 'platform.body 1: shape: expected "rod", "tube", "plate" or "box"', '"disc"'),
    ('"tangential"', '"radiall"', "legs.universal_axis: expected ", "universal_axis"),
    ("inner_radius = 25", "inner_radius = 30", "legs.lower.inner_radius: expected a radius smaller", "tube"),
    (
        "density = 7800",
        "density = 7800, mass = 1",
        "legs.lower.density: expected mass or density, got",
        "tube",
    ),
    (
        "[-150, 150]",
        "[-1500, 150]",
        "legs.stroke: expected a leg that is longer at home, 772.479, than it can retract, got 1500",
        "stroke",
    ),
    (
        "[10, 110, 130, 230, 250, 350]",
        "[0.2, 1.9, 2.3, 4, 4.4, 6.1]",
        "base.angles: expected degrees all",
        "6.1",
    ),
    ("[leg.3]", "[leg.7]", "leg.7: unknown key, expected one of 1, 2, 3, 4, 5, 6", "[leg.7]"),
    ("mass = 9.0, ", "", "leg.3.lower.mass: missing, since legs.lower is by shape", "= [250"),
    (
        "schema = 2",
        'schema = 2\nbase_joint = "spherical"',
        "legs.universal_axis: expected none",
        "tangential",
    ),
    (
        "radius = 320",
        "radius = 1e200",
        "platform.body 1: density: expected a body with a mass, got inf",
        "1e200",
    ),
]


@pytest.mark.parametrize(("old", "new", "told", "words"), MISTAKES)
def test_a_mistake_is_one_line_with_key_and_line(
    old: str, new: str, told: str, words: str, tmp_path: Path, run: Run
) -> None:
    text = TEXT.replace(old, new, 1)
    assert text != TEXT
    path = file_of(text, tmp_path)
    (line,) = run("check", path, code=2).err.splitlines()
    message = line.removeprefix(f"stewart-sym: error: {path}: ")
    assert message.startswith(told)
    number = int(message.removesuffix(")").rpartition("(at line ")[2])
    assert words in text.splitlines()[number - 1]


def made(value: Any, along: float | None = None) -> Body:
    found = body(value, "part", lambda x: x, along)
    return Body(*(found[key] for key in INERTIA_KEYS))


def points_of(shape: dict[str, Any], axis: np.ndarray) -> np.ndarray:
    """Points evenly spread over a cylinder about an axis through the origin, or over a box."""
    n = 41
    grid = (np.arange(n) + 0.5) / n - 0.5
    x, y, z = (each.ravel() for each in np.meshgrid(grid, grid, grid))
    if shape["shape"] == "box":
        return np.stack([x, y, z], axis=-1) * shape["size"]
    outer, inner = shape["radius"], shape.get("inner_radius", 0.0)
    # Even in the square of the radius, so that each point has the same volume.
    r = np.sqrt(inner**2 + (outer**2 - inner**2) * (x + 0.5))
    turn = 2.0 * np.pi * y
    height = z * shape.get("length", shape.get("thickness"))
    u = np.linalg.svd(axis[None])[2][1:]
    return r[:, None] * (np.cos(turn)[:, None] * u[0] + np.sin(turn)[:, None] * u[1]) + height[:, None] * axis


SHAPES: list[dict[str, Any]] = [
    {"shape": "rod", "radius": 0.1, "length": 0.7},
    {"shape": "tube", "radius": 0.2, "inner_radius": 0.15, "length": 0.3},
    {"shape": "plate", "radius": 0.5, "inner_radius": 0.4, "thickness": 0.1},
    {"shape": "box", "size": [0.2, 0.5, 0.9]},
]


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("axis", [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8]])
def test_inertia_is_that_of_points_spread_over_the_shape(shape: dict[str, Any], axis: list[float]) -> None:
    turned = {} if shape["shape"] == "box" else {"axis": axis}
    found = made({**shape, "mass": 2.0, "center": [0.1, -0.2, 0.3], **turned})
    x = points_of(shape, np.array(axis))
    square = np.einsum("ni,nj->ij", x, x) / len(x)
    expected = 2.0 * (np.trace(square) * np.eye(3) - square)
    np.testing.assert_allclose(found.inertia, expected, atol=2e-3 * np.abs(expected).max())
    np.testing.assert_array_equal(found.center_of_mass, [0.1, -0.2, 0.3])


def test_joined_bodies_move_as_one() -> None:
    """Kinetic energy and momentum of any motion are the sums of the parts'."""
    rng = np.random.default_rng(5)
    parts = []
    for _ in range(4):
        root = rng.normal(size=(3, 3))
        tensor = np.trace(root @ root.T) * np.eye(3) - root @ root.T
        parts.append(Body(rng.uniform(0.5, 2.0), rng.normal(size=3), tensor))
    one = joined(parts)
    for _ in range(5):
        v, omega = rng.normal(size=(2, 3))
        energies = [
            0.5 * each.mass * np.sum((v + np.cross(omega, each.center_of_mass)) ** 2)
            + 0.5 * omega @ each.inertia @ omega
            for each in (*parts, one)
        ]
        assert sum(energies[:-1]) == pytest.approx(energies[-1], rel=1e-13)
    moments = sum(each.mass * each.center_of_mass for each in parts)
    np.testing.assert_allclose(one.mass * one.center_of_mass, moments, rtol=1e-14)
