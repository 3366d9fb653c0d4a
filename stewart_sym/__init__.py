"""Kinematics, dynamics, design, and simulation of Gough-Stewart platforms (6-UPS and 6-SPS).

The equations are derived with SymPy and generated as C99 and NumPy code. All quantities have SI units, and
motions may have any leading shape.

Examples
--------
Load a robot, describe its motion, and compute the actuator forces (N):

>>> import stewart_sym as ss
>>> robot = ss.robots.load("unal")
>>> motion = ss.Motion.from_rpy(
...     t=[0.0, 0.0, 0.7],  # position (m), base frame
...     theta=[0.1, 0.0, 0.0],  # roll, pitch, and yaw (rad)
...     v=[0.0, 0.0, 0.2],
...     theta_dot=[0.0, 0.0, 0.0],
...     a=[0.0, 0.0, 1.0],
...     theta_ddot=[0.0, 0.0, 0.0],
... )
>>> ss.inverse_dynamics(robot, motion).F.round(2).tolist()
[7.11, 5.06, 7.37, 7.37, 5.06, 7.11]

For your own machine, load a robot file with ``ss.Robot.from_toml("robot.toml")``.
"""

import os
from typing import Any

import lazy_loader

# In a clone, whose package precedes an installed one if Python starts there, the folders ``generated``
# and ``derive`` are next to it.
if not os.path.isdir(os.path.join(__path__[0], "generated")):
    __path__.append(os.path.dirname(os.path.abspath(__path__[0])))

# Each name is imported when it is first used, from the module that the stub names.
_imported, _, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("stewart-sym")
    return _imported(name)


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
