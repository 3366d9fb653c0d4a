"""Identification of inertial parameters from measured forces: base parameters, excitation, and estimates."""
