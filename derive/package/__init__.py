"""What surrounds kernels in a kit: files of ``templates``, filled with names, numbers and tables."""
