"""Kits in Python, MATLAB and Rust: README commands run as printed, wrong input gets the status of C."""

import functools
import importlib.util
import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from kinematics_calls import library
from machines import dasgupta, random_motion, random_robot
from sweeps import FULL

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION, address, robot_numbers
from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.package.languages import LANGUAGES
from stewart_sym.dynamics import closed_form
from stewart_sym.generated.interface import MODELS
from stewart_sym.kit import Choice, kit, write_kit
from stewart_sym.results import JOINT_SINGULAR, NOT_CONVERGED, NOT_FINITE, OK, SINGULAR, ZERO_LENGTH

Array = np.ndarray

EVERY = ("forces", "motion", "derivatives", "kinematics")
SIZES = {"motion": 30, "F": 6, "L": 6, "guess": 12, "pose": 12, "L_dot": 6}
"""Arguments besides robot and model: how many numbers they have."""
TAKES = {
    **dict.fromkeys(("forces", "equations", "bias", "joint_inertia", "derivatives"), ("motion",)),
    **dict.fromkeys(("forward_dynamics", "linearisation"), ("motion", "F")),
    "inverse_kinematics": ("motion",),
    "forward_kinematics": ("L", "guess"),
    "forward_velocity": ("pose", "L_dot"),
}
OF_ROBOT = ("inverse_kinematics", "forward_kinematics", "forward_velocity")
ENDS = [0, *np.cumsum([9 if name == "R" else 3 for name in MOTION]).tolist()]
"""Where the members of a motion begin, and its end."""
WRONG = (np.nan, np.inf, -np.inf)

# ---------------------------------------------------------------- cases


@functools.cache
def machine() -> ss.Robot:
    return random_robot(np.random.default_rng(61))


@functools.cache
def sound() -> dict[str, Array]:
    """An example of each argument, flat."""
    robot = machine()
    motion = random_motion(np.random.default_rng(62), robot)
    legs = ss.inverse_kinematics(robot, motion)
    pose = np.concatenate([motion.R.ravel(), motion.t])
    return {
        "motion": np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION]),
        "F": 1.5 * ss.prepare(robot).forces(motion),
        "L": legs.L,
        "guess": pose + 0.01 * np.r_[np.zeros(9), np.ones(3)],
        "pose": pose,
        "L_dot": legs.L_dot,
    }


def row_of(function: str, given: dict[str, Array]) -> Array:
    return np.concatenate([given[name] for name in TAKES[function]])


def spoilt(function: str, every: bool) -> list[Array]:
    """The arguments with NaN or an infinity in each number, or in one of each three."""
    good = row_of(function, sound())
    rows = [good]
    for i in range(0, good.size, 1 if every else 3):
        rows += [np.where(np.arange(good.size) == i, wrong, good) for wrong in WRONG]
    return rows


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


def of_c(function: str, rows: Array) -> Array:
    """Statuses by the C, which writes nothing where they are not OK."""
    numbers, model = robot_numbers(machine()), np.zeros(MODELS["exact"])
    dynamics = closed_form.library()
    assert dynamics.stewart_exact_prepare(address(numbers), address(model)) == OK
    of_robot = function in OF_ROBOT
    call = getattr(
        *((library(), f"stewart_{function}") if of_robot else (dynamics, f"stewart_exact_{function}"))
    )
    ends = np.cumsum([SIZES[name] for name in TAKES[function]])[:-1]
    codes = []
    for row in rows:
        given = [part.copy() for part in np.split(row, ends)]
        found = [np.full(each.count, 7.0) for each in CALLS[function].outputs]
        if function == "forward_kinematics":
            found = [given.pop()]
        elif function not in (*OF_ROBOT, "forces", "bias", "forward_dynamics", "joint_inertia"):
            found = [np.concatenate(found)]
        before = [each.copy() for each in found]
        codes.append(call(*map(address, (numbers if of_robot else model, *given, *found))))
        assert codes[-1] == OK or all(map(partial(np.array_equal, equal_nan=True), found, before))
    return np.array(codes)


# ---------------------------------------------------------------- languages


def imported(folder: Path, name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, folder / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


Found = tuple[Array, list[Array]]
"""Statuses, and the numbers of each result."""


def in_python(folder: Path, cases: dict[str, Array]) -> dict[str, Found]:
    arrays, robot = imported(folder, "stewart_arrays"), imported(folder, "robot").robot()
    on = arrays.Arithmetic(np)
    found = {}
    with np.errstate(all="ignore"):
        model = arrays.prepare(on, robot)
        for function, rows in cases.items():
            given, first = {}, 0
            for name in TAKES[function]:
                part = rows[:, first : first + SIZES[name]]
                first += SIZES[name]
                given[name] = part
                if name == "motion":
                    members = np.split(part, ENDS[1:-1], axis=1)
                    given[name] = arrays.motion_of(on, **dict(zip(MOTION, members, strict=True)))
                elif name in ("pose", "guess"):
                    given[name] = arrays.pose_at(on, R=part[:, :9], t=part[:, 9:])
            result = getattr(arrays, function)(on, robot if function in OF_ROBOT else model, **given)
            numbers = np.stack([np.broadcast_to(each, len(rows)) for each in flat(result)], axis=1)
            found[function] = np.broadcast_to(result.status, len(rows)), list(numbers)
    return found


def flat(result: Any) -> list[Any]:
    """Numbers of a result without its status."""
    if isinstance(result, list):
        return [number for each in result for number in flat(each)]
    if hasattr(result, "__dict__") and not hasattr(result, "shape"):
        return [number for name, each in vars(result).items() if name != "status" for number in flat(each)]
    return [result]


OCTAVE = """
function show(found)
    numbers = flat(found);
    printf('%d', found.status);
    printf(' %.17g', numbers);
    printf('\\n');
end
function numbers = flat(found)
    numbers = [];
    names = fieldnames(found);
    for i = 1:numel(names)
        each = found.(names{i});
        if isstruct(each)
            numbers = [numbers; flat(each)];
        elseif ~strcmp(names{i}, 'status')
            numbers = [numbers; each(:)];
        end
    end
end
"""


def in_octave(folder: Path, cases: dict[str, Array]) -> dict[str, Found]:
    (folder / "show.m").write_text(OCTAVE.lstrip())
    lines = ["robot = stewart.robot();", "model = stewart.prepare(robot);", "motion = stewart.zero_motion();"]
    for function, rows in cases.items():
        literal = ";\n".join(" ".join(map(repr, row.tolist())) for row in rows)
        lines += [f"rows = [{literal}];".replace("inf", "Inf").replace("nan", "NaN")]
        lines += [f"for i = 1:{len(rows)}"]
        first = 0
        for name in TAKES[function]:
            if name == "motion":
                lines += [
                    f"motion.{member} = rows(i, {a + 1}:{b});"
                    for member, a, b in zip(MOTION, ENDS, ENDS[1:], strict=False)
                ]
            elif name in ("pose", "guess"):
                lines += [f"{name}.R = rows(i, {first + 1}:{first + 9});"]
                lines += [f"{name}.t = rows(i, {first + 10}:{first + 12});"]
            else:
                lines += [f"{name} = rows(i, {first + 1}:{first + SIZES[name]});"]
            first += SIZES[name]
        subject = "robot" if function in OF_ROBOT else "model"
        lines += [f"show(stewart.{function}({', '.join([subject, *TAKES[function]])}));", "end"]
    (folder / "cases.m").write_text("\n".join(lines))
    done = ran(["octave-cli", "cases.m"], folder)
    return split(done.splitlines(), cases)


RUST = """#![allow(non_snake_case)]
use {crate}::*;
fn main() {{
    let model = prepare(&ROBOT);
{calls}
}}
"""


def in_rust(folder: Path, cases: dict[str, Array]) -> dict[str, Found]:
    (crate,) = re.findall(r'^name = "(.*)"$', (folder / "Cargo.toml").read_text(), re.M)
    lines = []
    for function, rows in cases.items():
        (folder / f"{function}.in").write_bytes(rows.astype("<f8").tobytes())
        lines += [
            f'    for bytes in include_bytes!("../{function}.in").chunks({8 * rows.shape[1]}) {{',
            "        let mut row = [0.0; 64];",
            "        for (i, each) in bytes.chunks(8).enumerate() {",
            "            row[i] = f64::from_le_bytes(each.try_into().unwrap());",
            "        }",
        ]
        first = 0
        for name in TAKES[function]:
            members = {"motion": MOTION, "pose": ("R", "t"), "guess": ("R", "t")}.get(name, ())
            kind = "Motion" if name == "motion" else "Pose"
            sizes = [9 if member == "R" else 3 for member in members] or [SIZES[name]]
            ends = first + np.cumsum([0, *sizes])
            parts = [f"row[{a}..{b}].try_into().unwrap()" for a, b in pairwise(ends)]
            fields = ", ".join(f"{member}: {part}" for member, part in zip(members, parts, strict=False))
            value = f"{kind} {{ {fields} }}" if members else parts[0]
            lines += [f"        let {name}{'' if members else ': [Real; 6]'} = {value};"]
            first += SIZES[name]
        subject = "&ROBOT" if function in OF_ROBOT else "&model"
        passed = ", ".join([subject, *(f"&{name}" for name in TAKES[function])])
        lines += [f'        println!("{{:?}}", {function}({passed}));', "    }"]
    (folder / "examples" / "cases.rs").write_text(RUST.format(crate=crate, calls="\n".join(lines)))
    done = ran(["cargo", "run", "-q", "--offline", "--example", "cases"], folder)
    number = re.compile(r"(?<![\w.])(?:NaN|-?inf|-?\d[\d.]*(?:e-?\d+)?)(?!\w)")
    shown = []
    for line in done.splitlines():
        *numbers, status = number.findall(line)
        shown.append(" ".join([status, *numbers]))
    return split(shown, cases)


def split(lines: list[str], cases: dict[str, Array]) -> dict[str, Found]:
    """Lines of a status and numbers, those of each function in turn."""
    assert len(lines) == sum(map(len, cases.values()))
    found, first = {}, 0
    for function, rows in cases.items():
        own = [np.array(line.split(), dtype=float) for line in lines[first : first + len(rows)]]
        found[function] = np.array([int(each[0]) for each in own]), [each[1:] for each in own]
        first += len(rows)
    return found


def ran(command: list[str] | str, folder: Path) -> str:
    """What a command prints, with the commands of this environment before others."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        command,
        cwd=folder,
        shell=isinstance(command, str),
        capture_output=True,
        text=True,
        env=os.environ | {"PATH": path, "CARGO_NET_OFFLINE": "true"},
    )
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


RUNS: dict[str, Callable[[Path, dict[str, Array]], dict[str, Found]]]
RUNS = {"python": in_python, "matlab": in_octave, "rust": in_rust}


@pytest.fixture(scope="module")
def kit_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """The folder of a kit with every function."""

    @functools.cache
    def made(language: str) -> Path:
        folder = tmp_path_factory.mktemp(language)
        write_kit(machine(), folder, Choice(EVERY, language=language))
        return folder

    return made


SLOW = {"python": (), "matlab": pytest.mark.slow, "rust": pytest.mark.slow}
BY_LANGUAGE = pytest.mark.parametrize(
    "language", [pytest.param(name, marks=marks) for name, marks in SLOW.items()]
)


@BY_LANGUAGE
def test_wrong_input_gets_the_status_that_c_gives_it_and_no_number(
    language: str, kit_of: Callable[[str], Path]
) -> None:
    cases = table(every=FULL or language == "python")
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


def test_every_language_has_a_table_of_wrong_input() -> None:
    assert set(RUNS) == set(LANGUAGES)


# ---------------------------------------------------------------- shapes and types


SHAPES = [
    ("forward_dynamics(on, model, motion, np.zeros(5))", r"F: expected shape (..., 6), got (5,)"),
    ("forward_dynamics(on, model, motion, np.zeros((6, 5)))", r"F: expected shape (..., 6), got (6, 5)"),
    ("forward_dynamics(on, model, motion, [0.0] * 7)", "F: expected 6 numbers or arrays, got 7"),
    ("forward_dynamics(on, model, motion, [[0.0] * 6] * 6)", "F: expected 6 numbers or arrays, got nested"),
    ("forward_dynamics(on, model, motion, 1.0)", "F: expected shape (..., 6), got ()"),
    ("linearisation(on, model, motion, [0.0] * 5)", "F: expected 6 numbers or arrays, got 5"),
    ("forward_kinematics(on, machine, [1.0] * 5, guess)", "L: expected 6 numbers or arrays, got 5"),
    ("forward_velocity(on, machine, guess, np.zeros(3))", "L_dot: expected shape (..., 6), got (3,)"),
    ("forces(on, machine, motion)", "model: expected Model, got Robot"),
    ("forces(on, model, guess)", "motion: expected Motion, got Pose"),
    ("motion_of(on, t=[0.0, 0.0, 1.0])", "R: expected shape (..., 3, 3) or (..., 9), got none"),
    ("motion_of(on, R=np.eye(3), t=[1, 2])", "t: expected shape (..., 3), got (2,)"),
    ("motion_of(on, R=np.eye(3), omga=[1, 2, 3])", "omga: expected one of R, t"),
    ("pose_at(on, R=np.zeros((3, 2)))", "R: expected shape (..., 9), got (3, 2)"),
    (
        "forces(on, model, motion_of(on, R=np.ones((5, 9)), t=np.ones((4, 3))))",
        "t: expected a leading shape that broadcasts with (5,), got (4,)",
    ),
    (
        "forward_kinematics(on, machine, np.ones((2, 5, 6)), pose_at(on, R=np.ones((3, 1, 9))))",
        "R: expected a leading shape that broadcasts with (2, 5), got (3, 1)",
    ),
    ("motion_of(on, R=[[1, 2], [3]])", "R: expected real numbers, "),
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
    call: str, line: str, kit_of: Callable[[str], Path]
) -> None:
    arrays, names = in_kit(kit_of("python"))
    with pytest.raises(ValueError, match=f"^{re.escape(line)}"):
        eval(call, vars(arrays) | names)


def test_python_names_a_member_that_does_not_fit(kit_of: Callable[[str], Path]) -> None:
    arrays, names = in_kit(kit_of("python"))
    names["motion"].t = [0.0, 0.0]
    with pytest.raises(ValueError, match=r"^t: expected 3 numbers or arrays, got 2$"):
        arrays.forces(names["on"], names["model"], names["motion"])


def test_python_takes_components_in_a_list_or_along_the_last_axis(kit_of: Callable[[str], Path]) -> None:
    arrays, names = in_kit(kit_of("python"))
    on, model, motion = (names[name] for name in ("on", "model", "motion"))
    F = np.random.default_rng(63).normal(size=(6, 6))
    found = arrays.forward_dynamics(on, model, motion, F)
    same = arrays.forward_dynamics(on, model, motion, list(F.T))
    np.testing.assert_array_equal(found.a, same.a)
    for i, row in enumerate(F):
        alone = arrays.forward_dynamics(on, model, motion, row)
        np.testing.assert_array_equal([each[i] for each in found.a], alone.a)


@pytest.mark.parametrize("kind", [list, np.array, lambda numbers: np.array(numbers, dtype=np.int8)])
def test_python_takes_integers_for_what_they_are(kind: Any, kit_of: Callable[[str], Path]) -> None:
    arrays, names = in_kit(kit_of("python"))
    on, model, motion = (names[name] for name in ("on", "model", "motion"))
    numbers = [1, -2, 3, 0, 5, 0]
    found = arrays.forward_dynamics(on, model, motion, kind(numbers))
    exact = arrays.forward_dynamics(on, model, motion, [float(each) for each in numbers])
    np.testing.assert_array_equal(found.a, exact.a)
    motion.t = [0, 0, 1]
    found = arrays.forces(on, model, motion)
    motion.t = [0.0, 0.0, 1.0]
    np.testing.assert_array_equal(found.F, arrays.forces(on, model, motion).F)


OCTAVE_SHAPES = [
    (
        "stewart.forward_dynamics(model, motion, zeros(5, 1))",
        "F: expected a vector of 6 real numbers, got 5 x 1 of double",
    ),
    (
        "stewart.forward_dynamics(model, motion, eye(6))",
        "F: expected a vector of 6 real numbers, got 6 x 6 of double",
    ),
    (
        "stewart.forward_dynamics(model, motion, 'abcdef')",
        "F: expected a vector of 6 real numbers, got 1 x 6 of char",
    ),
    (
        "stewart.linearisation(model, motion, 1i * ones(6, 1))",
        "F: expected a vector of 6 real numbers, got 6 x 1 of double",
    ),
    (
        "stewart.forward_kinematics(robot, 1, guess)",
        "L: expected a vector of 6 real numbers, got 1 x 1 of double",
    ),
    (
        "stewart.forward_velocity(robot, guess, {1})",
        "L_dot: expected a vector of 6 real numbers, got 1 x 1 of cell",
    ),
    (
        "stewart.forces(model, setfield(motion, 't', [1 2]))",
        "t: expected a vector of 3 real numbers, got 1 x 2 of double",
    ),
    (
        "stewart.prepare(setfield(robot, 'M', [1 2]))",
        "M: expected a vector of 1 real numbers, got 1 x 2 of double",
    ),
    ("stewart.prepare(setfield(robot, 'leg', robot.leg(1:5)))", "leg: expected 6, got 5"),
    ("stewart.motion_of(eye(3), [0 0])", "t: expected a vector of 3 real numbers, got 1 x 2 of double"),
    (
        "stewart.forces(model, setfield(motion, 'R', eye(3)))",
        "R: expected a vector of 9 real numbers, got 3 x 3 of double",
    ),
    ("stewart.motion_of(eye(2))", "R: expected 3 x 3, got 2 x 2"),
]


def test_matlab_names_the_argument_that_does_not_fit_and_takes_integers(
    kit_of: Callable[[str], Path],
) -> None:
    lines = [
        "robot = stewart.robot(); model = stewart.prepare(robot);",
        "motion = stewart.motion_of(eye(3), [0; 0; 1]); guess = stewart.pose_at(eye(3), [0 0 1]);",
        *(f"try, {call}; disp('none'); catch e, disp(e.message); end" for call, _ in OCTAVE_SHAPES),
        "one = stewart.forward_dynamics(model, motion, int8([1 -2 3 0 5 0]));",
        "motion.t = single([0 0 1]);",
        "other = stewart.forward_dynamics(model, motion, [1 -2 3 0 5 0]');",
        "disp(isequal(one, other)); disp(class(other.a));",
    ]
    done = ran(["octave-cli", "--eval", "\n".join(lines)], kit_of("matlab"))
    assert done.splitlines() == [*(said for _, said in OCTAVE_SHAPES), "1", "double"]


# ---------------------------------------------------------------- README

FAST = (("python", ("forces",)), ("matlab", ("kinematics",)))
COMMAND = re.compile(r"^    ((?:python|octave-cli|cargo|stewart-sym) .*)$")


@pytest.mark.parametrize(
    ("language", "functions"),
    [
        pytest.param(
            language,
            functions,
            marks=() if (language, functions) in FAST else pytest.mark.slow,
        )
        for language in LANGUAGES
        for functions in (("forces",), EVERY, ("kinematics",))
    ],
    ids=lambda value: value if isinstance(value, str) else "+".join(value),
)
def test_the_commands_of_a_readme_run_as_printed(
    language: str, functions: tuple[str, ...], tmp_path: Path
) -> None:
    folder = tmp_path / "my kit"
    robot = machine() if functions == EVERY else dasgupta()
    written, _ = write_kit(robot, folder, Choice(functions, language=language))
    readme = (folder / "README.md").read_text()
    indented = [line for line in readme.splitlines() if line.startswith("    ")]
    commands = [found[1] for line in indented if (found := COMMAND.match(line))]
    assert len(commands) == (3 if language == "rust" else 2)
    for command in commands:
        ran(command, folder)
    assert {name: (folder / name).read_bytes() for name in written.files} == written.files
    shown = (folder / LANGUAGES[language].example).read_text().strip()
    assert f"\n\n{textwrap.indent(shown, '    ')}\n\n" in readme


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(
    ("functions", "more"),
    [(("kinematics",), {7}), (("forces",), {3}), (("derivatives",), {3, 6}), (EVERY, {3, 6, 7})],
    ids=lambda value: "+".join(map(str, value)),
)
def test_a_readme_names_the_statuses_that_its_kit_may_return(
    language: str, functions: tuple[str, ...], more: set[int]
) -> None:
    text = kit(dasgupta(), Choice(functions, language=language)).files["README.md"].decode()
    codes = {int(code) for code in re.findall(r"^\| (\d) \| `[A-Z_]+` \| .+ \|$", text, re.M)}
    assert codes == {0, 1, 2, 4} | more


def test_a_robot_s_name_may_hold_quotes(tmp_path: Path) -> None:
    robot = replace(dasgupta(), name='a "big" one\\"""')
    write_kit(robot, tmp_path, Choice(language="python"))
    ran("python self_test.py && python example.py", tmp_path)
