"""Imports as the source states them; who may import whom is in the contracts of pyproject.toml."""

import ast
import graphlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import stewart_sym as package

REPOSITORY = Path(__file__).parents[2]
PACKAGE = "stewart_sym"
FOLDERS = {PACKAGE: PACKAGE, "derive": f"{PACKAGE}.derive", "generated": f"{PACKAGE}.generated"}


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


@cache
def statements(module: str, only_top: bool = False) -> list[ast.Import | ast.ImportFrom]:
    found = []
    waiting: list[ast.AST] = [ast.parse(SOURCES[module].read_text(encoding="utf-8"))]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            found.append(node)
        if not (only_top and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)):
            waiting += [each for each in ast.iter_child_nodes(node) if not isinstance(each, ast.expr)]
    return found


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


def reachable(module: str) -> set[str]:
    """All that importing a module imports."""
    found, waiting = set(), [module]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting.extend(imports(name, only_top=True) if name in SOURCES else ())
    return found


def test_what_is_imported_at_once_is_numpy_alone() -> None:
    """The derivation, SymPy, SciPy and Matplotlib are imported by what needs them, when it runs."""
    for module in (
        f"{PACKAGE}.cli.main",
        *(f"{PACKAGE}{name}" for name in sorted(set(package._public().values()))),
    ):
        reached = reachable(module)
        assert not [name for name in reached if name.startswith(f"{PACKAGE}.derive")], module
        assert not {"sympy", "scipy", "matplotlib"} & {name.partition(".")[0] for name in reached}, module


def test_imports_run_in_no_circles() -> None:
    graph = {module: imports(module) & SOURCES.keys() - {module} for module in SOURCES}
    list(graphlib.TopologicalSorter(graph).static_order())


def test_the_package_names_its_own_modules_relatively() -> None:
    absolute = [
        f"{module}: {name}"
        for module in SOURCES
        for node in statements(module, False)
        if isinstance(node, ast.Import) or node.level == 0
        for name in targets(module, node)
        if name.partition(".")[0] == PACKAGE
    ]
    assert not absolute
