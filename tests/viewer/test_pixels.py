"""What is drawn is what was computed: legs have the colors of their forces and end where they project."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from browser import DOTS, Opened, color, pixels
from machines import dasgupta
from numpy.typing import NDArray
from playwright.sync_api import Browser

from stewart_sym.robot.robot import Robot
from stewart_sym.viewer.motion_history import MotionHistory
from stewart_sym.viewer.view import view

Array = NDArray[np.float64]

pytestmark = pytest.mark.slow

INSTANTS = 5
NEAR = 6.0
"""Pixels from another leg within which a pixel may be its."""
STILL = "viewer.clock.pause(); for (const id of ['labels', 'tip']) document.getElementById(id).hidden = true;"
LINES = "for (const id of ['frames', 'ribbon', 'skeleton']) document.getElementById(id).click();"


@pytest.fixture(scope="module")
def shown() -> tuple[Robot, MotionHistory, str]:
    robot = dasgupta()
    found = view(robot, "I")
    return robot, found.history, found.html


@pytest.fixture(scope="module")
def opened(
    browser: Browser, shown: tuple[Robot, MotionHistory, str], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Opened]:
    path = tmp_path_factory.mktemp("page") / "I.html"
    path.write_text(shown[2], encoding="utf-8")
    found = Opened(browser, path)
    found.do(STILL)
    yield found
    found.close()


def eye(opened: Opened, which: int = 0) -> tuple[dict[str, Any], dict[str, float]]:
    camera = opened.do("const { eye, target, up } = viewer.camera; return { eye, target, up };")
    return camera, opened.do(f"return viewer.pictures()[{which}];")


def ends(robot: Robot, history: MotionHistory, i: int) -> Array:
    """Base and platform points, (6, 2, 3)."""
    tips = robot.p @ history.motion.R[i].T + history.motion.t[i]
    return np.stack([robot.b, tips], axis=1)


def projected(opened: Opened, robot: Robot, history: MotionHistory, i: int, which: int = 0) -> Array:
    """Their pixels, (6, 2, 2)."""
    return pixels(ends(robot, history, i).reshape(-1, 3), *eye(opened, which)).reshape(6, 2, 2)


def off(points: Array, line: Array) -> Array:
    """Distances of points, (n, 2), from a line between two, (2, 2), pixels."""
    way = line[1] - line[0]
    share = np.clip((points - line[0]) @ way / (way @ way), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - line[0] - share[:, None] * way, axis=-1))


def legs_seen(
    opened: Opened, robot: Robot, history: MotionHistory
) -> Iterator[tuple[NDArray[np.int64], Array, int, Array]]:
    """At some history the picture and the projected legs; each leg, and the color of its force."""
    for i in np.linspace(0, len(history.time) - 1, INSTANTS).astype(int):
        opened.do(f"viewer.clock.seek({float(history.time[i])!r})")
        picture, lines = opened.drawn(), projected(opened, robot, history, i)
        for leg in range(6):
            yield picture, lines, leg, force_color(history, "exact", i, leg)


def force_color(history: MotionHistory, name: str, i: int, leg: int) -> Array:
    """On the scale of the largest force of the motion."""
    scale = max(float(np.abs(F).max()) for F in history.forces.values())
    return color(float(history.forces[name][i, leg]), scale)


def test_pixels_of_lines_have_the_colors_of_the_forces_and_end_at_the_joints(
    opened: Opened, shown: tuple[Robot, MotionHistory, str]
) -> None:
    opened.do(LINES)
    for picture, lines, leg, wanted in legs_seen(opened, *shown[:2]):
        along = lines[leg, 0] + np.linspace(0.03, 0.97, 60)[:, None] * (lines[leg, 1] - lines[leg, 0])
        free = np.all([off(along, lines[other]) > NEAR for other in range(6) if other != leg], axis=0)
        seen = picture[tuple(np.floor(DOTS * along[free]).astype(int).T[::-1])]
        assert free.sum() > 15
        assert np.abs(seen - wanted).max() <= 2, leg
        assert ends_off(picture, wanted, lines, leg) <= 1.0, leg
    opened.do(LINES)


def of_color(picture: NDArray[np.int64], wanted: Array) -> Array:
    """Middles of the dots of a color, pixels, (n, 2)."""
    rows, columns = np.nonzero(np.abs(picture - wanted).max(axis=-1) <= 2)
    return (np.stack([columns, rows], axis=-1) + 0.5) / DOTS


def ends_off(picture: NDArray[np.int64], wanted: Array, lines: Array, leg: int) -> float:
    """How far from a leg's projected ends its color ends, pixels; ends beside other legs don't count."""
    line = lines[leg]
    way = (line[1] - line[0]) / np.linalg.norm(line[1] - line[0])
    middles = of_color(picture, wanted)
    away = np.abs((middles - line[0]) @ [-way[1], way[0]])
    at = (middles[(away < 1.5) & (off(middles, line) < NEAR)] - line[0]) @ way
    # Half a dot from the middle of the last one to its far side.
    half = 0.5 / DOTS * np.abs(way).max()
    found = [at.min() - half, at.max() + half - np.linalg.norm(line[1] - line[0])]
    crowded = [
        any(off(end[None], lines[other])[0] < NEAR for other in range(6) if other != leg) for end in line
    ]
    return max(abs(float(each)) for each, skip in zip(found, crowded, strict=True) if not skip)
