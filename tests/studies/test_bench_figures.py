"""What a run of the bench says: figures, ratios, tables, the picture, and how times are measured."""

import itertools
import json
import os
import re
import shutil
import sys
import tomllib
from pathlib import Path
from typing import Any

import matplotlib.image
import numpy as np
import pytest
from command_line import rejects
from robot_files import PAPERS
from small_bench import CONTESTANTS, shorten, some_passes

from stewart_sym.backend.kernel import module
from stewart_sym.cli.main import main
from stewart_sym.dynamics import forces
from stewart_sym.io.progress import silent
from stewart_sym.studies.benchmark import bench, compile_times, equation_kernels
from stewart_sym.studies.benchmark.baselines import PEERS
from stewart_sym.studies.benchmark.figures import CLOSED, FORWARD, MOST, PLAIN, batched
from stewart_sym.studies.benchmark.plot import motion_picture, picture
from stewart_sym.studies.benchmark.processor import targets
from stewart_sym.studies.common import host, timing
from stewart_sym.studies.common.output import Figures


@pytest.fixture(scope="module", params=[pytest.param("robot", marks=pytest.mark.slow)])
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command wrote of a robot file."""
    folder = tmp_path_factory.mktemp("bench")
    file = folder / "mine.toml"
    file.write_text(PAPERS.read_text().replace('name = "Dasgupta & Mruthyunjaya 1998"', 'name = "mine"'))
    with pytest.MonkeyPatch.context() as patch:
        shorten(patch)
        assert main(["benchmark", "--quick", "--robot", str(file), "-o", str(folder / "new")]) == 0
    return folder / "new"


@pytest.fixture(scope="module")
def figures(written: Path) -> dict[str, Any]:
    """The JSON."""
    found: dict[str, Any] = json.loads((written / "bench.json").read_text())
    return found


def test_the_second_group_has_its_ratios_and_targets(figures: dict[str, Any], written: Path) -> None:
    motion, text = figures["motion"], (written / "bench.txt").read_text()
    inverse, baselines = motion["ours"][0], motion["baselines"]
    forward = next(entry for entry in motion["ours"] if entry["name"] == FORWARD)
    assert [entry["name"] for entry in motion["ours"]] == [each.name for each in equation_kernels.FUNCTIONS]
    assert [entry["name"] for entry in baselines] == ["Pinocchio", "MuJoCo"]
    for entry in (*motion["ours"], *baselines):
        assert len(entry["raw"]) == figures["rounds"]
        assert entry["ratio_to_inverse_dynamics"] == pytest.approx(entry["median"] / inverse["median"])
        limits = tuple(entry[name] for name in ("target", "goal") if name in entry)
        assert limits == MOST.get(entry["name"], ())
    for net, call, empty in zip(baselines, motion["calls"], motion["empty_calls"], strict=True):
        assert net["raw"] == pytest.approx(np.array(call["raw"]) - np.array(empty["raw"]))
    better = min(baselines, key=lambda entry: float(entry["median"]))
    assert motion["better_baseline"] == better["name"]
    assert motion["times_faster"] == pytest.approx(better["median"] / forward["median"])
    said = f"{motion['times_faster']:.1f} x faster than the better of the two, {better['name']} (target 20)"
    assert said in text
    assert all(f"ours: {entry['name']}" in text for entry in motion["ours"])
    assert all(entry["name"] in (written / "bench_motion.svg").read_text() for entry in motion["ours"])


# what is said


def test_json_has_every_candidate_with_positive_figures(figures: dict[str, Any]) -> None:
    for group, expected in (("ours", bench.OURS), ("calls", bench.CALLS)):
        assert [entry["name"] for entry in figures[group]] == [each.name for each in expected]
    assert [entry["name"] for entry in figures["baselines"]] == [*(each.name for each in PEERS), "Pinocchio"]
    groups = (figures[name] for name in ("ours", "calls", "baselines", "builds", "peaks"))
    for entry in (*itertools.chain(*groups), figures["cycle"]):
        low, high = entry["quartiles"]
        assert len(entry["raw"]) == figures["rounds"] == 3
        assert low <= entry["median"] <= high > 0
        assert min(entry["raw"]) <= entry["median"] <= max(entry["raw"])
    swept = [(each.name, size) for each in bench.OURS if each.sweep for size in (8, 64)]
    assert [(entry["name"], entry["poses"]) for entry in figures["sweep"]] == swept
    assert all(entry["median"] > 0 for entry in figures["sweep"])


def test_json_says_where_and_with_what_it_ran(figures: dict[str, Any]) -> None:
    assert figures["robot"] == "mine"
    assert figures["machine"]["processor"]
    assert figures["machine"]["cores"] >= 1
    assert {"-O3", "-ffp-contract=off"} <= set(figures["software"]["flags"])
    assert all(
        figures["software"][name] for name in ("compiler", "python", "numpy", "casadi", "pin", "mujoco")
    )


def test_ratios_are_of_the_medians_of_the_same_run(figures: dict[str, Any]) -> None:
    for name, key in ((CLOSED, "ratio_to_closed_form"), (PLAIN, "ratio_to_casadi")):
        casadi = next(entry for entry in figures["baselines"] if entry["name"] == name)
        for entry in (*figures["ours"], *figures["baselines"]):
            assert entry[key] == pytest.approx(np.median(entry["raw"]) / np.median(casadi["raw"]))
    for entry in (*figures["ours"], *figures["baselines"], *figures["builds"]):
        assert entry["cycles"] == pytest.approx(np.median(entry["raw"]) * figures["cycle"]["clock_GHz"])
    (call, *_), one_pose = figures["calls"], figures["ours"][0]
    assert call["overhead_over_c_ns"] == pytest.approx(call["median"] - one_pose["median"])


def test_cores_are_compared_on_the_same_batch_round_by_round(figures: dict[str, Any], written: Path) -> None:
    one, shared = (next(e for e in figures["ours"] if e["name"] == n) for n in (bench.BATCH, bench.ALL_CORES))
    cores = figures["cores"]
    assert one["poses"] == shared["poses"] == cores["poses"] >= 2 * forces.LEAST_SHARE
    assert cores["raw"] == pytest.approx(np.array(one["raw"]) / np.array(shared["raw"]))
    assert cores["median"] == pytest.approx(np.median(cores["raw"]))
    assert len(figures["cores_arithmetic"]["raw"]) == len(cores["raw"])
    assert 0 < figures["cores_arithmetic"]["median"] < 2 * cores["cores"]
    assert cores["quartiles"] == pytest.approx(np.percentile(cores["raw"], (25, 75)))
    line = f"{cores['cores']} cores over one core: {cores['median']:.2f} times, quartiles"
    assert line in (written / "bench.txt").read_text()


def test_passes_have_their_operations_and_both_times(figures: dict[str, Any], written: Path) -> None:
    text = (written / "bench.txt").read_text()
    for entry, expected in zip(figures["passes"], some_passes(), strict=True):
        assert (entry["name"], entry["meaning"]) == (expected.name, expected.meaning)
        assert tuple(entry["operations"].values()) == expected.operations
        for time in (entry["one_pose"], entry["batch"]):
            assert len(time["raw"]) == figures["rounds"]
            assert time["median"] > 0
        assert re.search(
            rf"^{expected.name} +{expected.operations[0]} +{expected.operations[1]} ", text, re.M
        )


def test_json_says_how_long_the_kernels_compile(figures: dict[str, Any]) -> None:
    assert [entry["source"] for entry in figures["compiling"]] == [
        "stewart_exact.c",
        "stewart_exact_forces.c",
    ]
    assert all(len(entry["raw"]) == 1 and entry["median"] > 0 for entry in figures["compiling"])


def test_text_is_of_the_functions_of_one_pose(figures: dict[str, Any], written: Path) -> None:
    functions = figures["text"]["functions"]
    assert {"stewart_exact_prepare", "stewart_exact_forces"} <= functions.keys()
    assert not {"main", "_start", "stewart_exact_forces_batch"} & functions.keys()
    assert figures["text"]["total"] == sum(functions.values())
    assert 2_000 < figures["text"]["total"] < 50_000
    assert f"{figures['text']['total']} bytes" in (written / "bench.txt").read_text()


@pytest.mark.parametrize("command", ["gcc", pytest.param("clang", marks=pytest.mark.slow)])
def test_text_is_found_with_either_compiler(command: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", command)
    size = compile_times.text_size()
    assert size is not None
    assert {"stewart_exact_prepare", "stewart_exact_forces"} <= size["functions"].keys()


def test_text_is_left_out_where_the_tools_are_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compile_times, "SIZE_FLAGS", ("-O0",))
    monkeypatch.setattr(compile_times, "_LINK_FLAGS", ("-Wl,--no-such-option",))
    assert compile_times.text_size() is None
    monkeypatch.undo()
    monkeypatch.setattr(shutil, "which", lambda name: None if "nm" in name else f"/usr/bin/{name}")
    assert compile_times.text_size() is None


def test_own_work_is_not_that_of_others() -> None:
    work, times = host._work_of_others(), os.times()
    if work is None:
        assert not sys.platform.startswith("linux")
        return
    while sum(os.times()[:2]) - sum(times[:2]) < 0.3:
        pass
    again = host._work_of_others()
    assert again is not None
    assert work is not None
    seconds = os.times().elapsed - times.elapsed
    assert -0.05 < again - work < (os.cpu_count() or 1) * seconds - 0.25


def test_pinocchio_is_newton_euler_less_the_call_and_a_solve(figures: dict[str, Any]) -> None:
    rnea, solve, empty = (np.array(part["raw"]) for part in figures["parts"]["Pinocchio"])
    assert figures["baselines"][-1]["raw"] == pytest.approx(rnea - empty + solve)


def test_the_limit_is_the_emitted_operations_at_the_measured_rate(figures: dict[str, Any]) -> None:
    operations = sum(module("exact").FORCE_OPERATIONS["friction"]["total"])
    assert figures["ours"][0]["operations"] == operations
    for peak in figures["peaks"]:
        each, paired = peak["limits"].values()
        assert each == pytest.approx(1e9 * operations / peak["rate_per_s"])
        assert paired == pytest.approx(each / 2)
        cycles = operations / peak["numbers_in_a_vector"] / peak["vectors_in_a_cycle"]
        assert cycles == pytest.approx(each * figures["cycle"]["clock_GHz"])


def test_all_c_is_compiled_for_every_target_and_of_casadi_the_fastest_counts(figures: dict[str, Any]) -> None:
    kinds = [kind.name for kind in targets()]
    assert [peak["instructions"] for peak in figures["peaks"]] == kinds
    ours = [each.name for each in bench.OURS if each.function]
    motion = [name for each in equation_kernels.FUNCTIONS for name in (each.name, batched(each.name))]
    for kind in kinds:
        built = [entry for entry in figures["builds"] if entry["instructions"] == kind]
        assert sorted(entry["name"] for entry in built) == sorted([*ours, *motion, *(2 * [CLOSED, PLAIN])])
        for name in (CLOSED, PLAIN):
            both = [entry for entry in built if entry["name"] == name]
            assert ["-ffp-contract=fast" in entry["flags"] for entry in both] == [False, True]
            best = min(both, key=lambda entry: float(entry["median"]))
            key = {CLOSED: "ratio_to_closed_form", PLAIN: "ratio_to_casadi"}[name]
            assert best[key] == pytest.approx(1)
            if kind == kinds[0]:
                assert best in figures["baselines"]


def test_shares_are_the_same_in_text_and_json(figures: dict[str, Any], written: Path) -> None:
    text = (written / "bench.txt").read_text()
    kinds = [peak["instructions"] for peak in figures["peaks"]]
    assert len(figures["shares"]) == 13
    for each in figures["shares"]:
        shown = [f"{each['values'][kind]:#.3g}" for kind in kinds]
        line = next(line for line in text.splitlines() if line.startswith(each["name"] + "  "))
        assert line.removeprefix(each["name"]).split()[1 : 1 + len(kinds)] == shown


def test_the_table_has_every_candidate(written: Path) -> None:
    text = (written / "bench.txt").read_text()
    assert all(each.name in text for each in CONTESTANTS)
    assert max(map(len, text.splitlines())) <= 115


def test_the_picture_shows_every_candidate(written: Path) -> None:
    drawing = (written / "bench.svg").read_text()
    assert all(each.name in drawing for each in (*bench.OURS, *PEERS))
    pixels = matplotlib.image.imread(written / "bench.png")
    assert min(pixels.shape[:2]) > 500
    assert 0.01 < np.mean(pixels[..., :3] < 0.9) < 0.5


def disturbed(found: Figures) -> Figures:
    """The slowest code's third quartile at 400 times its median, as beside another job."""
    *others, slowest = sorted(found["baselines"], key=lambda each: float(each["median"]))
    wide = slowest | {"quartiles": [slowest["median"], 400.0 * slowest["median"]]}
    return found | {"baselines": [*others, wide]}


def test_labels_in_the_picture_do_not_overlap(figures: Figures) -> None:
    for canvas in (picture(figures), motion_picture(figures), picture(disturbed(figures))):
        canvas.draw_without_rendering()
        above = canvas.axes[0]
        boxes = [text.get_window_extent() for text in (*above.texts, *above.get_yticklabels())]
        legend = above.get_legend()
        boxes.append(above.title.get_window_extent() if legend is None else legend.get_window_extent())
        assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))
        assert all(canvas.bbox.x0 < box.x0 and box.x1 < canvas.bbox.x1 for box in boxes)


def test_a_net_time_that_other_work_made_negative_does_not_stop_the_picture(figures: Figures) -> None:
    motion = figures["motion"]
    first, *others = motion["baselines"]
    times = {"median": -20.0, "quartiles": [-25.0, 20.0], "ratio_to_inverse_dynamics": -0.1}
    negative = motion | {"baselines": [first | times, *others]}
    motion_picture(figures | {"motion": negative}).draw_without_rendering()


def test_the_extra_names_what_the_bench_imports() -> None:
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())["project"]
    needs = project["optional-dependencies"]

    def named(extra: str) -> set[str]:
        """Requirements of an extra, for those that it takes from other extras their own."""
        found: set[str] = set()
        for need in needs[extra]:
            own = re.fullmatch(r"stewart-sym\[(.*)\]", need)
            found = found.union(*map(named, own[1].split(","))) if own else found | {need}
        return found

    drawing = {"matplotlib", "textalloc"}
    assert {need.split(">")[0] for need in named("bench")} == {*bench.COMPARED.values(), *drawing}
    assert named("bench") <= named("test")


# how it is measured


class Clock:
    """A clock that stands still but for what tasks take."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.now = 0
        self.calls: list[tuple[str, int]] = []
        monkeypatch.setattr("time.perf_counter_ns", lambda: self.now)
        # Of all that the tests before have left.
        monkeypatch.setattr("gc.collect", lambda: 0)

    def task(self, name: str, units: int, ns: int) -> timing.Task:
        def run(repeats: int) -> None:
            self.calls.append((name, repeats))
            self.now += repeats * units * ns

        return timing.Task(run, units)


def test_a_figure_is_the_time_of_one_unit(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    tasks = {"short": clock.task("short", 64, 100), "long": clock.task("long", 10**6, 750)}
    raw = timing.measured(tasks, {"short": 5, "long": 3}, silent)
    assert raw["short"] == pytest.approx(5 * (100.0,))
    assert raw["long"] == pytest.approx(3 * (750.0,))


def test_candidates_take_turns_and_every_sample_is_long_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    names = ("a", "b", "c")
    tasks = {name: clock.task(name, 64, 100) for name in names}
    timing.measured(tasks, dict.fromkeys(names, 4), silent)
    samples = [(name, repeats) for name, repeats in clock.calls[-2 * 3 * 4 :] if repeats > 1]
    assert len(samples) == 3 * 4
    assert all(repeats * 64 * 100 >= 1e9 * timing.SHORTEST for _, repeats in samples)
    rounds = [tuple(name for name, _ in samples[i : i + 3]) for i in range(0, 12, 3)]
    assert [sorted(turn) for turn in rounds] == 4 * [[*names]]
    assert len(set(rounds)) == 3


def test_every_sample_but_an_enormous_one_comes_after_a_run_that_is_not_timed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock = Clock(monkeypatch)
    tasks = {
        "large": clock.task("large", timing.ENORMOUS - 1, 100),
        "enormous": clock.task("enormous", timing.ENORMOUS, 100),
    }
    timing.measured(tasks, dict.fromkeys(tasks, 3), silent)
    turns = [name for name, _ in clock.calls[-3 * 3 :]]
    one, other = ["large", "large"], ["enormous"]
    assert turns == [*one, *other, *other, *one, *one, *other]


def test_a_sample_that_turns_out_short_is_taken_again(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock(monkeypatch)
    speeds = itertools.chain(8 * [1000], itertools.repeat(1))
    taken: list[int] = []

    def run(repeats: int) -> None:
        taken.append(repeats * 64 * next(speeds))
        clock.now += taken[-1]

    raw = timing.measured({"task": timing.Task(run, 64)}, {"task": 3}, silent)
    assert taken[-1] >= 1e9 * timing.SHORTEST
    assert raw["task"] == pytest.approx(3 * (1.0,))


def test_a_coarse_clock_is_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    ticks = itertools.count(0, 50_000)
    monkeypatch.setattr("time.perf_counter_ns", lambda: next(ticks))
    rejects("clock is too coarse", timing.time_source)
