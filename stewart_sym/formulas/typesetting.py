"""Formulas with named steps as LaTeX; steps that are equal for all legs are written once."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy as sp

LEGS = range(1, 7)
_OF_LEG = re.compile(r"(.+)_([1-6])")
_NUMBERED = re.compile(r"([A-Za-z]+)(\d+)")

Expr = Any
Steps = Sequence[tuple[Any, Expr]]


def typeset(
    name: str,
    result: Any,
    steps: Steps,
    constants: Mapping[Any, float],
    meanings: Mapping[str, tuple[str, str]],
) -> str:
    """Write the steps as text, the matrix, the constants, and their meanings; requires ``amsmath``."""
    expressions = [expr for _, expr in steps] + list(result)
    write = _Writer(set().union(*(expr.free_symbols for expr in expressions), (s for s, _ in steps)))
    text = [f"${write(symbol)} = {write(expr)}$" for symbol, expr in _once(steps, write)]
    # Stretchable brackets would prevent line breaks in the text.
    text = [each.replace(r"\left(", "(").replace(r"\right)", ")") for each in text]
    shown = sp.Matrix(*result.shape, [write.summed(each) for each in result])
    return "\n".join(
        [
            r"{\raggedright\noindent For each leg $i = 1, \dots, 6$ where an index $i$ occurs:",
            ",\\quad\n".join(text) + r". \par}",
            rf"\[ {write(sp.Symbol(name))} = {write(shown)} \]",
            *_numbers(constants, write),
            *_meanings(meanings),
            "",
        ]
    )


class _Writer:
    """Converter of expressions to LaTeX, with leg symbols of leg i in sums over the legs."""

    def __init__(self, symbols: Iterable[Any]) -> None:
        self.known = {symbol.name for symbol in symbols}
        numbered = filter(None, map(_NUMBERED.fullmatch, self.known))
        # These letters of numbered steps would look like components of a vector.
        self.primed = {found[1] for found in numbered if f"{found[1]}_{found[2]}" in self.known}
        self.to_leg = {
            leg: {self.symbol(name, "i"): self.symbol(name, leg) for name in self.bases()} for leg in LEGS
        }
        self.of_leg = {leg: {b: a for a, b in pairs.items()} for leg, pairs in self.to_leg.items()}

    def bases(self) -> set[str]:
        """Return the names of leg quantities without the number of the leg."""
        return {found[1] for name in self.known if (found := _OF_LEG.fullmatch(name))}

    @staticmethod
    def symbol(name: str, leg: object) -> Any:
        return sp.Symbol(f"{name}_{leg}", real=True)

    def general(self, expr: Expr, leg: int) -> Expr:
        """Rewrite an expression of one leg for leg i."""
        return expr.xreplace(self.of_leg[leg])

    def summed(self, expr: Expr) -> Expr:
        """Rewrite an expression so that its sums over the legs are one sum."""
        rest = list(sp.Add.make_args(expr))
        sums = []
        for term in tuple(rest):
            general = self.general(term, 1)
            alike = [general.xreplace(self.to_leg[leg]) for leg in LEGS]
            if general != term and all(each in rest for each in alike):
                rest = [each for each in rest if each not in alike]
                sums.append(general)
        if not sums:
            return expr
        i = sp.Symbol("i")
        return sp.Add(*rest, sp.Sum(sp.Add(*sums), (i, 1, 6)), evaluate=False)

    def __call__(self, expr: Expr) -> str:
        expr = sp.sympify(expr)
        names = {symbol: self.name(symbol.name) for symbol in expr.free_symbols}
        text: str = sp.latex(expr, symbol_names=names, mat_delim="[")
        return text

    def name(self, name: str) -> str:
        """Return the LaTeX of a symbol; numbered steps get a prime if a vector has the same letter."""
        step = _NUMBERED.fullmatch(name)
        return f"{_word(step[1], 1)}'_{{{step[2]}}}" if step and step[1] in self.primed else _name(name)


def _once(steps: Steps, write: _Writer) -> list[tuple[Any, Expr]]:
    """Return the steps, with steps that all legs share written once for leg i."""
    given = dict(steps)
    found = []
    for symbol, expr in given.items():
        match = _OF_LEG.fullmatch(symbol.name)
        if match is None:
            found.append((symbol, write.summed(expr)))
            continue
        own = {leg: write.symbol(match[1], leg) for leg in LEGS}
        alike = {write.general(given[each], leg) if each in given else None for leg, each in own.items()}
        if len(alike) > 1:
            found.append((symbol, expr))
        elif symbol == own[1]:
            found.append((write.symbol(match[1], "i"), alike.pop()))
    return found


def _name(name: str) -> str:
    """Return the LaTeX of a symbol: the first word, upright if it has several letters, and an index."""
    first, *others = re.sub(rf"^{_NUMBERED.pattern}", r"\1_\2", name).split("_")
    letter = _word(first, 1)
    for rate in ("dot", "ddot"):
        if rate in others:
            others.remove(rate)
            letter = rf"\{rate}{{{letter}}}"
    index = ",".join(_word(each, 3) for each in others)
    return f"{letter}_{{{index}}}" if index else letter


def _word(word: str, longest: int) -> str:
    text: str = sp.latex(sp.Symbol(word)) if word.isalpha() else word
    return rf"\mathrm{{{word}}}" if len(word) > longest and not text.startswith("\\") else text


def _numbers(constants: Mapping[Any, float], write: _Writer) -> list[str]:
    """Return the table of constants, with a row per quantity and a column per leg."""
    legs: dict[str, dict[int, float]] = {}
    alone = []
    for symbol, value in constants.items():
        match = _OF_LEG.fullmatch(symbol.name)
        if match:
            legs.setdefault(match[1], {})[int(match[2])] = value
        else:
            alone.append(f"${write(symbol)} = {_number(value)}$")
    rows = [
        f"${_name(name)}$ & " + " & ".join(f"${_number(by[leg])}$" for leg in LEGS) + r" \\"
        for name, by in legs.items()
    ]
    table = [r"\par\noindent\begin{tabular}{l|rrrrrr}", r"$i$ & 1 & 2 & 3 & 4 & 5 & 6 \\ \hline", *rows]
    lines = [*table, r"\end{tabular}"] if rows else []
    return [*lines, r"\par\noindent " + ",\n".join(alone) + "."] if alone else lines


def _meanings(meanings: Mapping[str, tuple[str, str]]) -> list[str]:
    rows = [
        rf"${_name(name)}$ & {_unit(unit)} & {_prose(meaning)} \\"
        for name, (unit, meaning) in meanings.items()
    ]
    table = r"\par\noindent\begin{tabular}{l|l|p{0.7\linewidth}}"
    return [table, *rows, r"\end{tabular}"] if rows else []


def _unit(unit: str) -> str:
    return re.sub(r"\^(\d+)", r"$^{\1}$", unit).replace(" ", r"\,")


def _prose(text: str) -> str:
    """Convert names such as J_P_xx in a text to formulas."""
    named = re.sub(r"\b[A-Za-z]\w*_\w+", lambda found: f"${_name(found[0])}$", text)
    return re.sub(r"\^(\w+)", r"$^{\1}$", named).replace("_ ", r"\_ ")


def _number(value: float) -> str:
    text: str = sp.latex(sp.Float(value, 6))
    return text.rstrip("0").rstrip(".") if "." in text and "cdot" not in text else text
