"""A new output is a written function and a line of ``RESULTS``: every language then has it, and proves it.

Its call in C, by which kits and the library find it, follows from the line; a line that lacks what this takes
is named at once. A line of ``FIDELITIES`` gives a reduced model's kernel in C, and its forces are right;
``test_kernel_tree`` adds a language.
"""

import ctypes
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from builds import run
from command_line import rejects
from machines import machine_in_motion, random_motion, random_robot
from reduced_machines import as_simple_as, at_rest

import stewart_sym as ss
from stewart_sym import derive
from stewart_sym.backend import c_kernel, kernel, native
from stewart_sym.backend.c_kernel import address
from stewart_sym.backend.kernel import MOTION
from stewart_sym.derive import generate
from stewart_sym.derive.kernel import interface, outputs
from stewart_sym.derive.kernel.prepare import result
from stewart_sym.derive.kernel.tree.nodes import Array, Field, Integer, Real, Type
from stewart_sym.derive.mechanics.reduced_models import AXISYMMETRIC, FIDELITIES, Fidelity
from stewart_sym.dynamics import closed_form
from stewart_sym.generated.interface import MODELS
from stewart_sym.kit.parts import robot_numbers

WRITTEN = '''

def momentum(model: "Model", motion: "Motion") -> "Momentum":
    """M [v; omega], about the reference point."""
    out = blank(Momentum)
    found = equations(model, motion)
    for i in range(6):
        out.momentum[i] = 0.0
        for j in range(3):
            total = found.M[i][j] * motion.v[j] + found.M[i][j + 3] * motion.omega[j]
            out.momentum[i] = out.momentum[i] + total
    out.status = found.status
    check_momentum(out)
    return out
'''
REGISTERED = """
    "momentum": _result("Momentum", "M [v; omega].", Field("momentum", _numbers(6), "kg m/s, kg m^2/s: it")),
"""
WRITE = """
import json, sys
from pathlib import Path
import stewart_sym.derive as derive
copy, folder = map(Path, sys.argv[1:])
derive.__path__[:] = [str(copy)]
from stewart_sym.derive.mechanics.formulation import EXACT
from stewart_sym.derive.generate import motion_files, output_program
from stewart_sym.derive.kernel.interface import CALLS
from stewart_sym.derive.package.languages import LANGUAGES
from stewart_sym.derive.package.functions import Vector
from stewart_sym.derive.package.languages.contents import Contents
from stewart_sym.derive.package.robot import Machine
given = json.loads(sys.stdin.read())
answers, bounds = ({"momentum": given[each]} for each in ("answer", "bound"))
test = Vector("momentum", given["motion"], answers, bounds)
program = output_program(EXACT, ("momentum",))
machine = Machine("one", given["robot"], {}, None, "test")
kit = Contents(machine, program, ("momentum",), (test,), "double", "")
texts = {name: language.files(kit) for name, language in LANGUAGES.items()}
call = CALLS["momentum"]
declared = call.prototypes("stewart_exact_momentum", "const stewart_exact_model *model", call.has_batch)
members = [(each.name, each.shape, each.unit, each.meaning) for each in call.outputs]
(folder / "call.json").write_text(json.dumps([declared, call.says, members]))
for language, files in (texts | {"c": motion_files(["equations", "momentum"])}).items():
    for name, text in files.items():
        (folder / language / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / language / name).write_text(text)
"""
RUN = {
    "python": [sys.executable, "self_test.py"],
    "matlab": ["octave-cli", "--eval", "assert(self_test() == 0)"],
    "rust": ["cargo", "test", "--offline", "-q"],
}


def case() -> tuple[ss.Robot, ss.Motion, np.ndarray]:
    """A machine, a motion and the momentum that it has."""
    robot, motion = machine_in_motion(51)
    M = ss.equations_of_motion(robot, motion).M
    return robot, motion, M @ np.concatenate([motion.v, motion.omega])


@pytest.fixture(scope="module")
def kits(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for each language, written by a copy of the derivation whose two files have the new output."""
    folder = tmp_path_factory.mktemp("momentum")
    copy = folder / "derive"
    shutil.copytree(Path(derive.__file__).parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
    with (copy / "kernel" / "written" / "closed_form.py").open("a") as file:
        file.write(WRITTEN)
    table = copy / "kernel" / "outputs.py"
    start, opening, rest = table.read_text().partition("\nRESULTS = {")
    assert opening
    table.write_text(f"{start}{opening}{REGISTERED}{rest}")
    robot, motion, answer = case()
    given = {
        "robot": robot_numbers(robot),
        "motion": {name: np.ravel(getattr(motion, name)).tolist() for name in MOTION},
        "answer": answer.tolist(),
        "bound": np.full(6, 100 * np.abs(answer).max()).tolist(),
    }
    command = [sys.executable, "-c", WRITE, str(copy), str(folder)]
    subprocess.run(command, input=json.dumps(given), text=True, check=True)
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("language", RUN)
def test_two_files_give_every_language_a_new_output(language: str, kits: Path) -> None:
    run(*RUN[language], cwd=kits / language)


def in_c(
    library: ctypes.CDLL, prefix: str, name: str, size: int, robot: ss.Robot, motion: ss.Motion
) -> np.ndarray:
    """Six numbers of a function whose prepared model has this size."""
    numbers = np.concatenate([np.ravel(getattr(motion, part)) for part in MOTION])
    arrays = [kernel.robot_numbers(robot), np.zeros(size), numbers, np.zeros(6)]
    pointers = [address(each) for each in arrays]
    assert getattr(library, f"stewart_{prefix}_prepare")(*pointers[:2]) == 0
    assert getattr(library, f"stewart_{prefix}_{name}")(*pointers[1:]) == 0
    return arrays[-1]


@pytest.mark.slow
def test_the_same_two_files_give_c_a_new_output(kits: Path) -> None:
    robot, motion, answer = case()
    made = {path.name: path.read_text() for path in (kits / "c").iterdir()}
    library = native.load("momentum", closed_form.c_sources() | made, ["-O0"])
    found = in_c(library, "exact", "momentum", MODELS["exact"], robot, motion)
    np.testing.assert_allclose(found, answer, rtol=0, atol=1e-14 * np.abs(answer).max())


@pytest.mark.slow
def test_its_call_is_what_the_header_declares(kits: Path) -> None:
    header = " ".join((kits / "c" / "stewart_exact_motion.h").read_text().replace("(\n    ", "(").split())
    declared, *others = json.loads((kits / "call.json").read_text())
    assert len(declared) == 2
    assert all(f"STEWART_NODISCARD {each}" in header for each in declared)
    assert others == ["M [v; omega].", [["momentum", [6], "kg m/s, kg m^2/s", "it"]]]


@pytest.mark.parametrize("kind", [Real(), Array(Integer(), (1,))])
def test_a_member_that_is_no_array_of_numbers_is_named(kind: Type) -> None:
    energy = result("KineticEnergy", "Kinetic energy.", Field("energy", kind, "J: it"))
    expected = 'Field("energy", _numbers(n), ...), of one number _numbers(1)'
    text = f"RESULTS: kinetic_energy: energy: expected {expected}, got {kind}"
    rejects(f"^{re.escape(text)}$", outputs.check_arrays, outputs.RESULTS | {"kinetic_energy": energy})


def test_an_output_of_several_arrays_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    numbers = Array(Real(), (3,))
    both = result("Both", "Two arrays.", Field("one", numbers, "m: it"), Field("other", numbers, "m: it"))
    monkeypatch.setitem(outputs.RESULTS, "both", both)
    rejects(r"^RESULTS: both: expected one array, or .*, got 2 arrays$", interface._of_result, "both")


# The recipe for a reduced model


LEVEL = Fidelity("axisymmetric_at_rest", AXISYMMETRIC, False, False, "at rest, axisymmetric legs")


@pytest.mark.filterwarnings("ignore::stewart_sym.robot.robot.RobotWarning")
def test_a_line_gives_a_kernel_in_c_with_the_forces_of_such_a_machine(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert LEVEL.name not in FIDELITIES
    monkeypatch.setattr(generate, "FIDELITIES", {LEVEL.name: LEVEL})
    monkeypatch.setattr(generate, "DRIVE_FIDELITIES", {})
    made = generate._fidelities("test")
    files = made.files
    ((name, size),) = made.models.items()
    assert LEVEL.meaning in files["fidelities.py"]

    sources = {path.removeprefix("c/"): text for path, text in files.items() if path.startswith("c/")}
    library = native.load(name, c_kernel.c_sources("exact") | sources, ("-O0",))
    rng = np.random.default_rng(3)
    robot = as_simple_as(random_robot(rng), LEVEL)
    motion = random_motion(rng, robot)
    F = in_c(library, name, "forces", size, robot, motion)
    expected = ss.inverse_dynamics(robot, at_rest(motion))
    np.testing.assert_allclose(F, expected.F, rtol=0, atol=1e-12 * np.abs(expected.F).max())
