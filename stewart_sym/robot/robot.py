"""Robot model: geometry, masses, friction, and limits, read from a robot file and checked."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..io import toml_reader
from ..io.arguments import instance, safe_text, shown, whole_number
from ..io.array_types import Array, Frozen
from ..io.error_policy import warn
from ..motion.trajectory_format import TrajectoryFormat
from . import fields, schema_2
from .bodies import inertias_of_parts, low_densities
from .drive import Drive
from .fields import LEGS as LEGS
from .fields import base_joint
from .fields import legs_text as legs_text
from .offsets import JointOffsets


class RobotWarning(UserWarning):
    """Issued if a robot has values that no machine, or almost none, can have; the robot is loaded anyway."""


@dataclass(frozen=True, eq=False)
class Robot(Frozen):
    """Gough-Stewart platform with six legs, which may all be different. Arrays are read-only.

    If all legs have the same value, one entry is sufficient instead of six, except for ``b`` and ``p``.

    Attributes
    ----------
    name : str
        Name, one line of text.
    base_joint : {"universal", "spherical"}
        Type of the base joints: "universal" for 6-UPS as in the paper, "spherical" for 6-SPS.
    g : ndarray, shape (3,)
        Gravity (m/s^2), base frame.
    M : float
        Mass (kg) of the platform with payload. Mass properties that the robot file does not contain are NaN.
    R_0 : ndarray, shape (3,)
        Center of mass (m) of the platform, platform frame.
    I_p : ndarray, shape (3, 3)
        Inertia (kg m^2) of the platform about its center of mass, platform frame.
    b : ndarray, shape (6, 3)
        Base points (m), base frame.
    p : ndarray, shape (6, 3)
        Platform points (m), platform frame.
    k : ndarray, shape (6, 3)
        Unit vectors along the fixed axes of the universal joints, base frame; zeros for spherical base
        joints.
    m_d, m_u : ndarray, shape (6,)
        Masses (kg) of the lower and upper parts of the legs.
    r_d0 : ndarray, shape (6, 3)
        Centers of mass (m) of the lower parts, frame D with its origin at the base point.
    I_d0, I_u0 : ndarray, shape (6, 3, 3)
        Inertias (kg m^2) of the lower and upper parts about their centers of mass, frames D and U.
    r_u0 : ndarray, shape (6, 3)
        Centers of mass (m) of the upper parts, frame U with its origin at the platform point.
    C_u, C_p, C_s : ndarray, shape (6,)
        Viscous friction of the base joints (N m s), prismatic joints (N s/m), and spherical joints (N m s).
    length_limits : ndarray, shape (6, 2), optional
        Minimum and maximum leg lengths (m); a row (0, inf) means no limit.
    force_limit, speed_limit : ndarray, shape (6,), optional
        Limits of the actuators (N and m/s); inf means no limit.
    joint_angle_limit : ndarray, shape (6, 2), optional
        Largest angles (rad) between a leg and its direction at the home pose: column 0 in the base frame,
        column 1 in the platform frame. The value pi means no limit at this end; a row (inf, inf) means no
        limit.
    lower_length, upper_length : ndarray, shape (6,), optional
        Lengths (m) of the parts, from the base point and from the platform point to the other end; 0 if not
        given. They are for drawings and do not affect forces.
    suppressed_warnings : tuple of str, optional
        Names, from ``WARNING_NAMES``, of warnings that are not issued for this robot.
    home_position : ndarray, shape (3,), optional
        Position (m) of the reference point at the home pose, base frame; the platform is parallel to the
        base. None if not given.
    tool : ndarray, shape (3,), optional
        Point (m), platform frame, whose poses the trajectory files of this robot describe.
    trajectory_format : TrajectoryFormat, optional
        Columns, units, and conventions of these files, used where neither an option nor the file states them.
    drive : Drive, optional
        Drives of the legs; None if not given.
    offsets : JointOffsets, optional
        Offset joints; None for legs whose axes intersect.
    length_unit, angle_unit : str, optional
        Units of lengths and angles in texts and plots of reports, from the robot file; by default "m" and
        "rad". All attributes have SI units.

    Raises
    ------
    ValueError
        If a value violates a rule of the robot file; the message names the field. ``dataclasses.replace``
        makes a changed copy and checks it again, except for inertias that no body can have: see
        ``find_invalid_inertias``.

    Examples
    --------
    >>> import dataclasses
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("unal")
    >>> robot.b.shape
    (6, 3)
    >>> heavier = dataclasses.replace(robot, M=10.0)
    >>> heavier.M
    10.0
    """

    name: str
    base_joint: str
    g: Array
    M: float
    R_0: Array
    I_p: Array
    b: Array
    p: Array
    k: Array
    m_d: Array
    r_d0: Array
    I_d0: Array
    m_u: Array
    r_u0: Array
    I_u0: Array
    C_u: Array
    C_p: Array
    C_s: Array
    length_limits: Array = field(default_factory=lambda: np.tile([0.0, math.inf], (LEGS, 1)))
    force_limit: Array = field(default_factory=lambda: np.full(LEGS, math.inf))
    speed_limit: Array = field(default_factory=lambda: np.full(LEGS, math.inf))
    joint_angle_limit: Array = field(default_factory=lambda: np.full((LEGS, 2), math.inf))
    lower_length: Array = field(default_factory=lambda: np.zeros(LEGS))
    upper_length: Array = field(default_factory=lambda: np.zeros(LEGS))
    suppressed_warnings: tuple[str, ...] = ()
    home_position: Array | None = None
    tool: Array = field(default_factory=lambda: np.zeros(3))
    trajectory_format: TrajectoryFormat = field(default_factory=TrajectoryFormat)
    drive: Drive | None = None
    offsets: JointOffsets | None = None
    length_unit: str = "m"
    angle_unit: str = "rad"

    def __post_init__(self) -> None:
        base_joint(self.base_joint, "robot: base_joint")
        checked: dict[str, Any] = {"name": safe_text(toml_reader.one_line(self.name, "robot: name"))}
        checked["suppressed_warnings"] = fields.accepted(
            self.suppressed_warnings, "robot: suppressed_warnings"
        )
        for name, check in (
            {name: check for name, (_, check) in fields.FIELDS.items()} | fields.POSE_FIELDS
        ).items():
            checked[name] = check(getattr(self, name), f"robot: {name}")
        spherical = self.base_joint == "spherical"
        for name, (_, check) in fields.LEG_FIELDS.items():
            checked[name] = self._per_leg(name, fields.no_direction if spherical and name == "k" else check)
        fields.need_whole_bodies(checked, "robot: ")
        instance(self.trajectory_format, TrajectoryFormat, "robot: trajectory_format")
        fields.need_home(self.trajectory_format, checked["home_position"], "robot: ")
        if np.isfinite(checked["joint_angle_limit"]).any() and checked["home_position"] is None:
            raise ValueError("robot: joint_angle_limit: refers to the home pose; add home_position")
        if not isinstance(self.drive, Drive | None):
            raise ValueError(f"robot: drive: expected a Drive or None, got {shown(self.drive)}")
        self._set(checked)
        if not isinstance(self.offsets, JointOffsets | None):
            raise ValueError(f"robot: offsets: expected JointOffsets or None, got {shown(self.offsets)}")
        if self.offsets is not None and spherical:
            raise ValueError('robot: offsets: expected none when base_joint is "spherical"')
        if spherical:
            fields.need_axisymmetric(checked, lambda i, name: f"robot: leg {i + 1}: {name}")

    def _per_leg(self, name: str, check: fields.Check) -> Array:
        given = getattr(self, name)
        rows = given.tolist() if isinstance(given, np.ndarray) else given
        if isinstance(rows, list | tuple) and len(rows) == LEGS:
            return np.array([check(row, f"robot: leg {i}: {name}") for i, row in enumerate(rows, 1)])
        if name in ("b", "p"):
            raise ValueError(f"robot: {name}: expected one entry for each of six legs")
        try:
            return np.array([check(rows, f"robot: {name}")] * LEGS)
        except ValueError as error:
            raise ValueError(f"{error} (one for all legs, or six)") from None

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Robot:
        """Read a robot file (TOML, schema 2).

        Parameters
        ----------
        path : str or os.PathLike
            Path of the robot file.

        Returns
        -------
        Robot
            Checked robot.

        Raises
        ------
        ValueError
            If the file cannot be read or violates the schema. The message is one line, ``file: key: expected
            ... (at line n)``; legs are numbered from 1.

        Warns
        -----
        RobotWarning
            About inertias that no body can have and densities that almost no body has, unless the file
            suppresses these warnings.
        """
        source = os.fsdecode(path)
        with toml_reader.toml_tables(source, "robot file") as d:
            robot = cls._read(d, source)
        _warn(robot, d, source)
        return robot

    @classmethod
    def from_dict(cls, d: Mapping[str, Any]) -> Robot:
        """Make a robot from the tables of a robot file.

        Parameters
        ----------
        d : dict
            Tables as plain Python dicts and lists.

        Returns
        -------
        Robot
            Checked robot.

        Raises
        ------
        ValueError
            As in ``from_toml``, with ``robot`` in place of the file name and without line numbers.

        Warns
        -----
        RobotWarning
            As in ``from_toml``.
        """
        robot = cls._read(d, "robot")
        _warn(robot, d, "robot")
        return robot

    @classmethod
    def _read(cls, d: object, source: str) -> Robot:
        """Check the tables of a robot file; every message begins with ``source: ``."""
        file = f"{source}: "
        if not isinstance(d, Mapping):
            raise ValueError(f"{source}: expected a table, got {shown(d)}")
        toml_reader.require(d, ("schema",), file, "missing")
        _need_schema(d["schema"], f"{file}schema")
        # schema_2 checks the tables, with messages that name the keys; __post_init__ would repeat the checks.
        robot = object.__new__(cls)
        robot._set(fields.DEFAULTS | schema_2.values(d, file))
        return robot

    def to_dict(self) -> dict[str, Any]:
        """Return the robot as the tables of a robot file.

        Returns
        -------
        dict
            Tables of schema 2 in SI units, with ``length_unit`` "m" and ``angle_unit`` "rad". ``from_dict``
            restores all other fields to the bit.
        """
        return schema_2.tables_of(vars(self))

    @property
    def reflected_mass(self) -> Array:
        """Reflected masses of the rotors (kg), J_r N^2, shape (6,); zero without a drive."""
        return np.zeros(LEGS) if self.drive is None else self.drive.reflected_mass

    @property
    def rotor_momentum(self) -> Array:
        """Angular momenta of the rotors per rate of length (kg m), J_r N, shape (6,).

        Zero without a drive, and zero with spherical base joints, because the spin of the legs is free.
        """
        if self.drive is None or self.base_joint != "universal":
            return np.zeros(LEGS)
        return self.drive.rotor_momentum

    @property
    def has_rotors(self) -> bool:
        """True if the rotor of any leg has inertia."""
        return self.drive is not None and bool(np.any(self.drive.rotor_inertia))

    @property
    def missing_bodies(self) -> tuple[str, ...]:
        """Keys of the bodies whose mass properties the robot file does not contain; () with all masses."""
        return tuple(
            key for key, (mass, *_) in fields.MASS_FIELDS.items() if np.isnan(getattr(self, mass)).any()
        )

    @property
    def has_joint_angle_limits(self) -> bool:
        """True if any joint angle has a limit."""
        return bool(np.isfinite(self.joint_angle_limit).any())

    def find_invalid_inertias(self) -> list[str]:
        """Find the parts whose inertia no rigid body can have.

        Principal moments A <= B <= C of a rigid body satisfy A >= 0 and A + B >= C.

        Returns
        -------
        list of str
            One line for each such part; legs with the same tensor share a line. Empty if all inertias are
            possible. Suppressed warnings are included.
        """
        return [message for _, message in impossible_inertias(self)]


_SYMBOLS = {
    "m_r": "reflected_mass",
    "j_r": "rotor_momentum",
    "cross": "axis_offset",
    "along": "slide_offset_y",
    "across": "slide_offset_z",
}


def need_masses(robot: Robot, used_for: str = "dynamics") -> None:
    """Raise ValueError for a robot file without all masses; ``used_for`` is the subject of the message."""
    missing = robot.missing_bodies
    if missing:
        raise ValueError(
            f"robot: {', '.join(missing)}: missing; {used_for} requires mass, center_of_mass, and inertia"
        )


def need_drive(robot: Robot) -> None:
    """Raise ValueError for a robot without a drive."""
    if robot.drive is None:
        raise ValueError("robot: drive: missing; motor torques require [legs.drive] in the robot file")


def has_symbol(owner: Any, symbol: str) -> bool:
    """Return True if a robot, its offsets, or its numbers have a symbol of the generated code."""
    return hasattr(owner, symbol) or hasattr(owner, _SYMBOLS.get(symbol, symbol))


def of_symbol(owner: Any, symbol: str) -> Any:
    """Return the attribute of a robot, its offsets, or its numbers for a symbol of the generated code."""
    return getattr(owner, symbol if hasattr(owner, symbol) else _SYMBOLS.get(symbol, symbol))


# Physicality


def impossible_inertias(robot: Robot) -> list[tuple[str, str]]:
    """Return the warning name (from ``WARNING_NAMES``) and the message of each impossible inertia."""
    missing = robot.missing_bodies
    found = []
    if "platform.body" not in missing:
        found = [("platform-inertia", f"platform: inertia: {fault}") for fault in inertia_fault(robot.I_p)]
    for part, tensors in (("lower", robot.I_d0), ("upper", robot.I_u0)):
        alike: dict[bytes, list[int]] = {}
        for i, tensor in enumerate(tensors if f"legs.{part}" not in missing else ()):
            alike.setdefault(tensor.tobytes(), []).append(i)
        for legs in alike.values():
            for fault in inertia_fault(tensors[legs[0]]):
                found.append((f"{part}-inertia", f"{part} part of {legs_text(legs)}: inertia: {fault}"))
    return found


def inertia_fault(inertia: Array) -> list[str]:
    """Return the reason why no body can have an inertia (3, 3); empty if a body can have it."""
    A, B, C = (float(moment) for moment in np.linalg.eigvalsh(inertia))
    tolerance = fields.SYMMETRY_TOLERANCE * max(abs(A), abs(C))
    moments = f"principal moments {A:.3g}, {B:.3g}, {C:.3g} kg m^2"
    # A thin rod has A = 0, so bodies at the limit are accepted.
    if A + tolerance < 0.0:
        return [f"physically impossible: {moments} are not all positive"]
    if A + B + tolerance < C:
        return [f"physically impossible: {moments} break A + B >= C by {C - A - B:.2g} kg m^2"]
    return []


def _need_schema(value: object, where: str) -> None:
    """Raise ValueError unless the schema is 2, with advice for files of schema 1."""
    if type(value) is int and value == 1:
        remedy = (
            "write schema = 2, six points in [base] and [platform], the inertia in [platform.body], "
            "common values of the legs in [legs], and [leg.1] to [leg.6] in place of [[leg]]"
        )
        raise ValueError(f"{where}: schema 1 is no longer read; {remedy}")
    whole_number(value, where, schema_2.SCHEMA, str(schema_2.SCHEMA), schema_2.SCHEMA)


def _warn(robot: Robot, d: Mapping[str, Any], source: str) -> None:
    """Warn of inertias and densities that no body, or almost none, can have."""
    of_parts: list[tuple[str, str]] = []
    low = low_densities(d)
    for key, tensor in inertias_of_parts(d).items():
        body = next((each for each in ("lower", "upper") if each in key), "platform")
        of_parts += [(f"{body}-inertia", f"{key}: {fault}") for fault in inertia_fault(tensor)]
    # A sum is not reported if an impossible part explains it.
    of_sums = [each for each in impossible_inertias(robot) if each[0] not in dict(of_parts)]
    found = of_sums + of_parts
    if low:
        text = f"{', '.join(low)}: {min(low.values()):g} kg/m^3; likely cause: given in g/cm^3"
        found.append(("density", text))
    for name, message in found:
        if name not in robot.suppressed_warnings:
            warn(f"{source}: {message} [{name}]", RobotWarning)


def about_point(robot: Robot, point: Array) -> Robot:
    """Return the same machine with a platform point (m), platform frame, (3,), as the reference point."""
    home = None if robot.home_position is None else robot.home_position + point
    return replace(
        robot, p=robot.p - point, R_0=robot.R_0 - point, tool=robot.tool - point, home_position=home
    )
