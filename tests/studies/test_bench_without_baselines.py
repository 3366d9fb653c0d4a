"""`bench` without CasADi, Pinocchio, Drake or MuJoCo leaves them out, says so in a line, keeps the rest."""

import itertools
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from stewart_sym.io.extras import install
from stewart_sym.studies.benchmark import published

BENCH = """
import dataclasses, sys
folder, hidden = sys.argv[1], sys.argv[2:]
sys.modules.update(dict.fromkeys(hidden))
from stewart_sym.backend import native
from stewart_sym.cli.main import main
from stewart_sym.studies.benchmark import bench, compile_times as bench_compile, reductions as bench_passes
from stewart_sym.studies.common import timing

# Samples so short that the figures mean nothing, of few poses and of code compiled at -O0 for one target;
# what compares nothing with others is left out.
load = native.load
native.load = lambda name, sources, flags=(), defines=None: load(name, sources, (*flags, "-O0"), defines)
timing.SHORTEST, bench.QUICK_ROUNDS, bench.QUICK_SIZES = 1e-5, 3, (8, 64)
bench.LARGE = 8_000
bench.OURS = tuple(dataclasses.replace(each, poses=min(each.poses, bench.LARGE)) for each in bench.OURS)
bench.targets, bench.time_source = lambda kinds=bench.targets: kinds()[:1], lambda: {}
bench_passes.stages = lambda _: ()
bench_compile.compile_times = lambda *_: ()
bench_compile.text_size = lambda: None
code = main(["bench", "--quick", "-o", folder])
sys.exit(code or any(sys.modules.get(name) for name in hidden))
"""
NAMES = {"casadi": "CasADi", "pinocchio": "Pinocchio", "pydrake": "Drake", "mujoco": "MuJoCo"}
PEERS = {"casadi": ["CasADi", "CasADi, closed form"], "pinocchio": ["Pinocchio"], "mujoco": []}
VERSIONS = {"casadi": "casadi", "pinocchio": "pin", "mujoco": "mujoco"}
HIDDEN = ("pinocchio", "pydrake")
"""All are missing where CI runs every subcommand, `.ci/newcomer`, and there in `test_bench_figures`."""

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def hidden() -> tuple[str, ...]:
    """Packages that cannot be imported."""
    return HIDDEN


@pytest.fixture(scope="module")
def folder(hidden: tuple[str, ...], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command wrote without them; the test fails where it does."""
    folder = tmp_path_factory.mktemp("bench") / "out"
    done = subprocess.run([sys.executable, "-c", BENCH, folder, *hidden], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert done.stdout.startswith((folder / "bench.txt").read_text())
    return folder


@pytest.fixture(scope="module")
def figures(folder: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((folder / "bench.json").read_text())
    return found


def test_one_line_says_what_is_left_out_and_how_to_get_it(hidden: tuple[str, ...], folder: Path) -> None:
    (line,) = [line for line in (folder / "bench.txt").read_text().splitlines() if "left out" in line]
    assert line.endswith(f"; {install('bench')}")
    assert [name for name in NAMES.values() if name in line] == [NAMES[name] for name in hidden]


def test_the_json_holds_what_was_measured(hidden: tuple[str, ...], figures: dict[str, Any]) -> None:
    there = [name for name in NAMES if name not in hidden]
    assert figures["left_out"] == [NAMES[name] for name in hidden]
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
    assert not {NAMES[name] for name in hidden} & compared


def test_tables_and_pictures_do_without_them(hidden: tuple[str, ...], folder: Path) -> None:
    text = (folder / "bench.txt").read_text()
    shown = text.split(install("bench"))[1]
    drawn = "".join((folder / f"{name}.svg").read_text() for name in ("bench", "bench_motion"))
    for name, label in NAMES.items():
        assert (label in shown) == (name not in hidden)
        assert (label in drawn) == (name not in hidden)
    assert all((folder / f"{name}.png").stat().st_size for name in ("bench", "bench_motion"))
    assert max(map(len, text.splitlines())) <= 115
    assert "nan" not in text
    assert "None" not in text


def test_no_table_is_made_of_a_part(hidden: tuple[str, ...], figures: dict[str, Any]) -> None:
    names = ", ".join(NAMES[name] for name in hidden)
    with pytest.raises(ValueError, match=rf"^bench\.json: expected .*, got none of {names}: pip install "):
        published.tables(figures)


def test_a_partial_run_replaces_no_published_one(tmp_path: Path) -> None:
    (tmp_path / "bench.json").write_text(json.dumps({"left_out": ["CasADi"]}))
    committed = Path(__file__).parents[2] / ".docs" / "bench.json"
    before = committed.read_bytes()
    command = [sys.executable, "-m", "stewart_sym.studies.published", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=committed.parents[1])
    assert done.returncode == 1
    (line,) = done.stderr.splitlines()
    assert line.startswith("bench.json: expected ")
    assert committed.read_bytes() == before
