"""A robot in another program's format, without the warnings of what has no place there."""

import warnings
from pathlib import Path

import stewart_sym as ss

HEXAPOD = Path(__file__).parents[3] / ".docs" / "examples" / "hexapod.toml"


def exported(form: str = "mjcf") -> ss.ModelFile:
    """The documentation's hexapod."""
    with warnings.catch_warnings(action="ignore"):
        return ss.export_model(ss.Robot.from_toml(HEXAPOD), form)
