"""C99 files of the force kernels for controllers, one leg after the other, with small code and stack.

The blocks are the same as in ``lanes``. The model is prepared once, or its constants are baked.
"""

from collections.abc import Iterable

import sympy as sp

from ..kernel import layouts as lay
from ..kernel import prepare as p
from ..kernel.batches import missing
from ..kernel.elimination import BY_POINTERS
from ..kernel.operations import force_operations
from ..kernel.shared import shared
from ..kernel.written import scalar as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel, joined
from ..mechanics.lumped_constants import q_1
from ..print.template import filled
from ..program.block import Block, Quantity, part_of
from ..program.order import AS_DERIVED
from ..trace import nodes as t
from ..trace.lower import expression, steps_of
from ..trace.placement import where_read
from ..trace.read import Given
from .inverse_dynamics import operations_table
from .shared import SOLVE, Part, Source, header, top

_LEAST_PIVOTS = t.signature("STEWART_LEAST_PIVOTS", t.Real(), size=t.Real())
_CLOSE = t.Field("close", t.Integer(), "1 if H may be singular to rounding because of a leg of zero length")
_LEAST = t.numbers("least", meaning="product of the pivots of H below which it may be singular to rounding")
_SIZE = t.numbers(
    "size", meaning="m: largest sum of the magnitudes of the coordinates of a base or platform point"
)


def files(kernel: ForceKernel, before: ForceKernel | None, version: str) -> dict[str, str]:
    """Return ``stewart_<kernel>_pose.h`` and ``.c``: preparation, unless baked, and one pose.

    ``before`` is the kernel without constants for a baked kernel.
    """
    made, file, folded = _Source(kernel), f"stewart_{kernel.name}_pose", ""
    if before is not None:
        count = force_operations(before, scalar_text=True).total.total
        folded = f" The constants are baked; without, a pose took {count} operations."
    texts = header(
        "forces_pose.h",
        file,
        version,
        rotors=kernel.formulation.drive,
        name=kernel.name,
        fidelity=f" * Fidelity level: {kernel.meaning or 'everything'}.{folded}",
        operations=operations_table(force_operations(kernel, scalar_text=True), None, " * "),
        declarations=made.declared(*(made.structures[name] for name in ("Leg", "Model") if before is None)),
    )
    before_it = top(file, version, SOLVE, filled("few_registers.c")) + filled("least_product.c")
    return texts | {f"{file}.c": made.printed(before_it, fused=False)}


class _Source(Source):
    def __init__(self, kernel: ForceKernel) -> None:
        self.kernel, self.baked = kernel, kernel.constants is not None
        self.of_pose = [out for out in kernel.shared.outputs if out.quantity not in lay.RIGHT_SIDE]
        self.structures = p.structures(kernel) | self._structures()
        given, model = kernel.leg.exprs, t.Name("model")
        size = kernel.size * p.per_length(kernel.size)
        self.flags = p.flags(kernel) | {
            "SIZE": t.Number(kernel.extent) if self.baked else t.Member(model, "size"),
            "LEAST": t.Call(_LEAST_PIVOTS.name, (t.Number(size),))
            if self.baked
            else t.Member(model, "least"),
        }
        self.flags |= {"model": False} if self.baked else {}
        self.flags |= {} if n.D in given else {"known": False}
        known = shared().by_name | {_LEAST_PIVOTS.name: _LEAST_PIVOTS}
        super().__init__(lay.Written(self.structures, self.flags, known))

    def _structures(self) -> dict[str, t.Structure]:
        kernel, name = self.kernel, f"stewart_{self.kernel.name}_pose"
        legs = tuple(map(lay.described, kernel.leg_constants()))
        named = (f"{name}_leg", "Constants of one leg.")
        leg = t.Structure(
            *(("leg_numbers", "Constants that differ between the legs.") if self.baked else named), legs
        )
        pose = (
            *(lay.stored(out.quantity) for out in self.of_pose),
            t.numbers("q_1", 3, meaning="platform point 1 from the reference point"),
            _CLOSE,
        )
        sizes = (t.numbers("L"), t.numbers("reach"), t.numbers("arm", 3), t.numbers("column", 6))
        of_legs, platform = t.Array(t.Record(leg.name), (6,)), map(lay.described, kernel.platform_constants())
        model = (t.Field("leg", of_legs), _SIZE, *platform, _LEAST, p.PER_LENGTH)
        prepared = map(lay.stored, kernel.prepare_platform.made)
        return {
            "Leg": leg,
            "Platform": t.Structure("platform_constants", "Constants of the platform.", tuple(prepared)),
            "PoseTerms": t.Structure("pose_terms", "Terms of the pose that are common to all legs.", pose),
            "LegSizes": t.Structure("leg_sizes", "Magnitudes for the check of a zero-length leg.", sizes),
            "Model": t.Structure(f"{name}_model", p.model_says((*legs, *model)), model),
        }

    def _parts(self) -> Iterable[Part]:
        kernel, read, name = self.kernel, self.texts.function, f"stewart_{self.kernel.name}_pose"
        if self.baked:
            yield p.literals(kernel)
            yield self._table()
        else:
            yield self.structures["Platform"]
            yield from p.preparation(self.texts, kernel)
            yield p.size_of(self.texts, by_legs=True)
            yield read(written.least_pivots)
            yield read(written.size_sum)
            held = {"OF_LEG": kernel.leg_constants(), "OF_PLATFORM": kernel.platform_constants()}
            given: dict[str, Given] = {each: lay.entries(constants) for each, constants in held.items()}
            yield read(
                written.prepare, f"{name}_prepare", public=True, given=given, **p.prepared_words(kernel)
            )
        yield self.structures["PoseTerms"]
        yield read(written.pose_of, given={"SHARED": self._shared()}, count=kernel.shared.operations())
        yield self.structures["LegSizes"]
        yield read(written.leg_closely, apart=True, given=self._closely())
        yield read(written.short_status, apart=True)
        yield read(written.shift_of, given=self._shift())
        if kernel.leg_near_singular is not None:
            yield self._leg(kernel.leg_near_singular, near=True)
        yield self._leg(kernel.leg, near=False)
        if p.is_scaled(kernel):
            yield read(written.scale_moments)
        yield read(written.solve, given=BY_POINTERS)
        yield read(written.pose_status, apart=True)
        given = missing(("motion", "F") if self.baked else ("model", "motion", "F"))
        yield read(written.pose_forces, f"{name}_forces", public=True, given=given, **p.motion_words(kernel))

    # ------------------------------------------------------------ constants

    def _table(self) -> t.Table:
        """Print the constants that differ between the legs of a baked kernel."""
        assert self.kernel.constants is not None
        columns = [self.kernel.constants[q] for q in self.kernel.leg_constants()]
        return t.Table("legs", self.structures["Leg"], tuple(zip(*columns, strict=True)))

    # ------------------------------------------------------------ blocks

    def _layout(self, q: Quantity) -> lay.Place | t.Name:
        """Return the location of an input of a leg's block."""
        if q in n.MOTION:
            return lay.member("at", q)
        if q == q_1 or any(out.quantity == q for out in self.of_pose):
            return lay.member("pose", q)
        if q in self.kernel.literals():
            return t.Name(p.literal(q))
        return lay.member("leg" if q in self.kernel.leg_constants() else "model", q)

    def _shared(self) -> tuple[t.Statement, ...]:
        block = self.kernel.shared
        right = block.exprs
        zeros = (sp.Integer(0),) * 3
        sides = [expr for q in lay.RIGHT_SIDE for expr in right.get(q, zeros)]
        return (
            *lay.lines(block, self._layout, ready=AS_DERIVED),
            *lay.stores(self.of_pose, lambda q: lay.member("out", q)),
            *(t.Assign(t.at("A", i, 6), expression(expr)) for i, expr in enumerate(sides)),
        )

    def _closely(self) -> dict[str, Given]:
        """Return the words of the rarely used check of a leg: length, magnitude of its terms, column of H."""
        kernel = self.kernel
        exprs = kernel.leg.exprs
        # In a baked kernel a coordinate of b that is zero for all legs is none of its inputs.
        around = [q for q in kernel.leg.inputs if q in (n.t, n.b) or q.name in n.b.names]
        block = part_of(joined(kernel.leg, kernel.moments), n.q, n.L, n.H_force, n.H_moment)
        given = block.exprs
        arms = [expression(e) - t.Name(f"q_1_{axis}") for e, axis in zip(given[n.q], "xyz", strict=True)]
        out = t.Name("out")
        places = (t.Element(t.Member(out, "arm"), (t.Number(i),)) for i in range(3))
        column = [*given[n.H_force], *given[n.H_moment]]
        return {
            "COLUMN": (
                *lay.loaded(
                    block, lambda q: lay.Place(t.Name("q_1")) if q == q_1 else self._layout(q), *around
                ),
                *steps_of(block.steps, AS_DERIVED),
            ),
            **lay.largest([*exprs[n.q], *(symbol for q in around for symbol in q.symbols)]),
            "SIZES": (
                *(t.Assign(to, arm) for to, arm in zip(places, arms, strict=True)),
                t.Assign(t.Member(out, "L"), expression(exprs[n.L][0])),
                *lay.set_in_order(t.Member(out, "column"), column),
            ),
        }

    def _shift(self) -> dict[str, Given]:
        """Return the words that move c to platform point 1, which leg 1 computes again."""
        (moved,) = self.kernel.shift.outputs
        block = part_of(self.kernel.leg, n.q)
        (point,) = block.outputs
        names = (*q_1.names, *n.c_force.names, *n.c_moment.names)
        places = (*map(expression, point.exprs), *(t.at("A", i, 6) for i in range(6)))
        known = map(t.Let, names, places)
        shifted = (t.Assign(t.at("A", i + 3, 6), expression(e)) for i, e in enumerate(moved.exprs))
        first = lay.lines(block, self._layout, ready=AS_DERIVED)
        return {
            "FIRST": (*first, *lay.set_in_order(t.of("pose", "q_1"), point.exprs)),
            "SHIFT": (*known, *shifted),
        }

    def _leg(self, own: Block, near: bool) -> t.Function:
        """Return the function of one leg, which stores its column of H and its D and adds its part of c."""
        kernel = self.kernel
        block = joined(own, kernel.moments)
        exprs, used = block.exprs, lay.names_used(block)
        before, after = lay.parted_steps(own, (*exprs[n.L], *exprs.get(n.k3, ())))
        loads = lay.loads((q for q in block.inputs if q != q_1), used, self._layout)
        first, loads = where_read(loads, steps_of(before, AS_DERIVED))
        then, loads = where_read(loads, steps_of(after, AS_DERIVED))
        alone = near or kernel.leg_near_singular is None
        given: dict[str, Given] = {
            "NEAR": int(near),
            "LENGTH": expression(exprs[n.L][0]),
            "SINE": expression(exprs[n.k3][0]) if n.k3 in exprs else 0,
            "LEAST_SINE": t.Name("STEWART_JOINT_SINGULAR_SINE" if alone else "STEWART_NEAR_JOINT_SINGULAR"),
            "BEFORE": first,
            "AFTER": then,
            "MOMENTS": (
                *loads,
                *lay.loads([q_1], used, self._layout),
                *steps_of(block.steps[len(own.steps) :], AS_DERIVED),
                *lay.assembled(exprs, lambda i: t.at("A", i, "column"), lambda i: t.at("A", i, 6)),
                *(t.Assign(t.Name("known"), expression(e)) for e in exprs.get(n.D, ())),
            ),
        }
        given |= {"least": False} if near else {}
        count = own.operations() + kernel.moments.operations()
        name = "leg_near_singular" if near else "leg_of"
        return self.texts.function(written.leg_of, name, apart=near, given=given, count=count)
