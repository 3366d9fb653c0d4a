"""Smooth motions along a path: with jerk limits, or with least energy or peak force in a given duration."""
