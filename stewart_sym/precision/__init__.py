"""Actuator forces with 113 bits and with 50 digits, as references for rounding errors."""
