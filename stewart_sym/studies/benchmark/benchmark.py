"""Times per pose (ns) of the kernels: measurement, tables, and plots."""

import functools
from collections.abc import Callable, Iterable
from typing import Any

from ...io.array_types import Array
from ...io.progress import Progress, silent
from ...reference import newton_euler
from ...robot.robot import Robot
from ..common import host, timing
from ..common.drawing import BLUE, Figure, new_figure
from ..common.report import SMALL, Picture, Report
from ..common.text_tables import Figures, aligned
from .cases import CALLS, EQUATIONS, FORCES, MANY, NAME, SIZES, Case, Poses, all_cases, bench_poses

ROUNDS, QUICK_ROUNDS = 41, 9

TITLES = {
    FORCES: "forces with friction, load, and solve",
    EQUATIONS: "equations of motion, one pose",
    CALLS: "one pose from Python",
    SIZES: "batch of",
}
"""Titles of the groups of cases."""


def benchmark(
    robot: Robot | None = None,
    quick: bool = False,
    progress: Progress = silent,
    more: Callable[[Poses, Array], Iterable[Case]] = lambda poses, truth: (),
) -> Figures:
    """Compare all cases with the reference, and measure them on this machine.

    The default of ``robot`` is the robot of the paper; ``more`` returns further cases for poses and forces.
    """
    machine = host.machine()
    progress("preparing the poses")
    poses = bench_poses(robot, MANY)
    truth = newton_euler.inverse_dynamics(poses.robot, poses.motion).F
    cases = [*all_cases(poses, truth, quick, progress), *more(poses, truth)]
    progress("comparing the results")
    differences = [case.difference() for case in cases]
    tasks = list(dict.fromkeys(task for case in cases for task in case.tasks))
    rounds = QUICK_ROUNDS if quick else ROUNDS
    raw = timing.measured(tasks, rounds, progress)
    return {
        "schema": 6,
        "unit": "ns/pose",
        "robot": poses.robot.name,
        "formulation": NAME,
        "rounds": rounds,
        "shortest_sample_s": timing.SHORTEST,
        "machine": machine,
        "software": host.software(),
        "cases": [case.figure(raw, off) for case, off in zip(cases, differences, strict=True)],
    }


def of_group(results: Figures, group: str) -> list[Figures]:
    """Return the records of a group."""
    return [case for case in results["cases"] if case["group"] == group]


def full_report(results: Figures) -> Report:
    """Create the report with all results as tables, JSON data, and plots."""
    figures = {
        name: Picture(functools.partial(picture, results, group), SMALL, ("png", "svg"))
        for name, group in (("bench", FORCES), ("bench_motion", EQUATIONS))
    }
    return Report(report(results), data=results, figures=figures)


def report(results: Figures) -> str:
    """Format all results with units and conditions as one text."""
    machine, software, rounds = results["machine"], results["software"], results["rounds"]
    head = [
        f"{results['robot']}, {results['formulation']}; times per pose, medians of {rounds} rounds",
        f"{machine['processor']}, {machine['cores']} cores; {software['compiler']}",
        " ".join(software["flags"]),
        "One pose: called from a loop in C.",
    ]
    return "\n\n".join(["\n".join(head), *(_table(results, group) for group in TITLES)]) + "\n"


def _table(results: Figures, group: str) -> str:
    rows = of_group(results, group)
    header = (TITLES[group], "poses", "operations", "ns", "quartiles", f"x {rows[0]['name']}")
    cells = [
        (
            row["name"],
            f"{row['poses']:,}",
            "" if row["operations"] is None else str(row["operations"]),
            _number(row["median"]),
            " - ".join(map(_number, row["quartiles"])),
            f"{row['median'] / rows[0]['median']:.3f}",
        )
        for row in rows
    ]
    return aligned(header, cells)


def _number(value: float) -> str:
    return f"{value:.1f}" if value < 1000 else f"{value:.0f}"


def picture(results: Figures, group: str) -> Figure:
    """Plot the time of every case of a group on a logarithmic axis, with ratios to the first case."""
    first, *_ = of_group(results, group)
    rows = sorted(of_group(results, group), key=lambda row: float(row["median"]))
    canvas = new_figure(8.6, 0.36 * len(rows) + 1.4)
    axes: Any = canvas.subplots()
    canvas.suptitle(f"{results['robot']}: {TITLES[group]}, {results['machine']['processor']}")
    # A time that is negative due to disturbances cannot be drawn on a logarithmic axis.
    low = 0.6 * min(row["quartiles"][0] for row in rows if row["quartiles"][0] > 0.0)
    high = max(row["quartiles"][1] for row in rows)
    for place, row in enumerate(rows):
        color = BLUE if row["package"] is None else "#5a5a5a"
        axes.plot([low, row["median"]], [place, place], color=color, linewidth=1.0, alpha=0.5)
        axes.plot(row["quartiles"], [place, place], color=color, linewidth=3.0, solid_capstyle="butt")
        axes.plot(row["median"], place, "o", color=color, markersize=7)
        ratio = f"{row['median'] / first['median']:#.3g}".removesuffix(".")
        text = rf"{_number(row['median'])} ns   $\times${ratio}"
        at = max(row["median"], row["quartiles"][1]), place
        axes.annotate(text, at, (9, 0), textcoords="offset points", va="center", color=color)
    axes.set_yticks(range(len(rows)), [row["name"] for row in rows])
    axes.set(xscale="log", xlim=(low, high * (high / low) ** 0.5), ylim=(len(rows) - 0.4, -0.6))
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel(rf"ns per pose, median (thick: quartiles); $\times$: of {first['name']}")
    return canvas
