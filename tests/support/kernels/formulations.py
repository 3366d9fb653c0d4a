"""Tests of every formulation: the general one, without and with rotors, in the fast run."""

import pytest

from stewart_sym.derive.mechanics.formulation import EXACT, EXACT_DRIVE, FORMULATIONS

OF_EACH_FORMULATION = pytest.mark.parametrize(
    "form",
    [
        pytest.param(
            form, id=form.kernel_name, marks=() if form in (EXACT, EXACT_DRIVE) else pytest.mark.slow
        )
        for form in FORMULATIONS
    ],
)
