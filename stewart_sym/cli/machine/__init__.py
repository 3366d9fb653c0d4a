"""A machine and its motions: what it is, what forces it needs, how it moves."""
