"""The interface table is what headers declare and what the package, kits and the sweep go by."""

import re
from pathlib import Path

import pytest
from attack_build import rotor_flags
from builds import run

from stewart_sym import results
from stewart_sym.backend import native
from stewart_sym.backend.kernel import generated_text
from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.mechanics.formulation import FORMULATIONS
from stewart_sym.derive.package.functions import DRIVES, MODEL, NOTHING, ROBOT, Function
from stewart_sym.derive.trace.constants import STATUS, STATUSES
from stewart_sym.generated import interface
from stewart_sym.kit.kit_options import STEMS

ROTATION = ("motion_from_rpy", "motion_from_quaternion")


def functions() -> list[Function]:
    found = [Function(stem, f"stewart_{stem}", "stewart_rotation.h", NOTHING) for stem in ROTATION]
    found += [
        Function(stem, f"stewart_{stem}", "stewart_kinematics.h", ROBOT) for stem in STEMS["kinematics"]
    ]
    for name in (form.kernel_name for form in FORMULATIONS):
        prefix = f"stewart_{name}"
        found += [Function(stem, f"{prefix}_{stem}", f"{prefix}.h", ROBOT) for stem in STEMS["reactions"]]
        found.append(Function("forces", f"{prefix}_forces", f"{prefix}_forces.h", MODEL, prefix))
    found.append(Function("motor_torques", "stewart_motor_torques", "stewart_torque.h", DRIVES))
    for name in ("stewart_exact_drive_axial", "stewart_exact_spherical_drive_axial"):
        found.append(Function("axial_forces", f"{name}_forces", f"{name}.h", ROBOT))
    return found + [
        Function(stem, f"stewart_{name}_{stem}", f"stewart_{name}_motion.h", MODEL, f"stewart_{name}")
        for name in ("exact", "exact_drive")
        for stem in (*STEMS["motion"], *STEMS["derivatives"])
    ]


def test_headers_declare_what_the_table_says_and_no_more() -> None:
    every = functions()
    for header in {function.header for function in every}:
        text = generated_text(f"c/{header}")
        declared = re.findall(r"^STEWART_NODISCARD (int [^;]*;)", text, re.M)
        plain = {" ".join(text.replace("(\n    ", "(").split()) for text in declared}
        of_table = {text for each in every if each.header == header for text in each.prototypes}
        assert of_table == {text for text in plain if "_prepare(" not in text}
    assert {each.stem for each in every} == set(CALLS)


def test_status_codes_are_the_same_everywhere() -> None:
    codes = {name: code for name, code, _ in STATUSES}
    assert {name: code for name, (code, _) in STATUS.items()}.items() <= codes.items()
    assert all(getattr(results, name) == code for name, code in codes.items())
    defined = re.findall(r"^#define STEWART_([A-Z_]+) (\d) /\*", generated_text("c/stewart.h"), re.M)
    assert [(name, int(code)) for name, code in defined] == list(codes.items())


@pytest.mark.parametrize("name", interface.MODELS)
def test_prepared_models_have_the_size_of_the_table(name: str, tmp_path: Path) -> None:
    header = f"stewart_{name}.h" if name.endswith("_bounds") else f"stewart_{name}_forces.h"
    for each in (*interface.HEADERS, header):
        (tmp_path / each).write_text(generated_text(f"c/{each}"), encoding="utf-8")
    right = f"sizeof(stewart_{name}_model) == {interface.MODELS[name]} * sizeof(stewart_real)"
    (tmp_path / "size.c").write_text(f'#include "{header}"\ntypedef char right[{right} ? 1 : -1];\n')
    compiler = native.find_compiler()
    if compiler is None:
        pytest.skip("needs a C compiler")
    command = [*compiler.command, "-std=c99", "-fsyntax-only", *rotor_flags(name)]
    for precision in ((), ("-DSTEWART_FLOAT",)):
        run(*command, *precision, "size.c", cwd=tmp_path)
