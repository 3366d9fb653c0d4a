"""The C of the forces with bounds, run with the worst rounding that its arithmetic may make.

Compiles the emitted C as C++ for numbers that write down every operation. Differentiating that record
backward gives the slope of a force along each result; then every operation is rounded by one whole unit, in
the direction in which its slope makes the force err most, and the bound that the same run finds is compared
with that error. Long double stands for real numbers; depends on the text of the C and on no equation.
"""

import ctypes
import functools
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stewart_sym.backend.c_kernel import c_sources
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

Array = NDArray[Any]
Real = np.longdouble

UNIT = {"double": 2.0**-53, "float": 2.0**-24}
"""Largest relative error of one operation."""

EVERY, NONE = -1, -2
"""In place of a group of operations: all of them round, or none does."""

_STATEMENT = re.compile(r"^( +)const stewart_real (\w+) =", re.M)
_ADDITION = re.compile(r"^( +)add\(&([^,]+), ", re.M)
_FUNCTION = re.compile(r"^(?:static )?(?:int|void|stewart_real) (\w+)\(", re.M)


def block_of(function: str) -> str:
    """Functions that round the same quantities share a name: leg_of_pose_x and leg_errors_x are ``leg_x``."""
    return function.replace("_of_pose", "").replace("_errors", "")


def marked(text: str) -> tuple[str, list[str]]:
    """The C with a mark before each statement that rounds, and the names of the groups of operations.

    A group is a quantity of a block, with what bounds its error; slopes are a group of their own.
    """
    groups: dict[str, int] = {}

    def at(name: str) -> str:
        return f"MARK({groups.setdefault(name, len(groups))});"

    def part(function: str, body: str) -> str:
        block = block_of(function)

        def statement(found: re.Match[str]) -> str:
            name = re.sub(r"_(err|own|max)$", "", found[2])
            group = "slopes" if "_bar" in name else f"{block} {name}"
            return f"{found[1]}{at(group)} const stewart_real {found[2]} ="

        if function.startswith(("prepare_", "shared_", "leg_")) and "{" in body:
            body = _STATEMENT.sub(statement, body)
        body = _ADDITION.sub(lambda m: f"{m[1]}{at(f'sum {m[2]}')} add(&{m[2]}, ", body)
        mark = {"solve_pose": "solution", "solution_error": "solution"}
        if function in mark:
            body = re.sub(
                r"\n(    for|    scale)", lambda m: f"\n    {at(mark[function])}\n{m[1]}", body, count=1
            )
        if function == "forces_of_pose":
            body = body.replace("        found[i] = D", f"        {at('force')} found[i] = D")
        if function == "bound_of_pose":
            body = re.sub(r"\n        (bound\[i\] = (?!0))", rf"\n        {at('force')} \1", body)
        return body

    return "".join(part(name, body) for name, body in _functions(text)), list(groups)


def _functions(text: str) -> list[tuple[str, str]]:
    """The text cut before each function, each part with that function's name."""
    starts = [(found.start(), found[1]) for found in _FUNCTION.finditer(text)]
    ends = [start for start, _ in starts[1:]] + [len(text)]
    parts = [(name, text[start:end]) for (start, name), end in zip(starts, ends, strict=True)]
    return [("", text[: starts[0][0]]), *parts]


@functools.cache
def _traced() -> tuple[ctypes.CDLL, list[str]]:
    sources = c_sources("exact_bounds")
    text, groups = marked(sources["stewart_exact_bounds.c"])
    text = text.replace("#define STEWART_UNIT (STEWART_EPSILON *", "#define STEWART_UNIT (epsilon_here() *")
    files = {**sources, "stewart_exact_bounds.c": text, "traced.h": _NUMBER, "traced.cpp": _RUN}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, content in files.items():
            (folder / file).write_text(content, encoding="utf-8")
        library = str(folder / "traced.so")
        command = ["g++", "-O1", "-w", "-shared", "-fPIC", "-o", library, str(folder / "traced.cpp")]
        subprocess.run(command, check=True, timeout=300)
        return ctypes.CDLL(library), groups


def groups() -> list[str]:
    """Names of the groups of operations, as ``Pose.of_group`` has them."""
    return _traced()[1]


class Pose:
    """One pose: the record of its operations, and what the worst rounding of all or of some makes of it.

    F: forces without rounding, N, (6,). first_order: (6,), N, what the slopes say that the worst rounding
    does to each; of_group: (6, groups), the same by groups. Raises ValueError for an unsolvable pose.
    """

    def __init__(self, robot: Robot, motion: Motion, unit: float) -> None:
        self._library, names = _traced()
        self._unit = unit
        self._numbers = robot_numbers(robot).astype(Real)
        at = [np.zeros(3) if getattr(motion, name) is None else getattr(motion, name) for name in MOTION]
        self._R = _rotation(at[0].astype(Real))
        self._rest = np.concatenate([np.ravel(values) for values in at[1:]]).astype(Real)
        self.F, first = np.zeros(6, Real), np.zeros(6, Real)
        self._slopes, shares = np.zeros((6, 3, 3), Real), np.zeros((6, len(names)), Real)
        self._library.set_unit(ctypes.c_double(unit))
        given = np.concatenate([self._R.ravel(), self._rest])
        arguments = map(_pointer, (self._numbers, given, self.F, first, self._slopes, shares))
        if self._library.record(ctypes.c_int(len(names)), *arguments):
            raise ValueError("motion: expected a pose that can be solved")
        of_R = [unit * _worst_strain(self._R, slope)[1] for slope in self._slopes]
        self.first_order = (first + of_R).astype(float)
        self.of_group = shares.astype(float)

    def worst(self, force: int, group: int = EVERY) -> tuple[float, float]:
        """Error and bound of one force, N, when all that rounds does so against it.

        group: only these operations round, and are counted, and R is a rotation. Runs on the record of the
        pose that was made last.
        """
        strain = _worst_strain(self._R, self._slopes[force])[0] if group == EVERY else np.zeros((3, 3))
        return self._perturbed(force, group, strain)

    def stretched(self, force: int, strain: Array) -> tuple[float, float]:
        """The same with no rounding, R stretched by the symmetric ``strain`` times the unit."""
        return self._perturbed(force, NONE, strain)

    def _perturbed(self, force: int, group: int, strain: Array) -> tuple[float, float]:
        R = self._R @ (np.eye(3, dtype=Real) + self._unit * strain.astype(Real))
        given, F, bound = np.concatenate([R.ravel(), self._rest]), np.zeros(6, Real), np.zeros(6, Real)
        chosen = map(ctypes.c_int, (force, group))
        if self._library.perturbed(*chosen, *map(_pointer, (self._numbers, given, F, bound))):
            raise ValueError("motion: expected a pose that can be solved however it is rounded")
        return float(abs(F[force] - self.F[force])), float(bound[force])


def _rotation(R: Array) -> Array:
    """The rotation nearest to R: R (3 - R^T R) / 2 squares the distance."""
    for _ in range(4):
        R = R @ (3 * np.eye(3, dtype=Real) - R.T @ R) / 2
    return R


def _worst_strain(R: Array, slope: Array) -> tuple[Array, float]:
    """The strain of R, 1 in the norm of largest singular values, that a force feels most, and how much."""
    along = (R.T @ slope).astype(float)
    values, vectors = np.linalg.eigh((along + along.T) / 2)
    return (vectors * np.sign(values)) @ vectors.T, float(np.abs(values).sum())


def _pointer(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


_NUMBER = """\
#include <cmath>
#include <cstddef>
#include <vector>

struct Operation {
    int left, right, group;
    long double by_left, by_right, value;
    bool exact;
};

enum { EVERY = -1, NONE = -2 };

static std::vector<Operation> tape;
static std::vector<signed char> against[6];
static int force = -1, group_here = 0, only = EVERY;
static long double unit;

static void MARK(int group) { group_here = group; }
static bool counted() { return only == EVERY || only == group_here; }

struct Number {
    long double value;
    int id;
    Number() : value(0), id(-1) {}
    Number(long double from) : value(from), id(-1) {}
};

static Number given(long double value)
{
    Number made(value);
    made.id = (int)tape.size();
    tape.push_back({-1, -1, -1, 0, 0, value, true});
    return made;
}

/* The result of an operation; rounded against the chosen force, if one is. */
static Number done(
    long double value, const Number &l, long double by_l, const Number &r, long double by_r, bool exact)
{
    Number made(value);
    if (l.id < 0 && r.id < 0) {
        return made;
    }
    made.id = (int)tape.size();
    if (force >= 0 && !exact && counted() && (size_t)made.id < against[force].size()) {
        made.value *= 1 + against[force][made.id] * unit;
    }
    tape.push_back({l.id, r.id, group_here, by_l, by_r, value, exact});
    return made;
}

static bool exact_factor(const Number &of)
{
    int exponent;
    return of.id < 0 && (of.value == 0 || fabsl(frexpl(of.value, &exponent)) == 0.5L);
}

static bool nothing(const Number &of) { return of.id < 0 && of.value == 0; }

static Number operator+(const Number &l, const Number &r)
{
    return done(l.value + r.value, l, 1, r, 1, nothing(l) || nothing(r));
}
static Number operator-(const Number &l, const Number &r)
{
    return done(l.value - r.value, l, 1, r, -1, nothing(l) || nothing(r));
}
static Number operator*(const Number &l, const Number &r)
{
    return done(l.value * r.value, l, r.value, r, l.value, exact_factor(l) || exact_factor(r));
}
static Number operator/(const Number &l, const Number &r)
{
    const long double value = l.value / r.value;
    return done(value, l, 1 / r.value, r, -value / r.value, exact_factor(r));
}
static Number operator-(const Number &of) { return done(-of.value, of, -1, Number(), 0, true); }
static Number root_of(const Number &of)
{
    const long double value = sqrtl(of.value);
    return done(value, of, 0.5L / value, Number(), 0, false);
}
/* One operation whatever the sign, so that every run of a pose counts alike. */
static Number magnitude(const Number &of)
{
    return done(fabsl(of.value), of, of.value < 0 ? -1 : 1, Number(), 0, true);
}
static bool operator>(const Number &l, const Number &r) { return l.value > r.value; }
static bool operator<(const Number &l, const Number &r) { return l.value < r.value; }
static bool operator>=(const Number &l, const Number &r) { return l.value >= r.value; }
static bool operator<=(const Number &l, const Number &r) { return l.value <= r.value; }
static bool operator==(const Number &l, const Number &r) { return l.value == r.value; }
static Number epsilon_here() { return Number(counted() ? 2 * unit : 0); }

#define STEWART_REAL Number
#define STEWART_SQRT(x) ::root_of(x)
#define STEWART_FABS(x) ::magnitude(x)
#define STEWART_EPSILON (Number(2 * unit))
#define STEWART_MAX (Number(1e300L))
"""

_RUN = """\
#include "traced.h"
/* Thousands of calls in a row: to optimize them takes longer than to run them. */
#pragma GCC push_options
#pragma GCC optimize("O0")
#include "stewart_exact_bounds.c"
#pragma GCC pop_options

static int run(const long double *numbers, const long double *motion, Number *F, Number *bound, Number *at_R)
{
    stewart_robot robot;
    stewart_motion at;
    stewart_exact_bounds_model model;
    Number *to = (Number *)&robot;
    size_t i;
    tape.clear();
    for (i = 0; i < sizeof robot / sizeof(Number); ++i) {
        to[i] = given(numbers[i]);
    }
    to = (Number *)&at;
    for (i = 0; i < sizeof at / sizeof(Number); ++i) {
        to[i] = given(motion[i]);
    }
    for (i = 0; i < 9 && at_R; ++i) {
        at_R[i] = at.R[i];
    }
    const int status = stewart_exact_bounds_prepare(&robot, &model);
    return status ? status : stewart_exact_forces_bounded(&model, &at, F, bound, NULL);
}

extern "C" void set_unit(double value) { unit = value; }

extern "C" int record(
    int groups, const long double *numbers, const long double *motion, long double *F,
    long double *first_order, long double *slopes_R, long double *shares)
{
    Number found[6], R[9];
    force = -1;
    const int status = run(numbers, motion, found, NULL, R);
    if (status) {
        return status;
    }
    std::vector<long double> slope(tape.size());
    for (int i = 0; i < 6; ++i) {
        F[i] = found[i].value;
        slope.assign(tape.size(), 0);
        against[i].assign(tape.size(), 0);
        slope[found[i].id] = 1;
        for (size_t n = tape.size(); n-- > 0;) {
            const Operation &op = tape[n];
            const long double along = slope[n], share = op.exact ? 0 : unit * fabsl(along * op.value);
            if (along == 0) {
                continue;
            }
            if (op.left >= 0) {
                slope[op.left] += along * op.by_left;
            }
            if (op.right >= 0) {
                slope[op.right] += along * op.by_right;
            }
            against[i][n] = (along > 0) == (op.value > 0) ? 1 : -1;
            first_order[i] += share;
            if (op.group >= 0) {
                shares[i * groups + op.group] += share;
            }
        }
        for (int j = 0; j < 9; ++j) {
            slopes_R[9 * i + j] = slope[R[j].id];
        }
    }
    return 0;
}

extern "C" int perturbed(
    int of, int group, const long double *numbers, const long double *motion, long double *F,
    long double *bound)
{
    Number found[6], limits[6];
    force = of;
    only = group;
    const int status = run(numbers, motion, found, limits, NULL);
    force = -1;
    only = EVERY;
    for (int i = 0; i < 6; ++i) {
        F[i] = found[i].value;
        bound[i] = limits[i].value;
    }
    return status;
}
"""
