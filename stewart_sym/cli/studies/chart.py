"""``stewart-sym chart``: cost and accuracy as pictures."""

import argparse
from pathlib import Path

from ..inputs import warn_of_doubts
from ..options import no_pictures, output
from ..results import drawing, results_folder
from ..terminal import progress_line

HELP = "draw time per pose over error, of the model and of rounding: pictures, CSV, JSON, table"
EXAMPLE = "stewart-sym chart enough.toml -o chart"
MORE = (
    "chart.png: every fidelity and implementation is a point; scales.png: rounding over size and mass"
    " of machines like this one; bounds.png: rounding and its bound. Each as SVG and CSV, too. The "
    "scene is one of `advise`; without it: the paper's machine on its Paths I, II and III. Takes "
    "about a minute."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``chart``."""
    parser.add_argument("scene", metavar="SCENE.toml", type=Path, nargs="?", help="scene file, schema 1")
    output(parser, "DIR", "folder to write to", Path("chart"))
    no_pictures(parser)


def run(arguments: argparse.Namespace) -> int:
    """Run ``chart``; returns the exit code."""
    import json

    from ...studies.accuracy.advice import table
    from ...studies.accuracy.budget import papers_motions, read_budget
    from ...studies.accuracy.charts import charts
    from ...studies.accuracy.cost import ROUNDS, cost
    from ...studies.accuracy.cost_plot import save
    from ...studies.common import host
    from ...studies.paper.reproduce import paper_machine

    if arguments.pictures:
        drawing()
    robot, motions = paper_machine(), papers_motions()
    read: tuple[Path, ...] = ()
    if arguments.scene is not None:
        scene = read_budget(arguments.scene)
        robot, motions, read = scene.robot, dict(scene.motions), scene.files
        warn_of_doubts(robot, arguments.scene)
    with (
        results_folder(arguments, "chart.txt", "chart.json", read=read) as folder,
        progress_line() as progress,
    ):
        found = cost(robot, motions, True, ROUNDS, progress)
        text = table(found)
        figures = {**found.as_json(), "machine": host.machine(), "software": host.software()}
        texts = {"chart.txt": text + "\n", "chart.json": json.dumps(figures, indent=1) + "\n"}
        every = list(charts(found, robot, progress))
        texts |= {f"{chart.name}.csv": chart.rows for chart in every}
        for name, content in texts.items():
            (folder / name).write_text(content, encoding="utf-8", newline="\n")
        if arguments.pictures:
            progress("drawing")
            for chart in every:
                save(chart.draw(), folder / chart.name)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0
