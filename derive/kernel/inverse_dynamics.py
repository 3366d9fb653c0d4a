"""Inverse dynamics with all terms, joint reactions, and the regressor, as trees.

The numbers of the six legs are consecutive for interpreters, and side by side for arrays.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import sympy as sp

from ..mechanics import quantities as n
from ..mechanics.inverse_dynamics import Kernel
from ..mechanics.platform import platform
from ..mechanics.regressor import Regressor
from ..program.block import Block, Output
from ..program.cse import share
from ..trace import nodes as t
from ..trace import read
from .elimination import CARRIED, INVERSE, ONCE
from .layouts import Arguments, Written, block_function, entries, structure
from .prepare import ABOUT_REFERENCE as SIZES
from .prepare import machine_structures, result
from .shared import legs_in_turn
from .written import inverse_dynamics as written
from .written import legs, solve

TERMS, REACTIONS = "terms", "leg_reactions"

_OF_LEG: Arguments = {"leg": ("Leg", n.OF_LEG)}
_OF_POSE: Arguments = {"robot": ("Robot", n.PLATFORM), "motion": ("Motion", n.MOTION)}
_AXIAL: Arguments = {"x": ("", (n.x,)), "bearing": ("", (n.bearing,))}
_TERMS = t.Structure(
    "Terms",
    "Terms of F = D - x, H x = c; moments about the reference point.",
    (
        t.numbers("D", 6, meaning="N: known part of the actuator force, (24)"),
        t.numbers("K", 6, 3, meaning="N: transverse force on the leg at its spherical joint, (21)"),
        t.numbers("H", 6, 6, meaning="1 and m: from x to the wrench on the platform, (36)"),
        t.numbers("c", 6, meaning="N, N m: wrench that the axial forces balance, (36)"),
    ),
)
_FORCES = result(
    "Forces",
    "Actuator forces, and what they are made of.",
    t.numbers("F", 6, meaning="N: actuator forces, (37)"),
    t.numbers("x", 6, meaning="N: axial forces of the legs at the platform, (36)"),
    t.Field("terms", t.Record("Terms"), "D, K, H and c"),
    t.Field("legs", t.Record("Legs"), "what the legs have"),
    t.numbers("reach", meaning="m: size of the vectors that each leg is the sum of"),
    t.Field("suspect", t.Integer(), "1 where H may be singular to rounding"),
)


def _column(row: t.Expression, column: t.Expression) -> t.Expression:
    """Return an entry of [H | c]; columns of H are side by side in its rows."""
    return t.Element(t.Name("c"), (row,)) if column == t.Number(6) else t.Element(t.Name("H"), (row, column))


_ELIMINATION: Mapping[str, read.Given] = {
    **ONCE,
    "a": _column,
    "bring": written.exchange_rows,
    "update": written.by_whole_rows,
}


def terms_program(kernel: Kernel) -> t.Program:
    """Return the program of the terms and reactions, leg by leg, without solution and checks."""
    of_leg = structure("LegDynamics", "Terms of one leg.", kernel.leg.made)
    held = t.Field("leg", t.Array(t.Record(of_leg.name), (6,)), "each of them")
    of_legs = t.Structure("Legs", "Terms of the legs.", (held,))
    structures = [*machine_structures(kernel.formulation.drive), of_leg, of_legs, *_results(kernel), _TERMS]
    texts = Written.of(structures, _blocks(kernel, kernel.leg, of_leg.name))
    texts.function(written.legs_in_turn, "legs_of")
    texts.function(written.leg_of_array, "leg_of")
    texts.function(written.terms_of, given=legs_in_turn("out", "leg"))
    texts.function(written.terms, TERMS, public=True)
    return texts.program(kernel.formulation.kernel_name)


def arrays_program(kernel: Kernel) -> t.Program:
    """Return the inverse dynamics and joint reactions with legs side by side."""
    leg = kernel.leg
    if n.k3 not in leg.made:
        leg = replace(leg, outputs=(*leg.outputs, Output(n.k3, (sp.S.One,))))
    of_legs = structure("Legs", "Terms of the legs.", leg.made)
    structures = [*_machine(), of_legs, *_results(kernel), _TERMS, _FORCES]
    _, *own = _blocks(kernel, leg, of_legs.name)
    texts = Written.of(structures, [*shared_program().functions, *own])
    texts.function(written.legs_side_by_side, "legs_of")
    summed = entries((n.D, n.K, n.H_force, n.H_moment, n.c_force, n.c_moment))
    texts.function(written.leg_of_lanes, "leg_of", given={"SUMMED": summed})
    texts.add(written.terms_of, given=legs_in_turn("out", "leg"))
    texts.add(written.terms, written.solved, written.inverse_dynamics)
    return texts.program(kernel.formulation.kernel_name)


@cache
def shared_program() -> t.Program:
    """Return the common part of programs with legs side by side: structures, platform, checks, and solve."""
    block = share(platform()[0])
    structures = [*_machine(), _wrench(block), _TERMS]
    texts = Written.of(structures, [block_function(block, block.name, "PlatformWrench", _OF_POSE)])
    texts.add(legs.largest_component, legs.reach_of, legs.fault_of, written.first_of, given=CARRIED)
    texts.add(solve.singular_status, given={**INVERSE, **CARRIED})
    texts.add(solve.per_length_of, written.largest_of)
    texts.add(written.scale_of, given={"SMALLEST": t.Number(SIZES[0])})
    texts.add(written.eliminate, given=_ELIMINATION)
    return texts.program("every_output")


def regressor_program(blocks: Regressor) -> t.Program:
    """Return the columns of the regressor with legs side by side."""
    of_legs = structure("RegressorOfLegs", "Columns of the legs.", blocks.leg.made)
    of_platform = structure("RegressorOfPlatform", "Columns of the platform.", blocks.platform.made)
    legs = t.Field("legs", t.Record(of_legs.name), "of the legs")
    platform = t.Field("platform", t.Record(of_platform.name), "of the platform")
    structures = [*_machine(), of_legs, of_platform, result("Regressor", "Columns of Y.", legs, platform)]
    of_leg = block_function(blocks.leg, blocks.leg.name, of_legs.name, _OF_LEG | _OF_POSE)
    of_pose = block_function(blocks.platform, blocks.platform.name, of_platform.name, _OF_POSE)
    texts = Written.of(structures, [*shared_program().functions, of_leg, of_pose])
    texts.add(written.regressor)
    return texts.program("regressor")


def rotor_program(columns: Block) -> t.Program:
    """Return the columns of the rotors with legs side by side."""
    of_legs = structure("RotorColumns", "Columns of the legs' rotors.", columns.made)
    made = block_function(columns, "rotor_columns", of_legs.name, _OF_LEG | _OF_POSE)
    return Written.of([*_machine(), of_legs], [made]).program("rotor")


def _machine() -> list[t.Structure]:
    """Return the structures of the robot, with its legs side by side, and of the motion."""
    leg, robot, motion = machine_structures()
    side_by_side = t.Field("leg", t.Record("Leg"), "the legs, in each number one value for each leg")
    return [leg, replace(robot, members=(*robot.members[:-1], side_by_side)), motion]


def _blocks(kernel: Kernel, leg: Block, result: str) -> list[t.Function]:
    return [
        block_function(kernel.platform, kernel.platform.name, "PlatformWrench", _OF_POSE),
        block_function(leg, "leg_dynamics", result, _OF_LEG | _OF_POSE),
        block_function(kernel.reactions, REACTIONS, "LegReactions", _OF_LEG | _OF_POSE | _AXIAL),
    ]


def _results(kernel: Kernel) -> list[t.Structure]:
    return [
        structure("LegReactions", "Forces and moments in a leg's joints.", kernel.reactions.made),
        _wrench(kernel.platform),
    ]


def _wrench(platform: Block) -> t.Structure:
    return structure("PlatformWrench", "The platform's part of c.", platform.made)
