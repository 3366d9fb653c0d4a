"""Write a kit for one robot in C, Python, MATLAB, or Rust.

A kit contains kernels, the constants of the robot, a self-test, an example, and a README.
In C, `make` builds the kit and runs its self-test; for other languages see its README.

Example: stewart-sym generate hexapod.toml -o kit --functions forces,kinematics && make -C kit
"""

from ...studies.common.report import Report
from ..command import Arguments, Parser, results
from ..inputs import robot_of

_FUNCTIONS = (
    "functions, with commas: forces, reactions (C), motion (M, C, g, friction, bias, H, forward dynamics, "
    "inertia at the actuators), derivatives (of the forces; linearization), kinematics (inverse, forward, "
    "velocities), torque (motors, C). motion and derivatives require universal base joints"
)
_FIDELITY = (
    "leg physics in the forces: general, frictionless, axisymmetric, slender, point_masses, massless (the "
    "last four also with _friction); general_static, slender_static, massless_static; for robots with rotors "
    "also no_rotor, reflected, reflected_slender, reflected_massless (the last two also with _friction)"
)
_UNITS = ("forces", "forces-rpy", "plant")
_UNIT = (
    "FMI 2.0 co-simulation unit: forces (default); forces-rpy, with roll, pitch, and yaw as inputs instead "
    "of R; or plant, the motion under leg forces. The first two also compute motor torques if the robot has "
    "a drive; plant requires universal base joints"
)
_LANGUAGE = (
    "language: c, python (arrays of NumPy, JAX, PyTorch), matlab (also Octave), or rust (also without std). "
    "Only C has reactions, torque, --bake, --scalar, and --fmu; only C and Rust have --precision float"
)


def add_arguments(parser: Parser) -> None:
    parser.file("robot")
    parser.valued("functions", str, _FUNCTIONS, "forces", "LIST")
    parser.formulation()
    parser.valued("fidelity", str, f"{_FIDELITY}; default: general", metavar="LEVEL")
    parser.flag("bake", "insert the constants of the robot into the kernel")
    text = "process the legs of one pose in sequence, for processors without vector registers"
    parser.flag("scalar", text)
    parser.chosen("precision", ("double", "float"), "floating-point type")
    parser.add_argument("--fmu", nargs="?", choices=_UNITS, const=_UNITS[0], metavar="KIND", help=_UNIT)
    parser.valued("language", str, _LANGUAGE, "c", "NAME")
    parser.flag("list", "print the file names without writing files")
    parser.output("DIR", "folder of the kit")


def run(arguments: Arguments) -> None:
    from ...kit import Choice, kit_names, write_kit

    robot, to = robot_of(arguments.robot), arguments.output
    options = ("formulation", "fidelity", "bake", "scalar", "precision", "fmu", "language")
    functions = tuple(name.strip() for name in arguments.functions.split(","))
    choice = Choice(functions, **{name: getattr(arguments, name) for name in options})
    with results(arguments) as (take, progress):
        operations = baked = None
        if arguments.list:
            files = [to / name for name in kit_names(robot, choice)]
        else:
            made, files = write_kit(robot, to, choice, arguments.force, [arguments.robot], progress)
            operations, baked = made.operations, made.baked_operations
        names = [str(path) for path in files]
        data = {"files": names, "operations_per_pose": operations, "baked_operations_per_pose": baked}
        folded = "" if baked is None else f", with the numbers folded in {baked}"
        counts = [] if operations is None else [f"operations per pose: {operations}{folded}"]
        take(Report("\n".join(names + counts), data=data))
