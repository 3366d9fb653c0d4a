"""Dynamics of the Stewart platform: derived by SymPy, emitted as C and NumPy, checked.

import stewart_sym as ss
robot = ss.Robot.from_toml("hexapod.toml")
motion = ss.Motion.from_rpy(t=t, theta=theta, v=v, theta_dot=theta_dot, a=a, theta_ddot=theta_ddot)
forces = ss.inverse_dynamics(robot, motion).F
"""

import os
from _thread import RLock

# Nothing is imported before a name is used: the command line is soon where an interrupt ends it cleanly.
_modules: dict[str, str] = {}
# A child forked while a thread imports would wait for ever for that thread's locks: the fork waits instead.
_importing = RLock()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        before=_importing.acquire, after_in_parent=_importing.release, after_in_child=_importing.release
    )


def _public() -> dict[str, str]:
    """Module that defines each public name, or is it; read from the stub when first used."""
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
    _modules.update(found)  # at once, as other threads may look
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
        # Their own handlers of forks must not be registered between the two parts of one.
        import concurrent.futures.thread  # noqa: F401
        import logging  # noqa: F401

        module = import_module(_public()[name], __name__)
        found = module if _public()[name] == f".{name}" else getattr(module, name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = found
    return found
