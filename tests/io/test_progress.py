"""Long work shows the share that is done: rising, from 0 to 1, and without effect on what is found."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import stewart_sym as ss
from stewart_sym.io.progress import Progress, silent
from stewart_sym.motion.log_reader import read_log

ROBOT = ss.robots.dasgupta1998()
Work = Callable[[Path, Progress], list[np.ndarray]]


def reading(folder: Path, progress: Progress, last: str = "") -> list[np.ndarray]:
    """A log whose last row may be such as is read cell by cell."""
    path, time = folder / "log.csv", np.arange(10_000) / 1e3
    waves = np.repeat([np.sin(time), np.cos(time), -np.sin(time)], 6, axis=0).T
    names = ["t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z"]
    header = ["time", *names, *(f"{rate}_{axis}" for rate in ("v", "theta_dot") for axis in "xyz")]
    header += [f"{rate}_{axis}" for rate in ("a", "theta_ddot") for axis in "xyz"]
    rows = [",".join([f"{t:.3f}", *(f"{x:.9f}" for x in each)]) for t, each in zip(time, waves, strict=True)]
    path.write_text("\n".join([",".join(header), last + rows[0], *rows[1:], ""]))
    return [read_log(path, smoothing=ss.SmoothingOptions(enabled=False), progress=progress).coordinates]


def reading_cells(folder: Path, progress: Progress) -> list[np.ndarray]:
    return reading(folder, progress, last="\n")


def finding_poses(_: Path, progress: Progress) -> list[np.ndarray]:
    path = ss.PAPER_PATHS["I"].path
    time = np.linspace(0.0, path.tau_f, 700)
    legs = ss.inverse_kinematics(ROBOT, path.sample(time))
    found = ss.motion_from_lengths(ROBOT, legs.L, legs.L_dot, legs.L_ddot, time=time, progress=progress)
    return [found.R, found.t]


def finding_poses_at_rest(_: Path, progress: Progress) -> list[np.ndarray]:
    legs = ss.inverse_kinematics(ROBOT, ss.PAPER_PATHS["I"].path.sample(np.linspace(0.0, 6.0, 30)))
    return [ss.motion_from_lengths(ROBOT, legs.L, 0.0 * legs.L, progress=progress).t]


def exciting(_: Path, progress: Progress) -> list[np.ndarray]:
    found = ss.choose_excitation(ROBOT, harmonics=2, samples=40, candidates=3, progress=progress)
    return [found.path.sine, found.path.cosine]


def timing(_: Path, progress: Progress) -> list[np.ndarray]:
    limits = ss.PathLimits(speed=1.0, jerk=20.0)
    timed = ss.parameterize_path(
        ROBOT, ss.PAPER_PATHS["I"].path.sample, (1.0, 5.0), limits, grid_size=10, progress=progress
    )
    return [timed.sample(np.linspace(0.0, timed.duration, 9)).t]


@pytest.mark.parametrize(
    "work", [reading, reading_cells, finding_poses, finding_poses_at_rest, exciting, timing]
)
def test_shares_rise_and_change_nothing(work: Work, tmp_path: Path) -> None:
    shown: list[tuple[str, float]] = []

    def progress(text: str, share: float | None = None) -> None:
        if share is not None:
            shown.append((text, share))

    found = work(tmp_path, progress)
    shares = [share for _, share in shown]
    assert len(shares) >= 2
    assert len({text for text, _ in shown}) == 1
    assert shares == sorted(shares)
    assert 0.0 <= shares[0] < shares[-1] <= 1.0
    for one, other in zip(found, work(tmp_path, silent), strict=True):
        np.testing.assert_array_equal(one, other)
