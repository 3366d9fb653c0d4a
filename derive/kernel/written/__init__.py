"""Written functions: the code of the kernels around their blocks, in the subset of Python of ``tree.read``.

Branches depend on numbers only by ``anywhere``, so that one text computes one pose or many poses side by
side. An error is a status that is passed on, and the exchange of rows is a selection. Names in capitals are
placeholders for the statements and constants of blocks.
"""
