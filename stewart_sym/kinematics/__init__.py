"""Legs from poses and poses from legs, (1)-(9), and the condition number of H."""
