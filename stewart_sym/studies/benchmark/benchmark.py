"""Times per pose (ns) of the kernels compared with CasADi, Pinocchio, and MuJoCo: run, tables, and plots.

All results are compared with the vector reference before the timing. Packages that are not installed (extra
``bench``) are omitted.
"""

import functools
from typing import Any

from ...io.extras import EXTRAS, absent, install
from ...io.progress import Progress, silent
from ...robot.robot import Robot
from ..common import host, timing
from ..common.drawing import BLUE, Figure, new_figure
from ..common.host import DISTURBED
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Figures, aligned
from .case import CALLS, EQUATIONS, FORCES, PASSES, SIZES, bench_poses
from .cases import CLOSED, INVERSE, MANY, NAME, PLAIN, all_cases

ROUNDS, QUICK_ROUNDS = 41, 9

COMPARED = {"casadi": "casadi", "pinocchio": "pin", "mujoco": "mujoco"}
"""Distribution of each optional package by its import name."""

BASES = {FORCES: (CLOSED, PLAIN), EQUATIONS: (INVERSE,), PASSES: (CLOSED, PLAIN)}
"""Cases by whose times the times of a group are divided."""

_TITLES = {
    FORCES: "forces with friction, load, and solve",
    EQUATIONS: "equations of motion, one pose",
    CALLS: "one pose from Python",
    SIZES: "batch of",
    PASSES: "after the pass of the derivation",
}


def benchmark(robot: Robot | None = None, quick: bool = False, progress: Progress = silent) -> Figures:
    """Measure all cases on this machine for a robot, or the robot of the paper near its Paths I and II."""
    machine = host.machine()
    progress("preparing the poses")
    poses = bench_poses(robot, MANY)
    missing = absent(*COMPARED)
    cases = all_cases(poses, quick, progress)
    progress("comparing the results")
    differences = [case.difference() for case in cases]
    taken_by_others = host.taken_by_others()
    tasks = list(dict.fromkeys(task for case in cases for task in case.tasks))
    rounds = QUICK_ROUNDS if quick else ROUNDS
    raw = timing.measured(tasks, rounds, progress)
    machine["taken_by_others"] = taken_by_others()
    return {
        "schema": 5,
        "unit": "ns/pose",
        "robot": poses.robot.name,
        "formulation": NAME,
        "rounds": rounds,
        "shortest_sample_s": timing.SHORTEST,
        "machine": machine,
        "software": host.software(*(COMPARED[name] for name in COMPARED if name not in missing)),
        "left_out": [EXTRAS[name][0] for name in missing],
        "cases": [case.figure(raw, off) for case, off in zip(cases, differences, strict=True)],
    }


def of_group(found: Figures, group: str) -> list[Figures]:
    """Return the records of a group."""
    return [case for case in found["cases"] if case["group"] == group]


def ratios(found: Figures, case: Figures) -> dict[str, float]:
    """Return the ratios of the median of a case to the medians of the bases of its group, by their names."""
    medians = {each["name"]: each["median"] for each in found["cases"]}
    bases = (name for name in BASES.get(case["group"], ()) if name in medians)
    return {name: case["median"] / medians[name] for name in bases}


# --- tables -----------------------------------------------------------------------------------


def full_report(found: Figures) -> Report:
    """Create the report with all results as tables, JSON data, and plots."""
    figures = {
        name: Picture(functools.partial(picture, found, group), SMALL, ("png", "svg"))
        for name, group in (("bench", FORCES), ("bench_motion", EQUATIONS))
    }
    return Report(report(found), data=found, figures=figures)


def report(found: Figures) -> str:
    """Format all results with units and conditions as one text."""
    machine, software = found["machine"], found["software"]
    versions = ", ".join(f"{name} {software[name]}" for name in COMPARED.values() if name in software)
    head = [
        f"{found['robot']}, {found['formulation']}; times per pose, medians of {found['rounds']} rounds",
        f"{machine['processor']}, {machine['cores']} cores; {software['compiler']}",
        " ".join(software["flags"]),
        *filter(None, [versions]),
    ]
    taken = machine["taken_by_others"] or 0.0
    if taken > DISTURBED:
        head.append(f"other processes took {100 * taken:.0f} % of the cores' time: the figures are disturbed")
    if found["left_out"]:
        missing = ", ".join(found["left_out"])
        head.append(f"not installed and left out: {missing}; {install('bench')}")
    return "\n\n".join(["\n".join(head), *(_table(found, group) for group in _TITLES), _NOTE]) + "\n"


def _table(found: Figures, group: str) -> str:
    rows = of_group(found, group)
    bases = list(ratios(found, rows[0]))
    header = (_TITLES[group], "poses", "operations", "ns", "quartiles", *(f"x {name}" for name in bases))
    cells = [
        (
            row["name"],
            f"{row['poses']:,}",
            "" if row["operations"] is None else str(row["operations"]),
            number(row["median"]),
            " - ".join(map(number, row["quartiles"])),
            *(f"{ratio:.3f}" for ratio in ratios(found, row).values()),
        )
        for row in rows
    ]
    return aligned(header, cells)


_NOTE = (
    "One pose: called from a loop in C. CasADi: the same equations in C by CasADi, as the closed form in\n"
    "the leg frame and with vectors in the base frame. Engines compute over the tree of all 13 bodies and\n"
    "are called from Python, less a call over nothing; joint motion and generalized forces are given to them."
)


def number(value: float) -> str:
    """Format a time (ns)."""
    return f"{value:.1f}" if value < 1000 else f"{value:.0f}"


# --- the picture ------------------------------------------------------------------------------


def picture(found: Figures, group: str) -> Figure:
    """Plot the time of every case of a group on a logarithmic axis, with ratios to the bases."""
    rows = sorted(of_group(found, group), key=lambda row: float(row["median"]))
    canvas = new_figure(8.6, 0.36 * len(rows) + 1.4)
    axes: Any = canvas.subplots()
    canvas.suptitle(f"{_TITLES[group]}, ns per pose: {found['machine']['processor']}")
    # A time that is negative due to disturbances cannot be drawn on a logarithmic axis.
    low = 0.6 * min(row["quartiles"][0] for row in rows if row["quartiles"][0] > 0.0)
    high = max(row["quartiles"][1] for row in rows)
    for place, row in enumerate(rows):
        color = BLUE if row["package"] is None else "#5a5a5a"
        axes.plot([low, row["median"]], [place, place], color=color, linewidth=1.0, alpha=0.5)
        axes.plot(row["quartiles"], [place, place], color=color, linewidth=3.0, solid_capstyle="butt")
        axes.plot(row["median"], place, "o", color=color, markersize=7)
        times = "   ".join(rf"$\times${ratio:#.3g}" for ratio in ratios(found, row).values())
        at = max(row["median"], row["quartiles"][1]), place
        text = f"{number(row['median'])} ns   {times}"
        axes.annotate(text, at, (9, 0), textcoords="offset points", va="center", color=color)
    axes.set_yticks(range(len(rows)), [row["name"] for row in rows])
    axes.set(xscale="log", xlim=(low, high * (high / low) ** 0.5), ylim=(len(rows) - 0.4, -0.6))
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)
    bases = ", ".join(ratios(found, rows[0]))
    share = rf"; $\times$: of {bases}" if bases else ""
    axes.set_xlabel(f"ns per pose, median (thick: quartiles){share}")
    return canvas
