"""The source of the closed form in C: legs in lanes, their sums, functions of one pose and of many."""

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from ..kernel import outputs as o
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
from ..kernel.shared import shared
from ..kernel.tree import nodes as t
from ..kernel.tree import read
from ..kernel.tree.legs_in_lanes import Layout
from ..kernel.tree.lower import expression, steps_of
from ..kernel.tree.settle import settled
from ..kernel.written import motion_lanes as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import GIVEN, SumKernel
from ..print.c import C
from ..print.template import filled
from ..program.block import Block, Quantity
from .closed_form import (
    FUNCTIONS,
    LANES,
    LEGS,
    MODEL_ONLY,
    OF_BATCHES,
    ORDER,
    PARTS,
    STRUCTS,
    asked_for,
    interface,
    members,
)
from .shared import SIZES, SOLVE, top

_CHECKS = t.Structure(
    "leg_checks",
    "What tells whether a leg is fit to be computed; bad: 1 where it is not, else 0.",
    tuple(t.Field(each, t.Array(t.Real(), (LANES,))) for each in ("L", "reach", "k3", "bad")),
)

_ADD_LEGS = t.Function(
    "add_legs",
    "",
    (
        t.Argument("lanes", t.Array(t.Real(), (1, LANES))),
        t.Argument("count", t.Integer()),
        t.Argument("sum", t.Array(t.Real(), (1,)), changed=True),
    ),
    None,
    (),
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
    made = _Source(kernels, model, asked_for(functions)).parts()
    parts = (settled(each) if isinstance(each, t.Function) else each for each in made)
    return C(sizes=SIZES).source(before, *parts)


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
        yield from (self.public[what][1] for what in ORDER if what in self.asked)

    def _uses(self, prefix: str) -> bool:
        return any(each.name == f"{prefix}_sums" for each in self.program.functions)

    def _read(self, text: o.Written, name: str = "", **more: Any) -> t.Function:
        structures = {"Checked": _CHECKS, **more.pop("structures", {})}
        found = read.function(text, structures, self.functions, name, **more)
        self.functions[found.name] = found
        return found

    def _forces(self) -> t.Function:
        record = t.Structure(self.layout.records["Forces"], "", o.RESULTS["forces"].members)
        known = f"stewart_{self.name}_forces"
        self.functions[known] = t.Function(
            known,
            "",
            (
                t.Argument("model", t.Record("")),
                t.Argument("motion", t.Record("")),
                t.Argument("F", t.Array(t.Real(), (LEGS,)), changed=True),
            ),
            t.Integer(),
            (),
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
        vectors: list[t.Statement] = [t.If(t.Compare("!=", status, ok), (t.Return(None),))]
        matrices: list[t.Statement] = []
        for name, count in members(what).items():
            number = t.Element(t.Member(t.Member(out, "of") if what in STRUCTS else out, name), (i,))
            finite = t.Compare("<=", t.Call("size", (number,)), t.Constant("MAX"))
            if count <= LEGS:
                known = t.If(t.Not(finite), (t.Assign(status, bad), t.Return(None)))
                vectors.append(t.For("i", t.Number(0), t.Number(count), (known,)))
            else:
                counted = t.Assign(lost, t.Binary("+", lost, t.Select(finite, none, one)))
                matrices.append(t.For("i", t.Number(0), t.Number(count), (counted,)))
        if matrices:
            found = t.Assign(status, t.Select(t.Compare("==", lost, none), ok, bad))
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

    def _pose_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        given = [out.quantity for out in kernel.pose.outputs if out.quantity not in kernel.summed]
        return t.Structure(f"{prefix}_pose", "", tuple(stored(q, always=False) for q in given))

    def _legs_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        count = sum(len(q.keys) for q in kernel.summed)
        held = [q for q in GIVEN if q in kernel.leg.inputs] + _kept(kernel)
        return t.Structure(
            f"{prefix}_legs",
            "",
            (
                t.Field("sum", t.Array(t.Real(), (count, LANES))),
                *(stored(q, LANES, always=False) for q in held),
                t.Field("checked", t.Record(_CHECKS.name)),
                t.Field("status", t.Integer()),
            ),
            aligned=True,
        )

    def _pose_body(self, kernel: SumKernel) -> tuple[t.Statement, ...]:
        block = kernel.pose
        given = [out for out in block.outputs if out.quantity not in kernel.summed]
        return (
            *loaded(block, lambda q: member("at" if q in n.MOTION else "model", q)),
            *steps_of(block.steps),
            *stores(given, lambda q: member("out", q)),
            *set_in_order(t.Name("summed"), _sums(kernel, block)),
        )

    def _leg_body(
        self, kernel: SumKernel, block: Block
    ) -> tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]:
        """What all legs share, and what is done for each."""

        def place(q: Quantity) -> Place:
            if q in GIVEN:
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
            *set_in_order(t.Member(t.Name("out"), "sum"), _sums(kernel, block), LANE),
            *stores(kept, lambda q: member("out", q, LANE)),
            *_checks(block),
        )

    def _padding(self, kernel: SumKernel) -> tuple[t.Statement, ...]:
        """The last two lanes of what the legs are given repeat leg 6."""
        lane, sixth = t.Name("l"), t.Number(LEGS - 1)
        parts = [
            (member("legs", q, lane).part(q, i), member("legs", q, sixth).part(q, i))
            for q in GIVEN
            if q in kernel.leg.inputs
            for i in range(len(q.keys))
        ]
        body = tuple(t.Assign(to, of) for to, of in parts)
        return (t.For("l", t.Number(LEGS), t.Number(LANES), body),) if body else ()


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


def _checks(block: Block) -> tuple[t.Statement, ...]:
    """What is wrong with a leg, in its lane."""
    given, checked = exprs_of(block), t.Member(t.Name("out"), "checked")

    def of_lane(name: str) -> t.Expression:
        return t.Element(t.Member(checked, name), (LANE,))

    return (
        *reach([*given[n.q], *n.t.symbols, *n.b.symbols]),
        t.Assign(of_lane("reach"), t.Name("reach")),
        *(t.Assign(of_lane(q.name), expression(given[q][0])) for q in (n.L, n.k3)),
        *suspicion(block, t.Number(0.0), of_lane("bad"), "ROUNDING", "JOINT_SINGULAR_SINE"),
    )
