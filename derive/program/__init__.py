"""Blocks, straight-line programs with named steps, and what rewrites them; no mechanics."""
