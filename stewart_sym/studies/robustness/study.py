"""Stability study: families of failures and random cases times kernels, with report, data, and plots."""

import functools
import os
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array
from ...io.progress import Progress, silent, tracked
from ...results import OK, STATUS_TEXT
from ..common.drawing import LEG_COLORS, Figure, legend_below, new_figure
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Figures, aligned
from .failures import FAMILIES, KINDS, MACHINE, UNLIKE, Family, random_cases
from .oracle import EPSILON, FORCES, GOOD, Verdict, check

WRONG = 1000.0
"""Rounding units relative to the condition number of the problem above which a result is wrong."""
CLOSED = ("forward_dynamics", "joint_inertia", "derivatives")
"""Kernels of the closed form in the study; machines that are singular at every pose omit the first one."""
PER_MACHINE = 500
"""Number of random cases of each machine."""
CHUNK = 2_000
"""Number of random cases that are computed at once."""
SHARE = 10
"""Number of cases in double for each case in float, and of the forces for each case of the closed form."""

_SUMS = ("cases", "answered", "wrong", "rejected_good")
_COLUMNS = (
    *(("cases", "cases", "d"), ("ok", "answered", "d"), ("worst", "worst", ".3g")),
    *(("at distance", "where", ".1e"), ("digits", "digits", ".1f"), ("wrong", "wrong", "d")),
    *(("rejected at", "rejected_at", ".1e"), ("good rejected", "rejected_good", "d")),
)
"""Columns of the printed tables: title, count, and format."""
_UNITS = {
    "worst": "rounding units over the condition number of the problem",
    "where": "distance from the failure, as of the family's axis",
    "rejected_at": "condition number",
    "wrong_above": "rounding units over the condition number of the problem",
    "good_below": "condition number",
}

_MARKERS = "os^vDP"
_FLOOR, _CEILING = 1e-17, 1e4


Course = tuple[Family, Array, dict[str, Verdict]]
"""Family, its distances, shape (n,), and the verdicts on all kernels by name."""


def courses(progress: Progress = silent) -> list[Course]:
    """Compute all families in a few seconds."""
    found = []
    for family in tracked(progress, FAMILIES, lambda family: f"approaching {family.name}"):
        cases = family.make(np.random.default_rng(family.seed))
        found.append((family, cases.distance, check(cases, (*FORCES, *CLOSED), floor=True)))
    return found


def sweep(
    cases: int, seed: int = 0, progress: Progress = silent, kinds: tuple[str, ...] = tuple(KINDS)
) -> Figures:
    """Check random cases near failure in double, and a tenth as many in float, in equal parts for each kind.

    Returns the counts of ``summary`` for each kernel, kind, and precision, and their sums. Raises ValueError
    for less than one case of each kind, and native.CompilerError as ``check``.
    """
    if cases < len(kinds) * SHARE:
        raise ValueError(f"cases: expected at least {len(kinds) * SHARE}, got {cases}")
    counts: list[Figures] = []
    parts = [(kind, *precision) for precision in (("double", 1), ("float", SHARE)) for kind in kinds]
    for kind, precision, share in tracked(progress, parts, lambda part: f"computing {part[0]}, {part[1]}"):
        counts += _counts(kind, precision, -(-cases // (share * len(kinds))), seed)
    totals = {name: sum(count[name] for count in counts) for name in ("wrong", "rejected_good")}
    total = sum(count["cases"] for count in counts if count["kernel"] == _named(FORCES[0]))
    return {"cases": total, **totals, "wrong_above": WRONG, "good_below": GOOD, "counts": counts}


def _counts(kind: str, precision: str, wanted: int, seed: int) -> Iterator[Figures]:
    """Yield the count of each kernel for a kind of cases; chunks are computed in parallel."""

    def chunk(start: int) -> dict[str, Figures]:
        rng, count = np.random.default_rng([seed, start, list(KINDS).index(kind)]), min(CHUNK, wanted - start)
        each, decades = min(PER_MACHINE, max(1, count // 20)), 1.0 - np.log10(EPSILON[precision])
        cases = random_cases(kind, rng, count, each, decades)
        closed, few = (CLOSED[1:], cases) if kind == MACHINE else (CLOSED, cases[::SHARE])
        how: Any = {"floor": kind in UNLIKE, "solvable": kind != MACHINE}
        return {
            kernel: summary(verdict, given.distance, precision)
            for kernels, given in ((FORCES, cases), (closed, few))
            for kernel, verdict in check(given, kernels, precision, **how).items()
        }

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        chunks = list(pool.map(chunk, range(0, wanted, CHUNK)))
    for kernel in chunks[0]:
        parts = [chunk[kernel] for chunk in chunks]
        yield {
            **{"kind": kind, "precision": precision, "kernel": _named(kernel)},
            **max(parts, key=lambda part: part["worst"]),
            **{name: sum(part[name] for part in parts) for name in _SUMS},
            "rejected_at": min(part["rejected_at"] for part in parts),
            "shown": next((part["shown"] for part in parts if part["shown"]), ""),
        }


def summary(found: Verdict, distance: Array, precision: str = "double", in_range: bool = True) -> Figures:
    """Summarize the results of one kernel.

    ``answered`` counts results with status OK, ``wrong`` the results of these with an error above ``WRONG``
    units times the condition number, and ``rejected_good`` good poses with a status. ``worst`` is the largest
    error over the condition number with status OK, -1 without any, at distance ``where``. ``rejected_at`` is
    the smallest condition number of a pose with a status, inf without one. ``digits`` are the decimal digits
    of the worst result. ``shown`` describes a failed case.
    """
    ratio, good = found.ratio, found.rejected_good(precision) & in_range
    rejected = (found.status != OK) & (found.truth == OK)
    wrong, worst = int(np.sum(ratio > WRONG)), int(np.argmax(ratio))
    i = int(np.argmax(good)) if good.any() and not wrong else worst
    shown = (
        f"{STATUS_TEXT[int(found.status[i])]}, error {found.error[i]:.3g} units at condition "
        f"{found.condition[i]:.3g}, distance {distance[i]:.3g}"
    )
    largest = EPSILON[precision] * float(np.max(found.error, initial=0.5, where=ratio >= 0.0))
    return {
        "cases": len(ratio),
        "answered": int(np.sum(found.status == OK)),
        "worst": float(ratio[worst]),
        "where": float(distance[worst]),
        "wrong": wrong,
        "rejected_at": float(found.pose[rejected].min(initial=np.inf)),
        "rejected_good": int(good.sum()),
        "digits": max(0.0, float(-np.log10(largest))),
        "shown": shown if wrong or good.any() else "",
    }


def _named(kernel: str) -> str:
    return kernel.replace("_", " ")


def full_report(found: Iterable[Course], swept: Figures) -> Report:
    """Create the report on the families and the random cases, with tables and plots of the families."""
    families, columns, figures = [], {}, {}
    parts = ["Errors of every kernel along families of poses that approach a failure."]
    for family, distance, verdicts in found:
        table: dict[str, NDArray[Any]] = {"distance": distance}
        counts = []
        for kernel, each in verdicts.items():
            name = _named(kernel)
            counts.append({"kernel": name, **summary(each, distance, in_range=family.in_range)})
            table |= {f"{name}: error": each.error * EPSILON["double"], f"{name}: status": each.status}
            table |= {f"{name}: condition": each.condition}
        named = {name: getattr(family, name) for name in ("name", "title", "axis")}
        families.append({**named, "counts": counts})
        columns[family.name] = table
        draw = functools.partial(figure_of, family, distance, verdicts)
        figures[family.name] = Picture(draw, SMALL, dpi=130)
        parts.append(f"{family.title}\n({family.axis})\n{_listed(counts)}")
    data = {"families": families, "sweep": swept, "units": _UNITS}
    return Report("\n\n".join([*parts, sweep_report(swept)]), columns, data, figures)


def sweep_report(swept: Figures) -> str:
    """Format the counts of the random cases as a table, and each notable case as one line."""
    limits = ", ".join(f"{limit:.0e} in {precision}" for precision, limit in GOOD.items())
    return (
        f"{swept['cases']} random cases near failure, each for {len(FORCES)} kernels, a part for "
        f"{len(CLOSED)} more: {swept['wrong']} wrong answers with status ok, "
        f"{swept['rejected_good']} statuses on good poses.\n"
        "worst: error in rounding units over the condition number of the problem.\n"
        f"wrong: worst above {WRONG:g}, or any answer for a singular machine.\n"
        f"rejected at: least condition number of a case with a status; good: below {limits}.\n\n"
        f"{_listed(swept['counts'])}"
    )


def _listed(counts: list[Figures]) -> str:
    rows = [
        (
            ", ".join(count[name] for name in ("kind", "precision", "kernel") if name in count),
            *("-" if count[key] < 0.0 else f"{count[key]:{form}}" for _, key, form in _COLUMNS),
        )
        for count in counts
    ]
    table = aligned(("kernel", *(name for name, _, _ in _COLUMNS)), rows)
    return "\n".join([table, *(count["shown"] for count in counts if count["shown"])])


def figure_of(family: Family, distance: Array, verdicts: dict[str, Verdict]) -> Figure:
    """Plot the errors of all kernels over the distance, with marks at the distances with a status."""
    figure = new_figure(7.0, 5.6)
    ax, curves = figure.subplots(), zip(verdicts.items(), LEG_COLORS, _MARKERS, strict=True)
    for number, ((name, found), color, marker) in enumerate(curves):
        error = np.clip(found.error * EPSILON["double"], _FLOOR, _CEILING)
        # The markers of the curves are offset, so that overlapping curves are distinguishable.
        style: Any = {"color": color, "marker": marker, "markersize": 4.0, "markevery": (number % 4, 4)}
        ax.loglog(distance, error, linewidth=1.1, label=_named(name), **style)
        limit = WRONG * EPSILON["double"] * found.condition
        label = "" if number else f"{WRONG:g} units x condition"
        limit[limit >= _CEILING] = np.nan
        ax.loglog(distance, limit, color="#555555", linestyle="--", linewidth=0.8, label=label)
        rejected: NDArray[Any] = distance[found.status != OK]
        height = np.full(len(rejected), 0.03 + 0.025 * number)
        label = "" if number else "rejected, by its status"
        mark: Any = {"markersize": 5.0, "color": color, "transform": ax.get_xaxis_transform(), "label": label}
        ax.plot(rejected, height, "|", **mark)
    # The lowest part of the panel is reserved for the statuses.
    ax.set(ylim=(_FLOOR / 100.0, 3.0 * _CEILING), xlim=(float(distance.max()), float(distance.min())))
    ax.set(xlabel=family.axis, ylabel=f"error over the size of the output (0 is drawn at {_FLOOR:.0e})")
    figure.suptitle(family.title, fontsize=10.5)
    legend_below(figure)
    return figure
