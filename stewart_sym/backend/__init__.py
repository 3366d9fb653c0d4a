"""Execution of the kernels: compiled C through ctypes, NumPy, and the available fidelity levels."""
