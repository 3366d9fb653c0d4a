"""Engines of forward dynamics for ``bench``, Pinocchio and MuJoCo, those of them that are installed.

Each closes the five loops of ``peers_tree`` by constraints and is called from Python, one pose a call, its
state prepared; a call over a model without bodies tells what the call costs. Times nothing.
"""

from ...io.extras import absent
from ...robot.robot import Robot
from .peers_tree import Engine, Tree


def engines(robot: Robot, tree: Tree) -> tuple[Engine, ...]:
    """Build every engine that is installed for the poses of the tree."""
    found = []
    if not absent("pinocchio"):
        from .peers_constraints_pinocchio import pinocchio_engine

        found.append(pinocchio_engine(robot, tree))
    if not absent("mujoco"):
        from .peers_constraints_mujoco import mujoco_engine

        found.append(mujoco_engine(robot, tree))
    return tuple(found)
