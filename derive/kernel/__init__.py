"""Kernels as trees: whole functions made of blocks, loops, checks and a solve, in no language."""
