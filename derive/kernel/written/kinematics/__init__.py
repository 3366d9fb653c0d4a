"""Kinematics of the legs and the search of a pose, in the part of Python that ``read`` reads."""
