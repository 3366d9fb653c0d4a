"""Operations of the kernels of the closed form for one pose, without linear solvers.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD
"""

OPERATIONS: dict[str, int] = {
    "forces": 2890,
}
