"""Self-test of a kit on its target, ``selftest.c``, with expected results of 50 digits."""

from collections.abc import Iterable, Mapping, Sequence

from ..kernel.interface import STRUCTS, Member
from ..mechanics import quantities as n
from .forces_name import FORCES_HEADER
from .functions import MODEL, ROBOT, Function, Vector, flat, includes, reads_robot
from .robot_source import Machine
from .text_format import Numbers, in_comment, literal, literals_of_legs, motion_members, stored, template

PER_LINE = 4
_ZERO = {q.name: [[0.0] * 3] * 3 if len(q.shape) == 2 else [0.0] * 3 for q in n.MOTION}
"""Motion in a self-test whose functions read none."""


def selftest(
    machine: Machine,
    functions: Sequence[Function],
    vectors: Mapping[str, Sequence[Vector]],
    rejected: Sequence[Vector],
) -> str:
    """Return ``selftest.c``.

    Parameters
    ----------
    vectors : mapping
        Test vectors by the stems of the functions.
    rejected : sequence of Vector
        Motions without forces, used if the kit computes forces.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    motions, table = _motions([vector for function in functions for vector in vectors[function.stem]])
    parts = {
        "name": in_comment(machine.name),
        "version": machine.version,
        "arithmetic": template("kit/arithmetic.h"),
        "includes": includes(functions) + _kit_include(functions),
        "robot": _constants(machine) if reads_robot(functions) else "",
        "models": "".join(template("kit/selftest_model.c", {"prefix": p}) for p in _prefixes(functions)),
        "motions": _initializers(motions or [_ZERO]),
        "motion_count": str(len(motions or [_ZERO])),
        "pointers": template("kit/selftest_pointers.c") if any(f.batch for f in functions) else "",
        "calls": "\n".join(text for function in functions for text in (_call(function), _batch(function))),
        "vectors": "\n".join(_arrays(function, vectors[function.stem], table) for function in functions),
        "rejected": _rejected_motions(rejected) if any(f.stem == "forces" for f in functions) else "",
        "kit_forces": _kit_forces(functions),
        "functions": str(len(functions)),
        "most": str(max(function.call.count for function in functions)),
        "most_inputs": str(max(1, *(each.call.taken for each in functions))),
        "reads_robot": "#define READS_ROBOT\n" if any(f.subject == ROBOT for f in functions) else "",
        "rows": "\n".join(_row(function, vectors[function.stem]) for function in functions),
        "prepared": _models(functions),
        "harness": template("kit/selftest_harness.c"),
    }
    return template("kit/selftest.c", parts)


def _motions(vectors: Sequence[Vector]) -> tuple[list[Numbers], dict[int, int]]:
    """Return each different motion once, and the index of each vector's motion by the vector's identity."""
    found: list[Numbers] = []
    table = {}
    for vector in vectors:
        if (motion := vector.motion) is not None:
            if motion not in found:
                found.append(motion)
            table[id(vector)] = found.index(motion)
    return found, table


def _prefixes(functions: Sequence[Function]) -> list[str]:
    return list(dict.fromkeys(f.prefix for f in functions if f.subject == MODEL))


def _models(functions: Sequence[Function]) -> str:
    prefixes = _prefixes(functions)
    rows = (
        f'    {{"{p}_prepare", {p}_prepared,\n        &{p}_of, &{p}_made, &{p}_before, sizeof {p}_of}},'
        for p in prefixes
    )
    values = {"count": str(len(prefixes)), "rows": "\n".join(rows)}
    return template("kit/selftest_models.c", values) if prefixes else ""


def _constants(machine: Machine) -> str:
    """Return the numbers of each struct of ``stewart_robot.c``."""
    of_legs = {"limits": machine.limits} | ({} if machine.drives is None else {"drives": machine.drives})
    legs = [(q, leg) for leg in range(6) for q in n.of_leg(machine.numbers)]
    parts = [*legs, *((q, None) for q in n.PLATFORM)]
    numbers = (number for q, leg in parts for number in stored(machine.numbers, q, "robot", leg))
    found = _numbers("robot", machine.symbol, [literal(number, "robot") for number in numbers])
    for struct, members in of_legs.items():
        literals = [each for six in literals_of_legs(members, struct).values() for each in six]
        found += _numbers(struct, f"{machine.symbol}_{struct}", literals)
    return found


def _numbers(struct: str, symbol: str, literals: Sequence[str]) -> str:
    table = _table(f"{struct}_numbers", literals)
    values = {"struct": struct, "macro": struct.upper(), "symbol": symbol, "numbers": table}
    return template("kit/selftest_numbers.c", values)


def _called(function: Function, suffix: str, declared: Iterable[str], body: Iterable[str]) -> str:
    """Return a function of the self-test that calls a function of the kit."""
    lines = "".join(f"    {line}\n" for line in (*declared, *body))
    values = {"stem": function.stem, "suffix": suffix, "body": lines}
    return template("kit/selftest_call.c", values)


def _subject(function: Function) -> str:
    return function.subject_argument("&robot_of.robot", f"&{function.prefix}_of", "&drives_of.drives")


def _call(function: Function) -> str:
    """Return the call for one pose, which copies structs from ``in`` and ``out`` and to ``out``."""
    call = function.call
    given, found = _places("in", call.inputs), _places("out", call.outputs)
    declared, before, after, handed = [], [], [], []
    for argument in call.arguments:
        name = "found" if argument.whole else "made" if argument.name == "motion" else argument.name
        if argument.is_motion:
            handed.append("motion")
            continue
        if not argument.struct:
            handed.append((found if argument.written else given)[(argument.takes or argument.gives)[0]])
            continue
        declared.append(f"stewart_{argument.struct} {name};")
        handed.append(f"&{name}")
        if argument.whole:
            before.append(f"(void)memcpy(&{name}, out, sizeof {name});")
            after.append(f"(void)memcpy(out, &{name}, sizeof {name});")
            continue
        targets = [f"{name}.{member.name}" for member in STRUCTS[argument.struct]]
        before += [
            _copied(target, given[each]) for target, each in zip(targets, argument.takes, strict=False)
        ]
        if argument.gives and not argument.takes:
            before.append(f"(void)memset(&{name}, 0, sizeof {name});")
        copies = [_copied(found[each], f"{name}.{each.name}", True) for each in argument.gives]
        if copies:
            after += ["if (status == STEWART_OK) {", *(f"    {line}" for line in copies), "}"]
    unused = [*([] if call.inputs else ["(void)in;"]), *([] if call.motion else ["(void)motion;"])]
    made = f"{function.symbol}({_subject(function)}{', '.join(handed)});"
    if not after:
        return _called(function, "call", declared, [*unused, *before, f"return {made}"])
    body = [*unused, *before, f"status = {made}", *after, "return status;"]
    return _called(function, "call", [*declared, "int status;"], body)


def _copied(to: str, source: str, sized_by_source: bool = False) -> str:
    return f"(void)memcpy({to}, {source}, sizeof {source if sized_by_source else to});"


def _places(array: str, members: Iterable[Member]) -> dict[Member, str]:
    """Return the location of each member's numbers in ``in`` or ``out``."""
    found, start = {}, 0
    for member in members:
        found[member] = f"{array} + {start}" if start else array
        start += member.count
    return found


def _batch(function: Function) -> str:
    """Return a call of the function's batches with one pose; their code is not the code for one pose."""
    if not function.batch:
        return ""
    call = function.call
    (filled,) = (each for each in call.arguments if each.gives)
    lines = ["const stewart_motions poses = pointers_to(motion);"]
    lines += [f"stewart_{filled.struct}_arrays arrays;"] if filled.struct else []
    lines += [f"stewart_real again[{call.count}];"] if call.has_columns else []
    lines += ["int status = -1;", "int first;", *([] if call.inputs else ["(void)in;"])]
    places = _places("out", call.outputs)
    lines += [f"arrays.{each.name} = {at};" for each, at in places.items()] if filled.struct else []
    further = "in, " if call.inputs else ""
    target = "&arrays" if filled.struct else "out"
    lines += [
        f"first = {function.symbol}_batch({_subject(function)}1, &poses, {further}{target}, &status);",
        *(_columns(function) if call.has_columns else ()),
        "return first == status ? first : -1;",
    ]
    return _called(function, "batch", [], lines)


def _columns(function: Function) -> list[str]:
    """Return a comparison of both batches: with one pose, columns and rows contain the same numbers."""
    again = f"{function.symbol}_columns({_subject(function)}1, 1, &poses, again, NULL)"
    return [
        "(void)memcpy(again, out, sizeof again);",
        f"if ({again} != first || memcmp(again, out, sizeof again) != 0) {{",
        "    return -1;",
        "}",
    ]


def _rejected_motions(rejected: Sequence[Vector]) -> str:
    values = {
        "count": str(len(rejected)),
        "motions": _initializers([each.motion or _ZERO for each in rejected]),
        "statuses": ", ".join(str(each.status) for each in rejected),
    }
    return template("kit/selftest_rejected.c", values)


def _forces(functions: Sequence[Function]) -> Function | None:
    """Return the forces among the functions of a kit, None for a kit without them."""
    return next((function for function in functions if function.stem == "forces"), None)


def _kit_include(functions: Sequence[Function]) -> str:
    """Include ``stewart_kit.h`` if the kit has it."""
    return f'#include "{FORCES_HEADER}"\n' if _forces(functions) else ""


def _kit_forces(functions: Sequence[Function]) -> str:
    """Compare the functions of ``stewart_kit.h`` with the kernel that they call."""
    if (forces := _forces(functions)) is None:
        return ""
    batch = template("kit/selftest_kit_batch.c") if forces.batch else ""
    return template("kit/selftest_kit_forces.c", {"batch": batch})


def _initializers(motions: Sequence[Numbers]) -> str:
    return ",\n".join(f"    {{\n{motion_members(motion, ' ' * 8)}\n    }}" for motion in motions)


def _arrays(function: Function, vectors: Sequence[Vector], table: Mapping[int, int]) -> str:
    stem, call = function.stem, function.call
    where = ", ".join(str(table.get(id(vector), 0)) for vector in vectors)
    parts = [f"static const unsigned char {stem}_motions[{len(vectors)}] = {{{where}}};"]
    arrays = {
        "in": [flat(each.inputs, call.inputs) for each in vectors],
        "answers": [flat(each.answers, call.outputs) for each in vectors],
        "bounds": [flat(each.bounds, call.outputs) for each in vectors],
    }
    for what, rows in arrays.items():
        if any(rows):
            numbers = [literal(number, f"{stem}_{what}") for row in rows for number in row]
            parts.append(_table(f"{stem}_{what}", numbers))
    return "\n".join(parts) + "\n"


def _table(name: str, numbers: Sequence[str]) -> str:
    lines = [", ".join(numbers[i : i + PER_LINE]) for i in range(0, len(numbers), PER_LINE)]
    body = ",\n    ".join(lines)
    return f"static const stewart_real {name}[{len(numbers)}] = {{\n    {body}}};"


def _row(function: Function, vectors: Sequence[Vector]) -> str:
    stem, call = function.stem, function.call
    inputs = call.taken
    given = f"{stem}_in" if inputs else "NULL"
    batch = f"{stem}_batch" if function.batch else "NULL"
    prepared = int(function.subject == MODEL)
    return (
        f'    {{"{stem}", {stem}_call, {batch}, {len(vectors)}, {inputs}, {call.count}, '
        f"{int(call.motion)},\n"
        f"        {stem}_motions, {given}, {stem}_answers, {stem}_bounds, {prepared}}},"
    )
