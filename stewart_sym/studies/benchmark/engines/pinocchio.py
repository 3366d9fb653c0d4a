"""Pinocchio candidates of ``benchmark`` for the forces and for the equations of motion.

Forces are computed by recursive Newton-Euler for the tree of the machine and a 6x6 solve, and forward
dynamics by ``constraintDynamics``.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from ....io.array_types import Array
from ....io.extras import needed_for
from ....motion.motion import Motion
from ....motion.rotation import quaternion_from_rotation
from ....robot.robot import Robot
from ...common.timing import over
from ..baselines import Called
from .tree import (
    CARRIER,
    States,
    Tree,
    base_frames,
    forward_dynamics,
    newton_euler,
    states,
    turned_back,
)

with needed_for("the comparison with Pinocchio"):
    import pinocchio as pin


_W_LAST = [1, 2, 3, 0]


def pinocchio_rnea(robot: Robot, motion: Motion) -> Called:
    """Measure ``rnea`` at poses (n,); base joints must be universal."""
    model, upper = _model_of_legs(robot)
    platform = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "platform")
    model.appendBodyToJoint(platform, pin.Inertia(robot.M, robot.R_0, robot.I_p), pin.SE3.Identity())
    data, nothing = model.createData(), pin.Model()
    none = (*3 * (np.zeros(0),), _forces(1))
    at = states(robot, motion)
    prepared = _prepared(at, model.njoints, upper)
    run = over(partial(pin.rnea, model, data), prepared)
    empty = over(partial(pin.rnea, nothing, nothing.createData()), [none] * len(prepared))
    tau = np.array([pin.rnea(model, data, *state) for state in prepared])
    rates = np.array([np.kron(np.eye(2), R.T) for R in motion.R])
    return newton_euler("Pinocchio", "rnea", robot, at, tau, rates, run, empty)


def _model_of_legs(robot: Robot) -> tuple[Any, list[int]]:
    """Build six chains, revolute about k and y, prismatic along s; return joints of upper parts.

    The joint of a lower part precedes the joint of its upper part.
    """
    model, here = pin.Model(), pin.SE3.Identity()
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    uppers = []
    for i, frame in enumerate(base_frames(robot)):
        first = model.addJoint(0, pin.JointModelRX(), pin.SE3(frame, robot.b[i]), f"fixed axis {i + 1}")
        lower = model.addJoint(first, pin.JointModelRY(), here, f"moving axis {i + 1}")
        upper = model.addJoint(lower, pin.JointModelPX(), here, f"actuator {i + 1}")
        model.appendBodyToJoint(lower, pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), here)
        model.appendBodyToJoint(upper, pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), here)
        uppers.append(upper)
    return model, uppers


def _prepared(at: States, joints: int, upper: list[int]) -> list[tuple[Any, ...]]:
    """Prepare the arguments of ``rnea`` for every pose: q, v, a, and external forces in body frames."""
    motion, legs = at.motion, at.legs
    R, omega, count = motion.R, motion.omega, len(motion.R)
    quaternions = quaternion_from_rotation(R)[:, _W_LAST]
    q = np.hstack([legs.coordinates.reshape(count, -1), motion.t, quaternions])
    v = np.hstack([legs.rates.reshape(count, -1), turned_back(R, motion.v), turned_back(R, omega)])
    # Pinocchio's spatial acceleration differs from the acceleration of the reference point by omega x v.
    platform = [turned_back(R, motion.a - np.cross(omega, motion.v)), turned_back(R, motion.alpha)]
    a = np.hstack([at.accelerations.reshape(count, -1), *platform])
    below, above = turned_back(legs.upper, at.lower), turned_back(legs.upper, at.upper)
    moment = motion.M_ext + turned_back(R, at.platform)
    found = []
    for i, state in enumerate(zip(q, v, a, strict=True)):
        forces = _forces(joints)
        for leg, joint in enumerate(upper):
            forces[joint - 1] = pin.Force(np.zeros(3), below[i, leg])
            forces[joint] = pin.Force(np.zeros(3), above[i, leg])
        forces[joints - 1] = pin.Force(motion.F_ext[i], moment[i])
        found.append((*state, forces))
    return found


def _forces(count: int) -> Any:
    forces = pin.StdVec_Force()
    for _ in range(count):
        forces.append(pin.Force.Zero())
    return forces


def pinocchio_engine(robot: Robot, tree: Tree) -> Called:
    """Measure ``constraintDynamics`` with five rigid point constraints and one step of its proximal
    solver.
    """
    solve, of_machine = _solver(*_closed_model(robot))
    nothing, of_nothing = _solver(pin.Model(), [])
    quaternions = quaternion_from_rotation(tree.relative)[:, _W_LAST]
    coordinates = tree.legs.coordinates.reshape(len(quaternions), -1)
    states = [
        (*state, *of_machine)
        for state in zip(np.hstack([coordinates, quaternions]), tree.rates, tree.forces, strict=True)
    ]
    none = [(*3 * (np.zeros(0),), *of_nothing)] * len(states)
    run, empty = over(solve, states), over(nothing, none)

    def joints() -> Array:
        return np.array([solve(*state) for state in states])

    return forward_dynamics("Pinocchio", "constraintDynamics, 5 loops", tree, run, empty, joints, 1e-6)


def _solver(model: Any, constraints: Sequence[Any]) -> tuple[Callable[..., Any], tuple[Any, ...]]:
    """Return ``constraintDynamics`` of a model, which takes the state, and its further arguments."""
    models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for constraint in constraints:
        models.append(constraint)
        datas.append(constraint.createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, models, datas)
    settings = pin.ProximalSettings(1e-12, 1e-12, 1)
    return partial(pin.constraintDynamics, model, data), (models, datas, settings)


def _closed_model(robot: Robot) -> tuple[Any, list[Any]]:
    here = pin.SE3.Identity()
    model, uppers = _model_of_legs(robot)
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
