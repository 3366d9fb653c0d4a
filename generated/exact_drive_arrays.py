"""Dynamics of a Gough-Stewart platform on arrays of the array API: NumPy, JAX, PyTorch, and others.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Each number of a structure may be an array with one value per pose, so the component is the first index: ``F`` is
a list of six. An array instead of such a list has the components last, (..., 6). ``on`` is the arithmetic:
selections, square roots, and constants. If a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

from .arithmetic import MASS_MATRIX_INDEFINITE, NOT_FINITE, OK, Arithmetic
from .exact_arrays import (
    Accelerations, Added, Apart, BiasAndFriction, BiasLeg, BiasLegs, BiasSums, Derivatives,
    DerivativesLeg, DerivativesLegs, DerivativesSums, Equations, EquationsLeg, EquationsLegs,
    EquationsSums, Forces, ForwardLeg, ForwardLegs, ForwardSums, JointInertia, JointRowsLeg,
    JointRowsLegs, JointRowsSums, JointSlopesLeg, JointSlopesLegs, JointSlopesSums, LegTerms,
    LinearizationResult, MomentTerms, Motion, Platform, Rows, SlopesApart, Sums, accelerations_of,
    add_up, bias_pose, bias_total, by_rows, check_bias_and_friction, check_derivatives,
    check_equations, check_forward_dynamics, check_joint_inertia, check_linearization, columns_status,
    cube_of, derivatives_pose, derivatives_total, equations_pose, equations_total, fault_of,
    forward_pose, forward_total, joint_rows_pose, joint_rows_total, joint_slopes_pose,
    joint_slopes_total, largest_component, make_rows, moments_of, per_length_of, pick_rows,
    place_blocks_24, place_blocks_6, place_inertia_12, place_inertia_24, place_inertia_6,
    prepare_platform, reach_of, row_back, row_right, rows_held, scale_moments_12, scale_moments_24,
    shared_terms, shift, singular_status, size_of, solve_definite_24, solve_definite_8, solve_legs,
    solve_pivoted_12, solve_pivoted_24, weigh_rows, with_acceleration,
)


class Leg:
    """One leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.m_d: Any = 0.0  # kg: mass of the lower part
        self.r_d0: Any = [0.0] * 3  # m: center of mass of the lower part, frame D
        self.I_d0: Any = [0.0] * 6  # kg m^2: inertia of the lower part about its center of mass, frame D
        self.m_u: Any = 0.0  # kg: mass of the upper part
        self.r_u0: Any = [0.0] * 3  # m: center of mass of the upper part, frame U
        self.I_u0: Any = [0.0] * 6  # kg m^2: inertia of the upper part about its center of mass, frame U
        self.C_u: Any = 0.0  # N m s: viscous friction of the universal joint
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
        # kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m)
        self.m_r: Any = 0.0
        self.j_r: Any = 0.0  # kg m: angular momentum J_r N of the rotor per length rate


class Robot:
    """The machine."""

    def __init__(self) -> None:
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: center of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its center of mass, platform frame
        self.I_p: Any = [0.0] * 6
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame
        self.leg: Any = [Leg() for _ in range(6)]  # the legs


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
        # kg: reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m)
        self.m_r: Any = 0.0
        self.j_r: Any = 0.0  # kg m: angular momentum J_r N of the rotor per length rate
        self.h: Any = [0.0] * 3  # kg m: first moment of the upper part about the platform point, leg frame
        self.h2_x: Any = 0.0  # kg m: 2 h_x
        self.h2_y: Any = 0.0  # kg m: 2 h_y
        self.h2_z: Any = 0.0  # kg m: 2 h_z
        # kg m: sum m_d r_d0 + m_u r_u0 of the first moments of both parts, leg frame
        self.w: Any = [0.0] * 3
        # kg m^2: sum of the inertias of the lower part about the base point and the upper part about the platform point, leg frame
        self.J: Any = [0.0] * 6
        self.J2_xz: Any = 0.0  # kg m^2: 2 J_xz
        self.dJ_zx: Any = 0.0  # kg m^2: J_zz - J_xx
        self.g_k: Any = 0.0  # m/s^2: component of g along the fixed axis k
        self.g_x_k: Any = [0.0] * 3  # m/s^2: g x k, base frame
        self.C_us: Any = 0.0  # N m s: C_u + C_s
        self.m_u: Any = 0.0  # kg: mass of the upper part
        self.M_add: Any = 0.0  # kg: mass of the leg that is added to the platform
        # kg m: first moment of the mass M_add about platform point 1, platform frame
        self.h_add: Any = [0.0] * 3
        # kg m^2: inertia of the mass M_add about platform point 1, platform frame
        self.J_add: Any = [0.0] * 6
        self.C_add: Any = 0.0  # N m s: friction of the leg's spherical joint


class Model:
    """A robot's constants, prepared once."""

    def __init__(self) -> None:
        self.leg: Any = [LegConstants() for _ in range(6)]  # the legs
        self.platform: Any = Platform()  # the platform
        self.per_length: Any = 0.0  # 1/m: one over the length over which moments are taken
        self.arm_cube: Any = 0.0  # cube of the largest arm over that length
        self.status: Any = 0  # 0, or the code of an error


def prepare_leg(on: Arithmetic, robot: Any, p_1: Any, leg: Any) -> Any:
    """Constants of one leg, and its contributions to the constants of the platform: 99 (55 mul, 42 add,
    1 div, 1 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_d = leg.m_d
    r_d0_x, r_d0_y, r_d0_z = leg.r_d0
    I_d0_xx, I_d0_xy, I_d0_xz, I_d0_yy, I_d0_yz, I_d0_zz = leg.I_d0
    m_u = leg.m_u
    r_u0_x, r_u0_y, r_u0_z = leg.r_u0
    I_u0_xx, I_u0_xy, I_u0_xz, I_u0_yy, I_u0_yz, I_u0_zz = leg.I_u0
    C_u, C_p, C_s, m_r, j_r = leg.C_u, leg.C_p, leg.C_s, leg.m_r, leg.j_r
    g_x, g_y, g_z = robot.g
    p_1_x, p_1_y, p_1_z = p_1[0], p_1[1], p_1[2]
    k_size = on.sqrt(k_x * k_x + k_y * k_y + k_z * k_z)
    inv_k_size = 1.0 / k_size
    # fixed axis, of length one
    k_unit_x = inv_k_size * k_x
    k_unit_y = inv_k_size * k_y
    k_unit_z = inv_k_size * k_z
    c1 = m_u * r_u0_x
    h_x = c1
    c2 = m_u * r_u0_y
    h_y = c2
    h_z = m_u * r_u0_z
    c3 = m_d * r_d0_x
    w_x = c3 + h_x
    c4 = m_d * r_d0_y
    w_y = c4 + h_y
    w_z = h_z + m_d * r_d0_z
    c5 = r_d0_y * r_d0_y
    c6 = r_d0_z * r_d0_z
    c7 = r_u0_y * r_u0_y
    c8 = r_u0_z * r_u0_z
    J_xx = I_d0_xx + I_u0_xx + m_d * (c5 + c6) + m_u * (c7 + c8)
    J_xy = I_d0_xy + I_u0_xy - c1 * r_u0_y - c3 * r_d0_y
    J_xz = I_d0_xz + I_u0_xz - c1 * r_u0_z - c3 * r_d0_z
    c9 = r_d0_x * r_d0_x
    c10 = r_u0_x * r_u0_x
    J_yy = I_d0_yy + I_u0_yy + m_d * (c6 + c9) + m_u * (c10 + c8)
    J_yz = I_d0_yz + I_u0_yz - c2 * r_u0_z - c4 * r_d0_z
    J_zz = I_d0_zz + I_u0_zz + m_d * (c5 + c9) + m_u * (c10 + c7)
    # platform point from platform point 1
    arm_x = p_x - p_1_x
    arm_y = p_y - p_1_y
    arm_z = p_z - p_1_z
    c11 = arm_x * m_u
    c12 = arm_y * m_u
    c13 = arm_y * arm_y
    c14 = arm_z * arm_z
    c15 = arm_x * arm_x
    out = LegConstants()
    out.b = [b_x, b_y, b_z]
    out.p = [p_x, p_y, p_z]
    out.k = [k_unit_x, k_unit_y, k_unit_z]
    out.C_p = C_p
    out.C_s = C_s
    out.m_r = m_r
    out.j_r = j_r
    out.h = [h_x, h_y, h_z]
    out.h2_x = 2.0 * h_x
    out.h2_y = 2.0 * h_y
    out.h2_z = 2.0 * h_z
    out.w = [w_x, w_y, w_z]
    out.J = [J_xx, J_xy, J_xz, J_yy, J_yz, J_zz]
    out.J2_xz = 2.0 * J_xz
    out.dJ_zx = J_zz - J_xx
    out.g_k = g_x * k_unit_x + g_y * k_unit_y + g_z * k_unit_z
    out.g_x_k = [
        g_y * k_unit_z - g_z * k_unit_y,
        g_z * k_unit_x - g_x * k_unit_z,
        g_x * k_unit_y - g_y * k_unit_x,
    ]
    out.C_us = C_s + C_u
    out.m_u = m_u
    out.M_add = m_u
    out.h_add = [c11, c12, arm_z * m_u]
    out.J_add = [
        m_u * (c13 + c14),
        -arm_y * c11,
        -arm_z * c11,
        m_u * (c14 + c15),
        -arm_z * c12,
        m_u * (c13 + c15),
    ]
    out.C_add = C_s
    return out


def lost_digits(on: Arithmetic, model: Any) -> Any:
    """Zero as long as all constants are finite."""
    lost = 0.0
    for leg in range(6):
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].b[i]
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].p[i]
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].k[i]
        lost = lost + 0.0 * model.leg[leg].C_p
        lost = lost + 0.0 * model.leg[leg].C_s
        lost = lost + 0.0 * model.leg[leg].m_r
        lost = lost + 0.0 * model.leg[leg].j_r
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].h[i]
        lost = lost + 0.0 * model.leg[leg].h2_x
        lost = lost + 0.0 * model.leg[leg].h2_y
        lost = lost + 0.0 * model.leg[leg].h2_z
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].w[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].J[i]
        lost = lost + 0.0 * model.leg[leg].J2_xz
        lost = lost + 0.0 * model.leg[leg].dJ_zx
        lost = lost + 0.0 * model.leg[leg].g_k
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].g_x_k[i]
        lost = lost + 0.0 * model.leg[leg].C_us
        lost = lost + 0.0 * model.leg[leg].m_u
        lost = lost + 0.0 * model.leg[leg].M_add
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].h_add[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].J_add[i]
        lost = lost + 0.0 * model.leg[leg].C_add
    lost = lost + 0.0 * model.platform.M_P
    for i in range(3):
        lost = lost + 0.0 * model.platform.r_C[i]
    for i in range(6):
        lost = lost + 0.0 * model.platform.J_C[i]
    for i in range(3):
        lost = lost + 0.0 * model.platform.dJ_C[i]
    lost = lost + 0.0 * model.platform.C_P
    for i in range(3):
        lost = lost + 0.0 * model.platform.g[i]
    lost = lost + 0.0 * model.platform.M
    for i in range(3):
        lost = lost + 0.0 * model.platform.R_0[i]
    for i in range(6):
        lost = lost + 0.0 * model.platform.I_p[i]
    for i in range(3):
        lost = lost + 0.0 * model.platform.h_P[i]
    for i in range(6):
        lost = lost + 0.0 * model.platform.J_P[i]
    return lost


def prepare(on: Arithmetic, robot: Any) -> Any:
    """Constants of a robot, prepared once; the status is not OK if a number of the robot is not finite."""
    robot = on.arrays(on.checked(Robot(), "robot", robot))
    model = Model()
    total = Added()
    for i in range(6):
        found = prepare_leg(on, robot, robot.leg[0].p, robot.leg[i])
        model.leg[i] = found
        total = add_up(on, total, found)
    model.platform = prepare_platform(on, robot, robot.leg[0].p, total)
    largest = size_of(on, model)
    model.per_length = per_length_of(on, largest, on.SMALLEST)
    model.arm_cube = cube_of(on, largest * model.per_length)
    model.status = on.where(lost_digits(on, model) == 0.0, OK, NOT_FINITE)
    return model


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 277 (163 mul, 110 add, 2 div,
    2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = shared.B
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    rho2 = k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(zeta * zeta + rho2)
    rho = on.sqrt(rho2)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    inv_rho = 1.0 / rho
    # (10) second axis of the leg frame
    y_x = inv_rho * k_cross_S_x
    y_y = inv_rho * k_cross_S_y
    y_z = inv_rho * k_cross_S_z
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) velocity of the platform point
    S_dot_x = v_x + omega_y * q_z - omega_z * q_y
    S_dot_y = v_y + omega_z * q_x - omega_x * q_z
    S_dot_z = v_z + omega_x * q_y - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = inv_rho * (L_dot * k1 - S_dot_x * k_x - S_dot_y * k_y - S_dot_z * k_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # rho_dot / rho
    rho_share = L_share + lean
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates
    theta_ddot = (inv_rho * (L_ddot * k1 - S_ddot_x * k_x - S_ddot_y * k_y - S_ddot_z * k_z) - theta_dot * (L_share
        + rho_share))
    phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - rho_share * two_phi_dot
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_theta = a2 * (0.5 - k33) + a1 * k13
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    c1 = L_dot * theta_dot
    bend = c1
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c2 = j_r * k3
    c3 = c2 * phi_dot
    c4 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + gamma_n * w_k + C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y
        + omega_z * y_z) - M_phi_theta * phi_dot2 + L_dot * c3 + bend * h2_x + M_mixed * phi_ddot + M_theta
        * theta_ddot)
    tau_k = (L_ddot * c4 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + M_mixed_theta * theta_dot2
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n - c1 * c2 + two_phi_dot * (L_dot * M_phi_L + M_phi_theta
        * theta_dot) - bend * h2_y * k1 + M_phi * phi_ddot + M_mixed * theta_ddot)
    # (21) K = Q_k k + Q_y y, with a component along s
    Q_k = -inv_rho * tau_y
    Q_y = inv_rho * tau_k
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_k * k_x
    K_y = Q_y * y_y + Q_k * k_y
    K_z = Q_y * y_z + Q_k * k_z
    # (24) known part of the actuator force for this K
    D = (C_p * L_dot - h_x * theta_dot2 + L_ddot * m_r - M_phi_L * phi_dot2 - c3 * theta_dot + c4 * phi_ddot
        + h_z * theta_ddot - Q_k * k1)
    c5 = C_s * phi_dot
    c6 = C_s * theta_dot
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c5 * k_x + c6 * y_x, c5 * k_y + c6 * y_y, c5 * k_z + c6 * y_z]
    return out


def leg_near_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 301 (180 mul, 117 add, 2 div,
    2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = shared.B
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) velocity of the platform point
    S_dot_x = v_x + omega_y * q_z - omega_z * q_y
    S_dot_y = v_y + omega_z * q_x - omega_x * q_z
    S_dot_z = v_z + omega_x * q_y - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - 2.0 * L_share * theta_dot
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c1 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c1
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    c2 = L * h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    c4 = L_dot * theta_dot
    bend = c4
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c5 = j_r * k3
    c6 = c5 * phi_dot
    c7 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + L_dot * c6 + M_theta
        * own_theta_ddot + M_mixed * phi_ddot)
    tau_k = (L_ddot * c7 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + M_mixed_theta * theta_dot2
        + C_us * phi_dot - c4 * c5 - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot
        * (0.5 * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_z * z_x + Q_y * y_x
    K_y = Q_z * z_y + Q_y * y_y
    K_z = Q_z * z_z + Q_y * y_z
    # (24) known part of the actuator force for this K
    D = (C_p * L_dot - h_x * theta_dot2 + L_ddot * m_r - M_phi_L * phi_dot2 + h_z * theta_ddot - c6 * theta_dot
        + c7 * phi_ddot)
    c8 = C_s * phi_dot
    c9 = C_s * theta_dot
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c8 * k_x + c9 * y_x, c8 * k_y + c9 * y_y, c8 * k_z + c9 * y_z]
    return out


def forces(on: Arithmetic, model: Any, motion: Any) -> Any:
    """Actuator forces F, N, (37), and a status; F is NaN if the status is not OK."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = Forces()
    sums = Sums()
    A = [[0.0] * 7 for _ in range(6)]
    L = [0.0] * 6
    reach = [0.0] * 6
    x = [0.0] * 6
    status = model.status
    suspect = 0
    near = 0
    shared = shared_terms(on, model.platform, motion)
    for i in range(6):
        leg = leg_terms(on, model.leg[i], model.platform, motion, shared)
        reach[i] = reach_of(on, model.leg[i].b, motion.t, leg.q)
        fault = fault_of(on, leg.L, leg.k3, reach[i])
        status = on.where(status == OK, fault, status)
        suspect = on.where(leg.L > on.SHORT_SHARE * reach[i], suspect, 1)
        near = on.where(leg.k3 > on.NEAR_JOINT_SINGULAR, near, 1)
        sums.leg[i] = leg
    if on.anywhere(near == 1):
        for i in range(6):
            other = leg_near_terms(on, model.leg[i], model.platform, motion, shared)
            sums.leg[i] = on.where(near == 1, other, sums.leg[i])
    for j in range(3):
        sums.q_1[j] = sums.leg[0].q[j]
    tip = shift(on, sums, shared)
    for j in range(3):
        sums.c[j] = shared.c_force[j]
        sums.c[j + 3] = tip.c_tip[j]
    for i in range(6):
        leg = sums.leg[i]
        turned = MomentTerms()
        if i > 0:
            turned = moments_of(on, leg, sums)
        L[i] = leg.L
        for j in range(3):
            sums.arm[i][j] = leg.q[j] - sums.q_1[j]
            sums.H[j][i] = leg.H_force[j]
            sums.H[j + 3][i] = turned.H_moment[j]
            sums.c[j] = sums.c[j] + leg.c_force[j]
            sums.c[j + 3] = sums.c[j + 3] + leg.c_moment[j]
            sums.c[j + 3] = sums.c[j + 3] + turned.arm_c[j]
    for i in range(3):
        A[i][6] = sums.c[i]
        A[i + 3][6] = sums.c[i + 3] * model.per_length
        for j in range(6):
            A[i][j] = sums.H[i][j]
            A[i + 3][j] = sums.H[i + 3][j] * model.per_length
    small_pivot = solve_legs(on, A, model.arm_cube, x)
    suspect = on.where(small_pivot == 0, suspect, 1)
    if on.anywhere(suspect == 1):
        found = singular_status(on, sums.H, sums.arm, L, reach, largest_component(on, sums.q_1, 0.0))
        status = on.where((status == OK) & (suspect == 1), found, status)
    for i in range(6):
        out.F[i] = sums.leg[i].D - x[i]
        status = on.where((status != OK) | (on.size(out.F[i]) <= on.MAX), status, NOT_FINITE)
    for i in range(6):
        out.F[i] = on.where(status == OK, out.F[i], on.NAN)
    out.status = status
    return out


def equations_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 699 (433 mul, 262
    add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_z = leg.h2_x, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_xz, J_yy, J_yz, J_zz = leg.J
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) distance of the tip from the fixed axis
    rho = on.sqrt(k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z)
    inv_rho = 1.0 / rho
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    c1 = k3 * k3
    k33 = c1
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    c2 = J_xy - L * h_y
    a3 = c2
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    c3 = j_r * k1 - k3_h
    c4 = inv_L * inv_rho
    c5 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = c3 * inv_rho
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * c4
    m_leg_zz = M_theta * c5
    m_T_xs = m_r * s_x + m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yz * z_x + m_leg_yy * y_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_r * s_y + m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yz * z_y + m_leg_yy * y_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_r * s_z + m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yz * z_z + m_leg_yy * y_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    c6 = k3 * phi_dot
    c7 = 0.5 * j_r
    c8 = h_x * theta_dot + c6 * c7
    C_xi_12 = -c8
    c9 = c7 * k3
    c10 = c1 * h_x - h_z * k1 * k3
    C_xi_13 = -c9 * theta_dot - c10 * phi_dot
    C_xi_21 = c8
    C_xi_22 = L_dot * h_x
    c11 = 2.0 * L
    c12 = 2.0 * J_xz - c11 * h_z
    c13 = 0.5 * k1 * (2.0 * k3 * (J_zz - J_xx + c11 * h_x) + c12 * k1) - 0.5 * c1 * c12
    C_xi_23 = L_dot * c9 - c13 * phi_dot
    c14 = -c9 - h_y * k1
    C_xi_31 = c14 * theta_dot + c10 * phi_dot
    C_xi_32 = L_dot * c14 + theta_dot * (J_yz * k1 - c2 * k3) + c13 * phi_dot
    C_xi_33 = L_dot * c10 + c13 * theta_dot
    G_dot_12 = c6
    G_dot_21 = -inv_L * theta_dot
    c15 = k1 * phi_dot
    G_dot_22 = c15 * inv_L
    G_dot_23 = L_dot * c5
    G_dot_31 = -c6 * inv_rho
    G_dot_32 = -L_dot * c4 - inv_rho * kappa * theta_dot
    G_dot_33 = c15 * inv_rho
    C_leg_11 = G_dot_21 * h_z + G_dot_31 * c3
    C_leg_12 = G_dot_12 * m_r + G_dot_22 * h_z + G_dot_32 * c3 + C_xi_13 * inv_rho
    C_leg_13 = G_dot_23 * h_z - m_r * theta_dot + G_dot_33 * c3 - C_xi_12 * inv_L
    C_leg_21 = inv_rho * (G_dot_21 * M_mixed + C_xi_31 + G_dot_31 * M_phi)
    C_leg_22 = inv_rho * (C_xi_33 * inv_rho + G_dot_12 * c3 + G_dot_22 * M_mixed + G_dot_32 * M_phi)
    C_leg_23 = inv_rho * (G_dot_23 * M_mixed - c3 * theta_dot + G_dot_33 * M_phi - C_xi_32 * inv_L)
    C_leg_31 = -inv_L * (G_dot_21 * M_theta + C_xi_21 + G_dot_31 * M_mixed)
    C_leg_32 = -inv_L * (G_dot_12 * h_z + G_dot_22 * M_theta + G_dot_32 * M_mixed + C_xi_23 * inv_rho)
    C_leg_33 = -inv_L * (G_dot_23 * M_theta - C_xi_22 * inv_L - h_z * theta_dot + G_dot_33 * M_mixed)
    C_tip_T_xs = C_leg_11 * s_x + C_leg_21 * y_x + C_leg_31 * z_x
    C_tip_T_xy = C_leg_12 * s_x + C_leg_22 * y_x + C_leg_32 * z_x
    C_tip_T_xz = C_leg_23 * y_x + C_leg_33 * z_x + C_leg_13 * s_x
    C_tip_T_ys = C_leg_11 * s_y + C_leg_21 * y_y + C_leg_31 * z_y
    C_tip_T_yy = C_leg_12 * s_y + C_leg_22 * y_y + C_leg_32 * z_y
    C_tip_T_yz = C_leg_23 * y_y + C_leg_33 * z_y + C_leg_13 * s_y
    C_tip_T_zs = C_leg_11 * s_z + C_leg_21 * y_z + C_leg_31 * z_z
    C_tip_T_zy = C_leg_12 * s_z + C_leg_22 * y_z + C_leg_32 * z_z
    C_tip_T_zz = C_leg_23 * y_z + C_leg_33 * z_z + C_leg_13 * s_z
    # Coriolis matrix at the tip, base frame
    C_tip_xx = C_tip_T_xs * s_x + C_tip_T_xy * y_x + C_tip_T_xz * z_x
    C_tip_xy = C_tip_T_xs * s_y + C_tip_T_xy * y_y + C_tip_T_xz * z_y
    C_tip_xz = C_tip_T_xs * s_z + C_tip_T_xy * y_z + C_tip_T_xz * z_z
    C_tip_yx = C_tip_T_ys * s_x + C_tip_T_yy * y_x + C_tip_T_yz * z_x
    C_tip_yy = C_tip_T_ys * s_y + C_tip_T_yy * y_y + C_tip_T_yz * z_y
    C_tip_yz = C_tip_T_ys * s_z + C_tip_T_yy * y_z + C_tip_T_yz * z_z
    C_tip_zx = C_tip_T_zs * s_x + C_tip_T_zy * y_x + C_tip_T_zz * z_x
    C_tip_zy = C_tip_T_zs * s_y + C_tip_T_zy * y_y + C_tip_T_zz * z_y
    C_tip_zz = C_tip_T_zs * s_z + C_tip_T_zy * y_z + C_tip_T_zz * z_z
    c16 = C_tip_xy * q_z
    c17 = m_xy * w_q_z
    c18 = C_tip_xz * q_y
    c19 = m_xz * w_q_y
    C_q_xx = c19 - c17 + c18 - c16
    c20 = C_tip_xx * q_z
    C_q_xy = m_xx * w_q_z - m_xz * w_q_x + c20 - C_tip_xz * q_x
    c21 = C_tip_xx * q_y
    C_q_xz = m_xy * w_q_x - m_xx * w_q_y + C_tip_xy * q_x - c21
    c22 = C_tip_yy * q_z
    C_q_yx = m_yz * w_q_y - m_yy * w_q_z + C_tip_yz * q_y - c22
    c23 = C_tip_yx * q_z
    c24 = -C_tip_yz * q_x
    c25 = -m_yz * w_q_x
    C_q_yy = c17 + c25 + c23 + c24
    c26 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - m_xy * w_q_y - C_tip_yx * q_y - c26
    c27 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - m_yz * w_q_z - C_tip_zy * q_z - c27
    c28 = -C_tip_zz * q_x
    C_q_zy = m_xz * w_q_z - m_zz * w_q_x + C_tip_zx * q_z + c28
    c29 = C_tip_zx * q_y
    c30 = -C_tip_zy * q_x
    C_q_zz = -c19 - c25 - c29 - c30
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c31 = inv_L * (g_k * w_n + gamma_n * w_k)
    c32 = -gamma_n * w_y - gamma_y * w_n
    # force at the tip that balances gravity
    held_x = c32 * inv_rho * y_x - c31 * z_x
    held_y = c32 * inv_rho * y_y - c31 * z_y
    held_z = c32 * inv_rho * y_z - c31 * z_z
    c33 = L_dot * s_x
    c34 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c35 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c36 = L_dot * s_y
    c37 = L_dot * s_z
    # force at the tip that balances friction
    resistance_x = C_p * c33 + c34 * y_x - c35 * z_x
    resistance_y = C_p * c36 + c34 * y_y - c35 * z_y
    resistance_z = C_p * c37 + c34 * y_z - c35 * z_z
    # (3) derivative of s
    s_dot_x = inv_L * (S_dot_x - c33)
    s_dot_y = inv_L * (S_dot_y - c36)
    s_dot_z = inv_L * (S_dot_z - c37)
    c38 = m_xy * q_z
    c39 = m_xz * q_y
    c40 = -m_yz * q_x
    # m [q]x
    m_q_xx = c38 - c39
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c38 - c40
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c39 + c40
    out = EquationsLeg()
    out.M_vv = [m_xx, m_xy, m_xz, m_yy, m_yz, m_zz]
    out.M_vw = [-m_q_xx, -m_q_xy, -m_q_xz, -m_q_yx, -m_q_yy, -m_q_yz, -m_q_zx, -m_q_zy, -m_q_zz]
    out.M_ww = [
        m_q_yx * q_z - m_q_zx * q_y,
        m_q_yy * q_z - m_q_zy * q_y,
        m_q_yz * q_z - m_q_zz * q_y,
        m_q_zy * q_x - m_q_xy * q_z,
        m_q_zz * q_x - m_q_xz * q_z,
        m_q_xz * q_y - m_q_yz * q_x,
    ]
    out.C_vv = [C_tip_xx, C_tip_xy, C_tip_xz, C_tip_yx, C_tip_yy, C_tip_yz, C_tip_zx, C_tip_zy, C_tip_zz]
    out.C_vw = [C_q_xx, C_q_xy, C_q_xz, C_q_yx, C_q_yy, C_q_yz, C_q_zx, C_q_zy, C_q_zz]
    out.C_wv = [
        c29 - c23,
        C_tip_zy * q_y - c22,
        -c27 - C_tip_yz * q_z,
        c20 - C_tip_zx * q_x,
        c16 + c30,
        c28 + C_tip_xz * q_z,
        C_tip_yx * q_x - c21,
        -c26 - C_tip_xy * q_y,
        -c18 - c24,
    ]
    out.C_ww = [
        C_q_zx * q_y - C_q_yx * q_z,
        C_q_zy * q_y - C_q_yy * q_z,
        C_q_zz * q_y - C_q_yz * q_z,
        C_q_xx * q_z - C_q_zx * q_x,
        C_q_xy * q_z - C_q_zy * q_x,
        C_q_xz * q_z - C_q_zz * q_x,
        C_q_yx * q_x - C_q_xx * q_y,
        C_q_yy * q_x - C_q_xy * q_y,
        C_q_yz * q_x - C_q_xz * q_y,
    ]
    out.g_force = [held_x, held_y, held_z]
    out.g_moment = [held_z * q_y - held_y * q_z, held_x * q_z - held_z * q_x, held_y * q_x - held_x * q_y]
    out.friction_force = [resistance_x, resistance_y, resistance_z]
    out.friction_moment = [
        q_y * resistance_z - q_z * resistance_y - C_s * (k_x * phi_dot + theta_dot * y_x),
        q_z * resistance_x - q_x * resistance_z - C_s * (k_y * phi_dot + theta_dot * y_y),
        q_x * resistance_y - q_y * resistance_x - C_s * (k_z * phi_dot + theta_dot * y_z),
    ]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.H_dot_force = [s_dot_x, s_dot_y, s_dot_z]
    out.H_dot_moment = [
        q_y * s_dot_z + s_z * w_q_y - q_z * s_dot_y - s_y * w_q_z,
        q_z * s_dot_x + s_x * w_q_z - q_x * s_dot_z - s_z * w_q_x,
        q_x * s_dot_y + s_y * w_q_x - q_y * s_dot_x - s_x * w_q_y,
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def equations_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = equations_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def equations_near(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 734 (444 mul, 286
    add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_z = leg.h2_x, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_xz, J_yy, J_yz, J_zz = leg.J
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    c1 = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1 * inv_rho
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    k33 = k3 * k3
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    c2 = j_r * k1
    c3 = h_z * inv_L
    c4 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = inv_rho * (c2 - k3_h)
    m_leg_sz = -c3
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * c4
    m_T_xs = m_r * s_x + m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_r * s_y + m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_r * s_z + m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xz * z_x + m_T_xy * y_x
    m_xy = m_T_xs * s_y + m_T_xz * z_y + m_T_xy * y_y
    m_xz = m_T_xs * s_z + m_T_xz * z_z + m_T_xy * y_z
    m_yy = m_T_ys * s_y + m_T_yz * z_y + m_T_yy * y_y
    m_yz = m_T_ys * s_z + m_T_yz * z_z + m_T_yy * y_z
    m_zz = m_T_zs * s_z + m_T_zz * z_z + m_T_zy * y_z
    inv_k3 = L * inv_rho
    # (6) angular velocity of the leg about z
    W_z = c1 * inv_L
    c5 = c3 * theta_dot
    c6 = W_z * inv_L
    c7 = c6 * h_y
    c8 = c2 * inv_k3
    c9 = c6 * c8
    C_leg_11 = c7 - c5 - c9
    c10 = c6 * h_x
    c11 = inv_L * theta_dot
    c12 = c11 * j_r
    c13 = 0.5 * c12
    c14 = L_dot * c4
    c15 = c14 * h_y
    c16 = c11 * h_y
    c17 = inv_k3 * k1
    c18 = W_z * c3
    c19 = inv_k3 * inv_k3
    C_leg_12 = c15 - c14 * c8 + W_z * m_r + c13 + c16 * c17 - c12 * c19 + 2.0 * c17 * c18 - c10
    c20 = c6 * j_r
    c21 = c11 * h_x - 0.5 * c20 - c17 * c7
    C_leg_13 = c14 * h_z - m_r * theta_dot + c19 * c20 + c21
    c22 = c4 * theta_dot
    c23 = J_yz * c22
    c24 = J_xy * c22
    c25 = W_z * c4
    c26 = J_xx * c19
    c27 = 2.0 * J_xz
    c28 = c25 * c27
    c29 = J_xx - J_zz
    C_leg_21 = (W_z * c29 * c4 - c23 - c13 - c17 * c24 - c10 - c25 * c26 + W_z * h_z * inv_L * inv_k3 * k1 - c17
        * c28)
    c30 = J_xy * c25
    c31 = c14 * h_x
    c32 = c19 * c7
    c33 = inv_L * inv_L * inv_L
    c34 = L_dot * c33
    c35 = J_xz * c19
    c36 = c17 * c34
    c37 = J_yz * c25
    c38 = c17 * c37
    c39 = c19 * c30
    c40 = J_xx * k1 * inv_k3 * inv_k3 * inv_k3
    C_leg_22 = (L_dot * c29 * c33 - c26 * c34 - c31 + L_dot * c4 * h_z * inv_k3 * k1 - c27 * c36 + c19 * h_z
        * inv_L * theta_dot - c22 * c35 - c22 * c40 + c9 + c38 + c39 - c30 - c32)
    c41 = 0.5 * c14 * j_r
    c42 = c17 * c23
    c43 = J_yz * c34 + J_xy * c36 + c25 * c35 - c18 * c19
    C_leg_23 = c41 + c24 - c11 * c8 + c25 * c40 - c42 + c43
    C_leg_31 = J_yy * c22 + c37 + c17 * c30 + c21
    C_leg_32 = (c16 - c15 * c17 - c41 + c18 + c19 * c24 + c42 - c24 - c16 * c19 + c17 * c25 * (-J_yy - c29)
        - c28 + c43)
    C_leg_33 = c5 - J_yy * c34 - c31 + c30 + c32 - c7 - c38 - c39
    C_tip_T_xs = C_leg_11 * s_x + C_leg_31 * z_x + C_leg_21 * y_x
    C_tip_T_xy = C_leg_12 * s_x + C_leg_22 * y_x + C_leg_32 * z_x
    C_tip_T_xz = C_leg_23 * y_x + C_leg_13 * s_x + C_leg_33 * z_x
    C_tip_T_ys = C_leg_11 * s_y + C_leg_31 * z_y + C_leg_21 * y_y
    C_tip_T_yy = C_leg_12 * s_y + C_leg_22 * y_y + C_leg_32 * z_y
    C_tip_T_yz = C_leg_23 * y_y + C_leg_13 * s_y + C_leg_33 * z_y
    C_tip_T_zs = C_leg_11 * s_z + C_leg_31 * z_z + C_leg_21 * y_z
    C_tip_T_zy = C_leg_12 * s_z + C_leg_22 * y_z + C_leg_32 * z_z
    C_tip_T_zz = C_leg_23 * y_z + C_leg_13 * s_z + C_leg_33 * z_z
    # Coriolis matrix at the tip, base frame
    C_tip_xx = C_tip_T_xz * z_x + C_tip_T_xs * s_x + C_tip_T_xy * y_x
    C_tip_xy = C_tip_T_xz * z_y + C_tip_T_xs * s_y + C_tip_T_xy * y_y
    C_tip_xz = C_tip_T_xz * z_z + C_tip_T_xs * s_z + C_tip_T_xy * y_z
    C_tip_yx = C_tip_T_yz * z_x + C_tip_T_ys * s_x + C_tip_T_yy * y_x
    C_tip_yy = C_tip_T_yz * z_y + C_tip_T_ys * s_y + C_tip_T_yy * y_y
    C_tip_yz = C_tip_T_yz * z_z + C_tip_T_ys * s_z + C_tip_T_yy * y_z
    C_tip_zx = C_tip_T_zz * z_x + C_tip_T_zs * s_x + C_tip_T_zy * y_x
    C_tip_zy = C_tip_T_zz * z_y + C_tip_T_zs * s_y + C_tip_T_zy * y_y
    C_tip_zz = C_tip_T_zz * z_z + C_tip_T_zs * s_z + C_tip_T_zy * y_z
    c44 = C_tip_xy * q_z
    c45 = m_xy * w_q_z
    c46 = C_tip_xz * q_y
    c47 = m_xz * w_q_y
    C_q_xx = c47 - c45 + c46 - c44
    c48 = C_tip_xx * q_z
    C_q_xy = m_xx * w_q_z - m_xz * w_q_x + c48 - C_tip_xz * q_x
    c49 = C_tip_xx * q_y
    C_q_xz = m_xy * w_q_x - m_xx * w_q_y + C_tip_xy * q_x - c49
    c50 = C_tip_yy * q_z
    C_q_yx = m_yz * w_q_y - m_yy * w_q_z + C_tip_yz * q_y - c50
    c51 = C_tip_yx * q_z
    c52 = -C_tip_yz * q_x
    c53 = -m_yz * w_q_x
    C_q_yy = c45 + c53 + c51 + c52
    c54 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - m_xy * w_q_y - C_tip_yx * q_y - c54
    c55 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - m_yz * w_q_z - C_tip_zy * q_z - c55
    c56 = -C_tip_zz * q_x
    C_q_zy = m_xz * w_q_z - m_zz * w_q_x + C_tip_zx * q_z + c56
    c57 = C_tip_zx * q_y
    c58 = -C_tip_zy * q_x
    C_q_zz = -c47 - c53 - c57 - c58
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c59 = inv_L * (g_k * w_n + gamma_n * w_k)
    c60 = -gamma_n * w_y - gamma_y * w_n
    # force at the tip that balances gravity
    held_x = c60 * inv_rho * y_x - c59 * z_x
    held_y = c60 * inv_rho * y_y - c59 * z_y
    held_z = c60 * inv_rho * y_z - c59 * z_z
    c61 = L_dot * s_x
    c62 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c63 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c64 = L_dot * s_y
    c65 = L_dot * s_z
    # force at the tip that balances friction
    resistance_x = C_p * c61 + c62 * y_x - c63 * z_x
    resistance_y = C_p * c64 + c62 * y_y - c63 * z_y
    resistance_z = C_p * c65 + c62 * y_z - c63 * z_z
    # (3) derivative of s
    s_dot_x = inv_L * (S_dot_x - c61)
    s_dot_y = inv_L * (S_dot_y - c64)
    s_dot_z = inv_L * (S_dot_z - c65)
    c66 = m_xy * q_z
    c67 = m_xz * q_y
    c68 = -m_yz * q_x
    # m [q]x
    m_q_xx = c66 - c67
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c66 - c68
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c67 + c68
    out = EquationsLeg()
    out.M_vv = [m_xx, m_xy, m_xz, m_yy, m_yz, m_zz]
    out.M_vw = [-m_q_xx, -m_q_xy, -m_q_xz, -m_q_yx, -m_q_yy, -m_q_yz, -m_q_zx, -m_q_zy, -m_q_zz]
    out.M_ww = [
        m_q_yx * q_z - m_q_zx * q_y,
        m_q_yy * q_z - m_q_zy * q_y,
        m_q_yz * q_z - m_q_zz * q_y,
        m_q_zy * q_x - m_q_xy * q_z,
        m_q_zz * q_x - m_q_xz * q_z,
        m_q_xz * q_y - m_q_yz * q_x,
    ]
    out.C_vv = [C_tip_xx, C_tip_xy, C_tip_xz, C_tip_yx, C_tip_yy, C_tip_yz, C_tip_zx, C_tip_zy, C_tip_zz]
    out.C_vw = [C_q_xx, C_q_xy, C_q_xz, C_q_yx, C_q_yy, C_q_yz, C_q_zx, C_q_zy, C_q_zz]
    out.C_wv = [
        c57 - c51,
        C_tip_zy * q_y - c50,
        -c55 - C_tip_yz * q_z,
        c48 - C_tip_zx * q_x,
        c44 + c58,
        c56 + C_tip_xz * q_z,
        C_tip_yx * q_x - c49,
        -c54 - C_tip_xy * q_y,
        -c46 - c52,
    ]
    out.C_ww = [
        C_q_zx * q_y - C_q_yx * q_z,
        C_q_zy * q_y - C_q_yy * q_z,
        C_q_zz * q_y - C_q_yz * q_z,
        C_q_xx * q_z - C_q_zx * q_x,
        C_q_xy * q_z - C_q_zy * q_x,
        C_q_xz * q_z - C_q_zz * q_x,
        C_q_yx * q_x - C_q_xx * q_y,
        C_q_yy * q_x - C_q_xy * q_y,
        C_q_yz * q_x - C_q_xz * q_y,
    ]
    out.g_force = [held_x, held_y, held_z]
    out.g_moment = [held_z * q_y - held_y * q_z, held_x * q_z - held_z * q_x, held_y * q_x - held_x * q_y]
    out.friction_force = [resistance_x, resistance_y, resistance_z]
    out.friction_moment = [
        q_y * resistance_z - q_z * resistance_y - C_s * (k_x * phi_dot + theta_dot * y_x),
        q_z * resistance_x - q_x * resistance_z - C_s * (k_y * phi_dot + theta_dot * y_y),
        q_x * resistance_y - q_y * resistance_x - C_s * (k_z * phi_dot + theta_dot * y_z),
    ]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.H_dot_force = [s_dot_x, s_dot_y, s_dot_z]
    out.H_dot_moment = [
        q_y * s_dot_z + s_z * w_q_y - q_z * s_dot_y - s_y * w_q_z,
        q_z * s_dot_x + s_x * w_q_z - q_x * s_dot_z - s_z * w_q_x,
        q_x * s_dot_y + s_y * w_q_x - q_y * s_dot_x - s_x * w_q_y,
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def equations_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs, by other blocks if a leg is near its joint singularity."""
    pose = equations_pose(on, model.platform, motion)
    equations_legs(on, model, motion, pose, legs)
    if on.anywhere(legs.leaning == 1):
        for i in range(6):
            near = equations_near(on, model.leg[i], model.platform, motion, pose, legs.given[i])
            legs.leg[i] = on.where(legs.leaning == 1, near, legs.leg[i])
    equations_total(on, pose, legs, summed)


def equations(on: Arithmetic, model: Any, motion: Any) -> Any:
    """M, C, g, friction, bias, H and its rate of M [a; alpha] + C [v; omega] + g + friction = H F +
    loads.
    """
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = Equations()
    legs = EquationsLegs()
    summed = EquationsSums()
    equations_sums(on, model, motion, legs, summed)
    place_inertia_6(on, summed.M_vv, summed.M_vw, summed.M_ww, 0, out.M)
    place_blocks_6(on, summed.C_vv, summed.C_vw, summed.C_wv, summed.C_ww, 0, out.C)
    for i in range(3):
        out.g[i] = summed.g_force[i]
        out.g[i + 3] = summed.g_moment[i]
        out.friction[i] = summed.friction_force[i]
        out.friction[i + 3] = summed.friction_moment[i]
        for j in range(6):
            out.H[i][j] = legs.leg[j].H_force[i]
            out.H[i + 3][j] = legs.leg[j].H_moment[i]
            out.H_dot[i][j] = legs.leg[j].H_dot_force[i]
            out.H_dot[i + 3][j] = legs.leg[j].H_dot_moment[i]
    for i in range(6):
        total_bias = out.g[i]
        for j in range(3):
            total_bias = total_bias + out.C[i][j] * motion.v[j] + out.C[i][j + 3] * motion.omega[j]
        out.bias[i] = total_bias
        out.bias_and_friction[i] = total_bias + out.friction[i]
    out.status = legs.status
    check_equations(on, out)
    return out


def bias_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of C twist + g + friction: 327 (197 mul, 126 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    B_0_xx, B_0_xy, B_0_xz, B_0_yx, B_0_yy, B_0_yz, B_0_zx, B_0_zy, B_0_zz = pose.B_0
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) distance of the tip from the fixed axis
    rho = on.sqrt(k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z)
    inv_rho = 1.0 / rho
    # relative component of the normal along s: rounding
    n_along_s = inv_rho * (k_cross_S_x * s_x + k_cross_S_y * s_y + k_cross_S_z * s_z)
    # one over |s x normal|
    inv_across = inv_rho + 0.5 * inv_rho * n_along_s * n_along_s
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) third axis of the leg frame
    z_x = inv_across * s_cross_normal_x
    z_y = inv_across * s_cross_normal_y
    z_z = inv_across * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = B_0_xx * q_x + B_0_xy * q_y + B_0_xz * q_z
    S_ddot_y = B_0_yx * q_x + B_0_yy * q_y + B_0_yz * q_z
    S_ddot_z = B_0_zx * q_x + B_0_zy * q_y + B_0_zz * q_z
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - 2.0 * L_share * theta_dot
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c1 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c1
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    c2 = L * h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    c4 = L_dot * theta_dot
    bend = c4
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c5 = j_r * k3
    c6 = c5 * phi_dot
    c7 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + L_dot * c6 + M_theta
        * own_theta_ddot + M_mixed * phi_ddot)
    tau_k = (L_ddot * c7 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + M_mixed_theta * theta_dot2
        + C_us * phi_dot - c4 * c5 - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot
        * (0.5 * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_z * z_x + Q_y * y_x
    K_y = Q_z * z_y + Q_y * y_y
    K_z = Q_z * z_z + Q_y * y_z
    # (24) known part of the actuator force for this K
    D = (C_p * L_dot - h_x * theta_dot2 + L_ddot * m_r - M_phi_L * phi_dot2 + h_z * theta_ddot - c6 * theta_dot
        + c7 * phi_ddot)
    # force at the tip
    R_tip_x = D * s_x + K_x
    R_tip_y = D * s_y + K_y
    R_tip_z = D * s_z + K_z
    out = BiasLeg()
    out.bias_force = [R_tip_x, R_tip_y, R_tip_z]
    out.bias_moment = [
        R_tip_z * q_y - R_tip_y * q_z - C_s * (k_x * phi_dot + theta_dot * y_x),
        R_tip_x * q_z - R_tip_z * q_x - C_s * (k_y * phi_dot + theta_dot * y_y),
        R_tip_y * q_x - R_tip_x * q_y - C_s * (k_z * phi_dot + theta_dot * y_z),
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def bias_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = bias_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def bias_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = bias_pose(on, model.platform, motion)
    bias_legs(on, model, motion, pose, legs)
    bias_total(on, pose, legs, summed)


def bias_and_friction(on: Arithmetic, model: Any, motion: Any) -> Any:
    """C [v; omega] + g + friction without C."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = BiasAndFriction()
    legs = BiasLegs()
    summed = BiasSums()
    bias_sums(on, model, motion, legs, summed)
    for i in range(3):
        out.bias_and_friction[i] = summed.bias_force[i]
        out.bias_and_friction[i + 3] = summed.bias_moment[i]
    out.status = legs.status
    check_bias_and_friction(on, out)
    return out


def forward_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M and of the right side: 453 (277 mul, 172 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    B_0_xx, B_0_xy, B_0_xz, B_0_yx, B_0_yy, B_0_yz, B_0_zx, B_0_zy, B_0_zz = pose.B_0
    F = given.F
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) distance of the tip from the fixed axis
    rho = on.sqrt(k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z)
    inv_rho = 1.0 / rho
    # relative component of the normal along s: rounding
    n_along_s = inv_rho * (k_cross_S_x * s_x + k_cross_S_y * s_y + k_cross_S_z * s_z)
    # one over |s x normal|
    inv_across = inv_rho + 0.5 * inv_rho * n_along_s * n_along_s
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) third axis of the leg frame
    z_x = inv_across * s_cross_normal_x
    z_y = inv_across * s_cross_normal_y
    z_z = inv_across * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = B_0_xx * q_x + B_0_xy * q_y + B_0_xz * q_z
    S_ddot_y = B_0_yx * q_x + B_0_yy * q_y + B_0_yz * q_z
    S_ddot_z = B_0_zx * q_x + B_0_zy * q_y + B_0_zz * q_z
    k33 = k3 * k3
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - 2.0 * L_share * theta_dot
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c1 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c1 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c1
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    c2 = L * h2_z
    c3 = J2_xz - c2
    a2 = c3
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    c4 = L_dot * theta_dot
    bend = c4
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c5 = j_r * k3
    c6 = c5 * phi_dot
    c7 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + L_dot * c6 + M_theta
        * own_theta_ddot + M_mixed * phi_ddot)
    tau_k = (L_ddot * c7 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + M_mixed_theta * theta_dot2
        + C_us * phi_dot - c4 * c5 - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot
        * (0.5 * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_z * z_x + Q_y * y_x
    K_y = Q_z * z_y + Q_y * y_y
    K_z = Q_z * z_z + Q_y * y_z
    # (24) known part of the actuator force for this K
    D = (C_p * L_dot - h_x * theta_dot2 + L_ddot * m_r - M_phi_L * phi_dot2 + h_z * theta_ddot - c6 * theta_dot
        + c7 * phi_ddot)
    c8 = F - D
    # force on the platform at the tip
    push_x = c8 * s_x - K_x
    push_y = c8 * s_y - K_y
    push_z = c8 * s_z - K_z
    # inertia at the tip, leg frame
    m_leg_sy = c7 * inv_rho
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * inv_L * inv_L
    m_T_xs = m_r * s_x + m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_r * s_y + m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_r * s_z + m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xz * z_x + m_T_xy * y_x
    m_xy = m_T_xs * s_y + m_T_xz * z_y + m_T_xy * y_y
    m_xz = m_T_xs * s_z + m_T_xz * z_z + m_T_xy * y_z
    m_yy = m_T_ys * s_y + m_T_yz * z_y + m_T_yy * y_y
    m_yz = m_T_ys * s_z + m_T_yz * z_z + m_T_yy * y_z
    m_zz = m_T_zs * s_z + m_T_zz * z_z + m_T_zy * y_z
    c9 = m_xy * q_z
    c10 = m_xz * q_y
    c11 = -m_yz * q_x
    # m [q]x
    m_q_xx = c9 - c10
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c9 - c11
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c10 + c11
    out = ForwardLeg()
    out.M_vv = [m_xx, m_xy, m_xz, m_yy, m_yz, m_zz]
    out.M_vw = [-m_q_xx, -m_q_xy, -m_q_xz, -m_q_yx, -m_q_yy, -m_q_yz, -m_q_zx, -m_q_zy, -m_q_zz]
    out.M_ww = [
        m_q_yx * q_z - m_q_zx * q_y,
        m_q_yy * q_z - m_q_zy * q_y,
        m_q_yz * q_z - m_q_zz * q_y,
        m_q_zy * q_x - m_q_xy * q_z,
        m_q_zz * q_x - m_q_xz * q_z,
        m_q_xz * q_y - m_q_yz * q_x,
    ]
    out.right_force = [push_x, push_y, push_z]
    out.right_moment = [
        push_z * q_y - push_y * q_z + C_s * (k_x * phi_dot + theta_dot * y_x),
        push_x * q_z - push_z * q_x + C_s * (k_y * phi_dot + theta_dot * y_y),
        push_y * q_x - push_x * q_y + C_s * (k_z * phi_dot + theta_dot * y_z),
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def forward_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = forward_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def forward_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = forward_pose(on, model.platform, motion)
    forward_legs(on, model, motion, pose, legs)
    forward_total(on, pose, legs, summed)


def joint_rows_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's inertia and generalized forces in its joint coordinates, and their gradients: 354 (214
    mul, 136 add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_u, C_p, C_s, m_r, j_r = leg.m_u, leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_y, h2_z = leg.h2_x, leg.h2_y, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_yy, J_yz = leg.J[0], leg.J[1], leg.J[3], leg.J[4]
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    B_0_xx, B_0_xy, B_0_xz, B_0_yx, B_0_yy, B_0_yz, B_0_zx, B_0_zy, B_0_zz = pose.B_0
    F = given.F
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    # L_dot / L
    L_share = L_dot * inv_L
    lean = kappa * theta_dot
    theta_dot2 = theta_dot * theta_dot
    phi_dot2 = phi_dot * phi_dot
    two_phi_dot = 2.0 * phi_dot
    c1 = B_0_xx * q_x + B_0_xy * q_y + B_0_xz * q_z
    c2 = B_0_yx * q_x + B_0_yy * q_y + B_0_yz * q_z
    c3 = B_0_zx * q_x + B_0_zy * q_y + B_0_zz * q_z
    # (7) acceleration of the platform point, a = alpha = 0
    S_ddot_x = c1
    S_ddot_y = c2
    S_ddot_z = c3
    c4 = k3 * k3
    k33 = c4
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - 2.0 * L_share * theta_dot
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c5 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c5 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c5
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    c6 = L * h2_z
    c7 = J2_xz - c6
    a2 = c7
    a3 = J_xy - L * h_y
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = J_yz * k3 + a3 * k1
    k3_h = h_y * k3
    # (19) derivatives of M_phi / 2 by theta and L, of M_mixed by theta
    M_phi_L = h_x * k33 - h_z * k13
    M_mixed_theta = J_yz * k1 - a3 * k3
    c8 = L_dot * theta_dot
    bend = c8
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c9 = j_r * k3
    c10 = c9 * phi_dot
    c11 = j_r * k1 - k3_h
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c7 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + L_dot * c10
        + M_theta * own_theta_ddot + M_mixed * phi_ddot)
    tau_k = (L_ddot * c11 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) + M_mixed_theta * theta_dot2
        + C_us * phi_dot - c8 * c9 - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot
        * (0.5 * J2_xz - 0.5 * c6 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # acceleration of the platform point relative to free fall, a = alpha = 0
    fall_x = c1 - g_x
    fall_y = c2 - g_y
    fall_z = c3 - g_z
    fall_T_x = fall_x * s_x + fall_y * s_y + fall_z * s_z
    fall_T_y = fall_x * y_x + fall_y * y_y + fall_z * y_z
    fall_T_z = fall_x * z_x + fall_y * z_y + fall_z * z_z
    row_v_yx = -inv_L * z_x
    row_v_yy = -inv_L * z_y
    row_v_yz = -inv_L * z_z
    row_v_zx = inv_rho * y_x
    row_v_zy = inv_rho * y_y
    row_v_zz = inv_rho * y_z
    c12 = m_u * L * L
    c13 = L * m_u
    out = JointRowsLeg()
    out.M_vv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_vw = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_ww = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.right_force = [0.0, 0.0, 0.0]
    out.right_moment = [
        C_s * (k_x * phi_dot + theta_dot * y_x),
        C_s * (k_y * phi_dot + theta_dot * y_y),
        C_s * (k_z * phi_dot + theta_dot * y_z),
    ]
    out.M_xi = [m_r + m_u, h_z, c11, M_theta + c12, M_mixed, M_phi + c12 * c4]
    out.row_v = [s_x, s_y, s_z, row_v_yx, row_v_yy, row_v_yz, row_v_zx, row_v_zy, row_v_zz]
    out.row_w = [
        q_y * s_z - q_z * s_y,
        q_z * s_x - q_x * s_z,
        q_x * s_y - q_y * s_x,
        q_y * row_v_yz - q_z * row_v_yy,
        q_z * row_v_yx - q_x * row_v_yz,
        q_x * row_v_yy - q_y * row_v_yx,
        q_y * row_v_zz - q_z * row_v_zy,
        q_z * row_v_zx - q_x * row_v_zz,
        q_x * row_v_zy - q_y * row_v_zx,
    ]
    out.tau = [
        C_p * L_dot + L_ddot * m_r + c11 * phi_ddot + fall_T_x * m_u + h_z * theta_ddot - F - M_phi_L * phi_dot2
            - c10 * theta_dot - h_x * theta_dot2,
        tau_y - c13 * fall_T_z,
        tau_k + c13 * fall_T_y * k3,
    ]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def joint_rows_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = joint_rows_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def joint_rows_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = joint_rows_pose(on, model.platform, motion)
    joint_rows_legs(on, model, motion, pose, legs)
    joint_rows_total(on, pose, legs, summed)


def forward_apart(on: Arithmetic, model: Any, motion: Any, F: Any, by: Any) -> Any:
    """Forward dynamics in the accelerations of the six stiffest rows; by: the rows, what legs are given."""
    out = Apart()
    legs = JointRowsLegs()
    summed = JointRowsSums()
    force = [0.0] * 24
    wrench = [0.0] * 6
    start = [0.0] * 6
    rest = [0.0] * 24
    held = [0.0] * 6
    right = [0.0] * 6
    A = [[0.0] * 8 for _ in range(6)]
    for i in range(6):
        legs.given[i].F = F[i]
    joint_rows_sums(on, model, motion, legs, summed)
    make_rows(on, summed, legs, by)
    pick_rows(on, by)
    weigh_rows(on, by)
    for i in range(6):
        for j in range(3):
            force[3 * i + j] = legs.leg[i].tau[j] / by.extent[3 * i + j]
    for i in range(3):
        wrench[i] = summed.right_force[i]
        wrench[i + 3] = summed.right_moment[i]
    by_rows(on, by, wrench, held)
    row_right(on, by, force, held, start, rest, right)
    for i in range(6):
        A[i][6] = right[i]
        for j in range(6):
            A[i][j] = by.inertia[i][j]
    fault = solve_definite_8(on, A, on.ROUNDING)
    for i in range(6):
        right[i] = A[i][6]
    row_back(on, by, right, start, out.x)
    rows_held(on, legs, by, right, start, rest, held)
    out.status = on.where(legs.status == OK, fault, legs.status)
    for i in range(6):
        out.status = on.where((out.status != OK) | (on.size(out.x[i]) <= on.MAX), out.status, NOT_FINITE)
    return out


def forward_dynamics(on: Arithmetic, model: Any, motion: Any, F: Any) -> Any:
    """Accelerations a and alpha of the platform under the actuator forces F, N; a and alpha are not
    read.
    """
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    F = on.arrays(on.checked([0.0] * 6, "F", F))
    on.agree(motion=motion, F=F)
    out = Accelerations()
    legs = ForwardLegs()
    summed = ForwardSums()
    for i in range(6):
        legs.given[i].F = F[i]
    forward_sums(on, model, motion, legs, summed)
    accelerations_of(on, legs, summed, out)
    if on.anywhere(out.status == MASS_MATRIX_INDEFINITE):
        by = Rows()
        apart = forward_apart(on, model, motion, F, by)
        lost = on.where(out.status == MASS_MATRIX_INDEFINITE, 1, 0)
        for i in range(3):
            out.a[i] = on.where(lost == 1, apart.x[i], out.a[i])
            out.alpha[i] = on.where(lost == 1, apart.x[i + 3], out.alpha[i])
        out.status = on.where(lost == 1, apart.status, out.status)
    check_forward_dynamics(on, out)
    return out


def joint_inertia(on: Arithmetic, model: Any, motion: Any) -> Any:
    """Mass matrix for leg lengths as coordinates, H^-1 M H^-T."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = JointInertia()
    legs = EquationsLegs()
    summed = EquationsSums()
    A = [[0.0] * 12 for _ in range(6)]
    half = [[0.0] * 6 for _ in range(6)]
    equations_sums(on, model, motion, legs, summed)
    status = legs.status
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
    place_inertia_12(on, summed.M_vv, summed.M_vw, summed.M_ww, 6, A)
    scale_moments_12(on, model.per_length, A)
    close = solve_pivoted_12(on, A)
    for i in range(6):
        close = on.where(legs.leg[i].L > on.SHORT_SHARE * legs.reach[i], close, 1)
        for j in range(6):
            half[i][j] = A[i][j + 6]
    if on.anywhere((status == OK) & (close == 1)):
        found = columns_status(on, model, motion, legs)
        status = on.where((status == OK) & (close == 1), found, status)
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
            A[i][j + 6] = half[j][i]
            A[i + 3][j + 6] = half[j][i + 3]
    scale_moments_12(on, model.per_length, A)
    solve_pivoted_12(on, A)
    for i in range(6):
        for j in range(6):
            out.inertia[i][j] = (A[i][j + 6] + A[j][i + 6]) * 0.5
    out.status = status
    check_joint_inertia(on, out)
    return out


def derivatives_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench: 1669 (978 mul, 687 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_z = leg.h2_x, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_xz, J_yy, J_yz, J_zz = leg.J
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = pose.B
    F = given.F
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) distance of the tip from the fixed axis
    rho = on.sqrt(k_cross_S_x * k_cross_S_x + k_cross_S_y * k_cross_S_y + k_cross_S_z * k_cross_S_z)
    inv_rho = 1.0 / rho
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = inv_rho * (S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z)
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    c1 = L_dot * inv_L
    # L_dot / L
    L_share = c1
    c2 = kappa * theta_dot
    lean = c2
    c3 = theta_dot * theta_dot
    theta_dot2 = c3
    c4 = phi_dot * phi_dot
    phi_dot2 = c4
    c5 = 2.0 * phi_dot
    two_phi_dot = c5
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    c6 = k3 * k3
    k33 = c6
    # (8) accelerations of the joint coordinates
    L_ddot = L * (theta_dot2 + k33 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    c7 = 2.0 * theta_dot
    # (9) accelerations of the joint coordinates without the rotation of the leg frame about s
    own_theta_ddot = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - L_share * c7
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    c8 = k1 * k3
    # (9) accelerations of the joint coordinates
    theta_ddot = c8 * phi_dot2 + own_theta_ddot
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    k13 = c8
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    c9 = J_xy - L * h_y
    a3 = c9
    c10 = J_yz * k3
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = c10 + a3 * k1
    c11 = h_y * k3
    k3_h = c11
    c12 = j_r * k1
    c13 = c12 - k3_h
    c14 = inv_rho * inv_rho
    c15 = inv_L * inv_rho
    c16 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = c13 * inv_rho
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * c14
    m_leg_yz = -M_mixed * c15
    m_leg_zz = M_theta * c16
    m_T_xs = m_r * s_x + m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yz * z_x + m_leg_yy * y_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_r * s_y + m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yz * z_y + m_leg_yy * y_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_r * s_z + m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yz * z_z + m_leg_yy * y_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # k x y
    normal_x = k_y * y_z - k_z * y_y
    normal_y = k_z * y_x - k_x * y_z
    normal_z = k_x * y_y - k_y * y_x
    # omega along k x y, y and k
    w_n_omega = normal_x * omega_x + normal_y * omega_y + normal_z * omega_z
    w_y_omega = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_k_omega = k_x * omega_x + k_y * omega_y + k_z * omega_z
    c17 = j_r * k1 - c11
    c18 = h_x * theta_dot
    c19 = k3 * phi_dot
    c20 = c19 * j_r
    c21 = c18 + 0.5 * c20
    c22 = j_r * k3
    c23 = 0.5 * c22
    c24 = c6 * h_x
    c25 = c24 - h_z * k1 * k3
    tau_L = (C_p * L_dot + L_ddot * m_r + h_z * theta_ddot + phi_dot * (-c23 * theta_dot - c25 * phi_dot) + c17
        * phi_ddot - c21 * theta_dot)
    c27 = 2.0 * L
    c28 = c27 * h_x
    c29 = k3 * w_z + k1 * w_x
    c30 = k1 * w_z - k3 * w_x
    c32 = c10 + c9 * k1
    c33 = 2.0 * J_xz - c27 * h_z
    c34 = c33 * k1
    c35 = J_zz - J_xx + c28
    c36 = c35 * k3
    c37 = 2.0 * c36 + c34
    c38 = 0.5 * k1
    c39 = c37 * c38 - 0.5 * c33 * c6
    tau_theta = (L_ddot * h_z - c30 * g_k + C_us * theta_dot + L_dot * c18 + c29 * gamma_n - C_s * w_y_omega
        + phi_dot * (L_dot * c23 - c39 * phi_dot) + theta_ddot * (J_yy + c28) + L_dot * c21 + c32 * phi_ddot)
    c41 = h_y * k1
    c42 = -c23 - c41
    c43 = c42 * theta_dot
    c44 = L_dot * c25
    c45 = c39 * theta_dot
    c46 = L_dot * c42
    c47 = theta_dot * (J_yz * k1 - c9 * k3)
    tau_phi = (L_ddot * c17 - C_s * w_k_omega + c30 * gamma_y + C_us * phi_dot + phi_dot * (c44 + c45) - gamma_n
        * w_y + L_dot * (c43 + c25 * phi_dot) + theta_dot * (c46 + c47 + c39 * phi_dot) + c32 * theta_ddot + phi_ddot
        * (J_xx + c35 * c6 + c33 * c8))
    G_dot_12 = c19
    c48 = inv_L * theta_dot
    G_dot_21 = -c48
    c49 = k1 * phi_dot
    G_dot_22 = c49 * inv_L
    c50 = L_dot * c16
    G_dot_23 = c50
    c51 = c19 * inv_rho
    G_dot_31 = -c51
    c52 = c1 * inv_rho
    c53 = -c52 - c2 * inv_rho
    G_dot_32 = c53
    c54 = c49 * inv_rho
    G_dot_33 = c54
    c55 = c4 * c6
    G_ddot_11 = -c3 - c55
    c56 = k3 * phi_ddot
    c57 = c5 * k1
    G_ddot_12 = c57 * theta_dot + c56
    c58 = c4 * c8
    G_ddot_13 = c58 - theta_ddot
    G_ddot_21 = 2.0 * L_dot * c16 * theta_dot - c58 * inv_L - inv_L * theta_ddot
    G_ddot_22 = inv_L * k1 * phi_ddot - c48 * c5 * k3 - c50 * c57
    c59 = c4 * k1 * k1
    G_ddot_23 = c3 * inv_L - 2.0 * L_dot * L_dot * inv_L * inv_L * inv_L + c59 * inv_L + L_ddot * c16
    G_ddot_31 = (c1 * c51 + c54 * theta_dot - c19 * c53 + theta_dot * (inv_rho * k3 * kappa * phi_dot - c54)
        - c56 * inv_rho)
    c60 = inv_rho * kappa
    c61 = -c1 - c2
    G_ddot_32 = (L_dot * (c50 * inv_rho - c15 * c61) - c55 * inv_rho - c59 * inv_rho - L_ddot * c15 + theta_dot
        * (-inv_rho * theta_dot * (-1.0 - kappa * kappa) - c60 * c61) - c60 * theta_ddot)
    G_ddot_33 = (c49 * c53 + c51 * theta_dot - c49 * c52 + theta_dot * (-c51 - c54 * kappa) + inv_rho * k1 * phi_ddot)
    c62 = 2.0 * c18 + c20
    tau_rate_12 = -c62
    tau_rate_13 = -c22 * theta_dot - 2.0 * c25 * phi_dot
    tau_rate_21 = c62
    c63 = 2.0 * h_x
    tau_rate_22 = C_us + L_dot * c63
    tau_rate_23 = L_dot * c22 - c39 * c5
    tau_rate_31 = 2.0 * c43 + c25 * c5
    tau_rate_32 = 2.0 * c46 + 2.0 * c47 + c39 * c5
    tau_rate_33 = C_us + 2.0 * c44 + 2.0 * c45
    c64 = h_z * k3
    c65 = 0.5 * j_r
    c66 = c65 * theta_dot
    c67 = c63 * k3 - h_z * k1
    tau_place_12 = (k1 * (phi_dot * (-c66 - c67 * phi_dot) - c66 * phi_dot - h_y * phi_ddot) - k3 * (c4 * c64
        + j_r * phi_ddot))
    c68 = 4.0 * h_x
    c69 = c6 * h_z + c38 * (c68 * k3 - 2.0 * h_z * k1)
    tau_place_21 = c63 * theta_ddot - c4 * c69 - c41 * phi_ddot
    c70 = c36 + c34
    c71 = L_dot * c65
    c72 = c38 * (2.0 * J_zz - 2.0 * J_xx + L * c68) - c33 * k3
    tau_place_22 = (k1 * (g_k * w_x + gamma_n * w_z + c71 * phi_dot + phi_dot * (c71 - c72 * phi_dot) + J_yz
        * phi_ddot) - k3 * (gamma_n * w_x - g_k * w_z - c4 * c70 + c9 * phi_ddot))
    tau_place_23 = -c29 * gamma_y - C_s * w_n_omega
    c73 = c69 * phi_dot
    tau_place_31 = (c73 * theta_dot + theta_dot * (c11 * theta_dot + c73) - c41 * theta_ddot + phi_ddot * (2.0
        * (c24 - c8 * h_z)))
    tau_place_32 = (k1 * (phi_dot * (L_dot * c67 + c72 * theta_dot) - L_ddot * h_y - gamma_y * w_x + L_dot * (c67
        * phi_dot - c66) + theta_dot * (c72 * phi_dot - c71 - c9 * theta_dot) + J_yz * theta_ddot + c37 * phi_ddot)
        - k3 * (L_ddot * j_r + gamma_y * w_z + phi_dot * (c70 * theta_dot - L_dot * c64) + theta_dot * (J_yz
        * theta_dot - L_dot * h_y + c70 * phi_dot) + c9 * theta_ddot + L_dot * (-h_y * theta_dot - c19 * h_z)
        + c33 * c56))
    tau_place_33 = c30 * gamma_n + gamma_y * w_y
    c74 = inv_rho * tau_phi
    c75 = inv_L * tau_theta
    c76 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c74 * y_x + c76 * s_x - c75 * z_x
    R_tip_y = c74 * y_y + c76 * s_y - c75 * z_y
    R_tip_z = c74 * y_z + c76 * s_z - c75 * z_z
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_32 * y_x + G_dot_33 * z_x + G_dot_31 * s_x)
    phi_dot_by_S_y = C_s * (G_dot_32 * y_y + G_dot_33 * z_y + G_dot_31 * s_y)
    phi_dot_by_S_z = C_s * (G_dot_32 * y_z + G_dot_33 * z_z + G_dot_31 * s_z)
    c77 = C_s * inv_L
    # gradient of theta, times C_s
    C_s_theta_x = -c77 * z_x
    C_s_theta_y = -c77 * z_y
    C_s_theta_z = -c77 * z_z
    c78 = C_s * inv_rho
    # gradient of phi, times C_s
    C_s_phi_x = c78 * y_x
    C_s_phi_y = c78 * y_y
    C_s_phi_z = c78 * y_z
    y_by_phi_x = normal_x * theta_dot
    y_by_phi_y = normal_y * theta_dot
    y_by_phi_z = normal_z * theta_dot
    # friction moment by S
    f_S_xx = C_s_phi_x * y_by_phi_x + theta_dot_by_S_x * y_x + k_x * phi_dot_by_S_x
    f_S_xy = C_s_phi_y * y_by_phi_x + theta_dot_by_S_y * y_x + k_x * phi_dot_by_S_y
    f_S_xz = C_s_phi_z * y_by_phi_x + theta_dot_by_S_z * y_x + k_x * phi_dot_by_S_z
    f_S_yx = C_s_phi_x * y_by_phi_y + theta_dot_by_S_x * y_y + k_y * phi_dot_by_S_x
    f_S_yy = C_s_phi_y * y_by_phi_y + theta_dot_by_S_y * y_y + k_y * phi_dot_by_S_y
    f_S_yz = C_s_phi_z * y_by_phi_y + theta_dot_by_S_z * y_y + k_y * phi_dot_by_S_z
    f_S_zx = C_s_phi_x * y_by_phi_z + theta_dot_by_S_x * y_z + k_z * phi_dot_by_S_x
    f_S_zy = C_s_phi_y * y_by_phi_z + theta_dot_by_S_y * y_z + k_z * phi_dot_by_S_y
    f_S_zz = C_s_phi_z * y_by_phi_z + theta_dot_by_S_z * y_z + k_z * phi_dot_by_S_z
    # friction moment by S_dot
    f_S_dot_xx = C_s_theta_x * y_x + C_s_phi_x * k_x
    f_S_dot_xy = C_s_theta_y * y_x + C_s_phi_y * k_x
    f_S_dot_xz = C_s_theta_z * y_x + C_s_phi_z * k_x
    f_S_dot_yx = C_s_theta_x * y_y + C_s_phi_x * k_y
    f_S_dot_yy = C_s_theta_y * y_y + C_s_phi_y * k_y
    f_S_dot_yz = C_s_theta_z * y_y + C_s_phi_z * k_y
    f_S_dot_zx = C_s_theta_x * y_z + C_s_phi_x * k_z
    f_S_dot_zy = C_s_theta_y * y_z + C_s_phi_y * k_z
    f_S_dot_zz = C_s_theta_z * y_z + C_s_phi_z * k_z
    A_0_leg_11 = (G_ddot_11 * m_r + G_dot_31 * tau_rate_13 + G_dot_21 * tau_rate_12 + G_ddot_21 * h_z + G_ddot_31
        * c13)
    A_0_leg_12 = (C_p * G_dot_12 + G_dot_32 * tau_rate_13 + G_dot_22 * tau_rate_12 + G_ddot_12 * m_r + G_ddot_22
        * h_z + G_ddot_32 * c13 - c14 * k3 * tau_phi)
    c79 = c16 * tau_theta
    A_0_leg_13 = (G_ddot_23 * h_z - C_p * theta_dot + G_dot_33 * tau_rate_13 + G_dot_23 * tau_rate_12 + G_ddot_13
        * m_r + G_ddot_33 * c13 + c79 - inv_L * tau_place_12)
    c80 = c15 * tau_phi
    A_0_leg_21 = (inv_rho * (G_ddot_11 * c13 + G_dot_21 * tau_rate_32 + G_dot_31 * tau_rate_33 + G_ddot_21 * M_mixed
        + tau_place_31 + G_ddot_31 * M_phi) - c80)
    A_0_leg_22 = (c15 * k1 * tau_theta + c76 * inv_rho * k3 + inv_rho * (G_dot_32 * tau_rate_33 + inv_rho * tau_place_33
        + G_dot_12 * tau_rate_31 + G_dot_22 * tau_rate_32 + G_ddot_12 * c13 + G_ddot_22 * M_mixed + G_ddot_32
        * M_phi))
    A_0_leg_23 = (c80 * kappa + inv_rho * (G_ddot_23 * M_mixed + G_dot_33 * tau_rate_33 + G_dot_23 * tau_rate_32
        - tau_rate_31 * theta_dot + G_ddot_13 * c13 + G_ddot_33 * M_phi - inv_L * tau_place_32))
    A_0_leg_31 = (c79 - inv_L * (G_ddot_11 * h_z + G_dot_21 * tau_rate_22 + G_dot_31 * tau_rate_23 + G_ddot_21
        * M_theta + tau_place_21 + G_ddot_31 * M_mixed))
    A_0_leg_32 = (c14 * k1 * tau_phi - inv_L * (G_dot_22 * tau_rate_22 + G_dot_12 * tau_rate_21 + G_dot_32 * tau_rate_23
        + inv_rho * tau_place_23 + G_ddot_12 * h_z + G_ddot_22 * M_theta + G_ddot_32 * M_mixed))
    A_0_leg_33 = (c76 * inv_L - inv_L * (G_ddot_23 * M_theta + G_dot_23 * tau_rate_22 + G_dot_33 * tau_rate_23
        - tau_rate_21 * theta_dot + G_ddot_13 * h_z + G_ddot_33 * M_mixed - inv_L * tau_place_22))
    A_0_T_xs = A_0_leg_11 * s_x + A_0_leg_21 * y_x + A_0_leg_31 * z_x
    A_0_T_xy = A_0_leg_12 * s_x + A_0_leg_22 * y_x + A_0_leg_32 * z_x
    A_0_T_xz = A_0_leg_13 * s_x + A_0_leg_23 * y_x + A_0_leg_33 * z_x
    A_0_T_ys = A_0_leg_11 * s_y + A_0_leg_21 * y_y + A_0_leg_31 * z_y
    A_0_T_yy = A_0_leg_12 * s_y + A_0_leg_22 * y_y + A_0_leg_32 * z_y
    A_0_T_yz = A_0_leg_13 * s_y + A_0_leg_23 * y_y + A_0_leg_33 * z_y
    A_0_T_zs = A_0_leg_11 * s_z + A_0_leg_21 * y_z + A_0_leg_31 * z_z
    A_0_T_zy = A_0_leg_12 * s_z + A_0_leg_22 * y_z + A_0_leg_32 * z_z
    A_0_T_zz = A_0_leg_13 * s_z + A_0_leg_23 * y_z + A_0_leg_33 * z_z
    # force at the tip by S
    A_0_xx = A_0_T_xs * s_x + A_0_T_xy * y_x + A_0_T_xz * z_x
    A_0_xy = A_0_T_xs * s_y + A_0_T_xy * y_y + A_0_T_xz * z_y
    A_0_xz = A_0_T_xs * s_z + A_0_T_xy * y_z + A_0_T_xz * z_z
    A_0_yx = A_0_T_ys * s_x + A_0_T_yy * y_x + A_0_T_yz * z_x
    A_0_yy = A_0_T_ys * s_y + A_0_T_yy * y_y + A_0_T_yz * z_y
    A_0_yz = A_0_T_ys * s_z + A_0_T_yy * y_z + A_0_T_yz * z_z
    A_0_zx = A_0_T_zs * s_x + A_0_T_zy * y_x + A_0_T_zz * z_x
    A_0_zy = A_0_T_zs * s_y + A_0_T_zy * y_y + A_0_T_zz * z_y
    A_0_zz = A_0_T_zs * s_z + A_0_T_zy * y_z + A_0_T_zz * z_z
    c81 = 2.0 * h_z
    c82 = 2.0 * (c12 - k3_h)
    A_1_leg_11 = C_p + G_dot_21 * c81 + G_dot_31 * c82
    A_1_leg_12 = 2.0 * G_dot_12 * m_r + G_dot_22 * c81 + G_dot_32 * c82 + inv_rho * tau_rate_13
    A_1_leg_13 = G_dot_23 * c81 - c7 * m_r + G_dot_33 * c82 - inv_L * tau_rate_12
    c83 = 2.0 * M_mixed
    c84 = 2.0 * M_phi
    A_1_leg_21 = inv_rho * (G_dot_21 * c83 + tau_rate_31 + G_dot_31 * c84)
    A_1_leg_22 = inv_rho * (G_dot_12 * c82 + inv_rho * tau_rate_33 + G_dot_22 * c83 + G_dot_32 * c84)
    A_1_leg_23 = inv_rho * (G_dot_23 * c83 - c82 * theta_dot + G_dot_33 * c84 - inv_L * tau_rate_32)
    c85 = 2.0 * M_theta
    A_1_leg_31 = -inv_L * (G_dot_21 * c85 + tau_rate_21 + G_dot_31 * c83)
    A_1_leg_32 = -inv_L * (G_dot_12 * c81 + G_dot_22 * c85 + G_dot_32 * c83 + inv_rho * tau_rate_23)
    A_1_leg_33 = -inv_L * (G_dot_23 * c85 - inv_L * tau_rate_22 - c7 * h_z + G_dot_33 * c83)
    A_1_T_xs = A_1_leg_11 * s_x + A_1_leg_21 * y_x + A_1_leg_31 * z_x
    A_1_T_xy = A_1_leg_12 * s_x + A_1_leg_22 * y_x + A_1_leg_32 * z_x
    A_1_T_xz = A_1_leg_33 * z_x + A_1_leg_13 * s_x + A_1_leg_23 * y_x
    A_1_T_ys = A_1_leg_11 * s_y + A_1_leg_21 * y_y + A_1_leg_31 * z_y
    A_1_T_yy = A_1_leg_12 * s_y + A_1_leg_22 * y_y + A_1_leg_32 * z_y
    A_1_T_yz = A_1_leg_33 * z_y + A_1_leg_13 * s_y + A_1_leg_23 * y_y
    A_1_T_zs = A_1_leg_11 * s_z + A_1_leg_21 * y_z + A_1_leg_31 * z_z
    A_1_T_zy = A_1_leg_12 * s_z + A_1_leg_22 * y_z + A_1_leg_32 * z_z
    A_1_T_zz = A_1_leg_33 * z_z + A_1_leg_13 * s_z + A_1_leg_23 * y_z
    # force at the tip by S_dot
    A_1_xx = A_1_T_xs * s_x + A_1_T_xz * z_x + A_1_T_xy * y_x
    A_1_xy = A_1_T_xs * s_y + A_1_T_xz * z_y + A_1_T_xy * y_y
    A_1_xz = A_1_T_xs * s_z + A_1_T_xz * z_z + A_1_T_xy * y_z
    A_1_yx = A_1_T_ys * s_x + A_1_T_yz * z_x + A_1_T_yy * y_x
    A_1_yy = A_1_T_ys * s_y + A_1_T_yz * z_y + A_1_T_yy * y_y
    A_1_yz = A_1_T_ys * s_z + A_1_T_yz * z_z + A_1_T_yy * y_z
    A_1_zx = A_1_T_zs * s_x + A_1_T_zz * z_x + A_1_T_zy * y_x
    A_1_zy = A_1_T_zs * s_y + A_1_T_zz * z_y + A_1_T_zy * y_y
    A_1_zz = A_1_T_zs * s_z + A_1_T_zz * z_z + A_1_T_zy * y_z
    # derivative of the force by rotation about the tip
    X_xx = B_xx * m_xx + B_yx * m_xy + B_zx * m_xz + A_1_xy * omega_z - A_1_xz * omega_y + A_0_xx
    X_xy = B_xy * m_xx + B_yy * m_xy + B_zy * m_xz + A_1_xz * omega_x - A_1_xx * omega_z + A_0_xy
    X_xz = B_xz * m_xx + B_yz * m_xy + B_zz * m_xz + A_1_xx * omega_y - A_1_xy * omega_x + A_0_xz
    X_yx = B_xx * m_xy + B_yx * m_yy + B_zx * m_yz + A_1_yy * omega_z - A_1_yz * omega_y + A_0_yx
    X_yy = B_xy * m_xy + B_yy * m_yy + B_zy * m_yz + A_1_yz * omega_x - A_1_yx * omega_z + A_0_yy
    X_yz = B_xz * m_xy + B_yz * m_yy + B_zz * m_yz + A_1_yx * omega_y - A_1_yy * omega_x + A_0_yz
    X_zx = B_xx * m_xz + B_yx * m_yz + B_zx * m_zz + A_1_zy * omega_z - A_1_zz * omega_y + A_0_zx
    X_zy = B_xy * m_xz + B_yy * m_yz + B_zy * m_zz + A_1_zz * omega_x - A_1_zx * omega_z + A_0_zy
    X_zz = B_xz * m_xz + B_yz * m_yz + B_zz * m_zz + A_1_zx * omega_y - A_1_zy * omega_x + A_0_zz
    c86 = m_xy * omega_z
    c87 = m_xz * omega_y
    Y_xx = c86 - c87 + A_1_xx
    Y_xy = m_xz * omega_x - m_xx * omega_z + A_1_xy
    Y_xz = m_xx * omega_y - m_xy * omega_x + A_1_xz
    Y_yx = m_yy * omega_z - m_yz * omega_y + A_1_yx
    c88 = m_yz * omega_x
    Y_yy = c88 - c86 + A_1_yy
    Y_yz = m_xy * omega_y - m_yy * omega_x + A_1_yz
    Y_zx = m_yz * omega_z - m_zz * omega_y + A_1_zx
    Y_zy = m_zz * omega_x - m_xz * omega_z + A_1_zy
    Y_zz = c87 - c88 + A_1_zz
    c89 = X_xy * q_z
    Z_xx = X_xz * q_y - c89
    c90 = X_xx * q_z
    Z_xy = c90 - X_xz * q_x
    c91 = X_xx * q_y
    Z_xz = X_xy * q_x - c91
    c92 = X_yy * q_z
    Z_yx = X_yz * q_y - c92
    c93 = X_yx * q_z
    c94 = -X_yz * q_x
    Z_yy = c93 + c94
    c95 = -X_yy * q_x
    Z_yz = -X_yx * q_y - c95
    c96 = -X_zz * q_y
    Z_zx = -X_zy * q_z - c96
    c97 = -X_zz * q_x
    Z_zy = X_zx * q_z + c97
    c98 = X_zx * q_y
    Z_zz = X_zy * q_x - c98
    c99 = m_xy * w_q_z
    c100 = m_xz * w_q_y
    V_xx = c100 - f_S_dot_xx - c99 + Y_xz * q_y - Y_xy * q_z
    V_xy = m_xx * w_q_z - f_S_dot_yx - m_xz * w_q_x + Y_xx * q_z - Y_xz * q_x
    V_xz = m_xy * w_q_x - f_S_dot_zx - m_xx * w_q_y + Y_xy * q_x - Y_xx * q_y
    V_yx = m_yz * w_q_y - f_S_dot_xy - m_yy * w_q_z + Y_yz * q_y - Y_yy * q_z
    c101 = m_yz * w_q_x
    V_yy = c99 - f_S_dot_yy - c101 + Y_yx * q_z - Y_yz * q_x
    V_yz = m_yy * w_q_x - f_S_dot_zy - m_xy * w_q_y + Y_yy * q_x - Y_yx * q_y
    V_zx = m_zz * w_q_y - f_S_dot_xz - m_yz * w_q_z + Y_zz * q_y - Y_zy * q_z
    V_zy = m_xz * w_q_z - f_S_dot_yz - m_zz * w_q_x + Y_zx * q_z - Y_zz * q_x
    V_zz = c101 - f_S_dot_zz - c100 + Y_zy * q_x - Y_zx * q_y
    # derivative of the moment by rotation about the tip
    Q_xx = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx + c93 - c98
    Q_xy = f_S_dot_xz * omega_x - f_S_dot_xx * omega_z + f_S_xy - R_tip_z + c92 - X_zy * q_y
    Q_xz = f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz + R_tip_y + X_yz * q_z + c96
    Q_yx = f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx + R_tip_z + X_zx * q_x - c90
    Q_yy = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy + X_zy * q_x - c89
    Q_yz = f_S_dot_yx * omega_y - f_S_dot_yy * omega_x + f_S_yz - R_tip_x - X_xz * q_z - c97
    Q_zx = f_S_dot_zy * omega_z - f_S_dot_zz * omega_y + f_S_zx - R_tip_y + c91 - X_yx * q_x
    Q_zy = f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy + R_tip_x + X_xy * q_y + c95
    Q_zz = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz + X_xz * q_y + c94
    c102 = m_xy * q_z
    c103 = m_xz * q_y
    c104 = -m_yz * q_x
    # m [q]x
    m_q_xx = c102 - c103
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c102 - c104
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c103 + c104
    out = DerivativesLeg()
    out.M_vv = [m_xx, m_xy, m_xz, m_yy, m_yz, m_zz]
    out.M_vw = [-m_q_xx, -m_q_xy, -m_q_xz, -m_q_yx, -m_q_yy, -m_q_yz, -m_q_zx, -m_q_zy, -m_q_zz]
    out.M_ww = [
        m_q_yx * q_z - m_q_zx * q_y,
        m_q_yy * q_z - m_q_zy * q_y,
        m_q_yz * q_z - m_q_zz * q_y,
        m_q_zy * q_x - m_q_xy * q_z,
        m_q_zz * q_x - m_q_xz * q_z,
        m_q_xz * q_y - m_q_yz * q_x,
    ]
    out.W_ft = [A_0_xx, A_0_xy, A_0_xz, A_0_yx, A_0_yy, A_0_yz, A_0_zx, A_0_zy, A_0_zz]
    out.W_fr = [Z_xx, Z_xy, Z_xz, Z_yx, Z_yy, Z_yz, Z_zx, Z_zy, Z_zz]
    out.W_mt = [
        A_0_zx * q_y - f_S_xx - A_0_yx * q_z,
        A_0_zy * q_y - f_S_xy - A_0_yy * q_z,
        A_0_zz * q_y - f_S_xz - A_0_yz * q_z,
        A_0_xx * q_z - f_S_yx - A_0_zx * q_x,
        A_0_xy * q_z - f_S_yy - A_0_zy * q_x,
        A_0_xz * q_z - f_S_yz - A_0_zz * q_x,
        A_0_yx * q_x - f_S_zx - A_0_xx * q_y,
        A_0_yy * q_x - f_S_zy - A_0_xy * q_y,
        A_0_yz * q_x - f_S_zz - A_0_xz * q_y,
    ]
    out.W_mr = [
        Q_xy * q_z - Q_xz * q_y,
        Q_xz * q_x - Q_xx * q_z,
        Q_xx * q_y - Q_xy * q_x,
        Q_yy * q_z - Q_yz * q_y,
        Q_yz * q_x - Q_yx * q_z,
        Q_yx * q_y - Q_yy * q_x,
        Q_zy * q_z - Q_zz * q_y,
        Q_zz * q_x - Q_zx * q_z,
        Q_zx * q_y - Q_zy * q_x,
    ]
    out.W_fv = [A_1_xx, A_1_xy, A_1_xz, A_1_yx, A_1_yy, A_1_yz, A_1_zx, A_1_zy, A_1_zz]
    out.W_fw = [V_xx, V_xy, V_xz, V_yx, V_yy, V_yz, V_zx, V_zy, V_zz]
    out.W_mv = [
        A_1_zx * q_y - f_S_dot_xx - A_1_yx * q_z,
        A_1_zy * q_y - f_S_dot_xy - A_1_yy * q_z,
        A_1_zz * q_y - f_S_dot_xz - A_1_yz * q_z,
        A_1_xx * q_z - f_S_dot_yx - A_1_zx * q_x,
        A_1_xy * q_z - f_S_dot_yy - A_1_zy * q_x,
        A_1_xz * q_z - f_S_dot_yz - A_1_zz * q_x,
        A_1_yx * q_x - f_S_dot_zx - A_1_xx * q_y,
        A_1_yy * q_x - f_S_dot_zy - A_1_xy * q_y,
        A_1_yz * q_x - f_S_dot_zz - A_1_xz * q_y,
    ]
    out.W_mw = [
        V_zx * q_y + f_S_dot_xy * q_z - V_yx * q_z - f_S_dot_xz * q_y,
        V_zy * q_y + f_S_dot_xz * q_x - V_yy * q_z - f_S_dot_xx * q_z,
        V_zz * q_y + f_S_dot_xx * q_y - V_yz * q_z - f_S_dot_xy * q_x,
        V_xx * q_z + f_S_dot_yy * q_z - V_zx * q_x - f_S_dot_yz * q_y,
        V_xy * q_z + f_S_dot_yz * q_x - V_zy * q_x - f_S_dot_yx * q_z,
        V_xz * q_z + f_S_dot_yx * q_y - V_zz * q_x - f_S_dot_yy * q_x,
        V_yx * q_x + f_S_dot_zy * q_z - V_xx * q_y - f_S_dot_zz * q_y,
        V_yy * q_x + f_S_dot_zz * q_x - V_xy * q_y - f_S_dot_zx * q_z,
        V_yz * q_x + f_S_dot_zx * q_y - V_xz * q_y - f_S_dot_zy * q_x,
    ]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def derivatives_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = derivatives_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def derivatives_near(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench: 2119 (1231 mul, 884 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s, m_r, j_r = leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    h2_x, h2_z = leg.h2_x, leg.h2_z
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_xz, J_yy, J_yz, J_zz = leg.J
    J2_xz, dJ_zx, g_k = leg.J2_xz, leg.dJ_zx, leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = pose.B
    F = given.F
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    c1 = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1 * inv_rho
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    c2 = L_dot * inv_L
    # L_dot / L
    L_share = c2
    c3 = theta_dot * theta_dot
    theta_dot2 = c3
    phi_dot2 = phi_dot * phi_dot
    inv_k3 = L * inv_rho
    # (6) angular velocity of the leg about z
    W_z = c1 * inv_L
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    c4 = k3 * k3
    # (8) acceleration of the length
    L_ddot = L * (theta_dot2 + c4 * phi_dot2) + S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    c5 = 2.0 * L_share
    # (9) angular accelerations of the leg about y and z without the rotation of the frame about s
    own_y = -inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - c5 * theta_dot
    own_z = inv_L * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - W_z * c5
    k33 = c4
    k13 = k1 * k3
    L_h2 = L * h2_x
    a1 = dJ_zx + L_h2
    a2 = J2_xz - L * h2_z
    c6 = L * h_y
    a3 = J_xy - c6
    c7 = J_yz * k3
    # (19) inertia of the joint coordinates
    M_phi = J_xx + a1 * k33 + a2 * k13
    M_theta = J_yy + L_h2
    M_mixed = c7 + a3 * k1
    c8 = h_y * k3
    k3_h = c8
    c9 = j_r * k1
    c10 = h_z * inv_L
    c11 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = inv_rho * (c9 - k3_h)
    m_leg_sz = -c10
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * c11
    m_T_xs = m_r * s_x + m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_r * s_y + m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_r * s_z + m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xz * z_x + m_T_xy * y_x
    m_xy = m_T_xs * s_y + m_T_xz * z_y + m_T_xy * y_y
    m_xz = m_T_xs * s_z + m_T_xz * z_z + m_T_xy * y_z
    m_yy = m_T_ys * s_y + m_T_yz * z_y + m_T_yy * y_y
    m_yz = m_T_ys * s_z + m_T_yz * z_z + m_T_yy * y_z
    m_zz = m_T_zs * s_z + m_T_zz * z_z + m_T_zy * y_z
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # k x y
    normal_x = k_y * y_z - k_z * y_y
    normal_y = k_z * y_x - k_x * y_z
    normal_z = k_x * y_y - k_y * y_x
    # omega along k x y, y and k
    w_n_omega = normal_x * omega_x + normal_y * omega_y + normal_z * omega_z
    w_y_omega = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_k_omega = k_x * omega_x + k_y * omega_y + k_z * omega_z
    c12 = L_ddot * m_r
    c13 = h_y * own_z
    c14 = W_z * j_r
    c15 = c14 * theta_dot
    c16 = inv_k3 * own_z
    c17 = c16 * c9
    c18 = W_z * W_z
    c19 = c18 * h_x
    c20 = c3 * h_x
    c21 = h_y * k1
    c22 = W_z * inv_k3
    c23 = 2.0 * theta_dot
    c24 = c22 * c23
    c25 = inv_k3 * inv_k3
    c26 = 2.0 * c25
    c27 = c18 * h_z
    c28 = inv_k3 * k1
    c29 = 2.0 * c28
    tau_L = (C_p * L_dot - c19 - c20 + c12 + c27 * c29 + c15 + h_z * own_y + c21 * c24 - c15 * c26 + c17 - c13)
    c30 = C_us * theta_dot
    c31 = J_yy * own_y
    c32 = J_yz * own_z
    c33 = L_ddot * h_z
    c34 = C_s * w_y_omega
    c35 = k3 * w_x
    c36 = c35 * g_k
    c37 = k1 * w_x
    c38 = c37 * gamma_n
    c39 = k3 * w_z
    c40 = c39 * gamma_n
    c41 = J_xy * c23
    c42 = W_z * c41
    c43 = 2.0 * L
    c44 = c43 * h_x
    c45 = L_dot * c23
    c46 = k1 * w_z
    c47 = c46 * g_k
    c48 = J_xy * k1
    c49 = c16 * c48
    c50 = J_xz * c18
    c51 = 2.0 * c50
    c52 = W_z * c23 * c6
    c53 = J_yz * k1
    c54 = c24 * c53
    c55 = c6 * k1
    c56 = c25 * c50
    c57 = c18 * inv_k3
    c59 = J_xx - J_zz
    c60 = J_yy + c59
    c61 = c60 * k1
    tau_theta = (c51 - c56 + L * c25 * c27 + c36 - c27 * c43 + c57 * c61 + c33 - c47 + c30 + c38 + c40 + c42
        + c45 * h_x - c34 + L_dot * c14 + c31 + c44 * own_y + c25 * c52 - c25 * c42 - c52 + c32 - c54 + c49
        - c16 * c55)
    c62 = C_s * w_k_omega
    c63 = gamma_n * w_y
    c64 = c48 * own_y
    c65 = L_ddot * c9
    c66 = c46 * gamma_y
    c67 = 2.0 * own_z
    c68 = J_xz * k1
    c69 = J_xy * c18
    c70 = c69 * inv_k3
    c71 = c18 * c53
    c72 = c3 * c53
    c73 = J_xz * c23
    c74 = k3 * own_z
    c75 = h_z * k1
    c76 = L_dot * k3
    c77 = 2.0 * h_x
    c78 = 2.0 * W_z
    c79 = J_xy * c3
    c80 = c6 * k3
    c81 = c22 * theta_dot
    c83 = 2.0 * J_xx
    c84 = c25 * c83
    c85 = W_z * theta_dot
    tau_phi = (c70 - c62 + c18 * c80 + c3 * c80 - c69 * k3 - c79 * k3 - c57 * c6 + c71 + c72 + c65 - L_ddot
        * c8 + c66 - c35 * gamma_y - c63 - c76 * j_r * theta_dot + C_us * c22 + W_z * c76 * c77 + c64 + c7 * own_y
        - c21 * c45 - c22 * c73 - c55 * own_y + c43 * c81 * h_z - L_dot * c75 * c78 - c84 * c85 * k1 + J_xx
        * c16 + c44 * c74 + c67 * c68 - c43 * c75 * own_z - c59 * c74)
    c86 = inv_rho * tau_phi
    c87 = inv_L * tau_theta
    c88 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c88 * s_x - c87 * z_x + c86 * y_x
    R_tip_y = c88 * s_y - c87 * z_y + c86 * y_y
    R_tip_z = c88 * s_z - c87 * z_z + c86 * y_z
    c89 = inv_L * theta_dot
    G_dot_21 = -c89
    c90 = k1 * phi_dot
    G_dot_22 = c90 * inv_L
    c91 = L_dot * c11
    G_dot_23 = c91
    G_dot_31 = -inv_rho * k3 * phi_dot
    G_dot_32 = -c2 * inv_rho - inv_rho * kappa * theta_dot
    G_dot_33 = c90 * inv_rho
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_32 * y_x + G_dot_33 * z_x + G_dot_31 * s_x)
    phi_dot_by_S_y = C_s * (G_dot_32 * y_y + G_dot_33 * z_y + G_dot_31 * s_y)
    phi_dot_by_S_z = C_s * (G_dot_32 * y_z + G_dot_33 * z_z + G_dot_31 * s_z)
    c92 = C_s * inv_L
    # gradient of theta, times C_s
    C_s_theta_x = -c92 * z_x
    C_s_theta_y = -c92 * z_y
    C_s_theta_z = -c92 * z_z
    c93 = C_s * inv_rho
    # gradient of phi, times C_s
    C_s_phi_x = c93 * y_x
    C_s_phi_y = c93 * y_y
    C_s_phi_z = c93 * y_z
    y_by_phi_x = normal_x * theta_dot
    y_by_phi_y = normal_y * theta_dot
    y_by_phi_z = normal_z * theta_dot
    # friction moment by S
    f_S_xx = C_s_phi_x * y_by_phi_x + theta_dot_by_S_x * y_x + k_x * phi_dot_by_S_x
    f_S_xy = C_s_phi_y * y_by_phi_x + theta_dot_by_S_y * y_x + k_x * phi_dot_by_S_y
    f_S_xz = C_s_phi_z * y_by_phi_x + theta_dot_by_S_z * y_x + k_x * phi_dot_by_S_z
    f_S_yx = C_s_phi_x * y_by_phi_y + theta_dot_by_S_x * y_y + k_y * phi_dot_by_S_x
    f_S_yy = C_s_phi_y * y_by_phi_y + theta_dot_by_S_y * y_y + k_y * phi_dot_by_S_y
    f_S_yz = C_s_phi_z * y_by_phi_y + theta_dot_by_S_z * y_y + k_y * phi_dot_by_S_z
    f_S_zx = C_s_phi_x * y_by_phi_z + theta_dot_by_S_x * y_z + k_z * phi_dot_by_S_x
    f_S_zy = C_s_phi_y * y_by_phi_z + theta_dot_by_S_y * y_z + k_z * phi_dot_by_S_y
    f_S_zz = C_s_phi_z * y_by_phi_z + theta_dot_by_S_z * y_z + k_z * phi_dot_by_S_z
    # friction moment by S_dot
    f_S_dot_xx = C_s_theta_x * y_x + C_s_phi_x * k_x
    f_S_dot_xy = C_s_theta_y * y_x + C_s_phi_y * k_x
    f_S_dot_xz = C_s_theta_z * y_x + C_s_phi_z * k_x
    f_S_dot_yx = C_s_theta_x * y_y + C_s_phi_x * k_y
    f_S_dot_yy = C_s_theta_y * y_y + C_s_phi_y * k_y
    f_S_dot_yz = C_s_theta_z * y_y + C_s_phi_z * k_y
    f_S_dot_zx = C_s_theta_x * y_z + C_s_phi_x * k_z
    f_S_dot_zy = C_s_theta_y * y_z + C_s_phi_y * k_z
    f_S_dot_zz = C_s_theta_z * y_z + C_s_phi_z * k_z
    c94 = c10 * own_y
    c95 = c91 * h_z
    c96 = -c23 * c95
    c97 = c10 * k1
    c98 = c57 * c97
    c99 = c13 * inv_L
    c100 = c91 * h_y
    c101 = c100 * c78
    c102 = 2.0 * c89
    c103 = c102 * c14
    c104 = c17 * inv_L
    c105 = 4.0 * c89
    c106 = c101 + c103 + c105 * c21 * c22 + c104 - c99
    A_0_leg_11 = (2.0 * c18 * h_x * inv_L - c18 * m_r - c3 * m_r + 2.0 * c3 * h_x * inv_L - 4.0 * c98 - c96
        - c94 + 4.0 * W_z * c25 * inv_L * j_r * theta_dot + 2.0 * L_dot * W_z * c11 * inv_k3 * j_r * k1 - c106)
    c107 = c11 * c69
    c108 = c11 * c79
    c109 = inv_L * own_y
    c110 = c109 * j_r
    c111 = c11 * own_z
    c112 = J_yz * c11
    c113 = c112 * own_y
    c114 = h_y * inv_L
    c115 = c114 * c18
    c116 = 2.0 * c115
    c117 = inv_L * inv_L * inv_L
    c118 = L_dot * L_dot
    c119 = c117 * c118
    c120 = 2.0 * c119
    c121 = c120 * h_y
    c122 = L_ddot * c11
    c123 = c122 * h_y
    c124 = 2.0 * c123
    c125 = C_us * c11
    c126 = c125 * c25
    c127 = W_z * c126
    c128 = J_xx * c25
    c129 = c107 * c25
    c130 = c114 * c3
    c131 = c10 * c23
    c132 = 3.0 * c115
    c133 = c11 * inv_k3
    c134 = c133 * c64
    c135 = c133 * c71
    c136 = c133 * c72
    c137 = c10 * c85
    c138 = c137 * c25
    c139 = 2.0 * c16
    c140 = c11 * c68
    c141 = c133 * c65
    c142 = c9 * inv_L
    c143 = inv_k3 * inv_k3 * inv_k3
    c144 = 2.0 * c143
    c145 = W_z * c11
    c146 = c25 * c73
    c147 = c91 * j_r
    c148 = c147 * c23
    c149 = c109 * h_y
    c150 = 2.0 * c149
    c151 = c142 * c3
    c152 = c9 * inv_k3
    c153 = 2.0 * c91
    c154 = c153 * h_z
    c155 = c22 * k1
    c156 = c145 * theta_dot
    c157 = c143 * k1
    c158 = c157 * c83
    c159 = c11 * gamma_y
    c160 = h_x * inv_L
    c161 = c133 * c62 + c133 * c63 + c159 * w_x - c133 * c66 - c160 * c67
    A_0_leg_12 = (c107 + c108 - c121 - c129 + c132 * c25 - c116 - c130 * c26 + c120 * c152 + c144 * c151 - c135
        - c136 + c124 - 2.0 * c141 - c142 * c144 * c18 + C_p * W_z + W_z * c131 + c148 * c25 + c145 * c146 - c127
        + c110 + c156 * c158 - c113 + m_r * own_z - c134 - 6.0 * c138 - c154 * c155 + c111 * c59 + c150 * c28
        - c110 * c25 + 3.0 * c16 * c97 - c111 * c128 + c161 - c139 * c140)
    c162 = c11 * c30
    c163 = c11 * c31
    c164 = c11 * c32
    c165 = c120 * h_z
    c166 = c11 * c51
    c167 = c11 * c33
    c168 = inv_L * j_r
    c169 = c11 * c56
    c170 = c145 * c41
    c171 = c10 * c18
    c172 = 3.0 * c171
    c173 = c11 * c49
    c174 = c11 * c18
    c175 = c14 * c153
    c176 = W_z * c105
    c177 = c143 * c176
    c178 = c10 * c3
    c179 = c11 * c34
    c180 = c176 * h_y
    c181 = c153 * h_y
    c182 = (c178 - c172 + c11 * c36 - c11 * c47 + c11 * c38 + c11 * c40 + c175 - c179 + c109 * c77 + c155 * c181
        + c180 * c25 - c180 - c28 * c99)
    A_0_leg_13 = (c166 - c165 - c169 + c172 * c25 + c174 * c61 * inv_k3 + 2.0 * c167 + c162 - C_p * theta_dot
        + c170 + c102 * c22 * c9 + c163 - m_r * own_y - c170 * c25 - c175 * c25 - c177 * c9 + c164 + c168 * c25
        * own_z - c11 * c54 + c173 + c182)
    c183 = -2.0 * J_zz
    c184 = c183 + c83
    c185 = 3.0 * c107
    c187 = L_dot * c117
    c188 = W_z * c187
    c189 = c187 * c23
    c190 = 4.0 * c140
    c191 = 6.0 * c156
    c192 = c48 * inv_k3
    c193 = c100 * c23
    c194 = 4.0 * c68
    c195 = J_xx * c157
    A_0_leg_21 = (3.0 * c108 + c185 - 3.0 * c129 - c115 - c130 + c116 * c25 + c123 - 3.0 * c135 - 3.0 * c136
        - c142 * c57 - c141 - c151 * inv_k3 + c148 + J_yz * c189 + c189 * c192 + c193 * c28 + c188 * c84 - 2.0
        * c127 + c187 * c194 * c22 - 2.0 * c113 - c184 * c188 + c149 * c28 + c191 * c195 - 2.0 * c134 - 4.0
        * c138 + J_xz * c191 * c25 + c111 * c184 + c139 * c97 - c111 * c84 - c16 * c190 + c161)
    c196 = L_ddot * c117
    c197 = c20 * inv_L
    c198 = c118 * inv_L * inv_L * inv_L * inv_L
    c199 = c11 * c3
    c200 = J_yy * c174
    c201 = c19 * inv_L
    c202 = 2.0 * J_xy
    c203 = c111 * c202
    c204 = c11 * own_y
    c205 = 2.0 * J_xz
    c206 = c204 * c205
    c207 = c159 * c25
    c208 = c174 * c25
    c209 = C_us * c187
    c210 = inv_k3 * inv_k3 * inv_k3 * inv_k3
    c211 = c210 * c83
    c212 = c25 * c99
    c213 = c188 * c202
    c214 = 2.0 * c94
    c215 = c11 * gamma_n
    c216 = c215 * c46
    c217 = c133 * own_y
    c218 = c11 * c50
    c219 = c213 * c25
    c220 = c68 * inv_k3
    c221 = 2.0 * c220
    c222 = c112 * c23
    c223 = W_z * c222
    c224 = c223 * c25
    c225 = 2.0 * c157
    c226 = c144 * c199
    c227 = 2.0 * c164
    c228 = 4.0 * c220
    c229 = c143 * c156
    c230 = 4.0 * c229 * c48
    c231 = 2.0 * c53
    c232 = c22 * c231
    c233 = c187 * c232
    c234 = c158 * theta_dot
    c235 = c177 * c21
    c236 = c11 * g_k
    c237 = (c120 * h_x - F * inv_L + c236 * c39 + c236 * c37 + C_p * c2 + c12 * inv_L - c122 * c77 + c216 - c215
        * c35 - c103 * c25)
    A_0_leg_22 = (c198 * c84 + c199 * c211 + c208 * (J_yy + c83 - J_zz) - c128 * c199 - c174 * c211 - c199 * c59
        - c200 + c197 - c184 * c198 - c201 - c133 * g_k * w_z + c157 * c172 + c226 * c68 - 3.0 * c157 * c218
        - c165 * c28 + c196 * c59 + c198 * c228 + c199 * c221 - c178 * c225 - c178 * c29 - c128 * c196 - c196
        * c221 + 3.0 * c167 * c28 - c209 * c25 + c187 * c234 + c162 * c28 + c96 + c146 * c187 + c207 * w_y + c213
        + c216 * c25 - c157 * c162 + c206 + c217 * c61 + c235 - c179 * c28 - c224 - c94 + c214 * c25 - c195
        * c204 - c219 - c233 + c237 - c206 * c25 + c203 * c25 - c203 - c230 + 2.0 * c104 + c227 * c28 - 2.0
        * c212)
    c238 = c112 * c3
    c239 = c112 * c18
    c240 = c119 * j_r
    c241 = J_xy * c25
    c242 = c239 * c25
    c243 = c238 * c25
    c244 = c149 * c25
    c245 = c187 * c41
    c246 = c11 * k1
    c247 = c246 * c70
    c248 = c125 * c157
    c249 = c189 * c53 * inv_k3
    c250 = 2.0 * J_yz
    c251 = c122 * j_r
    c252 = c10 * own_z
    c253 = c111 * c205
    c254 = c77 * c89
    c255 = c246 * c25
    c256 = 2.0 * c192
    c257 = c205 * c25
    c258 = (J_yz * c196 - c198 * c250 + c192 * c196 - c255 * c62 + c25 * c251 - c198 * c256 + W_z * c254 + c207
        * w_z - c255 * c63 + c190 * c81 - c188 * c257 + 4.0 * c137 * c157 - c156 * c184 - c194 * c229 + c25
        * c253 - c252 * c26)
    A_0_leg_23 = (c238 + c242 + c243 - c239 - c240 + c168 * c3 + c115 * c28 + c130 * c28 + c107 * c225 + c192
        * c199 - c116 * c157 - c247 - c123 * c28 + c193 + c248 * c78 + c249 - c193 * c25 - c245 + c149 + c204
        * c241 - c158 * c188 + c128 * c191 - c109 * c152 - c131 * c155 + c111 * c158 - c244 - J_xx * c191 * c210
        + c258)
    c259 = 2.0 * J_yy
    c260 = c259 * theta_dot
    c261 = 2.0 * c22
    c262 = c261 * c48
    A_0_leg_31 = (6.0 * c218 - 3.0 * c169 + c171 * c26 + c174 * c28 * (3.0 * (J_xx + J_yy - J_zz)) + c167 + 2.0
        * c162 - c187 * c260 - c188 * c250 + J_xy * c191 + 2.0 * c163 - 6.0 * c11 * c53 * c81 - c187 * c262
        - c191 * c241 + c227 + 2.0 * c173 + c182)
    c263 = c202 * c204
    c264 = 4.0 * J_xz
    c266 = c259 + c184
    c267 = 4.0 * c10 * c155
    A_0_leg_32 = (c240 - 2.0 * c239 + 3.0 * c242 - c243 - c168 * c18 + c116 * c28 + c121 * c28 + c157 * c185
        + c130 * c225 - c132 * c157 - c226 * c48 - 2.0 * c247 - c251 - c124 * c28 + W_z * c248 + c245 + c188
        * c264 + c217 * c231 - c245 * c25 - c249 - c78 * c95 + C_s * c133 * w_n_omega + c150 + c155 * c187 * c266
        + c156 * c25 * (4.0 * J_xx + c183 + c259) + c25 * c263 + c252 - c125 * c155 - c156 * c211 - c263 + c111
        * c195 - 2.0 * c244 - c253 - c267 * theta_dot - c16 * c246 * c60 + c258)
    A_0_leg_33 = (c198 * c259 + c200 - J_yy * c199 + c201 - c208 * c60 - c197 + c157 * c166 + 2.0 * c98 - c171
        * c225 - J_yy * c196 - c209 + c224 - c223 + c214 + c219 + c233 - c213 - c101 * c25 - c235 + c230 + c237
        - c11 * c24 * c48 + c212 - c111 * c241 + c106)
    A_0_T_xs = A_0_leg_11 * s_x + A_0_leg_31 * z_x + A_0_leg_21 * y_x
    A_0_T_xy = A_0_leg_12 * s_x + A_0_leg_32 * z_x + A_0_leg_22 * y_x
    A_0_T_xz = A_0_leg_13 * s_x + A_0_leg_23 * y_x + A_0_leg_33 * z_x
    A_0_T_ys = A_0_leg_11 * s_y + A_0_leg_31 * z_y + A_0_leg_21 * y_y
    A_0_T_yy = A_0_leg_12 * s_y + A_0_leg_32 * z_y + A_0_leg_22 * y_y
    A_0_T_yz = A_0_leg_13 * s_y + A_0_leg_23 * y_y + A_0_leg_33 * z_y
    A_0_T_zs = A_0_leg_11 * s_z + A_0_leg_31 * z_z + A_0_leg_21 * y_z
    A_0_T_zy = A_0_leg_12 * s_z + A_0_leg_32 * z_z + A_0_leg_22 * y_z
    A_0_T_zz = A_0_leg_13 * s_z + A_0_leg_23 * y_z + A_0_leg_33 * z_z
    # force at the tip by S
    A_0_xx = A_0_T_xz * z_x + A_0_T_xs * s_x + A_0_T_xy * y_x
    A_0_xy = A_0_T_xz * z_y + A_0_T_xs * s_y + A_0_T_xy * y_y
    A_0_xz = A_0_T_xz * z_z + A_0_T_xs * s_z + A_0_T_xy * y_z
    A_0_yx = A_0_T_yz * z_x + A_0_T_ys * s_x + A_0_T_yy * y_x
    A_0_yy = A_0_T_yz * z_y + A_0_T_ys * s_y + A_0_T_yy * y_y
    A_0_yz = A_0_T_yz * z_z + A_0_T_ys * s_z + A_0_T_yy * y_z
    A_0_zx = A_0_T_zz * z_x + A_0_T_zs * s_x + A_0_T_zy * y_x
    A_0_zy = A_0_T_zz * z_y + A_0_T_zs * s_y + A_0_T_zy * y_y
    A_0_zz = A_0_T_zz * z_z + A_0_T_zs * s_z + A_0_T_zy * y_z
    c268 = c142 * c261
    c269 = c114 * c78
    c270 = c269 - c131
    A_1_leg_11 = C_p + c270 - c268
    c271 = 2.0 * m_r
    c272 = c89 * j_r
    c273 = c160 * c78
    c274 = c102 * h_y
    A_1_leg_12 = c181 - c152 * c153 + c272 + W_z * c271 + c274 * c28 - c26 * c272 - c273 + c267
    c275 = c14 * inv_L
    c276 = c254 - c275 - 2.0 * c114 * c155
    A_1_leg_13 = c154 - c271 * theta_dot + c26 * c275 + c276
    c277 = c133 * c23
    A_1_leg_21 = (W_z * c11 * c184 - c222 - c272 - c277 * c48 - c145 * c84 - c190 * c22 - c273 + 2.0 * W_z * h_z
        * inv_L * inv_k3 * k1)
    c278 = c77 * c91
    c279 = c145 * c202
    c280 = c11 * c232 + c25 * c279 - c279 - c25 * c269
    A_1_leg_22 = (c126 + c184 * c187 - c187 * c228 - c187 * c84 - c278 + c154 * c28 + c131 * c25 - c11 * c234
        + c268 - c11 * c146 + c280)
    c281 = c11 * c41
    c282 = c277 * c53
    c283 = c10 * c78
    c284 = c187 * c250 + c187 * c256 + c145 * c257 - c25 * c283
    A_1_leg_23 = c147 + c281 + c145 * c158 - c102 * c152 - c282 + c284
    A_1_leg_31 = c11 * c260 + c112 * c78 + c11 * c262 + c276
    A_1_leg_32 = (c274 - c147 - c181 * c28 + c282 + c25 * c281 + c283 - c281 - c145 * c264 - c25 * c274 - c22
        * c246 * c266 + c284)
    A_1_leg_33 = C_us * c11 - c187 * c259 - c278 - c270 - c280
    A_1_T_xs = A_1_leg_11 * s_x + A_1_leg_31 * z_x + A_1_leg_21 * y_x
    A_1_T_xy = A_1_leg_12 * s_x + A_1_leg_22 * y_x + A_1_leg_32 * z_x
    A_1_T_xz = A_1_leg_13 * s_x + A_1_leg_23 * y_x + A_1_leg_33 * z_x
    A_1_T_ys = A_1_leg_11 * s_y + A_1_leg_31 * z_y + A_1_leg_21 * y_y
    A_1_T_yy = A_1_leg_12 * s_y + A_1_leg_22 * y_y + A_1_leg_32 * z_y
    A_1_T_yz = A_1_leg_13 * s_y + A_1_leg_23 * y_y + A_1_leg_33 * z_y
    A_1_T_zs = A_1_leg_11 * s_z + A_1_leg_31 * z_z + A_1_leg_21 * y_z
    A_1_T_zy = A_1_leg_12 * s_z + A_1_leg_22 * y_z + A_1_leg_32 * z_z
    A_1_T_zz = A_1_leg_13 * s_z + A_1_leg_23 * y_z + A_1_leg_33 * z_z
    # force at the tip by S_dot
    A_1_xx = A_1_T_xs * s_x + A_1_T_xz * z_x + A_1_T_xy * y_x
    A_1_xy = A_1_T_xs * s_y + A_1_T_xz * z_y + A_1_T_xy * y_y
    A_1_xz = A_1_T_xs * s_z + A_1_T_xz * z_z + A_1_T_xy * y_z
    A_1_yx = A_1_T_ys * s_x + A_1_T_yz * z_x + A_1_T_yy * y_x
    A_1_yy = A_1_T_ys * s_y + A_1_T_yz * z_y + A_1_T_yy * y_y
    A_1_yz = A_1_T_ys * s_z + A_1_T_yz * z_z + A_1_T_yy * y_z
    A_1_zx = A_1_T_zs * s_x + A_1_T_zz * z_x + A_1_T_zy * y_x
    A_1_zy = A_1_T_zs * s_y + A_1_T_zz * z_y + A_1_T_zy * y_y
    A_1_zz = A_1_T_zs * s_z + A_1_T_zz * z_z + A_1_T_zy * y_z
    # derivative of the force by rotation about the tip
    X_xx = B_xx * m_xx + B_yx * m_xy + B_zx * m_xz + A_1_xy * omega_z - A_1_xz * omega_y + A_0_xx
    X_xy = B_xy * m_xx + B_yy * m_xy + B_zy * m_xz + A_1_xz * omega_x - A_1_xx * omega_z + A_0_xy
    X_xz = B_xz * m_xx + B_yz * m_xy + B_zz * m_xz + A_1_xx * omega_y - A_1_xy * omega_x + A_0_xz
    X_yx = B_xx * m_xy + B_yx * m_yy + B_zx * m_yz + A_1_yy * omega_z - A_1_yz * omega_y + A_0_yx
    X_yy = B_xy * m_xy + B_yy * m_yy + B_zy * m_yz + A_1_yz * omega_x - A_1_yx * omega_z + A_0_yy
    X_yz = B_xz * m_xy + B_yz * m_yy + B_zz * m_yz + A_1_yx * omega_y - A_1_yy * omega_x + A_0_yz
    X_zx = B_xx * m_xz + B_yx * m_yz + B_zx * m_zz + A_1_zy * omega_z - A_1_zz * omega_y + A_0_zx
    X_zy = B_xy * m_xz + B_yy * m_yz + B_zy * m_zz + A_1_zz * omega_x - A_1_zx * omega_z + A_0_zy
    X_zz = B_xz * m_xz + B_yz * m_yz + B_zz * m_zz + A_1_zx * omega_y - A_1_zy * omega_x + A_0_zz
    c285 = m_xy * omega_z
    c286 = m_xz * omega_y
    Y_xx = c285 - c286 + A_1_xx
    Y_xy = m_xz * omega_x - m_xx * omega_z + A_1_xy
    Y_xz = m_xx * omega_y - m_xy * omega_x + A_1_xz
    Y_yx = m_yy * omega_z - m_yz * omega_y + A_1_yx
    c287 = m_yz * omega_x
    Y_yy = c287 - c285 + A_1_yy
    Y_yz = m_xy * omega_y - m_yy * omega_x + A_1_yz
    Y_zx = m_yz * omega_z - m_zz * omega_y + A_1_zx
    Y_zy = m_zz * omega_x - m_xz * omega_z + A_1_zy
    Y_zz = c286 - c287 + A_1_zz
    c288 = X_xy * q_z
    Z_xx = X_xz * q_y - c288
    c289 = X_xx * q_z
    Z_xy = c289 - X_xz * q_x
    c290 = X_xx * q_y
    Z_xz = X_xy * q_x - c290
    c291 = X_yy * q_z
    Z_yx = X_yz * q_y - c291
    c292 = X_yx * q_z
    c293 = -X_yz * q_x
    Z_yy = c292 + c293
    c294 = -X_yy * q_x
    Z_yz = -X_yx * q_y - c294
    c295 = -X_zz * q_y
    Z_zx = -X_zy * q_z - c295
    c296 = -X_zz * q_x
    Z_zy = X_zx * q_z + c296
    c297 = X_zx * q_y
    Z_zz = X_zy * q_x - c297
    c298 = m_xy * w_q_z
    c299 = m_xz * w_q_y
    V_xx = c299 - f_S_dot_xx - c298 + Y_xz * q_y - Y_xy * q_z
    V_xy = m_xx * w_q_z - f_S_dot_yx - m_xz * w_q_x + Y_xx * q_z - Y_xz * q_x
    V_xz = m_xy * w_q_x - f_S_dot_zx - m_xx * w_q_y + Y_xy * q_x - Y_xx * q_y
    V_yx = m_yz * w_q_y - f_S_dot_xy - m_yy * w_q_z + Y_yz * q_y - Y_yy * q_z
    c300 = m_yz * w_q_x
    V_yy = c298 - f_S_dot_yy - c300 + Y_yx * q_z - Y_yz * q_x
    V_yz = m_yy * w_q_x - f_S_dot_zy - m_xy * w_q_y + Y_yy * q_x - Y_yx * q_y
    V_zx = m_zz * w_q_y - f_S_dot_xz - m_yz * w_q_z + Y_zz * q_y - Y_zy * q_z
    V_zy = m_xz * w_q_z - f_S_dot_yz - m_zz * w_q_x + Y_zx * q_z - Y_zz * q_x
    V_zz = c300 - f_S_dot_zz - c299 + Y_zy * q_x - Y_zx * q_y
    # derivative of the moment by rotation about the tip
    Q_xx = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx + c292 - c297
    Q_xy = f_S_dot_xz * omega_x - f_S_dot_xx * omega_z + f_S_xy - R_tip_z + c291 - X_zy * q_y
    Q_xz = f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz + R_tip_y + X_yz * q_z + c295
    Q_yx = f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx + R_tip_z + X_zx * q_x - c289
    Q_yy = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy + X_zy * q_x - c288
    Q_yz = f_S_dot_yx * omega_y - f_S_dot_yy * omega_x + f_S_yz - R_tip_x - X_xz * q_z - c296
    Q_zx = f_S_dot_zy * omega_z - f_S_dot_zz * omega_y + f_S_zx - R_tip_y + c290 - X_yx * q_x
    Q_zy = f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy + R_tip_x + X_xy * q_y + c294
    Q_zz = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz + X_xz * q_y + c293
    c301 = m_xy * q_z
    c302 = m_xz * q_y
    c303 = -m_yz * q_x
    # m [q]x
    m_q_xx = c301 - c302
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c301 - c303
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c302 + c303
    out = DerivativesLeg()
    out.M_vv = [m_xx, m_xy, m_xz, m_yy, m_yz, m_zz]
    out.M_vw = [-m_q_xx, -m_q_xy, -m_q_xz, -m_q_yx, -m_q_yy, -m_q_yz, -m_q_zx, -m_q_zy, -m_q_zz]
    out.M_ww = [
        m_q_yx * q_z - m_q_zx * q_y,
        m_q_yy * q_z - m_q_zy * q_y,
        m_q_yz * q_z - m_q_zz * q_y,
        m_q_zy * q_x - m_q_xy * q_z,
        m_q_zz * q_x - m_q_xz * q_z,
        m_q_xz * q_y - m_q_yz * q_x,
    ]
    out.W_ft = [A_0_xx, A_0_xy, A_0_xz, A_0_yx, A_0_yy, A_0_yz, A_0_zx, A_0_zy, A_0_zz]
    out.W_fr = [Z_xx, Z_xy, Z_xz, Z_yx, Z_yy, Z_yz, Z_zx, Z_zy, Z_zz]
    out.W_mt = [
        A_0_zx * q_y - f_S_xx - A_0_yx * q_z,
        A_0_zy * q_y - f_S_xy - A_0_yy * q_z,
        A_0_zz * q_y - f_S_xz - A_0_yz * q_z,
        A_0_xx * q_z - f_S_yx - A_0_zx * q_x,
        A_0_xy * q_z - f_S_yy - A_0_zy * q_x,
        A_0_xz * q_z - f_S_yz - A_0_zz * q_x,
        A_0_yx * q_x - f_S_zx - A_0_xx * q_y,
        A_0_yy * q_x - f_S_zy - A_0_xy * q_y,
        A_0_yz * q_x - f_S_zz - A_0_xz * q_y,
    ]
    out.W_mr = [
        Q_xy * q_z - Q_xz * q_y,
        Q_xz * q_x - Q_xx * q_z,
        Q_xx * q_y - Q_xy * q_x,
        Q_yy * q_z - Q_yz * q_y,
        Q_yz * q_x - Q_yx * q_z,
        Q_yx * q_y - Q_yy * q_x,
        Q_zy * q_z - Q_zz * q_y,
        Q_zz * q_x - Q_zx * q_z,
        Q_zx * q_y - Q_zy * q_x,
    ]
    out.W_fv = [A_1_xx, A_1_xy, A_1_xz, A_1_yx, A_1_yy, A_1_yz, A_1_zx, A_1_zy, A_1_zz]
    out.W_fw = [V_xx, V_xy, V_xz, V_yx, V_yy, V_yz, V_zx, V_zy, V_zz]
    out.W_mv = [
        A_1_zx * q_y - f_S_dot_xx - A_1_yx * q_z,
        A_1_zy * q_y - f_S_dot_xy - A_1_yy * q_z,
        A_1_zz * q_y - f_S_dot_xz - A_1_yz * q_z,
        A_1_xx * q_z - f_S_dot_yx - A_1_zx * q_x,
        A_1_xy * q_z - f_S_dot_yy - A_1_zy * q_x,
        A_1_xz * q_z - f_S_dot_yz - A_1_zz * q_x,
        A_1_yx * q_x - f_S_dot_zx - A_1_xx * q_y,
        A_1_yy * q_x - f_S_dot_zy - A_1_xy * q_y,
        A_1_yz * q_x - f_S_dot_zz - A_1_xz * q_y,
    ]
    out.W_mw = [
        V_zx * q_y + f_S_dot_xy * q_z - V_yx * q_z - f_S_dot_xz * q_y,
        V_zy * q_y + f_S_dot_xz * q_x - V_yy * q_z - f_S_dot_xx * q_z,
        V_zz * q_y + f_S_dot_xx * q_y - V_yz * q_z - f_S_dot_xy * q_x,
        V_xx * q_z + f_S_dot_yy * q_z - V_zx * q_x - f_S_dot_yz * q_y,
        V_xy * q_z + f_S_dot_yz * q_x - V_zy * q_x - f_S_dot_yx * q_z,
        V_xz * q_z + f_S_dot_yx * q_y - V_zz * q_x - f_S_dot_yy * q_x,
        V_yx * q_x + f_S_dot_zy * q_z - V_xx * q_y - f_S_dot_zz * q_y,
        V_yy * q_x + f_S_dot_zz * q_x - V_xy * q_y - f_S_dot_zx * q_z,
        V_yz * q_x + f_S_dot_zx * q_y - V_xz * q_y - f_S_dot_zy * q_x,
    ]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def derivatives_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs, by other blocks if a leg is near its joint singularity."""
    pose = derivatives_pose(on, model.platform, motion)
    derivatives_legs(on, model, motion, pose, legs)
    if on.anywhere(legs.leaning == 1):
        for i in range(6):
            near = derivatives_near(on, model.leg[i], model.platform, motion, pose, legs.given[i])
            legs.leg[i] = on.where(legs.leaning == 1, near, legs.leg[i])
    derivatives_total(on, pose, legs, summed)


def derivatives(on: Arithmetic, model: Any, motion: Any) -> Any:
    """Actuator forces of inverse dynamics and their derivatives by [dt; dphi], [v; omega], [a; alpha]."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    on.agree(motion=motion)
    out = Derivatives()
    legs = DerivativesLegs()
    summed = DerivativesSums()
    A = [[0.0] * 24 for _ in range(6)]
    acting = forces(on, model, motion)
    for i in range(6):
        legs.given[i].F = acting.F[i]
    derivatives_sums(on, model, motion, legs, summed)
    for i in range(3):
        for j in range(6):
            A[i][j] = legs.leg[j].H_force[i]
            A[i + 3][j] = legs.leg[j].H_moment[i]
    place_blocks_24(on, summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, A)
    place_blocks_24(on, summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, A)
    place_inertia_24(on, summed.M_vv, summed.M_vw, summed.M_ww, 18, A)
    scale_moments_24(on, model.per_length, A)
    solve_pivoted_24(on, A)
    for i in range(6):
        out.F[i] = acting.F[i]
        for j in range(6):
            out.by_pose[i][j] = A[i][j + 6]
            out.by_twist[i][j] = A[i][j + 12]
            out.by_acceleration[i][j] = A[i][j + 18]
    out.status = on.where(acting.status == OK, legs.status, acting.status)
    check_derivatives(on, out)
    return out


def joint_slopes_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench, and its generalized forces' derivatives: 2220
    (1410 mul, 806 add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_u, C_p, C_s, m_r, j_r = leg.m_u, leg.C_p, leg.C_s, leg.m_r, leg.j_r
    h_x, h_y, h_z = leg.h
    w_x, w_y, w_z = leg.w
    J_xx, J_xy, J_xz, J_yy, J_yz, J_zz = leg.J
    g_k = leg.g_k
    g_x_k_x, g_x_k_y, g_x_k_z = leg.g_x_k
    C_us = leg.C_us
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = pose.B
    net_x, net_y, net_z = given.net
    turned_x, turned_y, turned_z = given.turned
    axial = given.axial
    g_x, g_y, g_z = platform.g
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) reference point from base point, base frame
    t_b_x = t_x - b_x
    t_b_y = t_y - b_y
    t_b_z = t_z - b_z
    # (1) leg vector
    S_x = t_b_x + q_x
    S_y = t_b_y + q_y
    S_z = t_b_z + q_z
    # (10) component of the leg vector along the fixed axis, and normal to both
    zeta = S_x * k_x + S_y * k_y + S_z * k_z
    k_cross_S_x = S_z * k_y - S_y * k_z
    k_cross_S_y = S_x * k_z - S_z * k_x
    k_cross_S_z = S_y * k_x - S_x * k_y
    # (2) leg length, and distance of the tip from the fixed axis
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_S_z * s_y - k_cross_S_y * s_z
    s_cross_normal_y = k_cross_S_x * s_z - k_cross_S_z * s_x
    s_cross_normal_z = k_cross_S_y * s_x - k_cross_S_x * s_y
    # (10) leg length, and distance of the tip from the fixed axis
    rho = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_rho = 1.0 / rho
    # (10) third axis of the leg frame
    z_x = inv_rho * s_cross_normal_x
    z_y = inv_rho * s_cross_normal_y
    z_z = inv_rho * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = inv_L * zeta
    k3 = inv_L * rho
    # (10) k1 / k3
    kappa = inv_rho * zeta
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (5) rates of the joint coordinates: L, phi about k, theta about y
    L_dot = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    c1 = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    # (6) rates of the joint coordinates: L, phi about k, theta about y
    phi_dot = c1 * inv_rho
    theta_dot = -inv_L * (S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z)
    c2 = L_dot * inv_L
    # L_dot / L
    L_share = c2
    c3 = theta_dot * theta_dot
    theta_dot2 = c3
    phi_dot2 = phi_dot * phi_dot
    c4 = L * inv_rho
    inv_k3 = c4
    # (6) angular velocity of the leg about z
    W_z = c1 * inv_L
    c5 = omega_z * w_q_y
    c6 = omega_x * w_q_z - omega_z * w_q_x
    c7 = omega_y * w_q_x
    # (7) acceleration of the platform point
    S_ddot_x = omega_y * w_q_z - c5
    S_ddot_y = -c6
    S_ddot_z = omega_x * w_q_y - c7
    c8 = k3 * k3
    # (8) acceleration of the length
    L_ddot = turned_x + L * (theta_dot2 + c8 * phi_dot2) + S_ddot_x * s_x + S_ddot_z * s_z + S_ddot_y * s_y
    c9 = 2.0 * L_share
    c10 = k3 * turned_z
    # (9) angular accelerations of the leg about y and z without the rotation of the frame about s
    own_y = turned_y - inv_L * (S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z) - c9 * theta_dot
    own_z = c10 + inv_L * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - W_z * c9
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # k x y
    normal_x = k_y * y_z - k_z * y_y
    normal_y = k_z * y_x - k_x * y_z
    normal_z = k_x * y_y - k_y * y_x
    # omega along k x y, y and k
    w_n_omega = normal_x * omega_x + normal_y * omega_y + normal_z * omega_z
    w_y_omega = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_k_omega = k_x * omega_x + k_y * omega_y + k_z * omega_z
    c11 = inv_rho * net_z
    c12 = inv_L * net_y
    # force at the tip, less the actuator's
    R_tip_x = net_x * s_x - c12 * z_x + c11 * y_x
    R_tip_y = net_x * s_y - c12 * z_y + c11 * y_y
    R_tip_z = net_x * s_z - c12 * z_z + c11 * y_z
    fall_x = omega_y * w_q_z - g_x - c5
    fall_y = -g_y - c6
    fall_z = omega_x * w_q_y - g_z - c7
    # m_u times the acceleration of the platform point relative to free fall, leg frame
    fall_T_x = turned_x + fall_x * s_x + fall_z * s_z + fall_y * s_y
    fall_T_y = L * c10 + fall_x * y_x + fall_y * y_y + fall_z * y_z
    fall_T_z = fall_x * z_x - L * turned_y + fall_y * z_y + fall_z * z_z
    c13 = h_z * own_y
    c14 = W_z * W_z
    c15 = W_z * j_r
    c16 = inv_L * theta_dot
    c17 = 2.0 * c16
    c18 = j_r * k1
    c19 = inv_L * inv_L
    c20 = L_dot * c19
    c21 = 2.0 * h_y
    c22 = W_z * c21
    c23 = h_y * inv_L
    c24 = W_z * inv_k3
    c25 = c24 * k1
    c26 = 4.0 * c25
    c27 = c26 * theta_dot
    c28 = inv_k3 * inv_k3
    c29 = c14 * h_z
    c30 = c29 * inv_L
    c31 = inv_k3 * k1
    tau_S_leg_11 = (2.0 * c14 * h_x * inv_L - c14 * m_r - c3 * m_r + 2.0 * c3 * h_x * inv_L - 4.0 * c30 * c31
        + 2.0 * L_dot * c19 * h_z * theta_dot - c15 * c17 - c20 * c22 - c13 * inv_L + 4.0 * W_z * c28 * inv_L
        * j_r * theta_dot + h_y * inv_L * own_z + 2.0 * L_dot * W_z * c19 * inv_k3 * j_r * k1 - c23 * c27 - c18
        * inv_L * inv_k3 * own_z)
    c32 = inv_L * own_y
    c33 = c32 * j_r
    c34 = 2.0 * h_x
    c35 = c34 * inv_L
    c36 = c35 * own_z
    c37 = axial * m_u
    c38 = c37 * fall_T_y
    c39 = L_ddot * c19
    c40 = c19 * w_x
    c41 = c40 * gamma_y
    c42 = c23 * c3
    c43 = h_z * inv_L
    c44 = 2.0 * theta_dot
    c45 = c43 * c44
    c46 = h_y * own_y
    c47 = inv_L * k1
    c48 = c47 * inv_k3
    c49 = h_z * own_z
    c50 = J_zz * own_z
    c51 = c19 * c50
    c52 = c14 * c23
    c53 = c20 * theta_dot
    c54 = c53 * j_r
    c55 = L_dot * L_dot
    c56 = inv_L * inv_L * inv_L
    c57 = c55 * c56
    c58 = c18 * inv_k3
    c59 = axial * c20
    c60 = 4.0 * W_z
    c61 = 2.0 * c28
    c62 = 4.0 * c20
    c63 = h_y * k1
    c64 = c63 * inv_k3
    c65 = 2.0 * c64
    c66 = 2.0 * c57
    c67 = c14 * j_r
    c68 = c67 * k1
    c69 = inv_k3 * inv_k3 * inv_k3
    c70 = 2.0 * c69
    c71 = c70 * inv_L
    c72 = c18 * c3
    tau_S_leg_12 = (c42 - c21 * c57 + c52 * c61 - c52 - c42 * c61 + c58 * c66 + c71 * c72 - c68 * c71 + c39
        * h_y - c39 * c58 + c41 + C_p * W_z + W_z * c45 + c38 * inv_L + c54 * c61 - c53 * c65 - c54 + W_z * c34
        * c59 - axial * c41 + c33 + c46 * c48 + m_r * own_z + axial * c36 + c48 * c49 - c25 * c62 * h_z - c28
        * c33 - c28 * c43 * c60 * theta_dot - c36 + axial * c51 - c51)
    c73 = c32 * c34
    c74 = c37 * fall_T_z
    c75 = J_yy * c19 * own_y
    c76 = L_ddot * h_z
    c77 = c3 * h_z
    c78 = W_z * c44
    c79 = c23 * c78
    c80 = c15 * c20
    c81 = c40 * g_k * k3
    c82 = gamma_n * k1
    c83 = c40 * c82
    c84 = c28 * inv_L
    c85 = 2.0 * k1
    c86 = c15 * c85
    c87 = 2.0 * h_z
    c88 = c34 * theta_dot
    c89 = 2.0 * W_z
    c90 = c64 * c89
    c91 = 4.0 * c16
    c93 = J_yy - J_zz
    c94 = c14 * inv_k3
    c95 = c94 * k1
    c96 = c19 * c95
    tau_S_leg_13 = (c77 * inv_L - c57 * c87 + c30 * c61 - c30 + c81 - axial * c81 + c93 * c96 - axial * c93
        * c96 + c19 * c76 + c74 * inv_L - C_p * theta_dot + c83 - c59 * c88 + c80 + c20 * c90 + c28 * c79 + c73
        + c75 - axial * c83 - c79 - m_r * own_y + c16 * c86 * inv_k3 - c61 * c80 + c84 * j_r * own_z - axial
        * c73 - axial * c75 - c15 * c69 * c91 * k1)
    c98 = c34 * own_y
    c99 = C_us * inv_L
    c100 = c99 * theta_dot
    c101 = J_yz * inv_L
    c102 = 2.0 * J_yy
    c103 = c15 * c2
    c104 = inv_L * k3
    c105 = c104 * w_x
    c106 = inv_L * w_x
    c107 = c16 * c60
    c108 = J_xy * k1
    c109 = c108 * inv_L
    c110 = c109 * inv_k3
    c111 = J_xz * c14
    c112 = 4.0 * inv_L
    c113 = c28 * c29
    c114 = c21 * theta_dot
    c115 = W_z * c114
    c116 = c115 * c28
    c117 = 2.0 * J_xx
    tau_S_leg_21 = (c14 * h_z - c77 - c113 - c111 * c112 + 2.0 * J_xz * c14 * c28 * inv_L + axial * g_k * inv_L
        * k3 * w_x - c105 * g_k + c14 * inv_L * inv_k3 * k1 * (3.0 * J_zz - 3.0 * J_yy - c117) + axial * c14
        * c93 * inv_L * inv_k3 * k1 - c74 - c100 + 2.0 * J_yy * L_dot * c19 * theta_dot - c106 * c82 + 2.0 * L_dot
        * axial * h_x * inv_L * theta_dot + 2.0 * W_z * h_y * theta_dot + axial * gamma_n * inv_L * k1 * w_x
        - c103 - c116 - c98 + J_yy * axial * inv_L * own_y + 2.0 * J_yz * L_dot * W_z * c19 + 2.0 * axial * h_x
        * own_y - J_xy * c107 - c102 * c32 - c2 * c90 + 4.0 * J_xy * W_z * c28 * inv_L * theta_dot - c101 * own_z
        - c110 * own_z + 2.0 * J_xy * L_dot * W_z * c19 * inv_k3 * k1 + 4.0 * J_yz * W_z * inv_L * inv_k3 * k1
        * theta_dot)
    c118 = J_xy * c32
    c119 = W_z * c88
    c120 = gamma_y * inv_L * w_z
    c121 = c101 * c14
    c122 = C_s * inv_L
    c123 = c99 * inv_k3
    c124 = W_z * c123
    c125 = c38 * k1
    c126 = J_yz * c39
    c127 = c101 * c3
    c128 = c101 * k1 * own_y
    c129 = inv_k3 * own_z
    c130 = axial * k1
    c131 = c130 * c34
    c132 = axial * c50
    c133 = 2.0 * J_xy
    c134 = J_xz * W_z
    c135 = c134 * c62
    c136 = J_xz * k1
    c137 = c2 * theta_dot
    c138 = c106 * gamma_y
    c139 = 2.0 * J_yz
    c140 = c19 * c55
    c141 = c140 * j_r
    c142 = c108 * c39
    c143 = W_z * c87
    c144 = c143 * c28
    c145 = c143 * k1
    c146 = c145 * theta_dot
    c147 = c2 * c34
    c148 = c130 * c147
    c149 = c14 * c63
    c150 = c3 * c70
    c151 = c134 * c16
    c152 = J_yz * k1
    c153 = 2.0 * c53
    c154 = c152 * c153
    c155 = -2.0 * J_zz
    c156 = c117 + c155
    c157 = c108 * c66
    c158 = c109 * c14
    c159 = J_xz * c89
    c160 = c102 + c156
    c162 = W_z * c28
    tau_S_leg_22 = (c67 + c139 * c57 - c141 + c121 + c127 * c61 - c127 - c121 * c61 + c109 * c150 + c109 * c94
        + c149 * c70 + c157 * inv_k3 + c3 * c64 - c150 * c63 - c63 * c94 - c110 * c3 - c140 * c65 - c158 * c70
        + L_ddot * c23 * c31 - c126 - c142 * inv_k3 + c114 * c2 + J_xy * c53 * c61 - c133 * c53 - c137 * c58
        + W_z * c156 * c16 + c124 * k1 + c125 * inv_k3 + c148 * c24 + c154 * inv_k3 - c114 * c2 * c28 - c119
        - c120 + c118 + c2 * c60 * h_z + c28 * c46 - axial * c138 * c31 - c135 - c46 + c151 * c69 * c85 + c159
        * c20 * c28 + c49 - 4.0 * c136 * c16 * c24 - c144 * c2 - c16 * c160 * c162 + c129 * c131 + c27 * h_z
        - c118 * c28 - c122 * inv_k3 * w_n_omega - c128 * inv_k3 - c146 * c69 - c160 * c20 * c25 + c129 * c47
        * c93 + c132 * c48)
    c163 = c15 * theta_dot
    c164 = g_k * k1
    c165 = gamma_n * w_z
    c166 = J_yy * inv_L
    c167 = h_y * own_z
    c168 = c107 * c69
    c169 = 2.0 * c20
    c170 = c152 * c24
    c171 = J_xy * c89
    c172 = 2.0 * c111
    c173 = c172 * c47
    c174 = J_xx + c93
    tau_S_leg_23 = (J_yy * c3 * inv_L - c14 * c34 - c102 * c57 - c140 * c34 + c14 * c174 * c28 * inv_L - c14
        * c166 - c104 * g_k * w_z - c106 * c164 + C_us * L_dot * c19 + 2.0 * c14 * c69 * h_z * k1 - c173 * c69
        + fall_T_x * m_u + J_yy * L_ddot * c19 + 2.0 * L_ddot * h_x * inv_L + gamma_n * inv_L * k3 * w_x - c165
        * c47 - c13 - c163 - c2 * c22 - c64 * c78 + 2.0 * J_xy * L_dot * W_z * c19 + 2.0 * J_yz * W_z * inv_L
        * theta_dot - c101 * c28 * c78 - c169 * c170 + 2.0 * L_dot * W_z * c28 * h_y * inv_L + 4.0 * W_z * c69
        * h_y * k1 * theta_dot - c108 * c168 - c171 * c20 * c28 + 2.0 * J_xy * W_z * inv_L * inv_k3 * k1 * theta_dot
        + J_xy * c28 * inv_L * own_z - c167 * c28)
    c175 = c34 * k3
    c176 = c175 * own_z
    c177 = c105 * gamma_y
    c178 = c94 * h_y
    c179 = J_xx * inv_k3
    c180 = c179 * inv_L
    c181 = 2.0 * J_xz
    c182 = c181 * c47
    c183 = c101 * k3
    c184 = c143 * inv_k3
    c185 = j_r * k3
    c186 = c185 * theta_dot
    c187 = J_xz * c24
    c188 = W_z * c175
    c189 = c104 * own_z
    c190 = c20 * c24
    c191 = J_yz * k3
    c192 = c28 * k1
    c194 = -W_z * c156 * k3
    tau_S_leg_31 = (c178 + c104 * c133 * c14 + c104 * c133 * c3 - 2.0 * J_xy * c94 * inv_L - c68 - c121 * c85
        - c127 * c85 - c72 + c177 + c186 * c2 + c108 * c153 + c153 * c191 + c38 * k3 - axial * c177 - c124 + axial
        * c188 * c2 + c117 * c190 + c135 * k1 + c187 * c91 - c183 * own_y + J_xx * c107 * c192 + c194 * c20
        - c145 * c2 - c184 * theta_dot + axial * c176 + c189 * (J_xx + c155) - c118 * k1 - c176 - c180 * own_z
        - c182 * own_z + c104 * c132)
    c195 = c106 * gamma_n
    c196 = L_ddot * inv_L
    c197 = c77 * c85
    c198 = c108 * c16 * c89
    c199 = c87 * theta_dot
    c200 = c2 * k3
    c201 = c117 * inv_L
    c202 = c87 * k1
    c203 = J_xx - J_zz
    tau_S_leg_32 = (2.0 * J_xx * c3 * c69 * inv_L - c14 * c201 * c69 + c14 * c174 * inv_L * inv_k3 + c14 * inv_L
        * k3 * (J_xx - J_yy) + 2.0 * c3 * h_x * k3 + 2.0 * J_xx * c55 * c56 * inv_k3 + axial * c14 * c93 * inv_L
        * k3 + 2.0 * c19 * c55 * h_x * k3 - c156 * c55 * c56 * k3 - c180 * c3 - c203 * c3 * inv_L * k3 - axial
        * c14 * c93 * inv_L * inv_k3 - c140 * c202 - c172 * c84 * k1 - c173 - c197 + 2.0 * J_xz * c3 * inv_L
        * k1 + 4.0 * J_xz * c55 * c56 * k1 + 2.0 * c14 * c28 * h_z * k1 + g_k * inv_L * k1 * k3 * w_x - axial
        * c105 * c164 - c197 * c28 + 2.0 * J_xz * c28 * c3 * inv_L * k1 - C_us * c20 * inv_k3 + L_ddot * c19
        * c203 * k3 - c175 * c196 - c179 * c39 - fall_T_x * k3 * m_u + 2.0 * L_ddot * h_z * inv_L * k1 - J_xz
        * c39 * c85 + axial * fall_T_z * k1 * m_u - c100 * c192 - c199 * c200 + gamma_y * inv_L * inv_k3 * w_y
        - axial * c195 - c130 * c2 * c88 - c195 * c8 + 2.0 * J_xz * L_dot * c19 * inv_k3 * theta_dot + axial
        * c8 * gamma_n * inv_L * w_x + gamma_n * inv_L * inv_k3 * k1 * w_z - c183 * c78 + 2.0 * J_xx * L_dot
        * c19 * c28 * k1 * theta_dot + c174 * inv_L * k1 * own_y + 2.0 * h_z * inv_k3 * own_y - c103 * k1 - 2.0
        * c13 * k3 - c133 * c190 - c152 * c20 * c89 - c163 * k3 - c198 + 2.0 * J_xy * L_dot * W_z * c19 * k3
        + 2.0 * J_xz * inv_L * k3 * own_y + 2.0 * W_z * c28 * h_y * k1 * theta_dot + j_r * k1 * own_z - axial
        * c166 * k1 * own_y - axial * c98 * k1 - c181 * c32 * inv_k3 - c198 * c28 + J_xy * inv_L * inv_k3 * own_z
        + J_yz * inv_L * k1 * own_z - J_xx * c28 * c32 * k1 - J_xy * c189 - c167 * inv_k3)
    c205 = 2.0 * k3
    c206 = J_xx * own_z
    c207 = 2.0 * c109
    c208 = c162 * k1
    c209 = c84 * k1
    c210 = J_xy * k3
    c211 = c117 * c208
    tau_S_leg_33 = (c127 * c205 + c185 * c3 - c141 * k3 - c191 * c66 - c157 + c158 * c28 + c207 * c3 - c149
        * c28 + c142 + c185 * c196 + c126 * k3 + c137 * c18 + c130 * c138 + c154 + c119 * k3 + c120 * k3 - W_z
        * c148 - c125 - c153 * c210 + c107 * c179 + c134 * c91 * k1 + c184 * c2 + c208 * c99 - c143 * c200 - c18
        * own_y + c118 * k3 + c144 * k1 * theta_dot + c16 * c194 - c128 - c146 - c181 * c190 + c181 * c189 + c206
        * c209 + c206 * c47 - J_xx * c168 - c131 * own_z - c151 * c28 * c85 - c20 * c211 - c205 * c49 - c132
        * c47)
    # derivatives of the generalized forces by the tip's motion
    tau_S_xx = s_x * tau_S_leg_11 + tau_S_leg_13 * z_x + tau_S_leg_12 * y_x
    tau_S_xy = s_y * tau_S_leg_11 + tau_S_leg_13 * z_y + tau_S_leg_12 * y_y
    tau_S_xz = s_z * tau_S_leg_11 + tau_S_leg_13 * z_z + tau_S_leg_12 * y_z
    tau_S_yx = tau_S_leg_23 * z_x + s_x * tau_S_leg_21 + tau_S_leg_22 * y_x
    tau_S_yy = tau_S_leg_23 * z_y + s_y * tau_S_leg_21 + tau_S_leg_22 * y_y
    tau_S_yz = tau_S_leg_23 * z_z + s_z * tau_S_leg_21 + tau_S_leg_22 * y_z
    tau_S_zx = s_x * tau_S_leg_31 + tau_S_leg_33 * z_x + tau_S_leg_32 * y_x
    tau_S_zy = s_y * tau_S_leg_31 + tau_S_leg_33 * z_y + tau_S_leg_32 * y_y
    tau_S_zz = s_z * tau_S_leg_31 + tau_S_leg_33 * z_z + tau_S_leg_32 * y_z
    c212 = c15 * inv_L
    c213 = c85 * inv_k3
    tau_S_dot_leg_11 = C_p - c45 + c23 * c89 - c212 * c213
    c214 = 2.0 * m_r
    c215 = c16 * j_r
    tau_S_dot_leg_12 = (c20 * c21 - c169 * c58 + c213 * c23 * theta_dot + c215 + W_z * c214 - W_z * c35 - c215
        * c61 + c26 * c43)
    tau_S_dot_leg_13 = c20 * c87 + c16 * c34 - c214 * theta_dot + c212 * c61 - c212 - c23 * c24 * c85
    tau_S_dot_leg_21 = (W_z * j_r - c88 - c102 * c16 - c101 * c89 - c207 * c24 + 2.0 * W_z * h_y * inv_k3 * k1)
    c216 = c101 * c85
    c217 = c216 * theta_dot
    c218 = c108 * c169
    tau_S_dot_leg_22 = (L_dot * inv_L * j_r - c139 * c20 + 2.0 * L_dot * h_y * inv_L * inv_k3 * k1 - c218 * inv_k3
        - c114 + 2.0 * J_xy * inv_L * theta_dot + 2.0 * c28 * h_y * theta_dot - c217 * inv_k3 - c143 + 4.0 * J_xz
        * W_z * inv_L + 2.0 * W_z * c28 * h_z - J_xy * c17 * c28 + W_z * c160 * inv_L * inv_k3 * k1 - c159 * c84)
    tau_S_dot_leg_23 = (c102 * c20 - c99 + c147 - c199 + c22 + c216 * c24 + c171 * c84 - c22 * c28 - c171 * inv_L)
    tau_S_dot_leg_31 = (W_z * c156 * inv_L * k3 - c186 - c183 * c44 - c108 * c17 - c188 + 2.0 * W_z * h_z * k1
        - c201 * c24 - c112 * c134 * k1)
    c219 = c24 * inv_L
    tau_S_dot_leg_32 = (c123 + c2 * c202 + c156 * c20 * k3 - c175 * c2 - c117 * c20 * inv_k3 - c136 * c62 + c199
        * inv_k3 + W_z * c216 + c86 - c117 * c16 * c192 + c133 * c219 - J_xz * c17 * inv_k3 - c22 * inv_k3 - c104
        * c171)
    tau_S_dot_leg_33 = (c185 * c2 + c169 * c191 + c218 - c217 + c17 * c210 - c18 * c44 + W_z * c117 * c209 + c181
        * c219 - c184)
    # derivatives of the generalized forces by the tip's motion
    tau_S_dot_xx = s_x * tau_S_dot_leg_11 + tau_S_dot_leg_12 * y_x + tau_S_dot_leg_13 * z_x
    tau_S_dot_xy = s_y * tau_S_dot_leg_11 + tau_S_dot_leg_12 * y_y + tau_S_dot_leg_13 * z_y
    tau_S_dot_xz = s_z * tau_S_dot_leg_11 + tau_S_dot_leg_12 * y_z + tau_S_dot_leg_13 * z_z
    tau_S_dot_yx = s_x * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_x + tau_S_dot_leg_22 * y_x
    tau_S_dot_yy = s_y * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_y + tau_S_dot_leg_22 * y_y
    tau_S_dot_yz = s_z * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_z + tau_S_dot_leg_22 * y_z
    tau_S_dot_zx = tau_S_dot_leg_33 * z_x + s_x * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_x
    tau_S_dot_zy = tau_S_dot_leg_33 * z_y + s_y * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_y
    tau_S_dot_zz = tau_S_dot_leg_33 * z_z + s_z * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_z
    tau_S_ddot_leg_11 = m_r + m_u
    tau_S_ddot_leg_12 = inv_L * inv_k3 * j_r * k1 - c23
    tau_S_ddot_leg_13 = -c43
    tau_S_ddot_leg_22 = c101 + c110 - c64
    c220 = L * m_u
    tau_S_ddot_leg_23 = -c34 - c166 - c220
    c221 = h_y * k3
    tau_S_ddot_leg_31 = j_r * k1 - c221
    tau_S_ddot_leg_32 = c175 + c220 * k3 + c180 - c104 * c203 + c182 - c202
    tau_S_ddot_leg_33 = h_y * k1 - c183 - c109
    # derivatives of the generalized forces by the tip's motion
    tau_S_ddot_xx = s_x * tau_S_ddot_leg_11 + tau_S_ddot_leg_13 * z_x + tau_S_ddot_leg_12 * y_x
    tau_S_ddot_xy = s_y * tau_S_ddot_leg_11 + tau_S_ddot_leg_13 * z_y + tau_S_ddot_leg_12 * y_y
    tau_S_ddot_xz = s_z * tau_S_ddot_leg_11 + tau_S_ddot_leg_13 * z_z + tau_S_ddot_leg_12 * y_z
    tau_S_ddot_yx = h_z * s_x + tau_S_ddot_leg_23 * z_x + tau_S_ddot_leg_22 * y_x
    tau_S_ddot_yy = h_z * s_y + tau_S_ddot_leg_23 * z_y + tau_S_ddot_leg_22 * y_y
    tau_S_ddot_yz = h_z * s_z + tau_S_ddot_leg_23 * z_z + tau_S_ddot_leg_22 * y_z
    tau_S_ddot_zx = s_x * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_x + tau_S_ddot_leg_32 * y_x
    tau_S_ddot_zy = s_y * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_y + tau_S_ddot_leg_32 * y_y
    tau_S_ddot_zz = s_z * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_z + tau_S_ddot_leg_32 * y_z
    c222 = 1.0 - axial
    c223 = L * k1
    c224 = (axial * net_z + c222 * (J_xy * c14 * inv_k3 - C_s * w_k_omega + L * c14 * h_y * k3 + L * c3 * h_y
        * k3 - c14 * c210 - c210 * c3 - L * c178 + J_yz * c14 * k1 + J_yz * c3 * k1 + L_ddot * j_r * k1 - L_ddot
        * c221 + gamma_y * k1 * w_z - L_dot * c186 - gamma_n * w_y + C_us * W_z * inv_k3 - L_dot * c44 * c63
        + J_xy * k1 * own_y + J_yz * k3 * own_y - L_dot * c145 - c187 * c44 - c223 * c46 + J_xx * inv_k3 * own_z
        + 2.0 * L * W_z * h_z * inv_k3 * theta_dot - c211 * theta_dot + 2.0 * J_xz * k1 * own_z - c206 * k3
        - L * c49 * c85))
    c225 = c224 * inv_rho * inv_rho
    bent_leg_12 = -c225 * k3
    c226 = J_xy * c78
    c227 = (axial * net_y + c222 * (c172 - c111 * c28 + L * c113 - 2.0 * L * c29 + J_xx * c95 - c164 * w_z + c76
        + C_us * theta_dot + c165 * k3 - C_s * w_y_omega + L_dot * c15 + c226 + L * c116 - L * c115 + J_yz * own_z
        - c170 * c44 - c226 * c28 + c108 * c129 - L * c64 * own_z))
    c228 = c19 * c227
    bent_leg_13 = c228
    bent_leg_21 = -L * c228
    bent_leg_22 = -c223 * c225
    bent_leg_23 = -L * inv_L * net_x
    c229 = c104 * c224 * c4
    bent_leg_31 = -c229
    c230 = inv_rho * k3
    bent_leg_32 = L * k3 * (c230 * net_x + c227 * c47 * inv_rho)
    bent_leg_33 = c229 * kappa
    # derivative of the generalized forces by the tip's position, with the rotation of the rows
    tau_place_xx = bent_leg_13 * z_x + tau_S_xx + bent_leg_12 * y_x
    tau_place_xy = bent_leg_13 * z_y + tau_S_xy + bent_leg_12 * y_y
    tau_place_xz = bent_leg_13 * z_z + tau_S_xz + bent_leg_12 * y_z
    tau_place_yx = bent_leg_23 * z_x + bent_leg_21 * s_x + bent_leg_22 * y_x + tau_S_yx
    tau_place_yy = bent_leg_23 * z_y + bent_leg_21 * s_y + bent_leg_22 * y_y + tau_S_yy
    tau_place_yz = bent_leg_23 * z_z + bent_leg_21 * s_z + bent_leg_22 * y_z + tau_S_yz
    tau_place_zx = bent_leg_32 * y_x + bent_leg_31 * s_x + bent_leg_33 * z_x + tau_S_zx
    tau_place_zy = bent_leg_32 * y_y + bent_leg_31 * s_y + bent_leg_33 * z_y + tau_S_zy
    tau_place_zz = bent_leg_32 * y_z + bent_leg_31 * s_z + bent_leg_33 * z_z + tau_S_zz
    X_xx = (B_xx * tau_S_ddot_xx + B_yx * tau_S_ddot_xy + B_zx * tau_S_ddot_xz + omega_z * tau_S_dot_xy - omega_y
        * tau_S_dot_xz + tau_place_xx)
    X_xy = (B_xy * tau_S_ddot_xx + B_yy * tau_S_ddot_xy + B_zy * tau_S_ddot_xz + omega_x * tau_S_dot_xz - omega_z
        * tau_S_dot_xx + tau_place_xy)
    X_xz = (B_xz * tau_S_ddot_xx + B_yz * tau_S_ddot_xy + B_zz * tau_S_ddot_xz + omega_y * tau_S_dot_xx - omega_x
        * tau_S_dot_xy + tau_place_xz)
    X_yx = (B_xx * tau_S_ddot_yx + B_yx * tau_S_ddot_yy + B_zx * tau_S_ddot_yz + omega_z * tau_S_dot_yy - omega_y
        * tau_S_dot_yz + tau_place_yx)
    X_yy = (B_xy * tau_S_ddot_yx + B_yy * tau_S_ddot_yy + B_zy * tau_S_ddot_yz + omega_x * tau_S_dot_yz - omega_z
        * tau_S_dot_yx + tau_place_yy)
    X_yz = (B_xz * tau_S_ddot_yx + B_yz * tau_S_ddot_yy + B_zz * tau_S_ddot_yz + omega_y * tau_S_dot_yx - omega_x
        * tau_S_dot_yy + tau_place_yz)
    X_zx = (B_xx * tau_S_ddot_zx + B_yx * tau_S_ddot_zy + B_zx * tau_S_ddot_zz + omega_z * tau_S_dot_zy - omega_y
        * tau_S_dot_zz + tau_place_zx)
    X_zy = (B_xy * tau_S_ddot_zx + B_yy * tau_S_ddot_zy + B_zy * tau_S_ddot_zz + omega_x * tau_S_dot_zz - omega_z
        * tau_S_dot_zx + tau_place_zy)
    X_zz = (B_xz * tau_S_ddot_zx + B_yz * tau_S_ddot_zy + B_zz * tau_S_ddot_zz + omega_y * tau_S_dot_zx - omega_x
        * tau_S_dot_zy + tau_place_zz)
    Y_xx = omega_z * tau_S_ddot_xy - omega_y * tau_S_ddot_xz + tau_S_dot_xx
    Y_xy = omega_x * tau_S_ddot_xz - omega_z * tau_S_ddot_xx + tau_S_dot_xy
    Y_xz = omega_y * tau_S_ddot_xx - omega_x * tau_S_ddot_xy + tau_S_dot_xz
    Y_yx = omega_z * tau_S_ddot_yy - omega_y * tau_S_ddot_yz + tau_S_dot_yx
    Y_yy = omega_x * tau_S_ddot_yz - omega_z * tau_S_ddot_yx + tau_S_dot_yy
    Y_yz = omega_y * tau_S_ddot_yx - omega_x * tau_S_ddot_yy + tau_S_dot_yz
    Y_zx = omega_z * tau_S_ddot_zy - omega_y * tau_S_ddot_zz + tau_S_dot_zx
    Y_zy = omega_x * tau_S_ddot_zz - omega_z * tau_S_ddot_zx + tau_S_dot_zy
    Y_zz = omega_y * tau_S_ddot_zx - omega_x * tau_S_ddot_zy + tau_S_dot_zz
    G_dot_21 = -c16
    c231 = k1 * phi_dot
    G_dot_22 = c231 * inv_L
    G_dot_23 = c20
    G_dot_31 = -c230 * phi_dot
    G_dot_32 = -c2 * inv_rho - inv_rho * kappa * theta_dot
    G_dot_33 = c231 * inv_rho
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_31 * s_x + G_dot_32 * y_x + G_dot_33 * z_x)
    phi_dot_by_S_y = C_s * (G_dot_31 * s_y + G_dot_32 * y_y + G_dot_33 * z_y)
    phi_dot_by_S_z = C_s * (G_dot_31 * s_z + G_dot_32 * y_z + G_dot_33 * z_z)
    # gradient of theta, times C_s
    C_s_theta_x = -c122 * z_x
    C_s_theta_y = -c122 * z_y
    C_s_theta_z = -c122 * z_z
    c232 = C_s * y_x
    c233 = C_s * y_y
    c234 = C_s * y_z
    # gradient of phi, times C_s
    C_s_phi_x = c232 * inv_rho
    C_s_phi_y = c233 * inv_rho
    C_s_phi_z = c234 * inv_rho
    y_by_phi_x = normal_x * theta_dot
    y_by_phi_y = normal_y * theta_dot
    y_by_phi_z = normal_z * theta_dot
    # friction moment by S
    f_S_xx = C_s_phi_x * y_by_phi_x + theta_dot_by_S_x * y_x + k_x * phi_dot_by_S_x
    f_S_xy = C_s_phi_y * y_by_phi_x + theta_dot_by_S_y * y_x + k_x * phi_dot_by_S_y
    f_S_xz = C_s_phi_z * y_by_phi_x + theta_dot_by_S_z * y_x + k_x * phi_dot_by_S_z
    f_S_yx = C_s_phi_x * y_by_phi_y + theta_dot_by_S_x * y_y + k_y * phi_dot_by_S_x
    f_S_yy = C_s_phi_y * y_by_phi_y + theta_dot_by_S_y * y_y + k_y * phi_dot_by_S_y
    f_S_yz = C_s_phi_z * y_by_phi_y + theta_dot_by_S_z * y_y + k_y * phi_dot_by_S_z
    f_S_zx = C_s_phi_x * y_by_phi_z + theta_dot_by_S_x * y_z + k_z * phi_dot_by_S_x
    f_S_zy = C_s_phi_y * y_by_phi_z + theta_dot_by_S_y * y_z + k_z * phi_dot_by_S_y
    f_S_zz = C_s_phi_z * y_by_phi_z + theta_dot_by_S_z * y_z + k_z * phi_dot_by_S_z
    # friction moment by S_dot
    f_S_dot_xx = C_s_theta_x * y_x + C_s_phi_x * k_x
    f_S_dot_xy = C_s_theta_y * y_x + C_s_phi_y * k_x
    f_S_dot_xz = C_s_theta_z * y_x + C_s_phi_z * k_x
    f_S_dot_yx = C_s_theta_x * y_y + C_s_phi_x * k_y
    f_S_dot_yy = C_s_theta_y * y_y + C_s_phi_y * k_y
    f_S_dot_yz = C_s_theta_z * y_y + C_s_phi_z * k_y
    f_S_dot_zx = C_s_theta_x * y_z + C_s_phi_x * k_z
    f_S_dot_zy = C_s_theta_y * y_z + C_s_phi_y * k_z
    f_S_dot_zz = C_s_theta_z * y_z + C_s_phi_z * k_z
    c238 = R_tip_y + f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz
    c239 = f_S_dot_xz * omega_x - R_tip_z - f_S_dot_xx * omega_z + f_S_xy
    c240 = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx
    c241 = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy
    c242 = f_S_dot_yx * omega_y - R_tip_x - f_S_dot_yy * omega_x + f_S_yz
    c243 = R_tip_z + f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx
    c244 = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz
    c245 = R_tip_x + f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy
    c246 = f_S_dot_zy * omega_z - R_tip_y - f_S_dot_zz * omega_y + f_S_zx
    out = JointSlopesLeg()
    out.M_vv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_vw = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_ww = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_ft = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fr = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mt = [-f_S_xx, -f_S_xy, -f_S_xz, -f_S_yx, -f_S_yy, -f_S_yz, -f_S_zx, -f_S_zy, -f_S_zz]
    out.W_mr = [
        c239 * q_z - c238 * q_y,
        c238 * q_x - c240 * q_z,
        c240 * q_y - c239 * q_x,
        c241 * q_z - c242 * q_y,
        c242 * q_x - c243 * q_z,
        c243 * q_y - c241 * q_x,
        c245 * q_z - c244 * q_y,
        c244 * q_x - c246 * q_z,
        c246 * q_y - c245 * q_x,
    ]
    out.W_fv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fw = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mv = [
        -f_S_dot_xx,
        -f_S_dot_xy,
        -f_S_dot_xz,
        -f_S_dot_yx,
        -f_S_dot_yy,
        -f_S_dot_yz,
        -f_S_dot_zx,
        -f_S_dot_zy,
        -f_S_dot_zz,
    ]
    out.W_mw = [
        f_S_dot_xy * q_z - f_S_dot_xz * q_y,
        f_S_dot_xz * q_x - f_S_dot_xx * q_z,
        f_S_dot_xx * q_y - f_S_dot_xy * q_x,
        f_S_dot_yy * q_z - f_S_dot_yz * q_y,
        f_S_dot_yz * q_x - f_S_dot_yx * q_z,
        f_S_dot_yx * q_y - f_S_dot_yy * q_x,
        f_S_dot_zy * q_z - f_S_dot_zz * q_y,
        f_S_dot_zz * q_x - f_S_dot_zx * q_z,
        f_S_dot_zx * q_y - f_S_dot_zy * q_x,
    ]
    out.tau_t = [
        tau_place_xx,
        tau_place_xy,
        tau_place_xz,
        tau_place_yx,
        tau_place_yy,
        tau_place_yz,
        tau_place_zx,
        tau_place_zy,
        tau_place_zz,
    ]
    out.tau_r = [
        X_xz * q_y - X_xy * q_z,
        X_xx * q_z - X_xz * q_x,
        X_xy * q_x - X_xx * q_y,
        X_yz * q_y - X_yy * q_z,
        X_yx * q_z - X_yz * q_x,
        X_yy * q_x - X_yx * q_y,
        X_zz * q_y - X_zy * q_z,
        X_zx * q_z - X_zz * q_x,
        X_zy * q_x - X_zx * q_y,
    ]
    out.tau_v = [
        tau_S_dot_xx,
        tau_S_dot_xy,
        tau_S_dot_xz,
        tau_S_dot_yx,
        tau_S_dot_yy,
        tau_S_dot_yz,
        tau_S_dot_zx,
        tau_S_dot_zy,
        tau_S_dot_zz,
    ]
    out.tau_w = [
        Y_xz * q_y + tau_S_ddot_xz * w_q_y - Y_xy * q_z - tau_S_ddot_xy * w_q_z,
        Y_xx * q_z + tau_S_ddot_xx * w_q_z - Y_xz * q_x - tau_S_ddot_xz * w_q_x,
        Y_xy * q_x + tau_S_ddot_xy * w_q_x - Y_xx * q_y - tau_S_ddot_xx * w_q_y,
        Y_yz * q_y + tau_S_ddot_yz * w_q_y - c232 - Y_yy * q_z - tau_S_ddot_yy * w_q_z,
        Y_yx * q_z + tau_S_ddot_yx * w_q_z - c233 - Y_yz * q_x - tau_S_ddot_yz * w_q_x,
        Y_yy * q_x + tau_S_ddot_yy * w_q_x - c234 - Y_yx * q_y - tau_S_ddot_yx * w_q_y,
        Y_zz * q_y + tau_S_ddot_zz * w_q_y - C_s * k_x - Y_zy * q_z - tau_S_ddot_zy * w_q_z,
        Y_zx * q_z + tau_S_ddot_zx * w_q_z - C_s * k_y - Y_zz * q_x - tau_S_ddot_zz * w_q_x,
        Y_zy * q_x + tau_S_ddot_zy * w_q_x - C_s * k_z - Y_zx * q_y - tau_S_ddot_zx * w_q_y,
    ]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    return out


def joint_slopes_legs(on: Arithmetic, model: Any, motion: Any, pose: Any, legs: Any) -> None:
    """Terms of the legs, their status, and a mark if a leg is near its joint singularity."""
    status = model.status
    leaning = 0
    for i in range(6):
        legs.leg[i] = joint_slopes_leg(on, model.leg[i], model.platform, motion, pose, legs.given[i])
        legs.reach[i] = reach_of(on, model.leg[i].b, motion.t, legs.leg[i].q)
        fault = fault_of(on, legs.leg[i].L, legs.leg[i].k3, legs.reach[i])
        status = on.where(status == OK, fault, status)
        leaning = on.where(legs.leg[i].k3 > on.LEANING, leaning, 1)
    legs.status = status
    legs.leaning = leaning


def joint_slopes_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = joint_slopes_pose(on, model.platform, motion)
    joint_slopes_legs(on, model, motion, pose, legs)
    joint_slopes_total(on, pose, legs, summed)


def slopes_apart(on: Arithmetic, model: Any, motion: Any, moving: Any, F: Any) -> Any:
    """M^-1 times the derivatives of the wrench and H, columns 6 to 23 of A, as ``forward_apart`` solves."""
    out = SlopesApart()
    by = Rows()
    legs = JointSlopesLegs()
    summed = JointSlopesSums()
    start = [0.0] * 6
    starts = [[0.0] * 6 for _ in range(18)]
    force = [0.0] * 24
    forces_by = [[0.0] * 24 for _ in range(18)]
    wrench = [0.0] * 6
    held = [0.0] * 6
    rest = [0.0] * 24
    right = [0.0] * 6
    apart = forward_apart(on, model, motion, F, by)
    for i in range(6):
        out.x[i] = apart.x[i]
        legs.given[i].axial = by.given[i].axial
        for j in range(3):
            legs.given[i].net[j] = by.given[i].net[j]
            legs.given[i].turned[j] = by.given[i].turned[j]
    joint_slopes_sums(on, model, moving, legs, summed)
    place_blocks_24(on, summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, out.A)
    place_blocks_24(on, summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, out.A)
    for i in range(3):
        for j in range(6):
            out.A[i][j + 18] = legs.leg[j].H_force[i]
            out.A[i + 3][j + 18] = legs.leg[j].H_moment[i]
    for i in range(6):
        for j in range(6):
            out.A[i][j] = by.inertia[i][j]
    for i in range(6):
        for j in range(3):
            for k in range(3):
                forces_by[k][3 * i + j] = -legs.leg[i].tau_t[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 3][3 * i + j] = -legs.leg[i].tau_r[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 6][3 * i + j] = -legs.leg[i].tau_v[3 * j + k] / by.extent[3 * i + j]
                forces_by[k + 9][3 * i + j] = -legs.leg[i].tau_w[3 * j + k] / by.extent[3 * i + j]
    for c in range(18):
        for i in range(24):
            force[i] = forces_by[c][i]
        for i in range(6):
            wrench[i] = out.A[i][c + 6]
        by_rows(on, by, wrench, held)
        row_right(on, by, force, held, start, rest, right)
        for i in range(6):
            starts[c][i] = start[i]
            out.A[i][c + 6] = right[i]
    fault = solve_definite_24(on, out.A, on.ROUNDING)
    for c in range(18):
        for i in range(6):
            right[i] = out.A[i][c + 6]
            start[i] = starts[c][i]
        row_back(on, by, right, start, wrench)
        for i in range(6):
            out.A[i][c + 6] = wrench[i]
    out.status = on.where(apart.status == OK, on.where(legs.status == OK, fault, legs.status), apart.status)
    return out


def linearization(on: Arithmetic, model: Any, motion: Any, F: Any) -> Any:
    """Forward dynamics, and d/dt [dt; dphi; dv; domega] = A [dt; dphi; dv; domega] + B dF about it."""
    model = on.arrays(on.checked(Model(), "model", model))
    motion = on.arrays(on.checked(Motion(), "motion", motion))
    F = on.arrays(on.checked([0.0] * 6, "F", F))
    on.agree(motion=motion, F=F)
    out = LinearizationResult()
    legs = DerivativesLegs()
    summed = DerivativesSums()
    A = [[0.0] * 24 for _ in range(6)]
    moved = forward_dynamics(on, model, motion, F)
    status = moved.status
    moving = with_acceleration(on, motion, moved.a, moved.alpha)
    for i in range(6):
        legs.given[i].F = F[i]
    derivatives_sums(on, model, moving, legs, summed)
    place_inertia_24(on, summed.M_vv, summed.M_vw, summed.M_ww, 0, A)
    place_blocks_24(on, summed.W_ft, summed.W_fr, summed.W_mt, summed.W_mr, 6, A)
    place_blocks_24(on, summed.W_fv, summed.W_fw, summed.W_mv, summed.W_mw, 12, A)
    for i in range(3):
        for j in range(6):
            A[i][j + 18] = legs.leg[j].H_force[i]
            A[i + 3][j + 18] = legs.leg[j].H_moment[i]
    fault = solve_definite_24(on, A, on.KEPT)
    if on.anywhere((status == OK) & (fault == MASS_MATRIX_INDEFINITE)):
        apart = slopes_apart(on, model, motion, moving, F)
        for i in range(6):
            for j in range(6, 24):
                A[i][j] = on.where(fault == MASS_MATRIX_INDEFINITE, apart.A[i][j], A[i][j])
        for i in range(3):
            moved.a[i] = on.where(fault == MASS_MATRIX_INDEFINITE, apart.x[i], moved.a[i])
            moved.alpha[i] = on.where(fault == MASS_MATRIX_INDEFINITE, apart.x[i + 3], moved.alpha[i])
        fault = on.where(fault == MASS_MATRIX_INDEFINITE, apart.status, fault)
    for i in range(3):
        out.a[i] = moved.a[i]
        out.alpha[i] = moved.alpha[i]
    for i in range(6):
        for j in range(12):
            out.A[i][j] = 0.0
            out.A[i + 6][j] = -A[i][j + 6]
        for j in range(6):
            out.B[i][j] = 0.0
            out.B[i + 6][j] = A[i][j + 18]
        out.A[i][i + 6] = 1.0
    out.A[3][4] = -motion.omega[2]
    out.A[3][5] = motion.omega[1]
    out.A[4][3] = motion.omega[2]
    out.A[4][5] = -motion.omega[0]
    out.A[5][3] = -motion.omega[1]
    out.A[5][4] = motion.omega[0]
    out.status = on.where(status == OK, fault, status)
    check_linearization(on, out)
    return out



def motion_of(on: Arithmetic, **fields: Any) -> Motion:
    """Return a motion from arrays: R (..., 9) or (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3).

    R is required; other fields are zero by default. The leading shapes must broadcast.

    Raises
    ------
    ValueError
        If a name or a shape is wrong.
    """
    made = Motion()
    on.fill(made, fields)
    return made
