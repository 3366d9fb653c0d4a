"""Near joint singularities, short and heavy legs every output errs by at most 10 times the sensitivity."""

import numpy as np
import pytest
from near_joint import BLOCKS, KINDS, blocks, excess, outputs, random_case, truth
from numpy.typing import NDArray
from sweeps import share

import stewart_sym as ss
from stewart_sym import reference_equations
from stewart_sym.closed_form import CClosedForm, NumpyClosedForm
from stewart_sym.results import OK, POLE, SHORT_LEG

MOST = 10.0
FORMS = {"c": CClosedForm, "numpy": NumpyClosedForm}
ENOUGH = 4
"""Random changes of all inputs, which already show most of the sensitivity."""


def case(seed: int, kind: str, index: int, deepest: float = 12.0) -> tuple:
    """A case, or None where no forces hold the machine: H is singular there."""
    rng = np.random.default_rng([seed, KINDS.index(kind), index])
    try:
        return random_case(rng, kind, deepest)
    except ValueError:
        return ()


def worst(given: tuple, form: type) -> float:
    """The largest error of all outputs over the sensitivity; statuses must be those of the truth."""
    robot, motion, F = given
    true = truth(robot, motion, F, ENOUGH)
    found, status = outputs(form(robot), motion, F)
    if set(status.values()) & {POLE, SHORT_LEG}:
        return 0.0
    assert status == true.status
    found = {name: value for name, value in found.items() if status[name.split(".")[0]] == OK}
    most = max(excess(true, found).values(), default=0.0)
    return most if most <= MOST else max(excess(truth(robot, motion, F), found).values())


@pytest.mark.parametrize("backend", FORMS)
@pytest.mark.parametrize("kind", KINDS)
def test_every_output_is_as_good_as_the_machine_allows(kind: str, backend: str) -> None:
    for given in filter(None, (case(0, kind, i) for i in range(12))):
        assert worst(given, FORMS[backend]) <= MOST


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_every_output_is_as_good_as_the_machine_allows_in_10_000_cases(kind: str) -> None:
    count = share(10_000 // len(KINDS))
    assert (
        max(worst(given, CClosedForm) for given in filter(None, (case(1, kind, i) for i in range(count))))
        <= MOST
    )


@pytest.mark.parametrize("kind", KINDS)
def test_the_truth_does_not_depend_on_the_code_paths_for_lost_digits(kind: str) -> None:
    for given in filter(None, (case(3, kind, i, deepest=5.0) for i in range(6))):
        own, plain = truth(*given, ENOUGH), truth(*given, 1, plain=True)
        for name in BLOCKS:
            apart = np.abs((own.high[name] - plain.high[name]) + (own.low[name] - plain.low[name]))
            for error, allowed in zip(blocks(name, apart), blocks(name, own.sensitivity[name]), strict=True):
                assert error.max() <= 1e-3 * allowed.max(), name


def acceleration(x: tuple[NDArray[np.float64], NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    return {"forward_dynamics.acceleration": np.concatenate(x)}


@pytest.mark.parametrize("kind", KINDS)
def test_the_reference_s_forward_dynamics_is_as_good_as_the_machine_allows(kind: str) -> None:
    for robot, motion, F in filter(None, (case(4, kind, i, deepest=9.0) for i in range(3))):
        found = ss.forward_dynamics(robot, motion, F, backend="reference")
        assert excess(truth(robot, motion, F, ENOUGH), acceleration(found)).popitem()[1] <= MOST


@pytest.mark.parametrize("kind", KINDS)
def test_50_digits_of_the_vector_reference_agree_with_the_truth(kind: str) -> None:
    for robot, motion, F in filter(None, (case(5, kind, i) for i in range(3))):
        x = reference_equations.forward_dynamics(robot, motion, F)
        found = {"forward_dynamics.acceleration": x}
        assert excess(truth(robot, motion, F, ENOUGH), found).popitem()[1] <= 1.0


def test_a_batch_of_calm_and_stiff_poses_gives_what_each_pose_gives() -> None:
    robot, motion, F = case(0, "lean", 6)
    R, t, omega, v = (np.stack([getattr(motion, n)] * 4) for n in ("R", "t", "omega", "v"))
    t[1:] += 1e-3 * np.arange(1, 4)[:, None] * np.ptp(robot.b)
    poses = ss.Motion(R=R, t=t, omega=omega, v=v)
    for form in FORMS.values():
        whole = form(robot).run("linearisation", poses, np.stack([F] * 4))
        for i in range(4):
            one = form(robot).run("linearisation", poses[i], F)
            for name in ("acceleration", "A", "B"):
                np.testing.assert_allclose(
                    whole[name][i], one[name], rtol=1e-12, atol=1e-12 * np.abs(one[name]).max()
                )
