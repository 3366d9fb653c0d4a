"""C99 files of the actuator forces with bounds of their rounding errors and the reciprocal condition of H."""

from ..kernel.bounds import BoundedForces
from ..print.c import C
from ..print.template import filled
from ..trace.nodes import Function
from .shared import LANES, SIZES, header

_OF_FORCES = ("shared_of_pose", "leg_of_pose", "leg_of_pose_near_singularity")
"""Functions that round like the force kernel; in other functions each operation has a separate error."""


def files(made: BoundedForces, version: str) -> dict[str, str]:
    """Return ``stewart_<kernel>_bounds.h`` and ``.c``.

    They contain the preparation, the blocks with their errors, and the solution with its bound.
    """
    name = made.kernel.formulation.kernel_name
    structures = (made.structures[each] for each in ("Leg", "Platform", "Model"))
    file = f"stewart_{name}_bounds"
    rotors = made.kernel.formulation.drive
    texts = header("bounds.h", file, version, rotors=rotors, name=name, structures=C().source(*structures))
    top = filled("bounds_top.c", name=name, version=version, header=LANES) + filled("bounds_macros.c")
    parts = list(made.parts())
    apart = {each.name for each in parts if isinstance(each, Function)}.difference(_OF_FORCES)
    source = C(made.texts.functions.values(), SIZES, apart=apart).source(top, *parts)
    return texts | {f"{file}.c": source}
