"""Report of ``simulate``: columns by name, a summary, and plots."""

from typing import Any

import numpy as np

from ...drives.limits import LimitTracker
from ...drives.motor_states import of_motor_forces
from ...io.array_types import Array
from ...motion.motion import Motion
from ...motion.rotation import rpy_from_rotation
from ...motion.sample_times import least_step, time_text
from ...robot.robot import Robot
from ...robot.units import Units
from ...simulation.actuator_models import ForceLaw, LegSprings, Reference, leg_states
from ...simulation.state_history import SimulationResult, StateHistory
from ...simulation.tracking import TrackingError, tracking_error
from ..common.drawing import DARK, LIMIT, Figure, curves, draw_limits, legend_beside, new_figure
from ..common.report import Picture, Report
from ..common.text_tables import Columns, aligned, by_leg, of_axes, of_legs
from .leg_tables import motor_data, motor_table

_EVEN = 1001
"""Number of evenly spaced samples for the mean kinetic energy."""
_STILL = 1e-12
"""Fraction of the compared energies below which rounding errors dominate the drift."""
_AXES = (*((axis, "m") for axis in "xyz"), *((f"about {axis}", "rad") for axis in "xyz"))
"""Axes of a tracking error with their units."""
_MOTION = (
    ("position since start", "m", ("x", "y", "z")),
    ("attitude since start", "rad", ("roll", "pitch", "yaw")),
    ("velocity", "m/s", ("x", "y", "z")),
    ("angular velocity", "rad/s", ("x", "y", "z")),
)
"""Name, unit, and components of the panels that show a motion."""
_PLANNED: dict[str, Any] = {"color": DARK, "linewidth": 0.9, "linestyle": (0, (3, 3))}


def run_columns(run: SimulationResult) -> Columns:
    """Return columns (n,) in SI units: time, pose (angles of (38)), rates, F, L, and energies."""
    vectors = {"t": run.t, "theta": rpy_from_rotation(run.R), "v": run.v, "omega": run.omega}
    columns: Columns = {"time": run.time}
    for name, values in vectors.items():
        columns |= of_axes(name, values)
    columns |= of_legs("F", run.F) | of_legs("L", run.L)
    return columns | {"kinetic_energy": run.kinetic_energy, "potential_energy": run.potential_energy}


def report(robot: Robot, run: SimulationResult, law: ForceLaw, reference: Reference | None = None) -> Report:
    """Create the report of a run, with the tracking error if there is a reference motion."""
    fine, figures, more = run.dense_history, {}, {}
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
    return Report(text, {"run": run_columns(run)}, _data(run, fine, law, motors) | more, figures)


def _data(
    run: SimulationResult, fine: StateHistory, law: ForceLaw, motors: LimitTracker | None
) -> dict[str, Any]:
    """Return the numbers of the summary for the JSON data."""
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
        "units": {"springs_energy_drift": "fraction of the mean kinetic energy"},
    }


def springs_drift(run: SimulationResult, fine: StateHistory, law: ForceLaw) -> float | None:
    """Return the energy drift over the mean kinetic energy, 0 at rest; None without unsaturated springs."""
    if not isinstance(law, LegSprings) or (run.saturation.max_excess > 0.0).any():
        return None
    even = run.at(np.linspace(0.0, run.stop.time, _EVEN))
    mean = float(even.kinetic_energy.mean())
    stored = float((np.abs(even.potential_energy) + np.abs(law.energy(even.L))).max())
    energy = fine.energy + law.energy(fine.L)
    return float(np.abs(energy - energy[0]).max()) / mean if mean > _STILL * stored else 0.0


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
    if drift == 0.0:
        lines.append("springs    nothing moved, so that no energy can drift")
    elif drift is not None and isinstance(law, LegSprings):
        finding = f"energy with that of the springs changes by up to {drift:.2e} of the mean kinetic energy"
        lines.append(f"springs    {finding}{_causes(run, law)}")
    return "\n".join(lines)


def _causes(run: SimulationResult, law: LegSprings) -> str:
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
    legs, units = [f"leg {leg + 1}" for leg in range(6)], Units.of(robot)
    picture = new_figure(10.0, 10.0)
    grid = picture.subplots(4, 2, sharex=True)
    time, planned = run.time[:: max(1, len(run.time) // _EVEN)], None
    if (reference := getattr(law, "reference", None)) is not None:
        planned = _since_start(_sampled(reference, time), run.motion)
    for i, values in enumerate(_since_start(run.motion, run.motion)):
        name, si_unit, components = _MOTION[i]
        scale, unit = units.of_unit(si_unit)
        curves(grid.flat[i], run.time, scale * values, components, f"{name}, {unit}")
        if planned is not None:
            grid.flat[i].plot(time, scale * planned[i], label=["planned", "_", "_"], **_PLANNED)
    curves(grid.flat[4], run.time, run.F, legs, "force, N")
    draw_limits(grid.flat[4].axhline, robot.force_limit, run.F, {**LIMIT, "label": "limit"})
    moved = (run.L - run.L[0]) / units.meters
    curves(grid.flat[5], run.time, moved, legs, f"leg length since start, {units.length}")
    curves(grid.flat[6], run.time, run.kinetic_energy[:, None], ["kinetic"], "kinetic energy, J")
    parts = {"kinetic": run.kinetic_energy, "potential": run.potential_energy}
    if isinstance(law, LegSprings):
        parts["springs"] = law.energy(run.L)
    parts["sum"] = np.sum([*parts.values()], axis=0)
    gained = np.stack([energy - energy[0] for energy in parts.values()], axis=-1)
    curves(grid.flat[7], run.time, gained, [*parts], "energy since start, J")
    legend_beside(picture)
    for axes in grid[-1]:
        axes.set_xlabel("time, s")
    picture.suptitle(f"{robot.name}: {run.stop.message}", fontsize=10.0)
    return picture


def _sampled(reference: Reference, time: Array) -> Motion:
    """Return a reference motion at times (s), shape (n,); at its last time it is already at rest."""
    poses = [reference(float(each)) for each in np.nextafter(time, 0.0)]
    names = ("R", "t", "omega", "v")
    return Motion._unchecked(*(np.stack([getattr(pose, name) for pose in poses]) for name in names))


def _since_start(motion: Motion, start: Motion) -> tuple[Array, Array, Array, Array]:
    """Return position (m) and roll, pitch, and yaw (rad) from the first pose of a run, and both rates."""
    # Angles are unwrapped, because a jump of 2 pi would be drawn as a line across the panel.
    first = rpy_from_rotation(start.R[:1])
    theta = np.unwrap(np.concatenate([first, rpy_from_rotation(motion.R)]), axis=0)
    return motion.t - start.t[0], theta[1:] - theta[0], motion.v, motion.omega


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
    curves(above, error.time, error.position / units.meters, names[:3], f"position error, {units.length}")
    curves(below, error.time, error.rotation / units.radians, names[3:], f"rotation error, {units.angle}")
    below.set_xlabel("time, s")
    legend_beside(picture)
    picture.suptitle(robot.name, fontsize=10.0)
    return picture
