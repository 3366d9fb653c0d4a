"""An exported URDF and its loops in Pinocchio: accelerations under rigid closures."""

import json
from typing import Any

import numpy as np
import pinocchio as pin
from exported_mujoco import universal_angles
from numpy.typing import NDArray

import stewart_sym as ss
from stewart_sym.exchange.model_from_robot import model_of
from stewart_sym.motion.rotation import quaternion_from_rotation, rotation_from_vector
from stewart_sym.robot.offset_chains import joint_motion

Array = NDArray[np.float64]


def accelerations(robot: ss.Robot, motion: ss.Motion, F: Array) -> Array:
    """[a; alpha], (6,), base frame, under actuator forces F, friction and the motion's load."""
    file = ss.export_model(robot, "urdf")
    model, loops = pin.buildModelFromXML(file.text), json.loads(file.loop_closures)
    model.gravity = pin.Motion(np.array(loops["gravity_m_s2"]), np.zeros(3))
    q, v = _state(robot, motion, model)
    data = model.createData()
    tau = -model.damping * v
    for i in range(6):
        tau[_rate(model, f"leg_{i + 1}")] += F[i]
    closures = pin.StdVec_RigidConstraintModel()
    for each in loops["closures"]:
        ends = [model.frames[model.getFrameId(each[key])] for key in ("link_1", "link_2")]
        places = [pin.SE3(np.eye(3), np.array(each[key])) for key in ("point_1_m", "point_2_m")]
        upper, platform = (frame.parentJoint for frame in ends)
        first, second = (frame.placement * place for frame, place in zip(ends, places, strict=True))
        kind, world = pin.ContactType.CONTACT_3D, pin.ReferenceFrame.LOCAL
        closures.append(pin.RigidConstraintModel(kind, model, upper, first, platform, second, world))
    tau += _moments(motion, loops, model, data, q, v)
    datas = pin.StdVec_RigidConstraintData()
    for each in closures:
        datas.append(each.createData())
    pin.initConstraintDynamics(model, data, closures, datas)
    settings = pin.ProximalSettings(1e-14, 1e-14, 20)
    found = pin.constraintDynamics(model, data, q, v, tau, closures, datas, settings)
    spatial = found[_rate(model, "free") : _rate(model, "free") + 6]
    a = motion.R @ spatial[:3] + np.cross(motion.omega, motion.v)
    return np.concatenate([a, motion.R @ spatial[3:]])


def _state(robot: ss.Robot, motion: ss.Motion, model: pin.Model) -> tuple[Array, Array]:
    """Joint coordinates and rates."""
    q, v, home = pin.neutral(model), np.zeros(model.nv), model_of(robot)
    arm = robot.p @ motion.R.T
    S, Sdot = motion.t + arm - robot.b, motion.v + np.cross(motion.omega, arm)
    L = np.linalg.norm(S, axis=-1)
    joints = None if robot.offsets is None else joint_motion(robot, motion)
    for i in range(6):
        frame, length = home.body(f"lower_{i + 1}").R, home.body(f"upper_{i + 1}").t - robot.b[i]
        s = S[i] / L[i]
        if joints is not None:
            s, at = joints.at.s[i], joints.at
            angles, rates = universal_angles(robot.k[i], frame, s, at.y[i])[0], joints.rates[i, :2]
        elif robot.base_joint == "universal":
            angles, axes = universal_angles(robot.k[i], frame, s)
            rates = np.linalg.solve(np.stack([*np.cross(axes, S[i]), s], axis=-1), Sdot[i])[:2]
        else:
            # Turns about y, z and x of the leg's frame at home, without a spin.
            x, y, z = frame.T @ s
            angles = (np.arctan2(-z, x), np.arcsin(y), 0.0)
            middle = rotation_from_vector(angles[0] * frame[:, 1]) @ frame[:, 2]
            rates = np.linalg.solve(np.stack([frame[:, 1], middle, s], axis=-1), np.cross(s, Sdot[i]) / L[i])
        for number, (angle, rate) in enumerate(zip(angles, rates, strict=True), 1):
            joint = model.joints[model.getJointId(f"base_{i + 1}_{number}")]
            q[joint.idx_q : joint.idx_q + joint.nq] = np.cos(angle), np.sin(angle)
            v[joint.idx_v] = rate
        slide = model.joints[model.getJointId(f"leg_{i + 1}")]
        if joints is None:
            q[slide.idx_q], v[slide.idx_v] = L[i] - np.linalg.norm(length), s @ Sdot[i]
        else:
            at_home = next(joint.position for joint in home.joints if joint.name == f"leg_{i + 1}")
            q[slide.idx_q], v[slide.idx_v] = joints.at.L[i, 0] - at_home, joints.rates[i, 2]
    free = model.joints[model.getJointId("free")]
    q[free.idx_q : free.idx_q + 7] = [*motion.t, *np.roll(quaternion_from_rotation(motion.R), -1)]
    v[free.idx_v : free.idx_v + 6] = [*motion.R.T @ motion.v, *motion.R.T @ motion.omega]
    # The file places the platform at its home pose.
    placement = model.jointPlacements[model.getJointId("free")]
    q[free.idx_q : free.idx_q + 3] -= placement.translation
    return q, v


def _moments(motion: ss.Motion, loops: Any, model: pin.Model, data: pin.Data, q: Array, v: Array) -> Array:
    """Generalized forces of the closures' friction and of the load."""
    pin.computeJointJacobians(model, data, q)
    frame, tau = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED, np.zeros(model.nv)
    platform = model.frames[model.getFrameId("platform")].parentJoint
    on_platform = pin.getJointJacobian(model, data, platform, frame)
    for each in loops["closures"]:
        upper = model.frames[model.getFrameId(each["link_1"])].parentJoint
        turning = pin.getJointJacobian(model, data, upper, frame)[3:] - on_platform[3:]
        tau -= each["damping_N_m_s"] * turning.T @ turning @ v
    for load, rows in ((motion.F_ext, slice(0, 3)), (motion.M_ext, slice(3, 6))):
        if load is not None:
            tau += on_platform[rows].T @ (motion.R @ load)
    return tau


def _rate(model: pin.Model, joint: str) -> int:
    return int(model.joints[model.getJointId(joint)].idx_v)
