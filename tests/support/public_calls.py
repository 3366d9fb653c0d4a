"""Every public function of the package with arguments that it accepts, by name, to start attacks from."""

import dataclasses
import functools
import os
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import sympy as sp
from machines import machine_in_motion

import stewart_sym as ss
from stewart_sym.motion.trajectory import Trajectory
from stewart_sym.robot.drive import NUMBERS
from stewart_sym.robot.offsets import SHAPES

# Of a class or a module that is no function: records that the package fills, types and constants.
_RECORDS = """
BaseParametersResult EquationsByParameterResult EquationsOfMotionResult IdentificationResult Excitation
Experiment ForceDerivativesResult InverseDynamicsResult LinearizationResult ParameterVector
ForwardKinematicsResult JointReactionsResult SimulationResult StopEvent StateHistory SingularityApproach
PoseCertificate SingularityCrossing ForceErrorBoundsResult LegExtreme PathSingularitiesResult
SingularityResult Polytope JointAnglesResult ActuatorRequirementsResult WorkspaceResult WorkspaceWarning
AxisTravelResult DriveEffortResult DriveIdentificationResult DriveLimitWarning ImportedModel TrajectoryWarning
ExportedModel MotorAnglesResult ForceSaturation PlanCertificate PlannedPath PosePath
TimedPath TrackingError Trajectory Viewer PAPER_PATHS RobotWarning AssemblyModeWarning SingularPoseWarning
results robots
"""
RECORDS = frozenset(_RECORDS.split())


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
    robot, motion = machine_in_motion(rng, scale=1.0)
    parts = {name: getattr(motion, name) for name in ("R", "t", "omega", "v", "alpha", "a", "F_ext", "M_ext")}
    F = ss.inverse_dynamics(robot, motion).F
    driven = dataclasses.replace(robot, drive=ss.Drive(lead=5e-3, torque_constant=0.5))
    legs = ss.inverse_kinematics(robot, motion)
    H = ss.wrench_matrix(robot, motion)
    guess = (motion.R, motion.t)
    pose = {"robot": robot, "R": motion.R, "t": motion.t}
    both = {"robot": robot, "motion": motion}
    limits = ss.PathLimits(force=1e6, speed=1.0)

    def shifted(s: np.ndarray) -> ss.Motion:
        """A straight path with its derivatives by s."""
        along = np.broadcast_to(np.array([0.01, 0.0, 0.0]), (len(s), 3))
        still = np.zeros((len(s), 3))
        R = np.broadcast_to(motion.R, (len(s), 3, 3))
        return ss.Motion(R=R, t=motion.t + s[:, None] * along, omega=still, v=along, alpha=still, a=still)

    options = {"formulation": "exact", "backend": "c", "on_singular": "raise"}
    vector = [0.1, 0.2, 0.3]
    path = ss.PAPER_PATHS["I"].path
    zeros = np.zeros((2, 6))
    fourier = {"t0": vector, "theta0": vector, "sine": zeros, "cosine": zeros, "period": 2.0}
    lines = {"t0": vector, "theta0": vector, "t1": (1.0, 0.2, 0.3), "theta1": vector}
    at_home = dataclasses.replace(robot, home_position=motion.t, force_limit=np.full(6, 1e5))
    ends = [[-1.0, 1.0], [-1.0, 1.0], [0.5, 1.5]]
    state = ss.Motion(R=motion.R, t=motion.t, omega=np.zeros(3), v=np.zeros(3))
    springs = {"robot": robot, "stiffness": 1e6, "rest_length": 1.0, "damping": 10.0}
    tracking = {"robot": robot, "reference": lambda time: motion, "k_p": 1.0, "k_d": 1.0}
    trajectory = Trajectory(np.arange(3.0), path.sample(np.arange(3.0)), "three", (2, 3, 4))

    @functools.cache
    def wrench_matrix() -> Any:
        return ss.symbolic(robot, "H")

    def derivative(by: Any) -> Any:
        return wrench_matrix().derivative(by)

    found: dict[str, Call] = {}

    def add(
        function: Callable[..., Any], free: tuple[str, ...] = (), other: Any = None, **given: Any
    ) -> None:
        found[function.__qualname__] = Call(function, given, free, other or {})

    add(ss.Motion, **parts)
    add(ss.Motion.at_rest, **{name: parts[name] for name in ("R", "t", "F_ext", "M_ext")})
    by_angles = ("t", "theta", "v", "theta_dot", "a", "theta_ddot", "F_ext", "M_ext")
    add(ss.Motion.from_rpy, **dict.fromkeys(by_angles, vector))
    add(ss.Robot.from_dict, d=robot.to_dict(), other={"d": "robot"})
    add(ss.Robot.from_toml, path="no.toml", free=("path",))
    add(ss.StraightLinePath, **lines, tau_f=1.0, V=1.5, Omega=1.0)
    add(path.sample, tau=0.5)
    add(path.time_grid, dtau=0.5)
    add(ss.FourierPath, **fourier)
    add(ss.FourierPath(**fourier).sample, tau=0.5)
    add(ss.FourierPath(**fourier).time_grid, samples=3)
    add(ss.inverse_dynamics, **both, **options)
    add(ss.joint_reactions, **both, bearing_distance=0.1, **options)
    add(ss.massless_forces, **both)
    add(ss.leg_dynamics_fraction, **both, F=F)
    add(ss.equations_of_motion, **both, **options)
    add(ss.forward_dynamics, **both, F=F, **options)
    add(ss.joint_space_inertia, **both, **options)
    add(ss.force_derivatives, **both, backend="c", on_singular="raise")
    add(ss.linearize, **both, F=F, backend="c", on_singular="raise")
    add(ss.inverse_kinematics, **both)
    add(ss.wrench_matrix, **both)
    add(ss.wrench_matrix_rate, **both)
    add(ss.inverse_jacobian, **both)
    add(ss.jacobian, **both)
    add(ss.forward_kinematics, robot=robot, L=legs.L, guess=guess, on_failure="raise", check_limits=True)
    add(ss.forward_velocity, **pose, L_dot=legs.L_dot, on_failure="raise")
    add(ss.forward_acceleration, **pose, v=vector, omega=vector, L_ddot=legs.L_ddot, on_failure="raise")
    add(ss.motion_from_lengths, robot=robot, L=legs.L[None], L_dot=legs.L_dot[None], L_ddot=legs.L_ddot[None])
    add(ss.condition_number, H=H)
    add(ss.scaled_condition_number, H=H, length=1.0)
    add(ss.up_direction, robot=robot)
    add(ss.characteristic_length, robot=robot)
    add(ss.regressor, **both, on_singular="raise", columns=[0, 147], backend="c")
    add(ss.equations_by_parameter, **both, on_singular="raise", backend="c")
    add(ss.inertial_parameters, robot=robot)
    add(ss.symbolic, robot=robot, quantity="H", formulation="exact")
    found["SymbolicResult.derivative"] = Call(derivative, {"by": sp.Symbol("t_x", real=True)})
    add(ss.casadi_function, robot=robot, quantity="forces", formulation="exact", checked=False)
    add(ss.ArrayKernel, robot=robot, xp=np, formulation="exact", dtype=None, free=("dtype",))
    log = {
        "path": "no.csv",
        "file_format": ss.TrajectoryFormat(),
        "smoothing": ss.SmoothingOptions(),
        "guess": guess,
    }
    add(ss.read_trajectory, robot=robot, **log, free=("path", "file_format", "guess"))
    add(ss.export_model, robot=robot, format="mjcf")
    add(ss.import_model, path="no.xml", free=("path",))
    add(ss.ForceKernel, robot=robot, formulation="exact", precision="double", fidelity="general")
    add(ss.ForceKernel(robot).forces, motion=motion, threads=1, on_singular="raise")
    add(ss.ForceKernel(robot).forces_and_status, motion=motion, threads=1)
    add(ss.LegSprings, **springs)
    add(ss.LegSprings.in_equilibrium, robot=robot, pose=motion, stiffness=1e6, damping=1.0)
    add(ss.LegSprings(**springs).energy, L=legs.L)
    add(ss.ComputedTorque, **tracking, formulation="exact", backend="c", free=("reference",))
    add(ss.StopConditions, max_condition=1e6, min_length=0.1, min_joint_sine=1e-3)
    start = {"robot": robot, "initial_state": state, "forces": F, "load": lambda time, state: np.zeros(6)}
    steps = {
        "duration": 1e-3,
        "control_rate": 1e3,
        "method": "DOP853",
        "rtol": 1e-6,
        "atol": 1e-6,
        "output_step": 1e-3,
    }
    add(ss.simulate, **start, **steps, formulation="exact", backend="c", stop_conditions=ss.StopConditions())
    sampled, none = path.sample(np.arange(3.0)), np.zeros(3)
    run = ss.StateHistory(
        *(np.arange(3.0), sampled.R, sampled.t, sampled.v, sampled.omega),
        *(np.zeros((3, 6)), np.zeros((3, 6)), none, none),
    )
    add(ss.tracking_error, history=run, reference=path.sample)
    add(ss.force_error_bounds, **both, precision="double", on_singular="raise")
    add(ss.singularity, robot=robot, pose=motion)
    add(ss.singularity_crossings, robot=robot, path=path.sample, time=[0.0, 1.0])
    add(ss.path_singularities, robot=robot, path=path.sample, time=[0.0, 1.0])
    add(ss.singular_force_residue, **both, formulation="exact")
    add(ss.certify_pose, robot=robot, L=legs.L, pose=(motion.R, motion.t))
    add(ss.joint_angles, robot=at_home, motion=motion)
    add(ss.leg_distances, **both)
    add(ss.PoseLimits, lengths=True, joint_angles=True, forces=True, max_condition=9.0, min_clearance=0.01)
    region = {
        "position": motion.t,
        "rpy": vector,
        "position_bounds": ends,
        "rpy_bounds": ends,
        "samples": 200,
        "seed": 0,
    }
    add(ss.workspace, robot=at_home, kind="six_dof", limits=ss.PoseLimits(), **region)
    add(ss.axis_travel, robot=at_home, limits=ss.PoseLimits())
    add(ss.capability_polytope, robot=at_home, motion=motion, quantity="force", complement="zero")
    needs = {"motions": [([0.0], motion[None])], "margin": 0.1, "quantiles": [0.5, 1.0]}
    add(ss.actuator_requirements, robot=robot, **needs, formulation="exact")
    add(ss.drive_effort, robot=driven, motion=motion, time=None, formulation="exact", backend="c")
    add(ss.motor_forces, robot=driven, current=F)
    add(ss.motor_angles, robot=driven, motion=motion, reference_length=legs.L)
    add(ss.pose_from_motor_angles, robot=driven, angle=np.zeros(6), guess=guess, reference_length=legs.L)
    offsets = {name: np.zeros(shape) for name, shape in SHAPES.items()}
    add(ss.JointOffsets, **offsets | {"platform_axis": np.ones((6, 3))}, platform_joint="universal")
    add(ss.Drive, **dict.fromkeys(NUMBERS, 1.0))
    add(ss.rotor_regressor, **both, on_singular="raise")
    add(ss.view, **both, time=None)
    ends_of_via = dict.fromkeys(("tolerance_low", "tolerance_high"), np.zeros(6))
    add(ss.ViaPose, R=motion.R, t=motion.t, **ends_of_via, other={"R": "pose", "t": "pose"})
    limited = ("force", "speed", "acceleration", "platform_speed", "platform_turn_rate")
    add(ss.PathLimits, **dict.fromkeys(limited, 1.0))
    via = {
        "via_poses": [ss.ViaPose(motion.R, motion.t), ss.ViaPose(motion.R, motion.t + 0.01)],
        "load": np.zeros(6),
    }
    aim = {"limits": None, "objective": "mean", "smoothness_weight": 0.5}
    add(ss.plan_path, robot=robot, **via, **aim, other={"via_poses": "via pose"})
    along = {"path": shifted, "span": (0.0, 1.0)}
    add(ss.parameterize_path, robot=robot, **along, limits=limits, formulation="exact", grid_size=10)
    add(ss.certify_plan, plan=ss.parameterize_path(robot, shifted, limits=limits, grid_size=10))
    add(ss.interpolate, trajectory=trajectory)
    add(ss.resample, trajectory=trajectory, rate=20.0)
    add(ss.force_std, robot=robot, trajectory=trajectory, formulation="exact", backend="numpy")
    add(
        ss.SmoothingOptions,
        position_std=1e-4,
        angle_std=1e-4,
        cutoff_frequency=5.0,
        enabled=True,
        free=("on",),
    )
    units = {"length_unit": "mm", "angle_unit": "deg", "time_unit": "ms"}
    add(ss.TrajectoryFormat, columns={"t_x": "X"}, **units, delimiter="semicolon", euler_order="zyx")
    add(ss.write_trajectory, trajectory=trajectory, path=os.devnull, robot=robot, free=("robot", "path"))
    add(ss.base_parameters, robot=robot, motion=motion[None])
    add(ss.choose_excitation, robot=robot, period=4.0, harmonics=1, samples=3, candidates=1, seed=0)
    excited = ss.choose_excitation(robot, harmonics=3, samples=60, candidates=1)
    deviations = {
        "F": ss.inverse_dynamics(robot, excited.motion).F,
        "force_std": 1.0,
        "base_parameters": excited.base,
    }
    add(ss.identify, robot=robot, motion=excited.motion, **deviations)
    poses = {"time": np.arange(9.0), "position": 1e-4, "angle": 1e-4, "period": 9.0, "harmonics": 2}
    add(ss.PoseNoise, **poses)
    add(ss.simulate_experiment, robot=robot, excitation=excited, force_std=1.0, seed=0)
    return found


def public() -> set[str]:
    """Names of ``stewart_sym.__all__`` that are to be called."""
    return set(ss.__all__) - RECORDS
