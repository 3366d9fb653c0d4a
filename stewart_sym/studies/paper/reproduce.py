"""Reproduction of section 5 of the paper: Paths I-III, errors due to the printed faults, work, and energy."""

import dataclasses
import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from typing import get_args

import numpy as np

from ...backend import native
from ...backend.kernel import kernel_name, module
from ...dynamics.inverse_dynamics import Formulation, inverse_dynamics, massless_forces
from ...io.array_types import Array
from ...io.progress import Progress, silent, tracked
from ...kinematics.conditioning import characteristic_length, condition_number, scaled_condition_number
from ...motion.motion import at_rest
from ...motion.straight_line import PAPER_PATHS
from ...reference import newton_euler
from ...robot.robot import Robot
from ...robots import dasgupta1998
from ...singularities.path_singularities import singularity_crossings
from ..common.text_tables import Columns, Figures, of_legs

LIGHT_PLATFORM = 4.0
"""Platform mass (kg), comparable to the mass of one leg, for the claim on the mass ratio."""

FORMULATIONS: tuple[Formulation, ...] = get_args(Formulation)

_SINGLE = (newton_euler.SPIN, newton_euler.MOMENT, newton_euler.TRANSPORT)
FAULTS = (*(frozenset({fault}) for fault in _SINGLE), newton_euler.PAPER, frozenset({newton_euler.SIGN}))
"""Sets of printed faults whose effect is measured: each fault alone, and the faults of `paper` together."""

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


@dataclass(frozen=True, eq=False)
class PathRun:
    """Results for one path in one formulation at times (s), shape (n,).

    F and F0 are total and massless-leg actuator forces (N), (37) and (41), shape (n, 6). The condition
    numbers of H have shape (n,); the scaled one with moments divided by the characteristic length.
    """

    path: str
    formulation: str
    time: Array
    F: Array
    F0: Array
    condition: Array
    scaled_condition: Array

    @property
    def Fd(self) -> Array:
        """Contribution of leg inertia, leg weight, and friction (N), shape (n, 6), (42)."""
        return self.F - self.F0

    @property
    def fraction(self) -> Array:
        """Dynamic fraction F_d / F, shape (n, 6), which is unbounded near zeros of F."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.Fd / self.F


@dataclass(frozen=True, eq=False)
class Reproduction:
    """Results of ``reproduce``: runs by (path, formulation), and results of the functions of this module.

    By formulation, ``light`` is Path I with a platform of ``LIGHT_PLATFORM`` kg. H is singular on Path III at
    ``singular_time`` (s).
    """

    robot: Robot
    backend: str
    runs: Mapping[tuple[str, str], PathRun]
    light: Mapping[str, PathRun]
    singular_time: float
    fault_costs: list[Figures]
    work_energy: list[Figures]
    operations: list[Figures]


def reproduce(progress: Progress = silent) -> Reproduction:
    """Compute all results for the machine of the paper; ``progress`` receives the current step."""
    robot, path, compiler = dasgupta1998(), PAPER_PATHS["III"].path, native.find_compiler()
    lighter = dataclasses.replace(robot, M=LIGHT_PLATFORM)
    progress("running Paths I-III")
    every = tracked(progress, FAULTS, lambda _: "measuring the printed faults")
    return Reproduction(
        robot=robot,
        backend="NumPy kernels" if compiler is None else f"C kernels, compiled by {compiler.version}",
        runs={(name, form): run_path(robot, name, form) for name in PAPER_PATHS for form in FORMULATIONS},
        light={form: run_path(lighter, "I", form) for form in FORMULATIONS},
        singular_time=singularity_crossings(robot, path.sample, path.breakpoints())[0].time,
        fault_costs=[fault_cost(robot, faults) for faults in every],
        work_energy=[work_energy(robot, name, form) for name in PAPER_PATHS for form in FORMULATIONS],
        operations=operations(),
    )


def run_path(robot: Robot, name: str, formulation: Formulation) -> PathRun:
    """Compute a path of ``PAPER_PATHS`` at the time step of the paper."""
    path, dtau = PAPER_PATHS[name]
    time = path.time_grid(dtau)
    motion = path.sample(time)
    forces = inverse_dynamics(robot, motion, formulation)
    scaled = scaled_condition_number(forces.H, characteristic_length(robot))
    F0, condition = massless_forces(robot, motion), condition_number(forces.H)
    return PathRun(name, formulation, time, forces.F, F0, condition, scaled)


def run_columns(run: PathRun) -> Columns:
    """Return the columns of the CSV file of a run by name, shape (n,), SI units."""
    return (
        {"time": run.time}
        | of_legs("F", run.F)
        | of_legs("F0", run.F0)
        | of_legs("Fd", run.Fd)
        | of_legs("dynamic_fraction", run.fraction)
        | {"condition_number": run.condition, "scaled_condition_number": run.scaled_condition}
    )


def without_friction(robot: Robot) -> Robot:
    """Return the robot with all eighteen friction coefficients 0."""
    zero = np.zeros(6)
    return dataclasses.replace(robot, C_u=zero, C_p=zero, C_s=zero)


def fault_cost(robot: Robot, faults: frozenset[int]) -> Figures:
    """Return the RMS of F - F_exact over the RMS of F_exact by path, moving and at rest, without friction."""
    frictionless = without_friction(robot)
    found: Figures = {"faults": sorted(faults), "moving": {}, "at_rest": {}}
    for name, (path, dtau) in PAPER_PATHS.items():
        moving = path.sample(path.time_grid(dtau))
        for state, motion in (("moving", moving), ("at_rest", at_rest(moving.R, moving.t))):
            exact = newton_euler.inverse_dynamics(frictionless, motion).F
            faulty = newton_euler.inverse_dynamics(frictionless, motion, faults).F
            found[state][name] = float(np.linalg.norm(faulty - exact) / np.linalg.norm(exact))
    return found


def work_energy(robot: Robot, name: str, formulation: Formulation) -> Figures:
    """Compute the work of the actuators and the increase of energy along a path (J), without friction.

    The power is integrated by Gauss-Legendre quadrature between the jumps of acceleration. The mismatch,
    relative to the energy increase, is 0 for correct equations. F is unbounded at the singular pose of Path
    III, but its power F.Ldot = D.Ldot - c.twist is not.
    """
    frictionless = without_friction(robot)
    path = PAPER_PATHS[name].path
    breaks = path.breakpoints()
    half = np.diff(breaks)[:, None] / 2
    motion = path.sample((breaks[:-1, None] + half * (_NODES + 1)).ravel())
    F = inverse_dynamics(frictionless, motion, formulation).F
    power = newton_euler.actuator_power(frictionless, motion, F)
    ends = newton_euler.energy(frictionless, path.sample(breaks[[0, -1]]))
    work, gain = float((half * _WEIGHTS).ravel() @ power), float(ends[1] - ends[0])
    figures = {"work_J": work, "gain_J": gain, "mismatch": (work - gain) / gain}
    return {"path": name, "formulation": formulation, **figures}


def operations() -> list[Figures]:
    """Count the operations (mul, add, div, sqrt) of the generated kernels for the paper's type of machine."""
    found = []
    for form, friction in itertools.product(FORMULATIONS, ("frictionless", "friction")):
        parts = module(kernel_name(form, "universal")).OPERATIONS[friction]
        leg, platform, total = (np.array(parts[part]) for part in ("leg", "platform", "total"))
        counts = {"leg": leg, "platform": platform, "final": total - 6 * leg - platform, "total": total}
        named = {"formulation": form, "friction": friction == "friction"}
        found.append(named | {part: each.tolist() for part, each in counts.items()})
    return found
