"""Engines of forward dynamics for ``bench``, Pinocchio and MuJoCo, those of them that are installed.

Each closes the five loops of ``tree`` by constraints and is called from Python, one pose per
call, its state prepared; a call over a model without bodies shows what the call costs.
"""

from ....io.extras import absent
from ....robot.robot import Robot
from .tree import Engine, Tree


def engines(robot: Robot, tree: Tree) -> tuple[Engine, ...]:
    """Build every engine that is installed for the poses of the tree."""
    found = []
    if not absent("pinocchio"):
        from .pinocchio_constraints import pinocchio_engine

        found.append(pinocchio_engine(robot, tree))
    if not absent("mujoco"):
        from .mujoco_constraints import mujoco_engine

        found.append(mujoco_engine(robot, tree))
    return tuple(found)
