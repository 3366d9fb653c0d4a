"""Calls of the kernels: arrays of poses as input, arrays of results and statuses as output."""
