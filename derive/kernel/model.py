"""The prepared model as a tree: structures of a robot's constants, and the functions that fill them."""

from .. import notation as n
from .. import prepared as p
from ..block import Quantity
from ..regroup import ForceKernel
from .lower import Arguments, block_function, elements, structure
from .nodes import (
    Argument,
    Array,
    Assign,
    Binary,
    Element,
    Expression,
    Field,
    Function,
    Integer,
    Member,
    Name,
    Number,
    Real,
    Record,
    Return,
    Statement,
    Structure,
    Variable,
)

STATUS_FIELD = Field("status", Integer(), "0, or what is wrong")


def machine_structures() -> list[Structure]:
    """The robot and the motion."""
    legs = Field("leg", Array(Record("Leg"), (6,)), "the legs")
    return [
        structure("Leg", "One leg.", n.LEG),
        structure("Robot", "The machine.", n.PLATFORM, legs),
        structure("Motion", "Motion of the platform and its load.", n.MOTION),
    ]


def model_structures(kernel: ForceKernel) -> list[Structure]:
    """The robot, the motion, and the constants that a kernel prepares."""
    of_leg = [out.quantity for out in kernel.prepare_leg.outputs]
    return [
        *machine_structures(),
        structure("LegConstants", "Prepared constants of one leg.", of_leg),
        structure("Added", "What the legs add to the platform's constants.", p.ADDED),
        structure("Platform", "Constants of the platform.", kernel.platform_constants()),
        Structure(
            "Model",
            "A robot's constants, prepared once.",
            (
                Field("leg", Array(Record("LegConstants"), (6,)), "the legs"),
                Field("platform", Record("Platform"), "the platform"),
                Field("per_length", Real(), "1/m: one over the length over which moments are taken"),
                STATUS_FIELD,
            ),
        ),
    ]


def model_functions(kernel: ForceKernel, structures: dict[str, Structure]) -> list[Function]:
    """What ``written.forces.prepare`` calls."""
    robot: Arguments = {"robot": ("Robot", n.PLATFORM)}
    return [
        block_function(kernel.prepare_leg, "prepare_leg", "LegConstants", robot | {"leg": ("Leg", n.LEG)}),
        block_function(
            kernel.prepare_platform, "prepare_platform", "Platform", robot | {"total": ("Added", p.ADDED)}
        ),
        sum_function(
            "add_up",
            "What the legs add to the platform, with one leg more.",
            structures["Added"],
            "LegConstants",
        ),
        _lost_digits(structures),
    ]


def block_arguments(kernel: ForceKernel, *more: tuple[str, str, tuple[Quantity, ...]]) -> Arguments:
    """Arguments of a leg's block: constants, the motion, and ``more``: name, structure, what it holds."""
    return {
        "leg": ("LegConstants", kernel.leg_constants()),
        "platform": ("Platform", kernel.platform_constants()),
        "motion": ("Motion", n.MOTION),
        **{name: (kind, held) for name, kind, held in more},
    }


def sum_function(name: str, meaning: str, total: Structure, more: str) -> Function:
    """Adds each number of ``total`` and the one of the same name in a structure of type ``more``."""
    owners = (Name("out"), Name("total"), Name("more"))
    parts = zip(*(elements(owner, total) for owner in owners), strict=True)
    sums: list[Statement] = [Assign(target, Binary("+", before, term)) for target, before, term in parts]
    return Function(
        name,
        meaning,
        (Argument("total", Record(total.name)), Argument("more", Record(more))),
        Record(total.name),
        (Variable("out", Record(total.name)), *sums, Return(owners[0])),
    )


def _lost_digits(structures: dict[str, Structure]) -> Function:
    model, lost = Name("model"), Name("lost")
    legs: list[Expression] = [Element(Member(model, "leg"), (Number(i),)) for i in range(6)]
    numbers = [each for leg in legs for each in elements(leg, structures["LegConstants"])]
    numbers += elements(Member(model, "platform"), structures["Platform"])
    body = [Assign(lost, Binary("+", lost, Binary("*", Number(0.0), each))) for each in numbers]
    return Function(
        "lost_digits",
        "Zero as long as all constants are finite.",
        (Argument("model", Record("Model")),),
        Real(),
        (Variable("lost", Real(), Number(0.0)), *body, Return(lost)),
    )
