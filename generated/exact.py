"""Inverse dynamics and joint reactions of a Gough-Stewart platform on arrays, kernel `exact`.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Arguments and results are described in every_output.py.

Operations of the inverse dynamics of one pose, without the checks for the status:
          with friction                               without friction
6 x leg   414 (229 mul, 181 add, 2 div, 2 sqrt)       364 (204 mul, 156 add, 2 div, 2 sqrt)
platform  219 (123 mul, 96 add, 0 div, 0 sqrt)        219 (123 mul, 96 add, 0 div, 0 sqrt)
sum of c  36 (0 mul, 36 add, 0 div, 0 sqrt)           36 (0 mul, 36 add, 0 div, 0 sqrt)
solve     197 (106 mul, 85 add, 6 div, 0 sqrt)        197 (106 mul, 85 add, 6 div, 0 sqrt)
forces    6 (0 mul, 6 add, 0 div, 0 sqrt)             6 (0 mul, 6 add, 0 div, 0 sqrt)
total     2942 (1603 mul, 1309 add, 18 div, 12 sqrt)  2642 (1453 mul, 1159 add, 18 div, 12 sqrt)
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
        "leg": (229, 181, 2, 2),
        "platform": (123, 96, 0, 0),
        "sum of c": (0, 36, 0, 0),
        "solve": (106, 85, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1603, 1309, 18, 12),
    },
    "frictionless": {
        "leg": (204, 156, 2, 2),
        "platform": (123, 96, 0, 0),
        "sum of c": (0, 36, 0, 0),
        "solve": (106, 85, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1453, 1159, 18, 12),
    },
}

# Operations of stewart_exact_forces.h.
FORCE_OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (156, 105, 2, 2),
        "platform": (99, 93, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 51, 0, 0),
        "solve": (158, 102, 2, 0),
        "forces": (0, 6, 0, 0),
        "total": (1253, 927, 14, 12),
    },
    "frictionless": {
        "leg": (137, 93, 2, 2),
        "platform": (96, 90, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 33, 0, 0),
        "solve": (158, 102, 2, 0),
        "forces": (0, 6, 0, 0),
        "total": (1136, 834, 14, 12),
    },
}


class Legs:
    """Terms of the legs."""

    def __init__(self) -> None:
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.D: Any = 0.0  # N: known part of the actuator force
        self.K: Any = [0.0] * 3  # N: transverse force on the leg at its spherical joint, base frame
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        self.c_force: Any = [0.0] * 3  # N: part of c, force rows, base frame
        self.c_moment: Any = [0.0] * 3  # N m: part of c, moment rows, base frame


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
    """One leg: D, K, its column of H and its part of c, (1)-(24), (35): 414 (229 mul, 181 add, 2 div, 2
    sqrt).
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
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y * s_z - k_z * s_y
    k_cross_s_y = k_z * s_x - k_x * s_z
    k_cross_s_z = k_x * s_y - k_y * s_x
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_s_z * s_y - k_cross_s_y * s_z
    s_cross_normal_y = k_cross_s_x * s_z - k_cross_s_z * s_x
    s_cross_normal_z = k_cross_s_y * s_x - k_cross_s_x * s_y
    # (10) k = (k1, 0, k3) in the leg frame
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
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = k_x * s_x + k_y * s_y + k_z * s_z
    # spin of the leg about s per rotation about z
    kappa = inv_k3 * k1
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
    # angular velocity of the platform, leg frame
    w_x = omega_x * s_x + omega_y * s_y + omega_z * s_z
    w_y = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_z = omega_x * z_x + omega_y * z_y + omega_z * z_z
    # (6) angular velocity of the leg, leg frame
    W_z = inv_L * u_y
    W_y = -inv_L * u_z
    W_x = W_z * kappa
    c1 = W_y * W_y
    c2 = W_z * W_z
    # (8) sliding acceleration
    L_ddot = L * c1 + L * c2 + e_x
    c3 = 2.0 * u_x
    c4 = W_z * c3
    c5 = W_y * c3
    # (9) angular acceleration of the leg without the spin terms, leg frame
    A_z_own = inv_L * (e_y - c4)
    A_y_own = inv_L * (-e_z - c5)
    c6 = W_y * W_z
    c7 = W_x * W_y
    c8 = 2.0 * c7
    # (9) angular acceleration of the leg, leg frame
    A_x = kappa * (A_z_own - c8) - c6
    # (12) center of mass of the upper part from the base point
    r_u_x = r_u0_x + L
    c9 = W_x * W_z
    c10 = 2.0 * c9
    c11 = W_x * W_x
    # (11), (13) acceleration of the lower center of mass
    a_d_x = A_y_own * r_d0_z - c1 * r_d0_x - c2 * r_d0_x + c10 * r_d0_z + c8 * r_d0_y - A_z_own * r_d0_y
    a_d_y = W_y * W_z * r_d0_z - c11 * r_d0_y - c2 * r_d0_y + A_z_own * r_d0_x - A_x * r_d0_z
    a_d_z = W_y * W_z * r_d0_y - c1 * r_d0_z - c11 * r_d0_z - A_y_own * r_d0_x + A_x * r_d0_y
    # (14) acceleration of the upper center of mass
    a_u_x = (L_ddot - c1 * r_u_x - c2 * r_u_x + A_y_own * r_u0_z + c10 * r_u0_z + c8 * r_u0_y - A_z_own * r_u0_y)
    a_u_y = c4 - c11 * r_u0_y - c2 * r_u0_y + W_y * W_z * r_u0_z + A_z_own * r_u_x - A_x * r_u0_z
    a_u_z = W_y * W_z * r_u0_y - c1 * r_u0_z - c11 * r_u0_z - c5 - A_y_own * r_u_x + A_x * r_u0_y
    # (25) m_d (a_d - g)
    N_d_x = m_d * (a_d_x - gamma_x)
    N_d_y = m_d * (a_d_y - gamma_y)
    N_d_z = m_d * (a_d_z - gamma_z)
    # (23) m_u (a_u - g)
    N_u_x = m_u * (a_u_x - gamma_x)
    N_u_y = m_u * (a_u_y - gamma_y)
    N_u_z = m_u * (a_u_z - gamma_z)
    # (18) friction moment at the spherical joint, leg frame
    f_leg_x = C_s * (W_x - w_x)
    f_leg_y = C_s * (W_y - w_y)
    f_leg_z = C_s * (W_z - w_z)
    # (15), (16), (19) I_d + I_u
    I_xx = I_d0_xx + I_u0_xx
    I_xy = I_d0_xy + I_u0_xy
    I_xz = I_d0_xz + I_u0_xz
    I_yy = I_d0_yy + I_u0_yy
    I_yz = I_d0_yz + I_u0_yz
    I_zz = I_d0_zz + I_u0_zz
    c15 = I_yy - I_zz
    # (19) I A + W x I W
    E_x = I_yz * c1 - I_yz * c2 + A_y_own * I_xy - c15 * c6 + A_z_own * I_xz + A_x * I_xx
    E_y = (I_xz * c2 - I_xz * c11 + I_xy * c6 + A_y_own * I_yy + c9 * (I_xx + c15) + A_z_own * I_yz - I_yz * c8
        + A_x * I_xy)
    E_z = (I_xy * c11 - I_xy * c1 + A_y_own * I_yz + c7 * (I_yy - I_xx - I_zz) - I_xz * c6 + I_yz * c10 + A_z_own
        * I_zz + A_x * I_xz)
    # (20) moment that the joint forces must balance
    C_x = C_u * W_x + f_leg_x + E_x + N_d_z * r_d0_y + N_u_z * r_u0_y - N_d_y * r_d0_z - N_u_y * r_u0_z
    C_y = C_u * W_y + f_leg_y + E_y + N_d_x * r_d0_z + N_u_x * r_u0_z - N_d_z * r_d0_x - N_u_z * r_u_x
    C_z = C_u * W_z + f_leg_z + E_z - N_d_x * r_d0_y - N_u_x * r_u0_y + N_d_y * r_d0_x + N_u_y * r_u_x
    # (24) known part of the actuator force
    D = C_p * u_x + N_u_x
    # (21) transverse force at the spherical joint, leg frame
    K_leg_y = inv_L * (C_z + C_x * kappa)
    K_leg_z = -C_y * inv_L
    # (21) transverse force at the spherical joint, base frame
    K_x = K_leg_z * z_x + K_leg_y * y_x
    K_y = K_leg_z * z_y + K_leg_y * y_y
    K_z = K_leg_z * z_z + K_leg_y * y_z
    # (18) friction moment at the spherical joint, base frame
    f_x = f_leg_y * y_x + f_leg_z * z_x + f_leg_x * s_x
    f_y = f_leg_y * y_y + f_leg_z * z_y + f_leg_x * s_y
    f_z = f_leg_y * y_z + f_leg_z * z_z + f_leg_x * s_z
    out = Legs()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.K = [K_x, K_y, K_z]
    out.H_force = [s_x, s_y, s_z]
    out.H_moment = [q_y * s_z - q_z * s_y, q_z * s_x - q_x * s_z, q_x * s_y - q_y * s_x]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [f_x + K_y * q_z - K_z * q_y, f_y + K_z * q_x - K_x * q_z, f_z + K_x * q_y - K_y * q_x]
    return out


def leg_reactions(on: Arithmetic, leg: Any, robot: Any, motion: Any, x: Any, bearing: Any) -> Any:
    """One leg: joint reactions, (21), (26)-(29), (17): 508 (275 mul, 229 add, 2 div, 2 sqrt)."""
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
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y * s_z - k_z * s_y
    k_cross_s_y = k_z * s_x - k_x * s_z
    k_cross_s_z = k_x * s_y - k_y * s_x
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_s_z * s_y - k_cross_s_y * s_z
    s_cross_normal_y = k_cross_s_x * s_z - k_cross_s_z * s_x
    s_cross_normal_z = k_cross_s_y * s_x - k_cross_s_x * s_y
    # (10) k = (k1, 0, k3) in the leg frame
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
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = k_x * s_x + k_y * s_y + k_z * s_z
    # spin of the leg about s per rotation about z
    kappa = inv_k3 * k1
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
    # angular velocity of the platform, leg frame
    w_x = omega_x * s_x + omega_y * s_y + omega_z * s_z
    w_y = omega_x * y_x + omega_y * y_y + omega_z * y_z
    w_z = omega_x * z_x + omega_y * z_y + omega_z * z_z
    # (6) angular velocity of the leg, leg frame
    W_z = inv_L * u_y
    W_y = -inv_L * u_z
    W_x = W_z * kappa
    c1 = W_y * W_y
    c2 = W_z * W_z
    # (8) sliding acceleration
    L_ddot = L * c1 + L * c2 + e_x
    c3 = 2.0 * u_x
    c4 = W_z * c3
    c5 = W_y * c3
    # (9) angular acceleration of the leg without the spin terms, leg frame
    A_z_own = inv_L * (e_y - c4)
    A_y_own = inv_L * (-e_z - c5)
    c6 = W_y * W_z
    c7 = W_x * W_y
    c8 = 2.0 * c7
    # (9) angular acceleration of the leg, leg frame
    A_x = kappa * (A_z_own - c8) - c6
    # (12) center of mass of the upper part from the base point
    r_u_x = r_u0_x + L
    c9 = W_x * W_z
    c10 = 2.0 * c9
    c11 = W_x * W_x
    # (11), (13) acceleration of the lower center of mass
    a_d_x = A_y_own * r_d0_z - c1 * r_d0_x - c2 * r_d0_x + c10 * r_d0_z + c8 * r_d0_y - A_z_own * r_d0_y
    a_d_y = W_y * W_z * r_d0_z - c11 * r_d0_y - c2 * r_d0_y + A_z_own * r_d0_x - A_x * r_d0_z
    a_d_z = W_y * W_z * r_d0_y - c1 * r_d0_z - c11 * r_d0_z - A_y_own * r_d0_x + A_x * r_d0_y
    # (14) acceleration of the upper center of mass
    a_u_x = (L_ddot - c1 * r_u_x - c2 * r_u_x + A_y_own * r_u0_z + c10 * r_u0_z + c8 * r_u0_y - A_z_own * r_u0_y)
    a_u_y = c4 - c11 * r_u0_y - c2 * r_u0_y + W_y * W_z * r_u0_z + A_z_own * r_u_x - A_x * r_u0_z
    a_u_z = W_y * W_z * r_u0_y - c1 * r_u0_z - c11 * r_u0_z - c5 - A_y_own * r_u_x + A_x * r_u0_y
    # (25) m_d (a_d - g)
    N_d_x = m_d * (a_d_x - gamma_x)
    N_d_y = m_d * (a_d_y - gamma_y)
    N_d_z = m_d * (a_d_z - gamma_z)
    # (23) m_u (a_u - g)
    N_u_x = m_u * (a_u_x - gamma_x)
    N_u_y = m_u * (a_u_y - gamma_y)
    N_u_z = m_u * (a_u_z - gamma_z)
    # (18) friction moment at the spherical joint, leg frame
    f_leg_x = C_s * (W_x - w_x)
    f_leg_y = C_s * (W_y - w_y)
    f_leg_z = C_s * (W_z - w_z)
    # (15), (16), (19) I_d + I_u
    I_xx = I_d0_xx + I_u0_xx
    I_xy = I_d0_xy + I_u0_xy
    I_xz = I_d0_xz + I_u0_xz
    I_yy = I_d0_yy + I_u0_yy
    I_yz = I_d0_yz + I_u0_yz
    I_zz = I_d0_zz + I_u0_zz
    c15 = I_yy - I_zz
    # (19) I A + W x I W
    E_x = I_yz * c1 - I_yz * c2 + A_y_own * I_xy - c15 * c6 + A_z_own * I_xz + A_x * I_xx
    E_y = (I_xz * c2 - I_xz * c11 + I_xy * c6 + A_y_own * I_yy + c9 * (I_xx + c15) + A_z_own * I_yz - I_yz * c8
        + A_x * I_xy)
    E_z = (I_xy * c11 - I_xy * c1 + A_y_own * I_yz + c7 * (I_yy - I_xx - I_zz) - I_xz * c6 + I_yz * c10 + A_z_own
        * I_zz + A_x * I_xz)
    c16 = I_d0_yy - I_d0_zz
    # (17) I_d A + W x I_d W
    E_d_x = I_d0_yz * c1 - I_d0_yz * c2 + A_y_own * I_d0_xy - c16 * c6 + A_z_own * I_d0_xz + A_x * I_d0_xx
    E_d_y = (I_d0_xz * c2 - I_d0_xz * c11 + I_d0_xy * c6 + A_y_own * I_d0_yy + c9 * (I_d0_xx + c16) + A_z_own
        * I_d0_yz - I_d0_yz * c8 + A_x * I_d0_xy)
    E_d_z = (I_d0_xy * c11 - I_d0_xy * c1 + A_y_own * I_d0_yz + c7 * (I_d0_yy - I_d0_xx - I_d0_zz) - I_d0_xz
        * c6 + I_d0_yz * c10 + A_z_own * I_d0_zz + A_x * I_d0_xz)
    c17 = C_u * W_x + N_d_z * r_d0_y - N_d_y * r_d0_z
    c18 = C_u * W_y + N_d_x * r_d0_z - N_d_z * r_d0_x
    c19 = C_u * W_z - N_d_x * r_d0_y + N_d_y * r_d0_x
    # (20) moment that the joint forces must balance
    C_x = f_leg_x + E_x + N_u_z * r_u0_y - N_u_y * r_u0_z + c17
    C_y = f_leg_y + E_y + N_u_x * r_u0_z - N_u_z * r_u_x + c18
    C_z = f_leg_z + E_z - N_u_x * r_u0_y + N_u_y * r_u_x + c19
    c20 = C_x * kappa
    c21 = C_z + c20
    c22 = C_y * inv_L
    # (21) transverse force at the spherical joint, leg frame
    K_leg_y = c21 * inv_L
    K_leg_z = -c22
    c23 = N_u_x - x
    c24 = N_u_y - c21 * inv_L
    c25 = N_u_z + c22
    # F_u, leg frame
    F_u_leg_x = N_d_x + c23
    F_u_leg_y = N_d_y + c24
    F_u_leg_z = N_d_z + c25
    # F_p, leg frame
    F_p_leg_x = C_p * u_x + c23
    F_p_leg_y = c24
    F_p_leg_z = c25
    # F_c, leg frame
    F_c_leg_y = c24
    F_c_leg_z = c25
    # M_p, leg frame
    M_p_leg_x = C_x - E_d_x - c17
    M_p_leg_y = N_u_z * bearing - E_d_y - c18 + C_y * bearing * inv_L
    M_p_leg_z = inv_L * (C_z * bearing + bearing * c20) - E_d_z - N_u_y * bearing - c19 - c20
    out = LegReactions()
    out.F_s = [
        K_leg_y * y_x + K_leg_z * z_x + s_x * x,
        K_leg_y * y_y + K_leg_z * z_y + s_y * x,
        K_leg_y * y_z + K_leg_z * z_z + s_z * x,
    ]
    out.F_u = [
        F_u_leg_x * s_x + F_u_leg_y * y_x + F_u_leg_z * z_x,
        F_u_leg_x * s_y + F_u_leg_y * y_y + F_u_leg_z * z_y,
        F_u_leg_x * s_z + F_u_leg_y * y_z + F_u_leg_z * z_z,
    ]
    out.F_p = [
        F_p_leg_x * s_x + F_p_leg_y * y_x + F_p_leg_z * z_x,
        F_p_leg_x * s_y + F_p_leg_y * y_y + F_p_leg_z * z_y,
        F_p_leg_x * s_z + F_p_leg_y * y_z + F_p_leg_z * z_z,
    ]
    out.F_c = [
        F_c_leg_y * y_x + F_c_leg_z * z_x,
        F_c_leg_y * y_y + F_c_leg_z * z_y,
        F_c_leg_y * y_z + F_c_leg_z * z_z,
    ]
    out.M_p = [
        M_p_leg_x * s_x + M_p_leg_y * y_x + M_p_leg_z * z_x,
        M_p_leg_x * s_y + M_p_leg_y * y_y + M_p_leg_z * z_y,
        M_p_leg_x * s_z + M_p_leg_y * y_z + M_p_leg_z * z_z,
    ]
    out.M_u = -C_x * inv_k3
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
