"""Control: the paper's paths tracked by controllers that differ in nothing but their model of the machine.

The plant is `exact` with friction, carried on in fixed steps between the samples of a controller that holds
its forces.
"""

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from ...drives.leg_limits import LegLimits, limited_angles
from ...dynamics.equations import ForwardDynamics, equations_of_motion
from ...dynamics.forces import ForceKernel, OnePose
from ...dynamics.inverse_dynamics import Formulation
from ...io.array_types import Array
from ...io.error_policy import errors_of
from ...io.progress import Progress, silent, tracked
from ...kinematics.inverse_kinematics import inverse_kinematics
from ...kinematics.mounting import path_for
from ...motion.motion import Motion
from ...motion.rotation import rotation_from_vector, vector_from_rotation
from ...motion.straight_line import StraightLinePath
from ...results import OK, STATUS_TEXT
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ...simulation.actuator_models import ForceLaw, GravityCompensation, Model, ModelTorque, Reference
from ...simulation.fixed_step import advance

CONTROLLERS = ("exact", "paper", "massless", "gravity")
TRACKED = ("I", "II")
"""Paths that can be tracked: Path III leads through singular poses."""

FRICTION = {"C_u": 0.1, "C_p": 100.0, "C_s": 0.1}
"""Friction of a machine with seals and bearings, N m s, N s/m and N m s, the same in every leg."""


@dataclass(frozen=True)
class Settings:
    """What all controllers and runs have in common.

    rate: samples of the controllers, Hz. k_p, 1/s^2, and k_d, 1/s: gains of the errors. offset_t, m, and
    offset_phi, rotation vector, rad, both in the path's axes: where the platform starts, seen from the path's
    start.
    step: longest of the integration, s.
    """

    rate: float = 1000.0
    k_p: float = 900.0
    k_d: float = 60.0
    offset_t: tuple[float, float, float] = (1e-4, 1e-4, 1e-4)
    offset_phi: tuple[float, float, float] = (1e-4, 1e-4, 1e-4)
    step: float = 1e-3

    @property
    def steps(self) -> int:
        """How many steps of the integration lie between two samples."""
        return math.ceil(1.0 / (self.rate * self.step) * (1.0 - 1e-12))


@dataclass(frozen=True, eq=False)
class Run:
    """One controller on one path, n samples.

    time: s, (n,). t: positions, m, (n, 3). R: (n, 3, 3). F: forces given at each sample, N, (n, 6).
    position, orientation: distance from the path, m, and angle from it, rad, (n,).
    """

    time: Array
    t: Array
    R: Array
    F: Array
    position: Array
    orientation: Array

    @property
    def largest_force(self) -> Array:
        """Magnitude of the force of whichever leg works hardest at each sample, N, (n,)."""
        return np.asarray(np.abs(self.F).max(axis=-1))


def figures(run: Run) -> dict[str, float]:
    """A run in numbers; settled: over the second half of the path, when the start is forgotten."""
    half = len(run.time) // 2
    found: dict[str, float] = {}
    for name, unit, errors in (("position", "mm", run.position), ("orientation", "mrad", run.orientation)):
        thousandths = 1e3 * errors
        found |= {
            f"{name}_rms_{unit}": _rms(thousandths),
            f"{name}_max_{unit}": float(thousandths.max()),
            f"{name}_settled_rms_{unit}": _rms(thousandths[half:]),
        }
    return found | {"force_peak_N": float(run.largest_force.max()), "force_rms_N": _rms(run.F)}


@dataclass(frozen=True, eq=False)
class Study:
    """Every controller on every path on one machine; runs by path, then by controller."""

    robot: Robot
    settings: Settings
    runs: Mapping[str, Mapping[str, Run]]
    exceeded: Sequence[str] = ()

    def rows(self) -> list[dict[str, Any]]:
        """A row for each path and controller: its figures, and their ratios to those of `exact`."""
        rows = []
        for path, runs in self.runs.items():
            exact = figures(runs["exact"])
            for controller, run in runs.items():
                numbers = figures(run)
                ratios = {f"{name}_to_exact": numbers[name] / exact[name] for name in numbers}
                rows.append({"path": path, "controller": controller, **numbers, **ratios})
        return rows

    def as_json(self) -> dict[str, Any]:
        """Machine and figures, as JSON takes them."""
        robot = self.robot
        friction = {name: getattr(robot, name).tolist() for name in ("C_u", "C_p", "C_s")}
        return {"robot": robot.name, "friction": friction, "rows": self.rows()}


def papers_machines() -> dict[str, Robot]:
    """The paper's machine with the friction it states, which is next to none, and with ``FRICTION``."""
    printed = dasgupta1998()
    C_u, C_p, C_s = (np.full(6, FRICTION[name]) for name in ("C_u", "C_p", "C_s"))
    name = f"{printed.name}, friction of {FRICTION['C_p']:g} N s/m in the legs"
    return {
        "printed": printed,
        "friction": dataclasses.replace(printed, name=name, C_u=C_u, C_p=C_p, C_s=C_s),
    }


class PreparedModel:
    """Inverse dynamics of one pose by the prepared C kernel, as the law of a controller calls it."""

    def __init__(self, robot: Robot, formulation: Formulation = "exact", fidelity: str = "general") -> None:
        """Prepare the kernel and its buffers; raises as ``ForceKernel``."""
        kernel = ForceKernel(robot, formulation, fidelity=fidelity, warns=False)
        self._slot: OnePose = kernel.single_pose()
        self._views = {each.name: getattr(self._slot, each.name) for each in fields(Motion)}

    def __call__(self, motion: Motion) -> Array:
        """Forces, N, (6,); NaN for an unsolvable pose."""
        for name, view in self._views.items():
            value = getattr(motion, name)
            view[...] = 0.0 if value is None else value
        return np.array(self._slot.F) if self._slot.solve() == OK else np.full(6, np.nan)


def controllers(robot: Robot, reference: Reference, settings: Settings) -> dict[str, ForceLaw]:
    """The four laws. `gravity` takes for its gains the machine's inertia at the start of the path."""
    gains = {"k_p": settings.k_p, "k_d": settings.k_d}
    models: dict[str, Model] = {
        "exact": PreparedModel(robot, "exact"),
        "paper": PreparedModel(robot, "paper"),
        "massless": PreparedModel(robot, fidelity="massless"),
    }
    inertia = equations_of_motion(robot, reference(0.0)).M
    return {
        **{name: ModelTorque(model, reference, **gains) for name, model in models.items()},
        "gravity": GravityCompensation(models["exact"], inertia, reference, **gains),
    }


def track_paths(
    robot: Robot,
    paths: Sequence[str] = TRACKED,
    settings: Settings | None = None,
    progress: Progress = silent,
) -> Study:
    """Track the paths named, of ``TRACKED``, with every controller.

    Raises ValueError of one line where a path or controller leads to an unsolvable pose,
    native.CompilerError without a C compiler.
    """
    settings = settings or Settings()
    runs: dict[str, dict[str, Run]] = {}
    beyond: list[str] = []
    for name in tracked(progress, paths, lambda name: f"tracking Path {name}"):
        path = path_for(robot, name).path
        with errors_of(f"{robot.name}: Path {name}: "):
            runs[name] = follow(robot, path, settings)
        run = runs[name]["exact"]
        motion = path.sample(run.time)
        legs, limits = inverse_kinematics(robot, motion), LegLimits(robot, run.time)
        values = {"F": run.F, "L": legs.L, "L_dot": legs.L_dot}
        limits.add(slice(None), values | limited_angles(robot, motion))
        beyond += [f"{robot.name}: Path {name}, controller exact: {line}" for line in limits.exceeded()]
    return Study(robot, settings, runs, beyond)


def follow(
    robot: Robot, path: StraightLinePath, settings: Settings, duration: float | None = None
) -> dict[str, Run]:
    """Track a path with every controller, side by side; duration: of it, s, None for all.

    Raises ValueError for a path or a run that comes to an unsolvable pose.
    """
    times = path.time_grid(1.0 / settings.rate)
    if duration is not None:
        times = times[times <= duration]
    motion = path.sample(times)
    at = {time: motion[i] for i, time in enumerate(times.tolist())}
    laws = controllers(robot, at.__getitem__, settings)
    start = _start(motion[0], np.array(path.axes), settings, len(laws))
    all_t, all_R, F = _runs(ForwardDynamics(robot), laws, times, start, settings.steps)
    found = {}
    for i, name in enumerate(laws):
        t, R = all_t[:, i], all_R[:, i]
        position = np.linalg.norm(t - motion.t, axis=-1)
        turn = vector_from_rotation(motion.R @ np.swapaxes(R, -1, -2))
        found[name] = Run(times, t, R, F[:, i], position, np.linalg.norm(turn, axis=-1))
    return found


def _runs(
    plant: ForwardDynamics, laws: Mapping[str, ForceLaw], times: Array, state: Motion, steps: int
) -> tuple[Array, Array, Array]:
    """t, (n, c, 3), R and forces, (n, c, 6), of n samples and c laws."""
    t, R, F = (np.empty((len(times), len(laws), *shape)) for shape in ((3,), (3, 3), (6,)))
    for i, time in enumerate(times.tolist()):
        t[i], R[i] = state.t, state.R
        for j, law in enumerate(laws.values()):
            F[i, j] = law(time, Motion._unchecked(state.R[j], state.t[j], state.omega[j], state.v[j]))
        _reject(laws, time, ["" if np.isfinite(of_law).all() else "no finite forces" for of_law in F[i]])
        if i + 1 < len(times):
            state, status = advance(plant, state, F[i], times[i + 1] - time, steps)
            _reject(laws, time, ["" if code == OK else STATUS_TEXT[code] for code in status.tolist()])
    return t, R, F


def _reject(laws: Mapping[str, ForceLaw], time: float, reasons: Sequence[str]) -> None:
    """Raise ValueError for the first law that there is a reason against."""
    for name, reason in zip(laws, reasons, strict=True):
        if reason:
            raise ValueError(f"controller {name}: at {time:g} s: {reason}")


def _start(reference: Motion, axes: Array, settings: Settings, count: int) -> Motion:
    R = rotation_from_vector(axes @ settings.offset_phi) @ reference.R
    t = reference.t + axes @ settings.offset_t
    return Motion(
        R=np.tile(R, (count, 1, 1)),
        t=np.tile(t, (count, 1)),
        omega=np.array(reference.omega),
        v=np.array(reference.v),
    )


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))
