"""Operations of the kernels of the closed form for one pose, without linear solvers.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD
"""

OPERATIONS: dict[str, int] = {
    "equations": 4760,
    "bias": 2163,
    "forward_dynamics": 3081,
    "derivatives": 10910,
    "joint_rows": 2508,
    "joint_slopes": 14237,
}
