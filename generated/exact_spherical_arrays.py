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
    Added, Forces, LegTerms, MomentTerms, Motion, Robot as Robot, SharedTerms, Sums, add_up, cube_of,
    fault_of, largest_component, moments_of, per_length_of, reach_of, shift, singular_status, size_of,
    solve_legs,
)


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.m_d: Any = 0.0  # kg: mass of the lower part
        self.r_d0: Any = [0.0] * 3  # m: center of mass of the lower part, frame D
        self.I_d0: Any = [0.0] * 6  # kg m^2: inertia of the lower part about its center of mass, frame D
        self.m_u: Any = 0.0  # kg: mass of the upper part
        self.r_u0: Any = [0.0] * 3  # m: center of mass of the upper part, frame U
        self.I_u0: Any = [0.0] * 6  # kg m^2: inertia of the upper part about its center of mass, frame U
        self.C_u: Any = 0.0  # N m s: viscous friction of the universal joint
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
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
    """Constants of one leg, and its contributions to the constants of the platform: 0 (0 mul, 0 add, 0
    div, 0 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    m_d = leg.m_d
    r_d0_x, r_d0_y, r_d0_z = leg.r_d0
    I_d0_xx, I_d0_xy, I_d0_xz, I_d0_yy, I_d0_yz, I_d0_zz = leg.I_d0
    m_u = leg.m_u
    r_u0_x, r_u0_y, r_u0_z = leg.r_u0
    I_u0_xx, I_u0_xy, I_u0_xz, I_u0_yy, I_u0_yz, I_u0_zz = leg.I_u0
    C_u = leg.C_u
    C_p = leg.C_p
    C_s = leg.C_s
    out = LegConstants()
    out.b = [b_x, b_y, b_z]
    out.p = [p_x, p_y, p_z]
    out.m_d = m_d
    out.r_d0 = [r_d0_x, r_d0_y, r_d0_z]
    out.I_d0 = [I_d0_xx, I_d0_xy, I_d0_xz, I_d0_yy, I_d0_yz, I_d0_zz]
    out.m_u = m_u
    out.r_u0 = [r_u0_x, r_u0_y, r_u0_z]
    out.I_u0 = [I_u0_xx, I_u0_xy, I_u0_xz, I_u0_yy, I_u0_yz, I_u0_zz]
    out.C_u = C_u
    out.C_p = C_p
    out.C_s = C_s
    out.M_add = 0.0
    out.h_add = [0.0, 0.0, 0.0]
    out.J_add = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.C_add = 0.0
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
        lost = lost + 0.0 * model.leg[leg].m_d
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].r_d0[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].I_d0[i]
        lost = lost + 0.0 * model.leg[leg].m_u
        for i in range(3):
            lost = lost + 0.0 * model.leg[leg].r_u0[i]
        for i in range(6):
            lost = lost + 0.0 * model.leg[leg].I_u0[i]
        lost = lost + 0.0 * model.leg[leg].C_u
        lost = lost + 0.0 * model.leg[leg].C_p
        lost = lost + 0.0 * model.leg[leg].C_s
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


def shared_terms(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """B and the platform's part of c, (7), (30)-(35): 174 (90 mul, 84 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    M_P = platform.M_P
    r_C_x, r_C_y, r_C_z = platform.r_C
    J_C_xx, J_C_xy, J_C_xz, J_C_yy, J_C_yz, J_C_zz = platform.J_C
    dJ_C_x, dJ_C_y, dJ_C_z = platform.dJ_C
    g_x, g_y, g_z = platform.g
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_xy = omega_xy - alpha_z
    B_xz = alpha_y + omega_xz
    B_yx = alpha_z + omega_xy
    B_yy = -omega_xx - omega_zz
    B_yz = omega_yz - alpha_x
    B_zx = omega_xz - alpha_y
    B_zy = alpha_x + omega_yz
    B_zz = -omega_xx - omega_yy
    # (30) center of mass from the reference point, base frame
    R_C_x = R_xx * r_C_x + R_xy * r_C_y + R_xz * r_C_z
    R_C_y = R_yx * r_C_x + R_yy * r_C_y + R_yz * r_C_z
    R_C_z = R_zx * r_C_x + R_zy * r_C_y + R_zz * r_C_z
    # (33) M_P (g - a_C)
    N_x = M_P * (g_x - a_x - B_xx * R_C_x - B_xy * R_C_y - B_xz * R_C_z)
    N_y = M_P * (g_y - a_y - B_yx * R_C_x - B_yy * R_C_y - B_yz * R_C_z)
    N_z = M_P * (g_z - a_z - B_zx * R_C_x - B_zy * R_C_y - B_zz * R_C_z)
    # angular velocity, platform frame
    omega_P_x = R_xx * omega_x + R_yx * omega_y + R_zx * omega_z
    omega_P_y = R_xy * omega_x + R_yy * omega_y + R_zy * omega_z
    omega_P_z = R_xz * omega_x + R_yz * omega_y + R_zz * omega_z
    # angular acceleration, platform frame
    alpha_P_x = R_xx * alpha_x + R_yx * alpha_y + R_zx * alpha_z
    alpha_P_y = R_xy * alpha_x + R_yy * alpha_y + R_zy * alpha_z
    alpha_P_z = R_xz * alpha_x + R_yz * alpha_y + R_zz * alpha_z
    P_xy = omega_P_x * omega_P_y
    P_xz = omega_P_x * omega_P_z
    P_yz = omega_P_y * omega_P_z
    P_xx = omega_P_x * omega_P_x
    P_yy = omega_P_y * omega_P_y
    P_zz = omega_P_z * omega_P_z
    # (34) external moment less I alpha + omega x I omega, platform frame
    M_P_load_x = (M_ext_x - J_C_yz * (P_yy - P_zz) - J_C_xx * alpha_P_x - P_yz * dJ_C_x + J_C_xy * (P_xz - alpha_P_y)
        - J_C_xz * (alpha_P_z + P_xy))
    M_P_load_y = (M_ext_y - J_C_xz * (P_zz - P_xx) - J_C_yy * alpha_P_y - P_xz * dJ_C_y + J_C_yz * (P_xy - alpha_P_z)
        - J_C_xy * (alpha_P_x + P_yz))
    M_P_load_z = (M_ext_z - J_C_xy * (P_xx - P_yy) - J_C_zz * alpha_P_z - P_xy * dJ_C_z + J_C_xz * (P_yz - alpha_P_x)
        - J_C_yz * (alpha_P_y + P_xz))
    out = SharedTerms()
    out.B = [B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz]
    out.c_force = [
        N_x + F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz,
        N_y + F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz,
        N_z + F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz,
    ]
    out.c_moment = [
        M_P_load_x * R_xx + M_P_load_y * R_xy + M_P_load_z * R_xz + N_z * R_C_y - N_y * R_C_z,
        M_P_load_x * R_yx + M_P_load_y * R_yy + M_P_load_z * R_yz + N_x * R_C_z - N_z * R_C_x,
        M_P_load_x * R_zx + M_P_load_y * R_zy + M_P_load_z * R_zz + N_y * R_C_x - N_x * R_C_y,
    ]
    return out


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg: D, K, its column of H and its part of c, (1)-(24), (35): 221 (128 mul, 91 add, 1 div, 1
    sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    m_d = leg.m_d
    r_d0_x = leg.r_d0[0]
    I_d0_yy = leg.I_d0[3]
    m_u = leg.m_u
    r_u0_x = leg.r_u0[0]
    I_u0_yy = leg.I_u0[3]
    C_u, C_p, C_s = leg.C_u, leg.C_p, leg.C_s
    g_x, g_y, g_z = platform.g
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    a_x, a_y, a_z = motion.a
    B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz = shared.B
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
    # (4) omega x q
    w_q_x = omega_y * q_z - omega_z * q_y
    w_q_y = omega_z * q_x - omega_x * q_z
    w_q_z = omega_x * q_y - omega_y * q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (7) acceleration of the platform point
    S_ddot_x = a_x + B_xx * q_x + B_xy * q_y + B_xz * q_z
    S_ddot_y = a_y + B_yx * q_x + B_yy * q_y + B_yz * q_z
    S_ddot_z = a_z + B_zx * q_x + B_zy * q_y + B_zz * q_z
    # part of e along the leg
    e_x = S_ddot_x * s_x + S_ddot_y * s_y + S_ddot_z * s_z
    # part of u along the leg
    u_x = S_dot_x * s_x + S_dot_y * s_y + S_dot_z * s_z
    # part of gamma along the leg
    gamma_x = g_x * s_x + g_y * s_y + g_z * s_z
    # part of w along the leg
    w_x = omega_x * s_x + omega_y * s_y + omega_z * s_z
    # part of e across the leg
    e_across_x = S_ddot_x - e_x * s_x
    e_across_y = S_ddot_y - e_x * s_y
    e_across_z = S_ddot_z - e_x * s_z
    # part of u across the leg
    u_across_x = S_dot_x - s_x * u_x
    u_across_y = S_dot_y - s_y * u_x
    u_across_z = S_dot_z - s_z * u_x
    # part of gamma across the leg
    gamma_across_x = g_x - gamma_x * s_x
    gamma_across_y = g_y - gamma_x * s_y
    gamma_across_z = g_z - gamma_x * s_z
    c1 = s_x * w_x
    c2 = s_y * w_x
    c3 = s_z * w_x
    # part of w across the leg
    w_across_x = omega_x - c1
    w_across_y = omega_y - c2
    w_across_z = omega_z - c3
    # square of u across the leg
    u_square = u_across_x * u_across_x + u_across_y * u_across_y + u_across_z * u_across_z
    c4 = inv_L * inv_L
    c5 = m_u * r_u0_x
    # (24) known part of the actuator force
    D = C_p * u_x - c4 * c5 * u_square - gamma_x * m_u + e_x * m_u
    c6 = m_u * L * L
    c7 = m_d * r_d0_x * r_d0_x
    c8 = m_u * r_u0_x * r_u0_x
    c9 = L * m_u
    K_e = c4 * (I_d0_yy + I_u0_yy + c6 + c7 + c8 + 2.0 * c9 * r_u0_x)
    c10 = 2.0 * inv_L * u_x
    K_u = (c4 * (C_s + C_u + 2.0 * L * m_u * u_x + 2.0 * m_u * r_u0_x * u_x - I_d0_yy * c10 - I_u0_yy * c10
        - c10 * c6 - c10 * c7 - c10 * c8 - 4.0 * c9 * inv_L * r_u0_x * u_x))
    K_gamma = -inv_L * (c5 + m_d * r_d0_x + c9)
    c11 = C_s * inv_L
    K_s_w = c11
    # K, base frame
    K_x = (K_gamma * gamma_across_x + K_e * e_across_x + K_s_w * (s_y * w_across_z - s_z * w_across_y) + K_u
        * u_across_x)
    K_y = (K_gamma * gamma_across_y + K_e * e_across_y + K_s_w * (s_z * w_across_x - s_x * w_across_z) + K_u
        * u_across_y)
    K_z = (K_gamma * gamma_across_z + K_e * e_across_z + K_s_w * (s_x * w_across_y - s_y * w_across_x) + K_u
        * u_across_z)
    f_s_u = c11
    # f, base frame
    f_x = f_s_u * (s_y * u_across_z - s_z * u_across_y) - C_s * c1 - C_s * w_across_x
    f_y = f_s_u * (s_z * u_across_x - s_x * u_across_z) - C_s * c2 - C_s * w_across_y
    f_z = f_s_u * (s_x * u_across_y - s_y * u_across_x) - C_s * c3 - C_s * w_across_z
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = 1.0
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [f_x, f_y, f_z]
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
    shared = shared_terms(on, model.platform, motion)
    for i in range(6):
        leg = leg_terms(on, model.leg[i], model.platform, motion, shared)
        reach[i] = reach_of(on, model.leg[i].b, motion.t, leg.q)
        fault = fault_of(on, leg.L, leg.k3, reach[i])
        status = on.where(status == OK, fault, status)
        suspect = on.where(leg.L > on.SHORT_SHARE * reach[i], suspect, 1)
        sums.leg[i] = leg
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
