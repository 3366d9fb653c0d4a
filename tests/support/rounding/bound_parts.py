"""Two functions of the C that bounds rounding errors, each by itself with the worst rounding of its values.

``rotation_error`` bounds how far R is from a rotation, ``solution_error`` the error of a solution with
given errors of H and c. Every operation is rounded by one unit in the direction that makes the bound
smallest; the exact value, or that of the worst H and c within their errors, must not be above it. Runs the
text of the C, read as Python, for all cases at once.
"""

import ast
import re
from collections.abc import Callable, Iterable, Iterator
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stewart_sym.backend.c_kernel import c_sources

Array = NDArray[np.float64]

UNIT = 2.0**-24
SLIGHT = 0.01
"""Share of the bound's own rounding that squares of it may take."""
NOISE = 1e-10
"""Relative error of the worst solution in double precision, and of squares of the unit."""

_ROUNDED = ("product", "sum", "small", "rest", "total", "lack", "term")
"""Values of both functions; what bounds an error has a margin of its own."""
_KNOWN = {
    "STEWART_FABS": np.abs,
    "STEWART_HALF": 0.5,
    "STEWART_UNIT": UNIT,
    "STEWART_EPSILON": 2 * UNIT,
    "STEWART_MAX": 1e300,
    "STEWART_SLACK": 1.0,
    "STEWART_INFINITY": np.inf,
    "REAL": float,
    "np": np,
}
_IN_PYTHON = (
    (r"^static \w+ (\w+)\((.*?)\)\n\{", lambda m: f"def {m[1]}({_names(m[2])}):"),
    (r"^ +/\*.*\*/$|^ +int .*;$|^ *\}$", ""),
    (r"for \((\w) = (\d+); \w < (\d+); (?:\+\+\w|\w \+= (\d))\) \{",
     lambda m: f"for {m[1]} in range({m[2]}, {m[3]}, {m[4] or 1}):"),
    (r"if \(!\((.*)\)\) \{\n +(\w+\[i\]) = (\w+);", r"\2 = np.where(\1, \2, \3)"),
    (r"if \(!\((.*)\)\) \{", r"if not (\1):"),
    (r"stewart_real (\w+)\[6\]\[6\];", r"\1 = [[None for _ in range(6)] for _ in range(6)]"),
    (r"stewart_real (\w+)\[(\d)\];", r"\1 = [None for _ in range(\2)]"),
    (r"(?:const )?stewart_real (\w+ =)", r"\1"),
    (r"(= |return )([^?;]*) \? (.*) : (.*);", r"\1np.where(\2, \3, \4)"),
    (r"(high\[i\]) = R\[i\] \+ shift - shift;", r"\1 = np.rint(R[i] * 4096) / 4096"),
    (r"->", "."),
    (r";$", ""),
)  # fmt: skip


def _names(parameters: str) -> str:
    return ", ".join(re.findall(r"(\w+)(?:\[\d\])*(?:,|$)", parameters))


class _Rounding(ast.NodeTransformer):
    """Hands every operation to ``rounded``."""

    def visit_Subscript(self, node: ast.Subscript) -> ast.Subscript:
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.Call:
        self.generic_visit(node)
        return ast.Call(ast.Name("rounded", ast.Load()), [node], [])


def _rounds(node: ast.Assign) -> bool:
    """Whether an operation gives a value; products of high parts are exact, and so are their sums."""
    operations = any(isinstance(each, ast.BinOp) for each in ast.walk(node.value))
    exact = ast.unparse(node.value).count("high") == 2
    return operations and not exact and ast.unparse(node.targets[0]) in _ROUNDED


def in_python(name: str, text: str) -> str:
    """A function of the C as one of Python, whose choices are made value by value."""
    found = re.search(rf"^static \w+ {name}\(.*?^\}}", text, re.M | re.S)
    assert found
    body = found[0]
    for old, new in _IN_PYTHON:
        body = re.sub(old, new, body, flags=re.M | (re.S if old.startswith("^static") else 0))
    return body


def _function(name: str, statements: int) -> Callable[..., Any]:
    """A function of the C, whose operations that round take their errors from the first argument."""
    tree = ast.parse(in_python(name, c_sources("exact_bounds")["stewart_exact_bounds.c"]))
    rounding = [each for each in ast.walk(tree) if isinstance(each, ast.Assign) and _rounds(each)]
    assert len(rounding) == statements
    for each in rounding:
        each.value = _Rounding().visit(each.value)
    code = compile(ast.fix_missing_locations(tree), name, "exec")

    def run(errors: Iterable[Array], *given: Any) -> Any:
        each = iter(errors)
        known = {**_KNOWN, "rounded": lambda value: value * (1 + next(each))}
        exec(code, known)
        return known[name](*given)

    return run


def _smallest(run: Callable[[Iterable[Array]], Array]) -> Array:
    """The least that outputs, (count, cases), may come out as; ``run`` adds a last axis of ways to round."""
    operations = 0

    def exactly() -> Iterator[Array]:
        nonlocal operations
        while True:
            operations += 1
            yield np.zeros(1)

    plain = run(exactly())
    # Where there is no bound, no rounding makes one.
    with np.errstate(invalid="ignore"):
        slopes = run(UNIT * np.eye(operations)) - plain
    against = np.where(slopes > 0, -UNIT, UNIT).transpose(2, 1, 0)
    return np.einsum("ncn->nc", run(against))


def holds() -> bool:
    """Whether the bounds are above the worst everywhere."""
    return _rotations_hold() and _solutions_hold()


def _rotations_hold() -> bool:
    function, all_R = _function("rotation_error", statements=3), np.array([*_rotations()])

    def run(errors: Iterable[Array]) -> Array:
        stretch = 9 * [None]
        worst = function(errors, all_R.T[..., None], stretch)
        return np.stack([*stretch, worst])

    R = all_R.reshape(-1, 3, 3)
    high, exact = np.rint(R * 4096) / 4096, abs(_transposed(R) @ R - np.eye(3))
    low = R - high
    sizes = exact + abs(_transposed(high)) @ abs(low) + abs(_transposed(low)) @ abs(R)
    least, own = (
        np.column_stack([each.reshape(-1, 9), share * each.sum(axis=-1).max(axis=-1)])
        for each, share in ((exact, 0.5), (sizes, 1.0))
    )
    return bool((_smallest(run).T >= least - SLIGHT * UNIT * own).all())


def _solutions_hold() -> bool:
    function, systems = _function("solution_error", statements=4), [*_systems()]
    H, H_err, c, c_err, c_own, x, Y = (np.array(each) for each in zip(*systems, strict=True))
    doubt = c_err + np.einsum("nij,nj->ni", H_err, abs(x))
    first = np.einsum("nij,nj->ni", abs(Y), doubt)

    def run(errors: Iterable[Array]) -> Array:
        of = {"H": H, "H_err": H_err, "c": c, "c_err": c_err, "c_own": c_own}
        error = [*_by_entry(first)]
        equations = SimpleNamespace(**{name: _by_entry(each) for name, each in of.items()})
        function(errors, equations, _by_entry(x), _by_entry(Y), error)
        return np.stack(error)

    least = [_farthest(i, H, H_err, c, c_err + c_own, x, Y) for i in range(6)]
    return bool((_smallest(run) >= np.array(least) * (1 - NOISE)).all())


def _transposed(matrices: Array) -> Array:
    return np.swapaxes(matrices, -1, -2)


def _by_entry(array: Array) -> Array:
    """Of arrays (cases, ...): (..., cases, 1)."""
    return np.moveaxis(array, 0, -1)[..., None]


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


def _farthest(i: int, H: Array, H_err: Array, c: Array, c_err: Array, x: Array, Y: Array) -> Array:
    """How far solutions, (cases,), may be from x in one place, with H and c anywhere within their errors."""
    most = np.zeros(len(H))
    for sign in (-1.0, 1.0):
        found, side = x, sign * np.where(Y[:, i] < 0, -1.0, 1.0)
        for _ in range(4):
            moved = H - side[:, :, None] * np.where(found < 0, -1.0, 1.0)[:, None] * H_err
            found = np.linalg.solve(moved, (c + side * c_err)[..., None])[..., 0]
            most = np.maximum(most, abs(found[:, i] - x[:, i]))
            side = sign * np.where(np.linalg.inv(moved)[:, i] < 0, -1.0, 1.0)
    return most
