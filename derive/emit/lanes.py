"""C99 files of the force kernels for speed, with legs or poses in vector lanes.

A single pose uses six of eight lanes for its legs. A batch uses eight lanes for poses, or sixteen in float.
In both cases a block is the body of a loop over lanes. Compilers vectorize this loop; otherwise it is
portable C.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import sympy as sp

from ..kernel import layouts as lay
from ..kernel import prepare as p
from ..kernel.batches import BATCH, LOADS, MOTIONS, loaded_block, missing
from ..kernel.operations import force_operations
from ..kernel.shared import by_shape, legs_in_lanes, shared
from ..kernel.tree import nodes as t
from ..kernel.tree.fused import with_products_in_sums
from ..kernel.tree.lower import expression, steps_of
from ..kernel.tree.read import LANES, POSES, Given
from ..kernel.written import lanes as written
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.lumped_constants import arm_c
from ..print.template import filled
from ..program.block import Block, Quantity
from ..program.order import ready_in
from .inverse_dynamics import operations_table
from .shared import LANES as HEADER
from .shared import Part, Source, header, top

_ROWS = {n.H_force: 0, n.H_moment: 3}
"""First row of a part of a column of H."""
_BASE_REACH = t.Field("base_reach", t.Real(), "m: largest magnitude of a coordinate of the base points")
_LANES_SAY = " In arrays that end with [8] the last index is the leg; the values 7 and 8 repeat leg 6."
# Least number of operations after a leg's roots for which computing the next leg's roots first is faster.
_WORTH_HANDING_ON = 40
_WITHOUT_D = "#define STEWART_FORCE(D, x) (-(x))\n"


def files(
    kernel: ForceKernel,
    version: str,
    frictionless: ForceKernel | None = None,
    before: ForceKernel | None = None,
) -> dict[str, str]:
    """Return ``stewart_<kernel>_forces.h`` and ``.c``: preparation, one pose, batch.

    Parameters
    ----------
    frictionless : ForceKernel, optional
        The kernel without friction, for its count of operations.
    before : ForceKernel, optional
        The kernel without constants, for a baked kernel.
    """
    made, file = _Source(kernel), f"stewart_{kernel.name}_forces"
    title, says = "from prepared constants, optimized for speed.", f"Fidelity level: {kernel.meaning}."
    if not kernel.friction and n.v in kernel.used_motion() and "friction" not in kernel.meaning:
        says += " The joints have no friction."
    if before is not None:
        title, count = "of one robot with baked constants.", force_operations(before).total.total
        says += f" Without baked constants, a pose took {count} operations."
    plain = None if frictionless is None else force_operations(frictionless)
    robot, leg = p.raw_structures(kernel)
    # These kernels are prepared from more constants than ``stewart_robot`` contains.
    own = [] if robot is p.ROBOT else [leg, robot]
    texts = header(
        "forces.h",
        file,
        version,
        rotors=kernel.formulation.drive,
        name=kernel.name,
        title=title,
        says="" if kernel.fidelity == "general" and before is None else f" * {says}\n *\n",
        operations=operations_table(force_operations(kernel), plain, " * "),
        declarations=made.declared(*([] if made.baked else [*own, made.structures["Model"]])),
    )
    defined = filled("registers.c") + ("" if n.D in made.given else _WITHOUT_D)
    return texts | {f"{file}.c": made.printed(top(file, version, HEADER, defined))}


def model_numbers(kernel: ForceKernel) -> int:
    """Return the count of numbers in ``stewart_<kernel>_model``."""
    of_legs = LANES * sum(len(q.keys) for q in kernel.leg_constants())
    return of_legs + sum(len(q.keys) for q in kernel.platform_constants()) + 3


def base_points(kernel: ForceKernel) -> tuple[Quantity, ...]:
    """Return the constants that are base points; in a baked kernel, components that differ between legs."""
    if kernel.constants is None:
        return (n.b,)
    return tuple(part for part in kernel.leg_constants() if part.name in n.b.names)


def reach_terms(kernel: ForceKernel) -> tuple[list[sp.Expr], tuple[Quantity, ...]]:
    """Return the components of the vectors whose sum is S, and the inputs among them."""
    inputs = (n.t, *base_points(kernel))
    symbols = (symbol for q in inputs for symbol in q.symbols)
    return [*kernel.leg.exprs[n.q], *symbols], inputs


def as_far_as_roots(leg: Block) -> tuple[Block, Block]:
    """Split a leg into the steps up to the square roots and their reciprocals, and the other steps."""
    half = sp.Rational(1, 2)
    rooted = [step for step in leg.steps if any(each.exp == half for each in step.expr.atoms(sp.Pow))]
    before, _ = lay.parted_steps(leg, (step.symbol for step in rooted))
    needed = {step.name for step in before}
    reciprocals = [step for step in leg.steps if step.expr.is_Pow and step.expr.exp == -1]
    needed |= {step.name for step in reciprocals if {s.name for s in step.expr.free_symbols} <= needed}
    first = tuple(step for step in leg.steps if step.name in needed)
    others = tuple(step for step in leg.steps if step.name not in needed)
    parts = replace(leg, steps=first, outputs=()), replace(leg, steps=others)
    roots, rest = (replace(part, inputs=part.used_inputs()) for part in parts)
    return roots, rest


class _Source(Source):
    def __init__(self, kernel: ForceKernel) -> None:
        self.kernel, self.baked = kernel, kernel.constants is not None
        self.of_pose = kernel.shared.made
        self.given = kernel.leg.exprs
        self.roots, self.from_roots = as_far_as_roots(kernel.leg)
        self.ahead = self.from_roots.operations().total > _WORTH_HANDING_ON
        if not self.ahead:
            self.from_roots = kernel.leg
        read = lay.names_used(self.from_roots)
        self.handed_on = [step.name for step in self.roots.steps if self.ahead and step.name in read]
        self.structures = p.structures(kernel) | self._structures()
        self.flags = p.flags(kernel) | {
            "ABOUT_TIP": int(kernel.about_tip),
            "AHEAD": int(self.ahead),
            "HAS_C": int(n.c_force in self.given),
            "HAS_C_MOMENT": int(n.c_moment in self.given),
        }
        known = shared(kernel.about_tip).by_name
        known |= by_shape(known, self.given) if kernel.about_tip else {}
        super().__init__(lay.Written(self.structures, self.flags, known))

    # ------------------------------------------------------------ structures

    def _structures(self) -> dict[str, t.Structure]:
        kernel = self.kernel
        motion = kernel.used_motion()
        blocks = (kernel.leg, kernel.moments) if kernel.about_tip else (kernel.leg,)
        terms = [q for block in blocks for q in block.made]
        terms = [q for q in terms if q not in (*lay.CHECKED, *_ROWS)]
        kept = [lay.stored(q, POSES) for q in (n.q, *lay.RIGHT_SIDE) if q in self.given]
        says = "Constants that differ between the legs; the last two lanes repeat leg 6."
        own = [] if self.baked else [p.PER_LENGTH, p.ARM_CUBE, _BASE_REACH]
        model = (
            *(lay.described(q, LANES) for q in kernel.leg_constants()),
            *map(lay.described, kernel.platform_constants()),
            *own,
        )
        if not self.baked:
            says = p.model_says(model, _LANES_SAY)
        of_pose = (
            *(lay.stored(q, POSES) for q in self.of_pose if q not in lay.RIGHT_SIDE),
            t.numbers("least_L", POSES, meaning="m: length below which a leg must be checked"),
        )
        of_legs = (
            t.numbers("A", 6, LANES, meaning="H, one column for each leg"),
            *(lay.stored(q, LANES) for q in (n.q, *terms)),
            *(t.numbers(name, LANES) for name in ("L", "reach", *(["k3"] if n.k3 in self.given else []))),
            t.numbers("bad", LANES, meaning="1 if the leg must be checked, else 0"),
        )
        block = (
            t.numbers("column", 7, 6, POSES, meaning="[H | c], column by column"),
            *([t.numbers("D", 6, POSES)] if n.D in self.given else []),
            t.numbers("F", 6, POSES),
            t.numbers("bad", POSES, meaning="1 if a leg, a pivot, or a force must be checked, else 0"),
        )
        roots = (t.numbers(name, POSES) for name in self.handed_on)
        of_pose_alone = tuple(map(lay.stored, (*self.of_pose, *kernel.shift.made)))
        aligned: dict[str, tuple[str, str, Iterable[t.Field]]] = {
            "MotionLanes": (
                "motion_lanes",
                "Motions of the poses of a block, component by component.",
                (lay.stored(q, POSES) for q in motion),
            ),
            "SharedLanes": ("shared_lanes", "", of_pose),
            "LegRoots": ("leg_roots", "A leg of the poses of a block up to its square roots.", roots),
            "Roots": ("roots_of_legs", "", [t.Field("leg", t.Array(t.Record("leg_roots"), (6,)))]),
            "Block": ("block", "Intermediate results of a block of poses.", block),
            "LegBlock": ("leg_block", "Terms of a leg that the moments require.", kept),
        }
        return {
            "Model": t.Structure(f"stewart_{kernel.name}_model", says, model),
            "Motions": MOTIONS,
            "SharedTerms": t.Structure(
                "shared_terms", "Terms of a pose that are common to all legs.", of_pose_alone
            ),
            "LegLanes": t.Structure("leg_lanes", "The legs of one pose.", of_legs),
            **{
                key: t.Structure(name, meaning, tuple(held), aligned=True)
                for key, (name, meaning, held) in aligned.items()
            },
        }

    # ------------------------------------------------------------ functions

    def _parts(self) -> Iterable[Part]:
        kernel, read, name = self.kernel, self.texts.function, f"stewart_{self.kernel.name}"
        made = self.structures
        yield from (made[each] for each in ("MotionLanes", "SharedTerms", "SharedLanes", "LegLanes"))
        if self.baked:
            yield p.literals(kernel)
            yield self._table()
        else:
            yield from p.preparation(self.texts, kernel, t.Name("i"))
            yield p.size_of(self.texts, by_legs=False)
            given = p.HANDED_OVER | {"COUNT": model_numbers(kernel)}
            yield read(
                written.prepare, f"{name}_prepare", public=True, given=given, **p.prepared_words(kernel)
            )
        shared = with_products_in_sums(
            (*lay.lines(kernel.shared, self._place("at")), *lay.stores(kernel.shared.outputs, _out()))
        )
        yield read(written.shared_of_pose, given={"SHARED": shared}, count=kernel.shared.operations())
        yield from self._legs_of_pose()
        of_pose = legs_in_lanes("legs", "A") | self.flags | self._public("motion", "F")
        of_pose |= {"LEGS_C": self._has(n.c_force, "legs"), "ARM_C": self._has(n.c_force, "legs", arm_c)}
        words = p.motion_words(kernel)
        yield read(written.forces, f"{name}_forces", public=True, given=of_pose, **words)
        yield made["Block"]
        if kernel.about_tip:
            yield made["LegBlock"]
        if self.ahead:
            yield from (made[each] for each in ("LegRoots", "Roots"))
        yield self._shared_of_block()
        if self.ahead:
            yield self._roots_of_leg()
        yield self._leg_of_block()
        yield from self._batch(name, words)

    def _table(self) -> t.Table:
        """Print the constants of a baked kernel; the last two lanes repeat leg 6."""
        assert self.kernel.constants is not None
        columns = [self.kernel.constants[q] for q in self.kernel.leg_constants()]
        row = tuple(value for values in columns for value in (*values, values[-1], values[-1]))
        return t.Table("numbers", self.structures["Model"], (row,))

    def _public(
        self, *needed: str, quantities: Iterable[Quantity] = (), tests: Iterable[t.Expression] = ()
    ) -> dict[str, Given]:
        """Return the checks of public functions, and the omission of the model in baked kernels."""
        pointers = needed if self.baked else ("model", *needed)
        return missing(pointers, tuple(quantities), *tests) | self._without()

    def _place(self, motion: str, *lane: t.Expression, leg: t.Expression | None = None) -> lay.Layout:
        """Return the layout of the blocks' inputs.

        Parameters
        ----------
        motion : str
            Argument that contains the motion.
        lane : Expression
            Lane of motion and pose.
        leg : Expression, optional
            Index of the legs' constants.
        """
        of_legs = () if leg is None else (leg,)
        literals = self.kernel.literals()

        def place(q: Quantity) -> lay.Place | t.Name:
            if q in n.MOTION:
                return lay.member(motion, q, *lane)
            if q in self.of_pose:
                return lay.member("shared", q, *lane)
            if q in literals:
                return t.Name(p.literal(q))
            return lay.member("model", q, *(() if q in self.kernel.platform_constants() else of_legs))

        return place

    # ------------------------------------------------------------ one pose

    def _legs_of_pose(self) -> Iterable[t.Function]:
        """Yield the legs of a pose, and the code path near the joint singularity if the kernel has one."""
        kernel, near = self.kernel, self.kernel.leg_near_singular
        least = "JOINT_SINGULAR_SINE" if near is None else "NEAR_JOINT_SINGULAR"
        yield self._legs(kernel.leg, "legs_of_pose", least, "Computes the legs of one pose in lanes")
        if near is not None:
            says = "Computes the legs of a pose in which a leg is near its joint singularity"
            yield self._legs(near, "legs_near_singular", "JOINT_SINGULAR_SINE", says)

    def _legs(self, leg: Block, name: str, least: str, says: str) -> t.Function:
        """Return the block of a leg as the body of a loop over the legs of a pose."""
        terms, more = reach_terms(self.kernel)
        outside, inside = lay.parted(lay.loaded(leg, self._place("at", leg=lay.LANE), *more))
        kept = [out for out in leg.outputs if out.quantity not in lay.CHECKED]
        kept += [out for out in leg.outputs if out.quantity == n.q]
        body = (*inside, *steps_of(leg.steps), *lay.stores(kept, _of_legs("out")))
        given: dict[str, Given] = {"OUTSIDE": outside, "BLOCK": body, **lay.largest(terms)}
        given |= lay.checks(leg, t.Constant("SHORT_SHARE") * t.Name("reach"), least)
        return self.texts.function(written.legs_of_pose, name, given=given, says=says, count=leg.operations())

    # ------------------------------------------------------------ poses of a block

    def _shared_of_block(self) -> t.Function:
        block = self.kernel.shared
        outside, inside = lay.parted(lay.loaded(block, self._place("at", lay.LANE)))
        kept = [out for out in block.outputs if out.quantity not in lay.RIGHT_SIDE]
        right = [e for out in block.outputs if out.quantity in lay.RIGHT_SIDE for e in out.exprs]
        body = (
            *inside,
            *steps_of(block.steps),
            *lay.stores(kept, _out(lay.LANE)),
            *lay.set_in_order(t.Name("c"), right, lay.LANE),
        )
        inside = with_products_in_sums(body)
        given: dict[str, Given] = {"OUTSIDE": outside, "INSIDE": inside, "BASE_REACH": self._base_reach()}
        return self.texts.function(written.shared_of_block, given=given)

    def _base_reach(self) -> t.Expression:
        constants = self.kernel.constants
        if constants is None:
            return t.of("model", _BASE_REACH.name)
        sizes = (abs(value) for q in base_points(self.kernel) for value in constants[q])
        return t.Number(max(sizes, default=0.0))

    def _roots_of_leg(self) -> t.Function:
        """Return the steps of a leg up to its roots, and store the results that other steps read."""
        leg = self.roots
        loads = lay.loaded(leg, self._place("at", lay.LANE, leg=t.Name("leg")))
        steps, _ = lay.where_read(loads, steps_of(leg.steps, ready_in(self.kernel.leg.steps)))
        kept = (t.Assign(t.at(t.of("out", name), "l"), t.Name(name)) for name in self.handed_on)
        given: dict[str, Given] = {"BLOCK": (*steps, *kept)}
        return self.texts.function(written.roots_of_leg, given=given, count=leg.operations())

    def _leg_of_block(self) -> t.Function:
        """Return the other steps of a leg as the body of a loop over the poses of a block."""
        kernel, exprs = self.kernel, self.given
        leg, about_tip = self.from_roots, kernel.about_tip
        loads = lay.loaded(leg, self._place("at", lay.LANE, leg=t.Name("leg")))
        found = (t.Let(name, t.at(t.of("roots", name), "l")) for name in self.handed_on)
        steps, loads = lay.where_read((*found, *loads), steps_of(leg.steps, ready_in(kernel.leg.steps)))
        own = [out for out in leg.outputs if about_tip and out.quantity in (n.q, *lay.RIGHT_SIDE)]
        kept = {out.quantity for out in own}
        body = (
            *steps,
            *loads,
            *lay.assembled({q: e for q, e in exprs.items() if q not in kept}),
            *lay.stores(own, lambda q: lay.member("own", q, lay.LANE)),
            *(t.Assign(t.at("known", "l"), expression(e)) for e in exprs.get(n.D, ())),
        )
        least = "JOINT_SINGULAR_SINE" if kernel.leg_near_singular is None else "NEAR_JOINT_SINGULAR"
        given: dict[str, Given] = {"BLOCK": body, "c" if about_tip else "own": False}
        given |= lay.checks(leg, t.at(t.of("shared", "least_L"), "l"), least)
        given |= {} if n.D in exprs else {"known": False}
        given |= {} if self.ahead else {"roots": False}
        says = "Computes the rest of a leg" if self.ahead else "Computes a leg of the poses of a block"
        return self.texts.function(written.leg_of_block, given=given, says=says, count=leg.operations())

    def _batch(self, name: str, words: dict[str, Any]) -> Iterable[str | t.Function]:
        """Yield the linear solver of a block, and the loop over blocks."""
        kernel, read = self.kernel, self.texts.function
        about_tip, has_d = kernel.about_tip, n.D in self.given
        given = kernel.used_motion()
        needed = [q for q in given if q not in LOADS]
        first = t.Binary("==", t.Name("i"), t.Number(0))
        one = tuple(
            t.Assign(t.at(t.of("one", q.name), "i"), t.at(t.of("at", q.name), "i", "l")) for q in given[1:]
        )
        of_block: dict[str, Given] = {
            "ROOTS": t.at(t.of("roots", "leg"), "i") if self.ahead else False,
            "OWN": t.Select(first, t.Name("first"), t.Name("other")) if about_tip else False,
            "C": False if about_tip else t.at(t.of("out", "column"), 6),
            "KNOWN": t.at(t.of("out", "D"), "i") if has_d else False,
            "D": t.of("out", "D") if has_d else t.Constant("NULL"),
            "ALL_C": t.at(t.of("out", "column"), 6) if n.c_force in self.given else False,
            **{f"{each.upper()}_C": self._has(n.c_force, each) for each in ("first", "other")},
            **{f"{each.upper()}_MOMENT": self._has(n.c_moment, each) for each in ("first", "other")},
        }
        stride = t.Name("stride")
        # If it were inlined, too few registers would remain for the loops of the same function.
        yield read(
            written.load_block, apart=True, given={"LOADS": tuple(loaded_block(q, stride) for q in given)}
        )
        yield read(written.forces_of_block, given=of_block)
        yield read(written.forces_of, given={"ONE": one} | self._without())
        yield read(written.forces_of_poses, given=BATCH | self._without())
        for many in (written.forces_batch, written.forces_columns):
            short = [t.Binary("<", stride, t.Name("count"))] if many == written.forces_columns else []
            public = self._public("motions", "F", quantities=needed, tests=short)
            yield read(many, f"{name}_{many.__name__}", public=True, given=public, **words)

    def _has(self, q: Quantity, owner: str, member: Quantity | None = None) -> t.Expression | bool:
        """Return the member for the quantity, or False if the kernel's legs do not have it."""
        return t.of(owner, (member or q).name) if q in self.given else False

    def _without(self) -> dict[str, Given]:
        """Return the omission of the model in baked kernels."""
        return {"model": False} if self.baked else {}


def _out(*lane: t.Expression) -> lay.Layout:
    return lambda q: lay.member("out", q, *lane)


def _of_legs(owner: str) -> lay.Layout:
    """Return the layout of the legs of a pose: columns of H are in the rows of the linear system."""

    def place(q: Quantity) -> lay.Place:
        if q in _ROWS:
            return lay.Place(t.of(owner, "A"), (lay.LANE,), _ROWS[q])
        return lay.member(owner, q, lay.LANE)

    return place
