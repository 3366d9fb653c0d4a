"""``stewart-sym generate``: a kit of one robot."""

import argparse
from pathlib import Path

from ...io.arguments import no_option
from ..inputs import robot_of
from ..options import chosen, formulation, output, robot_file
from ..output import results

HELP = "write a kit of one robot in C, Python, MATLAB or Rust: kernels, constants, self-test, example"
EXAMPLE = "stewart-sym generate hexapod.toml -o kit --functions forces,kinematics && make -C kit"
MORE = (
    "The kit tests itself where it runs: in C, `make` builds it and runs its self-test; in another "
    "language its README names the command."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--functions",
        metavar="LIST",
        default="forces",
        help="some of forces, reactions (in C alone), motion (M, C, g, friction, bias, H, forward dynamics, "
        "inertia at the actuators), derivatives (of the forces; linearization), both for universal base "
        "joints, kinematics (inverse, forward, velocities), torque (of the motors of a robot with a drive, "
        "in C alone), with commas; default: forces",
    )
    formulation(parser)
    parser.add_argument(
        "--fidelity",
        metavar="LEVEL",
        help="how much of the legs' physics the forces contain: general, frictionless, axisymmetric, "
        "slender, point_masses, massless, the last four also with _friction; general_static, slender_static, "
        "massless_static; general of legs with rotors has them too, and for these legs there are also "
        "no_rotor and, with the rotors' mass alone, reflected, reflected_slender, reflected_massless, the "
        "last two also with _friction; default: general",
    )
    parser.add_argument("--bake", action="store_true", help="fold the robot's numbers into the forces")
    parser.add_argument(
        "--scalar",
        action="store_true",
        help="forces of one pose, legs one after the other: for processors without vector registers",
    )
    chosen(parser, "precision", ("double", "float"))
    parser.add_argument("--fmu", action="store_true", help="add a co-simulation unit, FMI 2.0, of the forces")
    parser.add_argument(
        "--language",
        type=_language,
        default="c",
        help="c; python: one module on arrays of NumPy, JAX, PyTorch; matlab: a package of functions, for "
        "Octave as well; rust: a crate, without its standard library as well; each with the robot's "
        "constants, self-test, example and README, of forces, motion, derivatives, kinematics, without "
        "--bake, --scalar and --fmu, and with --precision float in rust alone; default: c",
    )
    parser.add_argument("--list", action="store_true", help="print the names of the files, write none")
    output(parser, "DIR", "folder to write to", None)


def _language(name: str) -> str:
    """A name of a language; those other than C are looked up only when asked for."""
    if name != "c":
        from ...derive.package.languages import LANGUAGES

        if name not in LANGUAGES:
            raise argparse.ArgumentTypeError(no_option(name, ("c", *LANGUAGES)))
    return name


def run(arguments: argparse.Namespace) -> int:
    from ...kit import Choice, kit_names, write_kit
    from ...studies.common.report import Report

    robot = robot_of(arguments.robot)
    options = ("formulation", "fidelity", "bake", "scalar", "precision", "fmu", "language")
    functions = tuple(name.strip() for name in arguments.functions.split(","))
    choice = Choice(functions, **{name: getattr(arguments, name) for name in options})
    with results(arguments) as (take, progress):
        counts: dict[str, int | None] = {"operations_per_pose": None, "baked_operations_per_pose": None}
        if arguments.list:
            files = [arguments.output / name for name in kit_names(robot, choice)]
        else:
            inputs = [Path(arguments.robot)]
            made, files = write_kit(robot, arguments.output, choice, arguments.force, inputs, progress)
            counts = dict(zip(counts, (made.operations, made.baked_operations), strict=True))
        operations, baked = counts.values()
        folded = "" if baked is None else f", with the numbers folded in {baked}"
        of_forces = [] if operations is None else [f"operations per pose: {operations}{folded}"]
        names = [str(path) for path in files]
        take(Report("\n".join([*names, *of_forces]), data={"files": names, **counts}))
    return 0
