"""Fields of a motion."""

FIELDS = ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")
