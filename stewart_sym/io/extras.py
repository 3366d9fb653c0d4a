"""Optional packages, with one-line errors that name the extra to install."""

import contextlib
import importlib.util
from collections.abc import Iterator

EXTRAS = {
    "casadi": ("CasADi", "casadi"),
    "dask": ("Dask", "cluster"),
    "distributed": ("Dask", "cluster"),
    "matplotlib": ("Matplotlib", "plot"),
    "mpl_toolkits": ("Matplotlib", "plot"),
    "mujoco": ("MuJoCo", "bench"),
    "pinocchio": ("Pinocchio", "bench"),
    "scipy": ("SciPy", "sim"),
    "textalloc": ("textalloc", "plot"),
}
"""Name and extra of each optional package by its import name."""


class MissingExtraError(ImportError):
    """Error for an optional package that is not installed; the message names its extra."""


def absent(*packages: str) -> tuple[str, ...]:
    """Return the import names of optional packages that are not installed."""
    return tuple(package for package in packages if importlib.util.find_spec(package) is None)


def need(package: str, what: str, otherwise: str = "") -> None:
    """Raise the error of ``needed_for`` before a long computation if a package is not installed."""
    if absent(package):
        raise _missing(package, what, otherwise)


@contextlib.contextmanager
def needed_for(what: str, otherwise: str = "") -> Iterator[None]:
    """Import optional packages in this block; a missing one raises MissingExtraError.

    ``what`` is the task that requires the packages, and ``otherwise`` an alternative without them, for the
    message ``<what> needs <package>: pip install "stewart-sym[<extra>]"<otherwise>``.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        if package not in EXTRAS:
            raise
        raise _missing(package, what, otherwise) from None


def install(extra: str) -> str:
    """Return the command that adds an extra to this installation."""
    return f'pip install "stewart-sym[{extra}]"'


def _missing(package: str, what: str, otherwise: str) -> MissingExtraError:
    name, extra = EXTRAS[package]
    return MissingExtraError(f"{what} needs {name}: {install(extra)}{otherwise}")
