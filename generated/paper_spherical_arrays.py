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
    Forces, LegTerms, MomentTerms, Motion, Robot as Robot, Sums, fault_of, largest_component,
    moments_of, reach_of, shift, singular_status, solve_legs,
)
from .exact_spherical_arrays import Model, prepare as prepare, shared_terms


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg: D, K, its column of H and its part of c, (1)-(24), (35): 222 (129 mul, 91 add, 1 div, 1
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
    c6 = m_d * r_d0_x * r_d0_x
    c7 = m_u * r_u0_x * r_u0_x
    c8 = L * m_u
    c9 = m_u * L * L
    K_e = c4 * (I_d0_yy + I_u0_yy + c6 + c7 + 2.0 * c9 + 2.0 * c8 * r_u0_x)
    c10 = 2.0 * inv_L * u_x
    c11 = 4.0 * inv_L * u_x
    K_u = (c4 * (C_s + C_u + 2.0 * L * m_u * u_x + 2.0 * m_u * r_u0_x * u_x - I_d0_yy * c10 - I_u0_yy * c10
        - c10 * c6 - c10 * c7 - c11 * c9 - c11 * c8 * r_u0_x))
    K_gamma = -inv_L * (c5 + m_d * r_d0_x + c8)
    c12 = C_s * inv_L
    K_s_w = c12
    # K, base frame
    K_x = (K_gamma * gamma_across_x + K_e * e_across_x + K_s_w * (s_y * w_across_z - s_z * w_across_y) + K_u
        * u_across_x)
    K_y = (K_gamma * gamma_across_y + K_e * e_across_y + K_s_w * (s_z * w_across_x - s_x * w_across_z) + K_u
        * u_across_y)
    K_z = (K_gamma * gamma_across_z + K_e * e_across_z + K_s_w * (s_x * w_across_y - s_y * w_across_x) + K_u
        * u_across_z)
    f_s_u = c12
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
