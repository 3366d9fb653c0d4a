"""Peers of forward dynamics in ``bench``: Pinocchio and MuJoCo, over the tree of ``peers_tree``.

Each closes the five loops by constraints and is called from Python, one pose a call, its state prepared; a
call over a model without bodies tells what the call costs. Times nothing.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..extras import needed_for
from ..robot import Robot
from .peers_tree import CARRIER, Tree, base_frames

with needed_for("the comparison with MuJoCo and Pinocchio"):
    import mujoco
    import pinocchio as pin

Array = NDArray[np.float64]

STIFFNESS = 1e7
"""1/s^2: MuJoCo's acceleration of a closed point for each metre that it is open.

So large that nanometres hold the loops together, so small that rounding of joint coordinates doesn't matter.
"""

_CORRECTIONS = 3
"""Corrections of MuJoCo's joint coordinates; each leaves a small share of what was missing."""

_QUATERNION_W_FIRST = [3, 0, 1, 2]


@dataclass(frozen=True, eq=False)
class Engine:
    """One peer: ``run(n)`` computes all poses n times, ``empty(n)`` calls as often over nothing.

    accelerations: [a; alpha] of the platform that it found, (poses, 6). tolerance: of them, share of a pose's
    largest. opened: by how much the loops are open, m.
    """

    name: str
    what: str
    run: Callable[[int], object]
    empty: Callable[[int], object]
    accelerations: Callable[[], Array]
    tolerance: float
    opened: float = 0.0


def engines(robot: Robot, tree: Tree) -> tuple[Engine, ...]:
    """Build every peer for the poses of the tree."""
    return pinocchio_engine(robot, tree), mujoco_engine(robot, tree)


# --- Pinocchio --------------------------------------------------------------------------------


def pinocchio_engine(robot: Robot, tree: Tree) -> Engine:
    """``constraintDynamics``: the five points as rigid constraints, one step of its proximal solver."""
    machine = _constrained(*_pinocchio_model(robot))
    nothing = _constrained(pin.Model(), [])
    quaternions = _quaternions(tree.relative)
    joints = tree.angles_and_length.reshape(len(quaternions), -1)
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


def _quaternions(R: Array) -> Array:
    return np.array([pin.Quaternion(matrix).coeffs() for matrix in R])


# --- MuJoCo -----------------------------------------------------------------------------------


def mujoco_engine(robot: Robot, tree: Tree) -> Engine:
    """``mj_forward`` with five ``connect`` constraints, one step of Newton's method on dense matrices.

    Its constraints give way in proportion to their force. That is made up for: the legs are moved by
    nanometres, beforehand, so that the constraints' springs push as much as is missing.
    """
    model = mujoco.MjModel.from_xml_string(_xml(robot))
    nothing = mujoco.MjModel.from_xml_string(f"<mujoco>{_option(np.zeros(3))}</mujoco>")
    quaternions = _quaternions(tree.relative)[:, _QUATERNION_W_FIRST]
    datas = [mujoco.MjData(model) for _ in quaternions]
    empty = [mujoco.MjData(nothing) for _ in quaternions]
    for data, quaternion, rates, forces in zip(datas, quaternions, tree.rates, tree.forces, strict=True):
        data.qpos[-4:] = quaternion
        data.qvel[:] = rates
        data.qfrc_applied[:] = forces

    def joints() -> Array:
        _forward(1, model, datas)
        return np.array([data.qacc for data in datas])

    moves = np.zeros((len(datas), CARRIER, 3))
    for correction in range(1 + _CORRECTIONS):
        if correction:
            moves += tree.gaps(joints()) / STIFFNESS
        for data, coordinates in zip(datas, tree.moved(moves), strict=True):
            data.qpos[:-4] = coordinates.ravel()
    return Engine(
        "MuJoCo",
        "mj_forward, 5 loops",
        lambda repeats: _forward(repeats, model, datas),
        lambda repeats: _forward(repeats, nothing, empty),
        lambda: tree.accelerations(joints()),
        1e-4,
        float(np.linalg.norm(moves, axis=-1).max()),
    )


def _forward(repeats: int, model: Any, datas: Sequence[Any]) -> None:
    forward = mujoco.mj_forward
    for _ in range(repeats):
        for data in datas:
            forward(model, data)


def _xml(robot: Robot) -> str:
    """The machine in MuJoCo's format; sites are the points to be closed."""
    carried = robot.p[CARRIER]
    points = (f'<site name="point{i}" pos="{_text(robot.p[i] - carried)}"/>' for i in range(CARRIER))
    platform = _body('<joint type="ball"/>', robot.M, robot.R_0 - carried, robot.I_p, "".join(points))
    quaternions = _quaternions(base_frames(robot))[:, _QUATERNION_W_FIRST]
    legs = ""
    for i, quaternion in enumerate(quaternions):
        tip = platform if i == CARRIER else f'<site name="tip{i}"/>'
        slide = '<joint type="slide" axis="1 0 0"/>'
        upper = _body(slide, robot.m_u[i], robot.r_u0[i], robot.I_u0[i], tip)
        hinges = '<joint type="hinge" axis="1 0 0"/><joint type="hinge" axis="0 1 0"/>'
        place = f' pos="{_text(robot.b[i])}" quat="{_text(quaternion)}"'
        legs += _body(hinges, robot.m_d[i], robot.r_d0[i], robot.I_d0[i], upper, place)
    soft = f'solref="{-STIFFNESS:g} 0" solimp="{mujoco.mjMAXIMP} {mujoco.mjMAXIMP} 1"'
    closed = "".join(f'<connect site1="tip{i}" site2="point{i}" {soft}/>' for i in range(CARRIER))
    return (
        f'<mujoco><compiler angle="radian"/>{_option(robot.g)}<worldbody>{legs}</worldbody>'
        f"<equality>{closed}</equality></mujoco>"
    )


def _option(gravity: Array) -> str:
    """The solver that is fastest here, nothing from the last call, nothing that isn't asked for."""
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
