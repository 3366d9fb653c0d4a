"""C99: the actuator forces with a bound of their rounding error and the reciprocal condition of H."""

from ..kernel.bounds import BoundedForces
from ..mechanics.actuator_forces import ForceKernel
from ..print.c import C
from ..print.template import filled
from .shared import LANES, SIZES


def header(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_bounds.h``: the prepared model with its errors, and the functions."""
    name = kernel.formulation.kernel_name
    made = BoundedForces(kernel).structures
    return filled(
        "bounds.h",
        name=name,
        version=version,
        guard=f"STEWART_{name.upper()}_BOUNDS_H",
        structures=C().source(*(made[each] for each in ("Leg", "Platform", "Model"))),
    )


def source(kernel: ForceKernel, version: str) -> str:
    """``stewart_<kernel>_bounds.c``: preparation, blocks with their errors, the solution and its bound."""
    name = kernel.formulation.kernel_name
    top = filled("bounds_top.c", name=name, version=version, header=LANES) + filled("bounds_macros.c")
    made = BoundedForces(kernel)
    return C(made.texts.functions.values(), SIZES).source(top, *made.parts())


def model_numbers(kernel: ForceKernel) -> int:
    """How many numbers ``stewart_<kernel>_bounds_model`` holds."""
    return BoundedForces(kernel).model_numbers()
