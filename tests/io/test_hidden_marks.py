"""Names with marks of direction, of no width, tags and quotes are read, and shown as text everywhere."""

import unicodedata
from pathlib import Path

import numpy as np
import pytest
from command_line import Run
from kits import few_vectors
from log_files import NAMES, write

import stewart_sym as ss
from stewart_sym.dynamics.home_pose import home_pose

MARKED = (
    "\"quoted' </h1><b>&amp; */ ??/ \\ %s ]]> --> \u202egnp.exe\u2066\u200b\u00ad\ufeff\U000e0041\u00a0\u05d0"
)
HEXAPOD = Path(__file__).parents[2] / ".docs" / "examples" / "hexapod.toml"
_UNSEEN = {"Cf", "Co", "Cs", "Zl", "Zp"}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    text = HEXAPOD.read_text(encoding="utf-8").replace('"hexapod"', f"'''{MARKED}'''")
    (tmp_path / "marked.toml").write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def all_seen(text: str) -> bool:
    return not any(unicodedata.category(each) in _UNSEEN for each in text)


def written(folder: Path) -> dict[str, str]:
    """Texts that were written in a folder and below, by name."""
    paths = [path for path in folder.rglob("*") if path.is_file() and path.suffix != ".png"]
    paths.remove(folder / "marked.toml")
    return {str(path.relative_to(folder)): path.read_bytes().decode(errors="replace") for path in paths}


@pytest.mark.parametrize(
    "command",
    [
        "check marked.toml -o out --no-plots",
        "forces marked.toml log.csv -o forces.csv --html out.html",
        "export marked.toml --format mjcf -o out.xml",
        "export marked.toml --format urdf -o out.urdf",
        "generate marked.toml -o kit",
    ],
)
@few_vectors()
def test_a_marked_name_is_shown_as_text(command: str, folder: Path, run: Run) -> None:
    robot = ss.Robot.from_toml("marked.toml")
    time = np.linspace(0.0, 1.0, 20)
    turned = 0.01 * np.sin(time)[:, None] * np.ones(6)
    home = np.append(home_pose(robot).t, np.zeros(3))
    write(folder / "log.csv", NAMES, np.column_stack([time, turned + home]))
    out, err = run(*command.split())
    texts = written(folder) | {"terminal": out, "warnings": err}
    for name, text in texts.items():
        assert all_seen(text), name
    assert any("[U+202E]gnp.exe" in text for text in texts.values())
    for name, text in texts.items():
        assert "</h1><b>" not in text or not name.endswith((".html", ".svg", ".xml", ".sdf", ".urdf")), name
