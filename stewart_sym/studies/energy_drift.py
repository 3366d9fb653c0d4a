"""Energy of a free-swinging machine on leg springs over time, in both formulations: what is right keeps it.

Without friction or drive, and with springs for actuators, the energy of machine and springs is constant.
Takes a robot and returns records; draws them if asked (extra ``plot``). Writes no file.
"""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np
from numpy.typing import NDArray

from ..dynamics import Formulation, inverse_dynamics
from ..kernel import FORMULATIONS
from ..kinematics import inverse_kinematics
from ..laws import LegSprings
from ..motion import Motion
from ..robot import Robot
from ..simulation import Simulation, Stop, simulate

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

COLORS = {"exact": "#1f4e9c", "paper": "#c1440e"}


@dataclass(frozen=True, eq=False)
class Drift:
    """One run's energy.

    times: s, (n,). drift: energy of machine and springs minus that at the start, over the run's largest
    kinetic energy, (n,). kinetic: that largest kinetic energy, J. stop: why the run ended.
    """

    times: Array
    drift: Array
    kinetic: float
    stop: Stop

    @property
    def worst(self) -> float:
        """Largest magnitude of the drift."""
        return float(np.abs(self.drift).max())


def energy_drift(
    robot: Robot,
    state: Motion,
    stiffness: float,
    duration: float = 10.0,
    rtol: float = 1e-9,
) -> Mapping[Formulation, Drift]:
    """Set the frictionless machine swinging on leg springs and return its drift in each formulation.

    state: pose, where the springs balance the weight, and rates to start with, of shape (). stiffness: of
    each leg, N/m. duration: s. rtol: as for ``simulate``. Friction of the robot is left out. Raises
    ValueError as ``simulate``.
    """
    none = np.zeros(6)
    robot = dataclasses.replace(robot, C_u=none, C_p=none, C_s=none)
    springs = balanced_springs(robot, state, stiffness)
    runs: dict[Formulation, Drift] = {}
    for name in FORMULATIONS:
        formulation = cast(Formulation, name)
        run = simulate(robot, state, springs, duration, formulation=formulation, rtol=rtol)
        runs[formulation] = drift_of(run, springs)
    return runs


def balanced_springs(robot: Robot, pose: Motion, stiffness: float, damping: float = 0.0) -> LegSprings:
    """Springs that hold the machine at rest in a pose, stiffness in N/m and damping in N s/m."""
    zero = np.zeros(3)
    rest = Motion(pose.R, pose.t, zero, zero, zero, zero)
    F = inverse_dynamics(robot, rest).F
    return LegSprings(robot, stiffness, inverse_kinematics(robot, rest).L + F / stiffness, damping)


def drift_of(run: Simulation, springs: LegSprings) -> Drift:
    """Drift of the energy of machine and springs along a run."""
    energy = run.energy + springs.energy(run.L)
    kinetic = float(run.kinetic.max())
    return Drift(run.times, (energy - energy[0]) / kinetic, kinetic, run.stop)


def figure(drifts: Mapping[str, Drift]) -> "Figure":
    """The drifts over time, their magnitudes on a logarithmic axis."""
    from matplotlib.figure import Figure

    picture = Figure(figsize=(8.0, 4.2), layout="constrained")
    axes = picture.subplots()
    for name, drift in drifts.items():
        # The first instant is the measure of the others, and zero has no logarithm.
        axes.semilogy(
            drift.times[1:],
            np.maximum(np.abs(drift.drift[1:]), np.finfo(np.float64).eps),
            color=COLORS[name],
            linewidth=1.3,
            label=f"`{name}`, largest {drift.worst:.1e}",
        )
    axes.set_xlabel("time, s")
    axes.set_ylabel("|energy - energy at start| / largest kinetic energy")
    axes.set_title("Energy of the frictionless machine on leg springs", fontsize=10.0)
    axes.margins(x=0.0)
    axes.grid(alpha=0.35, linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    picture.legend(loc="outside lower center", ncols=2, frameon=False)
    return picture
