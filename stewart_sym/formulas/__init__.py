"""The equations of one machine as SymPy expressions, LaTeX and CasADi functions."""
