"""A kit spares what is in its folder, repeats to the byte, and a failure leaves no trace."""

import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import rejects
from kits import contents, kit_of, machine

from stewart_sym import robots
from stewart_sym.kit import Choice, kit_names, put, write_kit

# ---------------------------------------------------------------- the same bytes


@pytest.mark.slow
def test_same_robot_gives_the_same_bytes_in_any_folder_and_under_any_hash_seed(tmp_path: Path) -> None:
    """All files of a kit, its test vectors and a unit of FMI with a library among them."""
    robot = robots.dasgupta1998()
    choice = Choice(
        ("forces", "kinematics"), fidelity="massless_static", bake=True, scalar=True, fmu="forces"
    )
    _, first = write_kit(robot, tmp_path / "a", choice)
    program = f"""
import warnings
from pathlib import Path
from stewart_sym import robots
from stewart_sym.kit import Choice, write_kit
warnings.simplefilter("ignore")
write_kit(robots.dasgupta1998(), Path({str(tmp_path / "b")!r}), {choice!r})
"""
    env = {**os.environ, "PYTHONHASHSEED": "12345", "TMPDIR": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], env=env, check=True)
    assert contents(tmp_path / "a") == contents(tmp_path / "b")
    assert any(path.suffix == ".fmu" for path in first)
    assert sorted(path.relative_to(tmp_path / "a").as_posix() for path in first) == sorted(
        contents(tmp_path / "a")
    )


# ---------------------------------------------------------------- what is there already


def test_edited_file_is_rejected_without_force_and_replaced_with_it(tmp_path: Path) -> None:
    put(kit_of(), tmp_path)
    fresh = contents(tmp_path)
    (tmp_path / "stewart_robot.c").write_text("mine", encoding="utf-8")
    (tmp_path / "README.md").unlink()
    (tmp_path / "notes.txt").write_text("mine too", encoding="utf-8")
    edited = contents(tmp_path)
    with pytest.raises(
        ValueError, match=r"^\S+robot\.c: exists with other content; use --force to overwrite$"
    ):
        put(kit_of(), tmp_path)
    assert contents(tmp_path) == edited
    put(kit_of(), tmp_path, force=True)
    assert contents(tmp_path) == {**fresh, "notes.txt": b"mine too"}


def test_files_that_the_new_kit_has_not_are_removed_and_edited_ones_only_with_force(tmp_path: Path) -> None:
    """An edited header of an older kit is not left beside the new one's, where a compiler would find it."""
    put(kit_of(), tmp_path)
    (tmp_path / "stewart_robot.h").write_text("mine", encoding="utf-8")
    edited = contents(tmp_path)
    baked = kit_of(choice=Choice(bake=True, scalar=True))
    rejects(r"^\S+robot\.h: exists with other content; use --force", put, baked, tmp_path)
    assert contents(tmp_path) == edited
    with pytest.raises(ValueError, match=r"^\S+robot\.h: is an input; use another name$"):
        put(baked, tmp_path, force=True, inputs=[tmp_path / "stewart_robot.h"])
    put(baked, tmp_path, force=True)
    assert contents(tmp_path) == baked.files


def test_manifest_that_names_files_elsewhere_removes_none(tmp_path: Path) -> None:
    folder = tmp_path / "kit"
    put(kit_of("Old"), folder)
    (tmp_path / "precious").write_text("mine", encoding="utf-8")
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    manifest["files"]["../precious"] = hashlib.sha256(b"mine").hexdigest()
    (folder / "manifest.json").write_text(json.dumps(manifest), encoding="utf-8")
    put(kit_of("New"), folder, force=True)
    assert (tmp_path / "precious").read_text(encoding="utf-8") == "mine"


# ---------------------------------------------------------------- failures


@pytest.mark.parametrize(
    ("choice", "which", "message"),
    [
        (Choice(formulation="fast"), "random", r'formulation: expected "exact" or "paper", got \'fast\''),
        (Choice(precision="half"), "random", r'precision: expected "double" or "float", got \'half\''),
        (Choice(()), "random", "functions: expected some of forces, .*, got none"),
        (Choice(("force",)), "random", "functions: expected some of forces, .*, got 'force'$"),
        (Choice(("motion",), "paper"), "random", "functions: motion: expected exact with universal .*"),
        (Choice(("derivatives",)), "spherical", "functions: derivatives: expected exact with universal .*"),
        (Choice(("reactions",), bake=True), "random", "bake: applies to the function forces, got reactions"),
        (Choice(("motion",), fidelity="slender"), "random", "fidelity: applies to the function forces, .*"),
        (Choice(("kinematics",), fmu="forces"), "random", "fmu: applies to the function forces, .*"),
        (Choice(fmu="motor"), "random", 'fmu: expected "forces", "forces-rpy" or "plant", got \'motor\''),
        (Choice(fmu="plant"), "spherical", "fmu: plant: expected exact with universal .* spherical .*"),
        (Choice(fidelity="rigid"), "random", 'fidelity: expected "general", .*'),
    ],
)
def test_wishes_that_do_not_go_together_are_rejected_in_one_line(
    tmp_path: Path, choice: Choice, which: str, message: str
) -> None:
    with pytest.raises(ValueError, match=rf"\A{message}\Z"):
        write_kit(machine(which), tmp_path / "kit", choice)
    with pytest.raises(ValueError, match=rf"\A{message}\Z"):
        kit_names(machine(which), choice)
    assert os.listdir(tmp_path) == []
