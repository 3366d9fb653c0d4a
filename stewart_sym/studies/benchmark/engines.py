"""Pinocchio and MuJoCo in ``benchmark``: inverse dynamics by a solve, and forward dynamics with five loops.

Joint coordinates, rates, accelerations, and generalized forces are prepared before the timing. A call for a
model without bodies measures the overhead of the call from Python.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from ...io.array_types import Array
from ...io.extras import absent
from ...motion.rotation import quaternion_from_rotation
from ...robot.robot import Robot
from ..common.timing import Task, over
from .case import EQUATIONS, FORCES, Case, Poses
from .joint_tree import CARRIER, SLIDES, JointTree, base_frames, joint_tree

_SOLVED = 1024
"""Number of systems in one call of the solve, so that the overhead of the call is negligible."""

STIFFNESS = 1e7
"""Ratio of MuJoCo's acceleration of a constrained point to the gap of the constraint (1/s^2)."""

_CORRECTIONS = 3
"""Number of corrections of MuJoCo's joint coordinates; each reduces the error to a small fraction."""


def inverse_engines(poses: Poses, expected: Array) -> Iterator[Case]:
    """Yield the installed engines that compute the actuator forces; ``expected`` are forces, (n, 6)."""
    if absent("pinocchio"):
        return
    import pinocchio as pin

    tree = joint_tree(poses.robot, poses.motion)
    model, _ = _pinocchio_model(poses.robot)
    data, nothing = model.createData(), pin.Model()
    states = list(zip(_positions(tree), tree.rates, tree.accelerations, strict=True))
    # The actuator forces are solutions of 6x6 systems.
    tau = np.array([pin.rnea(model, data, *state) for state in states])
    several = np.resize(np.arange(len(tau)), _SOLVED)
    matrices = np.swapaxes(tree.per_twist[:, SLIDES], -1, -2)[several]
    right = np.einsum("nji,nj->ni", tree.per_twist, tau - tree.resistance)[several, :, None]
    empty = over(partial(pin.rnea, nothing, nothing.createData()), [3 * (np.zeros(0),)] * len(states))
    task = Task(over(partial(pin.rnea, model, data), states), len(states))
    solve = Task(over(np.linalg.solve, [(matrices, right)]), _SOLVED)
    more: Any = {"package": "Pinocchio", "others": {solve: 1.0, Task(empty, len(states)): -1.0}}

    def found() -> Array:
        return np.asarray(np.linalg.solve(matrices, right)[: len(tau), :, 0])

    yield Case(FORCES, "Pinocchio", "rnea + solve - call", task, found, expected, **more)


def forward_engines(poses: Poses, F: Array, expected: Array) -> Iterator[Case]:
    """Yield the installed engines that compute [a; alpha], shape (n, 6), from the actuator forces F (N)."""
    tree = joint_tree(poses.robot, poses.motion)
    forces = tree.resistance.copy()
    forces[:, SLIDES] += F
    for name, what, engine, tolerance in (
        ("Pinocchio", "constraintDynamics", _constraint_dynamics, 1e-6),
        ("MuJoCo", "mj_forward", _mj_forward, 1e-4),
    ):
        if not absent(name.lower()):
            *calls, joints = engine(poses.robot, tree, forces)
            run, empty = (Task(call, len(expected)) for call in calls)
            found = partial(lambda joints: tree.platform_acceleration(joints()), joints)
            more: Any = {"tolerance": tolerance, "package": name, "others": {empty: -1.0}}
            row, what = f"forward dynamics, {name}", f"{what}, 5 loops - call"
            yield Case(EQUATIONS, row, what, run, found, expected, **more)


Engine = tuple[Callable[[int], None], Callable[[int], None], Callable[[], Array]]
"""Calls for all poses and for an empty model, and the function that returns the joint accelerations."""

# --- Pinocchio --------------------------------------------------------------------------------


def _constraint_dynamics(robot: Robot, tree: JointTree, forces: Array) -> Engine:
    """Call ``constraintDynamics`` with rigid constraints and one step of its proximal solver."""
    import pinocchio as pin

    def solver(model: Any, constraints: list[Any]) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        models = pin.StdVec_RigidConstraintModel(constraints)
        datas = pin.StdVec_RigidConstraintData([each.createData() for each in constraints])
        data = model.createData()
        pin.initConstraintDynamics(model, data, models, datas)
        more = models, datas, pin.ProximalSettings(1e-12, 1e-12, 1)
        return partial(pin.constraintDynamics, model, data), more

    solve, more = solver(*_pinocchio_model(robot))
    nothing, no_more = solver(pin.Model(), [])
    states = [(*state, *more) for state in zip(_positions(tree), tree.rates, forces, strict=True)]
    empty = over(nothing, [(*3 * (np.zeros(0),), *no_more)] * len(states))
    return over(solve, states), empty, lambda: np.array([solve(*state) for state in states])


def _positions(tree: JointTree) -> Array:
    return np.hstack([tree.coordinates, np.roll(tree.quaternion, -1, axis=1)])


def _pinocchio_model(robot: Robot) -> tuple[Any, list[Any]]:
    """Return the tree of the machine and the constraints that close its loops."""
    import pinocchio as pin

    model, here, uppers = pin.Model(), pin.SE3.Identity(), []
    model.gravity = pin.Motion(robot.g, np.zeros(3))
    for i, frame in enumerate(base_frames(robot)):
        first = model.addJoint(0, pin.JointModelRX(), pin.SE3(frame, robot.b[i]), f"fixed axis {i + 1}")
        lower = model.addJoint(first, pin.JointModelRY(), here, f"moving axis {i + 1}")
        upper = model.addJoint(lower, pin.JointModelPX(), here, f"actuator {i + 1}")
        model.appendBodyToJoint(lower, pin.Inertia(robot.m_d[i], robot.r_d0[i], robot.I_d0[i]), here)
        model.appendBodyToJoint(upper, pin.Inertia(robot.m_u[i], robot.r_u0[i], robot.I_u0[i]), here)
        uppers.append(upper)
    carried = robot.p[CARRIER]
    platform = model.addJoint(uppers[CARRIER], pin.JointModelSpherical(), here, "platform")
    model.appendBodyToJoint(platform, pin.Inertia(robot.M, robot.R_0 - carried, robot.I_p), here)
    contact, local = pin.ContactType.CONTACT_3D, pin.ReferenceFrame.LOCAL
    points = (pin.SE3(np.eye(3), point - carried) for point in robot.p)
    constraints = [
        pin.RigidConstraintModel(contact, model, upper, here, platform, point, local)
        for upper, point in zip(uppers[:CARRIER], points, strict=False)
    ]
    return model, constraints


# --- MuJoCo -----------------------------------------------------------------------------------


def _mj_forward(robot: Robot, tree: JointTree, forces: Array) -> Engine:
    """Call ``mj_forward`` with five ``connect`` constraints and one dense Newton step.

    The constraints yield in proportion to their force. In compensation the legs are moved by nanometers in
    advance, so that the springs of the constraints supply the missing force.
    """
    import mujoco

    model, nothing = _mujoco_model(robot), mujoco.MjModel.from_xml_string(_OPTIONS)
    datas = [mujoco.MjData(model) for _ in forces]
    for data, quaternion, rates, of_pose in zip(datas, tree.quaternion, tree.rates, forces, strict=True):
        data.qpos[-4:], data.qvel[:], data.qfrc_applied[:] = quaternion, rates, of_pose
    forward = over(mujoco.mj_forward, [(model, data) for data in datas])
    empty = over(mujoco.mj_forward, [(nothing, mujoco.MjData(nothing)) for _ in datas])

    def joints() -> Array:
        forward(1)
        return np.array([data.qacc for data in datas])

    moves, places = np.zeros((len(datas), CARRIER, 3)), tree.coordinates.reshape(-1, 6, 3).copy()
    for correction in range(1 + _CORRECTIONS):
        moves += tree.gaps(joints()) / STIFFNESS if correction else 0.0
        closed = np.linalg.solve(tree.jacobian[:, :CARRIER], moves[..., None])[..., 0]
        for data, place, by in zip(datas, places, closed, strict=True):
            data.qpos[:-4] = place.ravel()
            data.qpos[: 3 * CARRIER] += by.ravel()
    return forward, empty, joints


def _mujoco_model(robot: Robot) -> Any:
    """Return the machine; sites are the constrained points."""
    import mujoco

    spec = mujoco.MjSpec.from_string(_OPTIONS)
    spec.option.gravity = robot.g
    slide, hinge, ball = (getattr(mujoco.mjtJoint, f"mjJNT_{name}") for name in ("SLIDE", "HINGE", "BALL"))
    x, y = np.eye(3)[:2]

    def body(parent: Any, mass: Any, center: Array, inertia: Array, joints: Any, **place: Any) -> Any:
        tensor = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        made = parent.add_body(mass=mass, ipos=center, fullinertia=tensor, explicitinertial=True, **place)
        for kind, axis in joints:
            made.add_joint(type=kind, axis=axis)
        return made

    uppers = []
    for i, quaternion in enumerate(quaternion_from_rotation(base_frames(robot))):
        place: Any = {"joints": [(hinge, x), (hinge, y)], "pos": robot.b[i], "quat": quaternion}
        lower = body(spec.worldbody, robot.m_d[i], robot.r_d0[i], robot.I_d0[i], **place)
        uppers.append(body(lower, robot.m_u[i], robot.r_u0[i], robot.I_u0[i], [(slide, x)]))
    carried = robot.p[CARRIER]
    platform = body(uppers[CARRIER], robot.M, robot.R_0 - carried, robot.I_p, [(ball, x)])
    closure: Any = {"type": mujoco.mjtEq.mjEQ_CONNECT, "objtype": mujoco.mjtObj.mjOBJ_SITE}
    closure |= {"solref": (-STIFFNESS, 0.0), "solimp": (mujoco.mjMAXIMP, mujoco.mjMAXIMP, 1.0, 0.5, 2.0)}
    for i, upper in enumerate(uppers[:CARRIER]):
        upper.add_site(name=f"tip{i}")
        platform.add_site(name=f"point{i}", pos=robot.p[i] - carried)
        spec.add_equality(name1=f"tip{i}", name2=f"point{i}", **closure)
    return spec.compile()


_OPTIONS = """<mujoco>
  <option gravity="0 0 0" solver="Newton" jacobian="dense" iterations="1" tolerance="0">
    <flag contact="disable" sensor="disable" warmstart="disable" island="disable"/>
  </option>
  <size memory="1M"/>
</mujoco>"""
"""MuJoCo's fastest solver, without warm start and unrequested computations."""
