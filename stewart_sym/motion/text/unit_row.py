"""A row of units below a log's header."""

import math

from .head import Head, is_value

LENGTH_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
ANGLE_UNITS = {"rad": 1.0, "deg": math.pi / 180.0}
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}
UNITS = {
    "length_unit": LENGTH_UNITS,
    "angle_unit": ANGLE_UNITS,
    "time_unit": TIME_UNITS,
    "unit of force": {"N": 1.0},
    "unit of moment": {"Nm": 1.0},
    "unit of current": {"A": 1.0},
}
# What a row of units may state of the columns t_x, v_x, ..., and how often it is per second.
_QUANTITIES = {
    **{
        "time": ("time_unit", 0),
        "t": ("length_unit", 0),
        "L": ("length_unit", 0),
        "theta": ("angle_unit", 0),
    },
    **{"v": ("length_unit", 1), "L_dot": ("length_unit", 1), "theta_dot": ("angle_unit", 1)},
    **{"a": ("length_unit", 2), "L_ddot": ("length_unit", 2), "theta_ddot": ("angle_unit", 2)},
    **{"F_ext": ("unit of force", 0), "M_ext": ("unit of moment", 0)},
    **{"F": ("unit of force", 0), "current": ("unit of current", 0)},
}
_PER_SECOND = ("", "/s", "/s2")
_SPELLED = {"°": "deg", "degrees": "deg", "inch": "in", "sec": "s", "µs": "us", "μs": "us"}
_SPELLED |= {"n": "N", "nm": "Nm", "a": "A"}


def units_of(head: Head, header: list[str | None], source: str) -> dict[str, str] | None:
    """Return the units by kind if the first row below the header is one of units; None: it is none.

    Such a row has no number. Raises ValueError for a cell that is no unit, or not the unit of others.
    """
    cells = {name: cell for name, cell in zip(header, head.first, strict=False) if name is not None}
    if len(head.first) != len(header) or not any(cells.values()) or any(map(is_value, cells.values())):
        return None
    where = f"{source}: line {head.above + 1}"
    found: dict[str, str] = {}
    for name, cell in cells.items():
        kind, times = _QUANTITIES.get(name.rpartition("_")[0] or name.rstrip("123456"), ("", 0))
        if not kind or not cell:
            continue
        known = [unit + _PER_SECOND[times] for unit in UNITS[kind]]
        unit = _plain_unit(cell, _PER_SECOND[times])
        if unit not in UNITS[kind]:
            raise ValueError(
                f"{where}: {name}: expected a finite number, or in a row of units {' or '.join(known)}, got "
                f"{cell[:40]!r}: convert the column, or remove the row if it states no units"
            )
        stated = found.setdefault(kind, unit)
        if stated != unit:
            raise ValueError(
                f"{where}: {name}: expected one {kind} in the row of units, got {unit} and {stated}"
            )
    return found


def _plain_unit(cell: str, per_second: str) -> str:
    """A unit as in ``UNITS`` from one in brackets or spelled otherwise, less ``per_second`` at its end."""
    text = cell.strip("[]() ").lower()
    for mark, plain in (("²", "2"), ("^", ""), (" ", ""), ("·", ""), ("*", "")):
        text = text.replace(mark, plain)
    if not text.endswith(per_second):
        return ""
    unit = text.removesuffix(per_second)
    return _SPELLED.get(unit, unit)
