"""Optional packages, with one-line errors that name the extra to install."""

import contextlib
import importlib.util
from collections.abc import Iterator

EXTRAS = {
    "casadi": ("CasADi", "casadi"),
    "dask": ("Dask", "cluster"),
    "distributed": ("Dask", "cluster"),
    "matplotlib": ("Matplotlib", "plot"),
    "mujoco": ("MuJoCo", "exchange"),
    "textalloc": ("textalloc", "plot"),
}
"""Name and extra of each optional package by its import name."""


def absent(*packages: str) -> tuple[str, ...]:
    """Return the import names of optional packages that are not installed."""
    return tuple(package for package in packages if importlib.util.find_spec(package) is None)


def install(extra: str) -> str:
    """Return the command that adds an extra to this installation."""
    return f'pip install "stewart-sym[{extra}]"'


def need(package: str, what: str, otherwise: str = "") -> None:
    """Raise ImportError if a package of the task ``what`` is missing; ``otherwise`` is an alternative."""
    if package in EXTRAS and absent(package):
        name, extra = EXTRAS[package]
        raise ImportError(f"{what} needs {name}: {install(extra)}{otherwise}")


@contextlib.contextmanager
def needed_for(what: str, otherwise: str = "") -> Iterator[None]:
    """Import optional packages in this block; a missing one raises the error of ``need``."""
    try:
        yield
    except ModuleNotFoundError as error:
        need((error.name or "").partition(".")[0], what, otherwise)
        raise
