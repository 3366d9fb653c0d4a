"""The closed form: M [a; alpha] + C [v; omega] + g + friction = H F + external wrench, as blocks.

Every leg is a mechanism of three degrees of freedom at its tip (``tip``, ``joint_coordinates``), moved by
the platform through J = [E, -[q]x]. Blocks here give what a pose has for all legs with the platform's own
part, and one leg's part of each sum: of M, C, g and friction; of M and the right side of forward dynamics;
of the bias; and of the derivatives of the wrench by pose, twist and acceleration. Poses move by [dt; dphi],
R becoming exp([dphi]x) R. Formulation `exact` with universal base joints.
"""

from .derivatives import derivatives_kernel, joint_slopes_kernel
from .equations import bias_kernel, equations_kernel, forward_kernel, joint_rows_kernel
from .kernels import NAMES, OF_TWO_FORMS, kernel, kernels
from .parts import OWN_MASSES, PREPARED
from .terms import (
    AXIAL,
    B_0,
    BIAS,
    BY_POSE,
    BY_TWIST,
    C_VV,
    C_VW,
    C_WV,
    C_WW,
    CORIOLIS,
    F_LEG,
    FRICTION,
    GRAVITY,
    H_DOT,
    INERTIA,
    M_VV,
    M_VW,
    M_WW,
    M_XI,
    NET,
    RIGHT,
    ROWS,
    TAU,
    TAU_BY,
    TURNED,
    SumKernel,
)

__all__ = [
    "AXIAL",
    "BIAS",
    "BY_POSE",
    "BY_TWIST",
    "B_0",
    "CORIOLIS",
    "C_VV",
    "C_VW",
    "C_WV",
    "C_WW",
    "FRICTION",
    "F_LEG",
    "GRAVITY",
    "H_DOT",
    "INERTIA",
    "M_VV",
    "M_VW",
    "M_WW",
    "M_XI",
    "NAMES",
    "NET",
    "OF_TWO_FORMS",
    "OWN_MASSES",
    "PREPARED",
    "RIGHT",
    "ROWS",
    "TAU",
    "TAU_BY",
    "TURNED",
    "SumKernel",
    "bias_kernel",
    "derivatives_kernel",
    "equations_kernel",
    "forward_kernel",
    "joint_rows_kernel",
    "joint_slopes_kernel",
    "kernel",
    "kernels",
]
