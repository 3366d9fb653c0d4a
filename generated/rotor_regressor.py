"""Columns of the regressor for the rotors of the legs on arrays, formulation `exact`, universal base joints.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

The module exact_regressor.py does not contain these columns. The names follow the same pattern.
"""

from typing import Any

from .arithmetic import Arithmetic

# Name and unit of each column of one leg.
PARAMETERS = (
    ("m_r", "kg"),
    ("j_r", "kg m"),
)


class RotorColumns:
    """Columns of the legs' rotors."""

    def __init__(self) -> None:
        self.force_m_r: Any = [0.0] * 3  # column of m_r, force rows, base frame
        self.moment_m_r: Any = [0.0] * 3  # column of m_r, moment rows, base frame
        self.force_j_r: Any = [0.0] * 3  # column of j_r, force rows, base frame
        self.moment_j_r: Any = [0.0] * 3  # column of j_r, moment rows, base frame


def rotor_columns(on: Arithmetic, leg: Any, robot: Any, motion: Any) -> Any:
    """Columns of one leg's parameters: 201 (124 mul, 73 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
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
    # (7) acceleration of the platform point
    S_ddot_x = a_x + alpha_y * q_z - alpha_z * q_y + omega_y * w_q_z - omega_z * w_q_y
    S_ddot_y = a_y + alpha_z * q_x - alpha_x * q_z + omega_z * w_q_x - omega_x * w_q_z
    S_ddot_z = a_z + alpha_x * q_y - alpha_y * q_x + omega_x * w_q_y - omega_y * w_q_x
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
    own_phi_ddot = inv_rho * (S_ddot_x * y_x + S_ddot_y * y_y + S_ddot_z * y_z) - L_share * two_phi_dot
    # (9) accelerations of the joint coordinates
    phi_ddot = own_phi_ddot - lean * two_phi_dot
    c1 = k3 * phi_dot
    # (20) torques by j_r
    tau_L_j_r = k1 * phi_ddot - c1 * theta_dot
    tau_theta_j_r = L_dot * c1
    tau_phi_j_r = L_ddot * k1 - L_dot * k3 * theta_dot
    # force at the tip by m_r
    R_m_r_x = L_ddot * s_x
    R_m_r_y = L_ddot * s_y
    R_m_r_z = L_ddot * s_z
    c2 = inv_rho * tau_phi_j_r
    c3 = inv_L * tau_theta_j_r
    # force at the tip by j_r
    R_j_r_x = c2 * y_x - c3 * z_x + s_x * tau_L_j_r
    R_j_r_y = c2 * y_y - c3 * z_y + s_y * tau_L_j_r
    R_j_r_z = c2 * y_z - c3 * z_z + s_z * tau_L_j_r
    out = RotorColumns()
    out.force_m_r = [R_m_r_x, R_m_r_y, R_m_r_z]
    out.moment_m_r = [
        R_m_r_z * q_y - R_m_r_y * q_z,
        R_m_r_x * q_z - R_m_r_z * q_x,
        R_m_r_y * q_x - R_m_r_x * q_y,
    ]
    out.force_j_r = [R_j_r_x, R_j_r_y, R_j_r_z]
    out.moment_j_r = [
        R_j_r_z * q_y - R_j_r_y * q_z,
        R_j_r_x * q_z - R_j_r_z * q_x,
        R_j_r_y * q_x - R_j_r_x * q_y,
    ]
    return out
