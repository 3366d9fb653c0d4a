"""Every term of inverse dynamics as a tree: D, K, H, c and joint reactions of one pose or of many."""

from .. import notation as n
from ..block import Block, Quantity
from ..kernels import Kernel
from . import read
from .lower import block_function, structure
from .nodes import Array, Field, Program, Real, Record, Structure
from .shared import ABOUT_REFERENCE
from .written import inverse_dynamics as written

TERMS, REACTIONS = "terms", "leg_reactions"


def terms_program(kernel: Kernel) -> Program:
    """A kernel's leg and platform with their sums, and a leg's reactions; nothing is solved or checked."""
    leg = {"leg": ("Leg", n.LEG)}
    axial = {"x": ("", (n.x,)), "bearing": ("", (n.bearing,))}
    robot = {"robot": ("Robot", n.PLATFORM), "motion": ("Motion", n.MOTION)}
    structures = [
        structure("Leg", "One leg.", n.LEG),
        structure("Robot", "The machine.", n.PLATFORM, Field("leg", Array(Record("Leg"), (6,)), "the legs")),
        structure("Motion", "Motion of the platform and its load.", n.MOTION),
        structure("LegDynamics", "What a leg has.", _outputs(kernel.leg)),
        structure("LegReactions", "Forces and moments in a leg's joints.", _outputs(kernel.reactions)),
        structure("PlatformWrench", "The platform's part of c.", [n.c_force, n.c_moment]),
        Structure(
            "Terms",
            "Terms of F = D - x, H x = c; moments about the reference point.",
            (
                Field("D", Array(Real(), (6,)), "N: known part of the actuator force, (24)"),
                Field(
                    "K", Array(Real(), (6, 3)), "N: transverse force on the leg at its spherical joint, (21)"
                ),
                Field("H", Array(Real(), (6, 6)), "1 and m: from x to the wrench on the platform, (36)"),
                Field("c", Array(Real(), (6,)), "N, N m: wrench that the axial forces balance, (36)"),
            ),
        ),
    ]
    blocks = [
        block_function(kernel.platform, "platform_wrench", "PlatformWrench", robot),
        block_function(kernel.leg, "leg_dynamics", "LegDynamics", leg | robot),
        block_function(kernel.reactions, REACTIONS, "LegReactions", leg | robot | axial),
    ]
    known = {each.name: each for each in structures}
    functions = {each.name: each for each in blocks}
    terms = read.function(written.terms, known, functions, TERMS, True, ABOUT_REFERENCE)
    return Program(kernel.formulation.kernel_name, tuple(structures), (*blocks, terms))


def _outputs(block: Block) -> list[Quantity]:
    return [out.quantity for out in block.outputs]
