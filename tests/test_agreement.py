"""C, NumPy and the vector reference agree on machines and motions of every kind."""

import numpy as np
import pytest
from machines import random_motion, random_robot
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.results import Forces, Reactions

FORCES = ("F", "D", "x", "K", "H", "c")
REACTIONS = ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u")
POSES = 8
TOLERANCE = 1e-13


def deviation(left: Forces | Reactions, right: Forces | Reactions, name: str) -> NDArray[np.float64]:
    """Largest difference of each pose beside the largest entry of that pose."""
    a, b = (getattr(result, name).reshape(POSES, -1) for result in (left, right))
    size = np.abs(b).max(axis=1)
    return np.abs(a - b).max(axis=1) / np.where(size > 0, size, 1)


def check_agreement(rng: np.random.Generator, machines: int, formulation, backend, base_joint: str) -> None:
    """Forces and reactions of random machines, all terms on, beside the reference's."""
    for _ in range(machines):
        robot = random_robot(rng, base_joint)
        motion = random_motion(rng, robot, (POSES,))
        bearing = rng.uniform(0, 1, 6)
        truth = ss.inverse_dynamics(robot, motion, formulation, "reference")
        found = ss.inverse_dynamics(robot, motion, formulation, backend)
        bound = TOLERANCE * ss.condition_number(truth.H)
        for name in FORCES:
            assert (deviation(found, truth, name) <= bound).all(), name
        held = ss.joint_reactions(robot, motion, formulation, "reference", bearing)
        reacts = ss.joint_reactions(robot, motion, formulation, backend, bearing)
        for name in REACTIONS:
            assert (deviation(reacts, held, name) <= bound).all(), name


@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_backends_agree_to_rounding(formulation, backend, base_joint: str) -> None:
    check_agreement(np.random.default_rng(100), 25, formulation, backend, base_joint)


@pytest.mark.slow
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_backends_agree_to_rounding_on_many_machines(formulation, backend, base_joint: str) -> None:
    check_agreement(np.random.default_rng(200), 400, formulation, backend, base_joint)


@pytest.mark.parametrize("backend", ["c", "numpy", "reference"])
@pytest.mark.parametrize("shape", [(), (1,), (3, 4), (0,), (2, 0, 3)])
def test_any_leading_shape_gives_the_poses_one_by_one(backend, shape: tuple[int, ...]) -> None:
    rng = np.random.default_rng(7)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, shape)
    together = ss.inverse_dynamics(robot, motion, backend=backend)
    reactions = ss.joint_reactions(robot, motion, backend=backend)
    assert together.F.shape == (*shape, 6)
    assert together.K.shape == reactions.F_s.shape == (*shape, 6, 3)
    assert together.H.shape == (*shape, 6, 6)
    assert reactions.M_u.shape == (*shape, 6)
    assert together.status.shape == shape
    for index in np.ndindex(shape):
        alone = ss.inverse_dynamics(robot, motion[index], backend=backend)
        np.testing.assert_allclose(together.F[index], alone.F, rtol=1e-12, atol=0)


def test_batches_in_c_are_bit_identical_to_single_poses() -> None:
    rng = np.random.default_rng(8)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (50,))
    together = ss.inverse_dynamics(robot, motion).F
    assert all((together[i] == ss.inverse_dynamics(robot, motion[i]).F).all() for i in range(50))


def test_no_load_is_zero_load() -> None:
    rng = np.random.default_rng(9)
    robot = random_robot(rng)
    free = random_motion(rng, robot, (4,), load=False)
    zero = np.zeros((4, 3))
    loaded = ss.Motion(free.R, free.t, free.omega, free.v, free.alpha, free.a, zero, zero)
    for backend in ("c", "numpy", "reference"):
        left = ss.inverse_dynamics(robot, free, backend=backend).F  # type: ignore[arg-type]
        right = ss.inverse_dynamics(robot, loaded, backend=backend).F  # type: ignore[arg-type]
        assert (left == right).all()


def test_massless_legs_leave_F0() -> None:
    """With nearly weightless, frictionless legs the full forces are those of (41)."""
    rng = np.random.default_rng(10)
    robot = random_robot(rng, friction=False)
    motion = random_motion(rng, robot, (4,))
    tiny = 1e-12
    light = ss.Robot(
        **{**vars(robot), **{n: tiny * getattr(robot, n) for n in ("m_d", "I_d0", "m_u", "I_u0")}}
    )
    F = ss.inverse_dynamics(light, motion).F
    F0 = ss.massless_forces(robot, motion)
    np.testing.assert_allclose(F, F0, rtol=1e-7, atol=1e-9 * np.abs(F0).max())
    np.testing.assert_allclose(ss.dynamic_fraction(light, motion, F), (F - F0) / F)
