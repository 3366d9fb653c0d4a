"""Optional packages, with one-line errors that name the extra to install."""

import contextlib
import importlib.util
import json
from collections.abc import Iterator
from importlib.metadata import distributions
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from .blas import take_work_area

EXTRAS = {
    "casadi": ("CasADi", "casadi"),
    "dask": ("Dask", "cluster"),
    "distributed": ("Dask", "cluster"),
    "jax": ("JAX", "bench"),
    "matplotlib": ("Matplotlib", "plot"),
    "mpl_toolkits": ("Matplotlib", "plot"),
    "mujoco": ("MuJoCo", "bench"),
    "pinocchio": ("Pinocchio", "bench"),
    "pydrake": ("Drake", "bench"),
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
    """Import optional packages in this block.

    Parameters
    ----------
    what : str
        Task that requires the packages, as subject of the message.
    otherwise : str
        Alternative without the packages, such as an option, as end of the message.

    Raises
    ------
    MissingExtraError
        If a package is missing: ``<what> needs <package>: pip install "stewart-sym[<extra>]"``, with the
        command of ``install``.
    MemoryError
        If there is no memory for the work area of SciPy.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        if package not in EXTRAS:
            raise
        raise _missing(package, what, otherwise) from None
    take_work_area()


def install(extra: str) -> str:
    """Return the command that adds an extra to this installation, which may be from a source tree or a
    URL.
    """
    name = "stewart-sym"
    texts = (found.read_text("direct_url.json") for found in distributions(name=name))
    source = json.loads(next(filter(None, texts), "{}"))
    url = source.get("url", "")
    tree = Path(url2pathname(urlsplit(url).path))
    if "dir_info" in source and tree.is_dir():
        editable = "-e " if source["dir_info"].get("editable") else ""
        return f'pip install {editable}"{tree}[{extra}]"'
    if "vcs_info" in source:
        vcs = source["vcs_info"]
        return f'pip install "{name}[{extra}] @ {vcs["vcs"]}+{url}@{vcs["commit_id"]}"'
    return f'pip install "{name}[{extra}]{f" @ {url}" if "archive_info" in source else ""}"'


def _missing(package: str, what: str, otherwise: str) -> MissingExtraError:
    name, extra = EXTRAS[package]
    return MissingExtraError(f"{what} needs {name}: {install(extra)}{otherwise}")
