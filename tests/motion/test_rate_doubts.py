"""Rates in a log that are of another motion than its poses or lengths are warned of, and no others."""

import re
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from command_line import rejects
from log_files import write
from machines import Array

import stewart_sym as ss
from stewart_sym.motion.log_reader import read_csv, read_log
from stewart_sym.motion.rotation import motion_about_axes


def with_rates(time: Array, legs: bool = False) -> tuple[list[str], Array]:
    """Names and a table of a smooth motion with its rates."""
    angle = 2.0 * np.pi * np.outer(time, [0.3, 0.4, 0.5, 0.35, 0.45, 0.25]) + np.arange(6)
    w = 2.0 * np.pi * np.array([0.3, 0.4, 0.5, 0.35, 0.45, 0.25])
    found = 0.03 * np.array([np.sin(angle), w * np.cos(angle), -w * w * np.sin(angle)])
    if legs:
        found[0] += 0.7
        names = [f"{name}_{i}" for name in ("L", "L_dot", "L_ddot") for i in range(1, 7)]
    else:
        groups = (("t", "theta"), ("v", "theta_dot"), ("a", "theta_ddot"))
        names = [f"{name}_{axis}" for group in groups for name in group for axis in "xyz"]
    return ["time", *names], np.column_stack([time, *found])


@pytest.mark.parametrize("legs", [False, True], ids=["poses", "legs"])
@pytest.mark.parametrize(("unit", "words"), [(1e3, "ms"), (1e-3, "are rates in another unit")])
def test_rates_of_another_unit_of_time_are_told(tmp_path: Path, unit: float, words: str, legs: bool) -> None:
    names, table = with_rates(np.linspace(0.0, 2.0, 41), legs)
    table[:, 0] *= unit
    path = write(tmp_path / "odd.csv", names, table)
    said = "odd.csv: coordinates change by .* what their rates say"
    if unit > 1.0:
        rejects(rf"{said}.*; give time_unit={words}", read_log, path)
    with pytest.warns(ss.TrajectoryWarning, match=f"{said}: .*{words}"):
        read_log(path, ss.TrajectoryFormat(time_unit="s"))


@pytest.mark.parametrize(
    ("columns", "change", "words"),
    [
        (slice(7, 13), np.negative, "t_x, .*, theta_z change by -1 times what v_x, .* say: are signs opp"),
        (slice(7, 10), lambda rates: rates[:, [1, 0, 2]], "t_x, t_y do not change as v_x, v_y say"),
        (
            slice(10, 13),
            np.degrees,
            ".*theta_z change by 0.01[78] times what .*theta_dot_z say: are the latter in deg",
        ),
        (slice(13, 16), np.negative, "v_x, v_y, v_z change by -1 times what a_x, a_y, a_z say"),
    ],
    ids=["minus", "exchanged", "degrees", "accelerations"],
)
def test_rates_of_another_motion_are_warned_of(
    tmp_path: Path, columns: slice, change: Callable[[Array], Array], words: str
) -> None:
    noise = 1e-3
    names, good = with_rates(np.linspace(0.0, 4.0, 161))
    odd, scatter = good.copy(), noise * np.random.default_rng(1).normal(size=(161, 18))
    odd[:, columns] = change(odd[:, columns])
    for table in (good, odd):
        table[:, 1:] += scatter
    with warnings.catch_warnings(record=True, action="always") as caught:
        read_csv(write(tmp_path / "good.csv", names, good))
        assert not caught
        read_csv(write(tmp_path / "odd.csv", names, odd))
    assert any(re.search(f"odd.csv: {words}", str(each.message)) for each in caught)


@pytest.mark.parametrize("order", ["zyx", "xyz"])
@pytest.mark.parametrize("frame", ["base", "platform"])
def test_an_angular_velocity_in_place_of_rates_of_angles_is_told_from_them(
    tmp_path: Path, frame: str, order: str
) -> None:
    names, table = with_rates(np.linspace(0.0, 4.0, 401))
    angles = slice(4, 7), slice(10, 13), slice(16, 19)
    for columns in angles:
        table[:, columns] *= 5.0
    form = ss.TrajectoryFormat(euler_order=order)
    path = write(tmp_path / "log.csv", names, table)
    with warnings.catch_warnings(action="error"):
        read_csv(path, form)
    R, omega, alpha = motion_about_axes(*(table[:, columns] for columns in angles), order)
    turn = np.eye(3) if frame == "base" else R.swapaxes(-1, -2)
    table[:, 10:13], table[:, 16:19] = ((turn @ each[..., None])[..., 0] for each in (omega, alpha))
    expected = f"log.csv: theta_x to theta_z change as if .* were an angular velocity, {frame} frame: exp"
    with pytest.warns(ss.TrajectoryWarning, match=expected):
        read_csv(write(path, names, table), form)
