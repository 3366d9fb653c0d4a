"""How far the slow sweeps go: a fifth of their size or less by themselves, all of it with STEWART_FULL=1.

Stands below all test modules.
"""

import os

FULL = os.environ.get("STEWART_FULL") == "1"


def share(count: int, part: int = 5) -> int:
    """How many of ``count`` cases are run: all of them, or one in ``part``."""
    return count if FULL else count // part
