"""NumPy Python: the regressor, vectorised over poses and legs. Knows nothing of files."""

import sympy as sp

from ..block import Quantity, component_name
from ..regressor import LEG_PARAMETERS, PLATFORM_PARAMETERS, Regressor, dependencies
from .infix import infix
from .numpy import block_function


def module(blocks: Regressor, version: str) -> str:
    """``exact_regressor.py``: the columns as functions, and Y made of them."""
    return _MODULE.format(
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


_MODULE = '''\
"""The regressor of the Stewart platform, formulation `exact`, universal base joints.

Written by stewart-sym {version}; do not edit.
SPDX-License-Identifier: 0BSD

``robot`` and ``motion`` as in exact.py; of the robot, the points, the axes and gravity alone are read.
"""

from typing import Any

import numpy as np

from .assembly import NOT_FINITE, OK, Array, leg_status, only_good, stack

# Name and unit of each column of one leg and of the platform.
{leg_parameters}
{platform_parameters}

# Parameters of a leg whose columns are zero or sums of others on every machine, and the base parameters that
# take them up; sum: over the legs. All other parameters are base parameters by themselves.
{dependent}
{formulas}


def regressor(robot: Any, motion: Any) -> dict[str, Array]:
    """Y (..., 6, 148), the legs' columns before the platform's, and status (...)."""
    with np.errstate(all="ignore"):
        leg = regressor_of_leg(robot, motion)
        of_legs = columns(leg, LEG_PARAMETERS).swapaxes(-2, -3)
        platform = columns(regressor_of_platform(robot, motion), PLATFORM_PARAMETERS)
        status = leg_status(robot, motion, leg)
    joined = of_legs.reshape(*platform.shape[:-1], of_legs.shape[-2] * of_legs.shape[-1])
    Y = np.concatenate([joined, platform], axis=-1)
    finite = np.isfinite(Y).all(axis=(-1, -2))
    status = np.where(finite | (status != OK), status, NOT_FINITE).astype(np.int32)
    return {{"Y": only_good(Y, status), "status": status}}


def columns(found: dict[str, Array], parameters: tuple[tuple[str, str], ...]) -> Array:
    """The columns of ``parameters`` side by side, (..., 6, n)."""
    return np.stack(
        [
            np.concatenate([found[f"force_{{name}}"], found[f"moment_{{name}}"]], axis=-1)
            for name, _ in parameters
        ],
        axis=-1,
    )


{leg}


{platform}
'''
