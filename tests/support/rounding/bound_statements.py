"""The statements of the C that bounds rounding errors, each against the worst that its one step may do.

Every ``x_err``, ``x_own`` and ``x_max`` of the emitted text makes a claim about one assignment x = f(y, z,
...) alone: no rounding of its operations, whatever y and z err by within their own bounds, puts x farther
off. The claims are held to numbers over many sizes, so that each term is the largest somewhere. A mutant is
a statement with one term left out or one coefficient halved.
"""

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from bound_parts import in_python
from numpy.typing import NDArray

Array = NDArray[np.float64]
Names = dict[str, Any]

SAMPLES = 400
SLIGHT = 1e-6
NOISE = 1e-13
"""What double precision makes here of a bound, and of the sizes whose differences are compared with it."""

_DECLARED = re.compile(r"\n +const stewart_real ([^;]+);")
_FUNCTION = re.compile(r"^static (?:int|void|stewart_real) (\w+)\(", re.M)
_BLOCKS = ("prepare_", "shared_errors", "leg_errors")


@dataclass(frozen=True)
class Claim:
    """One statement and what it bounds: ``kind`` "err", "own" or "max" of the quantity ``name``."""

    function: str
    name: str
    kind: str
    text: str


@dataclass(frozen=True)
class Function:
    """The text of each name that a function assigns, and all its names."""

    name: str
    texts: Mapping[str, str]

    def claims(self) -> Iterator[Claim]:
        """Every bound whose quantity the function computes, or whose size it states."""
        for found, text in self.texts.items():
            stem, _, kind = found.rpartition("_")
            if kind in ("err", "own", "max") and "->" not in text and (stem in self.texts or kind == "max"):
                yield Claim(self.name, stem, kind, text)


def functions(c: str) -> list[Function]:
    """The functions of blocks that carry errors."""
    parts = re.split(_FUNCTION, c)[1:]
    pairs = zip(parts[::2], parts[1::2], strict=True)
    return [Function(name, _assigned(body)) for name, body in pairs if name.startswith(_BLOCKS)]


def _assigned(body: str) -> dict[str, str]:
    texts = {}
    for found in _DECLARED.finditer(re.sub(r"/\*.*?\*/", "", body, flags=re.S)):
        for part in split(" ".join(found[1].split()), ", "):
            name, _, text = part.partition(" = ")
            texts[name] = text
    return texts


def split(text: str, mark: str) -> list[str]:
    """The text split at a mark outside of brackets."""
    parts, depth, start = [], 0, 0
    for i, sign in enumerate(text):
        depth += (sign in "([") - (sign in ")]")
        if depth == 0 and text.startswith(mark, i):
            parts.append(text[start:i])
            start = i + len(mark)
    return [*parts, text[start:]]


# ---------------------------------------------------------------- the worst of one step


def python(text: str) -> str:
    """An expression of the C as one of Python."""
    for word, name in (("STEWART_FABS", "abs"), ("STEWART_SQRT", "sqrt"), ("STEWART_UNIT", "unit")):
        text = text.replace(word, name)
    return text.replace("STEWART_HALF", "0.5").replace("REAL", "")


def helpers(c: str, rng: np.random.Generator) -> Names:
    """least, root_error and reciprocal_error as the C defines them, and a rounding unit of each sample."""
    known: Names = {"sqrt": np.sqrt, "np": np, "abs": np.abs}
    known["unit"] = 10.0 ** rng.uniform(-9, -2, SAMPLES)
    for name in ("least", "root_error", "reciprocal_error"):
        exec(python(in_python(name, c)), known)
    return known


@dataclass(frozen=True)
class Worst:
    """Of one assignment, (samples,): the largest error with what goes in erring, and without, less noise."""

    err: Array
    own: Array


def worst(text: str, known: Names, errors: Mapping[str, Array]) -> Worst:
    """The assignment x = text at the values in ``known``, its inputs off by ``errors`` against x."""
    tree = ast.parse(python(text), mode="eval").body
    value, slopes, own, sizes = _differentiated(tree, known)
    moved = {**known, **{y: known[y] - np.sign(slopes[y]) * err for y, err in errors.items() if y in slopes}}
    far = {**known, **{y: known[y] + np.sign(slopes[y]) * err for y, err in errors.items() if y in slopes}}
    off = np.maximum(abs(_value(tree, moved) - value), abs(_value(tree, far) - value))
    own = known["unit"] * own
    return Worst(off + own - NOISE * sizes, own)


def _differentiated(tree: ast.expr, known: Names) -> tuple[Array, dict[str, Array], Array, Array]:
    """Value, slope along each name, and sums of sizes as they reach the value: of rounded results, of all."""
    slopes: dict[str, Array] = {}
    total = sizes = np.zeros(SAMPLES)

    def back(node: ast.expr, along: Array) -> None:
        nonlocal total, sizes
        sizes = sizes + abs(along * _value(node, known))
        if isinstance(node, ast.Name):
            slopes[node.id] = slopes.get(node.id, 0.0) + along
        elif isinstance(node, ast.UnaryOp):
            back(node.operand, -along)
        elif isinstance(node, ast.Call):
            root = _value(node, known)
            total = total + abs(along * root)
            back(node.args[0], along * 0.5 / root)
        elif isinstance(node, ast.BinOp):
            left, right = _value(node.left, known), _value(node.right, known)
            if not _exact(node):
                total = total + abs(along * _value(node, known))
            by = {
                ast.Add: (1.0, 1.0),
                ast.Sub: (1.0, -1.0),
                ast.Mult: (right, left),
                ast.Div: (1 / right, -left / right**2),
            }[type(node.op)]
            back(node.left, along * by[0])
            back(node.right, along * by[1])

    back(tree, np.ones(SAMPLES))
    return _value(tree, known), slopes, total, sizes


def _exact(node: ast.BinOp) -> bool:
    """Whether a product has a power of two in it."""
    sides = [side.operand if isinstance(side, ast.UnaryOp) else side for side in (node.left, node.right)]
    return isinstance(node.op, ast.Mult) and any(
        isinstance(side, ast.Constant) and np.frexp(side.value)[0] == 0.5 for side in sides
    )


def _value(node: ast.expr, known: Names) -> Array:
    return np.asarray(eval(compile(ast.Expression(node), "", "eval"), known), dtype=np.float64) + np.zeros(
        SAMPLES
    )  # type: ignore[no-any-return]


# ---------------------------------------------------------------- claims held to numbers


def sampled(function: Function, claim: Claim, rng: np.random.Generator, base: Names) -> tuple[Names, Array]:
    """Numbers for all that a claim reads, and what it must not be below.

    Sizes are spread over ten powers of ten each, errors from nothing to a tenth of their quantity.
    """
    value = function.texts.get(claim.name, "")
    words = set(re.findall(r"[A-Za-z_]\w*", f"{python(value)} {python(claim.text)}")) - set(base)
    stems = {re.sub(r"_(err|own|max)$", "", word) for word in words} - {"unit", "R"}
    known: Names = dict(base)
    inputs = sorted(set(re.findall(r"[A-Za-z_]\w*", python(value))) - set(base)) if value else []
    erring = [y for y in inputs if f"{y}_err" in function.texts or (y.startswith("R_") and len(y) == 4)]
    known["R_err"] = 10.0 ** rng.uniform(-6, -1, SAMPLES)
    for y in sorted(stems | set(inputs)):
        if y != claim.name or claim.kind == "max":
            known[y] = rng.choice([-1.0, 1.0], SAMPLES) * 10.0 ** rng.uniform(-5, 5, SAMPLES)
            shared = y.startswith("R_") and len(y) == 4
            known[f"{y}_err"] = abs(known[y]) * 10.0 ** rng.uniform(-6, -1, SAMPLES)
            size = abs(known[y])
            if shared:
                known[y] = known[y] + np.sign(known[y]) * 10 * known["R_err"]
                known[f"{y}_err"], size = known["R_err"], abs(known[y])
            exact = claim.kind != "max" and y not in erring
            known[f"{y}_max"] = size + (0 if exact else known[f"{y}_err"])
    errors = {y: known[f"{y}_err"] for y in erring}
    if claim.kind == "max":
        has = f"{claim.name}_err" in claim.text or "R_err" in claim.text
        error = known["R_err" if "R_err" in claim.text else f"{claim.name}_err"]
        return known, abs(known[claim.name]) + (error if has else 0)
    if "SQRT" in value:
        for y in inputs:
            known[y] = abs(known[y])
    at = worst(value, known, errors)
    known[claim.name] = _value(ast.parse(python(value), mode="eval").body, known)
    known[f"{claim.name}_own"] = at.own
    return known, at.own if claim.kind == "own" else at.err


def holds(text: str, known: Names, least: Array) -> bool:
    """Whether a bound, or a mutant of it, is below the worst nowhere."""
    return bool((_value(ast.parse(python(text), mode="eval").body, known) >= least * (1 - SLIGHT)).all())


# ---------------------------------------------------------------- mutants


def mutants(text: str) -> list[str]:
    """The expression with one term of one sum left out, or one whole coefficient halved, each in turn."""
    tree = ast.parse(python(text), mode="eval").body
    return ["0", *dict.fromkeys(map(ast.unparse, _varied(tree)))]


def _varied(node: ast.expr) -> Iterator[ast.expr]:
    if isinstance(node, ast.Call):
        for i, part in enumerate(node.args):
            none = [] if isinstance(part, ast.Name | ast.Constant) else [ast.Constant(0)]
            for new in (*_varied(part), *none):
                yield ast.Call(node.func, [*node.args[:i], new, *node.args[i + 1 :]], [])
    if not isinstance(node, ast.BinOp):
        return
    left, right = node.left, node.right
    if isinstance(node.op, ast.Add):
        yield left
        # Of a longer sum the terms before are left out one by one.
        if not isinstance(left, ast.BinOp) or not isinstance(left.op, ast.Add):
            yield right
    if isinstance(node.op, ast.Mult) and isinstance(left, ast.Constant) and isinstance(left.value, int):
        yield ast.BinOp(ast.Constant(left.value / 2), node.op, right)
    yield from (ast.BinOp(new, node.op, right) for new in _varied(left))
    yield from (ast.BinOp(left, node.op, new) for new in _varied(right))
