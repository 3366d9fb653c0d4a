"""Glitches, frozen rows, gaps, and clocks: forces elsewhere do not change, and the deviations cover the errors."""

import numpy as np
import pytest
from machines import GRAVITY, home_position, machine_size, random_robot
from motion_fields import motion_of
from noisy_logs import Array, Case, coordinates, logged, read
from sweeps import share

import stewart_sym as ss
from stewart_sym.drives.limit_status import status_codes


def minute() -> Case:
    """Return a motion of one minute at 100 Hz."""
    rng, time = np.random.default_rng(3), np.arange(6000) / 100.0
    robot = random_robot(rng, scale=1.0)
    true = coordinates(rng, machine_size(robot), time, 0.3 * np.sqrt(GRAVITY / machine_size(robot)))
    true[0, :, :3] += home_position(robot.b, machine_size(robot))
    return Case(robot, time, true, ss.inverse_dynamics(robot, motion_of(true)).F)


@pytest.mark.slow
def test_a_glitch_of_any_size_changes_no_force_elsewhere() -> None:
    one = minute()
    values, rng = logged(one, "white", 0), np.random.default_rng(1)
    plain, _ = read(one.time, values)
    F, std = ss.inverse_dynamics(one.robot, plain.motion).F, ss.force_std(one.robot, plain)
    limits = np.abs(one.F).max(axis=0) * np.array([0.7, 0.95, 1.0, 1.02, 1.05, 1.3])
    before = status_codes(np.abs(F), limits, std)
    for _ in range(share(60)):
        first, count = int(rng.integers(0, 5995)), int(rng.integers(1, 6))
        columns = rng.choice(6, rng.integers(1, 3), replace=False)
        glitched = values.copy()
        glitched[first : first + count, columns] += 10.0 ** rng.uniform(-3.0, 0.0) * rng.choice([-1, 1])
        found, said = read(one.time, glitched)
        away = np.abs(one.time - one.time[first + count // 2]) > 0.1 + 0.005 * count
        F_now, std_now = ss.inverse_dynamics(one.robot, found.motion).F, ss.force_std(one.robot, found)
        assert np.all(np.abs(F_now - F)[away] < std[away]), (first, count)
        now = status_codes(np.abs(F_now), limits, std_now)
        assert not np.any(undecided(now[away]) & ~undecided(before[away])), (first, count)
        assert any("outliers" in text for text in said)


def undecided(codes: Array) -> Array:
    """Return True for codes of undecided limits."""
    return np.isin(codes, [1, 2])
