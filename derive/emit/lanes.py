"""C99 for speed: the regrouped force kernel with legs, or poses, side by side in lanes.

One pose puts its six legs into lanes of eight; a batch puts eight poses into them. Either way a block is the
body of a loop over lanes, which compilers turn into vector instructions by themselves, and which is plain
portable C where they don't. Knows layout and solving, no dynamics.
"""

import re

import sympy as sp

from .. import notation as n
from ..block import Block, Quantity
from ..operations import force_operations
from ..prepared import ADDED, arm_c, q_1
from ..regroup import ForceKernel
from . import singular
from .c import ARITHMETIC, operations_table, size, step_lines, wrap_list
from .infix import infix, wrap
from .lane_scale import IS_SCALED, MEMBER, PREPARED, SIZE, per_length
from .lane_text import (
    EMPTY,
    JUDGED,
    LANES,
    MACROS,
    SCALED_AXIS,
    assigned,
    dims,
    entries,
    fault_lines,
    filled,
    judged,
    literal_macro,
    literal_macros,
    loads,
    names_used,
    reach_lines,
    stores,
    with_scaled_axis,
)

_RIGHT_SIDE = (n.c_force, n.c_moment)


def header(kernel: ForceKernel, frictionless: ForceKernel | None, version: str) -> str:
    """``stewart_<kernel>_forces.h``: the prepared model and the functions.

    frictionless: the same kernel without friction, for its count of operations.
    """
    name = kernel.name
    plain = None if frictionless is None else force_operations(frictionless)
    counts = operations_table(force_operations(kernel), plain, " * ")
    return _HEADER.format(
        name=name,
        guard=f"STEWART_{name.upper()}_FORCES_H",
        version=version,
        model=_MODEL[kernel.fidelity == "general"].format(meaning=kernel.meaning),
        operations=counts,
        legs="\n".join(_member(q, f"[{LANES}]") for q in kernel.leg_constants()),
        platform="\n".join(_member(q, "") for q in kernel.platform_constants()),
        scale=MEMBER,
    )


def baked_header(kernel: ForceKernel, before: ForceKernel, version: str) -> str:
    """The header of a kernel with a robot's numbers folded in; ``before`` is the kernel without them."""
    return _BAKED_HEADER.format(
        name=kernel.name,
        guard=f"STEWART_{kernel.name.upper()}_FORCES_H",
        version=version,
        meaning=kernel.meaning,
        before=force_operations(before).total.total,
        operations=operations_table(force_operations(kernel), None, " * "),
    )


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_forces.c``: preparation, one pose, batch."""
    name = kernel.name
    parts = [
        _TOP.format(name=name, version=version) + ARITHMETIC + MACROS + singular.MACROS,
        _only(_structs(kernel), kernel),
        *_model(kernel),
        _scalar_shared(kernel),
        *_legs(kernel),
        *_moments_of_pose(kernel),
        *([_SCALE_POSE] if is_scaled(kernel) else []),
        solve_pose(kernel.about_tip),
        singular.FUNCTION,
        _pose(kernel),
        _only(_BLOCK, kernel),
        _block_shared(kernel),
        _leg_of_block(kernel),
        *_moments_of_block(kernel),
        *([_only(_SCALE_BLOCK, kernel)] if is_scaled(kernel) else []),
        _solve_block(kernel),
        _batch(kernel),
    ]
    return "\n".join(parts).replace("@NAME@", name)


def _only(text: str, kernel: ForceKernel) -> str:
    """The text, with what stands in <D: :D> if legs have a D, in <C: :C> if they add to c.

    What stands in <K: :K> is of legs with a universal joint, in <J: :J> of others; in <P: :P> of kernels with
    a code path of its own near the joint singularity, in <Q: :Q> of others; in <M: :M> of kernels with a
    prepared model, in <B: :B> of baked ones; in <A: :A> of kernels with moments about platform point 1, in
    <O: :O> of others; in <F: :F> of legs with moments of their own in c, in <G: :G> of those about platform
    point 1 that add to c; in <S: :S> of prepared models, which may have a length to take moments over, in <Z:
    :Z> of baked kernels that have one.
    """
    given = {out.quantity for out in kernel.leg.outputs}
    bare = kernel.constants is not None
    marks = {
        "D": n.D in given,
        "C": n.c_force in given,
        "K": n.k3 in given,
        "J": n.k3 not in given,
        "P": kernel.leg_near_pole is not None,
        "Q": kernel.leg_near_pole is None,
        "M": not bare,
        "B": bare,
        "A": kernel.about_tip,
        "O": not kernel.about_tip,
        "F": n.c_moment in given,
        "G": kernel.about_tip and n.c_force in given,
        "S": not bare,
        "Z": bare and is_scaled(kernel),
    }
    for mark, kept in marks.items():
        if not kept:
            text = re.sub(rf"\n *<{mark}:[^\n]*:{mark}>(?=\n)|<{mark}:.*?:{mark}>", "", text)
        text = re.sub(rf"<{mark}:|:{mark}>", "", text)
    length = f"REAL({per_length(kernel.size)!r})" if bare else "model->per_length"
    return text.replace("@IS_SCALED@", IS_SCALED).replace("@PER_LENGTH@", length)


def model_numbers(kernel: ForceKernel) -> int:
    """How many numbers ``stewart_<kernel>_model`` holds."""
    numbers = LANES * sum(map(size, kernel.leg_constants())) + sum(map(size, kernel.platform_constants()))
    return numbers + 1


def _member(quantity: Quantity, lanes: str) -> str:
    return (
        f"    stewart_real {quantity.name}{dims(quantity)}{lanes}; /* {quantity.unit}: {quantity.meaning} */"
    )


def _structs(kernel: ForceKernel) -> str:
    parts = {
        "@MOTION@": [f"    stewart_real {q.name}[{size(q)}][{LANES}];" for q in kernel.used_motion()],
        "@SHARED@": [
            f"    stewart_real {q.name}[{size(q)}];"
            for q in (*_from_pose(kernel), *(out.quantity for out in kernel.shift.outputs))
        ],
        "@SHARED_LANES@": [
            f"    stewart_real {q.name}[{size(q)}][{LANES}];"
            for q in _from_pose(kernel)
            if q not in _RIGHT_SIDE
        ]
        or [EMPTY],
        "@TERMS@": [f"    stewart_real {q.name}{dims(q)}[{LANES}];" for q in _terms(kernel)],
    }
    return filled(_STRUCTS, parts)


def _from_pose(kernel: ForceKernel) -> list[Quantity]:
    return [out.quantity for out in kernel.shared.outputs]


def _terms(kernel: ForceKernel) -> list[Quantity]:
    """What the legs of a pose keep; q is what moments are taken with, or what bounds them."""
    blocks = (kernel.leg, kernel.moments) if kernel.about_tip else (kernel.leg,)
    found = [out.quantity for block in blocks for out in block.outputs if out.quantity not in JUDGED]
    return [n.q, *found]


# ---------------------------------------------------------------- preparation


def _legs(kernel: ForceKernel) -> list[str]:
    """The legs of a pose, and the road near a pole where the kernel has one."""
    parts = [_legs_of_pose(kernel, kernel.leg, "legs_of_pose", _least_sine(kernel))]
    if kernel.leg_near_pole is not None:
        near = _legs_of_pose(kernel, kernel.leg_near_pole, "legs_near_pole", "STEWART_POLE_SINE")
        parts.append(
            near.replace(
                "The legs of one pose side by side", "The same for a pose in which a leg is near its pole"
            )
        )
    return parts


def _model(kernel: ForceKernel) -> list[str]:
    """What prepares the constants, or the constants themselves."""
    if kernel.constants is None:
        return [
            prepare_function(kernel.prepare_leg, "prepared_leg"),
            prepare_function(kernel.prepare_platform, "prepared_platform"),
            SIZE.replace("@MODEL@", "stewart_@NAME@_model"),
            _prepare(kernel),
        ]
    tables = {q: kernel.constants[q] for q in kernel.leg_constants()}
    # The last two lanes repeat leg 6.
    rows = [
        (*(f"REAL({value!r})" for value in values), *(f"REAL({values[-1]!r})",) * 2)
        for values in tables.values()
    ]
    parts = {
        "@MEMBERS@": [_member(q, f"[{LANES}]") for q in tables],
        "@ROWS@": [
            f"    /* {q.name} */\n" + wrap_list(f"    {{{', '.join(row)}}},", " " * 5)
            for q, row in zip(tables, rows, strict=True)
        ],
    }
    return [literal_macros(kernel.literals()), filled(_NUMBERS, parts)]


def prepare_function(block: Block, struct: str) -> str:
    """A block of preparation as a function that fills a struct of its own."""
    members = "\n".join(f"    stewart_real {o.quantity.name}{dims(o.quantity)};" for o in block.outputs)
    used = names_used(block)
    lines = [line for q in block.inputs for line in loads(q, _owner_of_raw(q), "", used, "    ")]
    arguments = [
        ("robot", "const stewart_robot *robot"),
        ("leg", "const stewart_leg *leg") if struct == "prepared_leg" else ("sum", "const prepared_leg *sum"),
    ]
    unused = [f"    (void){name};" for name, _ in arguments if not any(f"= {name}->" in t for t in lines)]
    axis = [SCALED_AXIS] if n.k in block.inputs else []
    body = [
        *unused,
        *with_scaled_axis(lines),
        *step_lines(block.steps, "    "),
        *stores(block.outputs, "", "    "),
    ]
    return "\n".join(
        [
            *axis,
            f"typedef struct {{\n{members}\n}} {struct};\n",
            f"/* {block.meaning[0].upper()}{block.meaning[1:]}. */",
            f"static void {block.name}({', '.join(text for _, text in arguments)}, {struct} *out)",
            "{",
            *body,
            "}",
            "",
        ]
    )


def _owner_of_raw(quantity: Quantity) -> str:
    if quantity in n.LEG:
        return "leg"
    return "sum" if quantity in ADDED else "robot"


def _prepare(kernel: ForceKernel) -> str:
    parts = {
        "@COPIES@": [f"        made.{name}[i] = found.{name};" for name in entries(kernel.leg_constants())],
        "@ZERO@": [f"    sum.{name} = REAL(0);" for name in entries(ADDED)],
        "@ADD@": [f"        sum.{name} = sum.{name} + found.{name};" for name in entries(ADDED)],
        "@PLATFORM@": [
            f"    made.{name} = platform.{name};" for name in entries(kernel.platform_constants())
        ],
        "@SCALE@": [PREPARED.format(model="made.", address="&made")],
    }
    return filled(_PREPARE, parts)


# ---------------------------------------------------------------- blocks


def _scalar_shared(kernel: ForceKernel) -> str:
    block = kernel.shared
    used = names_used(block)
    found = [
        line
        for q in block.inputs
        for line in _loads(kernel, q, "at" if q in n.MOTION else "model", "", used, "    ")
    ]
    lines = [*found, *step_lines(block.steps, "    "), *stores(block.outputs, "", "    ")]
    text = _SHARED_POSE.replace("@COUNT@", str(block.operations()))
    return _used(text, found, "model").replace("@BODY@", "\n".join(lines))


def _block_shared(kernel: ForceKernel) -> str:
    block = kernel.shared
    used = names_used(block)
    outside = [
        line
        for q in block.inputs
        if q not in n.MOTION
        for line in _loads(kernel, q, "model", "", used, "    ")
    ]
    inside = [line for q in block.inputs if q in n.MOTION for line in loads(q, "in", "[l]", used, " " * 8)]
    kept = tuple(out for out in block.outputs if out.quantity not in _RIGHT_SIDE)
    right = [e for out in block.outputs if out.quantity in _RIGHT_SIDE for e in out.exprs]
    body = [
        *inside,
        *step_lines(block.steps, " " * 8),
        *stores(kept, "[l]", " " * 8),
        *(assigned(f"c[{i}][l]", infix(expr, "STEWART_SQRT")) for i, expr in enumerate(right)),
    ]
    text = _used(_SHARED_BLOCK, outside, "model")
    outside += [] if kept else ["    (void)out;"]
    return filled(text, {"@OUTSIDE@": outside, "@BODY@": body})


def _loads(kernel: ForceKernel, q: Quantity, owner: str, lane: str, used: set[str], indent: str) -> list[str]:
    """Loads of one input, or the literal that it is."""
    if q in kernel.literals():
        return [f"{indent}const stewart_real {q.name} = {literal_macro(q)};"]
    return loads(q, owner, lane, used, indent)


def _legs_of_pose(kernel: ForceKernel, leg: Block, name: str, least_sine: str) -> str:
    """A leg's block as the body of a loop over the legs of a pose."""
    kept = tuple(out for out in leg.outputs if out.quantity not in JUDGED)
    terms, more = reach_terms(kernel)
    length, sine = judged(leg)
    outside, inside = _lane_loads(kernel, leg, more, over_legs=True)
    body = [
        *inside,
        *step_lines(leg.steps, " " * 8),
        *stores(kept, "[l]", " " * 8),
        *stores(tuple(out for out in leg.outputs if out.quantity == n.q), "[l]", " " * 8),
        *reach_lines(terms),
        "        out->reach[l] = reach;",
        f"        out->L[l] = {length};",
        *([] if sine is None else [f"        out->k3[l] = {sine};"]),
        *fault_lines(length, sine, "0", "out->bad[l]", least_sine, "STEWART_SHORT_SHARE"),
    ]
    text = _LEGS_OF_POSE.replace("@COUNT@", str(leg.operations())).replace("@FUNCTION@", name)
    return filled(_used(text, outside + inside, "shared"), {"@OUTSIDE@": outside, "@BODY@": body})


def _least_sine(kernel: ForceKernel) -> str:
    """Below this sine the leg's block is not the one to compute with."""
    return "STEWART_POLE_SINE" if kernel.leg_near_pole is None else "STEWART_NEAR_POLE"


def _leg_of_block(kernel: ForceKernel) -> str:
    """The leg's block as the body of a loop over the poses of a block."""
    exprs = {out.quantity: out.exprs for out in kernel.leg.outputs}
    terms, more = reach_terms(kernel)
    length, sine = judged(kernel.leg)
    outside, inside = _lane_loads(kernel, kernel.leg, more, over_legs=False)
    column = [infix(expr, "STEWART_SQRT") for q in (n.H_force, n.H_moment) for expr in exprs.get(q, ())]
    known = [assigned("known[l]", infix(e, "STEWART_SQRT")) for e in exprs.get(n.D, ())]
    own = tuple(out for out in kernel.leg.outputs if out.quantity in (n.q, *_RIGHT_SIDE))
    right = [*exprs.get(n.c_force, ()), *exprs.get(n.c_moment, ())]
    added = [assigned(f"c[{i}][l]", f"c[{i}][l]{_added(expr)}") for i, expr in enumerate(right)]
    body = [
        *inside,
        *step_lines(kernel.leg.steps, " " * 8),
        *(assigned(f"column[{i}][l]", text) for i, text in enumerate(column)),
        *(stores(own, "[l]", " " * 8) if kernel.about_tip else added),
        *known,
        *reach_lines(terms),
        *fault_lines(length, sine, "bad[l]", "bad[l]", _least_sine(kernel), "STEWART_SHORT_SHARE"),
    ]
    text = _only(_LEG_OF_BLOCK, kernel).replace("@COUNT@", str(kernel.leg.operations()))
    return filled(_used(text, outside + inside, "shared"), {"@OUTSIDE@": outside, "@BODY@": body})


def _used(text: str, lines: list[str], argument: str) -> str:
    """The text without its mark for an unused argument where the lines read it."""
    used = any(f"{argument}->" in line for line in lines)
    return text.replace(f"@UNUSED {argument}@\n", "" if used else f"    (void){argument};\n")


def _added(expr: sp.Expr) -> str:
    """`` + (expr)``, with the sign drawn out of a product."""
    if not expr.is_Add and expr.could_extract_minus_sign():
        return f" - {infix(-expr, 'STEWART_SQRT')}"
    return f" + ({infix(expr, 'STEWART_SQRT')})"


def _lane_loads(
    kernel: ForceKernel, leg: Block, more: tuple[Quantity, ...], over_legs: bool
) -> tuple[list[str], list[str]]:
    """Loads of what all lanes share, and of what differs from lane to lane."""
    used = names_used(leg) | {name for q in more for name in q.names}
    shared_by_legs = {*kernel.platform_constants(), *kernel.literals()}
    outside, inside = [], []
    for q in dict.fromkeys((*leg.inputs, *more)):
        if q in n.MOTION or q in _from_pose(kernel):
            owner = ("at" if over_legs else "in") if q in n.MOTION else "shared"
            varies = not over_legs
        else:
            owner, varies = "model", over_legs and q not in shared_by_legs
        if varies:
            inside += _loads(kernel, q, owner, "[l]", used, " " * 8)
        else:
            lane = "[leg]" if owner == "model" and q not in shared_by_legs else ""
            outside += _loads(kernel, q, owner, lane, used, "    ")
    return outside, inside


def reach_terms(kernel: ForceKernel) -> tuple[list[str], tuple[Quantity, ...]]:
    """Sizes of the vectors whose sum is S, and the inputs among them."""
    exprs = {out.quantity: out.exprs for out in kernel.leg.outputs}
    inputs: tuple[Quantity, ...] = (n.t, n.b)
    if kernel.constants is not None:
        inputs = (n.t, *(part for part in kernel.leg_constants() if part.name in n.b.names))
    terms = (*exprs[n.q], *(symbol for quantity in inputs for symbol in quantity.symbols))
    return [f"STEWART_FABS({infix(expr, 'STEWART_SQRT')})" for expr in terms], inputs


# ---------------------------------------------------------------- moments about platform point 1


def _moments_of_pose(kernel: ForceKernel) -> list[str]:
    """The moments of a pose, legs in lanes; nothing where legs have their own."""
    if not kernel.about_tip:
        return []
    shift, leg = kernel.shift, kernel.moments
    first = [f"{name} = legs->q[{i}][0]" for i, name in enumerate(q_1.names)]
    parts = {
        "@OUTSIDE@": [wrap_list(f"    const stewart_real {', '.join(first)};")],
        "@SHIFT@": [
            wrap_list(f"    const stewart_real {', '.join(first)};"),
            *(line for q in _RIGHT_SIDE for line in loads(q, "shared", "", names_used(shift), "    ")),
            *step_lines(shift.steps, "    "),
            *(line.replace("out->", "shared->") for line in stores(shift.outputs, "", "    ")),
        ],
        "@BODY@": _moment_lines(kernel, "legs", "legs"),
    }
    text = _MOMENTS_OF_POSE.replace("@COUNT@", str(leg.operations()))
    return [filled(text, parts)]


def _moment_lines(kernel: ForceKernel, column: str, own: str) -> list[str]:
    """The body of a loop over lanes that makes the moments of one leg."""
    leg, used = kernel.moments, names_used(kernel.moments)
    owners = {n.q: own, n.c_force: own, n.H_force: column}
    return [
        *(
            line
            for q, owner in owners.items()
            if q in leg.inputs
            for line in loads(q, owner, "[l]", used, " " * 8)
        ),
        *step_lines(leg.steps, " " * 8),
        *(line.replace("out->", f"{column}->") for line in stores(leg.outputs, "[l]", " " * 8)),
    ]


def _read(quantity: Quantity, lanes: str) -> str:
    return ", ".join(f"{name} = {lanes}[{i}][l]" for i, name in enumerate(quantity.names))


def _moments_of_block(kernel: ForceKernel) -> list[str]:
    """The moments of one leg of eight poses, and what leg 1 has instead."""
    if not kernel.about_tip:
        return []
    given = [(n.c_force, 0), (n.c_moment, 3)]
    has = {out.quantity for out in kernel.leg.outputs}
    shift, leg = kernel.shift, kernel.moments
    first = [f"{name} = own->q[{i}][l]" for i, name in enumerate(q_1.names)]
    c = [f"{name} = c[{i + j}][l]" for q, i in given for j, name in enumerate(q.names)]
    sums = [
        assigned(f"c[{i + j}][l]", f"c[{i + j}][l] + own->{q.name}[{j}][l]")
        for q, i in given
        if q in has
        for j in range(3)
    ]
    used, exprs = names_used(leg), {out.quantity: out.exprs for out in leg.outputs}
    parts = {
        "@FIRST@": [
            wrap_list(f"        const stewart_real {', '.join(first)};", " " * 12),
            wrap_list(f"        const stewart_real {', '.join(c)};", " " * 12),
            *(
                assigned(f"c[{i + 3}][l]", infix(e, "STEWART_SQRT"))
                for i, e in enumerate(shift.outputs[0].exprs)
            ),
            *sums,
        ],
        "@OTHER@": [
            wrap_list(
                f"        const stewart_real {_read(q_1, 'q_1')};",
                " " * 12,
            ),
            *(
                line
                for q in (n.q, n.c_force)
                if q in leg.inputs
                for line in loads(q, "own", "[l]", used, " " * 8)
            ),
            wrap_list(
                f"        const stewart_real {_read(n.H_force, 'column')};",
                " " * 12,
            ),
            *step_lines(leg.steps, " " * 8),
            *(
                assigned(f"column[{i + 3}][l]", infix(e, "STEWART_SQRT"))
                for i, e in enumerate(exprs[n.H_moment])
            ),
            *sums,
            *(
                assigned(f"c[{i + 3}][l]", f"c[{i + 3}][l]{_added(e)}")
                for i, e in enumerate(exprs.get(arm_c, ()))
            ),
        ],
    }
    text = _MOMENTS_OF_BLOCK.replace("@COUNT@", str(leg.operations()))
    if not sums:
        text = text.replace(" @UNUSED@", "\n    (void)c;")
    return [filled(text.replace(" @UNUSED@", ""), parts)]


# ---------------------------------------------------------------- solving


def is_scaled(kernel: ForceKernel) -> bool:
    """Whether moments are multiplied by a length at all: a prepared model decides when it is prepared."""
    return kernel.constants is None or per_length(kernel.size) != 1.0


def solve_pose(about_tip: bool) -> str:
    """Elimination of one pose, unrolled: the next column is known before the rows that hold it are stored."""
    rows = range(6)
    body = [f"a{i} = A[{i}][0];" for i in rows if i < 3 or not about_tip]
    for k in rows:
        below = [i for i in rows[k + 1 :] if i < 3 or k > 0 or not about_tip]
        body += [f"/* Column {k + 1}. */"]
        for i in below:
            body += _exchange(k, i)
        if below:
            body += _eliminate(k, below)
    body.append("x[5] = A[5][6] / a5;")
    for i in reversed(rows[:-1]):
        known = "".join(f" - A[{i}][{j}] * x[{j}]" for j in rows[i + 1 :])
        body.append(f"x[{i}] = (A[{i}][6]{known}) * inverse{i};")
    why = "\n * The first column has no moment rows." if about_tip else ""
    large = " && ".join(f"STEWART_FABS(a{k}) > STEWART_SUSPECT" for k in rows)
    body.append(wrap(f"return ({large}) ? 0 : 1;", " " * 8, before="&&"))
    return _filled_body(_SOLVE_POSE.replace("@WHY@", why), body)


def _exchange(k: int, i: int) -> list[str]:
    """Rows k and i exchanged where i has the larger entry in column k: in the order of a block's lanes.

    Rows of equal entries then stand alike in both, and round alike.
    """
    return [
        f"if (STEWART_FABS(a{i}) > STEWART_FABS(a{k})) {{",
        f"    const stewart_real moved = a{k};",
        f"    exchange_rows(A[{k}], A[{i}]);",
        f"    a{k} = a{i};",
        f"    a{i} = moved;",
        "}",
    ]


def _eliminate(k: int, below: list[int]) -> list[str]:
    """Column k eliminated below row k; a1 to a5 become the entries of the next column."""
    return [
        f"inverse{k} = REAL(1) / a{k};",
        *(f"factor{i} = a{i} * inverse{k};" for i in below),
        *(
            f"a{i} = A[{i}][{k + 1}]{f' - factor{i} * A[{k}][{k + 1}]' if i in below else ''};"
            for i in range(k + 1, 6)
        ),
        *(f"subtract_row(A[{i}], factor{i}, A[{k}]);" for i in below),
    ]


def _filled_body(text: str, body: list[str]) -> str:
    return text.replace("@BODY@", "\n".join(wrap_list(f"    {line}", " " * 8) for line in body))


def _solve_block(kernel: ForceKernel) -> str:
    """Elimination with partial pivoting, unrolled: one loop over lanes that never branches.

    The row with the largest entry sinks to place k by exchanges that a lane makes or leaves.
    """
    rows, columns = range(6), range(7)
    entries = [[(i, j) for j in columns if not (kernel.about_tip and i > 2 and j == 0)] for i in rows]
    body = [
        "stewart_real " + ", ".join(f"a{i}{j} = column[{j}][{i}][l]" for i, j in row) + ";" for row in entries
    ]
    body.append("stewart_real fault = bad[l];")
    for k in rows:
        below = [i for i in rows[k + 1 :] if (i, k) in entries[i]]
        for i in below:
            body += _sink(k, i)
        body.append(f"fault = STEWART_FABS(a{k}{k}) > STEWART_SUSPECT ? fault : REAL(1);")
        if k < rows[-1]:
            body.append(f"const stewart_real inverse{k} = REAL(1) / a{k}{k};")
        for i in below:
            body.append(f"const stewart_real factor{i}{k} = a{i}{k} * inverse{k};")
            body += [f"a{i}{j} = a{i}{j} - factor{i}{k} * a{k}{j};" for j in columns[k + 1 :]]
    for i in reversed(rows):
        body += [f"a{i}6 = a{i}6 - a{i}{j} * a{j}6;" for j in rows[i + 1 :]]
        body.append(f"a{i}6 = a{i}6 {f'* inverse{i}' if i < rows[-1] else f'/ a{i}{i}'};")
    for i in rows:
        body += [
            f"const stewart_real F{i} = {_force(kernel, f'D[{i}][l]', f'a{i}6')};",
            f"fault = STEWART_FABS(F{i}) <= STEWART_MAX ? fault : REAL(1);",
            f"F[{i}][l] = F{i};",
        ]
    body.append("bad[l] = fault;")
    lines = "\n".join(wrap_list(" " * 8 + line, " " * 12) for line in body)
    text = _only(_SOLVE_BLOCK, kernel).replace("@FORCE@", _force(kernel, "D", "x"))
    return text.replace("@BODY@", lines)


def _sink(k: int, i: int) -> list[str]:
    """Rows k and i exchanged where row i has the larger entry in column k."""
    mask = f"below{i}{k}"
    lines = [
        f"const stewart_real {mask} = STEWART_FABS(a{i}{k}) > STEWART_FABS(a{k}{k})",
        "    ? REAL(1) : REAL(0);",
    ]
    for upper, lower in ((f"a{k}{j}", f"a{i}{j}") for j in range(k, 7)):
        lines += [
            f"const stewart_real {upper}_{i} = {mask} > REAL(0) ? {lower} : {upper};",
            f"{lower} = {mask} > REAL(0) ? {upper} : {lower};",
            f"{upper} = {upper}_{i};",
        ]
    return lines


def _pose(kernel: ForceKernel) -> str:
    """One pose; without legs that add to c, the platform's part is all of it."""
    adds = n.c_force in {out.quantity for out in kernel.leg.outputs}
    text = _only(_POSE, kernel).replace("@FORCE@", _force(kernel, "legs.D[i]", "x[i]"))
    return text.replace("@QUALIFIED@", "" if adds else "const ")


def _force(kernel: ForceKernel, known: str, solved: str) -> str:
    """F = D - x, (37), as text."""
    return f"{known} - {solved}" if n.D in {out.quantity for out in kernel.leg.outputs} else f"-{solved}"


def _batch(kernel: ForceKernel) -> str:
    given = kernel.used_motion()
    missing = ["motions", "F", *(f"motions->{q.name}" for q in given if q not in (n.F_ext, n.M_ext))]
    if kernel.constants is None:
        missing.insert(0, "model")
    parts = {
        "@LOADS@": _transposed(given),
        "@ONE@": _copied(given),
        "@MISSING@": wrap(
            f"    if ({' || '.join(f'{name} == NULL' for name in missing)}) {{", " " * 8, before=r"\|\|"
        ),
    }
    text = _only(_BATCH, kernel)
    for mark, lines in parts.items():
        text = text.replace(mark, lines)
    return text


def _transposed(motion: tuple[Quantity, ...]) -> str:
    lines = []
    for q in motion:
        call = f"spread_{'matrix' if q == n.R else 'vector'}"
        line = f"{call}(whole(motions->{q.name}, {size(q)}, first, count, padded), in->{q.name});"
        if q in (n.F_ext, n.M_ext):
            lines += [
                f"    if (motions->{q.name} != NULL) {{",
                f"        {line}",
                "    } else {",
                f"        clear(in->{q.name});",
                "    }",
            ]
        else:
            lines.append(f"    {line}")
    return "\n".join(lines)


def _copied(motion: tuple[Quantity, ...]) -> str:
    lines = []
    for q in motion[1:]:
        value = f"motions->{q.name}[at]"
        if q in (n.F_ext, n.M_ext):
            value = f"motions->{q.name} != NULL ? {value} : REAL(0)"
        lines.append(f"        one.{q.name}[i] = {value};")
    return "\n".join(lines)


_HEADER = """\
/* stewart_{name}_forces.h: the actuator forces alone, from prepared constants, as fast as we can.
 *
 * Written by stewart-sym {version}; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * One pose puts its six legs into lanes of eight, a batch eight poses; compilers make vector instructions of
 * the loops over lanes (gcc and clang: -O3 -std=c99 -fno-math-errno, and -march for the machine; with
 * -ffp-contract=off one pose and a batch agree to the last bit).
 *
{model}{operations}
 */
#ifndef {guard}
#define {guard}

#include "stewart.h"

#ifdef __cplusplus
extern "C" {{
#endif

/* A robot's constants, prepared once; legs in lanes, the last two lanes repeat leg 6. */
typedef struct {{
{legs}
{platform}
{scale}
}} stewart_{name}_model;

/* Prepares the constants; k may have any length but zero. Returns a status: STEWART_NOT_FINITE
 * if a number of the robot is not finite or too large, or k is zero; the model is written only if it is
 * STEWART_OK. */
STEWART_NODISCARD int stewart_{name}_prepare(const stewart_robot *robot, stewart_{name}_model *model);

/* Actuator forces F, N, of one pose, (37). Returns a status; F is written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_{name}_forces(
    const stewart_{name}_model *model, const stewart_motion *motion, stewart_real F[6]);

/* Actuator forces F[count][6] of `count` poses. `status` takes one code for each pose; null: not wanted.
 * Returns the first code other than STEWART_OK, or STEWART_OK. No pose's result depends on the others. */
STEWART_NODISCARD int stewart_{name}_forces_batch(
    const stewart_{name}_model *model, size_t count, const stewart_motions *motions, stewart_real *F,
    int *status);

#ifdef __cplusplus
}}
#endif

#endif
"""

_MODEL = {True: "", False: " * Fidelity: {meaning}.\n *\n"}

_TOP = """\
/* stewart_{name}_forces.c: see stewart_{name}_forces.h.
 *
 * Written by stewart-sym {version}; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include "stewart_{name}_forces.h"

"""

_STRUCTS = """\
/* Motions of eight poses, component by component. */
typedef struct {
@MOTION@
} motion_lanes;

/* What a pose has for all legs. */
typedef struct {
@SHARED@
} shared_terms;

typedef struct {
@SHARED_LANES@
} shared_lanes;

/* The legs of one pose. */
typedef struct {
@TERMS@
    stewart_real L[LANES], reach[LANES]<K:, k3[LANES]:K>;
    stewart_real bad[LANES]; /* 1 where the leg needs a closer look, else 0 */
} leg_lanes;

/* Status of the leg in one lane. */
static int leg_status(const leg_lanes *leg, int l)
{
    if (!(leg->L[l] <= STEWART_MAX)) {
        return STEWART_NOT_FINITE;
    }
    if (!(leg->L[l] > STEWART_ROUNDING * leg->reach[l])) {
        return STEWART_SHORT_LEG;
    }
    <K:return leg->k3[l] > STEWART_POLE_SINE ? STEWART_OK : STEWART_POLE;:K>
    <J:return STEWART_OK;:J>
}
"""

_NUMBERS = """\
/* What differs from leg to leg; the last two lanes repeat leg 6. */
typedef struct {
@MEMBERS@
} stewart_@NAME@_model;

static const stewart_@NAME@_model numbers = {
@ROWS@
};
"""

_BAKED_HEADER = """\
/* stewart_{name}_forces.h: the actuator forces of one machine, its numbers folded in.
 *
 * Written by stewart-sym {version}; do not edit.
 * SPDX-License-Identifier: 0BSD
 *
 * One pose puts its six legs into lanes of eight, a batch eight poses; compilers make vector instructions of
 * the loops over lanes (gcc and clang: -O3 -std=c99 -fno-math-errno, and -march for the machine; with
 * -ffp-contract=off one pose and a batch agree to the last bit).
 *
 * Fidelity: {meaning}. Before the numbers were folded in a pose took {before} operations.
 *
{operations}
 */
#ifndef {guard}
#define {guard}

#include "stewart.h"

#ifdef __cplusplus
extern "C" {{
#endif

/* Actuator forces F, N, of one pose, (37). Returns a status; F is written only if it is STEWART_OK. */
STEWART_NODISCARD int stewart_{name}_forces(const stewart_motion *motion, stewart_real F[6]);

/* Actuator forces F[count][6] of `count` poses. `status` takes one code for each pose; null: not wanted.
 * Returns the first code other than STEWART_OK, or STEWART_OK. No pose's result depends on the others. */
STEWART_NODISCARD int stewart_{name}_forces_batch(
    size_t count, const stewart_motions *motions, stewart_real *F, int *status);

#ifdef __cplusplus
}}
#endif

#endif
"""

_PREPARE = """\
int stewart_@NAME@_prepare(const stewart_robot *robot, stewart_@NAME@_model *model)
{
    stewart_@NAME@_model made;
    prepared_leg found, sum;
    prepared_platform platform;
    const stewart_real *numbers = (const stewart_real *)&made;
    const size_t count = sizeof made / sizeof *numbers;
    size_t number;
    int i;
    if (robot == NULL || model == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
@ZERO@
    for (i = 0; i < LANES; ++i) {
        prepare_leg(robot, &robot->leg[i < 6 ? i : 5], &found);
@COPIES@
        if (i >= 6) {
            continue;
        }
@ADD@
    }
    prepare_platform(robot, &sum, &platform);
@PLATFORM@
@SCALE@
    for (number = 0; number < count; ++number) {
        if (!(STEWART_FABS(numbers[number]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    *model = made;
    return STEWART_OK;
}
"""

_SHARED_POSE = """\
/* What one pose has for all legs: @COUNT@ operations. */
static void shared_of_pose(const stewart_@NAME@_model *model, const stewart_motion *at, shared_terms *out)
{
@UNUSED model@
@BODY@
}
"""

_BLOCK = """\
/* Eight poses on their way. */
typedef struct {
    stewart_real column[7][6][LANES]; /* [H | c], column by column */
    stewart_real <D:D[6][LANES], :D>F[6][LANES];
    stewart_real bad[LANES]; /* 1 where a leg, a pivot or a force needs a closer look, else 0 */
} block;
<A:
/* What a leg of eight poses hands to the moments. */
typedef struct {
    stewart_real q[3][LANES]<C:, c_force[3][LANES]:C><F:, c_moment[3][LANES]:F>;
} leg_block;
:A>"""

_SHARED_BLOCK = """\
/* What each of eight poses has for all legs, and the platform's part of c. */
static void shared_of_block(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const motion_lanes *STEWART_RESTRICT in,
    shared_lanes *STEWART_RESTRICT out, stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l;
@OUTSIDE@
@UNUSED model@
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_LEGS_OF_POSE = """\
/* The legs of one pose side by side: @COUNT@ operations each. */
static void @FUNCTION@(
    const stewart_@NAME@_model *STEWART_RESTRICT model, const stewart_motion *STEWART_RESTRICT at,
    const shared_terms *STEWART_RESTRICT shared, leg_lanes *STEWART_RESTRICT out)
{
    int l;
@OUTSIDE@
@UNUSED shared@
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_LEG_OF_BLOCK = """\
/* One leg of eight poses side by side, @COUNT@ operations each:
 * its column of H<A:, forces alone:A><D:, its D:D><C:, its part of c:C>. */
static void leg_of_block(
    const stewart_@NAME@_model *STEWART_RESTRICT model, int leg, const motion_lanes *STEWART_RESTRICT in,
    const shared_lanes *STEWART_RESTRICT shared, stewart_real (*STEWART_RESTRICT column)[LANES],
    <A:leg_block *STEWART_RESTRICT out, :A><O:stewart_real (*STEWART_RESTRICT c)[LANES], :O>
    <D:stewart_real *STEWART_RESTRICT known, :D>stewart_real *STEWART_RESTRICT bad)
{
    int l;
@OUTSIDE@
@UNUSED shared@
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_SOLVE_POSE = """\
static void exchange_rows(stewart_real *STEWART_RESTRICT upper, stewart_real *STEWART_RESTRICT lower)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        const stewart_real moved = upper[j];
        upper[j] = lower[j];
        lower[j] = moved;
    }
}

static void subtract_row(
    stewart_real *STEWART_RESTRICT to, stewart_real factor, const stewart_real *STEWART_RESTRICT from)
{
    int j;
    for (j = 0; j < LANES; ++j) {
        to[j] = to[j] - factor * from[j];
    }
}

/* Solves the augmented rows [H | c | 0] for x by elimination with partial pivoting, (36); whole rows are
 * updated, so that a row is one vector. Returns 1 where a pivot is small, else 0.@WHY@ */
static int solve_pose(stewart_real A[6][LANES], stewart_real x[6])
{
    stewart_real a0, a1, a2, a3, a4, a5, factor1, factor2, factor3, factor4, factor5;
    stewart_real inverse0, inverse1, inverse2, inverse3, inverse4;
@BODY@
}
"""

_MOMENTS_OF_POSE = """\
/* The platform's part of c with moments about platform point 1. */
static void shift_of_pose(const leg_lanes *STEWART_RESTRICT legs, shared_terms *STEWART_RESTRICT shared)
{
@SHIFT@
}

/* Moments about platform point 1, @COUNT@ operations of each leg but the first, which has none. */
static void moments_of_pose(leg_lanes *legs)
{
    int l;
@OUTSIDE@
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_MOMENTS_OF_BLOCK = """\
/* Leg 1 of eight poses: the platform's part of c moves to platform point 1, and the leg's is added. */
static void moments_of_first(const leg_block *STEWART_RESTRICT own, stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
@FIRST@
    }
}

/* Another leg: its moments about platform point 1, @COUNT@ operations each, and its part of c. */
static void moments_of_block(
    const leg_block *STEWART_RESTRICT own, stewart_real (*STEWART_RESTRICT q_1)[LANES],
    stewart_real (*STEWART_RESTRICT column)[LANES], stewart_real (*STEWART_RESTRICT c)[LANES])
{
    int l; @UNUSED@
    for (l = 0; l < LANES; ++l) {
@OTHER@
    }
}
"""

_POSE = """\
/* Status of a pose whose H may be singular to rounding. */
STEWART_APART static int pose_status(const leg_lanes *legs)
{
    stewart_real H[6][6], arm[6][3];
    int i, j;
    for (i = 0; i < 6; ++i) {
        for (j = 0; j < 3; ++j) {
            arm[i][j] = legs->q[j][i]<A: - legs->q[j][0]:A>;
            H[j][i] = legs->H_force[j][i];
            H[j + 3][i] = legs->H_moment[j][i];
        }
    }
    return singular_status(H, arm, legs->L, legs->reach);
}

int stewart_@NAME@_forces(
    <M:const stewart_@NAME@_model *model, :M>const stewart_motion *motion, stewart_real F[6])
{
    <B:const stewart_@NAME@_model *const model = &numbers;:B>
    shared_terms shared;
    leg_lanes legs;
    stewart_real A[6][LANES];
    stewart_real x[6], found[6];
    int i, j, status, suspect;
    int close = 0;
    <P:int near_pole = 0;:P>
    if (<M:model == NULL || :M>motion == NULL || F == NULL) {
        return STEWART_BAD_ARGUMENT;
    }
    shared_of_pose(model, motion, &shared);
    legs_of_pose(model, motion, &shared, &legs);
    for (i = 0; i < 6; ++i) {
        if (legs.bad[i] > REAL(0)) {
            status = leg_status(&legs, i);
            if (status != STEWART_OK) {
                return status;
            }
            close = legs.L[i] > STEWART_SHORT_SHARE * legs.reach[i] ? close : 1;
            <P:near_pole = legs.k3[i] > STEWART_NEAR_POLE ? near_pole : 1;:P>
        }
    }
    <P:if (near_pole != 0) {:P>
    <P:    legs_near_pole(model, motion, &shared, &legs);:P>
    <P:}:P>
    <A:shift_of_pose(&legs, &shared);:A>
    <A:moments_of_pose(&legs);:A>
    for (j = 0; j < 3; ++j) {
        @QUALIFIED@stewart_real force = shared.c_force[j];
        @QUALIFIED@stewart_real turn = shared.<A:c_tip:A><O:c_moment:O>[j];
        <C:for (i = 0; i < 6; ++i) {:C>
        <C:    force = force + legs.c_force[j][i];:C>
        <F:    turn = turn + legs.c_moment[j][i];:F>
        <G:    turn = turn + legs.arm_c[j][i];:G>
        <C:}:C>
        for (i = 0; i < LANES; ++i) {
            A[j][i] = legs.H_force[j][i];
            A[j + 3][i] = legs.H_moment[j][i];
        }
        A[j][6] = force;
        A[j + 3][6] = turn;
        A[j][7] = REAL(0);
        A[j + 3][7] = REAL(0);
    }
    <S:if (@IS_SCALED@) {:S>
    <S:    scale_pose(A, @PER_LENGTH@);:S>
    <S:}:S>
    <Z:scale_pose(A, @PER_LENGTH@);:Z>
    suspect = solve_pose(A, x);
    if (close != 0 || suspect != 0) {
        status = pose_status(&legs);
        if (status != STEWART_OK) {
            return status;
        }
    }
    for (i = 0; i < 6; ++i) {
        found[i] = @FORCE@;
        if (!(STEWART_FABS(found[i]) <= STEWART_MAX)) {
            return STEWART_NOT_FINITE;
        }
    }
    for (i = 0; i < 6; ++i) {
        F[i] = found[i];
    }
    return STEWART_OK;
}
"""

_SCALE_POSE = """\
/* Takes the moments of the rows [H | c] over a length. */
static void scale_pose(stewart_real A[6][LANES], stewart_real per_length)
{
    int i, j;
    for (i = 3; i < 6; ++i) {
        for (j = 0; j < LANES; ++j) {
            A[i][j] = A[i][j] * per_length;
        }
    }
}
"""

_SCALE_BLOCK = """\
/* The same for eight poses. */
static void scale_block(block *out, stewart_real per_length)
{
    int i, j, l;
    for (i = <A:1:A><O:0:O>; i < 7; ++i) {
        for (j = 3; j < 6; ++j) {
            for (l = 0; l < LANES; ++l) {
                out->column[i][j][l] = out->column[i][j][l] * per_length;
            }
        }
    }
}
"""

_SOLVE_BLOCK = """\
/* Solves eight systems [H | c] side by side for x by elimination with partial pivoting, (36), and
 * F = @FORCE@, (37). Marks as bad where a pivot is small or a force is not finite. */
STEWART_APART static void solve_block(
    stewart_real (*STEWART_RESTRICT column)[6][LANES],<D: stewart_real (*STEWART_RESTRICT D)[LANES],:D>
    stewart_real (*STEWART_RESTRICT F)[LANES], stewart_real *STEWART_RESTRICT bad)
{
    int l;
    for (l = 0; l < LANES; ++l) {
@BODY@
    }
}
"""

_BATCH = """\
/* `width` numbers of each of eight poses; past the end, the last pose again. */
static const stewart_real *whole(
    const stewart_real *from, size_t width, size_t first, size_t count, stewart_real *padded)
{
    size_t l, i;
    if (first + (size_t)LANES <= count) {
        return &from[first * width];
    }
    for (l = 0; l < (size_t)LANES; ++l) {
        const size_t pose = first + l < count ? first + l : count - 1U;
        for (i = 0; i < width; ++i) {
            padded[l * width + i] = from[pose * width + i];
        }
    }
    return padded;
}

/* Eight vectors, eight matrices, eight zeros: component by component. */
static void spread_vector(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[LANES])
{
    int l;
    for (l = 0; l < LANES; ++l) {
        to[0][l] = from[3 * l];
        to[1][l] = from[3 * l + 1];
        to[2][l] = from[3 * l + 2];
    }
}

static void spread_matrix(
    const stewart_real *STEWART_RESTRICT from, stewart_real (*STEWART_RESTRICT to)[LANES])
{
    int i, l;
    for (i = 0; i < 9; ++i) {
        for (l = 0; l < LANES; ++l) {
            to[i][l] = from[9 * l + i];
        }
    }
}

static void clear(stewart_real (*to)[LANES])
{
    int i, l;
    for (i = 0; i < 3; ++i) {
        for (l = 0; l < LANES; ++l) {
            to[i][l] = REAL(0);
        }
    }
}

static void load_block(const stewart_motions *motions, size_t first, size_t count, motion_lanes *in)
{
    stewart_real padded[9 * LANES];
@LOADS@
}

static void forces_of_block(const stewart_@NAME@_model *model, const motion_lanes *in, block *out)
{
    shared_lanes shared;
    <A:leg_block first, other;:A>
    int i, l;
    for (l = 0; l < LANES; ++l) {
        out->bad[l] = REAL(0);
    }
    shared_of_block(model, in, &shared, out->column[6]);
    for (i = 0; i < 6; ++i) {
        leg_of_block(
            model, i, in, &shared, out->column[i],
            <A:i == 0 ? &first : &other, :A><O:out->column[6], :O><D:out->D[i], :D>out->bad);
        <A:if (i == 0) {:A>
        <A:    moments_of_first(&first, out->column[6]);:A>
        <A:} else {:A>
        <A:    moments_of_block(&other, first.q, out->column[i], out->column[6]);:A>
        <A:}:A>
    }
    <S:if (@IS_SCALED@) {:S>
    <S:    scale_block(out, @PER_LENGTH@);:S>
    <S:}:S>
    <Z:scale_block(out, @PER_LENGTH@);:Z>
    solve_block(out->column, <D:out->D, :D>out->F, out->bad);
}

/* Forces and status of one pose of a batch. */
static int forces_of(
    <M:const stewart_@NAME@_model *model, :M>const stewart_motions *motions, size_t pose, stewart_real *F)
{
    stewart_motion one;
    int i;
    for (i = 0; i < 9; ++i) {
        one.R[i] = motions->R[pose * 9U + (size_t)i];
    }
    for (i = 0; i < 3; ++i) {
        const size_t at = pose * 3U + (size_t)i;
@ONE@
    }
    return stewart_@NAME@_forces(<M:model, :M>&one, F);
}

int stewart_@NAME@_forces_batch(
    <M:const stewart_@NAME@_model *model, :M>size_t count, const stewart_motions *motions, stewart_real *F,
    int *status)
{
    <B:const stewart_@NAME@_model *const model = &numbers;:B>
    motion_lanes in;
    block done;
    size_t first;
    int result = STEWART_OK;
    int i, l;
@MISSING@
        return STEWART_BAD_ARGUMENT;
    }
    for (first = 0; first < count; first += (size_t)LANES) {
        load_block(motions, first, count, &in);
        forces_of_block(model, &in, &done);
        for (l = 0; l < LANES && first + (size_t)l < count; ++l) {
            const size_t pose = first + (size_t)l;
            int code = STEWART_OK;
            if (done.bad[l] > REAL(0)) {
                code = forces_of(<M:model, :M>motions, pose, &F[pose * 6U]);
            } else {
                for (i = 0; i < 6; ++i) {
                    F[pose * 6U + (size_t)i] = done.F[i][l];
                }
            }
            if (status != NULL) {
                status[pose] = code;
            }
            result = result == STEWART_OK ? code : result;
        }
    }
    return result;
}
"""
