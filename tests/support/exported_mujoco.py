"""An exported machine in MuJoCo at a pose of ours, with the loops as little open as carries their load."""

from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.exchange.model_from_robot import model_of
from stewart_sym.motion.rotation import quaternion_from_rotation, rotation_from_vector
from stewart_sym.robot.offset_chains import JointMotion, joint_motion

Array = NDArray[np.float64]

_CORRECTIONS = 3
_STIFFNESS = 1e8
"""1/s^2: acceleration of a closed point for each meter that it is open."""


class Exported:
    """A robot's exported model; poses are single ones."""

    def __init__(self, robot: ss.Robot, text: str | None = None) -> None:
        self.robot = robot
        self.model = mujoco.MjModel.from_xml_string(text or ss.export_model(robot, "mjcf").text)
        self.data = mujoco.MjData(self.model)
        home = model_of(robot)
        self.frames = np.array([home.body(f"lower_{i}").R for i in range(1, 7)])
        # At an instant there is no time step that stiff closures would upset.
        self.model.eq_solref[:] = -_STIFFNESS, 0.0

    def accelerations(self, motion: ss.Motion, F: Array) -> Array:
        """[a; alpha], (6,), base frame, under actuator forces F; loads of the motion are on."""
        self.place(motion)
        self.data.ctrl[:] = F
        self._load(motion)
        mujoco.mj_forward(self.model, self.data)
        for _ in range(_CORRECTIONS):
            self._move(self._gaps() / _STIFFNESS)
            mujoco.mj_forward(self.model, self.data)
        address = self._dof("free")
        found = self.data.qacc[address : address + 6]
        return np.concatenate([found[:3], motion.R @ found[3:]])

    def place(self, motion: ss.Motion) -> None:
        """Put every joint where the platform's pose and rates have it."""
        robot, q = self.robot, motion.R @ self.robot.p.T
        S = motion.t + q.T - robot.b
        Sdot = motion.v + np.cross(motion.omega, q.T)
        joints = None if robot.offsets is None else joint_motion(robot, motion)
        for i in range(6):
            if joints is None:
                self._leg(i, S[i], Sdot[i])
            else:
                self._offset_leg(i, joints)
        where, rate = self._position("free"), self._dof("free")
        self.data.qpos[where : where + 7] = [*motion.t, *quaternion_from_rotation(motion.R)]
        self.data.qvel[rate : rate + 6] = [*motion.v, *motion.R.T @ motion.omega]

    def _leg(self, i: int, S: Array, Sdot: Array) -> None:
        L = float(np.linalg.norm(S))
        s, name, frame = S / L, f"base_{i + 1}", self.frames[i]
        if self.robot.base_joint == "spherical":
            turn = _between(frame[:, 0], s) @ frame
            where, rate = self._position(name), self._dof(name)
            self.data.qpos[where : where + 4] = quaternion_from_rotation(frame.T @ turn)
            self.data.qvel[rate : rate + 3] = turn.T @ np.cross(s, Sdot) / L
            self._set(f"leg_{i + 1}", L, float(s @ Sdot))
            return
        angles, axes = universal_angles(self.robot.k[i], frame, s)
        rates = np.linalg.solve(np.stack([*np.cross(axes, S), s], axis=-1), Sdot)
        joints = f"{name}_1", f"{name}_2", f"leg_{i + 1}"
        for joint, value, rate in zip(joints, (*angles, L), rates, strict=True):
            self._set(joint, value, rate)

    def _offset_leg(self, i: int, joints: JointMotion) -> None:
        at = joints.at
        angles, _ = universal_angles(self.robot.k[i], self.frames[i], at.s[i], at.y[i])
        names = f"base_{i + 1}_1", f"base_{i + 1}_2", f"leg_{i + 1}"
        for joint, value, rate in zip(names, (*angles, at.L[i, 0]), joints.rates[i], strict=True):
            self._set(joint, float(value), float(rate))

    def _set(self, joint: str, value: float, rate: float) -> None:
        self.data.qpos[self._position(joint)] = value
        self.data.qvel[self._dof(joint)] = rate

    def _load(self, motion: ss.Motion) -> None:
        body = self.model.body("platform").id
        zero = np.zeros(3)
        force, moment = (zero if each is None else motion.R @ each for each in (motion.F_ext, motion.M_ext))
        arm = motion.R @ self.robot.R_0
        self.data.xfrc_applied[body] = [*force, *(moment - np.cross(arm, force))]

    def _gaps(self) -> Array:
        """Accelerations of the legs' ends from the platform's points, (6, 3), world frame."""
        found = []
        for i in range(6):
            accelerations = []
            for end in "ab":
                site = self.model.site(f"tip_{i + 1}_{end}").id
                J, Jdot = np.zeros((2, 3, self.model.nv))
                body, point = self.model.site_bodyid[site], self.data.site_xpos[site]
                mujoco.mj_jac(self.model, self.data, J, None, point, body)
                mujoco.mj_jacDot(self.model, self.data, Jdot, None, point, body)
                accelerations.append(J @ self.data.qacc + Jdot @ self.data.qvel)
            found.append(accelerations[0] - accelerations[1])
        return np.array(found)

    def _move(self, tips: Array) -> None:
        """Move the legs' ends, (6, 3), world frame, by their joints."""
        step = np.zeros(self.model.nv)
        for i, move in enumerate(tips):
            site = self.model.site(f"tip_{i + 1}_a").id
            J = np.zeros((3, self.model.nv))
            mujoco.mj_jacSite(self.model, self.data, J, None, site)
            legs = slice(
                self._dof(f"base_{i + 1}{'' if self.robot.base_joint == 'spherical' else '_1'}"),
                self._dof(f"leg_{i + 1}") + 1,
            )
            step[legs] = np.linalg.lstsq(J[:, legs], move, rcond=None)[0]
        mujoco.mj_integratePos(self.model, self.data.qpos, step, 1.0)

    def _position(self, joint: str) -> Any:
        return self.model.jnt_qposadr[self.model.joint(joint).id]

    def _dof(self, joint: str) -> Any:
        return self.model.jnt_dofadr[self.model.joint(joint).id]


def universal_angles(
    k: Array, frame: Array, s: Array, moving: Array | None = None
) -> tuple[tuple[float, float], Array]:
    """Angles about both axes from the home pose, where the leg's frame is ``frame``, and the axes, (2, 3)."""
    y = np.cross(k, s) / np.linalg.norm(np.cross(k, s)) if moving is None else moving
    first = float(np.arctan2(k @ np.cross(frame[:, 1], y), frame[:, 1] @ y))
    along = rotation_from_vector(first * k) @ frame[:, 0]
    return (first, float(np.arctan2(y @ np.cross(along, s), along @ s))), np.array([k, y])


def _between(one: Array, other: Array) -> Array:
    """The least turn from a direction to another."""
    axis = np.cross(one, other)
    sine = float(np.linalg.norm(axis))
    return rotation_from_vector(axis / sine * np.arctan2(sine, one @ other)) if sine else np.eye(3)
