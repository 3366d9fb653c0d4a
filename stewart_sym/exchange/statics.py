"""Actuator forces that hold a model at rest, by virtual work of its bodies."""

from collections.abc import Sequence

import numpy as np

from ..io.array_types import Array
from ..motion.rotation import cross
from .model import Joint
from .topology import Machine, Step

_SINGULAR = 1e8
"""Condition number (m and rad) of a pose in which the forces are not determined."""


def slide_forces(machine: Machine, joints: Sequence[Joint], g: Array, loaded: bool = False) -> Array:
    """Compute the forces at rest in the pose of the file, along the slides from base to platform (N), (6,).

    With ``loaded``, the loads of the joints act, too. Raises LinAlgError in a singular pose.
    """
    platform, zero = machine.bodies[machine.platform], np.zeros(3)
    work = _wrench(platform.mass * g, zero, platform.placed(platform.center))
    rates = []
    for leg in machine.legs:
        steps = (*leg.base, leg.slide, *leg.tip)
        each = [_twists(machine, step) for step in steps]
        columns = np.hstack(each)
        if np.linalg.cond(columns) > _SINGULAR:
            raise np.linalg.LinAlgError("singular pose")
        # Rates of the joints per twist of the platform; the spin of a leg between spherical joints is free.
        split = np.split(np.linalg.pinv(columns), np.cumsum([len(twists.T) for twists in each])[:-1])
        rates.append(split[len(leg.base)][0])
        twist = np.zeros((6, 6))
        for step, twists, rate in zip(steps, each, split, strict=True):
            twist = twist + twists @ rate
            body = machine.bodies[step.reached]
            if step.reached != machine.platform:
                work += _wrench(body.mass * g, zero, body.placed(body.center)) @ twist
            if loaded:
                load = _wrench(step.joint.load[:3], step.joint.load[3:], machine.place(step)) @ twists @ rate
                work += load if step.forward else -load
    if loaded:
        for joint in joints:
            if joint.kind == "free":
                point = machine.placed[joint.child].placed(joint.point)
                work += _wrench(joint.load[:3], joint.load[3:], point)
    if np.linalg.cond(rates) > _SINGULAR:
        raise np.linalg.LinAlgError("singular pose")
    return np.asarray(np.linalg.solve(np.array(rates).T, -work), dtype=np.float64)


def _twists(machine: Machine, step: Step) -> Array:
    """Return the twists of a joint for unit rates, shape (6, n).

    A twist is the velocity of the point of a body at the origin, and the angular velocity.
    """
    axes = step.axes if len(step.axes) else np.eye(3)
    if step.joint.kind == "prismatic":
        return np.vstack([axes.T, np.zeros((3, 1))])
    return np.vstack([cross(machine.place(step), axes).T, axes.T])


def _wrench(force: Array, moment: Array, point: Array) -> Array:
    """Return force and moment about the origin, shape (6,), of a force and a moment at a point."""
    return np.concatenate([force, moment + cross(point, force)])
