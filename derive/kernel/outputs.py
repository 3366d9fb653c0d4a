"""Every output that kernels have as trees: the structures, blocks and written functions that each needs."""

from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from .. import motion as m
from .. import notation as n
from .. import prepared as p
from ..block import Block, Output, Quantity
from ..regroup import ForceKernel
from . import read
from .lower import Arguments, block_function, stored_type, structure
from .model import STATUS_FIELD, block_arguments, model_functions, model_structures, sum_function
from .nodes import Array, Field, Function, Integer, Program, Real, Record, Structure, Type
from .written import closed_form, forces, legs, solve

FORCES, EQUATIONS, FORWARD = "forces", "equations", "forward_dynamics"
OUTPUTS = (FORCES, EQUATIONS, FORWARD)

Written = Callable[..., Any]


@dataclass(frozen=True)
class Part:
    """What one output adds to a program."""

    structures: list[Structure]
    blocks: list[Function]
    sums: list[tuple[str, str, str]]
    written: dict[str, Written]


def program(
    kernel: ForceKernel, sums: Collection[m.SumKernel] = (), outputs: Collection[str] = (FORCES,)
) -> Program:
    """Preparation and some of ``OUTPUTS``, of one pose or of many side by side.

    kernel: the forces' blocks, whose prepared model serves all; sums: those of the closed form. Raises
    ValueError for an output that is not one of ``OUTPUTS``.
    """
    unknown = [each for each in outputs if each not in OUTPUTS]
    if unknown:
        raise ValueError(f"outputs: expected some of {', '.join(OUTPUTS)}, got {unknown[0]}")
    by_name = {each.name: each for each in sums}
    parts = [
        Part(
            model_structures(kernel),
            [],
            [],
            {"per_length_of": forces.per_length_of, "prepare": forces.prepare} | _LEGS,
        )
    ]
    if FORCES in outputs:
        parts.append(_forces(kernel))
    if EQUATIONS in outputs:
        parts.append(_equations(kernel, by_name["equations"]))
    if FORWARD in outputs:
        parts.append(_forward(kernel, by_name["forward_dynamics"], by_name["joint_rows"]))
    structures = {each.name: each for part in parts for each in part.structures}
    functions = {each.name: each for each in model_functions(kernel, structures)}
    for part in parts:
        functions |= {each.name: each for each in part.blocks}
        for name, total, more in part.sums:
            functions[name] = sum_function(name, "The sums with one part more.", structures[total], more)
    for name, text in {name: text for part in parts for name, text in part.written.items()}.items():
        functions[name] = read.function(text, structures, functions, name, name in ("prepare", *outputs))
    return Program(kernel.name, tuple(structures.values()), tuple(functions.values()))


_LEGS: dict[str, Written] = {"fault_of": legs.fault_of, "reach_of": legs.reach_of}
_LEG_OUTPUTS = (n.q, n.L, n.k3, n.D, n.H_force, n.c_force, n.c_moment)


def _result(name: str, meaning: str, *members: Field) -> Structure:
    return Structure(name, meaning, (*members, STATUS_FIELD))


def _numbers(*dims: int) -> Type:
    return Array(Real(), dims)


def _quantities(block: Block) -> tuple[Quantity, ...]:
    return tuple(out.quantity for out in block.outputs)


# ---------------------------------------------------------------- forces


def _forces(kernel: ForceKernel) -> Part:
    """The actuator forces; moments about platform point 1."""
    blocks = [kernel.leg] if kernel.leg_near_pole is None else [kernel.leg, kernel.leg_near_pole]
    of_legs = [_complete(block, _LEG_OUTPUTS) for block in blocks]
    moments = _complete(kernel.moments, (n.H_moment, p.arm_c))
    shared = _quantities(kernel.shared)
    arguments = block_arguments(kernel, ("shared", "SharedTerms", shared))
    of_pose = {name: arguments[name] for name in ("platform", "motion")}
    own: Arguments = {"leg": ("LegTerms", (n.q, n.H_force, n.c_force))}
    tip: Arguments = {"sums": ("Sums", (p.q_1,))}
    right: Arguments = {"shared": ("SharedTerms", (n.c_force, n.c_moment))}
    names = zip(("leg_terms", "leg_near_terms"), of_legs, strict=False)
    return Part(
        [
            structure("SharedTerms", "What a pose has for all legs.", shared),
            structure("LegTerms", "What a leg has.", _LEG_OUTPUTS),
            structure("ShiftTerms", "The platform's part of c about platform point 1.", [p.c_tip]),
            structure("MomentTerms", "A leg's moments about platform point 1.", _quantities(moments)),
            structure(
                "Sums",
                "H, c, and what moments are made with.",
                (n.c_force, n.c_moment, p.q_1),
                Field("H", _numbers(6, 6), "1 and m: from x to the wrench on the platform, (36)"),
                Field("arm", _numbers(6, 3), "m: arms of the moments"),
            ),
            _result(
                "Forces",
                "Actuator forces of one pose.",
                Field("F", _numbers(6), "N: positive when they extend the leg, (37)"),
            ),
        ],
        [
            block_function(kernel.shared, "shared_terms", "SharedTerms", of_pose),
            *(block_function(block, name, "LegTerms", arguments) for name, block in names),
            block_function(kernel.shift, "shift", "ShiftTerms", tip | right),
            block_function(moments, "moments_of", "MomentTerms", own | tip),
        ],
        [],
        {
            "leg_of": forces.leg_of if len(of_legs) > 1 else forces.leg_of_one_form,
            "add_leg": forces.add_leg,
            "eliminate": solve.eliminate,
            "singular_status": solve.singular_status,
            "forces": forces.forces,
        },
    )


def _complete(block: Block, quantities: tuple[Quantity, ...]) -> Block:
    """The block with all of these outputs: zero where it has none, and a sine of one."""
    given = {out.quantity: out for out in block.outputs}
    absent = {n.k3: sp.S.One}
    outputs = [given.get(q, Output(q, (absent.get(q, sp.S.Zero),) * len(q.keys))) for q in quantities]
    return replace(block, outputs=tuple(outputs))


# ---------------------------------------------------------------- closed form


def _sum_part(kernel: ForceKernel, sums: m.SumKernel, name: str, prefix: str) -> Part:
    """Blocks and sums of one kernel: prefix and ``_pose``, ``_leg``, ``_more``, ``_total``."""
    pose = _quantities(sums.pose)
    arguments = block_arguments(kernel)
    of_pose = {each: arguments[each] for each in ("platform", "motion")}
    if set(sums.leg.inputs) & set(pose):
        arguments |= {"pose": (f"{name}Pose", tuple(q for q in pose if q in sums.leg.inputs))}
    if m.F_LEG in sums.leg.inputs:
        arguments |= {"F": ("", (m.F_LEG,))}
    legs_of = {"leg": sums.leg} if sums.near is None else {"leg": sums.leg, "near": sums.near}
    return Part(
        [
            structure(f"{name}Pose", "The pose's own part.", pose),
            structure(f"{name}Leg", "A leg's part.", _quantities(sums.leg)),
            structure(f"{name}Sums", "Sums over the machine.", sums.summed),
        ],
        [
            block_function(sums.pose, f"{prefix}_pose", f"{name}Pose", of_pose),
            *(
                block_function(block, f"{prefix}_{which}", f"{name}Leg", arguments)
                for which, block in legs_of.items()
            ),
        ],
        [(f"{prefix}_more", f"{name}Sums", f"{name}Leg"), (f"{prefix}_total", f"{name}Sums", f"{name}Pose")],
        {},
    )


def _equations(kernel: ForceKernel, sums: m.SumKernel) -> Part:
    part = _sum_part(kernel, sums, "Equations", "equations")
    result = _result(
        "Equations",
        "M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext].",
        Field("M", _numbers(6, 6), "kg, kg m, kg m^2: inertia"),
        Field("C", _numbers(6, 6), "kg/s, kg m/s, kg m^2/s: Coriolis matrix"),
        Field("g", _numbers(6), "N, N m: gravity"),
        Field("friction", _numbers(6), "N, N m: friction"),
        Field("bias", _numbers(6), "N, N m: C [v; omega] + g + friction"),
        Field("H", _numbers(6, 6), "1 and m: from F to the wrench on the platform"),
    )
    written: dict[str, Written] = {
        "place_symmetric": closed_form.place_symmetric,
        "place_inertia": closed_form.place_inertia,
        "equations": closed_form.equations,
    }
    return replace(part, structures=[*part.structures, result], written=written)


def _forward(kernel: ForceKernel, sums: m.SumKernel, rows: m.SumKernel) -> Part:
    part = _sum_part(kernel, sums, "Forward", "forward")
    apart = _sum_part(kernel, rows, "JointRows", "joint_rows")
    structures = [
        *part.structures,
        *apart.structures,
        Structure(
            "RowBlock",
            "Three rows of A.",
            (
                Field("extent", _numbers(3), "root of the inertia in each row"),
                Field("weight", _numbers(3, 3), "1: their inertia over these"),
            ),
        ),
        Structure(
            "Rows",
            "M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform.",
            (
                Field("leg", Array(Record("JointRowsLeg"), (6,)), "what legs have"),
                Field("block", Array(Record("RowBlock"), (8,)), "of legs, and two of the platform"),
                Field("row", _numbers(24, 6), "A, each row times the root of its inertia; then multipliers"),
                Field("share", _numbers(24, 6), "each row as a sum of the six that serve as coordinates"),
                Field("factors", _numbers(6, 6), "L and U of these six, columns exchanged"),
                Field("column", Array(Integer(), (6,)), "number of the column in each place"),
                Field("place", _numbers(6, 24), "1 where a row is the one picked in a place, else 0"),
                Field("chosen", _numbers(24), "1 of a row that was picked, else 0"),
                Field("length", Real(), "m: moments and rotations are measured by it"),
            ),
        ),
        _result("Apart", "What the rows give.", Field("x", _numbers(6), "m/s^2, rad/s^2: a and alpha")),
        _result(
            "Accelerations",
            "Accelerations of the platform.",
            Field("a", stored_type(n.a), "m/s^2: acceleration of the reference point"),
            Field("alpha", stored_type(n.alpha), "rad/s^2: angular acceleration"),
        ),
    ]
    names = (
        "weigh",
        "make_rows",
        "pick_rows",
        "balance_rows",
        "solve_rows",
        "forward_apart",
        "forward_dynamics",
    )
    written: dict[str, Written] = {
        "place_symmetric": closed_form.place_symmetric,
        "place_inertia": closed_form.place_inertia,
        "solve_definite": solve.solve_definite,
    }
    written |= {name: getattr(closed_form, name) for name in names}
    return Part(structures, [*part.blocks, *apart.blocks], [*part.sums, *apart.sums], written)
