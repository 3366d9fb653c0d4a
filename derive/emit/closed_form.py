"""C99 of the closed form: equations of motion, bias, forward dynamics, derivatives, linearisation.

The trees of ``kernel.outputs`` with the legs in lanes (``kernel.legs_in_lanes``), on the prepared model of
the force kernel; here are its header, the functions that others call, and their batches.
"""

from collections.abc import Collection
from dataclasses import replace

from ..kernel import batches
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_one, missing
from ..kernel.model import STATUS_FIELD
from ..kernel.prepare import MOTION
from ..kernel.tree import nodes as t
from ..kernel.tree import read
from ..kernel.written import batch
from ..mechanics import quantities as n
from ..mechanics.closed_form import NAMES, SumKernel
from ..print.c import C
from ..print.template import filled
from ..program.block import Operations

LEGS, LANES = 6, 8
FUNCTIONS = tuple(each for each in o.OUTPUTS if each != o.FORCES)
"""What the emitted file can hold, in the order of its declarations."""

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
ORDER = (*STRUCTS, *(each for each in FUNCTIONS if each not in STRUCTS))
MODEL_ONLY = ("Leg", "Robot", "LegConstants", "Added", "Platform", "Model", "Motion")


def header(
    kernels: tuple[SumKernel, ...],
    frictionless: tuple[SumKernel, ...],
    name: str,
    version: str,
    functions: Collection[str] = FUNCTIONS,
) -> str:
    """``stewart_<kernel>_motion.h``: what is computed, its cost, its functions.

    kernels, frictionless: at least those of ``kernels_of``. functions: those that are declared, out of
    FUNCTIONS. Raises ValueError for others and for none.
    """
    asked = asked_for(functions)
    own = {each for what in asked for each in o.sums_used((what,), deep=False)}
    rows = [
        f" * {kernel.name:17s} {sum_operations(kernel)!s:44s} {sum_operations(plain).total}"
        for kernel, plain in zip(kernels, frictionless, strict=True)
        if kernel.name in own
    ]
    printer, structs = C(), [what for what in asked if what in STRUCTS]
    texts = [printer.structure(_struct(what)) for what in structs]
    for i, what in enumerate(structs):
        says = "The same of `count` poses. Any pointer may be null: not wanted." if i == 0 else ""
        texts.append(printer.structure(_arrays(what, says)))
    public = {what: interface(name, what) for what in asked}
    return filled(
        "motion.h",
        name=name,
        version=version,
        guard=f"STEWART_{name.upper()}_MOTION_H",
        read="are read by\n * `derivatives` alone." if "derivatives" in asked else "are not read.",
        operations="\n".join(rows),
        structs="\n".join("\n".join([*lines, ""]) for lines in texts),
        one_pose="\n".join(line for what in asked for line in printer.declaration(public[what][0])),
        forced="F is [count][6]. " if set(asked) & set(o.FORCED) else "",
        batches="\n".join(
            line for what in ORDER if what in asked for line in printer.declaration(public[what][1])
        ),
    )


def kernels_of(functions: Collection[str]) -> tuple[str, ...]:
    """Names of the kernels whose sums the functions need, in the order of ``closed_form.NAMES``.

    functions: out of FUNCTIONS. Raises ValueError for others and for none.
    """
    used = o.sums_used(asked_for(functions))
    return tuple(name for name in NAMES if name in used)


def asked_for(functions: Collection[str]) -> list[str]:
    """The functions in the order of their declarations."""
    if not functions or not set(functions) <= set(FUNCTIONS):
        raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got {list(functions)}")
    return [what for what in FUNCTIONS if what in functions]


def sum_operations(kernel: SumKernel) -> Operations:
    """Operations per pose before any solve: six legs, the platform, the sums."""
    sums = LEGS * sum(len(q.keys) for q in kernel.summed)
    return LEGS * kernel.leg.operations() + kernel.pose.operations() + Operations(add=sums)


# ---------------------------------------------------------------- what others call


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


def _struct(what: str) -> t.Structure:
    fields = tuple(t.Field(each, t.Array(t.Real(), (count,))) for each, count in members(what).items())
    return t.Structure(f"stewart_{what}", STRUCTS[what], fields)


def _arrays(what: str, says: str) -> t.Structure:
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
    whole = (
        t.Field("of", t.Record(f"stewart_{what}")) if struct else t.Field(first, t.Array(t.Real(), (count,)))
    )
    held["Found"] = t.Structure(f"{what}_found", "", (whole, STATUS_FIELD))
    arguments = (
        t.Argument(each, t.Record(""), each == "found") for each in ("model", "motion", *forced, "found")
    )
    find = t.Function(f"find_{what}", "", tuple(arguments), None, ())
    taken: t.Statement = t.Assign(out, t.Member(found, "of"))
    if struct:
        held |= {"Result": _struct(what)}
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
        held |= {"Found": _struct(what), "ResultArrays": _arrays(what, "")}
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


# ---------------------------------------------------------------- what they need
