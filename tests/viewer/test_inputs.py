"""What ``view`` says of a motion beyond limits, and of a file in another's place."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from browser import Opened
from command_line import fails_in_one_line
from machines import dasgupta
from playwright.sync_api import Browser

import stewart_sym as ss
from stewart_sym.cli.main import main


def test_a_motion_beyond_a_limit_gives_a_warning(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["view", "hexapod.toml", "I", "-o", "out.html"]) == 0
    err = capsys.readouterr().err
    assert err.startswith(
        "stewart-sym: warning: length_limits exceeded by legs 1, 3, 6: worst leg 1: 0.441606 m"
    )
    assert main(["view", "hexapod.toml", "trajectory.csv", "-o", "out.html"]) == 0
    assert capsys.readouterr().err == ""


def test_a_file_in_another_s_place_is_named(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said = fails_in_one_line(capsys, "view", "trajectory.csv", "-o", "out.html")
    assert said.endswith("trajectory.csv: expected a robot file, got a table of values, as of a CSV file")
    Path("report.json").write_text('{\n "generator": "x"\n}\n', encoding="utf-8")
    said = fails_in_one_line(capsys, "view", "hexapod.toml", "report.json", "-o", "out.html")
    assert said.endswith("report.json: expected a CSV file with a header line, got '{'")
    said = fails_in_one_line(capsys, "view", "hexapod.toml", "-o", "out.txt")
    assert said.endswith("-o out.txt: expected a file that ends in .html")
    said = fails_in_one_line(
        capsys, "forces", "hexapod.toml", "trajectory.csv", "-o", "f.csv", "--html", "out.pdf"
    )
    assert said.endswith("--html out.pdf: expected a file that ends in .html")
    said = fails_in_one_line(capsys, "view", "report.json", "-o", "out.html")
    assert said.endswith("report.json: expected a robot file, got '{'")


def test_limits_far_from_the_curves_are_said(browser: Browser, tmp_path: Path) -> None:
    limits = {"force_limit": np.full(6, 4e4), "speed_limit": np.full(6, 30.0)}
    robot = dataclasses.replace(dasgupta(), **limits)
    time = np.linspace(0.0, 2.0, 41)
    path, _ = ss.PATHS["I"]
    ss.view(robot, path.sample(time), time).save(tmp_path / "out.html")
    page = Opened(browser, tmp_path / "out.html")
    heads = page.page.locator("figcaption").all_inner_texts()
    page.close()
    assert heads[0] == "Force, N limit \u00b140000 N, outside the picture"
    assert heads[1] == "Length, mm"
    assert heads[2].endswith("limit \u00b13e+4 mm/s, outside the picture") or "\u00b130000 mm/s" in heads[2]
