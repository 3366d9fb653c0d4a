"""Motors along a trajectory for ``forces`` and ``plan``: columns, a table with the limits, and a plot."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...drives.effort import PEAKS, Summary, trapezoids
from ...drives.limit_status import amount_text
from ...drives.motor_states import MotorStates
from ...drives.noise import MotorDeviations
from ...io.array_types import Array, Flags
from ...motion.sample_times import elapsed, least_step
from ...robot.robot import LEGS, Robot
from ..common.drawing import DARK, Figure, as_written, new_figure, plot_legs
from ..common.output import Columns, leg_table, of_legs

_COLUMNS = {"torque": "torque", "speed": "motor_speed", "current": "current", "power": "power"}
_HEADINGS = {"power": "shaft power"}
# Ratio of a limit to the largest value above which the limit is not drawn.
_FAR = 3.0


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
        self.drive, self.name, self.time = robot.drive, robot.name, time
        self._weights = trapezoids(elapsed(time)) if weights is None else weights
        self.summary = Summary(robot.drive, least_step(time))
        self._torque, self._speed = np.full((2, len(time), LEGS), np.nan, dtype=np.float32)

    def add(
        self, part: MotorStates, where: slice, sd: MotorDeviations | None = None, there: Flags | None = None
    ) -> None:
        """Add the next samples; ``sd`` and ``there`` are the arguments of ``Summary.add``."""
        self.summary.add(part, self._weights[where], self.time[where], sd, there)
        self._torque[where], self._speed[where] = part.torque, part.speed

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
            columns[f"{_HEADINGS.get(name, name)}, {PEAKS[name]}"] = _cells(found.peaks[name], limit, sd)
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

    def figure(self) -> Figure:
        """Plot torque over time, and torque over speed with the limits of the motor as a frame."""
        figure = new_figure(9.0, 4.4)
        over_time, over_speed = figure.subplots(1, 2, width_ratios=(1.25, 1.0))
        plot_legs(over_time, self.time, self._torque, linewidth=1.1)
        plot_legs(over_speed, self._speed, self._torque, linewidth=1.1)
        over_time.set(xlabel="time, s", ylabel="motor torque, N m", xlim=(self.time[0], self.time[-1]))
        over_speed.set(xlabel="motor speed, rad/s", ylabel="motor torque, N m")
        style: Any = {"color": DARK, "linewidth": 0.9, "linestyle": (0, (4, 2))}
        for torque in _near(self.drive.torque_limit, self._torque):
            over_time.axhline(torque, **style)
            over_speed.axhline(torque, **style)
        for speed in _near(self.drive.speed_limit, self._speed):
            over_speed.axvline(speed, **style)
        figure.legend(*over_time.get_legend_handles_labels(), loc="outside lower center", ncols=LEGS)
        figure.suptitle(f"{as_written(self.name)}: motors", fontsize=11.0)
        return figure


def _near(limits: Array, values: NDArray[np.float32]) -> tuple[float, ...]:
    """Return the smallest limit in both directions, or nothing if it is too far from the values."""
    narrowest, largest = float(limits.min()), float(np.nanmax(np.abs(values), initial=0.0))
    return (-narrowest, narrowest) if narrowest <= _FAR * largest else ()


def _cells(values: Array, limits: Array, sd: Array | None) -> list[str]:
    """Format the value of each motor with its standard deviation and its limit, if any."""
    return [
        amount_text(value, None if sd is None else sd[i], 4) + (f" of {most:g}" if np.isfinite(most) else "")
        for i, (value, most) in enumerate(zip(values, limits, strict=True))
    ]
