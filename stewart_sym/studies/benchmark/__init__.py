"""Median times of the kernels and of the baselines, measured alternately."""
