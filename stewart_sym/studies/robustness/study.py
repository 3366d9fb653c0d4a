"""Stability study: all families, their verdicts, the report, and the JSON data for the table of the
documentation.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from ...io.progress import Progress, silent, tracked
from ..common.output import Figures, aligned, paragraph, table
from ..common.report import Picture, Report
from . import attitude, legs, poses, runs, scales, singular
from .family import WRONG, Family, verdict
from .poses import OUTCOMES, Basins, basins
from .sweep.sweep import Sweep
from .sweep.sweep import report as sweep_report

PARTS = {
    "H singular": singular.families,
    "the universal joint's singularity": legs.axis_families,
    "lengths": legs.length_families,
    "orientation": attitude.families,
    "forward kinematics": poses.families,
    "simulation": runs.families,
    "scales": scales.families,
}
"""Functions that create the families, by subject."""


def study(progress: Progress = silent) -> tuple[list[Family], Basins]:
    """Compute every family in about a minute; raise native.CompilerError without ``__float128``."""
    found: list[Family] = []
    for _, families in tracked(progress, PARTS.items(), lambda part: f"approaching {part[0]}"):
        found += families()
    progress("looking for the basins of Newton's steps")
    return found, basins()


def full_report(
    families: Sequence[Family], starts: Basins, swept: Sweep, figures: Mapping[str, Picture]
) -> Report:
    """Create the report: verdicts of all methods, errors of the families, and random cases, with the given
    plots.
    """
    data = as_json(families, starts, swept)
    text = "\n\n".join([report(data["families"]), basins_report(starts), sweep_report(swept)])
    return Report(text, {family.name: family.columns() for family in families}, data, figures)


def methods(family: Family) -> list[Figures]:
    """Return the verdict of each method, and whether its statuses are correct."""
    found = []
    for curve in family.curves:
        each = verdict(curve, family.distance)
        # Beyond the range of double, a status is valid for any pose.
        right = each["undetected"] == 0 and (family.beyond_range or each["false_alarms"] == 0)
        known = {"method": curve.method, "shipped": curve.shipped, "status": curve.status is not None}
        found.append({**known, "right": right, **each})
    return found


def report(families: Sequence[Figures]) -> str:
    """Format the verdicts of all families as text."""
    parts = [
        "Errors against 50 digits along families of poses that approach a degenerate configuration.\n"
        "worst: largest error in rounding units over the problem's own condition number, with status ok.\n"
        "digits: left at the worst answer with status ok. rejected at: condition number of first status.\n"
        f"undetected: poses with a wrong answer (above {WRONG:g}) and status ok; * shipped, else a candidate."
    ]
    for family in families:
        rows = [
            (
                f"{'*' if each['shipped'] else ' '} {each['method']}",
                _number(each["worst"]),
                _number(each["where"]),
                f"{each['digits']:.1f}",
                _number(each["last"]),
                "-" if each["rejected_at"] is None else _number(each["rejected_at"]),
                f"{each['undetected']}",
                "right" if each["right"] else "WRONG",
            )
            for each in family["methods"]
        ]
        header = ("method", "worst", "at", "digits", "last answer at", "rejected at", "undetected", "status")
        lines = [f"{family['title']}\n({family['axis']})", aligned(header, rows), *family["notes"]]
        parts.append("\n".join(lines))
    return "\n\n".join(parts)


def basins_report(found: Basins) -> str:
    """Format the outcomes of forward kinematics as fractions of the starts."""
    rows = [
        (method, *(f"{100 * found.share(method, outcome):.1f} %" for outcome in range(len(OUTCOMES))))
        for method in found.outcome
    ]
    return (
        f"Forward kinematics from {found.roll.size * found.yaw.size} starts turned all round: "
        f"{found.poses} poses found; `certify_pose` proves {100 * found.proven:.0f} % of a sample.\n"
        + aligned(("Newton's steps", *OUTCOMES), rows)
    )


def as_json(families: Sequence[Family], starts: Basins, swept: Sweep) -> Figures:
    """Return the numbers of the report."""
    named = ("name", "title", "fails", "remedy", "axis", "notes")
    shares = {
        method: [starts.share(method, outcome) for outcome in range(len(OUTCOMES))]
        for method in starts.outcome
    }
    return {
        "families": [
            {name: getattr(family, name) for name in named} | {"methods": methods(family)}
            for family in families
        ],
        "basins": {"shares": shares, "poses": starts.poses, "proven": starts.proven},
        "sweep": swept.figures,
        "units": {
            "worst": "rounding units over the condition number of the problem",
            "where": "distance from the degenerate configuration, as of the family's axis",
            "rejected_at": "condition number",
            "last": "distance, as of the family's axis",
            "shares": "of the starts",
            "wrong_above": "rounding units over the condition number of the problem",
            "good_below": "condition number",
        },
    }


def _number(value: float) -> str:
    return "-" if np.isnan(value) else f"{value:.2g}"


def tables(found: Figures) -> dict[str, str]:
    """Return the Markdown tables of the documentation from ``stability.json`` by name."""
    shown = [family for family in found["families"] if family["remedy"]]
    return {
        "stability_families": paragraph(_COLUMNS) + table(_HEADER, [_row(family) for family in shown]),
        "stability_cases": _cases(found["sweep"]),
    }


_HEADER = ("failure", "sweep", "remedy", "worst", "status from", "digits left", "undetected")
_COLUMNS = (
    "`stewart-sym stability` approaches each degenerate configuration, from a distance of 1 to 1e-16, "
    "with every kernel, and measures errors against 50 digits. Worst: the largest error of any kernel "
    "with status 0, in rounding units times the condition number of the problem itself. Status from: the "
    "condition number of the first pose with a status. Digits left: of the worst answer with status 0. "
    "Undetected: the kernels that give a wrong answer (worst above 1000) with status 0."
)


def _row(family: Figures) -> tuple[str, ...]:
    ours = [method for method in family["methods"] if method["shipped"]]
    worst = max((each["worst"] for each in ours if each["worst"] is not None), default=None)
    rejected = min((each["rejected_at"] for each in ours if each["rejected_at"] is not None), default=None)
    digits = min((each["digits"] for each in ours if each["digits"] is not None), default=None)
    undetected = [each["method"] for each in ours if each["undetected"]]
    return (
        family["fails"],
        family["title"],
        family["remedy"],
        "" if worst is None else f"{worst:.2g}",
        "never" if rejected is None else f"{rejected:.0e}",
        "" if digits is None else f"{digits:.0f}",
        "; ".join(undetected) or "none",
    )


def _cases(sweep: Figures) -> str:
    """Format the random cases by kind and in total."""
    kinds = dict.fromkeys(count["kind"] for count in sweep["counts"])
    rows = [_of_kind(kind, [each for each in sweep["counts"] if each["kind"] == kind]) for kind in kinds]
    lowest = min(
        count["lowest"] for count in sweep["counts"] if count["precision"] == "double" and count["lowest"]
    )
    lead = paragraph(
        f"The sweep has {sweep['cases']:,} random cases in double and float. {sweep['wrong']:,} answers are "
        f"wrong with status 0, and {sweep['rejected_good']:,} good poses have a status. Worst: the largest "
        "error as above, with its precision and kernel; any answer for a singular machine is wrong. In "
        f"double no pose has a status at a condition number below {lowest:.0e}. "
        "`stewart-sym stability --cases N` generates N other cases from `--seed`."
    )
    header = ("random cases", "cases", "kernels", "worst", "wrong", "good poses with a status")
    return lead + table(header, rows)


def _of_kind(kind: str, counts: list[Figures]) -> tuple[str, ...]:
    kernels = list(dict.fromkeys(count["kernel"] for count in counts))
    worst = max(counts, key=lambda count: count["worst"] or -1.0)
    given = (worst["worst"] or -1.0) >= 0.0
    wrong = sum(count["wrong"] for count in counts)
    return (
        kind,
        f"{sum(count['cases'] for count in counts if count['kernel'] == kernels[0]):,}",
        ", ".join(kernels),
        f"{worst['worst']:.2g} ({worst['precision']}, {worst['kernel']})"
        if given
        else ""
        if wrong
        else "unsolvable",
        f"{wrong:,}",
        f"{sum(count['rejected_good'] for count in counts):,}",
    )
