"""The chart of speed against accuracy: every point is named and readable, and the front is the front."""

import csv
import io
import itertools
import math
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from chart_tables import entry_of
from command_line import rejects
from cost_figures import LEVELS, PEAKS, chart, errors, made_up
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from stewart_sym.studies.accuracy import cost_plot
from stewart_sym.studies.accuracy.cost import worst
from stewart_sym.studies.accuracy.cost_plot import ROUNDING, TOTAL, Point, csv_rows, figure, front, points
from stewart_sym.studies.common.drawing import name_points
from stewart_sym.studies.common.report import SMALL, Picture, draw


@pytest.fixture
def picture() -> Figure:
    """The chart of the figures made up."""
    return chart()


@pytest.fixture
def unnamed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Charts whose points have no names, which take long to place."""
    monkeypatch.setattr(cost_plot, "name_points", lambda *_: None)


def boxes(axes: Axes) -> dict[str, Bbox]:
    canvas = axes.get_figure()
    assert isinstance(canvas, Figure)
    renderer = FigureCanvasAgg(canvas).get_renderer()
    canvas.draw_without_rendering()  # type: ignore[no-untyped-call]
    return {text.get_text(): text.get_window_extent(renderer) for text in axes.texts}


def overlapping(found: dict[str, Bbox]) -> list[tuple[str, str]]:
    return [
        (one, other)
        for (one, box), (other, next_box) in itertools.combinations(found.items(), 2)
        if box.overlaps(next_box)
    ]


def test_points_are_the_fidelities_and_the_implementations() -> None:
    found = points(made_up())
    names = {panel: {point.name for point in found if point.panel == panel} for panel in (TOTAL, ROUNDING)}
    exact = {name.split()[1] for name, _, _ in LEVELS}
    assert names[TOTAL] == {f"{name}{end}" for name in (*exact, "paper") for end in ("", ", float")}
    kinds = {f"{kind}, {precision}" for kind in ("one pose", "batch") for precision in ("double", "float")}
    assert names[ROUNDING] == kinds | {"every output", "NumPy kernel", "vector reference"}
    (slender,) = (point for point in found if point.name == "slender")
    entry = entry_of(made_up(), "exact", "slender", "double")
    assert slender.errors == {
        motion: each["model"] + each["rounding"] for motion, each in entry["errors"].items()
    }
    assert slender.worst == worst(entry) > 0.061
    assert {point.name: point.beside for point in found if point.beside} == {
        f"{name}, float": name for name in (*exact, "paper")
    }


def test_the_front_holds_what_nothing_beats() -> None:
    rng = np.random.default_rng(1)
    given = [
        Point(TOTAL, str(i), float(ns), {"I": float(error)}, "black")
        for i, (ns, error) in enumerate(rng.uniform(1, 9, (40, 2)).round())
    ]
    best = front(given)
    beaten = [
        any(
            (other.ns <= point.ns and other.worst < point.worst)
            or (other.ns < point.ns and other.worst <= point.worst)
            for other in given
        )
        for point in given
    ]
    expected = {(p.ns, p.worst) for p, lost in zip(given, beaten, strict=True) if not lost}
    assert {(point.ns, point.worst) for point in best} == expected
    assert [point.ns for point in best] == sorted({point.ns for point in best})


def test_rows_hold_every_point_and_motion_with_all_digits() -> None:
    found = made_up()
    rows = list(csv.DictReader(io.StringIO(csv_rows(found))))
    assert len(rows) == 3 * len(points(found))
    for row in rows:
        (point,) = (p for p in points(found) if (p.panel, p.name) == (row["error"], row["name"]))
        assert float(row["ns"]) == point.ns
        assert float(row["largest"]) == point.errors[row["motion"]]
    assert {row["name"] for row in rows if row["pareto"] == "1"} >= {
        "general",
        "frictionless, float",
        "batch, float",
    }


@pytest.mark.usefixtures("unnamed")
def test_errors_of_zero_have_a_band_below_all_others() -> None:
    found = made_up()
    no_error = {"errors": dict.fromkeys(PEAKS, errors(0.0, 0.0, 0.0))}
    entries = [e | no_error if worst(e, "model") == 0.0 else e for e in found["candidates"]]
    axes = figure(found | {"candidates": entries}).axes[0]
    labels = dict(zip(axes.get_yticks(), (t.get_text() for t in axes.get_yticklabels()), strict=True))
    none = next(y for y, text in labels.items() if text == "none")
    assert none == min(labels)
    assert none < 0.04 * 1.3e-5 / 3
    assert any(none in line.get_ydata() for line in axes.get_lines())


@pytest.mark.usefixtures("unnamed")
def test_points_without_an_answer_are_drawn_above_all_others() -> None:
    found = made_up()
    unsolvable = [
        e | {"errors": {"I": errors(0.0, 0.0, math.inf if e["precision"] == "float" else 1e-15)}}
        for e in found["candidates"]
    ]
    given = found | {"candidates": unsolvable, "implementations": []}
    left, right = ([text.get_text() for text in axes.get_yticklabels()] for axes in figure(given).axes)
    assert left[-1] == right[-1] == "unsolvable"


def crowd(where: list[tuple[float, float]], size: tuple[float, float] = (6.0, 4.0)) -> Axes:
    picture = Figure(figsize=size, layout="constrained")
    axes = picture.subplots()
    axes.set_xlim(0, 10)
    axes.set_ylim(0, 10)
    name_points(axes, [(f"point number {i}", at, "black") for i, at in enumerate(where)], where)
    return axes


@pytest.mark.slow
def test_names_of_points_at_one_place_do_not_overlap() -> None:
    axes = crowd([(5.0, 5.0)] * 14)
    assert [text.get_text() for text in axes.texts] == [f"point number {i}" for i in range(14)]
    assert not overlapping(boxes(axes))


@pytest.mark.slow
def test_too_many_names_are_rejected() -> None:
    rejects("not enough room in the plot", crowd, [(5.0, 5.0)] * 40, (2.0, 1.5))


@pytest.mark.slow
def test_pictures_are_written_as_png_and_svg(tmp_path: Path, picture: Figure) -> None:
    draw(Picture(lambda: picture, SMALL, ("png", "svg")), tmp_path / "all")
    pixels = matplotlib.image.imread(tmp_path / "all.png")
    assert pixels.shape[1] > 1500
    assert pixels.std() > 0.05
    drawing = (tmp_path / "all.svg").read_text()
    assert all(f">{point.name}<" in drawing for point in points(made_up()) if not point.beside)
