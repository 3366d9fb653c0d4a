"""Fused multiply-adds: a product in a sum becomes ``fma(a, b, c)``, which is a b + c rounded once or twice.

Rounded twice, the result equals the original sum to the last bit, because a sum does not depend on the order
of its two terms. The sign of a subtracted product is applied to a factor that differs between lanes, because
processors have an instruction for it. Compilers would negate a constant of all lanes separately.
"""

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from . import nodes as t

_LANE = t.Name("l")


def fused(function: t.Function) -> t.Function:
    """Fuse the products and sums of a function; indices and counts do not change."""
    whole = {each.name for each in function.arguments if isinstance(each.type, t.Integer | t.Count)}
    whole |= {each.index for each in t.statements(function.body) if isinstance(each, t.For)}
    whole |= {
        each.name
        for each in t.statements(function.body)
        if isinstance(each, t.Let | t.Variable) and isinstance(each.type, t.Integer | t.Count)
    }
    return replace(function, body=_Fused(frozenset(whole), _of_all_lanes(function)).node(function.body))


def with_products_in_sums(body: Iterable[t.Statement]) -> tuple[t.Statement, ...]:
    """Fuse named products with the sums that read them; without fused multiply-add nothing is computed twice.

    Outside of lanes gcc 12 makes one instruction (``vfmaddsub``) of alternating sums and differences of
    products, even with ``-ffp-contract=off``. One pose would then differ from its batch in a bit.
    """
    steps = tuple(body)
    products = {
        each.name: each.value
        for each in steps
        if isinstance(each, t.Let) and isinstance(each.value, t.Binary) and _is_short_product(each.value)
    }
    found = tuple(_with_products(each, products) for each in steps)
    in_sums = [each.arguments[0] for each in t.calls_in(found) if each.function == "fma_of"]
    read = Counter(each.name for each in t.names_in(found))
    read.subtract(each.name for part in in_sums for each in t.names_in(part))
    kept: list[t.Statement] = []
    for each in found:
        kept.append(each)
        if isinstance(each, t.Let) and each.name in products and not read[each.name]:
            kept.append(t.Do(t.Call("(void)", (t.Name(each.name),))))
    return tuple(kept)


def _is_short_product(value: t.Binary) -> bool:
    """Return True for a product of two names; longer factors would be computed twice."""
    return value.operator == "*" and all(isinstance(each, t.Name) for each in (value.left, value.right))


def _with_products(node: Any, products: Mapping[str, t.Binary]) -> Any:
    """Fuse one named product of each sum in a node, the last one."""
    if isinstance(node, tuple):
        return tuple(_with_products(each, products) for each in node)
    if not isinstance(node, t.Node):
        return node
    changed = t.mapped(node, lambda part: _with_products(part, products))
    match changed:
        case t.Binary("+", left, t.Name(name)) if name in products:
            return t.Call("fma_of", (t.Name(name), products[name].left, products[name].right, left))
        case t.Binary("-", left, t.Name(name)) if name in products:
            factors = products[name]
            return t.Call("fma_of", (t.Negative(t.Name(name)), t.Negative(factors.left), factors.right, left))
        case t.Binary("+" | "-" as operator, t.Name(name), right) if name in products and not _is_product(
            right
        ):
            other = right if operator == "+" else _negated(right)
            return t.Call("fma_of", (t.Name(name), products[name].left, products[name].right, other))
    return changed


def _of_all_lanes(function: t.Function) -> frozenset[str]:
    """Return the names of values outside of the lanes, in a function that has lanes."""
    read = [each for each in t.statements(function.body) if isinstance(each, t.Let)]
    in_lanes = {each.name for each in read if isinstance(each.value, t.Element) and _LANE in each.value.index}
    others = {each.name for each in read if isinstance(each.value, t.Element | t.Member)} - in_lanes
    return frozenset(others if in_lanes else ())


class _Fused:
    def __init__(self, whole: frozenset[str], of_all_lanes: frozenset[str]) -> None:
        """Store the names of whole numbers (``whole``) and of values that are equal in all lanes."""
        self.whole, self.of_all_lanes = whole, of_all_lanes

    def node(self, node: Any) -> Any:
        """Convert a statement, an expression, or several, with their parts."""
        match node:
            case tuple():
                return tuple(map(self.node, node))
            case t.Element() | t.From() | t.As():
                return node
            case t.Let(type=t.Integer() | t.Count()):
                return replace(node, value=self.node(node.value)) if any(t.calls_in(node)) else node
            case t.Binary("+" | "-" as operator, left, right) if self.is_real(node):
                return self.sum(operator, self.node(left), self.node(right))
        return t.mapped(node, self.node) if isinstance(node, t.Node) else node

    def is_real(self, node: Any) -> bool:
        """Return True if an expression is a number of the kernel's arithmetic."""
        match node:
            case t.Element() | t.Member() | t.Call():
                return True
            case t.As() | t.Number(int()):
                return False
            case t.Name(name):
                return name not in self.whole
        return not isinstance(node, t.Node) or all(
            self.is_real(getattr(node, name)) for name in node.__dataclass_fields__
        )

    def sum(self, operator: str, left: t.Expression, right: t.Expression) -> t.Expression:
        """Return left + right or left - right with its last product fused."""
        minus = operator == "-"
        if _is_product(right):
            assert isinstance(right, t.Binary)
            factors = self.subtracted(right.left, right.right) if minus else (right.left, right.right)
            return t.Call("fma", (*factors, left))
        if _is_product(left):
            assert isinstance(left, t.Binary)
            return t.Call("fma", (left.left, left.right, _negated(right) if minus else right))
        return t.Binary(operator, left, right)

    def subtracted(self, first: t.Expression, second: t.Expression) -> tuple[t.Expression, t.Expression]:
        """Return two factors, one of which has the minus sign."""
        common = isinstance(first, t.Name) and first.name in self.of_all_lanes
        # A sign before a negative or a literal would be drawn in.
        takes_sign = not isinstance(second, t.Negative | t.Number)
        if self.of_all_lanes and (common or not isinstance(first, t.Name)) and takes_sign:
            return first, t.Negative(second)
        return _negated(first), second


def _is_product(node: t.Expression) -> bool:
    return isinstance(node, t.Binary) and node.operator == "*"


def _negated(value: t.Expression) -> t.Expression:
    """Negate exactly: the first factor of a product, or a number."""
    match value:
        case t.Negative(inner):
            return inner
        case t.Binary("*" | "/" as operator, left, right):
            return t.Binary(operator, _negated(left), right)
        case t.Call("fma", (first, second, third)):
            return t.Call("fma", (_negated(first), second, _negated(third)))
        case t.Call("fma_of", (product, first, second, third)):
            return t.Call("fma_of", (_negated(product), _negated(first), second, _negated(third)))
    return t.Negative(value)
