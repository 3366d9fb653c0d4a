"""Singular poses: at one pose, along a path, and for motions from leg lengths."""
