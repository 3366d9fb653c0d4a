"""Inverse dynamics and joint reactions of the Stewart platform, formulation and joint `exact`.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

``robot`` has the fields of ``stewart_robot`` in stewart.h as arrays, legs first: b (6, 3), I_d0 (6, 3, 3).
``motion`` has R (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3). Units as in stewart.h.

Operations of one pose of inverse dynamics, six legs, solve included
         with friction                             without friction
leg      414 (229 mul, 181 add, 2 div, 2 sqrt)     364 (204 mul, 156 add, 2 div, 2 sqrt)
platform 219 (123 mul, 96 add, 0 div, 0 sqrt)      219 (123 mul, 96 add, 0 div, 0 sqrt)
sum of c 36 (0 mul, 36 add, 0 div, 0 sqrt)         36 (0 mul, 36 add, 0 div, 0 sqrt)
solve    197 (106 mul, 85 add, 6 div, 0 sqrt)      197 (106 mul, 85 add, 6 div, 0 sqrt)
forces   6 (0 mul, 6 add, 0 div, 0 sqrt)           6 (0 mul, 6 add, 0 div, 0 sqrt)
total    2942 (1603 mul, 1309 add, 18 div, 12 sqrt) 2642 (1453 mul, 1159 add, 18 div, 12 sqrt)
"""

from typing import Any

import numpy as np

from .assembly import Array, solve, stack

# (mul, add, div, sqrt) of each part of one pose, and of all.
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

# The same of stewart_exact_forces.h.
FORCE_OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (156, 105, 2, 2),
        "platform": (99, 93, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 51, 0, 0),
        "solve": (84, 67, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1179, 892, 18, 12),
    },
    "frictionless": {
        "leg": (137, 93, 2, 2),
        "platform": (96, 90, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 33, 0, 0),
        "solve": (84, 67, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1062, 799, 18, 12),
    },
}


def inverse_dynamics(robot: Any, motion: Any) -> dict[str, Array]:
    """F, D, x, c (..., 6), K (..., 6, 3), H (..., 6, 6) and status (...), (1)-(37)."""
    with np.errstate(all="ignore"):
        return solve(robot, motion, leg_dynamics(robot, motion), platform_wrench(robot, motion))


def joint_reactions(robot: Any, motion: Any, x: Array, bearing: Array) -> dict[str, Array]:
    """F_s, F_u, F_p, F_c, M_p (..., 6, 3) and M_u (..., 6) from x (..., 6); bearing (6,), m."""
    with np.errstate(all="ignore"):
        return leg_reactions(robot, motion, x, bearing)


def leg_dynamics(robot: Any, motion: Any) -> dict[str, Array]:
    """One leg: D, K, its column of H and its part of c, (1)-(24), (35).

    Operations: 414 (229 mul, 181 add, 2 div, 2 sqrt).
    """
    b_x = robot.b[:, 0]
    b_y = robot.b[:, 1]
    b_z = robot.b[:, 2]
    p_x = robot.p[:, 0]
    p_y = robot.p[:, 1]
    p_z = robot.p[:, 2]
    k_x = robot.k[:, 0]
    k_y = robot.k[:, 1]
    k_z = robot.k[:, 2]
    m_d = robot.m_d
    r_d0_x = robot.r_d0[:, 0]
    r_d0_y = robot.r_d0[:, 1]
    r_d0_z = robot.r_d0[:, 2]
    I_d0_xx = robot.I_d0[:, 0, 0]
    I_d0_xy = robot.I_d0[:, 0, 1]
    I_d0_xz = robot.I_d0[:, 0, 2]
    I_d0_yy = robot.I_d0[:, 1, 1]
    I_d0_yz = robot.I_d0[:, 1, 2]
    I_d0_zz = robot.I_d0[:, 2, 2]
    m_u = robot.m_u
    r_u0_x = robot.r_u0[:, 0]
    r_u0_y = robot.r_u0[:, 1]
    r_u0_z = robot.r_u0[:, 2]
    I_u0_xx = robot.I_u0[:, 0, 0]
    I_u0_xy = robot.I_u0[:, 0, 1]
    I_u0_xz = robot.I_u0[:, 0, 2]
    I_u0_yy = robot.I_u0[:, 1, 1]
    I_u0_yz = robot.I_u0[:, 1, 2]
    I_u0_zz = robot.I_u0[:, 2, 2]
    C_u = robot.C_u
    C_p = robot.C_p
    C_s = robot.C_s
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    alpha_x = motion.alpha[..., 0, None]
    alpha_y = motion.alpha[..., 1, None]
    alpha_z = motion.alpha[..., 2, None]
    a_x = motion.a[..., 0, None]
    a_y = motion.a[..., 1, None]
    a_z = motion.a[..., 2, None]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) leg vector
    S_x = q_x + t_x - b_x
    S_y = q_y + t_y - b_y
    S_z = q_z + t_z - b_z
    # (2) leg length
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (7) acceleration of the platform point
    S_ddot_x = a_x + alpha_y*q_z + omega_y*w_q_z - alpha_z*q_y - omega_z*w_q_y
    S_ddot_y = a_y + alpha_z*q_x + omega_z*w_q_x - alpha_x*q_z - omega_x*w_q_z
    S_ddot_z = a_z + alpha_x*q_y + omega_x*w_q_y - alpha_y*q_x - omega_y*w_q_x
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y*s_z - k_z*s_y
    k_cross_s_y = k_z*s_x - k_x*s_z
    k_cross_s_z = k_x*s_y - k_y*s_x
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_s_z*s_y - k_cross_s_y*s_z
    s_cross_normal_y = k_cross_s_x*s_z - k_cross_s_z*s_x
    s_cross_normal_z = k_cross_s_y*s_x - k_cross_s_x*s_y
    # (10) k = (k1, 0, k3) in the leg frame
    k3 = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_k3 = 1/k3
    # (10) third axis of the leg frame
    z_x = inv_k3*s_cross_normal_x
    z_y = inv_k3*s_cross_normal_y
    z_z = inv_k3*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = k_x*s_x + k_y*s_y + k_z*s_z
    # spin of the leg about s for each turn about z
    kappa = inv_k3*k1
    # (4), (5) velocity of the platform point, leg frame; u_x is L_dot
    u_x = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    u_y = S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z
    u_z = S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z
    # (7) acceleration of the platform point, leg frame
    e_x = S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    e_y = S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z
    e_z = S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z
    # gravity, leg frame
    gamma_x = g_x*s_x + g_y*s_y + g_z*s_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    gamma_z = g_x*z_x + g_y*z_y + g_z*z_z
    # angular velocity of the platform, leg frame
    w_x = omega_x*s_x + omega_y*s_y + omega_z*s_z
    w_y = omega_x*y_x + omega_y*y_y + omega_z*y_z
    w_z = omega_x*z_x + omega_y*z_y + omega_z*z_z
    # (6) angular velocity of the leg, leg frame
    W_z = inv_L*u_y
    W_y = -inv_L*u_z
    W_x = W_z*kappa
    c1 = W_y*W_y
    c2 = W_z*W_z
    # (8) sliding acceleration
    L_ddot = L*c1 + L*c2 + e_x
    c3 = 2*u_x
    c4 = W_z*c3
    c5 = W_y*c3
    # (9) angular acceleration of the leg but for its spin, leg frame
    A_z_own = inv_L*(e_y - c4)
    A_y_own = inv_L*(-c5 - e_z)
    c6 = W_y*W_z
    c7 = W_x*W_y
    c8 = 2*c7
    # (9) angular acceleration of the leg, leg frame
    A_x = kappa*(A_z_own - c8) - c6
    # (12) centre of mass of the upper part from the base point
    r_u_x = L + r_u0_x
    c9 = W_x*W_z
    c10 = 2*c9
    c11 = W_x*W_x
    # (11), (13) acceleration of the lower centre of mass
    a_d_x = A_y_own*r_d0_z + c10*r_d0_z + c8*r_d0_y - A_z_own*r_d0_y - c1*r_d0_x - c2*r_d0_x
    a_d_y = A_z_own*r_d0_x + W_y*W_z*r_d0_z - A_x*r_d0_z - c11*r_d0_y - c2*r_d0_y
    a_d_z = A_x*r_d0_y + W_y*W_z*r_d0_y - A_y_own*r_d0_x - c1*r_d0_z - c11*r_d0_z
    # (14) acceleration of the upper centre of mass
    a_u_x = A_y_own*r_u0_z + L_ddot + c10*r_u0_z + c8*r_u0_y - A_z_own*r_u0_y - c1*r_u_x - c2*r_u_x
    a_u_y = A_z_own*r_u_x + W_y*W_z*r_u0_z + c4 - A_x*r_u0_z - c11*r_u0_y - c2*r_u0_y
    a_u_z = A_x*r_u0_y + W_y*W_z*r_u0_y - A_y_own*r_u_x - c1*r_u0_z - c11*r_u0_z - c5
    # (25) m_d (a_d - g)
    N_d_x = m_d*(a_d_x - gamma_x)
    N_d_y = m_d*(a_d_y - gamma_y)
    N_d_z = m_d*(a_d_z - gamma_z)
    # (23) m_u (a_u - g)
    N_u_x = m_u*(a_u_x - gamma_x)
    N_u_y = m_u*(a_u_y - gamma_y)
    N_u_z = m_u*(a_u_z - gamma_z)
    # (18) friction moment at the spherical joint, leg frame
    f_leg_x = C_s*(W_x - w_x)
    f_leg_y = C_s*(W_y - w_y)
    f_leg_z = C_s*(W_z - w_z)
    # (15), (16), (19) I_d + I_u
    I_xx = I_d0_xx + I_u0_xx
    I_xy = I_d0_xy + I_u0_xy
    I_xz = I_d0_xz + I_u0_xz
    I_yy = I_d0_yy + I_u0_yy
    I_yz = I_d0_yz + I_u0_yz
    I_zz = I_d0_zz + I_u0_zz
    c15 = I_yy - I_zz
    # (19) I A + W x I W
    E_x = A_x*I_xx + A_y_own*I_xy + A_z_own*I_xz + I_yz*c1 - I_yz*c2 - c15*c6
    E_y = A_x*I_xy + A_y_own*I_yy + A_z_own*I_yz + I_xy*c6 + I_xz*c2 + c9*(I_xx + c15) - I_xz*c11 - I_yz*c8
    E_z = (
        A_x*I_xz + A_y_own*I_yz + A_z_own*I_zz + I_xy*c11 + I_yz*c10 + c7*(I_yy - I_xx - I_zz) - I_xy*c1
        - I_xz*c6
    )
    # (20) moment that the joints' forces must make
    C_x = C_u*W_x + E_x + N_d_z*r_d0_y + N_u_z*r_u0_y + f_leg_x - N_d_y*r_d0_z - N_u_y*r_u0_z
    C_y = C_u*W_y + E_y + N_d_x*r_d0_z + N_u_x*r_u0_z + f_leg_y - N_d_z*r_d0_x - N_u_z*r_u_x
    C_z = C_u*W_z + E_z + N_d_y*r_d0_x + N_u_y*r_u_x + f_leg_z - N_d_x*r_d0_y - N_u_x*r_u0_y
    # (24) known part of the actuator force
    D = C_p*u_x + N_u_x
    # (21) transverse force at the spherical joint, leg frame
    K_leg_y = inv_L*(C_x*kappa + C_z)
    K_leg_z = -C_y*inv_L
    # (21) transverse force at the spherical joint, base frame
    K_x = K_leg_y*y_x + K_leg_z*z_x
    K_y = K_leg_y*y_y + K_leg_z*z_y
    K_z = K_leg_y*y_z + K_leg_z*z_z
    # (18) friction moment at the spherical joint, base frame
    f_x = f_leg_x*s_x + f_leg_y*y_x + f_leg_z*z_x
    f_y = f_leg_x*s_y + f_leg_y*y_y + f_leg_z*z_y
    f_z = f_leg_x*s_z + f_leg_y*y_z + f_leg_z*z_z
    shape = (*motion.t.shape[:-1], 6)
    return {
        "q": stack(shape, q_x, q_y, q_z),
        "L": np.broadcast_to(L, shape),
        "k3": np.broadcast_to(k3, shape),
        "D": np.broadcast_to(D, shape),
        "K": stack(shape, K_x, K_y, K_z),
        "H_force": stack(shape, s_x, s_y, s_z),
        "H_moment": stack(shape, q_y*s_z - q_z*s_y, q_z*s_x - q_x*s_z, q_x*s_y - q_y*s_x),
        "c_force": stack(shape, -K_x, -K_y, -K_z),
        "c_moment": stack(shape, K_y*q_z + f_x - K_z*q_y, K_z*q_x + f_y - K_x*q_z, K_x*q_y + f_z - K_y*q_x),
    }


def platform_wrench(robot: Any, motion: Any) -> dict[str, Array]:
    """The platform's own part of c, (33)-(35).

    Operations: 219 (123 mul, 96 add, 0 div, 0 sqrt).
    """
    R_xx = motion.R[..., 0, 0]
    R_xy = motion.R[..., 0, 1]
    R_xz = motion.R[..., 0, 2]
    R_yx = motion.R[..., 1, 0]
    R_yy = motion.R[..., 1, 1]
    R_yz = motion.R[..., 1, 2]
    R_zx = motion.R[..., 2, 0]
    R_zy = motion.R[..., 2, 1]
    R_zz = motion.R[..., 2, 2]
    omega_x = motion.omega[..., 0]
    omega_y = motion.omega[..., 1]
    omega_z = motion.omega[..., 2]
    alpha_x = motion.alpha[..., 0]
    alpha_y = motion.alpha[..., 1]
    alpha_z = motion.alpha[..., 2]
    a_x = motion.a[..., 0]
    a_y = motion.a[..., 1]
    a_z = motion.a[..., 2]
    F_ext_x = motion.F_ext[..., 0]
    F_ext_y = motion.F_ext[..., 1]
    F_ext_z = motion.F_ext[..., 2]
    M_ext_x = motion.M_ext[..., 0]
    M_ext_y = motion.M_ext[..., 1]
    M_ext_z = motion.M_ext[..., 2]
    M = robot.M
    R_0_x = robot.R_0[0]
    R_0_y = robot.R_0[1]
    R_0_z = robot.R_0[2]
    I_p_xx = robot.I_p[0, 0]
    I_p_xy = robot.I_p[0, 1]
    I_p_xz = robot.I_p[0, 2]
    I_p_yy = robot.I_p[1, 1]
    I_p_yz = robot.I_p[1, 2]
    I_p_zz = robot.I_p[2, 2]
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    # (30) centre of mass from the reference point, base frame
    R_G_x = R_0_x*R_xx + R_0_y*R_xy + R_0_z*R_xz
    R_G_y = R_0_x*R_yx + R_0_y*R_yy + R_0_z*R_yz
    R_G_z = R_0_x*R_zx + R_0_y*R_zy + R_0_z*R_zz
    c1 = R_G_y*omega_x - R_G_x*omega_y
    c2 = R_G_x*omega_z - R_G_z*omega_x
    c3 = R_G_z*omega_y - R_G_y*omega_z
    # (31) acceleration of the centre of mass
    a_G_x = R_G_z*alpha_y + a_x + c1*omega_y - R_G_y*alpha_z - c2*omega_z
    a_G_y = R_G_x*alpha_z + a_y + c3*omega_z - R_G_z*alpha_x - c1*omega_x
    a_G_z = R_G_y*alpha_x + a_z + c2*omega_x - R_G_x*alpha_y - c3*omega_y
    c4 = I_p_xx*R_xx + I_p_xy*R_xy + I_p_xz*R_xz
    c5 = I_p_xy*R_xx + I_p_yy*R_xy + I_p_yz*R_xz
    c6 = I_p_xz*R_xx + I_p_yz*R_xy + I_p_zz*R_xz
    c7 = I_p_xx*R_yx + I_p_xy*R_yy + I_p_xz*R_yz
    c8 = I_p_xy*R_yx + I_p_yy*R_yy + I_p_yz*R_yz
    c9 = I_p_xz*R_yx + I_p_yz*R_yy + I_p_zz*R_yz
    # (32) inertia of the platform, base frame
    I_xx = R_xx*c4 + R_xy*c5 + R_xz*c6
    I_xy = R_yx*c4 + R_yy*c5 + R_yz*c6
    I_xz = R_zx*c4 + R_zy*c5 + R_zz*c6
    I_yy = R_yx*c7 + R_yy*c8 + R_yz*c9
    I_yz = R_zx*c7 + R_zy*c8 + R_zz*c9
    I_zz = (
        R_zx*(I_p_xx*R_zx + I_p_xy*R_zy + I_p_xz*R_zz) + R_zy*(I_p_xy*R_zx + I_p_yy*R_zy + I_p_yz*R_zz)
        + R_zz*(I_p_xz*R_zx + I_p_yz*R_zy + I_p_zz*R_zz)
    )
    # (33) M (g - a_G)
    N_x = M*(g_x - a_G_x)
    N_y = M*(g_y - a_G_y)
    N_z = M*(g_z - a_G_z)
    c10 = I_xz*omega_x + I_yz*omega_y + I_zz*omega_z
    c11 = I_xy*omega_x + I_yy*omega_y + I_yz*omega_z
    c12 = I_xx*omega_x + I_xy*omega_y + I_xz*omega_z
    # (34) I alpha + omega x I omega
    E_x = I_xx*alpha_x + I_xy*alpha_y + I_xz*alpha_z + c10*omega_y - c11*omega_z
    E_y = I_xy*alpha_x + I_yy*alpha_y + I_yz*alpha_z + c12*omega_z - c10*omega_x
    E_z = I_xz*alpha_x + I_yz*alpha_y + I_zz*alpha_z + c11*omega_x - c12*omega_y
    # (33) external force, base frame
    F_load_x = F_ext_x*R_xx + F_ext_y*R_xy + F_ext_z*R_xz
    F_load_y = F_ext_x*R_yx + F_ext_y*R_yy + F_ext_z*R_yz
    F_load_z = F_ext_x*R_zx + F_ext_y*R_zy + F_ext_z*R_zz
    # (34) external moment, base frame
    M_load_x = M_ext_x*R_xx + M_ext_y*R_xy + M_ext_z*R_xz
    M_load_y = M_ext_x*R_yx + M_ext_y*R_yy + M_ext_z*R_yz
    M_load_z = M_ext_x*R_zx + M_ext_y*R_zy + M_ext_z*R_zz
    shape = motion.t.shape[:-1]
    return {
        "c_force": stack(shape, F_load_x + N_x, F_load_y + N_y, F_load_z + N_z),
        "c_moment": stack(
            shape,
            M_load_x + N_z*R_G_y - E_x - N_y*R_G_z,
            M_load_y + N_x*R_G_z - E_y - N_z*R_G_x,
            M_load_z + N_y*R_G_x - E_z - N_x*R_G_y,
        ),
    }


def leg_reactions(robot: Any, motion: Any, x: Array, bearing: Array) -> dict[str, Array]:
    """One leg: joint reactions, (21), (26)-(29), (17).

    Operations: 508 (275 mul, 229 add, 2 div, 2 sqrt).
    """
    b_x = robot.b[:, 0]
    b_y = robot.b[:, 1]
    b_z = robot.b[:, 2]
    p_x = robot.p[:, 0]
    p_y = robot.p[:, 1]
    p_z = robot.p[:, 2]
    k_x = robot.k[:, 0]
    k_y = robot.k[:, 1]
    k_z = robot.k[:, 2]
    m_d = robot.m_d
    r_d0_x = robot.r_d0[:, 0]
    r_d0_y = robot.r_d0[:, 1]
    r_d0_z = robot.r_d0[:, 2]
    I_d0_xx = robot.I_d0[:, 0, 0]
    I_d0_xy = robot.I_d0[:, 0, 1]
    I_d0_xz = robot.I_d0[:, 0, 2]
    I_d0_yy = robot.I_d0[:, 1, 1]
    I_d0_yz = robot.I_d0[:, 1, 2]
    I_d0_zz = robot.I_d0[:, 2, 2]
    m_u = robot.m_u
    r_u0_x = robot.r_u0[:, 0]
    r_u0_y = robot.r_u0[:, 1]
    r_u0_z = robot.r_u0[:, 2]
    I_u0_xx = robot.I_u0[:, 0, 0]
    I_u0_xy = robot.I_u0[:, 0, 1]
    I_u0_xz = robot.I_u0[:, 0, 2]
    I_u0_yy = robot.I_u0[:, 1, 1]
    I_u0_yz = robot.I_u0[:, 1, 2]
    I_u0_zz = robot.I_u0[:, 2, 2]
    C_u = robot.C_u
    C_p = robot.C_p
    C_s = robot.C_s
    g_x = robot.g[0]
    g_y = robot.g[1]
    g_z = robot.g[2]
    R_xx = motion.R[..., 0, 0, None]
    R_xy = motion.R[..., 0, 1, None]
    R_xz = motion.R[..., 0, 2, None]
    R_yx = motion.R[..., 1, 0, None]
    R_yy = motion.R[..., 1, 1, None]
    R_yz = motion.R[..., 1, 2, None]
    R_zx = motion.R[..., 2, 0, None]
    R_zy = motion.R[..., 2, 1, None]
    R_zz = motion.R[..., 2, 2, None]
    t_x = motion.t[..., 0, None]
    t_y = motion.t[..., 1, None]
    t_z = motion.t[..., 2, None]
    omega_x = motion.omega[..., 0, None]
    omega_y = motion.omega[..., 1, None]
    omega_z = motion.omega[..., 2, None]
    v_x = motion.v[..., 0, None]
    v_y = motion.v[..., 1, None]
    v_z = motion.v[..., 2, None]
    alpha_x = motion.alpha[..., 0, None]
    alpha_y = motion.alpha[..., 1, None]
    alpha_z = motion.alpha[..., 2, None]
    a_x = motion.a[..., 0, None]
    a_y = motion.a[..., 1, None]
    a_z = motion.a[..., 2, None]
    # (1) platform point from the reference point
    q_x = R_xx*p_x + R_xy*p_y + R_xz*p_z
    q_y = R_yx*p_x + R_yy*p_y + R_yz*p_z
    q_z = R_zx*p_x + R_zy*p_y + R_zz*p_z
    # (1) leg vector
    S_x = q_x + t_x - b_x
    S_y = q_y + t_y - b_y
    S_z = q_z + t_z - b_z
    # (2) leg length
    L = np.sqrt(S_x*S_x + S_y*S_y + S_z*S_z)
    inv_L = 1/L
    # (3) unit vector along the leg
    s_x = S_x*inv_L
    s_y = S_y*inv_L
    s_z = S_z*inv_L
    # (4) omega x q
    w_q_x = omega_y*q_z - omega_z*q_y
    w_q_y = omega_z*q_x - omega_x*q_z
    w_q_z = omega_x*q_y - omega_y*q_x
    # (4) velocity of the platform point
    S_dot_x = v_x + w_q_x
    S_dot_y = v_y + w_q_y
    S_dot_z = v_z + w_q_z
    # (7) acceleration of the platform point
    S_ddot_x = a_x + alpha_y*q_z + omega_y*w_q_z - alpha_z*q_y - omega_z*w_q_y
    S_ddot_y = a_y + alpha_z*q_x + omega_z*w_q_x - alpha_x*q_z - omega_x*w_q_z
    S_ddot_z = a_z + alpha_x*q_y + omega_x*w_q_y - alpha_y*q_x - omega_y*w_q_x
    # (10) normal to the fixed axis and the leg
    k_cross_s_x = k_y*s_z - k_z*s_y
    k_cross_s_y = k_z*s_x - k_x*s_z
    k_cross_s_z = k_x*s_y - k_y*s_x
    # (10) along the third axis of the leg
    s_cross_normal_x = k_cross_s_z*s_y - k_cross_s_y*s_z
    s_cross_normal_y = k_cross_s_x*s_z - k_cross_s_z*s_x
    s_cross_normal_z = k_cross_s_y*s_x - k_cross_s_x*s_y
    # (10) k = (k1, 0, k3) in the leg frame
    k3 = (
        np.sqrt(s_cross_normal_x*s_cross_normal_x + s_cross_normal_y*s_cross_normal_y
        + s_cross_normal_z*s_cross_normal_z)
    )
    inv_k3 = 1/k3
    # (10) third axis of the leg frame
    z_x = inv_k3*s_cross_normal_x
    z_y = inv_k3*s_cross_normal_y
    z_z = inv_k3*s_cross_normal_z
    # (10) rotating axis of the universal joint
    y_x = s_z*z_y - s_y*z_z
    y_y = s_x*z_z - s_z*z_x
    y_z = s_y*z_x - s_x*z_y
    # (10) k = (k1, 0, k3) in the leg frame
    k1 = k_x*s_x + k_y*s_y + k_z*s_z
    # spin of the leg about s for each turn about z
    kappa = inv_k3*k1
    # (4), (5) velocity of the platform point, leg frame; u_x is L_dot
    u_x = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    u_y = S_dot_x*y_x + S_dot_y*y_y + S_dot_z*y_z
    u_z = S_dot_x*z_x + S_dot_y*z_y + S_dot_z*z_z
    # (7) acceleration of the platform point, leg frame
    e_x = S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    e_y = S_ddot_x*y_x + S_ddot_y*y_y + S_ddot_z*y_z
    e_z = S_ddot_x*z_x + S_ddot_y*z_y + S_ddot_z*z_z
    # gravity, leg frame
    gamma_x = g_x*s_x + g_y*s_y + g_z*s_z
    gamma_y = g_x*y_x + g_y*y_y + g_z*y_z
    gamma_z = g_x*z_x + g_y*z_y + g_z*z_z
    # angular velocity of the platform, leg frame
    w_x = omega_x*s_x + omega_y*s_y + omega_z*s_z
    w_y = omega_x*y_x + omega_y*y_y + omega_z*y_z
    w_z = omega_x*z_x + omega_y*z_y + omega_z*z_z
    # (6) angular velocity of the leg, leg frame
    W_z = inv_L*u_y
    W_y = -inv_L*u_z
    W_x = W_z*kappa
    c1 = W_y*W_y
    c2 = W_z*W_z
    # (8) sliding acceleration
    L_ddot = L*c1 + L*c2 + e_x
    c3 = 2*u_x
    c4 = W_z*c3
    c5 = W_y*c3
    # (9) angular acceleration of the leg but for its spin, leg frame
    A_z_own = inv_L*(e_y - c4)
    A_y_own = inv_L*(-c5 - e_z)
    c6 = W_y*W_z
    c7 = W_x*W_y
    c8 = 2*c7
    # (9) angular acceleration of the leg, leg frame
    A_x = kappa*(A_z_own - c8) - c6
    # (12) centre of mass of the upper part from the base point
    r_u_x = L + r_u0_x
    c9 = W_x*W_z
    c10 = 2*c9
    c11 = W_x*W_x
    # (11), (13) acceleration of the lower centre of mass
    a_d_x = A_y_own*r_d0_z + c10*r_d0_z + c8*r_d0_y - A_z_own*r_d0_y - c1*r_d0_x - c2*r_d0_x
    a_d_y = A_z_own*r_d0_x + W_y*W_z*r_d0_z - A_x*r_d0_z - c11*r_d0_y - c2*r_d0_y
    a_d_z = A_x*r_d0_y + W_y*W_z*r_d0_y - A_y_own*r_d0_x - c1*r_d0_z - c11*r_d0_z
    # (14) acceleration of the upper centre of mass
    a_u_x = A_y_own*r_u0_z + L_ddot + c10*r_u0_z + c8*r_u0_y - A_z_own*r_u0_y - c1*r_u_x - c2*r_u_x
    a_u_y = A_z_own*r_u_x + W_y*W_z*r_u0_z + c4 - A_x*r_u0_z - c11*r_u0_y - c2*r_u0_y
    a_u_z = A_x*r_u0_y + W_y*W_z*r_u0_y - A_y_own*r_u_x - c1*r_u0_z - c11*r_u0_z - c5
    # (25) m_d (a_d - g)
    N_d_x = m_d*(a_d_x - gamma_x)
    N_d_y = m_d*(a_d_y - gamma_y)
    N_d_z = m_d*(a_d_z - gamma_z)
    # (23) m_u (a_u - g)
    N_u_x = m_u*(a_u_x - gamma_x)
    N_u_y = m_u*(a_u_y - gamma_y)
    N_u_z = m_u*(a_u_z - gamma_z)
    # (18) friction moment at the spherical joint, leg frame
    f_leg_x = C_s*(W_x - w_x)
    f_leg_y = C_s*(W_y - w_y)
    f_leg_z = C_s*(W_z - w_z)
    # (15), (16), (19) I_d + I_u
    I_xx = I_d0_xx + I_u0_xx
    I_xy = I_d0_xy + I_u0_xy
    I_xz = I_d0_xz + I_u0_xz
    I_yy = I_d0_yy + I_u0_yy
    I_yz = I_d0_yz + I_u0_yz
    I_zz = I_d0_zz + I_u0_zz
    c15 = I_yy - I_zz
    # (19) I A + W x I W
    E_x = A_x*I_xx + A_y_own*I_xy + A_z_own*I_xz + I_yz*c1 - I_yz*c2 - c15*c6
    E_y = A_x*I_xy + A_y_own*I_yy + A_z_own*I_yz + I_xy*c6 + I_xz*c2 + c9*(I_xx + c15) - I_xz*c11 - I_yz*c8
    E_z = (
        A_x*I_xz + A_y_own*I_yz + A_z_own*I_zz + I_xy*c11 + I_yz*c10 + c7*(I_yy - I_xx - I_zz) - I_xy*c1
        - I_xz*c6
    )
    c16 = I_d0_yy - I_d0_zz
    # (17) I_d A + W x I_d W
    E_d_x = A_x*I_d0_xx + A_y_own*I_d0_xy + A_z_own*I_d0_xz + I_d0_yz*c1 - I_d0_yz*c2 - c16*c6
    E_d_y = (
        A_x*I_d0_xy + A_y_own*I_d0_yy + A_z_own*I_d0_yz + I_d0_xy*c6 + I_d0_xz*c2 + c9*(I_d0_xx + c16)
        - I_d0_xz*c11 - I_d0_yz*c8
    )
    E_d_z = (
        A_x*I_d0_xz + A_y_own*I_d0_yz + A_z_own*I_d0_zz + I_d0_xy*c11 + I_d0_yz*c10 + c7*(I_d0_yy - I_d0_xx
        - I_d0_zz) - I_d0_xy*c1 - I_d0_xz*c6
    )
    c17 = C_u*W_x + N_d_z*r_d0_y - N_d_y*r_d0_z
    c18 = C_u*W_y + N_d_x*r_d0_z - N_d_z*r_d0_x
    c19 = C_u*W_z + N_d_y*r_d0_x - N_d_x*r_d0_y
    # (20) moment that the joints' forces must make
    C_x = E_x + N_u_z*r_u0_y + c17 + f_leg_x - N_u_y*r_u0_z
    C_y = E_y + N_u_x*r_u0_z + c18 + f_leg_y - N_u_z*r_u_x
    C_z = E_z + N_u_y*r_u_x + c19 + f_leg_z - N_u_x*r_u0_y
    c20 = C_x*kappa
    c21 = C_z + c20
    c22 = C_y*inv_L
    # (21) transverse force at the spherical joint, leg frame
    K_leg_y = c21*inv_L
    K_leg_z = -c22
    c23 = N_u_x - x
    c24 = N_u_y - c21*inv_L
    c25 = N_u_z + c22
    # F_u, leg frame
    F_u_leg_x = N_d_x + c23
    F_u_leg_y = N_d_y + c24
    F_u_leg_z = N_d_z + c25
    # F_p, leg frame
    F_p_leg_x = C_p*u_x + c23
    F_p_leg_y = c24
    F_p_leg_z = c25
    # F_c, leg frame
    F_c_leg_y = c24
    F_c_leg_z = c25
    # M_p, leg frame
    M_p_leg_x = C_x - E_d_x - c17
    M_p_leg_y = C_y*bearing*inv_L + N_u_z*bearing - E_d_y - c18
    M_p_leg_z = inv_L*(C_z*bearing + bearing*c20) - E_d_z - N_u_y*bearing - c19 - c20
    shape = (*motion.t.shape[:-1], 6)
    return {
        "F_s": stack(
            shape,
            K_leg_y*y_x + K_leg_z*z_x + s_x*x,
            K_leg_y*y_y + K_leg_z*z_y + s_y*x,
            K_leg_y*y_z + K_leg_z*z_z + s_z*x,
        ),
        "F_u": stack(
            shape,
            F_u_leg_x*s_x + F_u_leg_y*y_x + F_u_leg_z*z_x,
            F_u_leg_x*s_y + F_u_leg_y*y_y + F_u_leg_z*z_y,
            F_u_leg_x*s_z + F_u_leg_y*y_z + F_u_leg_z*z_z,
        ),
        "F_p": stack(
            shape,
            F_p_leg_x*s_x + F_p_leg_y*y_x + F_p_leg_z*z_x,
            F_p_leg_x*s_y + F_p_leg_y*y_y + F_p_leg_z*z_y,
            F_p_leg_x*s_z + F_p_leg_y*y_z + F_p_leg_z*z_z,
        ),
        "F_c": stack(
            shape,
            F_c_leg_y*y_x + F_c_leg_z*z_x,
            F_c_leg_y*y_y + F_c_leg_z*z_y,
            F_c_leg_y*y_z + F_c_leg_z*z_z,
        ),
        "M_p": stack(
            shape,
            M_p_leg_x*s_x + M_p_leg_y*y_x + M_p_leg_z*z_x,
            M_p_leg_x*s_y + M_p_leg_y*y_y + M_p_leg_z*z_y,
            M_p_leg_x*s_z + M_p_leg_y*y_z + M_p_leg_z*z_z,
        ),
        "M_u": np.broadcast_to(-C_x*inv_k3, shape),
    }
