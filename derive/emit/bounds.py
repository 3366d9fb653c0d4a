"""C99: the actuator forces with a bound of their rounding error and the reciprocal condition of H."""

from math import prod

from ..kernel.bounds import BoundedForces
from ..kernel.nodes import Array, Record, Structure, Type
from ..print.c import C
from ..print.template import filled
from ..regroup import ForceKernel
from .lanes import solve_pose


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
    macros = ("arithmetic.c", "lanes.c", "suspect.c", "bounds_macros.c")
    top = filled("bounds_top.c", name=name, version=version) + "".join(map(filled, macros))
    fixed = solve_pose(about_tip=True), filled("singular_status.c"), filled("bounds_finite.c", name=name)
    made = BoundedForces(kernel)
    parts = [top, *made.parts(*fixed), filled("bounds.c", name=name)]
    return C(made.texts.functions.values(), {8: "LANES"}).source(*parts)


def model_numbers(kernel: ForceKernel) -> int:
    """How many numbers ``stewart_<kernel>_bounds_model`` holds."""
    made = BoundedForces(kernel).structures
    return _count(made["Model"], {each.name: each for each in made.values()})


def _count(structure: Structure, known: dict[str, Structure]) -> int:
    def of(kind: Type) -> int:
        if isinstance(kind, Array):
            return prod(kind.dims) * of(kind.item)
        return _count(known[kind.name], known) if isinstance(kind, Record) else 1

    return sum(of(each.type) for each in structure.members)


def python_module(kernel: ForceKernel, version: str) -> str:
    """``<kernel>_bounds.py``: what Python must know of the C's layout."""
    name = kernel.formulation.kernel_name
    return filled("bounds.py", name=name, version=version, numbers=model_numbers(kernel))
