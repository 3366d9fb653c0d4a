"""Export of robots to the model formats of other programs, and import from them."""

import functools
import os
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from ..drives.friction import losses
from ..drives.motor_states import motor_states
from ..dynamics.inverse_dynamics import inverse_dynamics
from ..dynamics.neglected_physics import effect
from ..io.arguments import instance, option, shown
from ..io.array_types import Array
from ..io.error_policy import errors_of, warn
from ..io.toml_reader import read_text
from ..kinematics.inverse_kinematics import inverse_kinematics
from ..motion.motion import Motion
from ..robot.drive import Drive
from ..robot.fields import LEGS
from ..robot.robot import Robot, RobotWarning, impossible_inertias, need_masses
from .formats import mjcf_in, mjcf_out, sdf_in, sdf_out, urdf_in, urdf_out, usd_out
from .formats.xml_text import HEADER, at_line, line_named, parsed
from .model import Model
from .model_from_robot import model_of, possible
from .notes import changed_keys
from .robot_from_model import LEAD, robot_of

PROGRAMS = {"mjcf": "MuJoCo", "sdf": "Gazebo", "drake": "Drake", "urdf": "Pinocchio", "usd": "Isaac Sim"}
"""Formats, each with a program that reads it."""
_WRITERS: dict[str, Callable[[Model], tuple[str, str | None]]] = {
    "mjcf": mjcf_out.written,
    "sdf": sdf_out.written,
    "drake": functools.partial(sdf_out.written, drake=True),
    "urdf": urdf_out.written,
    "usd": usd_out.written,
}
_ROOTS = {"mujoco": "mjcf", "sdf": "sdf", "robot": "urdf"}
"""Formats that are read, by the name of their root element."""
BEGINNINGS = (HEADER, usd_out.HEADER, f'{{\n "generator": "{urdf_out.GENERATOR}"')
"""First characters of files that this program has written."""
LOOPS = ".loops.json"
"""Ending of the name of the loops file of a URDF file; it replaces the suffix of the URDF file."""
_FAST = 1e6
"""Factor of the rotor speed that reduces the angular momentum for the same reflected mass."""


@dataclass(frozen=True)
class ExportedModel:
    """Robot in the format of another program.

    Attributes
    ----------
    text : str
        Content of the model file.
    loop_closures : str or None
        Content of the second file of a URDF model, in JSON: loop closures, gravity, friction, and drives,
        which URDF cannot represent. None for other formats.
    """

    text: str
    loop_closures: str | None = None


@dataclass(frozen=True, eq=False)
class ImportedModel:
    """Robot that was read from the format of another program.

    Attributes
    ----------
    robot : Robot
        Robot model.
    assumptions : tuple of str
        One line for each interpretation, assumption, and omission.
    """

    robot: Robot
    assumptions: tuple[str, ...]


def export_model(robot: Robot, format: str) -> ExportedModel:  # noqa: A002 # the option's name
    """Write a robot in the format of another program.

    The model is in its home pose. Each leg has two axes at the base, a sliding actuator, and a spherical loop
    closure at the platform, which is a free body. Properties that the format cannot represent are written as
    notes in the file, which ``import_model`` reads.

    Parameters
    ----------
    robot : Robot
        Robot model.
    format : {"mjcf", "sdf", "drake", "urdf", "usd"}
        MJCF (MuJoCo), SDF for Gazebo, SDF for Drake, URDF (ROS, Pinocchio, and Drake), or USD (Isaac Sim).
        Gazebo and Drake close loops in different ways.

    Returns
    -------
    ExportedModel
        Content of the model file and, for URDF, of the second file.

    Raises
    ------
    ValueError
        If upper leg parts rotate in the lower ones, or if a leg is parallel to its fixed axis in the home
        pose. If an inertia is physically impossible, unless the format is URDF or ``suppressed_warnings``
        contains the warning.

    Warns
    -----
    UserWarning
        If the format cannot represent friction, rotors, or limits of the robot.
    RobotWarning
        If an impossible inertia is replaced by the nearest possible one.

    See Also
    --------
    import_model : Read a robot from a model file.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> model = ss.export_model(ss.robots.load("tsai2000"), "mjcf")
    >>> model.text.splitlines()[2]
    '<mujoco model="Tsai 2000">'
    >>> model.text.count("<connect ")
    6
    """
    instance(robot, Robot, "robot")
    need_masses(robot, "a model")
    option(format, tuple(PROGRAMS), "format")
    if robot.offsets is not None and robot.offsets.has_spinning_parts:
        # No format has an actuator whose force rotates the body that it moves.
        raise ValueError(
            f'{format}: offsets.platform_joint: expected "spherical", because the format cannot represent '
            "upper parts that rotate in the lower ones"
        )
    written = robot if format == "urdf" else possible(robot, PROGRAMS[format])
    _warn_of_losses(robot, format)
    return ExportedModel(*_WRITERS[format](replace(model_of(written), note=written.to_dict())))


def import_model(path: str | os.PathLike[str]) -> ImportedModel:
    """Read a robot from a model in MJCF, SDF, or URDF, written by any program.

    Parameters
    ----------
    path : str or path-like
        Model file. The loops file of a URDF file, ``NAME.loops.json``, is read from the same folder.

    Returns
    -------
    ImportedModel
        Robot, with messages about all assumptions.

    Raises
    ------
    ValueError
        If the file cannot be read, or if it is not a Stewart platform. The message is one line with the
        location in the file.
    ImportError
        If the file is MJCF and MuJoCo is not installed. The message names the extra.

    Warns
    -----
    UserWarning
        If bodies or joints differ from the note of ``export_model``, which is ignored.
    RobotWarning
        If an inertia is physically impossible.

    See Also
    --------
    export_model : Write a robot in the format of another program.

    Notes
    -----
    Base, platform, and legs are identified by the joints between the bodies. Six chains lead from the base to
    one body. Each contains two revolute joints (or a universal or spherical joint), a prismatic joint, and a
    spherical joint. Any joint of a loop may be the loop closure. Loop closures and welds must be closed in
    the pose of the file. Perpendicular axes at the base that do not intersect are imported as joint offsets.
    MJCF requires MuJoCo (extra ``exchange``).

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("tsai2000")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "model.xml")
    ...     _ = path.write_text(ss.export_model(robot, "mjcf").text, encoding="utf-8")
    ...     imported = ss.import_model(path)
    >>> np.array_equal(imported.robot.b, robot.b)
    True
    >>> imported.assumptions[-1]
    'robot file: from the note in the file; bodies and joints agree with it'
    """
    source = os.fsdecode(path)
    text, beside = read_text(source, "model"), loops_path(source)
    loops = read_text(str(beside), "loops") if beside.is_file() else None
    with errors_of(f"{source}: "):
        root = parsed(text)
    try:
        model = _read(root, text, loops, source)
        robot, said = robot_of(model)
        noted = None if model.note is None else _noted(model.note, robot, _ROOTS[root.tag], source)
    except ValueError as error:
        line = None if " line " in str(error) else line_named(str(error), root)
        raise ValueError(f"{source}: {error}{'' if line is None else f' (at line {line})'}") from None
    if noted is not None:
        robot = noted
        said.append("robot file: from the note in the file; bodies and joints agree with it")
    elif robot.drive is not None:
        said.append(f"armatures of the slides: rotors behind screws with a lead of {LEAD:g} m")
    for name, text in impossible_inertias(robot):
        if name not in robot.suppressed_warnings:
            warn(f"{source}: {text} [{name}]", RobotWarning)
    return ImportedModel(robot, tuple(said))


def loops_path(path: str | os.PathLike[str]) -> Path:
    """Return the path of the loops file of a URDF file."""
    return Path(path).with_suffix(LOOPS)


def _read(root: ET.Element, text: str, loops: str | None, path: str) -> Model:
    """Convert the elements of a file to a model."""
    if root.tag == "mujoco":
        return mjcf_in.model(path, text)
    if root.tag == "sdf":
        return sdf_in.model(root)
    if root.tag == "robot":
        return urdf_in.model(root, loops)
    expected = "expected MJCF, SDF, or URDF with a root mujoco, sdf, or robot"
    raise ValueError(f"{expected}, got {shown(root.tag)}{at_line(root)}")


def _noted(note: Mapping[str, Any], robot: Robot, form: str, source: str) -> Robot | None:
    """Return the robot of a note, or None with a warning if bodies and joints of the file differ from it."""
    with errors_of("note: "):
        noted = Robot.from_dict(note)
        text, loops = _WRITERS[form](model_of(noted))
        expected, _ = robot_of(_read(parsed(text), text, loops, ""))
    if changed := changed_keys(robot, expected):
        differ = f"bodies and joints differ from the note ({', '.join(changed)})"
        warn(f"{source}: {differ}; the note is ignored")
        return None
    return noted


def _warn_of_losses(robot: Robot, form: str) -> None:
    """Warn of friction, rotors, and limits that the format cannot represent, with their effect on the forces.

    Spherical joints have no damping, except at the base in MuJoCo; the loops file of a URDF file contains it.
    The friction of drives is contained in the notes only.
    """
    lost = [] if form == "urdf" else ["C_s"]
    lost += ["C_u"] if form in ("sdf", "drake", "usd") and robot.base_joint == "spherical" else []
    none: dict[str, Any] = {name: 0.0 for name in lost if np.any(getattr(robot, name))}
    missing = {}
    if none:
        by = effect(robot, _forces_of(replace(robot, **none)))
        missing[f"friction of spherical joints ({', '.join(none)})"] = by
    drive = robot.drive
    if drive is not None and robot.has_rotors:
        # The same reflected mass without angular momentum of the rotors.
        light = replace(drive, lead=drive.lead / _FAST, rotor_inertia=drive.rotor_inertia / _FAST**2)
        if form in ("sdf", "drake"):
            bare = replace(drive, rotor_inertia=np.zeros(LEGS))
            missing["inertia of rotors"] = effect(robot, _forces_of(replace(robot, drive=bare)))
        elif form != "urdf" and np.any(robot.rotor_momentum):
            missing["angular momentum of rotors"] = effect(robot, _forces_of(replace(robot, drive=light)))
    if drive is not None and (lossy := losses(drive)):
        by = effect(robot, _forces_of(robot), full=_forces_at_motors(robot, drive))
        missing[f"friction of drives ({', '.join(lossy)})"] = by
    limits = [] if form in ("sdf", "drake", "urdf") else ["speed_limit"]
    for name in (*limits, "joint_angle_limit"):
        if np.isfinite(getattr(robot, name)).any():
            missing[name] = ""
    where = "left out" if form == "usd" else "noted only, for import"
    for what, by in missing.items():
        warn(f"{form}: {what} has no place in the format: {where}{by and '; ' + by}")


def _forces_of(robot: Robot) -> Callable[[Motion], Array]:
    """Return the actuator forces of a robot (N) as a function of motions (n,)."""
    return lambda motion: inverse_dynamics(robot, motion, backend="numpy").F


def _forces_at_motors(robot: Robot, drive: Drive) -> Callable[[Motion], Array]:
    """Return the motor forces along the legs (N) as a function of motions (n,)."""

    def forces(motion: Motion) -> Array:
        F, L_dot = _forces_of(robot)(motion), inverse_kinematics(robot, motion).L_dot
        return motor_states(robot, drive, motion, F, L_dot).torque * drive.transmission_ratio

    return forces
