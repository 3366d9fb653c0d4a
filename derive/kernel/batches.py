"""Batches: motions of many poses in arrays, and where their results go."""

from collections.abc import Collection, Iterable, Mapping
from functools import reduce

from ..mechanics import quantities as n
from ..program.block import Quantity
from .tree.nodes import (
    As,
    Assign,
    Binary,
    Call,
    Compare,
    Constant,
    Count,
    Do,
    Either,
    Expression,
    Field,
    From,
    Name,
    Number,
    Pointer,
    Real,
    Select,
    Statement,
    Structure,
    at,
    of,
)
from .tree.read import Given
from .written import batch as text

NUMBERS = Pointer(Real())
MOTIONS = Structure("stewart_motions", "", tuple(Field(q.name, NUMBERS) for q in n.MOTION))
LOADS = (n.F_ext, n.M_ext)
BATCH: dict[str, Given] = {"batch": text.batch, "note_status": text.noted, "COPIES": 0}


def batch(one_pose: Given, copied: tuple[Statement, ...] = ()) -> dict[str, Given]:
    """The loop over poses; one_pose: a text; copied: what becomes of its results."""
    return {**BATCH, "one_pose": one_pose, "COPIES": int(bool(copied)), "COPIED": copied}


def missing(
    needed: Iterable[str], quantities: Iterable[Quantity] = (), *more: Expression
) -> dict[str, Given]:
    """Whether an address is null; quantities: of the motions. more: other tests."""
    addresses = (*map(Name, needed), *map(_of_motions, quantities))
    return {"MISSING": reduce(Either, (*map(is_null, addresses), *more))}


def is_null(address: Expression) -> Expression:
    """Whether nothing is handed over."""
    return Compare("==", address, Constant("NULL"))


def parts_at(optional: Collection[Quantity], without: Collection[Quantity] = ()) -> dict[str, Given]:
    """Addresses of one pose in those of all; optional: may be null; without: not read."""
    found = []
    for q in n.MOTION:
        given = _of_motions(q)
        first = Binary("*", As(Count(), Number(len(q.keys))), Name("pose"))
        place: Expression = From(given, first)
        if q in optional:
            place = Select(Compare("!=", given, Constant("NULL")), place, Name("zeros"))
        found.append(Assign(of("at", q.name), given if q in without else place))
    return {"PARTS": tuple(found)}


def parts_of_one() -> dict[str, Given]:
    """Addresses of the numbers of a motion."""
    return {"PARTS": tuple(Assign(of("at", q.name), of("motion", q.name)) for q in n.MOTION)}


def loaded_one(quantities: Iterable[Quantity], optional: Collection[Quantity]) -> dict[str, Given]:
    """A component of each vector of a pose."""
    found = []
    for q in quantities:
        value: Expression = at(_of_motions(q), "at")
        if q in optional:
            value = Select(Compare("!=", _of_motions(q), Constant("NULL")), value, Number(0.0))
        found.append(Assign(at(of("one", q.name), "i"), value))
    return {"ONE": tuple(found)}


def copies(to: str, counts: Mapping[str, int], rows: Collection[str] = ()) -> tuple[Statement, ...]:
    """What was found of a pose into arrays; counts: numbers of each; rows: those that are arrays of rows."""
    found = []
    for name, count in counts.items():
        values: Expression = of("found", name)
        values = From(at(values, 0), Number(0)) if name in rows else values
        found.append(copied(of(to, name), values, count))
    return tuple(found)


def copied(to: Expression, values: Expression, count: int) -> Statement:
    """One of them."""
    return Do(Call("copy", (to, Name("pose"), values, As(Count(), Number(count)))))


def _of_motions(q: Quantity) -> Expression:
    return of("motions", q.name)
