"""Text that every source with lanes is made of: loads, stores, the judgement of a leg, macros.

Stands below ``lanes`` and ``motion``. A lane is a leg of a pose or a pose of a block; either way a block is
the body of a loop over eight of them. Knows no dynamics and no whole function.
"""

from collections.abc import Iterable, Mapping

from .. import notation as n
from ..block import Block, Output, Quantity
from .c import size, wrap_list
from .infix import infix, wrap

LANES = 8
JUDGED = (n.q, n.L, n.k3)
"""Outputs of a leg by which it is judged; they are not stored as they are."""


def dims(quantity: Quantity) -> str:
    """``[9]`` for a matrix, nothing for a scalar."""
    return f"[{size(quantity)}]" if quantity.shape else ""


def filled(text: str, parts: dict[str, list[str]]) -> str:
    """The text with each mark replaced by its lines."""
    for mark, lines in parts.items():
        text = text.replace(mark, "\n".join(lines))
    return text


EMPTY = "    int none; /* C has no structure without members */"


def entries(quantities: Iterable[Quantity]) -> list[str]:
    """``h[0]``, ``h[1]``, ``h[2]``, ``g_k``: the stored numbers of the quantities, in order."""
    return [q.name + (f"[{i}]" if q.shape else "") for q in quantities for i in range(size(q))]


def loads(quantity: Quantity, owner: str, lane: str, used: set[str], indent: str) -> list[str]:
    """``const stewart_real p_x = leg->p[0]<lane>, ...;`` for the components that are used."""
    member = raw_member(quantity, owner)
    if not quantity.shape:
        return [f"{indent}const stewart_real {quantity.name} = {owner}->{member}{lane};"]
    parts = [
        f"{name} = {owner}->{member}[{i}]{lane}" for i, name in enumerate(quantity.names) if name in used
    ]
    return [wrap_list(f"{indent}const stewart_real {', '.join(parts)};", indent + " " * 4)]


SCALED_AXIS = """\
/* The fixed axis times a power of two that makes its square a number of the arithmetic: it may have any
 * length. */
static void scaled_axis(const stewart_real *k, stewart_real *out)
{
    int i, j;
    for (j = 0; j < 3; ++j) {
        out[j] = k[j];
    }
    for (i = 0; i < 64; ++i) {
        stewart_real by = REAL(1);
        stewart_real largest = STEWART_FABS(out[0]);
        largest = STEWART_LARGER(STEWART_FABS(out[1]), largest);
        largest = STEWART_LARGER(STEWART_FABS(out[2]), largest);
        by = largest > REAL(1048576) ? REAL(1) / REAL(4294967296) : by;
        by = largest < REAL(1) / REAL(1048576) ? REAL(4294967296) : by;
        for (j = 0; j < 3; ++j) {
            out[j] = by * out[j];
        }
    }
}
"""


def with_scaled_axis(lines: list[str]) -> list[str]:
    """The lines of a preparation, a leg's fixed axis read by ``SCALED_AXIS``."""
    if not any("leg->k[" in line for line in lines):
        return lines
    read = (line.replace("leg->k[", "axis[") for line in lines)
    return ["    stewart_real axis[3];", "    scaled_axis(leg->k, axis);", *read]


def literal_macros(literals: Mapping[Quantity, float]) -> str:
    """Constants that a baked kernel has once, whichever of its functions read them."""
    lines = [f"#define {literal_macro(q)} REAL({value!r})" for q, value in literals.items()]
    return "\n".join(["/* Constants of the platform, and those that all legs share. */", *lines, ""])


def literal_macro(quantity: Quantity) -> str:
    """Name of such a constant."""
    return f"BAKED_{quantity.name}"


def raw_member(quantity: Quantity, owner: str) -> str:
    """Where a quantity stands; those of leg 1 alone are members of it where they are read from the robot."""
    return {n.p_1: "leg[0].p"}.get(quantity, quantity.name) if owner == "robot" else quantity.name


def stores(outputs: tuple[Output, ...], lane: str, indent: str) -> list[str]:
    """``out->K[0]<lane> = ...;`` for every component."""
    lines = []
    for out in outputs:
        for i, expr in enumerate(out.exprs):
            index = f"[{i}]" if out.quantity.shape else ""
            text = f"{indent}out->{out.quantity.name}{index}{lane} = {infix(expr, 'STEWART_SQRT')};"
            lines.append(wrap(text, indent + " " * 4))
    return lines


def names_used(block: Block) -> set[str]:
    """Names that occur on some right side."""
    return {symbol.name for expr in block.expressions() for symbol in expr.free_symbols}


def assigned(target: str, text: str) -> str:
    """An assignment in the body of a loop."""
    return wrap(f"{' ' * 8}{target} = {text};", " " * 12)


def judged(leg: Block) -> tuple[str, str | None]:
    """Length and sine of the angle at the universal joint, as text; None where there is no such joint."""
    by_name = {out.quantity: infix(out.exprs[0], "STEWART_SQRT") for out in leg.outputs}
    return by_name[n.L], by_name.get(n.k3)


def reach_lines(terms: list[str]) -> list[str]:
    """Declares `fault`, and `reach` as the largest of the terms, and of what is too short by itself."""
    lines = [
        "        stewart_real fault;",
        "        stewart_real reach = STEWART_SHORTEST / STEWART_ROUNDING;",
    ]
    return lines + [f"        reach = STEWART_LARGER({term}, reach);" for term in terms]


def fault_lines(
    length: str,
    sine: str | None,
    before: str,
    after: str,
    least_sine: str = "STEWART_POLE_SINE",
    least_share: str = "STEWART_ROUNDING",
) -> list[str]:
    """Puts 1 into `after` where a leg is not finite, too short or at its pole, else what was `before`."""
    before = f"REAL({before})" if before == "0" else before
    lines = [
        f"        fault = {length} <= STEWART_MAX ? {before} : REAL(1);",
        f"        fault = {length} > {least_share} * reach ? fault : REAL(1);",
    ]
    if sine is not None:
        lines.append(f"        fault = {sine} > {least_sine} ? fault : REAL(1);")
    return [*lines, f"        {after} = fault;"]


MACROS = """
#if defined(__cplusplus)
#define STEWART_RESTRICT __restrict
#else
#define STEWART_RESTRICT restrict
#endif


/* Compilers make vector instructions of a long loop more readily when it stands in a function of its own. */
#if defined(__GNUC__)
#define STEWART_APART __attribute__((noinline))
#else
#define STEWART_APART
#endif

#define LANES 8
"""
