"""The figures in the README are those that the code computes.

``PYTHONPATH=tests/support python tests/cli/test_readme.py DIR`` takes what
``stewart-sym bench -o DIR``, ``stewart-sym control -o DIR`` or
``stewart-sym chart -o DIR`` wrote for the README's figures: it copies JSON and pictures into ``.docs`` and
writes the README's tables anew; without DIR it only writes the tables.
"""

import argparse
import ast
import copy
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import readme_bench
import readme_chart
import readme_control
import readme_controller
import readme_stability
from machines import dasgupta, random_motion, random_robot
from numpy.typing import NDArray
from pinocchio_model import pinocchio_inverse_dynamics
from readme_tables import README, README_FOLDER, table_row

import stewart_sym as ss
from stewart_sym.backend import fidelity
from stewart_sym.backend.kernel import module
from stewart_sym.cli import main
from stewart_sym.reference import newton_euler
from stewart_sym.simulation.scene import Scene, read_scene
from stewart_sym.studies.accuracy.budget import papers_motions, read_budget
from stewart_sym.studies.benchmark.figures import Figure, MotionFigures
from stewart_sym.studies.common.host import DISTURBED
from stewart_sym.studies.control import control
from stewart_sym.studies.control import report as control_report
from stewart_sym.studies.paper.reproduce import work_energy
from stewart_sym.studies.reports import energy_drift

PUBLISHED = (
    *("bench.json", "bench.png", "bench_motion.png"),
    *("control.json", "control.png"),
    *("chart.json", "chart.png", "scales.png", "bounds.png"),
    *("stability.json", "singular_path_III.png"),
    "controller.json",
)
REWRITE = "run `PYTHONPATH=tests/support python tests/cli/test_readme.py` and look at the README"


def rms(difference: NDArray[np.float64], truth: NDArray[np.float64]) -> float:
    """RMS of the difference in per cent of the RMS of the truth."""
    return float(100 * np.sqrt(np.mean(difference**2) / np.mean(truth**2)))


@pytest.mark.parametrize("name", ["I", "II"])
def test_paper_differs_from_pinocchio_on_the_paths_by_what_the_readme_says(name: str) -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PATHS[name]
    motion = path.sample(path.times(step))
    truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(motion.shape[0])])
    paper, exact = (rms(ss.inverse_dynamics(robot, motion, f).F - truth, truth) for f in ("paper", "exact"))
    assert table_row(name)[:2] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert exact < 1e-10


@pytest.mark.parametrize("name", ["I", "II"])
def test_work_differs_from_energy_by_what_the_readme_says(name: str) -> None:
    robot = dasgupta(friction=False)
    paper, exact = (
        100 * (found.work - found.gain) / found.gain
        for found in (work_energy(robot, name, faults) for faults in (newton_euler.PAPER, newton_euler.EXACT))
    )
    assert table_row(name)[2:] == [f"{paper:.2f} %", "below 1e-10 %"]
    assert abs(exact) < 1e-10


def test_paper_differs_from_pinocchio_on_random_machines_by_what_the_readme_says() -> None:
    errors = []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        robot = random_robot(rng)
        motion = random_motion(rng, robot, (3,))
        truth = np.array([pinocchio_inverse_dynamics(robot, motion[i]).F for i in range(3)])
        errors.append(rms(ss.inverse_dynamics(robot, motion, "paper").F - truth, truth))
    said = re.search(r"off by (\d+) % at least and by (\d+) % in the\s+median", README)
    assert said
    assert [int(said[1]), int(said[2])] == [round(min(errors)), round(float(np.median(errors)))]


def test_fault_2_costs_at_rest_what_the_readme_says() -> None:
    robot = dasgupta(friction=False)
    path, step = ss.PATHS["I"]
    moving = path.sample(path.times(step))
    zero = np.zeros_like(moving.t)
    rest = ss.Motion(moving.R, moving.t, zero, zero, zero, zero)
    truth = newton_euler.inverse_dynamics(robot, rest).F
    error = rms(newton_euler.inverse_dynamics(robot, rest, frozenset({2})).F - truth, truth)
    assert f"Fault 2 acts even at rest: {error:.2f} %" in README


@pytest.mark.parametrize("formulation", ["paper", "exact"])
def test_operations_in_the_readme_are_those_of_the_kernels(formulation: str) -> None:
    kernel = module(formulation)
    for label, counts in (("", kernel.OPERATIONS), (", forces alone", kernel.FORCE_OPERATIONS)):
        totals = [str(sum(counts[kind]["total"])) for kind in ("frictionless", "friction")]
        assert table_row(f"`{formulation}`{label}") == totals


def figures(study: str = "bench") -> dict[str, Any]:
    """What the committed run of a study wrote."""
    text = (README_FOLDER / ".docs" / f"{study}.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    return found


def test_times_in_the_readme_are_those_of_the_benchmark() -> None:
    found = figures()
    for figure in (*found["ours"], *found["baselines"]):
        assert table_row(figure["name"]) == [f"{figure['median']:.0f}", f"{figure['ratio_to_casadi']:.2f}"]
    prose = " ".join(README.split())
    for source in found["compiling"]:
        assert f"`{source['source']}` in {np.median(source['raw']):.2f} s" in prose
    assert f"{sum(found['text']['functions'].values()):,} bytes" in prose
    assert f"{found['cores']['cores']} cores over one core: {np.median(found['cores']['raw']):.2f} " in prose
    assert f" with {found['machine']['vectors']}, " in prose
    assert readme_bench.replaced(README, found) == README, REWRITE


def test_the_committed_run_was_not_disturbed_by_others() -> None:
    assert figures()["machine"]["taken_by_others"] <= DISTURBED, "run `stewart-sym bench` on a quiet machine"


def test_the_committed_run_keeps_what_the_kernels_promise() -> None:
    found = figures()
    ratio = {each["name"]: each["ratio_to_casadi"] for each in found["ours"]}
    assert ratio["one pose"] <= 0.33
    assert ratio["batch, one core"] <= 0.11
    assert found["cores"]["median"] >= 0.9 * found["cores"]["cores"]
    assert found["calls"][0]["overhead_over_c_ns"] <= 5_000
    assert all(flatness <= 1.3 for flatness in found["flatness"].values())
    assert max(each["median"] for each in found["compiling"]) <= 5
    assert found["text"]["total"] <= 24 * 1024


def motion_figures() -> dict[str, Any]:
    """The second group as ``Benchmark.as_json`` writes it, from figures made up."""
    ours, baselines = (
        tuple(Figure(name, f"{name}, how", "one pose", 16, (time,)) for name, time in group)
        for group in (
            (("inverse dynamics", 300.0), ("forward dynamics", 400.0), ("derivatives", 1500.0)),
            (("Pinocchio", 9000.0), ("MuJoCo", 8000.0)),
        )
    )
    found = MotionFigures("machine", ours, baselines, (), (), 2e-8, {"Pinocchio": 1e-8, "MuJoCo": 2e-6})
    return found.as_json()


def test_motion_in_the_readme_has_every_figure_with_its_target() -> None:
    prose = readme_bench.motion(motion_figures(), 41)
    for line in (
        "| inverse dynamics | 300 | 1.00 | |",
        "| forward dynamics | 400 | 1.33 | 2 |",
        "| derivatives | 1500 | 5.00 | 8, goal 5 |",
        "| MuJoCo, forward dynamics | 8000 | 26.67 | |",
        "Forward dynamics is 20.0 times as fast as the better of the two baselines, MuJoCo (target 20).",
    ):
        assert line in prose


def test_every_figure_that_changes_changes_the_readme() -> None:
    found = figures()
    each = {"name": "pass", "operations": {"without_friction": 1, "with_friction": 2}}
    times = {"one_pose": {"median": 3.0}, "batch": {"median": 4.0, "poses": 10_000}}
    found["passes"] = [{**each, **times}]
    found["motion"] = motion_figures()
    texts = {readme_bench.text(found)}
    places: list[tuple[Any, ...]] = [
        ("machine", "vectors"),
        ("cores", "median"),
        ("flatness", next(iter(found["flatness"]))),
        ("text", "total"),
        ("passes", 0, "operations", "with_friction"),
        *((group, -1, "median") for group in ("ours", "baselines", "sweep", "calls", "compiling")),
        *(("motion", name) for name in ("times_faster", "loops_open_m")),
        ("motion", "largest_difference", "MuJoCo"),
        *(("motion", kind, -1, "median") for kind in ("ours", "baselines")),
        *(("passes", 0, kind, "median") for kind in ("one_pose", "batch")),
    ]
    for place in places:
        changed = copy.deepcopy(found)
        *way, last = place
        inner: Any = changed
        for step in way:
            inner = inner[step]
        inner[last] = "avx9" if isinstance(inner[last], str) else 7 * inner[last]
        texts.add(readme_bench.text(changed))
    assert len(texts) == 1 + len(places)


def test_control_in_the_readme_is_that_of_the_study() -> None:
    assert readme_control.replaced(README, figures("control")) == README, REWRITE


def test_every_figure_of_control_that_the_readme_shows_changes_it() -> None:
    found = figures("control")
    kinds = {"position": "mm", "orientation": "mrad"}
    shown = {f"{kind}_{of}_{unit}" for kind, unit in kinds.items() for of in ("rms", "max")}
    shown |= {f"{kind}_rms_{unit}_to_exact" for kind, unit in kinds.items()}
    shown |= {"force_peak_N", "force_rms_N", "force_peak_N_to_exact"}
    shown |= {"position_settled_rms_mm", "position_settled_rms_mm_to_exact"}
    text = readme_control.text(found)
    for name in shown:
        changed = copy.deepcopy(found)
        for row in changed["machines"]["printed"]["rows"]:
            row[name] *= 7
        assert readme_control.text(changed) != text, name


def test_failures_in_the_readme_are_those_of_the_study() -> None:
    assert readme_stability.replaced(README, figures("stability")) == README, REWRITE


def test_every_figure_of_failures_that_the_readme_shows_changes_it() -> None:
    found = figures("stability")
    text = readme_stability.text(found)
    for name in ("worst", "digits", "rejected_at", "silent"):
        changed = copy.deepcopy(found)
        for method in changed["families"][0]["methods"]:
            method[name] = 7 * (method[name] or 1)
        assert readme_stability.text(changed) != text, name
    for name in ("cases", "wrong", "rejected_good"):
        assert readme_stability.text({**found, "sweep": {**found["sweep"], name: 12345}}) != text, name


def recomputed(paths: tuple[str, ...]) -> None:
    """Compute rows anew and compare them with those committed, to what the README shows of them."""
    committed, machines = figures("control"), control.papers_machines()
    studies = {label: control.track_paths(robot, paths) for label, robot in machines.items()}
    found = json.loads(json.dumps(control_report.as_json(studies)))
    assert found["settings"] == committed["settings"]
    assert found["machines"].keys() == committed["machines"].keys()
    for label, machine in found["machines"].items():
        rows = readme_control.by_name(committed["machines"][label]["rows"])
        assert machine["friction"] == committed["machines"][label]["friction"]
        for key, row in readme_control.by_name(machine["rows"]).items():
            numbers = {name: value for name, value in row.items() if isinstance(value, float)}
            assert numbers == pytest.approx({name: rows[key][name] for name in numbers}, rel=1e-4), key


def test_the_committed_run_of_control_is_what_the_code_computes_on_path_ii() -> None:
    recomputed(("II",))


@pytest.mark.slow
def test_the_committed_run_of_control_is_what_the_code_computes() -> None:
    recomputed(control.TRACKED)


def test_the_chart_in_the_readme_is_that_of_the_study() -> None:
    assert readme_chart.replaced(README, figures("chart")) == README, REWRITE


def test_every_figure_of_the_chart_that_the_readme_shows_changes_it() -> None:
    found = figures("chart")
    texts = {readme_chart.text(found)}
    double = next(i for i, each in enumerate(found["candidates"]) if each["precision"] == "double")
    general = len(found["candidates"]) - 1
    places: list[tuple[Any, ...]] = [
        ("machine", "processor"),
        ("software", "compiler"),
        ("motions", "II", "peak_force_N"),
        *(("candidates", double, name) for name in ("operations", "one_pose_ns", "text_bytes")),
        ("candidates", double - 1, "one_pose_ns"),
        *(("candidates", double, "errors", path, "model") for path in ("I", "II", "III")),
        ("candidates", general, "errors", "III", "rounding"),
        ("implementations", -1, "rounding", "III"),
    ]
    for place in places:
        changed = copy.deepcopy(found)
        *way, last = place
        inner: Any = changed
        for step in way:
            inner = inner[step]
        inner[last] = "another" if isinstance(inner[last], str) else 7 * inner[last]
        texts.add(readme_chart.text(changed))
    assert len(texts) == 1 + len(places)


def test_the_committed_chart_is_what_the_code_computes() -> None:
    robot, motions = dasgupta(), papers_motions()
    for each in figures("chart")["candidates"]:
        how = each["formulation"], each["fidelity"]
        assert each["operations"] == fidelity.operations(robot, *how)
        for path, motion in motions.items():
            true = newton_euler.inverse_dynamics(robot, motion).F
            off = np.abs(ss.prepare(robot, how[0], "double", how[1]).forces(motion) - true).max()
            assert off / np.abs(true).max() == pytest.approx(
                each["errors"][path]["model"], rel=1e-6, abs=1e-12
            )


SHAPE = re.compile(r"\((\d+(?:, \d+)*),?\)")
NUMBER = re.compile(r"-?\d+(?:\.(\d+))?")
ROUNDING = 1e-9
"""Largest of what a comment calls 0 but for rounding, N and m/s^2."""


def compared(value: object, comment: str) -> int:
    """Check a value against the shape, the number or both that its comment begins with; returns how many."""
    text, count = comment, 0
    if shape := SHAPE.match(text):
        assert np.shape(value) == tuple(int(length) for length in shape[1].split(", ")), comment
        text, count = text[shape.end() :].lstrip(":, "), 1
    if number := NUMBER.match(text):
        within = ROUNDING if "but for rounding" in text else 0.5 * 10.0 ** -len(number[1] or "")
        assert np.abs(np.asarray(value) - float(number[0])).max() <= within, comment
        count += 1
    return count


def run_and_compare(text: str, names: dict[str, Any]) -> int:
    """Run statements in order, each compared with the comment at its end; returns how many were compared."""
    lines, count = text.splitlines(), 0
    for statement in ast.parse(text).body:
        assert statement.end_lineno is not None
        comment = lines[statement.end_lineno - 1].encode()[statement.end_col_offset :].decode()
        comment = comment.strip().removeprefix("#").strip()
        if isinstance(statement, ast.Expr):
            value = eval(compile(ast.Expression(statement.value), "README.md", "eval"), names)
        else:
            exec(compile(ast.Module([statement], []), "README.md", "exec"), names)
            target = statement.targets[0] if isinstance(statement, ast.Assign) else None
            value = names[target.id] if isinstance(target, ast.Name) else None
        count += compared(value, comment)
    return count


def test_python_examples_run_in_order_and_give_what_their_comments_say() -> None:
    blocks = "".join(re.findall(r"```python\n(.*?)```", README, re.DOTALL))
    names: dict[str, Any] = {}
    assert run_and_compare(blocks, names) >= 20
    assert names["code"] == 0
    comments = re.findall(r"#(.*)", blocks)
    assert not [comment for comment in comments if SHAPE.search(comment) and not SHAPE.match(comment.strip())]


def test_no_name_of_the_examples_changes_from_one_pose_to_many() -> None:
    """An array of another batch meets it without an error, by broadcasting."""
    kept: dict[str, tuple[int, ...]] = {}
    names: dict[str, Any] = {}
    for block in re.findall(r"```python\n(.*?)```", README, re.DOTALL):
        run_and_compare(block, names)
        for name, value in names.items():
            if isinstance(value, ss.Motion):
                assert kept.setdefault(name, value.shape) == value.shape, name


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


def written_files() -> set[str]:
    """What the commands of the README and of --help write, and the files that the README says to save."""
    helps = [README]
    for name, sub in subcommands().items():
        helps.append(sub.epilog or "")
        default = sub.get_default("output")
        helps.append(f"{name} -o {default}" if default else "")
    text = " ".join(helps)
    found = re.findall(r"(?:-o|--generate)\s+([a-z][\w.]*)", text)
    found += re.findall(r"saved as `(\S+)`", text, re.IGNORECASE)
    found += re.findall(r"stewart-sym \w+ ([a-z]\w*\.(?:toml|csv))", text)
    return set(found)


def subcommands() -> dict[str, argparse.ArgumentParser]:
    parsers = [a for a in main._parser()._actions if isinstance(a, argparse._SubParsersAction)]
    return dict(parsers[0].choices)


def test_what_the_commands_write_in_the_top_folder_is_no_change_of_the_repository() -> None:
    names = written_files()
    assert {"reproduce", "swing.toml", "enough.toml", "forces.csv", "kit", "simulation"} <= names
    for name in sorted(names):
        path = name if "." in name else f"{name}/report.txt"
        done = subprocess.run(["git", "check-ignore", "-q", path], cwd=README_FOLDER, check=False)
        assert done.returncode == 0, name


def test_robot_example_is_a_valid_robot_file(tmp_path: Path) -> None:
    text = re.search(r"```toml\n(.*?)```", README, re.DOTALL)
    assert text
    head, leg = text[1].split("[[leg]]")
    legs = []
    for angle in np.radians([0, 60, 120, 180, 240, 300]):
        point = f"[{np.cos(angle):.3f}, {np.sin(angle):.3f}, 0.0]"
        legs.append("[[leg]]" + re.sub(r"base_point = \[.*?\]", f"base_point = {point}", leg, count=1))
    path = tmp_path / "hexapod.toml"
    path.write_text(head + "\n".join(legs))
    assert ss.Robot.from_toml(path).name == "hexapod"


def test_advise_example_is_a_valid_budget(tmp_path: Path) -> None:
    (budget,) = re.findall(
        r"```toml\n(schema = 1\nrobot = (?:(?!```).)*?tolerance = .*?)```", README, re.DOTALL
    )
    (tmp_path / "stewart_sym").symlink_to(README_FOLDER / "stewart_sym")
    (tmp_path / "enough.toml").write_text(budget)
    assert list(read_budget(tmp_path / "enough.toml").motions) == ["I", "II"]


def readme_scene(folder: Path) -> Scene:
    """The README's scene, read from a folder that has the robot file where the scene says."""
    scene = re.search(r"```toml\n(schema = 1\nrobot = .*?)```", README, re.DOTALL)
    assert scene
    (folder / "stewart_sym").symlink_to(README_FOLDER / "stewart_sym")
    (folder / "swing.toml").write_text(scene[1])
    return read_scene(folder / "swing.toml")


def test_scene_example_is_a_valid_scene_of_springs(tmp_path: Path) -> None:
    scene = readme_scene(tmp_path)
    assert scene.robot.name == ss.robots.dasgupta1998().name
    assert energy_drift.springs_of(scene) is scene.law


@pytest.mark.slow
def test_energy_of_the_scene_example_drifts_by_what_the_readme_says(tmp_path: Path) -> None:
    scene = readme_scene(tmp_path)
    drifts = energy_drift.energy_drift(energy_drift.springs_of(scene), scene.state, scene.duration)
    said = re.search(
        r"by less than (\S+) of the mean kinetic energy with\s+`exact`, by up to (\d+) %", README
    )
    assert said
    assert drifts["exact"].worst < float(said[1])
    assert round(100 * drifts["paper"].worst) == int(said[2])
    assert {drift.times[-1] for drift in drifts.values()} == {scene.duration}


def _rewrite(run: Path | None) -> None:
    if run is not None:
        new = run / "bench.json"
        if new.exists():
            readme_bench.text(json.loads(new.read_text(encoding="utf-8")))  # before it replaces the old one
        for path in sorted(run.glob("*")):
            if path.name in PUBLISHED:
                shutil.copyfile(path, README_FOLDER / ".docs" / path.name)
    text = readme_bench.replaced(README, figures("bench"))
    text = readme_control.replaced(text, figures("control"))
    text = readme_chart.replaced(text, figures("chart"))
    text = readme_stability.replaced(text, figures("stability"))
    text = readme_controller.replaced(text, figures("controller"))
    (README_FOLDER / "README.md").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    try:
        _rewrite(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
    except ValueError as error:
        sys.exit(str(error))
