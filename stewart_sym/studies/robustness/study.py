"""Stability study: families of failures and random cases times kernels, with report and data."""

import os
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...io.array_types import Array
from ...io.progress import Progress, silent, tracked
from ...results import OK, STATUS_TEXT
from ..common.output import Figures, aligned
from ..common.report import Picture, Report
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


@dataclass(frozen=True, eq=False)
class Course:
    """Verdicts on all kernels, by name, over the distances of a family, shape (n,)."""

    family: Family
    distance: Array
    verdicts: dict[str, Verdict]

    def columns(self) -> dict[str, NDArray[Any]]:
        """Return the columns (n,) of its CSV file."""
        found: dict[str, NDArray[Any]] = {"distance": self.distance}
        for name, each in self.verdicts.items():
            found |= {f"{name}: error": each.error * EPSILON["double"], f"{name}: status": each.status}
            found |= {f"{name}: condition": each.condition}
        return found


def courses(progress: Progress = silent) -> list[Course]:
    """Compute all families in a few seconds."""
    found = []
    for family in tracked(progress, FAMILIES, lambda family: f"approaching {family.name}"):
        cases = family.make(np.random.default_rng(family.seed))
        with np.errstate(all="ignore"):
            verdicts = check(cases, (*FORCES, *CLOSED), floor=True)
        found.append(Course(family, cases.distance, {_named(k): each for k, each in verdicts.items()}))
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
    done = 0.0
    for precision, share in (("double", 1), ("float", SHARE)):
        for kind in kinds:
            progress(f"computing {kind}, {precision}", done / (len(kinds) * (1.0 + 1.0 / SHARE)))
            done += 1.0 / share
            counts += _counts(kind, precision, -(-cases // (share * len(kinds))), seed)
    totals = {name: sum(count[name] for count in counts) for name in ("wrong", "rejected_good")}
    total = sum(count["cases"] for count in counts if count["kernel"] == _named(FORCES[0]))
    return {"cases": total, **totals, "wrong_above": WRONG, "good_below": GOOD, "counts": counts}


def _counts(kind: str, precision: str, wanted: int, seed: int) -> Iterator[Figures]:
    """Yield the count of each kernel for a kind of cases; chunks are computed in parallel."""
    starts = range(0, wanted, CHUNK)

    def chunk(start: int) -> dict[str, Figures]:
        rng = np.random.default_rng([seed, start, list(KINDS).index(kind)])
        return _chunk(kind, precision, min(CHUNK, wanted - start), rng)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        chunks = list(pool.map(chunk, starts))
    for kernel in chunks[0]:
        parts = [chunk[kernel] for chunk in chunks]
        worst = max(parts, key=lambda part: part["worst"])
        sums = {name: sum(part[name] for part in parts) for name in _SUMS}
        shown = next((part["shown"] for part in parts if part["shown"]), "")
        least = min(part["rejected_at"] for part in parts)
        known = {"kind": kind, "precision": precision, "kernel": kernel}
        yield {**known, **worst, **sums, "rejected_at": least, "shown": shown}


def _chunk(kind: str, precision: str, count: int, rng: np.random.Generator) -> dict[str, Figures]:
    """Return the summary of each kernel for some random cases."""
    each = min(PER_MACHINE, max(1, count // 20))
    cases = random_cases(kind, rng, count, each, 1.0 - np.log10(EPSILON[precision]))
    closed, few = (CLOSED[1:], cases) if kind == MACHINE else (CLOSED, cases[::SHARE])
    found = {}
    for kernels, given in ((FORCES, cases), (closed, few)):
        with np.errstate(all="ignore"):
            verdicts = check(given, kernels, precision, floor=kind in UNLIKE, solvable=kind != MACHINE)
        for kernel, verdict in verdicts.items():
            found[_named(kernel)] = summary(verdict, given.distance, precision)
    return found


_SUMS = ("cases", "answered", "wrong", "rejected_good")


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


# --- report and data ------------------------------------------------


def full_report(found: Iterable[Course], swept: Figures, figures: Mapping[str, Picture]) -> Report:
    """Create the report on the families and the random cases, with the given plots."""
    families, columns = [], {}
    for course in found:
        family, distance = course.family, course.distance
        named = {name: getattr(family, name) for name in ("name", "title", "fails", "remedy", "axis")}
        counts = [
            {"kernel": kernel, **summary(each, distance, in_range=family.in_range)}
            for kernel, each in course.verdicts.items()
        ]
        families.append({**named, "counts": counts})
        columns[family.name] = course.columns()
    data = {"families": families, "sweep": swept, "units": _UNITS}
    head = "Errors of every kernel along families of poses that approach a failure."
    parts = [f"{each['title']}\n({each['axis']})\n{_listed(each['counts'])}" for each in families]
    text = "\n\n".join([head, *parts, sweep_report(swept)])
    return Report(text, columns, data, figures)


def sweep_report(swept: Figures) -> str:
    """Format the counts of the random cases as a table, and each notable case as one line."""
    limits = ", ".join(f"{limit:.0e} in {precision}" for precision, limit in GOOD.items())
    lines = [
        f"{swept['cases']} random cases near failure, each for {len(FORCES)} kernels, a part for "
        f"{len(CLOSED)} more: {swept['wrong']} wrong answers with status ok, "
        f"{swept['rejected_good']} statuses on good poses.",
        "worst: error in rounding units over the condition number of the problem.",
        f"wrong: worst above {WRONG:g}, or any answer for a singular machine.",
        f"rejected at: least condition number of a case with a status; good: below {limits}.",
    ]
    return "\n".join(lines) + "\n\n" + _listed(swept["counts"])


def _listed(counts: list[Figures]) -> str:
    header = ("kernel", *(name for name, _, _ in _COLUMNS))
    rows = [
        (
            ", ".join(count[name] for name in ("kind", "precision", "kernel") if name in count),
            *("-" if count[key] < 0.0 else f"{count[key]:{form}}" for _, key, form in _COLUMNS),
        )
        for count in counts
    ]
    return "\n".join([aligned(header, rows), *(count["shown"] for count in counts if count["shown"])])


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
