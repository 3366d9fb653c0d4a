"""Times as text: those of different instants of a log differ, whenever it begins; even clocks."""

import numpy as np
import pytest

from stewart_sym.motion.even_clock import even_clock
from stewart_sym.motion.sample_times import least_step, time_text


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


@pytest.mark.parametrize("missing", [0, 7])
@pytest.mark.parametrize("start", [12.345, 1_763_876_184.5])
@pytest.mark.parametrize("rate", [59.94, 90.0, 480.0])
def test_the_even_clock_of_times_in_milliseconds_is_found(rate: float, start: float, missing: int) -> None:
    rows = np.sort(np.random.default_rng(0).choice(600, 600 - missing, replace=False))
    found = even_clock(np.round(start + rows / rate, 3))
    assert found.rounded == 1e-3
    assert found.step == pytest.approx(1.0 / rate, rel=2e-4)
    np.testing.assert_allclose(found.times - found.times[0], (rows - rows[0]) / rate, rtol=0.0, atol=2e-4)


@pytest.mark.parametrize("rows", range(20, 41))
def test_uneven_times_have_no_even_clock(rows: int) -> None:
    time = (np.arange(rows) + np.random.default_rng(rows).uniform(-0.2, 0.2, rows)) / 10.0
    assert even_clock(np.round(time - time[0], 5)) is None
