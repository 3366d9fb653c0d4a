"""The prepared model as a tree: structures of a robot's constants, and the functions that fill them."""

from ..mechanics import lumped_constants as p
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..program.block import Quantity
from .tree import nodes as t
from .tree import read
from .tree.lower import Arguments, block_function, structure
from .written import forces

STATUS_FIELD = t.Field("status", t.Integer(), "0, or what is wrong")


def result(name: str, meaning: str, *members: t.Field) -> t.Structure:
    """What a function returns: members, and a status."""
    return t.Structure(name, meaning, (*members, STATUS_FIELD))


def machine_structures(drive: bool = False, more: tuple[Quantity, ...] = ()) -> list[t.Structure]:
    """The robot and the motion; drive: the robot's legs have rotors; more: what else they have."""
    legs = t.Field("leg", t.Array(t.Record("Leg"), (6,)), "the legs")
    return [
        structure("Leg", "One leg.", (*(n.OF_LEG if drive else n.LEG), *more)),
        structure("Robot", "The machine.", n.PLATFORM, legs),
        structure("Motion", "Motion of the platform and its load.", n.MOTION),
    ]


def model_structures(kernel: ForceKernel) -> list[t.Structure]:
    """The robot, the motion, and the constants that a kernel prepares."""
    return [
        *machine_structures(n.m_r in kernel.prepare_leg.inputs, kernel.more_of_legs()),
        structure("LegConstants", "Prepared constants of one leg.", kernel.prepare_leg.made),
        structure("Added", "What the legs add to the platform's constants.", p.ADDED),
        structure("Platform", "Constants of the platform.", kernel.platform_constants()),
        result(
            "Model",
            "A robot's constants, prepared once.",
            t.Field("leg", t.Array(t.Record("LegConstants"), (6,)), "the legs"),
            t.Field("platform", t.Record("Platform"), "the platform"),
            t.Field("per_length", t.Real(), "1/m: one over the length over which moments are taken"),
            t.Field("arm_cube", t.Real(), "cube of the largest arm over that length"),
        ),
    ]


def model_functions(kernel: ForceKernel, structures: dict[str, t.Structure]) -> list[t.Function]:
    """What ``written.forces.prepare`` calls."""
    robot: Arguments = {"robot": ("Robot", n.PLATFORM), "p_1": ("", (n.p_1,))}
    leg: Arguments = {"leg": ("Leg", (*n.OF_LEG, *kernel.more_of_legs()))}
    return [
        block_function(kernel.prepare_leg, "prepare_leg", "LegConstants", robot | leg),
        block_function(
            kernel.prepare_platform, "prepare_platform", "Platform", robot | {"total": ("Added", p.ADDED)}
        ),
        *(read.function(text, structures, {}) for text in (forces.add_up, forces.lost_digits)),
    ]


def block_arguments(kernel: ForceKernel, *more: tuple[str, str, tuple[Quantity, ...]]) -> Arguments:
    """Arguments of a leg's block: constants, the motion, and ``more``: name, structure, what it holds."""
    return {
        "leg": ("LegConstants", kernel.leg_constants()),
        "platform": ("Platform", kernel.platform_constants()),
        "motion": ("Motion", n.MOTION),
        **{name: (kind, held) for name, kind, held in more},
    }
