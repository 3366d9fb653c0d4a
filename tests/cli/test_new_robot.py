"""``new``, ``robots`` and the picture of ``check``: files that people begin with."""

import io
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from command_line import Fails, Run

import stewart_sym as ss
from stewart_sym import robots
from stewart_sym.cli.main import main

NUMBERS = {
    **{"--base-radius": 0.6, "--platform-radius": 0.3, "--height": 0.7, "--stroke": 0.3},
    **{"--platform-mass": 40.0, "--leg-mass": 4.0},
}


def options(numbers: dict[str, float]) -> list[str]:
    return [text for name, value in numbers.items() for text in (name, repr(value))]


def test_a_new_file_has_the_numbers_given_and_no_doubt(tmp_path: Path, run: Run) -> None:
    path = tmp_path / "robot.toml"
    assert (
        run("new", "-o", path, "--name", 'a "quoted\\" name', *options(NUMBERS)).out == f"Written to {path}\n"
    )
    robot = ss.Robot.from_toml(path)
    assert robot.name == 'a "quoted\\" name'
    assert np.linalg.norm(robot.b, axis=-1) == pytest.approx(0.6, rel=1e-15)
    assert np.linalg.norm(robot.p, axis=-1) == pytest.approx(0.3, rel=1e-15)
    assert (robot.M, robot.home_position.tolist()) == (40.0, [0.0, 0.0, 0.7])
    assert robot.m_d + robot.m_u == pytest.approx(4.0)
    assert np.ptp(robot.length_limits, axis=-1) == pytest.approx(0.3)
    assert run("check", path).err == ""


def test_a_stroke_in_meters_among_millimeters_is_doubted_by_new_and_check(tmp_path: Path, run: Run) -> None:
    path = tmp_path / "robot.toml"
    large = {name: 1000.0 * value if value < 1.0 else value for name, value in NUMBERS.items()}
    command = ("new", "-o", path, "--length-unit", "mm", *options({**large, "--stroke": 0.3}))
    for told in (run(*command), run("check", path)):
        (line,) = told.err.splitlines()
        assert "stroke or limits given in m in a file of another unit of length [length-limits]" in line


def test_z_may_point_down(tmp_path: Path, run: Run) -> None:
    up, down = tmp_path / "up.toml", tmp_path / "down.toml"
    assert main(["new", "-o", str(up), *options(NUMBERS)]) == 0
    assert main(["new", "-o", str(down), "--z-down", *options(NUMBERS)]) == 0
    assert "gravity = [0.0, 0.0, 9.81]      # base frame: z is down\n" in down.read_text()
    assert run("check", down).err == ""
    robots = [ss.Robot.from_toml(path) for path in (up, down)]
    np.testing.assert_allclose(robots[0].home_position, -robots[1].home_position)
    np.testing.assert_allclose(robots[0].g, -robots[1].g)


def test_numbers_that_no_machine_has_are_named_by_their_option(tmp_path: Path, fails: Fails) -> None:
    path = tmp_path / "robot.toml"
    for name, value, told in (
        ("--stroke", 1.0, "stroke: expected a number below 0.5433 m, since a leg is longer than its stroke"),
        ("--base-angle", 130.0, "base_angle: expected 0 to 120 degrees, got 130.0"),
        ("--height", -1.0, "argument --height: expected a number > 0, got '-1.0'"),
    ):
        assert told in fails("new", "-o", str(path), *options({**NUMBERS, name: value}))
    assert not path.exists()


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_what_is_not_given_is_asked_for_on_a_terminal(
    tmp_path: Path, run: Run, fails: Fails, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "robot.toml"
    given = {"--base-radius": 600.0, "--leg-mass": 4.0}
    monkeypatch.setattr(sys, "stdin", Terminal("300\n700 mm\n700\n40\n300\n"))
    asked = run("new", "-o", path, "--length-unit", "mm", *options(given)).err
    assert asked.count("radius of the circle of the platform joints (mm): ") == 1
    assert asked.count("at home (mm): ") == 2
    assert "expected a number > 0, got '700 mm'" in asked
    assert ss.Robot.from_toml(path).home_position[2] == 0.7
    monkeypatch.setattr(sys, "stdin", Terminal("300\n"))
    assert run("new", "-o", tmp_path / "other.toml", *options(given), code=2).err.endswith(
        "height: missing; standard input has ended\n"
    )
    monkeypatch.setattr(sys, "stdin", io.StringIO())
    line = fails("new", "-o", str(path))
    assert "base_radius: missing; not a terminal, use --base-radius --platform-radius --height" in line


def test_robots_are_listed_shown_and_copied(tmp_path: Path, run: Run, fails: Fails) -> None:
    listed = run("robots").out
    assert [line.split()[0] for line in listed.splitlines()[2:]] == list(robots.NAMES)
    assert run("robots", "--show", "unal").out == robots.text("unal")
    path = tmp_path / "mine.toml"
    for _ in range(2):
        run("robots", "--show", "tsai2000", "-o", path)
    assert path.read_text() == robots.text("tsai2000")
    assert "use --force" in fails("robots", "--show", "unal", "-o", str(path))
    assert "add --show NAME" in fails("robots", "-o", str(path))
    assert '--show: expected "dasgupta1998"' in fails("robots", "--show", "tsai")
    assert json.loads(run("robots", "--json").out)["robots"]["unal"]["platform_mass_kg"] == 2.146


@pytest.mark.slow
def test_check_draws_the_machine_into_a_folder(tmp_path: Path, run: Run) -> None:
    file = Path(robots.__file__).parent / "tsai2000.toml"
    text = run("check", file, "-o", tmp_path / "out").out
    assert {path.name for path in (tmp_path / "out").glob("[!.]*")} == {
        "machine.png",
        "report.json",
        "report.txt",
    }
    assert (tmp_path / "out" / "machine.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "out" / "report.txt").read_text() in text
    assert main(["check", str(file), "-o", str(tmp_path / "bare"), "--no-plots"]) == 0
    assert not (tmp_path / "bare" / "machine.png").exists()
