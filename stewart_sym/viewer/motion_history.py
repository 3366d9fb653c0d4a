"""Motion of a robot at n samples, with forces, condition numbers, singular poses, and exceeded limits."""

from __future__ import annotations

import csv
import itertools
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..drives.limit_status import INCONCLUSIVE_NOISE, unknown_forces
from ..drives.limits import (
    LimitTracker,
    limit_codes,
    limited_angles,
    limits_of,
    replaced_names,
    replaced_rows,
    times_of,
)
from ..drives.motor_states import MotorStates, motor_states, of_motor_forces
from ..drives.noise import Deviations, all_deviations, at_replaced
from ..dynamics.force_noise import force_std
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..io.array_types import Array, Flags
from ..kinematics.conditioning import characteristic_length, scaled_condition_number
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..kinematics.mounting_side import path_for
from ..kinematics.pose_search import rates_per_twist
from ..motion.csv_table import read_table
from ..motion.interpolation import Path, interpolate
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_rpy
from ..motion.straight_line import PAPER_PATHS, StraightLinePath
from ..motion.trajectory import Replaced, Trajectory, noise_text
from ..results import OK
from ..robot.robot import Robot
from ..simulation.actuator_models import leg_states
from ..simulation.state_history import SimulationResult, StateHistory
from ..singularities.path_singularities import singularity_crossings
from ..singularities.singular_poses import SingularityResult, singularity

FORMULATIONS = ("exact", "paper")
Forces = Mapping[str, Array] | None
STEPS_PER_PATH = 600
"""Smallest number of time steps of a path of the paper."""
# Columns of a run file.
_SCALARS = ("time", "kinetic_energy", "potential_energy")
_VECTORS = {name: [f"{name}_{axis}" for axis in "xyz"] for name in ("t", "theta", "v", "omega")}
_VECTORS |= {name: [f"{name}_{leg}" for leg in range(1, 7)] for name in "FL"}
# Largest difference between the lengths in a run file and at its poses, relative to the longest leg.
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class Event:
    """Time (s) that the time line marks, with its pose and singularity measures.

    singular: False for the largest condition number of a motion without singular poses.
    """

    time: float
    motion: Motion
    at: SingularityResult
    singular: bool


@dataclass(frozen=True, eq=False)
class Noise:
    """Effects of the noise of a log at n samples, with a description in ``text``.

    sd: standard deviations, with forces F of the first formulation, and F_exact and F_paper by formulation.
    there: flags of samples, (n,), whose standard deviations include replaced rows.
    """

    text: str
    sd: Deviations
    there: Flags
    replaced: tuple[Replaced, ...]


@dataclass(frozen=True, eq=False)
class MotionHistory:
    """Motion of a robot at n samples in SI units and the base frame.

    Attributes
    ----------
    name : str
        Name of the motion.
    time : ndarray, shape (n,)
        Times (s).
    motion : Motion
        Poses and rates, shape (n,).
    L, L_dot : ndarray, shape (n, 6)
        Leg lengths (m) and rates (m/s).
    forces : dict of ndarray, shape (n, 6)
        Actuator forces by formulation or source (N). NaN if a pose is unsolvable.
    condition : ndarray, shape (n,)
        Condition numbers of the scaled H (dimensionless).
    events : tuple of Event
        Singular poses in order of time, or the pose closest to a singular pose.
    noise : Noise, optional
        Noise of the log.
    """

    name: str
    time: Array
    motion: Motion
    L: Array
    L_dot: Array
    forces: Mapping[str, Array]
    condition: Array
    events: tuple[Event, ...]
    noise: Noise | None = None


@dataclass(frozen=True, eq=False)
class LimitReport:
    """Limits of a robot, if ``stated``, compared with its motion.

    ``told`` contains the status and text of each limit that is exceeded or inconclusive. ``codes`` contains
    indices of ``VERDICTS`` at each sample, (n, 6): of F by formulation, of L, of L_dot, and of the motors.
    The motor quantities are computed from the forces F (N), (n, 6).
    """

    stated: bool
    told: tuple[tuple[str, str], ...]
    codes: Mapping[str, NDArray[np.uint8]]
    F: Array
    motors: MotorStates | None
    tracker: LimitTracker


def of_path(robot: Robot, path: str | StraightLinePath) -> MotionHistory:
    """Return the motion along a straight line, or along path I, II, or III of the paper."""
    if isinstance(path, str):
        if path not in PAPER_PATHS:
            raise ValueError(f"motion: expected I, II, III, or a motion, got {path!r}")
        name, path = f"Path {path} of the paper", path_for(robot, path).path
    else:
        name = "straight line"
    time = path.time_grid(path.tau_f / STEPS_PER_PATH)
    return _history(robot, name, time, path.sample(time), path.sample, path.breakpoints(), None)


def of_trajectory(robot: Robot, trajectory: Trajectory) -> MotionHistory:
    """Return the motion of a trajectory; its name is the file name."""
    path = interpolate(trajectory) if len(trajectory.time) > 1 else None
    name = os.path.basename(trajectory.source)
    found = _history(robot, name, trajectory.time, trajectory.motion, path, trajectory.time, None)
    return replace(found, noise=_noise(robot, trajectory, list(found.forces)))


def of_run(robot: Robot, run: StateHistory) -> MotionHistory:
    """Return the motion of a simulation with its forces."""
    path = _path_of(run.time, run.motion)
    if isinstance(run, SimulationResult):

        def path(times: Array) -> Motion:
            return run.at(times).motion

    return _history(robot, "simulated run", run.time, run.motion, path, run.time, {"run": run.F})


def of_motion(robot: Robot, motion: Motion, times: ArrayLike | None, name: str = "motion") -> MotionHistory:
    """Return a motion of shape (n,) at increasing times (s), (n,); forces require accelerations."""
    motion = motion[None] if motion.shape == () else motion
    if times is None and motion.shape != (1,):
        raise ValueError("time: expected the times of the motion's poses (s), got none")
    time = times_of(motion, [0.0] if times is None else times)
    forces: Forces = {} if motion.a is None else None
    return _history(robot, name, time, motion, _path_of(time, motion), time, forces)


def read_run(robot: Robot, path: str | os.PathLike[str]) -> StateHistory:
    """Read ``run.csv`` of ``simulate``; raise ValueError if its lengths belong to another robot."""
    source = os.fsdecode(path)
    names = [*_SCALARS, *itertools.chain(*_VECTORS.values())]
    table = read_table(source, what="run")
    for name in names:
        if name not in table.header:
            raise ValueError(f"{source}: no column {name}; use a file run.csv of simulate")
    columns = dict(zip(names, table.numbers(names).T, strict=True))
    found = {name: np.stack([columns[each] for each in of], axis=-1) for name, of in _VECTORS.items()}
    found |= {"R": rotation_from_rpy(found.pop("theta"))} | {name: columns[name] for name in _SCALARS}
    run = StateHistory(**found)
    own = inverse_kinematics(robot, run.motion).L
    same = np.abs(own - run.L) <= _SAME * run.L.max(initial=0.0)
    if not same.all():
        row, leg = (int(found[0]) for found in np.nonzero(~same))
        raise ValueError(
            f"{source}: expected a run of {robot.name}, got one of another machine: at {run.time[row]:g} s "
            f"leg {leg + 1} is {own[row, leg]:.6g} m long, L{leg + 1} is {run.L[row, leg]:.6g} m"
        )
    return run


def is_run_file(path: str | os.PathLike[str]) -> bool:
    """Return True if a table contains the states and forces of a simulated run."""
    with open(path, encoding="utf-8", errors="replace", newline="") as stream:
        header = next(csv.reader(stream), [])
    return {"omega_x", "F_1", "kinetic_energy"} <= {name.strip() for name in header}


def _history(
    robot: Robot, name: str, time: Array, motion: Motion, path: Path | None, breaks: Array, forces: Forces
) -> MotionHistory:
    """Return the motion with forces and events; ``forces`` is None to compute them for the formulations.

    ``path`` and ``breaks`` are the arguments of ``singularity_crossings``.
    """
    with np.errstate(all="ignore"):
        legs = leg_states(robot, motion)
        length = characteristic_length(robot) or 1.0
        H = np.swapaxes(rates_per_twist(robot, motion.R, motion.t), -1, -2)
        condition = scaled_condition_number(H, length)
    if forces is None and robot.missing_bodies:
        forces = {}
    if forces is None:
        # The formulation of the paper has neither rotors nor offsets.
        exact_alone = robot.has_rotors or robot.offsets is not None
        formulations = FORMULATIONS[:1] if exact_alone else FORMULATIONS
        forces = {each: _forces(robot, motion, each) for each in formulations}
    events = _events(robot, time, motion, condition, path, breaks)
    return MotionHistory(name, time, motion, legs.L, legs.L_dot, forces, condition, events)


def _noise(robot: Robot, trajectory: Trajectory, formulations: list[str]) -> Noise | None:
    if trajectory.noise is None:
        return None
    first, *others = formulations
    sd = all_deviations(robot, trajectory, first)  # type: ignore[arg-type]
    sd[f"F_{first}"] = sd["F"]
    sd |= {f"F_{name}": force_std(robot, trajectory, name) for name in others}  # type: ignore[arg-type]
    replaced, said = replaced_rows(trajectory), []
    if trajectory.noise.sigma.any():
        units = robot.length_unit, robot.angle_unit
        said.append(f"{noise_text(trajectory.noise.sigma, trajectory.has_lengths, *units)}: smoothed")
    if replaced:
        said.append(f"replaced rows: {replaced_names(replaced)}")
    text, there = "; ".join(said), at_replaced(trajectory, trajectory.time)
    return Noise(text, sd, there, replaced)


def _forces(robot: Robot, motion: Motion, formulation: str) -> Array:
    found = inverse_dynamics(robot, motion, formulation, on_singular="nan")  # type: ignore[arg-type]
    return np.where((found.status == OK)[:, None], found.F, np.nan)


def _events(
    robot: Robot, time: Array, motion: Motion, condition: Array, path: Path | None, breaks: Array
) -> tuple[Event, ...]:
    if robot.offsets is not None:
        # The search for singular poses requires legs without offsets.
        return ()
    found = []
    if path is not None and len(breaks) > 1:
        for each in singularity_crossings(robot, path, breaks):
            found.append(Event(each.time, path(np.array([each.time]))[0], each.singularity, True))
    known = np.nan_to_num(condition, nan=0.0)
    if not found and len(time) > 1 and known.any():
        i = int(np.argmax(known))
        at = singularity(robot, motion[i])
        found.append(Event(float(time[i]), motion[i], at, bool(at.lost_dof)))
    return tuple(found)


def _path_of(time: Array, motion: Motion) -> Path | None:
    """Return the motion between its samples; missing accelerations are differences of the rates."""
    if len(time) < 2:
        return None
    a, alpha = motion.a, motion.alpha
    if a is None or alpha is None:
        a, alpha = (np.gradient(rate, time, axis=0) for rate in (motion.v, motion.omega))
    full = Motion._unchecked(motion.R, motion.t, motion.omega, motion.v, alpha, a)
    return interpolate(Trajectory(time, full, "motion", range(len(time))))


def limits(robot: Robot, shown: MotionHistory) -> LimitReport:
    """Compare a motion with all limits; without forces, only with the limits of lengths and speeds."""
    first, noise = next(iter(shown.forces), None), shown.noise
    F = np.full_like(shown.L, np.nan) if first is None else shown.forces[first]
    sd, there = (None, None) if noise is None else (noise.sd, noise.there)
    tracker = LimitTracker(robot, shown.time, () if noise is None else noise.replaced)
    lengths = {"L": shown.L, "L_dot": shown.L_dot}
    values = {"F": F, **lengths, **limited_angles(robot, shown.motion)}
    codes = limit_codes(robot, lengths, sd, there)
    for name, forces in shown.forces.items():
        off = None if noise is None else {"F": noise.sd[f"F_{name}"]}
        codes[f"F_{name}"] = limit_codes(robot, {"F": forces}, off, there)["F"]
    motors = None
    if robot.drive is not None:
        of = motor_states if first in FORMULATIONS else of_motor_forces
        motors = of(robot, robot.drive, shown.motion, F, shown.L_dot)
        values |= motors._asdict()
        codes |= limit_codes(robot, motors._asdict(), sd, there)
    tracker.add(slice(None), values, sd, there)
    unknown = None if noise is None else unknown_forces(F, np.where(noise.there[:, None], 0.0, noise.sd["F"]))
    told = [*([] if unknown is None else [(INCONCLUSIVE_NOISE, unknown)]), *tracker.told()]
    stated = any(limit.is_stated(robot) for limit in limits_of(robot))
    return LimitReport(stated, tuple(told), codes, F, motors, tracker)
