"""Find the cheapest kernel within a tolerance of the forces.

All keys of the scene are on page "Files" of the documentation.
The study runs its motions at every fidelity, formulation, and precision, in about a minute.
Exit code: 0, or 2 if no kernel is within the tolerance or for an error.

Example: stewart-sym choose-fidelity enough.toml --generate kernel
"""

from pathlib import Path

from ...studies.common.report import Report
from ..command import Arguments, Parser, folder_name, results
from ..inputs import warn_of_doubts


def add_arguments(parser: Parser) -> None:
    parser.file("scene")
    parser.json()
    parser.valued("generate", folder_name, "folder of a kit with the chosen kernel", metavar="DIR")
    parser.flag("bake", "insert the constants of the robot into that kernel")


def run(arguments: Arguments) -> None:
    from ...kit import Choice, write_kit
    from ...studies.accuracy import advice
    from ...studies.accuracy.budget import read_budget
    from ...studies.accuracy.cost import candidate_of, cost

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
        raise ValueError(f"{arguments.scene}: {advice.answer(found)}")
