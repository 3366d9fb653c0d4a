"""Files of a kit as text: kernels, constants, self-test, example, build files, README, and manifest."""

import hashlib
import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cache, partial
from importlib.resources import files as resources
from typing import Any, cast

import numpy as np

from ..backend.kernel import resolve_level
from ..derive.generated_files import generator_version
from ..derive.package import build, cpp, fmu, kit_license
from ..derive.package.example import example
from ..derive.package.forces_name import forces_header
from ..derive.package.functions import Function, Vector, reads_robot
from ..derive.package.readme import Figures, readme
from ..derive.package.readme import Kit as ReadmeKit
from ..derive.package.robot_source import Machine, robot_files
from ..derive.package.selftest import selftest
from ..drives.friction import drive_numbers
from ..dynamics.home_pose import home_pose
from ..dynamics.inverse_dynamics import Formulation
from ..dynamics.neglected_physics import neglected_physics
from ..dynamics.sample_poses import sample
from ..io.array_types import Array
from ..io.error_policy import warn
from ..io.output import json_text
from ..io.progress import Progress, silent
from ..motion.motion import Motion, at_rest
from ..motion.rotation import rpy_from_rotation
from ..precision.exact_forces import Truth
from ..results import OK
from ..robot.robot import Robot
from . import languages
from .fmu import packed
from .kit_options import DEFAULT, PRECISIONS, STEMS, TORQUE, Choice, check, options, robot_toml
from .required_kernels import Parts, generator, parts, robot_numbers, unit_parts
from .vectors import rejected, vectors

LICENSE, ROBOT = "LICENSE", "robot.toml"
MANIFEST = "manifest.json"
"""Record of the files of a kit, from which a later run recognizes edited files."""

_TEXTS = (build.SELFTEST, build.EXAMPLE, LICENSE, ROBOT, "README.md", build.WRAPPER, *build.FILES)


@dataclass(frozen=True)
class Kit:
    """Files of a kit and the operations of its forces per pose.

    Attributes
    ----------
    files : dict of str to bytes
        Content of each file by name.
    operations : int or None
        Operations of the forces per pose with general constants; None without the forces.
    baked_operations : int or None
        Operations of the forces per pose with baked constants; None if the kit is not baked.
    """

    files: dict[str, bytes]
    operations: int | None
    baked_operations: int | None


def kit(robot: Robot, choice: Choice = DEFAULT, progress: Progress = silent) -> Kit:
    """Generate the files of the kit of a robot.

    Raises ValueError for an unknown option, or if no pose is suitable for the self-test.
    """
    check(choice, robot)
    missing = _left_out(robot, choice)
    if missing:
        warn(f"{missing}; choose fidelity general to include it")
    if choice.language != "c":
        progress(f"generating {choice.language}")
        return _of_language(robot, choice, missing)
    progress("generating kernels")
    made = parts(robot, choice)
    progress("computing test vectors")
    found = _vectors(robot, choice, made)
    tested = [function for function in made.functions if found[function.stem]]
    machine = _machine(robot, TORQUE in choice.functions)
    texts = _sources(machine, made)
    unsolvable = rejected(robot, choice.level, choice.precision)
    texts[build.SELFTEST] = selftest(machine, tested, found, unsolvable)
    texts[build.EXAMPLE] = example(machine, tested, found)
    texts |= _build_files(machine, made, texts, choice.precision)
    texts[LICENSE] = kit_license.TEXT
    texts[ROBOT] = robot_toml(robot, choice)
    files = {name: text.encode() for name, text in texts.items()}
    if choice.fmu:
        progress("building the FMU")
        files[f"{machine.symbol}.fmu"] = _unit(robot, choice, made)
    files["README.md"] = _with_missing(_readme(choice, machine, made, found), missing).encode()
    files[MANIFEST] = _manifest(machine, choice, files)
    return Kit(dict(sorted(files.items())), made.operations, made.baked_operations)


def _left_out(robot: Robot, choice: Choice) -> str:
    """Return a clause about the physics that the forces of a kit omit, or an empty text."""
    if "forces" not in choice.functions:
        return ""
    level = resolve_level(robot, choice.formulation, choice.level)
    # The reference in 50-digit arithmetic requires no compiler.
    reduced = Truth(robot, choice.formulation, level).forces
    return neglected_physics(robot, cast("Formulation", choice.formulation), choice.level, reduced)


def _with_missing(readme: str, missing: str) -> str:
    """Return a README with a paragraph about the physics that the forces omit."""
    title, rest = readme.split("\n\n", 1)
    return f"{title}\n\nThe {missing}.\n\n{rest}" if missing else readme


def _of_language(robot: Robot, choice: Choice, missing: str = "") -> Kit:
    languages.check(choice)
    texts = languages.texts(robot, choice)
    texts["README.md"] = _with_missing(texts["README.md"], missing)
    files = {name: text.encode() for name, text in texts.items()}
    files[MANIFEST] = _manifest(_machine(robot, TORQUE in choice.functions), choice, files)
    return Kit(dict(sorted(files.items())), None, None)


def kit_names(robot: Robot, choice: Choice = DEFAULT) -> list[str]:
    """List the file names of a kit without computing its test vectors; raise the errors of ``kit``."""
    check(choice, robot)
    if choice.language != "c":
        return list(_of_language(robot, choice).files)
    machine = _machine(robot, TORQUE in choice.functions)
    unit = [f"{machine.symbol}.fmu"] if choice.fmu else []
    return sorted([*_sources(machine, parts(robot, choice)), *_TEXTS, *unit, MANIFEST])


def _sources(machine: Machine, made: Parts) -> dict[str, str]:
    forces = [each for each in made.functions if each.stem == "forces"]
    named = forces_header(machine, forces[0]) if forces else {}
    return made.files | named | (robot_files(machine) if reads_robot(made.functions) else {})


def _machine(robot: Robot, with_drives: bool) -> Machine:
    """Collect the constants of the robot, and of its drives if a function computes motor torques."""
    shortest, longest = robot.length_limits.T.tolist()
    limits = {"shortest": shortest, "longest": longest}
    limits |= {"force": robot.force_limit.tolist(), "speed": robot.speed_limit.tolist()}
    drives = None
    if with_drives and robot.drive is not None:
        drives = {name: numbers.tolist() for name, numbers in drive_numbers(robot.drive).items()}
    return Machine(robot.name, robot_numbers(robot), limits, drives, generator())


def _vectors(robot: Robot, choice: Choice, made: Parts) -> dict[str, list[Vector]]:
    """Compute the test vectors of each function."""
    stems = tuple(function.stem for function in made.functions)
    torques = tuple(stem for stem in stems if stem in STEMS[TORQUE])
    others = tuple(stem for stem in stems if stem not in ("forces", *torques))
    found: dict[str, list[Vector]] = {stem: [] for stem in stems}
    vectors_of = partial(vectors, robot, formulation=choice.formulation, precision=choice.precision)
    of_forces = vectors_of(("forces",), fidelity=choice.level, baked=choice.bake) if "forces" in stems else ()
    of_torques = vectors_of(torques, fidelity=choice.level) if torques else ()
    for vector in (*of_forces, *of_torques, *(vectors_of(others) if others else ())):
        found[vector.function].append(vector)
    return found


def _build_files(machine: Machine, made: Parts, texts: Mapping[str, str], precision: str) -> dict[str, str]:
    sources = sorted(n for n in texts if n.endswith(".c") and "/" not in n)
    headers = sorted(n for n in texts if n.endswith(".h") and n not in made.shared)
    files = build.build_files(machine.symbol, machine.version, sources, headers, made.shared, precision)
    return files | {build.WRAPPER: cpp.wrapper(made.functions, machine.version)}


def _readme(choice: Choice, machine: Machine, made: Parts, found: Mapping[str, list[Vector]]) -> str:
    eps, stacks = float(np.finfo(PRECISIONS[choice.precision]).eps), _stack()["bytes"]
    figures = {}
    for function in made.functions:
        error, worst = (_errors(found[function.stem]) * eps).tolist()
        stack, batch = (stacks.get(stack_key(function, choice, suffix)) for suffix in ("", "_batch"))
        figures[function.stem] = Figures(error, worst, stack, batch)
    return readme(
        ReadmeKit(
            machine=machine,
            parts=made.parts,
            figures=figures,
            options=options(choice),
            precision=choice.precision,
            stack_by=_stack()["by"],
            unit=f"{machine.symbol}.fmu" if choice.fmu else "",
        )
    )


def _errors(vectors_of: list[Vector]) -> Array:
    """Compute median and largest relative tolerance of the ordinary vectors (rounding units), (2,).

    The relative tolerance of a vector is the largest ratio of a tolerance to the largest value of the same
    array. Without ordinary vectors both results are nan.
    """
    found = [
        max(
            float(np.max(vector.bounds[name]) / np.max(np.abs(answer)))
            for name, answer in vector.answers.items()
            if np.any(answer)
        )
        for vector in vectors_of
        if vector.ordinary and any(np.any(answer) for answer in vector.answers.values())
    ]
    return np.array([np.median(found), np.max(found)] if found else [math.nan, math.nan])


def stack_key(function: Function, choice: Choice, suffix: str = "") -> str:
    """Return the key of a function in ``stack.json``; ``suffix`` is "_batch" for its batch function."""
    return f"{function.plain or function.symbol}{suffix} {choice.precision}"


@cache
def _stack() -> dict[str, Any]:
    """Read the stack sizes: ``by`` names compiler and processors, ``bytes`` has the size of each function."""
    found: dict[str, Any] = json.loads((resources("stewart_sym.kit") / "stack.json").read_text())
    return found


def _manifest(machine: Machine, choice: Choice, files: Mapping[str, bytes]) -> bytes:
    found = {
        "generator": f"stewart-sym {generator_version()}",
        "robot": {"name": machine.name, "sha256": machine.digest},
        "options": asdict(choice) | {"functions": list(choice.groups)},
        "files": {name: hashlib.sha256(content).hexdigest() for name, content in sorted(files.items())},
    }
    return json_text(found).encode()


def _start(robot: Robot, formulation: str) -> Motion:
    """Return the initial pose of an FMU: home, or the pose of the example if home has no solution."""
    home = home_pose(robot)
    return at_rest(np.eye(3), home.t) if home.status == OK else sample(robot, formulation)


def _unit(robot: Robot, choice: Choice, made: Parts) -> bytes:
    """Build the co-simulation unit, which starts at rest at the home pose."""
    assert choice.fmu is not None
    selected = unit_parts(robot, choice, made)
    machine = _machine(robot, choice.fmu != fmu.PLANT)
    sources = selected.files | (robot_files(machine) if reads_robot(selected.functions) else {})
    start = _start(robot, choice.formulation)
    # The sum removes minus signs of zeros.
    theta = rpy_from_rotation(start.R) + 0.0
    pose = {"R": start.R.tolist(), "t": start.t.tolist(), "theta": theta.tolist()}
    texts = fmu.unit(machine, choice.fmu, selected.parts, sources, choice.precision, pose)
    return packed(machine.symbol, texts)
