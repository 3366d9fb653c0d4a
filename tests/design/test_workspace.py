"""Volumes of workspaces against exact volumes, the tool, limits, errors, and the report."""

import dataclasses

import numpy as np
import pytest
from exported_models import HEXAPOD
from machines import (
    dasgupta,
    home_position,
    machine_size,
    random_robot,
)
from scipy.spatial.transform import Rotation
from shells import shell_volume
from sweeps import share, sweep

import stewart_sym as ss
from stewart_sym.design.pose_limits import REASONS, PoseExaminer, at_reference
from stewart_sym.design.workspace import Kind, WorkspaceWarning
from stewart_sym.dynamics.home_pose import home_pose
from stewart_sym.io.progress import silent
from stewart_sym.kinematics.clearance import PAIRS, distances_of, nearest_shares
from stewart_sym.kinematics.mounting_side import upright
from stewart_sym.motion.motion import at_rest
from stewart_sym.motion.rotation import rotation_from_rpy
from stewart_sym.studies.design.workspace_report import slices


def limited(rng: np.random.Generator) -> ss.Robot:
    """A random machine with lengths limited about those of a pose above its base."""
    robot = random_robot(rng)
    L = np.linalg.norm(home_position(robot.b, machine_size(robot)) + robot.p - robot.b, axis=-1)
    shares = np.column_stack([rng.uniform(0.75, 0.95, 6), rng.uniform(1.05, 1.5, 6)])
    return dataclasses.replace(robot, length_limits=L[:, None] * shares)


def exact_volume(robot: ss.Robot, angles: np.ndarray) -> float:
    """Volume, m^3, of six shells above the base, in axes whose z points to the platform's side."""
    axes, R = upright(robot), rotation_from_rpy(angles)
    floor = (robot.b.mean(axis=0) - R @ robot.p.mean(axis=0)) @ axes[:, 2]
    return shell_volume((robot.b - robot.p @ R.T) @ axes, robot.length_limits, float(floor))


def deviations(seeds: range, poses: int) -> list[float]:
    """Errors of volumes over their stated errors."""
    found = []
    for seed in seeds:
        rng = np.random.default_rng(seed)
        robot, angles = limited(rng), rng.uniform(-0.2, 0.2, 3)
        made = ss.workspace(robot, rpy=angles, samples=poses, seed=seed)
        found.append((made.volume - exact_volume(robot, angles)) / made.error)
        assert made.error < 3.0 / np.sqrt(poses) * made.volume
    return found


@pytest.mark.full
@sweep
@pytest.mark.slow
def test_the_exact_volume_is_within_the_error() -> None:
    found = np.array(deviations(range(share(20, 5)), share(300_000, 10)))
    assert np.all(np.abs(found) <= 1.0)
    # The error is three standard deviations: neither too small nor, for safety, far too large.
    assert 0.6 < 3.0 * np.sqrt(np.mean(found**2)) < 1.5


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["orientation", "six_dof"])
def test_volumes_of_rotations_are_those_of_independent_random_poses(kind: Kind) -> None:
    rng = np.random.default_rng(8)
    robot = limited(rng)
    limits = ss.PoseLimits(forces=False)
    t = home_position(robot.b, machine_size(robot))
    box = np.stack([t - 0.3 * machine_size(robot), t + 0.3 * machine_size(robot)], axis=-1)
    made = ss.workspace(
        robot, kind, limits, position=t, position_bounds=box if kind == "six_dof" else None, samples=200_000
    )
    count = 400_000
    R = Rotation.random(count, random_state=1).as_matrix()
    places = rng.uniform(*box.T, size=(count, 3)) if kind == "six_dof" else np.tile(t, (count, 1))
    q = np.einsum("nij,kj->nki", R, robot.p)
    L = np.linalg.norm(places[:, None] + q - robot.b, axis=-1)
    over = (q.mean(axis=1) + places - robot.b.mean(axis=0)) @ upright(robot)[:, 2] >= 0.0
    inside = over & np.all((robot.length_limits[:, 0] <= L) & (robot.length_limits[:, 1] >= L), axis=-1)
    share = inside.mean()
    whole = 8.0 * np.pi**2 * (np.prod(box[:, 1] - box[:, 0]) if kind == "six_dof" else 1.0)
    deviation = np.sqrt(share / count)
    assert abs(made.volume - whole * share) < made.error + 3.0 * whole * deviation
    assert made.unit == ("rad^3" if kind == "orientation" else "m^3 rad^3")
    assert made.error < (0.1 if kind == "orientation" else 0.5) * made.volume


@pytest.mark.slow
def test_positions_and_rotations_are_those_of_the_tool() -> None:
    rng = np.random.default_rng(0)
    plain = limited(rng)
    robot = dataclasses.replace(plain, tool=machine_size(plain) * np.array([0.1, -0.2, 0.9]))
    angles = rng.uniform(-0.2, 0.2, 3)
    arm, home = rotation_from_rpy(angles) @ robot.tool, home_pose(plain).t
    centers = ((plain, home), (robot, home + arm))
    one, other = (ss.workspace(each, position=t, rpy=angles, samples=20_000) for each, t in centers)
    np.testing.assert_allclose(other.bounds, one.bounds + arm[:, None], rtol=1e-12)
    assert abs(other.volume - one.volume) < other.error + one.error
    np.testing.assert_allclose(other.extent, one.extent + arm[:, None], atol=0.05 * machine_size(robot))
    assert other.distance_to_limit == pytest.approx(one.distance_to_limit, rel=0.1)
    planes = zip(
        *(slices(r, ss.PoseLimits(), w, silent) for r, w in ((plain, one), (robot, other))), strict=True
    )
    assert all(np.mean(first.codes != second.codes) < 0.02 for first, second in planes)
    turns = np.array([[-0.6, 0.6]] * 3)
    found = ss.workspace(robot, "orientation", rpy_bounds=turns, samples=100_000)
    np.testing.assert_allclose(found.position, home_pose(robot).t + robot.tool)
    R = rotation_from_rpy(rng.uniform(*turns.T, (200_000, 3)))
    q = np.einsum("njk,ik->nij", R, robot.p)
    t = found.position - R @ robot.tool
    L = np.linalg.norm(t[:, None] + q - robot.b, axis=-1)
    inside = np.all((robot.length_limits[:, 0] <= L) & (L <= robot.length_limits[:, 1]), axis=-1)
    pitch = np.arctan2(-R[:, 2, 0], np.hypot(R[:, 0, 0], R[:, 1, 0]))
    volume = np.prod(np.ptp(turns, axis=1)) * np.mean(inside * np.cos(pitch))
    assert abs(found.volume - volume) < found.error + 0.02 * volume


def test_a_load_acts_at_the_tool() -> None:
    robot = dataclasses.replace(dasgupta(), tool=np.array([0.0, 0.0, 1.5]), force_limit=5000.0)
    load = np.array([300.0, -200.0, 100.0, 5.0, 6.0, 7.0])
    at = at_reference(robot, ss.PoseLimits(load=load)).load
    F, M = load[:3], load[3:]
    moved = at_rest(np.eye(3), robot.tool, F, M).at_point(-robot.tool)
    np.testing.assert_allclose(at, np.concatenate([moved.F_ext, moved.M_ext]))
    limits, box = ss.PoseLimits(load=load), home_pose(robot).t[:, None] + [[-0.2, 0.2]] * np.ones((3, 1))
    found = ss.workspace(robot, limits=limits, position_bounds=box + robot.tool[:, None], samples=2000)
    plain = dataclasses.replace(robot, tool=np.zeros(3))
    same = ss.workspace(plain, limits=ss.PoseLimits(load=at), position_bounds=box, samples=2000)
    assert found.limit_fractions == same.limit_fractions
    assert 0.1 < found.limit_fractions["feasible"] < 0.9


def test_a_volume_below_its_error_is_doubted() -> None:
    robot = limited(np.random.default_rng(0))
    t, size = home_position(robot.b, machine_size(robot)), machine_size(robot)
    box = np.stack([t - 0.3 * size, t + 0.3 * size], axis=-1)
    with pytest.warns(WorkspaceWarning, match="the error exceeds the volume"):
        found = ss.workspace(robot, "six_dof", position=t, position_bounds=box, samples=2000)
    assert not found.is_known


def test_a_pose_breaks_the_first_limit_that_it_breaks() -> None:
    rng = np.random.default_rng(3)
    robot = limited(rng)
    t = home_position(robot.b, machine_size(robot))
    wide = np.column_stack([robot.length_limits[:, 0] * 0.3, robot.length_limits[:, 1] * 1.2])
    weight = 9.81 * (robot.M + robot.m_d.sum() + robot.m_u.sum())
    robot = dataclasses.replace(
        robot,
        home_position=t,
        length_limits=wide,
        joint_angle_limit=np.column_stack([np.full(6, 0.7), np.full(6, 0.75)]),
        force_limit=np.full(6, weight),
    )
    limits = ss.PoseLimits(max_condition=4.0, min_clearance=0.2 * machine_size(robot))
    examiner = PoseExaminer(robot, limits)
    R = rotation_from_rpy(rng.uniform(-0.35, 0.35, (6000, 3)))
    poses = t + machine_size(robot) * rng.uniform([-0.5, -0.5, -1.3], [0.5, 0.5, 0.4], (6000, 3))
    codes = examiner.broken_limits(R, poses)
    motion = at_rest(R, poses)
    L = ss.inverse_kinematics(robot, motion).L
    angles = ss.joint_angles(robot, motion)
    H = ss.wrench_matrix(robot, motion)
    size = ss.characteristic_length(robot)
    home = ss.wrench_matrix(robot, at_rest(np.eye(3), t))
    same = np.sign(np.linalg.det(H)) == np.sign(np.linalg.det(home))
    over = (poses + R @ robot.p.mean(axis=0) - robot.b.mean(axis=0)) @ examiner.up
    F = ss.inverse_dynamics(robot, motion, on_singular="nan").F
    kept = [
        over >= 0.0,
        np.all((wide[:, 0] <= L) & (wide[:, 1] >= L), axis=-1),
        np.all((angles.base <= 0.7) & (angles.platform <= 0.75), axis=-1),
        np.all(ss.leg_distances(robot, motion) >= limits.min_clearance, axis=-1),
        same & (ss.scaled_condition_number(H, size) <= 4.0),
        np.all(np.abs(F) <= weight, axis=-1),
    ]
    expected = np.where(np.all(kept, axis=0), 0, 1 + np.argmin(np.stack(kept), axis=0))
    np.testing.assert_array_equal(codes, expected)
    assert np.count_nonzero(np.bincount(codes, minlength=len(REASONS))) >= 6


def test_cells_that_are_left_out_hold_no_pose_within_the_limits() -> None:
    rng = np.random.default_rng(5)
    examiner = PoseExaminer(limited(rng), ss.PoseLimits())
    robot = examiner.robot
    turn, shift = rng.uniform(0.0, 0.4, 100), rng.uniform(0.0, 0.3, 100) * machine_size(robot)
    R = rotation_from_rpy(rng.uniform(-0.4, 0.4, (100, 3)))
    t = home_position(robot.b, machine_size(robot)) + machine_size(robot) * rng.uniform(-0.4, 0.4, (100, 3))
    broken = examiner.surely_broken(R, t, shift, turn, np.zeros(3))
    assert 7 < np.count_nonzero(broken) < 93
    for i in np.flatnonzero(broken):
        axis, direction = rng.normal(size=(2, 400, 3))
        size = turn[i] * rng.random(400)[:, None]
        turned = Rotation.from_rotvec(size * axis / np.linalg.norm(axis, axis=-1, keepdims=True)).as_matrix()
        moved = shift[i] * direction / np.linalg.norm(direction, axis=-1, keepdims=True)
        assert np.all(examiner.broken_limits(turned @ R[i], t[i] + moved) > 0)


@pytest.mark.slow
def test_a_cluster_of_workers_gives_the_same_bits() -> None:
    robot = ss.robots.rubin_m2()
    limits = ss.PoseLimits(max_condition=10.0, min_clearance=0.01)
    here, there = (
        ss.workspace(robot, limits=limits, samples=60_000, scheduler=scheduler)
        for scheduler in (None, "local")
    )
    for field in dataclasses.fields(here):
        one, other = getattr(here, field.name), getattr(there, field.name)
        if isinstance(one, np.ndarray):
            assert one.tobytes() == other.tobytes(), field.name
        else:
            assert one == other, field.name


def test_where_nothing_is_in_reach_that_is_said() -> None:
    robot = limited(np.random.default_rng(1))
    far = [[5.0, 5.1], [5.0, 5.1], [5.0, 5.1]]
    said = "no pose within the limits was found; position_bounds: t_x from 500 to 510 m is beyond the reach"
    with pytest.warns(ss.WorkspaceWarning, match=said) as caught:
        made = ss.workspace(robot, position_bounds=100.0 * np.array(far), samples=1000)
    assert len(caught) == 1
    assert (made.volume, made.error, made.distance_to_limit) == (0.0, 0.0, made.distance_to_limit)
    assert np.isnan(made.extent).all()
    with pytest.warns(ss.WorkspaceWarning, match="no pose .*; state another position"):
        ss.workspace(robot, "orientation", position=[5.0, 5.0, 5.0], samples=1000)


@pytest.mark.parametrize(("reach", "clear"), [((-0.02, 0.02), np.inf), ((0.0, 0.3), 0.2)])
def test_of_a_box_only_poses_that_break_a_limit_bound_what_is_clear(
    reach: tuple[float, float], clear: float
) -> None:
    """Whether the pose in the middle is at its corner or far from its faces."""
    robot = ss.Robot.from_toml(HEXAPOD)
    box = home_pose(robot).t[:, None] + np.array(reach)
    assert ss.workspace(robot, position_bounds=box, samples=20_000).distance_to_limit == pytest.approx(
        clear, rel=0.05
    )


def test_distances_of_legs_are_the_least_of_their_points() -> None:
    rng = np.random.default_rng(0)
    b, S = rng.normal(size=(6, 3)), rng.normal(size=(5, 6, 3))
    found = distances_of(b, S)
    share = np.linspace(0.0, 1.0, 201)[:, None]
    for n in range(5):
        for pair, (i, j) in enumerate(PAIRS):
            one, other = b[i] + share * S[n, i], b[j] + share * S[n, j]
            least = np.linalg.norm(one[:, None] - other, axis=-1).min()
            x, y = nearest_shares(b[i] - b[j], S[n, i], S[n, j])
            nearest = b[i] - b[j] + x * S[n, i] - y * S[n, j]
            assert np.linalg.norm(nearest) == pytest.approx(found[n, pair], rel=1e-9)
            assert found[n, pair] <= least + 1e-12
            assert least - found[n, pair] < 2e-2 * least + 1e-3
