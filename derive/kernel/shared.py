"""Functions that several C sources use, each in one header."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cache

from ..mechanics import quantities as n
from ..mechanics.actuator_forces import leg_moments, platform_moments
from ..mechanics.lumped_constants import ADDED, arm_c, q_1
from ..mechanics.platform import platform
from ..program.block import Quantity
from ..program.cse import share
from . import layouts as lay
from .batches import LOADS, MOTIONS, parts_at, parts_of_one
from .elimination import BLOCKS_OF_POSE, INVERSE, ONCE, RETURNED, blocks_in_lanes, by_rows, in_lanes
from .prepare import LUMPED, MOTION
from .tree import nodes as t
from .tree.constants import LARGEST
from .tree.decided_selections import settled
from .tree.lower import expression
from .tree.read import POSES, Given
from .written import batch, lanes, legs, moments, solve

_ADDED: dict[str, Given] = {
    "add_leg": legs.add_leg,
    "part_of_leg": legs.part_of_leg,
    "plus": legs.plus,
    "HAS_C_MOMENT": 1,
    "ALL_LEGS": 1,
}


def legs_in_turn(out: str, leg: str, moments: str = "") -> dict[str, Given]:
    """Return the statements that add one leg after the other to H and c of ``out``.

    ``moments`` are the moments about platform point 1, if they are not about the reference point.
    """

    def part(owner: str, name: str) -> Given:
        return lambda j, _: t.at(t.of(owner, name), j)

    return {
        **_ADDED,
        "H": lambda j, i: t.at(t.of(out, "H"), j, i),
        "c": lambda j: t.at(t.of(out, "c"), j),
        **{name: part(leg, name) for name in ("H_force", "c_force", "c_moment")},
        **{name: part(moments or leg, name) for name in ("H_moment", "arm_c")},
        "ABOUT_TIP": int(bool(moments)),
    }


def legs_with_errors(out: str, leg: str) -> dict[str, Given]:
    """Return ``legs_in_turn`` with rounding errors of the sums; leg 1 has no moments about its own point."""
    return {
        **legs_in_turn(out, leg, leg),
        "plus": legs.plus_error,
        "c_own": lambda j: t.at(t.of(out, "c_own"), j),
        "H_moment": lambda j, i: t.Select(
            t.Binary(">", i, t.Number(0)), t.at(t.of(leg, "H_moment"), j), t.Number(0.0)
        ),
        "ALL_LEGS": 0,
    }


def legs_in_lanes(owner: str, rows: str) -> dict[str, Given]:
    """Return the statements for legs side by side: columns of ``rows``, sums in ``force`` and ``turn``."""

    def part(name: str) -> Given:
        return lambda j, i: t.at(t.of(owner, name), j, i)

    of_legs = ("H_force", "H_moment", "c_force", "c_moment", "arm_c")
    return {
        **_ADDED,
        "H": lambda j, i: t.at(rows, j, i),
        "c": lambda j: t.Name("force") if isinstance(j, t.Name) else t.Name("turn"),
        **{name: part(name) for name in of_legs},
    }


_NUMBERS = t.Pointer(t.Real())
_VECTORS = t.Array(t.Real(), (3, POSES))


_COUNTS = dict.fromkeys(("stride", "first", "count"), t.Count())
_BLOCKS = (
    t.signature("load_vector", changed=("to",), source=_NUMBERS, **_COUNTS, to=_VECTORS),
    t.signature("load_matrix", changed=("to",), source=_NUMBERS, **_COUNTS, to=_VECTORS),
    t.signature(
        "store_forces", changed=("to",), F=_VECTORS, bad=t.Array(t.Real(), (POSES,)), **_COUNTS, to=_NUMBERS
    ),
)
FORCE = t.signature("STEWART_FORCE", t.Real(), D=t.Real(), x=t.Real())


@dataclass(frozen=True)
class Shared:
    """Functions around the linear solve, functions with lanes, and functions of every output.

    ``moments`` are the functions with lanes that compute moments. ``platform_terms`` is the structure that
    the functions of every output fill.
    """

    solve: tuple[t.Function, ...]
    lanes: tuple[t.Function, ...]
    moments: tuple[t.Function, ...]
    platform_terms: t.Structure
    outputs: tuple[t.Function, ...]

    @property
    def by_name(self) -> dict[str, t.Function]:
        """All functions that a source may call."""
        return {
            each.name: each for each in (*self.solve, *self.lanes, *self.moments, *self.outputs, *_BLOCKS)
        }


@cache
def shared(about_tip: bool = True) -> Shared:
    """Return the shared functions; ``about_tip`` selects moments about platform point 1."""
    texts = lay.Written({"Motions": MOTIONS, "Motion": MOTION, "Lumped": LUMPED}, {}, {FORCE.name: FORCE})
    read = texts.function
    wrench = share(platform()[0])
    of_platform = lay.structure("platform_terms", "", wrench.made)
    added: dict[str, Given] = {"ADDED": lay.entries(ADDED)}
    rows = (lanes.exchange_rows, lanes.subtract_row)
    return Shared(
        (
            read(solve.cube_of),
            settled(read(solve.per_length_of, given={"LARGEST": t.Number(LARGEST)})),
            read(solve.scaled_axis),
            read(solve.clear_lumped, given=added),
            read(solve.add_lumped, given=added),
            read(legs.largest_component),
            read(legs.fault_of, apart=True, given=RETURNED),
            read(solve.singular_status, apart=True, given={**INVERSE, **RETURNED}),
        ),
        (
            *(read(each) for each in rows),
            read(lanes.blocks_of_pose, given=BLOCKS_OF_POSE),
            read(lanes.pivots_of_pose, apart=True, given=by_rows(about_tip)),
            read(lanes.solve_pose),
            read(lanes.blocks_of_lanes, apart=True, given=blocks_in_lanes(about_tip)),
            read(lanes.pivots_of_lanes, apart=True, given=in_lanes(about_tip)),
            read(lanes.solve_block),
        ),
        _moments(texts, about_tip),
        of_platform,
        (
            lay.filling(wrench, of_platform),
            read(solve.eliminate, given=ONCE),
            # No call where every leg of every pose is checked.
            read(legs.fault_of, "status_of_leg", given=RETURNED),
            read(batch.is_finite),
            read(batch.pose_at, given=parts_at(LOADS)),
            read(batch.motion_as_arrays, given=parts_of_one()),
            read(batch.copy),
        ),
    )


# ---------------------------------------------------------------- moments about platform point 1

_SHAPES = {"": lay.RIGHT_SIDE, "_without_moment": (n.c_force,), "_without_c": ()}
"""Ending of names -> what legs add to c before their moments are taken about platform point 1."""


def by_shape(functions: Mapping[str, t.Function], has: Collection[Quantity]) -> dict[str, t.Function]:
    """Return the functions for legs with these outputs, by their names in the texts."""
    given = tuple(q for q in lay.RIGHT_SIDE if q in has)
    end = next(end for end, held in _SHAPES.items() if held == given)
    of_pose = "" if given else end
    ends = {"moments_of_pose": of_pose, "moments_of_first": end, "moments_of_block": end}
    return {name: functions[name + end] for name, end in ends.items()}


def _moments(texts: lay.Written, about_tip: bool) -> tuple[t.Function, ...]:
    """Return the functions with lanes; ``about_tip`` adds the functions that compute moments."""
    flags: dict[str, Given] = {"ABOUT_TIP": int(about_tip)}
    scaled = (texts.function(each, given=flags) for each in (moments.scale_pose, moments.scale_block))
    own = (*_of_pose(texts), *_of_block(texts)) if about_tip else ()
    return (*own, *scaled, texts.function(moments.rows_status, apart=True, given=flags))


def _of_pose(texts: lay.Written) -> Iterable[t.Function]:
    """Return the functions with legs in lanes."""
    shift = platform_moments()
    first = tuple(t.Let(name, t.at("q", i, 0)) for i, name in enumerate(q_1.names))
    moved = (
        *first,
        *lay.lines(shift, lambda q: lay.Place(t.Name(q.name)), without=(q_1,)),
        *lay.stores(shift.outputs, lambda q: lay.Place(t.Name(q.name))),
    )
    yield texts.function(moments.shift_of_pose, given={"SHIFT": moved})
    rows = {n.H_force: 0, n.H_moment: 3}

    def legs(q: Quantity) -> lay.Place:
        return lay.Place(t.Name("A" if q in rows else q.name), (lay.LANE,), rows.get(q, 0))

    for end, absent in (("", ()), ("_without_c", ("c_force", "arm_c"))):
        leg = leg_moments(not absent)
        body = (*lay.lines(leg, legs, without=(q_1,)), *lay.stores(leg.outputs, legs))
        given: dict[str, Given] = {"FIRST": first, "MOMENTS": body, **dict.fromkeys(absent, False)}
        name, count = f"moments_of_pose{end}", leg.operations()
        yield texts.function(moments.moments_of_pose, name, given=given, count=count)


def _of_block(texts: lay.Written) -> Iterable[t.Function]:
    """Return the functions with poses in lanes."""
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
        exprs = leg.exprs
        body: tuple[t.Statement, ...] = (
            *lay.lines(leg, lambda q: lay.Place(t.Name(arrays.get(q, q.name)), (lay.LANE,))),
            *lay.assembled({n.H_moment: exprs[n.H_moment]}),
            *sums,
            *lay.assembled({arm_c: exprs.get(arm_c, ())}),
        )
        absent: dict[str, Given] = {q.name: False for q in lay.RIGHT_SIDE if q not in held}
        first, other = f"moments_of_first{end}", f"moments_of_block{end}"
        yield texts.function(moments.moments_of_first, first, given={"FIRST": (*moved, *sums), **absent})
        given: dict[str, Given] = {"MOMENTS": body, **absent, **({} if held else {"c": False})}
        yield texts.function(moments.moments_of_block, other, given=given, count=leg.operations())
