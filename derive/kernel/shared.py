"""Functions that the sources of kernels share: each stands once, in a header that they include."""

from dataclasses import dataclass
from functools import cache

from .batches import LOADS, MOTIONS, parts_at, parts_of_one
from .elimination import CARRIED, INVERSE, ONCE, RETURNED, by_rows, in_lanes
from .layouts import Written
from .prepare import MOTION
from .tree.constants import LARGEST
from .tree.nodes import Argument, Array, Count, Function, Number, Pointer, Real, Type
from .tree.read import LANES, Given
from .written import batch, every_output, lanes, legs, solve

ABOUT_REFERENCE: dict[str, Given] = {"add_leg": legs.add_leg, "plus": legs.plus, "ABOUT_TIP": 0}
"""How a leg is added to the platform's equations."""
WITH_ERRORS: dict[str, Given] = {"add_leg": legs.add_leg, "plus": legs.plus_error, "ABOUT_TIP": 1}
"""The same about platform point 1, with rounding errors."""
_FAULT: dict[str, Given] = {"check_leg": legs.check_leg, "HAS_SINE": 1}
FAULT_RETURNED: dict[str, Given] = {**_FAULT, **RETURNED}
"""How a leg is checked where the first fault ends a function."""
FAULT_CARRIED: dict[str, Given] = {**_FAULT, **CARRIED}
"""The same where it is a status that is carried on."""

_NUMBERS = Pointer(Real())
_VECTORS = Array(Real(), (3, LANES))


def _signature(name: str, result: Type | None, **arguments: Type) -> Function:
    """A function or macro of the templates; ``to``, ``padded`` and ``H`` are changed."""
    given = (Argument(each, kind, each in ("to", "padded", "H")) for each, kind in arguments.items())
    return Function(name, "", tuple(given), result, ())


_BLOCKS = (
    _signature(
        "whole", _NUMBERS, source=_NUMBERS, width=Count(), first=Count(), count=Count(), padded=_NUMBERS
    ),
    _signature("spread_vector", None, source=_NUMBERS, to=_VECTORS),
    _signature("spread_matrix", None, source=_NUMBERS, to=_VECTORS),
    _signature("clear", None, to=_VECTORS),
)
FORCE = _signature("STEWART_FORCE", Real(), D=Real(), x=Real())


@dataclass(frozen=True)
class Shared:
    """Functions around the solve, those with legs or poses in lanes, and those of every output."""

    solve: tuple[Function, ...]
    lanes: tuple[Function, ...]
    outputs: tuple[Function, ...]

    @property
    def by_name(self) -> dict[str, Function]:
        """All that a source may call."""
        return {each.name: each for each in (*self.solve, *self.lanes, *self.outputs, *_BLOCKS)}


@cache
def shared(about_tip: bool = True) -> Shared:
    """The functions; about_tip: of kernels whose moments are about platform point 1."""
    texts = Written({"Motions": MOTIONS, "Motion": MOTION}, {}, {FORCE.name: FORCE})
    read = texts.function
    rows = (lanes.exchange_rows, lanes.subtract_row)
    return Shared(
        (
            read(solve.per_length_of, given={"LARGEST": Number(LARGEST)}, largest=f"{LARGEST:g}"),
            read(solve.scaled_axis),
            read(legs.largest_component),
            read(legs.fault_of, apart=True, given=FAULT_RETURNED),
            read(solve.singular_status, apart=True, given={**INVERSE, **RETURNED}),
        ),
        (
            *(read(each) for each in rows),
            read(lanes.solve_pose, given=by_rows(about_tip)),
            read(lanes.scale_pose),
            read(lanes.solve_block, apart=True, given=in_lanes(about_tip)),
        ),
        (
            read(every_output.solve, given=ONCE),
            read(batch.is_finite),
            read(batch.pose_at, given=parts_at(LOADS)),
            read(batch.motion_as_arrays, given=parts_of_one()),
            read(batch.copy),
        ),
    )
