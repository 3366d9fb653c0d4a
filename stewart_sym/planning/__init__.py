"""Paths between via poses, how fast a machine may move along them, and proof that no limit is exceeded."""
