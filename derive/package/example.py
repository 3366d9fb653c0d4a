"""Example of a kit, ``example/main.c``: one call of each function with its output."""

import textwrap
from collections.abc import Iterable, Mapping, Sequence

from ..kernel.interface import Argument
from .functions import MODEL, Function, Vector, flat, includes
from .robot_source import Machine
from .text_format import braces, in_comment, literal, motion_members, template


def example(machine: Machine, functions: Sequence[Function], vectors: Mapping[str, Sequence[Vector]]) -> str:
    """Return ``example/main.c``, with the first test vector of each function.

    Arguments and errors are as in ``selftest``.
    """
    shown = [(function, vectors[function.stem][0]) for function in functions]
    motions = [motion for _, vector in shown if (motion := vector.motion) is not None]
    parts = {
        "name": in_comment(machine.name),
        "version": machine.version,
        "includes": includes(functions),
        "motion": f"static const stewart_motion motion = {{\n{motion_members(motions[0], '    ')}\n}};\n"
        if motions
        else "",
        "shown": "\n".join(_shown(function, vector, machine.symbol) for function, vector in shown),
        "calls": "\n".join(f"    failed |= show_{function.stem}();" for function in functions),
    }
    return template("kit/example.c", parts)


def _shown(function: Function, vector: Vector, symbol: str) -> str:
    subject = function.subject_argument(f"&{symbol}", "&model", f"&{symbol}_drives")
    arguments = ", ".join(_handed(each) for each in function.call.arguments)
    made = f"    status = {function.symbol}({subject}{arguments});"
    if function.subject == MODEL:
        made = (
            f"    status = {function.prefix}_prepare(&{symbol}, &model);\n"
            "    if (status == STEWART_OK) {\n"
            f"        status = {function.symbol}({subject}{arguments});\n"
            "    }"
        )
    model = [f"    static {function.prefix}_model model;"] if function.subject == MODEL else []
    declared = [*model, *_declared(function, flat(vector.inputs, function.call.inputs)), "    int status;"]
    text = [
        *textwrap.wrap(f"/* {function.call.says} */", 108, subsequent_indent=" * ", break_long_words=False),
        f"static int show_{function.stem}(void)",
        "{",
        *declared,
        made,
        "    if (status != STEWART_OK) {",
        f'        (void)printf("{function.symbol}: status %d, see stewart.h\\n", status);',
        "        return 1;",
        "    }",
        *(f'    print("{label}", {where}, {count});' for label, where, count in _printed(function)),
        "    return 0;",
        "}",
        "",
    ]
    return "\n".join(text)


def _declared(function: Function, inputs: Sequence[float]) -> Iterable[str]:
    """Yield the declarations of all arguments; inputs have initial values."""
    start = 0
    for argument in function.call.arguments:
        arrays = []
        for given in argument.takes:
            values = [literal(value, given.name) for value in inputs[start : start + given.count]]
            arrays.append(f"        {braces(values, ' ' * 8)}")
            start += given.count
        name, numbers = _local(argument), ",\n".join(arrays)
        if argument.struct and arrays:
            yield f"    stewart_{argument.struct} {name} = {{\n{numbers}}};"
        elif arrays:
            yield f"    static const stewart_real {name}{argument.takes[0].dims} =\n{numbers};"
        elif argument.struct and argument.written:
            yield f"    stewart_{argument.struct} {name};"
        elif argument.written:
            yield f"    stewart_real {name}{argument.gives[0].dims};"


def _local(argument: Argument) -> str:
    """Return the name of an argument; outputs do not reuse ``motion``, a name of the example, or ``out``."""
    other = {"motion": "turned", "out": "found"} if argument.written else {}
    return other.get(argument.name, argument.name)


def _handed(argument: Argument) -> str:
    return f"&{_local(argument)}" if argument.struct else _local(argument)


def _printed(function: Function) -> Iterable[tuple[str, str, int]]:
    """Yield label, array, and count of the printed numbers."""
    outputs = [(f"{each.name}, {each.unit}", each.name, each.count) for each in function.call.outputs]
    return _PRINTED.get(function.stem, outputs)


_TURNED = (("R", "turned.R", 9), ("omega, rad/s", "turned.omega", 3), ("alpha, rad/s^2", "turned.alpha", 3))
_PRINTED: dict[str, tuple[tuple[str, str, int], ...]] = {
    "inverse_dynamics": (("F, N", "forces.F", 6), ("D, N", "forces.D", 6), ("c, N and N m", "forces.c", 6)),
    "joint_reactions": (("F_s of leg 1, N", "reactions.F_s[0]", 3), ("M_u, N m", "reactions.M_u", 6)),
    "equations": (("M, first row", "found.M", 6), ("g, N and N m", "found.g", 6)),
    "forward_dynamics": (("a, m/s^2, alpha, rad/s^2", "acceleration", 6),),
    "joint_inertia": (("joint inertia, first row, kg", "inertia", 6),),
    "derivatives": (("dF by pose, first row", "found.by_pose", 6),),
    "linearization": (("A, row of a, by dt", "found.A + 72", 6),),
    "forward_kinematics": (("R", "pose.R", 9), ("t, m", "pose.t", 3)),
    "axial_forces": (("axial forces, N", "axial", 6), ("L_dot, m/s", "L_dot", 6)),
    "motion_from_rpy": _TURNED,
    "motion_from_quaternion": _TURNED,
}
"""Printed numbers of functions that do not print all outputs: label, array, count."""
