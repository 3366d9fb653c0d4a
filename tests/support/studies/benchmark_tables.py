"""Tables of the documentation from the figures of ``compare_engines.py``: forces, passes, and motion."""

from markdown_text import paragraph, table

from stewart_sym.studies.benchmark.benchmark import of_group
from stewart_sym.studies.benchmark.cases import CALLS, EQUATIONS, FORCES, SIZES
from stewart_sym.studies.common.text_tables import Figures

PASSES = "passes"
"""Group of the kernel after each pass of the derivation."""

CLOSED, PLAIN, FORWARD = "CasADi, closed form", "CasADi", "forward dynamics"

README_ROWS = (
    *("one pose", "batch, one core", "batch, columns", "batch, float", "every output", "NumPy kernel"),
    *(CLOSED, PLAIN, "Pinocchio"),
)


def tables(found: Figures) -> dict[str, str]:
    """Return Markdown tables by name; raise ValueError for a run without other software."""
    if CLOSED not in {case["name"] for case in found["cases"]}:
        raise ValueError("bench.json: expected figures of `compare_engines.py`, got figures without CasADi")
    return {
        "bench_times": _times(found) + _sizes(found) + _calls(found),
        "bench_passes": _passes(found),
        "bench_motion": _motion(found),
        "readme_speed": _readme(found),
    }


def _ratio(case: Figures, base: Figures) -> str:
    return f"{case['median'] / base['median']:.2f}"


def _readme(found: Figures) -> str:
    forces = {each["name"]: each for each in of_group(found, FORCES)}
    rows = [
        (name, f"{forces[name]['median']:.0f}", _ratio(forces[name], forces[CLOSED])) for name in README_ROWS
    ]
    forward = [each for each in of_group(found, EQUATIONS) if each["name"].startswith(FORWARD)]
    rows += [(each["name"], f"{each['median']:.0f}", "") for each in forward]
    return table(("forces with friction and load", "ns per pose", "relative to CasADi, closed form"), rows)


def _times(found: Figures) -> str:
    machine, compiler = found["machine"], found["software"]["compiler"]
    vectors = f" with {machine['vectors']}" if machine["vectors"] else ""
    forces = {each["name"]: each for each in of_group(found, FORCES)}
    rows = [
        (name, f"{each['median']:.0f}", _ratio(each, forces[CLOSED]), _ratio(each, forces[PLAIN]))
        for name, each in forces.items()
    ]
    return paragraph(
        f"The table lists nanoseconds per pose of `{found['formulation']}` with friction and load, medians "
        f"of {found['rounds']} rounds. The machine has "
        f"{machine['cores']} cores of an {machine['processor']}{vectors}, and {compiler}. Ratios are to "
        "CasADi's C of the closed form in the leg frame, and to CasADi's C of the unchanged equations."
    ) + table(("", "ns per pose", "ratio to CasADi, closed form", "ratio to CasADi, plain C"), rows)


def _sizes(found: Figures) -> str:
    rows = of_group(found, SIZES)
    header = ("poses in one call of `forces`", *(f"{each['poses']:,}" for each in rows))
    return table(header, [("ns per pose", *(f"{each['median']:.0f}" for each in rows))])


def _calls(found: Figures) -> str:
    rows = [(f"`{each['name']}`", f"{each['median'] / 1e3:.2f}") for each in of_group(found, CALLS)]
    return table(("one pose from Python", "us per call"), rows)


def _passes(found: Figures) -> str:
    rows = of_group(found, PASSES)
    cells = [
        (
            one["name"].removesuffix(", one pose"),
            str(one["operations"]),
            f"{one['median']:.0f}",
            f"{batch['median']:.0f}",
        )
        for one, batch in zip(rows[::2], rows[1::2], strict=True)
    ]
    header = ("after the pass", "operations with friction", "one pose, ns", "batch, ns")
    return paragraph(
        "The table lists operations and times per pose after each reduction of the derivation, for the "
        f"forces alone. Batches have {rows[1]['poses']:,} poses and use one core."
    ) + table(header, cells)


def _motion(found: Figures) -> str:
    """Format times of the equations of motion and of their baselines."""
    cases = of_group(found, EQUATIONS)
    rows = [(each["name"], f"{each['median']:.0f}", _ratio(each, cases[0])) for each in cases]
    ours = next(each for each in cases if each["name"] == FORWARD)
    engines = [each for each in cases if each["package"] is not None]
    better = min(engines, key=lambda each: float(each["median"]))
    names = " and ".join(f"{each['package']}'s `{each['what'].split(',')[0]}`" for each in engines)
    agreement = " and ".join(f"{each['largest_difference']:.0e}" for each in engines)
    lead = paragraph(
        "The table lists the functions of the closed form in C (`stewart_exact_motion.h`) for one pose at a "
        f"time. Nanoseconds per pose are medians of the same {found['rounds']} rounds over "
        f"{ours['poses']} poses."
    )
    about = paragraph(
        f"Forward dynamics is {better['median'] / ours['median']:.1f} times as fast as the better of the "
        f"two baselines, {better['package']}. The baselines are {names}. Their model is a tree of all 13 "
        "bodies with five loop closures, the same load, and the same friction. They are called from Python "
        "with the state and the generalized forces; the time of a call for a model without bodies is "
        "subtracted."
    ) + paragraph(
        f"Their accelerations agree with ours to {agreement} of the largest one of a pose. No body can have "
        "the inertia tensors of the paper, and MuJoCo rejects them. Therefore this table uses physically "
        "possible tensors near them."
    )
    return lead + table(("", "ns per pose", "ratio to inverse dynamics"), rows) + about
