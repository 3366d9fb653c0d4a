"""Absurd robots are doubted with their likely cause, sound ones and published ones are not."""

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import Run, Told
from plausible_machines import (
    ABSURD,
    machine_of,
    published,
    sound,
    sound_machine,
    unlimited,
)
from robot_files import written
from sweeps import share

import stewart_sym as ss
from stewart_sym.plausibility.plausibility import find_implausible
from stewart_sym.robot.robot import WARNING_NAMES

Check = Callable[[ss.Robot], Told]


@pytest.fixture
def check(tmp_path: Path, run: Run) -> Check:
    """What ``check`` prints of a robot."""
    return lambda robot: run("check", written(robot, tmp_path / "robot.toml"))


def test_check_warns_of_no_sound_machine(check: Check) -> None:
    rng = np.random.default_rng(200)
    for i in range(share(100, 25)):
        assert check(sound_machine(rng)).err == "", i


@pytest.mark.parametrize("name", published())
def test_published_machines_are_not_doubted(name: str) -> None:
    limited = True
    rng = np.random.default_rng(1)
    for joint in ("universal", "spherical"):
        assert find_implausible(machine_of(rng, *published()[name], joint, limited)) == []


# Without limits nothing says where the machine stands and what it carries.
BY_LIMITS = {
    "universal axis along the leg",
    "home of another point",
    "lead in meters in a file of millimeters",
}
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


@pytest.mark.parametrize("size", [5e-324, 1e308])
def test_numbers_near_the_ends_of_double_are_doubted_and_nothing_else_happens(size: float) -> None:
    for name in ("g", "b", "p", "M", "R_0", "I_p", "r_d0", "I_u0", "m_u", "C_p"):
        values = np.asarray(getattr(unlimited(), name))
        changed = np.where(values != 0.0, np.clip(np.sign(values) * size, -1e308, 1e308), 0.0)
        robot = dataclasses.replace(unlimited(), **{name: float(changed) if name == "M" else changed})
        for said in find_implausible(robot):
            assert said.name in WARNING_NAMES


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


def arguments_of(command: str, robot: Path, folder: Path) -> list[str]:
    """A call of a subcommand that reads a robot file, as short as can be."""
    log = folder / "log.csv"
    rows = "".join(f"{0.1 * i},0,0,{0.7 + 0.001 * i},0,0,0\n" for i in range(8))
    log.write_text("time,t_x,t_y,t_z,theta_x,theta_y,theta_z\n" + rows)
    scene = folder / "scene.toml"
    legs = '[actuation]\ntype = "constant_force"\nforces = [0, 0, 0, 0, 0, 0]\n'
    state = "[state]\nt = [0.0, 0.0, 0.7]\ntheta = [0.0, 0.0, 0.0]\n"
    scene.write_text(f'schema = 1\nrobot = "{robot.name}"\nduration = 0.001\n{state}{legs}')
    out = ["-o", str(folder / f"{command}.out")]
    return {
        "check": [command, str(robot)],
        "generate": [command, str(robot), "--list", *out],
        "forces": [command, str(robot), str(log), *out],
        "singularities": [command, str(robot), str(log), "--no-plots", *out],
        "simulate": [command, str(scene), "--no-plots", *out],
    }[command]


@pytest.mark.parametrize("command", ["check", "forces", "simulate"])
def test_every_subcommand_warns_of_a_doubtful_robot(command: str, tmp_path: Path, run: Run) -> None:
    for change, count in ((ABSURD["speed limit in mm/s"][0], 1), (lambda robot: robot, 0)):
        folder = tmp_path / str(count)
        folder.mkdir()
        path = folder / "robot.toml"
        written(change(sound()), path)
        told = [
            line
            for line in run(*arguments_of(command, path, folder)).err.splitlines()
            if "[speed-limit]" in line
        ]
        assert len(told) == count


def test_motors_that_friction_or_a_self_locking_screw_relieves_are_not_said_to_be_weak() -> None:
    def names(**numbers: float) -> list[str]:
        drive = ss.Drive(lead=0.005, torque_limit=2.0, rated_torque=1e-4, **numbers)
        return [doubt.name for doubt in find_implausible(dataclasses.replace(sound(), drive=drive))]

    assert names() == ["drive-limit"]
    assert names(efficiency=0.3, backdrive_efficiency=-0.1) == []
    assert names(screw_coulomb=2e3) == []
    assert (
        "rated_torque of the drives of "
        in find_implausible(
            dataclasses.replace(sound(), drive=ss.Drive(lead=0.005, torque_limit=2.0, rated_torque=1e-4))
        )[0].text
    )
