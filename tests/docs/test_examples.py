"""Every example of the README and of the documentation runs and gives what the page says."""

import argparse
import re
import subprocess
import tomllib
from pathlib import Path

import matplotlib.image
import pytest
from cost_figures import hasty
from draw_all import DRAWINGS
from drawing_sheet import save
from pages import (
    DOCS,
    PAGES,
    SHAPE,
    TOP,
    blocks,
    pictures,
    prepared,
    run_and_compare,
    run_page,
    same_picture,
    text_of,
)
from sweeps import slow_but

import stewart_sym as ss
from stewart_sym.cli import main
from stewart_sym.motion.logs import LENGTH_UNITS, LENGTHS
from stewart_sym.robot import bodies, drive, offsets, schema_2
from stewart_sym.simulation import scene
from stewart_sym.simulation.scene import read_scene
from stewart_sym.studies.accuracy.budget import read_budget

RUNNING = [page for page in PAGES if any(block.language in ("python", "sh") for block in blocks(page))]
SHELL = {page for page in RUNNING if any(block.language == "sh" for block in blocks(page))}
LONG = {
    f".docs/gallery/{name}.md"
    for name in ("mpc", "computed-torque", "controller-models", "around-a-singularity")
} | {f".docs/howto/{name}.md" for name in ("arrays", "controller")}
DARKEST_PAPER = 0.94
"""Brightness below which a dot of a drawing is ink, 0 to 1."""
NOT_RUN = ("sh .ci/setup ", "pip install ")
"""Beginnings of commands that change the environment: those of the README are run by ``.ci/run``."""


@pytest.mark.parametrize("page", slow_but(set(RUNNING) - SHELL - LONG, RUNNING))
def test_examples_run_in_order_and_give_what_the_page_says(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if "stewart-sym choose-fidelity" in text_of(page):
        hasty(monkeypatch)
    monkeypatch.chdir(prepared(page, tmp_path))
    run_page(page, tmp_path)
    for committed in pictures(page):
        for made in tmp_path.glob(f"**/*{committed.name}"):
            assert same_picture(made, committed), committed.name


def test_examples_of_python_are_compared_with_their_comments() -> None:
    comments = [
        comment
        for page in RUNNING
        for block in blocks(page)
        if block.language == "python"
        for comment in re.findall(r"#(.*)", block.text)
    ]
    assert len([comment for comment in comments if SHAPE.match(comment.strip())]) >= 20
    assert not [comment for comment in comments if SHAPE.search(comment) and not SHAPE.match(comment.strip())]


@pytest.mark.parametrize(
    "text",
    [
        "x = [1.0, 2.0]  # (3,)",
        "[[1.0, 2.0]]  # (2, 1)",
        "1.25  # 1.26 s",
        "3  # 4: four",
        "[0.0, 1e-6]  # (2,): 0 but for rounding",
    ],
)
def test_a_comment_that_says_something_else_is_found(text: str) -> None:
    with pytest.raises(AssertionError):
        run_and_compare(text, {})


def test_commands_that_are_not_run_install_and_name_extras_that_there_are() -> None:
    extras = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"][
        "optional-dependencies"
    ]
    lines = [
        line
        for page in PAGES
        for block in blocks(page)
        if block.language == "console"
        for line in block.text.splitlines()
    ]
    assert lines
    assert [line for line in lines if not line.startswith(NOT_RUN)] == []
    named = re.findall(r"(?:\.\[|\.ci/setup )([a-z,]+)", "\n".join(text_of(page) for page in PAGES))
    assert {name for each in named for name in each.split(",")} <= set(extras)


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings_are_those_of_their_scripts_and_not_cut_off(name: str, tmp_path: Path) -> None:
    save(DRAWINGS[name](), tmp_path / "drawing.png")
    assert same_picture(tmp_path / "drawing.png", DOCS / name)
    ink = matplotlib.image.imread(DOCS / name)[..., :3].min(axis=-1) < DARKEST_PAPER
    assert ink.mean() > 0.01
    assert not any(edge.any() for edge in (ink[:4], ink[-4:], ink[:, :4], ink[:, -4:]))


def subcommands() -> dict[str, argparse.ArgumentParser]:
    return {name: main.subcommand_parser(name) for name in main.SUBCOMMANDS}


def written_files() -> set[str]:
    """What the commands of pages and of --help write, and the files that pages say to save."""
    helps = [text_of(page) for page in PAGES]
    for name, sub in subcommands().items():
        helps.append(sub.epilog or "")
        default = sub.get_default("output")
        helps.append(f"stewart-sym {name} -o {default}" if default else "")
    text = " ".join(helps)
    found = re.findall(r"(?:-o|--generate)\s+([a-z][\w.]*)", text)
    found += [block.file_name for block in blocks("README.md") if block.file_name]
    found += re.findall(r"saved? (?:\w+ ){0,3}as `(\S+)`", text, re.IGNORECASE)
    found += re.findall(r"stewart-sym \w+ ([a-z]\w*\.(?:toml|csv))", text)
    return set(found)


def test_what_the_commands_write_is_no_change_of_the_repository() -> None:
    """In the top folder and beside the examples."""
    names = written_files()
    assert {"reproduce", "swing.toml", "enough.toml", "forces.csv", "kit", "simulation"} <= names
    examples = {path.name for path in (DOCS / "examples").iterdir()}
    paths = sorted(
        f"{folder}{name if '.' in name else f'{name}/report.txt'}"
        for folder, kept in (("", set()), (".docs/examples/", examples))
        for name in names - kept
    )
    command = ["git", "check-ignore", *paths]
    ignored = subprocess.run(command, cwd=TOP, check=False, capture_output=True, text=True).stdout
    assert ignored.splitlines() == paths


def test_robot_example_is_a_valid_robot_file_that_nothing_is_said_against(
    recwarn: pytest.WarningsRecorder,
) -> None:
    assert ss.Robot.from_toml(DOCS / "examples" / "hexapod.toml").name == "hexapod"
    assert not list(recwarn)


def keys(value: object) -> set[str]:
    """Keys of tables inside tables."""
    if isinstance(value, dict):
        return set(value).union(*map(keys, value.values()))
    return set().union(*map(keys, value)) if isinstance(value, list) else set()


def test_the_page_about_files_names_every_key_of_a_robot_file() -> None:
    robot = ss.Robot.from_toml(DOCS / "examples" / "hexapod.toml")
    named = re.findall(r"`\[*(\w+)\]*`", text_of(".docs/reference/files.md"))
    assert keys(robot.to_dict()) - {"schema", "leg", *"123456"} <= set(named)


def test_the_page_about_files_names_every_key_of_schema_2() -> None:
    named = set(re.findall(r"`\[?(\w+)\]?`", text_of(".docs/reference/files.md")))
    known = {*schema_2._TOP_KEYS, *schema_2._POINT_KEYS, *schema_2._LEG_KEYS, *schema_2._TRAJECTORY_KEYS}
    known |= {*drive.KEYS, *offsets.OFFSET_KEYS, *offsets.CROSS_KEYS}
    known |= {*schema_2._DAMPING_KEYS, *bodies.INERTIA_KEYS, *bodies._MATTER, "shape", "body"}
    known |= {key for keys in (*bodies.SHAPES.values(), *bodies._PLACES.values()) for key in keys}
    assert known - named == {"leg"}
    quoted = set(re.findall(r'`"([\w-]+)"`', text_of(".docs/reference/files.md")))
    assert {*bodies.SHAPES, *schema_2.AXES, *LENGTH_UNITS, *LENGTHS} <= quoted


def test_the_page_about_files_names_every_key_of_a_scene() -> None:
    page = text_of(".docs/reference/files.md").partition("## Scene of a simulation")[2].partition("## Via")[0]
    laws = {key for keys in scene._LAW_KEYS.values() for key in keys}
    known = {*scene._TOP_KEYS, *scene._STATE_KEYS, *scene._LOAD_KEYS, *scene._THRESHOLD_KEYS, "type", *laws}
    assert known <= set(re.findall(r"`\[?(\w+)\]?`", page.replace("```", "")))


def test_scene_examples_are_valid() -> None:
    assert list(read_budget(DOCS / "examples" / "enough.toml").motions) == ["trajectory.csv"]
    assert read_scene(DOCS / "examples" / "swing.toml").robot.name == "hexapod"
