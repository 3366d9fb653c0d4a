"""Inverse dynamics and joint reactions of the Stewart platform, formulation and joint `paper_spherical`.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

``robot`` has the fields of ``stewart_robot`` in stewart.h as arrays, legs first: b (6, 3), I_d0 (6, 3, 3).
``motion`` has R (..., 3, 3), t, omega, v, alpha, a, F_ext, M_ext (..., 3). Units as in stewart.h.

Operations of one pose of inverse dynamics, six legs, solve included
         with friction                             without friction
leg      249 (144 mul, 103 add, 1 div, 1 sqrt)     182 (103 mul, 77 add, 1 div, 1 sqrt)
platform 219 (123 mul, 96 add, 0 div, 0 sqrt)      219 (123 mul, 96 add, 0 div, 0 sqrt)
sum of c 36 (0 mul, 36 add, 0 div, 0 sqrt)         36 (0 mul, 36 add, 0 div, 0 sqrt)
solve    197 (106 mul, 85 add, 6 div, 0 sqrt)      197 (106 mul, 85 add, 6 div, 0 sqrt)
forces   6 (0 mul, 6 add, 0 div, 0 sqrt)           6 (0 mul, 6 add, 0 div, 0 sqrt)
total    1952 (1093 mul, 841 add, 12 div, 6 sqrt)  1550 (847 mul, 685 add, 12 div, 6 sqrt)
"""

from typing import Any

import numpy as np

from .assembly import Array, solve, stack

# (mul, add, div, sqrt) of each part of one pose, and of all.
OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (144, 103, 1, 1),
        "platform": (123, 96, 0, 0),
        "sum of c": (0, 36, 0, 0),
        "solve": (106, 85, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1093, 841, 12, 6),
    },
    "frictionless": {
        "leg": (103, 77, 1, 1),
        "platform": (123, 96, 0, 0),
        "sum of c": (0, 36, 0, 0),
        "solve": (106, 85, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (847, 685, 12, 6),
    },
}

# The same of stewart_paper_spherical_forces.h.
FORCE_OPERATIONS: dict[str, dict[str, tuple[int, int, int, int]]] = {
    "friction": {
        "leg": (129, 91, 1, 1),
        "platform": (96, 90, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 51, 0, 0),
        "solve": (84, 67, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (1014, 805, 12, 6),
    },
    "frictionless": {
        "leg": (88, 68, 1, 1),
        "platform": (96, 90, 0, 0),
        "moments": (12, 9, 0, 0),
        "sum of c": (0, 33, 0, 0),
        "solve": (84, 67, 6, 0),
        "forces": (0, 6, 0, 0),
        "total": (768, 649, 12, 6),
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

    Operations: 249 (144 mul, 103 add, 1 div, 1 sqrt).
    """
    b_x = robot.b[:, 0]
    b_y = robot.b[:, 1]
    b_z = robot.b[:, 2]
    p_x = robot.p[:, 0]
    p_y = robot.p[:, 1]
    p_z = robot.p[:, 2]
    m_d = robot.m_d
    r_d0_x = robot.r_d0[:, 0]
    I_d0_yy = robot.I_d0[:, 1, 1]
    m_u = robot.m_u
    r_u0_x = robot.r_u0[:, 0]
    I_u0_yy = robot.I_u0[:, 1, 1]
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
    # part of e along the leg
    e_x = S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    # part of u along the leg
    u_x = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # part of gamma along the leg
    gamma_x = g_x*s_x + g_y*s_y + g_z*s_z
    # part of w along the leg
    w_x = omega_x*s_x + omega_y*s_y + omega_z*s_z
    # part of e across the leg
    e_across_x = S_ddot_x - e_x*s_x
    e_across_y = S_ddot_y - e_x*s_y
    e_across_z = S_ddot_z - e_x*s_z
    # part of u across the leg
    u_across_x = S_dot_x - s_x*u_x
    u_across_y = S_dot_y - s_y*u_x
    u_across_z = S_dot_z - s_z*u_x
    # part of gamma across the leg
    gamma_across_x = g_x - gamma_x*s_x
    gamma_across_y = g_y - gamma_x*s_y
    gamma_across_z = g_z - gamma_x*s_z
    c1 = s_x*w_x
    c2 = s_y*w_x
    c3 = s_z*w_x
    # part of w across the leg
    w_across_x = omega_x - c1
    w_across_y = omega_y - c2
    w_across_z = omega_z - c3
    # square of u across the leg
    u_square = u_across_x*u_across_x + u_across_y*u_across_y + u_across_z*u_across_z
    c4 = inv_L*inv_L
    c5 = m_u*r_u0_x
    # (24) known part of the actuator force
    D = C_p*u_x + e_x*m_u - c4*c5*u_square - gamma_x*m_u
    c6 = m_d*r_d0_x*r_d0_x
    c7 = m_u*r_u0_x*r_u0_x
    c8 = L*m_u
    c9 = m_u*L*L
    K_e = c4*(I_d0_yy + I_u0_yy + c6 + c7 + 2*c8*r_u0_x + 2*c9)
    c10 = 2*inv_L*u_x
    c11 = 4*inv_L*u_x
    K_u = (
        c4*(C_s + C_u + 2*L*m_u*u_x + 2*m_u*r_u0_x*u_x - I_d0_yy*c10 - I_u0_yy*c10 - c10*c6 - c10*c7
        - c11*c8*r_u0_x - c11*c9)
    )
    K_gamma = -inv_L*(c5 + c8 + m_d*r_d0_x)
    c12 = C_s*inv_L
    K_s_w = c12
    # K, base frame
    K_x = K_e*e_across_x + K_gamma*gamma_across_x + K_s_w*(s_y*w_across_z - s_z*w_across_y) + K_u*u_across_x
    K_y = K_e*e_across_y + K_gamma*gamma_across_y + K_s_w*(s_z*w_across_x - s_x*w_across_z) + K_u*u_across_y
    K_z = K_e*e_across_z + K_gamma*gamma_across_z + K_s_w*(s_x*w_across_y - s_y*w_across_x) + K_u*u_across_z
    f_s_u = c12
    # f, base frame
    f_x = f_s_u*(s_y*u_across_z - s_z*u_across_y) - C_s*c1 - C_s*w_across_x
    f_y = f_s_u*(s_z*u_across_x - s_x*u_across_z) - C_s*c2 - C_s*w_across_y
    f_z = f_s_u*(s_x*u_across_y - s_y*u_across_x) - C_s*c3 - C_s*w_across_z
    shape = (*motion.t.shape[:-1], 6)
    return {
        "q": stack(shape, q_x, q_y, q_z),
        "L": np.broadcast_to(L, shape),
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

    Operations: 462 (269 mul, 191 add, 1 div, 1 sqrt).
    """
    b_x = robot.b[:, 0]
    b_y = robot.b[:, 1]
    b_z = robot.b[:, 2]
    p_x = robot.p[:, 0]
    p_y = robot.p[:, 1]
    p_z = robot.p[:, 2]
    m_d = robot.m_d
    r_d0_x = robot.r_d0[:, 0]
    I_d0_yy = robot.I_d0[:, 1, 1]
    m_u = robot.m_u
    r_u0_x = robot.r_u0[:, 0]
    I_u0_yy = robot.I_u0[:, 1, 1]
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
    # part of e along the leg
    e_x = S_ddot_x*s_x + S_ddot_y*s_y + S_ddot_z*s_z
    # part of u along the leg
    u_x = S_dot_x*s_x + S_dot_y*s_y + S_dot_z*s_z
    # part of gamma along the leg
    gamma_x = g_x*s_x + g_y*s_y + g_z*s_z
    # part of w along the leg
    w_x = omega_x*s_x + omega_y*s_y + omega_z*s_z
    # part of e across the leg
    e_across_x = S_ddot_x - e_x*s_x
    e_across_y = S_ddot_y - e_x*s_y
    e_across_z = S_ddot_z - e_x*s_z
    # part of u across the leg
    u_across_x = S_dot_x - s_x*u_x
    u_across_y = S_dot_y - s_y*u_x
    u_across_z = S_dot_z - s_z*u_x
    # part of gamma across the leg
    gamma_across_x = g_x - gamma_x*s_x
    gamma_across_y = g_y - gamma_x*s_y
    gamma_across_z = g_z - gamma_x*s_z
    # part of w across the leg
    w_across_x = omega_x - s_x*w_x
    w_across_y = omega_y - s_y*w_x
    w_across_z = omega_z - s_z*w_x
    # square of u across the leg
    u_square = u_across_x*u_across_x + u_across_y*u_across_y + u_across_z*u_across_z
    c1 = inv_L*inv_L
    c2 = m_d*r_d0_x*r_d0_x
    c3 = m_u*r_u0_x*r_u0_x
    c4 = L*m_u
    c5 = L*L
    c6 = 2*m_u
    c7 = c5*c6
    F_s_e = c1*(I_d0_yy + I_u0_yy + c2 + c3 + 2*c4*r_u0_x + c7)
    c9 = 2*u_x
    c8 = I_d0_yy*inv_L
    c10 = c8*c9
    c11 = I_u0_yy*inv_L
    c12 = 4*u_x
    c13 = c4*inv_L
    c14 = c13*r_u0_x
    c15 = c5*inv_L
    c16 = c12*m_u
    c17 = c2*inv_L
    c18 = c17*c9
    c19 = c3*inv_L
    F_s_u = (
        c1*(C_s + C_u + 2*L*m_u*u_x + 2*m_u*r_u0_x*u_x - c10 - c11*c9 - c12*c14 - c15*c16 - c18 - c19*c9)
    )
    c20 = m_d*r_d0_x
    c21 = m_u*r_u0_x
    F_s_gamma = -inv_L*(c20 + c21 + c4)
    c22 = C_s*inv_L
    F_s_s_w = c22
    c23 = s_y*w_across_z - s_z*w_across_y
    c24 = s_z*w_across_x - s_x*w_across_z
    c25 = s_x*w_across_y - s_y*w_across_x
    # F_s, base frame
    F_s_x = F_s_e*e_across_x + F_s_gamma*gamma_across_x + F_s_s_w*c23 + F_s_u*u_across_x + s_x*x
    F_s_y = F_s_e*e_across_y + F_s_gamma*gamma_across_y + F_s_s_w*c24 + F_s_u*u_across_y + s_y*x
    F_s_z = F_s_e*e_across_z + F_s_gamma*gamma_across_z + F_s_s_w*c25 + F_s_u*u_across_z + s_z*x
    c27 = c11 + 2*c14 + c17 + c19 + c7*inv_L + c8 - c21 - c4
    F_u_e = -inv_L*(c27 - c20)
    c29 = c1*c9
    c30 = I_d0_yy*c29
    c31 = I_u0_yy*c29
    c32 = c1*c12*r_u0_x
    c33 = c1*c5
    c34 = c2*c29
    c35 = c29*c3
    c36 = (
        c16*c33 + c30 + c31 + c32*c4 + c34 + c35 + c6*u_x - C_u*inv_L - 4*L*inv_L*m_u*u_x - c22
        - 4*inv_L*m_u*r_u0_x*u_x
    )
    F_u_u = -inv_L*(2*inv_L*m_d*r_d0_x*u_x - c36)
    c37 = c20*inv_L
    c38 = c21*inv_L
    c39 = c13 + c37 + c38 - m_u
    F_u_gamma = c39 - m_d
    F_u_s_w = -c22
    c40 = c1*u_square
    c41 = c21*c40 + gamma_x*m_u + x - e_x*m_u
    c42 = -c20*c40 - c41 - gamma_x*m_d
    # F_u, base frame
    F_u_x = F_u_e*e_across_x + F_u_gamma*gamma_across_x + F_u_s_w*c23 + F_u_u*u_across_x + c42*s_x
    F_u_y = F_u_e*e_across_y + F_u_gamma*gamma_across_y + F_u_s_w*c24 + F_u_u*u_across_y + c42*s_y
    F_u_z = F_u_e*e_across_z + F_u_gamma*gamma_across_z + F_u_s_w*c25 + F_u_u*u_across_z + c42*s_z
    c43 = -c27*inv_L
    F_p_e = c43
    c44 = c36*inv_L
    F_p_u = c44
    F_p_gamma = c39
    F_p_s_w = -c22
    c45 = C_p*u_x - c41
    # F_p, base frame
    F_p_x = F_p_e*e_across_x + F_p_gamma*gamma_across_x + F_p_s_w*c23 + F_p_u*u_across_x + c45*s_x
    F_p_y = F_p_e*e_across_y + F_p_gamma*gamma_across_y + F_p_s_w*c24 + F_p_u*u_across_y + c45*s_y
    F_p_z = F_p_e*e_across_z + F_p_gamma*gamma_across_z + F_p_s_w*c25 + F_p_u*u_across_z + c45*s_z
    F_c_e = c43
    F_c_u = c44
    F_c_gamma = c39
    F_c_s_w = -c22
    # F_c, base frame
    F_c_x = F_c_e*e_across_x + F_c_gamma*gamma_across_x + F_c_s_w*c23 + F_c_u*u_across_x
    F_c_y = F_c_e*e_across_y + F_c_gamma*gamma_across_y + F_c_s_w*c24 + F_c_u*u_across_y
    F_c_z = F_c_e*e_across_z + F_c_gamma*gamma_across_z + F_c_s_w*c25 + F_c_u*u_across_z
    c46 = bearing*c4
    c47 = bearing*c13
    c48 = bearing*m_u
    M_p_s_e = (
        inv_L*(bearing*c11 + bearing*c17 + bearing*c19 + bearing*c8 + 2*c15*c48 + 2*c47*r_u0_x - I_d0_yy
        - bearing*c21 - c2 - c46)
    )
    c49 = -bearing*c22
    M_p_s_u = (
        inv_L*(C_u*bearing*inv_L + 4*L*bearing*inv_L*m_u*u_x + 4*bearing*inv_L*m_u*r_u0_x*u_x + c10 + c18
        - C_u - bearing*c30 - bearing*c31 - bearing*c34 - bearing*c35 - c12*c33*c48 - c32*c46 - c48*c9
        - c49)
    )
    M_p_s_gamma = bearing*m_u + c20 - bearing*c37 - bearing*c38 - c47
    M_p_w = c49
    # M_p, base frame
    M_p_x = (
        M_p_s_e*(e_across_z*s_y - e_across_y*s_z) + M_p_s_gamma*(gamma_across_z*s_y - gamma_across_y*s_z)
        + M_p_s_u*(s_y*u_across_z - s_z*u_across_y) + M_p_w*w_across_x
    )
    M_p_y = (
        M_p_s_e*(e_across_x*s_z - e_across_z*s_x) + M_p_s_gamma*(gamma_across_x*s_z - gamma_across_z*s_x)
        + M_p_s_u*(s_z*u_across_x - s_x*u_across_z) + M_p_w*w_across_y
    )
    M_p_z = (
        M_p_s_e*(e_across_y*s_x - e_across_x*s_y) + M_p_s_gamma*(gamma_across_y*s_x - gamma_across_x*s_y)
        + M_p_s_u*(s_x*u_across_y - s_y*u_across_x) + M_p_w*w_across_z
    )
    shape = (*motion.t.shape[:-1], 6)
    return {
        "F_s": stack(shape, F_s_x, F_s_y, F_s_z),
        "F_u": stack(shape, F_u_x, F_u_y, F_u_z),
        "F_p": stack(shape, F_p_x, F_p_y, F_p_z),
        "F_c": stack(shape, F_c_x, F_c_y, F_c_z),
        "M_p": stack(shape, M_p_x, M_p_y, M_p_z),
        "M_u": np.broadcast_to(0, shape),
    }
