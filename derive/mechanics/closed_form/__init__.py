"""Closed form M [a; alpha] + C [v; omega] + g + friction = H F + external wrench, as blocks.

Each leg is a mechanism with three degrees of freedom at its tip (``tip``, ``joint_coordinates``). The
platform moves the tip by J = [E, -[q]x]. One block computes the terms of a pose that are common to all legs,
with the platform's part. Another block computes one leg's part of each sum:

- M, C, g, and friction;
- M and the right-hand side of forward dynamics;
- the bias;
- the derivatives of the wrench by pose, twist, and acceleration.

A pose changes by [dt; dphi], where R becomes exp([dphi]x) R. The formulation is `exact` with universal base
joints.
"""

from dataclasses import replace
from functools import cache

from ..actuator_forces import from_difference
from ..legs.rotor import NONE, Rotor
from .derivatives import derivatives_kernel, derivatives_of_leg, joint_slopes_kernel
from .equations import bias_kernel, equations_kernel, equations_of_leg, forward_kernel, joint_rows_kernel
from .terms import AXIAL, F_LEG, NET, TURNED, SumKernel

GIVEN = (F_LEG, NET, TURNED, AXIAL)
"""Inputs of the legs' blocks in addition to the pose."""
_KERNELS = {
    "equations": equations_kernel,
    "bias": bias_kernel,
    "forward_dynamics": forward_kernel,
    "derivatives": derivatives_kernel,
    "joint_rows": joint_rows_kernel,
    "joint_slopes": joint_slopes_kernel,
}
NAMES = tuple(_KERNELS)
"""Names of the kernels, in the order of the emitted file."""
_NEAR = {"equations": equations_of_leg, "derivatives": derivatives_of_leg}
OF_TWO_FORMS = tuple(_NEAR)
"""Names of the kernels whose legs have a second block."""


def kernels(rotor: Rotor = NONE) -> tuple[SumKernel, ...]:
    """Return all kernels, in the order of ``NAMES``."""
    return tuple(kernel(name, rotor) for name in NAMES)


@cache
def kernel(name: str, rotor: Rotor = NONE) -> SumKernel:
    """Derive one of ``NAMES``, with the rotor of the legs' drives."""
    found = _KERNELS[name](rotor)
    if name in _NEAR:
        found = replace(found, near=_NEAR[name](True, rotor))
    return found.changed(from_difference)
