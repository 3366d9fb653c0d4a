"""Kernels that a kit requires: files of ``generated/``, or derived for one robot."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from importlib.metadata import version

import numpy as np

from ..backend import kernel as kernels
from ..backend.kernel import generated_text, module, robot_kernel
from ..derive.emit import lanes, scalar
from ..derive.emit.closed_form import FUNCTIONS as MOTION_FUNCTIONS
from ..derive.emit.header import common_header
from ..derive.emit.shared import ARITHMETIC, INCLUDED, LANES, OUTPUTS, SOLVE
from ..derive.emit.torque import axial_files, axial_name, axial_operations, torque_operations
from ..derive.generated_files import (
    generator_version,
    motion_files,
    reduced_axial,
    reduced_fidelity,
    reduced_kinematics,
    reduced_rotation,
)
from ..derive.kernel.kinematics import search_operations
from ..derive.kernel.operations import force_operations
from ..derive.kernel.outputs import solves, sums_used
from ..derive.mechanics import quantities
from ..derive.mechanics.actuator_forces import ForceKernel
from ..derive.mechanics.baked_constants import baked
from ..derive.mechanics.formulation import BY_KERNEL, EXACT, EXACT_DRIVE
from ..derive.mechanics.reduced_models import fidelity_kernel
from ..derive.package.fmu import FORCES_RPY, PLANT
from ..derive.package.functions import DRIVES, MODEL, NOTHING, ROBOT, Function, Part
from ..derive.package.text_format import Numbers, robot_symbol
from ..derive.program.cse import shared_blocks
from ..precision.exact_forces import form_and_level
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, of_symbol
from .kit_options import STEMS, TORQUE, Choice

_KINEMATICS = "kinematics"


@dataclass(frozen=True)
class Parts:
    """Parts of a kit.

    Attributes
    ----------
    parts : tuple of Part
        Header, source, and functions of each part.
    operations, baked_operations : int or None
        Operations of the forces per pose, as in ``files.Kit``.
    precision : str
        "double" or "float".
    rotors : bool
        True if the legs have rotors.
    """

    parts: tuple[Part, ...]
    operations: int | None = None
    baked_operations: int | None = None
    precision: str = "double"
    rotors: bool = False

    @property
    def files(self) -> dict[str, str]:
        """Text of all headers and sources, including the shared headers, by file name."""
        found = {"stewart.h": common_header(generator_version(), self.precision, self.rotors)}
        found |= {name: generated_text(f"c/{name}") for name in self.shared}
        for part in self.parts:
            found |= part.files
        return found

    @property
    def shared(self) -> tuple[str, ...]:
        """Headers that the sources of the parts share."""
        return tuple(dict.fromkeys(name for part in self.parts for name in part.shared))

    @property
    def functions(self) -> tuple[Function, ...]:
        """Functions of all parts."""
        return tuple(function for part in self.parts for function in part.functions)


def fields(rotors: bool) -> tuple[str, ...]:
    """List the fields of ``stewart_robot``: of the legs, optionally with rotors, and of the platform."""
    of_leg = quantities.OF_LEG if rotors else quantities.LEG
    return tuple(quantity.name for quantity in (*of_leg, *quantities.PLATFORM))


def robot_numbers(robot: Robot, rotors: bool | None = None) -> Numbers:
    """Return the fields of ``stewart_robot`` as nested lists.

    ``rotors`` includes the fields of rotors; None includes them if the robot has rotors.
    """
    need_no_offsets(robot)
    names = fields(robot.has_rotors if rotors is None else rotors)
    return {name: np.asarray(of_symbol(robot, name)).tolist() for name in names}


def parts(robot: Robot, choice: Choice) -> Parts:
    """Select the parts of a kit for a checked ``choice``; raise ValueError for an unknown fidelity level."""
    found: list[Part] = []
    before = after = None
    if "forces" in choice.functions:
        part, before, after = _forces(robot, choice)
        found.append(part)
    if "reactions" in choice.functions:
        found.append(_reactions(robot, choice))
    if {"motion", "derivatives"} & set(choice.functions):
        model = f"stewart_{robot_kernel(robot, 'exact')}_forces"
        if all(part.name != model for part in found):
            found.append(_model(model))
        found.append(_motion(robot, choice))
    if _KINEMATICS in choice.functions:
        found.append(_kinematics())
    if TORQUE in choice.functions:
        found += _torques(robot, choice)
    found.append(_rotation())
    return Parts(tuple(found), before, after, choice.precision, robot.has_rotors)


def unit_parts(robot: Robot, choice: Choice, parts_of_kit: Parts) -> Parts:
    """Select the parts of the co-simulation unit of a kit; the first one computes the dynamics."""
    if choice.fmu == PLANT:
        kernel = robot_kernel(robot, "exact")
        says = f"Forward dynamics, kernel `{kernel}`, all physics of the legs."
        costs = {"forward_dynamics": _before_solves(kernel, "forward_dynamics")}
        prefix = f"stewart_{kernel}"
        dynamics = _part(f"{prefix}_motion", costs, MODEL, ("motion",), says, prefix, SOLVE)
        found = [dynamics, _model(f"{prefix}_forces"), _kinematics(), _rotation()]
    else:
        has_forces = (part for part in parts_of_kit.parts if any(f.stem == "forces" for f in part.functions))
        found = [next(has_forces)]
        if robot.drive is not None:
            torques = _torques(robot, choice)
            # The function of the axial forces also computes length rates.
            found += torques if len(torques) > 1 else [*torques, _kinematics()]
        if choice.fmu == FORCES_RPY:
            found.append(_rotation())
    return Parts(tuple(found), precision=choice.precision, rotors=robot.has_rotors)


def _model(file: str) -> Part:
    says = "Prepared constants of the equations of motion, with the actuator forces."
    return _part(file, {}, MODEL, ("forces",), says, shared=LANES)


def _forces(robot: Robot, choice: Choice) -> tuple[Part, int, int | None]:
    level = kernels.resolve_level(robot, choice.formulation, choice.level)
    if choice.bake or choice.scalar:
        return _derived(robot, choice, level)
    name = kernels.force_kernel_name(robot, choice.formulation, level)
    count = kernels.operations_per_pose(robot, choice.formulation, level)
    meaning = kernels.levels(robot)[level]["meaning"]
    says = f"Actuator forces, kernel `{name}`, fidelity {level}: {meaning}."
    return _force_part(f"stewart_{name}_forces", f"stewart_{name}", count, says), count, None


def _force_part(
    file: str, prefix: str, count: int, says: str, plain: str = "", sources: Mapping[str, str] | None = None
) -> Part:
    """Build the part of the forces.

    ``plain`` is the prefix of the same kernel without baked constants, or "" if the kernel is not baked.
    """
    one_pose = file.endswith("_pose")
    kind = f"forces{' scalar' if one_pose else ''}{' baked' if plain else ''}"
    shared, subject = SOLVE if one_pose else LANES, NOTHING if plain else MODEL
    part = _part(file, {"forces": f"{count:,}"}, subject, (kind,), says, prefix, shared, sources)
    (function,) = part.functions
    function = replace(function, plain=f"{plain}_forces" if plain else "", one_pose=one_pose)
    return replace(part, functions=(function,))


def _derived(robot: Robot, choice: Choice, level: str) -> tuple[Part, int, int | None]:
    """Derive a kernel that is not committed: baked, or with its legs in sequence."""
    plain = reduced_fidelity(*form_and_level(robot.base_joint, choice.formulation, level, robot.has_rotors))
    made, before, after = plain, force_operations(plain, choice.scalar).total.total, None
    if choice.bake:
        made = folded_kernel(robot, choice.formulation, level)
        after = force_operations(made, choice.scalar).total.total
    count = before if after is None else after
    ways = [
        *(["constants of the robot baked in"] if choice.bake else []),
        *(["one pose, legs in sequence"] if choice.scalar else []),
    ]
    form = plain.formulation.name
    meaning = kernels.levels(robot)[level]["meaning"]
    says = f"Actuator forces, {form}, fidelity {level}: {meaning}; {', '.join(ways)}."
    suffix = "_pose" if choice.scalar else ""
    file = f"stewart_{made.name}_{'pose' if choice.scalar else 'forces'}"
    if choice.scalar:
        sources = scalar.files(made, plain if choice.bake else None, generator_version())
    else:
        sources = lanes.files(made, generator_version(), before=plain)
    without = f"stewart_{plain.name}{suffix}" if choice.bake else ""
    part = _force_part(file, f"stewart_{made.name}{suffix}", count, says, without, sources)
    return part, before, after


@lru_cache(maxsize=4)
def folded_kernel(robot: Robot, formulation: str, level: str) -> ForceKernel:
    """Derive the forces of a fidelity level with the constants of a robot baked in."""
    name = robot_symbol(robot.name).removeprefix("stewart_")
    name += "" if level == "general" else f"_{level}"
    raw = fidelity_kernel(*form_and_level(robot.base_joint, formulation, level, robot.has_rotors))
    return shared_blocks(baked(raw, robot_numbers(robot), name))


def _reactions(robot: Robot, choice: Choice) -> Part:
    name = robot_kernel(robot, choice.formulation)
    costs = dict.fromkeys(STEMS["reactions"], f"{sum(module(name).OPERATIONS['friction']['total']):,}")
    says = f"Inverse dynamics with D, K, H, c, and the joint reactions, kernel `{name}`."
    file = f"stewart_{name}"
    return _part(file, costs, ROBOT, ("reactions",), says, file, OUTPUTS)


def _motion(robot: Robot, choice: Choice) -> Part:
    form = EXACT_DRIVE if robot.has_rotors else EXACT
    prefix = f"stewart_{form.kernel_name}"
    groups = tuple(group for group in ("motion", "derivatives") if group in choice.functions)
    stems = tuple(stem for group in groups for stem in STEMS[group])
    costs = {stem: _before_solves(form.kernel_name, stem) for stem in stems}
    files = None if set(stems) == set(MOTION_FUNCTIONS) else _some_motion_files(stems, form)
    says = f"Closed form of the equations of motion: {', '.join(stem.replace('_', ' ') for stem in stems)}."
    return _part(f"{prefix}_motion", costs, MODEL, groups, says, prefix, SOLVE, files)


_some_motion_files = lru_cache(maxsize=4)(motion_files)


def _before_solves(kernel: str, stem: str) -> str:
    counts: Mapping[str, int] = module(f"{kernel}_operations").OPERATIONS
    count = sum(counts[name] for name in sums_used((stem,), deep=False))
    return f"{count:,} and the solves" if solves(stem) else f"{count:,}"


def _kinematics() -> Part:
    counts = {name: f"{each.total:,}" for name, each in search_operations(reduced_kinematics()).items()}
    costs = {
        "inverse_kinematics": counts["lengths, rates"],
        "forward_kinematics": f"{counts['search']} and {counts['step']} a step",
        "forward_velocity": counts["velocity"],
    }
    says = "Inverse and forward kinematics: leg lengths and rates, and the pose for given lengths."
    return _part("stewart_kinematics", costs, ROBOT, (_KINEMATICS,), says)


def _torques(robot: Robot, choice: Choice) -> list[Part]:
    """Build the part of the motor torques and, for forces that include rotors, of the axial forces."""
    found = []
    rotor = kernels.rotor_of(robot, choice.level)
    if rotor != "none":
        name = robot_kernel(robot, "exact")
        form, reflected = BY_KERNEL[name], rotor == "mass"
        file, block = axial_name(form, reflected), reduced_axial(form, reflected)
        made = axial_files(form, block, generator_version(), True) if reflected else None
        costs = {"axial_forces": f"{axial_operations(block).total:,}"}
        says = "Axial forces of the screws for the motor torques: F without the inertia of the rotors."
        prefix = file.removesuffix("_axial")
        found.append(_part(file, costs, ROBOT, ("axial",), says, prefix, files=made))
    assert robot.drive is not None
    costs = {"motor_torques": f"{torque_operations(bool(np.any(robot.drive.stribeck_force))).total:,}"}
    says = "Torques and currents of the motors for given leg forces and length rates."
    if robot.has_rotors and rotor == "none":
        says += (
            f" The forces of fidelity {choice.level} omit the rotors: the torques exclude the inertia of the "
            "rotors, and `axial` is null."
        )
    return [*found, _part("stewart_torque", costs, DRIVES, (TORQUE,), says)]


def _rotation() -> Part:
    says = "R, omega, and alpha of a motion from roll, pitch, and yaw, or a quaternion, and their rates."
    costs = {stem: f"{block.operations().total}" for stem, block in reduced_rotation().items()}
    return _part("stewart_rotation", costs, NOTHING, ("rotation",), says)


def _part(
    file: str,
    costs: Mapping[str, str],
    subject: str,
    kinds: tuple[str, ...],
    says: str,
    prefix: str = "stewart",
    shared: str = ARITHMETIC,
    files: Mapping[str, str] | None = None,
) -> Part:
    """Build one header and one source with functions ``<prefix>_<stem>``.

    ``costs`` contains the operations by stem, and ``shared`` is a key of ``INCLUDED``. If ``files`` is None,
    the files of ``generated/c`` are used, which are derived at first use if they are not installed.
    """
    if files is None:
        files = {name: generated_text(f"c/{name}") for name in (f"{file}.h", f"{file}.c")}
    functions = tuple(
        Function(stem, f"{prefix}_{stem}", f"{file}.h", subject, prefix, cost) for stem, cost in costs.items()
    )
    return Part(file, files, functions, kinds, says, INCLUDED[shared])


def generator() -> str:
    """Return the version of this package."""
    return version("stewart-sym")
