"""Scene files: simulations in TOML, validated and converted to the arguments of ``simulate``."""

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ..backend.kernel import FORMULATIONS
from ..dynamics.inverse_dynamics import Formulation
from ..io import toml_reader
from ..io.arguments import option, whole_number
from ..io.array_types import Array
from ..io.error_policy import errors_of, warn
from ..kinematics.mounting_side import path_for
from ..kinematics.robot_logs import read_log_of
from ..motion.interpolation import followed
from ..motion.motion import Motion
from ..motion.rotation import rotation_from_rpy
from ..motion.sample_times import elapsed
from ..motion.straight_line import PAPER_PATHS
from ..motion.trajectory_format import TrajectoryWarning
from ..robot.robot import Robot
from .actuator_models import ComputedTorque, ForceLaw, LegSprings, Reference, along, at_samples
from .simulation import (
    METHODS,
    ON_FORCE_LIMIT,
    Method,
    OnForceLimit,
    Progress,
    check_duration,
    check_output_step,
    check_rtol,
    simulate,
)
from .state_history import Load, SimulationResult
from .stop_conditions import StopConditions

SCHEMA = 1
STARTS = ("path",)

_TOP_KEYS = (
    *("schema", "robot", "formulation", "duration", "output_step", "method", "rtol", "initial_state"),
    *("on_force_limit", "state", "load", "actuation", "stop_conditions"),
)
_OPTIONS = (
    "control_rate",
    "load",
    "formulation",
    "method",
    "rtol",
    "output_step",
    "stop_conditions",
    "on_force_limit",
)
"""Fields of a scene that are passed to ``simulate`` under the same name."""
# Speeds (m/s and rad/s) up to which the platform counts as being at rest at the end of a path.
_RESTS = 1e-4
# Number of samples up to which a reference is evaluated for all samples at once, 200 MB.
_MOST_TABULATED = 1_000_000
_STATE_KEYS = ("t", "theta", "v", "omega")
_LOAD_KEYS = ("F_ext", "M_ext")
_THRESHOLD_KEYS = ("max_condition", "min_length", "min_joint_sine")
_LAW_NEEDS = {
    "constant_force": ("forces",),
    "spring": ("stiffness",),
    "computed_torque": ("path", "k_p", "k_d"),
}


@dataclass(frozen=True, eq=False)
class Scene:
    """Simulation with all arguments of ``simulate``, under the same names and in the same units.

    control_rate: sampling rate of the law (Hz). reference: motion of a tracking law for times (s), any shape.
    load: load in the file of a tracked path. stated: values in the file by key.
    """

    robot: Robot
    state: Motion
    law: ForceLaw
    control_rate: float | None
    formulation: Formulation
    duration: float
    output_step: float | None
    method: Method | None
    rtol: float
    stop_conditions: StopConditions
    on_force_limit: OnForceLimit = "stop"
    reference: Reference | None = None
    load: Load | None = None
    files: tuple[Path, ...] = ()
    stated: Mapping[str, Any] = field(default_factory=dict)

    def run(self, progress: Progress | None = None) -> SimulationResult:
        """Run the simulation with the errors of ``simulate``, preceded by the name of the scene file."""
        options = {name: getattr(self, name) for name in _OPTIONS}
        with errors_of("".join(f"{file}: " for file in self.files[:1])):
            return simulate(self.robot, self.state, self.law, self.duration, **options, progress=progress)


def read_scene(path: str | os.PathLike[str]) -> Scene:
    """Read and validate a scene file, TOML, schema 1, with file names relative to its folder."""
    source = os.fsdecode(path)
    with toml_reader.toml_tables(source, "scene of simulate") as d:
        return _scene(d, source)


def _scene(d: Mapping[str, Any], source: str) -> Scene:
    """Convert the tables of a scene file to a scene."""
    file = f"{source}: "
    top = toml_reader.checked_table(d, file, _TOP_KEYS, ("schema", "robot", "duration", "actuation"))
    whole_number(top["schema"], f"{file}schema", SCHEMA, str(SCHEMA), SCHEMA)
    # Errors in this file are reported before errors in other files.
    legs = _actuation(top["actuation"], f"{file}actuation.")
    options: dict[str, Any] = {
        key: toml_reader.positive(top[key], file + key) if key in top else default
        for key, default in (("duration", None), ("output_step", None), ("rtol", 1e-9))
    }
    with errors_of(file):
        check_duration(options["duration"])
        check_rtol(options["rtol"])
        check_output_step(options["output_step"], options["duration"])
    options["method"] = option(top["method"], METHODS, f"{file}method") if "method" in top else None
    choices = {"formulation": FORMULATIONS, "on_force_limit": ON_FORCE_LIMIT}
    for key, known in choices.items():
        options[key] = option(top.get(key, known[0]), known, file + key)
    thresholds = _thresholds(top.get("stop_conditions", {}), f"{file}stop_conditions.")
    load = _vectors(top.get("load", {}), _LOAD_KEYS, (), f"{file}load.")
    _check_start(top, legs["type"], file)
    given = _vectors(top["state"], _STATE_KEYS, ("t", "theta"), f"{file}state.") if "state" in top else None
    read = [Path(source), toml_reader.file_beside(top["robot"], source, "robot")]
    robot = Robot.from_toml(read[1])
    tracked = legs["path"] if legs["type"] == "computed_torque" else None
    if tracked is not None and tracked not in PAPER_PATHS:
        read.append(toml_reader.file_beside(tracked, source, "actuation.path"))
    reference = None if tracked is None else _reference(robot, tracked, read[-1], options["duration"])
    state = _state(given, reference, load)
    rate, followed = legs.get("rate"), reference
    if reference is not None and rate is not None and options["duration"] * rate <= _MOST_TABULATED:
        followed = at_samples(reference, rate, options["duration"])
    with errors_of(f"{file}actuation: "):
        law = _law(robot, legs, state, followed)
    options |= {"stop_conditions": thresholds, "files": tuple(read), "reference": reference}
    if reference is not None and "load" not in top and _load_of(reference(0.0)) is not None:
        options["load"] = lambda time, state: _load_of(reference(time))
    stated = {f"state.{key}": value for key, value in (given or {}).items()}
    stated |= {f"actuation.{key}": value for key, value in legs.items()}
    return Scene(robot, state, law, rate, stated=stated, **options)


def _check_start(top: Mapping[str, Any], law: str, file: str) -> None:
    """Reject a scene with no initial state or with two; computed torque starts on its path by default."""
    if "initial_state" in top:
        start = option(top["initial_state"], STARTS, f"{file}initial_state")
        if law != "computed_torque":
            raise ValueError(
                f'{file}initial_state: expected [actuation] type = "computed_torque" with "{start}", '
                f'got "{law}"'
            )
        if "state" in top:
            raise ValueError(f'{file}initial_state: expected no [state] with "{start}"')
    elif "state" not in top and law != "computed_torque":
        raise ValueError(f"{file}state: missing")


def _actuation(value: object, prefix: str) -> dict[str, Any]:
    """Return the checked values of the table ``actuation``; its valid keys depend on ``type``."""
    every = ("type", *(key for checks in _LAW_KEYS.values() for key in checks))
    law = option(
        toml_reader.checked_table(value, prefix, every, ("type",))["type"], tuple(_LAW_KEYS), f"{prefix}type"
    )
    checks = {"type": toml_reader.one_line} | _LAW_KEYS[law]
    legs = toml_reader.checked_table(value, prefix, tuple(checks), _LAW_NEEDS[law])
    return {key: checks[key](given, prefix + key) for key, given in legs.items()}


_not_negative = partial(toml_reader.per_leg, check=toml_reader.not_negative)

_LAW_KEYS: dict[str, dict[str, Callable[[object, str], Any]]] = {
    "constant_force": {"forces": lambda value, where: toml_reader.numbers(value, where, (6,))},
    "spring": {"stiffness": _not_negative, "rest_length": toml_reader.per_leg, "damping": _not_negative},
    "computed_torque": {
        "path": toml_reader.one_line,
        "k_p": toml_reader.not_negative,
        "k_d": toml_reader.not_negative,
        "model_formulation": lambda value, where: option(value, FORMULATIONS, where),
        "rate": toml_reader.positive,
    },
}
"""Keys of each actuation type, with the function that checks the value."""


def _thresholds(value: object, prefix: str) -> StopConditions:
    """Convert the table ``stop_conditions``."""
    table = toml_reader.checked_table(value, prefix, _THRESHOLD_KEYS)
    numbers = {key: toml_reader.positive(given, prefix + key) for key, given in table.items()}
    with errors_of(prefix):
        return StopConditions(**numbers)


def _vectors(value: object, keys: tuple[str, ...], needed: tuple[str, ...], prefix: str) -> dict[str, Array]:
    """Return the vectors of a table by key."""
    table = toml_reader.checked_table(value, prefix, keys, needed)
    return {key: toml_reader.vector(given, prefix + key) for key, given in table.items()}


def _reference(robot: Robot, path: str, file: Path, duration: float) -> Reference:
    """Return the reference motion from a path or a file; warn if a file ends in motion too early."""
    if path in PAPER_PATHS:
        return along(path_for(robot, path).path)
    found = read_log_of(robot, file)
    if found.in_joints:
        raise ValueError(f"{found.source}: expected poses, t_* and theta_*, got leg lengths L_1 to L_6")
    last, whole = found.motion[-1], float(elapsed(found.time)[-1])
    speed, turning = (float(np.linalg.norm(rate)) for rate in (last.v, last.omega))
    if whole < duration and max(speed, turning) > _RESTS:
        rates = f"{speed:.2g} m/s and {turning:.2g} rad/s, at {whole:.6g} s of a run of {duration:g} s"
        text = f"the motion ends while moving ({rates}); the reference is at rest afterwards"
        warn(f"{found.source}: {text}", TrajectoryWarning)
    return followed(found)


def _state(
    given: Mapping[str, Array] | None, reference: Reference | None, load: Mapping[str, Array]
) -> Motion:
    """Return the initial state; without values, the start of the reference motion."""
    if given is None:
        assert reference is not None
        start = reference(0.0)
        return Motion(R=start.R, t=start.t, omega=start.omega, v=start.v, **load)
    zero = np.zeros(3)
    R = rotation_from_rpy(given["theta"])
    return Motion(R=R, t=given["t"], omega=given.get("omega", zero), v=given.get("v", zero), **load)


def _load_of(motion: Motion) -> Array | None:
    """Return [F_ext; M_ext], shape (6,), of a motion of shape (), or None without a load."""
    load = motion.F_ext, motion.M_ext
    if load[0] is None and load[1] is None:
        return None
    return np.concatenate([np.zeros(3) if part is None else part for part in load])


def _law(robot: Robot, legs: Mapping[str, Any], state: Motion, reference: Reference | None) -> ForceLaw:
    """Create the force law of the table ``actuation``."""
    if legs["type"] == "constant_force":
        constant: Array = legs["forces"]
        return lambda time, state: constant
    if legs["type"] == "spring":
        stiffness, damping = legs["stiffness"], legs.get("damping", 0.0)
        if "rest_length" in legs:
            return LegSprings(robot, stiffness, legs["rest_length"], damping)
        return LegSprings.in_equilibrium(robot, state, stiffness, damping)
    assert reference is not None
    return ComputedTorque(
        robot, reference, legs["k_p"], legs["k_d"], legs.get("model_formulation", FORMULATIONS[0])
    )
