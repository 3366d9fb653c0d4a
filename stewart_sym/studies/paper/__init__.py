"""Reproduction of section 5 of the paper."""
