"""NumPy Python: the regressor, vectorised over poses and legs."""

import sympy as sp

from ..block import Quantity, component_name
from ..print.template import filled
from ..regressor import LEG_PARAMETERS, PLATFORM_PARAMETERS, Regressor, dependencies
from .infix import infix
from .numpy import block_function


def module(blocks: Regressor, version: str) -> str:
    """``exact_regressor.py``: the columns as functions, and Y made of them."""
    return filled(
        "regressor.py",
        version=version,
        leg_parameters=_literal("LEG_PARAMETERS", LEG_PARAMETERS),
        platform_parameters=_literal("PLATFORM_PARAMETERS", PLATFORM_PARAMETERS),
        dependent=_rows("DEPENDENT", [f'"{name}"' for name in dependencies()]),
        formulas=_rows("MERGED", [f'("{base}", "{text}")' for base, text in merged()]),
        leg=block_function(blocks.leg, legs=True),
        platform=block_function(blocks.platform, legs=False),
    )


def merged() -> list[tuple[str, str]]:
    """Base parameters that others are merged into, with their formulas; ``sum`` runs over the legs."""
    own = [component_name(q.name, key) for q in PLATFORM_PARAMETERS for key in q.keys]
    formulas: dict[str, str] = {}
    for lost, shares in dependencies().items():
        for base, share in shares.items():
            text = infix(sp.Symbol(lost, real=True) * share, "sqrt")
            formulas[base] = f"{base} + {f'sum({text})' if base in own else text}"
    return list(formulas.items())


def _literal(name: str, parameters: tuple[Quantity, ...]) -> str:
    return _rows(
        name, [f'("{component_name(q.name, key)}", "{q.unit}")' for q in parameters for key in q.keys]
    )


def _rows(name: str, rows: list[str]) -> str:
    return "\n".join([f"{name} = (", *(f"    {row}," for row in rows), ")"])
