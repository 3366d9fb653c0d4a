"""C functions of the closed form that compute results from sums, for one pose and for eight poses."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from ..kernel import batches
from ..kernel import layouts as lay
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_block, missing, parts_at
from ..kernel.outputs import SIX, inertia_at
from ..kernel.prepare import MOTION, result
from ..kernel.shared import shared
from ..kernel.written.motion import blocks as texts
from ..kernel.written.motion import closed_form_results as results
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import GIVEN
from ..mechanics.closed_form.terms import BY_POSE, BY_TWIST, CORIOLIS, F_LEG, SumKernel
from ..program.block import Quantity
from ..trace import nodes as t
from ..trace import read
from ..trace.read import LANES
from .closed_form_interface import OF_BATCHES, STRUCTS, arrays_of, in_place, members_in_order, struct_of

OUTPUTS = ("equations", "bias_and_friction", "forward_dynamics", "derivatives")
"""Functions whose batch computes eight poses at a time."""

OWN = ("equations", "bias_and_friction", "derivatives")
"""Functions with a separate C text for one pose; other functions share their text with other languages."""

LEGS = 6

Parted = tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]
"""Statements that are common to all lanes, and statements for each lane."""

MOTION_LANES = t.Structure(
    "motion_in_lanes",
    "Motions of eight poses, or of one pose in the first lane, component by component.",
    tuple(lay.stored(q, LANES) for q in n.MOTION),
    aligned=True,
)


CHECKS = t.Structure(
    "leg_checks",
    "Quantities that determine the status of a leg; bad: 1 if it cannot be computed, else 0.",
    tuple(t.numbers(each, LANES) for each in ("L", "reach", "k3", "bad")),
)

_ADD_LEGS = t.signature(
    "add_legs",
    changed=("sum",),
    lanes=t.Array(t.Real(), (1, LANES)),
    count=t.Integer(),
    sum=t.Array(t.Real(), (1,)),
)


def placed(summed: tuple[Quantity, ...]) -> list[tuple[Quantity, int]]:
    """Return each summed number in the order of C, with matrices of four parts row by row."""
    found: list[tuple[Quantity, int]] = []
    for q in summed:
        four = next((each for each in (CORIOLIS, BY_POSE, BY_TWIST) if q in each), None)
        if four is None:
            found += [(q, i) for i in range(len(q.keys))]
        elif q == four[0]:
            rows = [(i, j) for i in range(LEGS) for j in range(LEGS)]
            found += [(four[2 * (i // 3) + j // 3], 3 * (i % 3) + j % 3) for i, j in rows]
    return found


def offsets(summed: tuple[Quantity, ...]) -> dict[str, int]:
    """Return the index of the first number of each quantity."""
    return {q.name: place for place, (q, i) in enumerate(placed(summed)) if i == 0}


LOADED = tuple(loaded_block(q, t.As(t.Count(), t.Number(0))) for q in n.MOTION)
"""Loads of the motions of eight poses."""


def aligned(function: t.Function) -> t.Function:
    """Align the larger arrays of a function for vector instructions."""

    def changed(node: t.Statement) -> t.Statement:
        if isinstance(node, t.Variable) and isinstance(node.type, t.Array) and node.blank:
            return replace(node, aligned=node.type.item == t.Real() and node.type.dims[0] >= LANES)
        return node

    return replace(function, body=tuple(map(changed, function.body)))


@dataclass(frozen=True)
class Results:
    """Layout of the numbers of one output, in lanes of one pose or eight.

    Attributes
    ----------
    prefix : str
        Prefix of the functions.
    what : str
        Output.
    kernel : SumKernel
        Kernel of the sums.
    kept : list of Quantity
        Quantities of each leg in addition to the sums.
    """

    prefix: str
    what: str
    kernel: SumKernel
    kept: list[Quantity]

    @property
    def count(self) -> int:
        """Count of summed numbers."""
        return len(placed(self.kernel.summed))

    @property
    def first(self) -> int:
        """Index of the first sum; for the equations all sums except M are at their final place."""
        return 15 if self.what == "equations" else 0

    @property
    def base(self) -> int:
        """Index of the first number of ``kept``."""
        return 96 if self.what == "equations" else self.count

    @property
    def width(self) -> int:
        """Count of numbers that a pose returns."""
        slots = LEGS * sum(len(q.keys) for q in self.kept)
        return LEGS if self.what in ("bias_and_friction", "forward_dynamics") else self.base + slots

    @property
    def has_f(self) -> bool:
        """True if the legs read actuator forces."""
        return F_LEG in self.kernel.leg.inputs

    @property
    def forces_first(self) -> bool:
        """True if these are the forces of inverse dynamics."""
        return self.what == "derivatives"

    def block(self) -> t.Structure:
        """Return the structure of eight poses."""
        bad = "1 if the function for one pose must compute the pose, else 0"
        size = LANES * max(self.width, self.first + self.count)
        return t.Structure(
            f"{self.prefix}_block",
            "Numbers of eight poses.",
            (t.numbers("number", size), t.numbers("bad", LANES, meaning=bad)),
            aligned=True,
        )

    def names(self) -> dict[str, str]:
        """Return the C names of the names in the texts."""
        found = {"pose_terms": f"{self.prefix}_of_pose", "leg_of_poses": f"{self.prefix}_leg_of_poses"}
        of_block = {"leg_of_block": f"{self.prefix}_leg_of_block", "sums_of_block": f"{self.prefix}_of_block"}
        return found | of_block | {"sums": f"{self.prefix}_sums"}

    def given(self) -> dict[str, read.Given]:
        """Return the words of every text: indices of numbers, and the quantities that legs keep."""
        leg = t.Name("leg")
        of_block, of_one = t.of("out", "number"), t.Name("number")
        lanes = t.Number(LANES)
        return {
            "FIRST": self.first,
            "COUNT": self.count,
            "OF_LANES": LANES * self.count,
            "WIDTH": self.width,
            "HAS_NEAR": int(self.kernel.near is not None),
            "HAS_F": int(self.has_f),
            "FORCES_FIRST": int(self.forces_first),
            "KEPT_OF_LEG": tuple(
                t.Assign(
                    t.Element(of_block, (lanes * (slot + leg) + lay.LANE,)),
                    lay.member("legs", q, lay.LANE).part(q, i),
                )
                for q, i, slot in self._slots()
            ),
            "TAKEN": tuple(
                t.Assign(t.Element(of_one, (slot + leg,)), lay.member("legs", q, leg).part(q, i))
                for q, i, slot in self._slots()
            ),
            **self._places(),
            **({} if self.has_f else {"acting": False}),
        }

    def _places(self) -> dict[str, read.Given]:
        """Return the indices of the numbers."""
        if self.what == "equations":
            places = {
                "C": 36,
                "G": 72,
                "FRICTION": 78,
                "BIAS": 84,
                "WITH_FRICTION": 90,
                "RESULTS": 168,
                "ALL": 168,
            }
            return {**places, "SYMMETRIC": _symmetric(self.first)}
        if self.what == "derivatives":
            at = offsets(self.kernel.summed)
            found: dict[str, read.Given] = {each: at[each] for each in ("M_vv", "M_vw", "M_ww")}
            found = {each.upper(): place for each, place in found.items()}
            first = {"BY_POSE": at[BY_POSE[0].name], "BY_TWIST": at[BY_TWIST[0].name], "H": self.base}
            return {**found, **first, "ROW": 40, "TABLE": 240, "ALL": self.width + 2}
        return {}

    def _slots(self) -> Iterator[tuple[Quantity, int, t.Expression]]:
        """Yield each number that legs keep, and its index for six legs."""
        numbers = [(q, i) for q in self.kept for i in range(len(q.keys))]
        return ((q, i, t.Number(self.base + LEGS * slot)) for slot, (q, i) in enumerate(numbers))

    def batch(self) -> dict[str, read.Given]:
        """Return the additional words of the text of the batch."""
        needed = (n.R, n.t, n.omega, n.v, *((n.alpha, n.a) if self.forces_first else ()))
        forced = self.has_f and not self.forces_first
        of_block: dict[str, read.Given] = {
            "equations": texts.finished_equations,
            "bias_and_friction": texts.finished_in_lanes,
            "forward_dynamics": texts.finished_accelerations,
            "derivatives": texts.finished_forces,
        }
        return {
            "ROWS": LANES * self.width + 2 * self.forces_first,
            "finish_block": of_block[self.what],
            "one_by_one": texts.one_by_one,
            "finished_in_lanes": texts.finished_in_lanes,
            "inertia": inertia_at(
                lambda _, __, i: t.Element(t.of("block", "number"), (t.Number(LANES * i) + lay.LANE,))
            ),
            **({} if forced else {"F": False}),
            **parts_at(LOADS, (), "part", "first", t.Constant("NULL")),
            **missing(("model", "motions", "out", *(["F"] if forced else [])), needed),
        }


def _in_lanes(i: int) -> t.Expression:
    """Return one of the numbers of a lane."""
    return t.Element(t.Name("number"), (t.Number(i) * t.Name("lanes") + lay.LANE,))


def _symmetric(first: int) -> tuple[t.Statement, ...]:
    """Fill M row by row from its parts."""
    part = inertia_at(lambda _, __, i: t.Name(f"m_{i}"))
    cells = [(i, j) for i in range(LEGS) for j in range(LEGS)]
    return (
        *(t.Let(f"m_{i}", _in_lanes(first + i)) for i in range(21)),
        *(
            t.Assign(_in_lanes(LEGS * i + j), part(t.Number(min(i, j)), t.Number(max(i, j))))
            for i, j in cells
        ),
    )


def kept(kernel: SumKernel) -> list[Quantity]:
    """Return the outputs of a leg in addition to the sums."""
    others = (*kernel.summed, *lay.CHECKED)
    return [q for q in kernel.leg.made if q not in others]


def handed(kernel: SumKernel) -> list[Quantity]:
    """Return the outputs of a pose that its legs read."""
    return [q for q in kernel.pose.made if q not in kernel.summed]


class Batches:
    """Functions of one file that compute results from sums, for one pose and for many.

    Attributes
    ----------
    structures : dict
        Structures that all texts may name.
    functions : dict
        Functions that were read, and other functions that they may call.
    """

    def __init__(self, model: ForceKernel, asked: list[str], kernels: Iterable[SumKernel]) -> None:
        """Set the outputs ``asked`` and their kernels."""
        self.model, self.asked, self.name = model, asked, model.formulation.kernel_name
        self.kernels = {o.prefix_of(each): each for each in kernels}
        self.structures = {
            "Model": t.Structure(f"stewart_{self.name}_model", "", ()),
            "Motion": MOTION,
            "Motions": MOTIONS,
            "MotionLanes": MOTION_LANES,
            "Checked": CHECKS,
        }
        known = (_ADD_LEGS, *OF_BATCHES, *self._forces_as_called())
        self.functions = {each.name: each for each in known} | shared().by_name
        self.read = lay.Written(self.structures, {}, self.functions).function

    def _forces_as_called(self) -> Iterator[t.Function]:
        """Yield the signatures of the forces of one pose and of their batch."""
        name, records = f"stewart_{self.name}_forces", dict.fromkeys(("model", "motion"), t.Record(""))
        yield t.signature(name, t.Integer(), ("F",), **records, F=t.Array(t.Real(), (LEGS,)))
        arrays = dict.fromkeys(("F", "status"), t.Pointer(t.Real()))
        of_many = {"model": t.Record(""), "count": t.Count(), "motions": t.Record(""), **arrays}
        yield t.signature(f"{name}_batch", t.Integer(), ("F", "status"), **of_many)

    def pose_structure(self, prefix: str) -> t.Structure:
        """Return the structure of the terms of a pose that its legs read."""
        members = tuple(lay.stored(q, LANES) for q in handed(self.kernels[prefix]))
        return t.Structure(f"{prefix}_pose", "", members, aligned=bool(members))

    def legs_structure(self, prefix: str) -> t.Structure:
        """Return the structure of the legs of a pose, or of one leg of eight poses."""
        kernel = self.kernels[prefix]
        held = [q for q in GIVEN if q in kernel.leg.inputs] + kept(kernel)
        members = (
            t.numbers("sum", sum(len(q.keys) for q in kernel.summed), LANES),
            *(lay.stored(q, LANES) for q in held),
            t.Field("checked", t.Record(CHECKS.name)),
            t.Field("status", t.Integer()),
        )
        return t.Structure(f"{prefix}_legs", "", members, aligned=True)

    def shared_by_blocks(self) -> Iterator[t.Function]:
        """Yield the common functions of blocks of eight poses."""
        yield self.read(texts.load_motions, given={"LOADS": LOADED})
        if {"forward_dynamics", "derivatives"} & set(self.asked):
            yield self.read(texts.load_forces)
        yield self.read(texts.add_two, apart=True)
        yield self.read(texts.in_rows, apart=True)
        if {"equations", "bias_and_friction", "forward_dynamics"} & set(self.asked):
            yield self.read(texts.any_of)

    def _results(self, what: str) -> tuple[Results, dict[str, t.Structure]]:
        """Return the layout of an output, and the structures of its functions."""
        prefix = o.PREFIX.get(what, what)
        kernel = self.kernels[prefix]
        made = Results(prefix, what, kernel, [] if what == "bias_and_friction" else kept(kernel))
        structures = {
            "Pose": self.pose_structure(prefix),
            "Legs": self.legs_structure(prefix),
            "Block": made.block(),
        }
        if what in STRUCTS:
            filled = struct_of(what)
            structures |= {"Result": filled, "ResultArrays": arrays_of(what, ""), "Found": filled}
        return made, structures

    def own(self, what: str) -> Iterator[t.Function]:
        """Yield the function of one pose and its helpers."""
        made, structures = self._results(what)
        names = made.names() | {"kernel_forces": f"stewart_{self.name}_forces"}
        if what == "equations":
            yield replace(self.read(results.matrices, given=made.given()), inlined=True)
        if what == "derivatives":
            yield self.read(results.factored, apart=True)
            yield self.read(results.back, apart=True)
            yield aligned(self.read(results.slopes, apart=True, structures=structures, given=made.given()))
        copied_one = []
        for each, place, count in members_in_order(what):
            number = t.Element(t.Name("number"), (place + t.Name("i"),))
            taken = t.Assign(t.at(t.of("out", each), "i"), number)
            copied_one.append(t.For("i", t.Number(0), t.Number(count), (taken,)))
        given = made.given() | missing(("model", "motion", "out")) | {"COPIED": tuple(copied_one)}
        name, text = f"stewart_{self.name}_{what}", getattr(results, what)
        yield aligned(self.read(text, name, structures=structures, given=given, names=names, public=True))

    def accelerations(self) -> Iterator[t.Function]:
        """Yield the linear solver of forward dynamics."""
        made, structures = self._results("forward_dynamics")
        found = result("forward_dynamics_found", "", t.numbers("acceleration", 6))
        in_lanes: dict[str, read.Given] = {
            **SIX,
            "weigh_pivot": texts.stored_pivot,
            "inertia": inertia_at(lambda _, __, i: _in_lanes(i)),
            "right": lambda i: _in_lanes(21 + i.value),
        }
        yield replace(self.read(results.solve_inertia, given=in_lanes), inlined=True)
        given = made.given() | {"inertia": inertia_at(lambda _, __, i: t.at("summed", i))}
        yield self.read(results.accelerations_of, structures=structures | {"Found": found}, given=given)

    def of_blocks(self, what: str, leg: t.Function) -> Iterator[t.Structure | t.Function]:
        """Yield a batch and the functions of its blocks; ``leg`` computes one leg of a block."""
        made, structures = self._results(what)
        struct = what in STRUCTS
        yield structures["Block"]
        yield leg
        names = made.names() | {"kernel_forces_batch": f"stewart_{self.name}_forces_batch"}
        names |= {"of_pose": f"stewart_{self.name}_{what}"}
        names |= {} if struct else {"Found": f"array({LEGS})", "ResultArrays": "Pointer(Real)"}
        for text in (texts.leg_of_block, texts.sums_of_block):
            yield aligned(
                self.read(text, names[text.__name__], structures=structures, given=made.given(), names=names)
            )
        row = t.Name("l") * t.Number(made.width)
        counts = {each: count for each, _, count in members_in_order(what)}
        alone = copies("out", counts) if struct else (copied(t.Name("out"), t.Name("found"), 6),)
        in_rows = tuple(
            copied(t.of("out", each) if struct else t.Name("out"), t.From(t.Name("row"), row + place), count)
            for each, place, count in members_in_order(what)
        )
        given: dict[str, read.Given] = {
            **made.given(),
            **made.batch(),
            **batches.BATCH,
            "COPIED": alone if what == "derivatives" else in_rows,
            "COPIED_ALONE": alone,
            "IN_PLACE": tuple(in_place(what)),
        }
        name, many = f"stewart_{self.name}_{what}_batch", texts.batch_of_blocks
        yield aligned(self.read(many, name, structures=structures, given=given, names=names, public=True))
