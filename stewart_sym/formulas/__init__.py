"""Equations of one robot as SymPy expressions, LaTeX, and CasADi functions."""
