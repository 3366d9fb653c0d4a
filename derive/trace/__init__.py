"""Traces of kernels, which are ordinary Python functions, and their schedules as functions of a tree."""
