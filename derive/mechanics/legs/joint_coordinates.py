"""Leg of ``exact`` in joint coordinates, by Lagrange's equations.

The coordinates are the length L, the angle phi about the fixed axis k, and the angle theta about y. In the
leg frame k = (k1, 0, k3) = (cos theta, 0, sin theta). Rates and accelerations are projections of S_dot and
S_ddot on s, k, and y. The inertial constants are the sums in ``lumped_constants``. The mass of the upper part
is lumped with the platform.

The joint singularity is the pose in which the leg is parallel to the fixed axis: k3 = 0.
"""

from dataclasses import dataclass, replace

import sympy as sp

from ...program.block import Builder
from .. import lumped_constants as p
from .. import quantities as n
from .leg import axes, cross, tip_vector
from .rotor import NONE, Rotor

HALF = sp.Rational(1, 2)


@dataclass(frozen=True)
class JointFrame:
    """Geometry of a leg with universal base joint, base frame.

    Attributes
    ----------
    q : Matrix, shape (3, 1)
        Platform point (tip) from the reference point (m).
    s, y : Matrix, shape (3, 1)
        First and second axis of the leg frame.
    L, inv_L : Expr
        Leg length (m), and 1 / L.
    inv_rho : Expr
        1 / rho with the distance rho = |k x S| of the tip from the fixed axis.
    k1, k3, kappa : Expr
        k = (k1, 0, k3) in the leg frame, and k1 / k3.
    z : Matrix, shape (3, 1), optional
        Third axis of the leg frame; None if projections are on the fixed axis instead.
    rotor : Rotor
        Rotor of the leg's drive.
    """

    q: sp.Matrix
    s: sp.Matrix
    y: sp.Matrix
    L: sp.Expr
    inv_L: sp.Expr
    inv_rho: sp.Expr
    k1: sp.Expr
    k3: sp.Expr
    kappa: sp.Expr
    z: sp.Matrix | None = None
    rotor: Rotor = NONE


@dataclass(frozen=True)
class JointRates:
    """Rates of the joint coordinates L, theta, phi, and products of them.

    Attributes
    ----------
    L, theta, phi : Expr
        Rates (m/s, rad/s).
    theta2, phi2 : Expr
        Squares of the angular rates.
    phi_twice : Expr
        2 phi_dot.
    L_share, rho_share : Expr
        L_dot / L, and rho_dot / rho (1/s).
    lean : Expr
        kappa theta_dot = rho_dot / rho - L_dot / L (1/s).
    """

    L: sp.Expr
    theta: sp.Expr
    phi: sp.Expr
    theta2: sp.Expr
    phi2: sp.Expr
    phi_twice: sp.Expr
    L_share: sp.Expr = sp.S.Zero
    lean: sp.Expr = sp.S.Zero
    rho_share: sp.Expr = sp.S.Zero


@dataclass(frozen=True)
class JointAccelerations:
    """Accelerations of the joint coordinates L, theta, phi.

    Attributes
    ----------
    L, theta, phi : Expr
        Accelerations (m/s^2, rad/s^2).
    own_theta, own_phi : Expr, optional
        Accelerations without the effect of the frame's rotation about s, which is k1 k3 phi_dot^2 and -2
        kappa theta_dot phi_dot; None without projections on z.
    """

    L: sp.Expr
    theta: sp.Expr
    phi: sp.Expr
    own_theta: sp.Expr | None = None
    own_phi: sp.Expr | None = None


@dataclass(frozen=True)
class JointInertia:
    """Mass matrix M of the joint coordinates, and its derivatives.

    Attributes
    ----------
    theta, phi, mixed : Expr
        M_theta, M_phi, and M_theta_phi.
    L_theta, L_phi : Expr
        Coupling of L with theta and phi.
    phi_by_theta, phi_by_L : Expr
        Half the derivatives of M_phi.
    mixed_by_theta : Expr
        Derivative of M_theta_phi.
    L : Expr
        M_LL, which only a rotor contributes.
    """

    theta: sp.Expr
    phi: sp.Expr
    mixed: sp.Expr
    L_theta: sp.Expr
    L_phi: sp.Expr
    phi_by_theta: sp.Expr
    phi_by_L: sp.Expr
    mixed_by_theta: sp.Expr
    L: sp.Expr = sp.S.Zero

    def matrix(self) -> sp.Matrix:
        """Return M of (L, theta, phi), 3x3."""
        return sp.Matrix(
            [
                [self.L, self.L_theta, self.L_phi],
                [self.L_theta, self.theta, self.mixed],
                [self.L_phi, self.mixed, self.phi],
            ]
        )


@dataclass(frozen=True)
class JointForces:
    """Generalized forces: along L without the part of theta, about y, and about k."""

    along: sp.Expr
    about_y: sp.Expr
    about_k: sp.Expr


def joint_frame(
    build: Builder, with_z: bool = False, early: bool = False, leaning: bool = True, rotor: Rotor = NONE
) -> JointFrame:
    """Name the geometry of a leg, (1)-(3) and (10), with projections on the fixed axis or on z.

    Parameters
    ----------
    with_z : bool
        True to name the third axis z. Projections on the fixed axis lose accuracy in proportion to k1 / k3
        near the joint singularity; projections on z do not.
    early : bool
        True to compute rho without waiting for s.
    leaning : bool
        True to correct the rounding error of the normal in ``early``, for legs near their joint singularity.
    """
    k = n.k.value
    q, S = tip_vector(build)
    meaning = "component of the leg vector along the fixed axis, and normal to both"
    zeta = build.scalar("zeta", k.dot(S), "(10)", meaning)
    normal = build.vector("k_cross_S", cross(k, S), "(10)", meaning)
    meaning = "leg length, and distance of the tip from the fixed axis"
    if with_z:
        L = build.scalar("L", sp.sqrt(S.dot(S)), "(2)", meaning)
    else:
        rho2 = build.scalar("rho2", normal.dot(normal))
        L = build.scalar("L", sp.sqrt(rho2 + zeta**2), "(2)", meaning)
        rho = build.scalar("rho", sp.sqrt(rho2), "(2)", meaning)
    inv_L = build.scalar("inv_L", 1 / L)
    s = build.vector("s", S * inv_L, "(3)", "unit vector along the leg")
    if with_z and early:
        y, z, rho, inv_rho = _early_axes(build, s, normal, leaning)
    elif with_z:
        y, z, rho, inv_rho = axes(build, s, normal, "rho", meaning)
    else:
        inv_rho, z = build.scalar("inv_rho", 1 / rho), None
        y = build.vector("y", normal * inv_rho, "(10)", "second axis of the leg frame")
    meaning = "k = (k1, 0, k3) in the leg frame"
    return JointFrame(
        q,
        s,
        y,
        L=L,
        inv_L=inv_L,
        inv_rho=inv_rho,
        k1=build.scalar("k1", zeta * inv_L, "(10)", meaning),
        k3=build.scalar("k3", rho * inv_L, "(10)", meaning),
        kappa=build.scalar("kappa", zeta * inv_rho, "(10)", "k1 / k3"),
        z=z,
        rotor=rotor,
    )


def _early_axes(
    build: Builder, s: sp.Matrix, normal: sp.Matrix, leaning: bool
) -> tuple[sp.Matrix, sp.Matrix, sp.Expr, sp.Expr]:
    """Name the axes as ``leg.axes``, with rho from the normal itself to shorten the dependency chain.

    The component of the normal along s is a rounding error. It makes the normal longer than s x normal by
    half the square of its fraction of the length. ``leaning`` corrects this.
    """
    rho = build.scalar("rho", sp.sqrt(normal.dot(normal)), "(10)", "distance of the tip from the fixed axis")
    inv_rho = build.scalar("inv_rho", 1 / rho)
    unit = inv_rho
    if leaning:
        share = build.scalar(
            "n_along_s", normal.dot(s) * inv_rho, "", "relative component of the normal along s: rounding"
        )
        unit = build.scalar("inv_across", inv_rho + inv_rho * share**2 / 2, "", "one over |s x normal|")
    across = build.vector("s_cross_normal", cross(s, normal), "(10)", "along the third axis of the leg")
    z = build.vector("z", across * unit, "(10)", "third axis of the leg frame")
    return build.vector("y", cross(z, s), "(10)", "rotating axis of the universal joint"), z, rho, inv_rho


def joint_rates(build: Builder, at: JointFrame, S_dot: sp.Matrix) -> JointRates:
    """Name the rates of L, phi, and theta, (5), (6)."""
    meaning = "rates of the joint coordinates: L, phi about k, theta about y"
    L_dot = build.scalar("L_dot", at.s.dot(S_dot), "(5)", meaning)
    phi_dot = build.scalar("phi_dot", at.inv_rho * at.y.dot(S_dot), "(6)", meaning)
    across = (
        at.inv_rho * (at.k1 * L_dot - n.k.value.dot(S_dot)) if at.z is None else -at.inv_L * at.z.dot(S_dot)
    )
    theta_dot = build.scalar("theta_dot", across, "(6)", meaning)
    L_share = build.scalar("L_share", at.inv_L * L_dot, "", "L_dot / L")
    lean = build.scalar("lean", at.kappa * theta_dot)
    rates = with_products(build, L_dot, theta_dot, phi_dot)
    rho_share = build.scalar("rho_share", L_share + lean, "", "rho_dot / rho")
    return replace(rates, L_share=L_share, lean=lean, rho_share=rho_share)


def with_products(build: Builder, L_dot: sp.Expr, theta_dot: sp.Expr, phi_dot: sp.Expr) -> JointRates:
    """Return the rates with the products that the leg's equations require, without L_share and rho_share."""
    return JointRates(
        L_dot,
        theta_dot,
        phi_dot,
        theta2=build.scalar("theta_dot2", theta_dot**2),
        phi2=build.scalar("phi_dot2", phi_dot**2),
        phi_twice=build.scalar("two_phi_dot", 2 * phi_dot),
    )


def joint_accelerations(
    build: Builder, at: JointFrame, rates: JointRates, S_ddot: sp.Matrix
) -> JointAccelerations:
    """Name the accelerations of L, theta, and phi, (8), (9)."""
    meaning = "accelerations of the joint coordinates"
    k33 = build.scalar("k33", at.k3**2)
    L_ddot = build.scalar(
        "L_ddot", at.s.dot(S_ddot) + at.L * (rates.theta2 + k33 * rates.phi2), "(8)", meaning
    )
    if at.z is None:
        across = at.inv_rho * (at.k1 * L_ddot - n.k.value.dot(S_ddot))
        across -= rates.theta * (rates.rho_share + rates.L_share)
        theta_ddot = build.scalar("theta_ddot", across, "(9)", meaning)
        about_k = at.inv_rho * at.y.dot(S_ddot) - rates.phi_twice * rates.rho_share
        return JointAccelerations(L_ddot, theta_ddot, build.scalar("phi_ddot", about_k, "(9)", meaning))
    own = "accelerations of the joint coordinates without the rotation of the leg frame about s"
    across = -at.inv_L * at.z.dot(S_ddot) - 2 * rates.theta * rates.L_share
    about_k = at.inv_rho * at.y.dot(S_ddot) - rates.phi_twice * rates.L_share
    own_theta = build.scalar("own_theta_ddot", across, "(9)", own)
    own_phi = build.scalar("own_phi_ddot", about_k, "(9)", own)
    turning = at.k1 * at.k3 * rates.phi2
    theta_ddot = build.scalar("theta_ddot", own_theta + turning, "(9)", meaning)
    phi_ddot = build.scalar("phi_ddot", own_phi - rates.phi_twice * rates.lean, "(9)", meaning)
    return JointAccelerations(L_ddot, theta_ddot, phi_ddot, own_theta, own_phi)


def joint_inertia(build: Builder, at: JointFrame) -> JointInertia:
    """Name the mass matrix of the joint coordinates from J and h, (19)."""
    k1, k3, L = at.k1, at.k3, at.L
    hx, hy, hz = p.h.value
    J = p.J.value
    k33, k13 = build.scalar("k33", k3**2), build.scalar("k13", k1 * k3)
    L_h = build.scalar("L_h2", L * p.h2_x.value)
    a1 = build.scalar("a1", p.dJ_zx.value + L_h)
    a2 = build.scalar("a2", p.J2_xz.value - L * p.h2_z.value)
    a3 = build.scalar("a3", J[0, 1] - L * hy)
    meaning = "inertia of the joint coordinates"
    slopes = "derivatives of M_phi / 2 by theta and L, of M_mixed by theta"
    return JointInertia(
        phi=build.scalar("M_phi", J[0, 0] + k33 * a1 + k13 * a2, "(19)", meaning),
        theta=build.scalar("M_theta", J[1, 1] + L_h, "(19)", meaning),
        mixed=build.scalar("M_mixed", k1 * a3 + k3 * J[1, 2], "(19)", meaning),
        L=at.rotor.mass,
        L_theta=hz,
        L_phi=k1 * at.rotor.momentum - build.scalar("k3_h", k3 * hy),
        phi_by_theta=build.scalar("M_phi_theta", k13 * a1 + a2 * (HALF - k33), "(19)", slopes),
        phi_by_L=build.scalar("M_phi_L", k33 * hx - k13 * hz, "(19)", slopes),
        mixed_by_theta=build.scalar("M_mixed_theta", k1 * J[1, 2] - k3 * a3, "(19)", slopes),
    )


def gravity_torques(build: Builder, at: JointFrame) -> tuple[sp.Expr, sp.Expr]:
    """Name the generalized forces of gravity about y and about k, from the first moments w."""
    meaning = "components of gravity along k x y and along y"
    gamma_n = build.scalar("gamma_n", at.y.dot(p.g_x_k.value), "", meaning)
    gamma_y = build.scalar("gamma_y", at.y.dot(n.g.value), "", meaning)
    wx, wy, wz = p.w.value
    meaning = "components of the first moment along k and along -k x y"
    w_k = build.scalar("w_k", at.k1 * wx + at.k3 * wz, "", meaning)
    w_n = build.scalar("w_n", at.k3 * wx - at.k1 * wz, "", meaning)
    return w_n * p.g_k.value + w_k * gamma_n, -wy * gamma_n - w_n * gamma_y


def _turning(
    build: Builder, at: JointFrame, rates: JointRates, accelerations: JointAccelerations, m: JointInertia
) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return three terms of Lagrange's equations that contain M_theta and M_phi.

    They are M_theta theta_ddot - M_phi,theta phi_dot^2 / 2, M_phi phi_ddot, and M_phi,theta theta_dot / 2.
    With z the effect of the frame's rotation about s is omitted: it enters both terms of each sum with
    opposite signs and is proportional to 1 / k3.
    """
    if accelerations.own_theta is None or accelerations.own_phi is None:
        return (
            m.theta * accelerations.theta - m.phi_by_theta * rates.phi2,
            m.phi * accelerations.phi,
            m.phi_by_theta * rates.theta,
        )
    J, a2 = p.J.value, p.J2_xz.value - at.L * p.h2_z.value
    k33, k13 = build.scalar("k33", at.k3**2), build.scalar("k13", at.k1 * at.k3)
    uneven = J[1, 1] - p.dJ_zx.value
    return (
        m.theta * accelerations.own_theta + rates.phi2 * (k13 * uneven - a2 * (HALF - k33)),
        m.phi * accelerations.own_phi,
        -rates.theta * (HALF * a2 + at.kappa * J[0, 0]),
    )


def joint_forces(
    build: Builder,
    at: JointFrame,
    rates: JointRates,
    accelerations: JointAccelerations,
    friction: bool = True,
    inertia: JointInertia | None = None,
) -> JointForces:
    """Derive Lagrange's equations of the leg with gravity and friction, (17)-(20), (23).

    Parameters
    ----------
    inertia : JointInertia, optional
        Mass matrix of the joint coordinates. If None, it is ``joint_inertia``.
    """
    L_ddot, theta_ddot, phi_ddot = accelerations.L, accelerations.theta, accelerations.phi
    hx = p.h.value[0]
    m = joint_inertia(build, at) if inertia is None else inertia
    bend = build.scalar("bend", rates.L * rates.theta)
    about_y, about_k = gravity_torques(build, at)
    turn_y, turn_k, slope = _turning(build, at, rates, accelerations, m)
    about_y += m.L_theta * L_ddot + m.mixed * phi_ddot + p.h2_x.value * bend + turn_y
    about_k += (
        m.mixed * theta_ddot
        + m.L_phi * L_ddot
        + m.mixed_by_theta * rates.theta2
        - at.k1 * p.h2_y.value * bend
        + turn_k
        + rates.phi_twice * (m.phi_by_L * rates.L + slope)
    )
    along = m.L_theta * theta_ddot + m.L_phi * phi_ddot - hx * rates.theta2 - m.phi_by_L * rates.phi2
    if at.rotor != NONE:
        carried = at.k3 * at.rotor.momentum
        about_y += carried * rates.L * rates.phi
        about_k -= carried * rates.L * rates.theta
        along += m.L * L_ddot - carried * rates.theta * rates.phi
    if friction:
        C_s, C_us, omega = n.C_s.value, p.C_us.value, n.omega.value
        about_y += C_us * rates.theta - C_s * at.y.dot(omega)
        about_k += C_us * rates.phi - C_s * n.k.value.dot(omega)
        along += n.C_p.value * rates.L
    meaning = "generalized forces about y and about k"
    return JointForces(
        along,
        about_y=build.scalar("tau_y", about_y, "(20)", meaning),
        about_k=build.scalar("tau_k", about_k, "(20)", meaning),
    )


def tip_force(build: Builder, at: JointFrame, forces: JointForces) -> tuple[sp.Expr, sp.Matrix]:
    """Name D and K at the spherical joint, (21), (24), base frame.

    With z, K = Q_y y + Q_z z has no component along s. Without z, K = Q_k k + Q_y y has one, and D changes
    with it.
    """
    if at.z is not None:
        meaning = "K = Q_y y + Q_z z"
        Q_y = build.scalar("Q_y", at.inv_rho * forces.about_k, "(21)", meaning)
        Q_z = build.scalar("Q_z", -at.inv_L * forces.about_y, "(21)", meaning)
        K = build.vector("K", Q_y * at.y + Q_z * at.z, "(21)", "force at the spherical joint, base frame")
        return build.scalar("D", forces.along, "(24)", "known part of the actuator force for this K"), K
    meaning = "K = Q_k k + Q_y y, with a component along s"
    Q_k = build.scalar("Q_k", -at.inv_rho * forces.about_y, "(21)", meaning)
    Q_y = build.scalar("Q_y", at.inv_rho * forces.about_k, "(21)", meaning)
    K = build.vector("K", Q_k * n.k.value + Q_y * at.y, "(21)", "force at the spherical joint, base frame")
    D = build.scalar("D", forces.along - at.k1 * Q_k, "(24)", "known part of the actuator force for this K")
    return D, K


def friction_moment(at: JointFrame, rates: JointRates, friction: bool = True) -> sp.Matrix:
    """Return C_s times the angular velocity of the leg: the leg's part of f in (18), base frame.

    The platform's part is in C_P.
    """
    if not friction:
        return sp.zeros(3, 1)
    return n.C_s.value * (rates.phi * n.k.value + rates.theta * at.y)
