"""Numbers of ``view``: peaks, limits, and marked samples of a displayed motion."""

import warnings

import numpy as np

from ...drives.limits import limited_angles
from ...viewer.view import Viewer
from .track import Digest, Part


def view_data(view: Viewer) -> dict[str, object]:
    """Return the numbers of a view for JSON, with peaks over the samples that have finite forces."""
    shown, found = view.history, view.limits
    # The legs are compared with their limits as in `forces`.
    sd, there = (None, None) if shown.noise is None else (shown.noise.sd, shown.noise.there)
    status = np.zeros(len(shown.time), dtype=np.int32)
    whole = Part(slice(None), shown.time, found.F, shown.L, shown.L_dot, shown.condition, status)
    digest = Digest(view.robot, shown.time)
    angles = limited_angles(view.robot, shown.motion)
    digest.add(whole._replace(effort=found.motors, sd=sd, there=there, angles=angles))
    # NumPy warns of legs without a finite force at any sample.
    with warnings.catch_warnings(action="ignore", category=RuntimeWarning):
        peaks = {name: np.nanmax(np.abs(F), axis=0) for name, F in shown.forces.items()}
    return {
        "motion": shown.name,
        "samples": len(shown.time),
        "start_s": shown.time[0],
        "end_s": shown.time[-1],
        "scaled_condition_number_peak": shown.condition.max(),
        "peak_force_N": peaks,
        "legs": digest.as_json()["legs"],
        "warnings": [line for _, line in view.limits.told],
        "marked": [{"time_s": e.time, "singular": e.singular, "twist": e.at.twist} for e in shown.events],
        "units": {"twist": "m/s and rad/s"},
    }
