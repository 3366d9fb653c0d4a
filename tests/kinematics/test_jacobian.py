"""Jacobian and inverse Jacobian: leg rates of a twist, and back."""

import numpy as np
import pytest
from machines import random_motion, random_robot

import stewart_sym as ss


@pytest.mark.parametrize("seed", range(2))
def test_the_jacobian_turns_leg_rates_into_the_twist(seed: int) -> None:
    rng = np.random.default_rng(seed)
    robot = random_robot(rng)
    motion = random_motion(rng, robot, (4,))
    twist = np.concatenate([motion.v, motion.omega], axis=-1)
    L_dot = ss.inverse_kinematics(robot, motion).L_dot
    found = np.einsum("...ij,...j->...i", ss.jacobian(robot, motion), L_dot)
    np.testing.assert_allclose(found, twist, rtol=1e-8, atol=1e-8)


def test_a_singular_pose_has_no_jacobian() -> None:
    angles = np.arange(6) * np.pi / 3
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(6)], axis=-1)
    robot = ss.robots.dasgupta1998()
    flat = robot.__class__(**{**vars(robot), "b": ring, "p": 0.5 * ring})
    motion = ss.Motion(R=np.eye(3), t=[0.0, 0.0, 1.0], omega=np.zeros(3), v=np.zeros(3))
    assert np.linalg.matrix_rank(ss.inverse_jacobian(flat, motion)) < 6
    with pytest.raises(ValueError, match="singular pose"):
        ss.jacobian(flat, motion)
