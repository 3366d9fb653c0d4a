"""Plots of runs, machines, and workspaces: energies, names as written, and up upwards."""

import dataclasses

import numpy as np
import pytest
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d import Axes3D, proj3d
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies.design import workspace_report
from stewart_sym.studies.reports import machine_plot, run

Array = NDArray[np.float64]


def test_the_energies_of_a_run_are_all_shown_and_their_sum_is_kept() -> None:
    start = ss.PAPER_PATHS["I"].path.sample([3.0])[0]
    law = ss.LegSprings.in_equilibrium(dasgupta1998(), start, stiffness=5e4)
    panels = run.figure(ss.simulate(dasgupta1998(), start, law, duration=0.05), law).axes
    (axes,) = (axes for axes in panels if axes.get_ylabel() == "energy since start, J")
    curves = {line.get_label(): np.asarray(line.get_ydata(), dtype=float) for line in axes.get_lines()}
    assert list(curves) == ["kinetic", "potential", "springs", "sum"]
    assert np.abs(curves["sum"]).max() < 1e-2 * np.abs(curves["springs"]).max()
    assert any(axes.get_ylabel() == "kinetic energy, J" for axes in panels)


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
