"""Kits in Python, MATLAB and Rust, a module each."""

from .language import Language
from .matlab import MatlabKit
from .python import PythonKit
from .rust import RustKit

LANGUAGES: dict[str, Language] = {each.name: each for each in (PythonKit(), MatlabKit(), RustKit())}
"""Languages of kits besides C, by the name that the command line takes."""
