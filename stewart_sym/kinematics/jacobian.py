"""Jacobian of the machine and its inverse, between leg rates and the twist of the platform."""

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot
from .inverse_kinematics import wrench_matrix


def inverse_jacobian(robot: Robot, motion: Motion) -> Array:
    """Return the inverse Jacobian H^T, which turns the platform's twist into leg rates.

    L_dot = H^T [v; omega]. Every pose has an inverse Jacobian, a singular one too.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses, any leading shape; rates are not read.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Rows are legs: three columns without a unit, then three in m.

    Raises
    ------
    ValueError
        As ``inverse_kinematics``.

    See Also
    --------
    jacobian : From leg rates to the twist.
    wrench_matrix : H, from leg forces to the wrench on the platform.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.dasgupta1998()
    >>> zero = np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[0.2, 0.1, 1.0], omega=zero, v=[0.1, 0.0, 0.0])
    >>> twist = np.concatenate([motion.v, motion.omega])
    >>> rates = ss.inverse_jacobian(robot, motion) @ twist
    >>> np.allclose(rates, ss.inverse_kinematics(robot, motion).L_dot)
    True
    """
    return np.swapaxes(wrench_matrix(robot, motion), -1, -2)


def jacobian(robot: Robot, motion: Motion) -> Array:
    """Return the Jacobian H^-T, which turns leg rates into the platform's twist.

    [v; omega] = H^-T L_dot.

    Parameters
    ----------
    robot : Robot
        The machine.
    motion : Motion
        Poses, any leading shape; rates are not read.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Columns are legs: three rows without a unit, then three in 1/m.

    Raises
    ------
    ValueError
        As ``inverse_kinematics``, and for a singular pose.

    See Also
    --------
    inverse_jacobian : From the twist to leg rates.
    forward_velocity : Twist of measured leg rates.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.dasgupta1998()
    >>> zero = np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[0.2, 0.1, 1.0], omega=zero, v=zero)
    >>> np.allclose(ss.jacobian(robot, motion) @ ss.inverse_jacobian(robot, motion), np.eye(6))
    True
    """
    try:
        found = np.linalg.inv(inverse_jacobian(robot, motion))
    except np.linalg.LinAlgError:
        found = np.array(np.nan)
    if not np.isfinite(found).all():
        raise ValueError("motion: the Jacobian of a singular pose is not defined; expected regular poses")
    return np.asarray(found)
