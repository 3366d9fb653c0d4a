"""Batches as trees: the arrays of motions and results of many poses."""

from collections.abc import Collection, Iterable, Mapping
from functools import partial, reduce

from ..mechanics import quantities as n
from ..program.block import Quantity
from ..trace import nodes as t
from ..trace.read import Given
from .written import batch as text

NUMBERS = t.Pointer(t.Real())
MOTIONS = t.Structure("stewart_motions", "", tuple(t.Field(q.name, NUMBERS) for q in n.MOTION))
LOADS = (n.F_ext, n.M_ext)
_ZEROS = t.Name("zeros")
BATCH: dict[str, Given] = {"batch": text.batch, "note_status": text.noted, "COPIES": 0}


def batch(one_pose: Given, copied: tuple[t.Statement, ...] = ()) -> dict[str, Given]:
    """Return the function of a batch: a loop over poses with the text ``one_pose`` and ``copied`` results."""
    return {**BATCH, "one_pose": one_pose, "COPIES": int(bool(copied)), "COPIED": copied}


def missing(
    needed: Iterable[str], quantities: Iterable[Quantity] = (), *more: t.Expression
) -> dict[str, Given]:
    """Return a test that is true if an address of ``quantities`` of the motions is null, or by ``more``."""
    addresses = (*map(t.Name, needed), *map(_of_motions, quantities))
    return {"MISSING": reduce(partial(t.Binary, "|"), (*map(is_null, addresses), *more))}


def is_null(address: t.Expression) -> t.Expression:
    """Expression that is true if a pointer is null."""
    return t.Binary("==", address, t.Constant("NULL"))


def parts_at(
    optional: Collection[Quantity],
    without: Collection[Quantity] = (),
    to: str = "at",
    index: str = "pose",
    instead: t.Expression = _ZEROS,
) -> dict[str, Given]:
    """Return the addresses of one pose in the addresses of a batch.

    ``optional`` quantities may be null and are then replaced by ``instead``; quantities in ``without`` are
    not read. ``to`` is the structure of the addresses, and ``index`` the number of the pose.
    """
    found = []
    for q in n.MOTION:
        given = _of_motions(q)
        first = t.As(t.Count(), t.Number(len(q.keys))) * t.Name(index)
        place: t.Expression = t.From(given, first)
        if q in optional:
            place = t.Select(t.Binary("!=", given, t.Constant("NULL")), place, instead)
        found.append(t.Assign(t.of(to, q.name), given if q in without else place))
    return {"PARTS": tuple(found)}


def parts_of_one() -> dict[str, Given]:
    """Return the addresses of the numbers of one motion."""
    return {"PARTS": tuple(t.Assign(t.of("at", q.name), t.of("motion", q.name)) for q in n.MOTION)}


def loaded_one(quantities: Iterable[Quantity], optional: Collection[Quantity]) -> dict[str, Given]:
    """Statements that load one component of each vector of a pose."""
    found = []
    for q in quantities:
        value: t.Expression = t.at(_of_motions(q), "at")
        if q in optional:
            value = t.Select(t.Binary("!=", _of_motions(q), t.Constant("NULL")), value, t.Number(0.0))
        found.append(t.Assign(t.at(t.of("one", q.name), "i"), value))
    return {"ONE": tuple(found)}


def loaded_block(q: Quantity, stride: t.Expression) -> t.Statement:
    """Statements that load one quantity of the poses of a block by component, zeros for null addresses.

    ``stride`` is the distance of columns; it is 0 if poses are consecutive.
    """
    places = (stride, t.Name("first"), t.Name("count"), t.of("at", q.name))
    return t.Do(t.Call("load_matrix" if q.shape == (3, 3) else "load_vector", (_of_motions(q), *places)))


def copies(to: str, counts: Mapping[str, int], rows: Collection[str] = ()) -> tuple[t.Statement, ...]:
    """Statements that store the results of a pose; ``counts``: numbers of each; ``rows``: arrays of rows."""
    found = []
    for name, count in counts.items():
        values: t.Expression = t.of("found", name)
        values = t.From(t.at(values, 0), t.Number(0)) if name in rows else values
        found.append(copied(t.of(to, name), values, count))
    return tuple(found)


def copied(to: t.Expression, values: t.Expression, count: int) -> t.Statement:
    """Statements that copy the numbers of one pose into an array of all poses."""
    return t.Do(t.Call("copy", (to, t.Name("pose"), values, t.As(t.Count(), t.Number(count)))))


def _of_motions(q: Quantity) -> t.Expression:
    return t.of("motions", q.name)
