"""C99 files of the inverse dynamics with all terms, one header and one source for each formulation.

The code around the blocks is in ``kernel.written.every_output``.
"""

from collections.abc import Callable, Iterable, Mapping

from ..kernel import prepare as p
from ..kernel.batches import LOADS, MOTIONS, NUMBERS, batch, copies, missing
from ..kernel.interface import STRUCTS
from ..kernel.layouts import Written, filling, structure
from ..kernel.operations import LEGS, KernelOperations
from ..kernel.shared import legs_in_turn, shared
from ..kernel.written import every_output as written
from ..mechanics import quantities as n
from ..mechanics.formulation import SPHERICAL, UNIVERSAL
from ..mechanics.inverse_dynamics import Kernel
from ..print.c import C
from ..program.block import Block
from ..trace.nodes import Array, Field, Number, Real, Statement, Structure
from ..trace.read import Given
from .shared import OUTPUTS, Part, Source, header, top


def files(kernel: Kernel, counts: Mapping[str, KernelOperations], version: str) -> dict[str, str]:
    """Return ``stewart_<kernel>.h`` and ``.c``.

    ``counts`` contains the operations for "friction" and, if compared, "frictionless".
    """
    made = _Source(kernel)
    texts = header(
        "every_output.h",
        made.name,
        version,
        rotors=kernel.formulation.drive,
        name=kernel.formulation.kernel_name,
        about=_about(kernel),
        interface=_interface(kernel),
        operations=operations_table(counts["friction"], counts.get("frictionless"), " * "),
        declarations=made.declared(),
    )
    return texts | {f"{made.name}.c": made.printed(top(made.name, version, OUTPUTS))}


def _about(kernel: Kernel) -> str:
    form = kernel.formulation
    first = {
        "exact": "Formulation `exact`: corrected equations.",
        "paper": "Formulation `paper`: equations as printed, including their four errors.",
    }[form.name]
    joint = {
        UNIVERSAL: "Base joint: universal, with the fixed axis k.",
        SPHERICAL: "Base joint: spherical. The legs must be axisymmetric. M_u is zero.",
    }[form.base_joint]
    rotors = (
        "\n * Rotors: each leg has a rotor that turns in proportion to its length. Define STEWART_ROTORS in "
        "every source."
        if form.drive
        else ""
    )
    return f"{first}\n * {joint}{rotors}"


def _interface(kernel: Kernel) -> str:
    """List the inputs and outputs of the kernel with shapes and units."""
    used = {quantity.name for block in kernel.blocks for quantity in block.inputs}
    held = {"each leg": ("leg", "rotor"), "the robot": ("platform",), "the motion": ("motion",)}
    rows = {
        f"Inputs from {name}": [each for struct in structs for each in STRUCTS[struct] if each.name in used]
        for name, structs in held.items()
    }
    rows |= {f"Outputs in {name}": list(STRUCTS[name]) for name in ("forces", "reactions")}
    lists = (", ".join(f"{m.name}{m.dims} {m.unit}" for m in members) for members in rows.values())
    found = (f" * {title}: {names}." for title, names in zip(rows, lists, strict=True))
    return "\n".join(wrap_list(line, " *     ") for line in found)


def operations_table(counts: KernelOperations, frictionless: KernelOperations | None, prefix: str) -> str:
    """List the operations of each part; with ``frictionless`` also the operations without friction."""
    both = {"with friction": counts}
    if frictionless is not None:
        both["without friction"] = frictionless
    labels = {"leg": f"{LEGS} x leg", "moments": f"{counts.arms} x moments"}
    columns = [["", *(labels.get(part, part) for part in counts.parts())]]
    columns += [[title, *map(str, each.parts().values())] for title, each in both.items()]
    widths = [max(map(len, column)) for column in columns]
    titles, *lines = ("  ".join(map(str.ljust, row, widths)) for row in zip(*columns, strict=True))
    rows = ["Operations of the inverse dynamics of one pose, without the checks for the status:"]
    rows += lines if frictionless is None else [titles, *lines]
    if counts.fused:
        found = " and ".join(str(each.total.total - each.fused) for each in both.values())
        rows.append(f"Total with fused multiply-add instructions: {found}.")
    return "\n".join((prefix + row).rstrip() for row in (*rows, *_legend(counts)))


def _legend(counts: KernelOperations) -> list[str]:
    """Explain the rows of the table of operations."""
    arms = "; leg 1 has none" if counts.arms < LEGS else ""
    return [
        "leg: one leg. platform: terms that are common to all legs, and the platform's part of c.",
        *([f"moments: moments of one leg about platform point 1{arms}."] if counts.moments.total else []),
        "sum of c: sum of the parts of c. solve: H x = c, (36). forces: F = D - x, (37).",
        "add: additions and subtractions. Negations, copies, and comparisons are not counted.",
    ]


class _Source(Source):
    def __init__(self, kernel: Kernel) -> None:
        self.kernel, self.name = kernel, f"stewart_{kernel.formulation.kernel_name}"
        blocks = {"leg_terms": kernel.leg, "reaction_terms": kernel.reactions}
        self.blocks = {name: (block, structure(name, "", block.made)) for name, block in blocks.items()}
        made = (filled for _, filled in self.blocks.values())
        structures = {
            "Robot": p.ROBOT,
            "Leg": p.LEG,
            "Motion": p.MOTION,
            "Motions": MOTIONS,
            "Forces": _results("forces"),
            "ForcesArrays": _pointers("forces"),
            "Reactions": _results("reactions"),
            "ReactionsArrays": _pointers("reactions"),
            **dict(zip(("LegTerms", "ReactionTerms"), made, strict=True)),
            "PlatformTerms": shared().platform_terms,
        }
        self.flags: dict[str, Given] = {
            "HAS_SINE": int(n.k3 in kernel.leg.made),
            "COUNT": sum(each.count for each in STRUCTS["reactions"]),
            "SMALLEST": Number(p.ABOUT_REFERENCE[0]),
        }
        super().__init__(Written(structures, self.flags, shared().by_name))

    def _parts(self) -> Iterable[Part]:
        read = self.texts.function
        yield from (filled for _, filled in self.blocks.values())
        for block, filled in self.blocks.values():
            function = filling(block, filled)
            self.texts.functions[function.name] = function
            yield function
        yield read(written.pose_forces, given=legs_in_turn("out", "terms"))
        yield read(written.pose_reactions)
        single: tuple[Callable[..., object], ...] = (written.inverse_dynamics, written.joint_reactions)
        joint_singular = "STEWART_JOINT_SINGULAR, " if n.k3 in self.kernel.leg.made else ""
        for one in single:
            yield read(one, f"{self.name}_{one.__name__}", public=True, joint_singular=joint_singular)
        batches: dict[str, tuple[Callable[..., object], Callable[..., object]]] = {
            "forces": (written.inverse_dynamics_batch, written.one_forces),
            "reactions": (written.joint_reactions_batch, written.one_reactions),
        }
        needed = [q for q in n.MOTION if q not in LOADS]
        for results, (many, one) in batches.items():
            given = missing(("robot", "motions", results), needed) | batch(one, _copied(results))
            yield read(many, f"{self.name}_{many.__name__}", public=True, given=given)


def block_text(block: Block, result: str) -> str:
    """Print a block as a C function; ``result`` is the name of the structure that it fills."""
    return "\n".join(C().function(filling(block, structure(result, "", block.made))))


def _results(name: str) -> Structure:
    members = (Field(each.name, Array(Real(), each.stored)) for each in STRUCTS[name])
    return Structure(f"stewart_{name}", "", tuple(members))


def _pointers(name: str) -> Structure:
    members = (Field(each.name, NUMBERS) for each in STRUCTS[name])
    return Structure(f"stewart_{name}_arrays", "", tuple(members))


def _copied(name: str) -> tuple[Statement, ...]:
    """Return statements that copy the results of one pose to the arrays of the caller."""
    counts = {each.name: each.count for each in STRUCTS[name]}
    rows = [each.name for each in STRUCTS[name] if len(each.stored) > 1]
    return copies(name, counts, rows)


def wrap_list(text: str, indent: str = " " * 8) -> str:
    """Break a long list after commas; continuation lines begin with ``indent``."""
    lines, line = [], ""
    for word in text.split(", "):
        if line and len(line) + len(word) > 100:
            lines.append(line + ",")
            line = indent + word
        else:
            line = f"{line}, {word}" if line else word
    return "\n".join([*lines, line])
