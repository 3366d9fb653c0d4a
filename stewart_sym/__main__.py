"""Where ``stewart-sym`` and ``python -m stewart_sym`` begin; Ctrl-C during imports exits with 130."""

import os
import sys


def main() -> int:
    """Run the command line of this process; returns the exit code, 130 where it was interrupted."""
    # Before NumPy is imported: of matrices as small as ours, threads of OpenBLAS wait more than they work.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        from .cli.main import main as run

        return run()
    except KeyboardInterrupt:
        return 130
    except (ImportError, MemoryError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        print(f"stewart-sym: error: cannot start: {reason}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
