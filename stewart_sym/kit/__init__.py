"""The C kit of one robot: a folder that builds, explains itself, and tests itself on its target.

Takes a checked Robot and a ``Choice``; gathers kernels (``parts``), test vectors (``vectors``) and the
texts of ``derive.package``, and has the files put in place all at once or not at all.
"""

from .files import Kit, kit, kit_names
from .kit_options import FUNCTIONS, Choice
from .write import put, write_kit

__all__ = ["FUNCTIONS", "Choice", "Kit", "kit", "kit_names", "put", "write_kit"]
