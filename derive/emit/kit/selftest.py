"""``selftest.c``: a kit's proof of itself on its target, by answers that were computed at 50 digits.

One of the kit's texts. Takes the functions of a kit and their test vectors; knows no equation and nothing of
how answers and bounds came about.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from . import robot as robot_text
from .functions import MODEL, NOTHING, ROBOT, Function
from .words import EPSILON, Numbers, filled, in_comment, literal, motion_members

PER_LINE = 4


@dataclass(frozen=True)
class Refusal:
    """A motion without forces, R as (3, 3), and the status that says so."""

    motion: Numbers
    status: int


@dataclass(frozen=True)
class Case:
    """One call: the motion's fields, R as (3, 3), None where none is read; the other inputs; every answer and
    its largest error in rounding units, flat, in the order of the signature."""

    motion: Numbers | None
    inputs: Sequence[float]
    answers: Sequence[float]
    bounds: Sequence[float]


def selftest(
    name: str,
    symbol: str,
    functions: Sequence[Function],
    cases: Mapping[str, Sequence[Case]],
    refusals: Sequence[Refusal],
    version: str,
) -> str:
    """``selftest.c``. name: the robot's; symbol: its constants in C. cases: by the functions' stems.
    refusals: of the forces, where they are among the functions.

    Raises ValueError naming what is not a finite number.
    """
    motions, table = _motions([case for function in functions for case in cases[function.stem]])
    parts = {
        "name": in_comment(name),
        "version": version,
        "epsilon": EPSILON,
        "includes": "".join(f'#include "{file}"\n' for file in _headers(functions)),
        "models": _models(functions),
        "prepared": "".join(filled(_PREPARED, {"prefix": p}) for p in _prefixes(functions)),
        "of_robot": _OF_ROBOT if any(f.subject == ROBOT for f in functions) else "",
        "motions": ",\n".join(f"    {{\n{motion_members(motion, ' ' * 8)}\n    }}" for motion in motions),
        "motion_count": str(len(motions)),
        "most": str(max(function.signature.count for function in functions)),
        "most_inputs": str(max(1, *(each.signature.taken for each in functions))),
        "calls": "\n".join(
            text for function in functions for text in (_call(function, symbol), _batch(function, symbol))
        ),
        "pointers": _POINTERS if any(function.batch for function in functions) else "",
        "refusals": _refusals(refusals) if any(f.stem == "forces" for f in functions) else "",
        "told": _TOLD if any(f.stem == "forces" for f in functions) else "",
        "refused": _REFUSED if any(f.stem == "forces" for f in functions) else "",
        "vectors": "\n".join(_arrays(function, cases[function.stem], table) for function in functions),
        "rows": "\n".join(_row(function, cases[function.stem]) for function in functions),
        "function_count": str(len(functions)),
        "unprepare": "".join(
            f"    (void)memset(&{prefix}_of, 0, sizeof {prefix}_of);\n" for prefix in _prefixes(functions)
        ),
        "prepare": _prepare(functions, symbol),
    }
    return filled(_SELFTEST, parts)


def _headers(functions: Sequence[Function]) -> list[str]:
    own = [robot_text.HEADER] if any(function.subject != NOTHING for function in functions) else []
    return [*own, *dict.fromkeys(function.header for function in functions)]


def _motions(cases: Sequence[Case]) -> tuple[list[Numbers], dict[int, int]]:
    """Every motion once, and where that of a case stands, by the case's identity."""
    found: list[Numbers] = []
    table = {}
    for case in cases:
        if case.motion is not None:
            if case.motion not in found:
                found.append(case.motion)
            table[id(case)] = found.index(case.motion)
    return found, table


def _prefixes(functions: Sequence[Function]) -> list[str]:
    return list(dict.fromkeys(f.prefix for f in functions if f.subject == MODEL))


def _models(functions: Sequence[Function]) -> str:
    return (_ROBOT_OF if _has_robot(functions) else "") + "".join(
        f"static {prefix}_model {prefix}_of;\n" for prefix in _prefixes(functions)
    )


def _has_robot(functions: Sequence[Function]) -> bool:
    return any(function.subject != NOTHING for function in functions)


def _prepare(functions: Sequence[Function], symbol: str) -> str:
    copied = f"    robot_of.robot = {symbol};\n" if _has_robot(functions) else ""
    return copied + "".join(
        f"    if ({prefix}_prepare(&{symbol}, &{prefix}_of) != STEWART_OK) {{\n"
        f'        said("{prefix}_prepare", 0, 1, 0);\n'
        "        return -1;\n"
        "    }\n"
        f"    if (!{prefix}_needs_finite(&{symbol})) {{\n"
        f'        said("{prefix}_prepare", 0, 1, 0);\n'
        "        return 1;\n"
        "    }\n"
        for prefix in _prefixes(functions)
    )


def _call(function: Function, symbol: str) -> str:
    first = {ROBOT: "&robot_of.robot, ", MODEL: f"&{function.prefix}_of, ", NOTHING: ""}[function.subject]
    signature = function.signature
    body = signature.call.replace("@symbol@", function.symbol).replace("@subject@", first)
    unused = "" if signature.inputs else "    (void)in;\n"
    unused += "" if signature.motion else "    (void)motion;\n"
    declared, rest = _declarations(body)
    return (
        f"static int {function.stem}_call(\n"
        "    const stewart_motion *motion, const stewart_real *in, stewart_real *out)\n"
        f"{{\n{declared}{unused}{rest}}}\n"
    )


_ARRAYS = {
    "inverse_dynamics": "stewart_forces_arrays",
    "joint_reactions": "stewart_reactions_arrays",
    "equations": "stewart_equations_arrays",
    "derivatives": "stewart_derivatives_arrays",
    "linearisation": "stewart_linearisation_arrays",
}
"""Structs that the batches of some functions fill; the others fill one array."""


def _batch(function: Function, symbol: str) -> str:
    """The function's batch, of one pose: what it computes stands apart from what one pose computes."""
    if not function.batch:
        return ""
    first = {ROBOT: "&robot_of.robot, ", MODEL: f"&{function.prefix}_of, ", NOTHING: ""}[function.subject]
    arrays = _ARRAYS.get(function.stem)
    further = "in, " if function.signature.inputs else ""
    lines = ["    const stewart_motions poses = pointers_to(motion);"]
    target = "out"
    if arrays is not None:
        lines.append(f"    {arrays} arrays;")
        target = "&arrays"
    lines += ["    int status = -1;", "    int first;"]
    lines += [] if further else ["    (void)in;"]
    start = 0
    for out in function.signature.outputs if arrays is not None else ():
        lines.append(f"    arrays.{out.name} = out + {start};")
        start += out.count
    lines.append(f"    first = {function.symbol}_batch({first}1, &poses, {further}{target}, &status);")
    lines.append("    return first == status ? first : -1;")
    body = "\n".join(lines)
    return (
        f"static int {function.stem}_batch(\n"
        "    const stewart_motion *motion, const stewart_real *in, stewart_real *out)\n"
        f"{{\n{body}\n}}\n"
    )


def _refusals(refusals: Sequence[Refusal]) -> str:
    motions = ",\n".join(f"    {{\n{motion_members(each.motion, ' ' * 8)}\n    }}" for each in refusals)
    statuses = ", ".join(str(each.status) for each in refusals)
    return (
        "/* Motions without forces, and the status that says so. */\n"
        f"#define REFUSALS {len(refusals)}\n"
        f"static const stewart_motion refused_motions[REFUSALS] = {{\n{motions}\n}};\n"
        f"static const int refused_status[REFUSALS] = {{{statuses}}};\n"
    )


_ROBOT_OF = """\
#define ROBOT_NUMBERS ((int)(sizeof(stewart_robot) / sizeof(stewart_real)))

/* The robot's constants, to be spoilt one by one. */
static union {
    stewart_robot robot;
    stewart_real numbers[sizeof(stewart_robot) / sizeof(stewart_real)];
} robot_of;
"""

_OF_ROBOT = """\
    sound &= needs_finite(test, &at.motion, in, robot_of.numbers, ROBOT_NUMBERS);
"""

_PREPARED = """\
/* Whether every number of the robot that is prepared has to be finite, and the model is else as it was. */
static int @prefix@_needs_finite(const stewart_robot *robot)
{
    static @prefix@_model made, before;
    int i, which, sound = 1;
    (void)memset(&before, 0, sizeof before);
    for (i = 0; i < ROBOT_NUMBERS; ++i) {
        for (which = 0; which < 3; ++which) {
            int status;
            robot_of.robot = *robot;
            robot_of.numbers[i] = not_finite(which);
            made = before;
            status = @prefix@_prepare(&robot_of.robot, &made);
            sound &= !memcmp(&made, status != STEWART_OK ? &before : &@prefix@_of, sizeof made);
        }
    }
    robot_of.robot = *robot;
    return sound;
}

"""

_POINTERS = """\
static stewart_motions pointers_to(const stewart_motion *motion)
{
    stewart_motions poses;
    poses.R = motion->R;
    poses.t = motion->t;
    poses.omega = motion->omega;
    poses.v = motion->v;
    poses.alpha = motion->alpha;
    poses.a = motion->a;
    poses.F_ext = motion->F_ext;
    poses.M_ext = motion->M_ext;
    return poses;
}
"""

_TOLD = """\
/* How many of the motions without forces are refused with the status that they should be. */
static int refused_as_told(int (*forces)(const stewart_motion *, const stewart_real *, stewart_real *))
{
    int i, right = 0;
    for (i = 0; i < REFUSALS; ++i) {
        blank(6);
        right += forces(&refused_motions[i], NULL, found) == refused_status[i] && is_blank(6);
    }
    return right;
}

"""

_REFUSED = """\
        if (tests[test].call == forces_call) {
            right += refused_as_told(forces_call);
            count += REFUSALS;
            if (tests[test].batch) {
                right += refused_as_told(tests[test].batch);
                count += REFUSALS;
            }
        }
"""


def _declarations(body: str) -> tuple[str, str]:
    """The body's declarations, and the statements after them."""
    lines = body.splitlines(keepends=True)
    count = 0
    while "(" not in lines[count]:
        count += 1
    return "".join(lines[:count]), "".join(lines[count:])


def _arrays(function: Function, cases: Sequence[Case], table: Mapping[int, int]) -> str:
    stem, signature = function.stem, function.signature
    where = ", ".join(str(table.get(id(case), 0)) for case in cases)
    parts = [f"static const unsigned char {stem}_motions[{len(cases)}] = {{{where}}};"]
    if signature.inputs:
        parts.append(_table(f"{stem}_in", "stewart_real", [case.inputs for case in cases]))
    parts.append(_table(f"{stem}_answers", "stewart_real", [case.answers for case in cases]))
    parts.append(_table(f"{stem}_bounds", "stewart_real", [case.bounds for case in cases]))
    return "\n".join(parts) + "\n"


def _table(name: str, kind: str, rows: Sequence[Sequence[float]]) -> str:
    """All rows in one flat array."""
    numbers = [literal(float(number), name) for row in rows for number in row]
    lines = [", ".join(numbers[i : i + PER_LINE]) for i in range(0, len(numbers), PER_LINE)]
    body = ",\n    ".join(lines)
    return f"static const {kind} {name}[{len(numbers)}] = {{\n    {body}}};"


def _row(function: Function, cases: Sequence[Case]) -> str:
    stem, signature = function.stem, function.signature
    inputs = signature.taken
    given = f"{stem}_in" if inputs else "NULL"
    batch = f"{stem}_batch" if function.batch else "NULL"
    prepared = int(function.subject == MODEL)
    return (
        f'    {{"{stem}", {stem}_call, {batch}, {len(cases)}, {inputs}, {signature.count}, '
        f"{int(signature.motion)},\n"
        f"        {stem}_motions, {given}, {stem}_answers, {stem}_bounds, {prepared}}},"
    )


_SELFTEST = """\
/* selftest.c: proves the kit of "@name@" where it runs.
 *
 * Every function is called with inputs whose answers were computed at 50 digits; each number that it hands
 * out must be within its bound, which grows with the rounding errors that its own inputs can make. Then each
 * is called wrongly, and must say so and write nothing.
 *
 * main returns 0 if all is well. It prints, unless built with -DSTEWART_NO_STDIO; with -DSTEWART_NO_MAIN
 * there is stewart_selftest() alone.
 *
 * Written by stewart-sym @version@; do not edit.
 * SPDX-License-Identifier: 0BSD
 */
#include <float.h>
#include <stddef.h>
#include <string.h>
#if !defined(STEWART_NO_STDIO)
#include <stdio.h>
#endif

@includes@
@epsilon@
@models@
static const stewart_motion motions[@motion_count@] = {
@motions@
};

@pointers@
@calls@
@vectors@
@refusals@
/* One function and its calls: for each call which motion, the other inputs, the answers and their bounds in
 * rounding units. */
typedef struct {
    const char *name;
    int (*call)(const stewart_motion *motion, const stewart_real *in, stewart_real *out);
    int (*batch)(const stewart_motion *motion, const stewart_real *in, stewart_real *out); /* or NULL */
    int calls, inputs, answers, moved;
    const unsigned char *motion;
    const stewart_real *in, *answer, *bound;
    int prepared; /* whether it reads a model */
} function_test;

static const function_test tests[@function_count@] = {
@rows@
};

static stewart_real found[@most@];

int stewart_selftest(int *checks, stewart_real *worst);

/* Prints one line: how many of the checks were passed, and the worst error over its bound. */
static void said(const char *name, int good, int checks, stewart_real worst)
{
#if !defined(STEWART_NO_STDIO)
    (void)printf(
        "%-20s %3d of %3d right, worst error %.2g of its bound\\n", name, good, checks, (double)worst);
#else
    (void)name;
    (void)good;
    (void)checks;
    (void)worst;
#endif
}

static void blank(int count)
{
    int i;
    for (i = 0; i < count; ++i) {
        found[i] = REAL(12345);
    }
}

static int is_blank(int count)
{
    int i, same = 1;
    for (i = 0; i < count; ++i) {
        if (found[i] != REAL(12345)) {
            same = 0;
        }
    }
    return same;
}

/* Whether one call's answers are within their bounds; *worst: the largest error over its bound so far. */
static int is_right(
    const function_test *test, int (*function)(const stewart_motion *, const stewart_real *, stewart_real *),
    int call, stewart_real *worst)
{
    const stewart_real *const in = test->in ? test->in + call * test->inputs : NULL;
    const stewart_real *const answer = test->answer + call * test->answers;
    const stewart_real *const bound = test->bound + call * test->answers;
    int i, right;
    blank(test->answers);
    right = function(&motions[test->motion[call]], in, found) == STEWART_OK;
    for (i = 0; i < test->answers; ++i) {
        const stewart_real difference = found[i] - answer[i];
        const stewart_real error = difference < 0 ? -difference : difference;
        const stewart_real most = bound[i] * STEWART_EPSILON;
        if (!(error <= most)) {
            right = 0;
        }
        if (!(error <= *worst * most)) {
            *worst = error / most;
        }
    }
    return right;
}

/* NaN, infinity and minus infinity by number; stored, since registers may hold larger numbers. */
static stewart_real not_finite(int which)
{
    volatile stewart_real number = STEWART_MAX;
    number = number * 2;
    if (which == 0) {
        number = number - number;
    }
    return which == 2 ? -number : number;
}

/* Whether a call was rejected with its outputs as they were, or answered as `expected`, to the bit: then it
 * does not read what was spoilt. Bits, as a compiler told that all is finite takes NaN for equal. */
static int is_sound(int status, const stewart_real *expected, int count)
{
    return status != STEWART_OK ? is_blank(count)
                                : !memcmp(found, expected, (size_t)count * sizeof(stewart_real));
}

/* Whether no number of `count` in `numbers`, read by a call of the function, can be other than finite. */
static int needs_finite(
    const function_test *test, const stewart_motion *motion, const stewart_real *in, stewart_real *numbers,
    int count)
{
    static stewart_real expected[@most@];
    int i, which, sound;
    sound = test->call(motion, in, found) == STEWART_OK;
    (void)memcpy(expected, found, (size_t)test->answers * sizeof(stewart_real));
    for (i = 0; i < count; ++i) {
        const stewart_real good = numbers[i];
        for (which = 0; which < 3; ++which) {
            numbers[i] = not_finite(which);
            blank(test->answers);
            sound &= is_sound(test->call(motion, in, found), expected, test->answers);
            if (test->batch) {
                blank(test->answers);
                sound &= is_sound(test->batch(motion, in, found), expected, test->answers);
            }
        }
        numbers[i] = good;
    }
    return sound;
}

#define NUMBERS(type) ((int)(sizeof(type) / sizeof(stewart_real)))

/* The same of every number of motion, further inputs and, where a function reads it, robot. */
static int rejects_not_finite(const function_test *test)
{
    static union {
        stewart_motion motion;
        stewart_real numbers[NUMBERS(stewart_motion)];
    } at;
    static stewart_real in[@most_inputs@];
    int i, sound;
    at.motion = motions[test->motion[0]];
    for (i = 0; i < test->inputs; ++i) {
        in[i] = test->in[i];
    }
    sound = needs_finite(test, &at.motion, in, at.numbers, NUMBERS(stewart_motion));
    sound &= needs_finite(test, &at.motion, in, in, test->inputs);
@of_robot@    return sound;
}

/* The same of a motion that is not there. */
static int refuses_null(const function_test *test)
{
    blank(test->answers);
    return test->call(NULL, test->in, found) == STEWART_BAD_ARGUMENT && is_blank(test->answers);
}

/* The same of a model that nobody prepared. */
static int refuses_unprepared(const function_test *test)
{
    blank(test->answers);
    return test->call(&motions[test->motion[0]], test->in, found) != STEWART_OK && is_blank(test->answers);
}

@told@@prepared@/* Runs all checks. checks: how many there were, may be null; worst: largest error over its
 * bound, may be null. Returns how many failed, or -1 if the robot's constants could not be prepared. */
int stewart_selftest(int *checks, stewart_real *worst)
{
    stewart_real largest = 0;
    int all = 0, good = 0, test;
    int refused[@function_count@];
@unprepare@
    for (test = 0; test < @function_count@; ++test) {
        refused[test] = tests[test].prepared && refuses_unprepared(&tests[test]);
    }
@prepare@
    for (test = 0; test < @function_count@; ++test) {
        stewart_real of_function = 0;
        int call, right = refused[test];
        int count = tests[test].calls + 1 + tests[test].moved + tests[test].prepared;
        for (call = 0; call < tests[test].calls; ++call) {
            right += is_right(&tests[test], tests[test].call, call, &of_function);
            if (tests[test].batch) {
                right += is_right(&tests[test], tests[test].batch, call, &of_function);
            }
        }
        count += tests[test].batch ? tests[test].calls : 0;
@refused@        right += rejects_not_finite(&tests[test]);
        if (tests[test].moved) {
            right += refuses_null(&tests[test]);
        }
        said(tests[test].name, right, count, of_function);
        good += right;
        all += count;
        if (!(of_function <= largest)) {
            largest = of_function;
        }
    }
    if (checks) {
        *checks = all;
    }
    if (worst) {
        *worst = largest;
    }
    return all - good;
}

#if !defined(STEWART_NO_MAIN)
int main(void)
{
    int checks = 0;
    stewart_real worst = 0;
    const int failed = stewart_selftest(&checks, &worst);
    if (failed < 0) {
        return 1;
    }
    said("selftest", checks - failed, checks, worst);
    return failed ? 1 : 0;
}
#endif
"""
