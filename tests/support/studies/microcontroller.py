"""Measurement of one-pose kits on emulated Arm Cortex-M processors: instructions, flash, and stack.

``python tests/support/studies/microcontroller.py RUN`` runs in the top folder of the source, and writes
``controller.json``, ``controller_drive.json``, and ``controller_kinematics.json`` into the folder RUN. The C
sources of the folder ``board`` start the emulated processor and count.
"""

import re
import shutil
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import toolchain
from toolchain import CORES, Core

from stewart_sym.backend.kernel import MOTION
from stewart_sym.backend.native import CompilerError
from stewart_sym.derive.package.functions import Vector
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.dynamics.sample_poses import sample
from stewart_sym.io.array_types import Array
from stewart_sym.io.output import json_text
from stewart_sym.kinematics.conditioning import characteristic_length, scaled_condition_number
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics, wrench_matrix
from stewart_sym.kit import Choice, kit
from stewart_sym.kit.kit_options import PRECISIONS, STEMS, TORQUE
from stewart_sym.kit.vectors import knows_axes, rejected, vectors
from stewart_sym.motion.motion import Motion
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.results import NOT_FINITE
from stewart_sym.robot.robot import Robot
from stewart_sym.robots import dasgupta1998
from stewart_sym.studies.common.text_tables import Figures

MOTIONS = 8
"""Poses on which a kernel is checked and counted."""
NEAR_JOINT_SINGULAR = 1e-3
"""Sine of a leg's angle to its fixed axis: below 1/32 the code path near the joint singularity is taken."""
_SELFTEST = "selftest.c"
BOARD = Path(__file__).parent / "board"
"""Folder of the sources that start the processor and count."""
_DOCS = Path(".docs")
_OF_DRIVES = ("_axial", "_torque")
"""With what names of sources of torques end."""
_HEAP = frozenset({"malloc", "calloc", "realloc", "free", "_sbrk", "_malloc_r", "_free_r"})


def right(row: Figures) -> bool:
    """Return True if all results of a kit are right, and it needs neither heap nor libm."""
    return not any(row[name] for name in ("failed", "rejected_wrongly", "selftest", "foreign", "double"))


def driven_robot(folder: Path, docs: Path = _DOCS) -> Robot:
    """Write the robot file of the page on drives into a folder, and read it."""
    page = (docs / "howto" / "drives.md").read_text(encoding="utf-8")
    (drive,) = re.findall(r"> driven\.toml <<'END'\n(.*?)END\n", page, re.DOTALL)
    file = folder / "driven.toml"
    text = (docs / "examples" / "hexapod.toml").read_text(encoding="utf-8")
    file.write_text(text + drive, encoding="utf-8")
    return Robot.from_toml(file)


def of_rows(robot: Robot, rows: Sequence[Figures]) -> Figures:
    """Return the figures of the kits of one robot, and the tools that made them."""
    made = {"tools": toolchain.versions(), "flags": toolchain.FLAGS, "units": _UNITS}
    return {"robot": robot.name, "fidelity": "general", "rows": rows, **made}


_UNITS = {
    "drive": "instructions per call, and bytes",
    "worst": "share of the bound",
    "instructions": "per call",
    "near_singular_joints": "instructions per call",
    **dict.fromkeys(("flash", "ram", "stack"), "bytes"),
}


# --- one kit ----------------------------------------------------------------------------------


def measured(robot: Robot, level: str, bake: bool, precision: str) -> Figures:
    """Write, build, run and measure one kit. CompilerError if it does not build or does not end.

    core: the processor, flags: its own of the compiler, board: QEMU's with it. failed, rejected_wrongly:
    forces beyond their bound, and unsolvable poses without their status; worst: largest error over its bound;
    poses: how many; selftest: exit code of the kit's own test. instructions: executed for a pose at most, of
    the poses; near_singular_joints: the same with all six legs near singularities of their joints, None where
    it cannot be tried: baked, or no universal joint. flash: bytes of the ``kernel``'s code and constants, of
    the ``robot``'s numbers, and of all of the test's program, ``image``; ram: bytes of the data of kernel and
    robot, ``kit``, and of the prepared constants, ``model``, which the caller holds. stack: bytes below the
    caller that a ``pose`` was seen to write, and that the preparation, ``prepare``, was; ``frames``: of all
    frames on the deepest way through a pose. foreign: what the objects need of libraries beyond square root,
    size and copies; double: of a float kit, instructions and helpers for doubles. drive: of a machine with a
    drive, instructions of ``motor_torques`` and, with rotors, of ``axial_forces``, their ``flash`` and, of
    the deeper of both, ``stack``.
    """
    core = CORES[precision]
    functions = ("forces",) if robot.drive is None else ("forces", TORQUE)
    made = kit(robot, Choice(functions, "exact", level, bake, True, precision)).files
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as name:
        folder = Path(name)
        for file, content in made.items():
            (folder / Path(file).name).write_bytes(content)
        shutil.copytree(BOARD, folder, dirs_exist_ok=True)
        kernel = next(path.stem for path in folder.glob("stewart_*_pose.c"))
        torques = sorted(path.stem for path in folder.glob("*.c") if path.stem.endswith(_OF_DRIVES))
        header = _cases_header(robot, level, bake, precision, kernel, torques)
        (folder / "cases.h").write_text(header, encoding="utf-8")
        objects = [toolchain.compiled(core, folder / f"{kernel}.c")]
        if torques or not bake:
            objects.append(toolchain.compiled(core, folder / "stewart_robot.c"))
        objects += [toolchain.compiled(core, folder / f"{stem}.c") for stem in torques]
        start = toolchain.compiled(core, folder / "start.c", ["-Wno-pedantic"])
        # The test itself compares in double, on whatever processor.
        count = toolchain.compiled(core, folder / "count.c", ["-Wno-unused-parameter"])
        image = toolchain.linked(core, [*objects, start, count], folder / "link.ld", folder / "count.elf")
        selftest = _selftest(core, [*objects, start], folder)
        return _figures(core, bake, precision, kernel, objects, image, selftest)


def _selftest(core: Core, objects: Sequence[Path], folder: Path) -> int:
    """Exit code of the kit's own test on the processor."""
    test = toolchain.compiled(core, folder / _SELFTEST, ["-DSTEWART_NO_STDIO"])
    rotation = toolchain.compiled(core, folder / "stewart_rotation.c")
    image = toolchain.linked(core, [*objects, rotation, test], folder / "link.ld", folder / "selftest.elf")
    return toolchain.emulated(core, image)[0]


def _figures(
    core: Core,
    bake: bool,
    precision: str,
    kernel: str,
    objects: Sequence[Path],
    image: Path,
    selftest: int,
) -> Figures:
    code, output = toolchain.emulated(core, image)
    said = _said(output)
    if code not in (0, 1) or "stack_forces" not in said:
        raise CompilerError(f"{toolchain.QEMU}: the program ended with {code}: {output.strip()[-200:]}")
    per_call = _KNOWN / said["known"][0] / said["times"][0]
    # The empty function that is subtracted took one instruction itself.
    counts = {
        name: max(round((ticks - said["empty"][0]) * per_call + 1) for ticks in said[name])
        for name in ("ticks", "ticks_near_singular_joints", *(f"ticks_{stem}" for stem in STEMS[TORQUE]))
        if name in said
    }
    parts = [toolchain.sizes(path) for path in objects if not path.stem.endswith(_OF_DRIVES)]
    torques = [toolchain.sizes(path) for path in objects if path.stem.endswith(_OF_DRIVES)]
    drive = {stem: counts[f"ticks_{stem}"] for stem in STEMS[TORQUE] if f"ticks_{stem}" in counts}
    if drive:
        deepest = max(max(said[f"stack_{stem}"]) for stem in drive)
        drive |= {"flash": sum(part["flash"] for part in torques), "stack": deepest - said["stack_empty"][0]}
    usage = [path.with_suffix(".su") for path in objects]
    frames = {"frames": toolchain.deepest_stack(image, usage, f"{kernel}_forces")}
    stack = {"pose": said["stack_forces"][0] - said["stack_empty"][0], **frames}
    ram = {"kit": sum(part["ram"] for part in (*parts, *torques))}
    if not bake:
        stack["prepare"] = said["stack_prepare"][0] - said["stack_empty"][0]
        ram["model"] = said["model_bytes"][0]
    asked = set().union(*(toolchain.asked_for(path) for path in objects))
    own = set().union(*(toolchain.defined(path) for path in objects))
    foreign = (asked - own - toolchain.HARMLESS) | (toolchain.defined(image) & _HEAP)
    double: set[str] = set()
    if precision == "float":
        double = set().union(*(toolchain.double_arithmetic(path) for path in objects))
        foreign |= asked & {"sqrt", "fabs"}
    return {
        "precision": precision,
        "baked": bake,
        "core": core.name,
        "flags": core.flags,
        "board": core.board,
        "failed": said["failed"][0],
        "rejected_wrongly": said["rejected_wrongly"][0],
        "worst": said["worst_error_ppm_of_bound"][0] / 1e6,
        "poses": len(said["ticks"]),
        "selftest": selftest,
        "instructions": counts["ticks"],
        "near_singular_joints": counts.get("ticks_near_singular_joints"),
        "flash": {
            "kernel": parts[0]["flash"],
            "robot": sum(part["flash"] for part in parts[1:]),
            "image": toolchain.sizes(image)["flash"],
        },
        "ram": ram,
        "stack": stack,
        "foreign": sorted(foreign),
        "double": sorted(double),
        "drive": drive,
    }


# --- kinematics -------------------------------------------------------------------------------

NEAR = 1e-3
"""Distance of a guess from its pose: rotation (rad), and translation over the size of the platform."""


_MOST_CONDITION = 30.0
"""Condition number below which lengths of type float determine the pose."""


def _condition(robot: Robot, test: Vector) -> float:
    """Return the scaled condition number of H at a motion of the self-test."""
    at = {name: test.inputs[name].reshape(shape) for name, shape in MOTION.items()}
    H = wrench_matrix(robot, Motion._unchecked(**at))
    return float(scaled_condition_number(H, characteristic_length(robot)))


def measured_kinematics(robot: Robot, precision: str) -> Figures:
    """Measure inverse and forward kinematics on a processor: largest and smallest instructions over poses.

    ``search`` is forward kinematics from a guess at a distance of ``NEAR``, as from the previous cycle.
    """
    core = CORES[precision]
    made = kit(robot, Choice(("kinematics",), "exact", None, False, False, precision)).files
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as name:
        folder = Path(name)
        for file, content in made.items():
            (folder / Path(file).name).write_bytes(content)
        shutil.copytree(BOARD, folder, dirs_exist_ok=True)
        (folder / "kinematics_cases.h").write_text(_kinematics_header(robot, precision), encoding="utf-8")
        sources = ("stewart_kinematics", "stewart_robot", "kinematics")
        objects = [toolchain.compiled(core, folder / f"{stem}.c") for stem in sources]
        start = toolchain.compiled(core, folder / "start.c", ["-Wno-pedantic"])
        image = toolchain.linked(core, [*objects, start], folder / "link.ld", folder / "kinematics.elf")
        code, output = toolchain.emulated(core, image)
        flash = toolchain.sizes(objects[0])["flash"]
    said = _said(output)
    if code not in (0, 1) or "failed" not in said:
        raise CompilerError(f"{toolchain.QEMU}: the program ended with {code}: {output.strip()[-200:]}")
    per_call = _KNOWN / said["known"][0] / said["times"][0]
    counts = {
        name: [round((ticks - said["empty"][0]) * per_call) for ticks in (min(said[name]), max(said[name]))]
        for name in ("lengths", "rates", "search")
    }
    row = {"precision": precision, "core": core.name, "flags": core.flags, "poses": len(said["search"])}
    return row | {"failed": said["failed"][0], "flash": flash, **counts}


def _kinematics_header(robot: Robot, precision: str) -> str:
    """Write motions, and a guess at a distance of ``NEAR`` from the pose of each."""
    tests = vectors(robot, ("forces",), "exact", "general", precision, MOTIONS, False)
    tests = [test for test in tests if _condition(robot, test) < _MOST_CONDITION]
    turn = rotation_from_vector(NEAR * np.array([0.6, -0.64, 0.48]))
    shift = NEAR * characteristic_length(robot) * np.array([0.48, 0.6, -0.64])
    guesses = []
    for test in tests:
        R, t = turn @ test.inputs["R"].reshape(3, 3), test.inputs["t"].ravel() + shift
        guesses.append(f"{{{_nested(R.ravel(), 'REAL({})')}, {_nested(t, 'REAL({})')}}}")
    # The search ends at 16 rounding units of the largest component of the terms of S = q + t - b.
    error = float(64.0 * np.finfo(PRECISIONS[precision]).eps * (np.abs(robot.b).max() + 1.0))
    return "\n".join(
        [
            '#include "stewart_kinematics.h"',
            '#include "stewart_robot.h"',
            "#define REAL(value) ((stewart_real)(value))",
            f"#define ROBOT {robot_symbol(robot.name)}",
            f"#define ERROR REAL({error!r})",
            f"#define MOTIONS {len(tests)}",
            f"static const stewart_motion motions[MOTIONS] = {_motions([test.inputs for test in tests])};",
            f"static const stewart_pose guesses[MOTIONS] = {{{', '.join(guesses)}}};",
        ]
    )


def of_kinematics(robot: Robot, rows: Sequence[Figures]) -> Figures:
    """Return the figures of the kinematics of one robot, and the tools that made them."""
    made = {"tools": toolchain.versions(), "flags": toolchain.FLAGS}
    units = dict.fromkeys(("lengths", "rates", "search"), "instructions per call, least and most")
    return {"robot": robot.name, "rows": rows, **made, "units": units | {"flash": "bytes"}}


_KNOWN = 200_000
"""``BOARD_KNOWN`` of board.h: instructions of which the ticks are counted."""


def _said(output: str) -> dict[str, list[int]]:
    """Numbers that the program printed, by name."""
    found: dict[str, list[int]] = {}
    for name, number in re.findall(r"^(\w+) (-?\d+)\s*$", output, re.MULTILINE):
        found.setdefault(name, []).append(int(number))
    return found


# --- text of cases.h --------------------------------------------------------------------------


def _cases_header(
    robot: Robot, level: str, bake: bool, precision: str, kernel: str, torques: Sequence[str]
) -> str:
    """The kernel's names, motions with forces and bounds, and unsolvable motions.

    torques: names of their sources. The forces are those of the kit's own self-test.
    """
    tests = vectors(robot, ("forces",), "exact", level, precision, MOTIONS, bake)
    unsolvable = unsolvable_motions(robot, level, precision, tests[0].inputs)
    symbol = robot_symbol(robot.name)
    names = [f'#include "{kernel}.h"', f"#define FORCES {kernel}_forces"]
    if bake:
        names.append("#define BAKED")
    else:
        names += ['#include "stewart_robot.h"']
        names += [f"#define {name.upper()} {kernel}_{name}" for name in ("model", "prepare")]
    if torques or not bake:
        names.append(f"#define ROBOT {symbol}")
    if torques:
        names += [f'#include "{stem}.h"' for stem in ("stewart_robot", *torques)]
        names.append(f"#define DRIVES {symbol}_drives")
        names += [f"#define AXIAL {stem}_forces" for stem in torques if stem.endswith("_axial")]
    more = []
    if knows_axes(robot, level) and not bake:
        axes = _nested(_near_singular_joints(robot), "REAL({})")
        more.append("#define NEAR_SINGULAR_JOINTS")
        more.append(f"static const stewart_real near_singular_joints[6][3] = {axes};")
    if torques:
        more.append(f"static const stewart_real rates[MOTIONS][6] = {_rates(robot, tests)};")
    given, without = (
        _motions(each) for each in ([test.inputs for test in tests], [motion for motion, _ in unsolvable])
    )
    expected = np.array([test.answers["F"] for test in tests])
    bounds = np.array([test.bounds["F"] for test in tests]) * np.finfo(PRECISIONS[precision]).eps
    codes = ", ".join(str(code) for _, code in unsolvable)
    return "\n".join(
        [
            "/* cases.h: written for one kernel. */",
            "#include <math.h>",
            "#include <stddef.h>",
            *names,
            "#define REAL(value) ((stewart_real)(value))",
            f"#define MOTIONS {len(tests)}",
            f"#define REJECTED {len(unsolvable)}",
            f"static const stewart_motion motions[MOTIONS] = {given};",
            f"static const double expected[MOTIONS][6] = {_nested(expected)};",
            f"static const double bounds[MOTIONS][6] = {_nested(bounds)};",
            f"static const stewart_motion rejected_motions[REJECTED] = {without};",
            f"static const int rejected_status[REJECTED] = {{{codes}}};",
            *more,
            "",
        ]
    )


def unsolvable_motions(
    robot: Robot, level: str, precision: str, start: dict[str, Array]
) -> list[tuple[dict[str, Array], int]]:
    """Motions and their status: those of the self-test, and from a start numbers none or too large."""
    far = {"double": 1e160, "float": 1e25}[precision]
    return [
        *((each.inputs, each.status) for each in rejected(robot, level, precision)),
        (start | {"t": np.full(3, np.nan)}, NOT_FINITE),
        (start | {"t": np.full(3, far)}, NOT_FINITE),
        (start | {"F_ext": np.full(3, np.inf)}, NOT_FINITE),
    ]


def _near_singular_joints(robot: Robot) -> Array:
    """Fixed axes, (6, 3), with which all legs are near their joint singularities at the first motion."""
    s = inverse_kinematics(robot, sample(robot, "exact")).s
    across = np.cross(s, np.roll(s, 1, axis=-1))
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    return np.asarray(np.sqrt(1 - NEAR_JOINT_SINGULAR**2) * s + NEAR_JOINT_SINGULAR * across)


def _rates(robot: Robot, tests: Sequence[Vector]) -> str:
    rows = []
    for test in tests:
        at = {name: test.inputs[name].reshape(shape) for name, shape in MOTION.items()}
        rows.append(inverse_kinematics(robot, Motion._unchecked(**at)).L_dot)
    return _nested(np.array(rows), "REAL({})")


def _motions(all_numbers: Any) -> str:
    rows = []
    for each in all_numbers:
        fields = (f".{name} = {_nested(each[name].ravel(), 'REAL({})')}" for name in MOTION)
        rows.append(f"{{{', '.join(fields)}}}")
    return "{\n" + ",\n".join(rows) + "}"


def _nested(values: Array, form: str = "{}") -> str:
    if values.ndim > 1:
        return "{" + ",\n".join(_nested(row, form) for row in values) + "}"
    return "{" + ", ".join(form.format(_literal(float(value))) for value in values) + "}"


def _literal(value: float) -> str:
    special: Mapping[str, str] = {"nan": "NAN", "inf": "INFINITY"}
    return special.get(repr(value), repr(value))


def main(arguments: list[str]) -> int:
    """Measure the kits of the documentation, write their figures to a folder, and return the exit code."""
    if said := toolchain.missing():
        print(said, file=sys.stderr)
        return 2
    run = Path(arguments[0])
    run.mkdir(parents=True, exist_ok=True)
    kits = [(precision, bake) for precision in CORES for bake in (False, True)]
    all_right = True
    for name, robot in {"controller": dasgupta1998(), "controller_drive": driven_robot(run)}.items():
        rows = [measured(robot, "general", bake, precision) for precision, bake in kits]
        (run / f"{name}.json").write_text(json_text(of_rows(robot, rows)), encoding="utf-8")
        all_right = all_right and all(map(right, rows))
    robot = dasgupta1998()
    kinematics = [measured_kinematics(robot, precision) for precision in CORES]
    found = json_text(of_kinematics(robot, kinematics))
    (run / "controller_kinematics.json").write_text(found, encoding="utf-8")
    all_right = all_right and not any(row["failed"] for row in kinematics)
    return 0 if all_right else 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
