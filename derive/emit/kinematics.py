"""C99 files of kinematics: lengths and rates of legs, pose and twist of the platform, orientations.

The functions compute one pose, for processors without vector registers. ``stewart_legs`` computes many poses.
"""

from collections.abc import Iterable

from ..kernel.elimination import RETURNED
from ..kernel.kinematics import legs_batch, rotation_program, search_operations, search_program
from ..mechanics.kinematics import Kinematics
from ..print.c import C
from ..print.template import filled
from ..program.block import Block
from ..trace.constants import SEARCH
from ..trace.decided_selections import of_one_pose
from ..trace.nodes import Program, snake
from .shared import ARITHMETIC, header, top

STEPS = {"double": (3, 4, 6), "float": (2, 3, 5)}
"""Newton steps from near, medium, and distant guesses in the header; tests compare them with the kernel."""

OF_STEWART_H = {"Leg": "stewart_leg", "Robot": "stewart_robot", "Motion": "stewart_motion"}
_OF_ARRAYS = OF_STEWART_H | {"Motion": "stewart_motions", "LegsArrays": "stewart_legs_arrays"}
_OF_POSES = OF_STEWART_H | {"Pose": "stewart_pose"}


def kinematics_files(blocks: Kinematics, version: str) -> dict[str, str]:
    """Return ``stewart_kinematics``: inverse and forward kinematics of one pose."""
    return files(
        "kinematics",
        of_one_pose(search_program(blocks, check=RETURNED)),
        _OF_POSES,
        version,
        operations="\n".join(f" * {name:15s} {count}" for name, count in search_operations(blocks).items()),
        max_steps=SEARCH["MAX_STEPS"][0],
        max_searches=SEARCH["MAX_SEARCHES"][0],
        steps="{}, {}, and {}".format(*STEPS["double"]),
        float_steps="{}, {}, and {}".format(*STEPS["float"]),
    )


def legs_files(blocks: Kinematics, version: str) -> dict[str, str]:
    """Return ``stewart_legs``: the legs of many poses."""
    operations = f" * Operations, six legs: {6 * blocks.second.operations()}."
    return files("legs", legs_batch(blocks), _OF_ARRAYS, version, False, operations=operations)


def rotation_files(blocks: Iterable[Block], version: str) -> dict[str, str]:
    """Return ``stewart_rotation``: R, omega, and alpha from roll, pitch, and yaw or from a quaternion."""
    return files("rotation", rotation_program(blocks), OF_STEWART_H, version)


def files(
    name: str, program: Program, records: dict[str, str], version: str, brackets: bool = True, **said: object
) -> dict[str, str]:
    """Return header and source of a program, from the templates of this name.

    Parameters
    ----------
    records : dict
        C names of structures that a header declares, by their names in the tree.
    said : str
        Words of the templates, with ``file`` if the file has another name.
    """
    file = str(said.get("file", f"stewart_{name}"))
    named = {each.name: snake(each.name) for each in program.structures} | records
    printer = C(program.functions, None, brackets, named, program.structures, fused=False)
    own = (each for each in program.structures if each.name not in records)
    text = printer.source(top(file, version, ARITHMETIC), *own, *program.functions)
    after = "" if program.functions[-1].public else f"\n{filled(f'{name}.c', **said)}"
    return header(f"{name}.h", file, version, **said) | {f"{file}.c": text + after}
