"""Outputs of the kernels: the structure, blocks, and written functions of each, and their programs."""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import sympy as sp

from ..mechanics import closed_form as m
from ..mechanics import lumped_constants as p
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.closed_form import terms
from ..program.block import Block, Output, Quantity
from ..trace import nodes as t
from ..trace import read
from ..trace.function_text import Names
from ..trace.nodes import Field, Record, Structure
from .elimination import BLOCKS_IN_ARRAYS, CARRIED, DEFINITE, IN_ARRAYS, INVERSE, LONG_ROWS
from .layouts import Arguments, block_function, structure
from .prepare import block_arguments, model_functions, model_structures
from .prepare import result as _result
from .shared import legs_in_turn, shared
from .written import closed_form, elimination, forces, joint_rows, legs, solve

FORCES, EQUATIONS, FORWARD = "forces", "equations", "forward_dynamics"

Written = Callable[..., Any]


@dataclass(frozen=True)
class Text:
    """Written function with the content of its placeholders, ``given`` as for ``read.function``."""

    written: Written
    names: Names = field(default_factory=dict)
    given: Mapping[str, read.Given] = field(default_factory=dict)


Definition = Structure | Text | Callable[[], t.Function]
"""Content of a placeholder; blocks are converted when they are needed."""


def program(
    kernel: ForceKernel,
    sums: Collection[terms.SumKernel] = (),
    outputs: Collection[str] = (FORCES,),
    by_pivots: bool = False,
) -> t.Program:
    """Return the program of the preparation and of some of ``OUTPUTS``.

    ``kernel`` contains the blocks of the forces, whose prepared model all outputs use, and ``sums`` the
    kernels of the closed form. ``by_pivots`` omits the linear solver in two blocks.
    """
    of_model = {each.name: each for each in model_structures(kernel)}
    known = _texts(kernel) | _of_forces(kernel) | _NAMED
    if by_pivots:
        known["solve_legs"] = Text(solve.solve_by_pivots)
    for each in sums:
        known |= _of_sums(kernel, each)
    functions = {each.name: each for each in model_functions(kernel, of_model)}
    needed = _Needed(known, ("prepare", *outputs), of_model, functions)
    return needed.program(kernel.name)


def program_in_lanes(
    kernel: ForceKernel, sums: Collection[terms.SumKernel], outputs: Collection[str]
) -> t.Program:
    """Return the program of the closed form without the functions that differ with lanes.

    Sums, forces, ``singular_status``, and the checks of results have no bodies.
    """
    of_model = {each.name: each for each in model_structures(kernel)}
    known = _texts(kernel) | _NAMED
    of_pose: dict[str, Any] = {"model": Record("Model"), "motion": Record("Motion")}
    for each in sums:
        known |= _of_sums(kernel, each)
        name = prefix_of(each)
        found = {"legs": Record(f"{camel(name)}Legs"), "sums": Record(f"{camel(name)}Sums")}
        known[f"{name}_sums"] = partial(
            t.signature, f"{name}_sums", changed=("legs", "sums"), **of_pose, **found
        )
    for of, result in RESULTS.items():
        known[f"check_{of}"] = partial(t.signature, f"check_{of}", changed=("out",), out=Record(result.name))
    known["forces"] = partial(t.signature, "forces", Record("Forces"), **of_pose)
    known["place_blocks"] = Text(closed_form.place_blocks, given={"ROW": 6, "PART": 15})
    made = {"legs": "ForwardLegs", "summed": "ForwardSums", "out": "Accelerations"}
    known["accelerations_of"] = partial(
        t.signature, "accelerations_of", changed=("out",), **{each: Record(of) for each, of in made.items()}
    )
    known["singular_status"] = lambda: shared().by_name["singular_status"]
    needed = _Needed(known, tuple(outputs), of_model, {})
    return needed.program(kernel.name)


def sums_used(outputs: Collection[str], deep: bool = True) -> set[str]:
    """Return the names of the kernels whose sums outputs need; ``deep`` includes paths with lost digits."""
    called = _called(outputs, deep)
    return {each for each in m.NAMES if f"{PREFIX.get(each, each)}_sums" in called}


def solves(output: str) -> bool:
    """Return True if an output solves linear equations."""
    return any(each.startswith(("solve", "definite_six")) for each in _called((output,), deep=True))


def _called(outputs: Collection[str], deep: bool) -> set[str]:
    """Return the names of all functions that outputs call, directly or indirectly."""
    texts = {name: each for module in _MODULES for name, each in vars(module).items() if callable(each)}
    found: set[str] = set()
    waiting = list(outputs)
    while waiting:
        name = waiting.pop()
        if name not in found and (deep or not name.endswith("_apart")):
            found.add(name)
            waiting += read.used(texts[name]) if name in texts else []
    return found


@dataclass(frozen=True)
class _Needed:
    """Required structures and functions, each after its dependencies."""

    known: Mapping[str, Definition]
    public: tuple[str, ...]
    structures: dict[str, Structure]
    functions: dict[str, t.Function]

    def program(self, name: str) -> t.Program:
        """Return the program of the public functions with their dependencies."""
        for each in self.public:
            self.add(each)
        return t.Program(name, tuple(self.structures.values()), tuple(self.functions.values()))

    def add(self, name: str) -> None:
        """Return the functions of a name and their dependencies; nothing for a name without functions."""
        found = self._found(name)
        if found is None or name in self.structures or name in self.functions:
            return
        if isinstance(found, Structure):
            self._add_types(member.type for member in found.members)
            self.structures[name] = found
        elif isinstance(found, Text):
            for each in read.used(found.written, found.names, found.given):
                if each != name:
                    self.add(each)
            public = name in self.public
            self.functions[name] = read.function(
                found.written, self.structures, self.functions, name, public, found.given, found.names
            )
        else:
            made = found()
            self._add_types(argument.type for argument in made.arguments)
            self._add_types([] if made.result is None else [made.result])
            self.functions[name] = made

    def _add_types(self, types: Iterable[t.Type]) -> None:
        for each in types:
            kind = each.item if isinstance(each, t.Array) else each
            if isinstance(kind, Record):
                self.add(kind.name)

    def _found(self, name: str) -> Definition | None:
        """Return the definition of a name, or of a name that ends in a width."""
        text, _, width = name.rpartition("_")
        found = self.known.get(text)
        if name not in self.known and width.isdigit() and isinstance(found, Text):
            return replace(found, names={"WIDTH": int(width)})
        return self.known.get(name)


_MODULES = (legs, solve, forces, closed_form, joint_rows)


def _texts(kernel: ForceKernel) -> dict[str, Definition]:
    """Return every written function by its name."""
    found: dict[str, Definition] = {
        name: Text(text) for module in _MODULES for name, text in vars(module).items() if callable(text)
    }
    found["fault_of"] = Text(legs.fault_of, given=CARRIED)
    found["eliminate"] = Text(solve.eliminate, given=IN_ARRAYS)
    found["solve_legs"] = Text(solve.solve_legs, given=BLOCKS_IN_ARRAYS)
    found["solve_pivoted"] = Text(solve.solve_pivoted, given=LONG_ROWS)
    found["solve_definite"] = Text(solve.solve_definite, given=DEFINITE)
    found["singular_status"] = Text(solve.singular_status, given={**INVERSE, **CARRIED})
    at = inertia_at(lambda part, i, _: t.at(t.of("summed", part.name), i))
    six: dict[str, read.Given] = {"weigh_pivot": elimination.definite, "inertia": at, "right": _right}
    kept: dict[str, read.Given] = {"kept": t.Constant("KEPT"), "scale": lambda k: at(k, k)}
    found["accelerations_of"] = Text(closed_form.accelerations_of, given={**SIX, **six, **kept})
    found["place_blocks"] = Text(closed_form.place_blocks, given={"ROW": 3, "PART": 9})
    found["size_of"] = Text(solve.size_of, given={"BY_LEGS": 1})
    has_near = {"HAS_NEAR": int(kernel.leg_near_singular is not None)}
    found["forces"] = Text(forces.forces, given=legs_in_turn("sums", "leg", "turned") | has_near)
    return found


SIX: Mapping[str, read.Given] = {"definite_six": elimination.definite_six}
"""Functions that solve six equations with M."""


def inertia_at(place: Callable[[Quantity, int, int], t.Expression]) -> Callable[..., t.Expression]:
    """Return an element of the upper triangle of M from its parts.

    ``place`` takes the part, the index of the element in it, and the index in all three consecutive parts.
    """
    vv, vw, ww = terms.INERTIA

    def found(row: t.Number, column: t.Number) -> t.Expression:
        i, j = int(row.value), int(column.value)
        part, key = (vv, (i, j)) if j < 3 else (vw, (i, j - 3)) if i < 3 else (ww, (i - 3, j - 3))
        index = part.keys.index(key)
        return place(part, index, {vv: 0, vw: 6, ww: 15}[part] + index)

    return found


def _right(row: t.Number) -> t.Expression:
    """Return an element of the right side."""
    force, moment = terms.RIGHT
    return t.at(t.of("summed", (force if row.value < 3 else moment).name), int(row.value) % 3)


_LEG_OUTPUTS = (n.q, n.L, n.k3, n.D, n.H_force, n.c_force, n.c_moment)


def _numbers(*dims: int) -> t.Type:
    return t.Array(t.Real(), dims)


# ---------------------------------------------------------------- forces


def _of_forces(kernel: ForceKernel) -> dict[str, Definition]:
    """Return the blocks of the actuator forces, with moments about platform point 1."""
    blocks = [kernel.leg] if kernel.leg_near_singular is None else [kernel.leg, kernel.leg_near_singular]
    of_legs = [_complete(block, _LEG_OUTPUTS) for block in blocks]
    moments = _complete(kernel.moments, (n.H_moment, p.arm_c))
    shared = kernel.shared.made
    arguments = block_arguments(kernel, ("shared", "SharedTerms", shared))
    of_pose = {name: arguments[name] for name in ("platform", "motion")}
    own: Arguments = {"leg": ("LegTerms", (n.q, n.H_force, n.c_force))}
    tip: Arguments = {"sums": ("Sums", (p.q_1,))}
    right: Arguments = {"shared": ("SharedTerms", (n.c_force, n.c_moment))}
    structures = (
        structure("SharedTerms", "Terms of a pose that are common to all legs.", shared),
        structure("LegTerms", "Terms of one leg.", _LEG_OUTPUTS),
        structure("ShiftTerms", "The platform's part of c about platform point 1.", [p.c_tip]),
        structure("MomentTerms", "A leg's moments about platform point 1.", moments.made),
        structure(
            "Sums",
            "H, c, and what moments are made with.",
            [p.q_1],
            Field("c", _numbers(6), "N, N m: wrench that the axial forces balance, (36)"),
            Field("leg", t.Array(Record("LegTerms"), (6,)), "the legs"),
            Field("H", _numbers(6, 6), "1 and m: from x to the wrench on the platform, (36)"),
            Field("arm", _numbers(6, 3), "m: arms of the moments"),
        ),
    )
    names = zip(("leg_terms", "leg_near_terms"), of_legs, strict=False)
    found: dict[str, Definition] = {each.name: each for each in structures}
    found |= {name: partial(block_function, block, name, "LegTerms", arguments) for name, block in names}
    return found | {
        "shared_terms": partial(block_function, kernel.shared, "shared_terms", "SharedTerms", of_pose),
        "shift": partial(block_function, kernel.shift, "shift", "ShiftTerms", tip | right),
        "moments_of": partial(block_function, moments, "moments_of", "MomentTerms", own | tip),
    }


def _complete(block: Block, quantities: tuple[Quantity, ...]) -> Block:
    """Return the block with all of these outputs: missing outputs are zero, and a missing sine is one."""
    given = {out.quantity: out for out in block.outputs}
    absent = {n.k3: sp.S.One}
    outputs = [given.get(q, Output(q, (absent.get(q, sp.S.Zero),) * len(q.keys))) for q in quantities]
    return replace(block, outputs=tuple(outputs))


# ---------------------------------------------------------------- closed form


PREFIX = {"forward_dynamics": "forward", "bias_and_friction": "bias"}
"""Prefix of the names of a kernel's functions, where it is not the name of the kernel."""


def prefix_of(sums: terms.SumKernel) -> str:
    """Return the prefix of the function names of a kernel."""
    return PREFIX.get(sums.name, sums.name)


def camel(name: str) -> str:
    """Return ``JointRows`` for ``joint_rows``."""
    return "".join(word.capitalize() for word in name.split("_"))


def _of_sums(kernel: ForceKernel, sums: terms.SumKernel) -> dict[str, Definition]:
    """Return blocks and sums of one kernel of the closed form by name."""
    prefix = prefix_of(sums)
    name = camel(prefix)
    of_pose, of_leg, of_sums, of_legs = (f"{name}{part}" for part in ("Pose", "Leg", "Sums", "Legs"))
    pose = sums.pose.made
    arguments = block_arguments(kernel, ("pose", of_pose, pose), ("given", "LegInputs", m.GIVEN))
    before = {each: arguments[each] for each in ("platform", "motion")}
    given = {"Sums": of_sums, "Legs": of_legs, "Pose": of_pose}
    given |= {f"{part}_terms": f"{prefix}_{part}" for part in ("pose", "leg", "near")}
    given |= {"legs_of": f"{prefix}_legs", "total": f"{prefix}_total"}
    blocks = {"pose": (sums.pose, of_pose, before), "leg": (sums.leg, of_leg, arguments)}
    if sums.near is not None:
        blocks["near"] = (sums.near, of_leg, arguments)
    found: dict[str, Definition] = {
        of_pose: structure(of_pose, "The pose's own part.", pose),
        of_leg: structure(of_leg, "A leg's part.", sums.leg.made),
        of_sums: structure(of_sums, "Sums over the machine.", sums.summed),
        of_legs: _result(
            of_legs,
            "The legs.",
            Field("given", t.Array(Record("LegInputs"), (6,)), "what blocks are given"),
            Field("leg", t.Array(Record(of_leg), (6,)), "their parts"),
            Field("reach", _numbers(6), "m: size of the vectors that each is the sum of"),
            Field("leaning", t.Integer(), "1 where one is near its joint singularity"),
        ),
        f"{prefix}_total": Text(closed_form.total, given),
        f"{prefix}_legs": Text(closed_form.legs_of, given),
        f"{prefix}_sums": Text(
            closed_form.sums_of_two_forms if sums.name in m.OF_TWO_FORMS else closed_form.sums, given
        ),
    }
    for part, (block, result, reads) in blocks.items():
        found[f"{prefix}_{part}"] = partial(block_function, block, f"{prefix}_{part}", result, reads)
    return found


RESULTS = {
    "forces": _result(
        "Forces",
        "Actuator forces of one pose.",
        Field("F", _numbers(6), "N: positive when they extend the leg, (37)"),
    ),
    "equations": _result(
        "Equations",
        "M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext].",
        Field("M", _numbers(6, 6), "kg, kg m, kg m^2: inertia"),
        Field("C", _numbers(6, 6), "kg/s, kg m/s, kg m^2/s: Coriolis matrix"),
        Field("g", _numbers(6), "N, N m: gravity"),
        Field("friction", _numbers(6), "N, N m: friction"),
        Field("bias", _numbers(6), "N, N m: C [v; omega] + g"),
        Field("bias_and_friction", _numbers(6), "N, N m: C [v; omega] + g + friction"),
        Field("H", _numbers(6, 6), "1 and m: from F to the wrench on the platform"),
        Field("H_dot", _numbers(6, 6), "1/s and m/s: its rate"),
    ),
    "bias_and_friction": _result(
        "BiasAndFriction",
        "C [v; omega] + g + friction.",
        Field("bias_and_friction", _numbers(6), "N, N m: the sum"),
    ),
    "forward_dynamics": _result(
        "Accelerations",
        "Accelerations of the platform.",
        Field("a", _numbers(3), "m/s^2: acceleration of the reference point"),
        Field("alpha", _numbers(3), "rad/s^2: angular acceleration"),
    ),
    "joint_inertia": _result(
        "JointInertia",
        "Inertia that the actuators feel.",
        Field("inertia", _numbers(6, 6), "kg: H^-1 M H^-T"),
    ),
    "derivatives": _result(
        "Derivatives",
        "Actuator forces and their derivatives.",
        Field("F", _numbers(6), "N: of inverse dynamics"),
        Field("by_pose", _numbers(6, 6), "N/m, N: by [dt; dphi]"),
        Field("by_twist", _numbers(6, 6), "N s/m, N s: by [v; omega]"),
        Field("by_acceleration", _numbers(6, 6), "kg, kg m: by [a; alpha]"),
    ),
    "linearization": _result(
        "LinearizationResult",
        "Forward dynamics and its linearization.",
        Field("a", _numbers(3), "m/s^2: acceleration of the reference point"),
        Field("alpha", _numbers(3), "rad/s^2: angular acceleration"),
        Field("A", _numbers(12, 12), "by [dt; dphi; dv; domega]"),
        Field("B", _numbers(12, 6), "by the actuator forces"),
    ),
}
"""The structure that each output fills."""


def arrays(result: Structure) -> list[Field]:
    """Return the result arrays of an output: its members except the status."""
    return [each for each in result.members if each.name != "status"]


def check_arrays(results: Mapping[str, Structure]) -> None:
    """Raise ValueError, in one line, if a member of an output is not an array of numbers."""
    for of, result in results.items():
        for each in arrays(result):
            if not isinstance(each.type, t.Array) or each.type.item != t.Real():
                expected = f'Field("{each.name}", _numbers(n), ...), of one number _numbers(1)'
                raise ValueError(f"RESULTS: {of}: {each.name}: expected {expected}, got {each.type}")


check_arrays(RESULTS)
OUTPUTS = tuple(RESULTS)
FORCED = ("forward_dynamics", "linearization")
"""Outputs that take the actuator forces."""

_STRUCTURES = (
    structure("LegInputs", "Inputs of the blocks of a leg.", m.GIVEN),
    Structure(
        "Rows",
        "M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform.",
        (
            Field("given", t.Array(Record("LegInputs"), (6,)), "inputs of the derivatives, one for each leg"),
            Field("extent", _numbers(24), "root of the inertia in each row"),
            Field("weight", _numbers(24, 3), "1: W in blocks of three rows"),
            Field("row", _numbers(24, 6), "A, each row times the root of its inertia; then L and U"),
            Field("share", _numbers(24, 6), "each row as a sum of the six that serve as coordinates"),
            Field("inertia", _numbers(6, 6), "M in these coordinates"),
            Field("order", t.Array(t.Integer(), (24,)), "number of the row in each place"),
            Field("column", t.Array(t.Integer(), (6,)), "number of the column in each place"),
            Field("length", t.Real(), "m: moments and rotations are measured by it"),
        ),
    ),
    _result("Apart", "Result of the rows.", Field("x", _numbers(6), "m/s^2, rad/s^2: a and alpha")),
    _result(
        "SlopesApart",
        "Result of the rows for a linearization.",
        Field("x", _numbers(6), "m/s^2, rad/s^2: a and alpha"),
        Field("A", _numbers(6, 24), "the rows solved"),
    ),
)
_NAMED: dict[str, Definition] = {each.name: each for each in (*RESULTS.values(), *_STRUCTURES)}
_NAMED |= {f"check_{of}": Text(forces.check, {"Result": each.name}) for of, each in RESULTS.items()}
