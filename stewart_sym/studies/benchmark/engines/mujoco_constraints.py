"""Forward dynamics by MuJoCo's ``mj_forward`` as a baseline of the equations of motion."""

from dataclasses import replace
from typing import Any

import numpy as np

from ....io.array_types import Array
from ....io.extras import needed_for
from ....motion.rotation import quaternion_from_rotation
from ....robot.robot import Robot
from ...common.timing import over
from ..baselines import Called
from .tree import CARRIER, Tree, base_frames, forward_dynamics

with needed_for("the comparison with MuJoCo"):
    import mujoco


STIFFNESS = 1e7
"""Ratio of MuJoCo's acceleration of a constrained point to the gap of the constraint (1/s^2).

The value is so large that nanometers close the loops, and so small that rounding of joint coordinates is
negligible.
"""

_CORRECTIONS = 3
"""Number of corrections of MuJoCo's joint coordinates; each reduces the error to a small fraction."""


def mujoco_engine(robot: Robot, tree: Tree) -> Called:
    """Measure ``mj_forward`` with five ``connect`` constraints and one dense Newton step.

    The constraints yield in proportion to their force. In compensation the legs are moved by nanometers in
    advance, so that the springs of the constraints supply the missing force.
    """
    model = mujoco.MjModel.from_xml_string(_xml(robot))
    nothing = mujoco.MjModel.from_xml_string(f"<mujoco>{_option(np.zeros(3))}</mujoco>")
    quaternions = quaternion_from_rotation(tree.relative)
    datas = [mujoco.MjData(model) for _ in quaternions]
    for data, quaternion, rates, forces in zip(datas, quaternions, tree.rates, tree.forces, strict=True):
        data.qpos[-4:] = quaternion
        data.qvel[:] = rates
        data.qfrc_applied[:] = forces

    forward = over(mujoco.mj_forward, [(model, data) for data in datas])

    def joints() -> Array:
        forward(1)
        return np.array([data.qacc for data in datas])

    moves = np.zeros((len(datas), CARRIER, 3))
    for correction in range(1 + _CORRECTIONS):
        if correction:
            moves += tree.gaps(joints()) / STIFFNESS
        for data, coordinates in zip(datas, tree.moved(moves), strict=True):
            data.qpos[:-4] = coordinates.ravel()
    empty = over(mujoco.mj_forward, [(nothing, mujoco.MjData(nothing)) for _ in datas])
    engine = forward_dynamics("MuJoCo", "mj_forward, 5 loops", tree, forward, empty, joints, 1e-4)
    return replace(engine, opened=float(np.linalg.norm(moves, axis=-1).max()))


def _xml(robot: Robot) -> str:
    """Format the machine as an MJCF model; sites are the constrained points."""
    carried = robot.p[CARRIER]
    points = (f'<site name="point{i}" pos="{_text(robot.p[i] - carried)}"/>' for i in range(CARRIER))
    platform = _body('<joint type="ball"/>', robot.M, robot.R_0 - carried, robot.I_p, "".join(points))
    quaternions = quaternion_from_rotation(base_frames(robot))
    legs = ""
    for i, quaternion in enumerate(quaternions):
        tip = platform if i == CARRIER else f'<site name="tip{i}"/>'
        slide = f'<joint type="slide" axis="1 0 0" armature="{_text(robot.reflected_mass[i])}"/>'
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
