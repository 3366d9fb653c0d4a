"""Printers: blocks as text in C and Python. They hold text and layout, no dynamics."""
