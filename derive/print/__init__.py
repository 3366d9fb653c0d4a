"""Printers: one module for each language of a kernel tree. They make no decisions about the program."""
