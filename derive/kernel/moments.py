"""Moments about platform point 1, legs or poses side by side: functions that kernels of forces share."""

from collections.abc import Collection, Iterable, Mapping

from ..mechanics import quantities as n
from ..mechanics.actuator_forces import leg_moments, platform_moments
from ..mechanics.lumped_constants import arm_c, q_1
from ..program.block import Quantity
from . import layouts as lay
from .tree import nodes as t
from .tree.lower import expression
from .tree.read import Given
from .written import moments as written

_SHAPES = {"": lay.RIGHT_SIDE, "_without_moment": (n.c_force,), "_without_c": ()}
"""Ending of names -> what legs add to c before their moments are taken about platform point 1."""


def by_shape(functions: Mapping[str, t.Function], has: Collection[Quantity]) -> dict[str, t.Function]:
    """The functions for legs with these outputs, by the names that their texts give them."""
    given = tuple(q for q in lay.RIGHT_SIDE if q in has)
    end = next(end for end, held in _SHAPES.items() if held == given)
    of_pose = "" if given else end
    ends = {"moments_of_pose": of_pose, "moments_of_first": end, "moments_of_block": end}
    return {name: functions[name + end] for name, end in ends.items()}


def moments(texts: lay.Written, about_tip: bool) -> tuple[t.Function, ...]:
    """The functions; about_tip: with those that take moments, as legs do themselves otherwise."""
    flags: dict[str, Given] = {"ABOUT_TIP": int(about_tip)}
    scaled = (texts.function(each, given=flags) for each in (written.scale_pose, written.scale_block))
    own = (*_of_pose(texts), *_of_block(texts)) if about_tip else ()
    return (*own, *scaled, texts.function(written.rows_status, apart=True, given=flags))


def _of_pose(texts: lay.Written) -> Iterable[t.Function]:
    """Legs in lanes."""
    shift = platform_moments()
    first = tuple(t.Let(name, t.at("q", i, 0)) for i, name in enumerate(q_1.names))
    moved = (
        *first,
        *lay.lines(shift, lambda q: lay.Place(t.Name(q.name)), without=(q_1,)),
        *lay.stores(shift.outputs, lambda q: lay.Place(t.Name(q.name))),
    )
    yield texts.function(written.shift_of_pose, given={"SHIFT": moved})
    rows = {n.H_force: 0, n.H_moment: 3}

    def legs(q: Quantity) -> lay.Place:
        return lay.Place(t.Name("A" if q in rows else q.name), (lay.LANE,), rows.get(q, 0))

    for end, absent in (("", ()), ("_without_c", ("c_force", "arm_c"))):
        leg = leg_moments(not absent)
        body = (*lay.lines(leg, legs, without=(q_1,)), *lay.stores(leg.outputs, legs))
        given: dict[str, Given] = {"FIRST": first, "MOMENTS": body, **dict.fromkeys(absent, False)}
        name, count = f"moments_of_pose{end}", leg.operations()
        yield texts.function(written.moments_of_pose, name, given=given, count=count)


def _of_block(texts: lay.Written) -> Iterable[t.Function]:
    """Poses in lanes."""
    shift = platform_moments()
    arrays = {n.q: "q", q_1: "q_1", n.H_force: "column"}
    c = {n.c_force: lay.Place(t.Name("c"), (lay.LANE,)), n.c_moment: lay.Place(t.Name("c"), (lay.LANE,), 3)}
    moved = (
        *(t.Let(name, t.at("q", i, "l")) for i, name in enumerate(q_1.names)),
        *(t.Let(name, place.part(q, i)) for q, place in c.items() for i, name in enumerate(q.names)),
        *(t.Assign(t.at("c", i + 3, "l"), expression(e)) for i, e in enumerate(shift.outputs[0].exprs)),
    )
    for end, held in _SHAPES.items():
        sums = tuple(
            t.Assign(to, to + t.at(q.name, i, "l"))
            for q in held
            for i in range(3)
            for to in [c[q].part(q, i)]
        )
        leg = leg_moments(n.c_force in held)
        exprs = lay.exprs_of(leg)
        body: tuple[t.Statement, ...] = (
            *lay.lines(leg, lambda q: lay.Place(t.Name(arrays.get(q, q.name)), (lay.LANE,))),
            *lay.assembled({n.H_moment: exprs[n.H_moment]}, _column, _c),
            *sums,
            *lay.assembled({arm_c: exprs.get(arm_c, ())}, _column, _c),
        )
        absent: dict[str, Given] = {q.name: False for q in lay.RIGHT_SIDE if q not in held}
        first, other = f"moments_of_first{end}", f"moments_of_block{end}"
        yield texts.function(written.moments_of_first, first, given={"FIRST": (*moved, *sums), **absent})
        given: dict[str, Given] = {"MOMENTS": body, **absent, **({} if held else {"c": False})}
        yield texts.function(written.moments_of_block, other, given=given, count=leg.operations())


def _column(row: int) -> t.Expression:
    return t.at("column", row, "l")


def _c(row: int) -> t.Expression:
    return t.at("c", row, "l")
