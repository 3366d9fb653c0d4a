"""Folder of derived kernels and compiled libraries, shared by all processes of a user."""

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path


def cache_folder() -> Path:
    """Return ``$STEWART_SYM_CACHE``, by default the cache folder of the user."""
    import platformdirs

    own = os.environ.get("STEWART_SYM_CACHE")
    return Path(own or platformdirs.user_cache_dir("stewart-sym", appauthor=False)).absolute()


@contextlib.contextmanager
def locked(lock: Path) -> Iterator[None]:
    """Hold a lock file, which makes other processes and threads wait; OSError if it cannot be written."""
    lock.parent.mkdir(parents=True, exist_ok=True)
    with lock.open("w") as stream:
        # On Windows, two processes may create the same file.
        if sys.platform != "win32":
            import fcntl

            fcntl.flock(stream, fcntl.LOCK_EX)
        yield
