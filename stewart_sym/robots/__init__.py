"""Robots that come with the package; each is a robot file in this folder and a function that loads it."""

from importlib import resources

from ..robot.robot import Robot


def dasgupta1998() -> Robot:
    """Load the paper's test manipulator (appendix), as printed.

    None of its three printed inertia tensors belongs to a rigid body; the file accepts that, so there is no
    warning; ``physicality()`` lists them.
    """
    with resources.as_file(resources.files(__name__) / "dasgupta1998.toml") as path:
        return Robot.from_toml(path)
