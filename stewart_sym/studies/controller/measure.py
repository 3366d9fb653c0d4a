"""Kits on a controller: written, cross-compiled, run under QEMU, measured.

Takes a Robot, hands back figures for each kit. Stands on ``kit`` and ``toolchain``; prints nothing.
"""

import re
import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ... import dynamics, fidelity
from ...conditioning import characteristic_length, scaled_condition_number
from ...generated.fidelities import FIDELITIES
from ...kernel import MOTION, loaded
from ...kinematics import inverse_kinematics
from ...kit import GOOD_CONDITION, TOLERANCE_FACTOR, Choice, kit, sample
from ...motion import Motion
from ...native import CompilerError
from ...results import NOT_FINITE, POLE, SHORT_LEG, SINGULAR
from ...robot import Robot
from ...rotation import rotation_from_vector
from ..truth import Truth
from . import toolchain
from .toolchain import CORES, Core

Array = NDArray[np.float64]
Progress = Callable[[str], None]

MOTIONS = 8
"""Poses on which a kernel is checked and counted."""
NEAR_POLE = 1e-3
"""Sine of the angle between leg and fixed axis: the kernel's other road is taken below 1/64."""
_SELFTEST = "selftest.c"
_OWN = ("start.c", "count.c", "board.h", "link.ld")
_HEAP = frozenset({"malloc", "calloc", "realloc", "free", "_sbrk", "_malloc_r", "_free_r"})


@dataclass(frozen=True)
class Figures:
    """What one kit takes on its processor.

    precision: "double" or "float"; baked; core: the processor, flags: its own of the compiler, board: QEMU's
    with it. failed, refused_wrongly: forces beyond their bound and calls without an answer that were not told
    so; worst: largest error over its bound; poses: how many; selftest: exit code of the kit's own test, None
    where it has none. instructions: executed for a pose at most, of the poses; near_poles: the same with all
    six legs near the poles of their joints, None where that cannot be tried: baked, or no universal joint.
    flash: bytes of the ``kernel``'s code and constants, of the ``robot``'s numbers, and of all of the test's
    program, ``image``; ram: bytes of the data of kernel and robot, ``kit``, and of the prepared constants,
    ``model``, which the caller holds. stack: bytes below the caller that a ``pose`` was seen to write, and
    that the preparation, ``prepare``, was; ``frames``: of all frames on the deepest way through a pose.
    foreign: what the objects ask of libraries beyond square root, size and copies; double: of a float kit,
    instructions and helpers for doubles.
    """

    precision: str
    baked: bool
    core: str
    flags: tuple[str, ...]
    board: str
    failed: int
    refused_wrongly: int
    worst: float
    poses: int
    selftest: int | None
    instructions: int
    near_poles: int | None
    flash: dict[str, int]
    ram: dict[str, int]
    stack: dict[str, int]
    foreign: tuple[str, ...]
    double: tuple[str, ...]

    @property
    def right(self) -> bool:
        """Whether all that was tried came out as it has to, and nothing is asked of heap or libm."""
        tried = self.failed == 0 and self.refused_wrongly == 0 and self.selftest in (0, None)
        return tried and not self.foreign and not self.double

    @property
    def name(self) -> str:
        """The kit in words."""
        return f"{'baked' if self.baked else 'general'}, {self.precision}"


@dataclass(frozen=True)
class Study:
    """Figures of the kits of one robot, and what made them."""

    robot: str
    fidelity: str
    rows: tuple[Figures, ...]
    tools: dict[str, str]
    flags: tuple[str, ...]

    def as_json(self) -> dict[str, Any]:
        """Everything, as JSON takes it."""
        return asdict(self)


def study(robot: Robot, progress: Progress = lambda _: None, level: str = "general") -> Study:
    """Measure general and baked kits, double on a Cortex-M7 and float on a Cortex-M4F.

    Raises CompilerError where a tool is missing or fails, ValueError as ``kit`` does.
    """
    if said := toolchain.missing():
        raise CompilerError(said)
    cases = Cases.of(robot, level)
    rows = []
    for precision in CORES:
        for bake in (False, True):
            progress(f"{'baked' if bake else 'general'} kit in {precision}")
            rows.append(measured(cases, bake, precision))
    return Study(robot.name, level, tuple(rows), toolchain.versions(), toolchain.FLAGS)


# --- cases ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Cases:
    """Motions of a robot with their forces, N, (n, 6), and the bound of their errors, N a rounding unit."""

    robot: Robot
    level: str
    motions: tuple[Motion, ...]
    forces: Array
    units: Array

    @classmethod
    def of(cls, robot: Robot, level: str) -> "Cases":
        """The example's motion of the kit and others around it, their forces computed to 50 digits."""
        first, _, _ = sample(robot, "exact")
        motions = [first]
        rng = np.random.default_rng(1998)
        for _ in range(20 * MOTIONS):
            other = _nearby(rng, robot, first)
            found = dynamics.inverse_dynamics(robot, other, backend="numpy", on_singular="nan")
            if len(motions) < MOTIONS and found.status == 0 and _condition(robot, found.H) <= GOOD_CONDITION:
                motions.append(other)
        truth = Truth(robot, "exact", fidelity.resolved(robot, "exact", level))
        forces = np.array([truth.forces(motion).astype(np.float64) for motion in motions])
        units = []
        for motion, F in zip(motions, forces, strict=True):
            full = dynamics.inverse_dynamics(robot, motion, backend="numpy")
            largest = max(float(np.abs(values).max()) for values in (F, full.F, full.D, full.x))
            units.append(TOLERANCE_FACTOR * _condition(robot, full.H) * largest)
        return cls(robot, level, tuple(motions), forces, np.array(units))

    def near_poles(self) -> Array | None:
        """Fixed axes, (6, 3), with which all legs are near their poles at the first motion."""
        if not self._knows_axes():
            return None
        s = inverse_kinematics(self.robot, self.motions[0]).s
        across = np.cross(s, np.roll(s, 1, axis=-1))
        across /= np.linalg.norm(across, axis=-1, keepdims=True)
        return np.asarray(np.sqrt(1 - NEAR_POLE**2) * s + NEAR_POLE * across)

    def _knows_axes(self) -> bool:
        level = fidelity.resolved(self.robot, "exact", self.level)
        return self.robot.base_joint == "universal" and bool(FIDELITIES[level]["universal"])

    def refused(self, precision: str) -> list[tuple[dict[str, Array], int]]:
        """Motions without an answer, and their status."""
        robot, start = self.robot, numbers(self.motions[0])
        far = {"double": 1e160, "float": 1e25}[precision]
        still = start | {"R": np.eye(3)}
        cases = [
            (still | {"t": robot.b[2] - robot.p[2]}, SHORT_LEG),
            # With all platform points in one place the legs' lines meet there.
            (start | {"R": np.zeros((3, 3))}, SINGULAR),
            (start | {"t": np.full(3, np.nan)}, NOT_FINITE),
            (start | {"t": np.full(3, far)}, NOT_FINITE),
            (start | {"F_ext": np.full(3, np.inf)}, NOT_FINITE),
        ]
        if self._knows_axes():
            k = robot.k[4] / np.linalg.norm(robot.k[4])
            along = k * np.linalg.norm(start["t"] - robot.b[4])
            cases.append((still | {"t": robot.b[4] + along - robot.p[4]}, POLE))
        return cases


def _nearby(rng: np.random.Generator, robot: Robot, motion: Motion) -> Motion:
    """Another motion: a little turned and moved, with other rates and loads of the same size."""
    size = characteristic_length(robot)
    given = numbers(motion)
    moved = {name: given[name] * rng.uniform(-1.5, 1.5, 3) for name in MOTION if name not in ("R", "t")}
    R = given["R"] @ rotation_from_vector(0.2 * rng.normal(size=3))
    return Motion(R=R, t=given["t"] + 0.2 * size * rng.normal(size=3), **moved)


def _condition(robot: Robot, H: Array) -> float:
    return float(scaled_condition_number(H, characteristic_length(robot)))


def numbers(motion: Motion) -> dict[str, Array]:
    """The fields of a motion, loads included."""
    poses = loaded(motion)
    return {name: np.asarray(getattr(poses, name), dtype=np.float64) for name in MOTION}


# --- one kit ----------------------------------------------------------------------------------


def measured(cases: Cases, bake: bool, precision: str) -> Figures:
    """Write, build, run and measure one kit. CompilerError if it does not build or does not end."""
    core = CORES[precision]
    choice = Choice(fidelity=cases.level, bake=bake, precision=precision, scalar=True)
    made = kit(cases.robot, choice).files
    with tempfile.TemporaryDirectory(prefix="stewart-sym-") as name:
        folder = Path(name)
        for file, text in made.items():
            if "/" not in file and file.endswith((".c", ".h")):
                (folder / file).write_text(str(text), encoding="utf-8")
        for file in _OWN:
            shutil.copyfile(str(files(__package__) / file), folder / file)
        kernel = next(path.stem for path in folder.glob("stewart_*_pose.c"))
        symbol = "" if bake else re.findall(r"extern const stewart_robot (\w+);", str(made["robot.h"]))[0]
        (folder / "cases.h").write_text(_cases_header(cases, kernel, symbol, precision), encoding="utf-8")
        objects = [toolchain.compiled(core, folder / f"{kernel}.c")]
        if not bake:
            objects.append(toolchain.compiled(core, folder / "robot.c"))
        start = toolchain.compiled(core, folder / "start.c", ["-Wno-pedantic"])
        # The test itself compares in double, on whatever processor.
        count = toolchain.compiled(core, folder / "count.c", ["-Wno-unused-parameter"])
        image = toolchain.linked(core, [*objects, start, count], folder / "link.ld", folder / "count.elf")
        selftest = _selftest(core, [*objects, start], folder) if _SELFTEST in made else None
        return _figures(core, bake, precision, kernel, objects, image, selftest)


def _selftest(core: Core, objects: Sequence[Path], folder: Path) -> int:
    """Exit code of the kit's own test on the processor."""
    test = toolchain.compiled(core, folder / _SELFTEST, ["-DSTEWART_NO_STDIO"])
    image = toolchain.linked(core, [*objects, test], folder / "link.ld", folder / "selftest.elf")
    return toolchain.emulated(core, image)[0]


def _figures(
    core: Core,
    bake: bool,
    precision: str,
    kernel: str,
    objects: Sequence[Path],
    image: Path,
    selftest: int | None,
) -> Figures:
    code, output = toolchain.emulated(core, image)
    said = _said(output)
    if code not in (0, 1) or "stack_forces" not in said:
        raise CompilerError(f"{toolchain.QEMU}: the program ended with {code}: {output.strip()[-200:]}")
    per_call = _KNOWN / said["known"][0] / said["times"][0]
    # An empty function took one instruction.
    counts = {
        name: max(round((ticks - said["empty"][0]) * per_call + 1) for ticks in said[name])
        for name in ("ticks", "ticks_near_poles")
        if name in said
    }
    parts = [toolchain.sizes(path) for path in objects]
    usage = [path.with_suffix(".su") for path in objects]
    frames = {"frames": toolchain.deepest_stack(image, usage, f"{kernel}_forces")}
    stack = {"pose": said["stack_forces"][0] - said["stack_empty"][0], **frames}
    ram = {"kit": sum(part["ram"] for part in parts)}
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
    return Figures(
        precision=precision,
        baked=bake,
        core=core.name,
        flags=core.flags,
        board=core.board,
        failed=said["failed"][0],
        refused_wrongly=said["refused_wrongly"][0],
        worst=said["worst_error_ppm_of_bound"][0] / 1e6,
        poses=len(said["ticks"]),
        selftest=selftest,
        instructions=counts["ticks"],
        near_poles=counts.get("ticks_near_poles"),
        flash={
            "kernel": parts[0]["flash"],
            "robot": sum(part["flash"] for part in parts[1:]),
            "image": toolchain.sizes(image)["flash"],
        },
        ram=ram,
        stack=stack,
        foreign=tuple(sorted(foreign)),
        double=tuple(sorted(double)),
    )


_KNOWN = 200_000
"""``BOARD_KNOWN`` of board.h: instructions of which the ticks are counted."""


def _said(output: str) -> dict[str, list[int]]:
    """Numbers that the program printed, by name."""
    found: dict[str, list[int]] = {}
    for name, number in re.findall(r"^(\w+) (-?\d+)\s*$", output, re.MULTILINE):
        found.setdefault(name, []).append(int(number))
    return found


# --- text of cases.h --------------------------------------------------------------------------


def _cases_header(cases: Cases, kernel: str, symbol: str, precision: str) -> str:
    """The kernel's names, motions with forces and bounds, and motions without an answer.

    symbol: the robot's in C, empty where the kernel holds its numbers.
    """
    epsilon = {"double": np.finfo(np.float64).eps, "float": np.finfo(np.float32).eps}[precision]
    refused = cases.refused(precision)
    without = _motions(motion for motion, _ in refused)
    names = [f'#include "{kernel}.h"', f"#define FORCES {kernel}_forces"]
    if not symbol:
        names.append("#define BAKED")
    else:
        names += ['#include "robot.h"', f"#define MODEL {kernel}_model", f"#define PREPARE {kernel}_prepare"]
        names.append(f"#define ROBOT {symbol}")
    axes = cases.near_poles() if symbol else None
    bounds = [float(epsilon * unit) for unit in cases.units]
    return "\n".join(
        [
            "/* cases.h: written for one kernel. */",
            "#include <math.h>",
            "#include <stddef.h>",
            *names,
            "#define REAL(value) ((stewart_real)(value))",
            f"#define MOTIONS {len(cases.motions)}",
            f"#define REFUSED {len(refused)}",
            f"static const stewart_motion motions[MOTIONS] = {_motions(map(numbers, cases.motions))};",
            f"static const double expected[MOTIONS][6] = {_nested(cases.forces)};",
            f"static const double bounds[MOTIONS] = {_nested(np.array(bounds))};",
            f"static const stewart_motion refused_motions[REFUSED] = {without};",
            *([] if axes is None else ["#define NEAR_POLES", _axes_text(axes)]),
            f"static const int refused_status[REFUSED] = {{{', '.join(str(code) for _, code in refused)}}};",
            "",
        ]
    )


def _axes_text(axes: Array) -> str:
    return f"static const stewart_real near_poles[6][3] = {_nested(axes, 'REAL({})')};"


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
