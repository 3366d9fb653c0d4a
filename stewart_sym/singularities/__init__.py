"""Singular poses: at a pose, along a path, and motions from leg lengths that avoid them."""
