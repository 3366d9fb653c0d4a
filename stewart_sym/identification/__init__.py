"""Inertial parameters from measured forces: base parameters, excitation, estimates."""
