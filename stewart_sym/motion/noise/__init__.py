"""Noise beside a log's motion: how large it is stated or shown, rows that have none, lines in it."""
