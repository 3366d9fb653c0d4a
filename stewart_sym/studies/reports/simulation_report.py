"""Report of ``simulate``: columns by name, a summary, plots, and the energy drift of both formulations."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, cast

import numpy as np

from ...backend.kernel import FORMULATIONS
from ...drives.limits import LimitTracker
from ...drives.motor_states import of_motor_forces
from ...dynamics.inverse_dynamics import Formulation
from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import rpy_from_rotation
from ...motion.sample_times import least_step, time_text
from ...robot.robot import Robot
from ...robot.units import Units
from ...simulation.actuator_models import ForceLaw, LegSprings, Reference
from ...simulation.scene import Scene
from ...simulation.state_history import SimulationResult, StateHistory, leg_states
from ...simulation.tracking import TrackingError, tracking_error
from ..common.drawing import BLUE, DARK, RED, Figure, legend_below, log_numbers, new_figure
from ..common.report import Picture, Report
from ..common.text_tables import Columns, aligned, by_leg, of_axes, of_legs
from ..paper.reproduce import without_friction
from .leg_plot import LIMIT, draw_limit
from .leg_tables import motor_data, motor_table

_EVEN = 1001
"""Number of evenly spaced samples for the mean kinetic energy."""
_STILL = 1e-12
"""Fraction of the compared energies below which rounding errors dominate the drift."""
_AXES = (*((axis, "m") for axis in "xyz"), *((f"about {axis}", "rad") for axis in "xyz"))
"""Axes of a tracking error with their units."""


def run_columns(run: SimulationResult) -> Columns:
    """Return columns (n,) in SI units: time, pose (angles of (38)), rates, F, L, and energies."""
    vectors = {"t": run.t, "theta": rpy_from_rotation(run.R), "v": run.v, "omega": run.omega}
    columns: Columns = {"time": run.time}
    for name, values in vectors.items():
        columns |= of_axes(name, values)
    columns |= of_legs("F", run.F) | of_legs("L", run.L)
    return columns | {"kinetic_energy": run.kinetic_energy, "potential_energy": run.potential_energy}


def report(
    robot: Robot,
    run: SimulationResult,
    law: ForceLaw,
    drifts: Mapping[str, Columns] | None = None,
    reference: Reference | None = None,
) -> Report:
    """Create the report of a run, with tracking error and results of ``energy_drift``, if there are any."""
    drifts, fine, figures, more = drifts or {}, run.dense_history, {}, {}
    text = summary(robot, run, fine, law)
    if reference is not None:
        error = tracking_error(fine, reference)
        table, more["tracking_error"] = _tracking(robot, error)
        text = f"{text}\n\n{table}"
        figures["tracking"] = Picture(lambda: tracking_figure(robot, error))
    motors = None
    if robot.drive is not None:
        motors = LimitTracker(robot, fine.time, weights=run.dense_weights)
        L_dot = leg_states(robot, fine.motion).L_dot
        motors.add(slice(None), of_motor_forces(robot, robot.drive, fine.motion, fine.F, L_dot)._asdict())
        text = "\n".join([text, "", motor_table(motors), *motors.exceeded()])
    if len(run.time) > 1:
        figures["run"] = Picture(lambda: figure(robot, run, law))
    for name, drift in drifts.items():
        text += f"\n{name:<10} without friction, in {drift['time'][-1]:.6g} s: {_drift_text(drift['drift'])}"
    data = _data(run, fine, law, motors) | more
    if drifts:
        if all(len(drift["time"]) > 1 for drift in drifts.values()):
            figures["energy_drift"] = Picture(lambda: drift_figure(drifts))
        data["energy_drift"] = {name: np.abs(drift["drift"]).max() for name, drift in drifts.items()}
    tables = {f"energy_drift_{name}": drift for name, drift in drifts.items()}
    return Report(text, {"run": run_columns(run), **tables}, data, figures)


def energy_drift(scene: Scene) -> dict[str, Columns]:
    """Simulate a machine on springs in both formulations, without friction, dampers, and load.

    Returns times (s) and the change of energy over the mean kinetic energy; correct equations conserve it.
    """
    law, state = cast(LegSprings, scene.law), scene.state
    robot = without_friction(scene.robot)
    law = replace(law, robot=robot, damping=0.0)
    state = Motion(R=state.R, t=state.t, omega=state.omega, v=state.v)
    free = replace(scene, robot=robot, law=law, state=state, load=None, on_force_limit="stop")
    names = cast(tuple[Formulation, ...], FORMULATIONS)
    runs = {name: replace(free, formulation=name).run() for name in names}
    scale = _mean_kinetic_energy(runs["exact"], law)
    return {name: {"time": run.time, "drift": _drift(run, law, scale)} for name, run in runs.items()}


def _data(
    run: SimulationResult, fine: StateHistory, law: ForceLaw, motors: LimitTracker | None
) -> dict[str, Any]:
    peaks, drives = np.argmax(np.abs(fine.F), axis=0), run.drive_work
    legs = {
        "peak_force_N": np.take_along_axis(fine.F, peaks[None], axis=0)[0],
        "peak_force_time_s": fine.time[peaks],
        "min_length_m": fine.L.min(axis=0),
        "max_length_m": fine.L.max(axis=0),
        "saturated_s": run.saturation.duration,
        "saturation_max_excess_N": run.saturation.max_excess,
        **({} if motors is None else motor_data(motors)),
    }
    work = {}
    if drives is not None:
        work = {"motors_work_J": drives.done.sum(), "drive_friction_J": drives.lost.sum()}
    stop = run.stop
    return {
        "stop": {"reason": stop.reason, "time_s": stop.time, "leg": stop.leg, "message": stop.message},
        "steps": run.step_count,
        "legs": by_leg(legs),
        "energy_start_J": run.energy[0],
        "energy_end_J": run.energy[-1],
        "kinetic_energy_peak_J": fine.kinetic_energy.max(),
        "springs_energy_drift": springs_drift(run, fine, law),
        **work,
        "units": dict.fromkeys(("springs_energy_drift", "energy_drift"), "share of the mean kinetic energy"),
    }


def springs_drift(run: SimulationResult, fine: StateHistory, law: ForceLaw) -> float | None:
    """Return the energy drift over the mean kinetic energy, 0 at rest; None without unsaturated springs."""
    if not isinstance(law, LegSprings) or (run.saturation.max_excess > 0.0).any():
        return None
    return float(np.abs(_drift(fine, law, _mean_kinetic_energy(run, law))).max())


def _drift(run: StateHistory, law: LegSprings, scale: float) -> Array:
    """Return the change of the energy of machine and springs over ``scale`` (J), shape (n,)."""
    energy = run.energy + law.energy(run.L)
    return np.asarray((energy - energy[0]) / scale)


def _mean_kinetic_energy(run: SimulationResult, law: LegSprings) -> float:
    """Return the mean kinetic energy (J), or inf if the motion is only rounding errors."""
    even = run.at(np.linspace(0.0, run.stop.time, _EVEN))
    mean = float(even.kinetic_energy.mean())
    stored = float((np.abs(even.potential_energy) + np.abs(law.energy(even.L))).max())
    return mean if mean > _STILL * stored else math.inf


def _drift_text(drift: Array | float) -> str:
    largest = np.max(np.abs(drift))
    if largest == 0.0:
        return "nothing moved, so that no energy can drift"
    return f"energy with that of the springs changes by up to {largest:.2e} of the mean kinetic energy"


def summary(robot: Robot, run: SimulationResult, fine: StateHistory, law: ForceLaw) -> str:
    """Format the end, force, lengths, and energy of a run; ``fine`` is its dense history."""
    i, leg = np.unravel_index(int(np.argmax(np.abs(fine.F))), fine.F.shape)
    first, last, most = run.energy[0], run.energy[-1], fine.kinetic_energy.max()
    when, units = time_text(fine.time[i], least_step(fine.time)), Units.of(robot)
    shortest, longest = fine.L.min() / units.meters, fine.L.max() / units.meters
    lines = [
        f"stopped    {run.stop.message}",
        f"steps      {run.step_count}",
        f"force      up to {fine.F[i, leg]:.6g} N, leg {leg + 1} at {when} s",
        f"length     {shortest:.6g} to {longest:.6g} {units.length}",
        f"energy     {first:.6g} J at the start, {last:.6g} J at the end, kinetic up to {most:.6g} J",
    ]
    if run.drive_work is not None:
        done, lost = run.drive_work.done.sum(), run.drive_work.lost.sum()
        lines.append(f"motors     work of {done:.6g} J, friction of the drives took {lost:.6g} J")
    lines += [
        f"saturated  leg {i + 1} for {time:.6g} s, "
        f"up to {run.saturation.max_excess[i]:.6g} N beyond its limit"
        for i, time in enumerate(run.saturation.duration)
        if run.saturation.max_excess[i] > 0.0
    ]
    drift = springs_drift(run, fine, law)
    if drift is not None and isinstance(law, LegSprings):
        lines.append(f"springs    {_drift_text(drift)}{_taken(run, law) if drift else ''}")
    return "\n".join(lines)


def _taken(run: SimulationResult, law: LegSprings) -> str:
    """Name the causes of a legitimate change of the energy of a machine on springs, or return nothing."""
    sources = {
        "dampers": np.any(getattr(law, "damping", 0.0)),
        "friction": any(np.any(getattr(law.robot, name)) for name in ("C_u", "C_p", "C_s")),
        "drives": run.drive_work is not None,
        "the load": run.has_load,
    }
    found = [name for name, changes in sources.items() if changes]
    return f", by {' and '.join(filter(None, (', '.join(found[:-1]), found[-1])))}" if found else ""


def figure(robot: Robot, run: SimulationResult, law: ForceLaw) -> Figure:
    """Plot motion since the start, rates, forces, lengths, and energies; planned motion and limits dashed."""
    legs, units = tuple(f"leg {leg + 1}" for leg in range(6)), Units.of(robot)
    # Angles are unwrapped, because a jump of 2 pi would be drawn as a line across the panel.
    moved = _since_start(run.motion, run.motion)
    panels = (
        (moved[0] / units.meters, tuple("xyz"), f"position since start, {units.length}"),
        (moved[1] / units.radians, ("roll", "pitch", "yaw"), f"attitude since start, {units.angle}"),
        (run.v / units.meters, tuple("xyz"), f"velocity, {units.length}/s"),
        (run.omega / units.radians, tuple("xyz"), f"angular velocity, {units.angle}/s"),
        (run.F, legs, "force, N"),
        ((run.L - run.L[0]) / units.meters, legs, f"leg length since start, {units.length}"),
        (run.kinetic_energy[:, None], ("kinetic",), "kinetic energy, J"),
        (*_gained(run, law), "energy since start, J"),
    )
    picture = new_figure(10.0, 10.0)
    grid = picture.subplots(4, 2, sharex=True)
    for axes, panel in zip(grid.flat, panels, strict=True):
        _curves(axes, run.time, *panel)
    count = len(grid.flat[4].lines)
    for limit in np.unique(robot.force_limit):
        draw_limit(grid.flat[4].axhline, float(limit), run.F, LIMIT)
    for line in grid.flat[4].lines[count : count + 1]:
        line.set_label("limit")
    _draw_planned(grid.flat, units, run, law)
    for axes in grid.flat:
        _legend(axes)
    for axes in grid[-1]:
        axes.set_xlabel("time, s")
    picture.suptitle(run.stop.message, fontsize=10.0)
    return picture


def _curves(axes: Any, time: Array, values: Array, names: Sequence[str], label: str) -> None:
    for name, column in zip(names, values.T, strict=True):
        axes.plot(time, column, linewidth=1.1, label=name)
    axes.set_ylabel(label)
    axes.margins(x=0.0)


def _legend(axes: Any) -> None:
    # The legend is next to the panel, because curves could cover it inside.
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8.0)


def _since_start(motion: Motion, start: Motion) -> tuple[Array, Array]:
    """Return changes of position (m) and roll, pitch, and yaw (rad), (n, 3), from the first pose of a run."""
    first = rpy_from_rotation(start.R[:1])
    theta = np.unwrap(np.concatenate([first, rpy_from_rotation(motion.R)]), axis=0)
    return motion.t - start.t[0], theta[1:] - theta[0]


def _draw_planned(panels: Any, units: Units, run: SimulationResult, law: ForceLaw) -> None:
    """Draw the reference motion of a controller, if any, over position, attitude, and rates."""
    reference = getattr(law, "reference", None)
    if reference is None:
        return
    time = run.time[:: max(1, len(run.time) // _EVEN)]
    # At its last time a reference is already at rest.
    poses = [reference(float(each)) for each in np.nextafter(time, 0.0)]
    names = ("R", "t", "omega", "v")
    planned = Motion._unchecked(*(np.stack([getattr(pose, name) for pose in poses]) for name in names))
    position, attitude = _since_start(planned, run.motion)
    lines = (position, units.meters), (attitude, units.radians), (planned.v, units.meters)
    for axes, (values, scale) in zip(panels, (*lines, (planned.omega, units.radians)), strict=False):
        for number, column in enumerate(values.T):
            style: Any = {"color": DARK, "linewidth": 0.9, "linestyle": (0, (3, 3))}
            axes.plot(time, column / scale, label="planned" if number == 0 else None, **style)


def _gained(run: SimulationResult, law: ForceLaw) -> tuple[Array, tuple[str, ...]]:
    """Return energies since the start (J), shape (n, k), with their names, including springs if any."""
    parts = {"kinetic": run.kinetic_energy, "potential": run.potential_energy}
    if isinstance(law, LegSprings):
        parts["springs"] = law.energy(run.L)
    gained = np.stack([energy - energy[0] for energy in parts.values()], axis=-1)
    return np.column_stack([gained, gained.sum(axis=-1)]), (*parts, "sum")


def _tracking(robot: Robot, error: TrackingError) -> tuple[str, list[dict[str, Any]]]:
    """Return a table of RMS and peak of the tracking error of each axis, and the same for the JSON data."""
    # The dense history has shorter steps than the times of peaks require.
    units, step, rows, data = Units.of(robot), error.time[-1] / len(error.time), [], []
    for (name, si), rms, peak, when in zip(_AXES, error.rms, error.peak, error.peak_time, strict=True):
        factor, unit = units.of_unit(si)
        sizes = (f"{factor * size:.3g} {unit}" for size in (rms, peak))
        rows.append((name, *sizes, f"{time_text(when, step)} s"))
        data.append({"axis": name, f"rms_{si}": rms, f"peak_{si}": peak, "peak_time_s": when})
    return aligned(("tracking error", "RMS", "peak", "time of the peak"), rows), data


def tracking_figure(robot: Robot, error: TrackingError) -> Figure:
    """Plot the tracking error along and about each axis over time."""
    units, names = Units.of(robot), [name for name, _ in _AXES]
    picture = new_figure(8.0, 6.0)
    above, below = picture.subplots(2, sharex=True)
    position, rotation = error.position / units.meters, error.rotation / units.radians
    _curves(above, error.time, position, names[:3], f"position error, {units.length}")
    _curves(below, error.time, rotation, names[3:], f"rotation error, {units.angle}")
    below.set_xlabel("time, s")
    for axes in (above, below):
        _legend(axes)
    return picture


def drift_figure(drifts: Mapping[str, Columns]) -> Figure:
    """Plot the magnitudes of the energy drifts of both formulations over time."""
    picture = new_figure(8.0, 4.2)
    axes = picture.subplots()
    for (name, found), color in zip(drifts.items(), (BLUE, RED), strict=True):
        # The drift of the first sample is zero, which has no logarithm.
        size = np.maximum(np.abs(found["drift"][1:]), _STILL)
        label = f"{name}, largest {size.max():.1e}"
        axes.semilogy(found["time"][1:], size, color=color, linewidth=1.3, label=label)
    axes.set(xlabel="time, s", ylabel="change of energy / mean kinetic energy")
    log_numbers(axes.yaxis)
    legend_below(picture)
    return picture
