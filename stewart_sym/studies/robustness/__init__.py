"""Families of poses that approach each degenerate configuration, and what every method makes of them."""
