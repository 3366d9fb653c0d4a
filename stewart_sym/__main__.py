"""Entry point of ``stewart-sym`` and of ``python -m stewart_sym``; Ctrl-C during imports exits with 130."""

import os
import sys


def main() -> int:
    """Run the command line of this process and return the exit code, 130 after an interrupt."""
    # Set before NumPy is imported: for small matrices, threads of OpenBLAS cost more time than they save.
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
