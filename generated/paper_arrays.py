"""Dynamics of a Gough-Stewart platform on arrays of the array API: NumPy, JAX, PyTorch, and others.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Each number of a structure may be an array with one value per pose, so the component is the first index: ``F`` is
a list of six. An array instead of such a list has the components last, (..., 6). ``on`` is the arithmetic:
selections, square roots, and constants. If a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

from .arithmetic import NOT_FINITE, OK, Arithmetic
from .exact_arrays import (
    Added, Forces, LegTerms, MomentTerms, Motion, Robot as Robot, Sums, add_up, cube_of, fault_of,
    largest_component, moments_of, per_length_of, reach_of, shared_terms, shift, singular_status,
    size_of, solve_legs,
)


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
        self.h: Any = [0.0] * 3  # kg m: first moment of the upper part about the platform point, leg frame
        # kg m: sum m_d r_d0 + m_u r_u0 of the first moments of both parts, leg frame
        self.w: Any = [0.0] * 3
        # kg m^2: sum of the inertias of the lower part about the base point and the upper part about the platform point, leg frame
        self.J: Any = [0.0] * 6
        self.C_us: Any = 0.0  # N m s: C_u + C_s
        self.m_L2: Any = 0.0  # kg: m_u, counted twice in (16)
        self.M_add: Any = 0.0  # kg: mass of the leg that is added to the platform
        # kg m: first moment of the mass M_add about platform point 1, platform frame
        self.h_add: Any = [0.0] * 3
        # kg m^2: inertia of the mass M_add about platform point 1, platform frame
        self.J_add: Any = [0.0] * 6
        self.C_add: Any = 0.0  # N m s: friction of the leg's spherical joint


class Platform:
    """Constants of the platform."""

    def __init__(self) -> None:
        self.M_P: Any = 0.0  # kg: M plus the masses m_u of all legs (massless legs: M)
        # m: center of mass of M_P, with the masses m_u at the platform points (massless legs: R_0), platform frame
        self.r_C: Any = [0.0] * 3
        self.J_C: Any = [0.0] * 6  # kg m^2: inertia of the mass M_P about r_C, platform frame
        self.dJ_C: Any = [0.0] * 3  # kg m^2: J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx
        self.C_P: Any = 0.0  # N m s: sum of C_s of all legs
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame


class Model:
    """A robot's constants, prepared once."""

    def __init__(self) -> None:
        self.leg: Any = [LegConstants() for _ in range(6)]  # the legs
        self.platform: Any = Platform()  # the platform
        self.per_length: Any = 0.0  # 1/m: one over the length over which moments are taken
        self.arm_cube: Any = 0.0  # cube of the largest arm over that length
        self.status: Any = 0  # 0, or the code of an error


def prepare_leg(on: Arithmetic, robot: Any, p_1: Any, leg: Any) -> Any:
    """Constants of one leg, and its contributions to the constants of the platform: 80 (42 mul, 36 add,
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
    C_u, C_p, C_s = leg.C_u, leg.C_p, leg.C_s
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
    out.h = [h_x, h_y, h_z]
    out.w = [w_x, w_y, w_z]
    out.J = [J_xx, J_xy, J_xz, J_yy, J_yz, J_zz]
    out.C_us = C_s + C_u
    out.m_L2 = m_u
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


def prepare_platform(on: Arithmetic, robot: Any, p_1: Any, total: Any) -> Any:
    """Constants of the platform: 82 (38 mul, 43 add, 1 div, 0 sqrt)."""
    M = robot.M
    R_0_x, R_0_y, R_0_z = robot.R_0
    I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz = robot.I_p
    g_x, g_y, g_z = robot.g
    M_add = total.M_add
    h_add_x, h_add_y, h_add_z = total.h_add
    J_add_xx, J_add_xy, J_add_xz, J_add_yy, J_add_yz, J_add_zz = total.J_add
    C_add = total.C_add
    p_1_x, p_1_y, p_1_z = p_1[0], p_1[1], p_1[2]
    M_P = M + M_add
    # center of mass of the platform without the upper parts, from platform point 1
    arm_x = R_0_x - p_1_x
    arm_y = R_0_y - p_1_y
    arm_z = R_0_z - p_1_z
    # first moment of the lumped masses about this center
    e_x = h_add_x - M_add * arm_x
    e_y = h_add_y - M_add * arm_y
    e_z = h_add_z - M_add * arm_z
    # first moment about the reference point
    h_P_x = h_add_x + M * R_0_x + M_add * p_1_x
    h_P_y = h_add_y + M * R_0_y + M_add * p_1_y
    h_P_z = h_add_z + M * R_0_z + M_add * p_1_z
    c1 = 1.0 / M_P
    r_C_x = c1 * h_P_x
    r_C_y = c1 * h_P_y
    r_C_z = c1 * h_P_z
    r_x = c1 * h_add_x
    r_y = c1 * h_add_y
    r_z = c1 * h_add_z
    c2 = 0.5 * M * c1
    u_x = c2 * (h_add_x + e_x)
    u_y = c2 * (h_add_y + e_y)
    u_z = c2 * (h_add_z + e_z)
    c3 = h_add_z * r_z + 2.0 * arm_z * u_z
    c4 = h_add_y * r_y + 2.0 * arm_y * u_y
    J_C_xx = I_p_xx + J_add_xx - c3 - c4
    J_C_xy = I_p_xy + J_add_xy + h_add_x * r_y + arm_x * u_y + arm_y * u_x
    J_C_xz = I_p_xz + J_add_xz + h_add_x * r_z + arm_x * u_z + arm_z * u_x
    c5 = h_add_x * r_x + 2.0 * arm_x * u_x
    J_C_yy = I_p_yy + J_add_yy - c3 - c5
    J_C_yz = I_p_yz + J_add_yz + h_add_y * r_z + arm_y * u_z + arm_z * u_y
    J_C_zz = I_p_zz + J_add_zz - c4 - c5
    out = Platform()
    out.M_P = M_P
    out.r_C = [r_C_x, r_C_y, r_C_z]
    out.J_C = [J_C_xx, J_C_xy, J_C_xz, J_C_yy, J_C_yz, J_C_zz]
    out.dJ_C = [J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx]
    out.C_P = C_add
    out.g = [g_x, g_y, g_z]
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
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].h[i]
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].w[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].J[i]
        lost = lost + 0.0 * model.leg[leg].C_us
        lost = lost + 0.0 * model.leg[leg].m_L2
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
    """One leg in its frame: D, its column of H and its part of c: 243 (142 mul, 97 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
    h_x, h_y, h_z = leg.h
    w_x, w_y, w_z = leg.w
    J_xy, J_xz, J_yy, J_yz, J_zz = leg.J[1], leg.J[2], leg.J[3], leg.J[4], leg.J[5]
    C_us, m_L2 = leg.C_us, leg.m_L2
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
    # (2) leg length
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y * s_z - k_z * s_y
    k_cross_s_y = k_z * s_x - k_x * s_z
    k_cross_s_z = k_x * s_y - k_y * s_x
    # (10) |k x s|
    k3 = on.sqrt(k_cross_s_x * k_cross_s_x + k_cross_s_y * k_cross_s_y + k_cross_s_z * k_cross_s_z)
    inv_k3 = 1.0 / k3
    # (10) second axis of the leg frame
    y_x = inv_k3 * k_cross_s_x
    y_y = inv_k3 * k_cross_s_y
    y_z = inv_k3 * k_cross_s_z
    # (10) third axis of the leg frame
    z_x = s_y * y_z - s_z * y_y
    z_y = s_z * y_x - s_x * y_z
    z_z = s_x * y_y - s_y * y_x
    # (4) velocity of the platform point
    S_dot_x = v_x + omega_y * q_z - omega_z * q_y
    S_dot_y = v_y + omega_z * q_x - omega_x * q_z
    S_dot_z = v_z + omega_x * q_y - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # (4), (5) velocity of the platform point, leg frame; u_x is L_dot
    u_x = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    u_y = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    u_z = S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z
    # (7) acceleration of the platform point, leg frame
    e_x = S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    e_y = S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z
    e_z = S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z
    # gravity, leg frame
    gamma_x = g_x * s_x + g_y * s_y + g_z * s_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    gamma_z = g_x * z_x + g_y * z_y + g_z * z_z
    # (6) angular velocity of the leg, leg frame
    W_y = -inv_L * u_z
    W_z = inv_L * u_y
    shrink = 2.0 * inv_L * u_x
    # (9) angular acceleration of the leg, leg frame
    A_y = -e_z * inv_L - W_y * shrink
    A_z = e_y * inv_L - W_z * shrink
    W_yy = W_y * W_y
    W_zz = W_z * W_z
    W_yz = W_y * W_z
    # (14) force that accelerates the upper part about the platform point, leg frame
    N_x = A_y * h_z - h_x * (W_yy + W_zz) - A_z * h_y
    N_y = A_z * h_x - W_zz * h_y + W_yz * h_z
    N_z = W_yz * h_y - W_yy * h_z - A_y * h_x
    # (16) m_u L^2, counted twice
    m_L2_twice = m_L2 * L * L
    # (20) moment that the joint forces must balance
    C_y = (J_xz * W_zz - gamma_x * w_z + e_x * h_z - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + gamma_z
        * w_x + A_z * J_yz - e_z * h_x + C_us * W_y + J_xy * W_yz + A_y * J_yy + A_y * m_L2_twice)
    C_z = (gamma_x * w_y - J_xy * W_yy - e_x * h_y + e_y * h_x + C_us * W_z - gamma_y * w_x + A_z * J_zz + A_z
        * m_L2_twice - C_s * (omega_x * z_x + omega_y * z_y + omega_z * z_z) - J_xz * W_yz + A_y * J_yz)
    # (21) transverse force, leg frame
    K_y_leg = N_y + C_z * inv_L
    K_z_leg = N_z - C_y * inv_L
    # (21) transverse force, base frame
    K_x = K_y_leg * y_x + K_z_leg * z_x
    K_y = K_y_leg * y_y + K_z_leg * z_y
    K_z = K_y_leg * y_z + K_z_leg * z_z
    # (24) known part of the actuator force
    D = C_p * u_x + N_x
    c1 = C_s * W_y
    c2 = C_s * W_z
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c1 * y_x + c2 * z_x, c1 * y_y + c2 * z_y, c1 * y_z + c2 * z_z]
    return out


def leg_near_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in its frame: D, its column of H and its part of c: 252 (148 mul, 100 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
    h_x, h_y, h_z = leg.h
    w_x, w_y, w_z = leg.w
    J_xy, J_xz, J_yy, J_yz, J_zz = leg.J[1], leg.J[2], leg.J[3], leg.J[4], leg.J[5]
    C_us, m_L2 = leg.C_us, leg.m_L2
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
    # (2) leg length
    L = on.sqrt(S_x * S_x + S_y * S_y + S_z * S_z)
    inv_L = 1.0 / L
    # (3) unit vector along the leg
    s_x = S_x * inv_L
    s_y = S_y * inv_L
    s_z = S_z * inv_L
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y * s_z - k_z * s_y
    k_cross_s_y = k_z * s_x - k_x * s_z
    k_cross_s_z = k_x * s_y - k_y * s_x
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_s_z * s_y - k_cross_s_y * s_z
    s_cross_normal_y = k_cross_s_x * s_z - k_cross_s_z * s_x
    s_cross_normal_z = k_cross_s_y * s_x - k_cross_s_x * s_y
    # (10) |k x s|
    k3 = (on.sqrt(s_cross_normal_x * s_cross_normal_x + s_cross_normal_y * s_cross_normal_y + s_cross_normal_z
        * s_cross_normal_z))
    inv_k3 = 1.0 / k3
    # (10) third axis of the leg frame
    z_x = inv_k3 * s_cross_normal_x
    z_y = inv_k3 * s_cross_normal_y
    z_z = inv_k3 * s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z * z_y - s_y * z_z
    y_y = s_x * z_z - s_z * z_x
    y_z = s_y * z_x - s_x * z_y
    # (4) velocity of the platform point
    S_dot_x = v_x + omega_y * q_z - omega_z * q_y
    S_dot_y = v_y + omega_z * q_x - omega_x * q_z
    S_dot_z = v_z + omega_x * q_y - omega_y * q_x
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # (4), (5) velocity of the platform point, leg frame; u_x is L_dot
    u_x = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    u_y = S_dot_x * y_x + S_dot_y * y_y + S_dot_z * y_z
    u_z = S_dot_x * z_x + S_dot_y * z_y + S_dot_z * z_z
    # (7) acceleration of the platform point, leg frame
    e_x = S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    e_y = S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z
    e_z = S_ddot_x * z_x + S_ddot_y * z_y + S_ddot_z * z_z
    # gravity, leg frame
    gamma_x = g_x * s_x + g_y * s_y + g_z * s_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    gamma_z = g_x * z_x + g_y * z_y + g_z * z_z
    # (6) angular velocity of the leg, leg frame
    W_y = -inv_L * u_z
    W_z = inv_L * u_y
    shrink = 2.0 * inv_L * u_x
    # (9) angular acceleration of the leg, leg frame
    A_y = -e_z * inv_L - W_y * shrink
    A_z = e_y * inv_L - W_z * shrink
    W_yy = W_y * W_y
    W_zz = W_z * W_z
    W_yz = W_y * W_z
    # (14) force that accelerates the upper part about the platform point, leg frame
    N_x = A_y * h_z - h_x * (W_yy + W_zz) - A_z * h_y
    N_y = W_yz * h_z - W_zz * h_y + A_z * h_x
    N_z = W_yz * h_y - W_yy * h_z - A_y * h_x
    # (16) m_u L^2, counted twice
    m_L2_twice = m_L2 * L * L
    # (20) moment that the joint forces must balance
    C_y = (J_xz * W_zz - gamma_x * w_z + e_x * h_z + gamma_z * w_x - e_z * h_x + C_us * W_y - C_s * (omega_x
        * y_x + omega_y * y_y + omega_z * y_z) + A_y * J_yy + A_y * m_L2_twice + J_xy * W_yz + A_z * J_yz)
    C_z = (gamma_x * w_y - J_xy * W_yy - e_x * h_y - C_s * (omega_x * z_x + omega_y * z_y + omega_z * z_z) + e_y
        * h_x + C_us * W_z - gamma_y * w_x + A_y * J_yz - J_xz * W_yz + A_z * J_zz + A_z * m_L2_twice)
    # (21) transverse force, leg frame
    K_y_leg = N_y + C_z * inv_L
    K_z_leg = N_z - C_y * inv_L
    # (21) transverse force, base frame
    K_x = K_y_leg * y_x + K_z_leg * z_x
    K_y = K_y_leg * y_y + K_z_leg * z_y
    K_z = K_y_leg * y_z + K_z_leg * z_z
    # (24) known part of the actuator force
    D = C_p * u_x + N_x
    c1 = C_s * W_y
    c2 = C_s * W_z
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c1 * y_x + c2 * z_x, c1 * y_y + c2 * z_y, c1 * y_z + c2 * z_z]
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
