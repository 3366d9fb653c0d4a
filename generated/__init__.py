"""Kernels that ``stewart_sym.derive`` wrote: C below ``c/``, NumPy beside this file.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""
