"""Offset joints in robot files, and that nothing computes them as if they were ordinary legs."""

import dataclasses
import math
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command_line import Run, rejects
from machines import offset_case
from pages import DOCS
from public_calls import calls

import stewart_sym as ss
from stewart_sym.backend.kernel import robot_numbers
from stewart_sym.motion.rotation import rotation_from_rpy

EXAMPLE = DOCS / "examples" / "offset-joints.toml"

SERVED = {
    *("inverse_dynamics", "joint_reactions", "massless_forces", "dynamic_fraction", "equations_of_motion"),
    *("forward_dynamics", "joint_space_inertia", "inverse_kinematics", "wrench_matrix", "forward_kinematics"),
    *("forward_velocity", "forward_acceleration", "motion_from_lengths", "array_kernel", "ArrayKernel"),
    *("prepare", "LegSprings", "LegSprings.balanced", "ComputedTorque", "simulate", "singularity"),
    *("force_deviations", "motor_angles", "pose_of_motors", "capability", "drive_effort", "motor_forces"),
    *("view", "export_model", "joint_angles", "size", "wrench_matrix_rate"),
}
"""Functions that compute offset joints."""
OF_POINTS = {"up_direction", "characteristic_length", "read_trajectory"}
"""Functions of the joints' points alone, or of files."""


def _example() -> dict[str, Any]:
    return tomllib.loads(EXAMPLE.read_text(encoding="utf-8"))


def test_a_file_in_millimetres_is_read() -> None:
    robot = ss.Robot.from_toml(EXAMPLE)
    offsets = robot.offsets
    np.testing.assert_allclose(offsets.cross, 0.01, rtol=1e-15)
    np.testing.assert_allclose(offsets.across, 0.004, rtol=1e-15)
    np.testing.assert_allclose(offsets.cross_center, np.tile([0.005, 0, 0], (6, 1)), rtol=1e-15)
    assert offsets.cross_mass.tolist() == [0.15] * 6
    assert offsets.cross_inertia.tolist() == [2e-5] * 6


def test_a_leg_has_offsets_of_its_own() -> None:
    d = _example()
    d["leg"] = {"3": {"offsets": {"cross": 12.0}, "cross": {"mass": 0.2}}}
    offsets = ss.Robot.from_dict(d).offsets
    np.testing.assert_allclose(offsets.cross, [0.01, 0.01, 0.012, 0.01, 0.01, 0.01])
    np.testing.assert_allclose(offsets.across, 0.004)
    assert offsets.cross_mass[2] == 0.2


@pytest.mark.parametrize("joint", ["spherical", "universal"])
def test_what_to_dict_writes_is_read_to_the_bit(joint: str) -> None:
    robot, _ = offset_case(0, joint, screws=True)
    again = ss.Robot.from_dict(robot.to_dict())
    for each in dataclasses.fields(ss.Offsets):
        np.testing.assert_array_equal(getattr(again.offsets, each.name), getattr(robot.offsets, each.name))
    assert (
        ss.Robot.from_dict(
            _example()
            | {"legs": {k: v for k, v in _example()["legs"].items() if k not in ("offsets", "cross")}}
        ).offsets
        is None
    )


UNIVERSAL = {"platform_joint": "universal", "platform_axis": [0, 1, 0], "wrist": 3.0}


@pytest.mark.parametrize(
    ("table", "value", "message"),
    [
        ("offsets", {"cros": 1.0}, "legs.offsets.cros"),
        ("offsets", {"cross": "10"}, "legs.offsets.cross: expected a finite number"),
        ("offsets", {"cross": math.inf}, "legs.offsets.cross: expected a finite number"),
        ("offsets", {"cross": [1.0] * 6}, "legs.offsets.cross: expected a finite number"),
        ("offsets", {"wrist": 1.0}, "legs.offsets.wrist: expected none unless"),
        ("offsets", {"platform_axis": [0, 0, 1]}, "legs.offsets.platform_axis: expected none unless"),
        ("offsets", {"platform_joint": "hooke"}, "legs.offsets.platform_joint: expected"),
        ("offsets", {"platform_joint": "universal"}, "legs.offsets.platform_axis: missing"),
        ("offsets", {**UNIVERSAL, "platform_axis": [0, 0, 0]}, "legs.offsets.platform_axis: expected a non"),
        ("offsets", 10.0, "legs.offsets: expected a table"),
        ("cross", {"mass": -1.0}, "legs.cross.mass: expected a number >= 0"),
        ("cross", {"inertia": [1, 1, 1]}, "legs.cross.inertia: expected a finite number"),
        ("cross", {"center_of_mass": [0.0, 1.0]}, "legs.cross.center_of_mass: expected 3 finite"),
        ("stroke", [-1.0, 1.0], "legs.stroke: expected stroke or length_limits, got both"),
    ],
)
def test_bad_files_give_one_line_with_the_key(table: str, value: object, message: str) -> None:
    d = _example()
    d["legs"][table] = value
    rejects(re.escape(f"robot: {message}"), ss.Robot.from_dict, d)


def test_a_rack_moves_no_leg_whose_upper_part_turns() -> None:
    d = _example()
    d["legs"]["drive"] = {"radius": 12.0, "gear": 5.0}
    assert ss.Robot.from_dict(d).drive is not None
    d["legs"]["offsets"] |= UNIVERSAL
    rejects(r'\Arobot: legs\.drive\.radius: expected lead where .* "universal"', ss.Robot.from_dict, d)


@pytest.mark.parametrize("joint", [{}, UNIVERSAL], ids=["spherical", "universal"])
def test_a_stroke_is_about_the_length_along_the_line_of_sliding(joint: dict[str, Any]) -> None:
    d = _example()
    d["legs"]["offsets"] |= joint
    del d["legs"]["length_limits"]
    d["legs"]["stroke"] = [-50.0, 30.0]
    robot = ss.Robot.from_dict(d)
    L = ss.inverse_kinematics(robot, ss.Motion(np.eye(3), robot.home, *np.zeros((2, 3)))).L
    np.testing.assert_allclose(robot.length_limits, np.stack([L - 0.05, L + 0.03], axis=-1), rtol=1e-14)
    plain = np.linalg.norm(robot.home + robot.p - robot.b, axis=-1)
    assert np.abs(L - plain).min() > 1e-3
    d["legs"]["offsets"]["across"] = 5000.0
    rejects(r"legs\.stroke: .* which the offsets cannot reach", ss.Robot.from_dict, d)


def test_joints_swing_as_the_lines_of_sliding_do() -> None:
    d = _example()
    d["legs"]["offsets"] |= UNIVERSAL
    robot = ss.Robot.from_dict(d)
    R = rotation_from_rpy(np.array([0.1, -0.05, 0.2]))
    home, away = (ss.Motion(turn, robot.home, *np.zeros((2, 3))) for turn in (np.eye(3), R))
    s, neutral = (ss.inverse_kinematics(robot, pose).s for pose in (away, home))
    found = ss.joint_angles(robot, away)
    np.testing.assert_allclose(np.cos(found.base), np.sum(s * neutral, axis=-1), rtol=1e-12)
    np.testing.assert_allclose(np.cos(found.platform), np.sum((s @ R) * neutral, axis=-1), rtol=1e-12)
    assert ss.joint_angles(robot, home).base.max() < 1e-12


def test_the_same_platform_joint_for_all_legs() -> None:
    d = _example()
    d["leg"] = {"2": {"offsets": {"platform_joint": "universal"}}}
    rejects(re.escape("leg.2.offsets.platform_joint: expected it in legs"), ss.Robot.from_dict, d)
    d = _example() | {"base_joint": "spherical"}
    del d["legs"]["universal_axis"]
    rejects(re.escape("legs.offsets: expected none when base_joint"), ss.Robot.from_dict, d)


def test_every_public_function_computes_offsets_or_rejects_them() -> None:
    every = calls()
    seen = {name for name, call in every.items() if "robot" in call.arguments}
    assert SERVED | OF_POINTS <= seen
    for name in seen - OF_POINTS:
        call = every[name]
        robot = dataclasses.replace(
            call.arguments["robot"], offsets=ss.Offsets(cross=np.full(6, 0.02), along=np.full(6, 0.01))
        )
        given = {**call.arguments, "robot": robot}
        if name in SERVED:
            call.function(**given)
            continue
        with pytest.raises(ValueError, match="offset") as caught:
            call.function(**given)
        assert "\n" not in str(caught.value), name


def test_results_are_those_of_offsets() -> None:
    """Of what ``test_offset_joints`` does not compare."""
    robot, motion = offset_case(0)
    plain = dataclasses.replace(robot, offsets=None)
    e, H = ss.equations_of_motion(robot, motion), ss.wrench_matrix(robot, motion)
    np.testing.assert_allclose(H, ss.inverse_dynamics(robot, motion).H, atol=1e-13 * np.abs(H).max())
    inverse = np.linalg.inv(H)
    felt = ss.joint_space_inertia(robot, motion)
    np.testing.assert_allclose(felt, inverse @ e.M @ inverse.T, rtol=1e-9, atol=1e-9 * np.abs(felt).max())
    assert ss.singularity(robot, motion).condition != ss.singularity(plain, motion).condition
    fixed = ss.Motion(motion.R, motion.t, 0 * motion.t, 0 * motion.t)
    springs = ss.LegSprings.balanced(robot, fixed, 1e6)
    held = ss.Motion(motion.R, motion.t, *np.zeros((4, 3)))
    np.testing.assert_allclose(springs(0.0, fixed), ss.inverse_dynamics(robot, held).F, rtol=1e-6)
    rejects("offsets", robot_numbers, robot)


def test_paper_and_levels_are_rejected() -> None:
    robot, motion = offset_case(0)
    rejects("formulation: expected", ss.inverse_dynamics, robot, motion, formulation="paper")
    rejects("formulation: expected", ss.prepare, robot, formulation="paper")
    rejects("with offset joints, got 'slender'", ss.prepare, robot, fidelity="slender")
    universal, _ = offset_case(0, "universal")
    rejects("platform_joint", ss.prepare, universal)


def test_subcommands_say_so_in_one_line(tmp_path: Path, run: Run) -> None:
    out = run("check", EXAMPLE).out
    assert "offsets      10 mm from the fixed to the moving axis, 4 mm across it" in out
    assert "crosses      0.15 kg" in out
    lines = EXAMPLE.read_text(encoding="utf-8")
    offsets = 'platform_joint = "universal"\nplatform_axis = [0, 1, 0]\nwrist = 3.0\n'
    path = tmp_path / "turning.toml"
    path.write_text(lines.replace("[legs.offsets]\n", f"[legs.offsets]\n{offsets}"), encoding="utf-8")
    log = str(DOCS / "examples" / "trajectory.csv")
    run("forces", path, log, "-o", tmp_path / "F.csv", "--reactions")
    for words in (["generate"], ["controller"]):
        error = run(*words, EXAMPLE, "-o", tmp_path / words[0], code=2).err.strip().splitlines()
        assert len(error) == 1
        assert error[0].startswith(f"stewart-sym: error: {EXAMPLE}: offsets: ")
