"""Who may know whom: imports as the source states them, against the house rules of the design."""

import ast
import graphlib
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import stewart_sym as package

REPOSITORY = Path(__file__).parent.parent
PACKAGE = "stewart_sym"
FOLDERS = {PACKAGE: PACKAGE, "derive": f"{PACKAGE}.derive", "generated": f"{PACKAGE}.generated"}

# Every module of the runtime by floor, lowest first: one imports from its own floor or from those below it.
FLOORS = (
    {
        "blas",
        "chart",
        "checks",
        "extras",
        "faults",
        "frozen",
        "interrupts",
        "logs",
        "log_faults",
        "publish",
        "results",
        "rotation",
        "search",
        "smoothing",
        "tables",
        "generated",
    },
    {"robot", "motion", "native"},
    {
        "robots",
        "reference",
        "reference_equations",
        "conditioning",
        "kinematics",
        "smooth_motion",
        "leg_steps",
        "mounting",
        "trajectory",
        "kernel",
        "damping",
    },
    {"forward", "fidelity", "certificate", "interpolation", "singular_poses", "units", "paths"},
    {"dynamics", "forces", "force_noise", "passage"},
    {"closed_form", "bounds", "joint_space", "arrays", "typesetting", "trees"},
    {"symbols"},
    {"equations", "laws", "casadi_functions"},
    {"simulation", "fixed_step"},
    {"scene", "budget"},
    {"parameters", "home"},
    {"identifiable", "plausibility"},
    {"excitation", "physical"},
    {"identification"},
    {"studies", "kit"},
    {"cli"},
    {"__main__"},
)
GENERATE_ON_COMMAND = {
    f"{PACKAGE}.{name}"
    for name in (
        "casadi_functions",
        "cli",
        "symbols",
        "trees",
        "kit.files",
        "kit.languages",
        "kit.fmu",
        "kit.parts",
        "kit.readings",
        "kit.selection",
        "kit.sensitivity",
        "kit.vectors",
        "studies.bench_passes",
        "studies.controller.measure",
        "studies.truth",
    )
}


def sources() -> dict[str, Path]:
    """Every module of the package by its import name."""
    found = {}
    for folder, name in FOLDERS.items():
        for path in sorted((REPOSITORY / folder).rglob("*.py")):
            parts = path.relative_to(REPOSITORY / folder).with_suffix("").parts
            found[".".join([name, *parts]).removesuffix(".__init__")] = path
    return found


SOURCES = sources()


@cache
def imports(module: str, only_top: bool = False) -> frozenset[str]:
    """Modules that a module imports, absolute; ``only_top``: when it is imported, not when it runs."""
    return frozenset(name for node in statements(module, only_top) for name in targets(module, node))


def statements(module: str, only_top: bool = False) -> Iterator[ast.Import | ast.ImportFrom]:
    waiting: list[ast.AST] = [ast.parse(SOURCES[module].read_text(encoding="utf-8"))]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        if not (only_top and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)):
            waiting.extend(ast.iter_child_nodes(node))


def targets(module: str, node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
        return
    base = node.module or ""
    if node.level:
        package = module if SOURCES[module].name == "__init__.py" else module.rpartition(".")[0]
        for _ in range(node.level - 1):
            package = package.rpartition(".")[0]
        base = f"{package}.{base}".rstrip(".")
    for alias in node.names:
        submodule = f"{base}.{alias.name}"
        yield submodule if submodule in SOURCES else base


def outside(name: str) -> str:
    """The top package of an import, or "" for what Python itself brings."""
    top = name.partition(".")[0]
    return "" if top in sys.stdlib_module_names else top


def below(prefix: str) -> list[str]:
    return [name for name in SOURCES if name == prefix or name.startswith(f"{prefix}.")]


def floor(module: str) -> int:
    room = module.split(".")[1]
    found = [number for number, rooms in enumerate(FLOORS) if room in rooms]
    assert found, f"{module}: put it on a floor"
    return found[0]


def runtime() -> list[str]:
    derive = set(below(f"{PACKAGE}.derive"))
    return [name for name in SOURCES if name != PACKAGE and name not in derive]


@pytest.mark.parametrize(("room", "library"), [("derive", ("sympy", "mpmath")), ("generated", ("numpy",))])
def test_derive_and_generated_know_one_library_and_themselves(room: str, library: tuple[str, ...]) -> None:
    """SymPy brings mpmath, in which it computes numbers."""
    for module in below(f"{PACKAGE}.{room}"):
        for name in imports(module):
            at_home = name.startswith(f"{PACKAGE}.{room}")
            assert at_home or outside(name) in ("", *library), f"{module} imports {name}"


def test_the_reference_shares_nothing_with_what_it_checks() -> None:
    allowed = {f"{PACKAGE}.{name}" for name in ("robot", "motion", "results", "rotation")}
    oracles = {f"{PACKAGE}.reference", f"{PACKAGE}.reference_equations"}
    for oracle in sorted(oracles):
        for name in imports(oracle):
            known = name in allowed | oracles or outside(name) in ("", "numpy", "mpmath")
            assert known, f"{oracle} imports {name}"


def test_only_commands_know_the_derivation_and_the_command_line_asks_for_it_when_it_runs() -> None:
    for module in runtime():
        derivation = [name for name in imports(module) if name.startswith(f"{PACKAGE}.derive")]
        assert not derivation or module in GENERATE_ON_COMMAND, f"{module} imports {derivation}"
    assert any(name.startswith(f"{PACKAGE}.derive") for name in imports(f"{PACKAGE}.cli"))
    for module in (
        f"{PACKAGE}.cli",
        *(f"{PACKAGE}{name}" for name in sorted(set(package._public().values()))),
    ):
        reached = reachable(module)
        assert not [name for name in reached if name.startswith(f"{PACKAGE}.derive")], module
        assert not {"sympy", "scipy", "matplotlib"} & {outside(name) for name in reached}, module


def reachable(module: str) -> set[str]:
    """All that importing a module imports."""
    found, waiting = set(), [module]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting.extend(imports(name, only_top=True) if name in SOURCES else ())
    return found


def test_nobody_imports_from_a_floor_above() -> None:
    for module in runtime():
        for name in imports(module):
            if name.startswith(f"{PACKAGE}.") and not name.startswith(f"{PACKAGE}.derive"):
                assert floor(name) <= floor(module), f"{module} imports {name}"
            assert name != PACKAGE, f"{module} imports the package that holds it"


def test_imports_run_in_no_circles() -> None:
    graph = {module: imports(module) & SOURCES.keys() - {module} for module in SOURCES}
    list(graphlib.TopologicalSorter(graph).static_order())


def test_the_package_names_its_own_modules_relatively() -> None:
    absolute = [
        f"{module}: {name}"
        for module in SOURCES
        for node in statements(module)
        if isinstance(node, ast.Import) or node.level == 0
        for name in targets(module, node)
        if name.partition(".")[0] == PACKAGE
    ]
    assert not absolute
