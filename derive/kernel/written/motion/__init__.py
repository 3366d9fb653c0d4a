"""Closed form in C as written functions: legs or poses in vector lanes, and results of their sums."""
