"""``stewart-sym choose-fidelity``: the cheapest kernel that suffices."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import folder_name, json_file
from ..output import results
from ..terminal import progress_line

HELP = "the cheapest kernel that is good enough for a machine's motions, and what physics it needs"
EXAMPLE = "stewart-sym choose-fidelity enough.toml --generate kernel"
MORE = (
    'The scene is a TOML file: schema = 1, robot (a file beside it), motions (a list of "I", "II", "III" '
    "and of CSV files as for `forces`), tolerance (of the forces, share of a motion's peak force), "
    "optionally margin (default 3: errors times this must be within the tolerance) and rate (Hz: the forces "
    "of one pose must not take longer than a period). Runs the motions at every fidelity, formulation and "
    "precision; the cheapest is the one with the fewest operations, float before double. Rounding is "
    "measured at 12 poses spread over each motion and where force and condition number are largest, the "
    "model error at all poses. Exit code 2 where nothing is good enough. Takes about a minute, half of it "
    "when the kernels are compiled."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    json_file(parser)
    parser.add_argument(
        "--generate",
        metavar="DIR",
        type=folder_name,
        help="write the chosen kernel for this robot, as generate",
    )
    parser.add_argument("--bake", action="store_true", help="fold the robot's numbers into that kernel")


def run(arguments: argparse.Namespace) -> int:
    from ...kit import Choice, write_kit
    from ...studies.accuracy import advice
    from ...studies.accuracy.budget import read_budget
    from ...studies.accuracy.cost import candidate_of, cost
    from ...studies.common.report import Report

    with progress_line() as progress:
        progress("reading the motions")
        budget = read_budget(arguments.scene)
    warn_of_doubts(budget.robot, arguments.scene)
    with results(arguments, read=budget.files) as (take, progress):
        found = advice.advice(cost(budget.robot, budget.motions, progress=progress), budget)
        written: list[Path] = []
        if arguments.generate is not None and found.chosen is not None:
            choice = Choice(**candidate_of(found.chosen)._asdict(), bake=arguments.bake)
            to = arguments.generate
            _, written = write_kit(budget.robot, to, choice, arguments.force, budget.files, progress)
        take(Report("\n".join([advice.report(found), *map(str, written)]), data=advice.as_json(found)))
    if found.chosen is None:
        raise ValueError(f"{arguments.scene}: nothing keeps the budget; closest: {advice.closest(found)}")
    return 0
