"""Studies: commands that run the kernels for many cases and write tables and plots.

The studies take robots and motions and return records. Only ``common.report`` writes files. Plots require the
extra ``plot``.
"""
