"""LaTeX that docutils misreads is rewritten before it becomes MathML."""

import importlib.util
import re

import pytest
from docutils.utils.math.latex2mathml import tex2mathml
from pages import DOCS

_SPEC = importlib.util.spec_from_file_location("mathml", DOCS / "extensions" / "mathml.py")
assert _SPEC is not None
assert _SPEC.loader is not None
mathml = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(mathml)


def drawn(text: str) -> str:
    """Return MathML of a formula without white space."""
    return re.sub(r"\s*\n\s*", "", tex2mathml(mathml.explicit(text)))


@pytest.mark.parametrize(
    ("formula", "part"),
    [
        (r"\boldsymbol\omega^2+x", "<msup><mi>𝝎</mi><mn>2</mn></msup><mo>+</mo>"),
        (r"\boldsymbol{\omega}\times q", "<mi>𝝎</mi><mo>"),
        (r"\tfrac12 x", "<mn>1</mn><mn>2</mn></mfrac><mi>x</mi>"),
        (r"\frac hL", "<mfrac><mi>h</mi><mi>L</mi></mfrac>"),
        (r"\lVert S\rVert^2", "<mi>S</mi><mo>‖</mo><msup><mrow></mrow>"),
        (r"\frac{a}{b}", "<mfrac><mi>a</mi><mi>b</mi></mfrac>"),
        (r"\dot{\mathbf M}_{\boldsymbol\xi}", "<msub><mrow><mrow></mrow><mover"),
        (r"\ddot\theta_1", "<msub><mrow><mrow></mrow><mover"),
        (r"\dot L_i^2", "<msubsup><mrow><mrow></mrow><mover"),
    ],
)
def test_a_formula_is_drawn_as_it_is_meant(formula: str, part: str) -> None:
    assert part in drawn(formula)


def test_nothing_else_is_rewritten() -> None:
    for text in (r"\frac{\partial\mathcal T}{\partial S}", r"\dot S\cdot s", r"\hat{\mathbf y}\times x"):
        assert mathml.explicit(text) == text
