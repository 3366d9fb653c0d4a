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
from .case import EQUATIONS, FORCES, Case
from .joint_tree import CARRIER, SLIDES, JointTree, base_frames, joint_tree
from .poses import Poses

_SOLVED = 1024
"""Number of systems in one call of the solve, so that the overhead of the call is negligible."""

STIFFNESS = 1e7
"""Ratio of MuJoCo's acceleration of a constrained point to the gap of the constraint (1/s^2)."""

_CORRECTIONS = 3
"""Number of corrections of MuJoCo's joint coordinates; each reduces the error to a small fraction."""


def inverse_engines(poses: Poses, expected: Array) -> Iterator[Case]:
    """Yield the installed engines that compute the actuator forces; ``expected`` are forces, (n, 6)."""
    if not absent("pinocchio"):
        yield _rnea(poses, joint_tree(poses.robot, poses.motion), expected)


def forward_engines(poses: Poses, F: Array, expected: Array) -> Iterator[Case]:
    """Yield the installed engines that compute [a; alpha], shape (n, 6), from the actuator forces F (N)."""
    tree = joint_tree(poses.robot, poses.motion)
    forces = tree.resistance.copy()
    forces[:, SLIDES] += F
    if not absent("pinocchio"):
        yield _constraint_dynamics(poses.robot, tree, forces, expected)
    if not absent("mujoco"):
        yield _mj_forward(poses.robot, tree, forces, expected)


def _forward_case(
    name: str,
    what: str,
    tree: JointTree,
    calls: tuple[Callable[[int], None], Callable[[int], None]],
    joints: Callable[[], Array],
    expected: Array,
    tolerance: float,
) -> Case:
    """Return the case of an engine: calls for all poses and for an empty model, and joint accelerations."""
    run, empty = (Task(call, len(expected)) for call in calls)
    more: Any = {"tolerance": tolerance, "package": name, "minus": empty}

    def found() -> Array:
        return tree.platform_acceleration(joints())

    return Case(EQUATIONS, f"forward dynamics, {name}", f"{what} - call", run, found, expected, **more)


# --- Pinocchio --------------------------------------------------------------------------------


def _rnea(poses: Poses, tree: JointTree, expected: Array) -> Case:
    """Measure ``rnea`` for the tree, and the solution of 6x6 systems for the actuator forces."""
    import pinocchio as pin

    model, _ = _pinocchio_model(poses.robot)
    data, nothing = model.createData(), pin.Model()
    states = list(zip(_positions(tree), tree.rates, tree.accelerations, strict=True))
    tau = np.array([pin.rnea(model, data, *state) for state in states])
    several = np.resize(np.arange(len(tau)), _SOLVED)
    matrices = np.swapaxes(tree.per_twist[:, SLIDES], -1, -2)[several]
    right = np.einsum("nji,nj->ni", tree.per_twist, tau - tree.resistance)[several, :, None]
    empty = over(partial(pin.rnea, nothing, nothing.createData()), [3 * (np.zeros(0),)] * len(states))
    task = Task(over(partial(pin.rnea, model, data), states), len(states))
    solve = Task(over(np.linalg.solve, [(matrices, right)]), _SOLVED)
    more: Any = {"package": "Pinocchio", "plus": solve, "minus": Task(empty, len(states))}

    def found() -> Array:
        return np.asarray(np.linalg.solve(matrices, right)[: len(tau), :, 0])

    return Case(FORCES, "Pinocchio", "rnea + solve - call", task, found, expected, **more)


def _constraint_dynamics(robot: Robot, tree: JointTree, forces: Array, expected: Array) -> Case:
    """Measure ``constraintDynamics`` with rigid constraints and one step of its proximal solver."""
    import pinocchio as pin

    def solver(model: Any, constraints: list[Any]) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        models, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
        for constraint in constraints:
            models.append(constraint)
            datas.append(constraint.createData())
        data = model.createData()
        pin.initConstraintDynamics(model, data, models, datas)
        more = models, datas, pin.ProximalSettings(1e-12, 1e-12, 1)
        return partial(pin.constraintDynamics, model, data), more

    solve, more = solver(*_pinocchio_model(robot))
    nothing, no_more = solver(pin.Model(), [])
    states = [(*state, *more) for state in zip(_positions(tree), tree.rates, forces, strict=True)]
    calls = over(solve, states), over(nothing, [(*3 * (np.zeros(0),), *no_more)] * len(states))

    def joints() -> Array:
        return np.array([solve(*state) for state in states])

    what = "constraintDynamics, 5 loops"
    return _forward_case("Pinocchio", what, tree, calls, joints, expected, 1e-6)


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


def _mj_forward(robot: Robot, tree: JointTree, forces: Array, expected: Array) -> Case:
    """Measure ``mj_forward`` with five ``connect`` constraints and one dense Newton step.

    The constraints yield in proportion to their force. In compensation the legs are moved by nanometers in
    advance, so that the springs of the constraints supply the missing force.
    """
    import mujoco

    model = mujoco.MjModel.from_xml_string(_xml(robot, mujoco.mjMAXIMP))
    nothing = mujoco.MjModel.from_xml_string(f"<mujoco>{_option(np.zeros(3))}</mujoco>")
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
    return _forward_case("MuJoCo", "mj_forward, 5 loops", tree, (forward, empty), joints, expected, 1e-4)


def _xml(robot: Robot, stiff: float) -> str:
    """Format the machine as an MJCF model; sites are the constrained points."""
    carried, quaternions = robot.p[CARRIER], quaternion_from_rotation(base_frames(robot))
    points = (f'<site name="point{i}" pos="{_text(robot.p[i] - carried)}"/>' for i in range(CARRIER))
    platform = _body('<joint type="ball"/>', robot.M, robot.R_0 - carried, robot.I_p, "".join(points))
    slide = '<joint type="slide" axis="1 0 0"/>'
    hinges = '<joint type="hinge" axis="1 0 0"/><joint type="hinge" axis="0 1 0"/>'
    legs = ""
    for i, quaternion in enumerate(quaternions):
        tip = platform if i == CARRIER else f'<site name="tip{i}"/>'
        upper = _body(slide, robot.m_u[i], robot.r_u0[i], robot.I_u0[i], tip)
        place = f' pos="{_text(robot.b[i])}" quat="{_text(quaternion)}"'
        legs += _body(hinges, robot.m_d[i], robot.r_d0[i], robot.I_d0[i], upper, place)
    soft = f'solref="{-STIFFNESS:g} 0" solimp="{stiff} {stiff} 1"'
    closed = "".join(f'<connect site1="tip{i}" site2="point{i}" {soft}/>' for i in range(CARRIER))
    return (
        f'<mujoco><compiler angle="radian"/>{_option(robot.g)}<worldbody>{legs}</worldbody>'
        f"<equality>{closed}</equality></mujoco>"
    )


def _option(gravity: Array) -> str:
    """Return the options: the fastest solver, without warm start and unrequested computations."""
    off = " ".join(f'{name}="disable"' for name in ("contact", "sensor", "warmstart", "island"))
    return (
        f'<option gravity="{_text(gravity)}" solver="Newton" jacobian="dense" iterations="1" tolerance="0">'
        f'<flag {off}/></option><size memory="1M"/>'
    )


def _body(joints: str, mass: float, center: Array, inertia: Array, inside: str, place: str = "") -> str:
    tensor = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return (
        f'<body{place}>{joints}<inertial mass="{_text(mass)}" pos="{_text(center)}" '
        f'fullinertia="{_text(tensor)}"/>{inside}</body>'
    )


def _text(numbers: Any) -> str:
    return " ".join(repr(float(number)) for number in np.ravel(numbers))
