"""C99 of the closed form: equations of motion, bias, forward dynamics, derivatives, linearisation.

The trees of ``kernel.outputs`` with the legs in lanes (``kernel.legs_in_lanes``), on the prepared model of
the force kernel, the functions that others call, and their batches.
"""

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from ..kernel import batches
from ..kernel import layouts as lay
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_one, missing
from ..kernel.model import STATUS_FIELD
from ..kernel.prepare import MOTION
from ..kernel.shared import shared
from ..kernel.tree import nodes as t
from ..kernel.tree import read
from ..kernel.tree.legs_in_lanes import Layout
from ..kernel.tree.lower import steps_of
from ..kernel.tree.read import LANES
from ..kernel.tree.settle import settled
from ..kernel.written import batch
from ..kernel.written import motion_lanes as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import GIVEN, NAMES, SumKernel
from ..print.c import C
from ..print.template import filled
from ..program.block import Block, Operations, Quantity
from .shared import SIZES, SOLVE, header, top

LEGS = 6
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


def files(
    kernels: tuple[SumKernel, ...],
    frictionless: tuple[SumKernel, ...],
    model: ForceKernel,
    version: str,
    functions: Collection[str] = FUNCTIONS,
) -> dict[str, str]:
    """``stewart_<kernel>_motion.h`` and ``.c``: the functions and what they need, nothing else.

    kernels, frictionless: at least those of ``kernels_of``. functions: out of FUNCTIONS. Raises ValueError
    for others and for none.
    """
    asked = asked_for(functions)
    file = f"stewart_{model.formulation.kernel_name}_motion"
    before = "\n".join([top(file, version, SOLVE), filled("motion.c", aligned=filled("aligned.c"))])
    made = _Source(kernels, model, asked)
    parts = (settled(each) if isinstance(each, t.Function) else each for each in made.parts())
    texts = _header(made, kernels, frictionless, version)
    return texts | {f"{file}.c": C(sizes=SIZES).source(before, *parts)}


def _header(
    made: "_Source", kernels: tuple[SumKernel, ...], frictionless: tuple[SumKernel, ...], version: str
) -> dict[str, str]:
    """What is computed, its cost, its functions."""
    asked, public = made.asked, made.public
    own = {each for what in asked for each in o.sums_used((what,), deep=False)}
    rows = [
        f" * {kernel.name:17s} {sum_operations(kernel)!s:44s} {sum_operations(plain).total}"
        for kernel, plain in zip(kernels, frictionless, strict=True)
        if kernel.name in own
    ]
    printer, structs = C(), [what for what in asked if what in STRUCTS]
    says = ["The same of `count` poses. Any pointer may be null: not wanted.", *[""] * len(structs)]
    arrays = map(_arrays, structs, says)
    return header(
        "motion.h",
        f"stewart_{made.name}_motion",
        version,
        included=f"stewart_{made.name}_forces.h",
        name=made.name,
        read="are read by\n * `derivatives` alone." if "derivatives" in asked else "are not read.",
        operations="\n".join(rows),
        structs=printer.interface(*map(_struct, structs), *arrays),
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
    fields = tuple(t.numbers(each, count) for each, count in members(what).items())
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
    whole = t.Field("of", t.Record(f"stewart_{what}")) if struct else t.numbers(first, count)
    held["Found"] = t.Structure(f"{what}_found", "", (whole, STATUS_FIELD))
    arguments = dict.fromkeys(("model", "motion", *forced, "found"), t.Record(""))
    find = t.signature(f"find_{what}", changed=("found",), **arguments)
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

CHECKS = t.Structure(
    "leg_checks",
    "What tells whether a leg is fit to be computed; bad: 1 where it is not, else 0.",
    tuple(t.numbers(each, LANES) for each in ("L", "reach", "k3", "bad")),
)

_ADD_LEGS = t.signature(
    "add_legs",
    changed=("sum",),
    lanes=t.Array(t.Real(), (1, LANES)),
    count=t.Integer(),
    sum=t.Array(t.Real(), (1,)),
)


class _Source:
    """The functions of one file, in their order."""

    def __init__(self, kernels: tuple[SumKernel, ...], model: ForceKernel, asked: list[str]) -> None:
        self.model, self.asked, self.name = model, asked, model.formulation.kernel_name
        self.kernels = {o.prefix_of(each): each for each in kernels}
        self.program = o.program_in_lanes(model, kernels, asked)
        named = {each.name: each for each in self.program.structures}
        records = {each: "".join(f"_{c.lower()}" if c.isupper() else c for c in each)[1:] for each in named}
        records |= {each.name: f"{what}_found" for what, each in o.RESULTS.items()}
        records |= {"Apart": "apart_found", "SlopesApart": "slopes_found"}
        records |= {"Model": f"stewart_{self.name}_model", "Motion": "stewart_motion"}
        sums = {f"{o.camel(prefix)}Sums": kernel.summed for prefix, kernel in self.kernels.items()}
        self.layout = Layout(
            named,
            records,
            {each: _offsets(summed) for each, summed in sums.items()},
            {each: sum(len(q.keys) for q in summed) for each, summed in sums.items()},
            {o.RESULTS[what].name: f"stewart_{what}" for what in STRUCTS},
            PARTS,
            {each: f"find_{each}" for each in o.OUTPUTS},
        )
        self.public = {what: interface(self.name, what) for what in asked}
        self.functions = {"add_legs": _ADD_LEGS, "fault_of": shared().by_name["fault_of"]}

    def parts(self) -> Iterator[str | t.Structure | t.Function]:
        """Structures, functions and texts."""
        skipped = ("Pose", "Leg", "Legs", "Sums")
        for each in self.program.structures:
            if each.name not in MODEL_ONLY and not each.name.endswith(skipped):
                yield self.layout.structure(each.name)
        yield from OF_BATCHES
        yield CHECKS
        yield self._read(written.legs_status)
        if any(kernel.near is not None for prefix, kernel in self.kernels.items() if self._uses(prefix)):
            yield self._read(written.is_near)
        for function in self.program.functions:
            if function.name.endswith("_sums"):
                yield from self._kernel(function.name.removesuffix("_sums"))
            elif function.name == "singular_status":
                continue
            elif function.name == "forces":
                yield self._forces()
            elif function.name.startswith("check_"):
                yield self._check(function.name.removeprefix("check_"))
            else:
                yield self.layout.function(function)
            if function.name in self.asked:
                yield self.public[function.name][0]
        yield from (self.public[what][1] for what in ORDER if what in self.asked)

    def _uses(self, prefix: str) -> bool:
        return any(each.name == f"{prefix}_sums" for each in self.program.functions)

    def _read(self, text: o.Written, name: str = "", **more: Any) -> t.Function:
        structures = {"Checked": CHECKS, **more.pop("structures", {})}
        found = read.function(text, structures, self.functions, name, **more)
        self.functions[found.name] = found
        return found

    def _forces(self) -> t.Function:
        record = t.Structure(self.layout.records["Forces"], "", o.RESULTS["forces"].members)
        known = f"stewart_{self.name}_forces"
        self.functions[known] = t.signature(
            known,
            t.Integer(),
            ("F",),
            **dict.fromkeys(("model", "motion"), t.Record("")),
            F=t.Array(t.Real(), (LEGS,)),
        )
        structures = {"Forces": record, **self._given()}
        return self._read(
            written.forces, "find_forces", structures=structures, names={"kernel_forces": known}
        )

    def _check(self, what: str) -> t.Function:
        """Says where a result is not finite: vectors number by number, of matrices how many numbers."""
        out, lost, i = t.Name("out"), t.Name("lost"), t.Name("i")
        status, ok, bad = t.Member(out, "status"), t.Constant("OK"), t.Constant("NOT_FINITE")
        none, one = (t.As(t.Count(), t.Number(each)) for each in (0, 1))
        vectors: list[t.Statement] = [t.If(t.Binary("!=", status, ok), (t.Return(None),))]
        matrices: list[t.Statement] = []
        for name, count in members(what).items():
            number = t.Element(t.Member(t.Member(out, "of") if what in STRUCTS else out, name), (i,))
            finite = t.Binary("<=", t.Call("size", (number,)), t.Constant("MAX"))
            if count <= LEGS:
                known = t.If(t.Not(finite), (t.Assign(status, bad), t.Return(None)))
                vectors.append(t.For("i", t.Number(0), t.Number(count), (known,)))
            else:
                counted = t.Assign(lost, lost + t.Select(finite, none, one))
                matrices.append(t.For("i", t.Number(0), t.Number(count), (counted,)))
        if matrices:
            found = t.Assign(status, t.Select(t.Binary("==", lost, none), ok, bad))
            matrices = [t.Variable("lost", t.Count(), none), *matrices, found]
        return t.Function(
            f"check_{what}",
            "Says where a number of a result is not finite.",
            (t.Argument("out", t.Record(self.layout.records[o.RESULTS[what].name]), changed=True),),
            None,
            (*vectors, *matrices),
        )

    def _given(self) -> dict[str, t.Structure]:
        of = self.layout.records
        return {each: t.Structure(of[each], "", ()) for each in ("Model", "Motion")}

    def _kernel(self, prefix: str) -> Iterator[t.Structure | t.Function]:
        """One kernel: the pose's part, the legs' parts, both added up."""
        kernel = self.kernels[prefix]
        legs = {"leg": kernel.leg} | ({} if kernel.near is None else {"near": kernel.near})
        pose = self._pose_structure(prefix, kernel)
        of_legs = self._legs_structure(prefix, kernel)
        yield pose
        yield of_legs
        structures = {"Pose": pose, "Legs": of_legs, **self._given()}
        count = sum(len(q.keys) for q in kernel.summed)
        given: dict[str, read.Given] = {"COUNT": count, "HAS_NEAR": int("near" in legs)}
        names = {f"{part}_terms": f"{prefix}_of_{part}" for part in ("pose", "leg", "near")}
        body = self._pose_body(kernel)
        yield self._read(
            written.pose_terms, names["pose_terms"], structures=structures, given=given | {"POSE": body}
        )
        for part, block in legs.items():
            outside, inside = self._leg_body(kernel, block)
            found = self._read(
                written.leg_terms,
                f"{prefix}_of_{part}",
                structures=structures,
                given=given | {"OUTSIDE": outside, "BLOCK": inside} | checks(block),
            )
            self.functions[found.name] = replace(found, apart=True)
            yield self.functions[found.name]
        yield self._read(
            written.sums,
            f"{prefix}_sums",
            structures=structures | {"Checked": CHECKS},
            given=given | {"GIVEN": lay.entries(q for q in GIVEN if q in kernel.leg.inputs)},
            names=names,
        )

    def _pose_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        given = [out.quantity for out in kernel.pose.outputs if out.quantity not in kernel.summed]
        return t.Structure(f"{prefix}_pose", "", tuple(lay.stored(q, always=False) for q in given))

    def _legs_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        count = sum(len(q.keys) for q in kernel.summed)
        held = [q for q in GIVEN if q in kernel.leg.inputs] + _kept(kernel)
        return t.Structure(
            f"{prefix}_legs",
            "",
            (
                t.numbers("sum", count, LANES),
                *(lay.stored(q, LANES, always=False) for q in held),
                t.Field("checked", t.Record(CHECKS.name)),
                t.Field("status", t.Integer()),
            ),
            aligned=True,
        )

    def _pose_body(self, kernel: SumKernel) -> tuple[t.Statement, ...]:
        block = kernel.pose
        given = [out for out in block.outputs if out.quantity not in kernel.summed]
        return (
            *lay.loaded(block, lambda q: lay.member("at" if q in n.MOTION else "model", q)),
            *steps_of(block.steps),
            *lay.stores(given, lambda q: lay.member("out", q)),
            *lay.set_in_order(t.Name("summed"), _sums(kernel, block)),
        )

    def _leg_body(
        self, kernel: SumKernel, block: Block
    ) -> tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]:
        """What all legs share, and what is done for each."""

        def place(q: Quantity) -> lay.Place:
            if q in GIVEN:
                return lay.member("out", q, lay.LANE)
            if q in self.model.leg_constants():
                return lay.member("model", q, lay.LANE)
            owner = "at" if q in n.MOTION else "model" if q in self.model.platform_constants() else "pose"
            return lay.member(owner, q)

        outside, inside = lay.parted(lay.loaded(block, place, n.t, n.b))
        kept = [out for out in block.outputs if out.quantity in _kept(kernel)]
        return outside, (
            *inside,
            *steps_of(block.steps),
            *lay.set_in_order(t.Member(t.Name("out"), "sum"), _sums(kernel, block), lay.LANE),
            *lay.stores(kept, lambda q: lay.member("out", q, lay.LANE)),
        )


def _kept(kernel: SumKernel) -> list[Quantity]:
    checked = (n.q, n.L, n.k3)
    return [out.quantity for out in kernel.leg.outputs if out.quantity not in (*kernel.summed, *checked)]


def _offsets(summed: tuple[Quantity, ...]) -> dict[str, int]:
    counts = [len(q.keys) for q in summed]
    return {q.name: sum(counts[:i]) for i, q in enumerate(summed)}


def _sums(kernel: SumKernel, block: Block) -> list[sp.Expr]:
    """Each number that the block adds, in the order of the sums."""
    given = lay.exprs_of(block)
    return [expr for q in kernel.summed for expr in given[q]]


def checks(block: Block) -> dict[str, read.Given]:
    """How legs are found unfit, as ``layouts.checks`` has it."""
    terms = [*lay.exprs_of(block)[n.q], *n.t.symbols, *n.b.symbols]
    return lay.checks(block, terms, "ROUNDING", "JOINT_SINGULAR_SINE")
