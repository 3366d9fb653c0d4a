"""Generation of all files of ``generated/``, the last step of ``derive``.

For each formulation: derive the blocks, eliminate common subexpressions, and emit the files. The files depend
only on this package and on SymPy's minor version. Each process derives a kernel at most once.
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

from .emit import arrays, bounds, lanes
from .emit import closed_form as motion
from .emit import inverse_dynamics as inverse_dynamics_text
from .emit import kinematics as kinematics_text
from .emit import regressor as regressor_text
from .emit import torque as torque_text
from .emit.header import common_header, layout
from .emit.shared import shared_headers
from .kernel import kinematics as search
from .kernel.bounds import BoundedForces
from .kernel.operations import KernelOperations, force_operations, kernel_operations
from .kernel.outputs import FORCES, OUTPUTS, program, sums_used
from .mechanics import closed_form
from .mechanics.actuator_forces import ForceKernel, force_kernel, with_numbers
from .mechanics.axial_forces import axial_block
from .mechanics.closed_form.common_steps import PREPARED
from .mechanics.closed_form.terms import SumKernel
from .mechanics.formulation import BY_KERNEL, EXACT, EXACT_DRIVE, FORMULATIONS, PAPER, Formulation
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
from .trace.nodes import Program, joined

WHOLE = (EXACT, EXACT_DRIVE)
"""Formulations that have a closed form and error bounds."""
COMPARED = (EXACT, PAPER)
"""Formulations whose operations are also counted without friction, because the paper's program has none."""


def generator_version() -> str:
    """Return the version in each emitted header: this package and SymPy's minor version."""
    return f"{installed_version('stewart-sym')} with SymPy {'.'.join(sp.__version__.split('.')[:2])}"


@cache
def reduced(form: Formulation, friction: bool = True) -> Kernel:
    """Derive the inverse dynamics with all terms, and eliminate common subexpressions."""
    return shared_blocks(kernel(form, friction))


@cache
def reduced_forces(form: Formulation, friction: bool = True) -> ForceKernel:
    """Derive and regroup the kernel of the actuator forces, and eliminate its common subexpressions."""
    return shared_blocks(force_kernel(form, friction))


@cache
def prepared_model(form: Formulation) -> ForceKernel:
    """Return the kernel of the forces with all constants of the prepared model.

    Formulations of ``WHOLE`` include the constants of the closed form.
    """
    kernel = force_kernel(form)
    return shared_blocks(with_numbers(kernel, PREPARED) if form in WHOLE else kernel)


@cache
def reduced_kinematics() -> Kinematics:
    """Derive the blocks of the kinematics and eliminate their common subexpressions."""
    return shared_blocks(kinematics())


@cache
def reduced_axial(form: Formulation, reflected: bool = False) -> Block:
    """Derive the block of the axial forces of a formulation with rotors, as it is emitted.

    ``reflected`` selects forces that contain only the reflected masses of the rotors.
    """
    return share(axial_block(form, REFLECTED if reflected else None))


@cache
def reduced_rotation() -> dict[str, Block]:
    """Derive the blocks of an orientation and its rates, by their names in C."""
    return {"motion_from_rpy": share(rpy()), "motion_from_quaternion": share(quaternion())}


@dataclass(frozen=True)
class UnitResult:
    """Files and kernels of one unit of the derivation.

    Attributes
    ----------
    files : mapping
        Texts by path.
    models : mapping
        Count of numbers in the prepared model of each kernel.
    programs : mapping
        Kernel trees of the array modules by kernel.
    """

    files: Mapping[str, str]
    models: Mapping[str, int] = field(default_factory=dict)
    programs: Mapping[str, Program] = field(default_factory=dict)


BASES = {
    **dict.fromkeys(("paper", "exact_drive", "exact_spherical", "exact_offset"), ("exact",)),
    **dict.fromkeys(("paper_spherical", "exact_spherical_drive"), ("exact", "exact_spherical")),
}
"""Kernels whose array modules an array module imports, because they contain common parts, by kernel."""


Progress = Callable[[str, float, float], None]
"""Callback with the name of a finished unit, its time (s), and the completed fraction."""


def generated_files(progress: Progress = lambda *_: None, processes: int = 1) -> dict[str, str]:
    """Return each file of ``generated/`` by its relative path.

    Parameters
    ----------
    progress : callable
        Callback for each finished unit.
    processes : int
        Number of parallel processes; the texts do not depend on it. With 1, this process derives. Otherwise
        new processes are spawned, so a script must call this function under ``if __name__ == "__main__"``.
    """
    version = generator_version()
    found: dict[str, UnitResult] = {}
    for name, (made, seconds) in zip(UNITS, derived(UNITS, processes), strict=True):
        found[name] = made
        progress(name, seconds, len(found) / len(UNITS))
    models = {name: count for made in found.values() for name, count in made.models.items()}
    headers = {"stewart.h": common_header(version), **shared_headers(version)}
    files = {name: text for made in found.values() for name, text in made.files.items()}
    programs = {name: each for made in found.values() for name, each in made.programs.items()}
    # Modules of the forces alone import nothing else from ``exact``.
    forces = {**programs, "exact": array_program("exact", forces_alone=True)}
    for name in programs:
        bases = programs if BY_KERNEL.get(name) in WHOLE else forces
        files[f"{name}_arrays.py"] = array_module(name, bases, version)
    return {
        **_in_c_folder(headers),
        "every_output.py": arrays.shared_module(version),
        "arithmetic.py": filled("shared.py", version=version, arithmetic=arrays.arithmetic()),
        "__init__.py": filled("package.py", version=version),
        **files,
        "interface.py": layout(models, headers, version),
    }


def array_program(name: str, forces_alone: bool = False) -> Program:
    """Derive the kernel tree of the array module of one kernel, on request without its other outputs."""
    form = BY_KERNEL.get(name)
    if form is None:
        return program(reduced_offsets())
    return output_program(form, OUTPUTS if form in WHOLE and not forces_alone else (FORCES,))


def array_module(name: str, programs: Mapping[str, Program], version: str) -> str:
    """Print the array module of one kernel; ``programs`` contains also the kernels of ``BASES``."""
    made, bases = programs[name], {each: programs[each] for each in BASES.get(name, ())}
    if bases:
        return arrays.module_beside(bases, made, version)
    return arrays.module(made, arrays.imported(made), version)


def derived(names: Collection[str], processes: int = 1) -> Iterator[tuple[UnitResult, float]]:
    """Yield the results of some of ``UNITS`` in their order, and the time of each (s)."""
    if processes == 1:
        yield from map(_timed, names)
    else:
        # A process needs its results until it ends, and garbage collection would take a tenth of the time.
        with ProcessPoolExecutor(processes, get_context("spawn"), gc.disable) as pool:
            yield from pool.map(_timed, names)


def _timed(name: str) -> tuple[UnitResult, float]:
    """Derive one of ``UNITS`` and measure the time (s)."""
    start = perf_counter()
    return UNITS[name](generator_version()), perf_counter() - start


def _formulation(form: Formulation, version: str) -> UnitResult:
    """Derive all outputs and the forces of one formulation, its closed form, and its axial forces."""
    made = [outputs_in_c(form, version), outputs_in_python(form, version), forces_in_c(form, None, version)]
    if form in WHOLE:
        made += [closed_form_in_c(form, version), _closed_form_operations(form, version)]
    if form.drive:
        made.append(axial_forces_in_c(form, version))
    files = {name: text for each in made for name, text in each.files.items()}
    models = {name: count for each in made for name, count in each.models.items()}
    return UnitResult(files, models, {form.kernel_name: array_program(form.kernel_name)})


def outputs_in_c(form: Formulation, version: str) -> UnitResult:
    """Print the inverse dynamics with all outputs of one formulation in C."""
    return UnitResult(_in_c_folder(inverse_dynamics_text.files(reduced(form), _counts(form), version)))


def outputs_in_python(form: Formulation, version: str) -> UnitResult:
    """Print the inverse dynamics with all outputs of one formulation in Python."""
    counts = {"friction": force_operations(prepared_model(form))}
    if form in COMPARED:
        counts["frictionless"] = force_operations(reduced_forces(form, friction=False))
    text = arrays.every_output(reduced(form), _counts(form), counts, version)
    return UnitResult({f"{form.kernel_name}.py": text})


@cache
def _counts(form: Formulation) -> dict[str, KernelOperations]:
    """Count the operations of all outputs with friction and, for ``COMPARED``, without."""
    counts = {"friction": kernel_operations(reduced(form))}
    if form in COMPARED:
        counts["frictionless"] = kernel_operations(reduced(form, friction=False))
    return counts


def forces_in_c(form: Formulation, level: Fidelity | None, version: str) -> UnitResult:
    """Print the forces of one fidelity level in C; None is the level ``general``."""
    built = prepared_model(form) if level is None else reduced_fidelity(form, level)
    smooth = reduced_forces(form, friction=False) if level is None and form in COMPARED else None
    files = lanes.files(built, version, smooth)
    return UnitResult(_in_c_folder(files), {built.name: lanes.model_numbers(built)})


def bounds_in_c(form: Formulation, version: str) -> UnitResult:
    """Derive the forces of one of ``WHOLE`` with bounds of their rounding errors."""
    bounded = BoundedForces(reduced_forces(form))
    models = {f"{form.kernel_name}_bounds": bounded.model_numbers()}
    return UnitResult(_in_c_folder(bounds.files(bounded, version)), models)


def axial_forces_in_c(form: Formulation, version: str) -> UnitResult:
    """Derive the axial forces of a formulation with rotors."""
    return UnitResult(_in_c_folder(torque_text.axial_files(form, reduced_axial(form), version)))


def _regressors_kinematics_torques(version: str) -> UnitResult:
    """Derive the regressors, the kinematics, and the motor torques."""
    columns, blocks = shared_blocks(regressor()), reduced_kinematics()
    made = kinematics_text.kinematics_files(blocks, version) | kinematics_text.legs_files(blocks, version)
    made |= kinematics_text.rotation_files(reduced_rotation().values(), version)
    files = {
        "exact_regressor.py": arrays.regressor(columns, version),
        "rotor_regressor.py": arrays.rotor_regressor(share(rotor_columns()), version),
    }
    made |= regressor_text.files(columns, version) | torque_text.torque_files(version)
    return UnitResult(files | _in_c_folder(made))


def _offset_joints(version: str) -> UnitResult:
    """Derive the forces of legs with offset joints."""
    built, made = reduced_offsets(), offset_forces_in_c(version)
    row = f'    "forces": {force_operations(built).total.total},'
    counts = {f"{built.name}_operations.py": filled("operations.py", version=version, rows=row)}
    return UnitResult({**made.files, **counts}, made.models, {built.name: array_program(built.name)})


def offset_forces_in_c(version: str) -> UnitResult:
    """Print the forces of legs with offset joints in C."""
    built = reduced_offsets()
    return UnitResult(_in_c_folder(lanes.files(built, version)), {built.name: lanes.model_numbers(built)})


def _in_c_folder(files: dict[str, str]) -> dict[str, str]:
    """Prefix the names of C files with their folder."""
    return {f"c/{name}": text for name, text in files.items()}


@cache
def reduced_offsets() -> ForceKernel:
    """Derive the force kernel of legs with offset joints, and eliminate its common subexpressions."""
    return shared_blocks(offset_kernel())


@cache
def reduced_fidelity(form: Formulation, level: Fidelity) -> ForceKernel:
    """Derive and reduce the force kernel of one fidelity level, and eliminate its common subexpressions."""
    return shared_blocks(fidelity_kernel(form, level))


def _fidelities(version: str) -> UnitResult:
    """Derive the forces of all fidelity levels, and the table of levels."""
    files: dict[str, str] = {}
    models: dict[str, int] = {}
    kernels = {}
    for level in (*FIDELITIES.values(), *DRIVE_FIDELITIES.values()):
        form, general = form_of_level(level), level.name == "general"
        kernels[level] = prepared_model(form) if general else reduced_fidelity(form, level)
        if not general:
            made = forces_in_c(form, level, version)
            files.update(made.files)
            models.update(made.models)
    files["fidelities.py"] = arrays.fidelities(kernels, version)
    return UnitResult(files, models)


def form_of_level(level: Fidelity) -> Formulation:
    """Return the formulation from which a fidelity level is derived."""
    return EXACT if level.rotor == NONE else EXACT_DRIVE


def reduced_motion(
    names: Collection[str] = closed_form.NAMES, form: Formulation = EXACT
) -> tuple[SumKernel, ...]:
    """Return kernels of the closed form, with common subexpressions eliminated.

    Parameters
    ----------
    names : collection of str
        Kernels out of ``closed_form.NAMES``.
    form : Formulation
        One of ``WHOLE``.
    """
    return tuple(_reduced_sums(name, form) for name in closed_form.NAMES if name in names)


@cache
def _reduced_sums(name: str, form: Formulation) -> SumKernel:
    return shared_blocks(closed_form.kernel(name, rotor_of(form)))


@cache
def output_program(
    form: Formulation, outputs: tuple[str, ...], level: str = "general", by_pivots: bool = False
) -> Program:
    """Return the program of some outputs in ``kernel.outputs.OUTPUTS`` and of the kinematics.

    Outputs other than the forces and the kinematics exist only for formulations in ``WHOLE``. ``by_pivots``
    omits the linear solver that compares determinants.
    """
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
    """Return ``stewart_exact_motion.h`` and ``.c`` with some functions and their dependencies.

    Parameters
    ----------
    functions : collection of str
        Functions out of ``emit.closed_form.FUNCTIONS``.
    form : Formulation
        One of ``WHOLE``.

    Raises
    ------
    ValueError
        If there is no function, or an unknown one.
    """
    sums = reduced_motion(sums_used(functions), form)
    return motion.files(sums, prepared_model(form), generator_version(), functions)


def closed_form_in_c(form: Formulation, version: str) -> UnitResult:
    """Print all functions of the closed form in C."""
    return UnitResult(_in_c_folder(motion_files(motion.FUNCTIONS, form)))


def _closed_form_operations(form: Formulation, version: str) -> UnitResult:
    """Count the operations of the closed form."""
    rows = [f'    "{each.name}": {motion.sum_operations(each).total},' for each in reduced_motion(form=form)]
    text = filled("operations.py", version=version, rows="\n".join(rows))
    return UnitResult({f"{form.kernel_name}_operations.py": text})


UNITS: Mapping[str, Callable[[str], UnitResult]] = {
    **{form.kernel_name: partial(_formulation, form) for form in WHOLE},
    "fidelities": _fidelities,
    **{f"{form.kernel_name}_bounds": partial(bounds_in_c, form) for form in WHOLE},
    **{form.kernel_name: partial(_formulation, form) for form in FORMULATIONS if form not in WHOLE},
    "exact_offset": _offset_joints,
    "regressors, kinematics and torques": _regressors_kinematics_torques,
}
"""Units of the derivation by name, each a function of the version; the slowest units are first."""
