"""Tables of the documentation from ``stability.json``: degenerate configurations and random cases."""

from ..common.output import Figures, paragraph, table


def tables(found: Figures) -> dict[str, str]:
    """Name -> Markdown."""
    shown = [family for family in found["families"] if family["remedy"]]
    return {
        "stability_families": lead() + table(HEADER, [row(family) for family in shown]),
        "stability_cases": cases(found["sweep"]),
    }


HEADER = ("failure", "sweep", "remedy", "worst", "status from", "digits left", "undetected")


def lead() -> str:
    """What the columns mean."""
    return paragraph(
        "`stewart-sym stability` approaches each degenerate configuration, from a distance of 1 to 1e-16, "
        "with every kernel, and measures errors against 50 digits. Worst: the largest error of any kernel "
        "with status 0, in rounding units times the condition number of the problem itself. Status from: the "
        "condition number of the first pose with a status. Digits left: of the worst answer with status 0. "
        "Undetected: the kernels that give a wrong answer (worst above 1000) with status 0."
    )


def row(family: Figures) -> tuple[str, ...]:
    """Cells of a family."""
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


CASES_HEADER = ("random cases", "cases", "kernels", "worst", "wrong", "good poses with a status")


def cases(sweep: Figures) -> str:
    """The random cases, kind by kind, and in all."""
    kinds = dict.fromkeys(count["kind"] for count in sweep["counts"])
    rows = [of_kind(kind, [each for each in sweep["counts"] if each["kind"] == kind]) for kind in kinds]
    lowest = min(
        count["lowest"] for count in sweep["counts"] if count["precision"] == "double" and count["lowest"]
    )
    lead = paragraph(
        f"Of {sweep['cases']:,} random cases, in double and float, {sweep['wrong']:,} answers are wrong with "
        f"status 0, and {sweep['rejected_good']:,} good poses have a status, by kind as follows. Worst: as "
        "above, with the precision and the kernel where it is; of a singular machine any answer is wrong. In "
        f"double no pose has a status at a condition number below {lowest:.0e}. "
        "`stewart-sym stability --cases N` draws N others with `--seed`."
    )
    return lead + table(CASES_HEADER, rows)


def of_kind(kind: str, counts: list[Figures]) -> tuple[str, ...]:
    """Cells of a kind of case."""
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
