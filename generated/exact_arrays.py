"""Dynamics of a Gough-Stewart platform on arrays of the array API: NumPy, JAX, PyTorch, and others.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit.
SPDX-License-Identifier: 0BSD

Each number of a structure may be an array with one value per pose, so the component is the first index: ``F`` is
a list of six. An array instead of such a list has the components last, (..., 6). ``on`` is the arithmetic:
selections, square roots, and constants. If a status is not 0, the other numbers of a result are NaN.
"""

from typing import Any

from .arithmetic import JOINT_SINGULAR, MASS_MATRIX_INDEFINITE, NOT_FINITE, OK, SINGULAR, ZERO_LENGTH, Arithmetic


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


class Robot:
    """The machine."""

    def __init__(self) -> None:
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: center of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its center of mass, platform frame
        self.I_p: Any = [0.0] * 6
        self.g: Any = [0.0] * 3  # m/s^2: acceleration due to gravity, base frame
        self.leg: Any = [Leg() for _ in range(6)]  # the legs


class Motion:
    """Motion of the platform and its load."""

    def __init__(self) -> None:
        self.R: Any = [0.0] * 9  # 1: orientation of the platform, platform frame to base frame
        self.t: Any = [0.0] * 3  # m: position of the platform's reference point, base frame
        self.omega: Any = [0.0] * 3  # rad/s: angular velocity of the platform, base frame
        self.v: Any = [0.0] * 3  # m/s: velocity of the reference point, base frame
        self.alpha: Any = [0.0] * 3  # rad/s^2: angular acceleration of the platform, base frame
        self.a: Any = [0.0] * 3  # m/s^2: acceleration of the reference point, base frame
        self.F_ext: Any = [0.0] * 3  # N: external force at the reference point, platform frame
        self.M_ext: Any = [0.0] * 3  # N m: external moment about the reference point, platform frame


class LegConstants:
    """Prepared constants of one leg."""

    def __init__(self) -> None:
        self.b: Any = [0.0] * 3  # m: base point, base frame
        self.p: Any = [0.0] * 3  # m: platform point, platform frame
        self.k: Any = [0.0] * 3  # 1: unit vector along the fixed axis of the universal joint, base frame
        self.C_p: Any = 0.0  # N s/m: viscous friction of the prismatic joint
        self.C_s: Any = 0.0  # N m s: viscous friction of the spherical joint
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


class Added:
    """Contributions of the legs to the constants of the platform."""

    def __init__(self) -> None:
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
        self.M: Any = 0.0  # kg: mass of the platform with its payload
        self.R_0: Any = [0.0] * 3  # m: center of mass of the platform, platform frame
        # kg m^2: inertia of the platform about its center of mass, platform frame
        self.I_p: Any = [0.0] * 6
        # kg m: first moment of the mass M_P about the reference point, platform frame
        self.h_P: Any = [0.0] * 3
        # kg m^2: inertia of the mass M_P about the reference point, platform frame
        self.J_P: Any = [0.0] * 6


class Model:
    """A robot's constants, prepared once."""

    def __init__(self) -> None:
        self.leg: Any = [LegConstants() for _ in range(6)]  # the legs
        self.platform: Any = Platform()  # the platform
        self.per_length: Any = 0.0  # 1/m: one over the length over which moments are taken
        self.arm_cube: Any = 0.0  # cube of the largest arm over that length
        self.status: Any = 0  # 0, or the code of an error


class Forces:
    """Actuator forces of one pose."""

    def __init__(self) -> None:
        self.F: Any = [0.0] * 6  # N: positive when they extend the leg, (37)
        self.status: Any = 0  # 0, or the code of an error


class LegTerms:
    """Terms of one leg."""

    def __init__(self) -> None:
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis
        self.D: Any = 0.0  # N: known part of the actuator force
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.c_force: Any = [0.0] * 3  # N: part of c, force rows, base frame
        self.c_moment: Any = [0.0] * 3  # N m: part of c, moment rows, base frame


class Sums:
    """H, c, and what moments are made with."""

    def __init__(self) -> None:
        self.q_1: Any = [0.0] * 3  # m: platform point 1 from the reference point, base frame
        self.c: Any = [0.0] * 6  # N, N m: wrench that the axial forces balance, (36)
        self.leg: Any = [LegTerms() for _ in range(6)]  # the legs
        self.H: Any = [[0.0] * 6 for _ in range(6)]  # 1 and m: from x to the wrench on the platform, (36)
        self.arm: Any = [[0.0] * 3 for _ in range(6)]  # m: arms of the moments


class SharedTerms:
    """Terms of a pose that are common to all legs."""

    def __init__(self) -> None:
        self.B: Any = [0.0] * 9  # 1/s^2: [alpha]x + [omega]x [omega]x: S_ddot = B q + a
        self.c_force: Any = [0.0] * 3  # N: part of c, force rows, base frame
        self.c_moment: Any = [0.0] * 3  # N m: part of c, moment rows, base frame


class ShiftTerms:
    """The platform's part of c about platform point 1."""

    def __init__(self) -> None:
        self.c_tip: Any = [0.0] * 3  # N m: the platform's part of c, moment rows, about platform point 1


class MomentTerms:
    """A leg's moments about platform point 1."""

    def __init__(self) -> None:
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        # N m: moment of the leg's part of c, force rows, about platform point 1
        self.arm_c: Any = [0.0] * 3


class Equations:
    """M [a; alpha] + C [v; omega] + g + friction = H F + [R F_ext; R M_ext]."""

    def __init__(self) -> None:
        self.M: Any = [[0.0] * 6 for _ in range(6)]  # kg, kg m, kg m^2: inertia
        self.C: Any = [[0.0] * 6 for _ in range(6)]  # kg/s, kg m/s, kg m^2/s: Coriolis matrix
        self.g: Any = [0.0] * 6  # N, N m: gravity
        self.friction: Any = [0.0] * 6  # N, N m: friction
        self.bias: Any = [0.0] * 6  # N, N m: C [v; omega] + g
        self.bias_and_friction: Any = [0.0] * 6  # N, N m: C [v; omega] + g + friction
        self.H: Any = [[0.0] * 6 for _ in range(6)]  # 1 and m: from F to the wrench on the platform
        self.H_dot: Any = [[0.0] * 6 for _ in range(6)]  # 1/s and m/s: its rate
        self.status: Any = 0  # 0, or the code of an error


class LegInputs:
    """Inputs of the blocks of a leg."""

    def __init__(self) -> None:
        self.F: Any = 0.0  # N: actuator force of the leg
        # N, N m: generalized forces of the leg less the actuator's, along L, theta, phi
        self.net: Any = [0.0] * 3
        # m/s^2, 1/s^2: accelerations of L, theta, phi caused by the platform's accelerations only
        self.turned: Any = [0.0] * 3
        # 1: 0 for a leg near its joint singularity with little inertia about its own axis, else 1
        self.axial: Any = 0.0


class EquationsLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.C_vv: Any = [0.0] * 9  # kg/s: Coriolis matrix, force by v
        self.C_vw: Any = [0.0] * 9  # kg m/s: Coriolis matrix, force by omega
        self.C_wv: Any = [0.0] * 9  # kg m/s: Coriolis matrix, moment by v
        self.C_ww: Any = [0.0] * 9  # kg m^2/s: Coriolis matrix, moment by omega
        self.g_force: Any = [0.0] * 3  # N: gravity, force
        self.g_moment: Any = [0.0] * 3  # N m: gravity, moment
        self.friction_force: Any = [0.0] * 3  # N: friction, force
        self.friction_moment: Any = [0.0] * 3  # N m: friction, moment
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        self.H_dot_force: Any = [0.0] * 3  # 1/s: rate of the leg's column of H, force rows
        self.H_dot_moment: Any = [0.0] * 3  # m/s: rate of the leg's column of H, moment rows
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class EquationsLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [EquationsLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class EquationsSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.C_vv: Any = [0.0] * 9  # kg/s: Coriolis matrix, force by v
        self.C_vw: Any = [0.0] * 9  # kg m/s: Coriolis matrix, force by omega
        self.C_wv: Any = [0.0] * 9  # kg m/s: Coriolis matrix, moment by v
        self.C_ww: Any = [0.0] * 9  # kg m^2/s: Coriolis matrix, moment by omega
        self.g_force: Any = [0.0] * 3  # N: gravity, force
        self.g_moment: Any = [0.0] * 3  # N m: gravity, moment
        self.friction_force: Any = [0.0] * 3  # N: friction, force
        self.friction_moment: Any = [0.0] * 3  # N m: friction, moment


class EquationsPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.C_vv: Any = [0.0] * 9  # kg/s: Coriolis matrix, force by v
        self.C_vw: Any = [0.0] * 9  # kg m/s: Coriolis matrix, force by omega
        self.C_wv: Any = [0.0] * 9  # kg m/s: Coriolis matrix, moment by v
        self.C_ww: Any = [0.0] * 9  # kg m^2/s: Coriolis matrix, moment by omega
        self.g_force: Any = [0.0] * 3  # N: gravity, force
        self.g_moment: Any = [0.0] * 3  # N m: gravity, moment
        self.friction_force: Any = [0.0] * 3  # N: friction, force
        self.friction_moment: Any = [0.0] * 3  # N m: friction, moment


class BiasAndFriction:
    """C [v; omega] + g + friction."""

    def __init__(self) -> None:
        self.bias_and_friction: Any = [0.0] * 6  # N, N m: the sum
        self.status: Any = 0  # 0, or the code of an error


class BiasLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.bias_force: Any = [0.0] * 3  # N: C twist + g + friction, force
        self.bias_moment: Any = [0.0] * 3  # N m: C twist + g + friction, moment
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class BiasLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [BiasLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class BiasSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.bias_force: Any = [0.0] * 3  # N: C twist + g + friction, force
        self.bias_moment: Any = [0.0] * 3  # N m: C twist + g + friction, moment


class BiasPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.B_0: Any = [0.0] * 9  # 1/s^2: [omega]x [omega]x
        self.bias_force: Any = [0.0] * 3  # N: C twist + g + friction, force
        self.bias_moment: Any = [0.0] * 3  # N m: C twist + g + friction, moment


class Accelerations:
    """Accelerations of the platform."""

    def __init__(self) -> None:
        self.a: Any = [0.0] * 3  # m/s^2: acceleration of the reference point
        self.alpha: Any = [0.0] * 3  # rad/s^2: angular acceleration
        self.status: Any = 0  # 0, or the code of an error


class ForwardLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class ForwardLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [ForwardLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class ForwardSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment


class ForwardPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.B_0: Any = [0.0] * 9  # 1/s^2: [omega]x [omega]x
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment


class Rows:
    """M = A^T W A: three rows for each leg, by L, theta, phi, and six of the platform."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # inputs of the derivatives, one for each leg
        self.extent: Any = [0.0] * 24  # root of the inertia in each row
        self.weight: Any = [[0.0] * 3 for _ in range(24)]  # 1: W in blocks of three rows
        # A, each row times the root of its inertia; then L and U
        self.row: Any = [[0.0] * 6 for _ in range(24)]
        # each row as a sum of the six that serve as coordinates
        self.share: Any = [[0.0] * 6 for _ in range(24)]
        self.inertia: Any = [[0.0] * 6 for _ in range(6)]  # M in these coordinates
        self.order: Any = [0] * 24  # number of the row in each place
        self.column: Any = [0] * 6  # number of the column in each place
        self.length: Any = 0.0  # m: moments and rotations are measured by it


class Apart:
    """Result of the rows."""

    def __init__(self) -> None:
        self.x: Any = [0.0] * 6  # m/s^2, rad/s^2: a and alpha
        self.status: Any = 0  # 0, or the code of an error


class JointRowsLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment
        self.M_xi: Any = [0.0] * 6  # kg, kg m, kg m^2: inertia of the joint coordinates, rows L, theta, phi
        self.row_v: Any = [0.0] * 9  # 1, 1/m: gradients of L, theta, phi by position
        self.row_w: Any = [0.0] * 9  # m, 1: gradients of L, theta, phi by rotation
        # N, N m: generalized forces less the actuator's without accelerations of the platform
        self.tau: Any = [0.0] * 3
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class JointRowsLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [JointRowsLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class JointRowsSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment


class JointRowsPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.B_0: Any = [0.0] * 9  # 1/s^2: [omega]x [omega]x
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.right_force: Any = [0.0] * 3  # N: H F + external wrench - bias, force
        self.right_moment: Any = [0.0] * 3  # N m: H F + external wrench - bias, moment


class JointInertia:
    """Inertia that the actuators feel."""

    def __init__(self) -> None:
        self.inertia: Any = [[0.0] * 6 for _ in range(6)]  # kg: H^-1 M H^-T
        self.status: Any = 0  # 0, or the code of an error


class Derivatives:
    """Actuator forces and their derivatives."""

    def __init__(self) -> None:
        self.F: Any = [0.0] * 6  # N: of inverse dynamics
        self.by_pose: Any = [[0.0] * 6 for _ in range(6)]  # N/m, N: by [dt; dphi]
        self.by_twist: Any = [[0.0] * 6 for _ in range(6)]  # N s/m, N s: by [v; omega]
        self.by_acceleration: Any = [[0.0] * 6 for _ in range(6)]  # kg, kg m: by [a; alpha]
        self.status: Any = 0  # 0, or the code of an error


class DerivativesLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class DerivativesLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [DerivativesLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class DerivativesSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega


class DerivativesPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.B: Any = [0.0] * 9  # 1/s^2: [alpha]x + [omega]x [omega]x: S_ddot = B q + a
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega


class LinearizationResult:
    """Forward dynamics and its linearization."""

    def __init__(self) -> None:
        self.a: Any = [0.0] * 3  # m/s^2: acceleration of the reference point
        self.alpha: Any = [0.0] * 3  # rad/s^2: angular acceleration
        self.A: Any = [[0.0] * 12 for _ in range(12)]  # by [dt; dphi; dv; domega]
        self.B: Any = [[0.0] * 6 for _ in range(12)]  # by the actuator forces
        self.status: Any = 0  # 0, or the code of an error


class SlopesApart:
    """Result of the rows for a linearization."""

    def __init__(self) -> None:
        self.x: Any = [0.0] * 6  # m/s^2, rad/s^2: a and alpha
        self.A: Any = [[0.0] * 24 for _ in range(6)]  # the rows solved
        self.status: Any = 0  # 0, or the code of an error


class JointSlopesLeg:
    """A leg's part."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega
        self.tau_t: Any = [0.0] * 9  # N, N m per unit: generalized forces by dt, row for row
        self.tau_r: Any = [0.0] * 9  # N, N m per unit: generalized forces by dphi, row for row
        self.tau_v: Any = [0.0] * 9  # N, N m per unit: generalized forces by v, row for row
        self.tau_w: Any = [0.0] * 9  # N, N m per unit: generalized forces by omega, row for row
        self.H_force: Any = [0.0] * 3  # 1: the leg's column of H, force rows
        self.H_moment: Any = [0.0] * 3  # m: the leg's column of H, moment rows
        self.q: Any = [0.0] * 3  # m: platform point from the reference point, base frame
        self.L: Any = 0.0  # m: length of the leg
        self.k3: Any = 0.0  # 1: |k x s|, sine of the angle between the leg and the fixed axis


class JointSlopesLegs:
    """The legs."""

    def __init__(self) -> None:
        self.given: Any = [LegInputs() for _ in range(6)]  # what blocks are given
        self.leg: Any = [JointSlopesLeg() for _ in range(6)]  # their parts
        self.reach: Any = [0.0] * 6  # m: size of the vectors that each is the sum of
        self.leaning: Any = 0  # 1 where one is near its joint singularity
        self.status: Any = 0  # 0, or the code of an error


class JointSlopesSums:
    """Sums over the machine."""

    def __init__(self) -> None:
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega


class JointSlopesPose:
    """The pose's own part."""

    def __init__(self) -> None:
        self.B: Any = [0.0] * 9  # 1/s^2: [alpha]x + [omega]x [omega]x: S_ddot = B q + a
        self.M_vv: Any = [0.0] * 6  # kg: inertia, force by a
        self.M_vw: Any = [0.0] * 9  # kg m: inertia, force by alpha
        self.M_ww: Any = [0.0] * 6  # kg m^2: inertia, moment by alpha
        self.W_ft: Any = [0.0] * 9  # N/m: force by dt
        self.W_fr: Any = [0.0] * 9  # N: force by dphi
        self.W_mt: Any = [0.0] * 9  # N: moment by dt
        self.W_mr: Any = [0.0] * 9  # N m: moment by dphi
        self.W_fv: Any = [0.0] * 9  # N s/m: force by v
        self.W_fw: Any = [0.0] * 9  # N s: force by omega
        self.W_mv: Any = [0.0] * 9  # N s: moment by v
        self.W_mw: Any = [0.0] * 9  # N m s: moment by omega


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
    C_u, C_p, C_s = leg.C_u, leg.C_p, leg.C_s
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


def prepare_platform(on: Arithmetic, robot: Any, p_1: Any, total: Any) -> Any:
    """Constants of the platform: 102 (49 mul, 52 add, 1 div, 0 sqrt)."""
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
    c7 = r_C_y * r_C_y
    c8 = r_C_z * r_C_z
    c9 = M_P * r_C_x
    c10 = r_C_x * r_C_x
    out = Platform()
    out.M_P = M_P
    out.r_C = [r_C_x, r_C_y, r_C_z]
    out.J_C = [J_C_xx, J_C_xy, J_C_xz, J_C_yy, J_C_yz, J_C_zz]
    out.dJ_C = [J_C_zz - J_C_yy, J_C_xx - J_C_zz, J_C_yy - J_C_xx]
    out.C_P = C_add
    out.g = [g_x, g_y, g_z]
    out.M = M
    out.R_0 = [R_0_x, R_0_y, R_0_z]
    out.I_p = [I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz]
    out.h_P = [h_P_x, h_P_y, h_P_z]
    out.J_P = [
        J_C_xx + M_P * (c7 + c8),
        J_C_xy - c9 * r_C_y,
        J_C_xz - c9 * r_C_z,
        J_C_yy + M_P * (c10 + c8),
        J_C_yz - M_P * r_C_y * r_C_z,
        J_C_zz + M_P * (c10 + c7),
    ]
    return out


def add_up(on: Arithmetic, total: Any, more: Any) -> Any:
    """Add one leg to the contributions of the legs to the platform."""
    out = Added()
    out.M_add = total.M_add + more.M_add
    for i in range(3):
        out.h_add[i] = total.h_add[i] + more.h_add[i]
    for i in range(6):
        out.J_add[i] = total.J_add[i] + more.J_add[i]
    out.C_add = total.C_add + more.C_add
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


def size_of(on: Arithmetic, model: Any) -> Any:
    """Returns the largest coordinate (m) of the arms of moments about platform point 1."""
    largest = 0.0
    for j in range(3):
        for i in range(1, 6):
            largest = on.larger(on.size(model.leg[i].p[j] - model.leg[0].p[j]), largest)
    return largest


def per_length_of(on: Arithmetic, size: Any, smallest: Any) -> Any:
    """Returns the factor (1/m) of moments in the linear solver for arms whose largest coordinate is
    `size` (m). It is 1 from `smallest` to 16 m. Otherwise it is the reciprocal of the smallest power
    of two, from 2^-100 to 2^100, that is not below `size`.
    """
    per_length = 1.0
    if on.anywhere((size < smallest) | (size > on.LARGEST)):
        unit = 1.0
        for i in range(100):
            if on.anywhere(unit < size):
                unit = on.where(unit < size, 2.0 * unit, unit)
            else:
                break
        for i in range(100):
            if on.anywhere((size > 0.0) & (0.5 * unit >= size)):
                unit = on.where((size > 0.0) & (0.5 * unit >= size), 0.5 * unit, unit)
            else:
                break
        per_length = on.where((size < smallest) | (size > on.LARGEST), 1.0 / unit, 1.0)
    return per_length


def cube_of(on: Arithmetic, arm: Any) -> Any:
    """Returns the cube of a length; lengths above 2^40 are replaced by 2^40 to avoid overflow."""
    length = on.where(arm <= 1099511627776.0, arm, 1099511627776.0)
    return length * length * length


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
    """B and the platform's part of c, (7), (30)-(35): 180 (93 mul, 87 add, 0 div, 0 sqrt)."""
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
    C_P = platform.C_P
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
        M_P_load_x * R_xx + M_P_load_y * R_xy + M_P_load_z * R_xz + N_z * R_C_y - C_P * omega_x - N_y * R_C_z,
        M_P_load_x * R_yx + M_P_load_y * R_yy + M_P_load_z * R_yz + N_x * R_C_z - C_P * omega_y - N_z * R_C_x,
        M_P_load_x * R_zx + M_P_load_y * R_zy + M_P_load_z * R_zz + N_y * R_C_x - C_P * omega_z - N_x * R_C_y,
    ]
    return out


def shift(on: Arithmetic, sums: Any, shared: Any) -> Any:
    """The platform's part of c: 12 (6 mul, 6 add, 0 div, 0 sqrt)."""
    q_1_x, q_1_y, q_1_z = sums.q_1
    c_force_x, c_force_y, c_force_z = shared.c_force
    c_moment_x, c_moment_y, c_moment_z = shared.c_moment
    out = ShiftTerms()
    out.c_tip = [
        c_moment_x + c_force_y * q_1_z - c_force_z * q_1_y,
        c_moment_y + c_force_z * q_1_x - c_force_x * q_1_z,
        c_moment_z + c_force_x * q_1_y - c_force_y * q_1_x,
    ]
    return out


def eliminate(on: Arithmetic, A: Any, x: Any) -> Any:
    """Solves H x = c for x by elimination with partial pivoting, (36). Returns 1 if a pivot is small."""
    suspect = 0
    for k in range(6):
        for i in range(k + 1, 6):
            larger_below = on.size(A[i][k]) > on.size(A[k][k])
            for j in range(k, 7):
                above = A[k][j]
                A[k][j] = on.where(larger_below, A[i][j], A[k][j])
                A[i][j] = on.where(larger_below, above, A[i][j])
        suspect = on.where(on.size(A[k][k]) > on.SUSPECT, suspect, 1)
        x[k] = 1.0 / A[k][k]
        for i in range(k + 1, 6):
            factor = A[i][k] * x[k]
            for j in range(k + 1, 7):
                A[i][j] = A[i][j] - factor * A[k][j]
    for i in range(5, -1, -1):
        total = A[i][6]
        for j in range(i + 1, 6):
            total = total - A[i][j] * x[j]
        x[i] = on.where(i == 5, total / A[i][i], total * x[i])
    return suspect


def solve_legs(on: Arithmetic, A: Any, arm_cube: Any, x: Any) -> Any:
    """Solves [H | c] for x, (36), in two blocks of three legs, or by pivots if their determinants are
    small.

    Returns 1 if a pivot is small.
    """
    suspect = 0
    r_0_0 = A[1][3] * A[2][5] - A[2][3] * A[1][5]
    r_0_1 = A[2][3] * A[0][5] - A[0][3] * A[2][5]
    r_0_2 = A[0][3] * A[1][5] - A[1][3] * A[0][5]
    r_1_0 = A[1][5] * A[2][1] - A[2][5] * A[1][1]
    r_1_1 = A[2][5] * A[0][1] - A[0][5] * A[2][1]
    r_1_2 = A[0][5] * A[1][1] - A[1][5] * A[0][1]
    r_2_0 = A[1][1] * A[2][3] - A[2][1] * A[1][3]
    r_2_1 = A[2][1] * A[0][3] - A[0][1] * A[2][3]
    r_2_2 = A[0][1] * A[1][3] - A[1][1] * A[0][3]
    det = A[0][1] * r_0_0 + A[1][1] * r_0_1 + A[2][1] * r_0_2
    e_0_0 = r_0_0 * A[0][0] + r_0_1 * A[1][0] + r_0_2 * A[2][0]
    e_1_0 = r_1_0 * A[0][0] + r_1_1 * A[1][0] + r_1_2 * A[2][0]
    e_2_0 = r_2_0 * A[0][0] + r_2_1 * A[1][0] + r_2_2 * A[2][0]
    own_0_0 = det * A[3][0] - A[3][1] * e_0_0
    w_0_0 = own_0_0 - A[3][3] * e_1_0 - A[3][5] * e_2_0
    own_1_0 = det * A[4][0] - A[4][1] * e_0_0
    w_1_0 = own_1_0 - A[4][3] * e_1_0 - A[4][5] * e_2_0
    own_2_0 = det * A[5][0] - A[5][1] * e_0_0
    w_2_0 = own_2_0 - A[5][3] * e_1_0 - A[5][5] * e_2_0
    e_0_2 = r_0_0 * A[0][2] + r_0_1 * A[1][2] + r_0_2 * A[2][2]
    e_1_2 = r_1_0 * A[0][2] + r_1_1 * A[1][2] + r_1_2 * A[2][2]
    e_2_2 = r_2_0 * A[0][2] + r_2_1 * A[1][2] + r_2_2 * A[2][2]
    own_0_2 = det * A[3][2] - A[3][1] * e_0_2
    w_0_2 = own_0_2 - A[3][3] * e_1_2 - A[3][5] * e_2_2
    own_1_2 = det * A[4][2] - A[4][1] * e_0_2
    w_1_2 = own_1_2 - A[4][3] * e_1_2 - A[4][5] * e_2_2
    own_2_2 = det * A[5][2] - A[5][1] * e_0_2
    w_2_2 = own_2_2 - A[5][3] * e_1_2 - A[5][5] * e_2_2
    e_0_4 = r_0_0 * A[0][4] + r_0_1 * A[1][4] + r_0_2 * A[2][4]
    e_1_4 = r_1_0 * A[0][4] + r_1_1 * A[1][4] + r_1_2 * A[2][4]
    e_2_4 = r_2_0 * A[0][4] + r_2_1 * A[1][4] + r_2_2 * A[2][4]
    own_0_4 = det * A[3][4] - A[3][1] * e_0_4
    w_0_4 = own_0_4 - A[3][3] * e_1_4 - A[3][5] * e_2_4
    own_1_4 = det * A[4][4] - A[4][1] * e_0_4
    w_1_4 = own_1_4 - A[4][3] * e_1_4 - A[4][5] * e_2_4
    own_2_4 = det * A[5][4] - A[5][1] * e_0_4
    w_2_4 = own_2_4 - A[5][3] * e_1_4 - A[5][5] * e_2_4
    e_0_6 = r_0_0 * A[0][6] + r_0_1 * A[1][6] + r_0_2 * A[2][6]
    e_1_6 = r_1_0 * A[0][6] + r_1_1 * A[1][6] + r_1_2 * A[2][6]
    e_2_6 = r_2_0 * A[0][6] + r_2_1 * A[1][6] + r_2_2 * A[2][6]
    own_0_6 = det * A[3][6] - A[3][1] * e_0_6
    w_0_6 = own_0_6 - A[3][3] * e_1_6 - A[3][5] * e_2_6
    own_1_6 = det * A[4][6] - A[4][1] * e_0_6
    w_1_6 = own_1_6 - A[4][3] * e_1_6 - A[4][5] * e_2_6
    own_2_6 = det * A[5][6] - A[5][1] * e_0_6
    w_2_6 = own_2_6 - A[5][3] * e_1_6 - A[5][5] * e_2_6
    u_0_0 = w_1_2 * w_2_4 - w_2_2 * w_1_4
    u_0_1 = w_2_2 * w_0_4 - w_0_2 * w_2_4
    u_0_2 = w_0_2 * w_1_4 - w_1_2 * w_0_4
    u_1_0 = w_1_4 * w_2_0 - w_2_4 * w_1_0
    u_1_1 = w_2_4 * w_0_0 - w_0_4 * w_2_0
    u_1_2 = w_0_4 * w_1_0 - w_1_4 * w_0_0
    u_2_0 = w_1_0 * w_2_2 - w_2_0 * w_1_2
    u_2_1 = w_2_0 * w_0_2 - w_0_0 * w_2_2
    u_2_2 = w_0_0 * w_1_2 - w_1_0 * w_0_2
    complement = w_0_0 * u_0_0 + w_1_0 * u_0_1 + w_2_0 * u_0_2
    square_0 = e_0_0 * e_0_0 + e_0_2 * e_0_2 + e_0_4 * e_0_4
    square_1 = e_1_0 * e_1_0 + e_1_2 * e_1_2 + e_1_4 * e_1_4
    square_2 = e_2_0 * e_2_0 + e_2_2 * e_2_2 + e_2_4 * e_2_4
    det2 = det * det
    least = on.larger(on.size(det) * on.BLOCK_LEAST, on.BLOCK_SINGULAR) * (det2 * arm_cube)
    spread = square_0 + square_1 + square_2
    weak = on.where(spread > on.BLOCK_GROWTH * det2, 1.0, 0.0)
    weak = on.where(on.size(complement) <= least, 1.0, weak)
    inverse_det = 1.0 / (on.where(weak > 0.0, 1.0, det))
    inverse_complement = 1.0 / (on.where(weak > 0.0, 1.0, complement))
    x[0] = (u_0_0 * w_0_6 + u_0_1 * w_1_6 + u_0_2 * w_2_6) * inverse_complement
    x[2] = (u_1_0 * w_0_6 + u_1_1 * w_1_6 + u_1_2 * w_2_6) * inverse_complement
    x[4] = (u_2_0 * w_0_6 + u_2_1 * w_1_6 + u_2_2 * w_2_6) * inverse_complement
    x[1] = (e_0_6 - e_0_0 * x[0] - e_0_2 * x[2] - e_0_4 * x[4]) * inverse_det
    x[3] = (e_1_6 - e_1_0 * x[0] - e_1_2 * x[2] - e_1_4 * x[4]) * inverse_det
    x[5] = (e_2_6 - e_2_0 * x[0] - e_2_2 * x[2] - e_2_4 * x[4]) * inverse_det
    if on.anywhere(weak > 0.0):
        other = [0.0] * 6
        small = eliminate(on, A, other)
        for number in range(6):
            x[number] = on.where(weak > 0.0, other[number], x[number])
        suspect = on.where(weak > 0.0, small, suspect)
    return suspect


def leg_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 265 (156 mul, 105 add, 2 div,
    2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    bend = L_dot * theta_dot
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + gamma_n * w_k + C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y
        + omega_z * y_z) - M_phi_theta * phi_dot2 + bend * h2_x + M_mixed * phi_ddot + M_theta * theta_ddot)
    tau_k = (M_mixed_theta * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L + M_phi_theta * theta_dot)
        - bend * h2_y * k1 + M_phi * phi_ddot + M_mixed * theta_ddot)
    # (21) K = Q_k k + Q_y y, with a component along s
    Q_k = -inv_rho * tau_y
    Q_y = inv_rho * tau_k
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_k * k_x
    K_y = Q_y * y_y + Q_k * k_y
    K_z = Q_y * y_z + Q_k * k_z
    # (24) known part of the actuator force for this K
    D = C_p * L_dot - h_x * theta_dot2 - M_phi_L * phi_dot2 + h_z * theta_ddot - k3_h * phi_ddot - Q_k * k1
    c1 = C_s * phi_dot
    c2 = C_s * theta_dot
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c1 * k_x + c2 * y_x, c1 * k_y + c2 * y_y, c1 * k_z + c2 * y_z]
    return out


def largest_component(on: Arithmetic, vector: Any, least: Any) -> Any:
    """Returns the largest of ``least`` and the magnitudes of a vector's components."""
    most = least
    for j in range(3):
        most = on.larger(on.size(vector[j]), most)
    return most


def reach_of(on: Arithmetic, b: Any, t: Any, q: Any) -> Any:
    """Returns the largest component (m) of the vectors q, t, and b, whose sum is a leg."""
    return largest_component(on, b, largest_component(on, t, largest_component(on, q, 0.0)))


def fault_of(on: Arithmetic, L: Any, k3: Any, reach: Any) -> Any:
    """Returns the status of a leg: not finite, short compared with the vectors in its sum, along k, or
    OK.
    """
    status = OK
    status = on.where((status != OK) | (L <= on.MAX), status, NOT_FINITE)
    status = on.where((status != OK) | ((L > on.ROUNDING * reach) & (L > on.SHORTEST)), status, ZERO_LENGTH)
    status = on.where((status != OK) | (k3 > on.JOINT_SINGULAR_SINE), status, JOINT_SINGULAR)
    return status


def singular_status(on: Arithmetic, H: Any, arm: Any, L: Any, reach: Any, tip: Any) -> Any:
    """Returns SINGULAR if H is singular to rounding, NOT_FINITE, or OK; H is overwritten.

    arm (m): moment arms; L (m): lengths of the legs; reach (m): largest component of the vectors
    whose sum is a leg. tip (m): largest component of the platform point from which the arms are
    measured, 0 for the reference point.

    Let Y be the inverse of H. The error of the direction s of a leg is at most 4 epsilon (reach / L +
    2). Each input and each operation is rounded by half a unit, and the elimination adds its own
    error. This error changes the column (s, arm x s) of H, and Y_force + Y_moment x arm is its factor
    for any center of moments. The rounding of the moment is added.

    G_ik bounds the effect of the error of column k on row i of Y H. If H minus its error is singular,
    no v > 0 satisfies G v < v, and the spectral radius of G is at least 1. v is computed by powers of
    G. The limit 1/2 covers the errors of Y.
    """
    Y = [[0.0] * 6 for _ in range(6)]
    G = [[0.0] * 6 for _ in range(6)]
    v = [0.0] * 6
    grown = [0.0] * 6
    extent = tip
    least = 1.0
    status = OK
    for i in range(6):
        v[i] = 1.0
        for j in range(3):
            extent = on.larger(on.size(arm[i][j]), extent)
    for i in range(6):
        for j in range(6):
            status = on.where((status != OK) | (on.size(H[i][j]) <= on.MAX), status, NOT_FINITE)
            H[i][j] = on.where(i < 3, H[i][j], H[i][j] / extent)
            Y[i][j] = on.where(i == j, 1.0, 0.0)
    for k in range(6):
        pivot = k
        most = on.size(H[k][k])
        for i in range(k + 1, 6):
            entry = on.size(H[i][k])
            pivot = on.where(entry > most, i, pivot)
            most = on.where(entry > most, entry, most)
        if on.anywhere(pivot != k):
            for j in range(6):
                moved = H[k][j]
                H[k][j] = on.at(H, pivot, j)
                on.put(H, moved, pivot, j)
                beside = Y[k][j]
                Y[k][j] = on.at(Y, pivot, j)
                on.put(Y, beside, pivot, j)
        status = on.where((status != OK) | (on.size(H[k][k]) > 0.0), status, SINGULAR)
        for i in range(6):
            if i != k:
                factor = H[i][k] / H[k][k]
                for j in range(6):
                    H[i][j] = H[i][j] - factor * H[k][j]
                    Y[i][j] = Y[i][j] - factor * Y[k][j]
    for i in range(6):
        by_moment = on.size(Y[i][3]) + on.size(Y[i][4]) + on.size(Y[i][5])
        for k in range(6):
            x = on.size(Y[i][0] + (Y[i][4] * arm[k][2] - Y[i][5] * arm[k][1]) / extent)
            y = on.size(Y[i][1] + (Y[i][5] * arm[k][0] - Y[i][3] * arm[k][2]) / extent)
            z = on.size(Y[i][2] + (Y[i][3] * arm[k][1] - Y[i][4] * arm[k][0]) / extent)
            turned = (x + y + z) * (reach[k] / L[k] + 2.0) + 2.0 * by_moment
            G[i][k] = turned * (4.0 * on.EPSILON) / on.size(H[i][i])
    for turn in range(4):
        if on.anywhere(least > 0.5):
            worst = 0.0
            greatest = 0.0
            for i in range(6):
                total = 0.0
                for k in range(6):
                    total = total + G[i][k] * v[k]
                share = total / v[i]
                worst = on.where(share <= worst, worst, share)
                greatest = on.larger(total, greatest)
                grown[i] = total
            least = on.where(worst <= least, worst, least)
            for i in range(6):
                v[i] = on.larger(grown[i] / greatest, on.EPSILON)
        else:
            break
    status = on.where((status != OK) | (least <= 0.5), status, SINGULAR)
    return status


def moments_of(on: Arithmetic, leg: Any, sums: Any) -> Any:
    """Moments of one leg: 21 (12 mul, 9 add, 0 div, 0 sqrt)."""
    q_x, q_y, q_z = leg.q
    q_1_x, q_1_y, q_1_z = sums.q_1
    H_force_x, H_force_y, H_force_z = leg.H_force
    c_force_x, c_force_y, c_force_z = leg.c_force
    # platform point from platform point 1
    arm_x = q_x - q_1_x
    arm_y = q_y - q_1_y
    arm_z = q_z - q_1_z
    out = MomentTerms()
    out.H_moment = [
        H_force_z * arm_y - H_force_y * arm_z,
        H_force_x * arm_z - H_force_z * arm_x,
        H_force_y * arm_x - H_force_x * arm_y,
    ]
    out.arm_c = [
        arm_y * c_force_z - arm_z * c_force_y,
        arm_z * c_force_x - arm_x * c_force_z,
        arm_x * c_force_y - arm_y * c_force_x,
    ]
    return out


def leg_near_terms(on: Arithmetic, leg: Any, platform: Any, motion: Any, shared: Any) -> Any:
    """One leg in joint coordinates: D, its column of H and its part of c: 289 (173 mul, 112 add, 2 div,
    2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    bend = L_dot * theta_dot
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + M_theta * own_theta_ddot
        + M_mixed * phi_ddot)
    tau_k = (M_mixed_theta * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot * (0.5
        * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_z * z_x
    K_y = Q_y * y_y + Q_z * z_y
    K_z = Q_y * y_z + Q_z * z_z
    # (24) known part of the actuator force for this K
    D = C_p * L_dot - h_x * theta_dot2 - M_phi_L * phi_dot2 + h_z * theta_ddot - k3_h * phi_ddot
    c4 = C_s * phi_dot
    c5 = C_s * theta_dot
    out = LegTerms()
    out.q = [q_x, q_y, q_z]
    out.L = L
    out.k3 = k3
    out.D = D
    out.H_force = [s_x, s_y, s_z]
    out.c_force = [-K_x, -K_y, -K_z]
    out.c_moment = [c4 * k_x + c5 * y_x, c4 * k_y + c5 * y_y, c4 * k_z + c5 * y_z]
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


def equations_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M, C, g and friction: 152 (93 mul, 59 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    M_P = platform.M_P
    h_P_x, h_P_y, h_P_z = platform.h_P
    J_P_xx, J_P_xy, J_P_xz, J_P_yy, J_P_yz, J_P_zz = platform.J_P
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy
        + J_P_yz * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz))
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    half_trace = 0.5 * J_base_xx + 0.5 * J_base_yy + 0.5 * J_base_zz
    c7 = J_base_xy * omega_z
    c8 = J_base_xz * omega_y
    c9 = half_trace * omega_z
    c10 = half_trace * omega_y
    c11 = -J_base_yz * omega_x
    c12 = half_trace * omega_x
    out = EquationsPose()
    out.M_vv = [M_P, 0.0, 0.0, M_P, 0.0, M_P]
    out.M_vw = [0.0, h_base_z, -h_base_y, -h_base_z, 0.0, h_base_x, h_base_y, -h_base_x, 0.0]
    out.M_ww = [J_base_xx, J_base_xy, J_base_xz, J_base_yy, J_base_yz, J_base_zz]
    out.C_vv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.C_vw = [0.0, w_h_z, -w_h_y, -w_h_z, 0.0, w_h_x, w_h_y, -w_h_x, 0.0]
    out.C_wv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.C_ww = [
        c8 - c7,
        c9 + J_base_yz * omega_y - J_base_yy * omega_z,
        J_base_zz * omega_y - c10 - J_base_yz * omega_z,
        J_base_xx * omega_z - c9 - J_base_xz * omega_x,
        c11 + c7,
        c12 + J_base_xz * omega_z - J_base_zz * omega_x,
        c10 + J_base_xy * omega_x - J_base_xx * omega_y,
        J_base_yy * omega_x - c12 - J_base_xy * omega_y,
        -c11 - c8,
    ]
    out.g_force = [-M_P * g_x, -M_P * g_y, -M_P * g_z]
    out.g_moment = [
        g_y * h_base_z - g_z * h_base_y,
        g_z * h_base_x - g_x * h_base_z,
        g_x * h_base_y - g_y * h_base_x,
    ]
    out.friction_force = [0.0, 0.0, 0.0]
    out.friction_moment = [C_P * omega_x, C_P * omega_y, C_P * omega_z]
    return out


def equations_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 678 (422 mul, 252
    add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    c3 = inv_L * inv_rho
    c4 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * c3
    m_leg_zz = M_theta * c4
    m_T_xs = m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yz * z_x + m_leg_yy * y_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yz * z_y + m_leg_yy * y_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yz * z_z + m_leg_yy * y_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xy * y_x + m_T_xz * z_x
    m_xy = m_T_xs * s_y + m_T_xy * y_y + m_T_xz * z_y
    m_xz = m_T_xs * s_z + m_T_xy * y_z + m_T_xz * z_z
    m_yy = m_T_ys * s_y + m_T_yy * y_y + m_T_yz * z_y
    m_yz = m_T_ys * s_z + m_T_yy * y_z + m_T_yz * z_z
    m_zz = m_T_zs * s_z + m_T_zy * y_z + m_T_zz * z_z
    c5 = h_x * theta_dot
    C_xi_12 = -c5
    c6 = c1 * h_x - h_z * k1 * k3
    C_xi_13 = -c6 * phi_dot
    C_xi_21 = c5
    C_xi_22 = L_dot * h_x
    c7 = 2.0 * L
    c8 = 2.0 * J_xz - c7 * h_z
    c9 = 0.5 * k1 * (2.0 * k3 * (J_zz - J_xx + c7 * h_x) + c8 * k1) - 0.5 * c1 * c8
    C_xi_23 = -c9 * phi_dot
    c10 = h_y * k1
    C_xi_31 = c6 * phi_dot - c10 * theta_dot
    C_xi_32 = theta_dot * (J_yz * k1 - c2 * k3) - L_dot * c10 + c9 * phi_dot
    C_xi_33 = L_dot * c6 + c9 * theta_dot
    c11 = k3 * phi_dot
    G_dot_12 = c11
    G_dot_21 = -inv_L * theta_dot
    c12 = k1 * phi_dot
    G_dot_22 = c12 * inv_L
    G_dot_23 = L_dot * c4
    G_dot_31 = -c11 * inv_rho
    G_dot_32 = -L_dot * c3 - inv_rho * kappa * theta_dot
    G_dot_33 = c12 * inv_rho
    C_leg_11 = G_dot_21 * h_z - G_dot_31 * k3_h
    C_leg_12 = C_xi_13 * inv_rho + G_dot_22 * h_z - G_dot_32 * k3_h
    C_leg_13 = G_dot_23 * h_z - C_xi_12 * inv_L - G_dot_33 * k3_h
    C_leg_21 = inv_rho * (G_dot_21 * M_mixed + C_xi_31 + G_dot_31 * M_phi)
    C_leg_22 = inv_rho * (C_xi_33 * inv_rho + G_dot_22 * M_mixed + G_dot_32 * M_phi - G_dot_12 * k3_h)
    C_leg_23 = inv_rho * (G_dot_23 * M_mixed + k3_h * theta_dot + G_dot_33 * M_phi - C_xi_32 * inv_L)
    C_leg_31 = -inv_L * (C_xi_21 + G_dot_21 * M_theta + G_dot_31 * M_mixed)
    C_leg_32 = -inv_L * (G_dot_12 * h_z + C_xi_23 * inv_rho + G_dot_22 * M_theta + G_dot_32 * M_mixed)
    C_leg_33 = -inv_L * (G_dot_23 * M_theta - C_xi_22 * inv_L - h_z * theta_dot + G_dot_33 * M_mixed)
    C_tip_T_xs = C_leg_11 * s_x + C_leg_21 * y_x + C_leg_31 * z_x
    C_tip_T_xy = C_leg_12 * s_x + C_leg_22 * y_x + C_leg_32 * z_x
    C_tip_T_xz = C_leg_13 * s_x + C_leg_23 * y_x + C_leg_33 * z_x
    C_tip_T_ys = C_leg_11 * s_y + C_leg_21 * y_y + C_leg_31 * z_y
    C_tip_T_yy = C_leg_12 * s_y + C_leg_22 * y_y + C_leg_32 * z_y
    C_tip_T_yz = C_leg_13 * s_y + C_leg_23 * y_y + C_leg_33 * z_y
    C_tip_T_zs = C_leg_11 * s_z + C_leg_21 * y_z + C_leg_31 * z_z
    C_tip_T_zy = C_leg_12 * s_z + C_leg_22 * y_z + C_leg_32 * z_z
    C_tip_T_zz = C_leg_13 * s_z + C_leg_23 * y_z + C_leg_33 * z_z
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
    c13 = C_tip_xy * q_z
    c14 = m_xy * w_q_z
    c15 = C_tip_xz * q_y
    c16 = m_xz * w_q_y
    C_q_xx = c16 - c14 + c15 - c13
    c17 = C_tip_xx * q_z
    C_q_xy = m_xx * w_q_z - m_xz * w_q_x + c17 - C_tip_xz * q_x
    c18 = C_tip_xx * q_y
    C_q_xz = m_xy * w_q_x - m_xx * w_q_y + C_tip_xy * q_x - c18
    c19 = C_tip_yy * q_z
    C_q_yx = m_yz * w_q_y - m_yy * w_q_z + C_tip_yz * q_y - c19
    c20 = C_tip_yx * q_z
    c21 = -C_tip_yz * q_x
    c22 = -m_yz * w_q_x
    C_q_yy = c14 + c22 + c20 + c21
    c23 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - m_xy * w_q_y - C_tip_yx * q_y - c23
    c24 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - m_yz * w_q_z - C_tip_zy * q_z - c24
    c25 = -C_tip_zz * q_x
    C_q_zy = m_xz * w_q_z - m_zz * w_q_x + C_tip_zx * q_z + c25
    c26 = C_tip_zx * q_y
    c27 = -C_tip_zy * q_x
    C_q_zz = -c16 - c22 - c26 - c27
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c28 = inv_L * (g_k * w_n + gamma_n * w_k)
    c29 = -gamma_n * w_y - gamma_y * w_n
    # force at the tip that balances gravity
    held_x = c29 * inv_rho * y_x - c28 * z_x
    held_y = c29 * inv_rho * y_y - c28 * z_y
    held_z = c29 * inv_rho * y_z - c28 * z_z
    c30 = L_dot * s_x
    c31 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c32 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c33 = L_dot * s_y
    c34 = L_dot * s_z
    # force at the tip that balances friction
    resistance_x = C_p * c30 + c31 * y_x - c32 * z_x
    resistance_y = C_p * c33 + c31 * y_y - c32 * z_y
    resistance_z = C_p * c34 + c31 * y_z - c32 * z_z
    # (3) derivative of s
    s_dot_x = inv_L * (S_dot_x - c30)
    s_dot_y = inv_L * (S_dot_y - c33)
    s_dot_z = inv_L * (S_dot_z - c34)
    c35 = m_xy * q_z
    c36 = m_xz * q_y
    c37 = -m_yz * q_x
    # m [q]x
    m_q_xx = c35 - c36
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c35 - c37
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c36 + c37
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
        c26 - c20,
        C_tip_zy * q_y - c19,
        -c24 - C_tip_yz * q_z,
        c17 - C_tip_zx * q_x,
        c13 + c27,
        c25 + C_tip_xz * q_z,
        C_tip_yx * q_x - c18,
        -c23 - C_tip_xy * q_y,
        -c15 - c21,
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


def equations_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(6):
        out.M_vv[i] = (pose.M_vv[i] + (legs.leg[0].M_vv[i] + legs.leg[1].M_vv[i] + (legs.leg[2].M_vv[i] + legs.leg[3].M_vv[i])
            + (legs.leg[4].M_vv[i] + legs.leg[5].M_vv[i])))
    for i in range(9):
        out.M_vw[i] = (pose.M_vw[i] + (legs.leg[0].M_vw[i] + legs.leg[1].M_vw[i] + (legs.leg[2].M_vw[i] + legs.leg[3].M_vw[i])
            + (legs.leg[4].M_vw[i] + legs.leg[5].M_vw[i])))
    for i in range(6):
        out.M_ww[i] = (pose.M_ww[i] + (legs.leg[0].M_ww[i] + legs.leg[1].M_ww[i] + (legs.leg[2].M_ww[i] + legs.leg[3].M_ww[i])
            + (legs.leg[4].M_ww[i] + legs.leg[5].M_ww[i])))
    for i in range(9):
        out.C_vv[i] = (pose.C_vv[i] + (legs.leg[0].C_vv[i] + legs.leg[1].C_vv[i] + (legs.leg[2].C_vv[i] + legs.leg[3].C_vv[i])
            + (legs.leg[4].C_vv[i] + legs.leg[5].C_vv[i])))
    for i in range(9):
        out.C_vw[i] = (pose.C_vw[i] + (legs.leg[0].C_vw[i] + legs.leg[1].C_vw[i] + (legs.leg[2].C_vw[i] + legs.leg[3].C_vw[i])
            + (legs.leg[4].C_vw[i] + legs.leg[5].C_vw[i])))
    for i in range(9):
        out.C_wv[i] = (pose.C_wv[i] + (legs.leg[0].C_wv[i] + legs.leg[1].C_wv[i] + (legs.leg[2].C_wv[i] + legs.leg[3].C_wv[i])
            + (legs.leg[4].C_wv[i] + legs.leg[5].C_wv[i])))
    for i in range(9):
        out.C_ww[i] = (pose.C_ww[i] + (legs.leg[0].C_ww[i] + legs.leg[1].C_ww[i] + (legs.leg[2].C_ww[i] + legs.leg[3].C_ww[i])
            + (legs.leg[4].C_ww[i] + legs.leg[5].C_ww[i])))
    for i in range(3):
        out.g_force[i] = (pose.g_force[i] + (legs.leg[0].g_force[i] + legs.leg[1].g_force[i] + (legs.leg[2].g_force[i]
            + legs.leg[3].g_force[i]) + (legs.leg[4].g_force[i] + legs.leg[5].g_force[i])))
    for i in range(3):
        out.g_moment[i] = (pose.g_moment[i] + (legs.leg[0].g_moment[i] + legs.leg[1].g_moment[i] + (legs.leg[2].g_moment[i]
            + legs.leg[3].g_moment[i]) + (legs.leg[4].g_moment[i] + legs.leg[5].g_moment[i])))
    for i in range(3):
        out.friction_force[i] = (pose.friction_force[i] + (legs.leg[0].friction_force[i] + legs.leg[1].friction_force[i]
            + (legs.leg[2].friction_force[i] + legs.leg[3].friction_force[i]) + (legs.leg[4].friction_force[i]
            + legs.leg[5].friction_force[i])))
    for i in range(3):
        out.friction_moment[i] = (pose.friction_moment[i] + (legs.leg[0].friction_moment[i] + legs.leg[1].friction_moment[i]
            + (legs.leg[2].friction_moment[i] + legs.leg[3].friction_moment[i]) + (legs.leg[4].friction_moment[i]
            + legs.leg[5].friction_moment[i])))


def equations_near(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M, C, g and friction, its column of H and the column's rate: 698 (426 mul, 268
    add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    c2 = h_z * inv_L
    c3 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -c2
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * c3
    m_T_xs = m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_leg_sz * z_z + m_leg_sy * y_z
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
    c4 = W_z * inv_L
    c5 = c4 * h_y
    c6 = c5 - c2 * theta_dot
    C_leg_11 = c6
    c7 = c4 * h_x
    c8 = L_dot * c3
    c9 = c8 * h_y
    c10 = inv_L * theta_dot
    c11 = c10 * h_y
    c12 = inv_k3 * k1
    c13 = W_z * c2
    C_leg_12 = c9 + c11 * c12 + 2.0 * c12 * c13 - c7
    c14 = c10 * h_x - c12 * c5
    C_leg_13 = c8 * h_z + c14
    c15 = c3 * theta_dot
    c16 = J_yz * c15
    c17 = J_xy * c15
    c18 = W_z * c3
    c19 = inv_k3 * inv_k3
    c20 = J_xx * c19
    c21 = 2.0 * J_xz
    c22 = c18 * c21
    c23 = J_xx - J_zz
    C_leg_21 = (W_z * c23 * c3 - c16 - c12 * c17 - c18 * c20 - c7 + W_z * h_z * inv_L * inv_k3 * k1 - c12 * c22)
    c24 = J_xy * c18
    c25 = c8 * h_x
    c26 = c19 * c5
    c27 = inv_L * inv_L * inv_L
    c28 = L_dot * c27
    c29 = J_xz * c19
    c30 = c12 * c28
    c31 = J_yz * c18
    c32 = c12 * c31
    c33 = c19 * c24
    c34 = J_xx * k1 * inv_k3 * inv_k3 * inv_k3
    C_leg_22 = (L_dot * c23 * c27 - c20 * c28 - c25 + L_dot * c3 * h_z * inv_k3 * k1 - c21 * c30 + c19 * h_z
        * inv_L * theta_dot - c15 * c29 - c15 * c34 + c32 + c33 - c24 - c26)
    c35 = c12 * c16
    c36 = J_yz * c28 + J_xy * c30 + c18 * c29 - c13 * c19
    C_leg_23 = c17 + c18 * c34 - c35 + c36
    C_leg_31 = J_yy * c15 + c31 + c12 * c24 + c14
    C_leg_32 = (c11 - c12 * c9 + c13 + c17 * c19 + c35 - c17 - c11 * c19 + c12 * c18 * (-J_yy - c23) - c22 + c36)
    C_leg_33 = c24 - J_yy * c28 - c25 + c26 - c32 - c33 - c6
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
    c37 = C_tip_xy * q_z
    c38 = m_xy * w_q_z
    c39 = C_tip_xz * q_y
    c40 = m_xz * w_q_y
    C_q_xx = c40 - c38 + c39 - c37
    c41 = C_tip_xx * q_z
    C_q_xy = m_xx * w_q_z - m_xz * w_q_x + c41 - C_tip_xz * q_x
    c42 = C_tip_xx * q_y
    C_q_xz = m_xy * w_q_x - m_xx * w_q_y + C_tip_xy * q_x - c42
    c43 = C_tip_yy * q_z
    C_q_yx = m_yz * w_q_y - m_yy * w_q_z + C_tip_yz * q_y - c43
    c44 = C_tip_yx * q_z
    c45 = -C_tip_yz * q_x
    c46 = -m_yz * w_q_x
    C_q_yy = c38 + c46 + c44 + c45
    c47 = -C_tip_yy * q_x
    C_q_yz = m_yy * w_q_x - m_xy * w_q_y - C_tip_yx * q_y - c47
    c48 = -C_tip_zz * q_y
    C_q_zx = m_zz * w_q_y - m_yz * w_q_z - C_tip_zy * q_z - c48
    c49 = -C_tip_zz * q_x
    C_q_zy = m_xz * w_q_z - m_zz * w_q_x + C_tip_zx * q_z + c49
    c50 = C_tip_zx * q_y
    c51 = -C_tip_zy * q_x
    C_q_zz = -c40 - c46 - c50 - c51
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    c52 = inv_L * (g_k * w_n + gamma_n * w_k)
    c53 = -gamma_n * w_y - gamma_y * w_n
    # force at the tip that balances gravity
    held_x = c53 * inv_rho * y_x - c52 * z_x
    held_y = c53 * inv_rho * y_y - c52 * z_y
    held_z = c53 * inv_rho * y_z - c52 * z_z
    c54 = L_dot * s_x
    c55 = inv_rho * (C_us * phi_dot - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z))
    c56 = inv_L * (C_us * theta_dot - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z))
    c57 = L_dot * s_y
    c58 = L_dot * s_z
    # force at the tip that balances friction
    resistance_x = C_p * c54 + c55 * y_x - c56 * z_x
    resistance_y = C_p * c57 + c55 * y_y - c56 * z_y
    resistance_z = C_p * c58 + c55 * y_z - c56 * z_z
    # (3) derivative of s
    s_dot_x = inv_L * (S_dot_x - c54)
    s_dot_y = inv_L * (S_dot_y - c57)
    s_dot_z = inv_L * (S_dot_z - c58)
    c59 = m_xy * q_z
    c60 = m_xz * q_y
    c61 = -m_yz * q_x
    # m [q]x
    m_q_xx = c59 - c60
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c59 - c61
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c60 + c61
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
        c50 - c44,
        C_tip_zy * q_y - c43,
        -c48 - C_tip_yz * q_z,
        c41 - C_tip_zx * q_x,
        c37 + c51,
        c49 + C_tip_xz * q_z,
        C_tip_yx * q_x - c42,
        -c47 - C_tip_xy * q_y,
        -c39 - c45,
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


def place_symmetric_6(on: Arithmetic, parts: Any, row: Any, column: Any, A: Any) -> None:
    """A symmetric 3 x 3 block from xx xy xz yy yz zz."""
    for i in range(3):
        A[row][column + i] = parts[i]
        A[row + i][column] = parts[i]
    A[row + 1][column + 1] = parts[3]
    A[row + 1][column + 2] = parts[4]
    A[row + 2][column + 1] = parts[4]
    A[row + 2][column + 2] = parts[5]


def place_inertia_6(on: Arithmetic, vv: Any, vw: Any, ww: Any, first: Any, A: Any) -> None:
    """M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz
    zz.
    """
    for i in range(3):
        for j in range(3):
            A[i][first + j + 3] = vw[3 * i + j]
            A[j + 3][first + i] = vw[3 * i + j]
    place_symmetric_6(on, vv, 0, first, A)
    place_symmetric_6(on, ww, 3, first + 3, A)


def place_blocks_6(on: Arithmetic, vv: Any, vw: Any, wv: Any, ww: Any, first: Any, A: Any) -> None:
    """Four 3 x 3 blocks, whose rows are ``ROW`` numbers apart, into six columns from ``first`` on."""
    for i in range(3):
        for j in range(3):
            A[i][first + j] = vv[3 * i + j]
            A[i][first + j + 3] = vw[3 * i + j]
            A[i + 3][first + j] = wv[3 * i + j]
            A[i + 3][first + j + 3] = ww[3 * i + j]


def check_equations(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.M[i][j]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.C[i][j]
    for i in range(6):
        lost = lost + 0.0 * out.g[i]
    for i in range(6):
        lost = lost + 0.0 * out.friction[i]
    for i in range(6):
        lost = lost + 0.0 * out.bias[i]
    for i in range(6):
        lost = lost + 0.0 * out.bias_and_friction[i]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.H[i][j]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.H_dot[i][j]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(6):
        for j in range(6):
            out.M[i][j] = on.where(out.status == OK, out.M[i][j], on.NAN)
    for i in range(6):
        for j in range(6):
            out.C[i][j] = on.where(out.status == OK, out.C[i][j], on.NAN)
    for i in range(6):
        out.g[i] = on.where(out.status == OK, out.g[i], on.NAN)
    for i in range(6):
        out.friction[i] = on.where(out.status == OK, out.friction[i], on.NAN)
    for i in range(6):
        out.bias[i] = on.where(out.status == OK, out.bias[i], on.NAN)
    for i in range(6):
        out.bias_and_friction[i] = on.where(out.status == OK, out.bias_and_friction[i], on.NAN)
    for i in range(6):
        for j in range(6):
            out.H[i][j] = on.where(out.status == OK, out.H[i][j], on.NAN)
    for i in range(6):
        for j in range(6):
            out.H_dot[i][j] = on.where(out.status == OK, out.H_dot[i][j], on.NAN)


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


def bias_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of C twist + g + friction: 165 (99 mul, 66 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    M_P = platform.M_P
    h_P_x, h_P_y, h_P_z = platform.h_P
    J_P_xx, J_P_xy, J_P_xz, J_P_yy, J_P_yz, J_P_zz = platform.J_P
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy
        + J_P_yz * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz))
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + J_base_xy * omega_y + J_base_xz * omega_z
    J_w_y = J_base_xy * omega_x + J_base_yy * omega_y + J_base_yz * omega_z
    J_w_z = J_base_xz * omega_x + J_base_yz * omega_y + J_base_zz * omega_z
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    out = BiasPose()
    out.B_0 = [B_xx, omega_xy, omega_xz, omega_xy, B_yy, omega_yz, omega_xz, omega_yz, B_zz]
    out.bias_force = [
        omega_y * w_h_z - M_P * g_x - omega_z * w_h_y,
        omega_z * w_h_x - M_P * g_y - omega_x * w_h_z,
        omega_x * w_h_y - M_P * g_z - omega_y * w_h_x,
    ]
    out.bias_moment = [
        C_P * omega_x + J_w_z * omega_y + g_y * h_base_z - J_w_y * omega_z - g_z * h_base_y,
        C_P * omega_y + J_w_x * omega_z + g_z * h_base_x - J_w_z * omega_x - g_x * h_base_z,
        C_P * omega_z + J_w_y * omega_x + g_x * h_base_y - J_w_x * omega_y - g_y * h_base_x,
    ]
    return out


def bias_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of C twist + g + friction: 315 (190 mul, 121 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    bend = L_dot * theta_dot
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + M_theta * own_theta_ddot
        + M_mixed * phi_ddot)
    tau_k = (M_mixed_theta * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot * (0.5
        * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_z * z_x
    K_y = Q_y * y_y + Q_z * z_y
    K_z = Q_y * y_z + Q_z * z_z
    # (24) known part of the actuator force for this K
    D = C_p * L_dot - h_x * theta_dot2 - M_phi_L * phi_dot2 + h_z * theta_ddot - k3_h * phi_ddot
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


def bias_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(3):
        out.bias_force[i] = (pose.bias_force[i] + (legs.leg[0].bias_force[i] + legs.leg[1].bias_force[i] + (legs.leg[2].bias_force[i]
            + legs.leg[3].bias_force[i]) + (legs.leg[4].bias_force[i] + legs.leg[5].bias_force[i])))
    for i in range(3):
        out.bias_moment[i] = (pose.bias_moment[i] + (legs.leg[0].bias_moment[i] + legs.leg[1].bias_moment[i]
            + (legs.leg[2].bias_moment[i] + legs.leg[3].bias_moment[i]) + (legs.leg[4].bias_moment[i] + legs.leg[5].bias_moment[i])))


def bias_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = bias_pose(on, model.platform, motion)
    bias_legs(on, model, motion, pose, legs)
    bias_total(on, pose, legs, summed)


def check_bias_and_friction(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(6):
        lost = lost + 0.0 * out.bias_and_friction[i]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(6):
        out.bias_and_friction[i] = on.where(out.status == OK, out.bias_and_friction[i], on.NAN)


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


def forward_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M and of the right side: 201 (117 mul, 84 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    M_P = platform.M_P
    h_P_x, h_P_y, h_P_z = platform.h_P
    J_P_xx, J_P_xy, J_P_xz, J_P_yy, J_P_yz, J_P_zz = platform.J_P
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy
        + J_P_yz * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz))
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + J_base_xy * omega_y + J_base_xz * omega_z
    J_w_y = J_base_xy * omega_x + J_base_yy * omega_y + J_base_yz * omega_z
    J_w_z = J_base_xz * omega_x + J_base_yz * omega_y + J_base_zz * omega_z
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    out = ForwardPose()
    out.B_0 = [B_xx, omega_xy, omega_xz, omega_xy, B_yy, omega_yz, omega_xz, omega_yz, B_zz]
    out.M_vv = [M_P, 0.0, 0.0, M_P, 0.0, M_P]
    out.M_vw = [0.0, h_base_z, -h_base_y, -h_base_z, 0.0, h_base_x, h_base_y, -h_base_x, 0.0]
    out.M_ww = [J_base_xx, J_base_xy, J_base_xz, J_base_yy, J_base_yz, J_base_zz]
    out.right_force = [
        F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz + M_P * g_x + omega_z * w_h_y - omega_y * w_h_z,
        F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz + M_P * g_y + omega_x * w_h_z - omega_z * w_h_x,
        F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz + M_P * g_z + omega_y * w_h_x - omega_x * w_h_y,
    ]
    out.right_moment = [
        J_w_y * omega_z + M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz + g_z * h_base_y - C_P * omega_x
            - J_w_z * omega_y - g_y * h_base_z,
        J_w_z * omega_x + M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz + g_x * h_base_z - C_P * omega_y
            - J_w_x * omega_z - g_z * h_base_x,
        J_w_x * omega_y + M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz + g_y * h_base_x - C_P * omega_z
            - J_w_y * omega_x - g_x * h_base_y,
    ]
    return out


def forward_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of M and of the right side: 435 (267 mul, 164 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    bend = L_dot * theta_dot
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c3 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + M_theta * own_theta_ddot
        + M_mixed * phi_ddot)
    tau_k = (M_mixed_theta * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot * (0.5
        * J2_xz - 0.5 * c2 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
    # (21) K = Q_y y + Q_z z
    Q_y = inv_rho * tau_k
    Q_z = -inv_L * tau_y
    # (21) force at the spherical joint, base frame
    K_x = Q_y * y_x + Q_z * z_x
    K_y = Q_y * y_y + Q_z * z_y
    K_z = Q_y * y_z + Q_z * z_z
    # (24) known part of the actuator force for this K
    D = C_p * L_dot - h_x * theta_dot2 - M_phi_L * phi_dot2 + h_z * theta_ddot - k3_h * phi_ddot
    c4 = F - D
    # force on the platform at the tip
    push_x = c4 * s_x - K_x
    push_y = c4 * s_y - K_y
    push_z = c4 * s_z - K_z
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * inv_L * inv_L
    m_T_xs = m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_leg_sz * z_z + m_leg_sy * y_z
    m_T_zy = m_leg_sy * s_z + m_leg_yy * y_z + m_leg_yz * z_z
    m_T_zz = m_leg_sz * s_z + m_leg_zz * z_z + m_leg_yz * y_z
    # inertia at the tip, base frame
    m_xx = m_T_xs * s_x + m_T_xz * z_x + m_T_xy * y_x
    m_xy = m_T_xs * s_y + m_T_xz * z_y + m_T_xy * y_y
    m_xz = m_T_xs * s_z + m_T_xz * z_z + m_T_xy * y_z
    m_yy = m_T_ys * s_y + m_T_yz * z_y + m_T_yy * y_y
    m_yz = m_T_ys * s_z + m_T_yz * z_z + m_T_yy * y_z
    m_zz = m_T_zs * s_z + m_T_zz * z_z + m_T_zy * y_z
    c5 = m_xy * q_z
    c6 = m_xz * q_y
    c7 = -m_yz * q_x
    # m [q]x
    m_q_xx = c5 - c6
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c5 - c7
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c6 + c7
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


def forward_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(6):
        out.M_vv[i] = (pose.M_vv[i] + (legs.leg[0].M_vv[i] + legs.leg[1].M_vv[i] + (legs.leg[2].M_vv[i] + legs.leg[3].M_vv[i])
            + (legs.leg[4].M_vv[i] + legs.leg[5].M_vv[i])))
    for i in range(9):
        out.M_vw[i] = (pose.M_vw[i] + (legs.leg[0].M_vw[i] + legs.leg[1].M_vw[i] + (legs.leg[2].M_vw[i] + legs.leg[3].M_vw[i])
            + (legs.leg[4].M_vw[i] + legs.leg[5].M_vw[i])))
    for i in range(6):
        out.M_ww[i] = (pose.M_ww[i] + (legs.leg[0].M_ww[i] + legs.leg[1].M_ww[i] + (legs.leg[2].M_ww[i] + legs.leg[3].M_ww[i])
            + (legs.leg[4].M_ww[i] + legs.leg[5].M_ww[i])))
    for i in range(3):
        out.right_force[i] = (pose.right_force[i] + (legs.leg[0].right_force[i] + legs.leg[1].right_force[i]
            + (legs.leg[2].right_force[i] + legs.leg[3].right_force[i]) + (legs.leg[4].right_force[i] + legs.leg[5].right_force[i])))
    for i in range(3):
        out.right_moment[i] = (pose.right_moment[i] + (legs.leg[0].right_moment[i] + legs.leg[1].right_moment[i]
            + (legs.leg[2].right_moment[i] + legs.leg[3].right_moment[i]) + (legs.leg[4].right_moment[i] + legs.leg[5].right_moment[i])))


def forward_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = forward_pose(on, model.platform, motion)
    forward_legs(on, model, motion, pose, legs)
    forward_total(on, pose, legs, summed)


def accelerations_of(on: Arithmetic, legs: Any, summed: Any, out: Any) -> None:
    """The accelerations of a pose; MASS_MATRIX_INDEFINITE if elimination loses too many digits of M."""
    status = OK
    y_0 = summed.right_force[0]
    a_0_0, a_0_1, a_0_2 = summed.M_vv[0], summed.M_vv[1], summed.M_vv[2]
    a_0_3, a_0_4, a_0_5 = summed.M_vw[0], summed.M_vw[1], summed.M_vw[2]
    y_1 = summed.right_force[1]
    a_1_1 = summed.M_vv[3]
    a_1_2 = summed.M_vv[4]
    a_1_3 = summed.M_vw[3]
    a_1_4 = summed.M_vw[4]
    a_1_5 = summed.M_vw[5]
    y_2 = summed.right_force[2]
    a_2_2 = summed.M_vv[5]
    a_2_3 = summed.M_vw[6]
    a_2_4 = summed.M_vw[7]
    a_2_5 = summed.M_vw[8]
    y_3 = summed.right_moment[0]
    a_3_3 = summed.M_ww[0]
    a_3_4 = summed.M_ww[1]
    a_3_5 = summed.M_ww[2]
    y_4 = summed.right_moment[1]
    a_4_4 = summed.M_ww[3]
    a_4_5 = summed.M_ww[4]
    y_5 = summed.right_moment[2]
    a_5_5 = summed.M_ww[5]
    fault = on.where(on.size(a_0_0) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_0_0 > on.KEPT * summed.M_vv[0], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_0 = 1.0 / a_0_0
    factor_0_1 = a_0_1 * inverse_0
    a_1_1 = a_1_1 - factor_0_1 * a_0_1
    a_1_2 = a_1_2 - factor_0_1 * a_0_2
    a_1_3 = a_1_3 - factor_0_1 * a_0_3
    a_1_4 = a_1_4 - factor_0_1 * a_0_4
    a_1_5 = a_1_5 - factor_0_1 * a_0_5
    y_1 = y_1 - factor_0_1 * y_0
    factor_0_2 = a_0_2 * inverse_0
    a_2_2 = a_2_2 - factor_0_2 * a_0_2
    a_2_3 = a_2_3 - factor_0_2 * a_0_3
    a_2_4 = a_2_4 - factor_0_2 * a_0_4
    a_2_5 = a_2_5 - factor_0_2 * a_0_5
    y_2 = y_2 - factor_0_2 * y_0
    factor_0_3 = a_0_3 * inverse_0
    a_3_3 = a_3_3 - factor_0_3 * a_0_3
    a_3_4 = a_3_4 - factor_0_3 * a_0_4
    a_3_5 = a_3_5 - factor_0_3 * a_0_5
    y_3 = y_3 - factor_0_3 * y_0
    factor_0_4 = a_0_4 * inverse_0
    a_4_4 = a_4_4 - factor_0_4 * a_0_4
    a_4_5 = a_4_5 - factor_0_4 * a_0_5
    y_4 = y_4 - factor_0_4 * y_0
    factor_0_5 = a_0_5 * inverse_0
    a_5_5 = a_5_5 - factor_0_5 * a_0_5
    y_5 = y_5 - factor_0_5 * y_0
    fault = on.where(on.size(a_1_1) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_1_1 > on.KEPT * summed.M_vv[3], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_1 = 1.0 / a_1_1
    factor_1_2 = a_1_2 * inverse_1
    a_2_2 = a_2_2 - factor_1_2 * a_1_2
    a_2_3 = a_2_3 - factor_1_2 * a_1_3
    a_2_4 = a_2_4 - factor_1_2 * a_1_4
    a_2_5 = a_2_5 - factor_1_2 * a_1_5
    y_2 = y_2 - factor_1_2 * y_1
    factor_1_3 = a_1_3 * inverse_1
    a_3_3 = a_3_3 - factor_1_3 * a_1_3
    a_3_4 = a_3_4 - factor_1_3 * a_1_4
    a_3_5 = a_3_5 - factor_1_3 * a_1_5
    y_3 = y_3 - factor_1_3 * y_1
    factor_1_4 = a_1_4 * inverse_1
    a_4_4 = a_4_4 - factor_1_4 * a_1_4
    a_4_5 = a_4_5 - factor_1_4 * a_1_5
    y_4 = y_4 - factor_1_4 * y_1
    factor_1_5 = a_1_5 * inverse_1
    a_5_5 = a_5_5 - factor_1_5 * a_1_5
    y_5 = y_5 - factor_1_5 * y_1
    fault = on.where(on.size(a_2_2) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_2_2 > on.KEPT * summed.M_vv[5], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_2 = 1.0 / a_2_2
    factor_2_3 = a_2_3 * inverse_2
    a_3_3 = a_3_3 - factor_2_3 * a_2_3
    a_3_4 = a_3_4 - factor_2_3 * a_2_4
    a_3_5 = a_3_5 - factor_2_3 * a_2_5
    y_3 = y_3 - factor_2_3 * y_2
    factor_2_4 = a_2_4 * inverse_2
    a_4_4 = a_4_4 - factor_2_4 * a_2_4
    a_4_5 = a_4_5 - factor_2_4 * a_2_5
    y_4 = y_4 - factor_2_4 * y_2
    factor_2_5 = a_2_5 * inverse_2
    a_5_5 = a_5_5 - factor_2_5 * a_2_5
    y_5 = y_5 - factor_2_5 * y_2
    fault = on.where(on.size(a_3_3) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_3_3 > on.KEPT * summed.M_ww[0], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_3 = 1.0 / a_3_3
    factor_3_4 = a_3_4 * inverse_3
    a_4_4 = a_4_4 - factor_3_4 * a_3_4
    a_4_5 = a_4_5 - factor_3_4 * a_3_5
    y_4 = y_4 - factor_3_4 * y_3
    factor_3_5 = a_3_5 * inverse_3
    a_5_5 = a_5_5 - factor_3_5 * a_3_5
    y_5 = y_5 - factor_3_5 * y_3
    fault = on.where(on.size(a_4_4) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_4_4 > on.KEPT * summed.M_ww[3], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_4 = 1.0 / a_4_4
    factor_4_5 = a_4_5 * inverse_4
    a_5_5 = a_5_5 - factor_4_5 * a_4_5
    y_5 = y_5 - factor_4_5 * y_4
    fault = on.where(on.size(a_5_5) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
    fault = on.where(a_5_5 > on.KEPT * summed.M_ww[5], OK, fault)
    status = on.where(status == OK, fault, status)
    inverse_5 = 1.0 / a_5_5
    x_5 = y_5 * inverse_5
    x_4 = y_4 * inverse_4
    x_4 = x_4 - factor_4_5 * x_5
    x_3 = y_3 * inverse_3
    x_3 = x_3 - factor_3_5 * x_5
    x_3 = x_3 - factor_3_4 * x_4
    x_2 = y_2 * inverse_2
    x_2 = x_2 - factor_2_5 * x_5
    x_2 = x_2 - factor_2_4 * x_4
    x_2 = x_2 - factor_2_3 * x_3
    x_1 = y_1 * inverse_1
    x_1 = x_1 - factor_1_5 * x_5
    x_1 = x_1 - factor_1_4 * x_4
    x_1 = x_1 - factor_1_3 * x_3
    x_1 = x_1 - factor_1_2 * x_2
    x_0 = y_0 * inverse_0
    x_0 = x_0 - factor_0_5 * x_5
    x_0 = x_0 - factor_0_4 * x_4
    x_0 = x_0 - factor_0_3 * x_3
    x_0 = x_0 - factor_0_2 * x_2
    x_0 = x_0 - factor_0_1 * x_1
    out.a[0] = x_0
    out.alpha[0] = x_3
    out.a[1] = x_1
    out.alpha[1] = x_4
    out.a[2] = x_2
    out.alpha[2] = x_5
    out.status = on.where(legs.status == OK, status, legs.status)


def check_forward_dynamics(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(3):
        lost = lost + 0.0 * out.a[i]
    for i in range(3):
        lost = lost + 0.0 * out.alpha[i]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(3):
        out.a[i] = on.where(out.status == OK, out.a[i], on.NAN)
    for i in range(3):
        out.alpha[i] = on.where(out.status == OK, out.alpha[i], on.NAN)


def joint_rows_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of M and of the right side: 222 (129 mul, 93 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    M = platform.M
    R_0_x, R_0_y, R_0_z = platform.R_0
    I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz = platform.I_p
    c1 = R_0_y * R_0_y
    c2 = R_0_z * R_0_z
    J_0_xx = I_p_xx + M * (c1 + c2)
    c3 = M * R_0_x
    J_0_xy = I_p_xy - R_0_y * c3
    J_0_xz = I_p_xz - R_0_z * c3
    c4 = R_0_x * R_0_x
    J_0_yy = I_p_yy + M * (c2 + c4)
    c5 = M * R_0_y
    J_0_yz = I_p_yz - R_0_z * c5
    J_0_zz = I_p_zz + M * (c1 + c4)
    c6 = M * R_0_z
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * c3 + R_xy * c5 + R_xz * c6
    h_base_y = R_yx * c3 + R_yy * c5 + R_yz * c6
    h_base_z = R_zx * c3 + R_zy * c5 + R_zz * c6
    c7 = J_0_xy * R_xy + J_0_xz * R_xz + J_0_xx * R_xx
    c8 = J_0_xy * R_xx + J_0_yz * R_xz + J_0_yy * R_xy
    c9 = J_0_xz * R_xx + J_0_yz * R_xy + J_0_zz * R_xz
    c10 = J_0_xy * R_yy + J_0_xz * R_yz + J_0_xx * R_yx
    c11 = J_0_xy * R_yx + J_0_yz * R_yz + J_0_yy * R_yy
    c12 = J_0_xz * R_yx + J_0_yz * R_yy + J_0_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c7 + R_xy * c8 + R_xz * c9
    J_base_xy = R_yx * c7 + R_yy * c8 + R_yz * c9
    J_base_xz = R_zx * c7 + R_zy * c8 + R_zz * c9
    J_base_yy = R_yx * c10 + R_yy * c11 + R_yz * c12
    J_base_yz = R_zx * c10 + R_zy * c11 + R_zz * c12
    J_base_zz = (R_zx * (J_0_xy * R_zy + J_0_xz * R_zz + J_0_xx * R_zx) + R_zy * (J_0_xy * R_zx + J_0_yz * R_zz
        + J_0_yy * R_zy) + R_zz * (J_0_xz * R_zx + J_0_yz * R_zy + J_0_zz * R_zz))
    # (31) omega x h
    w_h_x = h_base_z * omega_y - h_base_y * omega_z
    w_h_y = h_base_x * omega_z - h_base_z * omega_x
    w_h_z = h_base_y * omega_x - h_base_x * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + J_base_xy * omega_y + J_base_xz * omega_z
    J_w_y = J_base_xy * omega_x + J_base_yy * omega_y + J_base_yz * omega_z
    J_w_z = J_base_xz * omega_x + J_base_yz * omega_y + J_base_zz * omega_z
    # products of omega
    omega_xx = omega_x * omega_x
    omega_xy = omega_x * omega_y
    omega_xz = omega_x * omega_z
    omega_yy = omega_y * omega_y
    omega_yz = omega_y * omega_z
    omega_zz = omega_z * omega_z
    # (7) S_ddot = B q + a
    B_xx = -omega_yy - omega_zz
    B_yy = -omega_xx - omega_zz
    B_zz = -omega_xx - omega_yy
    out = JointRowsPose()
    out.B_0 = [B_xx, omega_xy, omega_xz, omega_xy, B_yy, omega_yz, omega_xz, omega_yz, B_zz]
    out.M_vv = [M, 0.0, 0.0, M, 0.0, M]
    out.M_vw = [0.0, h_base_z, -h_base_y, -h_base_z, 0.0, h_base_x, h_base_y, -h_base_x, 0.0]
    out.M_ww = [J_base_xx, J_base_xy, J_base_xz, J_base_yy, J_base_yz, J_base_zz]
    out.right_force = [
        F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz + M * g_x + omega_z * w_h_y - omega_y * w_h_z,
        F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz + M * g_y + omega_x * w_h_z - omega_z * w_h_x,
        F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz + M * g_z + omega_y * w_h_x - omega_x * w_h_y,
    ]
    out.right_moment = [
        J_w_y * omega_z + M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz + g_z * h_base_y - C_P * omega_x
            - J_w_z * omega_y - g_y * h_base_z,
        J_w_z * omega_x + M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz + g_x * h_base_z - C_P * omega_y
            - J_w_x * omega_z - g_z * h_base_x,
        J_w_x * omega_y + M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz + g_y * h_base_x - C_P * omega_z
            - J_w_y * omega_x - g_x * h_base_y,
    ]
    return out


def joint_rows_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's inertia and generalized forces in its joint coordinates, and their gradients: 341 (207
    mul, 130 add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_u, C_p, C_s = leg.m_u, leg.C_p, leg.C_s
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
    bend = L_dot * theta_dot
    # components of gravity along k x y and along y
    gamma_n = g_x_k_x * y_x + g_x_k_y * y_y + g_x_k_z * y_z
    gamma_y = g_x * y_x + g_y * y_y + g_z * y_z
    # components of the first moment along k and along -k x y
    w_k = k3 * w_z + k1 * w_x
    w_n = k3 * w_x - k1 * w_z
    # (20) generalized forces about y and about k
    tau_y = (L_ddot * h_z + g_k * w_n + phi_dot2 * (k13 * (J_yy - dJ_zx) - c7 * (0.5 - k33)) + C_us * theta_dot
        + bend * h2_x + gamma_n * w_k - C_s * (omega_x * y_x + omega_y * y_y + omega_z * y_z) + M_theta * own_theta_ddot
        + M_mixed * phi_ddot)
    tau_k = (M_mixed_theta * theta_dot2 - C_s * (k_x * omega_x + k_y * omega_y + k_z * omega_z) - L_ddot * k3_h
        + C_us * phi_dot - gamma_n * w_y - gamma_y * w_n + two_phi_dot * (L_dot * M_phi_L - theta_dot * (0.5
        * J2_xz - 0.5 * c6 + J_xx * kappa)) - bend * h2_y * k1 + M_mixed * theta_ddot + M_phi * own_phi_ddot)
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
    c8 = m_u * L * L
    c9 = L * m_u
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
    out.M_xi = [m_u, h_z, -k3_h, M_theta + c8, M_mixed, M_phi + c4 * c8]
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
        C_p * L_dot + fall_T_x * m_u + h_z * theta_ddot - F - M_phi_L * phi_dot2 - h_x * theta_dot2 - k3_h * phi_ddot,
        tau_y - c9 * fall_T_z,
        tau_k + c9 * fall_T_y * k3,
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


def joint_rows_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(6):
        out.M_vv[i] = (pose.M_vv[i] + (legs.leg[0].M_vv[i] + legs.leg[1].M_vv[i] + (legs.leg[2].M_vv[i] + legs.leg[3].M_vv[i])
            + (legs.leg[4].M_vv[i] + legs.leg[5].M_vv[i])))
    for i in range(9):
        out.M_vw[i] = (pose.M_vw[i] + (legs.leg[0].M_vw[i] + legs.leg[1].M_vw[i] + (legs.leg[2].M_vw[i] + legs.leg[3].M_vw[i])
            + (legs.leg[4].M_vw[i] + legs.leg[5].M_vw[i])))
    for i in range(6):
        out.M_ww[i] = (pose.M_ww[i] + (legs.leg[0].M_ww[i] + legs.leg[1].M_ww[i] + (legs.leg[2].M_ww[i] + legs.leg[3].M_ww[i])
            + (legs.leg[4].M_ww[i] + legs.leg[5].M_ww[i])))
    for i in range(3):
        out.right_force[i] = (pose.right_force[i] + (legs.leg[0].right_force[i] + legs.leg[1].right_force[i]
            + (legs.leg[2].right_force[i] + legs.leg[3].right_force[i]) + (legs.leg[4].right_force[i] + legs.leg[5].right_force[i])))
    for i in range(3):
        out.right_moment[i] = (pose.right_moment[i] + (legs.leg[0].right_moment[i] + legs.leg[1].right_moment[i]
            + (legs.leg[2].right_moment[i] + legs.leg[3].right_moment[i]) + (legs.leg[4].right_moment[i] + legs.leg[5].right_moment[i])))


def joint_rows_sums(on: Arithmetic, model: Any, motion: Any, legs: Any, summed: Any) -> None:
    """Sums over platform and legs."""
    pose = joint_rows_pose(on, model.platform, motion)
    joint_rows_legs(on, model, motion, pose, legs)
    joint_rows_total(on, pose, legs, summed)


def weigh(on: Arithmetic, inertia: Any, first: Any, by: Any) -> None:
    """Inertia of three coordinates, xx xy xz yy yz zz, as weights of rows of their sizes."""
    for i in range(3):
        by.weight[first][i] = inertia[i] / by.extent[first] / by.extent[first + i]
        by.weight[first + i][0] = inertia[i] / by.extent[first + i] / by.extent[first]
    by.weight[first + 1][1] = inertia[3] / by.extent[first + 1] / by.extent[first + 1]
    by.weight[first + 1][2] = inertia[4] / by.extent[first + 1] / by.extent[first + 2]
    by.weight[first + 2][1] = inertia[4] / by.extent[first + 2] / by.extent[first + 1]
    by.weight[first + 2][2] = inertia[5] / by.extent[first + 2] / by.extent[first + 2]


def make_rows(on: Arithmetic, summed: Any, legs: Any, by: Any) -> None:
    """Rows and weights: each row of A carries the root of its inertia, so that weights are of about one."""
    mass = summed.M_vv[0]
    c = [0.0] * 3
    about = [0.0] * 6
    inertia = [0.0] * 6
    whole = [0.0] * 6
    heaviest = on.size(mass)
    length = 0.0
    for i in range(6):
        rho = legs.leg[i].L * legs.leg[i].k3
        for j in range(3):
            length = on.larger(on.size(legs.leg[i].row_w[j]), length)
        heaviest = on.larger(on.size(legs.leg[i].M_xi[3]) / legs.leg[i].L / legs.leg[i].L, heaviest)
        heaviest = on.larger(on.size(legs.leg[i].M_xi[5]) / rho / rho, heaviest)
    least = on.larger(on.EPSILON * on.sqrt(heaviest), on.SHORTEST)
    by.length = on.where(length > 0.0, length, 1.0)
    for i in range(6):
        reach = least * legs.leg[i].L
        theta = on.larger(on.sqrt(on.size(legs.leg[i].M_xi[3])), reach)
        phi = on.larger(on.sqrt(on.size(legs.leg[i].M_xi[5])), reach * legs.leg[i].k3)
        along = on.larger(on.size(legs.leg[i].M_xi[1]) / theta, on.size(legs.leg[i].M_xi[2]) / phi)
        along = on.larger(along, on.sqrt(on.size(legs.leg[i].M_xi[0])))
        by.extent[3 * i] = on.larger(along, least)
        by.extent[3 * i + 1] = theta
        by.extent[3 * i + 2] = phi
        for j in range(6):
            inertia[j] = legs.leg[i].M_xi[j]
        weigh(on, inertia, 3 * i, by)
        for j in range(3):
            for k in range(3):
                by.row[3 * i + j][k] = by.extent[3 * i + j] * legs.leg[i].row_v[3 * j + k]
                turn = legs.leg[i].row_w[3 * j + k] / by.length
                by.row[3 * i + j][k + 3] = by.extent[3 * i + j] * turn
    for i in range(18, 24):
        for j in range(6):
            by.row[i][j] = 0.0
    heft = on.larger(on.sqrt(on.size(mass)), least)
    per_mass = on.where(mass > 0.0, 1.0 / mass, 0.0)
    c[0] = summed.M_vw[5] * per_mass
    c[1] = -summed.M_vw[2] * per_mass
    c[2] = summed.M_vw[1] * per_mass
    square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2]
    about[0] = summed.M_ww[0] - mass * (square - c[0] * c[0])
    about[1] = summed.M_ww[1] + mass * (c[0] * c[1])
    about[2] = summed.M_ww[2] + mass * (c[0] * c[2])
    about[3] = summed.M_ww[3] - mass * (square - c[1] * c[1])
    about[4] = summed.M_ww[4] + mass * (c[1] * c[2])
    about[5] = summed.M_ww[5] - mass * (square - c[2] * c[2])
    whole[0] = mass
    whole[3] = mass
    whole[5] = mass
    by.extent[21] = on.larger(on.sqrt(on.size(about[0])), least * by.length)
    by.extent[22] = on.larger(on.sqrt(on.size(about[3])), least * by.length)
    by.extent[23] = on.larger(on.sqrt(on.size(about[5])), least * by.length)
    for i in range(3):
        by.extent[18 + i] = heft
        by.row[18 + i][i] = heft
        by.row[21 + i][i + 3] = by.extent[21 + i] / by.length
    by.row[18][4] = heft * (c[2] / by.length)
    by.row[18][5] = -heft * (c[1] / by.length)
    by.row[19][5] = heft * (c[0] / by.length)
    by.row[19][3] = -heft * (c[2] / by.length)
    by.row[20][3] = heft * (c[1] / by.length)
    by.row[20][4] = -heft * (c[0] / by.length)
    weigh(on, whole, 18, by)
    weigh(on, about, 21, by)


def pick_rows(on: Arithmetic, by: Any) -> None:
    """Picks six rows as coordinates by elimination with complete pivoting; the others are sums of them.

    Rows and columns are exchanged: ``order`` and ``column`` say which they were.
    """
    share = [0.0] * 6
    for i in range(24):
        by.order[i] = i
    for k in range(6):
        by.column[k] = k
    for k in range(6):
        best = k
        across = k
        most = on.size(by.row[k][k])
        for i in range(k, 24):
            for j in range(k, 6):
                entry = on.size(by.row[i][j])
                best = on.where(entry > most, i, best)
                across = on.where(entry > most, j, across)
                most = on.where(entry > most, entry, most)
        row = by.order[k]
        by.order[k] = on.at(by.order, best)
        on.put(by.order, row, best)
        column = by.column[k]
        by.column[k] = on.at(by.column, across)
        on.put(by.column, column, across)
        for j in range(6):
            upper = by.row[k][j]
            by.row[k][j] = on.at(by.row, best, j)
            on.put(by.row, upper, best, j)
        for i in range(24):
            left = by.row[i][k]
            by.row[i][k] = on.at(by.row, i, across)
            on.put(by.row, left, i, across)
        for i in range(k + 1, 24):
            by.row[i][k] = by.row[i][k] / by.row[k][k]
            for j in range(k + 1, 6):
                by.row[i][j] = by.row[i][j] - by.row[i][k] * by.row[k][j]
    for i in range(6):
        for j in range(6):
            on.put(by.share, on.where(i == j, 1.0, 0.0), by.order[i], j)
    for i in range(6, 24):
        for j in range(5, -1, -1):
            share[j] = by.row[i][j]
            for k in range(j + 1, 6):
                share[j] = share[j] - share[k] * by.row[k][j]
            on.put(by.share, share[j], by.order[i], j)


def weigh_rows(on: Arithmetic, by: Any) -> None:
    """M in the coordinates."""
    for k in range(6):
        for n in range(6):
            by.inertia[k][n] = 0.0
    for b in range(8):
        for i in range(3):
            for j in range(3):
                for k in range(6):
                    part = by.share[3 * b + i][k] * by.weight[3 * b + i][j]
                    for n in range(6):
                        by.inertia[k][n] = by.inertia[k][n] + part * by.share[3 * b + j][n]


def by_rows(on: Arithmetic, by: Any, wrench: Any, held: Any) -> None:
    """Forces of the six coordinates' rows that add up to a wrench."""
    for k in range(6):
        held[k] = on.at(wrench, by.column[k]) / (on.where(by.column[k] < 3, 1.0, by.length))
    for k in range(6):
        for j in range(k):
            held[k] = held[k] - by.row[j][k] * held[j]
        held[k] = held[k] / by.row[k][k]
    for k in range(5, -1, -1):
        for j in range(k + 1, 6):
            held[k] = held[k] - by.row[j][k] * held[j]


def balance_rows(on: Arithmetic, by: Any, force: Any, moved: Any, balanced: Any) -> None:
    """Accelerations of the coordinates' rows under which the inertia of each block balances their
    forces.

    ``balanced``: 1 of these rows, without those that have no inertia of their own beside the rows
    before them, else 0; ``moved`` is 0 of all others.
    """
    W = [[0.0] * 3 for _ in range(3)]
    for i in range(24):
        moved[i] = force[i]
        balanced[i] = 0.0
    for k in range(6):
        on.put(balanced, 1.0, by.order[k])
    for b in range(8):
        for i in range(3):
            for j in range(3):
                W[i][j] = by.weight[3 * b + i][j]
        for k in range(3):
            own = on.where(W[k][k] > on.KEPT, balanced[3 * b + k], 0.0)
            balanced[3 * b + k] = own
            if on.anywhere(own > 0.0):
                for i in range(k + 1, 3):
                    factor = on.where(own > 0.0, W[i][k] / W[k][k], 0.0)
                    moved[3 * b + i] = moved[3 * b + i] - factor * moved[3 * b + k]
                    for j in range(k + 1, 3):
                        W[i][j] = W[i][j] - factor * W[k][j]
        for k in range(2, -1, -1):
            for j in range(k + 1, 3):
                moved[3 * b + k] = moved[3 * b + k] - W[k][j] * moved[3 * b + j]
            moved[3 * b + k] = on.where(balanced[3 * b + k] > 0.0, moved[3 * b + k] / W[k][k], 0.0)


def row_right(on: Arithmetic, by: Any, force: Any, held: Any, start: Any, rest: Any, right: Any) -> None:
    """Right side of the equations for the accelerations of the six coordinates, with the wrench
    ``held``.

    force: of each row, as its generalized force over its size, without accelerations. start:
    accelerations of the coordinates that balance their own large forces, from which the unknown ones
    are measured; rest: the rows' forces there.
    """
    moved = [0.0] * 24
    balanced = [0.0] * 24
    balance_rows(on, by, force, moved, balanced)
    for k in range(6):
        start[k] = on.at(moved, by.order[k])
    for i in range(24):
        moved[i] = 0.0
        for k in range(6):
            moved[i] = moved[i] + by.share[i][k] * start[k]
    for b in range(8):
        for i in range(3):
            rest[3 * b + i] = on.where(balanced[3 * b + i] > 0.0, 0.0, force[3 * b + i])
            for j in range(3):
                own = (balanced[3 * b + i] > 0.0) & (balanced[3 * b + j] > 0.0)
                less = rest[3 * b + i] - by.weight[3 * b + i][j] * moved[3 * b + j]
                rest[3 * b + i] = on.where(own, rest[3 * b + i], less)
    for k in range(6):
        right[k] = held[k]
        for i in range(24):
            right[k] = right[k] - by.share[i][k] * rest[i]


def substitute_back_8(on: Arithmetic, A: Any, inverse: Any) -> None:
    """Substitutes back; ``inverse`` contains the reciprocals of the pivots."""
    row = [0.0] * 8
    for k in range(5, -1, -1):
        for j in range(6, 8):
            row[j] = A[k][j] * inverse[k]
            A[k][j] = row[j]
        for i in range(k):
            factor = A[i][k]
            for j in range(6, 8):
                A[i][j] = A[i][j] - factor * row[j]


def clear_below_8(on: Arithmetic, A: Any, k: Any, inverse: Any) -> None:
    """Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
    zero.

    ``row`` is a copy, because compilers then know that it differs from the rows that change.
    """
    row = [0.0] * 8
    for j in range(8):
        row[j] = A[k][j]
    for i in range(k + 1, 6):
        factor = A[i][k] * inverse
        for j in range(8):
            A[i][j] = A[i][j] - factor * row[j]


def solve_definite_8(on: Arithmetic, A: Any, kept: Any) -> Any:
    """Solves the rows [M | Y] for X, which replaces Y, by L D L^T.

    Returns MASS_MATRIX_INDEFINITE if a pivot is at most ``kept`` times its diagonal entry.
    """
    scale = [0.0] * 6
    inverse = [0.0] * 6
    status = OK
    for k in range(6):
        scale[k] = A[k][k]
    for k in range(6):
        fault = on.where(on.size(A[k][k]) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
        fault = on.where(A[k][k] > kept * scale[k], OK, fault)
        status = on.where(status == OK, fault, status)
        inverse[k] = 1.0 / A[k][k]
        clear_below_8(on, A, k, inverse[k])
    substitute_back_8(on, A, inverse)
    return status


def row_back(on: Arithmetic, by: Any, found: Any, start: Any, acceleration: Any) -> None:
    """[a; alpha] from the coordinates' accelerations."""
    x = [0.0] * 6
    for k in range(6):
        x[k] = found[k] - start[k]
        for j in range(k):
            x[k] = x[k] - by.row[k][j] * x[j]
    for k in range(5, -1, -1):
        for j in range(k + 1, 6):
            x[k] = x[k] - by.row[k][j] * x[j]
        x[k] = x[k] / by.row[k][k]
        on.put(acceleration, x[k] / (on.where(by.column[k] < 3, 1.0, by.length)), by.column[k])


def rows_held(on: Arithmetic, legs: Any, by: Any, found: Any, start: Any, rest: Any, held: Any) -> None:
    """Generalized forces of each leg, accelerations due to the platform, and a mark if a leg is thin.

    The inertia of a thin leg for a rotation by phi is nearly k3 times its inertia for a rotation by
    theta. A value between the two would have the rounding errors of both. The rows of the coordinates
    contain the part of the wrench that the other rows do not balance. For a heavy leg, this part may
    be much smaller than inertia times acceleration.
    """
    whole = [0.0] * 24
    force = [0.0] * 24
    for i in range(24):
        for j in range(6):
            whole[i] = whole[i] + by.share[i][j] * found[j]
    for b in range(8):
        for i in range(3):
            force[3 * b + i] = rest[3 * b + i]
            for j in range(3):
                force[3 * b + i] = force[3 * b + i] + by.weight[3 * b + i][j] * whole[3 * b + j]
    for k in range(6):
        on.put(force, 0.0, by.order[k])
    for k in range(6):
        for i in range(24):
            held[k] = held[k] - by.share[i][k] * force[i]
    for k in range(6):
        on.put(force, held[k], by.order[k])
    for b in range(6):
        k3 = legs.leg[b].k3
        thin = k3 * by.extent[3 * b + 1] / by.extent[3 * b + 2]
        by.given[b].axial = on.where((k3 < on.LEANING) & (thin * thin > 0.5), 0.0, 1.0)
        for i in range(3):
            turned = 0.0
            for j in range(6):
                turned = turned + by.share[3 * b + i][j] * (found[j] - start[j])
            by.given[b].net[i] = force[3 * b + i] * by.extent[3 * b + i]
            by.given[b].turned[i] = turned / by.extent[3 * b + i]


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


def place_symmetric_12(on: Arithmetic, parts: Any, row: Any, column: Any, A: Any) -> None:
    """A symmetric 3 x 3 block from xx xy xz yy yz zz."""
    for i in range(3):
        A[row][column + i] = parts[i]
        A[row + i][column] = parts[i]
    A[row + 1][column + 1] = parts[3]
    A[row + 1][column + 2] = parts[4]
    A[row + 2][column + 1] = parts[4]
    A[row + 2][column + 2] = parts[5]


def place_inertia_12(on: Arithmetic, vv: Any, vw: Any, ww: Any, first: Any, A: Any) -> None:
    """M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz
    zz.
    """
    for i in range(3):
        for j in range(3):
            A[i][first + j + 3] = vw[3 * i + j]
            A[j + 3][first + i] = vw[3 * i + j]
    place_symmetric_12(on, vv, 0, first, A)
    place_symmetric_12(on, ww, 3, first + 3, A)


def scale_moments_12(on: Arithmetic, per_length: Any, A: Any) -> None:
    """Multiplies the rows of moments by one over a length."""
    if on.anywhere(per_length != 1.0):
        for i in range(3, 6):
            for j in range(12):
                A[i][j] = A[i][j] * per_length


def substitute_back_12(on: Arithmetic, A: Any, inverse: Any) -> None:
    """Substitutes back; ``inverse`` contains the reciprocals of the pivots."""
    row = [0.0] * 12
    for k in range(5, -1, -1):
        for j in range(6, 12):
            row[j] = A[k][j] * inverse[k]
            A[k][j] = row[j]
        for i in range(k):
            factor = A[i][k]
            for j in range(6, 12):
                A[i][j] = A[i][j] - factor * row[j]


def clear_below_12(on: Arithmetic, A: Any, k: Any, inverse: Any) -> None:
    """Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
    zero.

    ``row`` is a copy, because compilers then know that it differs from the rows that change.
    """
    row = [0.0] * 12
    for j in range(12):
        row[j] = A[k][j]
    for i in range(k + 1, 6):
        factor = A[i][k] * inverse
        for j in range(12):
            A[i][j] = A[i][j] - factor * row[j]


def solve_pivoted_12(on: Arithmetic, A: Any) -> Any:
    """Solves the rows [H | Y] for X, which replaces Y, by elimination with partial pivoting. Returns 1
    if a pivot is small.
    """
    inverse = [0.0] * 6
    suspect = 0
    for k in range(6):
        pivot = k
        most = on.size(A[k][k])
        for i in range(k + 1, 6):
            entry = on.size(A[i][k])
            pivot = on.where(entry > most, i, pivot)
            most = on.where(entry > most, entry, most)
        if on.anywhere(pivot != k):
            for j in range(12):
                moved = A[k][j]
                A[k][j] = on.at(A, pivot, j)
                on.put(A, moved, pivot, j)
        suspect = on.where(on.size(A[k][k]) > on.SUSPECT, suspect, 1)
        inverse[k] = 1.0 / A[k][k]
        clear_below_12(on, A, k, inverse[k])
    substitute_back_12(on, A, inverse)
    return suspect


def check_joint_inertia(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.inertia[i][j]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(6):
        for j in range(6):
            out.inertia[i][j] = on.where(out.status == OK, out.inertia[i][j], on.NAN)


def columns_status(on: Arithmetic, model: Any, motion: Any, legs: Any) -> Any:
    """Returns the status of H: STEWART_SINGULAR if H is singular to rounding."""
    H = [[0.0] * 6 for _ in range(6)]
    arm = [[0.0] * 3 for _ in range(6)]
    L = [0.0] * 6
    for i in range(6):
        L[i] = legs.leg[i].L
        for j in range(3):
            H[j][i] = legs.leg[i].H_force[j]
            H[j + 3][i] = legs.leg[i].H_moment[j]
            plane = motion.R[3 * j] * model.leg[i].p[0] + motion.R[3 * j + 1] * model.leg[i].p[1]
            arm[i][j] = plane + motion.R[3 * j + 2] * model.leg[i].p[2]
    return singular_status(on, H, arm, L, legs.reach, 0.0)


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


def derivatives_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of the derivatives of the wrench: 338 (168 mul, 170 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    M_P = platform.M_P
    h_P_x, h_P_y, h_P_z = platform.h_P
    J_P_xx, J_P_xy, J_P_xz, J_P_yy, J_P_yz, J_P_zz = platform.J_P
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * h_P_x + R_xy * h_P_y + R_xz * h_P_z
    h_base_y = R_yx * h_P_x + R_yy * h_P_y + R_yz * h_P_z
    h_base_z = R_zx * h_P_x + R_zy * h_P_y + R_zz * h_P_z
    c1 = J_P_xx * R_xx + J_P_xy * R_xy + J_P_xz * R_xz
    c2 = J_P_xy * R_xx + J_P_yy * R_xy + J_P_yz * R_xz
    c3 = J_P_xz * R_xx + J_P_yz * R_xy + J_P_zz * R_xz
    c4 = J_P_xx * R_yx + J_P_xy * R_yy + J_P_xz * R_yz
    c5 = J_P_xy * R_yx + J_P_yy * R_yy + J_P_yz * R_yz
    c6 = J_P_xz * R_yx + J_P_yz * R_yy + J_P_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c1 + R_xy * c2 + R_xz * c3
    J_base_xy = R_yx * c1 + R_yy * c2 + R_yz * c3
    J_base_xz = R_zx * c1 + R_zy * c2 + R_zz * c3
    J_base_yy = R_yx * c4 + R_yy * c5 + R_yz * c6
    J_base_yz = R_zx * c4 + R_zy * c5 + R_zz * c6
    J_base_zz = (R_zx * (J_P_xx * R_zx + J_P_xy * R_zy + J_P_xz * R_zz) + R_zy * (J_P_xy * R_zx + J_P_yy * R_zy
        + J_P_yz * R_zz) + R_zz * (J_P_xz * R_zx + J_P_yz * R_zy + J_P_zz * R_zz))
    c7 = h_base_y * omega_z
    c8 = h_base_z * omega_y
    c9 = h_base_x * omega_z
    c10 = h_base_z * omega_x
    c11 = h_base_x * omega_y
    c12 = h_base_y * omega_x
    # (31) omega x h
    w_h_x = c8 - c7
    w_h_y = c9 - c10
    w_h_z = c12 - c11
    c13 = J_base_xy * omega_y
    c14 = J_base_xz * omega_z
    c15 = J_base_xy * omega_x
    c16 = J_base_yz * omega_z
    c17 = J_base_xz * omega_x
    c18 = J_base_yz * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + c13 + c14
    J_w_y = J_base_yy * omega_y + c15 + c16
    J_w_z = J_base_zz * omega_z + c17 + c18
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
    c19 = J_base_xy * alpha_y
    c20 = J_base_xz * alpha_z
    J_alpha_x = J_base_xx * alpha_x + c19 + c20
    c21 = J_base_xy * alpha_x
    c22 = J_base_yz * alpha_z
    J_alpha_y = J_base_yy * alpha_y + c21 + c22
    c23 = J_base_xz * alpha_x
    c24 = J_base_yz * alpha_y
    J_alpha_z = J_base_zz * alpha_z + c23 + c24
    # (33) a - g
    rise_x = a_x - g_x
    rise_y = a_y - g_y
    rise_z = a_z - g_z
    F_load_x = F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz
    F_load_y = F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz
    F_load_z = F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz
    M_load_x = M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz
    M_load_y = M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz
    M_load_z = M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz
    c25 = J_base_xy * omega_z
    c26 = J_base_xz * omega_y
    c28 = c17 - J_base_xx * omega_z + J_w_z
    c29 = c15 - J_base_xx * omega_y + J_w_y
    c30 = c18 - J_base_yy * omega_z + J_w_z
    c31 = J_base_yz * omega_x
    c33 = c25 - c31
    c34 = c13 - J_base_yy * omega_x + J_w_x
    c35 = c16 - J_base_zz * omega_y + J_w_y
    c36 = c14 - J_base_zz * omega_x + J_w_x
    # derivative of I omega by dphi at fixed omega
    spin_xx = c25 - c26
    spin_xy = c28
    spin_xz = -c29
    spin_yx = -c30
    spin_yy = -c33
    spin_yz = c34
    spin_zx = c35
    spin_zy = -c36
    spin_zz = c26 - c31
    c37 = J_base_xz * alpha_y
    c38 = h_base_y * rise_y
    c39 = h_base_z * rise_z
    c40 = J_base_xy * alpha_z
    c41 = h_base_x * rise_x
    c42 = J_base_yz * alpha_x
    c43 = h_base_y * omega_y
    c44 = h_base_z * omega_z
    c45 = h_base_x * omega_x
    out = DerivativesPose()
    out.B = [B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz]
    out.M_vv = [M_P, 0.0, 0.0, M_P, 0.0, M_P]
    out.M_vw = [0.0, h_base_z, -h_base_y, -h_base_z, 0.0, h_base_x, h_base_y, -h_base_x, 0.0]
    out.M_ww = [J_base_xx, J_base_xy, J_base_xz, J_base_yy, J_base_yz, J_base_zz]
    out.W_ft = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fr = [
        B_xz * h_base_y - B_xy * h_base_z,
        B_xx * h_base_z - F_load_z - B_xz * h_base_x,
        F_load_y + B_xy * h_base_x - B_xx * h_base_y,
        F_load_z + B_yz * h_base_y - B_yy * h_base_z,
        B_yx * h_base_z - B_yz * h_base_x,
        B_yy * h_base_x - F_load_x - B_yx * h_base_y,
        B_zz * h_base_y - F_load_y - B_zy * h_base_z,
        F_load_x + B_zx * h_base_z - B_zz * h_base_x,
        B_zy * h_base_x - B_zx * h_base_y,
    ]
    out.W_mt = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mr = [
        c40 + omega_y * spin_zx - c37 - c38 - c39 - omega_z * spin_yx,
        J_alpha_z + c23 + h_base_x * rise_y + omega_y * spin_zy - M_load_z - J_base_xx * alpha_z - omega_z * spin_yy,
        M_load_y + J_base_xx * alpha_y + h_base_x * rise_z + omega_y * spin_zz - J_alpha_y - c21 - omega_z * spin_yz,
        M_load_z + J_base_yy * alpha_z + h_base_y * rise_x + omega_z * spin_xx - J_alpha_z - c24 - omega_x * spin_zx,
        c42 + omega_z * spin_xy - c39 - c40 - c41 - omega_x * spin_zy,
        J_alpha_x + c19 + h_base_y * rise_z + omega_z * spin_xz - M_load_x - J_base_yy * alpha_x - omega_x * spin_zz,
        J_alpha_y + c22 + h_base_z * rise_x + omega_x * spin_yx - M_load_y - J_base_zz * alpha_y - omega_y * spin_xx,
        M_load_x + J_base_zz * alpha_x + h_base_z * rise_y + omega_x * spin_yy - J_alpha_x - c20 - omega_y * spin_xy,
        c37 + omega_x * spin_yz - c38 - c41 - c42 - omega_y * spin_xz,
    ]
    out.W_fv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fw = [
        c43 + c44,
        w_h_z - c11,
        -c9 - w_h_y,
        -c12 - w_h_z,
        c44 + c45,
        w_h_x - c7,
        w_h_y - c10,
        -c8 - w_h_x,
        c43 + c45,
    ]
    out.W_mv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mw = [C_P + c26 - c25, c30, -c35, -c28, C_P + c33, c36, c29, -c34, C_P + c31 - c26]
    return out


def derivatives_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench: 1606 (943 mul, 659 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    c12 = inv_rho * inv_rho
    c13 = inv_L * inv_rho
    c14 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -h_z * inv_L
    m_leg_yy = M_phi * c12
    m_leg_yz = -M_mixed * c13
    m_leg_zz = M_theta * c14
    m_T_xs = m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yz * z_x + m_leg_yy * y_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yz * z_y + m_leg_yy * y_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_leg_sz * z_z + m_leg_sy * y_z
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
    c15 = c6 * h_x
    c16 = c15 - h_z * k1 * k3
    tau_L = C_p * L_dot - c3 * h_x - c16 * c4 + h_z * theta_ddot - c11 * phi_ddot
    c18 = c7 * h_x
    c19 = 2.0 * L
    c20 = c19 * h_x
    c21 = k3 * w_z + k1 * w_x
    c22 = k1 * w_z - k3 * w_x
    c24 = c10 + c9 * k1
    c25 = 2.0 * J_xz - c19 * h_z
    c26 = c25 * k1
    c27 = J_zz - J_xx + c20
    c28 = c27 * k3
    c29 = 2.0 * c28 + c26
    c30 = 0.5 * k1
    c31 = c29 * c30 - 0.5 * c25 * c6
    tau_theta = (L_ddot * h_z - c22 * g_k - c31 * c4 + C_us * theta_dot + c21 * gamma_n + L_dot * c18 - C_s
        * w_y_omega + theta_ddot * (J_yy + c20) + c24 * phi_ddot)
    c33 = h_y * theta_dot
    c34 = c33 * k1
    c35 = L_dot * c16
    c36 = c31 * theta_dot
    c37 = L_dot * h_y
    c38 = c37 * k1
    c39 = theta_dot * (J_yz * k1 - c9 * k3)
    tau_phi = (c22 * gamma_y - C_s * w_k_omega - L_ddot * c11 + C_us * phi_dot + phi_dot * (c35 + c36) - gamma_n
        * w_y + theta_dot * (c39 - c38 + c31 * phi_dot) + L_dot * (c16 * phi_dot - c34) + c24 * theta_ddot + phi_ddot
        * (J_xx + c27 * c6 + c25 * c8))
    c40 = k3 * phi_dot
    G_dot_12 = c40
    c41 = inv_L * theta_dot
    G_dot_21 = -c41
    c42 = k1 * phi_dot
    G_dot_22 = c42 * inv_L
    c43 = L_dot * c14
    G_dot_23 = c43
    c44 = c40 * inv_rho
    G_dot_31 = -c44
    c45 = c1 * inv_rho
    c46 = -c45 - c2 * inv_rho
    G_dot_32 = c46
    c47 = c42 * inv_rho
    G_dot_33 = c47
    c48 = c4 * c6
    G_ddot_11 = -c3 - c48
    c49 = k3 * phi_ddot
    c50 = c5 * k1
    G_ddot_12 = c50 * theta_dot + c49
    c51 = c4 * c8
    G_ddot_13 = c51 - theta_ddot
    G_ddot_21 = 2.0 * L_dot * c14 * theta_dot - c51 * inv_L - inv_L * theta_ddot
    G_ddot_22 = inv_L * k1 * phi_ddot - c41 * c5 * k3 - c43 * c50
    c52 = c4 * k1 * k1
    G_ddot_23 = c3 * inv_L - 2.0 * L_dot * L_dot * inv_L * inv_L * inv_L + c52 * inv_L + L_ddot * c14
    G_ddot_31 = (c1 * c44 + c47 * theta_dot - c40 * c46 + theta_dot * (inv_rho * k3 * kappa * phi_dot - c47)
        - c49 * inv_rho)
    c53 = inv_rho * kappa
    c54 = -c1 - c2
    G_ddot_32 = (L_dot * (c43 * inv_rho - c13 * c54) - c48 * inv_rho - c52 * inv_rho - L_ddot * c13 + theta_dot
        * (-inv_rho * theta_dot * (-1.0 - kappa * kappa) - c53 * c54) - c53 * theta_ddot)
    G_ddot_33 = (c42 * c46 + c44 * theta_dot - c42 * c45 + theta_dot * (-c44 - c47 * kappa) + inv_rho * k1 * phi_ddot)
    tau_rate_12 = -c18
    tau_rate_13 = -c16 * c5
    tau_rate_21 = c18
    c55 = 2.0 * h_x
    tau_rate_22 = C_us + L_dot * c55
    tau_rate_23 = -c31 * c5
    tau_rate_31 = 2.0 * (c16 * phi_dot - c34)
    tau_rate_32 = 2.0 * c39 - 2.0 * c38 + c31 * c5
    tau_rate_33 = C_us + 2.0 * c35 + 2.0 * c36
    c56 = h_y * phi_ddot
    c57 = c55 * k3 - h_z * k1
    tau_place_12 = k1 * (-c4 * c57 - c56) - c48 * h_z
    c58 = 4.0 * h_x
    c59 = c6 * h_z + c30 * (c58 * k3 - 2.0 * h_z * k1)
    tau_place_21 = c55 * theta_ddot - c4 * c59 - c56 * k1
    c60 = c30 * (2.0 * J_zz - 2.0 * J_xx + L * c58) - c25 * k3
    c61 = c28 + c26
    tau_place_22 = (k1 * (g_k * w_x - c4 * c60 + gamma_n * w_z + J_yz * phi_ddot) - k3 * (gamma_n * w_x - g_k
        * w_z - c4 * c61 + c9 * phi_ddot))
    tau_place_23 = -c21 * gamma_y - C_s * w_n_omega
    c62 = c59 * phi_dot
    tau_place_31 = (c62 * theta_dot + theta_dot * (c11 * theta_dot + c62) + phi_ddot * (2.0 * (c15 - c8 * h_z))
        - h_y * k1 * theta_ddot)
    c63 = L_dot * c57
    tau_place_32 = (k1 * (c63 * phi_dot - L_ddot * h_y + phi_dot * (c63 + c60 * theta_dot) - gamma_y * w_x + theta_dot
        * (c60 * phi_dot - c9 * theta_dot) + J_yz * theta_ddot + c29 * phi_ddot) - k3 * (gamma_y * w_z + phi_dot
        * (c61 * theta_dot - L_dot * h_z * k3) + theta_dot * (J_yz * theta_dot - c37 + c61 * phi_dot) + c9 * theta_ddot
        + L_dot * (-c33 - c40 * h_z) + c25 * c49))
    tau_place_33 = c22 * gamma_n + gamma_y * w_y
    c64 = inv_rho * tau_phi
    c65 = inv_L * tau_theta
    c66 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c64 * y_x + c66 * s_x - c65 * z_x
    R_tip_y = c64 * y_y + c66 * s_y - c65 * z_y
    R_tip_z = c64 * y_z + c66 * s_z - c65 * z_z
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_32 * y_x + G_dot_33 * z_x + G_dot_31 * s_x)
    phi_dot_by_S_y = C_s * (G_dot_32 * y_y + G_dot_33 * z_y + G_dot_31 * s_y)
    phi_dot_by_S_z = C_s * (G_dot_32 * y_z + G_dot_33 * z_z + G_dot_31 * s_z)
    c67 = C_s * inv_L
    # gradient of theta, times C_s
    C_s_theta_x = -c67 * z_x
    C_s_theta_y = -c67 * z_y
    C_s_theta_z = -c67 * z_z
    c68 = C_s * inv_rho
    # gradient of phi, times C_s
    C_s_phi_x = c68 * y_x
    C_s_phi_y = c68 * y_y
    C_s_phi_z = c68 * y_z
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
    A_0_leg_11 = G_dot_21 * tau_rate_12 + G_dot_31 * tau_rate_13 + G_ddot_21 * h_z - G_ddot_31 * k3_h
    A_0_leg_12 = (C_p * G_dot_12 + G_dot_22 * tau_rate_12 + G_dot_32 * tau_rate_13 + G_ddot_22 * h_z - G_ddot_32
        * k3_h - c12 * k3 * tau_phi)
    c69 = c14 * tau_theta
    A_0_leg_13 = (G_ddot_23 * h_z - C_p * theta_dot + G_dot_23 * tau_rate_12 + G_dot_33 * tau_rate_13 + c69
        - G_ddot_33 * k3_h - inv_L * tau_place_12)
    c70 = c13 * tau_phi
    A_0_leg_21 = (inv_rho * (G_dot_21 * tau_rate_32 - G_ddot_11 * k3_h + G_dot_31 * tau_rate_33 + G_ddot_21
        * M_mixed + tau_place_31 + G_ddot_31 * M_phi) - c70)
    A_0_leg_22 = (c13 * k1 * tau_theta + c66 * inv_rho * k3 + inv_rho * (G_dot_32 * tau_rate_33 + inv_rho * tau_place_33
        + G_dot_12 * tau_rate_31 + G_dot_22 * tau_rate_32 + G_ddot_22 * M_mixed + G_ddot_32 * M_phi - G_ddot_12
        * k3_h))
    A_0_leg_23 = (c70 * kappa + inv_rho * (G_ddot_23 * M_mixed + G_dot_33 * tau_rate_33 + G_dot_23 * tau_rate_32
        - tau_rate_31 * theta_dot - G_ddot_13 * k3_h + G_ddot_33 * M_phi - inv_L * tau_place_32))
    A_0_leg_31 = (c69 - inv_L * (G_ddot_11 * h_z + G_dot_21 * tau_rate_22 + G_dot_31 * tau_rate_23 + G_ddot_21
        * M_theta + tau_place_21 + G_ddot_31 * M_mixed))
    A_0_leg_32 = (c12 * k1 * tau_phi - inv_L * (G_dot_12 * tau_rate_21 + G_dot_22 * tau_rate_22 + G_dot_32 * tau_rate_23
        + inv_rho * tau_place_23 + G_ddot_12 * h_z + G_ddot_22 * M_theta + G_ddot_32 * M_mixed))
    A_0_leg_33 = (c66 * inv_L - inv_L * (G_ddot_23 * M_theta + G_dot_23 * tau_rate_22 - tau_rate_21 * theta_dot
        + G_dot_33 * tau_rate_23 + G_ddot_13 * h_z + G_ddot_33 * M_mixed - inv_L * tau_place_22))
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
    c71 = 2.0 * h_z
    c72 = 2.0 * k3_h
    A_1_leg_11 = C_p + G_dot_21 * c71 - G_dot_31 * c72
    A_1_leg_12 = G_dot_22 * c71 + inv_rho * tau_rate_13 - G_dot_32 * c72
    A_1_leg_13 = 2.0 * G_dot_23 * h_z - inv_L * tau_rate_12 - G_dot_33 * c72
    c73 = 2.0 * M_mixed
    c74 = 2.0 * M_phi
    A_1_leg_21 = inv_rho * (G_dot_21 * c73 + tau_rate_31 + G_dot_31 * c74)
    A_1_leg_22 = inv_rho * (inv_rho * tau_rate_33 + G_dot_22 * c73 + G_dot_32 * c74 - G_dot_12 * c72)
    A_1_leg_23 = inv_rho * (G_dot_23 * c73 + c7 * k3_h + G_dot_33 * c74 - inv_L * tau_rate_32)
    c75 = 2.0 * M_theta
    A_1_leg_31 = -inv_L * (tau_rate_21 + G_dot_21 * c75 + G_dot_31 * c73)
    A_1_leg_32 = -inv_L * (G_dot_12 * c71 + G_dot_22 * c75 + G_dot_32 * c73 + inv_rho * tau_rate_23)
    A_1_leg_33 = -inv_L * (G_dot_23 * c75 - inv_L * tau_rate_22 - c7 * h_z + G_dot_33 * c73)
    A_1_T_xs = A_1_leg_11 * s_x + A_1_leg_21 * y_x + A_1_leg_31 * z_x
    A_1_T_xy = A_1_leg_12 * s_x + A_1_leg_22 * y_x + A_1_leg_32 * z_x
    A_1_T_xz = A_1_leg_13 * s_x + A_1_leg_33 * z_x + A_1_leg_23 * y_x
    A_1_T_ys = A_1_leg_11 * s_y + A_1_leg_21 * y_y + A_1_leg_31 * z_y
    A_1_T_yy = A_1_leg_12 * s_y + A_1_leg_22 * y_y + A_1_leg_32 * z_y
    A_1_T_yz = A_1_leg_13 * s_y + A_1_leg_33 * z_y + A_1_leg_23 * y_y
    A_1_T_zs = A_1_leg_11 * s_z + A_1_leg_21 * y_z + A_1_leg_31 * z_z
    A_1_T_zy = A_1_leg_12 * s_z + A_1_leg_22 * y_z + A_1_leg_32 * z_z
    A_1_T_zz = A_1_leg_13 * s_z + A_1_leg_33 * z_z + A_1_leg_23 * y_z
    # force at the tip by S_dot
    A_1_xx = A_1_T_xz * z_x + A_1_T_xs * s_x + A_1_T_xy * y_x
    A_1_xy = A_1_T_xz * z_y + A_1_T_xs * s_y + A_1_T_xy * y_y
    A_1_xz = A_1_T_xz * z_z + A_1_T_xs * s_z + A_1_T_xy * y_z
    A_1_yx = A_1_T_yz * z_x + A_1_T_ys * s_x + A_1_T_yy * y_x
    A_1_yy = A_1_T_yz * z_y + A_1_T_ys * s_y + A_1_T_yy * y_y
    A_1_yz = A_1_T_yz * z_z + A_1_T_ys * s_z + A_1_T_yy * y_z
    A_1_zx = A_1_T_zz * z_x + A_1_T_zs * s_x + A_1_T_zy * y_x
    A_1_zy = A_1_T_zz * z_y + A_1_T_zs * s_y + A_1_T_zy * y_y
    A_1_zz = A_1_T_zz * z_z + A_1_T_zs * s_z + A_1_T_zy * y_z
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
    c76 = m_xy * omega_z
    c77 = m_xz * omega_y
    Y_xx = c76 - c77 + A_1_xx
    Y_xy = m_xz * omega_x - m_xx * omega_z + A_1_xy
    Y_xz = m_xx * omega_y - m_xy * omega_x + A_1_xz
    Y_yx = m_yy * omega_z - m_yz * omega_y + A_1_yx
    c78 = m_yz * omega_x
    Y_yy = c78 - c76 + A_1_yy
    Y_yz = m_xy * omega_y - m_yy * omega_x + A_1_yz
    Y_zx = m_yz * omega_z - m_zz * omega_y + A_1_zx
    Y_zy = m_zz * omega_x - m_xz * omega_z + A_1_zy
    Y_zz = c77 - c78 + A_1_zz
    c79 = X_xy * q_z
    Z_xx = X_xz * q_y - c79
    c80 = X_xx * q_z
    Z_xy = c80 - X_xz * q_x
    c81 = X_xx * q_y
    Z_xz = X_xy * q_x - c81
    c82 = X_yy * q_z
    Z_yx = X_yz * q_y - c82
    c83 = X_yx * q_z
    c84 = -X_yz * q_x
    Z_yy = c83 + c84
    c85 = -X_yy * q_x
    Z_yz = -X_yx * q_y - c85
    c86 = -X_zz * q_y
    Z_zx = -X_zy * q_z - c86
    c87 = -X_zz * q_x
    Z_zy = X_zx * q_z + c87
    c88 = X_zx * q_y
    Z_zz = X_zy * q_x - c88
    c89 = m_xy * w_q_z
    c90 = m_xz * w_q_y
    V_xx = c90 - f_S_dot_xx - c89 + Y_xz * q_y - Y_xy * q_z
    V_xy = m_xx * w_q_z - f_S_dot_yx - m_xz * w_q_x + Y_xx * q_z - Y_xz * q_x
    V_xz = m_xy * w_q_x - f_S_dot_zx - m_xx * w_q_y + Y_xy * q_x - Y_xx * q_y
    V_yx = m_yz * w_q_y - f_S_dot_xy - m_yy * w_q_z + Y_yz * q_y - Y_yy * q_z
    c91 = m_yz * w_q_x
    V_yy = c89 - f_S_dot_yy - c91 + Y_yx * q_z - Y_yz * q_x
    V_yz = m_yy * w_q_x - f_S_dot_zy - m_xy * w_q_y + Y_yy * q_x - Y_yx * q_y
    V_zx = m_zz * w_q_y - f_S_dot_xz - m_yz * w_q_z + Y_zz * q_y - Y_zy * q_z
    V_zy = m_xz * w_q_z - f_S_dot_yz - m_zz * w_q_x + Y_zx * q_z - Y_zz * q_x
    V_zz = c91 - f_S_dot_zz - c90 + Y_zy * q_x - Y_zx * q_y
    # derivative of the moment by rotation about the tip
    Q_xx = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx + c83 - c88
    Q_xy = f_S_dot_xz * omega_x - f_S_dot_xx * omega_z + f_S_xy - R_tip_z + c82 - X_zy * q_y
    Q_xz = f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz + R_tip_y + X_yz * q_z + c86
    Q_yx = f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx + R_tip_z + X_zx * q_x - c80
    Q_yy = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy + X_zy * q_x - c79
    Q_yz = f_S_dot_yx * omega_y - f_S_dot_yy * omega_x + f_S_yz - R_tip_x - X_xz * q_z - c87
    Q_zx = f_S_dot_zy * omega_z - f_S_dot_zz * omega_y + f_S_zx - R_tip_y + c81 - X_yx * q_x
    Q_zy = f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy + R_tip_x + X_xy * q_y + c85
    Q_zz = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz + X_xz * q_y + c84
    c92 = m_xy * q_z
    c93 = m_xz * q_y
    c94 = -m_yz * q_x
    # m [q]x
    m_q_xx = c92 - c93
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c92 - c94
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c93 + c94
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


def derivatives_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(6):
        out.M_vv[i] = (pose.M_vv[i] + (legs.leg[0].M_vv[i] + legs.leg[1].M_vv[i] + (legs.leg[2].M_vv[i] + legs.leg[3].M_vv[i])
            + (legs.leg[4].M_vv[i] + legs.leg[5].M_vv[i])))
    for i in range(9):
        out.M_vw[i] = (pose.M_vw[i] + (legs.leg[0].M_vw[i] + legs.leg[1].M_vw[i] + (legs.leg[2].M_vw[i] + legs.leg[3].M_vw[i])
            + (legs.leg[4].M_vw[i] + legs.leg[5].M_vw[i])))
    for i in range(6):
        out.M_ww[i] = (pose.M_ww[i] + (legs.leg[0].M_ww[i] + legs.leg[1].M_ww[i] + (legs.leg[2].M_ww[i] + legs.leg[3].M_ww[i])
            + (legs.leg[4].M_ww[i] + legs.leg[5].M_ww[i])))
    for i in range(9):
        out.W_ft[i] = (pose.W_ft[i] + (legs.leg[0].W_ft[i] + legs.leg[1].W_ft[i] + (legs.leg[2].W_ft[i] + legs.leg[3].W_ft[i])
            + (legs.leg[4].W_ft[i] + legs.leg[5].W_ft[i])))
    for i in range(9):
        out.W_fr[i] = (pose.W_fr[i] + (legs.leg[0].W_fr[i] + legs.leg[1].W_fr[i] + (legs.leg[2].W_fr[i] + legs.leg[3].W_fr[i])
            + (legs.leg[4].W_fr[i] + legs.leg[5].W_fr[i])))
    for i in range(9):
        out.W_mt[i] = (pose.W_mt[i] + (legs.leg[0].W_mt[i] + legs.leg[1].W_mt[i] + (legs.leg[2].W_mt[i] + legs.leg[3].W_mt[i])
            + (legs.leg[4].W_mt[i] + legs.leg[5].W_mt[i])))
    for i in range(9):
        out.W_mr[i] = (pose.W_mr[i] + (legs.leg[0].W_mr[i] + legs.leg[1].W_mr[i] + (legs.leg[2].W_mr[i] + legs.leg[3].W_mr[i])
            + (legs.leg[4].W_mr[i] + legs.leg[5].W_mr[i])))
    for i in range(9):
        out.W_fv[i] = (pose.W_fv[i] + (legs.leg[0].W_fv[i] + legs.leg[1].W_fv[i] + (legs.leg[2].W_fv[i] + legs.leg[3].W_fv[i])
            + (legs.leg[4].W_fv[i] + legs.leg[5].W_fv[i])))
    for i in range(9):
        out.W_fw[i] = (pose.W_fw[i] + (legs.leg[0].W_fw[i] + legs.leg[1].W_fw[i] + (legs.leg[2].W_fw[i] + legs.leg[3].W_fw[i])
            + (legs.leg[4].W_fw[i] + legs.leg[5].W_fw[i])))
    for i in range(9):
        out.W_mv[i] = (pose.W_mv[i] + (legs.leg[0].W_mv[i] + legs.leg[1].W_mv[i] + (legs.leg[2].W_mv[i] + legs.leg[3].W_mv[i])
            + (legs.leg[4].W_mv[i] + legs.leg[5].W_mv[i])))
    for i in range(9):
        out.W_mw[i] = (pose.W_mw[i] + (legs.leg[0].W_mw[i] + legs.leg[1].W_mw[i] + (legs.leg[2].W_mw[i] + legs.leg[3].W_mw[i])
            + (legs.leg[4].W_mw[i] + legs.leg[5].W_mw[i])))


def derivatives_near(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench: 2043 (1206 mul, 833 add, 2 div, 2 sqrt)."""
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    C_p, C_s = leg.C_p, leg.C_s
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
    c9 = h_z * inv_L
    c10 = inv_L * inv_L
    # inertia at the tip, leg frame
    m_leg_sy = -inv_rho * k3_h
    m_leg_sz = -c9
    m_leg_yy = M_phi * inv_rho * inv_rho
    m_leg_yz = -M_mixed * inv_L * inv_rho
    m_leg_zz = M_theta * c10
    m_T_xs = m_leg_sz * z_x + m_leg_sy * y_x
    m_T_xy = m_leg_sy * s_x + m_leg_yy * y_x + m_leg_yz * z_x
    m_T_xz = m_leg_sz * s_x + m_leg_zz * z_x + m_leg_yz * y_x
    m_T_ys = m_leg_sz * z_y + m_leg_sy * y_y
    m_T_yy = m_leg_sy * s_y + m_leg_yy * y_y + m_leg_yz * z_y
    m_T_yz = m_leg_sz * s_y + m_leg_zz * z_y + m_leg_yz * y_y
    m_T_zs = m_leg_sz * z_z + m_leg_sy * y_z
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
    c11 = h_y * own_z
    c12 = W_z * W_z
    c13 = c12 * h_x
    c14 = c3 * h_x
    c15 = h_y * k1
    c16 = W_z * inv_k3
    c17 = 2.0 * theta_dot
    c18 = c16 * c17
    c19 = c12 * h_z
    c20 = inv_k3 * k1
    c21 = 2.0 * c20
    tau_L = C_p * L_dot - c13 - c14 + c19 * c21 + h_z * own_y + c15 * c18 - c11
    c22 = C_us * theta_dot
    c23 = J_yy * own_y
    c24 = J_yz * own_z
    c25 = L_ddot * h_z
    c26 = C_s * w_y_omega
    c27 = k3 * w_x
    c28 = c27 * g_k
    c29 = k1 * w_x
    c30 = c29 * gamma_n
    c31 = k3 * w_z
    c32 = c31 * gamma_n
    c33 = J_xy * c17
    c34 = W_z * c33
    c35 = 2.0 * L
    c36 = h_x * own_y
    c37 = L_dot * c17
    c38 = k1 * w_z
    c39 = c38 * g_k
    c40 = inv_k3 * own_z
    c41 = J_xy * k1
    c42 = c40 * c41
    c43 = J_xz * c12
    c44 = 2.0 * c43
    c45 = W_z * c17 * c6
    c46 = J_yz * k1
    c47 = c18 * c46
    c48 = c6 * k1
    c49 = inv_k3 * inv_k3
    c50 = c43 * c49
    c51 = c12 * inv_k3
    c53 = J_xx - J_zz
    c54 = J_yy + c53
    c55 = c54 * k1
    tau_theta = (c44 - c50 + L * c19 * c49 + c28 - c19 * c35 + c51 * c55 + c25 - c39 + c22 + c30 + c32 + c34
        + c37 * h_x - c26 + c23 + c35 * c36 + c45 * c49 - c34 * c49 - c45 + c24 - c47 + c42 - c40 * c48)
    c56 = C_s * w_k_omega
    c57 = gamma_n * w_y
    c58 = c41 * own_y
    c59 = c38 * gamma_y
    c60 = 2.0 * own_z
    c61 = J_xz * k1
    c62 = J_xy * c12
    c63 = c62 * inv_k3
    c64 = c12 * c46
    c65 = c3 * c46
    c66 = J_xz * c17
    c67 = k3 * own_z
    c68 = h_z * k1
    c69 = 2.0 * h_x
    c70 = 2.0 * W_z
    c71 = J_xy * c3
    c72 = c6 * k3
    c73 = c16 * theta_dot
    c75 = 2.0 * J_xx
    c76 = c49 * c75
    c77 = W_z * theta_dot
    tau_phi = (c63 - c56 + c12 * c72 + c3 * c72 - c62 * k3 - c71 * k3 - c51 * c6 + c64 + c65 - L_ddot * c8 + c59
        - c27 * gamma_y - c57 + C_us * c16 + c58 + c7 * own_y - c15 * c37 + L_dot * W_z * c69 * k3 - c16 * c66
        - c48 * own_y + c35 * c73 * h_z - L_dot * c68 * c70 - c76 * c77 * k1 + J_xx * c40 + c60 * c61 + c35
        * c67 * h_x - c35 * c68 * own_z - c53 * c67)
    c78 = inv_rho * tau_phi
    c79 = inv_L * tau_theta
    c80 = tau_L - F
    # force at the tip, less the actuator's
    R_tip_x = c80 * s_x - c79 * z_x + c78 * y_x
    R_tip_y = c80 * s_y - c79 * z_y + c78 * y_y
    R_tip_z = c80 * s_z - c79 * z_z + c78 * y_z
    c81 = inv_L * theta_dot
    G_dot_21 = -c81
    c82 = k1 * phi_dot
    G_dot_22 = c82 * inv_L
    c83 = L_dot * c10
    G_dot_23 = c83
    G_dot_31 = -inv_rho * k3 * phi_dot
    G_dot_32 = -c2 * inv_rho - inv_rho * kappa * theta_dot
    G_dot_33 = c82 * inv_rho
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_32 * y_x + G_dot_33 * z_x + G_dot_31 * s_x)
    phi_dot_by_S_y = C_s * (G_dot_32 * y_y + G_dot_33 * z_y + G_dot_31 * s_y)
    phi_dot_by_S_z = C_s * (G_dot_32 * y_z + G_dot_33 * z_z + G_dot_31 * s_z)
    c84 = C_s * inv_L
    # gradient of theta, times C_s
    C_s_theta_x = -c84 * z_x
    C_s_theta_y = -c84 * z_y
    C_s_theta_z = -c84 * z_z
    c85 = C_s * inv_rho
    # gradient of phi, times C_s
    C_s_phi_x = c85 * y_x
    C_s_phi_y = c85 * y_y
    C_s_phi_z = c85 * y_z
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
    c86 = c9 * own_y
    c87 = c83 * h_z
    c88 = -c17 * c87
    c89 = c9 * k1
    c90 = c51 * c89
    c91 = c11 * inv_L
    c92 = 2.0 * h_y
    c93 = c83 * c92
    c94 = W_z * c93
    c95 = c94 + 4.0 * c15 * c16 * c81 - c91
    A_0_leg_11 = 2.0 * c12 * h_x * inv_L + 2.0 * c3 * h_x * inv_L - 4.0 * c90 - c88 - c86 - c95
    c96 = h_x * inv_L
    c97 = c60 * c96
    c98 = J_yz * c10
    c99 = c98 * own_y
    c100 = h_y * inv_L
    c101 = c100 * c12
    c102 = 2.0 * c101
    c103 = c10 * inv_k3
    c104 = c103 * c58
    c105 = c103 * c59
    c106 = inv_L * inv_L * inv_L
    c107 = L_dot * L_dot
    c108 = c106 * c107
    c109 = c108 * c92
    c110 = C_us * c10
    c111 = W_z * c110 * c49
    c112 = c10 * own_z
    c113 = J_xx * c49
    c114 = 2.0 * c40
    c115 = c10 * c61
    c116 = c49 * c9
    c117 = c100 * c3
    c118 = 2.0 * c49
    c119 = c103 * c64
    c120 = c103 * c65
    c121 = 2.0 * c87
    c122 = c16 * k1
    c123 = c10 * c62
    c124 = c123 * c49
    c125 = inv_k3 * inv_k3 * inv_k3
    A_0_leg_12 = (J_xy * c10 * c12 + J_xy * c10 * c3 - c109 - c124 + 3.0 * c12 * c49 * h_y * inv_L - c102 - c117
        * c118 + C_s * c10 * inv_k3 * w_k_omega - c119 - c120 + 2.0 * L_ddot * c10 * h_y + C_p * W_z + c10 * gamma_y
        * w_x + c10 * gamma_n * inv_k3 * w_y - c105 - c111 - 6.0 * c116 * c77 - c99 + 2.0 * W_z * h_z * inv_L
        * theta_dot - c104 - c121 * c122 + 2.0 * J_xz * W_z * c10 * c49 * theta_dot + c10 * c53 * own_z + 2.0
        * J_xx * W_z * c10 * c125 * k1 * theta_dot + 2.0 * h_y * inv_L * inv_k3 * k1 * own_y - c112 * c113 - c97
        - c114 * c115 + 3.0 * h_z * inv_L * inv_k3 * k1 * own_z)
    c126 = c10 * c22
    c127 = c10 * c23
    c128 = c10 * c24
    c129 = 2.0 * c108
    c130 = c129 * h_z
    c131 = c10 * c44
    c132 = c10 * c25
    c133 = c10 * c50
    c134 = W_z * c10
    c135 = c134 * c33
    c136 = c12 * c9
    c137 = 3.0 * c136
    c138 = c10 * c42
    c139 = c10 * c12
    c140 = c3 * c9
    c141 = c10 * c26
    c142 = 4.0 * W_z
    c143 = c142 * c81
    c144 = c143 * h_y
    c145 = (c140 - c137 + c10 * c28 - c10 * c39 + c10 * c30 + c10 * c32 - c141 + c122 * c93 + c144 * c49 + 2.0
        * c36 * inv_L - c144 - c20 * c91)
    A_0_leg_13 = (c131 - c130 - c133 + c137 * c49 + c139 * c55 * inv_k3 + 2.0 * c132 + c126 - C_p * theta_dot
        + c135 + c127 - c135 * c49 + c128 - c10 * c47 + c138 + c145)
    c146 = L_ddot * c10
    c147 = c146 * h_y
    c148 = c10 * gamma_y
    c149 = c100 * own_y
    c150 = L_dot * c106
    c151 = c150 * c17
    c152 = 3.0 * c123
    c153 = 4.0 * c115
    c154 = c142 * theta_dot
    c155 = c41 * inv_k3
    c156 = 4.0 * c61
    c157 = c150 * c16
    c158 = c17 * c83 * h_y
    c159 = W_z * c150
    c160 = c134 * theta_dot
    c161 = 6.0 * c160
    c162 = -2.0 * J_zz
    c163 = c162 + c75
    c164 = c125 * k1
    c165 = J_xx * c164
    A_0_leg_21 = (3.0 * c10 * c71 + c152 - 3.0 * c124 - c101 - c117 + c102 * c49 + c103 * c56 + c147 - 3.0 * c119
        - 3.0 * c120 + J_yz * c151 + c103 * c57 + c148 * w_x + c151 * c155 + c158 * c20 + c159 * c76 - c105
        + c149 * c20 + c156 * c157 - 2.0 * c111 - c159 * c163 - 2.0 * c99 + c161 * c165 - 2.0 * c104 - c116
        * c154 + J_xz * c161 * c49 + c112 * c163 + c114 * c89 - c112 * c76 - c153 * c40 - c97)
    c167 = L_ddot * c106
    c168 = c14 * inv_L
    c169 = c107 * inv_L * inv_L * inv_L * inv_L
    c170 = c10 * c3
    c171 = J_yy * c139
    c172 = c13 * inv_L
    c173 = 2.0 * J_xy
    c174 = c112 * c173
    c175 = c10 * own_y
    c176 = 2.0 * J_xz
    c177 = c175 * c176
    c178 = c148 * c49
    c179 = c139 * c49
    c180 = C_us * c150
    c181 = inv_k3 * inv_k3 * inv_k3 * inv_k3
    c182 = c181 * c75
    c183 = c49 * c91
    c184 = c159 * c173
    c185 = 2.0 * c86
    c186 = c10 * gamma_n
    c187 = c186 * c38
    c188 = c103 * own_y
    c189 = c10 * c43
    c190 = c184 * c49
    c191 = 2.0 * c61
    c192 = c191 * inv_k3
    c193 = c17 * c98
    c194 = W_z * c193
    c195 = c194 * c49
    c196 = 2.0 * c164
    c197 = c49 * c66
    c198 = c125 * c170
    c199 = 2.0 * c128
    c200 = c156 * inv_k3
    c201 = c125 * c160
    c202 = 4.0 * c201 * c41
    c203 = 2.0 * c46
    c204 = c157 * c203
    c205 = c164 * c75
    c206 = c205 * theta_dot
    c207 = c125 * c143 * c15
    c208 = c10 * g_k
    c209 = c129 * h_x - F * inv_L + c208 * c31 + c208 * c29 + C_p * c2 - c146 * c69 + c187 - c186 * c27
    A_0_leg_22 = (c169 * c76 + c170 * c182 + c179 * (J_yy + c75 - J_zz) - c113 * c170 - c139 * c182 - c170 * c53
        - c171 + c168 - c163 * c169 - c172 - c103 * g_k * w_z + c137 * c164 + c191 * c198 - c130 * c20 - 3.0
        * c164 * c189 + c167 * c53 + c169 * c200 + c170 * c192 - c140 * c196 - c140 * c21 - c113 * c167 - c167
        * c192 + 3.0 * c132 * c20 - c180 * c49 + c150 * c206 + c126 * c20 + c88 + c150 * c197 + c178 * w_y + c184
        + c187 * c49 - c126 * c164 + c177 + c188 * c55 + c209 - c141 * c20 - c195 - c86 + c185 * c49 + c207
        - c165 * c175 - c190 - c204 - c177 * c49 + c174 * c49 - c174 - c202 + c199 * c20 - 2.0 * c183)
    c210 = c3 * c98
    c211 = c12 * c98
    c212 = J_xy * c49
    c213 = c211 * c49
    c214 = c210 * c49
    c215 = c149 * c49
    c216 = c150 * c33
    c217 = c10 * k1
    c218 = c217 * c63
    c219 = c110 * c164
    c220 = c17 * c9
    c221 = c151 * c46 * inv_k3
    c222 = 2.0 * J_yz
    c223 = c9 * own_z
    c224 = c112 * c176
    c225 = c69 * c81
    c226 = c217 * c49
    c227 = 2.0 * c155
    c228 = c176 * c49
    c229 = (J_yz * c167 - c169 * c222 + c155 * c167 - c226 * c56 - c169 * c227 + W_z * c225 + c178 * w_z - c226
        * c57 + c153 * c73 - c159 * c228 + c154 * c164 * c9 - c160 * c163 - c156 * c201 + c224 * c49 - c118
        * c223)
    A_0_leg_23 = (c210 + c213 + c214 - c211 + c101 * c20 + c117 * c20 + c123 * c196 + c155 * c170 - c102 * c164
        - c218 - c147 * c20 + c158 + c149 + c219 * c70 + c221 - c216 + c175 * c212 - c158 * c49 - c159 * c205
        + c113 * c161 - c122 * c220 - c215 + c112 * c205 - J_xx * c161 * c181 + c229)
    c230 = 2.0 * J_yy
    c231 = c230 * theta_dot
    c232 = 2.0 * c41
    A_0_leg_31 = (6.0 * c189 - 3.0 * c133 + c118 * c136 + c139 * c20 * (3.0 * (J_xx + J_yy - J_zz)) + c132 + 2.0
        * c126 - c150 * c231 - c159 * c222 + J_xy * c161 + 2.0 * c127 - c157 * c232 - 6.0 * c10 * c46 * c73
        - c161 * c212 + c199 + 2.0 * c138 + c145)
    c233 = c173 * c175
    c234 = 4.0 * J_xz
    c236 = c230 + c163
    c237 = 4.0 * c122 * c9
    A_0_leg_32 = (3.0 * c213 - 2.0 * c211 - c214 + c102 * c20 + c109 * c20 + c152 * c164 + c117 * c196 - 3.0
        * c101 * c164 - 2.0 * c218 - c198 * c232 - 2.0 * c147 * c20 + W_z * c219 + c216 + c159 * c234 + 2.0
        * c149 + c188 * c203 - c216 * c49 - c221 - c70 * c87 + C_s * c103 * w_n_omega + c122 * c150 * c236 + c160
        * c49 * (4.0 * J_xx + c162 + c230) + c223 + c233 * c49 - c110 * c122 - c160 * c182 - 2.0 * c215 - c233
        + c112 * c165 - c224 - c237 * theta_dot - c217 * c40 * c54 + c229)
    A_0_leg_33 = (c169 * c230 + c171 - J_yy * c170 + c172 - c179 * c54 - c168 + c131 * c164 + 2.0 * c90 - c136
        * c196 - J_yy * c167 - c180 + c195 - c194 + c185 + c190 + c204 + c209 - c184 - c49 * c94 + c202 - c10
        * c18 * c41 - c207 + c183 - c112 * c212 + c95)
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
    c238 = c100 * c70
    c239 = c238 - c220
    A_1_leg_11 = C_p + c239
    c240 = c70 * c96
    c241 = c81 * c92
    A_1_leg_12 = c93 + c20 * c241 - c240 + c237
    c242 = c225 - 2.0 * c100 * c122
    A_1_leg_13 = c121 + c242
    c243 = c103 * c17
    A_1_leg_21 = (W_z * c10 * c163 - c193 - c243 * c41 - c134 * c76 - c153 * c16 - c240 + 2.0 * W_z * h_z * inv_L
        * inv_k3 * k1)
    c244 = c134 * c173
    c245 = c69 * c83
    c246 = c238 * c49
    c247 = c10 * c16
    c248 = c203 * c247
    c249 = c244 * c49
    A_1_leg_22 = (C_us * c10 * c49 + L_dot * c106 * c163 - c150 * c200 - c150 * c76 - c245 + 2.0 * L_dot * c10
        * h_z * inv_k3 * k1 - c10 * c206 + 2.0 * c49 * h_z * inv_L * theta_dot + c248 + c249 - c10 * c197 - c244
        - c246)
    c250 = c10 * c33
    c251 = c243 * c46
    c252 = c70 * c9
    c253 = c150 * c222 + c150 * c227 + c134 * c228 - c252 * c49
    A_1_leg_23 = c250 + c134 * c205 - c251 + c253
    A_1_leg_31 = c10 * c231 + c70 * c98 + c232 * c247 + c242
    A_1_leg_32 = (c241 - c20 * c93 + c251 + c250 * c49 + c252 - c241 * c49 - c250 - c134 * c234 - c16 * c217
        * c236 + c253)
    A_1_leg_33 = C_us * c10 - c150 * c230 - c245 + c244 + c246 - c239 - c248 - c249
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
    c254 = m_xy * omega_z
    c255 = m_xz * omega_y
    Y_xx = c254 - c255 + A_1_xx
    Y_xy = m_xz * omega_x - m_xx * omega_z + A_1_xy
    Y_xz = m_xx * omega_y - m_xy * omega_x + A_1_xz
    Y_yx = m_yy * omega_z - m_yz * omega_y + A_1_yx
    c256 = m_yz * omega_x
    Y_yy = c256 - c254 + A_1_yy
    Y_yz = m_xy * omega_y - m_yy * omega_x + A_1_yz
    Y_zx = m_yz * omega_z - m_zz * omega_y + A_1_zx
    Y_zy = m_zz * omega_x - m_xz * omega_z + A_1_zy
    Y_zz = c255 - c256 + A_1_zz
    c257 = X_xy * q_z
    Z_xx = X_xz * q_y - c257
    c258 = X_xx * q_z
    Z_xy = c258 - X_xz * q_x
    c259 = X_xx * q_y
    Z_xz = X_xy * q_x - c259
    c260 = X_yy * q_z
    Z_yx = X_yz * q_y - c260
    c261 = X_yx * q_z
    c262 = -X_yz * q_x
    Z_yy = c261 + c262
    c263 = -X_yy * q_x
    Z_yz = -X_yx * q_y - c263
    c264 = -X_zz * q_y
    Z_zx = -X_zy * q_z - c264
    c265 = -X_zz * q_x
    Z_zy = X_zx * q_z + c265
    c266 = X_zx * q_y
    Z_zz = X_zy * q_x - c266
    c267 = m_xy * w_q_z
    c268 = m_xz * w_q_y
    V_xx = c268 - f_S_dot_xx - c267 + Y_xz * q_y - Y_xy * q_z
    V_xy = m_xx * w_q_z - f_S_dot_yx - m_xz * w_q_x + Y_xx * q_z - Y_xz * q_x
    V_xz = m_xy * w_q_x - f_S_dot_zx - m_xx * w_q_y + Y_xy * q_x - Y_xx * q_y
    V_yx = m_yz * w_q_y - f_S_dot_xy - m_yy * w_q_z + Y_yz * q_y - Y_yy * q_z
    c269 = m_yz * w_q_x
    V_yy = c267 - f_S_dot_yy - c269 + Y_yx * q_z - Y_yz * q_x
    V_yz = m_yy * w_q_x - f_S_dot_zy - m_xy * w_q_y + Y_yy * q_x - Y_yx * q_y
    V_zx = m_zz * w_q_y - f_S_dot_xz - m_yz * w_q_z + Y_zz * q_y - Y_zy * q_z
    V_zy = m_xz * w_q_z - f_S_dot_yz - m_zz * w_q_x + Y_zx * q_z - Y_zz * q_x
    V_zz = c269 - f_S_dot_zz - c268 + Y_zy * q_x - Y_zx * q_y
    # derivative of the moment by rotation about the tip
    Q_xx = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx + c261 - c266
    Q_xy = f_S_dot_xz * omega_x - f_S_dot_xx * omega_z + f_S_xy - R_tip_z + c260 - X_zy * q_y
    Q_xz = f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz + R_tip_y + X_yz * q_z + c264
    Q_yx = f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx + R_tip_z + X_zx * q_x - c258
    Q_yy = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy + X_zy * q_x - c257
    Q_yz = f_S_dot_yx * omega_y - f_S_dot_yy * omega_x + f_S_yz - R_tip_x - X_xz * q_z - c265
    Q_zx = f_S_dot_zy * omega_z - f_S_dot_zz * omega_y + f_S_zx - R_tip_y + c259 - X_yx * q_x
    Q_zy = f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy + R_tip_x + X_xy * q_y + c263
    Q_zz = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz + X_xz * q_y + c262
    c270 = m_xy * q_z
    c271 = m_xz * q_y
    c272 = -m_yz * q_x
    # m [q]x
    m_q_xx = c270 - c271
    m_q_xy = m_xz * q_x - m_xx * q_z
    m_q_xz = m_xx * q_y - m_xy * q_x
    m_q_yx = m_yy * q_z - m_yz * q_y
    m_q_yy = -c270 - c272
    m_q_yz = m_xy * q_y - m_yy * q_x
    m_q_zx = m_yz * q_z - m_zz * q_y
    m_q_zy = m_zz * q_x - m_xz * q_z
    m_q_zz = c271 + c272
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


def place_blocks_24(on: Arithmetic, vv: Any, vw: Any, wv: Any, ww: Any, first: Any, A: Any) -> None:
    """Four 3 x 3 blocks, whose rows are ``ROW`` numbers apart, into six columns from ``first`` on."""
    for i in range(3):
        for j in range(3):
            A[i][first + j] = vv[3 * i + j]
            A[i][first + j + 3] = vw[3 * i + j]
            A[i + 3][first + j] = wv[3 * i + j]
            A[i + 3][first + j + 3] = ww[3 * i + j]


def place_symmetric_24(on: Arithmetic, parts: Any, row: Any, column: Any, A: Any) -> None:
    """A symmetric 3 x 3 block from xx xy xz yy yz zz."""
    for i in range(3):
        A[row][column + i] = parts[i]
        A[row + i][column] = parts[i]
    A[row + 1][column + 1] = parts[3]
    A[row + 1][column + 2] = parts[4]
    A[row + 2][column + 1] = parts[4]
    A[row + 2][column + 2] = parts[5]


def place_inertia_24(on: Arithmetic, vv: Any, vw: Any, ww: Any, first: Any, A: Any) -> None:
    """M into six columns from ``first`` on, from its parts, of which symmetric ones are xx xy xz yy yz
    zz.
    """
    for i in range(3):
        for j in range(3):
            A[i][first + j + 3] = vw[3 * i + j]
            A[j + 3][first + i] = vw[3 * i + j]
    place_symmetric_24(on, vv, 0, first, A)
    place_symmetric_24(on, ww, 3, first + 3, A)


def scale_moments_24(on: Arithmetic, per_length: Any, A: Any) -> None:
    """Multiplies the rows of moments by one over a length."""
    if on.anywhere(per_length != 1.0):
        for i in range(3, 6):
            for j in range(24):
                A[i][j] = A[i][j] * per_length


def substitute_back_24(on: Arithmetic, A: Any, inverse: Any) -> None:
    """Substitutes back; ``inverse`` contains the reciprocals of the pivots."""
    row = [0.0] * 24
    for k in range(5, -1, -1):
        for j in range(6, 24):
            row[j] = A[k][j] * inverse[k]
            A[k][j] = row[j]
        for i in range(k):
            factor = A[i][k]
            for j in range(6, 24):
                A[i][j] = A[i][j] - factor * row[j]


def clear_below_24(on: Arithmetic, A: Any, k: Any, inverse: Any) -> None:
    """Subtracts multiples of row k from the rows below, so that their column k, which is not stored, is
    zero.

    ``row`` is a copy, because compilers then know that it differs from the rows that change.
    """
    row = [0.0] * 24
    for j in range(24):
        row[j] = A[k][j]
    for i in range(k + 1, 6):
        factor = A[i][k] * inverse
        for j in range(24):
            A[i][j] = A[i][j] - factor * row[j]


def solve_pivoted_24(on: Arithmetic, A: Any) -> Any:
    """Solves the rows [H | Y] for X, which replaces Y, by elimination with partial pivoting. Returns 1
    if a pivot is small.
    """
    inverse = [0.0] * 6
    suspect = 0
    for k in range(6):
        pivot = k
        most = on.size(A[k][k])
        for i in range(k + 1, 6):
            entry = on.size(A[i][k])
            pivot = on.where(entry > most, i, pivot)
            most = on.where(entry > most, entry, most)
        if on.anywhere(pivot != k):
            for j in range(24):
                moved = A[k][j]
                A[k][j] = on.at(A, pivot, j)
                on.put(A, moved, pivot, j)
        suspect = on.where(on.size(A[k][k]) > on.SUSPECT, suspect, 1)
        inverse[k] = 1.0 / A[k][k]
        clear_below_24(on, A, k, inverse[k])
    substitute_back_24(on, A, inverse)
    return suspect


def check_derivatives(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(6):
        lost = lost + 0.0 * out.F[i]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.by_pose[i][j]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.by_twist[i][j]
    for i in range(6):
        for j in range(6):
            lost = lost + 0.0 * out.by_acceleration[i][j]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(6):
        out.F[i] = on.where(out.status == OK, out.F[i], on.NAN)
    for i in range(6):
        for j in range(6):
            out.by_pose[i][j] = on.where(out.status == OK, out.by_pose[i][j], on.NAN)
    for i in range(6):
        for j in range(6):
            out.by_twist[i][j] = on.where(out.status == OK, out.by_twist[i][j], on.NAN)
    for i in range(6):
        for j in range(6):
            out.by_acceleration[i][j] = on.where(out.status == OK, out.by_acceleration[i][j], on.NAN)


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


def with_acceleration(on: Arithmetic, motion: Any, a: Any, alpha: Any) -> Any:
    """The motion with these accelerations."""
    out = Motion()
    for i in range(9):
        out.R[i] = motion.R[i]
    for i in range(3):
        out.t[i] = motion.t[i]
        out.omega[i] = motion.omega[i]
        out.v[i] = motion.v[i]
        out.alpha[i] = alpha[i]
        out.a[i] = a[i]
        out.F_ext[i] = motion.F_ext[i]
        out.M_ext[i] = motion.M_ext[i]
    return out


def solve_definite_24(on: Arithmetic, A: Any, kept: Any) -> Any:
    """Solves the rows [M | Y] for X, which replaces Y, by L D L^T.

    Returns MASS_MATRIX_INDEFINITE if a pivot is at most ``kept`` times its diagonal entry.
    """
    scale = [0.0] * 6
    inverse = [0.0] * 6
    status = OK
    for k in range(6):
        scale[k] = A[k][k]
    for k in range(6):
        fault = on.where(on.size(A[k][k]) <= on.MAX, MASS_MATRIX_INDEFINITE, NOT_FINITE)
        fault = on.where(A[k][k] > kept * scale[k], OK, fault)
        status = on.where(status == OK, fault, status)
        inverse[k] = 1.0 / A[k][k]
        clear_below_24(on, A, k, inverse[k])
    substitute_back_24(on, A, inverse)
    return status


def check_linearization(on: Arithmetic, out: Any) -> None:
    """Set the status if a number of a result is not finite, and NaN for all results if it is not OK."""
    lost = 0.0
    for i in range(3):
        lost = lost + 0.0 * out.a[i]
    for i in range(3):
        lost = lost + 0.0 * out.alpha[i]
    for i in range(12):
        for j in range(12):
            lost = lost + 0.0 * out.A[i][j]
    for i in range(12):
        for j in range(6):
            lost = lost + 0.0 * out.B[i][j]
    out.status = on.where((out.status != OK) | (lost == 0.0), out.status, NOT_FINITE)
    for i in range(3):
        out.a[i] = on.where(out.status == OK, out.a[i], on.NAN)
    for i in range(3):
        out.alpha[i] = on.where(out.status == OK, out.alpha[i], on.NAN)
    for i in range(12):
        for j in range(12):
            out.A[i][j] = on.where(out.status == OK, out.A[i][j], on.NAN)
    for i in range(12):
        for j in range(6):
            out.B[i][j] = on.where(out.status == OK, out.B[i][j], on.NAN)


def joint_slopes_pose(on: Arithmetic, platform: Any, motion: Any) -> Any:
    """The platform's part of the derivatives of the wrench: 359 (180 mul, 179 add, 0 div, 0 sqrt)."""
    R_xx, R_xy, R_xz, R_yx, R_yy, R_yz, R_zx, R_zy, R_zz = motion.R
    omega_x, omega_y, omega_z = motion.omega
    alpha_x, alpha_y, alpha_z = motion.alpha
    a_x, a_y, a_z = motion.a
    F_ext_x, F_ext_y, F_ext_z = motion.F_ext
    M_ext_x, M_ext_y, M_ext_z = motion.M_ext
    C_P = platform.C_P
    g_x, g_y, g_z = platform.g
    M = platform.M
    R_0_x, R_0_y, R_0_z = platform.R_0
    I_p_xx, I_p_xy, I_p_xz, I_p_yy, I_p_yz, I_p_zz = platform.I_p
    c1 = R_0_y * R_0_y
    c2 = R_0_z * R_0_z
    J_0_xx = I_p_xx + M * (c1 + c2)
    c3 = M * R_0_x
    J_0_xy = I_p_xy - R_0_y * c3
    J_0_xz = I_p_xz - R_0_z * c3
    c4 = R_0_x * R_0_x
    J_0_yy = I_p_yy + M * (c2 + c4)
    c5 = M * R_0_y
    J_0_yz = I_p_yz - R_0_z * c5
    J_0_zz = I_p_zz + M * (c1 + c4)
    c6 = M * R_0_z
    # (30) first moment of the platform, base frame
    h_base_x = R_xx * c3 + R_xy * c5 + R_xz * c6
    h_base_y = R_yx * c3 + R_yy * c5 + R_yz * c6
    h_base_z = R_zx * c3 + R_zy * c5 + R_zz * c6
    c7 = J_0_xy * R_xy + J_0_xz * R_xz + J_0_xx * R_xx
    c8 = J_0_xy * R_xx + J_0_yz * R_xz + J_0_yy * R_xy
    c9 = J_0_xz * R_xx + J_0_yz * R_xy + J_0_zz * R_xz
    c10 = J_0_xy * R_yy + J_0_xz * R_yz + J_0_xx * R_yx
    c11 = J_0_xy * R_yx + J_0_yz * R_yz + J_0_yy * R_yy
    c12 = J_0_xz * R_yx + J_0_yz * R_yy + J_0_zz * R_yz
    # (32) inertia of the platform, base frame
    J_base_xx = R_xx * c7 + R_xy * c8 + R_xz * c9
    J_base_xy = R_yx * c7 + R_yy * c8 + R_yz * c9
    J_base_xz = R_zx * c7 + R_zy * c8 + R_zz * c9
    J_base_yy = R_yx * c10 + R_yy * c11 + R_yz * c12
    J_base_yz = R_zx * c10 + R_zy * c11 + R_zz * c12
    J_base_zz = (R_zx * (J_0_xy * R_zy + J_0_xz * R_zz + J_0_xx * R_zx) + R_zy * (J_0_xy * R_zx + J_0_yz * R_zz
        + J_0_yy * R_zy) + R_zz * (J_0_xz * R_zx + J_0_yz * R_zy + J_0_zz * R_zz))
    c13 = h_base_y * omega_z
    c14 = h_base_z * omega_y
    c15 = h_base_x * omega_z
    c16 = h_base_z * omega_x
    c17 = h_base_x * omega_y
    c18 = h_base_y * omega_x
    # (31) omega x h
    w_h_x = c14 - c13
    w_h_y = c15 - c16
    w_h_z = c18 - c17
    c19 = J_base_xy * omega_y
    c20 = J_base_xz * omega_z
    c21 = J_base_xy * omega_x
    c22 = J_base_yz * omega_z
    c23 = J_base_xz * omega_x
    c24 = J_base_yz * omega_y
    # (34) I omega
    J_w_x = J_base_xx * omega_x + c19 + c20
    J_w_y = J_base_yy * omega_y + c21 + c22
    J_w_z = J_base_zz * omega_z + c23 + c24
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
    c25 = J_base_xy * alpha_y
    c26 = J_base_xz * alpha_z
    J_alpha_x = J_base_xx * alpha_x + c25 + c26
    c27 = J_base_xy * alpha_x
    c28 = J_base_yz * alpha_z
    J_alpha_y = J_base_yy * alpha_y + c27 + c28
    c29 = J_base_xz * alpha_x
    c30 = J_base_yz * alpha_y
    J_alpha_z = J_base_zz * alpha_z + c29 + c30
    # (33) a - g
    rise_x = a_x - g_x
    rise_y = a_y - g_y
    rise_z = a_z - g_z
    F_load_x = F_ext_x * R_xx + F_ext_y * R_xy + F_ext_z * R_xz
    F_load_y = F_ext_x * R_yx + F_ext_y * R_yy + F_ext_z * R_yz
    F_load_z = F_ext_x * R_zx + F_ext_y * R_zy + F_ext_z * R_zz
    M_load_x = M_ext_x * R_xx + M_ext_y * R_xy + M_ext_z * R_xz
    M_load_y = M_ext_x * R_yx + M_ext_y * R_yy + M_ext_z * R_yz
    M_load_z = M_ext_x * R_zx + M_ext_y * R_zy + M_ext_z * R_zz
    c31 = J_base_xy * omega_z
    c32 = J_base_xz * omega_y
    c34 = c23 - J_base_xx * omega_z + J_w_z
    c35 = c21 - J_base_xx * omega_y + J_w_y
    c36 = c24 - J_base_yy * omega_z + J_w_z
    c37 = J_base_yz * omega_x
    c39 = c31 - c37
    c40 = c19 - J_base_yy * omega_x + J_w_x
    c41 = c22 - J_base_zz * omega_y + J_w_y
    c42 = c20 - J_base_zz * omega_x + J_w_x
    # derivative of I omega by dphi at fixed omega
    spin_xx = c31 - c32
    spin_xy = c34
    spin_xz = -c35
    spin_yx = -c36
    spin_yy = -c39
    spin_yz = c40
    spin_zx = c41
    spin_zy = -c42
    spin_zz = c32 - c37
    c43 = J_base_xz * alpha_y
    c44 = h_base_y * rise_y
    c45 = h_base_z * rise_z
    c46 = J_base_xy * alpha_z
    c47 = h_base_x * rise_x
    c48 = J_base_yz * alpha_x
    c49 = h_base_y * omega_y
    c50 = h_base_z * omega_z
    c51 = h_base_x * omega_x
    out = JointSlopesPose()
    out.B = [B_xx, B_xy, B_xz, B_yx, B_yy, B_yz, B_zx, B_zy, B_zz]
    out.M_vv = [M, 0.0, 0.0, M, 0.0, M]
    out.M_vw = [0.0, h_base_z, -h_base_y, -h_base_z, 0.0, h_base_x, h_base_y, -h_base_x, 0.0]
    out.M_ww = [J_base_xx, J_base_xy, J_base_xz, J_base_yy, J_base_yz, J_base_zz]
    out.W_ft = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fr = [
        B_xz * h_base_y - B_xy * h_base_z,
        B_xx * h_base_z - F_load_z - B_xz * h_base_x,
        F_load_y + B_xy * h_base_x - B_xx * h_base_y,
        F_load_z + B_yz * h_base_y - B_yy * h_base_z,
        B_yx * h_base_z - B_yz * h_base_x,
        B_yy * h_base_x - F_load_x - B_yx * h_base_y,
        B_zz * h_base_y - F_load_y - B_zy * h_base_z,
        F_load_x + B_zx * h_base_z - B_zz * h_base_x,
        B_zy * h_base_x - B_zx * h_base_y,
    ]
    out.W_mt = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mr = [
        c46 + omega_y * spin_zx - c43 - c44 - c45 - omega_z * spin_yx,
        J_alpha_z + c29 + h_base_x * rise_y + omega_y * spin_zy - M_load_z - J_base_xx * alpha_z - omega_z * spin_yy,
        M_load_y + J_base_xx * alpha_y + h_base_x * rise_z + omega_y * spin_zz - J_alpha_y - c27 - omega_z * spin_yz,
        M_load_z + J_base_yy * alpha_z + h_base_y * rise_x + omega_z * spin_xx - J_alpha_z - c30 - omega_x * spin_zx,
        c48 + omega_z * spin_xy - c45 - c46 - c47 - omega_x * spin_zy,
        J_alpha_x + c25 + h_base_y * rise_z + omega_z * spin_xz - M_load_x - J_base_yy * alpha_x - omega_x * spin_zz,
        J_alpha_y + c28 + h_base_z * rise_x + omega_x * spin_yx - M_load_y - J_base_zz * alpha_y - omega_y * spin_xx,
        M_load_x + J_base_zz * alpha_x + h_base_z * rise_y + omega_x * spin_yy - J_alpha_x - c26 - omega_y * spin_xy,
        c43 + omega_x * spin_yz - c44 - c47 - c48 - omega_y * spin_xz,
    ]
    out.W_fv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fw = [
        c49 + c50,
        w_h_z - c17,
        -c15 - w_h_y,
        -c18 - w_h_z,
        c50 + c51,
        w_h_x - c13,
        w_h_y - c16,
        -c14 - w_h_x,
        c49 + c51,
    ]
    out.W_mv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mw = [C_P + c32 - c31, c36, -c41, -c34, C_P + c39, c42, c35, -c40, C_P + c37 - c32]
    return out


def joint_slopes_leg(on: Arithmetic, leg: Any, platform: Any, motion: Any, pose: Any, given: Any) -> Any:
    """One leg's part of the derivatives of the wrench, and its generalized forces' derivatives: 2040
    (1287 mul, 749 add, 2 div, 2 sqrt).
    """
    b_x, b_y, b_z = leg.b
    p_x, p_y, p_z = leg.p
    k_x, k_y, k_z = leg.k
    m_u, C_p, C_s = leg.m_u, leg.C_p, leg.C_s
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
    c15 = inv_L * inv_L
    c16 = L_dot * c15
    c17 = 2.0 * h_y
    c18 = W_z * c17
    c19 = h_y * inv_L
    c20 = W_z * inv_k3
    c21 = c20 * k1
    c22 = 4.0 * c21
    c23 = c22 * theta_dot
    c24 = c14 * h_z
    c25 = c24 * inv_L
    c26 = inv_k3 * k1
    tau_S_leg_11 = (2.0 * c14 * h_x * inv_L + 2.0 * c3 * h_x * inv_L - 4.0 * c25 * c26 + 2.0 * L_dot * c15 * h_z
        * theta_dot - c16 * c18 - c13 * inv_L + h_y * inv_L * own_z - c19 * c23)
    c27 = 2.0 * h_x
    c28 = c27 * inv_L
    c29 = c28 * own_z
    c30 = axial * m_u
    c31 = c30 * fall_T_y
    c32 = L_ddot * c15
    c33 = c15 * w_x
    c34 = c33 * gamma_y
    c35 = c19 * c3
    c36 = h_z * inv_L
    c37 = 2.0 * theta_dot
    c38 = c36 * c37
    c39 = h_y * own_y
    c40 = inv_L * k1
    c41 = c40 * inv_k3
    c42 = h_z * own_z
    c43 = J_zz * own_z
    c44 = c15 * c43
    c45 = c14 * c19
    c46 = L_dot * L_dot
    c47 = inv_L * inv_L * inv_L
    c48 = c46 * c47
    c49 = axial * c16
    c50 = inv_k3 * inv_k3
    c51 = 4.0 * W_z
    c52 = 2.0 * c50
    c53 = 4.0 * c16
    c54 = h_y * k1
    c55 = c54 * inv_k3
    c56 = c16 * c37
    tau_S_leg_12 = (c35 - c17 * c48 + c45 * c52 - c45 - c35 * c52 + c32 * h_y + c34 + C_p * W_z + W_z * c38
        + c31 * inv_L + W_z * c27 * c49 - axial * c34 - c55 * c56 + c39 * c41 + axial * c29 + c41 * c42 - c21
        * c53 * h_z - c29 - c36 * c50 * c51 * theta_dot + axial * c44 - c44)
    c57 = c27 * own_y
    c58 = c57 * inv_L
    c59 = c30 * fall_T_z
    c60 = J_yy * c15 * own_y
    c61 = L_ddot * h_z
    c62 = c3 * h_z
    c63 = W_z * c37
    c64 = c19 * c63
    c65 = c33 * g_k * k3
    c66 = gamma_n * k1
    c67 = c33 * c66
    c68 = 2.0 * h_z
    c69 = c27 * theta_dot
    c70 = 2.0 * W_z
    c71 = c55 * c70
    c73 = J_yy - J_zz
    c74 = c14 * inv_k3
    c75 = c74 * k1
    c76 = c15 * c75
    tau_S_leg_13 = (c62 * inv_L - c48 * c68 + c25 * c52 - c25 + c65 - axial * c65 + c73 * c76 - axial * c73
        * c76 + c15 * c61 + c59 * inv_L - C_p * theta_dot + c67 - c49 * c69 + c16 * c71 + c50 * c64 + c58 + c60
        - axial * c67 - c64 - axial * c58 - axial * c60)
    c78 = C_us * inv_L
    c79 = c78 * theta_dot
    c80 = 2.0 * J_yy
    c81 = inv_L * own_y
    c82 = J_yz * inv_L
    c83 = c17 * theta_dot
    c84 = W_z * c83
    c85 = axial * c57
    c86 = J_yy * inv_L
    c87 = axial * c86
    c88 = inv_L * theta_dot
    c89 = J_xy * c88
    c90 = c51 * c89
    c91 = inv_L * k3
    c92 = c91 * w_x
    c93 = c92 * g_k
    c94 = inv_L * w_x
    c95 = c66 * c94
    c96 = J_xz * c14
    c97 = 4.0 * inv_L
    c98 = J_xy * inv_L
    c99 = c98 * k1
    c100 = c99 * inv_k3
    c101 = axial * c2
    c102 = c16 * c80
    c103 = 2.0 * J_yz
    c104 = c103 * c16
    c105 = c50 * c84
    c106 = c24 * c50
    c107 = 2.0 * c96
    c108 = c50 * inv_L
    c109 = 2.0 * k1
    c110 = J_xy * c16
    c111 = c109 * c110
    c112 = c40 * c74
    c113 = 2.0 * J_xx
    tau_S_leg_21 = (c24 - c62 - c106 + c107 * c108 - c96 * c97 + axial * c93 - c93 + c112 * (3.0 * J_zz - 3.0
        * J_yy - c113) + axial * c112 * c73 - c59 + c102 * theta_dot + c101 * c69 - c79 + W_z * c104 + c84 + axial
        * c95 + c111 * c20 + c87 * own_y - c95 + c50 * c90 + c85 - c105 - c57 - c90 - c2 * c71 - c80 * c81 + c23
        * c82 - c100 * own_z - c82 * own_z)
    c114 = c98 * own_y
    c115 = W_z * c69
    c116 = gamma_y * inv_L * w_z
    c117 = c14 * c82
    c118 = C_s * inv_L
    c119 = W_z * c78 * inv_k3
    c120 = c31 * k1
    c121 = J_yz * c32
    c122 = c3 * c82
    c123 = k1 * own_y
    c124 = c123 * c82
    c125 = inv_k3 * own_z
    c126 = axial * k1
    c127 = c126 * c27
    c128 = axial * c43
    c129 = c110 * c37
    c130 = J_xz * W_z
    c131 = c130 * c53
    c132 = J_xz * k1
    c133 = c126 * c94
    c134 = J_xy * k1
    c135 = c134 * c32
    c136 = W_z * c68
    c137 = c136 * c50
    c138 = inv_k3 * inv_k3 * inv_k3
    c139 = c136 * k1
    c140 = c139 * theta_dot
    c141 = c2 * c27
    c142 = c126 * c141
    c143 = 2.0 * c54
    c144 = c138 * c14
    c145 = c138 * c3
    c146 = c40 * own_z
    c147 = c130 * c88
    c148 = J_yz * k1
    c149 = -2.0 * J_zz
    c150 = c113 + c149
    c151 = J_xy * c109 * c48
    c152 = 2.0 * c99
    c153 = J_xz * c70
    c154 = c15 * c46
    c155 = c80 + c150
    c157 = W_z * c50
    tau_S_leg_22 = (c103 * c48 + c117 + c122 * c52 - c122 - c117 * c52 + c74 * c99 + c143 * c144 + c145 * c152
        + c3 * c55 - c54 * c74 + c151 * inv_k3 - c100 * c3 - c143 * c145 - c144 * c152 - 2.0 * c154 * c55 + L_ddot
        * c19 * c26 - c121 - c135 * inv_k3 + c2 * c83 + c129 * c50 - c129 + W_z * c150 * c88 + c114 + c120 * inv_k3
        + c142 * c20 + c148 * c56 * inv_k3 - c115 - c116 - c133 * gamma_y * inv_k3 - c2 * c50 * c83 + c119 * k1
        + c2 * c51 * h_z + c39 * c50 - c131 - c39 + c109 * c138 * c147 + c153 * c16 * c50 + c42 - c114 * c50
        - 4.0 * c132 * c20 * c88 - c137 * c2 - c155 * c157 * c88 + c125 * c127 + c23 * h_z - c118 * inv_k3 * w_n_omega
        - c124 * inv_k3 - c138 * c140 - c155 * c16 * c21 + c128 * c41 + c146 * c73 * inv_k3)
    c158 = g_k * k1
    c159 = gamma_n * w_z
    c160 = h_y * own_z
    c161 = c51 * c88
    c162 = c138 * c161
    c163 = c16 * c20
    c164 = c107 * c40
    c165 = J_xx + c73
    tau_S_leg_23 = (J_yy * c3 * inv_L - c14 * c27 - c154 * c27 - c48 * c80 + c14 * c165 * c50 * inv_L - c14
        * c86 - c91 * g_k * w_z - c158 * c94 + C_us * L_dot * c15 + 2.0 * c138 * c14 * h_z * k1 - c138 * c164
        + fall_T_x * m_u + J_yy * L_ddot * c15 + 2.0 * L_ddot * h_x * inv_L + gamma_n * inv_L * k3 * w_x - c159
        * c40 - c13 - c18 * c2 - c55 * c63 + 2.0 * J_xy * L_dot * W_z * c15 + 2.0 * J_yz * W_z * inv_L * theta_dot
        - c110 * c50 * c70 - 2.0 * c148 * c163 - c50 * c63 * c82 + 2.0 * L_dot * W_z * c50 * h_y * inv_L + 4.0
        * W_z * c138 * h_y * k1 * theta_dot - c134 * c162 + 2.0 * J_xy * W_z * inv_L * inv_k3 * k1 * theta_dot
        + J_xy * c50 * inv_L * own_z - c160 * c50)
    c166 = c27 * k3
    c167 = c166 * own_z
    c168 = c92 * gamma_y
    c169 = c74 * h_y
    c170 = J_xx * inv_k3
    c171 = c170 * inv_L
    c172 = 2.0 * J_xz
    c173 = c82 * k3
    c174 = c136 * inv_k3
    c175 = J_xz * c20
    c176 = 4.0 * c88
    c177 = 2.0 * k3
    c178 = c177 * c98
    c179 = W_z * c166
    c180 = c91 * own_z
    c181 = J_yz * k3
    c182 = c50 * k1
    c184 = -W_z * c150 * k3
    tau_S_leg_31 = (c169 + c14 * c178 + c178 * c3 - 2.0 * c74 * c98 - c109 * c117 - c109 * c122 + c111 * theta_dot
        + c168 + c181 * c56 + c31 * k3 + c101 * c179 - axial * c168 + c113 * c163 + c131 * k1 + c175 * c176
        - c119 - c173 * own_y + J_xx * c161 * c182 + c16 * c184 - c114 * k1 - c139 * c2 - c174 * theta_dot + axial
        * c167 + c180 * (J_xx + c149) - c167 - c171 * own_z + c128 * c91 - c146 * c172)
    c185 = k3 * own_z
    c186 = c94 * gamma_n
    c187 = c172 * inv_k3
    c188 = c109 * c62
    c189 = c109 * c89
    c190 = c68 * theta_dot
    c191 = c2 * k3
    c192 = c113 * inv_L
    c193 = c68 * k1
    c194 = J_xx - J_zz
    tau_S_leg_32 = (2.0 * J_xx * c138 * c3 * inv_L - c144 * c192 + c14 * c165 * inv_L * inv_k3 + c14 * inv_L
        * k3 * (J_xx - J_yy) + 2.0 * c3 * h_x * k3 + 2.0 * J_xx * c46 * c47 * inv_k3 + axial * c14 * c73 * inv_L
        * k3 + 2.0 * c15 * c46 * h_x * k3 - c150 * c46 * c47 * k3 - c171 * c3 - c194 * c3 * inv_L * k3 - axial
        * c14 * c73 * inv_L * inv_k3 - c154 * c193 - c164 - c188 + 2.0 * J_xz * c3 * inv_L * k1 + 4.0 * J_xz
        * c46 * c47 * k1 + 2.0 * c14 * c50 * h_z * k1 + g_k * inv_L * k1 * k3 * w_x - axial * c158 * c92 - c164
        * c50 - c188 * c50 + 2.0 * J_xz * c3 * c50 * inv_L * k1 - C_us * c16 * inv_k3 + L_ddot * c15 * c194
        * k3 - L_ddot * c166 * inv_L - c170 * c32 - fall_T_x * k3 * m_u + 2.0 * L_ddot * h_z * inv_L * k1 - J_xz
        * c109 * c32 + axial * fall_T_z * k1 * m_u - c182 * c79 - c190 * c191 + gamma_y * inv_L * inv_k3 * w_y
        - axial * c186 - c126 * c2 * c69 - c186 * c8 + 2.0 * J_xz * L_dot * c15 * inv_k3 * theta_dot + axial
        * c8 * gamma_n * inv_L * w_x + gamma_n * inv_L * inv_k3 * k1 * w_z - W_z * c189 - 2.0 * c110 * c20 - c157
        * c189 - c173 * c63 + 2.0 * J_xx * L_dot * c15 * c50 * k1 * theta_dot + c165 * inv_L * k1 * own_y + 2.0
        * h_z * inv_k3 * own_y - c123 * c87 - 2.0 * c13 * k3 - c148 * c16 * c70 - c187 * c81 + 2.0 * J_xy * L_dot
        * W_z * c15 * k3 + 2.0 * J_xz * inv_L * k3 * own_y + 2.0 * W_z * c50 * h_y * k1 * theta_dot - J_xx * c108
        * c123 - c85 * k1 + J_xy * inv_L * inv_k3 * own_z + J_yz * inv_L * k1 * own_z - c160 * inv_k3 - c185
        * c98)
    c196 = J_xx * c146
    c197 = c157 * k1
    c198 = J_xy * k3
    c199 = c172 * c20
    c200 = 2.0 * c181
    c201 = c14 * c50
    c202 = c113 * c197
    tau_S_leg_33 = (c122 * c177 - c200 * c48 + c201 * c99 + c152 * c3 - c201 * c54 - c151 + c135 + c121 * k3
        + c133 * gamma_y + c148 * c56 + c115 * k3 + c116 * k3 - W_z * c142 - c120 - c198 * c56 + c114 * k3 + c130
        * c176 * k1 + c161 * c170 + c174 * c2 + c197 * c78 - c136 * c191 + c137 * k1 * theta_dot + c184 * c88
        - c124 - c140 - c16 * c199 + c172 * c180 + c196 - J_xx * c162 - c109 * c147 * c50 - c127 * own_z - c16
        * c202 + c196 * c50 - c177 * c42 - c128 * c40)
    # derivatives of the generalized forces by the tip's motion
    tau_S_xx = s_x * tau_S_leg_11 + tau_S_leg_13 * z_x + tau_S_leg_12 * y_x
    tau_S_xy = s_y * tau_S_leg_11 + tau_S_leg_13 * z_y + tau_S_leg_12 * y_y
    tau_S_xz = s_z * tau_S_leg_11 + tau_S_leg_13 * z_z + tau_S_leg_12 * y_z
    tau_S_yx = s_x * tau_S_leg_21 + tau_S_leg_23 * z_x + tau_S_leg_22 * y_x
    tau_S_yy = s_y * tau_S_leg_21 + tau_S_leg_23 * z_y + tau_S_leg_22 * y_y
    tau_S_yz = s_z * tau_S_leg_21 + tau_S_leg_23 * z_z + tau_S_leg_22 * y_z
    tau_S_zx = s_x * tau_S_leg_31 + tau_S_leg_33 * z_x + tau_S_leg_32 * y_x
    tau_S_zy = s_y * tau_S_leg_31 + tau_S_leg_33 * z_y + tau_S_leg_32 * y_y
    tau_S_zz = s_z * tau_S_leg_31 + tau_S_leg_33 * z_z + tau_S_leg_32 * y_z
    tau_S_dot_leg_11 = C_p - c38 + c19 * c70
    c203 = c109 * c19
    tau_S_dot_leg_12 = c16 * c17 + c203 * inv_k3 * theta_dot - W_z * c28 + c22 * c36
    tau_S_dot_leg_13 = c16 * c68 + c27 * c88 - c20 * c203
    tau_S_dot_leg_21 = 2.0 * W_z * h_y * inv_k3 * k1 - c69 - c80 * c88 - c152 * c20 - c70 * c82
    c204 = c109 * c82
    c205 = c204 * theta_dot
    tau_S_dot_leg_22 = (2.0 * L_dot * h_y * inv_L * inv_k3 * k1 - c104 - c111 * inv_k3 - c83 + 2.0 * J_xy * inv_L
        * theta_dot + 2.0 * c50 * h_y * theta_dot - c205 * inv_k3 - c136 - 2.0 * c50 * c89 + 4.0 * J_xz * W_z
        * inv_L + 2.0 * W_z * c50 * h_z + W_z * c155 * inv_L * inv_k3 * k1 - c108 * c153)
    c206 = c70 * c98
    tau_S_dot_leg_23 = c102 - c78 + c141 - c190 + c18 + c20 * c204 + c206 * c50 - c18 * c50 - c206
    tau_S_dot_leg_31 = (W_z * c150 * inv_L * k3 - c173 * c37 - c179 - c189 + 2.0 * W_z * h_z * k1 - c192 * c20
        - c130 * c97 * k1)
    tau_S_dot_leg_32 = (C_us * inv_L * inv_k3 + L_dot * c15 * c150 * k3 - c166 * c2 + 2.0 * L_dot * h_z * inv_L
        * k1 - c113 * c16 * inv_k3 - c132 * c53 + 2.0 * h_z * inv_k3 * theta_dot - c187 * c88 - W_z * c178 - c113
        * c182 * c88 - c18 * inv_k3 + 2.0 * J_xy * W_z * inv_L * inv_k3 + 2.0 * J_yz * W_z * inv_L * k1)
    tau_S_dot_leg_33 = c16 * c200 + c111 - c205 + 2.0 * c198 * c88 + c113 * c157 * c40 + c199 * inv_L - c174
    # derivatives of the generalized forces by the tip's motion
    tau_S_dot_xx = s_x * tau_S_dot_leg_11 + tau_S_dot_leg_13 * z_x + tau_S_dot_leg_12 * y_x
    tau_S_dot_xy = s_y * tau_S_dot_leg_11 + tau_S_dot_leg_13 * z_y + tau_S_dot_leg_12 * y_y
    tau_S_dot_xz = s_z * tau_S_dot_leg_11 + tau_S_dot_leg_13 * z_z + tau_S_dot_leg_12 * y_z
    tau_S_dot_yx = s_x * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_x + tau_S_dot_leg_22 * y_x
    tau_S_dot_yy = s_y * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_y + tau_S_dot_leg_22 * y_y
    tau_S_dot_yz = s_z * tau_S_dot_leg_21 + tau_S_dot_leg_23 * z_z + tau_S_dot_leg_22 * y_z
    tau_S_dot_zx = tau_S_dot_leg_33 * z_x + s_x * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_x
    tau_S_dot_zy = tau_S_dot_leg_33 * z_y + s_y * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_y
    tau_S_dot_zz = tau_S_dot_leg_33 * z_z + s_z * tau_S_dot_leg_31 + tau_S_dot_leg_32 * y_z
    tau_S_ddot_leg_12 = -c19
    tau_S_ddot_leg_13 = -c36
    tau_S_ddot_leg_22 = c82 + c100 - c55
    c207 = L * m_u
    tau_S_ddot_leg_23 = -c27 - c86 - c207
    c208 = h_y * k3
    tau_S_ddot_leg_31 = -c208
    tau_S_ddot_leg_32 = c166 + c207 * k3 + c171 - c194 * c91 + c172 * c40 - c193
    tau_S_ddot_leg_33 = h_y * k1 - c173 - c99
    # derivatives of the generalized forces by the tip's motion
    tau_S_ddot_xx = m_u * s_x + tau_S_ddot_leg_13 * z_x + tau_S_ddot_leg_12 * y_x
    tau_S_ddot_xy = m_u * s_y + tau_S_ddot_leg_13 * z_y + tau_S_ddot_leg_12 * y_y
    tau_S_ddot_xz = m_u * s_z + tau_S_ddot_leg_13 * z_z + tau_S_ddot_leg_12 * y_z
    tau_S_ddot_yx = h_z * s_x + tau_S_ddot_leg_23 * z_x + tau_S_ddot_leg_22 * y_x
    tau_S_ddot_yy = h_z * s_y + tau_S_ddot_leg_23 * z_y + tau_S_ddot_leg_22 * y_y
    tau_S_ddot_yz = h_z * s_z + tau_S_ddot_leg_23 * z_z + tau_S_ddot_leg_22 * y_z
    tau_S_ddot_zx = s_x * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_x + tau_S_ddot_leg_32 * y_x
    tau_S_ddot_zy = s_y * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_y + tau_S_ddot_leg_32 * y_y
    tau_S_ddot_zz = s_z * tau_S_ddot_leg_31 + tau_S_ddot_leg_33 * z_z + tau_S_ddot_leg_32 * y_z
    c209 = 1.0 - axial
    c210 = L * k1
    c211 = (axial * net_z + c209 * (J_xy * c14 * inv_k3 - C_s * w_k_omega + L * c14 * h_y * k3 + L * c3 * h_y
        * k3 - c14 * c198 - c198 * c3 - L * c169 + J_yz * c14 * k1 + J_yz * c3 * k1 - L_ddot * c208 + gamma_y
        * k1 * w_z - gamma_n * w_y + C_us * W_z * inv_k3 - L_dot * c37 * c54 + J_xy * k1 * own_y + J_yz * k3
        * own_y - L_dot * c139 - c175 * c37 - c210 * c39 + J_xx * inv_k3 * own_z + 2.0 * L * W_z * h_z * inv_k3
        * theta_dot - c202 * theta_dot + 2.0 * J_xz * k1 * own_z - J_xx * c185 - L * c109 * c42))
    c212 = c211 * inv_rho * inv_rho
    bent_leg_12 = -c212 * k3
    c213 = J_xy * c63
    c214 = (axial * net_y + c209 * (c107 - c50 * c96 + L * c106 - 2.0 * L * c24 + J_xx * c75 - c158 * w_z + c61
        + C_us * theta_dot + c159 * k3 - C_s * w_y_omega + c213 + L * c105 - L * c84 + J_yz * own_z - c148 * c20
        * c37 - c213 * c50 + c125 * c134 - L * c55 * own_z))
    c215 = c15 * c214
    bent_leg_13 = c215
    bent_leg_21 = -L * c215
    bent_leg_22 = -c210 * c212
    bent_leg_23 = -L * inv_L * net_x
    c216 = c211 * c4 * c91
    bent_leg_31 = -c216
    c217 = inv_rho * k3
    bent_leg_32 = L * k3 * (c217 * net_x + c214 * c40 * inv_rho)
    bent_leg_33 = c216 * kappa
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
    G_dot_21 = -c88
    c218 = k1 * phi_dot
    G_dot_22 = c218 * inv_L
    G_dot_23 = c16
    G_dot_31 = -c217 * phi_dot
    G_dot_32 = -c2 * inv_rho - inv_rho * kappa * theta_dot
    G_dot_33 = c218 * inv_rho
    # slope of a rate, times C_s
    theta_dot_by_S_x = C_s * (G_dot_23 * z_x + G_dot_21 * s_x + G_dot_22 * y_x)
    theta_dot_by_S_y = C_s * (G_dot_23 * z_y + G_dot_21 * s_y + G_dot_22 * y_y)
    theta_dot_by_S_z = C_s * (G_dot_23 * z_z + G_dot_21 * s_z + G_dot_22 * y_z)
    phi_dot_by_S_x = C_s * (G_dot_31 * s_x + G_dot_32 * y_x + G_dot_33 * z_x)
    phi_dot_by_S_y = C_s * (G_dot_31 * s_y + G_dot_32 * y_y + G_dot_33 * z_y)
    phi_dot_by_S_z = C_s * (G_dot_31 * s_z + G_dot_32 * y_z + G_dot_33 * z_z)
    # gradient of theta, times C_s
    C_s_theta_x = -c118 * z_x
    C_s_theta_y = -c118 * z_y
    C_s_theta_z = -c118 * z_z
    c219 = C_s * y_x
    c220 = C_s * y_y
    c221 = C_s * y_z
    # gradient of phi, times C_s
    C_s_phi_x = c219 * inv_rho
    C_s_phi_y = c220 * inv_rho
    C_s_phi_z = c221 * inv_rho
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
    c225 = R_tip_y + f_S_dot_xx * omega_y - f_S_dot_xy * omega_x + f_S_xz
    c226 = f_S_dot_xz * omega_x - R_tip_z - f_S_dot_xx * omega_z + f_S_xy
    c227 = f_S_dot_xy * omega_z - f_S_dot_xz * omega_y + f_S_xx
    c228 = f_S_dot_yz * omega_x - f_S_dot_yx * omega_z + f_S_yy
    c229 = f_S_dot_yx * omega_y - R_tip_x - f_S_dot_yy * omega_x + f_S_yz
    c230 = R_tip_z + f_S_dot_yy * omega_z - f_S_dot_yz * omega_y + f_S_yx
    c231 = f_S_dot_zx * omega_y - f_S_dot_zy * omega_x + f_S_zz
    c232 = R_tip_x + f_S_dot_zz * omega_x - f_S_dot_zx * omega_z + f_S_zy
    c233 = f_S_dot_zy * omega_z - R_tip_y - f_S_dot_zz * omega_y + f_S_zx
    out = JointSlopesLeg()
    out.M_vv = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_vw = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.M_ww = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_ft = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_fr = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    out.W_mt = [-f_S_xx, -f_S_xy, -f_S_xz, -f_S_yx, -f_S_yy, -f_S_yz, -f_S_zx, -f_S_zy, -f_S_zz]
    out.W_mr = [
        c226 * q_z - c225 * q_y,
        c225 * q_x - c227 * q_z,
        c227 * q_y - c226 * q_x,
        c228 * q_z - c229 * q_y,
        c229 * q_x - c230 * q_z,
        c230 * q_y - c228 * q_x,
        c232 * q_z - c231 * q_y,
        c231 * q_x - c233 * q_z,
        c233 * q_y - c232 * q_x,
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
        Y_yz * q_y + tau_S_ddot_yz * w_q_y - c219 - Y_yy * q_z - tau_S_ddot_yy * w_q_z,
        Y_yx * q_z + tau_S_ddot_yx * w_q_z - c220 - Y_yz * q_x - tau_S_ddot_yz * w_q_x,
        Y_yy * q_x + tau_S_ddot_yy * w_q_x - c221 - Y_yx * q_y - tau_S_ddot_yx * w_q_y,
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


def joint_slopes_total(on: Arithmetic, pose: Any, legs: Any, out: Any) -> None:
    """The sums over platform and legs."""
    for i in range(6):
        out.M_vv[i] = (pose.M_vv[i] + (legs.leg[0].M_vv[i] + legs.leg[1].M_vv[i] + (legs.leg[2].M_vv[i] + legs.leg[3].M_vv[i])
            + (legs.leg[4].M_vv[i] + legs.leg[5].M_vv[i])))
    for i in range(9):
        out.M_vw[i] = (pose.M_vw[i] + (legs.leg[0].M_vw[i] + legs.leg[1].M_vw[i] + (legs.leg[2].M_vw[i] + legs.leg[3].M_vw[i])
            + (legs.leg[4].M_vw[i] + legs.leg[5].M_vw[i])))
    for i in range(6):
        out.M_ww[i] = (pose.M_ww[i] + (legs.leg[0].M_ww[i] + legs.leg[1].M_ww[i] + (legs.leg[2].M_ww[i] + legs.leg[3].M_ww[i])
            + (legs.leg[4].M_ww[i] + legs.leg[5].M_ww[i])))
    for i in range(9):
        out.W_ft[i] = (pose.W_ft[i] + (legs.leg[0].W_ft[i] + legs.leg[1].W_ft[i] + (legs.leg[2].W_ft[i] + legs.leg[3].W_ft[i])
            + (legs.leg[4].W_ft[i] + legs.leg[5].W_ft[i])))
    for i in range(9):
        out.W_fr[i] = (pose.W_fr[i] + (legs.leg[0].W_fr[i] + legs.leg[1].W_fr[i] + (legs.leg[2].W_fr[i] + legs.leg[3].W_fr[i])
            + (legs.leg[4].W_fr[i] + legs.leg[5].W_fr[i])))
    for i in range(9):
        out.W_mt[i] = (pose.W_mt[i] + (legs.leg[0].W_mt[i] + legs.leg[1].W_mt[i] + (legs.leg[2].W_mt[i] + legs.leg[3].W_mt[i])
            + (legs.leg[4].W_mt[i] + legs.leg[5].W_mt[i])))
    for i in range(9):
        out.W_mr[i] = (pose.W_mr[i] + (legs.leg[0].W_mr[i] + legs.leg[1].W_mr[i] + (legs.leg[2].W_mr[i] + legs.leg[3].W_mr[i])
            + (legs.leg[4].W_mr[i] + legs.leg[5].W_mr[i])))
    for i in range(9):
        out.W_fv[i] = (pose.W_fv[i] + (legs.leg[0].W_fv[i] + legs.leg[1].W_fv[i] + (legs.leg[2].W_fv[i] + legs.leg[3].W_fv[i])
            + (legs.leg[4].W_fv[i] + legs.leg[5].W_fv[i])))
    for i in range(9):
        out.W_fw[i] = (pose.W_fw[i] + (legs.leg[0].W_fw[i] + legs.leg[1].W_fw[i] + (legs.leg[2].W_fw[i] + legs.leg[3].W_fw[i])
            + (legs.leg[4].W_fw[i] + legs.leg[5].W_fw[i])))
    for i in range(9):
        out.W_mv[i] = (pose.W_mv[i] + (legs.leg[0].W_mv[i] + legs.leg[1].W_mv[i] + (legs.leg[2].W_mv[i] + legs.leg[3].W_mv[i])
            + (legs.leg[4].W_mv[i] + legs.leg[5].W_mv[i])))
    for i in range(9):
        out.W_mw[i] = (pose.W_mw[i] + (legs.leg[0].W_mw[i] + legs.leg[1].W_mw[i] + (legs.leg[2].W_mw[i] + legs.leg[3].W_mw[i])
            + (legs.leg[4].W_mw[i] + legs.leg[5].W_mw[i])))


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
