"""Drake candidate of ``benchmark``: ``CalcInverseDynamics`` for the tree of the machine, then a 6x6 solve.

Gravity, load, and friction are prepared as body forces, because the call takes them in this form.
"""

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
from .tree import States, base_frames, newton_euler, states, turned

with needed_for("the comparison with Drake"):
    from pydrake.math import RigidTransform, RotationMatrix
    from pydrake.multibody import tree
    from pydrake.multibody.math import SpatialForce
    from pydrake.multibody.plant import MultibodyPlant


def drake_inverse(robot: Robot, motion: Motion) -> Called:
    """Measure ``CalcInverseDynamics`` at poses (n,); base joints must be universal."""
    plant, nothing = _plant(robot), _finished(MultibodyPlant(0.0))
    context, no_context = plant.CreateDefaultContext(), nothing.CreateDefaultContext()
    at = states(robot, motion)
    prepared = _prepared(plant, at)
    none = [(np.zeros(0), np.zeros(0), tree.MultibodyForces(nothing))] * len(prepared)
    tau = np.array([_tau(plant, context, *state) for state in prepared])
    rates = np.broadcast_to(np.roll(np.eye(6), 3, axis=0), (len(prepared), 6, 6))
    run = over(partial(_tau, plant, context), prepared)
    empty = over(partial(_tau, nothing, no_context), none)
    return newton_euler("Drake", "CalcInverseDynamics", robot, at, tau, rates, run, empty)


def _tau(plant: Any, context: Any, state: Array, second: Array, forces: Any) -> Any:
    """Compute one pose; the state is set first, because Drake caches the results of the last state."""
    plant.SetPositionsAndVelocities(context, state)
    return plant.CalcInverseDynamics(context, second, forces)


def _plant(robot: Robot) -> Any:
    """Build six chains, universal about k and y, prismatic along s, and the platform.

    A universal joint is faster in Drake than two revolute joints with a body between them.
    """
    plant = MultibodyPlant(0.0)
    plant.mutable_gravity_field().set_gravity_vector(robot.g)
    for i, frame in enumerate(base_frames(robot)):
        name, place = str(i + 1), RigidTransform(RotationMatrix(frame), robot.b[i])
        lower = plant.AddRigidBody(f"lower {name}", _inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]))
        upper = plant.AddRigidBody(f"upper {name}", _inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]))
        base = plant.AddFrame(tree.FixedOffsetFrame(f"base {name}", plant.world_frame(), place))
        plant.AddJoint(tree.UniversalJoint(f"axes {name}", base, lower.body_frame()))
        ends = lower.body_frame(), upper.body_frame()
        plant.AddJoint(tree.PrismaticJoint(f"actuator {name}", *ends, [1.0, 0.0, 0.0]))
    plant.AddRigidBody("platform", _inertia(robot.M, robot.R_0, robot.I_p))
    return _finished(plant)


def _finished(plant: Any) -> Any:
    plant.Finalize()
    return plant


def _inertia(mass: float, center: Array, inertia: Array) -> Any:
    """Return an unvalidated inertia, because no rigid body can have the tensors of the paper."""
    if mass == 0:
        return tree.SpatialInertia.Zero()
    unit = inertia / mass + center @ center * np.eye(3) - np.outer(center, center)
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = unit
    about_origin = tree.UnitInertia(xx, yy, zz, xy, xz, yz)
    return tree.SpatialInertia(mass, center, about_origin, skip_validity_check=True)


def _prepared(plant: Any, at: States) -> list[tuple[Any, ...]]:
    """Prepare the arguments for every pose: positions with rates, accelerations, and body forces."""
    motion, legs = at.motion, at.legs
    count = len(motion.R)
    q = [legs.coordinates.reshape(count, -1), quaternion_from_rotation(motion.R), motion.t]
    v = [legs.rates.reshape(count, -1), motion.omega, motion.v]
    second = np.hstack([at.accelerations.reshape(count, -1), motion.alpha, motion.a])
    force = turned(motion.R, motion.F_ext)
    moment = turned(motion.R, motion.M_ext) + at.platform
    names = [f"{part} {leg + 1}" for part in ("lower", "upper") for leg in range(6)]
    bodies = [plant.GetBodyByName(name) for name in (*names, "platform")]
    moments = np.concatenate([at.lower, at.upper, moment[:, None]], axis=1)
    forces = np.concatenate([np.zeros((count, 12, 3)), force[:, None]], axis=1)
    context, found = plant.CreateDefaultContext(), []
    for i, state in enumerate(np.hstack([*q, *v])):
        plant.SetPositionsAndVelocities(context, state)
        given = tree.MultibodyForces(plant)
        plant.CalcForceElementsContribution(context, given)
        for body, turning, pushing in zip(bodies, moments[i], forces[i], strict=True):
            body.AddInForceInWorld(context, SpatialForce(turning, pushing), given)
        found.append((state, second[i], given))
    return found
