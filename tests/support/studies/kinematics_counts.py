"""Measurement of inverse and forward kinematics on emulated Arm Cortex-M processors."""

import shutil
import tempfile
from pathlib import Path

import numpy as np
import toolchain
from microcontroller import BOARD, KNOWN, MOTIONS, motions_text, nested_text, printed_numbers
from toolchain import CORES

from stewart_sym.backend.native import CompilerError
from stewart_sym.derive.package.text_format import robot_symbol
from stewart_sym.io.array_types import Array
from stewart_sym.kit import Choice, kit
from stewart_sym.kit.kit_options import PRECISIONS
from stewart_sym.kit.vectors import vectors
from stewart_sym.motion.rotation import rotation_from_vector
from stewart_sym.robot.robot import Robot
from stewart_sym.studies.common.output import Figures

FUNCTIONS = ("inverse", "forward", "velocity")
AWAY = 1e-3
"""Distance from the guesses to the poses: rotation (rad), and translation relative to the longest leg."""
_ROUNDING = 2e4
"""Largest error of poses and velocities in rounding units; the condition number is part of it."""


def measured_kinematics(robot: Robot, precision: str) -> Figures:
    """Write, build, run, and measure a kit of kinematics; CompilerError if it does not build or end.

    Instructions and bytes of stack are the largest over all poses, for each of ``FUNCTIONS``.
    """
    core = CORES[precision]
    made = kit(robot, Choice(("kinematics",), precision=precision)).files
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as name:
        folder = Path(name)
        for file, content in made.items():
            (folder / Path(file).name).write_bytes(content)
        shutil.copytree(BOARD, folder, dirs_exist_ok=True)
        (folder / "poses.h").write_text(_poses_header(robot, precision), encoding="utf-8")
        kernel = toolchain.compiled(core, folder / "stewart_kinematics.c")
        numbers = toolchain.compiled(core, folder / "stewart_robot.c")
        start = toolchain.compiled(core, folder / "start.c", ["-Wno-pedantic"])
        count = toolchain.compiled(core, folder / "kinematics.c")
        objects = [kernel, numbers, start, count]
        image = toolchain.linked(core, objects, folder / "link.ld", folder / "kinematics.elf")
        code, output = toolchain.emulated(core, image)
        said = printed_numbers(output)
        if code not in (0, 1) or "failed" not in said:
            raise CompilerError(f"{toolchain.QEMU}: the program ended with {code}: {output.strip()[-200:]}")
        flash = toolchain.sizes(kernel)["flash"]
    per_call = KNOWN / said["known"][0] / said["times"][0]
    return {
        "precision": precision,
        "core": core.name,
        "failed": said["failed"][0],
        "poses": len(said["ticks_inverse"]),
        "flash": flash,
        "instructions": {
            name: max(round((ticks - said["empty"][0]) * per_call + 1) for ticks in said[f"ticks_{name}"])
            for name in FUNCTIONS
        },
        "stack": {name: max(said[f"stack_{name}"]) - said["stack_empty"][0] for name in FUNCTIONS},
    }


def _poses_header(robot: Robot, precision: str) -> str:
    """Return C definitions of the robot, motions, guesses, and the tolerance of the answers."""
    tests = [test.inputs for test in vectors(robot, ("forces",), "exact", "general", precision, MOTIONS)]
    # Extreme motions follow the ordinary ones.
    del tests[MOTIONS:]
    tolerance = _ROUNDING * float(np.finfo(PRECISIONS[precision]).eps)
    guesses = ",\n".join(
        f"{{.R = {nested_text(R.ravel(), 'REAL({})')}, .t = {nested_text(t, 'REAL({})')}}}"
        for R, t in map(_guess, tests, range(len(tests)))
    )
    return "\n".join(
        [
            "/* poses.h: written for one robot. */",
            f"#define ROBOT {robot_symbol(robot.name)}",
            "#define REAL(value) ((stewart_real)(value))",
            f"#define MOTIONS {len(tests)}",
            f"#define TOLERANCE {tolerance!r}",
            f"static const stewart_motion motions[MOTIONS] = {motions_text(tests)};",
            f"static const stewart_pose guesses[MOTIONS] = {{{guesses}}};",
            "",
        ]
    )


def _guess(inputs: dict[str, Array], seed: int) -> tuple[Array, Array]:
    """Return a pose at the distance ``AWAY`` from the pose of a motion, in a random direction."""
    turn, step = np.random.default_rng(seed).normal(size=(2, 3))
    R, t = inputs["R"].reshape(3, 3), inputs["t"].ravel()
    turn *= AWAY / np.linalg.norm(turn)
    step *= AWAY * np.linalg.norm(t) / np.linalg.norm(step)
    return rotation_from_vector(turn) @ R, t + step
