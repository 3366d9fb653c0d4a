"""Kernels as files in C and NumPy: data layout, lanes, and headers."""
