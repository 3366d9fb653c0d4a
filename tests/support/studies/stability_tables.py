"""Tables of the documentation from the figures of ``stability``: families of failures, and random cases."""

import numpy as np
from markdown_text import paragraph, table

from stewart_sym.studies.common.text_tables import Figures


def tables(found: Figures) -> dict[str, str]:
    """Return the Markdown tables of the documentation from ``stability.json`` by name."""
    rows = [_row(family, family["counts"]) for family in found["families"]]
    return {
        "stability_families": paragraph(_COLUMNS) + table(_HEADER, rows),
        "stability_cases": _cases(found["sweep"]),
    }


_PIVOT = "elimination with partial pivoting; status 4 if a pivot is at the rounding level of its row"
_FRAME = "sine and frame from k x s, dynamics in joint coordinates; status 3 for a sine of rounding level"
_ALONG = "leg along its universal joint's fixed axis"
_FAILURES = {
    "singular_path_III": ("H singular", _PIVOT),
    "singular_hexagons": ("H singular", _PIVOT),
    "joint_singularity": (_ALONG, _FRAME),
    "joint_singularity_at_rest": (f"{_ALONG}, at rest", "status 3 for a sine of rounding level"),
    "zero_length": (
        "leg of length zero",
        "status 2 if the length is at the rounding level of its terms",
    ),
    "scale_extreme": (
        "overflow, underflow",
        "status 1 if a result or a square exceeds the range of double",
    ),
}
"""Failure and remedy of each family, by name."""

_HEADER = ("failure", "sweep", "remedy", "worst", "status from", "digits left", "undetected")
_COLUMNS = (
    "`stewart-sym stability` approaches each failure with every kernel, and measures errors against `long "
    "double`, which is tested against 50 digits. `worst` is the largest error of any kernel with status 0, "
    "in rounding units times the condition number of the problem. `status from` is the condition number of "
    "the first pose with another status. `digits left` is the number of correct digits of the worst result "
    "with status 0. `undetected` lists the kernels that return a wrong result (error above 1000) with "
    "status 0."
)


def _row(family: Figures, counts: list[Figures]) -> tuple[str, ...]:
    fails, remedy = _FAILURES[family["name"]]
    rejected = min(count["rejected_at"] or np.inf for count in counts)
    return (
        *(fails, family["title"], remedy),
        f"{max(count['worst'] or np.inf for count in counts):.2g}",
        f"{rejected:.0e}" if np.isfinite(rejected) else "never",
        f"{min(count['digits'] for count in counts):.0f}",
        "; ".join(count["kernel"] for count in counts if count["wrong"]) or "none",
    )


def _cases(swept: Figures) -> str:
    """Format the random cases by kind and in total."""
    kinds = dict.fromkeys(count["kind"] for count in swept["counts"])
    rows = [_of_kind(kind, [each for each in swept["counts"] if each["kind"] == kind]) for kind in kinds]
    lowest = min(each["rejected_at"] or np.inf for each in swept["counts"] if each["precision"] == "double")
    lead = paragraph(
        f"The sweep has {swept['cases']:,} random cases in double and float. {swept['wrong']:,} results are "
        f"wrong with status 0, and {swept['rejected_good']:,} solvable poses have another status. `worst` is "
        "the largest error as above, with its precision and kernel; any result for a singular machine is "
        f"wrong. In double, all poses with a condition number below {lowest:.0e} have status 0. "
        "`stewart-sym stability --cases N` generates N other cases from `--seed`."
    )
    header = ("random cases", "cases", "kernels", "worst", "wrong", "solvable poses with another status")
    return lead + table(header, rows)


def _of_kind(kind: str, counts: list[Figures]) -> tuple[str, ...]:
    kernels = list(dict.fromkeys(count["kernel"] for count in counts))
    worst = max(counts, key=lambda count: count["worst"])
    return (
        kind,
        f"{sum(count['cases'] for count in counts if count['kernel'] == kernels[0]):,}",
        ", ".join(kernels),
        f"{worst['worst']:.2g} ({worst['precision']}, {worst['kernel']})"
        if worst["answered"]
        else "unsolvable",
        f"{sum(count['wrong'] for count in counts):,}",
        f"{sum(count['rejected_good'] for count in counts):,}",
    )
