"""Simulation: the machine set free under the forces of its legs, integrated until a time or a limit.

Orientation lives in a local chart, the rotation vector from a center that moves along, so that no attitude
is special and R stays orthonormal to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from ..drives.friction import losses
from ..dynamics.equations import ForwardDynamics
from ..dynamics.inverse_dynamics import Backend, Formulation
from ..io.arguments import instance, number_in, option, real_array, shown
from ..io.array_types import Array
from ..io.extras import needed_for
from ..motion.motion import Motion
from ..motion.rotation import one_vector_rate, orthonormal, rotation_from_vector, turned_by
from ..results import STATUS_TEXT
from ..robot.robot import Robot
from .actuator_models import ForceLaw
from .state_history import (
    Actuators,
    Load,
    Piece,
    SimulationResult,
    StopEvent,
    motion_of,
    output_times,
    sampled_at,
    saturation_of,
    six_forces,
)
from .stick_slip import StickSlip
from .stop_conditions import StopConditions, Watch, det_sign, need_between

Method = Literal["DOP853", "Radau"]
Progress = Callable[[float], None]
"""Called with the share that is done, 0 to 1."""
OnForceLimit = Literal["stop", "saturate"]
METHODS = ("DOP853", "Radau")
ON_FORCE_LIMIT = ("stop", "saturate")
CHART_RADIUS = 1.0
"""Angle from its center, rad, at which a chart is left for a new one; charts end at 2 pi."""
LONGEST = 86_400.0
"""Longest duration of a run, s: a day, which takes hours."""
MOST_INSTANTS = 10_000_000
"""Largest number of instants of a trace, and of calls of a law."""
RTOL_RANGE = (1e-13, 1e-2)
"""From where rounding is the error of a step to where the run is no longer that of the machine."""
_SQUARES_FINITE = 1e150


def simulate(
    robot: Robot,
    initial_state: Motion | Literal["path"],
    forces: ArrayLike | ForceLaw,
    duration: float,
    *,
    control_rate: float | None = None,
    load: Load | None = None,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    method: Method = "DOP853",
    rtol: float = 1e-9,
    atol: float = 1e-12,
    output_step: float | None = None,
    stop_conditions: StopConditions | None = None,
    on_force_limit: OnForceLimit = "stop",
    progress: Progress | None = None,
) -> SimulationResult:
    """Integrate the machine's motion from a state, under actuator forces, for a duration, s.

    A run stops before its end where a leg or the angle of a joint reaches a limit of the robot, or a leg a
    threshold; the place is a root of
    the interpolated motion, to rounding. Limits are looked at ``WATCHED`` times a step: a leg that passes one
    and is back within that is not seen. A singular pose that is crossed, where det H changes its sign, is
    seen however short the time near it; the run then ends where the condition number passes its threshold.

    Where the robot's drives have friction or an efficiency below 1, forces are those of the motors, N times
    torque, and legs stick and slip: one that sticks does not move at all. ``SimulationResult.drives`` has
    what they lost.

    Parameters
    ----------
    robot : Robot
        The machine.
    initial_state : Motion or {"path"}
        Motion of shape (); its accelerations don't count, its load F_ext, M_ext stays on. "path": that which
        the law, one with a wanted motion, wants at the start.
    forces : array_like or ForceLaw
        N, (6,), or a law (time, state) -> N, (6,). A law must depend on its arguments alone, unless there is
        a rate: then it is called at 0, 1/rate, 2/rate, ... s, once each, and its forces are held between.
    duration : float
        Length of the run, s, at most ``LONGEST``.
    control_rate : float, optional
        Of the calls of a law, Hz, at most ``MOST_INSTANTS`` of them; None: as often as the integration needs.
    load : Load, optional
        (time, state) -> [F_ext; M_ext], platform frame, in place of the state's load.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    backend : {"c", "numpy", "reference"}, optional
        What computes.
    method : Method, optional
        "DOP853", or "Radau" where springs or dampers are stiff.
    rtol : float, optional
        Relative error of a step, in ``RTOL_RANGE``.
    atol : float, optional
        Absolute error of a step, in m, rad, m/s and rad/s.
    output_step : float, optional
        s, between instants of the trace, at most ``MOST_INSTANTS``; None: as integrated.
    stop_conditions : StopConditions, optional
        None for the default ones.
    on_force_limit : OnForceLimit, optional
        Where a force reaches the robot's force_limit, the run ends ("stop"), or the force is clipped to it
        ("saturate") and ``saturation`` reports it.
    progress : Progress, optional
        Called now and then with the share done, 0 to 1.

    Returns
    -------
    SimulationResult
        Shapes and units are documented there.

    Raises
    ------
    ValueError
        Naming the argument: unknown options, numbers out of range, a state in which the machine has no
        accelerations, forces that are not six numbers; ImportError without SciPy.
    """
    instance(robot, Robot, "robot")
    law = _law(forces)
    start = _state(initial_state, law)
    option(method, METHODS, "method")
    option(on_force_limit, ON_FORCE_LIMIT, "on_force_limit")
    need_between(atol, "atol", 0.0, math.inf)
    check_duration(duration)
    if control_rate is not None:
        need_between(control_rate, "control_rate", 0.0, math.inf)
        if duration * control_rate > MOST_INSTANTS:
            raise ValueError(
                f"control_rate: expected at most {MOST_INSTANTS / duration:g} Hz, for at most "
                f"{MOST_INSTANTS} calls in {duration:g} s, got {shown(control_rate)}"
            )
    check_rtol(rtol)
    check_output_step(output_step, duration)
    for name, function, call in (
        ("load", load, "(time, state) -> six numbers"),
        ("progress", progress, "(share)"),
    ):
        if function is not None and not callable(function):
            raise ValueError(f"{name}: expected a function {call}, got {type(function).__name__}")
    if stop_conditions is not None:
        instance(stop_conditions, StopConditions, "stop_conditions")
    unlimited = np.full(6, math.inf)
    clips = on_force_limit == "saturate"
    actuators = Actuators(law, robot.force_limit if clips else unlimited)
    stops_at = unlimited if clips else robot.force_limit
    run = _Run(
        robot=robot,
        accelerations=ForwardDynamics(robot, formulation, backend).one_state(),
        actuators=actuators,
        load=load,
        constant=(start.F_ext, start.M_ext),
        solver=_solver(method),
        tolerances={"rtol": float(rtol), "atol": float(atol)},
        watch=Watch(robot, stop_conditions or StopConditions(), stops_at, det_sign(robot, start)),
        reached=lambda time: None if progress is None else progress(time / duration),
    )
    if robot.drive is not None and losses(robot.drive):
        if robot.offsets is not None:
            raise ValueError(
                "robot: expected offsets or friction of the drives, got both: legs that stick are simulated "
                "without offsets"
            )
        run.sticking = StickSlip(robot, robot.drive, run.accelerations, run._loaded)
    stop = run.through(start, float(duration), control_rate)
    pieces = tuple(run.pieces)
    times = output_times(pieces, stop.time, output_step)
    trace = sampled_at(robot, actuators, pieces, times)
    return SimulationResult(
        **vars(trace),
        stop=stop,
        saturation=saturation_of(actuators, pieces),
        _robot=robot,
        _actuators=actuators,
        _pieces=pieces,
        drive_work=None if run.sticking is None else run.sticking.results(pieces, actuators, times),
        has_load=load is not None or any(each is not None and np.any(each) for each in run.constant),
    )


@dataclass(eq=False)
class _Run:
    """One run's parts, and the integration from state to state.

    y, center: numbers of the chart at ``time``, s, and its center. step: that which is tried next, s, None
    where the solver finds one. sampled: what the law commanded last, N, (6,), None unless it is sampled.
    fault: the last status that is not 0. unknown: which input left the last accelerations without numbers.
    """

    robot: Robot
    accelerations: Callable[[Motion, Array], tuple[Array, int]]
    actuators: Actuators
    load: Load | None
    constant: tuple[Array | None, Array | None]
    solver: Any
    tolerances: dict[str, float]
    watch: Watch
    reached: Callable[[float], None]
    fault: int = 0
    unknown: str = ""
    sticking: StickSlip | None = None
    pieces: list[Piece] = field(default_factory=list)
    time: float = 0.0
    step: float | None = None
    sampled: Array | None = None
    y: Array = field(init=False)
    center: Array = field(init=False)

    def through(self, state: Motion, duration: float, rate: float | None) -> StopEvent:
        """Go from sample to sample of the law, or in one go, until the end or a stop."""
        self.y = np.concatenate([state.t, np.zeros(3), state.v, state.omega])
        self.center = np.array(state.R)
        sample = 0
        while self.time < duration:
            sample += 1
            if rate is not None:
                self.sampled = six_forces(self.actuators.law(self.time, self._state()), self.time)
            self._settle(first=sample == 1)
            if sample == 1:
                if not np.isfinite(self._rates(0.0, self.y)).all():
                    raise ValueError(self.unknown or f"initial_state: no accelerations: {self._reason()}")
                self.fault = 0
            end = duration if rate is None else min(sample / rate, duration)
            while self.time < end:
                stop = self._chart(end)
                if stop is not None:
                    return stop
        return StopEvent("completed", duration, None, f"ran to its end at {duration:g} s")

    def _chart(self, end: float) -> StopEvent | None:
        """Integrate in one chart, to its rim or to ``end``, and go over to a chart of its own."""
        first = None if self.step is None else min(self.step, end - self.time)
        modes = () if self.sticking is None else self.sticking.modes
        solver = self.solver(self._rates, self.time, self.y, end, first_step=first, **self.tolerances)
        while solver.status == "running" and np.linalg.norm(solver.y[3:6]) < CHART_RADIUS:
            solver.step()
            if solver.status == "failed":
                text = f"no step is small enough at {solver.t:.9g} s: {self._reason()}"
                if not self.pieces:
                    raise ValueError(self.unknown or f"initial_state: {text}")
                return StopEvent("step_failed", solver.t, None, text)
            dense = solver.dense_output()
            piece = Piece(solver.t_old, solver.t, dense, self.center, self.sampled, modes)
            change = None if self.sticking is None else self.sticking.first_change(piece, self.actuators)
            if change is not None:
                piece = piece._replace(end=change.time)
            stop = self.watch.first(piece, self.actuators)
            if stop is not None:
                # A stop where the step begins leaves no piece but the first, which the trace needs.
                if stop.time > piece.start or not self.pieces:
                    self.pieces.append(piece._replace(end=stop.time))
                return stop
            self.pieces.append(piece)
            self.reached(piece.end)
            if change is not None:
                return self._changed(piece)
        self.time, self.step = float(solver.t), float(solver.h_abs)
        self._recenter(solver.y)
        return None

    def _changed(self, piece: Piece) -> StopEvent | None:
        """Go on after a leg has come to rest or broken away at the end of a piece."""
        assert self.sticking is not None
        self.time, self.step = piece.end, None
        self._recenter(piece.interpolant(piece.end))
        if piece.end <= piece.start and len(self.pieces) > 1:
            self.pieces.pop()
        if self.sticking.stalled:
            text = f"legs stick and slip without end at {piece.end:.9g} s"
            return StopEvent("step_failed", piece.end, None, text)
        self._settle()
        return None

    def _recenter(self, y: Array) -> None:
        """Go over to a chart whose center is where the state is."""
        self.center = orthonormal(rotation_from_vector(y[3:6]) @ self.center)
        self.y = np.concatenate([y[:3], np.zeros(3), y[6:]])

    def _settle(self, first: bool = False) -> None:
        """Decide which legs stick; these are at rest then."""
        if self.sticking is None:
            return
        state = self._state()
        F = self.actuators.at(self.time, state, self.sampled)
        still = (self.sticking.begin if first else self.sticking.settled)(self.time, state, F)
        self.y = np.concatenate([self.y[:6], still.v, still.omega])

    def _state(self) -> Motion:
        return motion_of(self.y, self.center)

    def _rates(self, time: float, y: Array) -> Array:
        if not np.abs(y).max() < _SQUARES_FINITE:
            # A step that is far too long, which the solver shortens.
            return np.full_like(y, math.nan)
        state = Motion._unchecked(turned_by(y[3:6], self.center), y[:3], omega=y[9:], v=y[6:9])
        if self.sticking is not None:
            state = self.sticking.moving(state)
        F = self.actuators.at(time, state, self.sampled)
        loaded = self._loaded(time, state)
        if self.sticking is None:
            acceleration, status = self.accelerations(loaded, F)
        else:
            found = self.sticking.solved(loaded, F)
            acceleration, status = found.acceleration, found.status
        self.fault = status or self.fault
        if not np.isfinite(acceleration).all():
            self.unknown = _unknown(time, loaded, F)
        return np.concatenate([state.v, one_vector_rate(y[3:6], state.omega), acceleration])

    def _loaded(self, time: float, state: Motion) -> Motion:
        F_ext, M_ext = self.constant
        if self.load is not None:
            wrench = real_array(self.load(time, state), "load", "six numbers, [F_ext; M_ext]")
            if wrench.shape != (6,):
                raise ValueError(f"load: expected six numbers, [F_ext; M_ext], got shape {wrench.shape}")
            F_ext, M_ext = wrench[:3], wrench[3:]
        return Motion._unchecked(state.R, state.t, state.omega, state.v, F_ext=F_ext, M_ext=M_ext)

    def _reason(self) -> str:
        if self.unknown:
            return self.unknown
        return STATUS_TEXT[self.fault] if self.fault else "forces or accelerations grow without bound"


def _unknown(time: float, state: Motion, F: Array) -> str:
    """A line about a load or forces that are no finite numbers; nothing where both are."""
    for name, value in (("load", state.external_wrench()), ("forces", F)):
        if not np.isfinite(value).all():
            return f"{name}: expected six finite numbers at {time:.9g} s, got {shown(value)}"
    return ""


def check_duration(duration: object) -> None:
    """Reject, by ValueError, what is no number > 0 and at most ``LONGEST``, s."""
    need_between(duration, "duration", 0.0, math.inf)
    number_in(duration, "duration", f"at most {LONGEST:g} s, a day", high=LONGEST, closed=True)


def check_rtol(rtol: object) -> None:
    """Reject, by ValueError, what is no number in ``RTOL_RANGE``."""
    low, high = RTOL_RANGE
    number_in(rtol, "rtol", f"a number in [{low:g}, {high:g}]", low, high, closed=True)


def check_output_step(output_step: float | None, duration: float) -> None:
    """Reject, by ValueError, what is no number > 0, or makes more than ``MOST_INSTANTS`` of a duration, s."""
    if output_step is None:
        return
    need_between(output_step, "output_step", 0.0, math.inf)
    if duration > MOST_INSTANTS * output_step:
        raise ValueError(
            f"output_step: expected at least {duration / MOST_INSTANTS:g} s, for at most {MOST_INSTANTS} "
            f"instants in {duration:g} s, got {shown(output_step)}"
        )


def _law(forces: ArrayLike | ForceLaw) -> ForceLaw:
    if callable(forces):
        return forces
    constant = real_array(forces, "forces", "six finite numbers or a law")
    if constant.shape != (6,) or not np.isfinite(constant).all():
        raise ValueError(f"forces: expected six finite numbers or a law, got shape {constant.shape}")
    return lambda time, state: constant


def _state(given: Motion | str, law: ForceLaw) -> Motion:
    if isinstance(given, str):
        wanted = getattr(law, "reference", None)
        if given != "path" or wanted is None:
            text = 'a Motion, or "path" with a law that follows one'
            raise ValueError(f"initial_state: expected {text}, got {shown(given)}")
        start: Motion = wanted(0.0)
        return Motion(
            R=start.R, t=start.t, omega=start.omega, v=start.v, F_ext=start.F_ext, M_ext=start.M_ext
        )
    instance(given, Motion, "initial_state")
    if given.shape != ():
        raise ValueError(f"initial_state: expected one state, of shape (), got {given.shape}")
    return given


def _solver(method: str) -> Any:
    with needed_for("simulation"):
        from scipy import integrate
    return getattr(integrate, method)
