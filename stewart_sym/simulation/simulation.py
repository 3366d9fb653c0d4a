"""Simulation: the machine set free under the forces of its legs, integrated until a time or a limit.

Stands on ``equations``, whose forward dynamics it integrates by SciPy (extra ``sim``). Orientation lives in a
local chart, the rotation vector from a centre that moves along, so that no attitude is special and R stays
orthonormal to rounding. Knows charts, steps and limits; knows no equation of the machine.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.equations import ForwardDynamics
from ..dynamics.inverse import Backend, Formulation
from ..io.arguments import instance, option, real_array, shown
from ..io.extras import needed_for
from ..kinematics.conditioning import characteristic_length, condition_number
from ..kinematics.inverse import leg_vectors, tip_velocities
from ..motion import rotation_vector
from ..motion.motion import Motion
from ..motion.rotation import cross, orthonormal, rotation_from_vector
from ..reference import newton_euler
from ..results import STATUS_TEXT
from ..robot.robot import Robot
from .actuator_models import ForceLaw

Array = NDArray[np.float64]
Method = Literal["DOP853", "Radau"]
Load = Callable[[float, Motion], ArrayLike]
"""(time, s, state) -> [F_ext; M_ext], N and N m, platform frame, (6,)."""

Progress = Callable[[float], None]
"""Is told the share that is done, 0 to 1."""
OnForceLimit = Literal["stop", "saturate"]

METHODS = ("DOP853", "Radau")
ON_FORCE_LIMIT = ("stop", "saturate")
CHART_RADIUS = 1.0
"""Angle from its centre, rad, at which a chart is left for a new one; charts end at 2 pi."""
WATCHED = 5
"""Instants of each step at which limits are looked at."""
NEAR_SINGULAR, CROSSING = 36, 37
"""Columns of the watched margins: condition number of H, and det H on the side where the run began."""
MOST_INSTANTS = 10_000_000
"""Of a trace."""
RTOL_RANGE = (1e-13, 1e-2)
"""From where rounding is the error of a step to where the run is no longer that of the machine."""


@dataclass(frozen=True)
class Thresholds:
    """Where a run stops because the model ends, besides the robot's own limits.

    max_condition: scaled condition number of H (see ``scaled_condition_number``), > 1; inf: a run goes
    through singular poses.
    min_length: of a leg, m, > 0; None: a thousandth of the machine's characteristic length.
    min_joint_sine: sine of the angle between a leg and its universal axis, > 0 and < 1.

    Raises ValueError naming the argument.
    """

    max_condition: float = 1e6
    min_length: float | None = None
    min_joint_sine: float = 1e-3

    def __post_init__(self) -> None:
        """Check every threshold."""
        ranges = {
            "max_condition": (1.0, math.inf),
            "min_length": (0.0, math.inf),
            "min_joint_sine": (0.0, 1.0),
        }
        for name, (low, high) in ranges.items():
            value = getattr(self, name)
            through = name == "max_condition" and isinstance(value, float) and value == math.inf
            if value is not None and not through:
                _number(value, name, low, high)


@dataclass(frozen=True)
class Stop:
    """Why and when a run ended.

    kind: "duration" (it ran to its end), "length_limits", "speed_limit", "force_limit", "singular",
    "zero_length", "joint singularity" or "failed" (no step is small enough).
    time: s. leg: its number from 1, None where no leg is to blame. text: all of it in one line.
    """

    kind: str
    time: float
    leg: int | None
    text: str


@dataclass(frozen=True, eq=False)
class Saturation:
    """How long and by how much each leg's actuator was asked for more than its limit; zeros if it never was.

    time: s, (6,), of a law that is not sampled to a small part of a step. excess: the largest force beyond
    the limit, N, (6,).
    """

    time: Array
    excess: Array


@dataclass(frozen=True, eq=False)
class Trace:
    """States and forces at n instants; SI units, base frame.

    times: s, (n,). R: (n, 3, 3). t, v: m and m/s, (n, 3). omega: rad/s, (n, 3).
    F: actuator forces, N, (n, 6). L: leg lengths, m, (n, 6).
    kinetic, potential: energy of the platform and the twelve leg parts, J, (n,), with the exact kinematics of
    the legs in either formulation; the potential energy is that of weight, zero at the base frame's origin.
    """

    times: Array
    R: Array
    t: Array
    v: Array
    omega: Array
    F: Array
    L: Array
    kinetic: Array
    potential: Array

    @property
    def energy(self) -> Array:
        """Kinetic and potential energy, J, (n,)."""
        return self.kinetic + self.potential

    @property
    def motion(self) -> Motion:
        """The states as a Motion of shape (n,) without accelerations."""
        return Motion(self.R, self.t, self.omega, self.v)


class _Actuators(NamedTuple):
    """The law and the limits, N, (6,), inf for none, to which the forces it asks for are clipped."""

    law: ForceLaw
    limit: Array

    def at(self, time: float, state: Motion) -> Array:
        """Forces of one state, N, (6,)."""
        return self.clipped(six_forces(self.law(time, state), time))

    def asked(self, when: Array, states: Motion, held: Array | None) -> Array:
        """Forces that the law asks for at n instants, N, (n, 6)."""
        if held is not None:
            return np.broadcast_to(held, (len(when), 6))
        rows = [
            Motion.unchecked(states.R[i], states.t[i], states.omega[i], states.v[i]) for i in range(len(when))
        ]
        found = [six_forces(self.law(float(time), row), time) for time, row in zip(when, rows, strict=True)]
        return np.array(found).reshape(-1, 6)

    def forces(self, when: Array, states: Motion, held: Array | None) -> Array:
        """Forces that act at n instants, N, (n, 6)."""
        return self.clipped(self.asked(when, states, held))

    def clipped(self, F: Array) -> Array:
        """Forces (..., 6) within the limits."""
        return np.minimum(np.maximum(F, -self.limit), self.limit)


class _Piece(NamedTuple):
    """An accepted step: its times, the interpolant of the chart's numbers, the centre, the held forces.

    held: as the law asked for them; None where the law is not sampled.
    """

    start: float
    end: float
    interpolant: Callable[[Any], Array]
    center: Array
    held: Array | None


@dataclass(frozen=True, eq=False)
class Simulation(Trace):
    """A run: its trace, why it stopped, how its forces saturated, and any instant between by ``at``."""

    stop: Stop
    saturation: Saturation
    _robot: Robot
    _actuators: _Actuators
    _pieces: tuple[_Piece, ...]

    @property
    def steps(self) -> int:
        """How many steps the integration took."""
        return len(self._pieces)

    def at(self, times: ArrayLike) -> Trace:
        """States and forces at times, s, (n,), interpolated to the accuracy of the run.

        Raises ValueError for times outside the run.
        """
        when = real_array(times, "times", "times of shape (n,)")
        end = self.stop.time
        if when.ndim != 1:
            raise ValueError(f"times: expected shape (n,), got {when.shape}")
        outside = ~((when >= 0.0) & (when <= end))
        if outside.any():
            raise ValueError(f"times: expected times in [0, {end:g}] s, got {when[outside][0]:g}")
        return _sampled(self._robot, self._actuators, self._pieces, when)


def simulate(
    robot: Robot,
    initial_state: Motion | Literal["path"],
    forces: ArrayLike | ForceLaw,
    duration: float,
    *,
    rate: float | None = None,
    load: Load | None = None,
    formulation: Formulation = "exact",
    backend: Backend = "c",
    method: Method = "DOP853",
    rtol: float = 1e-9,
    atol: float = 1e-12,
    output_step: float | None = None,
    thresholds: Thresholds | None = None,
    on_force_limit: OnForceLimit = "stop",
    progress: Progress | None = None,
) -> Simulation:
    """Integrate the machine's motion from a state, under actuator forces, for a duration, s.

    initial_state: Motion of shape (); its accelerations don't count, its load F_ext, M_ext stays on. "path":
    that which the law, one with a wanted motion, wants at the start.
    forces: N, (6,), or a law (time, state) -> (6,). A law must depend on its arguments alone, unless
    rate: Hz; then it is asked at 0, 1/rate, 2/rate, ... s, once each, and its forces are held between.
    load: (time, state) -> [F_ext; M_ext], platform frame, in place of the state's load.
    method: "DOP853", or "Radau" where springs or dampers are stiff. rtol, in ``RTOL_RANGE``, and atol: error
    of a step, relative and absolute, in m, rad, m/s and rad/s. output_step: s, between instants of the trace,
    at most ``MOST_INSTANTS``; None: as integrated.
    thresholds: None for the default ones. on_force_limit: where a force reaches the robot's force_limit, the
    run ends ("stop"), or the force is clipped to it ("saturate") and ``saturation`` reports it.
    progress: is told the share done, 0 to 1, now and then.

    A run stops before its end where a leg reaches a limit of the robot or a threshold; the place is a root of
    the interpolated motion, to rounding. Limits are looked at ``WATCHED`` times a step: a leg that passes one
    and is back within that is not seen. A singular pose that is crossed, where det H changes its sign, is
    seen however short the time near it; the run then ends where the condition number passes its threshold.

    Returns Simulation. Raises ValueError naming the argument: unknown options, numbers out of range, a state
    in which the machine has no accelerations, forces that are not six numbers; ImportError without SciPy.
    """
    instance(robot, Robot, "robot")
    law = _law(forces)
    start = _state(initial_state, law)
    option(method, METHODS, "method")
    option(on_force_limit, ON_FORCE_LIMIT, "on_force_limit")
    for name, value in (("duration", duration), ("atol", atol)):
        _number(value, name, 0.0, math.inf)
    if rate is not None:
        _number(rate, "rate", 0.0, math.inf)
    check_rtol(rtol)
    check_output_step(output_step, duration)
    for name, function, call in (
        ("load", load, "(time, state) -> six numbers"),
        ("progress", progress, "(share)"),
    ):
        if function is not None and not callable(function):
            raise ValueError(f"{name}: expected a function {call}, got {type(function).__name__}")
    if thresholds is not None:
        instance(thresholds, Thresholds, "thresholds")
    unlimited = np.full(6, math.inf)
    clips = on_force_limit == "saturate"
    actuators = _Actuators(law, robot.force_limit if clips else unlimited)
    stops_at = unlimited if clips else robot.force_limit
    run = _Run(
        robot=robot,
        accelerations=ForwardDynamics(robot, formulation, backend).one_state(),
        actuators=actuators,
        load=load,
        constant=(start.F_ext, start.M_ext),
        solver=_solver(method),
        tolerances={"rtol": float(rtol), "atol": float(atol)},
        watch=_Watch(robot, thresholds or Thresholds(), stops_at, _det_sign(robot, start)),
        reached=lambda time: None if progress is None else progress(time / duration),
    )
    stop, pieces = run.through(start, float(duration), rate)
    times = _output_times(pieces, stop.time, output_step)
    trace = _sampled(robot, actuators, tuple(pieces), times)
    return Simulation(
        **vars(trace),
        stop=stop,
        saturation=_saturation(actuators, pieces),
        _robot=robot,
        _actuators=actuators,
        _pieces=tuple(pieces),
    )


# Integration


@dataclass(eq=False)
class _Run:
    """One run's parts, and the integration from state to state."""

    robot: Robot
    accelerations: Callable[[Motion, Array], tuple[Array, int]]
    actuators: _Actuators
    load: Load | None
    constant: tuple[Array | None, Array | None]
    solver: Any
    tolerances: dict[str, float]
    watch: _Watch
    reached: Callable[[float], None]
    fault: int = 0

    def through(self, state: Motion, duration: float, rate: float | None) -> tuple[Stop, list[_Piece]]:
        """Go from sample to sample of the law, or in one go, until the end or a stop."""
        pieces: list[_Piece] = []
        time, center = 0.0, np.array(state.R)
        y = np.concatenate([state.t, np.zeros(3), state.v, state.omega])
        step: float | None = None
        sample = 0
        while time < duration:
            sample += 1
            held = None if rate is None else six_forces(self.actuators.law(time, _motion(y, center)), time)
            if sample == 1:
                self._reject_bad_start(y, center, held)
            end = duration if rate is None else min(sample / rate, duration)
            while time < end:
                stop, time, y, center, step = self._chart(pieces, time, end, y, center, step, held)
                if stop is not None:
                    return stop, pieces
        return Stop("duration", duration, None, f"ran to its end at {duration:g} s"), pieces

    def _chart(
        self,
        pieces: list[_Piece],
        time: float,
        end: float,
        y: Array,
        center: Array,
        step: float | None,
        held: Array | None,
    ) -> tuple[Stop | None, float, Array, Array, float | None]:
        """Integrate in one chart, to its rim or to ``end``; hand back the state in a chart of its own."""
        first = None if step is None else min(step, end - time)

        def rates(time: float, y: Array) -> Array:
            return self._rates(time, y, center, held)

        solver = self.solver(rates, time, y, end, first_step=first, **self.tolerances)
        while solver.status == "running" and np.linalg.norm(solver.y[3:6]) < CHART_RADIUS:
            solver.step()
            if solver.status == "failed":
                failure = self._failed(solver.t)
                if not pieces:
                    raise ValueError(f"initial_state: {failure.text}")
                return failure, failure.time, solver.y, center, step
            piece = _Piece(solver.t_old, solver.t, solver.dense_output(), center, held)
            stop = self.watch.first(piece, self.actuators)
            if stop is not None:
                # A stop where the step begins leaves no piece but the first, which the trace needs.
                if stop.time > piece.start or not pieces:
                    pieces.append(piece._replace(end=stop.time))
                return stop, stop.time, solver.y, center, step
            pieces.append(piece)
            self.reached(piece.end)
        y = np.array(solver.y)
        center = orthonormal(rotation_from_vector(y[3:6]) @ center)
        y[3:6] = 0.0
        return None, float(solver.t), y, center, float(solver.h_abs)

    def _rates(self, time: float, y: Array, center: Array, held: Array | None) -> Array:
        state = Motion.unchecked(rotation_vector.turned(y[3:6], center), y[:3], omega=y[9:], v=y[6:9])
        F = self.actuators.at(time, state) if held is None else self.actuators.clipped(held)
        acceleration, status = self.accelerations(self._loaded(time, state), F)
        self.fault = status or self.fault
        return np.concatenate([state.v, rotation_vector.rate(y[3:6], state.omega), acceleration])

    def _loaded(self, time: float, state: Motion) -> Motion:
        F_ext, M_ext = self.constant
        if self.load is not None:
            wrench = real_array(self.load(time, state), "load", "six numbers, [F_ext; M_ext]")
            if wrench.shape != (6,):
                raise ValueError(f"load: expected six numbers, [F_ext; M_ext], got shape {wrench.shape}")
            F_ext, M_ext = wrench[:3], wrench[3:]
        return Motion.unchecked(state.R, state.t, state.omega, state.v, F_ext=F_ext, M_ext=M_ext)

    def _reject_bad_start(self, y: Array, center: Array, held: Array | None) -> None:
        if not np.isfinite(self._rates(0.0, y, center, held)).all():
            raise ValueError(f"initial_state: no accelerations: {self._reason()}")
        self.fault = 0

    def _failed(self, time: float) -> Stop:
        return Stop("failed", time, None, f"no step is small enough at {time:.9g} s: {self._reason()}")

    def _reason(self) -> str:
        return STATUS_TEXT[self.fault] if self.fault else "forces or accelerations grow without bound"


def _motion(y: Array, center: Array) -> Motion:
    """The chart's numbers [t; phi; v; omega], (..., 12), as states."""
    R = rotation_from_vector(y[..., 3:6]) @ center
    return Motion.unchecked(R, y[..., :3], omega=y[..., 9:], v=y[..., 6:9])


# Limits


@dataclass(frozen=True, eq=False)
class _Watch:
    """Everything that stops a run, as numbers that are positive while all is well.

    force_limit: N, (6,); inf where forces are clipped instead. side: sign of det H at the start of the run.
    """

    robot: Robot
    thresholds: Thresholds
    force_limit: Array
    side: float

    def first(self, piece: _Piece, actuators: _Actuators) -> Stop | None:
        """The first stop in a piece, None if there is none."""
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        margins = self._margins(when, piece, actuators)
        below = margins <= 0.0
        if not below.any():
            return None
        roots = []
        for row in np.flatnonzero(below.any(axis=0)).tolist():
            i = int(np.argmax(below[:, row]))
            start = float(when[max(i - 1, 0)])
            time = start if i == 0 else self._root(row, start, float(when[i]), piece, actuators)
            if row == CROSSING:
                # The condition number passes its threshold on the way, too shortly to be seen itself.
                time = self._root(NEAR_SINGULAR, start, time, piece, actuators)
            roots.append((time, row))
        return self._stop(*min(roots), piece, actuators)

    def _root(self, row: int, start: float, end: float, piece: _Piece, actuators: _Actuators) -> float:
        """Where a margin comes to zero; an end of the span where it doesn't within."""
        from scipy.optimize import brentq

        def margin(time: float) -> float:
            return float(self._margins(np.array([time]), piece, actuators)[0, row])

        if not margin(start) > 0.0:
            return start
        if margin(end) > 0.0:
            return end
        return float(brentq(margin, start, end, xtol=1e-14 * max(end, 1.0), rtol=1e-14))

    def _margins(self, when: Array, piece: _Piece, actuators: _Actuators) -> Array:
        """(n, 38): shortest, longest, speed, force, length zero, joint sine, 6 each; condition, side of H."""
        robot = self.robot
        state = _motion(piece.interpolant(when).T, piece.center)
        legs = _legs(robot, state)
        F = np.zeros((len(when), 6))
        if np.isfinite(self.force_limit).any():
            F = actuators.forces(when, state, piece.held)
        shortest = self.thresholds.min_length or 1e-3 * self._size
        margins = [
            legs.L - np.where(robot.length_limits[:, 0] > 0.0, robot.length_limits[:, 0], -math.inf),
            robot.length_limits[:, 1] - legs.L,
            robot.speed_limit - np.abs(legs.L_dot),
            self.force_limit - np.abs(F),
            legs.L - shortest,
            self._joint_sine(legs.s) - self.thresholds.min_joint_sine,
            *self._singular_margins(legs),
        ]
        return np.concatenate(margins, axis=-1)

    def _singular_margins(self, legs: _Legs) -> tuple[Array, Array]:
        if self.thresholds.max_condition == math.inf:
            none = np.ones((len(legs.L), 1))
            return none, none
        near = 1.0 / self._condition(legs) - 1.0 / self.thresholds.max_condition
        return near[:, None], self.side * np.linalg.det(_scaled_H(legs, self._size))[:, None]

    @property
    def _size(self) -> float:
        return _size(self.robot)

    def _joint_sine(self, s: Array) -> Array:
        if self.robot.base_joint == "spherical":
            return np.ones(s.shape[:-1])
        return np.asarray(np.linalg.norm(cross(self.robot.k, s), axis=-1))

    def _condition(self, legs: _Legs) -> Array:
        return condition_number(_scaled_H(legs, self._size))

    def _stop(self, time: float, row: int, piece: _Piece, actuators: _Actuators) -> Stop:
        robot, leg = self.robot, row % 6
        at = np.array([time])
        state = _motion(piece.interpolant(at).T, piece.center)
        legs = _legs(robot, state)
        low, high = robot.length_limits[leg]
        length = f"{legs.L[0, leg]:.6g} m"
        if row >= NEAR_SINGULAR:
            text = f"condition number of H reaches {self._condition(legs)[0]:.4g} at {time:.9g} s"
            return Stop("singular", time, None, f"near a singular pose: {text}")
        kind, text = (
            ("length_limits", f"length {length} reaches its lower limit {low:g} m"),
            ("length_limits", f"length {length} reaches its upper limit {high:g} m"),
            (
                "speed_limit",
                f"speed {legs.L_dot[0, leg]:.6g} m/s reaches its limit {robot.speed_limit[leg]:g} m/s",
            ),
            (
                "force_limit",
                f"force {actuators.forces(at, state, piece.held)[0, leg]:.6g} N reaches its limit "
                f"{robot.force_limit[leg]:g} N",
            ),
            ("zero_length", f"length {length} is near zero"),
            ("joint singularity", "lies nearly along the fixed axis of its universal joint"),
        )[row // 6]
        return Stop(kind, time, leg + 1, f"leg {leg + 1}: {text} at {time:.9g} s")


class _Legs(NamedTuple):
    q: Array
    L: Array
    L_dot: Array
    s: Array


def _legs(robot: Robot, state: Motion) -> _Legs:
    """Leg kinematics without the rejections of ``inverse_kinematics``: a watched leg may come to nothing."""
    q, S, L = leg_vectors(robot, state.R, state.t)
    with np.errstate(all="ignore"):
        s = S / L[..., None]
    return _Legs(q, L, np.einsum("...i,...i->...", s, tip_velocities(state, q)), s)


def _size(robot: Robot) -> float:
    return characteristic_length(robot) or 1.0


def _scaled_H(legs: _Legs, size: float) -> Array:
    """H^T with its moments over a length, (..., 6, 6)."""
    return np.concatenate([legs.s, cross(legs.q, legs.s) / size], axis=-1)


def _det_sign(robot: Robot, state: Motion) -> float:
    return float(np.sign(np.linalg.det(_scaled_H(_legs(robot, state), _size(robot)))))


# Results


def _sampled(robot: Robot, actuators: _Actuators, pieces: tuple[_Piece, ...], when: Array) -> Trace:
    """The trace at times within the pieces."""
    n = len(when)
    y, centers, F = np.empty((n, 12)), np.empty((n, 3, 3)), np.empty((n, 6))
    of = np.searchsorted([piece.start for piece in pieces], when, side="right") - 1
    order = np.argsort(of, kind="stable")
    for here in np.split(order, np.flatnonzero(np.diff(of[order])) + 1) if n else ():
        piece = pieces[of[here[0]]]
        y[here], centers[here] = piece.interpolant(when[here]).T, piece.center
        if piece.held is not None:
            F[here] = actuators.clipped(piece.held)
    motion = _motion(y, centers)
    if pieces[0].held is None:
        F = actuators.forces(when, motion, None)
    rest = Motion.unchecked(motion.R, motion.t, np.zeros((n, 3)), np.zeros((n, 3)))
    potential = newton_euler.energy(robot, rest)
    kinetic = newton_euler.energy(robot, motion) - potential
    L = _legs(robot, motion).L
    return Trace(when, motion.R, motion.t, motion.v, motion.omega, F, L, kinetic, potential)


def _saturation(actuators: _Actuators, pieces: list[_Piece]) -> Saturation:
    """What the forces asked for exceed their limits by, in all pieces."""
    time, excess = np.zeros(6), np.zeros(6)
    for piece in pieces if np.isfinite(actuators.limit).any() else ():
        when = np.linspace(piece.start, piece.end, WATCHED + 1)
        state = _motion(piece.interpolant(when).T, piece.center)
        beyond = np.abs(actuators.asked(when, state, piece.held)) - actuators.limit
        excess = np.maximum(excess, beyond.max(axis=0))
        time += np.diff(when) @ _share_above_zero(beyond[:-1], beyond[1:])
    return Saturation(time, excess)


def _share_above_zero(start: Array, end: Array) -> Array:
    """Of the way from one number to another, the share on which a straight line is above zero, 0 to 1."""
    above = np.maximum(start, 0.0) + np.maximum(end, 0.0)
    with np.errstate(invalid="ignore"):
        share = above / (np.abs(start) + np.abs(end))
    return np.where(above > 0.0, np.where(np.minimum(start, end) >= 0.0, 1.0, share), 0.0)


def _output_times(pieces: list[_Piece], end: float, step: float | None) -> Array:
    if step is None:
        return np.unique([pieces[0].start, *(piece.end for piece in pieces)])
    grid = np.arange(math.floor(end / step * (1.0 + 1e-12)) + 1) * step
    return np.append(grid[grid < end * (1.0 - 1e-12)], end)


# Arguments


def six_forces(value: ArrayLike, time: float) -> Array:
    """What a law returned, as six numbers; ValueError if it is anything else."""
    F = real_array(value, "forces", "six numbers")
    if F.shape != (6,):
        raise ValueError(f"forces: expected six numbers from the law at {time:g} s, got shape {F.shape}")
    return F


def check_rtol(rtol: object) -> None:
    """Reject, by ValueError, what is no number in ``RTOL_RANGE``."""
    low, high = RTOL_RANGE
    text = f"a number in [{low:g}, {high:g}]"
    number = real_array(rtol, "rtol", text)
    if number.shape != () or not low <= float(number) <= high:
        raise ValueError(f"rtol: expected {text}, got {shown(rtol)}")


def check_output_step(output_step: float | None, duration: float) -> None:
    """Reject, by ValueError, what is no number > 0, or makes more than ``MOST_INSTANTS`` of a duration, s."""
    if output_step is None:
        return
    _number(output_step, "output_step", 0.0, math.inf)
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
        wanted = getattr(law, "wanted", None)
        if given != "path" or wanted is None:
            text = 'a Motion, or "path" with a law that follows one'
            raise ValueError(f"initial_state: expected {text}, got {shown(given)}")
        start: Motion = wanted(0.0)
        return Motion(start.R, start.t, start.omega, start.v, F_ext=start.F_ext, M_ext=start.M_ext)
    instance(given, Motion, "initial_state")
    if given.shape != ():
        raise ValueError(f"initial_state: expected one state, of shape (), got {given.shape}")
    return given


def _number(value: object, name: str, low: float, high: float) -> None:
    text = f"a number > {low:g}" + (f" and < {high:g}" if math.isfinite(high) else "")
    number = real_array(value, name, text)
    if number.shape != () or not low < float(number) < high:
        raise ValueError(f"{name}: expected {text}, got {shown(value)}")


def _solver(method: str) -> Any:
    with needed_for("simulation"):
        from scipy import integrate
    return getattr(integrate, method)
