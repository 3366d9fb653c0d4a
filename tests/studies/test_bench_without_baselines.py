"""`benchmark` without CasADi, Pinocchio, Drake, or MuJoCo omits them and prints one line about them."""

import contextlib
import io
import itertools
import json
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import rejects
from machines import dasgupta
from small_bench import shorten

from stewart_sym.cli.main import main
from stewart_sym.io.extras import install
from stewart_sym.studies.benchmark import bench, compile_times, published
from stewart_sym.studies.benchmark.plot import report
from stewart_sym.studies.benchmark.processor import targets
from stewart_sym.studies.common import host
from stewart_sym.studies.common.output import Figures

NAMES = {"casadi": "CasADi", "pinocchio": "Pinocchio", "pydrake": "Drake", "mujoco": "MuJoCo"}
PEERS = {"casadi": ["CasADi", "CasADi, closed form"], "pinocchio": ["Pinocchio"], "mujoco": []}
VERSIONS = {"casadi": "casadi", "pinocchio": "pin", "mujoco": "mujoco"}
HIDDEN = ("pinocchio", "pydrake")
"""All are missing where CI runs every subcommand, `.ci/newcomer`, and there in `test_bench_figures`."""

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command wrote without them, of code for one target; what compares nothing is left out.

    Others disturb the run, and some batches do not fit into memory.
    """
    folder, told, first = tmp_path_factory.mktemp("bench") / "out", io.StringIO(), targets()[:1]
    at = itertools.count(0.0, 1e6)
    with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stderr(told):
        shorten(patch)
        patch.setitem(bench.COMPARED, "pydrake", "drake")
        for name in HIDDEN:
            patch.setitem(sys.modules, name, None)
        patch.setattr(bench, "targets", lambda: first)
        patch.setattr(bench, "stages", lambda _: ())
        patch.setattr(compile_times, "compile_times", lambda *_: ())
        patch.setattr(compile_times, "text_size", lambda: None)
        patch.setattr(bench, "QUICK_SIZES", (8, 10**12))
        patch.setattr(host, "_work_of_others", lambda: next(at))
        assert main(["benchmark", "--quick", "-o", str(folder)]) == 0
    assert told.getvalue() == ""
    return folder


@pytest.fixture(scope="module")
def figures(folder: Path) -> Figures:
    found: Figures = json.loads((folder / "bench.json").read_text())
    return found


def test_one_line_says_what_is_left_out_and_how_to_get_it(folder: Path) -> None:
    (line,) = [line for line in (folder / "bench.txt").read_text().splitlines() if "left out" in line]
    assert line.endswith(f"; {install('bench')}")
    assert [name for name in NAMES.values() if name in line] == [NAMES[name] for name in HIDDEN]


def test_the_json_holds_what_was_measured(figures: Figures) -> None:
    there = [name for name in NAMES if name not in HIDDEN]
    assert figures["left_out"] == [NAMES[name] for name in HIDDEN]
    expected = {"vector reference", *itertools.chain(*(PEERS[name] for name in there))}
    assert {entry["name"] for entry in figures["baselines"]} == expected
    assert {name for name in VERSIONS.values() if name in figures["software"]} == {
        VERSIONS[name] for name in there
    }
    assert ("Pinocchio" in figures["parts"]) == ("pinocchio" in there)
    assert ("ratio_to" in figures) == ("casadi" in there)
    for entry in (*figures["ours"], *figures["baselines"]):
        assert ("ratio_to_closed_form" in entry) == ("ratio_to_casadi" in entry) == ("casadi" in there)
        assert len(entry["raw"]) == 3

    motion, engines = figures["motion"], [NAMES[name] for name in there if name != "casadi"]
    for kind in ("baselines", "calls", "empty_calls"):
        assert [entry["name"] for entry in motion[kind]] == engines
    assert motion.get("better_baseline") in (engines or [None])
    assert ("times_faster" in motion) == bool(engines)
    assert ("loops_open_m" in motion) == ("mujoco" in there)
    assert any("CasADi" in each["name"] for each in figures["shares"]) == ("casadi" in there)
    compared = {*figures["largest_difference"], *motion["largest_difference"]}
    assert not {NAMES[name] for name in HIDDEN} & compared


def test_tables_and_pictures_do_without_them(folder: Path) -> None:
    text = (folder / "bench.txt").read_text()
    shown = text.split(install("bench"))[1]
    drawn = "".join((folder / f"{name}.svg").read_text() for name in ("bench", "bench_motion"))
    for name, label in NAMES.items():
        assert (label in shown) == (name not in HIDDEN)
        assert (label in drawn) == (name not in HIDDEN)
    assert all((folder / f"{name}.png").stat().st_size for name in ("bench", "bench_motion"))
    assert max(map(len, text.splitlines())) <= 115
    assert "nan" not in text
    assert "None" not in text


def test_tables_without_passes_and_text_are_left_out(folder: Path, figures: Figures) -> None:
    text = (folder / "bench.txt").read_text()
    assert figures["text"] is None
    assert figures["robot"] == dasgupta().name
    assert "after the pass" not in text
    assert "bytes" not in text


def test_a_run_that_others_disturbed_says_so(
    folder: Path, figures: Figures, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "100 % of the cores' time: the figures" in (folder / "bench.txt").read_text()
    monkeypatch.setattr(host, "_work_of_others", lambda: 0.0)
    undisturbed = figures["machine"] | {"taken_by_others": host.Others().share()}
    assert "took 0 % of the cores' time\n" in report(figures | {"machine": undisturbed})


def test_batches_that_do_not_fit_into_memory_are_left_out(figures: Figures) -> None:
    assert {figure["poses"] for figure in figures["sweep"]} == {8}


def test_no_table_is_made_of_a_part(figures: Figures) -> None:
    names = ", ".join(NAMES[name] for name in HIDDEN)
    rejects(rf"^bench\.json: expected .*, got none of {names}: pip install ", published.tables, figures)


def test_a_partial_run_replaces_no_published_one(tmp_path: Path) -> None:
    (tmp_path / "bench.json").write_text(json.dumps({"left_out": ["CasADi"]}))
    committed = Path(__file__).parents[2] / ".docs" / "bench.json"
    before = committed.read_bytes()
    command = [sys.executable, "tests/support/studies/published.py", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=committed.parents[1])
    assert done.returncode == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith("bench.json: expected ")
    assert committed.read_bytes() == before
