"""Functions that several C sources use, each in one header."""

from dataclasses import dataclass
from functools import cache

from ..kernels.solve import pivot_solver, solver
from ..mechanics.lumped_constants import ADDED
from ..mechanics.platform import platform
from ..program.cse import share
from ..trace import nodes as t
from ..trace.constants import LARGEST
from ..trace.decided_selections import settled
from ..trace.lanes import Lanes
from ..trace.read import POSES, Given
from . import layouts as lay
from .batches import LOADS, MOTIONS, parts_at, parts_of_one
from .elimination import INVERSE, ONCE, RETURNED
from .prepare import LUMPED, MOTION
from .written import batch, legs, solve

_ADDED: dict[str, Given] = {
    "add_leg": legs.add_leg,
    "part_of_leg": legs.part_of_leg,
    "plus": legs.plus,
    "HAS_C_MOMENT": 1,
    "ALL_LEGS": 1,
}


def legs_in_turn(out: str, leg: str, moments: str = "") -> dict[str, Given]:
    """Return the statements that add one leg after the other to H and c of ``out``.

    ``moments`` are the moments about platform point 1, if they are not about the reference point.
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
    """Return ``legs_in_turn`` with rounding errors of the sums; leg 1 has no moments about its own point."""
    return {
        **legs_in_turn(out, leg, leg),
        "plus": legs.plus_error,
        "c_own": lambda j: t.at(t.of(out, "c_own"), j),
        "H_moment": lambda j, i: t.Select(
            t.Binary(">", i, t.Number(0)), t.at(t.of(leg, "H_moment"), j), t.Number(0.0)
        ),
        "ALL_LEGS": 0,
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


@dataclass(frozen=True)
class Shared:
    """Functions around the linear solve, functions with lanes, and functions of every output.

    ``platform_terms`` is the structure that the functions of every output fill.
    """

    solve: tuple[t.Function, ...]
    lanes: tuple[t.Structure | t.Function, ...]
    platform_terms: t.Structure
    outputs: tuple[t.Function, ...]

    @property
    def by_name(self) -> dict[str, t.Function]:
        """All functions that a source may call."""
        parts = (*self.solve, *self.lanes, *self.outputs, *_BLOCKS)
        return {each.name: each for each in parts if isinstance(each, t.Function)}


@cache
def shared(about_tip: bool = True) -> Shared:
    """Return the shared functions; ``about_tip`` selects moments about platform point 1."""
    texts = lay.Written({"Motions": MOTIONS, "Motion": MOTION, "Lumped": LUMPED}, {})
    read = texts.function
    wrench = share(platform()[0])
    of_platform = lay.structure("platform_terms", "", wrench.made)
    added: dict[str, Given] = {"ADDED": lay.entries(ADDED)}
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
            *common_parts(about_tip),
            read(solve.rows_status, apart=True, given={"ABOUT_TIP": int(about_tip)}),
        ),
        of_platform,
        (
            lay.filling(wrench, of_platform),
            read(solve.eliminate, given=ONCE),
            # No call where every leg of every pose is checked.
            read(legs.fault_of, "status_of_leg", given=RETURNED),
            read(batch.is_finite),
            read(batch.pose_at, given=parts_at(LOADS)),
            read(batch.motion_as_arrays, given=parts_of_one()),
            read(batch.copy),
        ),
    )


@cache
def common_parts(about_tip: bool = True) -> tuple[t.Structure | t.Function, ...]:
    """Return the structures and functions that solve H x = c for one pose, and by pivots for a block."""
    found: list[t.Structure | t.Function] = []
    for trace, poses_in_lanes in ((solver(about_tip), False), (pivot_solver(about_tip), True)):
        schedule = Lanes(trace, "", poses_in_lanes)
        found += schedule.structures().values()
        found += (schedule.functions[part.name] for part in schedule.parts if part.common)
    return tuple(found)
