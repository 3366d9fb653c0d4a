"""Inputs of kernel trees: the numbers of a robot and a motion as structures."""

from collections.abc import Callable, Iterable, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..derive.mechanics import quantities as n
from ..derive.program.block import Quantity
from ..robot.offsets import need_no_offsets
from ..robot.robot import has_symbol, of_symbol

Number = Callable[[str, Any], Any]
"""Function that maps the name of a quantity and one component to a number of the arithmetic."""


def robot_structure(robot: Any, number: Number) -> SimpleNamespace:
    """Return the structure of a robot, which has the fields of ``Robot``, with or without rotors."""
    need_no_offsets(robot)
    of_leg = [q for q in n.OF_LEG if has_symbol(robot, q.name)]
    numbers = {q.name: np.asarray(of_symbol(robot, q.name)) for q in (*of_leg, *n.PLATFORM)}
    legs = [structure(of_leg, {q.name: numbers[q.name][i] for q in of_leg}, number) for i in range(6)]
    return SimpleNamespace(leg=legs, **vars(structure(n.PLATFORM, numbers, number)))


def structure(quantities: Iterable[Quantity], values: Mapping[str, Any], number: Number) -> SimpleNamespace:
    """Return quantities by name, each as a number or a list of its stored components.

    ``values`` contains arrays by name, flat or with the shapes of the quantities.
    """
    return SimpleNamespace(**{q.name: _stored(q, np.asarray(values[q.name]), number) for q in quantities})


def _stored(quantity: Quantity, value: Any, number: Number) -> Any:
    whole = value.reshape(quantity.shape)
    parts = [number(quantity.name, whole[key]) for key in quantity.keys]
    return parts if quantity.shape else parts[0]
