"""Every public function of the package with arguments that it accepts, by name, to start attacks from."""

import dataclasses
import functools
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp
from machines import random_motion, random_robot

import stewart_sym as ss
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.robot.drive import NUMBERS
from stewart_sym.robot.offsets import SHAPES

# Of a class or a module that is no function: records that the package fills, types and constants.
RECORDS = {
    *(
        "BaseParameters",
        "EquationsByParameter",
        "EquationsOfMotion",
        "Estimate",
        "Excitation",
        "Experiment",
        "ForceDerivatives",
    ),
    *("Forces", "Linearisation", "Parameters", "PlatformPose", "Reactions", "Simulation", "Stop", "Trace"),
    *("Approach", "Certificate", "Crossing", "ForceBounds", "LegExtreme", "PathSingularities", "Singularity"),
    *("Capability", "JointAngles", "Needs", "Workspace", "WorkspaceWarning"),
    *("DriveEffort", "DriveEstimate", "DriveLimitWarning", "ImportedModel", "LogWarning", "ModelFile"),
    *("MotorMotion", "Saturation", "Smooth"),
    *("PlanCertificate", "PlannedPath", "PosePath", "TimedPath", "View"),
    *("PATHS", "PhysicalityWarning", "AssemblyModeWarning", "SingularPoseWarning", "results", "robots"),
}


@dataclass(frozen=True)
class Call:
    """A function and arguments by name. free: which take anything; other: how a message may call them."""

    function: Callable[..., Any]
    arguments: dict[str, Any]
    free: tuple[str, ...] = ()
    other: dict[str, str] = field(default_factory=dict)


def calls() -> dict[str, Call]:
    """Name, as in ``stewart_sym.__all__`` up to a dot -> call; shapes () where there is a choice."""
    rng = np.random.default_rng(60)
    robot = random_robot(rng, scale=1.0)
    motion = random_motion(rng, robot)
    parts = {name: getattr(motion, name) for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")}
    F = ss.inverse_dynamics(robot, motion).F
    driven = dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, torque_constant=0.5))
    legs = ss.inverse_kinematics(robot, motion)
    H = ss.wrench_matrix(robot, motion)
    pose = {"robot": robot, "R": motion.R, "t": motion.t}
    both = {"robot": robot, "motion": motion}
    limits = ss.Limits(force=1e6, speed=1.0)

    def shifted(s: np.ndarray) -> ss.Motion:
        """A straight path with its derivatives by s."""
        along = np.broadcast_to(np.array([0.01, 0.0, 0.0]), (len(s), 3))
        still = np.zeros((len(s), 3))
        R = np.broadcast_to(motion.R, (len(s), 3, 3))
        return ss.Motion(R, motion.t + s[:, None] * along, still, along, still, still)

    options = {"formulation": "exact", "backend": "c", "on_singular": "raise"}
    vector = [0.1, 0.2, 0.3]
    path = ss.PATHS["I"].path
    zeros = np.zeros((2, 6))
    fourier = {"t0": vector, "theta0": vector, "sine": zeros, "cosine": zeros, "period": 2.0}
    lines = {"t0": vector, "theta0": vector, "t1": (1.0, 0.2, 0.3), "theta1": vector}
    at_home = dataclasses.replace(robot, home=motion.t, force_limit=np.full(6, 1e5))
    ends = [[-1.0, 1.0], [-1.0, 1.0], [0.5, 1.5]]
    state = ss.Motion(motion.R, motion.t, np.zeros(3), np.zeros(3))
    springs = {"robot": robot, "stiffness": 1e6, "rest_length": 1.0, "damping": 10.0}
    tracking = {"robot": robot, "wanted": lambda time: motion, "k_p": 1.0, "k_d": 1.0}
    rates = {"robot": robot, "L": legs.L, "L_dot": legs.L_dot, "L_ddot": legs.L_ddot}
    trajectory = Trajectory(np.arange(3.0), path.sample(np.arange(3.0)), "three", (2, 3, 4))

    @functools.cache
    def wrench_matrix() -> Any:
        return ss.symbolic(robot, "H")

    def derivative(by: Any) -> Any:
        return wrench_matrix().derivative(by)

    found = {
        "Motion": Call(ss.Motion, parts),
        "Motion.from_rpy": Call(
            ss.Motion.from_rpy,
            dict.fromkeys(("t", "theta", "v", "theta_dot", "a", "theta_ddot", "F_ext", "M_ext"), vector),
        ),
        "Robot.from_dict": Call(ss.Robot.from_dict, {"d": robot.to_dict()}, other={"d": "robot"}),
        "Robot.from_toml": Call(ss.Robot.from_toml, {"path": "no.toml"}),
        "StraightLinePath": Call(ss.StraightLinePath, {**lines, "tau_f": 1.0, "V": 1.5, "Omega": 1.0}),
        "StraightLinePath.sample": Call(path.sample, {"tau": 0.5}),
        "StraightLinePath.times": Call(path.times, {"dtau": 0.5}),
        "FourierPath": Call(ss.FourierPath, fourier),
        "FourierPath.sample": Call(ss.FourierPath(**fourier).sample, {"tau": 0.5}),
        "FourierPath.times": Call(ss.FourierPath(**fourier).times, {"samples": 3}),
        "inverse_dynamics": Call(ss.inverse_dynamics, {**both, **options}),
        "joint_reactions": Call(ss.joint_reactions, {**both, "bearing": 0.1, **options}),
        "massless_forces": Call(ss.massless_forces, both),
        "dynamic_fraction": Call(ss.dynamic_fraction, {**both, "F": F}),
        "equations_of_motion": Call(ss.equations_of_motion, {**both, **options}),
        "forward_dynamics": Call(ss.forward_dynamics, {**both, "F": F, **options}),
        "joint_space_inertia": Call(ss.joint_space_inertia, {**both, **options}),
        "force_derivatives": Call(ss.force_derivatives, {**both, "backend": "c", "on_singular": "raise"}),
        "linearise": Call(ss.linearise, {**both, "F": F, "backend": "c", "on_singular": "raise"}),
        "inverse_kinematics": Call(ss.inverse_kinematics, both),
        "wrench_matrix": Call(ss.wrench_matrix, both),
        "wrench_matrix_rate": Call(ss.wrench_matrix_rate, both),
        "forward_kinematics": Call(
            ss.forward_kinematics,
            {
                "robot": robot,
                "L": legs.L,
                "guess": (motion.R, motion.t),
                "on_failure": "raise",
                "limits": True,
            },
        ),
        "forward_velocity": Call(ss.forward_velocity, {**pose, "L_dot": legs.L_dot, "on_failure": "raise"}),
        "forward_acceleration": Call(
            ss.forward_acceleration,
            {**pose, "v": vector, "omega": vector, "L_ddot": legs.L_ddot, "on_failure": "raise"},
        ),
        "motion_from_lengths": Call(
            ss.motion_from_lengths,
            {name: value if name == "robot" else value[None] for name, value in rates.items()},
        ),
        "condition_number": Call(ss.condition_number, {"H": H}),
        "scaled_condition_number": Call(ss.scaled_condition_number, {"H": H, "length": 1.0}),
        "up_direction": Call(ss.up_direction, {"robot": robot}),
        "characteristic_length": Call(ss.characteristic_length, {"robot": robot}),
        "regressor": Call(
            ss.regressor, {**both, "on_singular": "raise", "columns": [0, 147], "backend": "c"}
        ),
        "equations_by_parameter": Call(
            ss.equations_by_parameter, {**both, "on_singular": "raise", "backend": "c"}
        ),
        "inertial_parameters": Call(ss.inertial_parameters, {"robot": robot}),
        "symbolic": Call(ss.symbolic, {"robot": robot, "what": "H", "formulation": "exact"}),
        "Symbolic.derivative": Call(derivative, {"by": sp.Symbol("t_x", real=True)}),
        "casadi_function": Call(
            ss.casadi_function, {"robot": robot, "what": "forces", "formulation": "exact", "checked": False}
        ),
        "array_kernel": Call(
            ss.array_kernel,
            {"robot": robot, "xp": np, "formulation": "exact", "dtype": None},
            free=("dtype",),
        ),
        "ArrayKernel": Call(
            ss.ArrayKernel, {"robot": robot, "xp": np, "formulation": "exact", "dtype": None}, free=("dtype",)
        ),
        "read_trajectory": Call(
            ss.read_trajectory,
            {
                "robot": robot,
                "path": "no.csv",
                "form": ss.LogFormat(),
                "smoothing": ss.Smoothing(),
                "guess": (motion.R, motion.t),
            },
            free=("form", "guess"),
        ),
        "export_model": Call(ss.export_model, {"robot": robot, "format": "mjcf"}),
        "import_model": Call(ss.import_model, {"path": "no.xml"}),
        "prepare": Call(
            ss.prepare, {"robot": robot, "formulation": "exact", "precision": "double", "fidelity": "general"}
        ),
        "ForceKernel.forces": Call(
            ss.prepare(robot).forces, {"motion": motion, "threads": 1, "on_singular": "raise"}
        ),
        "ForceKernel.status": Call(ss.prepare(robot).status, {"motion": motion, "threads": 1}),
        "LegSprings": Call(ss.LegSprings, springs),
        "LegSprings.balanced": Call(
            ss.LegSprings.balanced, {"robot": robot, "pose": motion, "stiffness": 1e6, "damping": 1.0}
        ),
        "LegSprings.energy": Call(ss.LegSprings(**springs).energy, {"L": legs.L}),
        "ComputedTorque": Call(
            ss.ComputedTorque, {**tracking, "formulation": "exact", "backend": "c"}, free=("wanted",)
        ),
        "Thresholds": Call(ss.Thresholds, {"max_condition": 1e6, "min_length": 0.1, "min_joint_sine": 1e-3}),
        "simulate": Call(
            ss.simulate,
            {
                **{"robot": robot, "initial_state": state, "forces": F, "duration": 1e-3, "rate": 1e3},
                **{"load": lambda time, state: np.zeros(6), "formulation": "exact", "backend": "c"},
                **{"method": "DOP853", "rtol": 1e-6, "atol": 1e-6, "output_step": 1e-3},
                "thresholds": ss.Thresholds(),
            },
        ),
        "forces_with_bounds": Call(
            ss.forces_with_bounds, {**both, "precision": "double", "on_singular": "raise"}
        ),
        "singularity": Call(ss.singularity, {"robot": robot, "pose": motion}),
        "crossings": Call(ss.crossings, {"robot": robot, "path": path.sample, "times": [0.0, 1.0]}),
        "singularities_along": Call(
            ss.singularities_along, {"robot": robot, "path": path.sample, "times": [0.0, 1.0]}
        ),
        "force_residue": Call(ss.force_residue, {**both, "formulation": "exact"}),
        "damped_solution": Call(ss.damped_solution, {"H": H, "c": np.ones(6), "length": 1.0, "share": 1e-4}),
        "certify_pose": Call(ss.certify_pose, {"robot": robot, "L": legs.L, "pose": (motion.R, motion.t)}),
        "joint_angles": Call(ss.joint_angles, {"robot": at_home, "motion": motion}),
        "leg_distances": Call(ss.leg_distances, both),
        "PoseLimits": Call(
            ss.PoseLimits,
            {"lengths": True, "joint_angles": True, "forces": True, "condition": 9.0, "clearance": 0.01},
        ),
        "workspace": Call(
            ss.workspace,
            {
                **{"robot": at_home, "kind": "total", "limits": ss.PoseLimits(), "position": motion.t},
                **{"angles": vector, "box": ends, "turns": ends, "poses": 200, "seed": 0},
            },
        ),
        "capability": Call(
            ss.capability, {"robot": at_home, "motion": motion, "what": "force", "others": "zero"}
        ),
        "size": Call(
            ss.size,
            {
                **{"robot": robot, "motions": [([0.0], motion[None])], "margin": 0.1},
                **{"quantiles": [0.5, 1.0], "formulation": "exact"},
            },
        ),
        "drive_effort": Call(
            ss.drive_effort,
            {"robot": driven, "motion": motion, "time": None, "formulation": "exact", "backend": "c"},
        ),
        "motor_forces": Call(ss.motor_forces, {"robot": driven, "current": F}),
        "motor_angles": Call(ss.motor_angles, {"robot": driven, "motion": motion, "L_0": legs.L}),
        "pose_of_motors": Call(
            ss.pose_of_motors,
            {"robot": driven, "angle": np.zeros(6), "guess": (motion.R, motion.t), "L_0": legs.L},
        ),
        "Offsets": Call(
            ss.Offsets,
            {**dict.fromkeys(set(SHAPES) - {"platform_axis", "cross_center"}, np.zeros(6))}
            | {
                "platform_joint": "universal",
                "platform_axis": np.ones((6, 3)),
                "cross_center": np.zeros((6, 3)),
            },
        ),
        "Drive": Call(ss.Drive, dict.fromkeys(NUMBERS, 1.0)),
        "rotor_regressor": Call(ss.rotor_regressor, {**both, "on_singular": "raise"}),
        "view": Call(ss.view, {**both, "times": None}),
        "ViaPose": Call(
            ss.ViaPose,
            {"R": motion.R, "t": motion.t, "low": np.zeros(6), "high": np.zeros(6)},
            other={"R": "pose", "t": "pose"},
        ),
        "Limits": Call(
            ss.Limits,
            dict.fromkeys(("force", "speed", "acceleration", "platform_speed", "platform_turn_rate"), 1.0),
        ),
        "plan_path": Call(
            ss.plan_path,
            {
                "robot": robot,
                "poses": [ss.ViaPose(motion.R, motion.t), ss.ViaPose(motion.R, motion.t + 0.01)],
                "limits": None,
                "objective": "mean",
                "price": 0.5,
                "load": np.zeros(6),
            },
            other={"poses": "via pose"},
        ),
        "time_path": Call(
            ss.time_path,
            {
                "robot": robot,
                "path": shifted,
                "span": (0.0, 1.0),
                "limits": limits,
                "formulation": "exact",
                "cells": 10,
            },
        ),
        "certify_plan": Call(
            ss.certify_plan, {"plan": ss.time_path(robot, shifted, limits=limits, cells=10)}
        ),
        "Units": Call(ss.Units, {"length": 1.0, "mass": 2.0, "time": 0.5}),
        "between": Call(ss.between, {"trajectory": trajectory}),
        "resampled": Call(ss.resampled, {"trajectory": trajectory, "rate": 20.0}),
        "force_deviations": Call(
            ss.force_deviations,
            {"robot": robot, "trajectory": trajectory, "formulation": "exact", "backend": "numpy"},
        ),
        "smooth": Call(
            ss.smooth,
            {"time": np.arange(20.0), "values": rng.normal(size=(20, 2)), "sigma": 0.1, "cutoff": 0.2},
        ),
        "Smoothing": Call(
            ss.Smoothing, {"position": 1e-4, "angle": 1e-4, "cutoff": 5.0, "on": True}, free=("on",)
        ),
        "LogFormat": Call(
            ss.LogFormat,
            {
                **{"columns": {"t_x": "X"}, "length_unit": "mm", "angle_unit": "deg", "time_unit": "ms"},
                **{"delimiter": ";", "decimal": ",", "euler_order": "zyx"},
            },
        ),
        "base_parameters": Call(ss.base_parameters, {"robot": robot, "motion": motion[None]}),
        "choose_excitation": Call(
            ss.choose_excitation,
            {"robot": robot, "period": 4.0, "harmonics": 1, "samples": 3, "candidates": 1, "seed": 0},
        ),
    }
    excited = ss.choose_excitation(robot, harmonics=3, samples=60, candidates=1)
    deviations = {"F": ss.inverse_dynamics(robot, excited.motion).F, "sigma": 1.0, "base": excited.base}
    found["identify"] = Call(ss.identify, {"robot": robot, "motion": excited.motion, **deviations})
    poses = {"time": np.arange(9.0), "position": 1e-4, "angle": 1e-4, "period": 9.0, "harmonics": 2}
    found["PoseNoise"] = Call(ss.PoseNoise, poses)
    rough = ss.Motion(
        excited.motion.R,
        excited.motion.t + 1e-4 * rng.normal(size=(60, 3)),
        excited.motion.omega,
        excited.motion.v,
    )
    found["estimated_noise"] = Call(
        ss.estimated_noise,
        {"time": excited.time, "motion": rough, "period": excited.path.period, "harmonics": 3},
    )
    found["simulated_experiment"] = Call(
        ss.simulated_experiment, {"robot": robot, "excited": excited, "sigma": 1.0, "seed": 0}
    )
    return found


def public() -> set[str]:
    """Names of ``stewart_sym.__all__`` that are to be called."""
    return set(ss.__all__) - RECORDS
