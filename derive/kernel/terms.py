"""Blocks of the inverse dynamics as functions that fill a structure, for languages with addresses."""

from ..mechanics import quantities as n
from ..program.block import Block, Quantity
from . import layouts as lay
from .tree import nodes as t


def terms(name: str, block: Block) -> t.Structure:
    """What a block makes."""
    return t.Structure(name, "", tuple(lay.described(out.quantity) for out in block.outputs))


def filling(block: Block, made: t.Structure) -> t.Function:
    """A block as a function; each named step keeps its equation number and meaning."""
    inputs = block.inputs
    given = [q for q in inputs if q in (n.x, n.bearing)]
    arguments = [
        *([t.Argument("robot", t.Record("stewart_robot"))] if any(q in n.PLATFORM for q in inputs) else []),
        *([t.Argument("leg", t.Record("stewart_leg"))] if any(q in n.OF_LEG for q in inputs) else []),
        t.Argument("at", t.Record("stewart_motions")),
        *(t.Argument(q.name, t.Real()) for q in given),
        t.Argument("out", t.Record(made.name), changed=True),
    ]
    body = (*lay.lines(block, _place, given), *lay.stores(block.outputs, lambda q: lay.member("out", q)))
    meaning = f"{block.meaning[0].upper()}{block.meaning[1:]}. Operations: {block.operations()}."
    return t.Function(block.name, meaning, tuple(arguments), None, body)


def _place(q: Quantity) -> lay.Place:
    return lay.member("robot" if q in n.PLATFORM else "leg" if q in n.OF_LEG else "at", q)
