"""Robots that come with the package; each is a robot file in this folder and a function that loads it."""

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
"""Of all robots, as ``load`` takes them."""

TSAI_MOTIONS = (1, 2, 3, 4)
_TSAI_RATE = 3.0


def load(name: str) -> Robot:
    """Load the robot of a name of ``NAMES``; ValueError for another."""
    option(name, NAMES, "name")
    with resources.as_file(resources.files(__name__) / f"{name}.toml") as path:
        return Robot.from_toml(path)


def text(name: str) -> str:
    """Text of the robot file of a name of ``NAMES``: it cites its source and says what is assumed."""
    option(name, NAMES, "name")
    return (resources.files(__name__) / f"{name}.toml").read_text(encoding="utf-8")


def dasgupta1998() -> Robot:
    """Load the paper's test manipulator (appendix), as printed.

    None of its three printed inertia tensors belongs to a rigid body; the file accepts that, so there is no
    warning; ``physicality()`` lists them.
    """
    return load("dasgupta1998")


def tsai2000() -> Robot:
    """Load the benchmark of Tsai (J. Mech. Des. 122, 2000): spherical joints at both ends of the legs."""
    return load("tsai2000")


def mathworks2002() -> Robot:
    """Load the steel platform of MathWorks' SimMechanics example of 2002."""
    return load("mathworks2002")


def unal() -> Robot:
    """Load the hexapod of Universidad Nacional de Colombia, which has public logs of motor currents."""
    return load("unal")


def dehaeze_nano() -> Robot:
    """Load the geometry and bodies of Dehaeze's nano-hexapod; stiffness is left out."""
    return load("dehaeze_nano")


def rubin_camera() -> Robot:
    """Load the geometry of the Rubin Observatory's camera hexapod; its masses are assumed."""
    return load("rubin_camera")


def rubin_m2() -> Robot:
    """Load the geometry of the Rubin Observatory's M2 hexapod, three struts along z, three along tangents.

    Its masses are assumed.
    """
    return load("rubin_m2")


def tsai2000_motion(number: int, time: ArrayLike) -> Motion:
    """Return one of Tsai's four motions at times, with rates and accelerations.

    1: 0.2 sin wt in x, y and z; 2: pi/6 sin wt about z; 3: 0.2 sin wt in x; 4: at rest; all about the home
    pose, w = 3 rad/s.

    Parameters
    ----------
    number : int
        1, 2, 3 or 4.
    time : array_like
        s, of any shape.

    Returns
    -------
    Motion
        Of the shape of ``time``.
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
