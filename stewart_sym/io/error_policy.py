"""Locations of errors, errors for optional packages, and warnings at the line of the user."""

import contextlib
import importlib.util
import inspect
import warnings
from collections.abc import Iterator

EXTRAS = {
    "casadi": ("CasADi", "casadi"),
    "distributed": ("Dask", "cluster"),
    "matplotlib": ("Matplotlib", "plot"),
    "mujoco": ("MuJoCo", "exchange"),
    "textalloc": ("textalloc", "plot"),
}
"""Name and extra of each optional package by its import name."""


@contextlib.contextmanager
def errors_of(where: str) -> Iterator[None]:
    """Prefix a ValueError of the block with its location, such as ``file: key: ``."""
    try:
        yield
    except ValueError as error:
        raise ValueError(f"{where}{error}") from None


def warn(text: str, category: type[Warning] = UserWarning) -> None:
    """Warn at the line outside this package that called it, at any depth of the call stack."""
    frame, level, package = inspect.currentframe(), 0, __name__.partition(".")[0]
    while frame is not None and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, level = frame.f_back, level + 1
    warnings.warn(text, category, stacklevel=level + 1)


def need(package: str, what: str, otherwise: str = "") -> None:
    """Raise ImportError if a package of the task ``what`` is missing; ``otherwise`` is an alternative."""
    if importlib.util.find_spec(package) is None:
        name, extra = EXTRAS[package]
        raise ImportError(f'{what} needs {name}: pip install "stewart-sym[{extra}]"{otherwise}')
