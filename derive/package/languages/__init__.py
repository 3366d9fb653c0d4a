"""Kits in Python, MATLAB, and Rust, one module each."""

from .language import Language
from .matlab import MatlabKit
from .python import PythonKit
from .rust import RustKit

LANGUAGES: dict[str, Language] = {each.name: each for each in (PythonKit(), MatlabKit(), RustKit())}
"""Languages of kits other than C, by their command-line names."""
