"""Kernels as trees: complete functions with blocks, loops, checks, and the linear solve, in no language."""
