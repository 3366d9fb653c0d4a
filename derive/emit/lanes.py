"""C99 files of the force kernels for speed, with legs or poses in vector lanes.

A single pose uses six of eight lanes for its legs. A batch uses eight lanes for poses, or sixteen in float.
In both cases a block is the body of a loop over lanes. Compilers vectorize this loop; otherwise it is
portable C.
"""

from collections.abc import Iterable
from dataclasses import replace
from string import Template
from typing import Any

from ..kernel import layouts as lay
from ..kernel import prepare as p
from ..kernel.batches import BATCH, LOADS, MOTIONS, loaded_block, missing
from ..kernel.operations import force_operations
from ..kernel.shared import common_parts, shared
from ..kernel.written import lanes as written
from ..kernels.forces import BASE_REACH, FORCES, PER_LENGTH, base_points, forces
from ..kernels.solve import ARM_CUBE
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..print.template import filled
from ..program.block import Quantity
from ..trace import nodes as t
from ..trace.lanes import Lanes
from ..trace.read import LANES, POSES, Given
from ..trace.recorder import LEG, MODEL, MOTION, Trace, inputs_of
from .inverse_dynamics import operations_table
from .shared import LANES as HEADER
from .shared import Part, Source, header, top

_BASE_REACH = t.Field("base_reach", t.Real(), "m: largest magnitude of a coordinate of the base points")
_LANES_SAY = " In arrays that end with [8] the last index is the leg; the values 7 and 8 repeat leg 6."


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
    return texts | {f"{file}.c": made.printed(top(file, version, HEADER, filled("registers.c")))}


def model_numbers(kernel: ForceKernel) -> int:
    """Return the count of numbers in ``stewart_<kernel>_model``."""
    of_legs = LANES * sum(len(q.keys) for q in kernel.leg_constants())
    return of_legs + sum(len(q.keys) for q in kernel.platform_constants()) + 3


def traced(kernel: ForceKernel) -> Trace:
    """Trace the forces of a kernel."""
    unit = p.per_length(kernel.size)
    numbers = {PER_LENGTH: unit, ARM_CUBE: (kernel.size * unit) ** 3, BASE_REACH: _base_reach(kernel)}
    own = {q: t.Number(number) for q, number in numbers.items()}
    literals: dict[Quantity, t.Expression] = {q: t.Name(p.literal(q)) for q in kernel.literals()}
    if kernel.constants is not None:
        literals.update(own)
    inputs = (
        inputs_of(MOTION, n.MOTION)
        | inputs_of(LEG, kernel.leg_constants())
        | inputs_of(MODEL, (*kernel.platform_constants(), *kernel.literals(), *own))
    )
    for q, literal in literals.items():
        inputs[q.name] = replace(inputs[q.name], literal=literal)
    k = Trace(inputs)
    forces(k, kernel, None if kernel.constants is None else p.is_scaled(kernel))
    return k


def _base_reach(kernel: ForceKernel) -> float:
    """Return the largest magnitude of a coordinate of the base points of a baked kernel (m)."""
    constants = kernel.constants or {}
    return max((abs(value) for q in base_points(kernel) for value in constants.get(q, ())), default=0.0)


class _Source(Source):
    def __init__(self, kernel: ForceKernel) -> None:
        self.kernel, self.baked = kernel, kernel.constants is not None
        self.structures = p.structures(kernel) | self._structures()
        trace, model = traced(kernel), self.structures["Model"].name
        self.pose, self.block = (Lanes(trace, model, poses_in_lanes) for poses_in_lanes in (False, True))
        self.structures["Block"] = self.block.structures()[FORCES]
        known = shared().by_name
        super().__init__(lay.Written(self.structures, p.flags(kernel), known))

    # ------------------------------------------------------------ structures

    def _structures(self) -> dict[str, t.Structure]:
        kernel = self.kernel
        says = "Constants that differ between the legs; the last two lanes repeat leg 6."
        own = [] if self.baked else [p.PER_LENGTH, p.ARM_CUBE, _BASE_REACH]
        model = (
            *(lay.described(q, LANES) for q in kernel.leg_constants()),
            *map(lay.described, kernel.platform_constants()),
            *own,
        )
        if not self.baked:
            says = p.model_says(model, _LANES_SAY)
        lanes = tuple(lay.stored(q, POSES) for q in kernel.used_motion())
        says_of_motion = "Motions of the poses of a block, component by component."
        return {
            "Model": t.Structure(f"stewart_{kernel.name}_model", says, model),
            "Motions": MOTIONS,
            "MotionLanes": t.Structure("motion_lanes", says_of_motion, lanes, aligned=True),
        }

    # ------------------------------------------------------------ functions

    def _parts(self) -> Iterable[Part]:
        kernel, read, name = self.kernel, self.texts.function, f"stewart_{self.kernel.name}"
        made, words = self.structures, p.motion_words(self.kernel)
        yield made["MotionLanes"]
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
        yield from self._own(self.pose)
        yield self._added(self._one_pose(f"{name}_forces", words))
        yield from self._own(self.block)
        yield self._added(self._one_block())
        yield from self._batch(name, words)

    def _own(self, schedule: Lanes) -> Iterable[t.Structure | t.Function]:
        """Yield the structures and functions of a schedule that the common header does not have."""
        common = {each.name: each for each in common_parts(self.kernel.about_tip)}
        parts: list[t.Structure | t.Function] = [*schedule.structures().values()]
        for each in (*parts, *schedule.functions.values()):
            if common.get(each.name) != each:
                yield self._added(each) if isinstance(each, t.Function) else each
            elif isinstance(each, t.Function):
                self.texts.functions[each.name] = each

    def _added(self, function: t.Function) -> t.Function:
        """Add a function that later functions call."""
        self.texts.functions[function.name.removeprefix(f"stewart_{self.kernel.name}_")] = function
        self.texts.functions[function.name] = function
        return function

    def _table(self) -> t.Table:
        """Print the constants of a baked kernel; the last two lanes repeat leg 6."""
        assert self.kernel.constants is not None
        columns = [self.kernel.constants[q] for q in self.kernel.leg_constants()]
        row = tuple(value for values in columns for value in (*values, values[-1], values[-1]))
        return t.Table("numbers", self.structures["Model"], (row,))

    def _one_pose(self, name: str, words: dict[str, Any]) -> t.Function:
        """Return the public function of one pose."""
        model = t.Record(self.structures["Model"].name)
        address = t.Let("model", t.Name("numbers"), t.Pointer(model))
        pointers = ("motion", "F") if self.baked else ("model", "motion", "F")
        body = (
            *((address,) if self.baked else ()),
            *self.pose.variables(),
            t.Variable("status", t.Integer(), t.Constant("OK")),
            t.If(missing(pointers)["MISSING"], (t.Return(t.Constant("BAD_ARGUMENT")),)),  # type: ignore[arg-type]
            *self.pose.calls(),
            *self.pose.return_results("F"),
        )
        arguments = (
            *(() if self.baked else (t.Argument("model", model),)),
            t.Argument("motion", t.Record("stewart_motion")),
            t.Argument("F", t.Array(t.Real(), (6,)), changed=True),
        )
        meaning = Template(written.FORCES).substitute(words)
        return t.Function(name, meaning, arguments, t.Integer(), body, public=True)

    def _one_block(self) -> t.Function:
        """Return the function of a block of poses."""
        variables = (each for each in self.block.variables() if each.name != FORCES)
        body = (*variables, *self.block.calls())
        arguments = (
            t.Argument("model", t.Record(self.structures["Model"].name)),
            t.Argument("at", t.Record("motion_lanes")),
            t.Argument(FORCES, t.Record(self.structures["Block"].name), changed=True),
        )
        meaning = "Computes the forces of a block of poses, and marks the poses that must be examined."
        return t.Function("forces_of_block", meaning, arguments, None, body)

    def _batch(self, name: str, words: dict[str, Any]) -> Iterable[t.Function]:
        """Yield the loop over blocks and the public functions of many poses."""
        read, given = self.texts.function, self.kernel.used_motion()
        needed = tuple(q for q in given if q not in LOADS)
        one = tuple(
            t.Assign(t.at(t.of("one", q.name), "i"), t.at(t.of("at", q.name), "i", "l")) for q in given[1:]
        )
        without: dict[str, Given] = {"model": False} if self.baked else {}
        stride = t.Name("stride")
        # If it were inlined, too few registers would remain for the loops of the same function.
        yield read(
            written.load_block, apart=True, given={"LOADS": tuple(loaded_block(q, stride) for q in given)}
        )
        yield read(written.forces_of, given={"ONE": one} | without)
        yield read(written.forces_of_poses, given=BATCH | without)
        pointers = ("motions", "F") if self.baked else ("model", "motions", "F")
        for many in (written.forces_batch, written.forces_columns):
            short = [t.Binary("<", stride, t.Name("count"))] if many == written.forces_columns else []
            checked = missing(pointers, needed, *short) | without
            yield read(many, f"{name}_{many.__name__}", public=True, given=checked, **words)
