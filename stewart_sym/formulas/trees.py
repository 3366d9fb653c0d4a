"""What kernel trees read: the numbers of a robot and of a motion as structures."""

from collections.abc import Callable, Iterable, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..derive.mechanics import quantities as n
from ..derive.program.block import Quantity
from ..robot.offsets import need_no_offsets
from ..robot.robot import has_symbol, of_symbol

Number = Callable[[str, Any], Any]
"""From a quantity's name and one of its components to a number of the arithmetic."""


def robot_structure(robot: Any, number: Number) -> SimpleNamespace:
    """The robot; robot: what has the fields of ``Robot``, those of rotors or not."""
    need_no_offsets(robot)
    of_leg = [q for q in n.OF_LEG if has_symbol(robot, q.name)]
    numbers = {q.name: np.asarray(of_symbol(robot, q.name)) for q in (*of_leg, *n.PLATFORM)}
    legs = [structure(of_leg, {q.name: numbers[q.name][i] for q in of_leg}, number) for i in range(6)]
    return SimpleNamespace(leg=legs, **vars(structure(n.PLATFORM, numbers, number)))


def structure(quantities: Iterable[Quantity], values: Mapping[str, Any], number: Number) -> SimpleNamespace:
    """Quantities by name, each a number or a list of its components as they are stored.

    values: arrays by name, of the quantities' shapes or flat.
    """
    return SimpleNamespace(**{q.name: _stored(q, np.asarray(values[q.name]), number) for q in quantities})


def _stored(quantity: Quantity, value: Any, number: Number) -> Any:
    whole = value.reshape(quantity.shape)
    parts = [number(quantity.name, whole[key]) for key in quantity.keys]
    return parts if quantity.shape else parts[0]
