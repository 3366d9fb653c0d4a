"""The README's part about failures, as Markdown made of what ``stewart-sym stability`` wrote.

``test_readme`` compares it with the README and, run as a program, writes it there.
"""

from typing import Any

from readme_bench import paragraph, table

BEGIN = "<!-- from .docs/stability.json by `PYTHONPATH=tests/support python tests/cli/test_readme.py` -->\n"
END = "<!-- end of stability -->\n"

Figures = dict[str, Any]


def replaced(readme: str, found: Figures) -> str:
    """The README with the part between the marks made anew from the figures."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert after, "the README's marks of stability are gone"
    return f"{before}{BEGIN}\n{text(found)}{END}{after}"


def text(found: Figures) -> str:
    """Everything between the marks."""
    shown = [family for family in found["families"] if family["remedy"]]
    return "".join([lead(), table(HEADER, [row(family) for family in shown]), cases(found["sweep"])])


HEADER = ("what fails", "walk", "what we do", "worst", "rejected at", "digits left", "silent")


def lead() -> str:
    return paragraph(
        "`stewart-sym stability` walks into each failure, from a distance of 1 to 1e-16, with every kernel, "
        "and measures errors against 50 digits. Worst: the largest error of any kernel with status ok, in "
        "rounding units over the condition number of the problem itself, what changes of its inputs by "
        "rounding units do to its answer. Rejected at: the condition number of the first pose with a status. "
        "Digits left: at the worst answer with status ok. Silent: the kernels that give a wrong answer "
        "(above 1000) with status ok."
    )


def row(family: Figures) -> tuple[str, ...]:
    ours = [method for method in family["methods"] if method["shipped"]]
    worst = max((each["worst"] for each in ours if each["worst"] is not None), default=None)
    rejected = min((each["rejected_at"] for each in ours if each["rejected_at"] is not None), default=None)
    digits = min((each["digits"] for each in ours if each["digits"] is not None), default=None)
    silent = [each["method"] for each in ours if each["silent"]]
    return (
        family["fails"],
        family["title"],
        family["remedy"],
        "" if worst is None else f"{worst:.2g}",
        "never" if rejected is None else f"{rejected:.0e}",
        "" if digits is None else f"{digits:.0f}",
        "; ".join(silent) or "none",
    )


CASES_HEADER = ("random cases", "cases", "kernels", "worst", "wrong", "good poses with a status")


def cases(sweep: Figures) -> str:
    """What the sweep saw, kind by kind, and in all."""
    kinds = dict.fromkeys(count["kind"] for count in sweep["counts"])
    rows = [of_kind(kind, [each for each in sweep["counts"] if each["kind"] == kind]) for kind in kinds]
    lowest = min(
        count["lowest"] for count in sweep["counts"] if count["precision"] == "double" and count["lowest"]
    )
    lead = paragraph(
        f"Of {sweep['cases']:,} random cases, in double and float, {sweep['wrong']:,} answers are wrong with "
        f"status ok, and {sweep['rejected_good']:,} good poses have a status, by kind as follows. Worst: as "
        "above, with the precision and the kernel where it is; of a singular machine any answer is wrong. In "
        f"double no pose is rejected at a condition number below {lowest:.0e}. "
        "`stewart-sym stability --cases N` draws N others with `--seed`."
    )
    return lead + table(CASES_HEADER, rows)


def of_kind(kind: str, counts: list[Figures]) -> tuple[str, ...]:
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
        else "no answer",
        f"{wrong:,}",
        f"{sum(count['rejected_good'] for count in counts):,}",
    )
