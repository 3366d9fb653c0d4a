"""A robot file and trajectories as commands read them."""

import shutil
from pathlib import Path

import numpy as np
import pytest
from command_files import POSES
from robot_files import PAPERS

import stewart_sym as ss
from stewart_sym.motion.rotation import rpy_from_rotation
from stewart_sym.studies.common.text_tables import csv_lines


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """The paper's robot file."""
    target = tmp_path / "robot.toml"
    shutil.copy(PAPERS, target)
    return target


@pytest.fixture
def trajectory(tmp_path: Path) -> Path:
    """Poses of Path I without derivatives."""
    target = tmp_path / "trajectory.csv"
    time = np.linspace(0.0, 2.0, 21)
    swing = 0.5 - 0.5 * np.cos(np.pi * time / 2)
    columns = {
        "time": time,
        **dict(zip(POSES, (0.1 + 0.1 * swing, 0 * time, 0.4 + 0.1 * swing, *3 * [0.1 * swing]), strict=True)),
    }
    target.write_text("".join(csv_lines(columns)))
    return target


# singularities


@pytest.fixture
def crossing(tmp_path: Path) -> Path:
    """Path III with its rates every 0.3 s; H is singular between lines 14 and 15."""
    target = tmp_path / "crossing.csv"
    path = ss.PAPER_PATHS["III"].path
    time = path.time_grid(0.3)
    motion = path.sample(time)
    theta = rpy_from_rotation(motion.R)
    rates = np.gradient(theta, time, axis=0, edge_order=2)
    vectors = {"t": motion.t, "theta": theta, "v": motion.v, "theta_dot": rates, "a": motion.a}
    vectors["theta_ddot"] = np.zeros_like(theta)
    columns = {"time": time}
    columns |= {f"{name}_{axis}": x[:, j] for name, x in vectors.items() for j, axis in enumerate("xyz")}
    target.write_text("".join(csv_lines(columns)))
    return target
