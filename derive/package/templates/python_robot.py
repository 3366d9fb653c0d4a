"""The numbers of $robot, from its robot file."""

from stewart_arrays import Robot


def robot() -> Robot:
    """$robot."""
    made = Robot()
$numbers
    return made
