"""Motions of the platform: rotations, paths, logs and what smooths them."""
