"""Times of the kernels and of the baselines, alternating, as medians."""
