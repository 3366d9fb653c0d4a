"""Absurd robots are doubted with their likely cause, sound ones and published ones are not."""

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import Run, Told
from plausible_machines import (
    ABSURD,
    BASE,
    PLATFORM,
    machine_of,
    published,
    ring,
    scaled,
    sound,
    sound_machine,
    unlimited,
)
from robot_files import written
from sweeps import share

import stewart_sym as ss
from stewart_sym.plausibility.plausibility import find_implausible
from stewart_sym.robot.fields import WARNING_NAMES

Check = Callable[[ss.Robot], Told]


@pytest.fixture
def check(tmp_path: Path, run: Run) -> Check:
    """What ``check`` prints of a robot."""
    return lambda robot: run("check", written(robot, tmp_path / "robot.toml"))


def test_check_warns_of_no_sound_machine(check: Check) -> None:
    rng = np.random.default_rng(200)
    assert check(sound_machine(rng)).err == ""
    for i in range(share(100, 10)):
        assert find_implausible(sound_machine(rng)) == [], i


@pytest.mark.parametrize("limited", [True, False])
def test_published_machines_are_not_doubted(limited: bool) -> None:
    rng = np.random.default_rng(1)
    for name, points in published().items():
        for joint in ("universal", "spherical"):
            assert find_implausible(machine_of(rng, *points, joint, limited)) == [], name


@pytest.mark.parametrize(("name", "leg"), [("mathworks2002", 0), ("tsai2000", 2), ("unal", 5)])
@pytest.mark.parametrize("points", ["b", "p"])
def test_center_lines_of_legs_that_meet_are_doubted(name: str, leg: int, points: str) -> None:
    # Points of neighbors exchanged: seen along the machine axis, the legs cross less than the threshold.
    robot, order = ss.robots.load(name), np.arange(6)
    order[[leg, (leg + 1) % 6]] = (leg + 1) % 6, leg
    (said,) = find_implausible(dataclasses.replace(robot, **{points: getattr(robot, points)[order]}))
    first, second = sorted((leg + 1, (leg + 1) % 6 + 1))
    assert said.name == "crossing"
    assert said.text.startswith(f"legs {first}, {second} cross at the home pose; likely cause: ")


@pytest.mark.parametrize("name", ss.robots.NAMES)
def test_no_robot_of_the_package_is_doubted(name: str) -> None:
    assert find_implausible(ss.robots.load(name)) == []


# Without limits nothing says where the machine stands and what it carries.
BY_LIMITS = {"home of another point"}
BY_LIMITS |= {wrong for wrong, (_, name, _) in ABSURD.items() if name.endswith("-limit") or "limits" in name}


@pytest.mark.parametrize("wrong", ABSURD)
def test_absurd_machines_are_doubted_with_their_likely_cause_most_without_limits_too(wrong: str) -> None:
    change, name, cause = ABSURD[wrong]
    for robot in (sound(),) if wrong in BY_LIMITS else (sound(), unlimited()):
        (said,) = find_implausible(change(robot))
        assert said.name == name or not name
        assert said.name in WARNING_NAMES
        assert cause in said.text
        assert "; likely cause: " in said.text
        assert "\n" not in said.text


@pytest.mark.parametrize("size", [0.005, 20.0])
def test_a_machine_of_that_size_is_not_doubted(size: float) -> None:
    rng = np.random.default_rng(10)
    b, p, t = ring(size, BASE), ring(0.6 * size, PLATFORM), np.array([0.0, 0.0, 1.4 * size])
    for limited in (True, False):
        assert find_implausible(machine_of(rng, b, p, t, limited=limited)) == []


@pytest.mark.parametrize("size", [5e-324, 1e-200, 1e160, 1e308])
def test_numbers_near_the_ends_of_double_are_doubted_and_nothing_else_happens(size: float) -> None:
    for name in ("g", "b", "p", "M", "R_0", "I_p", "r_d0", "I_u0", "m_u", "C_p"):
        values = np.asarray(getattr(unlimited(), name))
        changed = np.where(values != 0.0, np.clip(np.sign(values) * size, -1e308, 1e308), 0.0)
        robot = dataclasses.replace(unlimited(), **{name: float(changed) if name == "M" else changed})
        for said in find_implausible(robot):
            assert said.name in WARNING_NAMES


def test_lengths_have_the_unit_of_the_file() -> None:
    (said,) = find_implausible(scaled(p=1e3)(dataclasses.replace(sound(), length_unit="mm")))
    assert said.text.startswith("base points 500 mm, platform points 300000 mm in RMS radius; ")


def test_check_warns_in_one_line_and_the_file_may_accept_it(tmp_path: Path, run: Run) -> None:
    # Without limits that a thousandfold weight exceeds, which is a doubt of its own.
    robot = ABSURD["gravity in mm/s^2"][0](dataclasses.replace(sound(), force_limit=np.full(6, np.inf)))
    path = tmp_path / "robot.toml"
    for accept in ((), ("gravity",)):
        written(dataclasses.replace(robot, suppressed_warnings=accept), path)
        lines = run("check", path).err.splitlines()
        assert len(lines) == (not accept)
        for line in lines:
            assert line.startswith(f"stewart-sym: warning: {path}: gravity: 9810 m/s^2; likely cause: ")
            assert line.endswith(" [gravity]")


@pytest.mark.parametrize("command", ["generate", "forces", "simulate"])
def test_other_subcommands_warn_of_a_doubtful_robot(command: str, tmp_path: Path, run: Run) -> None:
    robot, log, scene = (tmp_path / name for name in ("robot.toml", "log.csv", "scene.toml"))
    written(ABSURD["speed limit in mm/s"][0](sound()), robot)
    rows = "".join(f"{0.1 * i},0,0,{0.7 + 0.001 * i},0,0,0\n" for i in range(8))
    log.write_text("time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n" + rows)
    legs = '[actuation]\ntype = "constant_force"\nforces = [0, 0, 0, 0, 0, 0]\n'
    state = "[state]\nt = [0.0, 0.0, 0.7]\ntheta = [0.0, 0.0, 0.0]\n"
    scene.write_text(f'schema = 1\nrobot = "{robot.name}"\nduration = 0.001\n{state}{legs}')
    given = {"generate": [robot, "--list"], "forces": [robot, log], "simulate": [scene, "--no-plots"]}
    told = run(command, *given[command], "-o", tmp_path / "out").err.splitlines()
    assert sum("[speed-limit]" in line for line in told) == 1


def test_motors_that_friction_or_a_self_locking_screw_relieves_are_not_said_to_be_weak() -> None:
    def names(**numbers: float) -> list[str]:
        drive = ss.Drive(lead=0.005, torque_limit=2.0, rated_torque=1e-4, **numbers)
        return [doubt.name for doubt in find_implausible(dataclasses.replace(sound(), drive=drive))]

    assert names() == ["drive-limit"]
    assert names(efficiency=0.3, backdrive_efficiency=-0.1) == []
    assert names(screw_coulomb=2e3) == []


def test_an_accepted_doubt_hides_no_other() -> None:
    robot = ss.robots.dasgupta1998()
    weak = dataclasses.replace(robot, g=10.0 * robot.g, force_limit=np.full(6, 10.0))
    assert [doubt.name for doubt in find_implausible(weak)] == ["gravity"]
    assert [
        doubt.name for doubt in find_implausible(dataclasses.replace(weak, suppressed_warnings=("gravity",)))
    ] == ["force-limit"]
