"""Machines that are singular everywhere have no pose with status ok; poses near singular ones keep theirs."""

import dataclasses

import numpy as np
import pytest
from machines import Array
from sweep_machines import joined
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym import results
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse import wrench_matrix
from stewart_sym.studies.robustness.sweep.machines import random_machine, random_motion
from stewart_sym.studies.robustness.sweep.singular_machines import FAMILIES, NEARLY, singular_machine

LARGEST_CONDITION = {"double": 1e12, "float": 1e12 * np.finfo(np.float64).eps / np.finfo(np.float32).eps}
"""Up to these condition numbers of H no pose is singular to rounding."""


LOST = [family for family in FAMILIES if family not in NEARLY]
"""Families without pivots that are small for another reason."""


def machine(
    rng: np.random.Generator, family: str, apart: float = 0.0, count: int = 40
) -> tuple[ss.Robot, ss.Motion]:
    """A machine of a family, its points moved by ``apart`` of their size, and poses."""
    robot = singular_machine(rng, family, size=10.0 ** rng.uniform(-1.0, 1.0))
    motion = joined([random_motion(rng, robot) for _ in range(count)])
    size = np.abs(robot.b).max()
    b, p = (points + apart * size * rng.normal(size=(6, 3)) for points in (robot.b, robot.p))
    return dataclasses.replace(robot, b=b, p=p), motion


def from_afar(
    rng: np.random.Generator, robot: ss.Robot, motion: ss.Motion, radii: float
) -> tuple[ss.Robot, ss.Motion]:
    """The same from a reference point so many sizes away."""
    d = rng.normal(size=3)
    d *= radii * np.abs(robot.b).max() / np.linalg.norm(d)
    moved = dataclasses.replace(robot, p=robot.p + d, R_0=robot.R_0 + d)
    return moved, dataclasses.replace(motion, t=motion.t - motion.R @ d)


def statuses(robot: ss.Robot, motion: ss.Motion) -> dict[str, Array]:
    """Status of every pose by every kernel that solves with H."""
    found = {}
    for formulation in ("exact", "paper"):
        for backend in ("c", "numpy"):
            name = f"double inverse_dynamics {formulation} {backend}"
            found[name] = ss.inverse_dynamics(
                robot, motion, formulation=formulation, backend=backend, on_singular="nan"
            ).status
        for precision in ("double", "float"):
            kernel = ss.prepare(robot, formulation=formulation, precision=precision)
            found[f"{precision} forces {formulation}"] = kernel.status(motion)
    for fidelity in ("slender", "massless_static"):
        for precision in ("double", "float"):
            kernel = ss.prepare(robot, precision=precision, fidelity=fidelity)
            found[f"{precision} forces {fidelity}"] = kernel.status(motion)
    found["double bounds"] = ss.forces_with_bounds(robot, motion, on_singular="nan").status
    for backend in ("c", "numpy"):
        inertia = ss.joint_space_inertia(robot, motion, on_singular="nan", backend=backend)
        lost = np.isnan(inertia).any(axis=(-2, -1))
        found[f"double joint inertia {backend}"] = np.where(lost, results.SINGULAR, results.OK)
    return found


@sweep
@pytest.mark.parametrize("family", LOST)
def test_a_machine_that_is_singular_everywhere_has_no_pose_with_status_ok(family: str) -> None:
    """Wherever its points are measured from."""
    for seed in range(share(100, 25)):
        rng = np.random.default_rng(seed)
        radii = (0.0, 1e2, 1e4, 1e6)[seed % 4]
        for name, status in statuses(*from_afar(rng, *machine(rng, family), radii)).items():
            assert (status != results.OK).all(), (name, seed)
            assert radii or (status == results.SINGULAR).all(), (name, seed)


def test_good_poses_are_not_singular_from_far_away() -> None:
    """Up to the distance at which rounding of the points is that of a condition number of 1e12."""
    for seed, radii in enumerate(10.0 ** np.arange(1, 9)):
        rng = np.random.default_rng(seed)
        robot = random_machine(rng)
        far = from_afar(rng, robot, joined([random_motion(rng, robot) for _ in range(40)]), radii)
        for name, status in statuses(*far).items():
            if radii <= LARGEST_CONDITION[name.split()[0]] / 1e3:
                assert (status == results.OK).all(), (name, radii)


@pytest.mark.parametrize("family", LOST)
def test_no_pose_of_a_moderate_condition_number_is_singular(family: str) -> None:
    for seed, apart in enumerate(10.0 ** np.arange(-11, -1, 3)):
        robot, motion = machine(np.random.default_rng(seed), family, apart)
        condition = scaled_condition_number(wrench_matrix(robot, motion), characteristic_length(robot))
        for name, status in statuses(robot, motion).items():
            good = condition <= LARGEST_CONDITION[name.split()[0]]
            assert (status[good] != results.SINGULAR).all(), (name, apart)
