"""Kernels as files of C and NumPy: where numbers are, what stands in lanes, what a header says."""
