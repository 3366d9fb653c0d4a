"""A simulation's run as ``simulate`` writes it: columns by name, a summary, a picture.

Takes a Simulation and the law it ran under. The pictures need the extra ``plot``; nothing else is written.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...motion.rotation import rpy_from_rotation
from ...simulation.actuator_models import ForceLaw, LegSprings
from ...simulation.simulation import Simulation
from .energy_drift import drift_of, energy_scale

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Columns = dict[str, NDArray[Any]]


def run_columns(run: Simulation) -> Columns:
    """Columns (n,) in SI units: time, pose (angles of (38), |theta_y| <= pi/2), rates, F, L and energies."""
    vectors = {"t": run.t, "theta": rpy_from_rotation(run.R), "v": run.v, "omega": run.omega}
    columns: Columns = {"time": run.times}
    columns |= {f"{name}_{axis}": x[:, j] for name, x in vectors.items() for j, axis in enumerate("xyz")}
    for name, of_legs in (("F", run.F), ("L", run.L)):
        columns |= {f"{name}{leg + 1}": of_legs[:, leg] for leg in range(6)}
    return columns | {"kinetic": run.kinetic, "potential": run.potential}


def summary(run: Simulation, law: ForceLaw) -> str:
    """A few lines: why the run ended, the largest force, the legs' travel, the energy and its drift."""
    i, leg = np.unravel_index(int(np.argmax(np.abs(run.F))), run.F.shape)
    first, last, most = run.energy[0], run.energy[-1], run.kinetic.max()
    lines = [
        f"stopped    {run.stop.text}",
        f"steps      {run.steps}",
        f"force      up to {run.F[i, leg]:.6g} N, leg {leg + 1} at {run.times[i]:g} s",
        f"length     {run.L.min():.6g} to {run.L.max():.6g} m",
        f"energy     {first:.6g} J at the start, {last:.6g} J at the end, kinetic up to {most:.6g} J",
    ]
    lines += [
        f"saturated  leg {i + 1} for {time:.6g} s, up to {run.saturation.excess[i]:.6g} N beyond its limit"
        for i, time in enumerate(run.saturation.time)
        if run.saturation.excess[i] > 0.0
    ]
    # Of springs whose forces are clipped no energy is kept.
    if isinstance(law, LegSprings) and not (run.saturation.excess > 0.0).any():
        lines.append(f"springs    {drift_of(run, law, energy_scale(run, law)).text}")
    return "\n".join(lines)


def figure(run: Simulation) -> "Figure | None":
    """Position, attitude, forces, lengths and energy over time; None of a run of one instant."""
    from matplotlib.figure import Figure

    if len(run.times) < 2:
        return None
    axes_of = dict(zip("xyz", range(3), strict=True))
    legs = {f"leg {leg + 1}": leg for leg in range(6)}
    angles = dict(zip(("roll", "pitch", "yaw"), range(3), strict=True))
    # An angle that leaps by a turn is not drawn as a line across the panel.
    theta = np.unwrap(rpy_from_rotation(run.R), axis=0)
    gained = run.potential - run.potential[0]
    energies = np.stack([run.kinetic, gained, run.kinetic + gained], axis=-1)
    panels = (
        (run.t, axes_of, "position, m"),
        (np.degrees(theta), angles, "attitude, degrees"),
        (run.F, legs, "force, N"),
        (run.L, legs, "leg length, m"),
        (run.omega, axes_of, "angular velocity, rad/s"),
        (energies, {"kinetic": 0, "potential gained": 1, "both": 2}, "energy, J"),
    )
    picture = Figure(figsize=(10.0, 8.0), layout="constrained")
    grid = picture.subplots(3, 2, sharex=True)
    for axes, (values, names, label) in zip(grid.flat, panels, strict=True):
        _curves(axes, run.times, values, names, label)
    for axes in grid[-1]:
        axes.set_xlabel("time, s")
    picture.suptitle(run.stop.text, fontsize=10.0)
    return picture


def save(picture: "Figure", path: Path) -> None:
    """Write a picture as PNG; the same numbers give the same bytes."""
    picture.savefig(path, dpi=160, metadata={"Software": None})


def _curves(axes: "Axes", times: Array, values: Array, names: Mapping[str, int], label: str) -> None:
    for name, column in names.items():
        axes.plot(times, values[:, column], linewidth=1.1, label=name)
    axes.set_ylabel(label)
    axes.margins(x=0.0)
    axes.grid(alpha=0.35, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    # Beside the panel, where no curve can run through it.
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False, fontsize=8.0)
