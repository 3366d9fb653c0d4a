"""Tests of every formulation."""

import pytest

from stewart_sym.derive.mechanics.formulation import EXACT, EXACT_DRIVE, FORMULATIONS, Formulation


def of_each_formulation(*fast: Formulation) -> pytest.MarkDecorator:
    """Parameter form: all, some of them in the fast run."""
    slow = {form: () if form in fast else pytest.mark.slow for form in FORMULATIONS}
    forms = [pytest.param(form, id=form.kernel_name, marks=marks) for form, marks in slow.items()]
    return pytest.mark.parametrize("form", forms)


OF_EACH_FORMULATION = of_each_formulation(EXACT, EXACT_DRIVE)
"""The general one, without and with rotors, in the fast run."""
