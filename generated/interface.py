"""Layout of the C code as data: status codes, structs, outputs of functions, sizes of prepared models.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""

Shape = tuple[int, ...]

# Code and meaning of ``STEWART_<name>``.
STATUS: dict[str, tuple[int, str]] = {
    "OK": (0, "solved"),
    "NOT_FINITE": (1, "an input is not finite, or a result overflows"),
    "ZERO_LENGTH": (2, "a leg has length zero"),
    "JOINT_SINGULAR": (3, "a leg lies along the fixed axis of its universal joint"),
    "SINGULAR": (4, "H is singular: no leg forces can hold the platform"),
    "BAD_ARGUMENT": (5, "an argument is invalid: a pointer is null, stride < count, or an index is out of range"),
    "MASS_MATRIX_INDEFINITE": (6, "the mass matrix M is not positive definite: no body has such inertias"),
    "NOT_CONVERGED": (7, "no pose with these leg lengths was found"),
}

# Members of ``stewart_<name>`` in order, with their shapes; ``stewart_robot`` is six legs, then ``platform``.
# For a symmetric (3, 3) tensor C stores the six components xx xy xz yy yz zz.
STRUCTS: dict[str, dict[str, Shape]] = {
    "leg": {
        "b": (3,),
        "p": (3,),
        "k": (3,),
        "m_d": (),
        "r_d0": (3,),
        "I_d0": (3, 3),
        "m_u": (),
        "r_u0": (3,),
        "I_u0": (3, 3),
        "C_u": (),
        "C_p": (),
        "C_s": (),
    },
    "rotor": {
        "m_r": (),
        "j_r": (),
    },
    "platform": {
        "M": (),
        "R_0": (3,),
        "I_p": (3, 3),
        "g": (3,),
    },
    "limits": {
        "shortest": (6,),
        "longest": (6,),
        "force": (6,),
        "speed": (6,),
    },
    "drives": {
        "turns": (6,),
        "driving": (6,),
        "driven": (6,),
        "coulomb": (6,),
        "viscous": (6,),
        "stribeck": (6,),
        "stribeck_speed": (6,),
        "smoothing": (6,),
        "torque_constant": (6,),
    },
    "motion": {
        "R": (3, 3),
        "t": (3,),
        "omega": (3,),
        "v": (3,),
        "alpha": (3,),
        "a": (3,),
        "F_ext": (3,),
        "M_ext": (3,),
    },
    "pose": {
        "R": (3, 3),
        "t": (3,),
    },
    "forces": {
        "F": (6,),
        "D": (6,),
        "x": (6,),
        "K": (6, 3),
        "H": (6, 6),
        "c": (6,),
    },
    "reactions": {
        "F_s": (6, 3),
        "F_u": (6, 3),
        "F_p": (6, 3),
        "F_c": (6, 3),
        "M_p": (6, 3),
        "M_u": (6,),
    },
    "equations": {
        "M": (6, 6),
        "C": (6, 6),
        "g": (6,),
        "friction": (6,),
        "bias": (6,),
        "bias_and_friction": (6,),
        "H": (6, 6),
        "H_dot": (6, 6),
    },
    "derivatives": {
        "F": (6,),
        "by_pose": (6, 6),
        "by_twist": (6, 6),
        "by_acceleration": (6, 6),
    },
    "linearization": {
        "acceleration": (6,),
        "A": (12, 12),
        "B": (12, 6),
    },
    "legs": {
        "L": (6,),
        "L_dot": (6,),
        "L_ddot": (6,),
        "s": (6, 3),
        "S": (6, 3),
    },
}

# Outputs of each function in order, with their shapes.
OUTPUTS: dict[str, dict[str, Shape]] = {
    "forces": {
        "F": (6,),
    },
    "inverse_dynamics": {
        "F": (6,),
        "D": (6,),
        "x": (6,),
        "K": (6, 3),
        "H": (6, 6),
        "c": (6,),
    },
    "joint_reactions": {
        "F_s": (6, 3),
        "F_u": (6, 3),
        "F_p": (6, 3),
        "F_c": (6, 3),
        "M_p": (6, 3),
        "M_u": (6,),
    },
    "equations": {
        "M": (6, 6),
        "C": (6, 6),
        "g": (6,),
        "friction": (6,),
        "bias": (6,),
        "bias_and_friction": (6,),
        "H": (6, 6),
        "H_dot": (6, 6),
    },
    "bias_and_friction": {
        "bias_and_friction": (6,),
    },
    "forward_dynamics": {
        "acceleration": (6,),
    },
    "joint_inertia": {
        "inertia": (6, 6),
    },
    "derivatives": {
        "F": (6,),
        "by_pose": (6, 6),
        "by_twist": (6, 6),
        "by_acceleration": (6, 6),
    },
    "linearization": {
        "acceleration": (6,),
        "A": (12, 12),
        "B": (12, 6),
    },
    "inverse_kinematics": {
        "L": (6,),
        "L_dot": (6,),
    },
    "forward_kinematics": {
        "R": (9,),
        "t": (3,),
    },
    "forward_velocity": {
        "v": (3,),
        "omega": (3,),
    },
    "axial_forces": {
        "axial": (6,),
        "L_dot": (6,),
    },
    "motor_torques": {
        "torque": (6,),
        "current": (6,),
    },
    "motion_from_rpy": {
        "R": (9,),
        "omega": (3,),
        "alpha": (3,),
    },
    "motion_from_quaternion": {
        "R": (9,),
        "omega": (3,),
        "alpha": (3,),
    },
}

# Count of numbers in the prepared model of each kernel.
MODELS: dict[str, int] = {
    "exact": 311,
    "exact_axisymmetric": 163,
    "exact_axisymmetric_friction": 188,
    "exact_bounds": 385,
    "exact_drive": 327,
    "exact_drive_bounds": 397,
    "exact_drive_reflected": 292,
    "exact_drive_reflected_massless": 75,
    "exact_drive_reflected_massless_friction": 124,
    "exact_drive_reflected_slender": 99,
    "exact_drive_reflected_slender_friction": 180,
    "exact_frictionless": 259,
    "exact_general_static": 140,
    "exact_massless": 67,
    "exact_massless_friction": 116,
    "exact_massless_static": 57,
    "exact_offset": 356,
    "exact_point_masses": 91,
    "exact_point_masses_friction": 172,
    "exact_slender": 91,
    "exact_slender_friction": 172,
    "exact_slender_static": 68,
    "exact_spherical": 251,
    "exact_spherical_drive": 259,
    "paper": 220,
    "paper_spherical": 251,
}

# Headers that the sources share; a source requires these and its own.
HEADERS = (
    "stewart.h",
    "stewart_arithmetic.h",
    "stewart_solve.h",
    "stewart_lanes.h",
    "stewart_outputs.h",
)
