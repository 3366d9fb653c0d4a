"""Blocks, which are straight-line programs with named steps, and their transformations; no mechanics."""
