"""The derivation: from the paper's equations to the files of ``generated/``. SymPy only, no runtime.

In the order of the flow; each folder imports only those before it:

    program     blocks, straight-line programs with named steps, and what rewrites them
    mechanics   the paper's equations as blocks: legs, platform, forces, closed form, regressor, reductions
    kernel      whole functions as trees: blocks, and the loops, checks and solves around them
    print       trees as C, Python, MATLAB and Rust
    emit        files of ``generated/``
    package     what surrounds kernels in a kit for one robot, from files of ``templates``

``generate`` writes all of it; ``passes`` shows what each reduction is worth. ``derivation.ipynb`` reads
this beside the paper.
"""

import os

# SymPy reads this when it is imported first. By itself it keeps a thousand results, and the derivation needs
# most of them again once they are gone: a fifth of its time.
os.environ.setdefault("SYMPY_CACHE_SIZE", "20000")
