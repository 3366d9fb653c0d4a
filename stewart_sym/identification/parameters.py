"""The regressor: the platform's equations of motion as a matrix times the machine's inertial parameters.

    H F + [R F_ext; R M_ext] = Y pi

Y depends on the points, the axes, gravity and the motion alone, pi on masses, centers of mass, inertias and
friction alone.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..backend.c_kernel import address, call, library
from ..backend.kernel import robot_numbers
from ..backend.numpy_kernel import legs_side_by_side, on_arrays
from ..dynamics.inverse_dynamics import Backend, need_motion, need_universal, report_faults, with_compiler
from ..generated import exact_regressor
from ..generated import rotor_regressor as exact_rotors
from ..io.arguments import instance, option, real_array, shown
from ..io.array_types import Array, Codes, Flags
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion
from ..reference.equations_of_motion import coriolis, with_rates
from ..reference.equations_of_motion import regressor as reference_regressor
from ..results import NOT_FINITE, OK
from ..robot.robot import LEGS, Robot

_UPPER = np.triu_indices(3)
# Parameters of a body: mass, first moment, inertia.
_BODY = 10
_COLUMNS = LEGS * len(exact_regressor.LEG_PARAMETERS) + len(exact_regressor.PLATFORM_PARAMETERS)


@dataclass(frozen=True, eq=False)
class ParameterVector:
    """Inertial and friction parameters of the thirteen bodies, in the order of the columns of Y.

    Leg after leg, 23 each: m_d, first moment h_d = m_d r_d0 and inertia J_d (xx, xy, xz, yy, yz, zz) of the
    lower part about the base point, frame D; m_u, h_u, J_u of the upper part about the platform point, frame
    U; C_u, C_p, C_s. Then 10 of the platform: M, h_P = M R_0 and J_P about its reference point, platform
    frame.

    Attributes
    ----------
    values : ndarray
        (148,), SI.
    names : tuple
        As in the robot's fields, with the number of the leg: ``h_d1_x``, ``J_P_xy``.
    units : tuple
        Of each.
    """

    values: Array
    names: tuple[str, ...]
    units: tuple[str, ...]


def regressor(
    robot: Robot,
    motion: Motion,
    on_singular: OnFault = "raise",
    columns: ArrayLike | None = None,
    backend: Backend = "c",
) -> Array:
    """Y of H F + [R F_ext; R M_ext] = Y pi, (..., 6, 148); formulation `exact`, universal base joints.

    Rows 0-2 are forces, N, rows 3-5 moments about the reference point, N m, base frame, each over the unit of
    its parameter; columns as in ``ParameterVector``. Equal and zero columns are meant (``base_parameters``).
    The load of the motion has no part in Y; rotors of the legs have columns of their own
    (``rotor_regressor``).

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    on_singular : {"raise", "nan", "warn"}, optional
        As for ``inverse_dynamics``, but singular H is no fault.
    columns : array_like of int, optional
        Numbers of the columns to compute, (n,), such as ``BaseParametersResult.kept``. None: all.
    backend : {"c", "numpy", "reference"}, optional
        As for ``inverse_dynamics``.

    Returns
    -------
    ndarray
        Y, (..., 6, 148), or its columns that are asked for, (..., 6, n).

    Raises
    ------
    ValueError
        For spherical base joints, for a motion without accelerations, for columns that there are not, and for
        poses in which a leg has length zero or lies along its universal axis.
    """
    need_universal(robot)
    need_motion(robot, motion)
    option(on_singular, ON_FAULT, "on_singular")
    option(backend, BACKENDS, "backend")
    Y, status = evaluated(robot, motion, None if columns is None else _column_numbers(columns), backend)
    report_faults(status, robot, motion, on_singular)
    return Y


def evaluated(
    robot: Robot, motion: Motion, columns: NDArray[np.int32] | None, backend: Backend
) -> tuple[Array, Codes]:
    """Y, NaN where the status is not 0, and the status, (...), of checked arguments."""
    Y, status = _FOUND_BY[backend](robot, motion, columns)
    Y[status != OK] = np.nan
    return Y, status


def _column_numbers(columns: ArrayLike) -> NDArray[np.int32]:
    """Numbers of columns as C takes them."""
    expected = f"whole numbers from 0 to {_COLUMNS - 1}, (n,)"
    given = real_array(columns, "columns", expected)
    within = (given >= 0) & (given < _COLUMNS) & (given == np.floor(given))
    if given.ndim != 1 or not within.all():
        raise ValueError(f"columns: expected {expected}, got {shown(columns)}")
    return np.ascontiguousarray(given, dtype=np.int32)


def _compiled(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    def run() -> tuple[Array, Codes]:
        source, width = library("exact_regressor"), 0 if columns is None else len(columns)
        Y = np.empty((*motion.shape, 6, _COLUMNS if columns is None else width))
        status = np.zeros(motion.shape, dtype=np.int32)
        chosen = (address(columns), ctypes.c_size_t(width))
        code = source.stewart_exact_regressor_batch
        call(code, robot_numbers(robot), motion, *chosen, address(Y), address(status))
        return Y, status

    found: tuple[Array, Codes] = with_compiler(run, lambda: _on_arrays(robot, motion, columns))
    return found


def _on_arrays(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    of_leg, of_platform = exact_regressor.LEG_PARAMETERS, exact_regressor.PLATFORM_PARAMETERS

    def run(on: Any, structure: Any, part: Any, _: slice) -> Any:
        found = exact_regressor.regressor(on, structure, part)
        legs, platform = _columns(found.legs, of_leg), _columns(found.platform, of_platform)
        return {"legs": legs, "platform": platform, "status": found.status}

    shapes = {"legs": (len(of_leg), 6, LEGS), "platform": (len(of_platform), 6)}
    found, status = on_arrays(run, legs_side_by_side(robot), motion, shapes)
    legs = np.moveaxis(found["legs"], -3, -1).reshape(*motion.shape, 6, LEGS * len(of_leg))
    Y = np.concatenate([legs, found["platform"].swapaxes(-1, -2)], axis=-1)
    status[(status == OK) & ~np.isfinite(Y).all(axis=(-1, -2))] = NOT_FINITE
    return Y if columns is None else Y[..., columns], status


def _reference(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    Y, status = reference_regressor(robot, motion)
    return Y if columns is None else Y[..., columns], status


_FOUND_BY = {"c": _compiled, "numpy": _on_arrays, "reference": _reference}
BACKENDS = tuple(_FOUND_BY)


def _columns(found: Any, parameters: Sequence[tuple[str, str]]) -> list[list[Any]]:
    """The columns of parameters, each a list of its rows."""
    return [[*getattr(found, f"force_{name}"), *getattr(found, f"moment_{name}")] for name, _ in parameters]


def rotor_regressor(robot: Robot, motion: Motion, on_singular: OnFault = "raise") -> Array:
    """Y_r, (..., 6, 12): columns of the rotors of the legs' drives, besides those of the bodies in Y.

        H F + [R F_ext; R M_ext] = Y pi + Y_r [m_r; j_r]

    F is the motors' force along the legs; the columns are of m_r of legs 1 to 6, then of j_r; formulation
    `exact`. Rows and units are as of ``regressor``, parameters in kg and kg m: both of a leg follow from J_r,
    its turns per length being known.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive or without.
    motion : Motion
        Motion of the platform, any leading shape.
    on_singular : {"raise", "nan", "warn"}, optional
        As for ``regressor``.

    Returns
    -------
    ndarray
        Y_r, NaN where a pose has none.

    Raises
    ------
    ValueError
        For spherical base joints, for a motion without accelerations, and for poses in which a leg has length
        zero or lies along its universal axis.
    """
    need_universal(robot)
    need_motion(robot, motion)
    option(on_singular, ON_FAULT, "on_singular")
    _, status = evaluated(robot, motion, np.zeros(1, dtype=np.int32), "c")
    names = [f"{rows}_{name}" for name, _ in exact_rotors.PARAMETERS for rows in ("force", "moment")]

    def run(on: Any, structure: Any, part: Any, _: slice) -> Any:
        return vars(exact_rotors.rotor_columns(on, structure.leg, structure, part))

    found, _ = on_arrays(run, legs_side_by_side(robot), motion, dict.fromkeys(names, (3, LEGS)))
    columns = [
        np.concatenate([found[f"force_{name}"], found[f"moment_{name}"]], axis=-2)
        for name, _ in exact_rotors.PARAMETERS
    ]
    Y = np.concatenate(columns, axis=-1)
    Y[status != 0] = np.nan
    report_faults(status, robot, motion, on_singular)
    return Y


@dataclass(frozen=True, eq=False)
class EquationsByParameterResult:
    """Terms of M [a; alpha] + C [v; omega] + g + friction = Y pi for each parameter, in the last axis.

    A term times ``inertial_parameters(robot).values`` is that of ``equations_of_motion`` of a robot without
    rotors, which are no parameters.

    Attributes
    ----------
    M, C : ndarray
        (..., 6, 6, 148).
    g, friction : ndarray
        (..., 6, 148).
    """

    M: Array
    C: Array
    g: Array
    friction: Array


def equations_by_parameter(
    robot: Robot, motion: Motion, on_singular: OnFault = "raise", backend: Backend = "c"
) -> EquationsByParameterResult:
    """M, C, g and friction of each parameter, from the regressor at chosen rates and accelerations.

    g is Y at rest. Without gravity a column of M is Y at rest under a unit acceleration, friction what the
    columns of its coefficients are at the motion's rates, and C, as ``equations_of_motion`` has it, is drawn
    from Y at twelve twists.

    Parameters
    ----------
    robot : Robot
        The machine: points, axes and gravity.
    motion : Motion
        Poses and rates; accelerations and load don't count.
    on_singular, backend : str, optional
        As for ``regressor``.

    Returns
    -------
    EquationsByParameterResult
        Terms, the parameters as in ``ParameterVector``; NaN where a pose has no regressor.

    Raises
    ------
    ValueError
        As ``regressor``.
    """
    need_universal(robot)
    instance(motion, Motion, "motion")
    option(on_singular, ON_FAULT, "on_singular")
    option(backend, BACKENDS, "backend")
    weightless = replace(robot, g=np.zeros(3))
    of_friction = is_friction(parameter_names()[0])
    none, unit = np.zeros_like(motion.t), np.broadcast_to(np.eye(6), (*motion.shape, 6, 6))
    still = np.zeros((*motion.shape, 6, 3))
    status = np.zeros(motion.shape, dtype=np.int32)

    def Y(machine: Robot, v: Array, omega: Array, a: Array, alpha: Array) -> Array:
        """Parameters first."""
        found, codes = evaluated(machine, with_rates(motion, v, omega, a, alpha), None, backend)
        worst = codes.max(axis=-1) if codes.ndim > status.ndim else codes
        status[status == OK] = worst[status == OK]
        return np.moveaxis(found, -1, 0)

    def inertial(v: Array, omega: Array) -> Array:
        found = Y(weightless, v, omega, still, still)
        found[of_friction] = 0.0
        return found

    g = Y(robot, none, none, none, none)
    M = np.swapaxes(Y(weightless, still, still, unit[..., :3], unit[..., 3:]), -1, -2)
    friction = Y(weightless, motion.v, motion.omega, none, none)
    friction[~of_friction] = 0.0
    C = coriolis(inertial, robot, motion, M)
    terms = {"M": M, "C": C, "g": g, "friction": friction}
    for each in terms.values():
        each[:, status != OK] = np.nan
    report_faults(status, robot, motion, on_singular)
    return EquationsByParameterResult(**{name: np.moveaxis(each, 0, -1) for name, each in terms.items()})


def inertial_parameters(robot: Robot) -> ParameterVector:
    """The robot's pi, by Steiner's theorem about each part's joint point.

    Parameters
    ----------
    robot : Robot
        The machine.

    Returns
    -------
    Parameters
        Values, names and units of pi.

    Raises
    ------
    ValueError
        For spherical base joints.
    """
    need_universal(robot)
    lower = body_parameters(robot.m_d, robot.r_d0, robot.I_d0)
    upper = body_parameters(robot.m_u, robot.r_u0, robot.I_u0)
    friction = np.column_stack([robot.C_u, robot.C_p, robot.C_s])
    platform = body_parameters(np.array([robot.M]), robot.R_0[None], robot.I_p[None])
    legs = np.hstack([lower, upper, friction])
    names, units = parameter_names()
    return ParameterVector(np.concatenate([legs.ravel(), platform.ravel()]), names, units)


def with_parameters(robot: Robot, values: Array) -> Robot:
    """The robot with inertial and friction parameters, (148,), as in ``ParameterVector``, in place of its
    own.

    Raises ValueError as ``Robot`` for masses not > 0 and friction < 0; inertias are not checked.
    """
    legs, platform = values[:-_BODY].reshape(LEGS, -1), values[-_BODY:]
    m_d, r_d0, I_d0 = _about_center(legs[:, :_BODY])
    m_u, r_u0, I_u0 = _about_center(legs[:, _BODY : 2 * _BODY])
    M, R_0, I_p = (part[0] for part in _about_center(platform[None]))
    C_u, C_p, C_s = legs[:, 2 * _BODY :].T
    return replace(
        robot,
        M=float(M), R_0=R_0, I_p=I_p,
        m_d=m_d, r_d0=r_d0, I_d0=I_d0,
        m_u=m_u, r_u0=r_u0, I_u0=I_u0,
        C_u=C_u, C_p=C_p, C_s=C_s,
    )  # fmt: skip


def parameter_names() -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of the columns of Y."""
    rows = [
        (leg_name(name, leg), unit)
        for leg in range(1, LEGS + 1)
        for name, unit in exact_regressor.LEG_PARAMETERS
    ]
    rows += exact_regressor.PLATFORM_PARAMETERS
    return tuple(name for name, _ in rows), tuple(unit for _, unit in rows)


def is_friction(names: Sequence[str]) -> Flags:
    """Which names are of friction coefficients, (n,)."""
    return np.array([name.startswith("C_") for name in names], dtype=np.bool_)


def leg_name(name: str, leg: int) -> str:
    """``h_d_x`` of leg 1 is ``h_d1_x``."""
    head, under, axes = name.rpartition("_")
    return f"{head}{leg}_{axes}" if under and set(axes) <= set("xyz") else f"{name}{leg}"


def symmetric(six: Array) -> Array:
    """Matrices of (xx, xy, xz, yy, yz, zz), (..., 6) to (..., 3, 3)."""
    full = np.empty((*six.shape[:-1], 3, 3))
    full[..., *_UPPER] = six
    full[..., _UPPER[1], _UPPER[0]] = six
    return full


def _about_center(bodies: Array) -> tuple[Array, Array, Array]:
    """Masses, centers of mass and inertias about them of bodies as in ``ParameterVector``, (n, 10)."""
    m = bodies[:, 0]
    r = bodies[:, 1:4] / m[:, None]
    at_point = body_parameters(m, r, np.zeros((len(m), 3, 3)))[:, 4:]
    return m, r, symmetric(bodies[:, 4:] - at_point)


def body_parameters(m: Array, r: Array, inertia: Array) -> Array:
    """Mass, first moment and inertia about the point from which r (n, 3) is measured, (n, 10)."""
    outer = np.einsum("ni,nj->nij", r, r)
    about = inertia + m[:, None, None] * (
        np.trace(outer, axis1=1, axis2=2)[:, None, None] * np.eye(3) - outer
    )
    return np.hstack([m[:, None], m[:, None] * r, about[:, *_UPPER]])
