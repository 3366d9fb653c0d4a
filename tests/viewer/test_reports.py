"""``--html``: one file with text, tables that sort, figures and the motion, that makes no request."""

import dataclasses
import shutil
from pathlib import Path

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from browser import Opened
from command_line import Fails
from machines import dasgupta
from matplotlib.figure import Figure
from playwright.sync_api import Browser

import stewart_sym as ss
from stewart_sym.cli.main import main
from stewart_sym.studies.common.html_page import html_page
from stewart_sym.studies.common.report import Picture, Report


@pytest.mark.slow
def test_forces_have_their_motion_and_a_table_that_sorts(browser: Browser, folder: Path) -> None:
    assert (
        main(["forces", "hexapod.toml", "trajectory.csv", "-o", "forces.csv", "--html", "forces.html"]) == 0
    )
    page = Opened(browser, folder / "forces.html", (1000, 800))
    assert "101 samples" in page.page.inner_text("pre")
    rows = "[...document.querySelectorAll('table.sorts tbody tr')]"
    column = f"() => {rows}.map((row) => row.cells[1].dataset.value)"
    for order, name in ((1, "ascending"), (-1, "descending")):
        page.page.locator("table.sorts th:nth-child(2) button").press("Enter")
        page.page.locator(f"th[aria-sort={name}]").wait_for()
        numbers = np.array([float(text) for text in page.page.evaluate(column)])
        assert np.all(order * np.diff(numbers) >= 0.0)
    inside = page.page.frame_locator("iframe")
    assert inside.locator("#now tbody tr").count() == 6
    inside.locator("#forward").click()
    assert page.said == []
    assert page.requests == [(folder / "forces.html").as_uri(), "about:srcdoc"][: len(page.requests)]
    page.close()


def test_size_has_its_needs_as_a_table_and_every_motion(folder: Path) -> None:
    (folder / "other").mkdir()
    shutil.copy(folder / "trajectory.csv", folder / "other")
    given = ["trajectory.csv", "other/trajectory.csv", "-o", "size", "--no-plots"]
    assert main(["size-actuators", "hexapod.toml", *given, "--html", "size.html"]) == 0
    text = (folder / "size.html").read_text(encoding="utf-8")
    needs = (folder / "size" / "needs.csv").read_text(encoding="utf-8").splitlines()
    assert f"needs.csv: {len(needs) - 1} rows" in text
    assert all(f'data-value="{number}"' in text for number in needs[4].split(",")[3:])
    assert all(f"<h2>motion {n}: trajectory.csv</h2>" in text for n in (1, 2))
    assert text.count("<iframe") == 2


@pytest.mark.slow
def test_axe_finds_nothing_in_a_report(browser: Browser, tmp_path: Path) -> None:
    figure = Picture(lambda: Figure(figsize=(5.0, 2.0)))
    lists = {"legs": [{"leg": leg, "peak_force_N": 7.0 * leg, "known": leg > 1} for leg in range(3)]}
    columns = {"time": np.arange(5.0), "F_1": np.arange(5.0)}
    report = Report(
        "words", {"run": columns}, lists, {"run": figure}, {"Path I": lambda: ss.view(dasgupta(), "I")}
    )
    (tmp_path / "report.html").write_text(html_page("title", report), encoding="utf-8")
    page = Opened(browser, tmp_path / "report.html", (1000, 800), bypass_csp=True)
    assert page.do("return document.querySelector('img').naturalWidth") > 300
    assert page.page.locator("details summary").inner_text() == "run.csv: 5 rows"
    assert [each["id"] for each in Axe().run(page.page).response["violations"]] == []
    assert page.said == []
    page.close()


@pytest.mark.slow
def test_the_run_that_simulate_wrote_is_shown_with_its_own_forces(folder: Path) -> None:
    simulate = ["simulate", "swing.toml", "-o", "swing", "--no-plots"]
    assert main([*simulate, "--html", "report.html"]) == 0
    rows = len((folder / "swing" / "run.csv").read_text(encoding="utf-8").splitlines()) - 1
    assert f"run.csv: {rows:,} rows" in (folder / "report.html").read_text(encoding="utf-8")
    assert main(["view", "hexapod.toml", "swing", "-o", "swing.html"]) == 0
    text = (folder / "swing.html").read_text(encoding="utf-8")
    assert '"forces":["run"]' in text
    assert "F_exact" not in text


def test_a_page_goes_over_no_input_and_no_other_result(folder: Path, fails: Fails) -> None:
    forces = ("forces", "hexapod.toml", "trajectory.csv", "-o", "forces.csv")
    line = fails(*forces, "--html", "hexapod.toml")
    assert "--html: expected a file name that ends in .html, got 'hexapod.toml'" in line
    line = fails(*forces, "--html", "page.html", "--json", "page.html")
    assert "two results have the same file" in line
    (folder / "mine.html").write_text("<p>mine")
    line = fails(*forces, "--html", "mine.html")
    assert "exists with other content" in line
    assert (folder / "mine.html").read_text() == "<p>mine"
    assert not (folder / "forces.csv").exists()


def test_the_example_opens_a_browser_or_says_the_path(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or len(opened) > 1)
    assert main(["view", "--example"]) == 0
    assert str(folder / "machine.html") in capsys.readouterr().err
    assert main(["view", "--example"]) == 0
    assert capsys.readouterr().err == ""
    assert opened == [(folder / "machine.html").as_uri()] * 2


def test_a_motion_without_accelerations_is_shown_without_forces() -> None:
    robot = ss.robots.dasgupta1998()
    path, _ = ss.PAPER_PATHS["III"]
    time = np.linspace(0.0, 6.0, 61)
    full = path.sample(time)
    shown = ss.view(robot, ss.Motion(R=full.R, t=full.t, omega=full.omega, v=full.v), time).history
    assert shown.forces == {}
    (event,) = shown.events
    assert event.time == pytest.approx(3.6705041, abs=1e-3)


def test_a_robot_with_rotors_is_shown_in_exact_alone(folder: Path) -> None:
    robot = dataclasses.replace(dasgupta(), drive=ss.Drive(lead=0.005, rotor_inertia=1.7e-5))
    shown = ss.view(robot, "I").history
    expected = ss.inverse_dynamics(robot, shown.motion).F
    assert list(shown.forces) == ["exact"]
    assert np.allclose(shown.forces["exact"], expected, rtol=1e-12)
    drive = "[legs.drive]\nlead = 0.005\nrotor_inertia = 1.7e-5\n"
    hexapod = folder / "hexapod.toml"
    hexapod.write_text(hexapod.read_text(encoding="utf-8") + drive, encoding="utf-8")
    given = ["hexapod.toml", "trajectory.csv"]
    assert main(["view", *given, "-o", "view.html"]) == 0
    assert main(["forces", *given, "-o", "forces.csv", "--html", "forces.html"]) == 0
    for name in ("view.html", "forces.html"):
        text = (folder / name).read_text(encoding="utf-8")
        assert "F_exact" in text
        assert "F_paper" not in text
