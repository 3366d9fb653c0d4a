"""``stewart-sym advise``: the cheapest kernel that suffices."""

import argparse
import contextlib
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import force, path_name
from ..results import reject_inputs
from ..terminal import progress_line

HELP = "the cheapest kernel that is good enough for a machine's motions, and what physics it needs"
EXAMPLE = "stewart-sym advise enough.toml --generate kernel"
MORE = (
    'The scene is a TOML file: schema = 1, robot (a file beside it), motions (a list of "I", "II", '
    '"III" and of CSV files as for `forces`), tolerance (of the forces, share of a motion\'s peak '
    "force), if you like margin (default 3: errors times this must be within the tolerance) and rate "
    "(Hz: a pose alone must not take longer). Runs the motions at every fidelity, formulation and "
    "precision; the cheapest is the one with the fewest operations, float before double. Rounding is "
    "measured at 12 poses spread over each motion and at its hardest, the model at all poses. Exit "
    "code 2 where nothing is good enough. Takes half a minute, less when the kernels are compiled."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``advise``."""
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    parser.add_argument(
        "--json", metavar="FILE", type=path_name, help="write all figures and the answer to a file"
    )
    parser.add_argument(
        "--generate",
        metavar="DIR",
        type=path_name,
        help="write the chosen kernel for this robot, as generate",
    )
    parser.add_argument("--bake", action="store_true", help="fold the robot's numbers into that kernel")
    force(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``advise``; returns the exit code."""
    import json

    from ...io.writing import replaced_file
    from ...kit import Choice, write_kit
    from ...studies.accuracy import advice
    from ...studies.accuracy.budget import read_budget
    from ...studies.accuracy.cost import cost

    budget = read_budget(arguments.scene)
    if arguments.json is not None:
        reject_inputs(arguments.json, *budget.files)
    warn_of_doubts(budget.robot, arguments.scene)
    with contextlib.ExitStack() as opened, progress_line() as progress:
        stream = None if arguments.json is None else opened.enter_context(replaced_file(arguments.json))
        found = advice.advice(cost(budget.robot, budget.motions, progress=progress), budget)
        if stream is not None:
            stream.write(json.dumps(advice.as_json(found), indent=1) + "\n")
        written: list[Path] = []
        if arguments.generate is not None and found.chosen is not None:
            progress("generating")
            it = found.chosen.candidate
            choice = Choice(
                formulation=it.formulation,
                fidelity=it.fidelity,
                bake=arguments.bake,
                precision=it.precision,
            )
            _, written = write_kit(budget.robot, arguments.generate, choice, arguments.force, budget.files)
    print(advice.report(found))
    for path in written:
        print(path)
    if found.chosen is None:
        raise ValueError(f"{arguments.scene}: nothing keeps the budget; closest: {advice.closest(found)}")
    return 0
