"""Formats of other programs: each is written from, or read as, a model of bodies and joints."""
