"""Limits have the same status in warnings, JSON data, and page of ``view`` as in ``forces``."""

import contextlib
import dataclasses
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import Opened
from machines import dasgupta
from numpy.typing import NDArray
from playwright.sync_api import Browser

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.drives.limit_status import EXCEEDED, INCONCLUSIVE_NOISE, SURE, WITHIN
from stewart_sym.viewer.view import Viewer

EXAMPLES = Path(__file__).parents[2] / ".docs" / "examples"
POSE = ("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z")
RATES = [f"{name}_{axis}" for name in ("v", "theta_dot", "a", "theta_ddot") for axis in "xyz"]
DRIVE = """
[legs.drive]
lead = 0.01
efficiency = 0.9
screw_coulomb = 3.0
regularization_speed = 0.01
torque_constant = 0.1
resistance = 1.0
"""
# Limits of a file, where they stand, the peaks that they limit, and the verdicts, both as JSON has them.
LEGS = {"force_limit": "peak_force_N", "speed_limit": "peak_speed_m_per_s"}
MOTORS = {
    "torque_limit": ("motor_peak_torque_N_m", "motor_torque_limit"),
    "speed_limit": ("motor_peak_speed_rad_per_s", "motor_speed_limit"),
    "current_limit": ("motor_peak_current_A", "motor_current_limit"),
    "power_limit": ("motor_peak_power_W", "motor_power_limit"),
    "rated_torque": ("motor_rms_torque_N_m", "motor_rated_torque"),
}
VERDICTS = [*LEGS, "max_length_limit", "min_length_limit", *(name for _, name in MOTORS.values())]
MARKS = {WITHIN: "", INCONCLUSIVE_NOISE: "doubtful", EXCEEDED: "beyond"}
# Columns of the tables of peaks, and the verdicts that they show.
PEAKS = {
    "peaks": {"force_limit": 1, "speed_limit": -1},
    "motors-peaks": {name: i + 1 for i, (_, name) in enumerate(MOTORS.values())},
}
Array = NDArray[np.float64]


def moves(noisy: bool) -> tuple[list[str], Array]:
    """Names and columns of a motion with its rates, or of its poses with noise."""
    time = np.arange(0.0, 1.5, 0.0075)
    phase = np.outer(time, [6.0, 7.0, 8.0, 5.0, 9.0, 6.5]) + np.arange(6.0)
    size = np.array([0.03, 0.03, 0.02, 0.04, 0.04, 0.05])
    rate = (phase[1] - phase[0]) / time[1]
    poses, rates, second = size * np.sin(phase), size * rate * np.cos(phase), -size * rate**2 * np.sin(phase)
    poses[:, 2] += 0.65
    if noisy:
        poses += np.random.default_rng(3).normal(size=poses.shape) * 1e-5
        return ["time", *POSE], np.column_stack([time, poses])
    columns = [time, poses, *(x[:, part] for x in (rates, second) for part in (slice(3), slice(3, 6)))]
    return ["time", *POSE, *RATES], np.column_stack(columns)


def said(*arguments: str | Path) -> list[str]:
    """What a command warns of limits."""
    stream = io.StringIO()
    with contextlib.redirect_stderr(stream):
        assert main([str(each) for each in arguments]) == 0
    lines = [line.partition("warning: ")[2] for line in stream.getvalue().splitlines()]
    return [line for line in lines if re.match(r"[\w.]+ (exceeded|inconclusive)", line)]


def legs_of(path: Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(path.read_text(encoding="utf-8"))["legs"]
    return found


class Case:
    """Limits that some legs exceed, others keep, and one reaches; a motion; what both commands say of it."""

    def __init__(self, folder: Path, noisy: bool) -> None:
        """Run both commands."""
        self.noisy, self.page = noisy, folder / "out.html"
        names, columns = moves(noisy)
        log, robot = folder / "log.csv", folder / "robot.toml"
        np.savetxt(log, columns, delimiter=",", header=",".join(names), comments="", fmt="%.12g")
        text = (EXAMPLES / "hexapod.toml").read_text(encoding="utf-8") + DRIVE
        robot.write_text(text, encoding="utf-8")
        files = {name: folder / f"{name}.json" for name in ("free", "forces", "view")}
        forces = ("forces", robot, log, "-o", folder / "out.csv", "--noise-threshold", "10", "--json")
        said(*forces, files["free"])
        robot.write_text(limited(text, legs_of(files["free"]), noisy), encoding="utf-8")
        self.warned_by_forces = said(*forces, files["forces"])
        self.warned = said("view", robot, log, "-o", self.page, "--json", files["view"])
        self.forces, self.legs = legs_of(files["forces"]), legs_of(files["view"])
        self.doubts = json.loads(files["view"].read_text(encoding="utf-8"))["warnings"]
        self.table = np.genfromtxt(folder / "out.csv", delimiter=",", names=True)
        self.time = self.table["time"]
        self.robot = ss.Robot.from_toml(robot)


def limited(text: str, legs: list[dict[str, Any]], noisy: bool) -> str:
    """A robot file with limits that two legs exceed and one reaches: inconclusive with noise."""

    def limit(name: str, sign: float = 1.0) -> float:
        value = sorted(sign * abs(leg[name]) for leg in legs)[-3]
        return sign * (value + (1e-7 if noisy else 1e-5) * abs(value))

    for name, peak in LEGS.items():
        text = re.sub(rf"^{name} = .*$", f"{name} = {limit(peak)!r}", text, flags=re.MULTILINE)
    ends = [limit("min_length_m", -1.0), limit("max_length_m")]
    text = re.sub(r"^length_limits = .*$", f"length_limits = {ends}", text, flags=re.MULTILINE)
    return text + "".join(f"{name} = {limit(peak)!r}\n" for name, (peak, _) in MOTORS.items())


@pytest.fixture(scope="module", params=[False, True], ids=["exact", "noisy"])
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Case:
    return Case(tmp_path_factory.mktemp("limits"), request.param)


@pytest.fixture(scope="module")
def opened(browser: Browser, case: Case) -> Iterator[Opened]:
    found = Opened(browser, case.page)
    yield found
    found.close()


@pytest.mark.slow
def test_warnings_and_json_are_those_of_forces(case: Case) -> None:
    assert case.warned == case.warned_by_forces == case.doubts
    found = {name: [leg[name] for leg in case.legs] for name in VERDICTS}
    assert found == {name: [leg[name] for leg in case.forces] for name in VERDICTS}
    for name, verdicts in found.items():
        assert EXCEEDED in verdicts, name
        assert WITHIN in verdicts, name
        assert (INCONCLUSIVE_NOISE in verdicts) == case.noisy, name
    for leg, other in zip(case.legs, case.forces, strict=True):
        assert leg.keys() == other.keys()
        assert ("motor_peak_power_std_W" in leg) == ("peak_speed_std_m_per_s" in leg) == case.noisy
        numbers = {name: value for name, value in other.items() if not isinstance(value, str)}
        for name, value in numbers.items():
            assert leg[name] == (value if value is None else pytest.approx(value, rel=1e-9)), name


@pytest.mark.slow
def test_the_page_says_what_the_command_warns_of(case: Case, opened: Opened) -> None:
    lines = opened.page.locator("#limits li")
    assert lines.all_inner_texts() == case.warned
    classes = [line.get_attribute("class") for line in lines.all()]
    assert classes == ["beyond" if f" {EXCEEDED} by " in line else "doubtful" for line in case.warned]
    # Of the one limit of all legs on the scale of colors, on either side.
    assert opened.page.locator("#bar i").count() == 2
    noise = opened.page.locator("#noise")
    assert noise.count() == case.noisy
    legend = ["limit exceeded", "inconclusive noise ?"]
    assert opened.page.locator("#verdicts span").all_inner_texts() == legend[: 1 + case.noisy]
    for table, columns in PEAKS.items():
        for name, column in columns.items():
            shown = marks(opened, table, column)
            assert shown == [MARKS[leg[name]] for leg in case.legs], name
    assert opened.said == []


def marks(opened: Opened, table: str, column: int) -> list[str]:
    """Classes of the cells of the legs in a column of a table."""
    rows = f"[...document.querySelectorAll('#{table} tbody tr')]"
    found: list[str] = opened.do(f"return {rows}.map((row) => [...row.cells].at({column}).className)")
    return found


@pytest.mark.slow
def test_every_instant_has_the_verdicts_of_its_numbers(case: Case, opened: Opened) -> None:
    drive, seen = case.robot.drive, set()
    assert drive is not None
    limits = {"F": case.robot.force_limit, "motor_speed": drive.speed_limit, "power": drive.power_limit}
    for name, limit in limits.items():
        sizes, sd = abs(columns(case, name)), columns(case, f"{name}_std") if case.noisy else 0.0
        codes = np.where(sizes - SURE * sd > limit, 2, np.where(sizes + SURE * sd > limit, 1, 0))
        table, column = {"F": ("now", 1), "motor_speed": ("motors-now", 2), "power": ("motors-now", 4)}[name]
        for code in range(2 + case.noisy if name == "F" else 2):
            code = 2 if code == 1 and not case.noisy else code
            i, leg = np.argwhere(codes == code)[0]
            opened.do(f"viewer.clock.pause(); viewer.clock.seek({case.time[i]})")
            found = marks(opened, table, column)
            assert found == [["", "doubtful", "beyond"][each] for each in codes[i]], (name, i)
            seen.add(found[leg])
    assert seen == ({"", "doubtful", "beyond"} if case.noisy else {"", "beyond"})


def columns(case: Case, name: str) -> Array:
    """Of the six legs, (n, 6), as ``forces`` writes them."""
    stem, _, ending = name.partition("_std")
    ending = "_std" if name.endswith("_std") else ending
    return np.stack([case.table[f"{stem}_{leg}{ending}"] for leg in range(1, 7)], axis=-1)


def test_a_path_and_a_machine_without_limits_say_nothing_of_limits() -> None:
    free = dataclasses.replace(dasgupta(), length_limits=np.tile([0.0, np.inf], (6, 1)))
    assert 'id="limits"' not in ss.view(free, "I").html
    wide = dataclasses.replace(free, force_limit=np.full(6, 1e5))
    shown: Viewer = ss.view(wide, "I")
    assert (
        "The motion is within the limits of forces, lengths, speeds, and motors in the robot file."
        in shown.html
    )
    assert not shown.limits.told
