"""Kernels as ordinary Python functions over values that may have one number for each leg."""
