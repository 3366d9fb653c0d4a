"""Optional packages: what is missing is one line that names the extra to install."""

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
"""Name and extra of each optional package, by the name it is imported by."""


class MissingExtraError(ImportError):
    """An optional package that is not installed; the message names the extra that brings it."""


def absent(*packages: str) -> tuple[str, ...]:
    """Those of the optional packages, by the names they are imported by, that are not installed."""
    return tuple(package for package in packages if importlib.util.find_spec(package) is None)


def need(package: str, what: str, otherwise: str = "") -> None:
    """Raise the error of ``needed_for`` at once where a package is not installed: before long work."""
    if absent(package):
        raise _missing(package, what, otherwise)


@contextlib.contextmanager
def needed_for(what: str, otherwise: str = "") -> Iterator[None]:
    """Import optional packages in this block.

    what: the work that needs them, as the subject of the message. otherwise: what helps without them, such as
    an option, at its end. Raises MissingExtraError in one line: ``<what> needs <package>: pip install
    "stewart-sym[<extra>]"``, as ``install`` has it; MemoryError without room for SciPy's work area.
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
    """Command that adds an extra to this installation: of a source tree, where it was installed from one."""
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
