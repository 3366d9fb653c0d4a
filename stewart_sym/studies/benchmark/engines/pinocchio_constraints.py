"""Forward dynamics by Pinocchio's ``constraintDynamics``, for ``constraints``."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ....io.array_types import Array
from ....io.extras import needed_for
from ....motion.rotation import quaternion_from_rotation
from ....robot.robot import Robot
from .pinocchio_rnea import QUATERNION_W_LAST, model_of_legs
from .tree import CARRIER, Engine, Tree

with needed_for("the comparison with Pinocchio"):
    import pinocchio as pin


def pinocchio_engine(robot: Robot, tree: Tree) -> Engine:
    """``constraintDynamics``: the five points as rigid constraints, one step of its proximal solver."""
    machine = _constrained(*_pinocchio_model(robot))
    nothing = _constrained(pin.Model(), [])
    quaternions = quaternion_from_rotation(tree.relative)[:, QUATERNION_W_LAST]
    joints = tree.legs.coordinates.reshape(len(quaternions), -1)
    states = list(zip(np.hstack([joints, quaternions]), tree.rates, tree.forces, strict=True))
    none = [3 * (np.zeros(0),) for _ in states]

    def found() -> Array:
        solve, (model, data, *rest) = pin.constraintDynamics, machine
        return tree.accelerations(np.array([solve(model, data, *state, *rest) for state in states]))

    return Engine(
        "Pinocchio",
        "constraintDynamics, 5 loops",
        lambda repeats: _solved(repeats, machine, states),
        lambda repeats: _solved(repeats, nothing, none),
        found,
        1e-6,
    )


def _solved(repeats: int, machine: tuple[Any, ...], states: Sequence[tuple[Array, ...]]) -> None:
    solve, (model, data, constraints, found, settings) = pin.constraintDynamics, machine
    for _ in range(repeats):
        for q, v, tau in states:
            solve(model, data, q, v, tau, constraints, found, settings)


def _constrained(model: Any, constraints: Sequence[Any]) -> tuple[Any, ...]:
    """Arguments of ``constraintDynamics`` but for the state."""
    models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for constraint in constraints:
        models.append(constraint)
        datas.append(constraint.createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, models, datas)
    return model, data, models, datas, pin.ProximalSettings(1e-12, 1e-12, 1)


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
