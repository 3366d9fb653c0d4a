"""The kernels of the closed form by name, each derived once."""

from dataclasses import replace
from functools import cache

from ..actuator_forces import from_difference
from .derivatives import derivatives_kernel, derivatives_of_leg, joint_slopes_kernel
from .equations import bias_kernel, equations_kernel, equations_of_leg, forward_kernel, joint_rows_kernel
from .terms import SumKernel

NAMES = ("equations", "bias", "forward_dynamics", "derivatives", "joint_rows", "joint_slopes")
"""Of the kernels, in the order of the emitted file."""
OF_TWO_FORMS = ("equations", "derivatives")
"""Of those whose legs have a second block."""


def kernels(friction: bool = True) -> tuple[SumKernel, ...]:
    """All of them, as ``NAMES``."""
    return tuple(kernel(name, friction) for name in NAMES)


@cache
def kernel(name: str, friction: bool) -> SumKernel:
    """One of ``NAMES``, derived once."""
    derive = {
        "equations": equations_kernel,
        "bias": bias_kernel,
        "forward_dynamics": forward_kernel,
        "derivatives": derivatives_kernel,
        "joint_rows": joint_rows_kernel,
        "joint_slopes": joint_slopes_kernel,
    }[name]
    found = derive(friction)
    if name in OF_TWO_FORMS:
        leg = {"equations": equations_of_leg, "derivatives": derivatives_of_leg}[name]
        found = replace(found, near=leg(friction, near=True))
    return found.changed(from_difference)
