"""A machine of another size and mass, played at the speed of similar motions: all figures scale with it."""

import csv
import json
import math
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command_line import Run
from sweeps import FULL

from stewart_sym.io.toml_text import toml_text

EXAMPLES = Path(__file__).parents[2] / ".docs" / "examples"
DRIVE = {
    **{"lead": 0.005, "efficiency": 0.9, "backdrive_efficiency": 0.8, "rotor_inertia": 1.73e-5},
    **{"motor_coulomb": 0.05, "screw_coulomb": 12.0, "screw_viscous": 30.0, "regularization_speed": 0.001},
    **{"torque_constant": 0.5, "resistance": 2.0, "torque_limit": 3.82, "current_limit": 8.5},
    "motor_speed_limit": 523.6,
}
POWERS = {
    # Of length and mass; times are roots of lengths, gravity and currents stay.
    **dict.fromkeys(
        ("points", "center_of_mass", "length_limits", "lead", "t", "t_x", "t_y", "t_z"), (1.0, 0)
    ),
    **dict.fromkeys(("mass", "force_limit", "screw_coulomb"), (0.0, 1)),
    **dict.fromkeys(("inertia", "rotor_inertia"), (2.0, 1)),
    **dict.fromkeys(("universal", "spherical"), (1.5, 1)),
    **dict.fromkeys(("prismatic", "screw_viscous"), (-0.5, 1)),
    **dict.fromkeys(("speed_limit", "regularization_speed", "v", "duration", "time"), (0.5, 0)),
    **dict.fromkeys(("motor_coulomb", "torque_constant", "torque_limit"), (1.0, 1)),
    **dict.fromkeys(("motor_speed_limit", "rate"), (-0.5, 0)),
    **{"resistance": (0.5, 1), "stiffness": (-1.0, 1), "min_clearance": (1.0, 0)},
}
LENGTH, MASS = 2.0**-8, 3.0**-12
"""So unlike that no product of their powers is near another."""


def scaled(value: Any, length: float, mass: float, name: str = "") -> Any:
    if isinstance(value, dict):
        return {key: scaled(each, length, mass, key) for key, each in value.items()}
    if isinstance(value, list):
        return [scaled(each, length, mass, name) for each in value]
    powers = POWERS.get(name, (0.0, 0))
    return value * length ** powers[0] * mass ** powers[1] if isinstance(value, float) else value


def examples(folder: Path, length: float, mass: float) -> None:
    """The documentation's machine, with drives, and what it does, scaled."""
    folder.mkdir()
    for name in ("hexapod", "via", "swing"):
        tables = tomllib.loads((EXAMPLES / f"{name}.toml").read_text())
        if name == "hexapod":
            tables["legs"]["drive"] = DRIVE
        text = toml_text(scaled(tables, length, mass)).replace("motor_speed_limit", "speed_limit")
        (folder / f"{name}.toml").write_text(text)
    with (EXAMPLES / "trajectory.csv").open() as stream:
        head, *rows = csv.reader(stream)
    values = [
        [scaled(float(x), length, mass, name) for name, x in zip(head, row, strict=True)] for row in rows
    ]
    (folder / "trajectory.csv").write_text(
        "\n".join(",".join(map(str, row)) for row in (head, *values)) + "\n"
    )


def leaves(value: Any, where: str = "") -> Iterator[tuple[str, float]]:
    if isinstance(value, dict):
        for key, each in value.items():
            yield from leaves(each, f"{where}/{key}")
    elif isinstance(value, list):
        for i, each in enumerate(value):
            yield from leaves(each, f"{where}/{i}")
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield where, float(value)


def off(one: float, other: float) -> float:
    """How far a ratio is from every product of powers, as a share."""
    if one == other:
        return 0.0
    if one * other <= 0.0:
        return math.inf
    ratio = math.log(other / one)
    return min(
        abs(ratio - 0.5 * n * math.log(LENGTH) - k * math.log(MASS))
        for n in range(-8, 13)
        for k in (-1, 0, 1, 2)
    )


COMMANDS = {
    "size-actuators": ("hexapod.toml", "trajectory.csv", "-o", "out", "--no-plots"),
    "simulate": ("swing.toml", "-o", "out", "--no-plots"),
    "plan": ("via.toml", "-o", "out", "--no-plots"),
    "forces": ("hexapod.toml", "trajectory.csv", "-o", "out.csv"),
}
FREE = ("condition_number", "_std_", "/std/", "time_s", "/steps", "certificate/samples")
"""With moments of another unit, of rounding, where a peak is flat, of steps."""


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("command", COMMANDS if FULL else ["forces"])
def test_every_figure_of_a_command_scales_with_the_machine(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, run: Run
) -> None:
    found = []
    for name, scale in (("plain", (1.0, 1.0)), ("small", (LENGTH, MASS))):
        examples(tmp_path / name, *scale)
        monkeypatch.chdir(tmp_path / name)
        run(command, *COMMANDS[command], "--json", "found.json")
        found.append(dict(leaves(json.loads(Path("found.json").read_text()))))
    plain, small = found
    assert plain.keys() == small.keys()
    apart = {where: off(plain[where], small[where]) for where in plain if not any(x in where for x in FREE)}
    assert len(apart) > 20
    assert {where: share for where, share in apart.items() if share > 3e-3} == {}
