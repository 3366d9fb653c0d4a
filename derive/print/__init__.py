"""Printers: one module for each language that a kernel tree can be spelled in. They decide nothing."""
