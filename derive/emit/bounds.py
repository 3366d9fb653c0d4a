"""C99: the actuator forces with a bound of their rounding error and the reciprocal condition of H."""

from ..kernel.bounds import BoundedForces
from ..print.c import C
from ..print.template import filled
from .shared import LANES, SIZES, header


def files(made: BoundedForces, version: str) -> dict[str, str]:
    """``stewart_<kernel>_bounds.h`` and ``.c``: preparation, blocks with their errors, the solution and its
    bound."""
    name = made.kernel.formulation.kernel_name
    structures = (made.structures[each] for each in ("Leg", "Platform", "Model"))
    file = f"stewart_{name}_bounds"
    texts = header("bounds.h", file, version, name=name, structures=C().source(*structures))
    top = filled("bounds_top.c", name=name, version=version, header=LANES) + filled("bounds_macros.c")
    source = C(made.texts.functions.values(), SIZES).source(top, *made.parts())
    return texts | {f"{file}.c": source}
