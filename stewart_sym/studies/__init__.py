"""Studies: commands that run the kernels over many cases and write tables and pictures.

They take robots and motions and return records; ``common.report`` alone writes files, and what draws needs
the extra ``plot``.
"""
