"""Actuator forces with bounds of their rounding errors, and the reciprocal condition number of each pose.

The C code of ``stewart_exact_bounds.h`` computes the bounds; this module prepares its arrays.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..calls.c_kernel import CKernel, prepared
from ..io.arguments import option
from ..motion.motion import Motion
from ..results import ON_FAULT, OnFault
from ..robot.robot import Robot
from .forces import Precision
from .inverse_dynamics import need_motion, need_universal, report_faults

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class ForceErrorBoundsResult:
    """Actuator forces with bounds of their rounding errors.

    ``(...)`` is the shape of the motion. Numbers have the type of the precision and are NaN if the status is
    not 0.

    Attributes
    ----------
    F : ndarray, shape (..., 6)
        Actuator forces (N), positive when they extend the leg, (37).
    bound : ndarray, shape (..., 6)
        Bounds (N) of the differences between F and the exact forces for the same inputs. Infinite if H is so
        nearly singular that this precision gives no bound.
    rcond : ndarray, shape (...)
        Reciprocal condition number of H in the maximum column sum norm, at most 1. Moments are about the
        reference point and divided by the characteristic length.
    status : ndarray of int, shape (...)
        Status of each pose: 0 if it was solved, otherwise a code of ``STATUS_TEXT``.
    """

    F: Array
    bound: Array
    rcond: Array
    status: NDArray[np.int32]


def force_error_bounds(
    robot: Robot, motion: Motion, precision: Precision = "double", on_singular: OnFault = "raise"
) -> ForceErrorBoundsResult:
    """Compute actuator forces with a rigorous bound of the rounding error of each force.

    Parameters
    ----------
    robot : Robot
        Robot model with universal base joints without offsets.
    motion : Motion, shape (...)
        Poses, velocities, and accelerations of the platform, with an external wrench if there is one.
    precision : {"double", "float"}, optional
        Type of the numbers in C.
    on_singular : {"raise", "warn", "nan"}, optional
        Treatment of poses without a solution. "raise" raises a ``ValueError``, "warn" issues a
        ``SingularPoseWarning`` and returns NaN, and "nan" returns NaN without a warning.

    Returns
    -------
    ForceErrorBoundsResult
        Forces ``F`` (N) and bounds ``bound`` (N), shape (..., 6); reciprocal condition numbers ``rcond`` and
        ``status``, shape (...).

    Raises
    ------
    ValueError
        If an option is unknown, the robot has spherical or offset base joints, or the precision cannot
        represent its constants. Also if the motion has no accelerations, or if a pose has no solution and
        ``on_singular`` is "raise".
    CompilerError
        If there is no working C compiler.

    See Also
    --------
    inverse_dynamics : Compute the forces without bounds.
    force_std : Compute the effect of measurement noise.

    Notes
    -----
    The bounds are rigorous except for overflow and underflow. They count the rounding of every operation,
    weighted by the derivative of the force with respect to its result. This is running error analysis
    (Higham, Accuracy and Stability of Numerical Algorithms, 3.3). The solution of H x = c is enclosed as in
    Rump, Acta Numerica 19 (2010), 10. Inputs count as exact after they are rounded to the precision, except
    that R denotes the rotation nearest to it. The kernel is the formulation "exact".

    Examples
    --------
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> motion = ss.PAPER_PATHS["I"].path.sample(1.0)
    >>> result = ss.force_error_bounds(robot, motion)
    >>> bool((result.bound < 1e-10).all())
    True
    >>> round(float(result.rcond), 3)
    0.024
    """
    option(precision, ("double", "float"), "precision")
    option(on_singular, ON_FAULT, "on_singular")
    need_universal(robot)
    need_motion(robot, motion)
    kernel = prepared(CKernel, robot, "exact", "_bounds", precision)
    found = ForceErrorBoundsResult(**kernel.run("forces_bounded", motion))
    report_faults(found.status, robot, motion, on_singular)
    return found
