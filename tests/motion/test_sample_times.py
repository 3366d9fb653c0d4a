"""Times as text: those of different instants of a log differ, whenever it begins."""

import numpy as np
import pytest

from stewart_sym.motion.sample_times import elapsed, least_step, time_text


@pytest.mark.parametrize("start", [-2.0, 1.7e9])
@pytest.mark.parametrize("step", [1e-5, 0.0125, 30.0])
def test_different_instants_of_a_log_have_different_texts(start: float, step: float) -> None:
    times = start + step * np.arange(5000)
    least = least_step(times)
    texts = [time_text(time, least) for time in times]
    assert len(set(texts)) == len(times)
    assert not any("e+" in text for text in texts)
    assert np.abs(np.array(texts, dtype=np.float64) - times).max() <= 0.5 * step


def test_no_digits_are_printed_that_are_rounding() -> None:
    times = 1_700_000_000.123 + 0.001 * np.arange(100)
    assert time_text(times[0], least_step(times)) == time_text(times[0]) == "1700000000.123"
    assert time_text(0.1 + 0.2, 0.1) == "0.3"
    assert time_text(0.0, 0.1) == time_text(0.0) == "0"
    assert least_step(times[:1]) == 0.0


@pytest.mark.parametrize("start", [12.345, 1_763_876_184.5])
def test_steps_of_times_since_1970_are_exact(start: float) -> None:
    steps = np.diff(elapsed(np.round(start + 0.001 * np.arange(5000), 3)))
    np.testing.assert_allclose(steps, 0.001, rtol=1e-9)
