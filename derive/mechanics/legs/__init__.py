"""Equations of motion of one leg, printed and corrected, in each set of coordinates that kernels use."""
