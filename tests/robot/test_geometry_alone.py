"""Robot files with geometry alone: kinematics works, and everything else names the missing keys."""

import dataclasses
import functools
import json
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_files import edit
from command_line import Fails, Run
from public_calls import Call, calls
from robot_files import HANGING

import stewart_sym as ss

MISSING = "platform.body, legs.lower, legs.upper: missing"
GEOMETRY = "".join(
    line for line in HANGING.splitlines(keepends=True) if not line.startswith(("body", "lower", "upper"))
)
MASS_FIELDS = ("M", "R_0", "I_p", "m_d", "r_d0", "I_d0", "m_u", "r_u0", "I_u0")
# Public functions with a robot that work without masses; all others name the missing keys.
KINEMATICS = """
ArrayKernel axis_travel base_parameters certify_pose characteristic_length
equations_by_parameter forward_acceleration forward_kinematics forward_velocity inverse_jacobian
inverse_kinematics jacobian joint_angles leg_distances motion_from_lengths motor_angles motor_forces
path_singularities plan_path pose_from_motor_angles regressor rotor_regressor singularity
singularity_crossings up_direction view workspace wrench_matrix wrench_matrix_rate write_trajectory
LegSprings StopConditions
"""


def without_masses(robot: ss.Robot) -> ss.Robot:
    """The same machine with NaN for all mass properties."""
    return dataclasses.replace(
        robot, **{name: np.full(np.shape(getattr(robot, name)), np.nan) for name in MASS_FIELDS}
    )


def is_finite(value: Any) -> bool:
    """Return False if a result contains NaN."""
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        return not np.isnan(value).any()
    inside = dataclasses.is_dataclass(value) and not isinstance(value, ss.Robot | ss.ArrayKernel)
    return not inside or all(map(is_finite, vars(value).values()))


@functools.cache
def called() -> dict[str, Call]:
    """Calls of public functions with a robot, except of the one that reads a file."""
    found = {name: call for name, call in calls().items() if "robot" in call.arguments}
    return {name: call for name, call in found.items() if name != "read_trajectory"}


@pytest.mark.parametrize("name", sorted(called()))
def test_each_function_works_or_names_the_missing_keys(name: str) -> None:
    call = called()[name]
    given = call.arguments | {"robot": without_masses(call.arguments["robot"])}
    if name in KINEMATICS.split():
        assert is_finite(call.function(**given))
        return
    with pytest.raises(ValueError, match=MISSING) as error:
        call.function(**given)
    assert "\n" not in str(error.value)


def test_a_file_with_geometry_alone_goes_through_tables(tmp_path: Path) -> None:
    robot = ss.Robot.from_dict(tomllib.loads(GEOMETRY))
    assert robot.missing_bodies == ("platform.body", "legs.lower", "legs.upper")
    assert not robot.find_invalid_inertias()
    again = ss.Robot.from_dict(robot.to_dict())
    for field in dataclasses.fields(ss.Robot):
        if not field.name.endswith("_unit"):
            one, other = (getattr(each, field.name) for each in (robot, again))
            np.testing.assert_array_equal(one, other) if isinstance(one, np.ndarray) else None
    full = ss.Robot.from_dict(tomllib.loads(HANGING))
    motion = ss.Motion.at_rest(R=np.eye(3), t=[0.0, 0.0, 0.71])
    np.testing.assert_array_equal(
        ss.inverse_kinematics(robot, motion).L, ss.inverse_kinematics(full, motion).L
    )
    for limits in (ss.PoseLimits(), ss.PoseLimits(forces=False)):
        one, other = (ss.workspace(each, limits=limits, samples=500) for each in (robot, full))
        assert one.volume == other.volume or limits.forces
    assert ss.axis_travel(robot).acceleration is None
    np.testing.assert_allclose(
        ss.axis_travel(robot).travel, ss.axis_travel(full, ss.PoseLimits(forces=False)).travel
    )


def test_a_body_of_one_leg_alone_is_an_error(folder: Path, fails: Fails) -> None:
    (folder / "geometry.toml").write_text(f"{GEOMETRY}\n[leg.1]\nlower.mass = 1.0\n")
    assert "lower" in fails("check", "geometry.toml")


@pytest.mark.slow
def test_subcommands_of_kinematics_work_and_others_name_the_missing_keys(
    folder: Path, run: Run, fails: Fails
) -> None:
    (folder / "geometry.toml").write_text(GEOMETRY)
    assert f"masses       {MISSING.split(':')[0]}" not in run("check", "geometry.toml").out
    report = run("check", "geometry.toml", "-o", "geometry").out
    assert "masses       missing: platform.body, legs.lower, legs.upper; kinematics only, no forces" in report
    data = json.loads((folder / "geometry" / "report.json").read_text())
    assert "body" not in data["robot"]["platform"]
    assert (folder / "geometry" / "machine.png").exists()
    told = run("workspace", "geometry.toml", "--samples", 500, "--no-plots").out
    assert "not actuator forces: platform.body is missing" in told
    run("view", "geometry.toml", "-o", "view.html")
    run("singularities", "geometry.toml", "III", "--no-plots")
    assert "nan" in (folder / "singularities" / "path.csv").read_text()
    edit(folder / "swing.toml", 'robot = "hexapod.toml"', 'robot = "geometry.toml"')
    for command in (
        ("forces", "geometry.toml", "trajectory.csv", "-o", "f.csv"),
        ("generate", "geometry.toml", "-o", "kit"),
        ("export", "geometry.toml", "--format", "mjcf", "-o", "x.xml"),
        ("size-actuators", "geometry.toml", "trajectory.csv"),
        ("simulate", "swing.toml"),
    ):
        assert MISSING in fails(*command)
