"""Families of poses that approach each degenerate configuration, and the results of every method for them."""
