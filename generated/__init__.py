"""Kernels written by ``stewart_sym.derive``: C in ``c/``, NumPy in this folder.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""
