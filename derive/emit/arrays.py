"""Python array modules of ``generated/``, and the parts that they share with kits in Python."""

from collections.abc import Collection, Mapping
from dataclasses import replace

import sympy as sp

from ..kernel.inverse_dynamics import arrays_program, regressor_program, rotor_program, shared_program
from ..kernel.operations import KernelOperations, force_operations
from ..mechanics import quantities as n
from ..mechanics.actuator_forces import ForceKernel
from ..mechanics.inverse_dynamics import Kernel
from ..mechanics.legs.rotor import NONE
from ..mechanics.reduced_models import Fidelity
from ..mechanics.regressor import LEG_PARAMETERS, PLATFORM_PARAMETERS, Regressor, dependencies, names_of
from ..print.c import C
from ..print.python import Python
from ..print.spelling import WIDTH
from ..print.template import filled
from ..program.block import Block, Quantity, component_name
from ..trace import nodes as t
from ..trace.constants import NAMES, PRECISIONS, STATUS, constants
from ..trace.lower import expression
from .inverse_dynamics import operations_table, wrap_list

Counts = Mapping[str, KernelOperations]
"""Operations for "friction" and, if the kernel is compared with the paper's program, "frictionless"."""


def every_output(kernel: Kernel, counts: Counts, force_counts: Counts, version: str) -> str:
    """Return ``<kernel>.py``, with the operations of this kernel and of the kernel of the forces."""
    program = arrays_program(kernel)
    return filled(
        "every_output.py",
        name=kernel.formulation.kernel_name,
        version=version,
        operations=operations_table(counts["friction"], counts.get("frictionless"), ""),
        imported=_imported(program, {"every_output": _shared_names()}),
        table=_operations("OPERATIONS", counts),
        force_table=_operations("FORCE_OPERATIONS", force_counts),
        program=_own(program),
    )


def shared_module(version: str) -> str:
    """Return ``every_output.py``, the common part of the modules of inverse dynamics."""
    program = shared_program()
    source = Python(program).source().rstrip()
    return filled("shared_outputs.py", version=version, imported=imported(program), program=source)


def _own(program: t.Program) -> str:
    """Print the program without the common part."""
    return Python(program).source(_shared_names()).rstrip()


def _imported(program: t.Program, shared: Mapping[str, set[str]], public: Collection[str] = ()) -> str:
    """Print the imports of a program from shared modules; ``public`` names are imported for callers."""
    taken = set().union(*shared.values())
    parts = [part for name, part in _by_name(program).items() if name not in taken]
    functions = tuple(each for each in parts if isinstance(each, t.Function))
    used = {name for each in parts for name in _needed(each)}.union(public)
    lines = [imported(replace(program, functions=functions))]
    for module, held in shared.items():
        names = ", ".join(
            f"{each} as {each}" if each in public else each for each in sorted(used.intersection(held))
        )
        line = f"from .{module} import {names}"
        wrapped = f"from .{module} import (\n{wrap_list(f'    {names},', '    ')}\n)"
        lines.append(line if len(line) <= WIDTH else wrapped)
    return "\n".join(lines)


def _needed(part: t.Structure | t.Function) -> set[str]:
    """Return the names that a part of a program requires.

    These are structures that it creates or by which it checks its arguments, and functions that it calls.
    """
    public = isinstance(part, t.Function) and part.public
    kinds = t.Variable | t.Field | t.Argument if public else t.Variable | t.Field
    made = (each for each in t.parts_of(part) if isinstance(each, kinds))
    return {each.name for of in made for each in t.parts_of(of.type) if isinstance(each, t.Record)} | {
        each.function for each in t.calls_in(part)
    }


def _by_name(program: t.Program) -> dict[str, t.Structure | t.Function]:
    parts: tuple[t.Structure | t.Function, ...] = (*program.structures, *program.functions)
    return {each.name: each for each in parts}


def alike(program: t.Program, base: t.Program) -> set[str]:
    """Return the names that two programs have in common, including everything that these names require."""
    own, known = map(_by_name, (program, base))
    found = {name for name, part in own.items() if known.get(name) == part}
    needed = {name: _needed(own[name]).intersection(own) for name in found}
    while lost := {name for name in found if not needed[name] <= found}:
        found -= lost
    return found


def _shared_names() -> set[str]:
    return set(_by_name(shared_program()))


def regressor(blocks: Regressor, version: str) -> str:
    """Return ``exact_regressor.py``."""
    program = regressor_program(blocks)
    return filled(
        "regressor.py",
        version=version,
        imported=_imported(program, {"every_output": _shared_names()}),
        leg_parameters=_literal("LEG_PARAMETERS", LEG_PARAMETERS),
        platform_parameters=_literal("PLATFORM_PARAMETERS", PLATFORM_PARAMETERS),
        dependent=_rows("DEPENDENT", [f'"{name}"' for name in dependencies()]),
        formulas=_rows("MERGED", [f'("{base}", "{text}")' for base, text in merged()]),
        program=_own(program),
    )


def rotor_regressor(columns: Block, version: str) -> str:
    """Return ``rotor_regressor.py``."""
    program = rotor_program(columns)
    parameters = _literal("PARAMETERS", n.ROTOR)
    return filled("rotor_regressor.py", version=version, parameters=parameters, program=_own(program))


def arithmetic(numbers: Mapping[str, tuple[int, str]] = STATUS) -> str:
    """Return status codes, constants, and the class ``Arithmetic`` of array modules."""
    found = {name: constants(name) for name in PRECISIONS}
    return filled(
        "arithmetic.py",
        statuses="\n".join(f"{name} = {code}  # {says}" for name, (code, says) in numbers.items()),
        constants="\n".join(f"    {name!r}: {values!r}," for name, values in found.items()),
        declared="\n".join(f"    {name}: float" for name in NAMES),
    )


def module(program: t.Program, names: str, version: str, without: Collection[str] = ()) -> str:
    """Return a program as an array module.

    Parameters
    ----------
    names : str
        Text that defines or imports the names of ``arithmetic``.
    without : collection of str
        Structures and functions to omit.
    """
    has_pose = any(each.name == "Pose" for each in program.structures)
    return filled(
        "arrays.py",
        arithmetic=names,
        program=Python(program).source(without),
        version=version,
        poses=filled("pose.py") if has_pose else "",
    )


def module_beside(bases: Mapping[str, t.Program], program: t.Program, version: str) -> str:
    """Return a program as a module that imports common parts from the first module that contains them."""
    shared: dict[str, set[str]] = {}
    for name, base in bases.items():
        shared[f"{name}_arrays"] = alike(program, base).difference(*shared.values())
    public = ["Robot", *(each.name for each in program.functions if each.public)]
    return module(program, _imported(program, shared, public), version, set().union(*shared.values()))


def imported(program: t.Program) -> str:
    """Return the import of the names that a program requires from the common module."""
    named = {each.name for each in t.parts_of(program.functions) if isinstance(each, t.Constant)}
    return f"from .arithmetic import {', '.join([*sorted(named & STATUS.keys()), 'Arithmetic'])}"


def merged() -> list[tuple[str, str]]:
    """Return base parameters with their formulas in other parameters; ``sum`` is a sum over the legs."""
    own = names_of(PLATFORM_PARAMETERS)
    formulas: dict[str, str] = {}
    for lost, shares in dependencies().items():
        for base, share in shares.items():
            text = C().text(expression(sp.Symbol(lost, real=True) * share))
            formulas[base] = f"{base} + {f'sum({text})' if base in own else text}"
    return list(formulas.items())


def _operations(name: str, both: Counts) -> str:
    lines = [f"{name}: dict[str, dict[str, tuple[int, int, int, int]]] = {{"]
    for label, counts in both.items():
        lines.append(f'    "{label}": {{')
        for part, count in counts.parts().items():
            lines.append(f'        "{part}": ({count.mul}, {count.add}, {count.div}, {count.sqrt}),')
        lines.append("    },")
    return "\n".join([*lines, "}"])


def _literal(name: str, parameters: tuple[Quantity, ...]) -> str:
    return _rows(
        name, [f'("{component_name(q.name, key)}", "{q.unit}")' for q in parameters for key in q.keys]
    )


def _rows(name: str, rows: list[str]) -> str:
    return "\n".join([f"{name} = (", *(f"    {row}," for row in rows), ")"])


def fidelities(kernels: Mapping[Fidelity, ForceKernel], version: str) -> str:
    """Return ``fidelities.py``, the table of reduced force kernels for the runtime."""
    plain, drive = (
        "\n".join(
            _fidelity(level, kernel) for level, kernel in kernels.items() if (level.rotor != NONE) == rotors
        )
        for rotors in (False, True)
    )
    return filled("fidelities.py", version=version, entries=plain, drive=drive)


def _fidelity(level: Fidelity, kernel: ForceKernel) -> str:
    counts = {part: count.total for part, count in force_operations(kernel).parts().items()}
    values = {
        "kernel": f'"{kernel.name}"',
        "meaning": f'"{level.meaning}"',
        "universal": n.k in kernel.leg_constants(),
    }
    lines = "\n".join(f'        "{name}": {value},' for name, value in values.items())
    parts = ", ".join(f'"{part}": {count}' for part, count in counts.items())
    operations = wrap_list(f"{' ' * 12}{parts},", " " * 12)
    return f'    "{level.name}": {{\n{lines}\n        "operations": {{\n{operations}\n        }},\n    }},'
