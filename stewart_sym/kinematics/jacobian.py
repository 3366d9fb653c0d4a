"""Jacobian of the robot and its inverse, which relate leg rates and the twist of the platform."""

import numpy as np

from ..io.array_types import Array
from ..motion.motion import Motion
from ..robot.robot import Robot
from .inverse_kinematics import wrench_matrix


def inverse_jacobian(robot: Robot, motion: Motion) -> Array:
    """Compute the inverse Jacobian H^T, which maps the twist of the platform to leg rates.

    Every pose has an inverse Jacobian, including singular poses.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    motion : Motion
        Poses of the platform with any leading shape; rates are ignored.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Inverse Jacobian, L_dot = H^T [v; omega] in the base frame. Row i belongs to leg i; columns 0-2 are
        dimensionless, columns 3-5 are in m.

    Raises
    ------
    ValueError
        If a leg has length zero, if a leg with joint offsets has no solution, or if a result overflows.

    See Also
    --------
    jacobian : Matrix that maps leg rates to the twist.
    wrench_matrix : H, which maps leg forces to the wrench on the platform.

    Notes
    -----
    If the upper parts of the legs turn on screws (``platform_joint = "universal"`` and a drive with a lead),
    H includes the turn of the nuts. H^T [v; omega] are then the motor rates divided by the transmission
    ratio N, not L_dot; ``inverse_kinematics`` returns L_dot.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
    >>> zero = np.zeros(3)
    >>> motion = ss.Motion(R=np.eye(3), t=[0.2, 0.1, 1.0], omega=zero, v=[0.1, 0.0, 0.0])
    >>> twist = np.concatenate([motion.v, motion.omega])
    >>> rates = ss.inverse_jacobian(robot, motion) @ twist
    >>> np.allclose(rates, ss.inverse_kinematics(robot, motion).L_dot)
    True
    """
    return np.swapaxes(wrench_matrix(robot, motion), -1, -2)


def jacobian(robot: Robot, motion: Motion) -> Array:
    """Compute the Jacobian H^-T, which maps leg rates to the twist of the platform.

    Parameters
    ----------
    robot : Robot
        Robot geometry.
    motion : Motion
        Poses of the platform with any leading shape; rates are ignored.

    Returns
    -------
    ndarray, shape (..., 6, 6)
        Jacobian, [v; omega] = H^-T L_dot in the base frame. Column i belongs to leg i; rows 0-2 are
        dimensionless, rows 3-5 are in 1/m.

    Raises
    ------
    ValueError
        If a pose is singular, if a leg has length zero, if a leg with joint offsets has no solution, or if a
        result overflows.

    See Also
    --------
    inverse_jacobian : Matrix that maps the twist to leg rates.
    forward_velocity : Compute the twist from measured leg rates.

    Notes
    -----
    If the upper parts of the legs turn on screws (``platform_joint = "universal"`` and a drive with a lead),
    H includes the turn of the nuts. H^T [v; omega] are then the motor rates divided by the transmission
    ratio N, not L_dot; ``forward_velocity`` computes the twist from L_dot.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> robot = ss.robots.load("dasgupta1998")
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
