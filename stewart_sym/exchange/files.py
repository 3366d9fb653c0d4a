"""Robots to models in other programs' formats and back."""

import os
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..drives.friction import losses
from ..drives.motor_states import motor_states
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..dynamics.left_out import effect
from ..io.arguments import instance, option, shown
from ..io.array_types import Array
from ..io.error_policy import errors_of, warn
from ..io.toml_reader import file_name, read_text
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.fields import LEGS
from ..robot.robot import Robot, RobotWarning, impossible_inertias
from .formats import mjcf_in, mjcf_out, sdf_in, sdf_out, urdf_in, urdf_out, usd_out
from .formats.xml_text import HEADER, at_line, line_named, parsed
from .model import Model
from .model_from_robot import model_of, possible
from .notes import differences, noted
from .robot_from_model import robot_of

PROGRAMS = {"mjcf": "MuJoCo", "sdf": "Gazebo", "drake": "Drake", "urdf": "Pinocchio", "usd": "Isaac Sim"}
"""Formats, and a program that reads each."""
_WRITERS: dict[str, Callable[[Model], tuple[str, str | None]]] = {
    "mjcf": mjcf_out.written,
    "sdf": sdf_out.written,
    "drake": sdf_out.written_for_drake,
    "urdf": urdf_out.written,
    "usd": usd_out.written,
}
_READERS = {"mujoco": mjcf_in.model, "sdf": sdf_in.model, "robot": urdf_in.model}
"""Readers by the name of the file's root element."""
BEGINNINGS = (HEADER, usd_out.HEADER, f'{{\n "generator": "{urdf_out.GENERATOR}"')
"""How files that this program wrote begin."""
LOOPS = ".loops.json"
"""End of the name of the file beside a URDF, in place of the URDF's suffix."""
_MOST_BYTES = 1 << 24
_FAST = 1e6
"""Factor of the rotors' speed by which their angular momentum is divided at the same reflected mass."""


@dataclass(frozen=True)
class ExportedModel:
    """A machine in another program's format.

    Attributes
    ----------
    text : str
        The file.
    loop_closures : str or None
        Of URDF, a second file beside it, as JSON: what closes the loops, gravity, and friction and drives,
        for which URDF has no place; None of other formats.
    """

    text: str
    loop_closures: str | None = None


@dataclass(frozen=True, eq=False)
class ImportedModel:
    """A robot read from another program's format.

    Attributes
    ----------
    robot : Robot
        The machine.
    assumptions : tuple of str
        What was found how, what had to be assumed, and what is left out, a line each.
    """

    robot: Robot
    assumptions: tuple[str, ...]


def export_model(robot: Robot, format: str) -> ExportedModel:  # noqa: A002 # the option's name
    """Write a robot in another program's format.

    The machine stands at its home pose: legs with two axes at the base, a sliding actuator and a spherical
    closure at the platform, which is free. What the format has no place for is in notes in the file, which
    ``import_model`` reads.

    Parameters
    ----------
    robot : Robot
        The machine.
    format : str
        ``"mjcf"`` (MuJoCo), ``"sdf"`` (SDF for Gazebo), ``"drake"`` (SDF for Drake), ``"urdf"`` (ROS,
        Pinocchio, Drake), or ``"usd"`` (Isaac Sim). Gazebo and Drake close loops in different ways.

    Returns
    -------
    ExportedModel
        Text of the file, and of a second one beside it where there is one.

    Raises
    ------
    ValueError
        In one line: legs whose upper parts turn in the lower ones or that lie along a fixed axis at home; an
        inertia that no body can have, which all but URDF reject, unless the robot accepts it: then a warning
        says that the nearest possible one is written.
    """
    instance(robot, Robot, "robot")
    option(format, tuple(PROGRAMS), "format")
    if robot.offsets is not None and robot.offsets.has_spinning_parts:
        # No format has an actuator whose force turns what it pushes.
        raise ValueError(
            f'{format}: offsets.platform_joint: expected "spherical", got "universal", which the format does '
            "not support"
        )
    written = robot if format == "urdf" else possible(robot, PROGRAMS[format])
    model = model_of(written)
    _warn_of_losses(robot, format)
    text, loops = _WRITERS[format](model)
    if format == "usd":
        return ExportedModel(text)
    # What is read back differently, by rounding or for want of a place, stands in the notes.
    again, _ = robot_of(_read(parsed(text), loops))
    return ExportedModel(*_WRITERS[format](replace(model, notes=noted(differences(written, again)))))


def import_model(path: str | os.PathLike[str]) -> ImportedModel:
    """Read a robot from a model in MJCF, SDF or URDF, whatever program wrote it.

    Base, platform and legs are found by how bodies are joined: six chains from the base to one body, each of
    two revolute joints or a universal or spherical one, a prismatic joint, and a spherical one. Loops may be
    cut anywhere and must be closed in the pose of the file, as must welds. Axes at the base that miss each
    other are read where the file has the note of ``export_model`` that they are meant to.

    Parameters
    ----------
    path : path
        The file; of a URDF, that of its loops is read beside it.

    Returns
    -------
    ImportedModel
        The robot, with lines on what was assumed.

    Raises
    ------
    ValueError
        In one line: what of the file can't be read or is no Stewart platform, and where.

    Warns
    -----
    RobotWarning
        For an inertia that no rigid body has.
    """
    source = file_name(path)
    text, beside = read_text(source, "model", _MOST_BYTES), loops_path(source)
    loops = read_text(str(beside), "loops", _MOST_BYTES) if beside.is_file() else None
    with errors_of(f"{source}: "):
        root = parsed(text)
    try:
        robot, said = robot_of(_read(root, loops))
    except ValueError as error:
        line = line_named(str(error), root)
        raise ValueError(f"{source}: {error}{'' if line is None else f' (at line {line})'}") from None
    for name, text in impossible_inertias(robot):
        if name not in robot.suppressed_warnings:
            warn(f"{source}: {text} [{name}]", RobotWarning)
    return ImportedModel(robot, said)


def _warn_of_losses(robot: Robot, form: str) -> None:
    """Warn of friction, rotors and limits that readers of the file leave out, with their effect on forces.

    Spherical joints have no damping but MuJoCo's at the base; a URDF's loops state what that has not.
    Friction of drives is nowhere but in the notes.
    """
    lost = [] if form == "urdf" else ["C_s"]
    lost += ["C_u"] if form in ("sdf", "drake", "usd") and robot.base_joint == "spherical" else []
    found = [name for name in lost if np.any(getattr(robot, name))]
    missing = {}
    if found:
        none: dict[str, Any] = dict.fromkeys(found, 0.0)
        frictionless = replace(robot, **none)
        missing[f"friction of spherical joints ({', '.join(found)})"] = _effect(robot, frictionless)
    drive = robot.drive
    if robot.has_rotors and drive is not None:
        if form in ("sdf", "drake"):
            bare = replace(drive, rotor_inertia=np.zeros(LEGS))
            missing["inertia of rotors"] = _effect(robot, replace(robot, drive=bare))
        elif form != "urdf" and np.any(robot.rotor_momentum):
            # The same reflected mass at a speed at which the rotors have no angular momentum.
            light = replace(drive, lead=drive.lead / _FAST, rotor_inertia=drive.rotor_inertia / _FAST**2)
            missing["angular momentum of rotors"] = _effect(robot, replace(robot, drive=light))
    lossy = [] if drive is None else losses(drive)
    if lossy:
        at_legs, at_motors = _forces_of(robot), _at_motors(robot)
        missing[f"friction of drives ({', '.join(lossy)})"] = effect(robot, at_legs, full=at_motors)
    limits = [] if form in ("sdf", "drake", "urdf") else ["speed_limit"]
    missing |= {
        name: "" for name in (*limits, "joint_angle_limit") if np.isfinite(getattr(robot, name)).any()
    }
    where = "left out" if form == "usd" else "noted only, for import"
    for what, by in missing.items():
        warn(f"{form}: {what} has no place in the format: {where}{by and '; ' + by}")


def _effect(robot: Robot, other: Robot) -> str:
    return effect(robot, _forces_of(other))


def _forces_of(robot: Robot) -> Callable[[Motion], Array]:
    """Return the actuator forces of a robot (N) as a function of motions (n,)."""
    return lambda motion: inverse_dynamics(robot, motion, backend="numpy").F


def _at_motors(robot: Robot) -> Callable[[Motion], Array]:
    """Return the forces of the motors along the legs (N) as a function of motions (n,)."""

    def forces(motion: Motion) -> Array:
        assert robot.drive is not None
        F, L_dot = _forces_of(robot)(motion), inverse_kinematics(robot, motion).L_dot
        return motor_states(robot, robot.drive, motion, F, L_dot).torque * robot.drive.transmission_ratio

    return forces


def loops_path(path: str | os.PathLike[str]) -> Path:
    """Where the loops of a URDF are."""
    return Path(path).with_suffix(LOOPS)


def _read(root: ET.Element, loops: str | None) -> Model:
    if root.tag not in _READERS:
        expected = "expected MJCF, SDF or URDF with a root mujoco, sdf or robot"
        raise ValueError(f"{expected}, got {shown(root.tag)}{at_line(root)}")
    with np.errstate(over="ignore", invalid="ignore"):
        return _READERS[root.tag](root, loops)
