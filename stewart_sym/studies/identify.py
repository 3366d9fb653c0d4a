"""A simulated identification from beginning to end: motion, noisy forces, estimates beside the truth.

Takes a Robot; prints nothing, writes no file.
"""

import csv
import io
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from ..excitation import choose_excitation
from ..identification import Experiment, simulated_experiment
from ..robot import Robot
from .table import aligned

Array = NDArray[np.float64]

# Share of a normal distribution within one, two and three standard deviations.
NORMAL = (0.6827, 0.9545, 0.9973)
_COORDINATES = (("t", "theta"), ("v", "theta_dot"), ("a", "theta_ddot"))


def identification(
    robot: Robot,
    sigma: float,
    seed: int,
    period: float | None,
    harmonics: int,
    samples: int,
    candidates: int,
    progress: Callable[[str], None] = lambda _: None,
) -> Experiment:
    """Choose the motion, measure along it and identify.

    Arguments as for ``choose_excitation`` and ``simulated_experiment``; seed: of both.
    """
    progress(f"choosing among {candidates} motions")
    excited = choose_excitation(robot, period, harmonics, samples, candidates, seed)
    progress("identifying")
    return simulated_experiment(robot, excited, sigma, seed)


def report(robot: Robot, found: Experiment) -> str:
    """What was done and the table: true, estimated, sigma, deviation in sigmas."""
    excited, estimate = found.excitation, found.estimate
    base = estimate.base
    size = np.abs(found.deviation)
    shares = ", ".join(
        f"{100 * np.mean(size <= width):.0f} % ({100 * normal:.1f} %) within {width}"
        for width, normal in zip((1, 2, 3), NORMAL, strict=True)
    )
    harmonics = len(excited.path.sine)
    lines = [
        f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.gap:.2g}",
        f"motion: {harmonics} harmonics, period {excited.path.period:.4g} s, {len(excited.time)} instants; "
        f"condition number {excited.condition:.4g}",
        f"noise: {found.sigma:g} N on each force; RMS of what is left {estimate.misfit:.3f} of that",
        f"errors in standard deviations (of a normal distribution): {shares}; largest {np.max(size):.2f}",
    ]
    rows = [
        [name, unit, *(f"{value:.6g}" for value in numbers[:2]), f"{numbers[2]:.2g}", f"{numbers[3]:+.2f}"]
        for name, unit, *numbers in _rows(found)
    ]
    head = ["parameter", "unit", "true", "estimated", "sigma", "error/sigma"]
    merged = [text for name, text in zip(base.names, base.formulas, strict=True) if text != name]
    return "\n".join(
        [*lines, "", aligned(head, rows, left=2), "", "Parameters stand for these combinations:", *merged]
    )


def parameter_lines(found: Experiment) -> Iterator[str]:
    """Lines of a CSV file: name, formula, unit, true, estimated, sigma, deviation of each base parameter."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(["name", "formula", "unit", "true", "estimated", "sigma", "deviation"])
    for (name, unit, *numbers), formula in zip(_rows(found), found.estimate.base.formulas, strict=True):
        writer.writerow([name, formula, unit, *map(repr, numbers)])
    yield stream.getvalue()


def trajectory_columns(found: Experiment) -> dict[str, Array]:
    """The motion as the command ``forces`` reads it."""
    columns = {"time": found.excitation.time}
    for names, x in zip(_COORDINATES, found.excitation.path.coordinates(columns["time"]), strict=True):
        for j, name in enumerate(f"{name}_{axis}" for name in names for axis in "xyz"):
            columns[name] = x[:, j]
    return columns


def force_columns(found: Experiment) -> dict[str, Array]:
    """Time and the noisy forces."""
    return {"time": found.excitation.time} | {f"F{leg + 1}": found.F[:, leg] for leg in range(6)}


def _rows(found: Experiment) -> Iterator[tuple[str, str, float, float, float, float]]:
    estimate = found.estimate
    numbers = zip(
        found.truth.tolist(),
        estimate.values.tolist(),
        estimate.sigma.tolist(),
        found.deviation.tolist(),
        strict=True,
    )
    for name, unit, four in zip(estimate.base.names, estimate.base.units, numbers, strict=True):
        yield (name, unit, *four)
