"""Compares with answers of 50 digits, and with what rounding may take away from a sound build."""

import sys

import numpy as np
import stewart_arrays
from robot import robot

TESTS = [
$tests]


def main() -> int:
    """Number of numbers that are farther off than rounding explains."""
    on = stewart_arrays.Arithmetic(np)
    model = stewart_arrays.prepare(on, robot())
    failed = 0
    with np.errstate(all="ignore"):
        for function, fields, F, answers, bounds in TESTS:
            motion = stewart_arrays.motion_of(on, **fields)
            further = [] if F is None else [F]
            found = getattr(stewart_arrays, function)(on, model, motion, *further)
            failed += int(found.status != stewart_arrays.OK)
            for name, answer in answers.items():
                error = np.abs(np.ravel(getattr(found, name)) - answer)
                failed += int(np.sum(~(error <= np.multiply(bounds[name], on.EPSILON))))
        motion = stewart_arrays.motion_of(on, t=[0.0, 0.0, np.nan])
        failed += int(stewart_arrays.$first(on, model, motion$force).status == stewart_arrays.OK)
    print(f"{failed} failed")
    return failed


if __name__ == "__main__":
    sys.exit(min(main(), 1))
