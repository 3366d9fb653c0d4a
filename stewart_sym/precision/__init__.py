"""Actuator forces with 50 digits, as a reference for rounding errors."""
