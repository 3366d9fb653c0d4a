"""The prepared model as a tree: structures of a robot's constants, and the functions that fill them."""

from functools import reduce

from ..mechanics import lumped_constants as p
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..program.block import Quantity
from .tree.lower import Arguments, Place, block_function, each_number, structure
from .tree.nodes import (
    Argument,
    Array,
    Assign,
    Binary,
    Compare,
    Constant,
    Either,
    Element,
    Expression,
    Field,
    For,
    Function,
    Integer,
    Member,
    Name,
    Number,
    Real,
    Record,
    Return,
    Select,
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
    robot: Arguments = {"robot": ("Robot", n.PLATFORM), "p_1": ("", (n.p_1,))}
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
    out, before, term = Name("out"), Name("total"), Name("more")
    sums = each_number(total, lambda at: Assign(at(out), Binary("+", at(before), at(term))))
    return Function(
        name,
        meaning,
        (Argument("total", Record(total.name)), Argument("more", Record(more))),
        Record(total.name),
        (Variable("out", Record(total.name)), *sums, Return(out)),
    )


def legs_function(name: str, total: Structure, pose: str, legs: str) -> Function:
    """Adds the parts of the six legs, one after the other, to that of the pose."""
    out, own = Name("out"), Name("pose")
    parts = [Element(Member(Name("legs"), "leg"), (Number(i),)) for i in range(6)]

    def added(at: Place) -> Statement:
        of_legs = reduce(lambda before, leg: Binary("+", before, leg), map(at, parts))
        return Assign(at(out), Binary("+", at(own), of_legs))

    return Function(
        name,
        "The sums over platform and legs.",
        (
            Argument("pose", Record(pose)),
            Argument("legs", Record(legs)),
            Argument("out", Record(total.name), changed=True),
        ),
        None,
        tuple(each_number(total, added)),
    )


def check_function(name: str, result: Structure) -> Function:
    """A status where a number of a result is not finite; NaN for its numbers where that is not OK."""
    out, lost = Name("out"), Name("lost")
    status = Member(out, "status")
    fine = Compare("==", status, Constant("OK"))
    known = Either(Compare("!=", status, Constant("OK")), Compare("==", lost, Number(0.0)))
    looked_at = each_number(
        result, lambda at: Assign(lost, Binary("+", lost, Binary("*", Number(0.0), at(out))))
    )
    return Function(
        name,
        "Says where a number of a result is not finite, and puts NaN for all where the status is not OK.",
        (Argument("out", Record(result.name), changed=True),),
        None,
        (
            Variable("lost", Real(), Number(0.0)),
            *looked_at,
            Assign(status, Select(known, status, Constant("NOT_FINITE"))),
            *each_number(result, lambda at: Assign(at(out), Select(fine, at(out), Constant("NAN")))),
        ),
    )


def _lost_digits(structures: dict[str, Structure]) -> Function:
    model, lost = Name("model"), Name("lost")
    leg = Element(Member(model, "leg"), (Name("leg"),))

    def checked(owner: Expression, kind: str) -> tuple[Statement, ...]:
        def added(at: Place) -> Statement:
            return Assign(lost, Binary("+", lost, Binary("*", Number(0.0), at(owner))))

        return tuple(each_number(structures[kind], added))

    legs = For("leg", Number(0), Number(6), checked(leg, "LegConstants"))
    body = (legs, *checked(Member(model, "platform"), "Platform"))
    return Function(
        "lost_digits",
        "Zero as long as all constants are finite.",
        (Argument("model", Record("Model")),),
        Real(),
        (Variable("lost", Real(), Number(0.0)), *body, Return(lost)),
    )
