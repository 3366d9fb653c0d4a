"""Robot files: what is read is what is held, and every break of the schema is named in one line."""

import dataclasses
import json
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from command_line import error_of
from robot_files import same

from stewart_sym import robots
from stewart_sym.robot.robot import Robot, RobotWarning

Tables = dict[str, Any]


def part(mass: float, x: float) -> Tables:
    inertia = [[0.02, 0.001, 0.0], [0.001, 0.3, 0.002], [0.0, 0.002, 0.31]]
    return {"mass": mass, "center_of_mass": [x, 0.01, -0.02], "inertia": inertia}


def machine() -> Tables:
    """Return a possible machine with distinct legs; leg 3 overrides in part what legs share."""
    angles = np.arange(6) * np.pi / 3
    legs: Tables = {
        str(i): {"universal_axis": [-3.0 * math.sin(a), 3.0 * math.cos(a), 0.1]}
        for i, a in enumerate(angles, 1)
    }
    legs["3"] |= {"lower": {"mass": 7.5}, "damping": {"prismatic": 2.0}, "length_limits": [0.5, 2.0]}
    legs["3"] |= {"force_limit": 900.0, "speed_limit": 0.7}
    body = {**part(40.0, 0.04), "inertia": [[1.0, 0.0, 0.1], [0.0, 1.1, 0.0], [0.1, 0.0, 1.5]]}
    above = [[0.5 * math.cos(a + 0.4), 0.5 * math.sin(a + 0.4), 0.0] for a in angles]
    return {
        "schema": 2,
        "name": "test machine",
        "gravity": [0.1, -0.2, -9.7],
        "base": {"points": [[math.cos(a), math.sin(a), 0.01 * i] for i, a in enumerate(angles)]},
        "platform": {"points": above, "body": body},
        "legs": {
            "lower": part(3.0, 0.4),
            "upper": part(1.0, -0.6),
            "damping": {"universal": 0.1, "prismatic": 1, "spherical": 0.0},
        },
        "leg": legs,
    }


def spherical_machine() -> Tables:
    d = machine() | {"base_joint": "spherical"}
    for leg in d["leg"].values():
        del leg["universal_axis"]
    for name in ("lower", "upper"):
        body = d["legs"][name]
        body["center_of_mass"][1:] = [0.0, 0.0]
        body["inertia"] = [[0.02, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.3]]
    return d


def test_values_stand_where_the_contract_puts_them() -> None:
    robot = Robot.from_dict(machine())
    assert robot.base_joint == "universal"
    np.testing.assert_array_equal(robot.g, [0.1, -0.2, -9.7])
    np.testing.assert_array_equal(robot.m_d, [3.0, 3.0, 7.5, 3.0, 3.0, 3.0])
    np.testing.assert_array_equal(robot.C_p, [1.0, 1.0, 2.0, 1.0, 1.0, 1.0])
    np.testing.assert_array_equal(robot.C_u, np.full(6, 0.1))
    np.testing.assert_array_equal(robot.r_u0, np.tile([-0.6, 0.01, -0.02], (6, 1)))
    assert robot.I_d0.shape == robot.I_u0.shape == (6, 3, 3)
    np.testing.assert_array_equal(robot.length_limits[[1, 2]], [[0.0, np.inf], [0.5, 2.0]])
    np.testing.assert_array_equal(robot.force_limit[1:3], [np.inf, 900.0])
    np.testing.assert_array_equal(robot.speed_limit[1:3], [np.inf, 0.7])


@pytest.mark.parametrize("tables", [machine, spherical_machine])
def test_to_dict_round_trips_exactly(tables: Callable[[], Tables]) -> None:
    robot = Robot.from_dict(tables())
    again = Robot.from_dict(json.loads(json.dumps(robot.to_dict())))
    assert same(robot, again)
    assert again.to_dict() == robot.to_dict()


def test_replace_makes_a_checked_copy() -> None:
    robot = Robot.from_dict(machine())
    message = error_of(lambda: dataclasses.replace(robot, m_u=np.array([1, 1, 1, -1, 1, 1.0])))
    assert message == "robot: leg 4: m_u: expected a number > 0, got -1"
    assert "robot: b: expected one entry for each of six legs" in error_of(
        lambda: dataclasses.replace(robot, b=np.zeros((5, 3)))
    )
    assert "robot: platform.body: expected mass" in error_of(lambda: dataclasses.replace(robot, M=math.nan))
    message = error_of(lambda: dataclasses.replace(robot, I_p=[1, 1, 1]))
    assert message == "robot: I_p: expected 3 x 3 finite numbers, got [1, 1, 1]"
    assert "robot: leg 1: length_limits" in error_of(
        lambda: dataclasses.replace(robot, length_limits=np.tile([0.3, np.inf], (6, 1)))
    )


@pytest.mark.parametrize(
    ("name", "one"),
    [("m_d", 2.0), ("length_limits", [0.1, 0.2]), ("I_u0", np.eye(3))],
)
def test_one_entry_is_that_of_all_legs(name: str, one: Any) -> None:
    robot = dataclasses.replace(Robot.from_dict(machine()), home_position=[0.0, 0.0, 1.0])
    found = dataclasses.replace(robot, **{name: one})
    assert same(found, dataclasses.replace(robot, **{name: [one] * 6}))
    message = error_of(lambda: dataclasses.replace(robot, **{name: [one] * 5}))
    assert message.startswith(f"robot: {name}: expected ")
    assert message.endswith("(one for all legs, or six)")


# Every wrong value: where it stands, what it is, what the message must hold.
WRONG: list[tuple[tuple[str | int, ...], Any, str]] = [
    (("schema",), 3, "schema: expected 2, got 3"),
    (("schema",), 1, "schema: schema 1 is no longer read; write schema = 2, "),
    (("name",), "two\nlines", "name: expected one line of text"),
    (("base_joint",), "cardan", 'base_joint: expected "universal" or "spherical"'),
    (("gravity",), [0.0, -9.81], "gravity: expected 3 finite numbers"),
    (("platform", "body", "mass"), 0.0, "platform.body.mass: expected a number > 0, got 0"),
    (("platform", "body", "mass"), "40", "platform.body.mass: expected a finite number, got '40'"),
    (
        ("platform", "body", "inertia"),
        [[1, 0.2, 0], [0.1, 1, 0], [0, 0, 1]],
        "platform.body.inertia: expected a symmetric tensor, got 0.2 at (1, 2) and 0.1 at (2, 1)",
    ),
    (("leg",), [], "leg: expected tables [leg.1] to [leg.6], got []"),
    (
        ("leg", "3", "universal_axis"),
        [0, 0, 0],
        "leg.3.universal_axis: expected a non-zero direction, got (0, 0, 0)",
    ),
    (
        ("leg", "3", "length_limits"),
        [2.0, 0.5],
        "leg.3.length_limits: expected [min, max] with 0 <= min < max",
    ),
    (("leg", "3", "force_limit"), 0, "leg.3.force_limit: expected a number > 0"),
]


MISSING: list[tuple[tuple[str | int, ...], str]] = [
    (("platform",), "platform: missing"),
    (("base", "points"), "base.points: missing, and leg.1.base_point as well"),
    (("platform", "body", "mass"), "platform.body.mass: missing"),
    (("leg", "6", "universal_axis"), "legs.universal_axis: missing"),
]


MISSPELT: list[tuple[tuple[str | int, ...], str]] = [
    (("gravitation",), 'gravitation: unknown key, did you mean "gravity"?'),
    (
        ("platform", "body", "centre_of_mass"),
        'platform.body.centre_of_mass: unknown key, did you mean "center_of_mass"?',
    ),
    (("leg", "3", "universal_axes"), 'leg.3.universal_axes: unknown key, did you mean "universal_axis"?'),
    (("two\nlines",), "two\\nlines: unknown key"),
]


EVERY = [
    *WRONG,
    *((path, None, expected) for path, expected in MISSING),
    *((path, 1.0, expected) for path, expected in MISSPELT),
]


@pytest.mark.parametrize(("path", "value", "expected"), EVERY)
def test_what_is_wrong_missing_or_misspelt_is_named(
    path: tuple[str | int, ...], value: Any, expected: str
) -> None:
    """None: the key is left out."""
    d = machine()
    table: Any = d
    for key in path[:-1]:
        table = table[key]
    if value is None:
        del table[path[-1]]
    else:
        table[path[-1]] = value
    message = error_of(lambda: Robot.from_dict(d))
    assert message == f"robot: {expected}" if value is None else message.startswith(f"robot: {expected}")


def test_spherical_base_joint_rejects_axes_and_asymmetric_legs() -> None:
    d = spherical_machine()
    d["leg"]["2"]["universal_axis"] = [1, 0, 0]
    assert error_of(lambda: Robot.from_dict(d)).startswith("robot: leg.2.universal_axis: expected none")
    d = spherical_machine()
    d["leg"]["5"]["upper"] = {"center_of_mass": [-0.6, 0.0, 0.001]}
    assert error_of(lambda: Robot.from_dict(d)).startswith("robot: leg.5.upper: expected (x, 0, 0)")
    d = spherical_machine()
    d["leg"]["5"]["lower"] = {"inertia": [[0.02, 0, 0], [0, 0.3, 0], [0, 0, 0.31]]}
    assert error_of(lambda: Robot.from_dict(d)).startswith("robot: leg.5.lower: expected diag(Ia, It, It)")


# Files


def test_paper_machine_is_the_appendix() -> None:
    robot = robots.dasgupta1998()
    assert robot.M == 40.0
    np.testing.assert_allclose(robot.k[0], np.array([-3.0, 1.0, 0.0]) / math.sqrt(10.0), atol=1e-4)
    np.testing.assert_array_equal(robot.b[:, 0], [0.6, 0.1, -0.3, -0.3, 0.2, 0.5])
    np.testing.assert_array_equal(robot.b[:, 1], [0.2, 0.5, 0.3, -0.4, -0.3, -0.2])
    np.testing.assert_array_equal(robot.b[:, 2], [0.0, 0.1, 0.1, 0.0, -0.05, 0.0])
    np.testing.assert_array_equal(robot.p[:, 0], [0.3, 0.3, 0.0, -0.2, -0.15, 0.15])
    np.testing.assert_array_equal(robot.p[:, 1], [0.0, 0.2, 0.3, 0.1, -0.2, -0.15])
    np.testing.assert_array_equal(robot.p[:, 2], [0.1, 0.0, 0.0, -0.1, -0.05, -0.05])
    np.testing.assert_array_equal(robot.r_d0, np.tile([0.4, 0.14, -0.18], (6, 1)))
    np.testing.assert_array_equal(robot.r_u0, np.tile([-0.6, -0.08, 0.08], (6, 1)))
    np.testing.assert_array_equal(robot.I_u0[3], [[5e-3, 2e-3, 2e-3], [2e-3, 2e-3, 1e-3], [2e-3, 1e-3, 3e-3]])
    np.testing.assert_array_equal(robot.g, [0.0, 0.0, -9.81])


def test_a_file_accepts_the_warnings_that_it_names_and_no_other() -> None:
    accepted = "lower-inertia"
    d = robots.dasgupta1998().to_dict() | {"suppress_warnings": [accepted]}
    with pytest.warns(RobotWarning) as caught:
        Robot.from_dict(d)
    assert len(caught) == 2
    assert not any(accepted in str(w.message) for w in caught)


@pytest.mark.parametrize(
    ("moments", "possible"),
    [
        ((1.0, 1.0, 1.0), True),
        ((1.0, 2.0, 3.0), True),
        ((0.0, 2.0, 2.0), True),
        ((1.0, 2.0, 3.001), False),
        ((-0.001, 2.0, 2.0), False),
        ((-1.0, -1.0, -1.0), False),
    ],
)
def test_possible_inertias_are_those_of_bodies(moments: tuple[float, float, float], possible: bool) -> None:
    c, s = math.cos(0.6), math.sin(0.6)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    robot = dataclasses.replace(Robot.from_dict(machine()), I_p=turn @ np.diag(moments) @ turn.T)
    assert (robot.find_invalid_inertias() == []) == possible
