"""Kinematics of the legs, and the search for a pose, as written functions."""
