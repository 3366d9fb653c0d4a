"""C99 files of the regressor: one pose with its legs in lanes, and a loop over poses.

The blocks and their order are the same as in the array module, so both results agree to the last bit.
"""

from ..kernel import layouts as lay
from ..kernel.batches import LOADS, MOTIONS, batch, is_null, loaded_one, missing
from ..kernel.layouts import LANE, Place, Written
from ..kernel.prepare import LEG, MOTION, ROBOT
from ..kernel.shared import shared
from ..kernel.written.batch import load_pose
from ..kernel.written.motion import lanes as written
from ..mechanics import quantities as n
from ..mechanics.regressor import LEG_PARAMETERS, PLATFORM_PARAMETERS, Regressor, column, names_of
from ..print.c import C
from ..program.block import Block, Quantity
from ..trace import nodes as t
from ..trace.lower import steps_of
from ..trace.read import LANES, Entries, Given
from .closed_form import checks
from .closed_form_blocks import CHECKS, LEGS
from .shared import SIZES, SOLVE, header, top

NAME = "stewart_exact_regressor"
_GIVEN = (n.b, n.p, n.k)
_OF_LEG, _OF_PLATFORM = names_of(LEG_PARAMETERS), names_of(PLATFORM_PARAMETERS)
_COUNTS: dict[str, Given] = {
    "OF_ONE_LEG": len(_OF_LEG),
    "OF_LEGS": LEGS * len(_OF_LEG),
    "OF_PLATFORM": len(_OF_PLATFORM),
    "OF_ALL": LEGS * len(_OF_LEG) + len(_OF_PLATFORM),
}
_COLUMNS = t.Structure(
    "regressor_columns",
    "Columns of a pose with the row as first index, and inputs of the legs. lost: 1 if not finite.",
    (
        t.numbers("of_legs", 6, len(_OF_LEG), LANES),
        *(lay.stored(q, LANES) for q in _GIVEN),
        t.numbers("lost", LANES),
        t.Field("checked", t.Record(CHECKS.name)),
        t.numbers("of_platform", 6, len(_OF_PLATFORM)),
    ),
    aligned=True,
)


def files(blocks: Regressor, version: str) -> dict[str, str]:
    """Return ``stewart_exact_regressor.h`` and ``.c``."""
    parts = _functions(blocks)
    texts = header(
        "regressor.h",
        NAME,
        version,
        operations=LEGS * blocks.leg.operations() + blocks.platform.operations(),
        columns=_COUNTS["OF_ALL"],
        declarations=C(parts).interface(*parts),
    )
    before = top(NAME, version, SOLVE)
    source = C(shared().by_name.values(), SIZES).source(before, CHECKS, _COLUMNS, *parts)
    return texts | {f"{NAME}.c": source}


def _functions(blocks: Regressor) -> list[t.Function]:
    structures = {"Robot": ROBOT, "Leg": LEG, "Motion": MOTION, "Motions": MOTIONS}
    structures |= {"Columns": _COLUMNS, "Checked": CHECKS}
    read = Written(structures, _COUNTS, dict(shared().by_name)).function
    of_platform = lay.stores(blocks.platform.outputs, _places("of_platform", _OF_PLATFORM).__getitem__)
    pose = (*lay.lines(blocks.platform, _loaded), *of_platform)
    no_columns = t.Binary(
        "&", is_null(t.Name("columns")), t.Binary("!=", t.Name("width"), t.As(t.Count(), t.Number(0)))
    )
    one = missing(("robot", "motion", "Y"), (), no_columns)
    moved = tuple(q for q in n.MOTION if q not in LOADS)
    many = missing(("robot", "motions", "Y"), moved) | batch(written.one_regressor)
    leg, platform = (each.operations().total for each in (blocks.leg, blocks.platform))
    return [
        read(written.legs_status),
        read(written.columns_of_legs, apart=True, given=_leg(blocks.leg), count=leg),
        read(written.columns_of_platform, apart=True, given={"POSE": pose}, count=platform),
        read(written.columns_status),
        read(written.all_columns),
        read(written.chosen_columns),
        read(written.regressor, NAME, public=True, given=one, count=_COUNTS["OF_ALL"]),
        read(load_pose, given=loaded_one(n.MOTION[1:], LOADS)),
        read(written.regressor_batch, f"{NAME}_batch", public=True, given=many),
    ]


def _loaded(quantity: Quantity) -> Place:
    """Return the location of a block's input."""
    if quantity in _GIVEN:
        return lay.member("out", quantity, LANE)
    return lay.member("at" if quantity in n.MOTION else "robot", quantity)


def _places(member: str, parameters: list[str], *lane: t.Expression) -> dict[Quantity, Place]:
    """Return the locations of the columns: force rows, then moment rows."""
    whole = t.of("out", member)
    return {
        rows: Place(whole, (t.Number(j), *lane), first)
        for j, name in enumerate(parameters)
        for rows, first in zip(column(name), (0, 3), strict=True)
    }


def _leg(block: Block) -> dict[str, Given]:
    """Return the words of ``written.columns_of_legs``: loads, the block, and the moments."""
    places = _places("of_legs", _OF_LEG, LANE)
    columns = [out for out in block.outputs if out.quantity in places]
    moments = {
        expr: places[out.quantity].part(out.quantity, i)
        for out in columns
        if places[out.quantity].first
        for i, expr in enumerate(out.exprs)
        if expr != 0
    }
    outside, inside = lay.parted(lay.loaded(block, _loaded, n.t, n.b))
    return {
        **checks(block),
        "OF_LEG": lay.entries(_GIVEN),
        "OUTSIDE": outside,
        "BLOCK": (*inside, *steps_of(block.steps), *lay.stores(columns, places.__getitem__)),
        "MOMENTS": Entries(tuple(moments.values())),
    }
