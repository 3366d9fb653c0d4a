"""Former keys of robot files, scenes, and plans: the error names the present key."""

import json
from pathlib import Path

import pytest
from command_line import error_of

import stewart_sym as ss
from stewart_sym.planning.plan_file import read_plan
from stewart_sym.simulation.scene import read_scene

ROBOT_KEYS = {
    "accept": "suppress_warnings",
    "legs.drive.gear": "legs.drive.gear_ratio",
    "legs.offsets.cross": "legs.offsets.axis_offset",
}
SCENE_KEYS = {"legs": "actuation", "actuation.law": "actuation.type"}
PLAN_KEYS = {"least": "minimize", "limits.condition": "limits.max_condition"}


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
