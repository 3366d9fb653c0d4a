"""C, NumPy and the vector reference agree on machines and motions of every kind."""

from dataclasses import replace

import numpy as np
import pytest
from machines import machine_in_motion, random_motion, random_robot
from numpy.typing import NDArray
from sweeps import share, sweep
from unsolvable_poses import semiregular

import stewart_sym as ss
from stewart_sym.backend import kernel
from stewart_sym.calls import c_kernel, numpy_kernel
from stewart_sym.motion.rotation import rotation_from_vector

FORCES = ("F", "D", "x", "K", "H", "c")
REACTIONS = ("F_s", "F_u", "F_p", "F_c", "M_p", "M_u")
POSES = 8
TOLERANCE = 1e-13


def deviation(
    left: ss.InverseDynamicsResult | ss.JointReactionsResult,
    right: ss.InverseDynamicsResult | ss.JointReactionsResult,
    name: str,
) -> NDArray[np.float64]:
    """Largest difference of each pose beside the largest entry of that pose."""
    a, b = (getattr(result, name).reshape(POSES, -1) for result in (left, right))
    size = np.abs(b).max(axis=1)
    return np.abs(a - b).max(axis=1) / np.where(size > 0, size, 1)


@sweep
@pytest.mark.parametrize("base_joint", ["universal", "spherical"])
@pytest.mark.parametrize("formulation", ["exact", "paper"])
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_backends_agree_to_rounding(formulation, backend, base_joint: str) -> None:
    """Forces and reactions of random machines, all terms on, beside the reference's."""
    rng = np.random.default_rng(100)
    for _ in range(share(400, 40)):
        robot, motion = machine_in_motion(rng, (POSES,), base_joint)
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


# Degrees of points in circles: turned by 90 degrees about its axis, this flat machine has a singular H.
BASE, PLATE = [-12, 12, 108, 132, 228, 252], [-45, 45, 75, 165, 195, 285]


def doubtful(rng: np.random.Generator, robot: ss.Robot) -> ss.Motion:
    """Random poses, among them turns about z to and through a singular one, in which pivots are equally large
    but for the last digits; legs of length zero or along their axes, numbers not finite or overflowing."""
    motion = random_motion(rng, robot, (60,))
    parts = {name: getattr(motion, name).copy() for name in kernel.MOTION}
    R, t = parts["R"], parts["t"]
    turns = np.pi / 2 + np.concatenate([[0.0], np.logspace(-16, -1, 31)])
    R[:32], t[:32] = rotation_from_vector(turns[:, None] * [0.0, 0.0, 1.0]), (0.0, 0.0, np.abs(robot.b).max())
    t[32:35] = robot.b[:3] - np.einsum("nij,nj->ni", R[32:35], robot.p[:3])
    t[35:38] = robot.b[:3] + robot.k[:3] - np.einsum("nij,nj->ni", R[35:38], robot.p[:3])
    t[38], parts["alpha"][39], parts["F_ext"][40] = 1e200, np.nan, np.inf
    return ss.Motion._unchecked(**parts)


@pytest.mark.parametrize(
    ("formulation", "base_joint", "scale"),
    [
        ("exact", "universal", 1e-3),
        ("exact", "universal", 100.0),
        ("exact", "spherical", 1.0),
        ("paper", "universal", 1.0),
        ("paper", "spherical", 1e-3),
    ],
)
@pytest.mark.usefixtures("rounded_twice")
def test_numpy_has_every_bit_and_status_of_c_however_many_poses_it_takes_at_once(
    formulation, base_joint: str, scale: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng(17)
    robot = random_robot(rng, base_joint, scale=scale)
    b, p = semiregular(BASE, scale), semiregular(PLATE, 0.5 * scale)
    for machine in (robot, replace(robot, b=b, p=p)):
        motion = doubtful(rng, machine)
        expected = c_kernel.CKernel(machine, formulation).run("inverse_dynamics", motion)
        for at_once in (1024, 7):
            monkeypatch.setattr(numpy_kernel, "_AT_ONCE", at_once)
            found = numpy_kernel.NumpyKernel(machine, formulation).run("inverse_dynamics", motion)
            for name in (*FORCES, "status"):
                np.testing.assert_array_equal(found[name], expected[name], name)
    assert {1, 2, 4} <= set(expected["status"])


def test_massless_legs_leave_F0() -> None:
    """With nearly weightless, frictionless legs the full forces are those of (41)."""
    robot, motion = machine_in_motion(10, (4,), friction=False)
    tiny = 1e-12
    light = ss.Robot(
        **{**vars(robot), **{n: tiny * getattr(robot, n) for n in ("m_d", "I_d0", "m_u", "I_u0")}}
    )
    F = ss.inverse_dynamics(light, motion).F
    F0 = ss.massless_forces(robot, motion)
    np.testing.assert_allclose(F, F0, rtol=1e-7, atol=1e-9 * np.abs(F0).max())
    np.testing.assert_allclose(ss.leg_dynamics_fraction(light, motion, F), (F - F0) / F)
