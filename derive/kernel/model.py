"""The prepared model as a tree: structures of a robot's constants, and the functions that fill them."""

from functools import reduce

from ..mechanics import lumped_constants as p
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..program.block import Quantity
from .tree import nodes as t
from .tree.lower import Arguments, Place, block_function, each_number, structure

STATUS_FIELD = t.Field("status", t.Integer(), "0, or what is wrong")


def machine_structures() -> list[t.Structure]:
    """The robot and the motion."""
    legs = t.Field("leg", t.Array(t.Record("Leg"), (6,)), "the legs")
    return [
        structure("Leg", "One leg.", n.LEG),
        structure("Robot", "The machine.", n.PLATFORM, legs),
        structure("Motion", "Motion of the platform and its load.", n.MOTION),
    ]


def model_structures(kernel: ForceKernel) -> list[t.Structure]:
    """The robot, the motion, and the constants that a kernel prepares."""
    of_leg = [out.quantity for out in kernel.prepare_leg.outputs]
    return [
        *machine_structures(),
        structure("LegConstants", "Prepared constants of one leg.", of_leg),
        structure("Added", "What the legs add to the platform's constants.", p.ADDED),
        structure("Platform", "Constants of the platform.", kernel.platform_constants()),
        t.Structure(
            "Model",
            "A robot's constants, prepared once.",
            (
                t.Field("leg", t.Array(t.Record("LegConstants"), (6,)), "the legs"),
                t.Field("platform", t.Record("Platform"), "the platform"),
                t.Field("per_length", t.Real(), "1/m: one over the length over which moments are taken"),
                STATUS_FIELD,
            ),
        ),
    ]


def model_functions(kernel: ForceKernel, structures: dict[str, t.Structure]) -> list[t.Function]:
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


def sum_function(name: str, meaning: str, total: t.Structure, more: str) -> t.Function:
    """Adds each number of ``total`` and the one of the same name in a structure of type ``more``."""
    out, before, term = t.Name("out"), t.Name("total"), t.Name("more")
    sums = each_number(total, lambda at: t.Assign(at(out), t.Binary("+", at(before), at(term))))
    return t.Function(
        name,
        meaning,
        (t.Argument("total", t.Record(total.name)), t.Argument("more", t.Record(more))),
        t.Record(total.name),
        (t.Variable("out", t.Record(total.name)), *sums, t.Return(out)),
    )


def legs_function(name: str, total: t.Structure, pose: str, legs: str) -> t.Function:
    """Adds the parts of the six legs, one after the other, to that of the pose."""
    out, own = t.Name("out"), t.Name("pose")
    parts = [t.Element(t.Member(t.Name("legs"), "leg"), (t.Number(i),)) for i in range(6)]

    def added(at: Place) -> t.Statement:
        of_legs = reduce(lambda before, leg: t.Binary("+", before, leg), map(at, parts))
        return t.Assign(at(out), t.Binary("+", at(own), of_legs))

    return t.Function(
        name,
        "The sums over platform and legs.",
        (
            t.Argument("pose", t.Record(pose)),
            t.Argument("legs", t.Record(legs)),
            t.Argument("out", t.Record(total.name), changed=True),
        ),
        None,
        tuple(each_number(total, added)),
    )


def check_function(name: str, result: t.Structure) -> t.Function:
    """A status where a number of a result is not finite; NaN for its numbers where that is not OK."""
    out, lost = t.Name("out"), t.Name("lost")
    status = t.Member(out, "status")
    fine = t.Compare("==", status, t.Constant("OK"))
    known = t.Either(t.Compare("!=", status, t.Constant("OK")), t.Compare("==", lost, t.Number(0.0)))
    looked_at = each_number(
        result, lambda at: t.Assign(lost, t.Binary("+", lost, t.Binary("*", t.Number(0.0), at(out))))
    )
    return t.Function(
        name,
        "Says where a number of a result is not finite, and puts NaN for all where the status is not OK.",
        (t.Argument("out", t.Record(result.name), changed=True),),
        None,
        (
            t.Variable("lost", t.Real(), t.Number(0.0)),
            *looked_at,
            t.Assign(status, t.Select(known, status, t.Constant("NOT_FINITE"))),
            *each_number(result, lambda at: t.Assign(at(out), t.Select(fine, at(out), t.Constant("NAN")))),
        ),
    )


def _lost_digits(structures: dict[str, t.Structure]) -> t.Function:
    model, lost = t.Name("model"), t.Name("lost")
    leg = t.Element(t.Member(model, "leg"), (t.Name("leg"),))

    def checked(owner: t.Expression, kind: str) -> tuple[t.Statement, ...]:
        def added(at: Place) -> t.Statement:
            return t.Assign(lost, t.Binary("+", lost, t.Binary("*", t.Number(0.0), at(owner))))

        return tuple(each_number(structures[kind], added))

    legs = t.For("leg", t.Number(0), t.Number(6), checked(leg, "LegConstants"))
    body = (legs, *checked(t.Member(model, "platform"), "Platform"))
    return t.Function(
        "lost_digits",
        "Zero as long as all constants are finite.",
        (t.Argument("model", t.Record("Model")),),
        t.Real(),
        (t.Variable("lost", t.Real(), t.Number(0.0)), *body, t.Return(lost)),
    )
