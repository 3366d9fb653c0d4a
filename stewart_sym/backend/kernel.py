"""Generated kernels: texts, modules, names, fidelity levels, and the constants of a robot in their order.

``stewart_sym.generated`` contains only digests of the rarely used kernels. They are derived at first use and
stored in the cache folder. Their Python modules are imported under the same names as the installed ones.
"""

import contextlib
import hashlib
import importlib.abc
import importlib.util
import sys
from functools import cache
from importlib import import_module
from importlib.machinery import ModuleSpec
from importlib.resources import files
from pathlib import PurePosixPath
from threading import Lock
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np

from ..generated.fidelities import DRIVE_FIDELITIES, FIDELITIES
from ..generated.interface import STRUCTS
from ..io.arguments import option
from ..io.array_types import Array
from ..io.output import write_file
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, need_masses, of_symbol
from .native import cache_folder, create_once

PACKAGE = "stewart_sym.generated"
"""Package of the generated kernels."""
_ONE_DERIVATION = Lock()

FORMULATIONS = ("exact", "paper")
MOTION = STRUCTS["motion"]
"""Arrays of a motion in the order of ``stewart_motion``, with their shapes for one pose."""
LEG, ROTOR, PLATFORM = (tuple(STRUCTS[name]) for name in ("leg", "rotor", "platform"))
_UPPER = np.triu_indices(3)

OFFSET_KERNEL = "exact_offset"
"""Name of the kernel of legs with offset joints, which computes only actuator forces."""
OFFSETS = ("cross", "along", "across", "cross_mass", "cross_center", "cross_inertia")
"""Constants of ``JointOffsets`` that the offset kernel takes, in its order."""


@cache
def digests() -> dict[str, str]:
    """Return the SHA-256 digests of the files that are derived at first use, by path in ``generated/``."""
    table = (files(PACKAGE) / "on_demand.sha256").read_text(encoding="utf-8")
    return {path: digest for digest, path in map(str.split, table.splitlines())}


def generated_text(path: str) -> str:
    """Return the text of a file of ``generated/``, and derive it if it is neither installed nor cached.

    Raises ImportError if SymPy is missing or derives another text than the digest requires.
    """
    if path not in digests():
        return (files(PACKAGE) / path).read_text(encoding="utf-8")
    name = PurePosixPath(path)
    place = cache_folder() / f"{name.stem}-{digests()[path][:32]}{name.suffix}"
    with contextlib.suppress(OSError):
        create_once(place, lambda: write_file(place, _derived(name.stem)[path]))
        return place.read_text(encoding="utf-8")
    # The cache folder cannot be written.
    return _derived(name.stem)[path]


@cache
def _derived(kernel: str) -> dict[str, str]:
    """Derive the files of a kernel, text by path, and compare them with their digests."""
    from ..derive.on_demand import kernel_files

    with _ONE_DERIVATION:
        texts: dict[str, str] = kernel_files(kernel)
    for path, text in texts.items():
        if hashlib.sha256(text.encode()).hexdigest() != digests()[path]:
            remedy = "install the version of SymPy in its requirements, or run `stewart-sym derive`"
            raise ImportError(f"kernel {kernel}: {path} differs from its digest in {PACKAGE}; {remedy}")
    return texts


class _Importer(importlib.abc.InspectLoader):
    """Import of the Python modules that are derived at first use."""

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> ModuleSpec | None:
        package, _, name = fullname.rpartition(".")
        is_derived = package == PACKAGE and f"{name}.py" in digests()
        return importlib.util.spec_from_loader(fullname, self) if is_derived else None

    def get_source(self, fullname: str) -> str:
        return generated_text(f"{fullname.rpartition('.')[2]}.py")


sys.meta_path.append(_Importer())


def module(name: str) -> ModuleType:
    """Import the generated NumPy module of one kernel."""
    return import_module(f"{PACKAGE}.{name}")


def kernel_name(formulation: str, base_joint: str) -> str:
    """Return the name of the generated kernel; raise ValueError for an unknown formulation."""
    option(formulation, FORMULATIONS, "formulation")
    return formulation if base_joint == "universal" else f"{formulation}_{base_joint}"


def robot_kernel(robot: Robot, formulation: str) -> str:
    """Return the name of the kernel of a robot with its rotors; raise ValueError if there is none."""
    name = kernel_name(formulation, robot.base_joint)
    need_no_offsets(robot)
    need_masses(robot)
    if not robot.has_rotors:
        return name
    need_exact(formulation, "whose drive has rotor_inertia")
    return f"{name}_drive"


def force_kernel(robot: Robot, formulation: str) -> str:
    """Return the name of the force kernel of a robot, which may have offsets; raise ValueError if none."""
    if robot.offsets is None:
        return robot_kernel(robot, formulation)
    need_masses(robot)
    need_exact(formulation, "with offset joints")
    if robot.offsets.has_spinning_parts:
        problem = 'expected "spherical", got "universal"; use inverse_dynamics'
        raise ValueError(f"robot: offsets: platform_joint: {problem}")
    return OFFSET_KERNEL


def need_exact(formulation: str, whose: str) -> None:
    """Raise ValueError unless the formulation is "exact"; ``whose`` describes the robot that requires it."""
    if formulation != "exact":
        raise ValueError(f'formulation: expected "exact" for a robot {whose}, got "{formulation}"')


_DRIVE_LEVELS = {
    **DRIVE_FIDELITIES,
    "no_rotor": {**FIDELITIES["general"], "meaning": "everything but the rotors"},
    **{name: level for name, level in FIDELITIES.items() if name != "general"},
}


def levels(robot: Robot, formulation: str = "exact") -> dict[str, dict[str, Any]]:
    """Return kernel, meaning, and operations of the levels of a robot by name, as of universal base joints.

    ``general`` includes all physics. ``frictionless``, ``axisymmetric``, ``slender``, ``point_masses``, and
    ``massless`` have no friction; the last four also exist with friction (``_friction``). Levels with
    ``_static`` omit velocities and accelerations. With rotors, ``general`` includes all their effects, and
    ``reflected`` only their reflected masses, also with ``slender`` and ``massless`` legs; the other levels
    omit the rotors.

    All levels require ``exact`` and universal base joints. With spherical base joints, only levels whose legs
    do not depend on the fixed axis exist, and ``general``. Offset joints and ``paper`` have only ``general``,
    ``paper`` with rotors has none. Raises ValueError for an unknown formulation.
    """
    kernel_name(formulation, robot.base_joint)
    table = _DRIVE_LEVELS if robot.has_rotors else FIDELITIES
    if robot.offsets is not None or formulation == "paper":
        return {} if robot.has_rotors and robot.offsets is None else {"general": table["general"]}
    if robot.base_joint == "universal":
        return table
    return {name: level for name, level in table.items() if name == "general" or not level["universal"]}


def resolve_level(robot: Robot, formulation: str, fidelity: str) -> str:
    """Return a level; raise ValueError, which lists the available levels, for an unavailable one."""
    force_kernel(robot, formulation)
    return option(fidelity, tuple(levels(robot, formulation)), "fidelity")


def force_kernel_name(robot: Robot, formulation: str, fidelity: str) -> str:
    """Return the name in ``stewart_<name>_forces.c`` of a generated kernel; raises as ``resolve_level``."""
    level = resolve_level(robot, formulation, fidelity)
    return force_kernel(robot, formulation) if level == "general" else str(levels(robot)[level]["kernel"])


def operations_per_pose(robot: Robot, formulation: str = "exact", fidelity: str = "general") -> int:
    """Count the operations per pose: +, -, *, /, and sqrt count one each, including the linear solve."""
    level = resolve_level(robot, formulation, fidelity)
    if robot.offsets is not None:
        return int(module(f"{OFFSET_KERNEL}_operations").OPERATIONS["forces"])
    if level == "general":
        return sum(module(force_kernel(robot, formulation)).FORCE_OPERATIONS["friction"]["total"])
    return int(levels(robot)[level]["operations"]["total"])


def rotor_of(robot: Robot, fidelity: str) -> str:
    """Return the effects of the rotors in a level: "all", "mass" (reflected mass), or "none"."""
    if not robot.has_rotors or fidelity not in DRIVE_FIDELITIES:
        return "none"
    return "all" if fidelity == "general" else "mass"


def robot_numbers(robot: Robot, kernel: str = "exact") -> Array:
    """Return the constants of a robot in the order of ``stewart_robot`` or ``stewart_offset_robot``."""
    has_offsets = kernel == OFFSET_KERNEL
    if not has_offsets:
        need_no_offsets(robot)
    symbols = (*LEG, *(ROTOR if has_offsets or "_drive" in kernel else ()))
    legs = [stored(of_symbol(robot, name)).reshape(6, -1) for name in symbols]
    legs += [stored(of_symbol(robot.offsets, name)).reshape(6, -1) for name in OFFSETS if has_offsets]
    platform = [np.ravel(stored(of_symbol(robot, name))) for name in PLATFORM]
    return np.concatenate([np.concatenate(legs, axis=1).ravel(), *platform])


def legs_side_by_side(robot: Robot) -> SimpleNamespace:
    """Convert a robot to a structure of a generated module; constants of the legs have shape (6, 1)."""
    need_no_offsets(robot)
    leg = {name: stored(of_symbol(robot, name)).T[..., None] for name in (*LEG, *ROTOR)}
    platform = {name: stored(of_symbol(robot, name)) for name in PLATFORM}
    return SimpleNamespace(leg=SimpleNamespace(**leg), **platform)


def stored(value: Any) -> Array:
    """Return the six stored components of symmetric tensors; return other arrays unchanged."""
    values = np.asarray(value)
    return values[..., *_UPPER] if values.shape[-2:] == (3, 3) else values


def overflows(precision: str) -> ValueError:
    """Return the error for constants that overflow during their preparation."""
    return ValueError(f"robot: constants or their products exceed the range of {precision}; use smaller ones")
