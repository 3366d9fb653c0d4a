"""Energy of a free-swinging machine on leg springs over time, in both formulations: what is right keeps it.

Without friction or drive, and with springs for actuators, the energy of machine and springs is constant.
"""

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
"""Evenly spaced in a run's time, over which the kinetic energy is averaged."""
STILL = 1e-12
"""Of the energies that are compared, below which rounding hides what drifts."""
COLORS = {"exact": BLUE, "paper": RED}


@dataclass(frozen=True, eq=False)
class Drift:
    """One run's energy.

    times: s, (n,). drift: energy of machine and springs minus that at the start, over ``scale``, (n,); zero
    where nothing moved. scale: mean kinetic energy, J, see ``energy_scale``; 0 where nothing moved.
    stop: why the run ended.
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
        """The worst drift in words."""
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
    """Set the springs' machine swinging and return its drift in each formulation.

    Both are measured by the mean kinetic energy of the run in ``exact``.

    springs: their dampers, and the friction of their robot, are left out. state: to start from, of shape (),
    without its load. duration, rtol, thresholds: as for ``simulate``, and so are the errors.
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
    """Drift of the energy of machine and springs along a run, measured by a scale, J; stop: why it ended."""
    energy = run.energy + springs.energy(run.L)
    drift = (energy - energy[0]) / scale if scale else np.zeros_like(energy)
    return Drift(run.time, drift, scale, stop)


def energy_scale(run: SimulationResult, springs: LegSprings) -> float:
    """Mean kinetic energy over a run's time, J, which no short peak makes large.

    0 where it is below ``STILL`` of the energy of weight and springs: nothing moved but by rounding.
    """
    even = run.at(np.linspace(0.0, run.stop.time, INSTANTS))
    mean = float(even.kinetic_energy.mean())
    stored = float((np.abs(even.potential_energy) + np.abs(springs.energy(even.L))).max())
    return mean if mean > STILL * stored else 0.0


def summary(drifts: Mapping[Formulation, Drift]) -> str:
    """One line for each formulation: the worst drift and why the run ended."""
    return "\n".join(
        f"{name:<9}  without friction: {drift.text}; {drift.stop.message}" for name, drift in drifts.items()
    )


def figure(drifts: Mapping[Formulation, Drift]) -> Figure:
    """The drifts over time, their magnitudes on a logarithmic axis; of runs of more than one instant."""
    drifts = {name: drift for name, drift in drifts.items() if len(drift.times) > 1}
    picture = new_figure(8.0, 4.2)
    axes = picture.subplots()
    for name, drift in drifts.items():
        # At the first instant the drift is zero, which has no logarithm.
        axes.semilogy(
            drift.times[1:],
            np.maximum(np.abs(drift.drift[1:]), STILL),
            color=COLORS[name],
            linewidth=1.3,
            label=f"{name}, largest {drift.worst:.1e}",
        )
    axes.set(xlabel="time, s", ylabel="change of energy / mean kinetic energy")
    axes.set_title("Energy of the frictionless machine on leg springs", fontsize=10.0)
    axes.margins(x=0.0)
    log_numbers(axes.yaxis)
    legend_below(picture)
    return picture
