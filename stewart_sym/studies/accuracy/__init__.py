"""Cost and accuracy of every kernel on a machine's motions."""
