"""The README's part about failures, as Markdown made of what ``stewart-sym stability`` wrote.

``test_readme`` compares it with the README and, run as a program, writes it there.
"""

from typing import Any

from readme_bench import paragraph, table

BEGIN = "<!-- from .docs/stability.json by `python tests/test_readme.py` -->\n"
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


HEADER = ("what fails", "walk", "what we do", "worst", "refused at", "digits left", "silent")


def lead() -> str:
    return paragraph(
        "`stewart-sym stability` walks into each failure, from a distance of 1 to 1e-16, with every kernel, "
        "and measures errors against 50 digits. Worst: the largest error of any kernel with status ok, in "
        "rounding units over the condition number of the problem itself, what changes of its inputs by "
        "rounding units do to its answer. Refused at: the condition number of the first pose with a status. "
        "Digits left: at the worst answer with status ok. Silent: the kernels that give a wrong answer "
        "(above 1000) with status ok."
    )


def row(family: Figures) -> tuple[str, ...]:
    ours = [method for method in family["methods"] if method["shipped"]]
    worst = max((each["worst"] for each in ours if each["worst"] is not None), default=None)
    refused = min((each["refused_at"] for each in ours if each["refused_at"] is not None), default=None)
    digits = min((each["digits"] for each in ours if each["digits"] is not None), default=None)
    silent = [each["method"] for each in ours if each["silent"]]
    return (
        family["fails"],
        family["title"],
        family["remedy"],
        "" if worst is None else f"{worst:.2g}",
        "never" if refused is None else f"{refused:.0e}",
        "" if digits is None else f"{digits:.0f}",
        "; ".join(silent) or "none",
    )


def cases(sweep: Figures) -> str:
    worst = max(sweep["counts"], key=lambda count: count["worst"] or 0.0)
    lowest = min(
        count["lowest"] for count in sweep["counts"] if count["precision"] == "double" and count["lowest"]
    )
    return paragraph(
        f"Of {sweep['cases']:,} random cases near a failure, {sweep['wrong']:,} answers of "
        f"{len({count['kernel'] for count in sweep['counts']})} kernels are wrong with status ok, and "
        f"{sweep['refused_good']:,} good poses have a status; the worst is {worst['worst']:.2g} "
        f"({worst['kind']}, {worst['precision']}, {worst['kernel']}). In double no pose is refused at a "
        f"condition number below {lowest:.0e}. `stewart-sym stability --cases N` judges N others with "
        "`--seed`."
    )
