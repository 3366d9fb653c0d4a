"""M, C, g and friction by parameter: what each inertial parameter adds to the equations of motion."""

from dataclasses import dataclass, replace

import numpy as np

from ..dynamics.inverse import Backend, need_universal, report_faults
from ..io.arguments import instance, option
from ..io.array_types import Array
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion
from ..reference.equations_of_motion import coriolis, with_rates
from ..results import OK
from ..robot.robot import Robot
from .parameters import BACKENDS, evaluated, is_friction, parameter_names


@dataclass(frozen=True, eq=False)
class EquationsByParameter:
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
) -> EquationsByParameter:
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
    EquationsByParameter
        Terms, the parameters as in ``Parameters``; NaN where a pose has no regressor.

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
    report_faults(status, robot, motion, on_singular, stacklevel=3)
    return EquationsByParameter(**{name: np.moveaxis(each, 0, -1) for name, each in terms.items()})
