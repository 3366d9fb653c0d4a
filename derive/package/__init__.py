"""Files of a kit other than the kernels: ``templates``, filled with names, numbers, and tables."""
