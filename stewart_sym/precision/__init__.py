"""Actuator forces at 113 bits and at 50 digits: the truth for rounding errors."""
