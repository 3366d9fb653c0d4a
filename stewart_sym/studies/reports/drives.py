"""Motors along a trajectory for ``forces`` and ``plan``: columns, and a table with the limits."""

from typing import Any

import numpy as np

from ...drives.effort import PEAKS, Summary, trapezoids
from ...drives.limit_status import amount_text
from ...drives.motor_states import MotorStates
from ...drives.noise import MotorDeviations
from ...io.array_types import Array, Flags
from ...motion.sample_times import elapsed, least_step
from ...robot.robot import LEGS, Robot
from ..common.output import Columns, leg_table, of_legs

_COLUMNS = {"torque": "torque", "speed": "motor_speed", "current": "current", "power": "power"}
_HEADINGS = {"power": "shaft power"}


def drive_columns(part: MotorStates, sd: MotorDeviations | None = None) -> Columns:
    """Return the written columns by name (N m, rad/s, A, and W)."""
    found: Columns = {}
    for name, column in _COLUMNS.items():
        for ending, values in (("", getattr(part, name)), ("_std", getattr(sd, name, None))):
            if values is not None:
                found |= of_legs(column, values, ending)
    return found


class DriveDigest:
    """Peaks, root mean squares, and energies of the motors over a run, and the data of its plot."""

    def __init__(self, robot: Robot, time: Array, weights: Array | None = None) -> None:
        """Start a run of a robot with a drive at times (s) with weights in integrals (s), shape (n,)."""
        assert robot.drive is not None
        self.drive, self.time = robot.drive, time
        self._weights = trapezoids(elapsed(time)) if weights is None else weights
        self.summary = Summary(robot, least_step(time))
        self.torque, self.speed = np.full((2, len(time), LEGS), np.nan, dtype=np.float32)

    def add(
        self, part: MotorStates, where: slice, sd: MotorDeviations | None = None, there: Flags | None = None
    ) -> None:
        """Add the next samples; ``sd`` and ``there`` are the arguments of ``Summary.add``."""
        self.summary.add(part, self._weights[where], self.time[where], sd, there)
        self.torque[where], self.speed[where] = part.torque, part.speed

    @property
    def lasts(self) -> bool:
        """True if the run has a duration, which means and energies require."""
        return len(self.time) > 1 and bool(self.time[-1] > self.time[0])

    def table(self) -> str:
        """Format a line for each motor: peaks and root mean square with their limits, and energy."""
        found, drive = self.summary, self.drive
        columns = {}
        for name in self._known():
            limit, sd = getattr(drive, f"{name}_limit"), found.peak_sd.get(name)
            scale, unit = found.units.of_unit(PEAKS[name])
            cells = _cells(scale * found.peaks[name], scale * limit, None if sd is None else scale * sd)
            columns[f"{_HEADINGS.get(name, name)}, {unit}"] = cells
        means = {"RMS torque, N m": ["-"] * LEGS, "electrical energy, J": ["-"] * LEGS}
        if self.lasts:
            rms = _cells(found.rms_torque, drive.rated_torque, found.rms_torque_sd)
            energy = _cells(found.energy, np.full(LEGS, np.inf), found.energy_sd)
            means = dict(zip(means, (rms, energy), strict=True))
        return leg_table("motor", columns | means)

    def _known(self) -> list[str]:
        return [name for name in PEAKS if name != "current" or np.any(self.drive.torque_constant > 0.0)]

    def columns(self) -> dict[str, Any]:
        """Return the numbers for the JSON data, shape (6,) each; None if the run has no duration."""
        units = {"torque": "N_m", "speed": "rad_per_s", "current": "A", "power": "W"}
        summary, none = self.summary, [None] * LEGS
        found: dict[str, Any] = {}
        for name in self._known():
            found[f"motor_peak_{name}_{units[name]}"] = summary.peaks[name]
            found[f"motor_{name}_limit_{units[name]}"] = getattr(self.drive, f"{name}_limit")
        found["motor_rms_torque_N_m"] = summary.rms_torque if self.lasts else none
        found["motor_rated_torque_N_m"] = self.drive.rated_torque
        found["motor_energy_J"] = summary.energy if self.lasts else none
        if summary.noisy:
            found |= {f"motor_peak_{name}_std_{units[name]}": sd for name, sd in summary.peak_sd.items()}
            known = self.lasts and summary.rms_torque_sd is not None
            found["motor_rms_torque_std_N_m"] = summary.rms_torque_sd if known else none
            found["motor_energy_std_J"] = summary.energy_sd if self.lasts else none
        return found

    def verdicts(self) -> dict[str, Any]:
        """Return the status of each limit, shape (6,), for the JSON data."""
        found: dict[str, Any] = {f"motor_{name}_limit": self.summary.verdicts(name) for name in self._known()}
        rated = self.summary.verdicts("rated_torque") if self.lasts else [None] * LEGS
        return found | {"motor_rated_torque": rated}


def _cells(values: Array, limits: Array, sd: Array | None) -> list[str]:
    """Format the value of each motor with its standard deviation and its limit, if any."""
    return [
        amount_text(value, None if sd is None else sd[i], 4) + (f" of {most:g}" if np.isfinite(most) else "")
        for i, (value, most) in enumerate(zip(values, limits, strict=True))
    ]
