"""The functions of a kit run in Python, Octave and Rust on rows of numbers, and the statuses of the C."""

import functools
import importlib.util
import os
import re
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

import kits
import numpy as np
from kinematics_calls import library
from machines import random_motion

import stewart_sym as ss
from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.calls import c_kernel
from stewart_sym.calls.c_kernel import address
from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.kernel.outputs import FORCED, OUTPUTS
from stewart_sym.generated.interface import MODELS
from stewart_sym.results import OK

Array = np.ndarray
SIZES = {"motion": 30, "F": 6, "L": 6, "guess": 12, "pose": 12, "L_dot": 6}
"""Arguments besides robot and model: how many numbers they have."""
TAKES = {
    **{output: ("motion", "F") if output in FORCED else ("motion",) for output in OUTPUTS},
    "inverse_kinematics": ("motion",),
    "forward_kinematics": ("L", "guess"),
    "forward_velocity": ("pose", "L_dot"),
}
OF_ROBOT = ("inverse_kinematics", "forward_kinematics", "forward_velocity")

# ---------------------------------------------------------------- cases


@functools.cache
def machine() -> ss.Robot:
    return kits.machine("random")


@functools.cache
def sound() -> dict[str, Array]:
    """An example of each argument, flat."""
    robot = machine()
    motion = random_motion(np.random.default_rng(62), robot)
    legs = ss.inverse_kinematics(robot, motion)
    pose = np.concatenate([motion.R.ravel(), motion.t])
    return {
        "motion": np.concatenate([np.ravel(getattr(motion, name)) for name in MOTION]),
        "F": 1.5 * ss.ForceKernel(robot).forces(motion),
        "L": legs.L,
        "guess": pose + 0.01 * np.r_[np.zeros(9), np.ones(3)],
        "pose": pose,
        "L_dot": legs.L_dot,
    }


def of_c(function: str, rows: Array) -> Array:
    """Statuses by the C, which writes nothing where they are not OK."""
    numbers, model = robot_numbers(machine()), np.zeros(MODELS["exact"])
    dynamics = c_kernel.library("exact_motion")
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
        elif any(each.whole for each in CALLS[function].arguments):
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


def columns(function: str) -> dict[str, dict[str, slice]]:
    """Of each argument the columns of its members, those of one without members under ""."""
    found, first = {}, 0
    for name in TAKES[function]:
        found[name] = {}
        for member in {"motion": MOTION, "pose": ("R", "t"), "guess": ("R", "t")}.get(name, ("",)):
            last = first + {"R": 9, "": 6}.get(member, 3)
            found[name][member], first = slice(first, last), last
    return found


Found = tuple[Array, list[Array]]
"""Statuses, and the numbers of each result."""


def in_python(folder: Path, cases: dict[str, Array]) -> dict[str, Found]:
    arrays, robot = imported(folder, "stewart_arrays"), imported(folder, "robot").robot()
    on = arrays.Arithmetic(np)
    found = {}
    with np.errstate(all="ignore"):
        model = arrays.prepare(on, robot)
        for function, rows in cases.items():
            given = {}
            for name, parts in columns(function).items():
                values = {member: rows[:, part] for member, part in parts.items()}
                made = arrays.motion_of if name == "motion" else arrays.pose_at
                given[name] = values[""] if "" in values else made(on, **values)
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
        for name, parts in columns(function).items():
            targets = {f"{name}.{member}".removesuffix("."): part for member, part in parts.items()}
            lines += [f"{to} = rows(i, {part.start + 1}:{part.stop});" for to, part in targets.items()]
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
        for name, parts in columns(function).items():
            slices = {member: f"row[{part.start}..{part.stop}]" for member, part in parts.items()}
            fields = [f"{member}: {each}.try_into().unwrap()" for member, each in slices.items()]
            kind = "Motion" if name == "motion" else "Pose"
            value = f"{kind} {{ {', '.join(fields)} }}"
            if "" in slices:
                kind, value = "[Real; 6]", f"{slices['']}.try_into().unwrap()"
            lines += [f"        let {name}: {kind} = {value};"]
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
