"""Pictures can be read: legends within the figure, numbers of logarithmic axes, names as they are said."""

import dataclasses
import functools
import itertools
import re
from collections.abc import Callable

import numpy as np
import pytest
from cost_figures import chart
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from matplotlib.text import Text
from mpl_toolkits.mplot3d import Axes3D, proj3d
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies.common.drawing import log_numbers
from stewart_sym.studies.design import workspace_report
from stewart_sym.studies.reports import machine_plot, run, singularities

Array = NDArray[np.float64]


@functools.cache
def _run() -> Figure:
    start = ss.PAPER_PATHS["I"].path.sample([3.0])[0]
    law = ss.LegSprings.in_equilibrium(dasgupta1998(), start, stiffness=5e4)
    return run.figure(ss.simulate(dasgupta1998(), start, law, duration=0.05), law)


def _path() -> Figure:
    path = ss.PAPER_PATHS["I"].path
    found = singularities.examine(dasgupta1998(), "I", path.sample, path.breakpoints())
    return singularities.path_figure(found, singularities.curves(found))


PICTURES: dict[str, Callable[[], Figure]] = {
    "chart": chart,
    "run": _run,
    "path": _path,
}


@pytest.fixture(scope="module", params=list(PICTURES))
def picture(request: pytest.FixtureRequest) -> Figure:
    found = PICTURES[request.param]()
    FigureCanvasAgg(found)
    found.draw_without_rendering()  # type: ignore[no-untyped-call]
    return found


def _inside(figure: Figure) -> bool:
    boxes = [legend.get_window_extent() for legend in figure.findobj(Legend)]
    return all(
        0.0 <= box.x0 and box.x1 <= figure.bbox.x1 and 0.0 <= box.y0 and box.y1 <= figure.bbox.y1
        for box in boxes
    )


def _numbers(axis: Axis) -> list[Text]:
    """Numbers beside an axis, as far as they are seen."""
    low, high = sorted(axis.get_view_interval())
    ticks = [*axis.get_major_ticks(), *axis.get_minor_ticks()]
    labels = [tick.label1 for tick in ticks if low <= tick.get_loc() <= high]
    return [label for label in labels if label.get_visible() and label.get_text()]


def test_legends_lie_within_the_figure(picture: Figure) -> None:
    assert _inside(picture)


def test_logarithmic_axes_have_powers_of_ten_or_plain_numbers_that_do_not_overlap(picture: Figure) -> None:
    for axes in picture.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if axis.get_scale() != "log":
                continue
            labels = _numbers(axis)
            assert len(labels) >= 2
            for label in labels:
                text = label.get_text()
                assert text in ("none", "unsolvable") or re.fullmatch(
                    r"[\d.,]+|\$\\mathdefault\{10\^\{.?\d+\}\}\$|\$10\^\{-?\d+\}\$", text
                ), text
            boxes = sorted((label.get_window_extent() for label in labels), key=lambda box: (box.x0, box.y0))
            assert not any(one.overlaps(other) for one, other in itertools.pairwise(boxes))


def test_each_curve_of_a_run_fills_its_panel_whatever_the_pose_that_it_starts_from() -> None:
    for axes in _run().axes:
        curves = np.array([line.get_ydata() for line in axes.get_lines()], dtype=float)
        if "since start" in axes.get_ylabel():
            assert (curves[:, 0] == 0.0).all()
            assert np.ptp(curves, axis=1).max() > 0.3 * np.ptp(axes.get_ylim())


def test_the_energies_of_a_run_are_all_shown_and_their_sum_is_kept() -> None:
    (axes,) = (axes for axes in _run().axes if axes.get_ylabel() == "energy since start, J")
    curves = {line.get_label(): np.asarray(line.get_ydata(), dtype=float) for line in axes.get_lines()}
    assert list(curves) == ["kinetic", "potential", "springs", "sum"]
    assert np.abs(curves["sum"]).max() < 1e-2 * np.abs(curves["springs"]).max()
    assert any(axes.get_ylabel() == "kinetic energy, J" for axes in _run().axes)


@pytest.fixture
def as_it_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Machines with names of points where they come, which takes long to make better."""
    monkeypatch.setattr(machine_plot, "name_points", lambda *_, **__: None)


@pytest.mark.usefixtures("as_it_comes")
@pytest.mark.parametrize("name", [r"$\frac{$", r"$x$", r"5 \$ and $$", "$"])
def test_a_machine_s_name_is_drawn_as_written(name: str) -> None:
    robot = dataclasses.replace(dasgupta1998(), name=name)
    figure = machine_plot.figure(robot, home_pose(robot))
    figure.canvas.draw()
    # Matplotlib draws a text that is no formula without the backslashes before its dollar signs.
    title = figure.axes[1].title
    drawn, formula = title._preprocess_math(title.get_text())  # type: ignore[attr-defined]
    assert drawn.startswith(f"{name}: home pose")
    assert not formula


@pytest.mark.parametrize(
    ("low", "high"), [(3.41, 3.43), (2.0, 8.0), (0.3, 4.0), (1e-4, 1e7), (570.0, 1450.0)]
)
def test_any_logarithmic_axis_has_two_numbers_or_more(low: float, high: float) -> None:
    figure = Figure()
    axes = figure.subplots()
    axes.semilogy([low, high])
    log_numbers(axes.yaxis)
    figure.draw_without_rendering()  # type: ignore[no-untyped-call]
    texts = [label.get_text() for label in _numbers(axes.yaxis)]
    assert len(texts) >= 2
    assert not [text for text in texts if "times" in text]
    assert axes.get_yscale() == ("linear" if high < 10.0 * low else "log")


# Turned together with its base frame, a machine stands as before.
HALF, THIRD = np.diag([1.0, -1.0, -1.0]), np.roll(np.eye(3), 1, axis=0)
TURNS = {"z": np.eye(3), "-z": HALF, "-x": THIRD @ HALF, "y": THIRD @ THIRD}


def _turned(name: str, Q: Array) -> ss.Robot:
    robot = ss.robots.load(name)
    vectors = {each: getattr(robot, each) @ Q for each in ("g", "R_0", "b", "p", "k", "tool")}
    return dataclasses.replace(
        robot, **vectors, home_position=home_pose(robot).t @ Q, I_p=Q.T @ robot.I_p @ Q
    )


def _at_home(robot: ss.Robot) -> Figure:
    return machine_plot.figure(robot, home_pose(robot))


def _in_space(figure: Figure, laid_out: bool = True) -> Axes3D:
    if laid_out:
        figure.draw_without_rendering()  # type: ignore[no-untyped-call]
    (found,) = (axes for axes in figure.axes if isinstance(axes, Axes3D))
    return found


@pytest.mark.usefixtures("as_it_comes")
@pytest.mark.parametrize(("upright", "stands"), [("-x", True), ("-z", True), ("y", False)])
def test_a_machine_stands_or_hangs_as_gravity_says(upright: str, stands: bool) -> None:
    robot = _turned("unal", TURNS[upright])
    axes = _in_space(_at_home(robot if stands else dataclasses.replace(robot, g=-robot.g)), laid_out=False)
    base, platform = (
        proj3d.proj_transform(*at.mean(axis=0), axes.get_proj())[1]
        for at in (robot.b, robot.p + home_pose(robot).t)
    )
    assert (platform > base) == stands


@pytest.mark.usefixtures("as_it_comes")
@pytest.mark.parametrize(
    ("name", "upright"),
    [("unal", "-z"), ("rubin_camera", "z"), ("rubin_camera", "y"), ("dasgupta1998", "-x")],
)
def test_numbers_and_names_of_a_machine_s_axes_are_seen_whole(name: str, upright: str) -> None:
    _need_whole(_in_space(_at_home(_turned(name, TURNS[upright]))))


def _need_whole(axes: Axes3D) -> None:
    """Each edge has numbers; they and its name lie on the page, apart from all others."""
    sides = (axes.xaxis, axes.yaxis, axes.zaxis)
    assert all(len(_numbers(side)) >= 2 for side in sides)
    boxes = [text.get_window_extent() for side in sides for text in (side.label, *_numbers(side))]
    page = axes.figure.canvas.figure.bbox
    assert all(page.count_contains(box.corners()) == 4 for box in boxes)
    assert not any(one.overlaps(other) for one, other in itertools.combinations(boxes, 2))


@pytest.mark.parametrize("upright", ["z", "-z"])
def test_planes_through_a_workspace_have_up_upwards(upright: str) -> None:
    robot = _turned("unal", TURNS[upright])
    ends = np.array([0.0, 0.1])
    planes = [
        workspace_report.Slice(axes, ends, ends, np.zeros((2, 2), dtype=np.int8), np.ones((2, 2)))
        for axes in ((0, 1), (0, 2), (1, 2))
    ]
    panels = workspace_report.figure(
        robot, ss.workspace(robot, samples=100, position_bounds=[[-0.1, 0.1]] * 3), planes
    ).axes
    for axes, down in zip(panels, [False] + [upright == "-z"] * 2, strict=False):
        assert axes.yaxis_inverted() == down
        assert ("z points down" in axes.get_ylabel()) == down
