"""The machine: geometry, masses, friction and limits, as read from a robot file and checked once."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..io import toml_reader
from ..io.arguments import shown
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.frozen import Frozen
from . import fields, schema_2
from .bodies import inertias_of_parts, low_densities
from .drive import Drive
from .fields import LEGS as LEGS
from .fields import WARNING_NAMES as WARNING_NAMES
from .fields import base_joint
from .fields import legs_text as legs_text
from .offsets import JointOffsets


class RobotWarning(UserWarning):
    """Numbers that no machine, or hardly one, can have; the robot is loaded all the same."""


@dataclass(frozen=True, eq=False)
class Robot(Frozen):
    """A Stewart platform with six legs, all of them distinct if need be.  SI units; arrays are read-only.

    One entry alone may be given for an array (6, ...), that of all legs, but for ``b`` and ``p``.

    Attributes
    ----------
    name : str
        One line of text.
    base_joint : str
        ``"universal"`` (the paper's machine) or ``"spherical"`` (joints of that kind at both ends).
    g : ndarray
        Gravity, m/s^2, base frame, (3,).
    M : float
        Platform mass with payload, kg.
    R_0 : ndarray
        Center of mass of the platform, m, platform frame, (3,).
    I_p : ndarray
        Its inertia about that center of mass, kg m^2, platform frame, (3, 3).
    b : ndarray
        Base points, m, base frame, (6, 3).
    p : ndarray
        Platform points, m, platform frame, (6, 3).
    k : ndarray
        Unit fixed axes of the universal joints, base frame, (6, 3); zeros when ``base_joint`` is spherical.
    m_d, m_u : ndarray
        Masses of the lower and upper parts, kg, (6,).
    r_d0 : ndarray
        Centers of mass of the lower parts, m, frame D (origin at the base point), (6, 3).
    I_d0, I_u0 : ndarray
        Inertias about those centers of mass, kg m^2, frames D and U, (6, 3, 3).
    r_u0 : ndarray
        Centers of mass of the upper parts, m, frame U (origin at the platform point), (6, 3).
    C_u, C_p, C_s : ndarray
        Viscous friction of the base joint (N m s), prismatic joint (N s/m) and spherical joint (N m s), (6,).
    length_limits : ndarray, optional
        Shortest and longest leg, m, (6, 2); a row (0, inf) means no limit.
    force_limit, speed_limit : ndarray, optional
        Of the actuators, N and m/s, (6,); inf means no limit.
    joint_angle_limit : ndarray, optional
        Largest angles between a leg and its direction at the home pose, in the base frame and in the platform
        frame, rad, (6, 2), pi for none at one end; a row (inf, inf) means no limit.
    lower_length, upper_length : ndarray, optional
        Of the parts, from the base point and from the platform point to the other end, m, (6,); 0 where not
        stated. For drawings: forces do not depend on them.
    suppressed_warnings : tuple, optional
        Names, of ``WARNING_NAMES``, of warnings that are known of this robot and not given.
    home_position : ndarray, optional
        Home pose: position of the platform's reference point, m, base frame, (3,), the platform parallel to
        the base; None where none is stated.
    tool : ndarray, optional
        Point whose poses the rows of its trajectory files give, m, platform frame, (3,).
    euler_order : str, optional
        Order in which these files multiply rotations, ``"zyx"`` for R = Rz Ry Rx.
    length_mode : str, optional
        Leg lengths in these files: ``"absolute"``, or ``"relative"`` to those of the home pose.
    drive : Drive, optional
        What moves the legs; None where nothing is stated of it.
    offsets : JointOffsets, optional
        Offset joints; None for legs whose axes meet.

    Raises
    ------
    ValueError
        Naming the field when a value breaks a rule of the robot file. ``dataclasses.replace`` makes a changed
        copy and checks it again, but for what no body can be: see ``find_invalid_inertias``.
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
    euler_order: str = "zyx"
    length_mode: str = "absolute"
    drive: Drive | None = None
    offsets: JointOffsets | None = None

    def __post_init__(self) -> None:
        base_joint(self.base_joint, "robot: base_joint")
        checked: dict[str, Any] = {"name": toml_reader.title(self.name, "robot: name")}
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
        if self.length_mode == "relative" and checked["home_position"] is None:
            raise ValueError('robot: length_mode: "relative" refers to the home pose; add home_position')
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
            The file.

        Returns
        -------
        Robot
            The machine, checked.

        Raises
        ------
        ValueError
            Of one line, ``file: key: what was expected (at line n)``, for a file that cannot be read and for
            every break of the schema; legs are numbered from 1.

        Warns
        -----
        RobotWarning
            About inertias that no body can have and densities that hardly any has, unless the file accepts
            them.
        """
        source = toml_reader.file_name(path)
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
            The tables as plain Python dicts and lists.

        Returns
        -------
        Robot
            The machine, checked.

        Raises
        ------
        ValueError
            As ``from_toml``, with ``robot`` in place of the file's name and without lines.

        Warns
        -----
        RobotWarning
            As ``from_toml``.
        """
        robot = cls._read(d, "robot")
        _warn(robot, d, "robot")
        return robot

    @classmethod
    def _read(cls, d: object, source: str) -> Robot:
        """Check the tables of a robot file; ``source: `` begins every message."""
        file = f"{source}: "
        if not isinstance(d, Mapping):
            raise ValueError(f"{source}: expected a table, got {shown(d)}")
        toml_reader.require(d, ("schema",), file, "missing")
        _need_schema(d["schema"], f"{file}schema")
        # Checked where a message can name the key, and so not again as fields.
        robot = object.__new__(cls)
        robot._set(fields.DEFAULTS | schema_2.values(d, file))
        return robot

    def to_dict(self) -> dict[str, Any]:
        """Return the robot as the tables of a robot file.

        Returns
        -------
        dict
            Tables of schema 2 in SI units. ``from_dict`` undoes the conversion to the bit.
        """
        return schema_2.tables_of(vars(self))

    # Readable names of the paper's symbols.

    @property
    def platform_mass(self) -> float:
        """Platform mass with payload (kg)."""
        return self.M

    @property
    def platform_com(self) -> Array:
        """Center of mass of the platform (m), platform frame, shape (3,)."""
        return self.R_0

    @property
    def platform_inertia(self) -> Array:
        """Inertia of the platform about its center of mass (kg m^2), platform frame, shape (3, 3)."""
        return self.I_p

    @property
    def base_points(self) -> Array:
        """Base points (m), base frame, shape (6, 3)."""
        return self.b

    @property
    def platform_points(self) -> Array:
        """Platform points (m), platform frame, shape (6, 3)."""
        return self.p

    @property
    def universal_axes(self) -> Array:
        """Unit fixed axes of the universal joints, base frame, shape (6, 3)."""
        return self.k

    @property
    def lower_mass(self) -> Array:
        """Masses of the lower parts (kg), shape (6,)."""
        return self.m_d

    @property
    def upper_mass(self) -> Array:
        """Masses of the upper parts (kg), shape (6,)."""
        return self.m_u

    @property
    def gravity(self) -> Array:
        """Gravity (m/s^2), base frame, shape (3,)."""
        return self.g

    @property
    def reflected_mass(self) -> Array:
        """Reflected masses of the rotors, J_r N^2, kg, (6,); zero without a drive."""
        return np.zeros(LEGS) if self.drive is None else self.drive.reflected_mass

    @property
    def rotor_momentum(self) -> Array:
        """Angular momenta of the rotors per rate of length, J_r N, kg m, (6,); zero without a drive.

        Zero as well with spherical base joints: nothing fixes the spin of the legs, on which they act.
        """
        if self.drive is None or self.base_joint != "universal":
            return np.zeros(LEGS)
        return self.drive.rotor_momentum

    @property
    def has_rotors(self) -> bool:
        """Whether any leg's rotor has inertia."""
        return self.drive is not None and bool(np.any(self.drive.rotor_inertia))

    @property
    def has_joint_angle_limits(self) -> bool:
        """Whether any joint's angle has a limit."""
        return bool(np.isfinite(self.joint_angle_limit).any())

    def find_invalid_inertias(self) -> list[str]:
        """Find the parts whose inertia no rigid body can have.

        Principal moments A <= B <= C of a body satisfy A >= 0 and A + B >= C.

        Returns
        -------
        list of str
            One line for each such part, legs with the same tensor sharing one; empty when all are possible.
            What the robot accepts is reported as well.
        """
        return [message for _, message in impossible_inertias(self)]


_SYMBOLS = {
    "m_r": "reflected_mass",
    "j_r": "rotor_momentum",
    "cross": "axis_offset",
    "along": "slide_offset_y",
    "across": "slide_offset_z",
}


def has_symbol(owner: Any, symbol: str) -> bool:
    """Return True if a robot, its offsets, or its numbers have a symbol of the generated code."""
    return hasattr(owner, symbol) or hasattr(owner, _SYMBOLS.get(symbol, symbol))


def of_symbol(owner: Any, symbol: str) -> Any:
    """Return the attribute of a robot, its offsets, or its numbers for a symbol of the generated code."""
    return getattr(owner, symbol if hasattr(owner, symbol) else _SYMBOLS.get(symbol, symbol))


# Physicality


def impossible_inertias(robot: Robot) -> list[tuple[str, str]]:
    """Name, of ``WARNING_NAMES``, and line of each impossible inertia."""
    found = [("platform-inertia", f"platform: inertia: {fault}") for fault in inertia_fault(robot.I_p)]
    for part, tensors in (("lower", robot.I_d0), ("upper", robot.I_u0)):
        alike: dict[bytes, list[int]] = {}
        for i, tensor in enumerate(tensors):
            alike.setdefault(tensor.tobytes(), []).append(i)
        for legs in alike.values():
            for fault in inertia_fault(tensors[legs[0]]):
                found.append((f"{part}-inertia", f"{part} part of {legs_text(legs)}: inertia: {fault}"))
    return found


def inertia_fault(inertia: Array) -> list[str]:
    """What makes a tensor, (3, 3), that of no body; empty where it is one's."""
    A, B, C = (float(moment) for moment in np.linalg.eigvalsh(inertia))
    tolerance = fields.SYMMETRY_TOLERANCE * max(abs(A), abs(C))
    moments = f"principal moments {A:.3g}, {B:.3g}, {C:.3g} kg m^2"
    # A thin rod has A = 0: the limit of possible bodies is let pass.
    if A + tolerance < 0.0:
        return [f"physically impossible: {moments} are not all positive"]
    if A + B + tolerance < C:
        return [f"physically impossible: {moments} break A + B >= C by {C - A - B:.2g} kg m^2"]
    return []


def _need_schema(value: object, where: str) -> None:
    """Reject every schema but the one that is read, with the remedy for files of schema 1."""
    if type(value) is int and value == 1:
        remedy = (
            "write schema = 2, six points in [base] and [platform], the inertia in [platform.body], "
            "common values of the legs in [legs], and [leg.1] to [leg.6] in place of [[leg]]"
        )
        raise ValueError(f"{where}: schema 1 is no longer read; {remedy}")
    toml_reader.need_schema(value, (schema_2.SCHEMA,), where)


def _warn(robot: Robot, d: Mapping[str, Any], source: str) -> None:
    """Warn of what is doubtful in the tables alone, or impossible."""
    of_parts: list[tuple[str, str]] = []
    low = low_densities(d)
    for key, tensor in inertias_of_parts(d).items():
        body = next((each for each in ("lower", "upper") if each in key), "platform")
        of_parts += [(f"{body}-inertia", f"{key}: {fault}") for fault in inertia_fault(tensor)]
    # A part that is impossible explains a sum that is.
    of_sums = [each for each in impossible_inertias(robot) if each[0] not in dict(of_parts)]
    found = of_sums + of_parts
    if low:
        text = f"{', '.join(low)}: {min(low.values()):g} kg/m^3; likely cause: given in g/cm^3"
        found.append(("density", text))
    for name, message in found:
        if name not in robot.suppressed_warnings:
            warn(f"{source}: {message} [{name}]", RobotWarning)


def about_point(robot: Robot, point: Array) -> Robot:
    """Return the same machine with a platform point (m), platform frame, (3,), as its reference point."""
    home = None if robot.home_position is None else robot.home_position + point
    return replace(
        robot, p=robot.p - point, R_0=robot.R_0 - point, tool=robot.tool - point, home_position=home
    )
