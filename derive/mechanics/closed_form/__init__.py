"""The closed form: M [a; alpha] + C [v; omega] + g + friction = H F + external wrench, as blocks.

Every leg is a mechanism of three degrees of freedom at its tip (``tip``, ``joint_coordinates``), moved by
the platform through J = [E, -[q]x]. Blocks here give what a pose has for all legs with the platform's own
part, and one leg's part of each sum: of M, C, g and friction; of M and the right side of forward dynamics;
of the bias; and of the derivatives of the wrench by pose, twist and acceleration. Poses move by [dt; dphi],
R becoming exp([dphi]x) R. Formulation `exact` with universal base joints.
"""

from dataclasses import replace
from functools import cache

from ..actuator_forces import from_difference
from ..legs.rotor import NONE, Rotor
from .derivatives import derivatives_kernel, derivatives_of_leg, joint_slopes_kernel
from .equations import bias_kernel, equations_kernel, equations_of_leg, forward_kernel, joint_rows_kernel
from .terms import AXIAL, F_LEG, NET, TURNED, SumKernel

GIVEN = (F_LEG, NET, TURNED, AXIAL)
"""What the legs' blocks are given beside the pose."""
_KERNELS = {
    "equations": equations_kernel,
    "bias": bias_kernel,
    "forward_dynamics": forward_kernel,
    "derivatives": derivatives_kernel,
    "joint_rows": joint_rows_kernel,
    "joint_slopes": joint_slopes_kernel,
}
NAMES = tuple(_KERNELS)
"""Of the kernels, in the order of the emitted file."""
_NEAR = {"equations": equations_of_leg, "derivatives": derivatives_of_leg}
OF_TWO_FORMS = tuple(_NEAR)
"""Of those whose legs have a second block."""


def kernels(rotor: Rotor = NONE) -> tuple[SumKernel, ...]:
    """All of them, as ``NAMES``."""
    return tuple(kernel(name, rotor) for name in NAMES)


@cache
def kernel(name: str, rotor: Rotor = NONE) -> SumKernel:
    """One of ``NAMES``, derived once; rotor: of the legs' drives."""
    found = _KERNELS[name](rotor)
    if name in _NEAR:
        found = replace(found, near=_NEAR[name](True, rotor))
    return found.changed(from_difference)
