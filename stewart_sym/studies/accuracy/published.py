"""Tables of the documentation from ``chart.json``: cost and error of each fidelity, what `advise` picks."""

from ...backend import fidelity
from ..common.output import Figures, paragraph, table
from .budget import MARGIN
from .cost import candidate_of, entry_of

TOLERANCES = (("50 %", 0.5), ("5 %", 0.05), ("1 %", 0.01), ("1e-9", 1e-9))
README_LEVELS = ("massless", "slender", "frictionless", "paper", "general")


def tables(found: Figures) -> dict[str, str]:
    """Name -> Markdown."""
    return {
        "chart_fidelities": fidelities(found) + implementations(found),
        "chart_advice": advice(found),
        "readme_accuracy": readme(found),
    }


def readme(found: Figures) -> str:
    """A few of the levels, in double, and the rounding error of the default kernel."""
    shown = [each for each in found["candidates"] if name(each).strip("`") in README_LEVELS]
    rows = [
        (
            f"{name(each)}: {meaning(each)}" + (", float" if each["precision"] == "float" else ""),
            str(each["operations"]),
            *(percent(total(each, path)) for path in ("I", "II")),
        )
        for each in shown
        if each["precision"] == "double" or is_general(each)
    ]
    return table(("kernel", "operations", "error, Path I", "error, Path II"), rows)


def meaning(each: Figures) -> str:
    """What a level computes."""
    found: str = "as printed" if each["formulation"] == "paper" else fidelity.meaning(each["fidelity"])
    return found


def fidelities(found: Figures) -> str:
    """Cost and model error of every level."""
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
    header = ("fidelity", "physics", "operations", "ns", "float, ns", "bytes")
    rows = [
        (
            name(each),
            meaning(each),
            str(each["operations"]),
            f"{each['one_pose_ns']:.0f}",
            f"{entry_of(found, each['formulation'], each['fidelity'], 'float')['one_pose_ns']:.0f}",
            f"{each['text_bytes']:,}",
            *(percent(errors["model"]) for errors in each["errors"].values()),
        )
        for each in found["candidates"]
        if each["precision"] == "double"
    ]
    return lead + table((*header, *(f"Path {motion}" for motion in found["motions"])), rows)


def name(each: Figures) -> str:
    """Name of a level as code."""
    return "`paper`" if each["formulation"] == "paper" else f"`{each['fidelity']}`"


def percent(error: float) -> str:
    """Two digits, in per cent."""
    return f"{100 * error:.2g} %" if error else "0"


def implementations(found: Figures) -> str:
    """Rounding errors of the implementations of the whole model."""
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
    """Whether nothing is left out."""
    return candidate_of(each)[:2] == ("exact", "general")


def advice(found: Figures) -> str:
    """What `advise` picks for some tolerances."""
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


def total(each: Figures, path: str = "I") -> float:
    """Errors of model and rounding on a path, share of the largest force."""
    errors = each["errors"][path]
    found: float = errors["model"] + errors["rounding"]
    return found
