"""Bounds of rounding errors against the worst rounding that there is, instead of a random one.

Two layers. The whole kernel: every operation rounded by one unit against a force. One quantity at a time:
only its operations round, so that no other term of the bound hides that one is missing.
"""

import dataclasses
import shutil
from collections.abc import Iterator

import numpy as np
import pytest
import worst_rounding as rounding
from drawn_poses import PATH, drawn
from machines import machine_in_motion
from near_singular import PRECISIONS, case, wild
from sweeps import share

MEDIAN = 1.6
FAR = {"double": 2.0, "float": 12.0}
"""Largest factor from the worst error to the bound: median, and in 95 % of the cases.

In float squares of errors count near a joint singularity, where the sine has as few as twelve bits.
"""
COARSE = 2.0**-30
"""A unit whose errors are seen in long double one quantity at a time, and of which no square is."""
HAIR = 1e-4
"""Relative difference that the squares of errors make, and the rounding of long double."""

needs_compiler = pytest.mark.skipif(
    shutil.which("g++") is None or np.finfo(np.longdouble).eps > 2.0**-63, reason="no g++ with long double"
)


def ratios(precision: str, cases: int) -> np.ndarray:
    """Bound over worst error of every force, near a joint singularity in every other case."""
    rng = np.random.default_rng(21)
    found = []
    for number in range(cases):
        robot, motion = case(rng, number // 2) if number % 2 else drawn(rng, precision)[:2]
        try:
            pose = rounding.Pose(robot, motion, rounding.UNIT[precision])
            worst = np.array([pose.worst(force) for force in range(6)])
        except ValueError:
            continue
        found.append(worst[:, 1] / worst[:, 0])
    return np.concatenate(found)


@needs_compiler
@pytest.mark.slow
@pytest.mark.parametrize("precision", PRECISIONS)
def test_bound_is_above_the_worst_rounding_over_ten_thousand_poses(precision: str) -> None:
    found = ratios(precision, share(10_000, 300))
    assert found.min() >= 1
    assert np.median(found) <= MEDIAN
    assert np.percentile(found, 95) <= FAR[precision]


def poses(count: int) -> Iterator[rounding.Pose]:
    """Poses away from a joint singularity and near one, first moments of every size, some with wild rates."""
    rng = np.random.default_rng(22)
    while count:
        if count % 2:
            robot, motion = machine_in_motion(rng)
        else:
            robot, motion, sine = drawn(rng, "float")
            if sine > PATH:
                continue
        per_leg = {name: getattr(robot, name) * 10 ** rng.uniform(-3, 3, 6) for name in ("m_d", "m_u")}
        per_leg["r_u0"] = robot.r_u0 * 10 ** rng.uniform(-2, 2, (6, 3))
        robot = dataclasses.replace(robot, **per_leg)
        if count % 8 < 2:
            motion = wild(rng, robot, motion)[1]
        try:
            pose = rounding.Pose(robot, motion, COARSE)
            [pose.worst(force) for force in range(6)]
        except ValueError:
            continue
        count -= 1
        yield pose


def by_group(pose: rounding.Pose, group: int) -> float | None:
    """Bound over error when only one group rounds, of the force that feels it most; None if none does."""
    shares = pose.of_group[:, group] / pose.first_order
    if not (shares > 1e-9).any():
        return None
    error, bound = pose.worst(int(np.argmax(shares)), group)
    return bound / error


def by_strain(pose: rounding.Pose, entry: int) -> float:
    """The same when R is stretched by one entry of a symmetric matrix; the least of all forces."""
    strain = np.zeros((3, 3))
    strain.flat[entry] = 1.0
    found = [pose.stretched(force, np.maximum(strain, strain.T)) for force in range(6)]
    return min(bound / error for error, bound in found)


@pytest.mark.full
@pytest.mark.slow
@needs_compiler
def test_every_quantity_is_bounded_by_itself() -> None:
    seen = set()
    for pose in poses(2):
        for group, name in enumerate(rounding.groups()):
            found = by_group(pose, group)
            if found is not None:
                seen.add(name)
                assert found >= 1 - HAIR, name
        assert min(by_strain(pose, entry) for entry in range(9)) >= 1 - HAIR
    assert len(seen) > 200
