"""Long work shows the share that is done: rising, from 0 to 1, and without effect on what is found."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import stewart_sym as ss
from stewart_sym.io.progress import Progress, silent

ROBOT = ss.robots.dasgupta1998()
Work = Callable[[Path, Progress], list[np.ndarray]]


def finding_poses(_: Path, progress: Progress) -> list[np.ndarray]:
    path = ss.PAPER_PATHS["I"].path
    time = np.linspace(0.0, path.tau_f, 700)
    legs = ss.inverse_kinematics(ROBOT, path.sample(time))
    found = ss.motion_from_lengths(ROBOT, legs.L, legs.L_dot, legs.L_ddot, time=time, progress=progress)
    return [found.R, found.t]


@pytest.mark.slow
@pytest.mark.parametrize("work", [finding_poses])
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
