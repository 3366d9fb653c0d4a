"""Entry point of ``stewart-sym`` and of ``python -m stewart_sym``; signals remove unfinished files."""

import os
import sys


def main() -> int:
    """Run the command line of this process and return the exit code, 128 + n after signal n."""
    # Set before NumPy is imported: for small matrices, threads of OpenBLAS cost more time than they save.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        import signal

        for name in ("SIGTERM", "SIGHUP"):
            number = getattr(signal, name, None)
            if number is not None and signal.getsignal(number) == signal.SIG_DFL:
                signal.signal(number, _end)
        from .cli.main import main as run

        return run()
    except KeyboardInterrupt:
        return 130
    except (ImportError, MemoryError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        print(f"stewart-sym: error: cannot start: {reason}", file=sys.stderr)
        return 2


def _end(number: int, frame: object) -> None:
    raise SystemExit(128 + number)


if __name__ == "__main__":
    sys.exit(main())
