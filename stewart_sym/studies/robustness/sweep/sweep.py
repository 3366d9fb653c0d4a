"""Verification of a million random cases near failure: no wrong result with status OK, no status for a good
pose.
"""

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....backend.kernel import robot_numbers
from ....io.array_types import Array
from ....io.progress import Progress, silent
from ....results import OK, STATUS_TEXT
from ...common.output import Figures, aligned
from ..family import WRONG
from .machines import LEGS, machine_size, random_machine
from .oracle import CLOSED_KERNELS, KERNELS, KINDS, MACHINE, check_random, closed_form_errors
from .singular_machines import FAMILIES, singular_machine

GOOD = {"double": 1e12, "float": 1e3}
"""Condition number below which a pose must have a result.

It is the largest of the condition numbers of the problem, of the scaled H, and of the leg frames.
"""
SIZES, MASSES = (1e-4, 1e3), (1e-6, 1e6)
"""Extremes of the size (m) and mass (kg) of a machine."""
PER_MACHINE = 500
FLOAT_SHARE = 10
"""Number of cases in double for each case in float."""
CLOSED_SHARE = 10
"""Number of cases of the force kernels for each case of the closed form, whose verification is more
expensive.
"""
CLOSED = ("forward_dynamics", "joint_inertia", "derivatives")
"""Kernels of the closed form in the sweep; machines that are singular at every pose omit the first one."""


@dataclass(frozen=True)
class Sweep:
    """Results of the sweep.

    Attributes
    ----------
    figures : dict
        Data. ``counts`` has one record for each kernel and each kind of cases. ``cases`` is the number of
        cases, and ``answered`` the number with status OK. ``wrong`` is the number of these with an error
        above ``WRONG`` units times the condition number. ``rejected_good`` is the number with a status and a
        condition number below ``GOOD``. ``worst`` is the largest error relative to the condition number with
        status OK, at distance ``where``. ``lowest`` is the smallest condition number of a case with a status,
        inf without such a case.
    shown : list of str
        Descriptions of the worst case of each count with errors.
    in_quad : int
        Number of cases in quadruple precision.
    """

    figures: Figures
    shown: list[str]
    in_quad: int


def sweep(cases: int, seed: int = 0, progress: Progress = silent, kinds: tuple[str, ...] = KINDS) -> Sweep:
    """Verify random cases near failure in double, and a tenth as many in float, in equal parts for each kind.

    Raises ValueError for less than one case of each kind, and native.CompilerError without ``__float128``.
    """
    if cases < len(kinds) * FLOAT_SHARE:
        raise ValueError(f"cases: expected at least {len(kinds) * FLOAT_SHARE}, got {cases}")
    counts: list[Figures] = []
    shown: list[str] = []
    in_quad = 0
    done = 0.0
    for precision, share in (("double", 1), ("float", FLOAT_SHARE)):
        for kind in kinds:
            progress(f"computing {kind}, {precision}", done / (len(kinds) * (1.0 + 1.0 / FLOAT_SHARE)))
            done += 1.0 / share
            wanted = -(-cases // (share * len(kinds)))
            each = min(PER_MACHINE, max(1, wanted // 20))
            rng = np.random.default_rng([seed, KINDS.index(kind)])
            numbers, sizes = random_machines(rng, -(-wanted // each), kind == MACHINE)
            found = check_random(kind, numbers, sizes, each, seed, precision)
            in_quad += int(found["in_quad"].sum())
            answers = [_of_forces(found, column) for column in range(len(KERNELS))]
            each_closed = each if kind == MACHINE else max(1, each // CLOSED_SHARE)
            kernels = CLOSED[1:] if kind == MACHINE else CLOSED
            closed = closed_form_errors(kind, numbers, sizes, each_closed, seed, precision, kernels=kernels)
            in_quad += int(closed["in_quad"].sum())
            answers += [_of_closed_form(closed, kernel) for kernel in kernels]
            for answer in answers:
                count, i = _counted(answer, kind, precision)
                counts.append(count)
                if count["wrong"] or count["rejected_good"]:
                    shown.append(
                        f"{kind}, {precision}, {answer.kernel}: {STATUS_TEXT[int(answer.status[i])]}, error "
                        f"{answer.error[i]:.3g} units at condition {answer.condition[i]:.3g}, distance "
                        f"{answer.distance[i]:.3g}"
                    )
    figures = {
        "cases": sum(count["cases"] for count in counts if count["kernel"] == KERNELS[0]),
        "wrong": sum(count["wrong"] for count in counts),
        "rejected_good": sum(count["rejected_good"] for count in counts),
        "wrong_above": WRONG,
        "good_below": GOOD,
        "counts": counts,
    }
    return Sweep(figures, shown, in_quad)


def condition_of(found: NDArray[Any]) -> Array:
    """Return the condition number of the problem, at least the scaled one of H."""
    return np.asarray(np.maximum(np.maximum(found["own"], found["scaled"]), 1.0))


def _of_forces(found: NDArray[Any], column: int) -> SimpleNamespace:
    """Return the results of one kernel, (n,): error (rounding units) and condition numbers."""
    condition = condition_of(found)
    return SimpleNamespace(
        kernel=KERNELS[column],
        made=found["made"] == 1,
        status=found["status"][:, column],
        truth=found["truth"],
        error=found["error"][:, column],
        condition=condition,
        # Near the joint singularity, the frame of a leg is inaccurate, even if the forces of this motion are
        # accurate.
        of_pose=np.maximum(condition, found["frames"]),
        distance=found["distance"],
    )


def _of_closed_form(found: NDArray[Any], kernel: str) -> SimpleNamespace:
    column = CLOSED_KERNELS.index(kernel)
    condition, error = found["condition"][:, column], found["error"][:, column]
    return SimpleNamespace(
        kernel=kernel.replace("_", " "),
        made=found["made"] == 1,
        status=found["status"][:, column],
        truth=found["truth"][:, column],
        error=np.where(error < 0.0, np.nan, error * condition),
        condition=condition,
        of_pose=np.maximum(np.maximum(condition, found["scaled"]), found["frames"]),
        distance=found["distance"],
    )


def report(found: Sweep) -> str:
    """Format the counts as a table, and each notable case as one line."""
    rows = [
        (
            f"{count['kind']}, {count['precision']}, {count['kernel']}",
            f"{count['cases']}",
            f"{count['answered']}",
            "-" if count["worst"] < 0.0 else f"{count['worst']:.3g}",
            f"{count['where']:.1e}",
            f"{count['wrong']}",
            f"{count['lowest']:.1e}",
            f"{count['rejected_good']}",
        )
        for count in found.figures["counts"]
    ]
    header = (
        *("near failure", "cases", "ok", "worst", "at distance", "wrong"),
        *("least rejected", "good rejected"),
    )
    cases, wrong, rejected = (found.figures[name] for name in ("cases", "wrong", "rejected_good"))
    head = (
        f"{cases} random cases near failure, each put to {len(KERNELS)} kernels, a part of them to "
        f"{len(CLOSED)} more: {wrong} wrong answers with status ok, {rejected} statuses on good poses.\n"
        f"worst: error in rounding units over the problem's own condition number; wrong: above {WRONG:g}, or "
        "with a singular machine.\n"
        "least rejected: least condition number of a case with a status; good: below "
        + ", ".join(f"{limit:.0e} in {precision}" for precision, limit in GOOD.items())
        + f".\n{found.in_quad} doubtful cases were computed again in quadruple precision.\n\n"
    )
    return head + aligned(header, rows) + ("\n\n" + "\n".join(found.shown) if found.shown else "")


def random_machines(rng: np.random.Generator, count: int, singular: bool) -> tuple[Array, Array]:
    """Generate machines as numbers (count, 205) and sizes (count,), half of them of about one meter, others
    of any size.

    ``singular`` selects machines of the families of ``singular_machines`` in turn.
    """
    machines = []
    families = tuple(FAMILIES)
    for number in range(count):
        legs = LEGS[number // 2 % len(LEGS)]
        size, mass = (10.0 ** rng.uniform(*np.log10(extremes)) for extremes in (SIZES, MASSES))
        size, mass = (size, mass) if number % 2 else (1.0, 10.0)
        machines.append(
            singular_machine(rng, families[number % len(families)], size, mass, legs)
            if singular
            else random_machine(rng, size, mass, legs)
        )
    return (
        np.array([robot_numbers(machine) for machine in machines]),
        np.array([machine_size(machine) for machine in machines]),
    )


def _counted(found: SimpleNamespace, kind: str, precision: str) -> tuple[Figures, int]:
    """Return the count, and the index of the most notable case."""
    answered = found.made & (found.status == OK)
    # Any result with status OK is wrong if the pose is unsolvable.
    ratio = np.where(found.truth == OK, found.error / found.condition, np.inf)
    ratio = np.where(answered, np.where(np.isnan(ratio), np.inf, ratio), -1.0)
    rejected = found.made & (found.status != OK) & (found.truth == OK)
    good = rejected & (found.of_pose < GOOD[precision])
    worst, wrong = int(np.argmax(ratio)), int(np.sum(ratio > WRONG))
    count = {
        "kind": kind,
        "precision": precision,
        "kernel": found.kernel,
        "cases": int(found.made.sum()),
        "answered": int(answered.sum()),
        "wrong": wrong,
        "rejected_good": int(good.sum()),
        "worst": float(ratio[worst]),
        "where": float(found.distance[worst]),
        "lowest": float(found.of_pose[rejected].min(initial=np.inf)),
    }
    return count, int(np.flatnonzero(good)[0]) if good.any() and not wrong else worst
