"""Accuracy of smoothed logs, and coverage of the stated standard deviations, over random motions."""

import itertools
from pathlib import Path

import numpy as np
import pytest
from noisy_logs import KINDS, NOISES, Array, Case, case, errors, logged, read
from sweeps import FULL, share

from stewart_sym.drives.limit_status import EXCEEDED, INCONCLUSIVE_NOISE, limit_status

Run = tuple[Case, Array, Array]
# Root mean square errors of the forces (N) of the smoother of commit f70a9224, by seed, kind, and noise.
FORMER_ERRORS = Path(__file__).with_name("force_errors.csv")


@pytest.fixture(scope="module")
def sweep() -> dict[tuple[str, str], list[Run]]:
    """Return motions, errors of their forces (N), and standard deviations, by kind of motion and noise."""
    found: dict[tuple[str, str], list[Run]] = {pair: [] for pair in itertools.product(KINDS, NOISES)}
    for seed in range(share(17, 17)):
        for (kind, noise), runs in found.items():
            one = case(seed, kind, (20.0, 200.0))
            runs.append((one, *errors(one, read(one.time, logged(one, noise, seed))[0])))
    return found


def fraction(runs: list[Run], deviations: float) -> float:
    """Return the fraction of errors within a number of standard deviations."""
    return float(np.mean([np.mean(np.abs(off) < deviations * std) for _, off, std in runs]))


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_stated_deviations_cover_the_errors(sweep: dict[tuple[str, str], list[Run]], kind: str) -> None:
    runs = [run for (each, _), some in sweep.items() if each == kind for run in some]
    slack = 0.08 if FULL and kind != "trapezoids" else 0.13
    assert fraction(runs, 1.0) == pytest.approx(0.68, abs=slack)
    assert fraction(runs, 2.0) == pytest.approx(0.95, abs=slack)
    # Standard deviations do not apply near the jumps of the acceleration of trapezoids.
    assert fraction(runs, 4.0) > (0.97 if kind == "trapezoids" else 0.985)


@pytest.mark.slow
def test_forces_are_as_accurate_as_those_of_the_former_smoother(
    sweep: dict[tuple[str, str], list[Run]],
) -> None:
    former = np.loadtxt(FORMER_ERRORS, delimiter=",", skiprows=1).T
    ratios = []
    for runs, errors_before in zip(sweep.values(), former, strict=True):
        own = [float(np.sqrt(np.mean(off**2))) for _, off, _ in runs]
        ratios.append(np.array(own) / errors_before[: len(own)])
        assert np.exp(np.mean(np.log(ratios[-1]))) < (1.2 if FULL else 1.85)
    assert np.mean(np.array(ratios) > 1.5) < 0.03
    assert np.max(ratios) < 2.0


@pytest.mark.slow
def test_decided_limits_are_right(sweep: dict[tuple[str, str], list[Run]]) -> None:
    rng, decided = np.random.default_rng(5), {True: 0, False: 0}
    for one, off, std in (run for runs in sweep.values() for run in runs):
        peak = np.abs(one.F).max(axis=0)
        limit = peak * rng.uniform(0.9, 1.1, 6)
        for leg, verdict in enumerate(limit_status(np.abs(one.F + off), limit, std)):
            decided[verdict != INCONCLUSIVE_NOISE] += 1
            if verdict != INCONCLUSIVE_NOISE:
                beyond = peak[leg] > limit[leg]
                assert (verdict == EXCEEDED) == beyond or abs(peak[leg] / limit[leg] - 1.0) < 0.01
    assert min(decided.values()) > 0
