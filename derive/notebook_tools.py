"""Typesetting and algebra of the derivation notebooks.

The notebooks show named steps of the derivation as equations, tables, and figures, and check them with SymPy.
"""

import io
import re
from dataclasses import dataclass
from typing import Any

import sympy as sp
from IPython.display import Image, Latex, Markdown, display

from .mechanics.formulation import Formulation
from .mechanics.legs import leg
from .program.block import Builder, Quantity, Step

GREEK = ("alpha", "gamma", "kappa", "omega", "phi", "rho", "sigma", "tau", "theta", "zeta")

LETTERS = {
    "R": (r"\mathfrak{R}", ""),
    "S_dot": (r"\dot S", ""),
    "S_ddot": (r"\ddot S", ""),
    "L_dot": (r"\dot L", ""),
    "L_ddot": (r"\ddot L", ""),
    "y": (r"\hat y", ""),
    "z": (r"\hat z", ""),
    "bearing": ("r", ""),
    "k_cross_s": (r"(k\times s)", ""),
    "w_q": (r"(\omega\times q)", ""),
    "u_square": (r"|u_\perp|^2", ""),
    "A_y_own": ("A", r"y,\mathrm{own}"),
    "A_z_own": ("A", r"z,\mathrm{own}"),
    "s_cross_normal": (r"(s\times(k\times s))", ""),
    "k_cross_S": (r"(k\times S)", ""),
    "rho2": (r"\rho^2", ""),
    "theta_dot": (r"\dot\theta", ""),
    "phi_dot": (r"\dot\phi", ""),
    "M_mixed": ("M", r"\theta\phi"),
    "M_phi_L": ("M", r"\phi,L"),
    "M_phi_theta": ("M", r"\phi,\theta"),
    "M_mixed_theta": ("M", r"\theta\phi,\theta"),
    "h_base": ("h", "P"),
    "J_base": ("J", "P"),
    "w_y_omega": (r"\omega", "y"),
    "w_k_omega": (r"\omega", "k"),
    "inv_L2": (r"L^{-2}", ""),
    "turning": (r"|\dot s|^2", ""),
}
"""Letter and subscript of the names that do not split at their first underscore."""


def name_tex(name: str, bold: bool = False) -> str:
    """Return LaTeX of a symbol's name: r_d0_x is r_{d0,x}, K_x_1 is K_{1,x}; ``bold`` for whole vectors."""
    match = re.fullmatch(r"(.+?)_([xyz]{1,2})(?:_([1-6]))?", name)
    base, axes, number = match.groups() if match else (name, None, None)
    letter, _, below = base.partition("_")
    if re.fullmatch(r"[kc]\d+", base):
        letter, below = base[0], base[1:]
    letter, below = LETTERS.get(base, ("\\" + letter if letter in GREEK else letter, below))
    below = r"\perp" if below == "across" else below.replace("s_", r"s\times ")
    below = "\\" + below if below in GREEK else below
    if len(below) > 1 and below.isalpha():
        below = rf"\mathrm{{{below}}}"
    if bold and base != "R":
        letter = rf"\boldsymbol{{{letter}}}" if letter.startswith("\\") else rf"\mathbf{{{letter}}}"
    subscript = ",".join(part for part in (below, number, axes) if part)
    return f"{letter}_{{{subscript}}}" if subscript else letter


def tex(expr: sp.Expr) -> str:
    """Return LaTeX of an expression, with 1/L, 1/k3, and 1/rho as fractions."""
    expr = sp.sympify(expr).subs(
        {sp.Symbol(f"inv_{name}", real=True): 1 / sp.Symbol(name, real=True) for name in ("L", "k3", "rho")}
    )
    return str(sp.latex(expr, symbol_names={symbol: name_tex(symbol.name) for symbol in expr.free_symbols}))


def rows_tex(expr: sp.Expr, width: int) -> list[str]:
    """Return LaTeX of an expression; a long sum is broken into rows between its terms."""
    rows, used = [""], 0
    for term in sp.sympify(expr).as_ordered_terms():
        text = tex(term)
        text = text if text.startswith("-") or not any(rows) else "+" + text
        length = len(re.sub(r"\\(left|right|mathrm|frac|dot|ddot|times)|[\\{}_^ ,]", "", text))
        if used and used + length > width:
            rows, used = [*rows, ""], 0
        rows[-1] += text
        used += length
    return rows


def show(*equations: Step | tuple[str, sp.Expr, str], width: int = 62) -> None:
    """Typeset steps, or (left side in LaTeX, right side, equation number), one below the other."""
    lines = []
    for equation in equations:
        if isinstance(equation, Step):
            if equation.name.startswith("inv_"):
                continue
            equation = name_tex(equation.name), equation.expr, equation.equation
        left, right, number = equation
        first, *others = rows_tex(right, width)
        lines.append(rf"{left} &= {first} && {number}")
        lines += [rf"&\qquad {row} &&" for row in others]
    display(Latex("$$\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}$$"))


def show_matrix(left: str, matrix: sp.Matrix) -> None:
    """Typeset a matrix with its left side in LaTeX."""
    display(Latex(rf"$${left} = {tex(matrix)}$$"))


def table(head: list[str], body: list[list[str]], numbers: bool = True) -> None:
    """Typeset a table; with ``numbers``, all columns except the first are aligned right."""
    lines = [head, ["---", *["---:" if numbers else "---"] * (len(head) - 1)], *body]
    display(Markdown("\n".join("| " + " | ".join(line) + " |" for line in lines)))


def show_figure(figure: Any, alt: str) -> None:
    """Display a Matplotlib figure as a picture with a text for readers who do not see it."""
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=110, metadata={"Software": None})
    display(Image(picture.getvalue(), alt=alt))


def c_statement(source: str, name: str) -> str:
    """Return the statement that assigns ``name`` in C, as code in Markdown; "" if there is none."""
    pattern = rf"^ +(?:const stewart_real |out->)({re.escape(name)} = .*?;)$"
    found = re.search(pattern, source, re.MULTILINE | re.DOTALL)
    return f"`{' '.join(found[1].split())}`" if found else ""


def unfold(expr: Any, steps: list[Step]) -> Any:
    """Replace the names of steps in an expression or matrix by their expressions."""
    for step in reversed(steps):
        expr = expr.xreplace({step.symbol: step.expr})
    return expr


def vanishes(expr: sp.Expr | sp.Matrix) -> bool:
    """Return True if SymPy simplifies every component to zero."""
    entries = expr if isinstance(expr, sp.MatrixBase) else [expr]
    return all(sp.simplify(sp.expand(entry)) == 0 for entry in entries)


def rate(expr: Any, rates: dict[sp.Symbol, sp.Expr]) -> Any:
    """Return the time derivative by the chain rule; symbols without a rate are constants."""
    return sum((expr.diff(symbol) * change for symbol, change in rates.items()), 0 * expr)


def vector(name: str) -> sp.Matrix:
    """Return a vector of three new components."""
    return Quantity(name, (3,), "", "").value


def rates_of(vectors: dict[str, sp.Matrix]) -> dict[sp.Symbol, sp.Expr]:
    """Return the rates of components from the rates of whole vectors."""
    pairs = ((vector(name), change) for name, change in vectors.items())
    return {symbol: by for of, change in pairs for symbol, by in zip(of, change, strict=True)}


def of_leg(name: str, i: int) -> sp.Matrix:
    """Return the vector ``name`` of leg i, 1 to 6."""
    return sp.Matrix([sp.Symbol(f"{name}_{axis}_{i}", real=True) for axis in "xyz"])


@dataclass(frozen=True)
class OneLeg:
    """Symbols of one leg: its vector, its frame, and the motion of its platform point in this frame.

    ``u`` and ``e`` are velocity and acceleration of the platform point, ``gamma`` is gravity, and ``w`` is
    the angular velocity of the platform, all in the leg frame.
    """

    L: Any
    inv_L: Any
    s: Any
    k: Any
    inv_k3: Any
    kappa: Any
    u: Any
    e: Any
    gamma: Any
    w: Any

    @property
    def motion(self) -> leg.LegFrameMotion:
        """Motion of the leg for the functions of the derivation."""
        return leg.LegFrameMotion(
            self.L, self.inv_L, self.k, self.inv_k3, self.kappa, self.u, self.e, self.gamma, self.w
        )

    def turn(self, form: Formulation) -> tuple[list[Step], list[sp.Matrix]]:
        """Return the steps of ``rotation``, and L_dot, W, L_ddot, A by u, e, L, 1/L, and kappa."""
        build = Builder()
        results = leg.rotation(build, form, self.motion)
        values = (sp.Matrix([value]) for value in results)
        return build.steps, [unfold(value, build.steps).subs(self.inv_L, 1 / self.L) for value in values]


def one_leg() -> OneLeg:
    """Return the symbols of one leg, as sections 1.1 to 1.4 of the first notebook define them."""
    _, _, L, inv_L, s = leg.leg_vector(Builder())
    _, k, inv_k3, kappa = leg.leg_frame(Builder(), s)
    u, e, gamma, w = (vector(name) for name in ("u", "e", "gamma", "w"))
    return OneLeg(L, inv_L, s, k, inv_k3, kappa, u, e, gamma, w)


def quantity_tables(groups: dict[str, tuple[Quantity, ...]]) -> None:
    """Typeset quantities with symbol, name in the code, kind, unit, and meaning, by groups."""
    kinds = {(): "number", (3,): "vector", (3, 3): "matrix"}
    for title, group in groups.items():
        display(Markdown(f"**{title}**"))
        rows = [
            [
                f"${name_tex(q.name, bold=bool(q.shape))}$",
                f"`{q.name}`",
                kinds[q.shape],
                q.unit,
                q.meaning.replace("|", r"\|"),
            ]
            for q in group
        ]
        table(["symbol", "name in the code", "kind", "unit", "meaning"], rows, numbers=False)
