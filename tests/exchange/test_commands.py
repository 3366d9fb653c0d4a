"""``export`` and ``import`` write what they say, replace nothing of others, and need no extra."""

from pathlib import Path

import pytest
from command_line import Fails, Run

import stewart_sym as ss
from stewart_sym.cli.main import main


@pytest.mark.parametrize("form", ["mjcf", "sdf", "drake", "urdf"])
def test_a_robot_file_goes_out_and_comes_back(form: str, folder: Path, run: Run) -> None:
    told = run("export", "hexapod.toml", "--format", form, "-o", "machine.xml").out
    loops = "Written to machine.loops.json\n" if form == "urdf" else ""
    assert told == f"{loops}Written to machine.xml\n"
    out, err = run("import", "machine.xml", "-o", "back.toml")
    assert out.startswith("legs in the order of the file: 1 'lower_1' 'upper_1'")
    assert err == ""
    text = (folder / "back.toml").read_text(encoding="utf-8")
    assert text.startswith("# Imported by stewart-sym from machine.xml.\n# legs in the order of the file")
    assert ss.Robot.from_toml("back.toml").to_dict() == ss.Robot.from_toml("hexapod.toml").to_dict()
    # Its own files are replaced.
    run("export", "back.toml", "--format", form, "-o", "machine.xml")
    run("import", "machine.xml", "-o", "back.toml")


def test_nothing_of_others_is_replaced(folder: Path, fails: Fails) -> None:
    (folder / "m.loops.json").write_text("mine")
    export = ["export", "hexapod.toml", "--format", "urdf", "-o", "m.urdf"]
    assert "m.loops.json: exists with other content" in fails(*export)
    assert not (folder / "m.urdf").exists()
    over = ["export", "hexapod.toml", "--format", "mjcf", "-o", "hexapod.toml", "--force"]
    assert "is an input" in fails(*over)
    assert main([*export, "--force"]) == 0
    for place, said in (("hexapod.toml", "exists with other content"), ("m.urdf", "is an input")):
        assert said in fails("import", "m.urdf", "-o", place)


def test_a_part_that_simulators_reject_is_named_with_the_file(folder: Path, run: Run) -> None:
    text, possible = (folder / "hexapod.toml").read_text(encoding="utf-8"), "inertia = [0.9, 0.9, 1.6]"
    assert possible in text
    text = text.replace(possible, "inertia = [9.9, 0.9, 1.6]")
    (folder / "bad.toml").write_text(text, encoding="utf-8")
    err = run("export", "bad.toml", "--format", "mjcf", "-o", "m.xml", code=2).err.splitlines()
    assert err[-1].startswith("stewart-sym: error: bad.toml: platform: inertia: physically impossible")
    assert 'add "platform-inertia" to suppress_warnings' in err[-1]
    assert not (folder / "m.xml").exists()
