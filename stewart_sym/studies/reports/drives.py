"""Motors along a motion for ``forces``, ``plan``, and ``simulate``: columns, and a table with the limits."""

from typing import Any

import numpy as np

from ...drives.limit_status import amount_text
from ...drives.limits import MOTOR_LIMITS, PEAKS, RATED, LimitTracker
from ...drives.motor_states import MotorStates
from ...drives.noise import Deviations
from ...io.array_types import Array
from ...robot.robot import LEGS
from ..common.text_tables import Columns, leg_table, of_legs

_COLUMNS = {"torque": "torque", "speed": "motor_speed", "current": "current", "power": "power"}
_HEADINGS = {"power": "shaft power"}
_UNITS = {"torque": "N_m", "speed": "rad_per_s", "current": "A", "power": "W"}


def drive_columns(part: MotorStates, sd: Deviations | None) -> Columns:
    """Return the written columns by name (N m, rad/s, A, and W)."""
    found: Columns = {}
    for name, column in _COLUMNS.items():
        for ending, values in (("", getattr(part, name)), ("_std", (sd or {}).get(name))):
            if values is not None:
                found |= of_legs(column, values, ending)
    return found


def _peaks(motors: LimitTracker) -> dict[str, tuple[Array, Array | None, Array]]:
    """Return peak, standard deviation, and limit of each quantity; currents need a torque constant."""
    assert motors.robot.drive is not None
    known = np.any(motors.robot.drive.torque_constant > 0.0)
    limits = {name: MOTOR_LIMITS[name] for name in PEAKS if known or name != "current"}
    return {name: (*motors.peaks(limit), limit.bound(motors.robot)) for name, limit in limits.items()}


def motor_table(motors: LimitTracker) -> str:
    """Format a line for each motor: peaks and root mean square with their limits, and energy."""
    columns = {}
    for name, parts in _peaks(motors).items():
        scale, unit = motors.units.of_unit(PEAKS[name])
        peaks, sd, limit = (None if part is None else scale * part for part in parts)
        columns[f"{_HEADINGS.get(name, name)}, {unit}"] = _cells(peaks, sd, limit)
    means = {"RMS torque, N m": ["-"] * LEGS, "electrical energy, J": ["-"] * LEGS}
    if motors.weights.sum() > 0.0:
        rms = _cells(motors.rms_torque, motors.rms_torque_sd, RATED.bound(motors.robot))
        energy = _cells(motors.energy, motors.energy_sd, np.full(LEGS, np.inf))
        means = dict(zip(means, (rms, energy), strict=True))
    return leg_table("motor", columns | means)


def motor_data(motors: LimitTracker) -> dict[str, Any]:
    """Return numbers and limit statuses for the JSON data, (6,) each; None if the run has no duration."""
    found: dict[str, Any] = {}
    for name, (peaks, sd, limit) in _peaks(motors).items():
        unit = _UNITS[name]
        found |= {f"motor_peak_{name}_{unit}": peaks, f"motor_{name}_limit_{unit}": limit}
        found |= {} if sd is None else {f"motor_peak_{name}_std_{unit}": sd}
        found[f"motor_{name}_limit"] = motors.verdicts(MOTOR_LIMITS[name])
    integrals: dict[str, Any] = {"rms_torque_N_m": motors.rms_torque, "energy_J": motors.energy}
    if motors.noisy:
        integrals |= {"rms_torque_std_N_m": motors.rms_torque_sd, "energy_std_J": motors.energy_sd}
    integrals["rated_torque"] = motors.verdicts(RATED)
    lasts = motors.weights.sum() > 0.0
    found |= {f"motor_{name}": values if lasts else [None] * LEGS for name, values in integrals.items()}
    return found | {"motor_rated_torque_N_m": RATED.bound(motors.robot)}


def _cells(values: Any, sd: Any, limits: Any) -> list[str]:
    """Format the value of each motor with its standard deviation and its limit, if any."""
    return [
        amount_text(value, None if sd is None else sd[i], 4) + (f" of {most:g}" if np.isfinite(most) else "")
        for i, (value, most) in enumerate(zip(values, limits, strict=True))
    ]
