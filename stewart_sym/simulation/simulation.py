"""Simulation of a robot under actuator forces until a given time or a stop condition.

The coordinates of the orientation are a quaternion of any length. No orientation is singular in these
coordinates, and R remains orthonormal to rounding.
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
from ..motion.motion import Motion
from ..motion.rotation import one_quaternion_rate, one_rotation, quaternion_from_rotation
from ..results import STATUS_TEXT
from ..robot.robot import Robot
from .actuator_models import ForceLaw
from .state_history import (
    Actuators,
    Load,
    Piece,
    SimulationResult,
    StopEvent,
    output_times,
    sampled_at,
    saturation_of,
    six_forces,
)
from .stick_slip import StickSlip
from .stop_conditions import StopConditions, Watch, det_sign, need_between

Method = Literal["DOP853", "RK45", "Radau"]
Progress = Callable[[float], None]
"""Function that is called with the completed fraction, 0 to 1."""
OnForceLimit = Literal["stop", "saturate"]
METHODS = ("DOP853", "RK45", "Radau")
ON_FORCE_LIMIT = ("stop", "saturate")
LONGEST = 86_400.0
"""Longest duration of a simulation (s): one day, which takes hours to compute."""
MOST_INSTANTS = 10_000_000
"""Largest number of output samples, and of calls of a sampled law."""
RTOL_RANGE = (1e-13, 1e-2)
"""Range of ``rtol``: below it rounding errors dominate, above it the solution is meaningless."""
_SQUARES_FINITE = 1e150
_WATCHED_TOGETHER = 50
"""Number of pieces of a sampled law whose stop conditions are checked together."""


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
    method: Method | None = None,
    rtol: float = 1e-9,
    atol: float = 1e-12,
    output_step: float | None = None,
    stop_conditions: StopConditions | None = None,
    on_force_limit: OnForceLimit = "stop",
    progress: Progress | None = None,
) -> SimulationResult:
    """Integrate the equations of motion from an initial state under actuator forces.

    Parameters
    ----------
    robot : Robot
        Robot model.
    initial_state : Motion or {"path"}
        Initial state, shape (), in the base frame. Its accelerations are ignored; its load F_ext, M_ext is
        constant in the platform frame. "path" starts at the start of the reference motion of a law.
    forces : array_like, shape (6,), or callable
        Actuator forces (N), or a law (time, state) -> forces (N), shape (6,). Without ``control_rate`` a law
        must depend on its arguments only.
    duration : float
        Duration (s), at most 86400.
    control_rate : float, optional
        Sampling rate of the law (Hz), with at most 10^7 samples. The law is called once per sample, and its
        forces are constant in between. By default the integrator calls it as often as necessary.
    load : callable, optional
        Function (time, state) -> [F_ext; M_ext] (N and N m) in the platform frame, shape (6,). It replaces
        the load of the initial state.
    formulation : {"exact", "paper"}, optional
        Corrected equations or equations as printed.
    backend : {"c", "numpy", "reference"}, optional
        Implementation of forward dynamics.
    method : {"DOP853", "RK45", "Radau"}, optional
        Integration method of SciPy: explicit Runge-Kutta of order 8 or 5, or implicit for stiff springs and
        dampers. By default "RK45" with ``control_rate``, otherwise "DOP853".
    rtol : float, optional
        Relative error tolerance of a step, from 1e-13 to 1e-2.
    atol : float, optional
        Absolute error tolerance of a step (m, rad, m/s, and rad/s).
    output_step : float, optional
        Time step of the result (s), with at most 10^7 samples; by default the steps of the integrator.
    stop_conditions : StopConditions, optional
        Limits of the model; by default ``StopConditions()``.
    on_force_limit : {"stop", "saturate"}, optional
        Effect of the force limit of the robot: "stop" ends the simulation there, "saturate" clips the forces
        and reports it in ``saturation``.
    progress : callable, optional
        Function that is called with the completed fraction, 0 to 1.

    Returns
    -------
    SimulationResult
        States, forces, and energies over time, and the stop event.

    Raises
    ------
    ValueError
        If an argument is invalid, if the initial state has no accelerations, or if a law or a load does not
        return six finite numbers.

    See Also
    --------
    forward_dynamics : Accelerations of single states.
    LegSprings : Passive legs with stiffness and damping.
    ComputedTorque : Tracking control by inverse dynamics.

    Notes
    -----
    A simulation stops before its end if a leg or a joint angle reaches a limit of the robot or a stop
    condition. The stop time is a root of the interpolated motion, accurate to rounding. Limits are checked at
    five times in each step; a limit that is exceeded and satisfied again in between is not detected. The sign
    of det H detects each crossing of a singularity; the simulation then stops at the time at which the
    condition number reaches ``max_condition``.

    If the drives of the robot have friction or an efficiency below 1, the forces are motor forces (motor
    torque times transmission ratio), and each leg sticks or slips. A sticking leg does not move.
    ``SimulationResult.drive_work`` contains the dissipated energy.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> state = ss.PAPER_PATHS["I"].path.sample(0.0)
    >>> run = ss.simulate(robot, state, forces=np.zeros(6), duration=0.1, output_step=0.05)
    >>> run.stop.reason
    'completed'
    >>> run.t[:, 2].round(4)
    array([0.4   , 0.3884, 0.3535])

    Without forces the platform falls until it reaches a singular pose:

    >>> run = ss.simulate(robot, state, forces=np.zeros(6), duration=1.0)
    >>> run.stop.reason, round(run.stop.time, 3)
    ('singular', 0.206)
    """
    from scipy import integrate

    instance(robot, Robot, "robot")
    law = _law(forces)
    start = _state(initial_state, law)
    if method is None:
        method = "DOP853" if control_rate is None else "RK45"
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
        ("progress", progress, "(fraction)"),
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
        solver=getattr(integrate, method),
        tolerances={"rtol": float(rtol), "atol": float(atol)},
        watch=Watch(robot, stop_conditions or StopConditions(), stops_at, det_sign(robot, start)),
        reached=lambda time: None if progress is None else progress(time / duration),
    )
    if robot.drive is not None and losses(robot.drive):
        if robot.offsets is not None:
            raise ValueError(
                "robot: expected joint offsets or drive friction, got both: stick-slip friction is supported "
                "for robots without joint offsets only"
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
    """Parts and current state of one simulation, and its integration."""

    robot: Robot
    accelerations: Callable[[Motion, Array], tuple[Array, int]]
    actuators: Actuators
    load: Load | None
    constant: tuple[Array | None, Array | None]
    solver: Any
    tolerances: dict[str, float]
    watch: Watch
    reached: Callable[[float], None]
    # Last nonzero status, and message about the input for which the last accelerations were not finite.
    fault: int = 0
    unknown: str = ""
    sticking: StickSlip | None = None
    pieces: list[Piece] = field(default_factory=list)
    # Number of the last pieces whose stop conditions are not checked yet.
    unwatched: int = 0
    time: float = 0.0
    # Next trial step (s), None if the solver chooses it; last forces of a sampled law (N).
    step: float | None = None
    sampled: Array | None = None
    # Coordinates [t; quaternion; v; omega], shape (13,).
    y: Array = field(init=False)

    def through(self, state: Motion, duration: float, rate: float | None) -> StopEvent:
        """Integrate until the end or a stop condition, with one call of a sampled law per sample."""
        self.y = np.concatenate([state.t, quaternion_from_rotation(state.R), state.v, state.omega])
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
                stop = self._integrated(end)
                if stop is not None:
                    return stop
        return self._stop() or StopEvent("completed", duration, None, f"ran to its end at {duration:g} s")

    def _integrated(self, end: float) -> StopEvent | None:
        """Integrate until ``end`` or until a leg changes between sticking and slipping."""
        first = None if self.step is None else min(self.step, end - self.time)
        modes = () if self.sticking is None else self.sticking.modes
        solver = self.solver(self._rates, self.time, self.y, end, first_step=first, **self.tolerances)
        while solver.status == "running":
            solver.step()
            if solver.status == "failed":
                return self._failed(float(solver.t))
            piece = Piece(solver.t_old, solver.t, solver.dense_output(), self.sampled, modes)
            change = None if self.sticking is None else self.sticking.first_change(piece, self.actuators)
            if change is not None:
                piece = piece._replace(end=change.time)
            self.pieces.append(piece)
            self.unwatched += 1
            # Pieces of a sampled law are short; several together take less time.
            if self.sampled is None or change is not None or self.unwatched >= _WATCHED_TOGETHER:
                stop = self._stop()
                if stop is not None:
                    return stop
            self.reached(piece.end)
            if change is not None:
                return self._changed(piece)
        self.time, self.step, self.y = float(solver.t), float(solver.h_abs), solver.y
        return None

    def _stop(self) -> StopEvent | None:
        """Return the first stop event in the pieces that are not checked yet, and end the run there."""
        pieces, self.unwatched = self.pieces[len(self.pieces) - self.unwatched :], 0
        found = self.watch.first(pieces, self.actuators) if pieces else None
        if found is None:
            return None
        i, stop = found
        del self.pieces[len(self.pieces) - len(pieces) + i :]
        # A stop at the start of a step adds no piece, but the history requires at least one.
        if stop.time > pieces[i].start or not self.pieces:
            self.pieces.append(pieces[i]._replace(end=stop.time))
        return stop

    def _failed(self, time: float) -> StopEvent:
        """Return the event of a step that cannot be made small enough at a time (s)."""
        stop = self._stop()
        if stop is not None:
            return stop
        text = f"no step is small enough at {time:.9g} s: {self._reason()}"
        if not self.pieces:
            raise ValueError(self.unknown or f"initial_state: {text}")
        return StopEvent("step_failed", time, None, text)

    def _changed(self, piece: Piece) -> StopEvent | None:
        """Continue after a leg has changed between sticking and slipping at the end of a piece."""
        assert self.sticking is not None
        self.time, self.step = piece.end, None
        self.y = piece.interpolant(piece.end)
        if piece.end <= piece.start and len(self.pieces) > 1:
            self.pieces.pop()
        if self.sticking.stalled:
            text = f"legs alternate endlessly between sticking and slipping at {piece.end:.9g} s"
            return StopEvent("step_failed", piece.end, None, text)
        self._settle()
        return None

    def _settle(self, first: bool = False) -> None:
        """Decide which legs stick, and set their rates to zero."""
        if self.sticking is None:
            return
        state = self._state()
        F = self.actuators.at(self.time, state, self.sampled)
        still = (self.sticking.begin if first else self.sticking.settled)(self.time, state, F)
        self.y = np.concatenate([self.y[:7], still.v, still.omega])

    def _state(self) -> Motion:
        """Return the current state."""
        return self._at(self.y)

    def _at(self, y: Array) -> Motion:
        """Return the state at coordinates, shape (13,), as ``motion_of`` in less time."""
        return Motion._unchecked(one_rotation(y[3:7]), y[:3], omega=y[10:], v=y[7:10])

    def _rates(self, time: float, y: Array) -> Array:
        """Compute the time derivative of the coordinates, shape (13,)."""
        if not np.abs(y).max() < _SQUARES_FINITE:
            # NaN makes the solver shorten a step that is much too long.
            return np.full_like(y, math.nan)
        state = self._at(y)
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
        # A sum is not finite if one of the numbers is not.
        if not math.isfinite(float(acceleration.sum())):
            self.unknown = _unknown(time, loaded, F)
        return np.concatenate([state.v, one_quaternion_rate(y[3:7], state.omega), acceleration])

    def _loaded(self, time: float, state: Motion) -> Motion:
        """Return a state with its load."""
        F_ext, M_ext = self.constant
        if self.load is not None:
            wrench = real_array(self.load(time, state), "load", "six numbers, [F_ext; M_ext]")
            if wrench.shape != (6,):
                raise ValueError(f"load: expected six numbers, [F_ext; M_ext], got shape {wrench.shape}")
            F_ext, M_ext = wrench[:3], wrench[3:]
        elif F_ext is None and M_ext is None:
            return state
        return Motion._unchecked(state.R, state.t, state.omega, state.v, F_ext=F_ext, M_ext=M_ext)

    def _reason(self) -> str:
        """Return the reason for a failed step."""
        if self.unknown:
            return self.unknown
        return STATUS_TEXT[self.fault] if self.fault else "forces or accelerations grow without bound"


def _unknown(time: float, state: Motion, F: Array) -> str:
    """Return a message if the load or the forces are not finite, otherwise an empty string."""
    for name, value in (("load", state.external_wrench()), ("forces", F)):
        if not np.isfinite(value).all():
            return f"{name}: expected six finite numbers at {time:.9g} s, got {shown(value)}"
    return ""


def check_duration(duration: object) -> None:
    """Raise ValueError unless the duration (s) is a number > 0 and at most ``LONGEST``."""
    need_between(duration, "duration", 0.0, math.inf)
    number_in(duration, "duration", f"at most {LONGEST:g} s, a day", high=LONGEST, closed=True)


def check_rtol(rtol: object) -> None:
    """Raise ValueError unless ``rtol`` is a number in ``RTOL_RANGE``."""
    low, high = RTOL_RANGE
    number_in(rtol, "rtol", f"a number in [{low:g}, {high:g}]", low, high, closed=True)


def check_output_step(output_step: float | None, duration: float) -> None:
    """Raise ValueError unless the step (s) is > 0 and gives at most ``MOST_INSTANTS`` samples."""
    if output_step is None:
        return
    need_between(output_step, "output_step", 0.0, math.inf)
    if duration > MOST_INSTANTS * output_step:
        raise ValueError(
            f"output_step: expected at least {duration / MOST_INSTANTS:g} s, for at most {MOST_INSTANTS} "
            f"samples in {duration:g} s, got {shown(output_step)}"
        )


def _law(forces: ArrayLike | ForceLaw) -> ForceLaw:
    """Return a force law; constant forces become a law."""
    if callable(forces):
        return forces
    constant = real_array(forces, "forces", "six finite numbers or a law")
    if constant.shape != (6,) or not np.isfinite(constant).all():
        raise ValueError(f"forces: expected six finite numbers or a law, got shape {constant.shape}")
    return lambda time, state: constant


def _state(given: Motion | str, law: ForceLaw) -> Motion:
    """Return the initial state, from the reference motion of the law for "path"."""
    if isinstance(given, str):
        reference = getattr(law, "reference", None)
        if given != "path" or reference is None:
            text = 'a Motion, or "path" with a law that has a reference motion'
            raise ValueError(f"initial_state: expected {text}, got {shown(given)}")
        start: Motion = reference(0.0)
        return Motion(
            R=start.R, t=start.t, omega=start.omega, v=start.v, F_ext=start.F_ext, M_ext=start.M_ext
        )
    instance(given, Motion, "initial_state")
    if given.shape != ():
        raise ValueError(f"initial_state: expected one state, of shape (), got {given.shape}")
    return given
