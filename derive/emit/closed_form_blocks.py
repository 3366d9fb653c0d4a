"""Results of the closed form in C, of one pose and of eight side by side: what their texts are given."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from ..kernel import batches
from ..kernel import layouts as lay
from ..kernel import outputs as o
from ..kernel.batches import LOADS, MOTIONS, copied, copies, loaded_block, missing
from ..kernel.model import STATUS_FIELD
from ..kernel.outputs import SIX, inertia_at
from ..kernel.tree import nodes as t
from ..kernel.tree import read
from ..kernel.tree.read import LANES
from ..kernel.written.motion import blocks as texts
from ..kernel.written.motion import results
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import F_LEG, SumKernel
from ..mechanics.closed_form.terms import BY_POSE, BY_TWIST, CORIOLIS
from ..program.block import Quantity
from .closed_form_interface import STRUCTS, arrays_of, in_place, members, members_in_order, struct_of

OUTPUTS = ("equations", "bias", "forward_dynamics", "derivatives")
"""Of those whose batches are blocks of eight poses."""

OWN = ("equations", "bias", "derivatives")
"""Of those whose function of one pose is written for C as well."""

LEGS = 6

Parted = tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]
"""What all lanes share, and what is done in each."""

MOTION_LANES = t.Structure(
    "motion_in_lanes",
    "A motion in every lane, or motions of eight poses, component by component.",
    tuple(lay.stored(q, LANES) for q in n.MOTION),
    aligned=True,
)


def of_leg(name: str) -> t.Structure:
    """A leg of a kernel's model."""
    return t.Structure(
        "leg_in_lanes",
        "The constants of one leg in every lane.",
        (t.Field("model", t.Record(f"stewart_{name}_model")),),
        aligned=True,
    )


_ROW = 6


def placed(summed: tuple[Quantity, ...]) -> list[tuple[Quantity, int]]:
    """Each number that is summed, in the order in which C has them: matrices of four parts row by row."""
    found: list[tuple[Quantity, int]] = []
    for q in summed:
        four = next((each for each in (CORIOLIS, BY_POSE, BY_TWIST) if q in each), None)
        if four is None:
            found += [(q, i) for i in range(len(q.keys))]
        elif q == four[0]:
            rows = [(i, j) for i in range(_ROW) for j in range(_ROW)]
            found += [(four[2 * (i // 3) + j // 3], 3 * (i % 3) + j % 3) for i, j in rows]
    return found


def offsets(summed: tuple[Quantity, ...]) -> dict[str, int]:
    """Where the first number of each quantity is."""
    return {q.name: place for place, (q, i) in enumerate(placed(summed)) if i == 0}


LOADED = tuple(loaded_block(q, t.As(t.Count(), t.Number(0))) for q in n.MOTION)
"""Motions of eight poses."""


def aligned(function: t.Function) -> t.Function:
    """The function with its larger arrays where vectors begin."""

    def changed(node: t.Statement) -> t.Statement:
        if isinstance(node, t.Variable) and isinstance(node.type, t.Array) and node.blank:
            return replace(node, aligned=node.type.item == t.Real() and node.type.dims[0] >= LANES)
        return node

    return replace(function, body=tuple(map(changed, function.body)))


@dataclass(frozen=True)
class Results:
    """What one output is made of, and where: numbers one after the other, in lanes of one pose or eight.

    prefix: of its functions. what: the output. kept: of each leg, beside the sums.
    """

    prefix: str
    what: str
    kernel: SumKernel
    kept: list[Quantity]

    @property
    def count(self) -> int:
        """How many numbers are summed."""
        return len(placed(self.kernel.summed))

    @property
    def first(self) -> int:
        """Where the sums begin: those of the equations so that all but M are in their place."""
        return 15 if self.what == "equations" else 0

    @property
    def base(self) -> int:
        """Where the numbers begin that legs keep."""
        return 90 if self.what == "equations" else self.count

    @property
    def width(self) -> int:
        """How many numbers a pose hands on."""
        slots = LEGS * sum(len(q.keys) for q in self.kept)
        return LEGS if self.what in ("bias", "forward_dynamics") else self.base + slots

    @property
    def has_f(self) -> bool:
        """Whether the legs are given actuator forces."""
        return F_LEG in self.kernel.leg.inputs

    @property
    def forces_first(self) -> bool:
        """Whether these are those of inverse dynamics."""
        return self.what == "derivatives"

    def block(self) -> t.Structure:
        """Eight poses on their way."""
        bad = "1 where a pose is left to the function of one, else 0"
        size = LANES * max(self.width, self.first + self.count)
        return t.Structure(
            f"{self.prefix}_block",
            "Numbers of eight poses.",
            (t.numbers("number", size), t.numbers("bad", LANES, meaning=bad)),
            aligned=True,
        )

    def names(self) -> dict[str, str]:
        """What names of the texts stand for."""
        found = {f"{part}_terms": f"{self.prefix}_of_{part}" for part in ("pose", "leg")}
        of_block = {
            "leg_of_block": f"{self.prefix}_leg_of_block",
            "sums_of_block": f"{self.prefix}_of_block",
        }
        return found | of_block | {"sums": f"{self.prefix}_sums"}

    def given(self) -> dict[str, read.Given]:
        """Of all functions: places of numbers, and what legs keep of them."""
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
                t.Assign(t.Element(of_block, (lanes * (slot + leg) + lay.LANE,)), place(lay.LANE))
                for place, slot in self._slots()
            ),
            "TAKEN": tuple(
                t.Assign(t.Element(of_one, (slot + leg,)), place(leg)) for place, slot in self._slots()
            ),
            **self._places(),
            **({} if self.has_f else {"acting": False}),
        }

    def _places(self) -> dict[str, read.Given]:
        """Where numbers are."""
        if self.what == "equations":
            places = {"C": 36, "G": 72, "FRICTION": 78, "BIAS": 84, "RESULTS": 162, "ALL": 168}
            return {**places, "SYMMETRIC": _symmetric(self.first)}
        if self.what == "derivatives":
            at = offsets(self.kernel.summed)
            found: dict[str, read.Given] = {each: at[each] for each in ("M_vv", "M_vw", "M_ww")}
            found = {each.upper(): place for each, place in found.items()}
            first = {"BY_POSE": at[BY_POSE[0].name], "BY_TWIST": at[BY_TWIST[0].name], "H": self.base}
            return {**found, **first, "ROW": 40, "TABLE": 240, "ALL": self.width + 2}
        return {}

    def _slots(self) -> Iterator[tuple[Callable[[t.Expression], t.Expression], t.Expression]]:
        """Each number that legs keep: where it is in a lane, and where those of six legs begin."""
        numbers = [(q, i) for q in self.kept for i in range(len(q.keys))]
        for slot, (q, i) in enumerate(numbers):

            def place(lane: t.Expression, q: Quantity = q, i: int = i) -> t.Expression:
                return lay.member("legs", q, lane).part(q, i)

            yield place, t.Number(self.base + LEGS * slot)

    def one(self) -> dict[str, read.Given]:
        """Of the function of one pose."""
        return missing(("model", "motion", "out"))

    def batch(self) -> dict[str, read.Given]:
        """Of the batch."""
        needed = (n.R, n.t, n.omega, n.v, *((n.alpha, n.a) if self.forces_first else ()))
        forced = self.has_f and not self.forces_first
        load: read.Given = texts.forces_of_block if self.forces_first else texts.acting_of_block
        of_block: dict[str, read.Given] = {
            "equations": texts.finished_equations,
            "bias": texts.finished_in_lanes,
            "forward_dynamics": texts.finished_accelerations,
            "derivatives": texts.finished_forces,
        }
        of_array = self.what in ("bias", "forward_dynamics")
        return {
            "ROWS": LANES * self.width + 2 * self.forces_first,
            "begin": texts.begun_array if of_array else texts.begun_structure,
            "load_acting": load if self.has_f else (),
            "finish_block": of_block[self.what],
            "one_by_one": texts.one_by_one,
            "IN_LANES": int(not self.forces_first),
            "finished_in_lanes": texts.finished_in_lanes,
            "finish": texts.finished_slopes if self.forces_first else (),
            "find": texts.found_under_forces if forced else texts.found_alone,
            "inertia": inertia_at(
                lambda _, __, i: t.Element(t.of("block", "number"), (t.Number(LANES * i) + lay.LANE,))
            ),
            **({} if forced else {"F": False}),
            **_parts(),
            **missing(("model", "motions", "out", *(["F"] if forced else [])), needed),
        }


def _in_lanes(i: int) -> t.Expression:
    """One of the numbers of a lane."""
    return t.Element(t.Name("number"), (t.Number(i) * t.Name("lanes") + lay.LANE,))


def solve_in_lanes() -> dict[str, read.Given]:
    """Of ``written.motion.results.solve_inertia``."""
    return {
        **SIX,
        "weigh_pivot": texts.stored_pivot,
        "inertia": inertia_at(lambda _, __, i: _in_lanes(i)),
        "right": lambda i: _in_lanes(21 + i.value),
    }


def solve_of_one() -> dict[str, read.Given]:
    """Of ``written.motion.results.accelerations_of``."""
    return {"inertia": inertia_at(lambda _, __, i: t.at("summed", i))}


def _symmetric(first: int) -> tuple[t.Statement, ...]:
    """M, row by row, from its parts."""
    part = inertia_at(lambda _, __, i: t.Name(f"m_{i}"))
    cells = [(i, j) for i in range(_ROW) for j in range(_ROW)]
    return (
        *(t.Let(f"m_{i}", _in_lanes(first + i)) for i in range(21)),
        *(
            t.Assign(_in_lanes(_ROW * i + j), part(t.Number(min(i, j)), t.Number(max(i, j))))
            for i, j in cells
        ),
    )


def _parts() -> dict[str, read.Given]:
    """Addresses of a block's motions in those of all."""
    found = []
    for q in n.MOTION:
        given = t.of("motions", q.name)
        place: t.Expression = t.From(given, t.As(t.Count(), t.Number(len(q.keys))) * t.Name("first"))
        if q in LOADS:
            place = t.Select(t.Binary("!=", given, t.Constant("NULL")), place, t.Constant("NULL"))
        found.append(t.Assign(t.of("part", q.name), place))
    return {"PARTS": tuple(found)}


def kept(kernel: SumKernel) -> list[Quantity]:
    """What legs hand out beside their part of the sums."""
    checked = (n.q, n.L, n.k3)
    return [out.quantity for out in kernel.leg.outputs if out.quantity not in (*kernel.summed, *checked)]


class Batches(ABC):
    """The functions of one file that make results of sums, of one pose and of many."""

    name: str
    asked: list[str]
    model: ForceKernel
    kernels: dict[str, SumKernel]
    functions: dict[str, t.Function]

    @abstractmethod
    def read(self, text: o.Written, name: str = "", **more: Any) -> t.Function:
        """One more function."""

    @abstractmethod
    def given(self) -> dict[str, t.Structure]:
        """Structures that all functions may name."""

    @abstractmethod
    def pose_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        """What a pose hands to its legs."""

    @abstractmethod
    def legs_structure(self, prefix: str, kernel: SumKernel) -> t.Structure:
        """The legs of a pose, or one leg of eight."""

    def known_forces(self) -> t.Function:
        """The forces of one pose as they are called."""
        return t.signature(
            f"stewart_{self.name}_forces",
            t.Integer(),
            ("F",),
            **dict.fromkeys(("model", "motion"), t.Record("")),
            F=t.Array(t.Real(), (LEGS,)),
        )

    def _forces_batch(self) -> t.Function:
        """The batch of forces as it is called."""
        arrays = dict.fromkeys(("F", "status"), t.Pointer(t.Real()))
        return t.signature(
            f"stewart_{self.name}_forces_batch",
            t.Integer(),
            ("F", "status"),
            model=t.Record(""),
            count=t.Count(),
            motions=t.Record(""),
            **arrays,
        )

    def shared_by_blocks(self) -> Iterator[t.Function]:
        """What all kernels need for blocks of eight poses."""
        structures = {**self.given(), "Motions": MOTIONS, "MotionLanes": MOTION_LANES}
        yield self.read(
            texts.spread_leg,
            structures=structures,
            given={"OF_LEG": lay.entries(self.model.leg_constants())},
        )
        yield self.read(texts.load_motions, structures=structures, given={"LOADS": LOADED})
        if {"forward_dynamics", "derivatives"} & set(self.asked):
            yield self.read(texts.load_forces)
        yield replace(self.read(texts.add_two), apart=True)
        yield replace(self.read(texts.in_rows), apart=True)
        if {"equations", "bias", "forward_dynamics"} & set(self.asked):
            yield self.read(texts.any_of)

    def _results(self, what: str) -> tuple[Results, dict[str, t.Structure]]:
        """What is known of an output, and the structures of its functions."""
        prefix = o.PREFIX.get(what, what)
        kernel = self.kernels[prefix]
        made = Results(prefix, what, kernel, [] if what == "bias" else kept(kernel))
        structures = {
            **self.given(),
            "Motions": MOTIONS,
            "MotionLanes": MOTION_LANES,
            "Pose": self.pose_structure(prefix, kernel),
            "Legs": self.legs_structure(prefix, kernel),
            "Block": made.block(),
            "OfLeg": of_leg(self.name),
        }
        if what in STRUCTS:
            structures |= {
                "Result": struct_of(what),
                "ResultArrays": arrays_of(what, ""),
                "Found": struct_of(what),
            }
        return made, structures

    def own(self, what: str) -> Iterator[t.Function]:
        """The function of one pose, and what it makes a result with."""
        made, structures = self._results(what)
        names = made.names() | {"kernel_forces": f"stewart_{self.name}_forces"}
        self.functions[names["kernel_forces"]] = self.known_forces()
        if what == "equations":
            yield replace(self.read(results.matrices, given=made.given()), inlined=True)
        if what == "derivatives":
            yield replace(self.read(results.factored), apart=True)
            yield replace(self.read(results.back), apart=True)
            slopes = self.read(results.slopes, structures=structures, given=made.given())
            yield replace(aligned(slopes), apart=True)
        copied_one = tuple(
            t.For(
                "i",
                t.Number(0),
                t.Number(count),
                (
                    t.Assign(
                        t.at(t.of("out", each), "i"), t.Element(t.Name("number"), (place + t.Name("i"),))
                    ),
                ),
            )
            for each, place, count in members_in_order(what)
        )
        text = next(
            each for each in (results.equations, results.bias, results.derivatives) if each.__name__ == what
        )
        yield aligned(
            self.read(
                text,
                f"stewart_{self.name}_{what}",
                structures=structures,
                given=made.given() | made.one() | {"COPIED": copied_one},
                names=names,
                public=True,
            )
        )

    def accelerations(self) -> Iterator[t.Function]:
        """The solve of forward dynamics."""
        made, structures = self._results("forward_dynamics")
        found = t.Structure("forward_dynamics_found", "", (t.numbers("acceleration", 6), STATUS_FIELD))
        yield replace(self.read(results.solve_inertia, given=solve_in_lanes()), inlined=True)
        yield self.read(
            results.accelerations_of,
            structures=structures | {"Found": found},
            given=made.given() | solve_of_one(),
        )

    def of_blocks(self, what: str) -> Iterator[t.Structure | t.Function]:
        """A batch, and what its blocks do."""
        made, structures = self._results(what)
        struct = what in STRUCTS
        yield structures["Block"]
        names = made.names() | {"kernel_forces_batch": f"stewart_{self.name}_forces_batch"}
        names |= {"of_pose": f"stewart_{self.name}_{what}"}
        names |= {} if struct else {"ResultArrays": "Pointer(Real)"}
        self.functions[names["kernel_forces_batch"]] = self._forces_batch()
        for text in (texts.leg_of_block, texts.sums_of_block):
            found = self.read(
                text, names[text.__name__], structures=structures, given=made.given(), names=names
            )
            yield aligned(found)
        row = t.Name("l") * t.Number(made.width)
        alone = copies("out", members(what)) if struct else (copied(t.Name("out"), t.Name("found"), 6),)
        in_rows = tuple(
            copied(t.of("out", each) if struct else t.Name("out"), t.From(t.Name("row"), row + place), count)
            for each, place, count in members_in_order(what)
        )
        yield aligned(
            self.read(
                texts.batch_of_blocks,
                f"stewart_{self.name}_{what}_batch",
                structures=structures,
                given={
                    **made.given(),
                    **made.batch(),
                    **batches.BATCH,
                    "COPIED": alone if what == "derivatives" else in_rows,
                    "COPIED_ALONE": alone,
                    "IN_PLACE": tuple(in_place(what)),
                },
                names=names,
                public=True,
            )
        )
