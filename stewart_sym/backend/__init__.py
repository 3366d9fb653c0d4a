"""Kernels as they run: compiled C through ctypes, NumPy, and which fidelities there are."""
