"""Layout of the C that bounds the rounding error of the forces, formulation and joint `exact`.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD
"""

# Numbers of ``stewart_exact_bounds_model``.
MODEL_NUMBERS = 384
