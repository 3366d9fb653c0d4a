"""C99 of the closed form: equations of motion, bias, forward dynamics, derivatives, linearisation.

The trees of ``kernel.outputs`` with the legs in lanes (``kernel.legs_in_lanes``), on the prepared model of
the force kernel; here are its header, the functions that others call, and their batches.
"""

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from ..kernel import batches
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_one, missing
from ..kernel.layouts import (
    LANE,
    Place,
    exprs_of,
    loaded,
    member,
    parted,
    reach,
    set_in_order,
    stored,
    stores,
    suspicion,
)
from ..kernel.model import STATUS_FIELD
from ..kernel.prepare import MOTION
from ..kernel.shared import shared
from ..kernel.tree import read
from ..kernel.tree.legs_in_lanes import Layout
from ..kernel.tree.lower import expression, steps_of
from ..kernel.tree.nodes import (
    Argument,
    Array,
    As,
    Assign,
    Binary,
    Call,
    Compare,
    Constant,
    Count,
    Element,
    Expression,
    Field,
    For,
    Function,
    If,
    Integer,
    Member,
    Name,
    Not,
    Number,
    Pointer,
    Real,
    Record,
    Return,
    Select,
    Statement,
    Structure,
    Variable,
)
from ..kernel.tree.settle import settled
from ..kernel.written import batch
from ..kernel.written import motion_lanes as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import AXIAL, F_LEG, NAMES, NET, TURNED, SumKernel
from ..print.c import C
from ..print.template import filled
from ..program.block import Block, Operations, Quantity
from .shared import SIZES, SOLVE, top

LEGS, LANES = 6, 8
FUNCTIONS = tuple(each for each in o.OUTPUTS if each != o.FORCES)
"""What the emitted file can hold, in the order of its declarations."""

_STRUCTS = {
    "equations": "H_dot: rate of H; the others as above.",
    "derivatives": "Actuator forces of inverse dynamics and their derivatives by [dt; dphi], [v; omega], "
    "[a; alpha].",
    "linearisation": "Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF "
    "about the motion.",
}
"""Functions that fill a structure, and what it says."""

_PARTS = {
    (result, part): ("acceleration", first)
    for result in ("Accelerations", "Linearisation")
    for part, first in (("a", 0), ("alpha", 3))
}
_ORDER = (*_STRUCTS, *(each for each in FUNCTIONS if each not in _STRUCTS))
_INPUTS = (F_LEG, NET, TURNED, AXIAL)
_MODEL_ONLY = ("Leg", "Robot", "LegConstants", "Added", "Platform", "Model", "Motion")
_CHECKS = Structure(
    "leg_checks",
    "What tells whether a leg is fit to be computed; bad: 1 where it is not, else 0.",
    tuple(Field(each, Array(Real(), (LANES,))) for each in ("L", "reach", "k3", "bad")),
)
_ADD_LEGS = Function(
    "add_legs",
    "",
    (
        Argument("lanes", Array(Real(), (1, LANES))),
        Argument("count", Integer()),
        Argument("sum", Array(Real(), (1,)), changed=True),
    ),
    None,
    (),
)


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
    asked = _asked(functions)
    own = {each for what in asked for each in o.sums_used((what,), deep=False)}
    rows = [
        f" * {kernel.name:17s} {sum_operations(kernel)!s:44s} {sum_operations(plain).total}"
        for kernel, plain in zip(kernels, frictionless, strict=True)
        if kernel.name in own
    ]
    printer, structs = C(), [what for what in asked if what in _STRUCTS]
    texts = [printer.structure(_struct(what)) for what in structs]
    for i, what in enumerate(structs):
        says = "The same of `count` poses. Any pointer may be null: not wanted." if i == 0 else ""
        texts.append(printer.structure(_arrays(what, says)))
    public = {what: _interface(name, what) for what in asked}
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
            line for what in _ORDER if what in asked for line in printer.declaration(public[what][1])
        ),
    )


def source(
    kernels: tuple[SumKernel, ...],
    model: ForceKernel,
    version: str,
    functions: Collection[str] = FUNCTIONS,
) -> str:
    """``stewart_<kernel>_motion.c``: the functions and what they need, nothing else.

    kernels: at least those of ``kernels_of``. functions: out of FUNCTIONS. Raises ValueError for others and
    for none.
    """
    name = model.formulation.kernel_name
    before = "\n".join([top(f"stewart_{name}_motion", version, SOLVE), filled("motion.c")])
    made = _Source(kernels, model, _asked(functions)).parts()
    parts = (settled(each) if isinstance(each, Function) else each for each in made)
    return C(sizes=SIZES).source(before, *parts)


def kernels_of(functions: Collection[str]) -> tuple[str, ...]:
    """Names of the kernels whose sums the functions need, in the order of ``closed_form.NAMES``.

    functions: out of FUNCTIONS. Raises ValueError for others and for none.
    """
    used = o.sums_used(_asked(functions))
    return tuple(name for name in NAMES if name in used)


def _asked(functions: Collection[str]) -> list[str]:
    """The functions in the order of their declarations."""
    if not functions or not set(functions) <= set(FUNCTIONS):
        raise ValueError(f"functions: expected some of {', '.join(FUNCTIONS)}, got {list(functions)}")
    return [what for what in FUNCTIONS if what in functions]


def sum_operations(kernel: SumKernel) -> Operations:
    """Operations of a pose before any solve: six legs, the platform, the sums."""
    sums = LEGS * sum(len(q.keys) for q in kernel.summed)
    return LEGS * kernel.leg.operations() + kernel.pose.operations() + Operations(add=sums)


# ---------------------------------------------------------------- what others call


def members(what: str) -> dict[str, int]:
    """Members of what a function fills, and how many numbers each has."""
    result = o.RESULTS[what]
    found: dict[str, int] = {}
    for each in result.members:
        if isinstance(each.type, Array):
            whole = _PARTS.get((result.name, each.name), (each.name, 0))[0]
            count = each.type.dims[0] * (each.type.dims[1] if len(each.type.dims) == 2 else 1)
            found[whole] = found.get(whole, 0) + count
    return found


def _struct(what: str) -> Structure:
    fields = tuple(Field(each, Array(Real(), (count,))) for each, count in members(what).items())
    return Structure(f"stewart_{what}", _STRUCTS[what], fields)


def _arrays(what: str, says: str) -> Structure:
    fields = tuple(Field(each, Pointer(Real()), f"[count][{n}]") for each, n in members(what).items())
    return Structure(f"stewart_{what}_arrays", says, fields)


def _interface(name: str, what: str) -> tuple[Function, Function]:
    """The functions of one pose and of many."""
    struct, counts = what in _STRUCTS, members(what)
    ((first, count), *_) = counts.items()
    forced = ["F"] if what in o.FORCED else []
    given: dict[str, read.Given] = {} if forced else {"F": False}
    held = {"Model": Structure(f"stewart_{name}_model", "", ()), "Motion": MOTION, "Motions": MOTIONS}
    found, out, i = Name("found"), Name("out"), Name("i")
    whole = Field("of", Record(f"stewart_{what}")) if struct else Field(first, Array(Real(), (count,)))
    held["Found"] = Structure(f"{what}_found", "", (whole, STATUS_FIELD))
    arguments = (
        Argument(each, Record(""), each == "found") for each in ("model", "motion", *forced, "found")
    )
    find = Function(f"find_{what}", "", tuple(arguments), None, ())
    taken: Statement = Assign(out, Member(found, "of"))
    if struct:
        held |= {"Result": _struct(what)}
    else:
        number = Assign(Element(Name(first), (i,)), Element(Member(found, first), (i,)))
        taken = For("i", Number(0), Number(count), (number,))
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
        {each.name: each for each in (one, *_OF_BATCHES)},
        f"{one.name}_batch",
        True,
        given | needed | batches.batch(batch.one_closed_form, done),
        {"of_pose": one.name, **own},
    )
    says = "Inertia that the actuators feel, H^-1 M H^-T: H^T [v; omega] are the rates of the leg lengths."
    return replace(one, meaning=says if what == "joint_inertia" else ""), replace(many, meaning="")


_OF_BATCHES = (
    read.function(batch.copy, {}, {}),
    read.function(
        batch.load_pose,
        {"Motion": MOTION, "Motions": MOTIONS},
        {},
        given=loaded_one(n.MOTION[1:], (n.alpha, n.a, *LOADS)),
    ),
)


# ---------------------------------------------------------------- what they need


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
            {o.RESULTS[what].name: f"stewart_{what}" for what in _STRUCTS},
            _PARTS,
            {each: f"find_{each}" for each in o.OUTPUTS},
        )
        self.public = {what: _interface(self.name, what) for what in asked}
        self.functions = {"add_legs": _ADD_LEGS, "fault_of": shared().by_name["fault_of"]}

    def parts(self) -> Iterator[str | Structure | Function]:
        """Structures, functions and texts."""
        skipped = ("Pose", "Leg", "Legs", "Sums")
        for each in self.program.structures:
            if each.name not in _MODEL_ONLY and not each.name.endswith(skipped):
                yield self.layout.structure(each.name)
        yield from _OF_BATCHES
        yield _CHECKS
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
        yield from (self.public[what][1] for what in _ORDER if what in self.asked)

    def _uses(self, prefix: str) -> bool:
        return any(each.name == f"{prefix}_sums" for each in self.program.functions)

    def _read(self, text: o.Written, name: str = "", **more: Any) -> Function:
        structures = {"Checked": _CHECKS, **more.pop("structures", {})}
        found = read.function(text, structures, self.functions, name, **more)
        self.functions[found.name] = found
        return found

    def _forces(self) -> Function:
        record = Structure(self.layout.records["Forces"], "", o.RESULTS["forces"].members)
        known = f"stewart_{self.name}_forces"
        self.functions[known] = Function(
            known,
            "",
            (
                Argument("model", Record("")),
                Argument("motion", Record("")),
                Argument("F", Array(Real(), (LEGS,)), changed=True),
            ),
            Integer(),
            (),
        )
        structures = {"Forces": record, **self._given()}
        return self._read(
            written.forces, "find_forces", structures=structures, names={"kernel_forces": known}
        )

    def _check(self, what: str) -> Function:
        """Says where a result is not finite: vectors number by number, of matrices how many numbers."""
        out, lost, i = Name("out"), Name("lost"), Name("i")
        status, ok, bad = Member(out, "status"), Constant("OK"), Constant("NOT_FINITE")
        none, one = (As(Count(), Number(each)) for each in (0, 1))
        vectors: list[Statement] = [If(Compare("!=", status, ok), (Return(None),))]
        matrices: list[Statement] = []
        for name, count in members(what).items():
            number = Element(Member(Member(out, "of") if what in _STRUCTS else out, name), (i,))
            finite = Compare("<=", Call("size", (number,)), Constant("MAX"))
            if count <= LEGS:
                known = If(Not(finite), (Assign(status, bad), Return(None)))
                vectors.append(For("i", Number(0), Number(count), (known,)))
            else:
                counted = Assign(lost, Binary("+", lost, Select(finite, none, one)))
                matrices.append(For("i", Number(0), Number(count), (counted,)))
        if matrices:
            found = Assign(status, Select(Compare("==", lost, none), ok, bad))
            matrices = [Variable("lost", Count(), none), *matrices, found]
        return Function(
            f"check_{what}",
            "Says where a number of a result is not finite.",
            (Argument("out", Record(self.layout.records[o.RESULTS[what].name]), changed=True),),
            None,
            (*vectors, *matrices),
        )

    def _given(self) -> dict[str, Structure]:
        of = self.layout.records
        return {each: Structure(of[each], "", ()) for each in ("Model", "Motion")}

    def _kernel(self, prefix: str) -> Iterator[Structure | Function]:
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
                given=given | {"OUTSIDE": outside, "INSIDE": inside},
            )
            self.functions[found.name] = replace(found, apart=True)
            yield self.functions[found.name]
        yield self._read(
            written.sums,
            f"{prefix}_sums",
            structures=structures | {"Checked": _CHECKS},
            given=given | {"INPUTS": self._padding(kernel)},
            names=names,
        )

    def _pose_structure(self, prefix: str, kernel: SumKernel) -> Structure:
        given = [out.quantity for out in kernel.pose.outputs if out.quantity not in kernel.summed]
        return Structure(f"{prefix}_pose", "", tuple(stored(q, always=False) for q in given))

    def _legs_structure(self, prefix: str, kernel: SumKernel) -> Structure:
        count = sum(len(q.keys) for q in kernel.summed)
        held = [q for q in _INPUTS if q in kernel.leg.inputs] + _kept(kernel)
        return Structure(
            f"{prefix}_legs",
            "",
            (
                Field("sum", Array(Real(), (count, LANES))),
                *(stored(q, LANES, always=False) for q in held),
                Field("checked", Record(_CHECKS.name)),
                Field("status", Integer()),
            ),
            aligned=True,
        )

    def _pose_body(self, kernel: SumKernel) -> tuple[Statement, ...]:
        block = kernel.pose
        given = [out for out in block.outputs if out.quantity not in kernel.summed]
        return (
            *loaded(block, lambda q: member("at" if q in n.MOTION else "model", q)),
            *steps_of(block.steps),
            *stores(given, lambda q: member("out", q)),
            *set_in_order(Name("summed"), _sums(kernel, block)),
        )

    def _leg_body(
        self, kernel: SumKernel, block: Block
    ) -> tuple[tuple[Statement, ...], tuple[Statement, ...]]:
        """What all legs share, and what is done for each."""

        def place(q: Quantity) -> Place:
            if q in _INPUTS:
                return member("out", q, LANE)
            if q in self.model.leg_constants():
                return member("model", q, LANE)
            owner = "at" if q in n.MOTION else "model" if q in self.model.platform_constants() else "pose"
            return member(owner, q)

        outside, inside = parted(loaded(block, place, n.t, n.b))
        kept = [out for out in block.outputs if out.quantity in _kept(kernel)]
        return outside, (
            *inside,
            *steps_of(block.steps),
            *set_in_order(Member(Name("out"), "sum"), _sums(kernel, block), LANE),
            *stores(kept, lambda q: member("out", q, LANE)),
            *_checks(block),
        )

    def _padding(self, kernel: SumKernel) -> tuple[Statement, ...]:
        """The last two lanes of what the legs are given repeat leg 6."""
        lane, sixth = Name("l"), Number(LEGS - 1)
        parts = [
            (member("legs", q, lane).part(q, i), member("legs", q, sixth).part(q, i))
            for q in _INPUTS
            if q in kernel.leg.inputs
            for i in range(len(q.keys))
        ]
        body = tuple(Assign(to, of) for to, of in parts)
        return (For("l", Number(LEGS), Number(LANES), body),) if body else ()


def _kept(kernel: SumKernel) -> list[Quantity]:
    checked = (n.q, n.L, n.k3)
    return [out.quantity for out in kernel.leg.outputs if out.quantity not in (*kernel.summed, *checked)]


def _offsets(summed: tuple[Quantity, ...]) -> dict[str, int]:
    counts = [len(q.keys) for q in summed]
    return {q.name: sum(counts[:i]) for i, q in enumerate(summed)}


def _sums(kernel: SumKernel, block: Block) -> list[sp.Expr]:
    """Each number that the block adds, in the order of the sums."""
    given = exprs_of(block)
    return [expr for q in kernel.summed for expr in given[q]]


def _checks(block: Block) -> tuple[Statement, ...]:
    """What is wrong with a leg, in its lane."""
    given, checked = exprs_of(block), Member(Name("out"), "checked")

    def of_lane(name: str) -> Expression:
        return Element(Member(checked, name), (LANE,))

    return (
        *reach([*given[n.q], *n.t.symbols, *n.b.symbols]),
        Assign(of_lane("reach"), Name("reach")),
        *(Assign(of_lane(q.name), expression(given[q][0])) for q in (n.L, n.k3)),
        *suspicion(block, Number(0.0), of_lane("bad"), "ROUNDING", "POLE_SINE"),
    )
