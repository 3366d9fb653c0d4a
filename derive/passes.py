"""Force kernel of the formulation ``exact`` after every pass, with its operations and its C.

For the benchmark. The modules ``cse`` and ``actuator_forces`` contain the passes; this module defines their
order.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from .emit import lanes
from .emit.header import common_header
from .emit.shared import shared_headers
from .generated_files import generator_version, prepared_model
from .kernel.operations import force_operations
from .mechanics.actuator_forces import (
    ForceKernel,
    elimination_kernel,
    force_kernel,
    regrouped,
    with_shared_pose,
)
from .mechanics.formulation import EXACT
from .program.cse import share, shared_blocks


@dataclass(frozen=True)
class Pass:
    """The kernel after one more pass.

    operations: of a pose, without and with friction. sources: the C by file name, with the functions of the
    generated force kernel. model_numbers: how many numbers its prepared model holds.
    """

    name: str
    meaning: str
    operations: tuple[int, int]
    sources: dict[str, str]
    model_numbers: int


def passes() -> tuple[Pass, ...]:
    """The passes in order; each has all those before it."""
    return tuple(_after(name, meaning, derive) for name, meaning, derive in _ORDER)


def _plain(friction: bool) -> ForceKernel:
    """The named steps of the derivation; only the preparation of constants is shared, as in every pass."""
    raw = elimination_kernel(EXACT, friction)
    prepared = share(raw.prepare_leg), share(raw.prepare_platform)
    return replace(raw, prepare_leg=prepared[0], prepare_platform=prepared[1])


_ORDER: tuple[tuple[str, str, Callable[[bool], ForceKernel]], ...] = (
    ("leg frame", "the elimination in the leg frame, step by step", _plain),
    (
        "shared subexpressions",
        "what occurs twice between the named steps computed once",
        lambda friction: shared_blocks(elimination_kernel(EXACT, friction)),
    ),
    (
        "shared pose",
        "S_ddot = B q + a, the platform's inertia about its center of mass",
        lambda friction: shared_blocks(with_shared_pose(EXACT, friction)),
    ),
    (
        "joint coordinates",
        "legs by Lagrange in L, theta, phi with regrouped constants, upper masses on the platform",
        lambda friction: shared_blocks(regrouped(EXACT, friction)),
    ),
    (
        "moments about platform point 1",
        "leg 1 has none: elimination begins with three rows, and five legs have moments",
        lambda friction: prepared_model(EXACT) if friction else shared_blocks(force_kernel(EXACT, False)),
    ),
)


def _after(name: str, meaning: str, derive: Callable[[bool], ForceKernel]) -> Pass:
    smooth, rough = derive(False), derive(True)
    version = generator_version()
    return Pass(
        name,
        meaning,
        operations=(force_operations(smooth).total.total, force_operations(rough).total.total),
        sources={
            "stewart.h": common_header(version),
            **shared_headers(version, rough.about_tip),
            **lanes.files(rough, version, smooth),
        },
        model_numbers=lanes.model_numbers(rough),
    )
