"""Actuator forces with a bound of their rounding error, and how near each pose is to a singular one.

Lays arrays out for the C of ``stewart_exact_bounds.h``, where all bounding is done.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend.c_kernel import function, prepared_model, results_of
from ..backend.kernel import robot_kernel, takes_rotors
from ..generated.interface import MODELS
from ..io.arguments import option
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion
from ..robot.robot import Robot
from .forces import Precision
from .inverse_dynamics import need_motion, need_universal, report_faults

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class ForceErrorBoundsResult:
    """Forces of one or many poses and what can be said of their rounding; ``(...)`` is the motion's shape.

    Of the precision's type; NaN where the status is not 0.

    Attributes
    ----------
    F : ndarray
        Actuator forces, N, (..., 6), positive when they extend the leg, (37).
    bound : ndarray
        No force is farther than this from the exact one of the same numbers, N, (..., 6); inf where H is so
        near to singular that none can be had in this precision.
    rcond : ndarray
        Reciprocal condition of H, (...), in the norm of largest column sums, moments about the reference
        point over the characteristic length: 1 at best.
    status : ndarray of int
        0 where the pose was solved, else a code of ``STATUS_TEXT``; int, (...).
    """

    F: Array
    bound: Array
    rcond: Array
    status: NDArray[np.int32]


def force_error_bounds(
    robot: Robot, motion: Motion, precision: Precision = "double", on_singular: OnFault = "raise"
) -> ForceErrorBoundsResult:
    """Actuator forces of ``motion`` by the ``exact`` kernel, each with a bound of its rounding error.

    The bound is rigorous, short of overflow and underflow. It counts every operation from the robot's numbers
    on (running error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 3.3), each by the
    derivative of the force by its result, and it encloses the solution of H x = c (Rump, Acta Numerica 19
    (2010), 10). Inputs are taken as given, after they have been rounded to the precision, but for R, which
    stands for the rotation nearest to it.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Motion of the platform, any leading shape.
    precision : {"double", "float"}, optional
        "double" or "float".
    on_singular : {"raise", "nan", "warn"}, optional
        "raise" ValueError, "warn" and return NaN, or return "nan" without a warning for unsolvable poses;
        ``status`` is that of each pose.

    Returns
    -------
    ForceErrorBoundsResult
        Forces, bounds, reciprocal condition numbers and statuses.

    Raises
    ------
    ValueError
        For unknown options, a robot without universal base joints or with constants that the precision can't
        hold, a motion without accelerations, and unsolvable poses; native.CompilerError without a C compiler.
    """
    option(precision, ("double", "float"), "precision")
    option(on_singular, ON_FAULT, "on_singular")
    need_universal(robot)
    need_motion(robot, motion)
    name = robot_kernel(robot, "exact")
    prepare = function(name, "bounds", precision, "bounds_prepare")
    model = prepared_model(prepare, robot, MODELS[f"{name}_bounds"], precision, takes_rotors(name))
    code = function(name, "bounds", precision, "forces_bounded_batch")
    shapes = {"F": (6,), "bound": (6,), "rcond": ()}
    found = ForceErrorBoundsResult(**results_of(code, model, motion, shapes, apart=True))
    report_faults(found.status, robot, motion, on_singular)
    return found
