"""What others call of the closed form in C: structures, functions of one pose and batches."""

from collections.abc import Iterator
from dataclasses import replace

from ..kernel import batches
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_one, missing
from ..kernel.model import STATUS_FIELD
from ..kernel.prepare import MOTION
from ..kernel.tree import nodes as t
from ..kernel.tree import read
from ..kernel.tree.read import LANES
from ..kernel.written import batch
from ..mechanics import quantities as n

STRUCTS = {
    "equations": "H_dot: rate of H; the others as above.",
    "derivatives": "Actuator forces of inverse dynamics and their derivatives by [dt; dphi], [v; omega], "
    "[a; alpha].",
    "linearisation": "Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF "
    "about the motion.",
}
"""Functions that fill a structure, and what it says."""

PARTS = {
    (result, part): ("acceleration", first)
    for result in ("Accelerations", "Linearisation")
    for part, first in (("a", 0), ("alpha", 3))
}


def members(what: str) -> dict[str, int]:
    """Members of what a function fills, and how many numbers each has."""
    result = o.RESULTS[what]
    found: dict[str, int] = {}
    for each in result.members:
        if isinstance(each.type, t.Array):
            whole = PARTS.get((result.name, each.name), (each.name, 0))[0]
            count = each.type.dims[0] * (each.type.dims[1] if len(each.type.dims) == 2 else 1)
            found[whole] = found.get(whole, 0) + count
    return found


def members_in_order(what: str) -> Iterator[tuple[str, t.Expression, int]]:
    """Members, where they begin where all are one after the other, and how many numbers each has."""
    first = 0
    for name, count in members(what).items():
        yield name, t.Number(first), count
        first += count


def in_place(what: str) -> Iterator[t.Statement]:
    """Members of a whole block, each into its array, if there is one."""
    for name, place, count in members_in_order(what):
        to = t.of("out", name) if what in STRUCTS else t.Name("out")
        numbers = t.From(t.of("block", "number"), t.Number(LANES) * place)
        rows = t.From(to, t.As(t.Count(), t.Number(count)) * t.Name("first"))
        call: t.Statement = t.Do(t.Call("in_rows", (numbers, t.Number(count), rows)))
        yield t.If(t.Binary("!=", to, t.Constant("NULL")), (call,)) if what in STRUCTS else call


def struct_of(what: str) -> t.Structure:
    """What a function fills."""
    fields = tuple(t.numbers(each, count) for each, count in members(what).items())
    return t.Structure(f"stewart_{what}", STRUCTS[what], fields)


def arrays_of(what: str, says: str) -> t.Structure:
    """What its batch fills; says: of the structure."""
    fields = tuple(t.Field(each, t.Pointer(t.Real()), f"[count][{n}]") for each, n in members(what).items())
    return t.Structure(f"stewart_{what}_arrays", says, fields)


def interface(name: str, what: str) -> tuple[t.Function, t.Function]:
    """The functions of one pose and of many."""
    struct, counts = what in STRUCTS, members(what)
    ((first, count), *_) = counts.items()
    forced = ["F"] if what in o.FORCED else []
    given: dict[str, read.Given] = {} if forced else {"F": False}
    held = {"Model": t.Structure(f"stewart_{name}_model", "", ()), "Motion": MOTION, "Motions": MOTIONS}
    found, out, i = t.Name("found"), t.Name("out"), t.Name("i")
    whole = t.Field("of", t.Record(f"stewart_{what}")) if struct else t.numbers(first, count)
    held["Found"] = t.Structure(f"{what}_found", "", (whole, STATUS_FIELD))
    arguments = dict.fromkeys(("model", "motion", *forced, "found"), t.Record(""))
    find = t.signature(f"find_{what}", changed=("found",), **arguments)
    taken: t.Statement = t.Assign(out, t.Member(found, "of"))
    if struct:
        held |= {"Result": struct_of(what)}
    else:
        number = t.Assign(t.Element(t.Name(first), (i,)), t.Element(t.Member(found, first), (i,)))
        taken = t.For("i", t.Number(0), t.Number(count), (number,))
    own = {} if struct else {"out": first, "Result": f"array({count})"}
    needed = missing(("model", "motion", *forced, own.get("out", "out")))
    one = read.function(
        batch.closed_form,
        held,
        {find.name: find},
        f"stewart_{name}_{what}",
        True,
        given | needed | {"COPIED": (taken,)},
        {"find": find.name, **own},
    )
    if struct:
        held |= {"Found": struct_of(what), "ResultArrays": arrays_of(what, "")}
    own = {} if struct else {"Found": f"array({count})", "ResultArrays": "Pointer(Real)"}
    motions = (n.R, n.t, n.omega, n.v, *((n.alpha, n.a) if what == "derivatives" else ()))
    done = copies("out", counts) if struct else (copied(out, found, count),)
    needed = missing(("model", "motions", "out", *forced), motions)
    many = read.function(
        batch.closed_form_batch,
        held,
        {each.name: each for each in (one, *OF_BATCHES)},
        f"{one.name}_batch",
        True,
        given | needed | batches.batch(batch.one_closed_form, done),
        {"of_pose": one.name, **own},
    )
    says = "Inertia that the actuators feel, H^-1 M H^-T: H^T [v; omega] are the rates of the leg lengths."
    return replace(one, meaning=says if what == "joint_inertia" else ""), replace(many, meaning="")


OF_BATCHES = (
    read.function(batch.copy, {}, {}),
    read.function(
        batch.load_pose,
        {"Motion": MOTION, "Motions": MOTIONS},
        {},
        given=loaded_one(n.MOTION[1:], (n.alpha, n.a, *LOADS)),
    ),
)
