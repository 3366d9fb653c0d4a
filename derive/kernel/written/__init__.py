"""What kernels do around their blocks, in the part of Python that ``read`` turns into trees.

No branch depends on a number but through ``anywhere``, so that one text serves one pose, and many side by
side: a fault is a status that is carried on, a row exchange a selection.
"""
