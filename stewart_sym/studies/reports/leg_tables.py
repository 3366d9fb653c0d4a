"""Legs and motors along a motion: columns, data, and tables with their limits."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...drives import limits
from ...drives.limits import Limit, LimitTracker
from ...drives.motor_states import MotorStates
from ...drives.noise import Deviations
from ...io.array_types import Array
from ...robot.robot import LEGS
from ..common.text_tables import Columns, amounts, leg_table, of_legs

_COLUMNS = {"torque": "torque", "speed": "motor_speed", "current": "current", "power": "power"}
_LEGS = {
    limits.SHORTEST: ("min_length", "min_length_limit", "m"),
    limits.LONGEST: ("max_length", "max_length_limit", "m"),
    limits.SPEED: ("peak_speed", "speed_limit", "m_per_s"),
    limits.BASE: ("peak_base_angle", "base_angle_limit", "rad"),
    limits.PLATFORM: ("peak_platform_angle", "platform_angle_limit", "rad"),
}
_MOTORS = {
    limits.MOTOR_LIMITS["torque"]: ("motor_peak_torque", "motor_torque_limit", "N_m"),
    limits.MOTOR_LIMITS["speed"]: ("motor_peak_speed", "motor_speed_limit", "rad_per_s"),
    limits.MOTOR_LIMITS["current"]: ("motor_peak_current", "motor_current_limit", "A"),
    limits.MOTOR_LIMITS["power"]: ("motor_peak_power", "motor_power_limit", "W"),
    limits.RATED: ("motor_rms_torque", "motor_rated_torque", "N_m"),
}
"""Keys of the extreme value and of the status of each limit in the JSON data, and the unit in keys."""
_HEADINGS = {"power": "shaft power", "rms_torque": "RMS torque"}


def drive_columns(part: MotorStates, sd: Deviations | None) -> Columns:
    """Return the written columns by name (N m, rad/s, A, and W)."""
    found: Columns = {}
    for name, column in _COLUMNS.items():
        for ending, values in (("", getattr(part, name)), ("_std", (sd or {}).get(name))):
            if values is not None:
                found |= of_legs(column, values, ending)
    return found


def _motor_limits(tracker: LimitTracker) -> list[Limit]:
    """Return the limits of defined values: currents require a torque constant, means a duration."""
    assert tracker.robot.drive is not None
    is_defined = {"current": np.any(tracker.robot.drive.torque_constant > 0.0)}
    is_defined[limits.RATED.values] = tracker.weights.sum() > 0.0
    return [limit for limit in _MOTORS if is_defined.get(limit.values, True)]


def _extreme_data(tracker: LimitTracker, compared: Iterable[Limit]) -> dict[str, Any]:
    """Return value, standard deviation, limit, and status of each leg for the JSON data, (6,) each."""
    found: dict[str, Any] = {}
    for limit in compared:
        value, status, unit = (_LEGS | _MOTORS)[limit]
        peaks, sd = tracker.peaks(limit)
        found |= {f"{value}_{unit}": peaks, status: tracker.verdicts(limit)}
        found |= {} if sd is None else {f"{value}_std_{unit}": sd}
        found[f"{status}_{unit}"] = limit.sign * limit.bound(tracker.robot)
    return found


def leg_data(tracker: LimitTracker) -> dict[str, Any]:
    """Return extreme values, limits, and statuses of legs and motors for the JSON data, (6,) each."""
    time, F, _, F_sd = tracker.forces()
    peak, has_angles = largest(F), tracker.robot.has_joint_angle_limits
    found = {
        "peak_force_N": at_rows(F, peak),
        "peak_force_std_N": [None] * LEGS if F_sd is None else at_rows(F_sd, peak),
        "peak_force_time_s": time[peak],
        "force_limit_N": tracker.robot.force_limit,
        "force_limit": tracker.verdicts(limits.FORCE),
    }
    found |= _extreme_data(tracker, [*_LEGS][: 5 if has_angles else 3])
    return found if tracker.robot.drive is None else found | motor_data(tracker)


def motor_data(tracker: LimitTracker) -> dict[str, Any]:
    """Return extreme values, limits, statuses, and energies of the motors for the JSON data, (6,) each."""
    found = _extreme_data(tracker, _motor_limits(tracker)) | {"motor_energy_J": tracker.energy}
    return found | ({"motor_energy_std_J": tracker.energy_sd} if tracker.noisy else {})


def motor_table(tracker: LimitTracker) -> str:
    """Format a line for each motor: peaks and root mean square with their limits, and energy."""
    columns = {}
    for limit in _motor_limits(tracker):
        scale, unit = tracker.units.of_unit(limit.unit)
        cells = zip(extreme_texts(tracker, limit), scale * limit.bound(tracker.robot), strict=True)
        columns[f"{_HEADINGS.get(limit.values, limit.values)}, {unit}"] = [
            f"{text} of {bound:g}" if np.isfinite(bound) else text for text, bound in cells
        ]
    energy_sd = tracker.energy_sd if tracker.noisy else None
    return leg_table("motor", columns | {"electrical energy, J": amounts(tracker.energy, energy_sd, 4)})


def extreme_texts(tracker: LimitTracker, limit: Limit) -> list[str]:
    """Format the extreme value of each leg or motor in the units of the robot file."""
    peaks, sd = tracker.peaks(limit)
    scale, _ = tracker.units.of_unit(limit.unit)
    return amounts(scale * peaks, None if sd is None else scale * sd, 4)


def largest(values: Array) -> NDArray[np.int64]:
    """Return the indices, shape (...), of the largest magnitudes of values, shape (n, ...)."""
    return np.asarray(np.argmax(np.nan_to_num(np.abs(values), nan=-1.0), axis=0))


def at_rows(values: Array, rows: NDArray[np.int64]) -> Array:
    """Return the value of each leg, shape (6,), in its row of values, shape (n, 6)."""
    return np.asarray(values[rows, np.arange(LEGS)])
