"""Whether a robot file describes a machine that can exist."""
