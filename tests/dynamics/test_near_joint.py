"""Near joint singularities, short and heavy legs every output errs by at most 10 times the sensitivity."""

import functools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from fifty_digits import truth as true_forces
from leaning_legs import leaning
from machines import machine_in_motion, random_motion, random_robot
from mpmath import mp
from near_joint import KINDS, Truth, excess, of_reference, random_case, truth
from reduced_machines import as_simple_as, at_rest
from sweep_machines import outputs
from sweeps import FULL, share, slow_but, sweep

import stewart_sym as ss
from stewart_sym.backend import fidelity
from stewart_sym.derive.mechanics.formulation import EXACT, FORMULATIONS
from stewart_sym.derive.mechanics.reduced_models import FIDELITIES
from stewart_sym.dynamics.closed_form import CClosedForm, NumpyClosedForm
from stewart_sym.reference import equations_of_motion
from stewart_sym.results import JOINT_SINGULAR, OK, ZERO_LENGTH

MOST = 10.0
FORMS = {"c": CClosedForm, "numpy": NumpyClosedForm}
BACKENDS: dict[str, Callable[..., Any]] = {
    "c": lambda robot, motion, F: outputs(CClosedForm(robot), motion, F),
    "numpy": lambda robot, motion, F: outputs(NumpyClosedForm(robot), motion, F),
    "reference": of_reference,
}
ENOUGH = 4
"""Random changes of all inputs, which already show most of the sensitivity."""


def case(seed: int, kind: str, index: int, deepest: float = 12.0) -> tuple:
    """A case, or () where no forces hold the machine: H is singular there."""
    rng = np.random.default_rng([seed, KINDS.index(kind), index])
    try:
        return random_case(rng, kind, deepest)
    except ValueError:
        return ()


def cases(seed: int, kind: str, count: int, deepest: float = 12.0) -> list[tuple]:
    return [found for i in range(count) if (found := case(seed, kind, i, deepest))]


@functools.cache
def with_truth(seed: int, kind: str, index: int) -> tuple[tuple, Truth]:
    """A case and its truth, which all backends share."""
    given = case(seed, kind, index)
    return given, truth(*given, ENOUGH)


def worst(given: tuple, true: Truth, backend: str) -> float:
    """The largest error of all outputs over the sensitivity; statuses must be those of the truth."""
    found, status = BACKENDS[backend](*given)
    if set(status.values()) & {JOINT_SINGULAR, ZERO_LENGTH}:
        return 0.0
    assert status == {name: true.status[name] for name in status}
    found = {name: value for name, value in found.items() if status[name.split(".")[0]] == OK}
    most = max(excess(true, found).values(), default=0.0)
    return most if most <= MOST else max(excess(truth(*given), found).values())


@sweep
@pytest.mark.parametrize("kind", slow_but(("short",), KINDS))
def test_every_output_is_as_good_as_the_machine_allows(kind: str) -> None:
    """Each case on C and NumPy, one in ten on the reference, which takes 50 digits."""
    found = []
    for number, given in enumerate(cases(1, kind, share(10_000 // len(KINDS), part=1100))):
        true = truth(*given, ENOUGH)
        backends = list(BACKENDS)[: 2 if number % 10 else 3]
        found += [(worst(given, true, backend), backend, number) for backend in backends]
    assert [each for each in found if each[0] > MOST] == []


@pytest.mark.parametrize(
    ("seed", "kind", "index"),
    [
        (0, "short and heavy", 18),
        (1, "lean and heavy", 96),
    ],
)
@pytest.mark.parametrize("backend", FORMS)
def test_what_turns_and_moves_a_heavy_leg_leaves_a_light_platform_its_digits(
    seed: int, kind: str, index: int, backend: str
) -> None:
    """Lost where the leg's force is taken as a wrench, or as its own inertia times its accelerations."""
    assert worst(*with_truth(seed, kind, index), backend) <= MOST


@pytest.mark.parametrize("kind", slow_but(("lean", "short"), KINDS if FULL else ("lean", "short")))
def test_50_digits_of_the_vector_reference_agree_with_the_truth(kind: str) -> None:
    for robot, motion, F in cases(5, kind, 1):
        x = equations_of_motion.forward_dynamics(robot, motion, F)
        found = {"forward_dynamics.acceleration": x}
        assert excess(truth(robot, motion, F, ENOUGH), found).popitem()[1] <= 1.0


def test_a_batch_of_calm_and_stiff_poses_gives_what_each_pose_gives() -> None:
    robot, motion, F = case(0, "lean", 6)
    R, t, omega, v = (np.stack([getattr(motion, n)] * 4) for n in ("R", "t", "omega", "v"))
    t[1:] += 1e-3 * np.arange(1, 4)[:, None] * np.ptp(robot.b)
    poses = ss.Motion(R=R, t=t, omega=omega, v=v)
    for form in FORMS.values():
        whole = form(robot).run("linearization", poses, np.stack([F] * 4))
        for i in range(4):
            one = form(robot).run("linearization", poses[i], F)
            for name in ("acceleration", "A", "B"):
                np.testing.assert_allclose(
                    whole[name][i], one[name], rtol=1e-12, atol=1e-12 * np.abs(one[name]).max()
                )


EPSILON = np.finfo(np.float64).eps
UNITS = 1000
SINES = [1e-1, 1e-5, 1e-11]


def calm(seed: int) -> tuple[ss.Robot, ss.Motion]:
    """A machine at rest with axisymmetric legs: no force depends on the joint singularity."""
    rng = np.random.default_rng(seed)
    robot = as_simple_as(random_robot(rng), FIDELITIES["axisymmetric"])
    return robot, at_rest(random_motion(rng, robot))


@pytest.mark.parametrize("sine", SINES)
def test_a_machine_that_does_not_feel_the_joint_singularity_keeps_its_digits(sine: float) -> None:
    robot, motion = calm(1)
    robot = leaning(robot, motion, sine)
    with mp.workdps(50):
        expected = np.array([float(F) for F in true_forces(EXACT, robot, motion)["F"]])
    whole = ss.inverse_dynamics(robot, motion)
    size = max(np.abs(values).max() for values in (whole.F, whole.D, whole.x))
    bound = UNITS * EPSILON * ss.condition_number(whole.H) * size
    names = [name for name in fidelity.FIDELITIES if not name.startswith(("massless", "point"))]
    found = [ss.ForceKernel(robot, fidelity=name).forces(motion) for name in names]
    found += [ss.inverse_dynamics(robot, motion, backend=backend).F for backend in ("c", "numpy")]
    for F in found:
        assert np.abs(F - expected).max() <= bound


@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("sine", [1e-2, 1e-8])
def test_a_general_machine_loses_no_more_than_its_own_sensitivity(formulation: str, sine: float) -> None:
    robot, motion = machine_in_motion(4)
    robot = leaning(robot, motion, sine)
    form = next(form for form in FORMULATIONS if form.kernel_name == formulation)
    with mp.workdps(50):
        expected = np.array([float(F) for F in true_forces(form, robot, motion)["F"]])
    # The leg's spin grows like the inverse sine, and with it what the error of a number does to the forces.
    kernel = ss.ForceKernel(robot, formulation)
    error = np.abs(kernel.forces(motion) - expected).max() / np.abs(expected).max()
    assert error <= UNITS * EPSILON * 60 / sine


def test_the_joint_singularity_itself_is_said_by_every_kernel() -> None:
    robot, motion = calm(0)
    for sine, status in ((3e-12, OK), (3e-13, JOINT_SINGULAR), (0.0, JOINT_SINGULAR)):
        leaned = leaning(robot, motion, sine)
        for name in ("general", "axisymmetric", "general_static"):
            assert ss.ForceKernel(leaned, fidelity=name).status(motion) == status
        for backend in ("c", "numpy"):
            found = ss.inverse_dynamics(leaned, motion, backend=backend, on_singular="nan")
            assert found.status == status
