"""Two functions of the C that bounds rounding errors, each by itself with the worst rounding of its values.

``rotation_error`` bounds how far R is from a rotation, ``solution_error`` the error of a solution with
given errors of H and c. Every operation is rounded by one unit in the direction that makes the bound
smallest; the exact value, or that of the worst H and c within their errors, must not be above it. Finds
both functions in the text of the C.
"""

import ctypes
import functools
import re
from collections.abc import Iterator

import numpy as np
import worst_rounding as rounding
from numpy.typing import NDArray

from stewart_sym.backend.c_kernel import c_sources

Array = NDArray[np.float64]

UNIT = 2.0**-24
SLIGHT = 0.01
"""Share of the bound's own rounding that squares of it may take."""
NOISE = 1e-10
"""Relative error of the worst solution in double precision, and of squares of the unit."""
VALUES = 4
"""Statements of each function that round values."""


@functools.cache
def _library() -> ctypes.CDLL:
    text = c_sources("exact_bounds")["stewart_exact_bounds.c"]
    parts = []
    for name in ("rotation_error", "solution_error"):
        found = re.search(rf"^static \w+ {name}\(.*?^\}}", text, re.M | re.S)
        assert found
        parts.append(found[0])
    rotation = parts[0]
    for old, new in (
        ("high[i] = R[i] + shift - shift;", "high[i] = Number(rint(R[i].v * 4096) / 4096);"),
        ("low[i] = R[i] - high[i];", "low[i] = Number(R[i].v - high[i].v);"),
    ):
        assert old in rotation
        rotation = rotation.replace(old, new)
    # Products of high parts are exact, and so are their sums; what bounds an error has a margin of its own.
    values = r"(\n +(?:const stewart_real )?(?:product|sum|small|rest|total|lack|term) = [^;]+;)"
    rotation, count = re.subn(values, r"exact = 0; \1 exact = 1;", rotation)
    parts[1], more = re.subn(values, r"exact = 0; \1 exact = 1;", parts[1])
    high = re.search(r"exact = 0; (\n +total = [^;]+high[^;]+;)", rotation)
    assert high
    assert count == more == VALUES
    rotation = rotation.replace(high[0], high[1])
    sources = {"parts.cpp": _NUMBER + rotation + parts[1] + _RUN}
    return rounding.compiled(sources, "parts.cpp")


def holds() -> bool:
    """Whether the bounds are above the worst everywhere."""
    library = _library()
    for R in _rotations():
        exact = abs(R.reshape(3, 3).T @ R.reshape(3, 3) - np.eye(3))
        high = np.rint(R * 4096) / 4096
        low, high, R_ = ((each.reshape(3, 3)) for each in (R - high, high, R))
        sizes = abs(high.T) @ abs(low) + abs(low.T) @ abs(R_)
        least = np.append(exact.ravel(), exact.sum(axis=1).max() / 2)
        own = UNIT * np.append((sizes + exact).ravel(), (sizes + exact).sum(axis=1).max())
        found = np.zeros(10)
        library.rotation(_at(R), _at(found))
        if not (found >= least - SLIGHT * own).all():
            return False
    for H, H_err, c, c_err, c_own, x, Y in _systems():
        doubt = c_err + H_err @ abs(x)
        error, found = abs(Y) @ doubt, np.zeros(6)
        library.solution(*(_at(each) for each in (H, H_err, c, c_err, c_own, x, Y, error)), _at(found))
        least = np.array([_farthest(i, H, H_err, c, c_err + c_own, x, Y) for i in range(6)])
        if not (found >= least * (1 - NOISE)).all():
            return False
    return True


def _at(array: Array) -> ctypes.c_void_p:
    assert array.flags.c_contiguous
    assert array.dtype == np.float64
    return ctypes.c_void_p(array.ctypes.data)


def _rotations() -> Iterator[Array]:
    """Matrices of 24 bits near a rotation, none farther off than a hundredth."""
    rng = np.random.default_rng(31)
    for number in range(60):
        R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        if number % 3 == 0:
            R = R * (1 + 10 ** rng.uniform(-7, -2.5))
        elif number % 3 == 1:
            R = R @ (np.eye(3) + 10 ** rng.uniform(-7, -3) * rng.normal(size=(3, 3)))
        yield np.ascontiguousarray(np.rint(R.ravel() / UNIT) * UNIT)


def _systems() -> Iterator[tuple[Array, ...]]:
    """H, its errors, c, its errors and its own rounding, x, Y: single equations and some that are coupled."""
    rng = np.random.default_rng(32)
    zero = np.zeros(6)
    yield np.eye(6), np.zeros((6, 6)), zero, zero, zero, zero, np.eye(6)
    for k in range(1, 6):
        # Nothing errs but what is rounded, and Y lacks a coupling: one product in each sum, rounded most.
        H = np.eye(6)
        H[0, k] = H[k, 0] = -0.3
        yield H, np.zeros((6, 6)), np.ones(6), zero, zero, zero, np.eye(6)
        one = np.eye(6)[k]
        yield np.eye(6), np.zeros((6, 6)), one, zero, zero, one * (1 - 2.0**-20), np.eye(6)
    for number in range(12):
        yield _chain(rng.permutation(6), residual=bool(number % 2))
    for number in range(120):
        H = np.diag(rng.choice([-1.0, 1.0], 6) * 10 ** rng.uniform(-1, 1, 6))
        if number % 2:
            H = H + np.diag(abs(np.diag(H))) @ (rng.normal(size=(6, 6)) * (rng.random((6, 6)) < 0.15) * 0.2)
        of_size = abs(H) if number % 4 < 2 else np.abs(np.diag(H))[:, None] * (rng.random((6, 6)) < 0.3)
        H_err = of_size * 10 ** rng.uniform(-7 if number % 3 else -1.5, -1, (6, 1))
        Y = np.linalg.inv(H) * (1 + (0.1 if number % 5 else 0.0) * rng.uniform(-1, 1))
        c = rng.normal(size=6) * (rng.random(6) < 0.8)
        x = np.linalg.solve(H, c) * (1 + rng.choice([0, 1e-7, 1e-3], 6) * rng.normal(size=6))
        x = np.where(rng.random(6) < 0.2, 1.0, x)
        c_err, c_own = (10 ** rng.uniform(-4, -2, 6) * (rng.random(6) < 0.7) for _ in range(2))
        yield H, H_err, c, c_err, c_own, x, np.ascontiguousarray(Y)


def _chain(order: NDArray[np.int64], residual: bool) -> tuple[Array, ...]:
    """Equations of which each feeds the next, three times as large: products in Y H and in H x that cancel.

    Either 1 - Y H errs in each solution alike, along its own sign, so that the bound has nothing to spare; or
    Y is exact, and x leaves residuals that add up in the first solution.
    """
    H = (np.eye(6) + 3 * np.eye(6, k=1))[np.ix_(order, order)]
    right = 1.0 * (order == 5)
    x, Y, zero = np.linalg.solve(H, right), np.linalg.inv(H), np.zeros(6)
    if residual:
        first = Y[int(np.argmin(order))]
        x = x - Y @ (1e-5 * np.abs(x) * np.sign(first))
    else:
        x, Y = zero, (np.eye(6) - 1e-3 * np.outer(x, 1 / x)) @ Y
    return H, np.zeros((6, 6)), right, zero, zero, x, np.ascontiguousarray(Y)


def _farthest(i: int, H: Array, H_err: Array, c: Array, c_err: Array, x: Array, Y: Array) -> float:
    """How far a solution may be from x in one place, with H and c anywhere within their errors."""
    most = 0.0
    for sign in (-1.0, 1.0):
        found, side = x, sign * np.where(Y[i] < 0, -1.0, 1.0)
        for _ in range(4):
            moved = H - side[:, None] * np.where(found < 0, -1.0, 1.0) * H_err
            found = np.linalg.solve(moved, c + side * c_err)
            most = max(most, abs(found[i] - x[i]))
            side = sign * np.where(np.linalg.inv(moved)[i] < 0, -1.0, 1.0)
    return float(most)


_NUMBER = """\
#include <cmath>
#include <cstring>
static int exact = 1, made;
static double rounded[100000];
struct Number {
    double v;
    Number() = default;
    Number(double x) : v(x) {}
};
static Number made_of(double x)
{
    if (!exact) {
        x *= 1 + rounded[made++];
    }
    return Number(x);
}
static Number operator+(Number a, Number b) { return made_of(a.v + b.v); }
static Number operator-(Number a, Number b) { return made_of(a.v - b.v); }
static Number operator*(Number a, Number b) { return made_of(a.v * b.v); }
static Number operator/(Number a, Number b) { return made_of(a.v / b.v); }
static Number operator-(Number a) { return Number(-a.v); }
static bool operator<=(Number a, Number b) { return a.v <= b.v; }
static bool operator>=(Number a, Number b) { return a.v >= b.v; }
static bool operator>(Number a, Number b) { return a.v > b.v; }
static bool operator==(Number a, Number b) { return a.v == b.v; }
#define stewart_real Number
#define REAL(value) Number(value)
#define STEWART_FABS(value) Number(fabs((value).v))
#define STEWART_HALF Number(0.5)
#define STEWART_UNIT Number(5.9604644775390625e-08)
#define STEWART_EPSILON Number(1.1920928955078125e-07)
#define STEWART_MAX Number(1e300)
#define STEWART_SLACK Number(1)
#define STEWART_INFINITY Number(INFINITY)
struct platform_equations {
    Number c[6], c_err[6], c_own[6], H[6][6], H_err[6][6];
};
"""

_RUN = """
static void worst(void (*run)(double *), int count, double *least)
{
    double plain[10], moved[10];
    static double slope[10][100000];
    int i, k, operations;
    memset(rounded, 0, sizeof rounded);
    made = 0;
    run(plain);
    operations = made;
    for (k = 0; k < operations; ++k) {
        rounded[k] = 5.9604644775390625e-08;
        made = 0;
        run(moved);
        rounded[k] = 0;
        for (i = 0; i < count; ++i) {
            slope[i][k] = moved[i] - plain[i];
        }
    }
    for (i = 0; i < count; ++i) {
        for (k = 0; k < operations; ++k) {
            rounded[k] = slope[i][k] > 0 ? -5.9604644775390625e-08 : 5.9604644775390625e-08;
        }
        made = 0;
        run(moved);
        least[i] = moved[i];
    }
}

static Number R[9], x[6], Y[6][6], error[6];
static platform_equations of;

static void run_rotation(double *out)
{
    Number stretch[9];
    out[9] = rotation_error(R, stretch).v;
    for (int i = 0; i < 9; ++i) {
        out[i] = stretch[i].v;
    }
}

static void run_solution(double *out)
{
    Number sum[6];
    memcpy(sum, error, sizeof sum);
    solution_error(&of, x, Y, sum);
    for (int i = 0; i < 6; ++i) {
        out[i] = sum[i].v;
    }
}

extern "C" void rotation(const double *matrix, double *out)
{
    memcpy(R, matrix, sizeof R);
    worst(run_rotation, 10, out);
}

extern "C" void solution(
    const double *H, const double *H_err, const double *c, const double *c_err, const double *c_own,
    const double *at, const double *inverse, const double *first, double *out)
{
    memcpy(of.H, H, sizeof of.H);
    memcpy(of.H_err, H_err, sizeof of.H_err);
    memcpy(of.c, c, sizeof of.c);
    memcpy(of.c_err, c_err, sizeof of.c_err);
    memcpy(of.c_own, c_own, sizeof of.c_own);
    memcpy(x, at, sizeof x);
    memcpy(Y, inverse, sizeof Y);
    memcpy(error, first, sizeof error);
    worst(run_solution, 6, out);
}
"""
