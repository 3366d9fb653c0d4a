"""Generation: derive every formulation, share, emit, and write the files of ``generated/``.

The last step of ``derive``. The texts depend on this package and on SymPy's minor version alone: no date,
no path, no order of a set. Does not depend on the runtime. A process derives each kernel once.
"""

import gc
from collections.abc import Callable, Collection, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache, partial, reduce
from importlib.metadata import version as installed_version
from multiprocessing import get_context
from time import perf_counter

import sympy as sp

from .emit import arrays, bounds, c, lanes
from .emit import closed_form as motion
from .emit import kinematics as kinematics_text
from .emit import regressor as regressor_text
from .emit import torque as torque_text
from .emit.header import common_header, layout
from .emit.shared import shared_headers
from .kernel import kinematics as search
from .kernel.bounds import BoundedForces
from .kernel.operations import force_operations, kernel_operations
from .kernel.outputs import FORCES, OUTPUTS, program, sums_used
from .kernel.tree.nodes import Program, joined
from .mechanics import closed_form
from .mechanics.actuator_forces import ForceKernel, force_kernel, with_numbers
from .mechanics.axial_forces import axial_block
from .mechanics.closed_form.parts import PREPARED
from .mechanics.closed_form.terms import SumKernel
from .mechanics.formulation import EXACT, EXACT_DRIVE, FORMULATIONS, PAPER, Formulation
from .mechanics.inverse_dynamics import Kernel, kernel
from .mechanics.kinematics import Kinematics, kinematics
from .mechanics.legs.rotor import NONE, REFLECTED, rotor_of
from .mechanics.offset_forces import offset_kernel
from .mechanics.orientation import quaternion, rpy
from .mechanics.reduced_models import DRIVE_FIDELITIES, FIDELITIES, Fidelity, fidelity_kernel, level_of
from .mechanics.regressor import regressor, rotor_columns
from .print.template import filled
from .program.block import Block
from .program.cse import share, shared_blocks

WHOLE = (EXACT, EXACT_DRIVE)
"""Formulations with a closed form and bounds."""
COMPARED = (EXACT, PAPER)
"""Formulations whose operations are counted without friction as well: the paper's program has none."""


def generator_version() -> str:
    """Version that goes into every emitted header: this package's and SymPy's minor one."""
    return f"{installed_version('stewart-sym')} with SymPy {'.'.join(sp.__version__.split('.')[:2])}"


@cache
def reduced(form: Formulation, friction: bool = True) -> Kernel:
    """The kernel as it is emitted: derived, then shared."""
    return shared_blocks(kernel(form, friction))


@cache
def reduced_forces(form: Formulation, friction: bool = True) -> ForceKernel:
    """The kernel of the forces alone as it is emitted: derived, regrouped, then shared."""
    return shared_blocks(force_kernel(form, friction))


@cache
def prepared_model(form: Formulation) -> ForceKernel:
    """The kernel of the forces with all constants that are prepared for it and, of ``WHOLE``, for the closed
    form."""
    kernel = force_kernel(form)
    return shared_blocks(with_numbers(kernel, PREPARED) if form in WHOLE else kernel)


@cache
def reduced_kinematics() -> Kinematics:
    """The blocks of the kinematics as they are emitted: derived, then shared."""
    return shared_blocks(kinematics())


@cache
def reduced_axial(form: Formulation, reflected: bool = False) -> Block:
    """The block of the axial forces of a formulation with rotors as it is emitted: derived, then shared.

    reflected: of forces that have the rotors' masses alone.
    """
    return share(axial_block(form, REFLECTED if reflected else None))


@cache
def reduced_rotation() -> dict[str, Block]:
    """The blocks of an orientation and its rates as they are emitted, by what they are named in C."""
    return {"motion_from_rpy": share(rpy()), "motion_from_quaternion": share(quaternion())}


@dataclass(frozen=True)
class Made:
    """What one unit of the derivation makes.

    files: texts by their paths. models: how many numbers each kernel's prepared model holds. programs: of
    kernels on arrays.
    """

    files: Mapping[str, str]
    models: Mapping[str, int] = field(default_factory=dict)
    programs: Mapping[str, Program] = field(default_factory=dict)


_BASES = {
    **dict.fromkeys(("paper", "exact_drive", "exact_spherical", "exact_offset"), ("exact",)),
    **dict.fromkeys(("paper_spherical", "exact_spherical_drive"), ("exact", "exact_spherical")),
}
"""Kernel -> those whose modules on arrays hold what it has in common with them."""


Progress = Callable[[str, float, float], None]
"""Takes the name of a unit that is made, the seconds that it took, and the share of all that is made."""


def generated_files(progress: Progress = lambda *_: None, processes: int = 1) -> dict[str, str]:
    """Every file of ``generated/`` by its path relative to it.

    processes: how many derive side by side; the texts do not depend on it. One is this process; more are
    started anew, so that a script calls this under ``if __name__ == "__main__"``.
    """
    version = generator_version()
    found: dict[str, Made] = {}
    for name, (made, seconds) in zip(UNITS, derived(UNITS, processes), strict=True):
        found[name] = made
        progress(name, seconds, len(found) / len(UNITS))
    models = {name: count for made in found.values() for name, count in made.models.items()}
    headers = {"stewart.h": common_header(version), **shared_headers(version)}
    files = {name: text for made in found.values() for name, text in made.files.items()}
    return {
        **_of_c(headers),
        "every_output.py": arrays.shared_module(version),
        "arithmetic.py": filled("shared.py", version=version, arithmetic=arrays.arithmetic()),
        "__init__.py": filled("package.py", version=version),
        **files,
        **_on_arrays({name: each for made in found.values() for name, each in made.programs.items()}),
        "interface.py": layout(models, headers, version),
    }


def _on_arrays(programs: Mapping[str, Program]) -> dict[str, str]:
    """The modules on arrays."""
    version = generator_version()
    files = {}
    for name, made in programs.items():
        if bases := _BASES.get(name):
            text = arrays.module_beside({each: programs[each] for each in bases}, made, version)
        else:
            text = arrays.module(made, arrays.imported(made), version)
        files[f"{name}_arrays.py"] = text
    return files


def derived(names: Collection[str], processes: int = 1) -> Iterator[tuple[Made, float]]:
    """What some of ``UNITS`` make, in their order, and the seconds that each took."""
    if processes == 1:
        yield from map(_timed, names)
    else:
        # What a process makes it needs to its end: collecting garbage takes a tenth of the time.
        with ProcessPoolExecutor(processes, get_context("spawn"), gc.disable) as pool:
            yield from pool.map(_timed, names)


def _timed(name: str) -> tuple[Made, float]:
    """One of ``UNITS``, and the seconds that it took."""
    start = perf_counter()
    return UNITS[name](generator_version()), perf_counter() - start


def _formulation(form: Formulation, version: str) -> Made:
    """Every output and the forces of one formulation, the closed form, and the axial forces."""
    built, forces, smooth = reduced(form), prepared_model(form), None
    counts, force_counts = {"friction": kernel_operations(built)}, {"friction": force_operations(forces)}
    if form in COMPARED:
        smooth = reduced_forces(form, friction=False)
        counts["frictionless"] = kernel_operations(reduced(form, friction=False))
        force_counts["frictionless"] = force_operations(smooth)
    found = output_program(form, OUTPUTS if form in WHOLE else (FORCES,))
    files = _of_c(c.files(built, counts, version) | lanes.files(forces, version, smooth)) | {
        f"{form.kernel_name}.py": arrays.every_output(built, counts, force_counts, version),
    }
    if form in WHOLE:
        files |= _closed_form(form, version)
    if form.drive:
        files |= _of_c(torque_text.axial_files(form, reduced_axial(form), version))
    return Made(files, {form.kernel_name: lanes.model_numbers(forces)}, {form.kernel_name: found})


def _bounds(form: Formulation, version: str) -> Made:
    """The forces of one of ``WHOLE`` with bounds of their rounding errors."""
    bounded = BoundedForces(reduced_forces(form))
    models = {f"{form.kernel_name}_bounds": bounded.model_numbers()}
    return Made(_of_c(bounds.files(bounded, version)), models)


def _others(version: str) -> Made:
    """The regressors, the kinematics and the motors' torques."""
    columns, blocks = shared_blocks(regressor()), reduced_kinematics()
    made = kinematics_text.kinematics_files(blocks, version) | kinematics_text.legs_files(blocks, version)
    made |= kinematics_text.rotation_files(reduced_rotation().values(), version)
    files = {
        "exact_regressor.py": arrays.regressor(columns, version),
        "rotor_regressor.py": arrays.rotor_regressor(share(rotor_columns()), version),
    }
    made |= regressor_text.files(columns, version) | torque_text.torque_files(version)
    return Made(files | _of_c(made))


def _offset_joints(version: str) -> Made:
    """The forces of legs with offset joints."""
    built = shared_blocks(offset_kernel())
    row = f'    "forces": {force_operations(built).total.total},'
    files = _of_c(lanes.files(built, version)) | {
        f"{built.name}_operations.py": filled("operations.py", version=version, rows=row),
    }
    return Made(files, {built.name: lanes.model_numbers(built)}, {built.name: program(built)})


def _of_c(files: dict[str, str]) -> dict[str, str]:
    """Files by their paths."""
    return {f"c/{name}": text for name, text in files.items()}


@cache
def reduced_fidelity(form: Formulation, level: Fidelity) -> ForceKernel:
    """The force kernel of one level as it is emitted: derived, reduced, then shared."""
    return shared_blocks(fidelity_kernel(form, level))


def _fidelities(version: str) -> Made:
    """The forces of the levels, and the table of them."""
    files: dict[str, str] = {}
    models: dict[str, int] = {}
    kernels = {}
    for level in (*FIDELITIES.values(), *DRIVE_FIDELITIES.values()):
        built = reduced_fidelity(EXACT if level.rotor == NONE else EXACT_DRIVE, level)
        kernels[level] = built if built.fidelity != "general" else prepared_model(built.formulation)
        if built.fidelity != "general":
            models[built.name] = lanes.model_numbers(built)
            files |= _of_c(lanes.files(built, version))
    files["fidelities.py"] = arrays.fidelities(kernels, version)
    return Made(files, models)


def reduced_motion(
    names: Collection[str] = closed_form.NAMES, form: Formulation = EXACT
) -> tuple[SumKernel, ...]:
    """The kernels of the closed form as they are emitted; names: out of ``closed_form.NAMES``; form: of
    ``WHOLE``."""
    return tuple(_reduced_sums(name, form) for name in closed_form.NAMES if name in names)


@cache
def _reduced_sums(name: str, form: Formulation) -> SumKernel:
    return shared_blocks(closed_form.kernel(name, rotor_of(form)))


@cache
def output_program(
    form: Formulation, outputs: tuple[str, ...], level: str = "general", by_pivots: bool = False
) -> Program:
    """Some of ``kernel.outputs.OUTPUTS`` and of the kinematics as one program; what of the former is not of
    the forces is of ``exact`` alone. by_pivots: without the solve that compares determinants."""
    of_model = tuple(each for each in outputs if each not in search.PUBLIC)
    parts = []
    if of_model:
        built = prepared_model(form)
        if level != "general":
            built = reduced_fidelity(form, level_of(level, form.drive))
        sums = () if of_model == (FORCES,) else reduced_motion(sums_used(of_model), form)
        parts.append(program(built, sums, of_model, by_pivots))
    if of_robot := [each for each in outputs if each in search.PUBLIC]:
        parts.append(search.search_program(reduced_kinematics(), of_robot))
    return reduce(joined, parts)


def motion_files(functions: Collection[str], form: Formulation = EXACT) -> dict[str, str]:
    """``stewart_exact_motion.h`` and ``.c`` with some of ``emit.closed_form.FUNCTIONS`` and what those need.

    form: of ``WHOLE``. Raises ValueError for other functions and for none.
    """
    sums = reduced_motion(sums_used(functions), form)
    return motion.files(sums, prepared_model(form), generator_version(), functions)


def _closed_form(form: Formulation, version: str) -> dict[str, str]:
    rows = [f'    "{each.name}": {motion.sum_operations(each).total},' for each in reduced_motion(form=form)]
    return {
        f"{form.kernel_name}_operations.py": filled("operations.py", version=version, rows="\n".join(rows)),
        **_of_c(motion_files(motion.FUNCTIONS, form)),
    }


UNITS: Mapping[str, Callable[[str], Made]] = {
    **{form.kernel_name: partial(_formulation, form) for form in WHOLE},
    "fidelities": _fidelities,
    **{f"{form.kernel_name}_bounds": partial(_bounds, form) for form in WHOLE},
    **{form.kernel_name: partial(_formulation, form) for form in FORMULATIONS if form not in WHOLE},
    "exact_offset": _offset_joints,
    "regressors, kinematics and torques": _others,
}
"""What is derived, by name, each from the version; what takes longest comes first."""
