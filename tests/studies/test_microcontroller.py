"""One-pose kernels on emulated microcontrollers: right, small, quick, and alone."""

import json
from functools import cache
from pathlib import Path

import microcontroller as measure
import pytest
import toolchain
from machines import dasgupta
from microcontroller import right
from sweeps import FULL

from stewart_sym.io.output import json_text
from stewart_sym.studies.common.text_tables import Figures

INSTRUCTIONS = {"double": 3300, "float": 2850}
"""Of a kit of a precision at the kit's own flags, at most."""
AT_MOST = {False: 4100, True: 4000}
"""The same near joint singularities, of other levels, and at other flags."""
FLASH = {"double": 24 * 1024, "float": 12 * 1024}
STACK = 3 * 1024
MEASURED = ("instructions", "near_singular_joints", "flash", "ram", "stack", "worst", "drive")
DOCS = Path(__file__).parents[2] / ".docs"
KITS = [(precision, baked) for precision in toolchain.CORES for baked in (False, True)]
KIT_NAMES = {
    f"{precision}-{'baked' if baked else 'general'}": (precision, baked) for precision, baked in KITS
}
OPPOSITE = [("float", True), ("double", False)][: 2 if FULL else 1]
"""Two kits that have both precisions, and constants both prepared and folded in; else the first."""
QUICK = ("float", False)
"""The kit that is measured in the fast tests; the others take as long each."""

pytestmark = [
    pytest.mark.skipif(bool(toolchain.missing()), reason=toolchain.missing() or "all tools are there"),
    # Each kit is compiled and run on an emulated processor.
    pytest.mark.slow,
]


@cache
def measured(precision: str, baked: bool) -> Figures:
    return measure.measured(dasgupta(), "general", baked, precision)


def study_of(kits: list[tuple[str, bool]]) -> Figures:
    return measure.of_rows(dasgupta(), [measured(*kit) for kit in kits])


@pytest.fixture(
    scope="module", params=[[QUICK], pytest.param(KITS, marks=pytest.mark.full)], ids=["one kit", "all kits"]
)
def found(request: pytest.FixtureRequest) -> Figures:
    return study_of(request.param)


@pytest.fixture(params=KIT_NAMES if FULL else ["float-general"])
def row(request: pytest.FixtureRequest) -> Figures:
    return measured(*KIT_NAMES[request.param])


def test_answers_are_within_bounds_and_calls_without_an_answer_say_so(row: Figures) -> None:
    assert row["poses"] > measure.MOTIONS
    assert (row["failed"], row["rejected_wrongly"], row["selftest"]) == (0, 0, 0)
    # Arithmetic that errs by nothing was not run on the processor.
    assert 0 < row["worst"] <= 1
    assert right(row)


def test_a_pose_takes_no_more_instructions_than_a_controller_has(row: Figures) -> None:
    assert 1000 < row["instructions"] <= INSTRUCTIONS[row["precision"]]
    if not row["baked"]:
        assert row["near_singular_joints"] is not None
        # All six legs near their joint singularities at once, which the limit for a pose does not cover.
        assert row["instructions"] < row["near_singular_joints"] <= AT_MOST[False]


def test_code_and_stack_are_small(row: Figures) -> None:
    assert 1000 < row["flash"]["kernel"] + row["flash"]["robot"] <= FLASH[row["precision"]]
    assert row["flash"]["image"] > row["flash"]["kernel"]
    assert row["ram"]["kit"] == 0
    assert 100 < row["stack"]["pose"] <= STACK
    # What was seen is no more than what the compiler says of all frames; a library's memcpy has small ones.
    assert row["stack"]["pose"] <= row["stack"]["frames"] + 64 <= STACK
    if not row["baked"]:
        assert 100 < row["stack"]["prepare"] <= STACK


def test_objects_ask_for_no_heap_no_libm_and_no_double(row: Figures) -> None:
    assert row["foreign"] == []
    assert row["double"] == []


def test_the_committed_figures_are_those_found_today_with_the_same_tools(found: Figures) -> None:
    agrees_with_the_committed(found, "controller.json")


def agrees_with_the_committed(found: Figures, name: str) -> None:
    path = DOCS / name
    committed, today = json.loads(path.read_text(encoding="utf-8")), json.loads(json_text(found))
    shown = {(row["precision"], row["baked"]) for row in today["rows"]}
    assert shown <= {(row["precision"], row["baked"]) for row in committed["rows"]}
    committed["rows"] = [row for row in committed["rows"] if (row["precision"], row["baked"]) in shown]
    if committed["tools"] != today["tools"]:
        for each in (committed, today):
            for row in each["rows"]:
                for key in MEASURED:
                    row.pop(key)
        del committed["tools"], today["tools"]
    assert committed == today, f"run `microcontroller.py` and `published.py`: .docs/{name}"


def test_the_committed_figures_of_a_drive_are_those_found_today(tmp_path: Path) -> None:
    robot = measure.driven_robot(tmp_path, DOCS)
    rows = [measure.measured(robot, "general", baked, precision) for precision, baked in OPPOSITE]
    assert all(map(right, rows))
    for row in rows:
        # No more than the forces: what a controller adds to them.
        assert 0 < row["drive"]["motor_torques"] < row["instructions"]
        assert 0 < row["drive"]["axial_forces"] < row["instructions"]
    agrees_with_the_committed(measure.of_rows(robot, rows), "controller_drive.json")


# --- what the study must be able to find --------------------------------------------------------


def test_the_committed_figures_of_the_kinematics_are_those_found_today() -> None:
    rows = [
        measure.measured_kinematics(dasgupta(), precision)
        for precision in (toolchain.CORES if FULL else ("float",))
    ]
    for row in rows:
        assert row["failed"] == 0
        # A search has at least two steps, each with the lengths and a solution of six equations.
        assert 500 < row["lengths"][1] <= row["rates"][0] < 0.2 * row["search"][0]
    committed = json.loads((DOCS / "controller_kinematics.json").read_text(encoding="utf-8"))
    committed["rows"] = [row for row in committed["rows"] if FULL or row["precision"] == "float"]
    if committed["tools"] == toolchain.versions():
        assert committed == json.loads(json_text(measure.of_kinematics(dasgupta(), rows)))
