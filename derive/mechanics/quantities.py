"""Symbols of the paper: name, shape, unit, frame, and meaning of each input and output of a block.

Read this file first when you compare the code with the paper. All other modules of ``derive`` take their
symbols from here. This module contains no equation.
"""

from collections.abc import Container

from ..program.block import Quantity

# Motion of the platform and its load.
R = Quantity("R", (3, 3), "1", "orientation of the platform, platform frame to base frame")
t = Quantity("t", (3,), "m", "position of the platform's reference point, base frame")
omega = Quantity("omega", (3,), "rad/s", "angular velocity of the platform, base frame")
v = Quantity("v", (3,), "m/s", "velocity of the reference point, base frame")
alpha = Quantity("alpha", (3,), "rad/s^2", "angular acceleration of the platform, base frame")
a = Quantity("a", (3,), "m/s^2", "acceleration of the reference point, base frame")
F_ext = Quantity("F_ext", (3,), "N", "external force at the reference point, platform frame")
M_ext = Quantity("M_ext", (3,), "N m", "external moment about the reference point, platform frame")
MOTION = (R, t, omega, v, alpha, a, F_ext, M_ext)

# Constants of one leg.
b = Quantity("b", (3,), "m", "base point, base frame")
p = Quantity("p", (3,), "m", "platform point, platform frame")
k = Quantity("k", (3,), "1", "unit vector along the fixed axis of the universal joint, base frame")
m_d = Quantity("m_d", (), "kg", "mass of the lower part")
r_d0 = Quantity("r_d0", (3,), "m", "center of mass of the lower part, frame D")
I_d0 = Quantity("I_d0", (3, 3), "kg m^2", "inertia of the lower part about its center of mass, frame D", True)
m_u = Quantity("m_u", (), "kg", "mass of the upper part")
r_u0 = Quantity("r_u0", (3,), "m", "center of mass of the upper part, frame U")
I_u0 = Quantity("I_u0", (3, 3), "kg m^2", "inertia of the upper part about its center of mass, frame U", True)
C_u = Quantity("C_u", (), "N m s", "viscous friction of the universal joint")
C_p = Quantity("C_p", (), "N s/m", "viscous friction of the prismatic joint")
C_s = Quantity("C_s", (), "N m s", "viscous friction of the spherical joint")
LEG = (b, p, k, m_d, r_d0, I_d0, m_u, r_u0, I_u0, C_u, C_p, C_s)
FRICTION = (C_u, C_p, C_s)
m_r = Quantity(
    "m_r",
    (),
    "kg",
    "reflected mass J_r N^2 of the rotor with inertia J_r (kg m^2) and transmission N (rad/m)",
)
j_r = Quantity("j_r", (), "kg m", "angular momentum J_r N of the rotor per length rate")
ROTOR = (m_r, j_r)
OF_LEG = (*LEG, *ROTOR)


def of_leg(numbers: Container[str]) -> tuple[Quantity, ...]:
    """Return the constants of a leg, with the rotor constants if ``numbers`` contains m_r."""
    return OF_LEG if m_r.name in numbers else LEG


# Constants of the platform and gravity.
M = Quantity("M", (), "kg", "mass of the platform with its payload")
R_0 = Quantity("R_0", (3,), "m", "center of mass of the platform, platform frame")
I_p = Quantity(
    "I_p", (3, 3), "kg m^2", "inertia of the platform about its center of mass, platform frame", True
)
g = Quantity("g", (3,), "m/s^2", "acceleration due to gravity, base frame")
PLATFORM = (M, R_0, I_p, g)
p_1 = Quantity("p_1", (3,), "m", "platform point 1, platform frame")

# Terms of one leg in the equations of motion of the platform.
q = Quantity("q", (3,), "m", "platform point from the reference point, base frame")
s = Quantity("s", (3,), "1", "unit vector along the leg, base frame")
L = Quantity("L", (), "m", "length of the leg")
k3 = Quantity("k3", (), "1", "|k x s|, sine of the angle between the leg and the fixed axis")
D = Quantity("D", (), "N", "known part of the actuator force")
K = Quantity("K", (3,), "N", "transverse force on the leg at its spherical joint, base frame")
f = Quantity("f", (3,), "N m", "friction moment at the spherical joint, base frame")
x = Quantity("x", (), "N", "axial force on the leg at its spherical joint")
H_force = Quantity("H_force", (3,), "1", "the leg's column of H, force rows")
H_moment = Quantity("H_moment", (3,), "m", "the leg's column of H, moment rows")
c_force = Quantity("c_force", (3,), "N", "part of c, force rows, base frame")
c_moment = Quantity("c_moment", (3,), "N m", "part of c, moment rows, base frame")

# Reactions.
bearing = Quantity("bearing", (), "m", "distance along the leg from the base point to the reference of M_p")
F_s = Quantity("F_s", (3,), "N", "force on the leg at the spherical joint, base frame")
F_u = Quantity("F_u", (3,), "N", "force on the leg at the universal joint, base frame")
F_p = Quantity(
    "F_p",
    (3,),
    "N",
    "force of the lower part on the upper at the prismatic joint, without the viscous friction -C_p L_dot s, "
    "base frame",
)
F_c = Quantity("F_c", (3,), "N", "constraint part of F_p, base frame")
M_p = Quantity(
    "M_p",
    (3,),
    "N m",
    "moment of the lower part, on which the gyroscopic moment of a rotor acts, on the upper at the prismatic "
    "joint, base frame",
)
M_u = Quantity(
    "M_u",
    (),
    "N m",
    "constraint moment on the leg at the universal joint, along k x y, y the moving axis; in `paper` along s",
)
