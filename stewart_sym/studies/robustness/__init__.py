"""The failure atlas: families of poses that walk into each failure, and what every method makes of them.

Stands on the kernels it measures and on wider arithmetic; decides nothing, ships no number by hand.
"""
