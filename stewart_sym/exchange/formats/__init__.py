"""Formats of other programs, written from or read into a model of bodies and joints."""
