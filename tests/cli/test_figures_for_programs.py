"""``--json``: every subcommand that prints figures has it, and what it writes is JSON of the same result."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from command_line import Run

from stewart_sym.cli import terminal
from stewart_sym.io.output import json_text
from stewart_sym.io.progress import tracked


def strict(text: str) -> object:
    """JSON without the constants that are none."""

    def constant(name: str) -> None:
        raise AssertionError(f"{name} is no JSON")

    assert text.endswith("}\n")
    return json.loads(text, parse_constant=constant)


def test_on_standard_output_stands_nothing_but_the_figures(robot: Path, run: Run) -> None:
    found = strict(run("check", robot, "--json").out)
    assert isinstance(found, dict)
    assert found["robot"]["platform"]["body"]["mass"] == 40.0
    # The paper's machine has no limits, and JSON has no infinity.
    assert found["axis_travel"]["surge"]["acceleration_m_per_s2"] == [None] * 2
    assert len(found["home_pose"]["holding_forces_N"]) == 6


def test_what_is_not_finite_is_null() -> None:
    data = {"a": np.array([1.0, np.nan]), "b": (np.float64(np.inf), np.int32(3)), "c": {2: [-np.inf, "x"]}}
    assert strict(json_text(data)) == {"a": [1.0, None], "b": [None, 3], "c": {"2": [None, "x"]}}
    assert json_text({"a": 1}) == '{\n "a": 1\n}\n'


def test_a_task_shows_its_share_and_the_time_left(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    now = [100.0]
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    monkeypatch.setattr(terminal.time, "monotonic", lambda: now[0])
    with terminal.progress_line() as progress:
        for _ in tracked(progress, range(4), lambda number: f"part {number}"):
            now[0] += 30.0
        progress("another")
    shown = [line.removeprefix("\x1b[K") for line in capsys.readouterr().err.split("\r")[1:-1]]
    assert [line.split("]")[-1] for line in shown] == [
        "   0 %  part 0",
        "  25 %, 1 min 30 s left  part 1",
        "  50 %, 1 min 00 s left  part 2",
        "  75 %, 30 s left  part 3",
        "another ...",
    ]
    assert shown[2].startswith("[############            ]")
