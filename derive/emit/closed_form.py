"""C99 files of the closed form: equations of motion, bias, forward dynamics, derivatives, linearization.

The trees of ``kernel.outputs`` are printed with the legs in lanes (``trace.legs_in_lanes``), and use
the prepared model of the force kernel. Parts that exist only in C are in ``kernel.written.motion``, and
batches in ``closed_form_blocks``.
"""

from collections.abc import Collection, Iterator
from dataclasses import replace

import sympy as sp

from ..kernel import layouts as lay
from ..kernel import outputs as o
from ..kernel.written.motion import closed_form_results as results
from ..kernel.written.motion import lanes as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import GIVEN
from ..mechanics.closed_form.terms import SumKernel
from ..print.c import C
from ..print.template import filled
from ..program.block import Block, Operations, Quantity
from ..trace import nodes as t
from ..trace import read
from ..trace.decided_selections import settled
from ..trace.legs_in_lanes import Layout
from ..trace.lower import expression, steps_of
from . import closed_form_blocks as blocks
from .closed_form_blocks import CHECKS, LEGS
from .closed_form_interface import OF_BATCHES, PARTS, STRUCTS, arrays_of, interface, members, struct_of
from .shared import LANES as HEADER
from .shared import SIZES, header, top

FUNCTIONS = tuple(each for each in o.OUTPUTS if each != o.FORCES)
"""Functions that the emitted file can contain, in the order of its declarations."""

ORDER = (*STRUCTS, *(each for each in FUNCTIONS if each not in STRUCTS))
MODEL_ONLY = ("Leg", "Robot", "LegConstants", "Added", "Platform", "Model", "Motion")


def files(
    kernels: tuple[SumKernel, ...], model: ForceKernel, version: str, functions: Collection[str] = FUNCTIONS
) -> dict[str, str]:
    """Return ``stewart_<kernel>_motion.h`` and ``.c`` with the functions and their dependencies.

    Parameters
    ----------
    kernels : tuple of SumKernel
        At least the kernels whose sums the functions use.
    functions : collection of str
        Functions out of FUNCTIONS.
    """
    asked = [what for what in FUNCTIONS if what in functions]
    file = f"stewart_{model.formulation.kernel_name}_motion"
    before = "\n".join([top(file, version, HEADER), filled("motion.c")])
    made = _Source(kernels, model, asked)
    parts = [settled(each) if isinstance(each, t.Function) else each for each in made.parts()]
    texts = _header(made, kernels, version)
    return texts | {f"{file}.c": C(made.functions.values(), SIZES).source(before, *parts)}


def _header(made: "_Source", kernels: tuple[SumKernel, ...], version: str) -> dict[str, str]:
    """Return the header: description, operations, declarations."""
    asked, public = made.asked, made.public
    own = {each for what in asked for each in o.sums_used((what,), deep=False)}
    rows = ["Operations per pose without linear solver"]
    rows += [f"{kernel.name:17s} {sum_operations(kernel)}" for kernel in kernels if kernel.name in own]
    printer, structs = C(), [what for what in asked if what in STRUCTS]
    says = [
        "Results of `count` poses. A pointer may be null if its output is not needed.",
        *[""] * len(structs),
    ]
    arrays = map(arrays_of, structs, says)
    return header(
        "motion.h",
        f"stewart_{made.name}_motion",
        version,
        rotors=made.model.formulation.drive,
        included=f"stewart_{made.name}_forces.h",
        name=made.name,
        read="are read only by `derivatives`." if "derivatives" in asked else "are not read.",
        operations="\n".join(f" * {row}" for row in rows),
        structs=printer.interface(*map(struct_of, structs), *arrays),
        one_pose="\n".join(line for what in asked for line in printer.declaration(public[what][0])),
        forced="F is [count][6]. " if set(asked) & set(o.FORCED) else "",
        batches="\n".join(
            line for what in ORDER if what in asked for line in printer.declaration(public[what][1])
        ),
    )


def sum_operations(kernel: SumKernel) -> Operations:
    """Count the operations per pose without linear solver: six legs, the platform, the sums."""
    sums = LEGS * sum(len(q.keys) for q in kernel.summed)
    return LEGS * kernel.leg.operations() + kernel.pose.operations() + Operations(add=sums)


class _Source(blocks.Batches):
    """Functions of one file, in order."""

    def __init__(self, kernels: tuple[SumKernel, ...], model: ForceKernel, asked: list[str]) -> None:
        super().__init__(model, asked, kernels)
        # Functions that are common to all languages.
        texts = [each for each in asked if each not in blocks.OWN]
        texts += [f"{o.PREFIX.get(each, each)}_sums" for each in asked if each in blocks.OWN]
        texts += ["place_inertia_40"] if "derivatives" in asked else []
        self.program = o.program_in_lanes(model, kernels, texts)
        named = {each.name: each for each in self.program.structures}
        records = {each: t.snake(each) for each in named}
        records |= {each.name: f"{what}_found" for what, each in o.RESULTS.items()}
        records |= {"Apart": "apart_found", "SlopesApart": "slopes_found"}
        records |= {"Model": f"stewart_{self.name}_model", "Motion": "stewart_motion"}
        sums = {f"{o.camel(prefix)}Sums": kernel.summed for prefix, kernel in self.kernels.items()}
        self.layout = Layout(
            named,
            records,
            {each: blocks.offsets(summed) for each, summed in sums.items()},
            {each: sum(len(q.keys) for q in summed) for each, summed in sums.items()},
            {o.RESULTS[what].name: f"stewart_{what}" for what in STRUCTS},
            PARTS,
            {each: f"find_{each}" for each in o.OUTPUTS},
        )
        self.public = {what: interface(self.name, what) for what in asked}

    def parts(self) -> Iterator[str | t.Structure | t.Function]:
        """Yield structures, functions, and texts."""
        skipped = ("Pose", "Leg", "Legs", "Sums")
        for each in self.program.structures:
            if each.name not in MODEL_ONLY and not each.name.endswith(skipped):
                yield self.layout.structure(each.name)
        yield from OF_BATCHES
        yield CHECKS
        yield blocks.MOTION_LANES
        yield self.read(written.legs_status)
        summed = {each.name for each in self.program.functions}
        if any(each.near is not None for prefix, each in self.kernels.items() if f"{prefix}_sums" in summed):
            yield self.read(written.is_near)
        yield self.read(results.not_finite)
        for function in self.program.functions:
            if function.name.endswith("_sums"):
                yield from self._kernel(function.name.removesuffix("_sums"))
            elif function.name == "singular_status":
                continue
            elif function.name == "forces":
                yield self._forces()
            elif function.name == "accelerations_of":
                yield from self.accelerations()
            elif function.name.startswith("check_"):
                yield self._add(self._check(function.name.removeprefix("check_")))
            else:
                yield self._add(self.layout.function(function))
            if function.name in self.asked and function.name not in blocks.OWN:
                yield self._add(self.public[function.name][0])
        for what in blocks.OWN:
            if what in self.asked:
                yield from self.own(what)
        if set(blocks.OUTPUTS) & set(self.asked):
            yield from self.shared_by_blocks()
        for what in ORDER:
            if what in self.asked and what in blocks.OUTPUTS:
                yield from self.of_blocks(what, self._leg_of_poses(o.PREFIX.get(what, what)))
            elif what in self.asked:
                yield self.public[what][1]

    def _add(self, function: t.Function) -> t.Function:
        self.functions[function.name] = function
        return function

    def _forces(self) -> t.Function:
        record = t.Structure(self.layout.records["Forces"], "", o.RESULTS["forces"].members)
        names = {"kernel_forces": f"stewart_{self.name}_forces"}
        return self.read(written.forces, "find_forces", structures={"Forces": record}, names=names)

    def _check(self, what: str) -> t.Function:
        """Return a function that checks whether a result is finite.

        Vectors are checked number by number; for matrices the numbers that are not finite are counted.
        """
        lost, status, ok, bad = (
            t.Name("lost"),
            t.of("out", "status"),
            t.Constant("OK"),
            t.Constant("NOT_FINITE"),
        )
        none, one = (t.As(t.Count(), t.Number(each)) for each in (0, 1))
        vectors: list[t.Statement] = [t.If(t.Binary("!=", status, ok), (t.Return(None),))]
        matrices: list[t.Statement] = []
        for name, count in members(what).items():
            number = t.at(t.of(t.of("out", "of") if what in STRUCTS else "out", name), "i")
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
            "Sets the status if a number of a result is not finite.",
            (t.Argument("out", t.Record(self.layout.records[o.RESULTS[what].name]), changed=True),),
            None,
            (*vectors, *matrices),
        )

    def _kernel(self, prefix: str) -> Iterator[t.Structure | t.Function]:
        """Yield the functions of one kernel: the pose's part, the legs' parts, and their sum."""
        kernel = self.kernels[prefix]
        legs = {"leg": kernel.leg} | ({} if kernel.near is None else {"near": kernel.near})
        structures = {"Pose": self.pose_structure(prefix), "Legs": self.legs_structure(prefix)}
        yield from structures.values()
        count = sum(len(q.keys) for q in kernel.summed)
        given: dict[str, read.Given] = {"COUNT": count, "HAS_NEAR": int("near" in legs)}
        names = {f"{part}_terms": f"{prefix}_of_{part}" for part in ("pose", "leg", "near")}
        outside, inside = self._pose_body(kernel)
        own: dict[str, read.Given] = {"OUTSIDE": outside, "BLOCK": inside}
        pose_terms = self.read(
            written.pose_terms, names["pose_terms"], structures=structures, given=given | own
        )
        yield replace(pose_terms, inlined=True)
        for part, block in legs.items():
            outside, inside = self._leg_body(kernel, block)
            own = {"OUTSIDE": outside, "BLOCK": inside} | checks(block)
            name = f"{prefix}_of_{part}"
            yield self.read(written.leg_terms, name, apart=True, given=given | own, structures=structures)
        given |= {
            "GIVEN": lay.entries(q for q in GIVEN if q in kernel.leg.inputs),
            "MOVED": lay.entries(q for q in n.MOTION if q in kernel.pose.inputs),
        }
        yield self.read(written.sums, f"{prefix}_sums", structures=structures, given=given, names=names)

    def _leg_of_poses(self, prefix: str) -> t.Function:
        """Return the function of one leg of eight poses."""
        kernel = self.kernels[prefix]
        structures = {"Pose": self.pose_structure(prefix), "Legs": self.legs_structure(prefix)}
        _, body = self._leg_body(kernel, kernel.leg, of_block=True)
        given: dict[str, read.Given] = {"BLOCK": body} | checks(kernel.leg)
        name = f"{prefix}_leg_of_poses"
        return self.read(written.leg_of_poses, name, apart=True, given=given, structures=structures)

    def _pose_body(self, kernel: SumKernel) -> blocks.Parted:
        block = kernel.pose
        given = [out for out in block.outputs if out.quantity not in kernel.summed]

        def place(q: Quantity) -> lay.Place:
            return lay.member("at", q, lay.LANE) if q in n.MOTION else lay.member("model", q)

        outside, inside = lay.parted(lay.loaded(block, place))
        sums = (
            t.Assign(t.Element(t.Name("summed"), (t.Number(i) * t.Name("lanes") + lay.LANE,)), expression(e))
            for i, e in enumerate(_sums(kernel, block))
        )
        return outside, (
            *inside,
            *steps_of(block.steps),
            *lay.stores(given, lambda q: lay.member("out", q, lay.LANE)),
            *sums,
        )

    def _leg_body(self, kernel: SumKernel, block: Block, of_block: bool = False) -> blocks.Parted:
        """Return the statements that are common to all lanes, and the statements for each lane.

        Lanes are legs, or, in a block, poses; all statements are then for each lane.
        """
        leg = t.Name("leg") if of_block else lay.LANE

        def place(q: Quantity) -> lay.Place:
            if q in GIVEN:
                return lay.member("out", q, lay.LANE)
            if q in self.model.leg_constants():
                return lay.member("model", q, leg)
            if q in self.model.platform_constants():
                return lay.member("model", q)
            if q not in n.MOTION:
                return lay.member("pose", q, lay.LANE if of_block else t.Number(0))
            return lay.member("at", q, lay.LANE) if of_block else lay.member("motion", q)

        loads = lay.loaded(block, place, n.t, n.b)
        outside, inside = ((), loads) if of_block else lay.parted(loads)
        kept = [out for out in block.outputs if out.quantity in blocks.kept(kernel)]
        return outside, (
            *inside,
            *steps_of(block.steps),
            *lay.set_in_order(t.Member(t.Name("out"), "sum"), _sums(kernel, block), lay.LANE),
            *lay.stores(kept, lambda q: lay.member("out", q, lay.LANE)),
        )


def _sums(kernel: SumKernel, block: Block) -> list[sp.Expr]:
    """Return the numbers that the block adds, in the order of the sums."""
    given = block.exprs
    return [given[q][i] for q, i in blocks.placed(kernel.summed)]


def checks(block: Block) -> dict[str, read.Given]:
    """Return the checks of legs, as in ``layouts.checks``."""
    terms = [*block.exprs[n.q], *n.t.symbols, *n.b.symbols]
    least = t.Constant("ROUNDING") * t.Name("reach")
    return lay.largest(terms) | lay.checks(block, least, "JOINT_SINGULAR_SINE")
