"""Robots that are included in the package: a robot file for each, and functions that load them."""

from importlib import resources

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import option, real_array
from ..motion.motion import Motion
from ..robot.robot import Robot

NAMES = (
    "dasgupta1998",
    "tsai2000",
    "mathworks2002",
    "unal",
    "dehaeze_nano",
    "rubin_camera",
    "rubin_m2",
)
"""Names of all robots, for ``load``."""

TSAI_MOTIONS = (1, 2, 3, 4)
"""Numbers of the motions of ``tsai2000_motion``."""
_TSAI_RATE = 3.0


def load(name: str) -> Robot:
    """Load a robot that is included in the package.

    Parameters
    ----------
    name : str
        One of ``NAMES``.

    Returns
    -------
    Robot
        Checked robot.

    Raises
    ------
    ValueError
        If there is no robot of this name.

    See Also
    --------
    text : Return the robot file.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> ss.robots.load("unal").name
    'UNAL hexapod'
    """
    option(name, NAMES, "name")
    with resources.as_file(resources.files(__name__) / f"{name}.toml") as path:
        return Robot.from_toml(path)


def text(name: str) -> str:
    """Return the text of a robot file that is included in the package.

    The comments in the file cite its source and mark assumptions.

    Parameters
    ----------
    name : str
        One of ``NAMES``.

    Returns
    -------
    str
        Text of the file.

    Raises
    ------
    ValueError
        If there is no robot of this name.

    See Also
    --------
    load : Load the robot.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> "schema = 2" in ss.robots.text("unal")
    True
    """
    option(name, NAMES, "name")
    return (resources.files(__name__) / f"{name}.toml").read_text(encoding="utf-8")


def dasgupta1998() -> Robot:
    """Load the test manipulator of the paper (appendix), as printed.

    No rigid body can have its three printed inertia tensors. The file suppresses the warnings;
    ``find_invalid_inertias()`` lists the tensors.
    """
    return load("dasgupta1998")


def tsai2000() -> Robot:
    """Load the benchmark of Tsai (J. Mech. Des. 122, 2000) with spherical joints at both ends of the legs."""
    return load("tsai2000")


def mathworks2002() -> Robot:
    """Load the steel platform of the MathWorks SimMechanics example of 2002."""
    return load("mathworks2002")


def unal() -> Robot:
    """Load the hexapod of Universidad Nacional de Colombia, which has public logs of motor currents."""
    return load("unal")


def dehaeze_nano() -> Robot:
    """Load the geometry and bodies of the nano-hexapod by Dehaeze, without its stiffness."""
    return load("dehaeze_nano")


def rubin_camera() -> Robot:
    """Load the geometry of the camera hexapod of the Rubin Observatory, with assumed masses."""
    return load("rubin_camera")


def rubin_m2() -> Robot:
    """Load the geometry of the M2 hexapod of the Rubin Observatory, with assumed masses.

    Three struts are along z and three along tangents.
    """
    return load("rubin_m2")


def tsai2000_motion(number: int, time: ArrayLike) -> Motion:
    """Return one of the four motions of Tsai at given times, with velocities and accelerations.

    All motions are about the home pose, with w = 3 rad/s:

    1. 0.2 sin wt (m) in x, y, and z
    2. pi/6 sin wt (rad) about z
    3. 0.2 sin wt (m) in x
    4. at rest

    Parameters
    ----------
    number : {1, 2, 3, 4}
        Number of the motion.
    time : array_like, any shape
        Times (s).

    Returns
    -------
    Motion
        Motion with the shape of ``time``.

    Raises
    ------
    ValueError
        If ``number`` is not 1, 2, 3, or 4.

    See Also
    --------
    tsai2000 : Load the robot of these motions.

    Examples
    --------
    >>> import stewart_sym as ss
    >>> ss.robots.tsai2000_motion(3, time=[0.0, 0.5]).t.round(3).tolist()
    [[-1.5, 0.0, 1.0], [-1.301, 0.0, 1.0]]
    """
    if number not in TSAI_MOTIONS:
        raise ValueError(f"number: expected 1, 2, 3 or 4, got {number!r}")
    phase = _TSAI_RATE * real_array(time, "time")
    wave = np.stack([np.sin(phase), _TSAI_RATE * np.cos(phase), -(_TSAI_RATE**2) * np.sin(phase)])
    shift = {1: (0.2, 0.2, 0.2), 3: (0.2, 0.0, 0.0)}.get(number, (0.0, 0.0, 0.0))
    turn = (0.0, 0.0, np.pi / 6.0 if number == 2 else 0.0)
    t, v, a = wave[..., None] * np.array(shift)
    theta, theta_dot, theta_ddot = wave[..., None] * np.array(turn)
    return Motion.from_rpy(np.array([-1.5, 0.0, 1.0]) + t, theta, v, theta_dot, a, theta_ddot)
