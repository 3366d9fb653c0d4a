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
from _thread import RLock

# In a clone, whose package precedes an installed one if Python starts there, the folders ``generated``
# and ``derive`` are next to it.
if not os.path.isdir(os.path.join(__path__[0], "generated")):
    __path__.append(os.path.dirname(os.path.abspath(__path__[0])))

# Modules are imported when a name is first used, so that the command line soon handles interrupts cleanly.
_modules: dict[str, str] = {}
# A fork waits for imports, because its child would wait forever for the locks of an importing thread.
_importing = RLock()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_importing.acquire, after_in_parent=_importing.release, after_in_child=_importing.release
    )


def _public() -> dict[str, str]:
    """Return the defining module of each public name; read the stub once."""
    if _modules:
        return _modules
    import ast
    from importlib.resources import files

    stub = ast.parse((files(__name__) / "__init__.pyi").read_text(encoding="utf-8"))
    found = {
        alias.name: f".{node.module or alias.name}"
        for node in stub.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    _modules.update(found)  # one update, because other threads may read it
    return _modules


def __dir__() -> list[str]:
    return sorted([*_public(), "__version__"])


def __getattr__(name: str) -> object:
    with _importing:
        return _found(name)


def _found(name: str) -> object:
    from importlib import import_module
    from importlib.metadata import version

    if name == "__version__":
        found: object = version("stewart-sym")
    elif name == "__all__":
        found = sorted(_public())
    elif not name.startswith("__") and name in _public():
        # These modules register handlers of forks, which the lock prevents in the middle of a fork.
        import concurrent.futures.thread  # noqa: F401
        import logging  # noqa: F401

        module = import_module(_public()[name], __name__)
        found = module if _public()[name] == f".{name}" else getattr(module, name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found
