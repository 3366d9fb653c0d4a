"""Forward dynamics by Pinocchio's ``constraintDynamics``, as a baseline of the equations of motion."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from ....io.extras import needed_for
from ....motion.rotation import quaternion_from_rotation
from ....robot.robot import Robot
from ...common.timing import over
from .pinocchio_rnea import QUATERNION_W_LAST, model_of_legs
from .tree import CARRIER, Engine, Tree

with needed_for("the comparison with Pinocchio"):
    import pinocchio as pin


def pinocchio_engine(robot: Robot, tree: Tree) -> Engine:
    """``constraintDynamics``: the five points as rigid constraints, one step of its proximal solver."""
    solve, of_machine = _solver(*_pinocchio_model(robot))
    nothing, of_nothing = _solver(pin.Model(), [])
    quaternions = quaternion_from_rotation(tree.relative)[:, QUATERNION_W_LAST]
    joints = tree.legs.coordinates.reshape(len(quaternions), -1)
    states = [
        (*state, *of_machine)
        for state in zip(np.hstack([joints, quaternions]), tree.rates, tree.forces, strict=True)
    ]
    none = [(*3 * (np.zeros(0),), *of_nothing)] * len(states)
    return Engine(
        "Pinocchio",
        "constraintDynamics, 5 loops",
        over(solve, states),
        over(nothing, none),
        lambda: tree.accelerations(np.array([solve(*state) for state in states])),
        1e-6,
    )


def _solver(model: Any, constraints: Sequence[Any]) -> tuple[Callable[..., Any], tuple[Any, ...]]:
    """``constraintDynamics`` of a model, which takes the state and then the arguments given with it."""
    models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for constraint in constraints:
        models.append(constraint)
        datas.append(constraint.createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, models, datas)
    settings = pin.ProximalSettings(1e-12, 1e-12, 1)
    return partial(pin.constraintDynamics, model, data), (models, datas, settings)


def _pinocchio_model(robot: Robot) -> tuple[Any, list[Any]]:
    here = pin.SE3.Identity()
    model, uppers = model_of_legs(robot)
    platform = model.addJoint(uppers[CARRIER], pin.JointModelSpherical(), here, "platform")
    carried = robot.p[CARRIER]
    model.appendBodyToJoint(platform, pin.Inertia(robot.M, robot.R_0 - carried, robot.I_p), here)
    constraints = [
        pin.RigidConstraintModel(
            pin.ContactType.CONTACT_3D,
            model,
            upper,
            here,
            platform,
            pin.SE3(np.eye(3), point - carried),
            pin.ReferenceFrame.LOCAL,
        )
        for upper, point in zip(uppers[:CARRIER], robot.p, strict=False)
    ]
    return model, constraints
