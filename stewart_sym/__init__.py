"""Dynamics of the Stewart platform: derived by SymPy, emitted as C and NumPy, checked.

import stewart_sym as ss
robot = ss.Robot.from_toml("hexapod.toml")
motion = ss.Motion.from_rpy(t=t, theta=theta, v=v, theta_dot=theta_dot, a=a, theta_ddot=theta_ddot)
forces = ss.inverse_dynamics(robot, motion).F
"""

import ast as _ast
import importlib as _importlib
from importlib.resources import files as _files

_STUB = _ast.parse((_files(__name__) / "__init__.pyi").read_text(encoding="utf-8"))
_MODULES = {
    alias.name: f".{node.module or alias.name}"
    for node in _STUB.body
    if isinstance(node, _ast.ImportFrom)
    for alias in node.names
}
"""Module that defines each public name, or is it; imported when the name is first used."""

__all__ = sorted(_MODULES)


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version

        found: object = version("stewart-sym")
    elif name in _MODULES:
        module = _importlib.import_module(_MODULES[name], __name__)
        found = module if _MODULES[name] == f".{name}" else getattr(module, name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found
