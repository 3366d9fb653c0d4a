"""Interface of the closed form in C: structures, functions for one pose, and batches."""

from collections.abc import Iterator
from dataclasses import replace

from ..kernel import batches
from ..kernel import layouts as lay
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_one, missing
from ..kernel.interface import CALLS
from ..kernel.prepare import MOTION, result
from ..kernel.written import batch
from ..mechanics import quantities as n
from ..trace import nodes as t
from ..trace import read
from ..trace.read import LANES

STRUCTS = {
    "equations": "Terms of the equations of motion, base frame, moments about the reference point.",
    "derivatives": "Actuator forces of inverse dynamics, and their derivatives by pose, twist, and "
    "acceleration.",
    "linearization": "Forward dynamics, and its linearization about the motion: "
    "d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF.",
}
"""Functions that fill a structure, and the description of the structure."""

_SAYS = {
    "equations": "Computes the terms of the equations of motion.",
    "bias_and_friction": "Computes C [v; omega] + g + friction (N and N m), base frame.",
    "forward_dynamics": "Computes the acceleration [a; alpha] (m/s^2 and rad/s^2, base frame) caused by the "
    "actuator forces F (N). Also returns STEWART_MASS_MATRIX_INDEFINITE.",
    "joint_inertia": "Computes the inertia seen by the actuators (kg), H^-1 M H^-T, row-major. The length "
    "rates are H^T [v; omega]. Also returns STEWART_SINGULAR.",
    "derivatives": "Computes the actuator forces of inverse dynamics and their derivatives. Also returns "
    "STEWART_SINGULAR.",
    "linearization": "Computes the forward dynamics for the actuator forces F (N) and its linearization. "
    "Also returns STEWART_MASS_MATRIX_INDEFINITE.",
}
"""Descriptions of the functions of one pose that say more than the table of outputs."""

PARTS = {
    (structure, part): ("acceleration", first)
    for structure in ("Accelerations", "LinearizationResult")
    for part, first in (("a", 0), ("alpha", 3))
}


def members(what: str) -> dict[str, int]:
    """Return the members of a function's result, and the count of their numbers."""
    return {each.name: each.count for each in CALLS[what].outputs}


def members_in_order(what: str) -> Iterator[tuple[str, t.Expression, int]]:
    """Yield each member with its offset in a contiguous array and its count."""
    first = 0
    for name, count in members(what).items():
        yield name, t.Number(first), count
        first += count


def in_place(what: str) -> Iterator[t.Statement]:
    """Yield statements that copy the members of a whole block to their arrays, if there are such."""
    for name, place, count in members_in_order(what):
        to = t.of("out", name) if what in STRUCTS else t.Name("out")
        numbers = t.From(t.of("block", "number"), t.Number(LANES) * place)
        rows = t.From(to, t.As(t.Count(), t.Number(count)) * t.Name("first"))
        call: t.Statement = t.Do(t.Call("in_rows", (numbers, t.Number(count), rows)))
        yield t.If(t.Binary("!=", to, t.Constant("NULL")), (call,)) if what in STRUCTS else call


def struct_of(what: str) -> t.Structure:
    """Return the structure that a function fills."""
    fields = (t.numbers(e.name, e.count, meaning=f"{e.unit}: {e.meaning}") for e in CALLS[what].outputs)
    return t.Structure(f"stewart_{what}", STRUCTS[what], tuple(fields))


def arrays_of(what: str, says: str) -> t.Structure:
    """Return the structure that its batch fills, with the description ``says``."""
    fields = tuple(t.Field(each, t.Pointer(t.Real()), f"[count][{n}]") for each, n in members(what).items())
    return t.Structure(f"stewart_{what}_arrays", says, fields)


def interface(name: str, what: str) -> tuple[t.Function, t.Function]:
    """Return the functions of one pose and of many."""
    struct, counts = what in STRUCTS, members(what)
    ((first, count), *_) = counts.items()
    forced = ["F"] if what in o.FORCED else []
    given: dict[str, read.Given] = {} if forced else {"F": False}
    found, out = t.Name("found"), t.Name("out")
    whole = t.Field("of", t.Record(f"stewart_{what}")) if struct else t.numbers(first, count)
    held = {
        "Model": t.Structure(f"stewart_{name}_model", "", ()),
        "Motion": MOTION,
        "Motions": MOTIONS,
        "Found": result(f"{what}_found", "", whole),
        **({"Result": struct_of(what)} if struct else {}),
    }
    arguments = dict.fromkeys(("model", "motion", *forced, "found"), t.Record(""))
    find = t.signature(f"find_{what}", changed=("found",), **arguments)
    texts = lay.Written(held, given, {each.name: each for each in (find, *OF_BATCHES)})
    taken: t.Statement = t.Assign(out, t.Member(found, "of"))
    if not struct:
        number = t.Assign(t.at(first, "i"), t.at(t.Member(found, first), "i"))
        taken = t.For("i", t.Number(0), t.Number(count), (number,))
    needed = missing(("model", "motion", *forced, "out" if struct else first)) | {"COPIED": (taken,)}
    names = {"find": find.name, **({} if struct else {"out": first, "Result": f"array({count})"})}
    one = texts.function(batch.closed_form, f"stewart_{name}_{what}", True, given=needed, names=names)
    motions = (n.R, n.t, n.omega, n.v, *((n.alpha, n.a) if what == "derivatives" else ()))
    done = copies("out", counts) if struct else (copied(out, found, count),)
    needed = missing(("model", "motions", "out", *forced), motions)
    needed |= batches.batch(batch.one_closed_form, done)
    of_arrays = {"Found": f"array({count})", "ResultArrays": "Pointer(Real)"}
    names = {"of_pose": one.name, **({} if struct else of_arrays)}
    more = {"Found": struct_of(what), "ResultArrays": arrays_of(what, "")} if struct else {}
    many = texts.function(
        batch.closed_form_batch, f"{one.name}_batch", True, given=needed, structures=more, names=names
    )
    says = _SAYS.get(what, CALLS[what].says)
    return replace(one, meaning=says), replace(many, meaning="")


OF_BATCHES = (
    read.function(batch.copy, {}, {}),
    read.function(
        batch.load_pose,
        {"Motion": MOTION, "Motions": MOTIONS},
        {},
        given=loaded_one(n.MOTION[1:], (n.alpha, n.a, *LOADS)),
    ),
)
