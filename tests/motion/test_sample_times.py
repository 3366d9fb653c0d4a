"""Times as text: those of different instants of a log differ, whenever it begins."""

import numpy as np
import pytest

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
