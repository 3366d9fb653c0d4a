"""Times as text: those of different instants of a log differ, whenever it begins."""

import numpy as np
import pytest

from stewart_sym.io.instants import least_step, time_text


@pytest.mark.parametrize("start", [0.0, -2.0, 1e3, 1.7e9])
@pytest.mark.parametrize("step", [1e-5, 1e-3, 0.0125, 0.5, 30.0])
def test_different_instants_of_a_log_have_different_texts(start: float, step: float) -> None:
    times = start + step * np.arange(5000)
    texts = [time_text(time, least_step(times)) for time in times]
    assert len(set(texts)) == len(times)
    assert not any("e+" in text for text in texts)
    assert np.abs(np.array(texts, dtype=np.float64) - times).max() <= 0.5 * step


def test_no_digits_are_printed_that_are_rounding() -> None:
    times = 1_700_000_000.123 + 0.001 * np.arange(100)
    assert time_text(times[0], least_step(times)) == time_text(times[0]) == "1700000000.123"
    assert time_text(0.1 + 0.2, 0.1) == "0.3"
    assert time_text(0.0, 0.1) == time_text(0.0) == "0"
    assert least_step(times[:1]) == 0.0
