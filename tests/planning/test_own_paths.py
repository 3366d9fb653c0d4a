"""Paths of one's own: rates that contradict poses, singular poses between nodes, limits of speed alone."""

import dataclasses
import functools
import warnings
from collections.abc import Callable

import numpy as np
import pytest
from machines import home_position, machine_size, random_robot
from scipy.interpolate import PchipInterpolator, make_interp_spline
from via_cases import straight, via_case, with_limits

from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.motion.straight_line import PAPER_PATHS
from stewart_sym.planning.path_parameterization import TimedPath, parameterize_path
from stewart_sym.planning.plan_certificate import certify_plan
from stewart_sym.planning.timing.path_rates import need_rates
from stewart_sym.planning.timing.path_terms import Path, PathLimits
from stewart_sym.robots import dasgupta1998

ROBOT = random_robot(np.random.default_rng(1))
PLACES = np.linspace(0.0, 1.0, 8193)


def through(spline: Callable, size: float = 1.0) -> Path:
    """A path about home whose shifts and angles are a spline, times a size."""
    scale = size * np.repeat([machine_size(ROBOT), 1.0], 3)
    home = np.append(home_position(ROBOT.b, machine_size(ROBOT)), np.zeros(3))

    def path(s: np.ndarray) -> Motion:
        at = home + scale * spline(s), scale * spline(s, 1), scale * spline(s, 2)
        return Motion.from_rpy(*(half for x in at for half in (x[:, :3], x[:, 3:])))

    return path


def rows(count: int = 12) -> tuple[np.ndarray, np.ndarray]:
    s = np.linspace(0.0, 1.0, count)
    return s, 0.1 * np.sin(np.outer(s, [4.0, 5.0, 6.0, 3.0, 7.0, 8.0]) + np.arange(6))


def smooth(degree: int = 5) -> Callable:
    return make_interp_spline(*rows(), degree)


def blurred(path: Path) -> Path:
    """The path with errors of 1e-9 in every number."""
    random = np.random.default_rng(0)

    def blurred_path(s: np.ndarray) -> Motion:
        motion = path(s)
        turn, *vectors = 1e-9 * random.uniform(-1.0, 1.0, (6, len(s), 3))
        names = ("t", "omega", "v", "alpha", "a")
        odd = {name: getattr(motion, name) + by for name, by in zip(names, vectors, strict=True)}
        return Motion(R=rotation_from_vector(turn) @ motion.R, **odd)

    return blurred_path


def changed(**factors: float) -> Path:
    """A path some of whose derivatives are wrong by factors."""

    def path(s: np.ndarray) -> Motion:
        motion = through(smooth())(s)
        return dataclasses.replace(
            motion, **{name: by * getattr(motion, name) for name, by in factors.items()}
        )

    return path


def within_a_straight_line(s: np.ndarray) -> Motion:
    """Path II without its ends, at which it rests, moved to the machine's home."""
    line = PAPER_PATHS["II"].path
    motion = line.sample(line.tau_f * (0.05 + 0.9 * s))
    names = ("omega", "v", "alpha", "a")
    rates = {name: getattr(motion, name) * (0.9 * line.tau_f) ** (1 + (name[0] == "a")) for name in names}
    return Motion(R=motion.R, t=motion.t - line.t0 + home_position(ROBOT.b, machine_size(ROBOT)), **rates)


@functools.cache
def own_plan() -> TimedPath:
    return parameterize_path(ROBOT, through(smooth()), limits=LIMITS, grid_size=10)


LIMITS = PathLimits(speed=1.0, acceleration=50.0)
RATES = (
    r"^path: expected velocities equal to the derivatives of the poses by s: the length of leg \d changes by "
    r"\S+ m from s = "
)
JUMP = (
    r"^path: expected continuous velocities, and accelerations equal to their derivatives by s: "
    r"the rate of leg \d "
)


@pytest.mark.parametrize(
    ("path", "message"),
    [
        (changed(v=1.01), RATES),
        (changed(alpha=0.5), JUMP),
        (through(make_interp_spline(*rows(), 1)), JUMP + r"changes by \S+ m from s = 0.45"),
    ],
)
def test_rates_that_contradict_the_poses_or_jump_are_named(path: Path, message: str) -> None:
    with pytest.raises(ValueError, match=message) as error:
        parameterize_path(ROBOT, path, limits=LIMITS, grid_size=10)
    assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match=message):
        certify_plan(dataclasses.replace(own_plan(), path=path))


@pytest.mark.parametrize("blur", [False, True])
@pytest.mark.parametrize(
    "path",
    [
        *(through(smooth(degree)) for degree in (2, 3, 5)),
        through(PchipInterpolator(*rows(30))),
        through(smooth(), size=1e-5),
        within_a_straight_line,
    ],
)
def test_rates_that_are_those_of_the_poses_are_accepted(path: Path, blur: bool) -> None:
    need_rates(ROBOT, blurred(path) if blur else path, PLACES)


@pytest.mark.slow
def test_limits_of_speed_alone_give_the_least_time_and_a_warning_that_names_the_others() -> None:
    robot, poses = via_case(2)
    path = straight(robot, poses)
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        plan = parameterize_path(robot, path, limits=PathLimits(speed=0.1), grid_size=100)
    assert [each.category for each in found] == [UserWarning]
    expected = "limits: expected a limit of force, acceleration, or jerk in addition to speed, got none: "
    assert str(found[0].message).startswith(expected)
    L = inverse_kinematics(robot, path(np.linspace(0.0, 1.0, 20_001))).L
    assert plan.duration == pytest.approx(np.abs(np.diff(L, axis=0)).max(axis=-1).sum() / 0.1, rel=1e-3)
    assert certify_plan(plan).is_valid


@pytest.mark.slow
def test_a_singular_pose_between_the_nodes_is_named_by_the_force_that_it_takes() -> None:
    turn = np.array([0.0, 0.0, 1.6])

    def path(s: np.ndarray) -> Motion:
        still = np.zeros((len(s), 3))
        home = still + np.array([0.0, 0.0, 0.65])
        return Motion(
            R=rotation_from_vector(np.outer(s, turn)),
            t=home,
            omega=still + turn,
            v=still,
            alpha=still,
            a=still,
        )

    message = (
        r"^limits: force of leg 1 is \S+ at rest at s = 0.553907 of the path, expected less than its limit,"
    )
    with pytest.raises(ValueError, match=message):
        parameterize_path(dasgupta1998(), path, limits=PathLimits(force=1e5), grid_size=10)


def test_the_limit_that_no_slow_motion_keeps_is_named_with_its_place() -> None:
    robot, poses = via_case(1)
    path = straight(robot, poses)
    robot = dataclasses.replace(with_limits(robot, path), C_p=np.full(6, 1e10))
    with pytest.raises(
        ValueError,
        match=r"was found: force of leg 1 is \S+ times its limit near s = 0\.\d+ of the path$",
    ):
        parameterize_path(robot, path, limits=PathLimits(jerk=1e3), grid_size=10)
