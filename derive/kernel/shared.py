"""Functions that the sources of kernels share: each stands once, in a header that they include."""

from dataclasses import dataclass
from functools import cache

from ..mechanics.lumped_constants import ADDED
from ..mechanics.platform import platform
from ..program.cse import share
from .batches import LOADS, MOTIONS, parts_at, parts_of_one
from .elimination import BLOCKS_OF_POSE, INVERSE, ONCE, RETURNED, blocks_in_lanes, by_rows, in_lanes
from .layouts import Written, entries
from .moments import moments
from .prepare import LUMPED, MOTION
from .terms import filling, terms
from .tree import nodes as t
from .tree.constants import LARGEST
from .tree.read import POSES, Given
from .tree.settle import settled
from .written import batch, lanes, legs, solve

_ADDED: dict[str, Given] = {
    "add_leg": legs.add_leg,
    "part_of_leg": legs.part_of_leg,
    "plus": legs.plus,
    "HAS_C_MOMENT": 1,
    "ALL_LEGS": 1,
}


def legs_in_turn(out: str, leg: str, moments: str = "") -> dict[str, Given]:
    """How a leg at a time is added to H and c of ``out``.

    moments: what holds those about platform point 1, if they are not about the reference point.
    """

    def part(owner: str, name: str) -> Given:
        return lambda j, _: t.at(t.of(owner, name), j)

    return {
        **_ADDED,
        "H": lambda j, i: t.at(t.of(out, "H"), j, i),
        "c": lambda j: t.at(t.of(out, "c"), j),
        **{name: part(leg, name) for name in ("H_force", "c_force", "c_moment")},
        **{name: part(moments or leg, name) for name in ("H_moment", "arm_c")},
        "ABOUT_TIP": int(bool(moments)),
    }


def legs_with_errors(out: str, leg: str) -> dict[str, Given]:
    """``legs_in_turn`` with rounding errors of the sums; leg 1 has no moments about its own point."""
    return {
        **legs_in_turn(out, leg, leg),
        "plus": legs.plus_error,
        "c_own": lambda j: t.at(t.of(out, "c_own"), j),
        "H_moment": lambda j, i: t.Select(
            t.Binary(">", i, t.Number(0)), t.at(t.of(leg, "H_moment"), j), t.Number(0.0)
        ),
        "ALL_LEGS": 0,
    }


def legs_in_lanes(owner: str, rows: str) -> dict[str, Given]:
    """The legs side by side: columns of ``rows``, and sums of one row in ``force`` and ``turn``."""

    def part(name: str) -> Given:
        return lambda j, i: t.at(t.of(owner, name), j, i)

    of_legs = ("H_force", "H_moment", "c_force", "c_moment", "arm_c")
    return {
        **_ADDED,
        "H": lambda j, i: t.at(rows, j, i),
        "c": lambda j: t.Name("force") if isinstance(j, t.Name) else t.Name("turn"),
        **{name: part(name) for name in of_legs},
    }


_NUMBERS = t.Pointer(t.Real())
_VECTORS = t.Array(t.Real(), (3, POSES))


_COUNTS = dict.fromkeys(("stride", "first", "count"), t.Count())
_BLOCKS = (
    t.signature("load_vector", changed=("to",), source=_NUMBERS, **_COUNTS, to=_VECTORS),
    t.signature("load_matrix", changed=("to",), source=_NUMBERS, **_COUNTS, to=_VECTORS),
    t.signature(
        "store_forces", changed=("to",), F=_VECTORS, bad=t.Array(t.Real(), (POSES,)), **_COUNTS, to=_NUMBERS
    ),
)
FORCE = t.signature("STEWART_FORCE", t.Real(), D=t.Real(), x=t.Real())


@dataclass(frozen=True)
class Shared:
    """Functions around the solve, those with legs or poses in lanes, and those of every output.

    moments: those of the lanes with which kernels take moments. platform_terms: what one of the last fills.
    """

    solve: tuple[t.Function, ...]
    lanes: tuple[t.Function, ...]
    moments: tuple[t.Function, ...]
    platform_terms: t.Structure
    outputs: tuple[t.Function, ...]

    @property
    def by_name(self) -> dict[str, t.Function]:
        """All that a source may call."""
        return {
            each.name: each for each in (*self.solve, *self.lanes, *self.moments, *self.outputs, *_BLOCKS)
        }


@cache
def shared(about_tip: bool = True) -> Shared:
    """The functions; about_tip: of kernels whose moments are about platform point 1."""
    texts = Written({"Motions": MOTIONS, "Motion": MOTION, "Lumped": LUMPED}, {}, {FORCE.name: FORCE})
    read = texts.function
    wrench = share(platform()[0])
    of_platform = terms("platform_terms", wrench)
    added: dict[str, Given] = {"ADDED": entries(ADDED)}
    rows = (lanes.exchange_rows, lanes.subtract_row)
    return Shared(
        (
            read(solve.cube_of),
            settled(read(solve.per_length_of, given={"LARGEST": t.Number(LARGEST)})),
            read(solve.scaled_axis),
            read(solve.clear_lumped, given=added),
            read(solve.add_lumped, given=added),
            read(legs.largest_component),
            read(legs.fault_of, apart=True, given=RETURNED),
            read(solve.singular_status, apart=True, given={**INVERSE, **RETURNED}),
        ),
        (
            *(read(each) for each in rows),
            read(lanes.blocks_of_pose, given=BLOCKS_OF_POSE),
            read(lanes.pivots_of_pose, apart=True, given=by_rows(about_tip)),
            read(lanes.solve_pose),
            read(lanes.blocks_of_lanes, apart=True, given=blocks_in_lanes(about_tip)),
            read(lanes.pivots_of_lanes, apart=True, given=in_lanes(about_tip)),
            read(lanes.solve_block),
        ),
        moments(texts, about_tip),
        of_platform,
        (
            filling(wrench, of_platform),
            read(solve.eliminate, given=ONCE),
            # No call where every leg of every pose is checked.
            read(legs.fault_of, "status_of_leg", given=RETURNED),
            read(batch.is_finite),
            read(batch.pose_at, given=parts_at(LOADS)),
            read(batch.motion_as_arrays, given=parts_of_one()),
            read(batch.copy),
        ),
    )
