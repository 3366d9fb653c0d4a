"""Preparation of a robot: the blocks of its constants as functions, and the length that scales moments.

All operations of a kernel except one are homogeneous in the units of length, mass, and time. Therefore units
that differ by powers of two give identical bits. The exception is the choice of a pivot, which compares force
rows, without unit, with moment rows, in meters. The length that scales moments is a power of two, so that it
influences only this choice. For platforms of about a meter it is 1, and no solve multiplies by it.
"""

import math
from collections.abc import Iterable
from typing import Any

from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.lumped_constants import ADDED
from ..program.block import Block, Quantity
from ..trace import nodes as t
from ..trace import read
from ..trace.constants import LARGEST, SMALLEST
from ..trace.read import Given
from . import layouts as lay
from .written import forces, solve

ABOUT_REFERENCE = SMALLEST / 2, LARGEST
"""``SMALLEST`` and ``LARGEST`` for arms from the reference point, which is amid most platforms."""
PER_LENGTH = t.Field(
    "per_length",
    t.Real(),
    f"1/m: factor of the moment rows of H and c in the linear solver. It is 1 if the largest coordinate of "
    f"the arms p_i - p_1 is {SMALLEST:g} m to {LARGEST:g} m. Otherwise it is the reciprocal of the smallest "
    "power of two that is not below this coordinate, and each pose requires 18 to 21 more multiplications.",
)
ARM_CUBE = t.Field(
    "arm_cube",
    t.Real(),
    "1: (largest coordinate of p_i - p_1, times per_length)^3, the scale of determinants of moments",
)
ROBOT = t.Structure(
    "stewart_robot",
    "",
    (t.Field("leg", t.Array(t.Record("stewart_leg"), (6,))), *map(lay.stored, n.PLATFORM)),
)
_LEG_SAYS = (
    "One leg. The origin of frame D is the base point, and the origin of frame U the platform point. In both "
    "frames x is along the leg and y along the moving axis of the universal joint. Inertias have the order "
    "xx xy xz yy yz zz."
)
LEG = t.Structure("stewart_leg", "", tuple(map(lay.stored, n.OF_LEG)))
MOTION = t.Structure("stewart_motion", "", tuple(map(lay.stored, n.MOTION)))
LUMPED = t.Structure(
    "lumped_terms", "Contributions of a leg to the constants of the platform.", tuple(map(lay.stored, ADDED))
)


def model_says(members: Iterable[t.Field], more: str = "") -> str:
    """Describe the structure of a prepared model: ``more``, frames, and storage order."""
    said = " ".join(each.meaning for each in members)
    frame = " The leg frame has x along the leg and y along the moving axis of the universal joint."
    order = " Inertias have the order xx xy xz yy yz zz."
    return (
        f"Prepared constants of a robot.{more}{frame if 'leg frame' in said else ''}"
        f"{order if 'J_' in said or 'inertia' in said else ''}"
    )


def prepared_words(kernel: ForceKernel) -> dict[str, Any]:
    """Return the words of the description of ``prepare``, which depend on the use of the fixed axis."""
    if not list(axis(kernel.prepare_leg)):
        return {"any_axis": "", "zero_axis": ""}
    return {
        "any_axis": " The vectors k may have any length except zero.",
        "zero_axis": ", or a vector k is zero",
    }


def motion_words(kernel: ForceKernel) -> dict[str, Any]:
    """Return the words of the descriptions of the forces: members of the motion, and a status."""
    read = [q.name for q in kernel.used_motion()]
    return {
        "motion_read": f"{', '.join(read[:-1])}, and {read[-1]}",
        "motion_needed": ", ".join(q.name for q in kernel.used_motion() if q not in (n.F_ext, n.M_ext)),
        "joint_singular": "STEWART_JOINT_SINGULAR, " if n.k3 in kernel.leg.made else "",
    }


def raw_structures(kernel: ForceKernel) -> tuple[t.Structure, t.Structure]:
    """Structures of robot and leg for the preparation: from ``stewart.h``, or defined by the kernel."""
    more = kernel.more_of_legs()
    if not more:
        return ROBOT, LEG
    name = f"stewart_{kernel.fidelity}"
    leg = lay.structure(f"{name}_leg", _LEG_SAYS, (*n.OF_LEG, *more))
    legs = t.Field("leg", t.Array(t.Record(leg.name), (6,)))
    robot = t.Structure(
        f"{name}_robot", "Robot: legs, platform, and gravity.", (legs, *map(lay.described, n.PLATFORM))
    )
    return robot, leg


HANDED_OVER: dict[str, Given] = {"hand_over": solve.handed_over}
"""Last statements of the functions of the preparation."""


def per_length(size: float) -> float:
    """Structure that ``written.solve.per_length_of`` returns."""
    if SMALLEST <= size <= LARGEST or size == 0.0:
        return 1.0
    fraction, exponent = math.frexp(size)
    return math.ldexp(1.0, min(max((fraction == 0.5) - exponent, -100), 100))


def is_scaled(kernel: ForceKernel) -> bool:
    """Return True if moments may be scaled; for a prepared model this is decided when it is prepared."""
    return kernel.constants is None or per_length(kernel.size) != 1.0


def flags(kernel: ForceKernel) -> dict[str, Given]:
    """Properties of a kernel that the texts of the forces depend on."""
    given, baked = kernel.leg.exprs, kernel.constants is not None
    unit = per_length(kernel.size)
    return {
        "BAKED": int(baked),
        "HAS_D": int(n.D in given),
        "HAS_SINE": int(n.k3 in given),
        "HAS_NEAR": int(kernel.leg_near_singular is not None),
        "SCALED": 0 if not is_scaled(kernel) else 2 if baked else 1,
        "SMALLEST": t.Number(SMALLEST),
        "PER_LENGTH": t.Number(unit),
        "UNIT_OF_MOMENTS": t.Number(unit) if baked else t.of("model", "per_length"),
        "ARM_CUBE": t.Number((kernel.size * unit) ** 3) if baked else t.of("model", "arm_cube"),
    }


def size_of(texts: lay.Written, by_legs: bool) -> t.Function:
    """Return the largest arm of a prepared model; with ``by_legs``, its legs are consecutive."""
    return texts.function(solve.size_of, given={"BY_LEGS": int(by_legs)})


def preparation(texts: lay.Written, kernel: ForceKernel, *lane: t.Name) -> list[t.Function]:
    """Return both blocks of the preparation; ``lane`` is the index of a leg if the legs are in lanes."""
    given = dict(zip(("robot", "leg"), raw_structures(kernel), strict=True)) | {"sum": LUMPED}
    first, second, third = (t.Argument(name, t.Record(each.name)) for name, each in given.items())
    leg, platform = (
        t.Argument("out", t.Record(texts.structures["Model" if lane else each].name), changed=True)
        for each in ("Leg", "Platform")
    )
    added = t.Argument("added", t.Record(LUMPED.name), changed=True)
    lanes = (t.Argument(each.name, t.Integer()) for each in lane)
    of_leg = _prepared(kernel.prepare_leg, (first, second, *lanes, leg, added), *lane)
    of_platform = _prepared(kernel.prepare_platform, (first, third, platform))
    texts.functions |= {each.name: each for each in (of_leg, of_platform)}
    return [of_leg, of_platform]


def _prepared(block: Block, arguments: tuple[t.Argument, ...], *lane: t.Expression) -> t.Function:
    """Return one of the blocks; ``added`` receives the contributions to the platform."""

    def out(q: Quantity) -> lay.Place:
        return lay.member("added", q) if q in ADDED else lay.member("out", q, *lane)

    meaning = f"{block.meaning[0].upper()}{block.meaning[1:]}."
    body = (*axis(block), *lay.lines(block, raw), *lay.stores(block.outputs, out))
    return t.Function(block.name, meaning, arguments, None, body)


def axis(block: Block) -> Iterable[t.Statement]:
    """Return the fixed axis, which may have any length, as read by ``raw``."""
    if n.k in block.inputs and lay.names_used(block) & set(n.k.names):
        k = t.Member(t.Name("leg"), "k")
        yield t.Variable("axis", t.Array(t.Real(), (3,)), blank=True)
        yield t.Do(t.Call("scaled_axis", (k, t.Name("axis"))))


def raw(quantity: Quantity) -> lay.Place:
    """Return the location of an input of the preparation; inputs of leg 1 are in the robot's first leg."""
    if quantity == n.k:
        return lay.Place(t.Name("axis"))
    if quantity == n.p_1:
        return lay.Place(t.Member(t.Element(t.Member(t.Name("robot"), "leg"), (t.Number(0),)), "p"))
    owner = "sum" if quantity in ADDED else "robot" if quantity in n.PLATFORM else "leg"
    return lay.member(owner, quantity)


def structures(kernel: ForceKernel) -> dict[str, t.Structure]:
    """Return the structures that the preparation reads and creates, by their names in the texts."""
    robot, leg = raw_structures(kernel)
    return {"Robot": robot, "RawLeg": leg, "Motion": MOTION, "Lumped": LUMPED}


def literal(quantity: Quantity) -> str:
    """Return the name of a constant of a baked kernel, which all of its functions use."""
    return f"BAKED_{quantity.name}"


def literals(kernel: ForceKernel) -> str:
    """Print these constants as macros."""
    made = [
        f"#define {literal(q)} REAL({value!r}) /* {lay.unit_and_meaning(q)} */"
        for q, value in kernel.literals().items()
    ]
    return "\n".join(
        ["/* Constants of the platform, and constants that are equal for all legs. */", *made, ""]
    )


# ---------------------------------------------------------------- as trees of other languages than C


def result(name: str, meaning: str, *members: t.Field) -> t.Structure:
    """Structure that a function returns: members, and a status."""
    return t.Structure(
        name, meaning, (*members, t.Field("status", t.Integer(), "0, or the code of an error"))
    )


def machine_structures(drive: bool = False, more: tuple[Quantity, ...] = ()) -> list[t.Structure]:
    """Return the structures of robot and motion; with ``drive``, legs have rotors. ``more``: members."""
    legs = t.Field("leg", t.Array(t.Record("Leg"), (6,)), "the legs")
    return [
        lay.structure("Leg", "One leg.", (*(n.OF_LEG if drive else n.LEG), *more)),
        lay.structure("Robot", "The machine.", n.PLATFORM, legs),
        lay.structure("Motion", "Motion of the platform and its load.", n.MOTION),
    ]


def model_structures(kernel: ForceKernel) -> list[t.Structure]:
    """Return the structures of robot and motion, and of the constants that a kernel prepares."""
    return [
        *machine_structures(n.m_r in kernel.prepare_leg.inputs, kernel.more_of_legs()),
        lay.structure("LegConstants", "Prepared constants of one leg.", kernel.prepare_leg.made),
        lay.structure("Added", "Contributions of the legs to the constants of the platform.", ADDED),
        lay.structure("Platform", "Constants of the platform.", kernel.platform_constants()),
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
    """Return the functions that ``written.forces.prepare`` calls."""
    robot: lay.Arguments = {"robot": ("Robot", n.PLATFORM), "p_1": ("", (n.p_1,))}
    leg: lay.Arguments = {"leg": ("Leg", (*n.OF_LEG, *kernel.more_of_legs()))}
    return [
        lay.block_function(kernel.prepare_leg, "prepare_leg", "LegConstants", robot | leg),
        lay.block_function(
            kernel.prepare_platform, "prepare_platform", "Platform", robot | {"total": ("Added", ADDED)}
        ),
        *(read.function(text, structures, {}) for text in (forces.add_up, forces.lost_digits)),
    ]


def block_arguments(kernel: ForceKernel, *more: tuple[str, str, tuple[Quantity, ...]]) -> lay.Arguments:
    """Return the arguments of a leg's block: constants, motion, and ``more`` (name, structure, content)."""
    return {
        "leg": ("LegConstants", kernel.leg_constants()),
        "platform": ("Platform", kernel.platform_constants()),
        "motion": ("Motion", n.MOTION),
        **{name: (kind, held) for name, kind, held in more},
    }
