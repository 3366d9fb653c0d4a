"""Smooth motions along a path: with a limit of jerk, and those of a given duration that take least energy."""
