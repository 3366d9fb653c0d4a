"""One BLAS thread in each process of the tests: xdist runs one for each core, more would only wait."""

import os

for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")
