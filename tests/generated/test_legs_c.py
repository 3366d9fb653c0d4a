"""The legs of many poses in C: as NumPy's to rounding, the same errors. Statuses: ``test_attack_c``."""

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pytest
from machines import dasgupta, home_position, machine_in_motion, machine_size

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.kinematics import inverse_kinematics

MANY = 2 * inverse_kinematics.MANY + 3
ERROR = 64 * np.finfo(np.float64).eps


@contextmanager
def numpy_alone(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    def nothing(name: str, suffix: str) -> ctypes.CDLL:
        raise native.CompilerError("none")

    with monkeypatch.context() as patch:
        patch.setattr(inverse_kinematics, "function", nothing)
        yield


@pytest.mark.parametrize("scale", [1e-3, 10.0])
@pytest.mark.parametrize("accelerations", [True, False])
def test_many_poses_are_those_of_numpy(
    scale: float, accelerations: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot, motion = machine_in_motion(5, (3, MANY // 3 + 1), scale=scale)
    if not accelerations:
        motion = ss.Motion(R=motion.R, t=motion.t, omega=motion.omega, v=motion.v)
    assert inverse_kinematics._compiled_legs(robot, motion) is not None
    found = ss.inverse_kinematics(robot, motion)
    with numpy_alone(monkeypatch):
        expected = ss.inverse_kinematics(robot, motion)
    assert (found.L_ddot is None) == (not accelerations)
    for name, value in vars(expected).items():
        if value is not None:
            size = np.abs(value).max()
            np.testing.assert_allclose(getattr(found, name), value, rtol=0.0, atol=ERROR * size, err_msg=name)


def test_a_fault_in_a_late_pose_is_named_as_numpy_names_it(monkeypatch: pytest.MonkeyPatch) -> None:
    robot = dasgupta()
    n = MANY
    t = np.tile(home_position(robot.b, machine_size(robot)), (n, 1))
    t[n - 2] = robot.b[3] - robot.p[3]
    short = ss.Motion(R=np.eye(3), t=t, omega=np.zeros(3), v=np.zeros(3))
    far = ss.Motion(
        R=np.eye(3), t=np.where(np.arange(n)[:, None] == n - 2, 1e200, t), omega=np.zeros(3), v=np.zeros(3)
    )
    for motion, message in ((short, rf"leg 4 has length zero at motion\[{n - 2}\]"), (far, "leg|overflow")):
        with pytest.raises(ValueError, match=message) as in_c:
            ss.inverse_kinematics(robot, motion)
        with numpy_alone(monkeypatch), pytest.raises(ValueError, match=message) as in_numpy:
            ss.inverse_kinematics(robot, motion)
        assert str(in_c.value) == str(in_numpy.value)
