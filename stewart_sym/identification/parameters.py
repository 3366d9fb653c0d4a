"""Regressor: the equations of motion as a matrix times the inertial parameters.

    H F + [R F_ext; R M_ext] = Y pi

Y depends on points, axes, gravity, and motion only; pi depends on masses, centers of mass, inertias, and
friction only.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..backend.kernel import legs_side_by_side, robot_numbers
from ..calls.c_kernel import address, function, results_of
from ..calls.numpy_kernel import on_arrays
from ..dynamics.inverse_dynamics import Backend, need_motion, need_universal, report_faults, with_compiler
from ..generated import exact_regressor
from ..generated import rotor_regressor as exact_rotors
from ..io.arguments import instance, option, real_array, shown
from ..io.array_types import Array, Codes, Flags
from ..motion.motion import Motion
from ..reference.equations_of_motion import coriolis, with_rates
from ..reference.equations_of_motion import regressor as reference_regressor
from ..results import NOT_FINITE, OK, ON_FAULT, OnFault
from ..robot.robot import LEGS, Robot, need_masses

_UPPER = np.triu_indices(3)
_OF_LEG = len(exact_regressor.LEG_PARAMETERS)
_COLUMNS = LEGS * _OF_LEG + len(exact_regressor.PLATFORM_PARAMETERS)
_BY_LEG = np.arange(LEGS * _OF_LEG).reshape(LEGS, _OF_LEG)
BODIES = np.vstack([_BY_LEG[:, :20].reshape(2 * LEGS, 10), np.arange(_COLUMNS - 10, _COLUMNS)])
"""Indices of mass, first moment, and inertia: lower and upper parts of the legs, and platform, (13, 10)."""
FRICTION = _BY_LEG[:, 20:]
"""Indices of the friction coefficients C_u, C_p, and C_s of each leg, shape (6, 3)."""


@dataclass(frozen=True, eq=False)
class ParameterVector:
    """Inertial and friction parameters pi of the thirteen bodies, in the order of the columns of Y.

    Each leg has 23 parameters. The lower part has m_d, the first moment h_d = m_d r_d0, and the inertia J_d
    (xx, xy, xz, yy, yz, zz) about the base point in frame D. The upper part has m_u, h_u, and J_u about the
    platform point in frame U. The friction coefficients are C_u, C_p, and C_s. The platform has 10: M, h_P =
    M R_0, and J_P about its reference point in the platform frame.

    Attributes
    ----------
    values : ndarray, shape (148,)
        Values in SI units.
    names : tuple of str
        Names as in the fields of the robot, with the number of the leg: ``h_d1_x``, ``J_P_xy``.
    units : tuple of str
        Unit of each parameter.
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
    """Compute the regressor Y of H F + [R F_ext; R M_ext] = Y pi.

    The formulation is `exact`, for universal base joints.

    Parameters
    ----------
    robot : Robot
        Robot model; only its geometry and gravity are used.
    motion : Motion
        Motion with accelerations, shape (...). Its load has no effect on Y.
    on_singular : {"raise", "nan", "warn"}, optional
        Treatment of unsolvable poses, as in ``inverse_dynamics``; a singular H is no error here.
    columns : array_like of int, shape (n,), optional
        Indices of the columns to compute, for example ``BaseParametersResult.required_columns()``; by default
        all columns.
    backend : {"c", "numpy", "reference"}, optional
        Implementation, as in ``inverse_dynamics``.

    Returns
    -------
    ndarray, shape (..., 6, 148) or (..., 6, n)
        Regressor Y or its columns, in the order of ``ParameterVector``. Rows 0 to 2 are forces (N) and rows 3
        to 5 moments about the reference point (N m) in the base frame, each per unit of the parameter.

    Raises
    ------
    ValueError
        If the base joints are spherical, if the motion has no accelerations, if a column does not exist, or
        if a pose is unsolvable (leg of zero length, or parallel to its fixed joint axis).

    See Also
    --------
    inertial_parameters : Parameters pi of a robot.
    base_parameters : Independent columns of Y.
    rotor_regressor : Columns of the rotors of the drives.

    Notes
    -----
    Some columns of Y are zero or equal to each other, because the parameters are not independent; see
    ``base_parameters``.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample([0.0, 3.0, 6.0])
    >>> Y = ss.regressor(robot, motion)
    >>> Y.shape
    (3, 6, 148)
    >>> result = ss.inverse_dynamics(robot, motion)
    >>> wrench = np.einsum("nij,nj->ni", result.H, result.F)
    >>> np.allclose(Y @ ss.inertial_parameters(robot).values, wrench)
    True
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
    """Compute Y and the status, shape (...), for checked arguments; Y is NaN if the status is not 0."""
    Y, status = _FOUND_BY[backend](robot, motion, columns)
    Y[status != OK] = np.nan
    return Y, status


def _column_numbers(columns: ArrayLike) -> NDArray[np.int32]:
    """Return column indices as C integers."""
    expected = f"whole numbers from 0 to {_COLUMNS - 1}, (n,)"
    given = real_array(columns, "columns", expected)
    within = (given >= 0) & (given < _COLUMNS) & (given == np.floor(given))
    if given.ndim != 1 or not within.all():
        raise ValueError(f"columns: expected {expected}, got {shown(columns)}")
    return np.ascontiguousarray(given, dtype=np.int32)


def _compiled(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    """Compute Y and the status by the C kernel."""

    def run() -> tuple[Array, Codes]:
        width = 0 if columns is None else len(columns)
        shapes = {"Y": (6, _COLUMNS if columns is None else width)}
        chosen = (address(columns), ctypes.c_size_t(width))
        code = function("exact", "regressor_batch", "_regressor")
        found = results_of(code, robot_numbers(robot), motion, shapes, chosen, apart=True)
        return found["Y"], found["status"]

    found: tuple[Array, Codes] = with_compiler(run, lambda: _on_arrays(robot, motion, columns))
    return found


def _on_arrays(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    """Compute Y and the status by the NumPy kernel."""
    of_leg, of_platform = exact_regressor.LEG_PARAMETERS, exact_regressor.PLATFORM_PARAMETERS
    structure = legs_side_by_side(robot)

    def run(on: Any, part: Any, _: slice) -> Any:
        found = exact_regressor.regressor(on, structure, part)
        legs, platform = _columns(found.legs, of_leg), _columns(found.platform, of_platform)
        return {"legs": legs, "platform": platform, "status": found.status}

    shapes = {"legs": (len(of_leg), 6, LEGS), "platform": (len(of_platform), 6)}
    found = on_arrays(run, motion, shapes)
    legs = np.moveaxis(found["legs"], -3, -1).reshape(*motion.shape, 6, LEGS * len(of_leg))
    Y = np.concatenate([legs, found["platform"].swapaxes(-1, -2)], axis=-1)
    status = found["status"]
    status[(status == OK) & ~np.isfinite(Y).all(axis=(-1, -2))] = NOT_FINITE
    return Y if columns is None else Y[..., columns], status


def _reference(robot: Robot, motion: Motion, columns: NDArray[np.int32] | None) -> tuple[Array, Codes]:
    """Compute Y and the status by the reference implementation."""
    Y, status = reference_regressor(robot, motion)
    return Y if columns is None else Y[..., columns], status


_FOUND_BY = {"c": _compiled, "numpy": _on_arrays, "reference": _reference}
BACKENDS = tuple(_FOUND_BY)


def _columns(found: Any, parameters: Sequence[tuple[str, str]]) -> list[list[Any]]:
    """Return the columns of parameters, each as a list of its rows."""
    return [[*getattr(found, f"force_{name}"), *getattr(found, f"moment_{name}")] for name, _ in parameters]


def rotor_regressor(robot: Robot, motion: Motion, on_singular: OnFault = "raise") -> Array:
    """Compute the regressor Y_r of the rotors of the drives.

    The equations of motion with rotors are

        H F + [R F_ext; R M_ext] = Y pi + Y_r [m_r; j_r]

    with motor forces F along the legs, in the formulation `exact`.

    Parameters
    ----------
    robot : Robot
        Robot model, with or without a drive.
    motion : Motion
        Motion with accelerations, shape (...).
    on_singular : {"raise", "nan", "warn"}, optional
        Treatment of unsolvable poses, as in ``regressor``.

    Returns
    -------
    ndarray, shape (..., 6, 12)
        Columns of the reflected masses m_r (kg) of legs 1 to 6, followed by the rotor momenta j_r (kg m) of
        legs 1 to 6. Rows and units are the same as in ``regressor``; NaN if a pose has no solution.

    Raises
    ------
    ValueError
        If the base joints are spherical, if the motion has no accelerations, or if a leg has zero length or
        is parallel to the fixed axis of its universal joint.

    See Also
    --------
    regressor : Columns of the bodies and of friction.

    Notes
    -----
    Both parameters of a leg follow from the rotor inertia and the known transmission ratio.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample([0.0, 3.0, 6.0])
    >>> ss.rotor_regressor(robot, motion).shape
    (3, 6, 12)
    """
    need_universal(robot)
    need_motion(robot, motion)
    option(on_singular, ON_FAULT, "on_singular")
    _, status = evaluated(robot, motion, np.zeros(1, dtype=np.int32), "c")
    names = [f"{rows}_{name}" for name, _ in exact_rotors.PARAMETERS for rows in ("force", "moment")]
    structure = legs_side_by_side(robot)

    def run(on: Any, part: Any, _: slice) -> Any:
        return vars(exact_rotors.rotor_columns(on, structure.leg, structure, part))

    found = on_arrays(run, motion, dict.fromkeys(names, (3, LEGS)))
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
    """Terms of M [a; alpha] + C [v; omega] + g + friction = Y pi for each parameter, on the last axis.

    The product of a term with ``inertial_parameters(robot).values`` is the term of ``equations_of_motion``
    for a robot without rotors.

    Attributes
    ----------
    M, C : ndarray, shape (..., 6, 6, 148)
        Mass matrix and Coriolis matrix.
    g, friction : ndarray, shape (..., 6, 148)
        Gravity and friction wrenches.
    """

    M: Array
    C: Array
    g: Array
    friction: Array


def equations_by_parameter(
    robot: Robot, motion: Motion, on_singular: OnFault = "raise", backend: Backend = "c"
) -> EquationsByParameterResult:
    """Compute the mass matrix, Coriolis matrix, gravity, and friction for each inertial parameter.

    Parameters
    ----------
    robot : Robot
        Robot model; only its geometry and gravity are used.
    motion : Motion
        Poses and twists, shape (...); accelerations and load are ignored.
    on_singular : {"raise", "nan", "warn"}, optional
        Treatment of unsolvable poses, as in ``regressor``.
    backend : {"c", "numpy", "reference"}, optional
        Implementation, as in ``inverse_dynamics``.

    Returns
    -------
    EquationsByParameterResult
        Terms in the base frame, with the parameters on the last axis in the order of ``ParameterVector``; NaN
        if a pose has no regressor.

    Raises
    ------
    ValueError
        If the base joints are spherical, or if a leg has zero length or is parallel to the fixed axis of its
        universal joint.

    See Also
    --------
    equations_of_motion : The same terms for the parameters of a robot.
    regressor : The sum of the terms.

    Notes
    -----
    The terms are computed from the regressor. Gravity is Y at rest. A column of M is Y at rest under a unit
    acceleration without gravity. Friction consists of the columns of the friction coefficients. C is computed
    from Y at twelve twists.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample([0.0, 3.0, 6.0])
    >>> terms = ss.equations_by_parameter(robot, motion)
    >>> terms.M.shape
    (3, 6, 6, 148)
    >>> M = terms.M @ ss.inertial_parameters(robot).values
    >>> np.allclose(M, ss.equations_of_motion(robot, motion).M)
    True
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
        """Compute the regressor with the parameters on the first axis."""
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
    """Return the inertial parameters pi of a robot, about the joint point of each part.

    Parameters
    ----------
    robot : Robot
        Robot model.

    Returns
    -------
    ParameterVector
        Values in SI units, shape (148,), with names and units.

    Raises
    ------
    ValueError
        If the base joints are spherical.

    See Also
    --------
    regressor : Matrix Y that multiplies pi.
    base_parameters : Identifiable combinations of pi.

    Notes
    -----
    The inertias are moved from the centers of mass to the joint points by Steiner's theorem.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> pi = ss.inertial_parameters(ss.robots.load("dasgupta1998"))
    >>> pi.names[-10:-6], pi.values[-10:-6].round(3)
    (('M', 'h_P_x', 'h_P_y', 'h_P_z'), array([40. ,  1.6,  1.2, -2.4]))
    """
    need_universal(robot)
    need_masses(robot, "the parameter vector")
    m = np.append(np.column_stack([robot.m_d, robot.m_u]), robot.M)
    r = np.vstack([np.stack([robot.r_d0, robot.r_u0], axis=1).reshape(-1, 3), robot.R_0])
    inertia = np.vstack([np.stack([robot.I_d0, robot.I_u0], axis=1).reshape(-1, 3, 3), robot.I_p[None]])
    values = np.empty(_COLUMNS)
    values[BODIES] = _about_joint(m, r, inertia)
    values[FRICTION] = np.column_stack([robot.C_u, robot.C_p, robot.C_s])
    return ParameterVector(values, *parameter_names())


def parameter_names() -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return names and units of the columns of Y."""
    rows = [
        (leg_name(name, leg), unit)
        for leg in range(1, LEGS + 1)
        for name, unit in exact_regressor.LEG_PARAMETERS
    ]
    rows += exact_regressor.PLATFORM_PARAMETERS
    return tuple(name for name, _ in rows), tuple(unit for _, unit in rows)


def is_friction(names: Sequence[str]) -> Flags:
    """Return True for names of friction coefficients, shape (n,)."""
    return np.array([name.startswith("C_") for name in names], dtype=np.bool_)


def leg_name(name: str, leg: int) -> str:
    """Return the name of a parameter of a leg; ``h_d_x`` of leg 1 is ``h_d1_x``."""
    head, under, axes = name.rpartition("_")
    return f"{head}{leg}_{axes}" if under and set(axes) <= set("xyz") else f"{name}{leg}"


def symmetric(six: Array) -> Array:
    """Return symmetric matrices, shape (..., 3, 3), from (xx, xy, xz, yy, yz, zz), shape (..., 6)."""
    full = np.empty((*six.shape[:-1], 3, 3))
    full[..., *_UPPER] = six
    full[..., _UPPER[1], _UPPER[0]] = six
    return full


def _about_joint(m: Array, r: Array, inertia: Array) -> Array:
    """Return mass, first moment, and inertia about the origin of r, shape (n, 10)."""
    outer = np.einsum("ni,nj->nij", r, r)
    about = inertia + m[:, None, None] * (
        np.trace(outer, axis1=1, axis2=2)[:, None, None] * np.eye(3) - outer
    )
    return np.hstack([m[:, None], m[:, None] * r, about[:, *_UPPER]])
