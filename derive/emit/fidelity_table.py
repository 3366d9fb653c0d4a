"""``fidelities.py``: what there is of reduced force kernels, for the runtime to choose from.

Prints names, meanings and counts; the kernels themselves are C.
"""

from collections.abc import Mapping

from ..kernel.operations import force_operations
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.reduced_models import Fidelity
from ..print.template import filled
from .c import wrap_list


def module(kernels: Mapping[Fidelity, ForceKernel], version: str) -> str:
    """The module's text."""
    entries = "\n".join(_entry(level, kernel) for level, kernel in kernels.items())
    return filled("fidelities.py", version=version, entries=entries)


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
