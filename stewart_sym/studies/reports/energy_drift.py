"""Energy of a frictionless machine on leg springs in both formulations; correct equations conserve it."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import cast

import numpy as np

from ...backend.kernel import FORMULATIONS
from ...dynamics.inverse_dynamics import Formulation
from ...io.array_types import Array
from ...motion.motion import Motion
from ...simulation.actuator_models import LegSprings
from ...simulation.simulation import simulate
from ...simulation.state_history import SimulationResult, StateHistory, StopEvent
from ...simulation.stop_conditions import StopConditions
from ..common.drawing import BLUE, RED, Figure, legend_below, log_numbers, new_figure
from ..paper.reproduce import without_friction

INSTANTS = 1001
"""Number of evenly spaced samples for the mean kinetic energy."""
STILL = 1e-12
"""Fraction of the compared energies below which rounding errors dominate the drift."""
COLORS = {"exact": BLUE, "paper": RED}


@dataclass(frozen=True, eq=False)
class Drift:
    """Energy drift at times (s), shape (n,): change of the energy of machine and springs over ``scale``.

    ``scale`` is the result of ``energy_scale`` (J), and ``stop`` the end of the run.
    """

    times: Array
    drift: Array
    scale: float
    stop: StopEvent

    @property
    def worst(self) -> float:
        """Largest magnitude of the drift."""
        return float(np.abs(self.drift).max())

    @property
    def text(self) -> str:
        """Description of the largest drift."""
        if self.scale == 0.0:
            return "nothing moved, so that no energy can drift"
        return f"energy with that of the springs changes by up to {self.worst:.2e} of the mean kinetic energy"


def energy_drift(
    springs: LegSprings,
    state: Motion,
    duration: float = 10.0,
    rtol: float = 1e-9,
    thresholds: StopConditions | None = None,
) -> dict[Formulation, Drift]:
    """Simulate a machine on springs without friction, dampers, and load, and return its drift in each
    formulation.

    Both drifts are relative to the mean kinetic energy of the run in ``exact``.
    """
    robot = without_friction(springs.robot)
    springs = dataclasses.replace(springs, robot=robot, damping=0.0)
    state = Motion(R=state.R, t=state.t, omega=state.omega, v=state.v)
    runs = {
        formulation: simulate(
            robot, state, springs, duration, formulation=formulation, rtol=rtol, stop_conditions=thresholds
        )
        for formulation in cast(tuple[Formulation, ...], FORMULATIONS)
    }
    scale = energy_scale(runs["exact"], springs)
    return {formulation: drift_of(run, run.stop, springs, scale) for formulation, run in runs.items()}


def drift_of(run: StateHistory, stop: StopEvent, springs: LegSprings, scale: float) -> Drift:
    """Compute the energy drift of machine and springs along a run, relative to ``scale`` (J)."""
    energy = run.energy + springs.energy(run.L)
    drift = (energy - energy[0]) / scale if scale else np.zeros_like(energy)
    return Drift(run.time, drift, scale, stop)


def energy_scale(run: SimulationResult, springs: LegSprings) -> float:
    """Compute the mean kinetic energy of a run (J), or 0 if the motion is only rounding errors."""
    even = run.at(np.linspace(0.0, run.stop.time, INSTANTS))
    mean = float(even.kinetic_energy.mean())
    stored = float((np.abs(even.potential_energy) + np.abs(springs.energy(even.L))).max())
    return mean if mean > STILL * stored else 0.0


def summary(drifts: Mapping[Formulation, Drift]) -> str:
    """Format one line for each formulation with the largest drift and the reason of the end."""
    return "\n".join(
        f"{name:<9}  without friction: {drift.text}; {drift.stop.message}" for name, drift in drifts.items()
    )


def figure(drifts: Mapping[Formulation, Drift]) -> Figure:
    """Plot the magnitudes of the drifts over time, for runs with more than one sample."""
    drifts = {name: drift for name, drift in drifts.items() if len(drift.times) > 1}
    picture = new_figure(8.0, 4.2)
    axes = picture.subplots()
    for name, drift in drifts.items():
        # The drift of the first sample is zero, which has no logarithm.
        size = np.maximum(np.abs(drift.drift[1:]), STILL)
        label = f"{name}, largest {drift.worst:.1e}"
        axes.semilogy(drift.times[1:], size, color=COLORS[name], linewidth=1.3, label=label)
    axes.set(xlabel="time, s", ylabel="change of energy / mean kinetic energy")
    axes.set_title("Energy of the frictionless machine on leg springs", fontsize=10.0)
    axes.margins(x=0.0)
    log_numbers(axes.yaxis)
    legend_below(picture)
    return picture
