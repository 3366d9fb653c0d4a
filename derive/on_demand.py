"""Kernels that the runtime package derives at first use, and the table of their digests in ``generated/``."""

from collections.abc import Callable, Mapping
from functools import partial
from hashlib import sha256
from pathlib import Path, PurePosixPath

from .emit.torque import axial_name
from .generated_files import (
    BASES,
    WHOLE,
    UnitResult,
    array_module,
    array_program,
    axial_forces_in_c,
    bounds_in_c,
    closed_form_in_c,
    forces_in_c,
    form_of_level,
    generator_version,
    offset_forces_in_c,
    outputs_in_c,
    outputs_in_python,
)
from .mechanics.formulation import BY_KERNEL, EXACT, EXACT_DRIVE, EXACT_SPHERICAL_DRIVE, FORMULATIONS, PAPER
from .mechanics.reduced_models import DRIVE_FIDELITIES, FIDELITIES, GENERAL

TABLE = "on_demand.sha256"
"""File of ``generated/`` with the digests of the files that are derived at first use, as of ``sha256sum``."""


def _arrays(name: str, version: str) -> UnitResult:
    """Derive the array module of one kernel, and the kernels from whose modules it imports."""
    programs = {each: array_program(each, BY_KERNEL.get(name) not in WHOLE) for each in (*BASES[name], name)}
    return UnitResult({f"{name}_arrays.py": array_module(name, programs, version)})


_FORMS = [form for form in FORMULATIONS if form not in (EXACT, PAPER)]
_LEVELS = [level for level in (*FIDELITIES.values(), *DRIVE_FIDELITIES.values()) if level.name != GENERAL]

ON_DEMAND: Mapping[str, Callable[[str], UnitResult]] = {
    **{f"stewart_{form.kernel_name}": partial(outputs_in_c, form) for form in _FORMS},
    **{form.kernel_name: partial(outputs_in_python, form) for form in _FORMS},
    **{f"stewart_{form.kernel_name}_forces": partial(forces_in_c, form, None) for form in (PAPER, *_FORMS)},
    **{
        f"stewart_{form_of_level(level).kernel_name}_{level.name}_forces": partial(
            forces_in_c, form_of_level(level), level
        )
        for level in _LEVELS
    },
    "stewart_exact_offset_forces": offset_forces_in_c,
    **{f"stewart_{form.kernel_name}_bounds": partial(bounds_in_c, form) for form in WHOLE},
    "stewart_exact_drive_motion": partial(closed_form_in_c, EXACT_DRIVE),
    axial_name(EXACT_SPHERICAL_DRIVE): partial(axial_forces_in_c, EXACT_SPHERICAL_DRIVE),
    **{f"{name}_arrays": partial(_arrays, name) for name in BASES if name != PAPER.kernel_name},
}
"""Kernels that are derived at first use, each a function of the version, by the stem of their files."""


def kernel_files(name: str) -> dict[str, str]:
    """Derive the files of one kernel of ``ON_DEMAND``, text by path in ``generated/``."""
    return dict(ON_DEMAND[name](generator_version()).files)


def committed(files: Mapping[str, str]) -> dict[str, str]:
    """Return the files that ``generated/`` contains, with digests instead of the files of ``ON_DEMAND``."""
    later = sorted(name for name in files if PurePosixPath(name).stem in ON_DEMAND)
    rows = (f"{sha256(files[name].encode()).hexdigest()}  {name}\n" for name in later)
    return {name: text for name, text in files.items() if name not in later} | {TABLE: "".join(rows)}


def differences(folder: Path, files: Mapping[str, str]) -> dict[str, list[str]]:
    """Return the names of files of a folder that differ from ``files``, are missing, or are not generated.

    The table in the folder contains the digests of the files of ``ON_DEMAND``.
    """
    paths = [path for pattern in ("*.py", "c/*.[ch]") for path in folder.glob(pattern)]
    present = {path.relative_to(folder).as_posix(): sha256(path.read_bytes()).hexdigest() for path in paths}
    stray = present.keys() - committed(files).keys()
    if (folder / TABLE).is_file():
        rows = (folder / TABLE).read_text(encoding="utf-8").splitlines()
        present |= {name: digest for digest, name in map(str.split, rows)}
    expected = {name: sha256(text.encode()).hexdigest() for name, text in files.items()}
    return {
        "differ": sorted(name for name in expected.keys() & present if expected[name] != present[name]),
        "missing": sorted(expected.keys() - present),
        "not_generated": sorted((present.keys() - expected) | stray),
    }
