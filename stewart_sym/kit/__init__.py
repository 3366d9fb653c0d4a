"""Writes the C kit of one robot: a kernel, the robot's constants, an example that checks itself.

Takes a checked Robot; chooses the example's pose, has its forces computed, and has the files put in place all
at once or not at all. The texts are those of ``derive.emit.kit``; knows nothing of their syntax.
"""

import os
from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import numpy as np

from .. import fidelity
from ..checks import option
from ..derive import notation
from ..derive.bake import baked
from ..derive.block import Quantity
from ..derive.emit import kit as texts
from ..derive.emit import lanes, scalar
from ..derive.emit.c import common_header
from ..derive.fidelity import FIDELITIES, fidelity_kernel
from ..derive.formulation import EXACT, FORMULATIONS
from ..derive.generate import generator_version, shared_blocks
from ..derive.operations import force_operations
from ..derive.regroup import ForceKernel
from ..kernel import c_sources, kernel_name, module
from ..publish import staged_folder
from ..robot import Robot
from ..studies.truth import Truth
from .poses import sample, significant

# Errors of the forces in float, over rounding unit, condition number and largest force, stay below a quarter.
TOLERANCE_FACTOR = 8.0


@dataclass(frozen=True)
class Choice:
    """Which kernel goes into a kit.

    formulation: "exact" or "paper". fidelity: None for the whole kernel with D, K, H, c and the reactions,
    else the forces alone at one level of ``fidelity.FIDELITIES``. bake: fold the robot's numbers in (forces
    alone; ``general`` where no fidelity is given). precision: "double" or "float". scalar: one pose, its legs
    one after the other, small in code and stack, for processors without vector registers (forces alone).
    """

    formulation: str = "exact"
    fidelity: str | None = None
    bake: bool = False
    precision: str = "double"
    scalar: bool = False

    @property
    def level(self) -> str | None:
        """The level of the forces alone, None for the whole kernel."""
        return self.fidelity or ("general" if self.bake or self.scalar else None)


@dataclass(frozen=True)
class Kit:
    """Files of a kit, name -> text, and what a pose takes in operations, before the numbers were folded in
    and after; None where they were not."""

    files: dict[str, str]
    operations: int
    baked_operations: int | None


def write_kit(
    robot: Robot, directory: Path, choice: Choice = Choice(), force: bool = False
) -> tuple[Kit, list[Path]]:
    """Write the C kit of ``robot`` into ``directory``, made if missing, and return it and its files.

    The same robot, choice and version give the same bytes. Files that are there already and equal stay;
    others of the kit's names are replaced only with ``force``; further files are left alone. When anything
    fails the folder is as it was before.

    Raises ValueError of one line: an unknown option, a robot without a pose for the example, a file that
    would be overwritten, a folder that cannot be written.
    """
    made = kit(robot, choice)
    contents = {name: text.encode() for name, text in made.files.items()}
    try:
        changed = [name for name, content in contents.items() if _differs(directory / name, content, force)]
        if changed:
            with staged_folder(directory) as folder:
                for name in changed:
                    (folder / name).write_bytes(contents[name])
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(f"{error.filename or directory}: {reason}") from error
    return made, [directory / name for name in made.files]


def kit(robot: Robot, choice: Choice = Choice()) -> Kit:
    """The kit of a robot. Raises ValueError for an unknown option, or if no pose is good."""
    option(choice.precision, ("double", "float"), "precision")
    numbers = {
        field: np.asarray(getattr(robot, field)).tolist()
        for field in _names(notation.LEG + notation.PLATFORM)
    }
    if choice.level is None:
        kernel = _whole_kernel(robot, choice)
    elif choice.bake or choice.scalar:
        kernel = _derived_kernel(robot, choice, numbers)
    else:
        kernel = _force_kernel(robot, choice)
    sources = dict(kernel.sources)
    if choice.precision == "float":
        sources["stewart.h"] = texts.float_by_default(sources["stewart.h"])
    checked = _checked(robot, choice)
    own = texts.kit(robot.name, kernel.target, numbers, checked, version("stewart-sym"))
    return Kit({**sources, **own}, kernel.operations, kernel.baked_operations)


@dataclass(frozen=True)
class _Kernel:
    """A kernel's files, how the kit's texts call it, and its operations."""

    sources: dict[str, str]
    target: texts.Target
    operations: int
    baked_operations: int | None = None


def _whole_kernel(robot: Robot, choice: Choice) -> _Kernel:
    name = kernel_name(choice.formulation, robot.base_joint)
    says = f"Inverse dynamics and joint reactions of this Stewart platform, kernel `{name}`."
    target = texts.Target(name, precision=choice.precision, says=says)
    count = sum(module(name).OPERATIONS["friction"]["total"])
    return _Kernel(c_sources(name), target, count)


def _force_kernel(robot: Robot, choice: Choice) -> _Kernel:
    level = str(choice.level)
    name = fidelity.force_kernel_name(robot, choice.formulation, level)
    count = fidelity.operations(robot, choice.formulation, level)
    says = (
        f"Actuator forces of this Stewart platform, kernel `{name}`, fidelity {level}: "
        f"{fidelity.meaning(level)}; {count} operations a pose."
    )
    target = texts.Target(name, forces_alone=True, precision=choice.precision, says=says)
    return _Kernel(c_sources(f"{name}_forces"), target, count)


def _derived_kernel(robot: Robot, choice: Choice, numbers: texts.Numbers) -> _Kernel:
    """A kernel that is not among the committed ones: baked, or with its legs one after the other."""
    level = fidelity.resolved(robot, choice.formulation, str(choice.level))
    joint = robot.base_joint if level == "general" else EXACT.base_joint
    form = next(f for f in FORMULATIONS if f.kernel_name == kernel_name(choice.formulation, joint))
    raw = fidelity_kernel(form, FIDELITIES[level])
    plain = shared_blocks(raw)
    made, before, after = plain, force_operations(plain).total.total, None
    if choice.bake:
        name = texts.robot_symbol(robot.name).removeprefix("stewart_")
        name += "" if level == "general" else f"_{level}"
        made = shared_blocks(baked(raw, numbers, name))
        after = force_operations(made).total.total
    count = f"{before} operations a pose" if after is None else f"{after} operations a pose, {before} before"
    folded = " with its numbers folded in" if choice.bake else ""
    says = (
        f"Actuator forces of this Stewart platform{folded}, {form.name}, fidelity {level}: "
        f"{fidelity.meaning(level)}; {count}."
    )
    target = texts.Target(
        made.name,
        forces_alone=True,
        baked=choice.bake,
        scalar=choice.scalar,
        precision=choice.precision,
        says=says,
    )
    return _Kernel(_derived_sources(made, plain, target), target, before, after)


def _derived_sources(made: ForceKernel, plain: ForceKernel, target: texts.Target) -> dict[str, str]:
    generator = generator_version()
    if target.scalar:
        header, source = scalar.header(made, plain if target.baked else None, generator), scalar.source
    else:
        header, source = lanes.baked_header(made, plain, generator), lanes.source
    return {
        "stewart.h": common_header(generator),
        f"{target.file}.h": header,
        f"{target.file}.c": source(made, generator),
    }


def _checked(robot: Robot, choice: Choice) -> texts.Sample:
    """The example's pose with its forces; those of a reduced kernel from its own equations at 50 digits."""
    motion, forces, condition = sample(robot, choice.formulation)
    F = forces.F
    if choice.level is not None:
        level = fidelity.resolved(robot, choice.formulation, choice.level)
        F = Truth(robot, choice.formulation, level).forces(motion).astype(np.float64)
    largest = max(float(np.abs(values).max()) for values in (F, forces.F, forces.D, forces.x))
    return texts.Sample(
        motion={field: getattr(motion, field).tolist() for field in _names(notation.MOTION)},
        F=F.tolist(),
        tolerance=float(significant([TOLERANCE_FACTOR * condition * largest], 2)[0]),
    )


def _names(quantities: Iterable[Quantity]) -> list[str]:
    return [quantity.name for quantity in quantities]


# --- files ------------------------------------------------------------------------------------


def _differs(path: Path, content: bytes, force: bool) -> bool:
    """Whether the file has to be written. ValueError if that takes ``force`` or is out of the question."""
    if not os.path.lexists(path):
        return True
    if path.is_dir():
        raise ValueError(f"{path}: expected a file or nothing, found a folder")
    if path.exists() and path.read_bytes() == content:
        return False
    if not force:
        raise ValueError(f"{path}: exists with other content; use --force to overwrite")
    return True
