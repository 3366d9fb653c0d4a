"""The README's part about speed against accuracy, as Markdown made of what ``stewart-sym chart`` wrote.

``test_readme`` compares it with the README and, run as a program, writes it there.
"""

from typing import Any

from readme_bench import paragraph, table

from stewart_sym.backend import fidelity
from stewart_sym.studies.accuracy.budget import MARGIN

BEGIN = "<!-- from .docs/chart.json by `PYTHONPATH=tests/support python tests/cli/test_readme.py` -->\n"
END = "<!-- end of chart -->\n"
TOLERANCES = (("50 %", 0.5), ("5 %", 0.05), ("1 %", 0.01), ("1e-9", 1e-9))

Figures = dict[str, Any]


def replaced(readme: str, found: Figures) -> str:
    """The README with the part between the marks made anew from the figures."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert after, "the README's marks of the chart are gone"
    return f"{before}{BEGIN}\n{text(found)}{END}{after}"


def text(found: Figures) -> str:
    """Everything between the marks."""
    return fidelities(found) + implementations(found) + advice(found)


def fidelities(found: Figures) -> str:
    machine, compiler = found["machine"], found["software"]["compiler"]
    peaks = ", ".join(
        f"{motion['peak_force_N']:,.0f} N on Path {name}" for name, motion in found["motions"].items()
    )
    lead = paragraph(
        "What each level leaves out, what it costs (operations; nanoseconds per pose, one at a time, in "
        "double and in float; bytes of code to prepare and compute one pose in double) and how far it is "
        f"off on the paper's paths, largest error in per cent of the largest force ({peaks}); on "
        f"{machine['cores']} cores of an {machine['processor']}, {compiler}:"
    )
    header = ("fidelity", "what remains", "operations", "ns", "float, ns", "bytes")
    rows = [
        (
            name(each),
            "as printed" if each["formulation"] == "paper" else fidelity.meaning(each["fidelity"]),
            str(each["operations"]),
            f"{each['one_pose_ns']:.0f}",
            f"{in_float(found, each)['one_pose_ns']:.0f}",
            f"{each['text_bytes']:,}",
            *(percent(errors["model"]) for errors in each["errors"].values()),
        )
        for each in found["candidates"]
        if each["precision"] == "double"
    ]
    return lead + table((*header, *(f"Path {motion}" for motion in found["motions"])), rows)


def name(each: Figures) -> str:
    return "`paper`" if each["formulation"] == "paper" else f"`{each['fidelity']}`"


def in_float(found: Figures, double: Figures) -> Figures:
    same = ("formulation", "fidelity")
    (one,) = (
        each
        for each in found["candidates"]
        if each["precision"] == "float" and all(each[key] == double[key] for key in same)
    )
    return one


def percent(error: float) -> str:
    return f"{100 * error:.2g} %" if error else "0"


def implementations(found: Figures) -> str:
    general = [each for each in found["candidates"] if is_general(each)]
    of = {each["precision"]: each["errors"] for each in general}
    parts = [
        f"{max(errors['rounding'] for errors in of[precision].values()):.0e} in {precision}"
        for precision in ("double", "float")
    ]
    others = [
        f"{max(each['rounding'].values()):.0e} in the {each['name']}"
        for each in found["implementations"]
        if each["name"] in ("NumPy kernel", "vector reference")
    ]
    return paragraph(
        "Rounding adds to that, measured beside the same equations at 50 digits; for `general`, at worst (on "
        f"Path III, through a singular pose), {', '.join([*parts, *others])}; for the others about as much."
    )


def is_general(each: Figures) -> bool:
    return (each["formulation"], each["fidelity"]) == ("exact", "general")


def advice(found: Figures) -> str:
    lead = paragraph(
        "What `advise` picks on Path I: the kernel with the fewest operations, float before double, whose "
        f"errors of model and rounding, times a margin of {MARGIN:g}, are within the tolerance:"
    )
    rows = []
    for label, tolerance in TOLERANCES:
        each = picked(found, tolerance)
        error = total(each)
        rows.append((label, f"{name(each)}, {each['precision']}", str(each["operations"]), f"{error:.1e}"))
    return lead + table(("tolerance", "kernel", "operations", "error"), rows)


def picked(found: Figures, tolerance: float) -> Figures:
    """The first of the candidates, which are listed by cost, that is good enough."""
    good = (each for each in found["candidates"] if total(each) * MARGIN <= tolerance)
    return next(good)


def total(each: Figures) -> float:
    errors = each["errors"]["I"]
    found: float = errors["model"] + errors["rounding"]
    return found
