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
from stewart_sym.studies.reports import leg_plot, machine_plot
from stewart_sym.studies.reports import simulation_report as run

Array = NDArray[np.float64]


def test_the_energies_of_a_run_are_all_shown_and_their_sum_is_kept() -> None:
    start = ss.PAPER_PATHS["I"].path.sample([3.0])[0]
    law = ss.LegSprings.in_equilibrium(dasgupta1998(), start, stiffness=5e4)
    robot = dasgupta1998()
    panels = run.figure(robot, ss.simulate(robot, start, law, duration=0.05), law).axes
    (axes,) = (axes for axes in panels if axes.get_ylabel() == "energy since start, J")
    curves = {line.get_label(): np.asarray(line.get_ydata(), dtype=float) for line in axes.get_lines()}
    assert list(curves) == ["kinetic", "potential", "springs", "sum"]
    assert np.abs(curves["sum"]).max() < 1e-2 * np.abs(curves["springs"]).max()
    assert any(axes.get_ylabel() == "kinetic energy, J" for axes in panels)


@pytest.fixture
def as_it_comes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Machines with names of points where they come, which takes long to make better."""
    monkeypatch.setattr(machine_plot, "name_points", lambda *_, **__: None)


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


def test_each_leg_has_a_panel_of_forces_and_of_torques_with_the_limits() -> None:
    drive = ss.Drive(lead=0.01, rated_torque=0.4, torque_limit=0.8, speed_limit=[100.0] * 5 + [1e4])
    limits = {"force_limit": [30.0] * 5 + [1e6], "angle_unit": "deg", "drive": drive}
    robot = dataclasses.replace(dasgupta1998(), **limits)
    for count in (100, 20_001):
        time = np.linspace(0.0, 10.0, count)
        wave = np.sin(time)[:, None] * np.linspace(1.0, 1.5, 6)
        figure = leg_plot.leg_figure(robot, time, 20.0 * wave, (0.5 * wave, 80.0 * wave))
        assert len(figure.axes) == 12
        forces, motors = (
            [axes for axes in figure.axes if axes.get_title().startswith(name)] for name in ("leg", "motor")
        )
        places = [{float(y) for line in axes.lines[1:] for y in line.get_ydata()} for axes in forces]
        assert places == [{-30.0, 30.0}] * 5 + [set()]
        assert motors[0].get_title() == "motor 1, rated 0.4 N m, peak 0.8 N m, speed 5729.58 deg/s"
        assert [len(axes.lines) for axes in motors] == [7] * 5 + [5]
        assert len(forces[1].lines[0].get_ydata()) == count


def test_the_planned_motion_is_drawn_over_the_actual_motion_in_the_units_of_the_file() -> None:
    robot = dataclasses.replace(dasgupta1998(), length_unit="mm", angle_unit="deg")
    path, _ = ss.PAPER_PATHS["I"]
    law = ss.ComputedTorque(robot, lambda time: path.sample([time])[0], k_p=100.0, k_d=20.0)
    start = path.sample([0.0])[0]
    panels = run.figure(robot, ss.simulate(robot, start, law, duration=0.02), law).axes
    for axes, label in zip(panels, ("mm", "deg", "mm/s", "deg/s"), strict=False):
        assert axes.get_ylabel().endswith(f", {label}")
        actual, planned = (np.array([line.get_ydata() for line in axes.lines[i : i + 3]]) for i in (0, 3))
        np.testing.assert_allclose(actual, planned, atol=1e-3 * np.abs(planned).max())
    moved = 1e3 * (path.sample([0.02])[0].t - start.t)
    np.testing.assert_allclose([line.get_ydata()[-1] for line in panels[0].lines[3:]], moved, rtol=1e-6)
