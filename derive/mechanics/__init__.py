"""Mechanics of the paper: its equations as blocks of named steps."""
