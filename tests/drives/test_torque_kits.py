"""Torques that kits compute in C are those of ``drive_effort``, with rotors and without."""

import ctypes
import dataclasses
import re
from pathlib import Path

import numpy as np
import pytest
from kits import build, few_vectors, proves_itself, run
from machines import Array, dasgupta, random_motion, random_robot, with_random_drives

import stewart_sym as ss
from stewart_sym.backend import native
from stewart_sym.backend.kernel import MOTION
from stewart_sym.derive.kernel.interface import STRUCTS
from stewart_sym.drives.friction import losses
from stewart_sym.drives.motor_states import motor_states
from stewart_sym.kit import Choice, kit, write_kit
from stewart_sym.kit.files import kit_names
from stewart_sym.kit.interpreter import KitInterpreter
from stewart_sym.kit.kit_options import check
from stewart_sym.kit.required_kernels import fields
from stewart_sym.reference import newton_euler
from stewart_sym.robot.robot import of_symbol

Six = ctypes.c_double * 6
EPSILON = np.finfo(np.float64).eps


def machine(rotors: bool, joint: str = "universal") -> ss.Robot:
    rng = np.random.default_rng(5)
    return with_random_drives(rng, random_robot(rng, joint), rotors)


class Compiled:
    """The torques of a kit."""

    def __init__(self, robot: ss.Robot) -> None:
        with few_vectors():
            files = kit(robot, Choice(("torque",))).files
        sources = {name: text.decode() for name, text in files.items() if name.endswith((".c", ".h"))}
        sources = {name: text for name, text in sources.items() if "/" not in name}
        library = native.load("kit_torque", sources)
        self.torques, symbol = library.stewart_motor_torques, f"stewart_robot_{robot.name.lower()}_drives"
        count = sum(each.count for each in STRUCTS["drives"])
        self.drives = (ctypes.c_double * count).in_dll(library, symbol)

    def __call__(self, F: Array, axial: Array | None, L_dot: Array) -> tuple[int, Array, Array]:
        torque, current = Six(), Six()
        passed = None if axial is None else Six(*axial)
        status = self.torques(self.drives, Six(*F), passed, Six(*L_dot), torque, current)
        return status, np.array(torque), np.array(current)


def robot_named(robot: ss.Robot) -> ss.Robot:
    return dataclasses.replace(robot, name="turned")


@pytest.fixture(scope="module", params=[(True, "universal"), (True, "spherical"), (False, "universal")])
def case(request: pytest.FixtureRequest) -> tuple[ss.Robot, Compiled]:
    robot = robot_named(machine(*request.param))
    return robot, Compiled(robot)


@pytest.mark.slow
def test_torques_are_those_of_the_python_layer(case: tuple[ss.Robot, Compiled]) -> None:
    robot, torques = case
    drive = robot.drive
    # Every kind of friction that a drive may have is in this test.
    assert len(losses(drive)) == 7
    motion = random_motion(np.random.default_rng(6), robot, (50,))
    F, L_dot = ss.inverse_dynamics(robot, motion).F, ss.inverse_kinematics(robot, motion).L_dot
    # From rates within the smoothing, where friction is as at rest, to those of the motion.
    for slowness in (0.0, 1e-5, 1e-2, 0.1, 0.3, 1.0):
        slow = dataclasses.replace(motion, v=slowness * motion.v, omega=slowness * motion.omega)
        expected = motor_states(robot, drive, slow, F, slowness * L_dot)
        size = np.abs(F) + np.abs(expected.friction) + np.abs(expected.rotor)
        known = drive.torque_constant > 0.0
        for i in range(50):
            rates = slowness * L_dot[i]
            status, torque, current = torques(F[i], F[i] - expected.rotor[i], rates)
            assert status == 0
            assert np.all(
                np.abs(torque - expected.torque[i]) * np.abs(drive.transmission_ratio)
                <= 8 * EPSILON * size[i]
            )
            assert np.all(current[~known] == 0.0)
            np.testing.assert_allclose(current[known], expected.current[i, known], rtol=1e-12)


def test_torques_need_a_drive_and_those_of_rotors_are_exact() -> None:
    with pytest.raises(ValueError, match=r"^formulation: expected \"exact\" for a robot whose drive has"):
        check(Choice(("torque",), "paper"), machine(True))
    with pytest.raises(
        ValueError, match=r"^functions: torque: expected a robot with a drive, got one without"
    ):
        check(Choice(("torque",)), dasgupta())
    with pytest.raises(ValueError, match=r"^functions: python: expected some of forces.*got 'torque'"):
        kit(machine(True), Choice(("torque",), language="python"))


@pytest.mark.parametrize(
    ("file", "good", "wrong"),
    [
        pytest.param("stewart_torque.c", r"REAL\(3\) -", "REAL(3.001) -", marks=pytest.mark.slow),
        ("stewart_robot.c", r"(_drives = \{[^{]*\{)REAL\([^)]*\)", r"\1REAL(1.5)"),
    ],
)
def test_the_self_test_finds_a_wrong_torque(tmp_path: Path, file: str, good: str, wrong: str) -> None:
    robot, choice = robot_named(machine(False)), Choice(("torque",))
    with few_vectors():
        made, _ = write_kit(robot, tmp_path / "kit", choice)
    assert list(made.files) == kit_names(robot, choice)
    proves_itself(tmp_path / "kit", "gcc", "-O0")
    path = tmp_path / "kit" / file
    text, count = re.subn(good, wrong, path.read_text(encoding="utf-8"))
    assert count == 1
    path.write_text(text, encoding="utf-8")
    code, said = run(build(tmp_path / "kit", "gcc", "-O0")["selftest"])
    assert (code, "drives" in said) == (1, True)


@pytest.mark.parametrize("joint", ["universal", "spherical"])
def test_axial_forces_are_those_of_the_reference(joint: str) -> None:
    robot = machine(True, joint)
    motion = random_motion(np.random.default_rng(7), robot, (5,))
    F = ss.inverse_dynamics(robot, motion).F
    expected = F - newton_euler.rotor_force(robot, motion)
    interpreter = KitInterpreter(
        {name: np.asarray(of_symbol(robot, name)) for name in fields(True)}, robot.base_joint
    )
    for i in range(5):
        at = {name: np.ravel(getattr(motion, name)[i]) for name in MOTION} | {"F": F[i]}
        found = interpreter.axial_forces(at)
        np.testing.assert_allclose(found["axial"].astype(float), expected[i], atol=1e-12 * np.abs(F).max())
        rates = ss.inverse_kinematics(robot, motion[i]).L_dot
        np.testing.assert_allclose(found["L_dot"].astype(float), rates, atol=1e-13 * np.abs(rates).max())


def test_axial_forces_of_reflected_masses_leave_these_out_alone() -> None:
    robot, choice = robot_named(machine(True)), Choice(("forces", "torque"), fidelity="reflected_slender")
    names = kit_names(robot, choice)
    assert "stewart_exact_drive_reflected_axial.c" in names
    assert "stewart_exact_drive_axial.c" not in names
    motion = random_motion(np.random.default_rng(8), robot, (3,))
    F = ss.ForceKernel(robot, fidelity="reflected_slender").forces(motion)
    numbers = {name: np.asarray(of_symbol(robot, name)) for name in fields(True)}
    interpreter = KitInterpreter(numbers, robot.base_joint, fidelity="reflected_slender")
    expected = F - robot.drive.reflected_mass * ss.inverse_kinematics(robot, motion).L_ddot
    for i in range(3):
        at = {name: np.ravel(getattr(motion, name)[i]) for name in MOTION} | {"F": F[i]}
        found = interpreter.axial_forces(at)["axial"].astype(float)
        np.testing.assert_allclose(found, expected[i], atol=1e-12 * np.abs(F).max())
