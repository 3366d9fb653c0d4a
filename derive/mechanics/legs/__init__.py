"""One leg: its equations as printed and as they should be, in each of the coordinates that kernels use."""
