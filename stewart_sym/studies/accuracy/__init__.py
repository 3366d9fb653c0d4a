"""Cost and accuracy of every kernel for the motions of a machine."""
