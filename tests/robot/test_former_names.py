"""Former names: they are no names of the package, no attributes of its classes, and no keys of its files."""

import json
from pathlib import Path

import pytest
from command_line import error_of

import stewart_sym as ss
from stewart_sym.planning.plan_file import read_plan
from stewart_sym.simulation.scene import read_scene

ROBOT_KEYS = {
    "accept": "suppress_warnings",
    "home": "home_position",
    "legs.friction": "legs.damping",
    "trajectory.lengths": "trajectory.length_mode",
    "legs.drive.gear": "legs.drive.gear_ratio",
    "legs.drive.stribeck": "legs.drive.stribeck_force",
    "legs.drive.smoothing": "legs.drive.regularization_speed",
    "legs.drive.back_efficiency": "legs.drive.backdrive_efficiency",
    "legs.offsets.cross": "legs.offsets.axis_offset",
    "legs.offsets.along": "legs.offsets.slide_offset_y",
    "legs.offsets.across": "legs.offsets.slide_offset_z",
    "legs.offsets.wrist": "legs.offsets.wrist_offset",
}
SCENE_KEYS = {
    "legs": "actuation",
    "thresholds": "stop_conditions",
    "start": "initial_state",
    "actuation.law": "actuation.type",
    "actuation.model": "actuation.model_formulation",
}
PLAN_KEYS = {
    "price": "smoothness_weight",
    "least": "minimize",
    "limits.condition": "limits.max_condition",
    "limits.clearance": "limits.min_clearance",
}


@pytest.mark.parametrize("former", ROBOT_KEYS)
def test_the_error_for_a_former_key_of_a_robot_file_names_the_present_one(former: str) -> None:
    tables = json.loads(json.dumps(ss.robots.dasgupta1998().to_dict()))
    *path, key = former.split(".")
    table = tables
    for name in path:
        table = table.setdefault(name, {})
    table[key] = 1.0
    present = ROBOT_KEYS[former].rpartition(".")[2]
    expected = f'robot: {former}: unknown key, did you mean "{present}"?'
    assert error_of(lambda: ss.Robot.from_dict(tables)) == expected


@pytest.mark.parametrize("former", [*SCENE_KEYS, *PLAN_KEYS])
def test_the_error_for_a_former_key_of_a_scene_or_plan_names_the_present_one(
    former: str, tmp_path: Path
) -> None:
    scene = former in SCENE_KEYS
    table, _, key = former.rpartition(".")
    text = 'schema = 1\nrobot = "robot.toml"\n' + ("duration = 1.0\n" if scene else "via = [1, 2]\n")
    text += f"[{table}]\n{key} = 1\n" if table else f"{key} = 1\n"
    if scene and table != "actuation" and former != "legs":
        text += '[actuation]\ntype = "constant_force"\nforces = [0, 0, 0, 0, 0, 0]\n'
    file = tmp_path / "file.toml"
    file.write_text(text)
    present = (SCENE_KEYS | PLAN_KEYS)[former].rpartition(".")[2]

    def read() -> None:
        if scene:
            read_scene(file)
        else:
            with read_plan(file):
                pass

    message = error_of(read)
    assert message.startswith(f'{file}: {former}: unknown key, did you mean "{present}"?'), message


def test_a_robot_file_of_schema_1_is_rejected_in_one_line_that_names_the_remedy() -> None:
    message = error_of(lambda: ss.Robot.from_dict({"schema": 1, "name": "old", "leg": []}))
    assert message.startswith("robot: schema: schema 1 is no longer read; write schema = 2")
    assert "\n" not in message


def test_a_motion_takes_keywords_alone() -> None:
    with pytest.raises(TypeError):
        ss.Motion([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 1], [0, 0, 0], [0, 0, 0])  # type: ignore[misc, arg-type]
