"""Identification from beginning to end: of measured forces, or simulated with the truth beside the estimates.

Prints nothing, writes no file.
"""

import csv
import io
from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..excitation import choose_excitation
from ..identifiable import BaseParameters, base_parameters
from ..identification import Estimate, Experiment, identify, simulated_experiment
from ..robot import Robot
from ..trajectory import Trajectory
from .output import csv_lines
from .table import aligned

Array = NDArray[np.float64]

# Share of a normal distribution within one, two and three standard deviations.
NORMAL = (0.6827, 0.9545, 0.9973)
# Times that differ by less than this share of the last one are the same.
_SAME_TIME = 1e-6
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


def from_measurement(
    robot: Robot, trajectory: Trajectory, time: Array, F: Array, sigma: float, source: str
) -> Estimate:
    """Identify what the motion of a trajectory excites from forces measured at the same times.

    time, F: instants, s, (n,), and forces, N, (n, 6), as read from ``source``. Raises ValueError naming it
    for other times than those of the trajectory.
    """
    if len(time) != len(trajectory.time):
        raise ValueError(
            f"{source}: expected {len(trajectory.time)} rows, as many as {trajectory.source}, got {len(time)}"
        )
    off = np.abs(time - trajectory.time) > _SAME_TIME * np.max(np.abs(trajectory.time))
    if np.any(off):
        i = int(np.argmax(off))
        expected = f"the time {trajectory.time[i]:g} of {trajectory.source}"
        raise ValueError(f"{source}: instant {i + 1}: expected {expected}, got {time[i]:g}")
    return identify(robot, trajectory.motion, F, sigma, base_parameters(robot, trajectory.motion))


def measured_texts(robot: Robot, found: Estimate, sigma: float) -> dict[str, str]:
    """Texts of the files about measured forces, by name."""
    base = found.base
    head = ("name", "formula", "unit", "estimated", "sigma")
    columns = (base.names, base.formulas, base.units, found.values.tolist(), found.sigma.tolist())
    rows = list(zip(*columns, strict=True))
    lines = [
        _count(robot, base),
        f"noise: {sigma:g} N on each force; RMS of what is left {found.misfit:.3f} of that",
    ]
    cells = [[name, unit, f"{value:.6g}", f"{width:.2g}"] for name, _, unit, value, width in rows]
    table = aligned(["parameter", "unit", "estimated", "sigma"], cells, left=2)
    return {
        "parameters.csv": _csv(head, rows),
        "report.txt": "\n".join([*lines, "", table, "", *_merged(base)]) + "\n",
    }


def simulated_texts(robot: Robot, found: Experiment) -> dict[str, str]:
    """Texts of the files about a simulated measurement, by name."""
    return {
        "parameters.csv": parameter_text(found),
        "trajectory.csv": "".join(csv_lines(trajectory_columns(found))),
        "forces.csv": "".join(csv_lines(force_columns(found))),
        "report.txt": report(robot, found) + "\n",
    }


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
        _count(robot, base),
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
    return "\n".join([*lines, "", aligned(head, rows, left=2), "", *_merged(base)])


def _count(robot: Robot, base: BaseParameters) -> str:
    return f"{robot.name}: {base.rank} base parameters of {base.matrix.shape[1]}, gap {base.gap:.2g}"


def _merged(base: BaseParameters) -> list[str]:
    found = [text for name, text in zip(base.names, base.formulas, strict=True) if text != name]
    return ["Parameters stand for these combinations:", *found]


def parameter_text(found: Experiment) -> str:
    """A CSV file: name, formula, unit, true, estimated, sigma, deviation of each base parameter."""
    head = ("name", "formula", "unit", "true", "estimated", "sigma", "deviation")
    rows = zip(_rows(found), found.estimate.base.formulas, strict=True)
    return _csv(head, [(row[0], formula, *row[1:]) for row, formula in rows])


def _csv(head: Sequence[str], rows: Iterable[Sequence[str | float]]) -> str:
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows([head, *rows])
    return stream.getvalue()


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
