"""Kinematics as trees: inverse kinematics, search for the pose of leg lengths, orientations and rates."""

import itertools
import random
from collections.abc import Callable, Collection, Iterable, Mapping
from math import prod
from types import MappingProxyType
from typing import Any

from ..mechanics import kinematics as k
from ..mechanics import quantities as n
from ..program.block import Block, Operations
from ..trace import nodes as t
from ..trace import read
from ..trace.operation_counter import counted
from . import batches
from .batches import LOADS, MOTIONS, NUMBERS, copies, is_null, missing, parts_at
from .elimination import CARRIED, RETURNED
from .layouts import Arguments, Written, block_function, structure
from .prepare import machine_structures, result
from .written import batch, legs
from .written.kinematics import nearest_pose
from .written.kinematics import pose_search as written

_LEG: Arguments = {"leg": ("Leg", n.LEG)}
_POSE: Arguments = {"pose": ("Pose", (n.R, n.t))}
_MOTION: Arguments = {"motion": ("Motion", n.MOTION)}
_VECTORS = (n.q, k.S, n.L)


def legs_batch(blocks: k.Kinematics) -> t.Program:
    """Return the program of the legs: lengths, rates, second rates, and vectors, and its batch in C."""
    dims = {each.name: each.type.dims for each in _LEG_MOTIONS.members if isinstance(each.type, t.Array)}
    arrays = t.Structure("LegsArrays", "", tuple(t.Field(name, NUMBERS) for name in dims))
    held = [structure("LegMotion", "A leg.", blocks.second.made), _LEG_MOTIONS, arrays]
    made = [block_function(blocks.second, "motion_of", "LegMotion", _LEG | _MOTION)]
    called = (legs.largest_component, legs.reach_of, legs.fault_of, written.motions_of, batch.copy)
    texts = _written(held, made, called, RETURNED)
    of_many = {"Motions": MOTIONS}
    texts.function(batch.pose_at, given=parts_at((n.alpha, n.a), LOADS), structures=of_many)
    second = t.Binary("!=", t.of("legs", "L_ddot"), t.Constant("NULL"))
    without = t.Binary("|", *(is_null(t.of("motions", q.name)) for q in (n.alpha, n.a)))
    given = missing(("robot", "motions", "legs"), (n.R, n.t, n.omega, n.v), t.Binary("&", second, without))
    rows = [name for name, size in dims.items() if len(size) == 2]
    found = copies("legs", {name: prod(size) for name, size in dims.items()}, rows)
    given |= batches.batch(batch.one_kinematics, found)
    texts.function(batch.legs_batch, "stewart_legs_batch", public=True, given=given, structures=of_many)
    return texts.program("legs")


def search_program(
    blocks: k.Kinematics, public: Collection[str] = (), check: Mapping[str, read.Given] = CARRIED
) -> t.Program:
    """Return the program of ``rates_of``, ``pose_of``, and ``twist_of``: from a pose to lengths and back.

    ``public`` adds some of ``PUBLIC``, whose results are NaN if the status is not OK. ``check`` is the check
    of the legs, ``RETURNED`` for one pose.
    """
    of_leg: Arguments = {"leg": ("LegVectors", _VECTORS)}
    held = [
        structure("Pose", "Pose of the platform.", (n.R, n.t)),
        structure("LegVectors", "Vectors of a leg.", _VECTORS),
        structure("LegRow", "A leg's row of J.", blocks.row.made),
        structure("LegRate", "A leg's rate.", blocks.rate.made),
        structure("SmallTurn", "A rotation.", blocks.turned.made),
        *_SEARCHED,
    ]
    made = [
        block_function(blocks.vectors, "vectors_of", "LegVectors", _LEG | _POSE),
        block_function(blocks.row, "row_of", "LegRow", of_leg),
        block_function(blocks.rate, "rate_of", "LegRate", of_leg | _MOTION),
        block_function(blocks.turned, "turned_by", "SmallTurn", {"turn": ("", (k.turn,))}),
    ]
    texts = (
        legs.largest_component,
        legs.reach_of,
        legs.fault_of,
        *_SEARCH,
        *(PUBLIC[name] for name in public),
    )
    return _written(held, made, texts, check).program("kinematics")


def search_operations(blocks: k.Kinematics) -> dict[str, Operations]:
    """Count the operations of lengths, rates, a search without its steps, a step, and the velocity."""
    program = search_program(blocks)
    draw = random.Random(1)

    def numbers(name: str) -> float:
        # R is a rotation already, as far as a search of no steps can tell.
        known = {"moving": moving, "damping": 0}
        return next(turn) if name == "R" else known[name] if name in known else draw.uniform(0.5, 1.5)

    def run(function: str, steps: int = 0) -> Operations:
        return counted(program, function, numbers, {"MAX_STEPS": steps, "MAX_SEARCHES": 1})

    moving, turn = 0, itertools.cycle((1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
    lengths = run("rates_of")
    moving = 1
    once, twice = run("search", 1), run("search", 2)
    return {
        "lengths": lengths,
        "lengths, rates": run("rates_of"),
        "search": run("pose_of"),
        "step": twice + -1 * once,
        "velocity": run("twist_of"),
    }


def rotation_program(blocks: Iterable[Block]) -> t.Program:
    """Return a function for each block of an orientation and its rates."""
    made = []
    for block in blocks:
        # A quaternion's numbers stand in one array, scalar first.
        names = dict.fromkeys(q.name.removesuffix("_w") for q in block.inputs)
        held = {name: tuple(q for q in block.inputs if q.name.removesuffix("_w") == name) for name in names}
        arguments: Arguments = {name: ("", parts) for name, parts in held.items()}
        made.append(block_function(block, block.name, "Orientation", arguments))
    found = structure("Orientation", "An orientation and its rates.", (n.R, n.omega, n.alpha))
    return _written([found], made, (written.orientation_status,)).program("rotation")


def _written(
    held: Iterable[t.Structure],
    blocks: Iterable[t.Function],
    texts: Iterable[Callable[..., Any]],
    given: Mapping[str, read.Given] = MappingProxyType({}),
) -> Written:
    made = Written.of((*machine_structures(), *held), blocks, given)
    for text in texts:
        made.function(text, public=text in PUBLIC.values())
    return made


_LENGTHS = t.numbers("L", 6, meaning="m: lengths, (2)"), t.numbers("L_dot", 6, meaning="m/s: rates, (5)")
_LEG_MOTIONS = result(
    "LegMotions",
    "Six legs of a pose.",
    *_LENGTHS,
    t.numbers("L_ddot", 6, meaning="m/s^2: second rates, (8)"),
    t.numbers("s", 6, 3, meaning="1: unit vectors along the legs, base frame, (3)"),
    t.numbers("S", 6, 3, meaning="m: leg vectors, base frame, (1)"),
)
_SEARCHED = (
    result("LegRates", "Lengths of six legs and their rates.", *_LENGTHS),
    t.Structure(
        "LegsAtPose",
        "Six legs at a pose, and their equations.",
        (
            t.numbers("A", 6, 7, meaning="1: rows [s, q x s / size] of J, and a right side; then a triangle"),
            t.Field("leg", t.Array(t.Record("LegVectors"), (6,)), "the legs"),
            t.Field("extent", t.Real(), "m: largest distance of a joint from the origin of its part"),
            t.Field("reach", t.Real(), "m: size of the terms of S = q + t - b"),
            t.Field("of_inverse", t.Real(), "1: square of the size of J^-1"),
            t.Field("last", t.Real(), "m^2: square of the last step of a search"),
            t.Field("straight", t.Integer(), "1 if each step reduced the largest length error by 30 %"),
        ),
    ),
    t.Structure(
        "NearestPose",
        "Nearest pose that the searches found.",
        (
            t.Field("guess", t.Record("Pose"), "the guess"),
            t.Field("pose", t.Record("Pose"), "the nearest pose to it"),
            t.Field("away", t.Real(), "m^2 and rad^2: square of the distance between both"),
            t.Field("basin", t.Real(), "rad^2: square of a distance from which steps lead to the pose"),
        ),
    ),
    result("FoundPose", "Result of the search for a pose.", t.Field("pose", t.Record("Pose"), "the pose")),
    result(
        "Twist",
        "Velocity of the platform.",
        t.numbers("v", 3, meaning="m/s: of the reference point"),
        t.numbers("omega", 3, meaning="rad/s: angular velocity, base frame"),
    ),
)
PUBLIC = {
    each.__name__: each
    for each in (written.inverse_kinematics, written.forward_kinematics, written.forward_velocity)
}
"""Functions of a program without addresses, by name."""
_OTHERS = (written.orientation_status, written.motions_of)
_SEARCH = tuple(
    each
    for each in (*vars(written).values(), *vars(nearest_pose).values())
    if callable(each) and each not in (*PUBLIC.values(), *_OTHERS)
)
"""Functions of the search for a pose, each after the functions that it calls."""
