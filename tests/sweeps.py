"""How far the slow sweeps go: a fifth of their size by themselves, all of it with STEWART_FULL=1.

Stands below all test modules.
"""

import os

FULL = os.environ.get("STEWART_FULL") == "1"


def share(count: int) -> int:
    """How many of ``count`` cases are run."""
    return count if FULL else count // 5
