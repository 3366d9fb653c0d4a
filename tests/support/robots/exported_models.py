"""A robot in another program's format, without the warnings of what has no place there."""

import warnings
from pathlib import Path

import stewart_sym as ss
from stewart_sym.exchange.files import loops_path

HEXAPOD = Path(__file__).parents[3] / ".docs" / "examples" / "hexapod.toml"


def exported(form: str = "mjcf") -> ss.ExportedModel:
    """The documentation's hexapod."""
    with warnings.catch_warnings(action="ignore"):
        return ss.export_model(ss.Robot.from_toml(HEXAPOD), form)


def written(file: ss.ExportedModel, path: Path) -> Path:
    """A model with its loops beside it."""
    path.write_text(file.text, encoding="utf-8")
    if file.loop_closures is not None:
        loops_path(path).write_text(file.loop_closures, encoding="utf-8")
    return path


def imported(text: str, folder: Path, name: str = "model.xml") -> ss.ImportedModel:
    """What is made of the text of a model."""
    return ss.import_model(written(ss.ExportedModel(text, None), folder / name))
