"""Studies: commands that run the kernels over many cases and write tables and pictures."""
