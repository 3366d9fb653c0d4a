"""Tables of the documentation from the figures of ``chart``: cost and error of each level, and the choice."""

from markdown_text import paragraph, table

from stewart_sym.generated.fidelities import FIDELITIES
from stewart_sym.studies.accuracy.budget import MARGIN
from stewart_sym.studies.accuracy.cost import candidate_of
from stewart_sym.studies.common.text_tables import Figures

_TOLERANCES = (("50 %", 0.5), ("5 %", 0.05), ("1 %", 0.01), ("1e-9", 1e-9))
_README_LEVELS = ("massless", "slender", "frictionless", "paper", "general")


def entry_of(found: Figures, *kernel: str) -> Figures:
    """Return the record of a candidate with the given formulation, fidelity level, and precision."""
    return next(entry for entry in found["candidates"] if candidate_of(entry) == kernel)


def tables(found: Figures) -> dict[str, str]:
    """Return the tables of ``chart.json``: cost and error of each level, and the chosen kernel."""
    return {
        "chart_fidelities": _fidelities(found) + _implementations(found),
        "chart_advice": _advice(found),
        "readme_accuracy": _readme(found),
    }


def _readme(found: Figures) -> str:
    """Format some of the levels in double precision, and the rounding error of the default kernel."""
    shown = [each for each in found["candidates"] if _name(each).strip("`") in _README_LEVELS]
    rows = [
        (
            f"{_name(each)}: {_meaning(each)}" + (", float" if each["precision"] == "float" else ""),
            str(each["operations"]),
            *(_percent(_total(each, path)) for path in ("I", "II")),
        )
        for each in shown
        if each["precision"] == "double" or _is_general(each)
    ]
    return table(("kernel", "operations", "error, Path I", "error, Path II"), rows)


def _meaning(each: Figures) -> str:
    found: str = "as printed" if each["formulation"] == "paper" else FIDELITIES[each["fidelity"]]["meaning"]
    return found


def _fidelities(found: Figures) -> str:
    machine, compiler = found["machine"], found["software"]["compiler"]
    peaks = ", ".join(
        f"{motion['peak_force_N']:,.0f} N on Path {name}" for name, motion in found["motions"].items()
    )
    lead = paragraph(
        "The table lists the physics, the cost, and the error of each level. Times are nanoseconds for one "
        "pose at a time, in double and in float. Errors are the largest error on each of the paper's paths, "
        "in percent of the largest force "
        f"({peaks}). The machine has {machine['cores']} cores of an {machine['processor']}, and {compiler}."
    )
    header = ("fidelity", "physics", "operations", "ns", "float, ns")
    rows = [
        (
            _name(each),
            _meaning(each),
            str(each["operations"]),
            f"{each['one_pose_ns']:.0f}",
            f"{entry_of(found, each['formulation'], each['fidelity'], 'float')['one_pose_ns']:.0f}",
            *(_percent(errors["model"]) for errors in each["errors"].values()),
        )
        for each in found["candidates"]
        if each["precision"] == "double"
    ]
    return lead + table((*header, *(f"Path {motion}" for motion in found["motions"])), rows)


def _name(each: Figures) -> str:
    return "`paper`" if each["formulation"] == "paper" else f"`{each['fidelity']}`"


def _percent(error: float) -> str:
    return f"{100 * error:.2g} %" if error else "0"


def _implementations(found: Figures) -> str:
    general = [each for each in found["candidates"] if _is_general(each)]
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
        "Rounding errors, measured against the same equations with 50 digits, are added to the errors of the "
        "table. For `general` the largest ones, on Path III through a singular pose, are "
        f"{', '.join([*parts, *others])}. They are similar for the other levels."
    )


def _is_general(each: Figures) -> bool:
    return candidate_of(each)[:2] == ("exact", "general")


def _advice(found: Figures) -> str:
    lead = paragraph(
        "The table lists the choice of `choose-fidelity` on Path I for four tolerances. It is the kernel "
        "with the fewest operations, float before double, whose model and rounding errors, multiplied by a "
        f"margin of {MARGIN:g}, are within the tolerance."
    )
    rows = []
    for label, tolerance in _TOLERANCES:
        # The first acceptable candidate is selected, because the candidates are sorted by cost.
        each = next(each for each in found["candidates"] if _total(each) * MARGIN <= tolerance)
        error = _total(each)
        rows.append((label, f"{_name(each)}, {each['precision']}", str(each["operations"]), f"{error:.1e}"))
    return lead + table(("tolerance", "kernel", "operations", "error"), rows)


def _total(each: Figures, path: str = "I") -> float:
    """Return the sum of modeling and rounding errors on a path, as a fraction of the largest force."""
    errors = each["errors"][path]
    found: float = errors["model"] + errors["rounding"]
    return found
