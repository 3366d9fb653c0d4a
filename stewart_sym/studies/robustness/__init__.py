"""Families of poses that approach each degenerate configuration, and what every method makes of them.

Stands on the kernels it measures and on wider arithmetic; decides nothing, ships no number by hand.
"""
