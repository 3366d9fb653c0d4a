"""Products that feed a sum as fused multiply-adds: ``fma(a, b, c)`` is a b + c, rounded once or twice.

Rounded twice it is the sum as it stood, to the last bit: a sum does not depend on the order of its two terms.
"""

from dataclasses import replace
from typing import Any

from . import nodes as t


def fused(function: t.Function) -> t.Function:
    """The function with its products and sums fused; indices and counts stay as they are."""
    whole = {each.name for each in function.arguments if isinstance(each.type, t.Integer | t.Count)}
    whole |= {each.index for each in t.statements(function.body) if isinstance(each, t.For)}
    whole |= {
        each.name
        for each in t.statements(function.body)
        if isinstance(each, t.Let | t.Variable) and isinstance(each.type, t.Integer | t.Count)
    }
    return replace(function, body=_Fused(frozenset(whole)).node(function.body))


class _Fused:
    def __init__(self, whole: frozenset[str]) -> None:
        """whole: names of whole numbers."""
        self.whole = whole

    def node(self, node: Any) -> Any:
        """A statement, an expression or several, with their parts."""
        match node:
            case tuple():
                return tuple(map(self.node, node))
            case t.Element() | t.From() | t.As():
                return node
            case t.Let(type=t.Integer() | t.Count()):
                return replace(node, value=self.node(node.value)) if _has_call(node) else node
            case t.Binary("+" | "-" as operator, left, right) if self.is_real(node):
                return _sum(operator, self.node(left), self.node(right))
        return t.mapped(node, self.node) if isinstance(node, t.Node) else node

    def is_real(self, node: Any) -> bool:
        """Whether an expression is a number of the kernel's arithmetic."""
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


def _has_call(node: Any) -> bool:
    return any(True for _ in t.calls_in(node))


def _sum(operator: str, left: t.Expression, right: t.Expression) -> t.Expression:
    """left + right or left - right; the product that comes last is fused."""
    minus = operator == "-"
    if _is_product(right):
        assert isinstance(right, t.Binary)
        factor = _negated(right.left) if minus else right.left
        return t.Call("fma", (factor, right.right, left))
    if _is_product(left):
        assert isinstance(left, t.Binary)
        return t.Call("fma", (left.left, left.right, _negated(right) if minus else right))
    return t.Binary(operator, left, right)


def _is_product(node: t.Expression) -> bool:
    return isinstance(node, t.Binary) and node.operator == "*"


def _negated(value: t.Expression) -> t.Expression:
    """Exact: of a product the sign of its first factor, of a number its own."""
    match value:
        case t.Negative(inner):
            return inner
        case t.Binary("*" | "/" as operator, left, right):
            return t.Binary(operator, _negated(left), right)
        case t.Call("fma", (first, second, third)):
            return t.Call("fma", (_negated(first), second, _negated(third)))
    return t.Negative(value)
