"""Formulas as MathML, which browsers draw themselves: docutils translates the LaTeX."""

import re

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx

_BOLD = {
    "alpha": "\N{MATHEMATICAL BOLD ITALIC SMALL ALPHA}",
    "gamma": "\N{MATHEMATICAL BOLD ITALIC SMALL GAMMA}",
    "phi": "\N{MATHEMATICAL BOLD ITALIC PHI SYMBOL}",
    "omega": "\N{MATHEMATICAL BOLD ITALIC SMALL OMEGA}",
    "tau": "\N{MATHEMATICAL BOLD ITALIC SMALL TAU}",
    "theta": "\N{MATHEMATICAL BOLD ITALIC SMALL THETA}",
    "xi": "\N{MATHEMATICAL BOLD ITALIC SMALL XI}",
    "zeta": "\N{MATHEMATICAL BOLD ITALIC SMALL ZETA}",
    "Gamma": "\N{MATHEMATICAL BOLD ITALIC CAPITAL GAMMA}",
}
"""Bold Greek letters as characters, by their names in LaTeX."""
_BOLD_LETTER = re.compile(
    rf"\\boldsymbol\s*(?:\\({'|'.join(_BOLD)})(?![a-zA-Z])|\{{\\({'|'.join(_BOLD)})\}})"
)
_SCRIPT_LETTER = re.compile(r"\\boldsymbol\{\\mathcal J\}")
_SHORT_FRACTION = re.compile(r"\\(t?frac)\s*(\w)\s*(\w)")

_ACCENT = re.compile(r"(\\(?:d?dot|hat)\s*(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\[a-zA-Z]+|\w))(?=[_^])")


def explicit(text: str) -> str:
    """Rewrite LaTeX that docutils misreads.

    A bold Greek letter takes everything after it, the numerator of ``\\frac12`` is 12, an index of an
    accented letter is drawn below the letter, and a norm with an exponent has signs of two heights.
    """
    text = _BOLD_LETTER.sub(lambda found: _BOLD[found[1] or found[2]], text)
    text = _SCRIPT_LETTER.sub("\N{MATHEMATICAL BOLD SCRIPT CAPITAL J}", text)
    text = re.sub(r"\\rVert(?=[_^])", r"\\rVert{}", text)
    text = _SHORT_FRACTION.sub(r"\\\1{\2}{\3}", text)
    # The empty group keeps docutils from removing the braces.
    return _ACCENT.sub(r"{{}\1}", text)


def _inline(self, node: nodes.math) -> None:
    self.body.append(tex2mathml(explicit(node.astext())))
    raise nodes.SkipNode


def _display(self, node: nodes.math_block) -> None:
    self.body.append(f'<div class="math">{tex2mathml(explicit(node.astext()), as_block=True)}</div>')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the renderer."""
    app.add_html_math_renderer("mathml", (_inline, None), (_display, None))
    return {"parallel_read_safe": True}
