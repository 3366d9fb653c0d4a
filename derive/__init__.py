"""Derivation of all kernels from the equations of the paper, with SymPy.

The forces and kinematics of ``stewart_sym`` do not import it; kits and formulas do. In the order of the data
flow, each folder imports only the folders before it:

    program     blocks: straight-line programs with named steps, and their transformations
    mechanics   equations of the paper as blocks: legs, platform, forces, closed form, regressor, reductions
    trace       traces of kernels and their schedules; trees of functions
    kernels     actuator forces as an ordinary Python function that is traced
    kernel      complete functions as trees: blocks with loops, checks, and linear solves
    print       trees as C, Python, MATLAB, and Rust
    emit        files of ``generated/``
    package     other files of a kit for one robot, from ``templates``

``generate`` writes all files. ``passes`` measures the effect of each reduction. ``derivation.ipynb`` compares
the code with the paper.
"""

import os

# SymPy reads this variable at its first import. Its default cache of 1000 results is too small: recomputing
# results that were dropped takes a fifth of the time of the derivation.
os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
