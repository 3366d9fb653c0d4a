"""The chart of speed against accuracy: every point is named and readable, and the front is the front."""

import csv
import io
import itertools
import math
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from command_line import rejects
from cost_figures import LEVELS, PEAKS, chart, errors, made_up
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from stewart_sym.studies.accuracy import cost_plot
from stewart_sym.studies.accuracy.cost import entry_of, worst
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


def test_all_points_are_named_inside_the_picture_and_no_names_overlap(picture: Figure) -> None:
    found = made_up()
    for axes, panel in zip(picture.axes, (TOTAL, ROUNDING), strict=True):
        names = boxes(axes)
        assert names.keys() == {p.name for p in points(found) if p.panel == panel and not p.beside}
        assert not overlapping(names)
        frame = axes.get_window_extent()
        assert all(frame.x0 <= box.x0 and box.x1 <= frame.x1 for box in names.values())
        assert all(frame.y0 <= box.y0 and box.y1 <= frame.y1 for box in names.values())


def test_no_name_covers_a_point(picture: Figure) -> None:
    for axes in picture.axes:
        names = boxes(axes)
        for line in axes.get_lines():
            if line.get_marker() not in ("None", None, ""):
                for x, y in axes.transData.transform(line.get_xydata()):
                    assert not any(box.contains(x, y) for box in names.values())


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


@pytest.mark.usefixtures("unnamed")
def test_the_legend_names_no_color_without_points() -> None:
    def named(drawn: Figure) -> set[str]:
        return {text.get_text() for text in drawn.legends[0].get_texts()}

    made = made_up()
    exact = [each for each in made["candidates"] if each["formulation"] == "exact"]
    assert named(figure(made)) - named(figure(made | {"candidates": exact})) == {"paper, double"}


def test_float_kernels_are_hollow_and_may_be_on_the_front(picture: Figure) -> None:
    every = [point for point in points(made_up()) if point.panel == TOTAL]
    hollow = {
        float(line.get_xdata()[0])  # type: ignore[index, arg-type]
        for line in picture.axes[0].get_lines()
        if line.get_marker() != "None" and line.get_markerfacecolor() == "white"
    }
    assert hollow == {point.ns for point in every if point.beside}
    assert any(point.beside for point in front(every))
    assert any(not point.beside for point in front(every))


@pytest.mark.slow
@pytest.mark.usefixtures("unnamed")
def test_a_run_that_others_disturbed_says_so(picture: Figure) -> None:
    assert made_up()["taken_by_others"] is None
    assert picture.get_suptitle().endswith("machine")
    title = figure(made_up() | {"taken_by_others": 0.42, "load": 3.25}).get_suptitle()
    assert title.count("\n") == 1
    assert title.endswith("took 42 % of the cores' time, load 3.2")


def crowd(where: list[tuple[float, float]], size: tuple[float, float] = (6.0, 4.0)) -> Axes:
    picture = Figure(figsize=size, layout="constrained")
    axes = picture.subplots()
    axes.set_xlim(0, 10)
    axes.set_ylim(0, 10)
    name_points(axes, [(f"point number {i}", at, "black") for i, at in enumerate(where)], where)
    return axes


def test_names_of_points_at_one_place_do_not_overlap() -> None:
    axes = crowd([(5.0, 5.0)] * 14)
    assert [text.get_text() for text in axes.texts] == [f"point number {i}" for i in range(14)]
    assert not overlapping(boxes(axes))


def test_names_of_points_in_the_corners_stay_inside() -> None:
    axes = crowd([(0.0, 0.0), (10.0, 0.0), (0.0, 10.0), (10.0, 10.0)])
    frame = axes.get_window_extent()
    assert all(frame.x0 <= box.x0 and box.x1 <= frame.x1 for box in boxes(axes).values())


def test_places_are_the_same_on_every_run() -> None:
    where = [(float(x), float(y)) for x, y in np.random.default_rng(3).uniform(1, 9, (12, 2))]
    first, second = (crowd(where).texts for _ in range(2))
    assert [text.get_position() for text in first] == [text.get_position() for text in second]


def test_too_many_names_are_rejected() -> None:
    rejects("not enough room in the plot", crowd, [(5.0, 5.0)] * 40, (2.0, 1.5))


def test_pictures_are_written_as_png_and_svg(tmp_path: Path, picture: Figure) -> None:
    draw(Picture(lambda: picture, SMALL, ("png", "svg")), tmp_path / "all")
    pixels = matplotlib.image.imread(tmp_path / "all.png")
    assert pixels.shape[1] > 1500
    assert pixels.std() > 0.05
    drawing = (tmp_path / "all.svg").read_text()
    assert all(f">{point.name}<" in drawing for point in points(made_up()) if not point.beside)
