"""Writes the C kit of one robot: the committed kernel, the robot's constants, an example that checks itself.

Takes a checked Robot; chooses the example's pose, has its forces computed, and has the files put in place all
at once or not at all. The texts are those of ``derive.emit.kit``; knows nothing of their syntax.
"""

import itertools
import math
import os
from collections.abc import Iterable
from importlib.metadata import version
from pathlib import Path
from typing import cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .conditioning import characteristic_length, scaled_condition_number
from .derive import notation
from .derive.block import Quantity
from .derive.emit import kit as texts
from .dynamics import Formulation, inverse_dynamics
from .kernel import c_sources, kernel_name
from .kinematics import inverse_kinematics
from .motion import Motion
from .publish import staged_folder
from .results import Forces
from .robot import Robot

Array = NDArray[np.float64]

GOOD_CONDITION = 50.0
MAX_CONDITION = 1000.0
MIN_SIN_POLE = 0.3
# Errors of the forces in float, over rounding unit, condition number and largest force, stay below a quarter.
TOLERANCE_FACTOR = 8.0

_DIRECTIONS = ((0, 0, 1), (0, 0, -1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))
# The rotation of the quaternion (20, 1, -2, 1) / sqrt(406): some 14 degrees.
_SLIGHT_TURN = np.array([[396, -44, -78], [36, 402, -44], [82, 36, 396]]) / 406


def write_kit(robot: Robot, directory: Path, formulation: str = "exact", force: bool = False) -> list[Path]:
    """Write the C kit of ``robot`` into ``directory``, made if missing, and return its files.

    The same robot, formulation and version give the same bytes. Files that are there already and equal stay;
    others of the kit's names are replaced only with ``force``; further files are left alone. When anything
    fails the folder is as it was before.

    Raises ValueError of one line: an unknown formulation, a robot without a pose for the example, a file that
    would be overwritten, a folder that cannot be written.
    """
    files = kit_files(robot, formulation)
    contents = {name: text.encode() for name, text in files.items()}
    try:
        changed = [name for name, content in contents.items() if _differs(directory / name, content, force)]
        if changed:
            with staged_folder(directory) as folder:
                for name in changed:
                    (folder / name).write_bytes(contents[name])
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(f"{error.filename or directory}: {reason}") from error
    return [directory / name for name in files]


def kit_files(robot: Robot, formulation: str = "exact") -> dict[str, str]:
    """File name -> text of the kit. Raises ValueError for an unknown formulation, or if no pose is good."""
    name = kernel_name(formulation, robot.base_joint)
    motion, forces, condition = sample(robot, formulation)
    largest = max(float(np.abs(values).max()) for values in (forces.F, forces.D, forces.x))
    checked = texts.Sample(
        motion={field: getattr(motion, field).tolist() for field in _names(notation.MOTION)},
        F=forces.F.tolist(),
        tolerance=float(_significant([TOLERANCE_FACTOR * condition * largest], 2)[0]),
    )
    numbers = {
        field: np.asarray(getattr(robot, field)).tolist()
        for field in _names(notation.LEG + notation.PLATFORM)
    }
    return {
        **c_sources(name),
        **texts.kit(robot.name, name, numbers, checked, version("stewart-sym")),
    }


def _names(quantities: Iterable[Quantity]) -> list[str]:
    return [quantity.name for quantity in quantities]


# --- the example's pose -----------------------------------------------------------------------


def sample(robot: Robot, formulation: str) -> tuple[Motion, Forces, float]:
    """The motion of the example, its forces and the condition number of H, moments over a length.

    The pose is a slight turn away from home, where the middle of the platform points is straight above the
    middle of the base points, 1.1 times the machine's radius away, and the frames are parallel; everything
    moves and is loaded. A machine that hangs, stands on a wall or has another frame on its platform gets
    another axis, distance or quarter turns: the first, in a fixed order, that solves with a good condition
    number, clear of the legs' universal axes and, if possible, within their length limits. Raises ValueError
    if there is none.
    """
    # NumPy, as it rounds like the C and is there without a compiler.
    around = _candidates(robot)
    status = _forces(robot, around, formulation).status
    poses = around[np.flatnonzero(status == 0)]
    if poses.shape != (0,):
        H = _forces(robot, poses, formulation).H
        condition = scaled_condition_number(H, characteristic_length(robot))
        clear, within = _leg_checks(robot, poses)
        for also in (within, True):
            for bound in (GOOD_CONDITION, MAX_CONDITION):
                good = np.flatnonzero(clear & also & (condition <= bound))
                if good.size:
                    motion = poses[int(good[0])]
                    return motion, _forces(robot, motion, formulation), float(condition[good[0]])
    raise ValueError(
        f"robot {robot.name!r}: no good pose for the example: wherever the platform is put, H is singular or "
        f"its condition number above {MAX_CONDITION:g}, or a leg is near its universal axis"
    )


def _forces(robot: Robot, motion: Motion, formulation: str) -> Forces:
    return inverse_dynamics(robot, motion, cast(Formulation, formulation), "numpy", "nan")


def _leg_checks(robot: Robot, poses: Motion) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """For each pose: are all legs clear of their universal axes, are all within their length limits."""
    legs = inverse_kinematics(robot, poses)
    sines = np.linalg.norm(np.cross(robot.k, legs.s), axis=-1)
    clear = (sines >= MIN_SIN_POLE).all(axis=-1) | (robot.base_joint == "spherical")
    within = np.clip(legs.L, *robot.length_limits.T) == legs.L
    return clear, within.all(axis=-1)


def _candidates(robot: Robot) -> Motion:
    """Motions around the base, (n,), the likeliest first, in numbers of few digits."""
    size = _significant([max(_radius(robot.b), _radius(robot.p))], 2)[0] or 1.0
    distances = [1.1 * size * 1.15**n for n in sorted(range(-8, 11), key=abs)]
    places = list(itertools.product(_quarter_turns(), _DIRECTIONS, distances))
    R = np.array([_SLIGHT_TURN @ turn for turn, _, _ in places])
    off = np.array([distance * np.array(direction) for _, direction, distance in places])
    t = robot.b.mean(axis=0) + off - R @ robot.p.mean(axis=0)
    return Motion(
        R,
        # Adding zero turns -0.0 into 0.0.
        np.round(t, 3 - math.floor(math.log10(size))) + 0.0,
        omega=np.array([0.3, -0.2, 0.4]),
        v=_significant(size * np.array([0.2, 0.3, -0.1]), 3),
        alpha=np.array([-0.5, 0.4, 0.7]),
        a=_significant(size * np.array([0.6, -0.4, 0.5]), 3),
        F_ext=_significant(robot.M * np.array([1.0, -2.0, 3.0]), 3),
        M_ext=_significant(robot.M * size * np.array([0.5, 0.3, -0.2]), 3),
    )


def _quarter_turns() -> list[Array]:
    """The 24 rotations that take the axes into each other, the identity first."""
    turns = []
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            turn = np.zeros((3, 3))
            turn[range(3), order] = signs
            if float(np.cross(turn[0], turn[1]) @ turn[2]) > 0.0:
                turns.append(turn)
    return turns


def _radius(points: Array) -> float:
    """Root mean square distance of points (6, 3) from their middle, m."""
    return float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=-1))))


def _significant(values: ArrayLike, digits: int) -> Array:
    """Values (n,) rounded to so many significant decimal digits."""
    return np.array([float(f"{value:.{digits - 1}e}") for value in np.asarray(values)])


# --- files ------------------------------------------------------------------------------------


def _differs(path: Path, content: bytes, force: bool) -> bool:
    """Whether the file has to be written. ValueError if that takes ``force`` or is out of the question."""
    if not os.path.lexists(path):
        return True
    if path.is_dir():
        raise ValueError(f"{path}: expected a file or nothing, found a folder")
    if path.exists() and path.read_bytes() == content:
        return False
    if not force:
        raise ValueError(f"{path}: exists with other content; use --force to overwrite")
    return True
