"""C kit of one robot: a folder of generated code with build files, documentation, and a self-test.

The package takes a validated Robot and a ``Choice``, collects kernels (``parts``), test vectors
(``vectors``), and the texts of ``derive.package``, and writes the files one by one.
"""

from .files import Kit, kit, kit_names
from .kit_options import FUNCTIONS, Choice
from .write import put, write_kit

__all__ = ["FUNCTIONS", "Choice", "Kit", "kit", "kit_names", "put", "write_kit"]
