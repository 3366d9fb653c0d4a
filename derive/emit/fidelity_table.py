"""``fidelities.py``: what there is of reduced force kernels, for the runtime to choose from.

Prints names, meanings and counts; the kernels themselves are C. Knows no dynamics.
"""

from collections.abc import Mapping

from ..fidelity import Fidelity
from ..operations import force_operations
from ..regroup import ForceKernel
from .c import wrap_list


def module(kernels: Mapping[Fidelity, ForceKernel], version: str) -> str:
    """The module's text."""
    entries = "\n".join(_entry(level, kernel) for level, kernel in kernels.items())
    return _MODULE.format(version=version, entries=entries)


def _entry(level: Fidelity, kernel: ForceKernel) -> str:
    counts = {part: count.total for part, count in force_operations(kernel).parts().items()}
    values = {
        "kernel": kernel.name,
        "meaning": level.meaning,
        "universal": any(q.name == "k" for q in kernel.leg_constants()),
    }
    lines = "\n".join(f'        "{name}": {_literal(value)},' for name, value in values.items())
    parts = ", ".join(f'"{part}": {count}' for part, count in counts.items())
    operations = wrap_list(f"{' ' * 12}{parts},", " " * 12)
    return f'    "{level.name}": {{\n{lines}\n        "operations": {{\n{operations}\n        }},\n    }},'


def _literal(value: object) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)


_MODULE = '''\
"""The levels of fidelity of the force kernels of ``exact``, from everything to nothing but the platform.

Written by stewart-sym {version}; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

# kernel: name of its C, stewart_<kernel>_forces; universal: whether it knows the universal joints' axes.
FIDELITIES: dict[str, dict[str, Any]] = {{
{entries}
}}
'''
