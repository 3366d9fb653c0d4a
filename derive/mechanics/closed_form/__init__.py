"""The closed form: M [a; alpha] + C [v; omega] + g + friction = H F + external wrench, as blocks.

Every leg is a mechanism of three degrees of freedom at its tip (``tip``, ``joint_coordinates``), moved by
the platform through J = [E, -[q]x]. Blocks here give what a pose has for all legs with the platform's own
part, and one leg's part of each sum: of M, C, g and friction; of M and the right side of forward dynamics;
of the bias; and of the derivatives of the wrench by pose, twist and acceleration. Poses move by [dt; dphi],
R becoming exp([dphi]x) R. Formulation `exact` with universal base joints.
"""

from .kernels import NAMES, OF_TWO_FORMS, kernel, kernels
from .parts import PREPARED
from .terms import AXIAL, F_LEG, NET, TURNED, SumKernel

GIVEN = (F_LEG, NET, TURNED, AXIAL)
"""What the legs' blocks are given beside the pose."""

__all__ = ["F_LEG", "GIVEN", "NAMES", "OF_TWO_FORMS", "PREPARED", "SumKernel", "kernel", "kernels"]
