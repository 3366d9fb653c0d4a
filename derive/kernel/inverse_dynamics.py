"""Every term of inverse dynamics as a tree: D, K, H and c of one pose or of many side by side."""

from .. import notation as n
from ..kernels import Kernel
from . import read
from .lower import block_function, structure
from .nodes import Array, Field, Program, Real, Record, Structure
from .written import inverse_dynamics as written

TERMS = "terms"


def terms_program(kernel: Kernel) -> Program:
    """A kernel's leg and platform with their sums; nothing is solved and nothing checked."""
    robot = {"robot": ("Robot", n.PLATFORM), "motion": ("Motion", n.MOTION)}
    structures = [
        structure("Leg", "One leg.", n.LEG),
        structure("Robot", "The machine.", n.PLATFORM, Field("leg", Array(Record("Leg"), (6,)), "the legs")),
        structure("Motion", "Motion of the platform and its load.", n.MOTION),
        structure("LegDynamics", "What a leg has.", [out.quantity for out in kernel.leg.outputs]),
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
        block_function(kernel.leg, "leg_dynamics", "LegDynamics", {"leg": ("Leg", n.LEG), **robot}),
    ]
    known = {each.name: each for each in structures}
    functions = {each.name: each for each in blocks}
    terms = read.function(written.terms, known, functions, TERMS, True)
    return Program(kernel.formulation.kernel_name, tuple(structures), (*blocks, terms))
