"""The stability study whole: every family, its verdicts, the report, and the JSON for the README's table."""

from collections.abc import Mapping, Sequence

import numpy as np

from ...io.progress import Progress, silent, tracked
from ..common.output import Figures, aligned
from ..common.report import Picture, Report
from . import attitude, leg_frame, lengths, poses, runs, scales, singular
from .family import WRONG, Family, verdict
from .poses import OUTCOMES, Basins, basins
from .sweep.sweep import Sweep
from .sweep.sweep import report as sweep_report

PARTS = {
    "H singular": singular.families,
    "the universal joint's singularity": leg_frame.families,
    "lengths": lengths.families,
    "orientation": attitude.families,
    "forward kinematics": poses.families,
    "simulation": runs.families,
    "scales": scales.families,
}
"""What makes the families, by what they are about."""


def study(progress: Progress = silent) -> tuple[list[Family], Basins]:
    """Make every family; takes about a minute. Raises native.CompilerError without ``__float128``."""
    found: list[Family] = []
    for _, families in tracked(progress, PARTS.items(), lambda part: f"approaching {part[0]}"):
        found += families()
    progress("looking for the basins of Newton's steps")
    return found, basins()


def full_report(
    families: Sequence[Family], starts: Basins, swept: Sweep, figures: Mapping[str, Picture]
) -> Report:
    """Verdicts on every method, the families' errors and the random cases, with the pictures given."""
    data = as_json(families, starts, swept)
    text = "\n\n".join([report(data["families"]), basins_report(starts), sweep_report(swept)])
    return Report(text, {family.name: family.columns() for family in families}, data, figures)


def methods(family: Family) -> list[Figures]:
    """Each method's verdict, and whether its statuses are where they must be."""
    found = []
    for curve in family.curves:
        each = verdict(curve, family.distance)
        # Beyond the range of double a status may be on any pose.
        right = each["undetected"] == 0 and (family.beyond_range or each["false_alarms"] == 0)
        known = {"method": curve.method, "shipped": curve.shipped, "status": curve.status is not None}
        found.append({**known, "right": right, **each})
    return found


def report(families: Sequence[Figures]) -> str:
    """Every family's verdicts as text."""
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
    """Outcomes of forward kinematics in shares of the starts."""
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
    """Everything that the report says, as plain numbers."""
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
