"""``stewart-sym generate``: write a kit for one robot."""

import argparse
from pathlib import Path

from ...io.arguments import no_option
from ..inputs import robot_of
from ..options import chosen, formulation, output, robot_file
from ..output import results

HELP = "write a kit for one robot in C, Python, MATLAB, or Rust"
EXAMPLE = "stewart-sym generate hexapod.toml -o kit --functions forces,kinematics && make -C kit"
MORE = (
    "A kit contains kernels, the constants of the robot, a self-test, an example, and a README.\n"
    "In C, `make` builds the kit and runs its self-test; for other languages see its README."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    robot_file(parser)
    parser.add_argument(
        "--functions",
        metavar="LIST",
        default="forces",
        help="functions, with commas: forces, reactions (C), motion (M, C, g, friction, bias, H, forward "
        "dynamics, inertia at the actuators), derivatives (of the forces; linearization), kinematics "
        "(inverse, forward, velocities), torque (motors, C). motion and derivatives require universal base "
        "joints; default: forces",
    )
    formulation(parser)
    parser.add_argument(
        "--fidelity",
        metavar="LEVEL",
        help="leg physics in the forces: general, frictionless, axisymmetric, slender, point_masses, "
        "massless (the last four also with _friction); general_static, slender_static, massless_static; for "
        "robots with rotors also no_rotor, reflected, reflected_slender, reflected_massless (the last two "
        "also with _friction); default: general",
    )
    parser.add_argument(
        "--bake", action="store_true", help="insert the constants of the robot into the kernel"
    )
    parser.add_argument(
        "--scalar",
        action="store_true",
        help="process the legs of one pose in sequence, for processors without vector registers",
    )
    chosen(parser, "precision", ("double", "float"), "floating-point type")
    parser.add_argument("--fmu", action="store_true", help="add an FMI 2.0 co-simulation unit of the forces")
    parser.add_argument(
        "--language",
        type=_language,
        default="c",
        help="language: c, python (arrays of NumPy, JAX, PyTorch), matlab (also Octave), or rust (also "
        "without std). Only C has reactions, torque, --bake, --scalar, and --fmu; only C and Rust have "
        "--precision float; default: c",
    )
    parser.add_argument("--list", action="store_true", help="print the file names without writing files")
    output(parser, "DIR", "folder of the kit", None)


def _language(name: str) -> str:
    """Parse the name of a language; import the other languages only if the name is not C."""
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
