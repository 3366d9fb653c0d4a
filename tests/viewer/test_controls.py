"""Clock, keys, slider, views and curves do what they say; nothing is asked of a network; names stay text."""

import dataclasses
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from browser import Opened
from machines import dasgupta
from playwright.sync_api import Browser

import stewart_sym as ss

pytestmark = pytest.mark.slow

HOSTILE = "</script><img src=x onerror=alert(1)> \"quoted' & <b>@data@</b> \u05d0\u05d1"
BIDI = "\u202egnp.exe\u2066 <i>"


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Hostile names of a machine and of a path that crosses a singular pose; the folder can't be written."""
    robot = dataclasses.replace(dasgupta(), name=HOSTILE)
    shown = ss.view(robot, "III")
    shown = dataclasses.replace(shown, history=dataclasses.replace(shown.history, name=BIDI))
    folder = tmp_path_factory.mktemp("read-only")
    shown.save(folder / "III.html")
    (folder / "III.html").chmod(0o444)
    folder.chmod(0o555)
    return folder / "III.html"


@pytest.fixture(scope="module")
def shared(browser: Browser, path: Path) -> Iterator[Opened]:
    found = Opened(browser, path)
    yield found
    found.close()


@pytest.fixture
def opened(shared: Opened) -> Opened:
    """The page as it is at first."""
    shared.do("viewer.endTwist(); viewer.clock.pause(); viewer.clock.seek(0); viewer.camera.reset()")
    return shared


def index(opened: Opened) -> int:
    return int(opened.do("return viewer.clock.index"))


def test_the_page_makes_no_request_and_says_nothing(opened: Opened, path: Path) -> None:
    opened.drawn()
    assert opened.requests == [path.as_uri()]
    assert opened.said == []
    policy = opened.page.locator("meta[http-equiv]").get_attribute("content") or ""
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy


def test_the_policy_blocks_what_is_not_the_page_s_own(opened: Opened) -> None:
    ran = opened.do(
        "const bad = document.createElement('script'); bad.textContent = 'window.bad = 1';"
        "document.body.append(bad); bad.remove(); return window.bad === undefined"
    )
    assert ran
    asked = opened.do("return fetch('https://example.org').then(() => 'sent', () => 'blocked')")
    assert asked == "blocked"
    opened.said.clear()


def test_a_hostile_name_is_shown_as_text(opened: Opened) -> None:
    assert opened.page.locator("h1").inner_text() == HOSTILE
    assert opened.page.locator("header p").inner_text() == "[U+202E]gnp.exe[U+2066] <i>"
    assert opened.page.locator("img, b:not(#condition), header i").count() == 0
    assert opened.page.title() == f"{HOSTILE}: [U+202E]gnp.exe[U+2066] <i>"


def test_play_pause_and_step(opened: Opened) -> None:
    opened.page.click("#play")
    opened.page.wait_for_function("() => viewer.clock.index > 3")
    assert opened.page.inner_text("#play") == "Pause"
    opened.page.click("#play")
    at = index(opened)
    opened.drawn()
    assert index(opened) == at
    opened.page.click("#forward")
    opened.page.click("#forward")
    opened.page.click("#back")
    assert index(opened) == at + 1


def test_the_slider_moves_by_samples_and_is_read_out(opened: Opened) -> None:
    slider = opened.page.locator("#time")
    slider.focus()
    for key, expected in (("ArrowRight", 1), ("PageUp", 11), ("ArrowLeft", 10), ("End", 600), ("Home", 0)):
        opened.page.keyboard.press(key)
        assert index(opened) == expected, key
    slider.evaluate("(each) => { each.value = '3'; each.dispatchEvent(new Event('input')) }")
    assert index(opened) == 300
    assert (slider.get_attribute("aria-valuetext") or "").startswith("3.000 s, condition number ")
    assert opened.page.inner_text("#said").startswith("3.000 s")


def test_keys_of_the_page_and_of_the_picture(opened: Opened) -> None:
    opened.page.locator("#scene").focus()
    opened.drawn()
    before = opened.do("return viewer.camera.eye")
    opened.page.keyboard.press("ArrowRight")
    opened.page.keyboard.press("ArrowUp")
    turned = opened.do("return viewer.camera.eye")
    assert not np.allclose(before, turned)
    opened.page.keyboard.press("+")
    assert opened.do("return viewer.camera.untouched") is False
    opened.page.keyboard.press("0")
    opened.drawn()
    assert np.allclose(opened.do("return viewer.camera.eye"), before)
    opened.page.keyboard.press("End")
    assert index(opened) == 600
    opened.page.keyboard.press("s")
    assert opened.page.locator("#skeleton").is_checked()
    opened.page.keyboard.press("s")
    opened.page.keyboard.press(" ")
    assert opened.do("return viewer.clock.playing") is True


def test_values_are_shown_under_the_pointer_and_the_curve_sets_the_clock(opened: Opened) -> None:
    plot = opened.page.locator("#lengths .plot")
    plot.scroll_into_view_if_needed()
    box = plot.bounding_box()
    assert box is not None
    opened.page.mouse.move(box["x"] + 64 + 0.5 * (box["width"] - 76), box["y"] + 60)
    lines = opened.page.locator("#lengths .tip").inner_text().splitlines()
    assert lines[0] == "3.000 s"
    robot = dasgupta()
    found = ss.view(robot, "III").history
    shown = [float(re.findall(r"\u2002([\d.]+) m", line)[0]) for line in lines[1:]]
    assert np.allclose(shown, found.L[300], rtol=1e-5)
    opened.page.mouse.down()
    opened.page.mouse.up()
    assert index(opened) == 300
    opened.page.mouse.move(1, 1)


def test_singular_instants_are_marked_and_their_twist_moves_no_leg(opened: Opened) -> None:
    (event,) = opened.do("return viewer.motion.events.map(({ time, singular }) => ({ time, singular }))")
    assert event["singular"]
    assert event["time"] == pytest.approx(3.67050411, abs=1e-8)
    mark = opened.page.locator("#marks .singular")
    assert float((mark.get_attribute("style") or "").split(":")[1].strip(" %;")) == pytest.approx(
        100 * event["time"] / 6.0, abs=1e-3
    )
    opened.page.click("#events button")
    opened.drawn()
    assert opened.do("return viewer.state.twist.share") == pytest.approx(
        opened.do("return viewer.page.machine.swing")
    )
    assert index(opened) == 367
    opened.page.keyboard.press("Escape")
    opened.page.click("#events button")
    assert opened.do("return viewer.state.twist") is None


def test_axe_finds_no_violation(browser: Browser, path: Path) -> None:
    scheme = "light"
    found = Opened(browser, path, color_scheme=scheme, bypass_csp=True)
    found.do("for (const each of document.querySelectorAll('details')) each.open = true")
    assert Axe().run(found.page).response["violations"] == []
    found.close()


def test_twenty_thousand_samples_keep_every_number_and_every_peak(browser: Browser, tmp_path: Path) -> None:
    robot, (path, _) = dasgupta(), ss.PAPER_PATHS["I"]
    time = np.linspace(0.0, path.tau_f, 20_000)
    shown = ss.view(robot, path.sample(time), time)
    peak, leg = 13_415, 2
    F = shown.history.forces["exact"].copy()
    F[peak, leg] = 5e3
    history = dataclasses.replace(shown.history, forces={"exact": F})
    dataclasses.replace(shown, history=history).save(tmp_path / "long.html")
    page = Opened(browser, tmp_path / "long.html")
    assert page.do("return viewer.motion.count") == 20_000
    assert np.array_equal(page.do("return [...viewer.motion.columns.F_exact]"), F.astype(np.float32).ravel())
    highest = page.do(
        "return Math.max(...viewer.panels[0].columns(viewer.panels[0].series[2]).map((e) => e.high))"
    )
    assert highest == 5e3
    assert page.do("return viewer.panels[0].columns(viewer.panels[0].series[2]).length") < 1000
    assert f"5000 N at {time[peak]:.4f} s" in page.page.locator("#peaks tbody tr").nth(leg).inner_text()
    page.close()
