"""Kits in Python, MATLAB and Rust: README commands run as printed, wrong input gets the status of C."""

import functools
import re
import textwrap
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import kits
import numpy as np
import pytest
from language_runs import RUNS, TAKES, Array, imported, machine, of_c, ran, sound
from machines import dasgupta
from sweeps import FULL, slow_but

from stewart_sym.derive.package.languages import LANGUAGES
from stewart_sym.kit import Choice, put, write_kit
from stewart_sym.results import JOINT_SINGULAR, NOT_CONVERGED, NOT_FINITE, OK, SINGULAR, ZERO_LENGTH

EVERY = ("forces", "motion", "derivatives", "kinematics")
WRONG = (np.nan, np.inf, -np.inf)


def row_of(function: str, given: dict[str, Array]) -> Array:
    return np.concatenate([given[name] for name in TAKES[function]])


def spoilt(function: str, every: bool) -> list[Array]:
    """The arguments with NaN and infinities in each number, or one of these in one of each five numbers."""
    good = row_of(function, sound())
    places = [(i, wrong) for i in range(good.size) for wrong in WRONG][:: 1 if every else 5 * len(WRONG) + 1]
    return [good, *(np.where(np.arange(good.size) == i, wrong, good) for i, wrong in places)]


def degenerate(function: str) -> list[Array]:
    """A leg of length zero, one along its joint axis, singular poses, no rotation, numbers that overflow."""
    robot, good = machine(), sound()
    R = good["pose"][:9].reshape(3, 3)
    short = robot.b[2] - R @ robot.p[2]
    along = robot.b[4] - R @ robot.p[4] + 0.5 * robot.k[4] / np.linalg.norm(robot.k[4])
    poses = [(R, short), (R, along), (np.zeros((3, 3)), good["pose"][9:]), (1.3 * R, good["pose"][9:])]
    poses += [(-R, good["pose"][9:]), (R, 1e200 * good["pose"][9:]), (R, np.full(3, 1e308))]
    numbers = [np.concatenate([turned.ravel(), t]) for turned, t in poses]
    rows = [
        row_of(
            function, good | {"pose": at, "guess": at, "motion": np.concatenate([at, good["motion"][12:]])}
        )
        for at in numbers
    ]
    if function == "forward_kinematics":
        lengths = (0.0 * good["L"], -good["L"], good["L"] * [1, 1, 1, 1, 1, 20], 1e308 * good["L"])
        rows += [row_of(function, good | {"L": L}) for L in lengths]
    return rows


def table(every: bool) -> dict[str, Array]:
    return {name: np.array([*spoilt(name, every), *degenerate(name)]) for name in TAKES}


@pytest.fixture(scope="module")
def kit_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """The folder of a kit with every function; it tests itself on fewer vectors than others."""

    @functools.cache
    def made(language: str, functions: tuple[str, ...] = EVERY) -> Path:
        folder = tmp_path_factory.mktemp(language)
        with kits.few_vectors():
            write_kit(machine(), folder, Choice(functions, language=language))
        return folder

    return made


BY_LANGUAGE = pytest.mark.parametrize("language", slow_but(["python"], LANGUAGES))


@pytest.mark.slow
@BY_LANGUAGE
def test_wrong_input_gets_the_status_that_c_gives_it_and_no_number(
    language: str, kit_of: Callable[..., Path]
) -> None:
    cases = table(every=FULL)
    for function, (status, numbers) in RUNS[language](kit_of(language), cases).items():
        np.testing.assert_array_equal(status, of_c(function, cases[function]), function)
        for code, result in zip(status, numbers, strict=True):
            assert (np.isfinite(result) if code == OK else np.isnan(result)).all(), function


def test_the_cases_of_wrong_input_have_every_status() -> None:
    seen = {name: set(of_c(name, rows).tolist()) for name, rows in table(every=False).items()}
    assert all({OK, NOT_FINITE, ZERO_LENGTH} <= codes for codes in seen.values())
    assert {JOINT_SINGULAR, SINGULAR} <= seen["forces"] & seen["joint_inertia"] & seen["derivatives"]
    assert {NOT_CONVERGED} <= seen["forward_kinematics"]
    assert {SINGULAR} <= seen["forward_velocity"]


# ---------------------------------------------------------------- shapes and types


SHAPES = [
    ("forward_dynamics(on, model, motion, np.zeros(5))", "F: expected shape (..., 6), got (5,)"),
    ("forward_dynamics(on, model, motion, [0.0] * 7)", "F: expected 6 numbers or arrays, got 7"),
    ("forces(on, machine, motion)", "model: expected Model, got Robot"),
    ("motion_of(on, t=[0.0, 0.0, 1.0])", "R: expected shape (..., 3, 3) or (..., 9), got none"),
    ("motion_of(on, R=np.eye(3), omga=[1, 2, 3])", "omga: expected one of R, t"),
    (
        "forces(on, model, motion_of(on, R=np.ones((5, 9)), t=np.ones((4, 3))))",
        "t: expected a leading shape that broadcasts with (5,), got (4,)",
    ),
    ("pose_at(on, R=np.eye(3), t='far')", "t: expected real numbers, "),
]


def in_kit(folder: Path) -> tuple[ModuleType, dict[str, Any]]:
    """The modules of a Python kit, and names for its calls."""
    arrays = imported(folder, "stewart_arrays")
    on = arrays.Arithmetic(np)
    made = imported(folder, "robot").robot()
    names = {"on": on, "np": np, "machine": made, "model": arrays.prepare(on, made)}
    pose = sound()["pose"]
    names["motion"] = arrays.motion_of(on, R=pose[:9], t=pose[9:])
    return arrays, names | {"guess": arrays.pose_at(on, R=pose[:9], t=pose[9:])}


@pytest.mark.parametrize(("call", "line"), SHAPES, ids=[call for call, _ in SHAPES])
def test_python_names_the_argument_that_does_not_fit(
    call: str, line: str, kit_of: Callable[..., Path]
) -> None:
    arrays, names = in_kit(kit_of("python", ("forces", "motion", "kinematics")))
    with pytest.raises(ValueError, match=f"^{re.escape(line)}"):
        eval(call, vars(arrays) | names)


# ---------------------------------------------------------------- README

COMMAND = re.compile(r"^    ((?:python|octave-cli|cargo|stewart-sym) .*)$")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("language", "functions"),
    [
        *((name, ("kinematics",)) for name in ("python", "matlab")),
        *slow_but((), ((language, EVERY) for language in LANGUAGES)),
    ],
    ids=lambda value: value if isinstance(value, str) else "+".join(value),
)
def test_the_commands_of_a_readme_run_as_printed(
    language: str, functions: tuple[str, ...], tmp_path: Path
) -> None:
    folder = tmp_path / "my kit"
    robot = machine() if functions == EVERY else dasgupta()
    with kits.few_vectors():
        written, _ = write_kit(robot, folder, Choice(functions, language=language))
    readme = (folder / "README.md").read_text()
    indented = [line for line in readme.splitlines() if line.startswith("    ")]
    commands = [found[1] for line in indented if (found := COMMAND.match(line))]
    assert len(commands) == (3 if language == "rust" else 2)
    for command in commands:
        # Kits of C show that the line of the generator is right: ``test_kit_use``.
        if not command.startswith("stewart-sym "):
            ran(command, folder)
    assert {name: (folder / name).read_bytes() for name in written.files} == written.files
    shown = (folder / LANGUAGES[language].example).read_text().strip()
    assert f"\n\n{textwrap.indent(shown, '    ')}\n\n" in readme


@BY_LANGUAGE
def test_the_self_test_sees_the_last_bit_of_a_number_that_no_function_reads(
    language: str, tmp_path: Path
) -> None:
    put(kits.kit_of(choice=Choice(("kinematics",), language=language)), tmp_path)
    command, _ = LANGUAGES[language].run.split(" && ")
    ran(command, tmp_path)
    (path,) = (each for each in tmp_path.rglob("robot.*") if each.suffix in {".py", ".m", ".rs"})
    text, mass = path.read_text(), dasgupta().M
    path.write_text(text.replace(f" {mass!r}", f" {np.nextafter(mass, np.inf).item()!r}", 1))
    assert path.read_text() != text
    with pytest.raises(AssertionError, match="failed"):
        ran(command, tmp_path)
