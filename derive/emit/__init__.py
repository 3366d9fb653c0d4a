"""Files of ``generated/`` from kernel trees: C sources and headers, and NumPy modules."""
