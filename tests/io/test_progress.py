"""Long work shows the share that is done: rising, from 0 to 1, and without effect on what is found."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from plain_logs import read_log

import stewart_sym as ss
from stewart_sym.io.progress import Progress, silent

ROBOT = ss.robots.dasgupta1998()
Work = Callable[[Path, Progress], list[np.ndarray]]


def reading(folder: Path, progress: Progress) -> list[np.ndarray]:
    path, time = folder / "log.csv", np.arange(10_000) / 1e3
    waves = np.repeat([np.sin(time), np.cos(time), -np.sin(time)], 6, axis=0).T
    names = ["t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z"]
    header = ["time", *names, *(f"{rate}_{axis}" for rate in ("v", "theta_dot") for axis in "xyz")]
    header += [f"{rate}_{axis}" for rate in ("a", "theta_ddot") for axis in "xyz"]
    rows = [",".join([f"{t:.3f}", *(f"{x:.9f}" for x in each)]) for t, each in zip(time, waves, strict=True)]
    path.write_text("\n".join([",".join(header), *rows, ""]))
    return [read_log(path, smoothing=ss.SmoothingOptions(enabled=False), progress=progress).coordinates]


def finding_poses(_: Path, progress: Progress) -> list[np.ndarray]:
    path = ss.PAPER_PATHS["I"].path
    time = np.linspace(0.0, path.tau_f, 700)
    legs = ss.inverse_kinematics(ROBOT, path.sample(time))
    found = ss.motion_from_lengths(ROBOT, legs.L, legs.L_dot, legs.L_ddot, time=time, progress=progress)
    return [found.R, found.t]


@pytest.mark.slow
@pytest.mark.parametrize("work", [reading, finding_poses])
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
