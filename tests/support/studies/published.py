"""Generator of the tables of the documentation from the results of the studies.

``python tests/support/studies/published.py [RUN]`` runs in the top folder of the source. RUN is a folder that
``chart``, ``stability``, ``compare_engines.py``, ``microcontroller.py``, or ``planning_study.py`` wrote: its
JSON files and plots replace the files in ``.docs``. Tables are written to ``.docs/tables`` and to the marked
places of the README.
"""

import json
import re
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import benchmark_tables as benchmark
import chart_tables as charts
import microcontroller_tables as microcontroller
import planning_study as planning
import stability_tables as stability

from stewart_sym.studies.common.text_tables import Figures

STUDIES: dict[str, Callable[[Figures], dict[str, str]]] = {
    "bench": benchmark.tables,
    "chart": charts.tables,
    "controller": microcontroller.tables,
    "controller_drive": microcontroller.drive_tables,
    "controller_kinematics": microcontroller.kinematics_tables,
    "plan": planning.tables,
    "stability": stability.tables,
}
"""Function that generates the tables of each study, by the name of its JSON file."""

PICTURES = (
    *("bench.png", "bench_motion.png"),
    *("plan_claim.png", "plan_path_III.png", "plan_durations.png"),
    *("chart.png", "singular_path_III.png"),
)
COMMAND = "python tests/support/studies/published.py"


def written(top: Path) -> dict[Path, str]:
    """Generate the text of every file with tables from the JSON files in ``top / ".docs"``."""
    docs, readme = top / ".docs", top / "README.md"
    files = {readme: readme.read_text(encoding="utf-8")}
    for name, tables in STUDIES.items():
        found: Figures = json.loads((docs / f"{name}.json").read_text(encoding="utf-8"))
        for table, text in tables(found).items():
            if table.startswith("readme_"):
                files[readme] = between_marks(files[readme], table, text)
            else:
                files[docs / "tables" / f"{table}.md"] = f"<!-- {name}.json by `{COMMAND}` -->\n\n{text}"
    return files


def between_marks(page: str, name: str, text: str) -> str:
    """Replace the text between the marks of a name on a page; raise ValueError without these marks."""
    begin, end = f"<!-- {name} by `{COMMAND}` -->\n", f"<!-- end of {name} -->"
    found, count = re.subn(
        re.escape(begin) + ".*?" + re.escape(end), lambda _: f"{begin}\n{text}{end}", page, flags=re.DOTALL
    )
    if count != 1:
        raise ValueError(f"README.md: expected the marks of {name} once, got {count}")
    return found


def take(run: Path, docs: Path) -> None:
    """Copy JSON files and plots of a run; raise ValueError, and copy nothing, if tables cannot be
    generated.
    """
    names = [name for name in (*(f"{study}.json" for study in STUDIES), *PICTURES) if (run / name).exists()]
    if not names:
        raise ValueError(f"{run}: expected figures of a study, got none")
    for name in names:
        if name.endswith(".json"):
            STUDIES[name.removesuffix(".json")](json.loads((run / name).read_text(encoding="utf-8")))
    for name in names:
        shutil.copyfile(run / name, docs / name)


def main(arguments: list[str]) -> int:
    """Write the tables; return the exit code."""
    top = Path.cwd()
    try:
        for run in arguments:
            take(Path(run), top / ".docs")
        for path, text in written(top).items():
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
