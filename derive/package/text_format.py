"""Format of numbers, names, lists, and tables in the texts of a kit, and its templates."""

import hashlib
import math
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from operator import getitem
from typing import Any

from ..kernel.interface import STRUCTS
from ..mechanics import quantities as n
from ..print.template import filled_from
from ..program.block import Quantity

Numbers = Mapping[str, Any]
"""Quantity name -> number or nested lists of numbers."""

LONGEST = 48
"""Largest length of a robot's name in a C identifier, in characters."""


def template(name: str, values: Mapping[str, str] | None = None) -> str:
    """Return a file of ``templates`` with each ``$word`` replaced; ``name`` is without ``.in``."""
    return filled_from(__package__, name, values or {})


def robot_symbol(name: str) -> str:
    """Return the C identifier of a robot: ``stewart_robot_`` and the ASCII letters and digits of its name.

    Accents are removed. A name without any such letter or digit is replaced by its digest. A name of more
    than LONGEST characters is shortened and ends in eight digits of its digest, so that long names with the
    same beginning remain different. Names of files and libraries contain the symbol, and file systems allow
    255 bytes.
    """
    plain = unicodedata.normalize("NFKD", name.casefold())
    letters = "".join(char for char in plain if not unicodedata.combining(char))
    words = re.findall(r"[a-z0-9]+", letters)
    digest = hashlib.sha256(name.encode()).hexdigest()
    symbol = "_".join(words) or digest[:12]
    if len(symbol) > LONGEST:
        symbol = f"{symbol[: LONGEST - 9].rstrip('_')}_{digest[:8]}"
    return f"stewart_robot_{symbol}"


def in_comment(name: str) -> str:
    """Escape a name for a C comment."""
    return name.replace("*/", "* /").replace("/*", "/ *")


def in_markdown(name: str) -> str:
    """Escape a name for Markdown."""
    return re.sub(r"([\\`*_{}\[\]<>#|&])", r"\\\1", name)


def literal(number: Any, where: str) -> str:
    """Return a number with all digits in the arithmetic of the kernel.

    A float build thus contains no double.

    Raises
    ------
    ValueError
        If the number is not finite; the message begins with ``where``.
    """
    return f"REAL({_finite(number, where)!r})"


def literals_of_legs(numbers: Numbers, struct: str) -> dict[str, list[str]]:
    """Return the members of a struct with six numbers each; infinite numbers become the largest number."""
    return {
        each.name: ["STEWART_MAX" if math.isinf(x) else literal(x, each.name) for x in numbers[each.name]]
        for each in STRUCTS[struct]
    }


def _finite(number: Any, where: str) -> float:
    if not math.isfinite(number):
        raise ValueError(f"{where}: expected finite numbers, got {number!r}")
    return float(number)


def stored(numbers: Numbers, quantity: Quantity, owner: str, leg: int | None = None) -> list[float]:
    """Return the components that ``stewart.h`` stores, in its order.

    Raises
    ------
    ValueError
        If the quantity of the owner is not finite.
    """
    value = numbers[quantity.name] if leg is None else numbers[quantity.name][leg]
    return [_finite(reduce(getitem, key, value), f"{owner}: {quantity.name}") for key in quantity.keys]


def member(quantity: Quantity, numbers: Sequence[float], indent: str) -> str:
    """Return one member of an initializer, with its name, unit, and meaning."""
    order = ", order xx xy xz yy yz zz" if quantity.symmetric else ""
    literals = [literal(number, quantity.name) for number in numbers]
    value = braces(literals, indent) if quantity.shape else literals[0]
    return f"{indent}/* {quantity.name}, {quantity.unit}: {quantity.meaning}{order} */\n{indent}{value},"


def braces(literals: Sequence[str], indent: str) -> str:
    """Return a braced list with three numbers per line."""
    rows = [", ".join(literals[i : i + 3]) for i in range(0, len(literals), 3)]
    return "{" + f",\n{indent} ".join(rows) + "}"


def motion_members(motion: Numbers, indent: str) -> str:
    """Return the initializer of a ``stewart_motion`` without braces; R is (3, 3), other fields are (3,)."""
    return "\n".join(member(q, stored(motion, q, "motion"), indent) for q in n.MOTION)


def table(rows: Iterable[Sequence[str]]) -> str:
    """Return the rows of a Markdown table; the first cell is code."""
    return "\n".join(f"| `{first}` | {' | '.join(rest)} |" for first, *rest in rows)
