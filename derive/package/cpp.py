"""C++ wrapper ``stewart.hpp``: the functions of a kit as C++17 classes, in one header.

The wrapper uses neither heap nor exceptions. It adds only types to the C code: statuses that must not be
ignored, arrays of fixed length, and constants that are prepared once. Methods have the arguments of the C
functions.
"""

import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..kernel.interface import Argument
from ..kernel.outputs import FORCES, OUTPUTS
from ..trace.constants import STATUSES
from .functions import DRIVES, MODEL, NOTHING, ROBOT, Function
from .text_format import template

_CLASSES = {
    ROBOT: "class_of_robot",
    MODEL: "class_of_model",
    DRIVES: "class_of_drives",
    NOTHING: "class_of_nothing",
}


def wrapper(functions: Sequence[Function], version: str) -> str:
    """Return ``stewart.hpp`` of a kit with these functions; ``version`` is the version of the generator.

    There is one class for each prepared model, for each header whose functions take a robot or its drives,
    and for each baked kernel. Each name in ``_ALIASES`` is an alias of the first class with one of its
    functions.
    """
    classes: dict[str, list[Function]] = {}
    for function in functions:
        classes.setdefault(_class_name(function), []).append(function)
    parts = {
        "version": version,
        "includes": "\n".join(f'#include "{name}"' for name in dict.fromkeys(f.header for f in functions)),
        "statuses": "\n".join(
            f"    {name.lower()} = STEWART_{name}, // {text}" for name, _, text in STATUSES
        ),
        "texts": "\n".join(
            f'    case status::{name.lower()}:\n        return "{text}";' for name, _, text in STATUSES
        ),
        "classes": "\n".join(_class(name, members) for name, members in classes.items()),
        "aliases": "\n".join(_aliases(classes)),
    }
    return template("kit/stewart.hpp", parts)


def _class_name(function: Function) -> str:
    """Return a class name that contains the kernel, so that a program may contain two kits."""
    if function.subject == MODEL:
        return f"{_short(function.prefix)}_kernel"
    if function.subject == NOTHING and function.stem == "forces":
        return f"{_short(function.symbol).removesuffix(f'_{function.stem}')}_kernel"
    return f"{_short(function.header.removesuffix('.h'))}_functions"


def _short(name: str) -> str:
    return name.removeprefix("stewart_")


def _class(name: str, functions: Sequence[Function]) -> str:
    first = functions[0]
    methods = "\n".join(text for function in functions for text in _methods(function))
    values = {"name": name, "prefix": first.prefix, "methods": methods}
    return template(f"kit/{_CLASSES[first.subject]}.hpp", values)


def _methods(function: Function) -> Iterable[str]:
    """Yield a method, a second one with optional arguments, and the batch methods of forces."""
    arguments = function.call.arguments
    yield _method(function, [each for each in arguments if not each.optional], arguments)
    if any(each.optional for each in arguments):
        yield _method(function, arguments, arguments)
    if function.stem == "forces" and function.batch:
        yield template("kit/batch.hpp", _call(function))


def _call(function: Function) -> dict[str, str]:
    checked = template("kit/prepared.hpp") if function.subject == MODEL else ""
    return {
        "symbol": function.symbol,
        "prepared": checked,
        "subject": function.subject_argument("robot_", "&model_", "drives_"),
    }


def _method(function: Function, taken: Sequence[Argument], arguments: Sequence[Argument]) -> str:
    """Return a method with the arguments ``taken``; it passes nullptr for the others."""
    name = "operator()" if function.stem == "forces" else function.stem.removeprefix("motion_")
    named = {each: replace(each, name=_name(each, name)) for each in arguments}
    parameters = ", ".join(_parameter(named[each]) for each in taken)
    says = textwrap.wrap(function.call.says, 100, break_long_words=False, break_on_hyphens=False)
    return template(
        "kit/method.hpp",
        _call(function)
        | {
            "says": "\n    // ".join(says),
            "name": name,
            "parameters": f"\n        {parameters}" if len(parameters) > 60 else parameters,
            "arguments": ", ".join(
                _handed(named[each]) if each in taken else "nullptr" for each in arguments
            ),
        },
    )


def _name(argument: Argument, method: str) -> str:
    """Return the name of an argument in C, or "found" if it is the method or the class ``out``."""
    return "found" if argument.name in (method, "out") else argument.name


def _parameter(argument: Argument) -> str:
    if argument.struct:
        return f"{'' if argument.written else 'const '}stewart_{argument.struct} &{argument.name}"
    (array,) = argument.takes or argument.gives
    return f"{'out' if argument.written else 'in'}<{array.count}> {argument.name}"


def _handed(argument: Argument) -> str:
    return f"&{argument.name}" if argument.struct else f"{argument.name}.data()"


def _aliases(classes: dict[str, list[Function]]) -> Iterable[str]:
    """Yield an alias of the first class that has one of the functions."""
    for alias, stems in _ALIASES.items():
        for name, functions in classes.items():
            if any(function.stem in stems for function in functions):
                yield f"using {alias} = {name};"
                break


_ALIASES = {
    "forces_kernel": ("forces",),
    "motion_kernel": tuple(each for each in OUTPUTS if each != FORCES),
    "reactions_kernel": ("inverse_dynamics", "joint_reactions"),
    "kinematics_kernel": ("inverse_kinematics", "forward_kinematics", "forward_velocity"),
    "axial_kernel": ("axial_forces",),
    "torque_kernel": ("motor_torques",),
}
