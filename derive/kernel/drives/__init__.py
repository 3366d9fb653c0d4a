"""Torques of the motors."""
