"""Dynamics of the Stewart platform: derived by SymPy, emitted as C and NumPy, checked.

import stewart_sym as ss
robot = ss.Robot.from_toml("hexapod.toml")
motion = ss.Motion.from_rpy(t=t, theta=theta, v=v, theta_dot=theta_dot, a=a, theta_ddot=theta_ddot)
forces = ss.inverse_dynamics(robot, motion).F
"""

from typing import TYPE_CHECKING

from . import results, robots
from .bounds import ForceBounds, forces_with_bounds
from .certificate import Certificate, certify_pose
from .conditioning import characteristic_length, condition_number, scaled_condition_number
from .damping import damped_solution
from .dynamics import (
    dynamic_fraction,
    inverse_dynamics,
    joint_reactions,
    massless_forces,
)
from .equations import (
    equations_of_motion,
    force_derivatives,
    forward_dynamics,
    joint_space_inertia,
    linearise,
)
from .excitation import Excitation, FourierPath, choose_excitation
from .faults import SingularPoseWarning
from .force_noise import force_deviations
from .forces import ForceKernel, prepare
from .forward import PlatformPose, forward_acceleration, forward_kinematics, forward_velocity
from .identifiable import BaseParameters, base_parameters
from .identification import Estimate, Experiment, identify, simulated_experiment
from .interpolation import between, resampled
from .joint_space import motion_from_lengths
from .kinematics import inverse_kinematics, wrench_matrix, wrench_matrix_rate
from .laws import ComputedTorque, LegSprings
from .logs import LogFormat
from .motion import Motion
from .mounting import AssemblyModeWarning, up_direction
from .parameters import Parameters, inertial_parameters, regressor
from .passage import (
    Approach,
    Crossing,
    LegExtreme,
    Passage,
    crossings,
    force_pole,
    singularities_along,
)
from .results import EquationsOfMotion, ForceDerivatives, Forces, Linearisation, Reactions
from .robot import PhysicalityWarning, Robot
from .simulation import Saturation, Simulation, Stop, Thresholds, Trace, simulate
from .singularity import Singularity, singularity
from .smooth_motion import PoseNoise, estimated_noise
from .smoothing import LogWarning, Smooth, smooth
from .trajectory import PATHS, Smoothing, StraightLinePath
from .units import Units

__all__ = [
    "PATHS",
    "Approach",
    "AssemblyModeWarning",
    "BaseParameters",
    "Certificate",
    "ComputedTorque",
    "Crossing",
    "EquationsOfMotion",
    "Estimate",
    "Excitation",
    "Experiment",
    "ForceBounds",
    "ForceDerivatives",
    "ForceKernel",
    "Forces",
    "FourierPath",
    "LegExtreme",
    "LegSprings",
    "Linearisation",
    "LogFormat",
    "LogWarning",
    "Motion",
    "Parameters",
    "Passage",
    "PhysicalityWarning",
    "PlatformPose",
    "PoseNoise",
    "Reactions",
    "Robot",
    "Saturation",
    "Simulation",
    "SingularPoseWarning",
    "Singularity",
    "Smooth",
    "Smoothing",
    "Stop",
    "StraightLinePath",
    "Thresholds",
    "Trace",
    "Units",
    "base_parameters",
    "between",
    "certify_pose",
    "characteristic_length",
    "choose_excitation",
    "condition_number",
    "crossings",
    "damped_solution",
    "dynamic_fraction",
    "equations_of_motion",
    "estimated_noise",
    "force_derivatives",
    "force_deviations",
    "force_pole",
    "forces_with_bounds",
    "forward_acceleration",
    "forward_dynamics",
    "forward_kinematics",
    "forward_velocity",
    "identify",
    "inertial_parameters",
    "inverse_dynamics",
    "inverse_kinematics",
    "joint_reactions",
    "joint_space_inertia",
    "linearise",
    "massless_forces",
    "motion_from_lengths",
    "prepare",
    "regressor",
    "resampled",
    "results",
    "robots",
    "scaled_condition_number",
    "simulate",
    "simulated_experiment",
    "singularities_along",
    "singularity",
    "smooth",
    "up_direction",
    "wrench_matrix",
    "wrench_matrix_rate",
]

__version__: str
"""Of the installed package; looked up when first asked for, since that takes as long as the whole import."""


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])


if not TYPE_CHECKING:

    def __getattr__(name: str) -> str:
        if name != "__version__":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib.metadata import version

        globals()[name] = found = version("stewart-sym")
        return found
