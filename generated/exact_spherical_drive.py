"""Inverse dynamics and joint reactions of a Gough-Stewart platform on arrays, kernel `exact_spherical_drive`.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Arguments and results are described in every_output.py.

Operations of the inverse dynamics of one pose, without the checks for the status:
6 x leg   253 (146 mul, 105 add, 1 div, 1 sqrt)
platform  219 (123 mul, 96 add, 0 div, 0 sqrt)
sum of c  36 (0 mul, 36 add, 0 div, 0 sqrt)
solve     197 (106 mul, 85 add, 6 div, 0 sqrt)
forces    6 (0 mul, 6 add, 0 div, 0 sqrt)
total     1976 (1105 mul, 853 add, 12 div, 6 sqrt)
leg: one leg. platform: terms that are common to all legs, and the platform's part of c.
sum of c: sum of the parts of c. solve: H x = c, (36). forces: F = D - x, (37).
add: additions and subtractions. Negations, copies, and comparisons are not counted.
"""

from typing import Any

from .arithmetic import NOT_FINITE, OK, Arithmetic
from .every_output import (
    Terms, eliminate, fault_of, first_of, platform_wrench, reach_of, scale_of, singular_status,
)

# Operations (mul, add, div, sqrt) of each part of one pose, and in total.
OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (146, 105, 1, 1),
        "platform": (123, 96, 0, 0),
        "sum of c": (0, 36, 0, 0),
        "solve": (106, 85, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1105, 853, 12, 6),
    },
}

# Operations of stewart_exact_spherical_drive_forces.h.
FORCE_OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (131, 93, 1, 1),
        "platform": (96, 90, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 51, 0, 0),
        "solve": (158, 102, 2, 0),
        "forces": (0, 6, 0, 0),
        "total": (1100, 852, 8, 6),
    },
}


class Legs:
    """Terms of the legs."""

    def __init__(self) -> None:
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.D: Any = 0.0  # N: known part of the actuator force
        self.K: Any = [0.0] * 3  # N: transverse force on the leg at its spherical joint, base frame
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        self.c_force: Any = [0.0] * 3  # N: part of c, force rows, base frame
        self.c_moment: Any = [0.0] * 3  # N m: part of c, moment rows, base frame
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class LegReactions:
    """Forces and moments in a leg's joints."""

    def __init__(self) -> None:
        self.F_s: Any = [0.0] * 3  # N: force on the leg at the spherical joint, base frame
        self.F_u: Any = [0.0] * 3  # N: force on the leg at the universal joint, base frame
        # N: force of the lower part on the upper at the prismatic joint, without the viscous friction -C_p L_dot s, base frame
        self.F_p: Any = [0.0] * 3
        self.F_c: Any = [0.0] * 3  # N: constraint part of F_p, base frame
        # N m: moment of the lower part, on which the gyroscopic moment of a rotor acts, on the upper at the prismatic joint, base frame
        self.M_p: Any = [0.0] * 3
        # N m: constraint moment on the leg at the universal joint, along k x y, y the moving axis; in `paper` along s
        self.M_u: Any = 0.0


class Forces:
    """Actuator forces, and what they are made of."""

    def __init__(self) -> None:
        self.F: Any = [0.0] * 6  # N: actuator forces, (37)
        self.x: Any = [0.0] * 6  # N: axial forces of the legs at the platform, (36)
        self.terms: Any = Terms()  # D, K, H and c
        self.legs: Any = Legs()  # what the legs have
        self.reach: Any = 0.0  # m: size of the vectors that each leg is the sum of
        self.suspect: Any = 0  # 1 where H may be singular to rounding
        self.status: Any = 0  # 0, or the code of an error


def leg_dynamics(on: Arithmetic, leg: Any, robot: Any, motion: Any) -> Any:
    """One leg: D, K, its column of H and its part of c, (1)-(24), (35): 253 (146 mul, 105 add, 1 div, 1
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
    C_u, C_p, C_s, m_r = leg.C_u, leg.C_p, leg.C_s, leg.m_r
    g_x, g_y, g_z = robot.g
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) leg vector
    S_x = t_x - b_x + q_x
    S_y = t_y - b_y + q_y
    S_z = t_z - b_z + q_z
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
    S_ddot_x = a_x + alpha_y * q_z - alpha_z * q_y + omega_y * w_q_z - omega_z * w_q_y
    S_ddot_y = a_y + alpha_z * q_x - alpha_x * q_z + omega_z * w_q_x - omega_x * w_q_z
    S_ddot_z = a_z + alpha_x * q_y - alpha_y * q_x + omega_x * w_q_y - omega_y * w_q_x
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
    c5 = c4 * u_square
    c6 = m_u * r_u0_x
    # (24) known part of the actuator force
    D = L * c5 * m_r - c5 * c6 - gamma_x * m_u + C_p * u_x + e_x * m_r + e_x * m_u
    c7 = m_u * L * L
    c8 = m_d * r_d0_x * r_d0_x
    c9 = m_u * r_u0_x * r_u0_x
    c10 = L * m_u
    K_e = c4 * (I_d0_yy + I_u0_yy + c7 + c8 + c9 + 2.0 * c10 * r_u0_x)
    c11 = 2.0 * inv_L * u_x
    K_u = (c4 * (C_s + C_u + 2.0 * L * m_u * u_x + 2.0 * m_u * r_u0_x * u_x - I_d0_yy * c11 - I_u0_yy * c11
        - 4.0 * c10 * inv_L * r_u0_x * u_x - c11 * c7 - c11 * c8 - c11 * c9))
    K_gamma = -inv_L * (c6 + m_d * r_d0_x + c10)
    c12 = C_s * inv_L
    K_s_w = c12
    # K, base frame
    K_x = (K_gamma * gamma_across_x + K_s_w * (s_y * w_across_z - s_z * w_across_y) + K_e * e_across_x + K_u
        * u_across_x)
    K_y = (K_gamma * gamma_across_y + K_s_w * (s_z * w_across_x - s_x * w_across_z) + K_e * e_across_y + K_u
        * u_across_y)
    K_z = (K_gamma * gamma_across_z + K_s_w * (s_x * w_across_y - s_y * w_across_x) + K_e * e_across_z + K_u
        * u_across_z)
    f_s_u = c12
    # f, base frame
    f_x = f_s_u * (s_y * u_across_z - s_z * u_across_y) - C_s * c1 - C_s * w_across_x
    f_y = f_s_u * (s_z * u_across_x - s_x * u_across_z) - C_s * c2 - C_s * w_across_y
    f_z = f_s_u * (s_x * u_across_y - s_y * u_across_x) - C_s * c3 - C_s * w_across_z
    out = Legs()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.D = D
    out.K = [K_x, K_y, K_z]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [f_x + K_y * q_z - K_z * q_y, f_y + K_z * q_x - K_x * q_z, f_z + K_x * q_y - K_y * q_x]
    out.k3 = 1.0
    return out


def leg_reactions(on: Arithmetic, leg: Any, robot: Any, motion: Any, x: Any, bearing: Any) -> Any:
    """One leg: joint reactions, (21), (26)-(29), (17): 455 (262 mul, 191 add, 1 div, 1 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    m_d = leg.m_d
    r_d0_x = leg.r_d0[0]
    I_d0_yy = leg.I_d0[3]
    m_u = leg.m_u
    r_u0_x = leg.r_u0[0]
    I_u0_yy = leg.I_u0[3]
    C_u, C_p, C_s = leg.C_u, leg.C_p, leg.C_s
    g_x, g_y, g_z = robot.g
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    t_x, t_y, t_z = motion.t
    omega_x, omega_y, omega_z = motion.omega
    v_x, v_y, v_z = motion.v
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    # (1) platform point from the reference point
    q_x = R_xx * p_x + R_xy * p_y + R_xz * p_z
    q_y = R_yx * p_x + R_yy * p_y + R_yz * p_z
    q_z = R_zx * p_x + R_zy * p_y + R_zz * p_z
    # (1) leg vector
    S_x = t_x - b_x + q_x
    S_y = t_y - b_y + q_y
    S_z = t_z - b_z + q_z
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
    S_ddot_x = a_x + alpha_y * q_z - alpha_z * q_y + omega_y * w_q_z - omega_z * w_q_y
    S_ddot_y = a_y + alpha_z * q_x - alpha_x * q_z + omega_z * w_q_x - omega_x * w_q_z
    S_ddot_z = a_z + alpha_x * q_y - alpha_y * q_x + omega_x * w_q_y - omega_y * w_q_x
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
    # part of w across the leg
    w_across_x = omega_x - s_x * w_x
    w_across_y = omega_y - s_y * w_x
    w_across_z = omega_z - s_z * w_x
    # square of u across the leg
    u_square = u_across_x * u_across_x + u_across_y * u_across_y + u_across_z * u_across_z
    c1 = inv_L * inv_L
    c2 = m_u * L * L
    c3 = m_d * r_d0_x * r_d0_x
    c4 = m_u * r_u0_x * r_u0_x
    c5 = L * m_u
    c6 = 2.0 * r_u0_x
    F_s_e = c1 * (I_d0_yy + I_u0_yy + c2 + c3 + c4 + c5 * c6)
    c8 = 2.0 * u_x
    c7 = I_d0_yy * inv_L
    c9 = c7 * c8
    c10 = I_u0_yy * inv_L
    c11 = c5 * inv_L
    c12 = 4.0 * u_x
    c13 = c2 * inv_L
    c14 = c3 * inv_L
    c15 = c14 * c8
    c16 = c4 * inv_L
    F_s_u = (c1 * (C_s + C_u + 2.0 * L * m_u * u_x + 2.0 * m_u * r_u0_x * u_x - c10 * c8 - c13 * c8 - c15 - c16
        * c8 - c9 - c11 * c12 * r_u0_x))
    c17 = m_d * r_d0_x
    c18 = m_u * r_u0_x
    F_s_gamma = -inv_L * (c17 + c18 + c5)
    c19 = C_s * inv_L
    F_s_s_w = c19
    c20 = s_y * w_across_z - s_z * w_across_y
    c21 = s_z * w_across_x - s_x * w_across_z
    c22 = s_x * w_across_y - s_y * w_across_x
    # F_s, base frame
    F_s_x = s_x * x + F_s_gamma * gamma_across_x + F_s_s_w * c20 + F_s_e * e_across_x + F_s_u * u_across_x
    F_s_y = s_y * x + F_s_gamma * gamma_across_y + F_s_s_w * c21 + F_s_e * e_across_y + F_s_u * u_across_y
    F_s_z = s_z * x + F_s_gamma * gamma_across_z + F_s_s_w * c22 + F_s_e * e_across_z + F_s_u * u_across_z
    c24 = c10 - c18 + c13 + c14 + c16 + c7 - c5 + c11 * c6
    F_u_e = -inv_L * (c24 - c17)
    c26 = c1 * c8
    c27 = I_d0_yy * c26
    c28 = I_u0_yy * c26
    c29 = c1 * c12 * r_u0_x
    c30 = c2 * c26
    c31 = c26 * c3
    c32 = c26 * c4
    c33 = (c8 * m_u - C_u * inv_L - c19 + c27 + c28 + c30 + c31 + c32 + c29 * c5 - 4.0 * L * inv_L * m_u * u_x
        - 4.0 * inv_L * m_u * r_u0_x * u_x)
    F_u_u = -inv_L * (2.0 * inv_L * m_d * r_d0_x * u_x - c33)
    c34 = c17 * inv_L
    c35 = c18 * inv_L
    c36 = c34 - m_u + c35 + c11
    F_u_gamma = c36 - m_d
    F_u_s_w = -c19
    c37 = c1 * u_square
    c38 = x + c18 * c37 + gamma_x * m_u - e_x * m_u
    c39 = -c17 * c37 - gamma_x * m_d - c38
    # F_u, base frame
    F_u_x = F_u_gamma * gamma_across_x + F_u_s_w * c20 + F_u_e * e_across_x + c39 * s_x + F_u_u * u_across_x
    F_u_y = F_u_gamma * gamma_across_y + F_u_s_w * c21 + F_u_e * e_across_y + c39 * s_y + F_u_u * u_across_y
    F_u_z = F_u_gamma * gamma_across_z + F_u_s_w * c22 + F_u_e * e_across_z + c39 * s_z + F_u_u * u_across_z
    c40 = -c24 * inv_L
    F_p_e = c40
    c41 = c33 * inv_L
    F_p_u = c41
    F_p_gamma = c36
    F_p_s_w = -c19
    c42 = C_p * u_x - c38
    # F_p, base frame
    F_p_x = F_p_gamma * gamma_across_x + F_p_s_w * c20 + F_p_e * e_across_x + c42 * s_x + F_p_u * u_across_x
    F_p_y = F_p_gamma * gamma_across_y + F_p_s_w * c21 + F_p_e * e_across_y + c42 * s_y + F_p_u * u_across_y
    F_p_z = F_p_gamma * gamma_across_z + F_p_s_w * c22 + F_p_e * e_across_z + c42 * s_z + F_p_u * u_across_z
    F_c_e = c40
    F_c_u = c41
    F_c_gamma = c36
    F_c_s_w = -c19
    # F_c, base frame
    F_c_x = F_c_gamma * gamma_across_x + F_c_s_w * c20 + F_c_e * e_across_x + F_c_u * u_across_x
    F_c_y = F_c_gamma * gamma_across_y + F_c_s_w * c21 + F_c_e * e_across_y + F_c_u * u_across_y
    F_c_z = F_c_gamma * gamma_across_z + F_c_s_w * c22 + F_c_e * e_across_z + F_c_u * u_across_z
    c43 = bearing * c5
    c44 = bearing * c11
    M_p_s_e = (inv_L * (bearing * c10 - I_d0_yy - bearing * c18 - c3 + bearing * c13 + bearing * c14 + bearing
        * c16 + bearing * c7 - c43 + c44 * c6))
    c45 = -bearing * c19
    M_p_s_u = (inv_L * (C_u * bearing * inv_L - C_u - c45 + c15 + c9 - bearing * c8 * m_u + 4.0 * L * bearing
        * inv_L * m_u * u_x + 4.0 * bearing * inv_L * m_u * r_u0_x * u_x - bearing * c27 - bearing * c28 - bearing
        * c30 - bearing * c31 - bearing * c32 - c29 * c43))
    M_p_s_gamma = bearing * m_u + c17 - bearing * c34 - bearing * c35 - c44
    M_p_w = c45
    # M_p, base frame
    M_p_x = (M_p_w * w_across_x + M_p_s_gamma * (gamma_across_z * s_y - gamma_across_y * s_z) + M_p_s_e * (e_across_z
        * s_y - e_across_y * s_z) + M_p_s_u * (s_y * u_across_z - s_z * u_across_y))
    M_p_y = (M_p_w * w_across_y + M_p_s_gamma * (gamma_across_x * s_z - gamma_across_z * s_x) + M_p_s_e * (e_across_x
        * s_z - e_across_z * s_x) + M_p_s_u * (s_z * u_across_x - s_x * u_across_z))
    M_p_z = (M_p_w * w_across_z + M_p_s_gamma * (gamma_across_y * s_x - gamma_across_x * s_y) + M_p_s_e * (e_across_y
        * s_x - e_across_x * s_y) + M_p_s_u * (s_x * u_across_y - s_y * u_across_x))
    out = LegReactions()
    out.F_s = [F_s_x, F_s_y, F_s_z]
    out.F_u = [F_u_x, F_u_y, F_u_z]
    out.F_p = [F_p_x, F_p_y, F_p_z]
    out.F_c = [F_c_x, F_c_y, F_c_z]
    out.M_p = [M_p_x, M_p_y, M_p_z]
    out.M_u = 0.0
    return out


def legs_of(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """The legs side by side."""
    return leg_dynamics(on, robot.leg, robot, motion)


def leg_of(on: Arithmetic, legs: Any, i: Any) -> Any:
    """One of the legs."""
    out = Legs()
    out.D = legs.D[i]
    out.K = [legs.K[0][i], legs.K[1][i], legs.K[2][i]]
    out.H_force = [legs.H_force[0][i], legs.H_force[1][i], legs.H_force[2][i]]
    out.H_moment = [legs.H_moment[0][i], legs.H_moment[1][i], legs.H_moment[2][i]]
    out.c_force = [legs.c_force[0][i], legs.c_force[1][i], legs.c_force[2][i]]
    out.c_moment = [legs.c_moment[0][i], legs.c_moment[1][i], legs.c_moment[2][i]]
    return out


def terms_of(on: Arithmetic, legs: Any, robot: Any, motion: Any) -> Any:
    """The same, where the legs are known."""
    out = Terms()
    pose = platform_wrench(on, robot, motion)
    for i in range(3):
        out.c[i] = pose.c_force[i]
        out.c[i + 3] = pose.c_moment[i]
    for i in range(6):
        leg = leg_of(on, legs, i)
        out.D[i] = leg.D
        for j in range(3):
            out.K[i][j] = leg.K[j]
            out.H[j][i] = leg.H_force[j]
            out.H[j + 3][i] = leg.H_moment[j]
            out.c[j] = out.c[j] + leg.c_force[j]
            out.c[j + 3] = out.c[j + 3] + leg.c_moment[j]
    return out


def terms(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """D, K, H and c of (21), (24), (36): H x = c and F = D - x; moments about the reference point."""
    legs = legs_of(on, robot, motion)
    return terms_of(on, legs, robot, motion)


def solved(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """The same as `inverse_dynamics`, but `suspect` is 1 where H may be singular to rounding."""
    out = Forces()
    H = [0.0] * 6
    c = [0.0] * 6
    legs = legs_of(on, robot, motion)
    known = terms_of(on, legs, robot, motion)
    reach = reach_of(on, robot.leg.b, motion.t, legs.q)
    status = first_of(on, fault_of(on, legs.L, legs.k3, reach))
    close = first_of(on, on.where(legs.L > on.SHORT_SHARE * reach, 0, 1))
    per_length = scale_of(on, legs.q)
    for i in range(3):
        H[i] = legs.H_force[i]
        H[i + 3] = legs.H_moment[i] * per_length
        c[i] = known.c[i]
        c[i + 3] = known.c[i + 3] * per_length
    small_pivot = eliminate(on, H, c, out.x)
    out.suspect = on.where((status == OK) & ((close == 1) | (small_pivot == 1)), 1, 0)
    for i in range(6):
        out.F[i] = known.D[i] - out.x[i]
        status = on.where((status != OK) | (on.size(out.F[i]) <= on.MAX), status, NOT_FINITE)
    out.terms = known
    out.legs = legs
    out.reach = reach
    out.status = status
    return out


def inverse_dynamics(on: Arithmetic, robot: Any, motion: Any) -> Any:
    """Every output of (1)-(37) and a status; where that is not OK, the numbers mean nothing."""
    out = solved(on, robot, motion)
    if on.anywhere(out.suspect == 1):
        H = [[0.0] * 6 for _ in range(6)]
        arm = [[0.0] * 3 for _ in range(6)]
        for i in range(6):
            for j in range(3):
                arm[i][j] = out.legs.q[j][i]
            for j in range(6):
                H[i][j] = out.terms.H[i][j]
        found = singular_status(on, H, arm, out.legs.L, out.reach, 0.0)
        out.status = on.where((out.suspect == 1) & (found != OK), found, out.status)
    return out
