"""The map of the tree and the recipes name folders, files and names that there are."""

import re
from pathlib import Path

import pytest
from pages import DOCS, PAGES, TOP, table_row

WHERE, CONTRIBUTING = ".docs/where.md", ".docs/contributing.md"
MAPPED = ("derive", "generated", "stewart_sym")
NO_FOLDER_OF_CODE = {"__pycache__", "templates", "kit"}
PATH = re.compile(r"`((?:derive|generated|stewart_sym|tests|\.docs|\.ci)/[\w./*-]*)`")
NAMED = re.compile(r"`(\w+)`,? (?:in|of) `([\w./]+\.\w+)`")


def folders() -> set[str]:
    """Folders of code, as the map names them."""
    found = {f"{name}/" for name in MAPPED}
    for name in MAPPED:
        for path in (TOP / name).rglob("*/"):
            if path.is_dir() and not NO_FOLDER_OF_CODE & set(path.relative_to(TOP / name).parts):
                found.add(f"{path.relative_to(TOP).as_posix()}/")
    return found | {"stewart_sym/kit/"}


def test_the_map_has_every_folder_and_no_other() -> None:
    rows = re.findall(r"^\| `([\w./]+/)` \|", (TOP / WHERE).read_text(encoding="utf-8"), re.MULTILINE)
    assert len(rows) == len(set(rows))
    assert {row for row in rows if row.split("/")[0] in MAPPED} == folders()
    assert all(table_row(WHERE, f"`{row}`")[0] for row in rows)


@pytest.mark.parametrize("page", PAGES)
def test_files_that_a_page_names_exist(page: str) -> None:
    named = PATH.findall((TOP / page).read_text(encoding="utf-8"))
    assert [path for path in named if not list(TOP.glob(path.rstrip("/")))] == []


@pytest.mark.parametrize("page", [WHERE, CONTRIBUTING])
def test_names_that_a_page_places_in_a_file_are_there(page: str) -> None:
    text = " ".join((TOP / page).read_text(encoding="utf-8").split())
    placed = NAMED.findall(text)
    assert len(placed) >= 2
    assert [(name, path) for name, path in placed if not defined(name, TOP / path)] == []


def defined(name: str, path: Path) -> bool:
    """Whether a file defines a name, at its top level or as a step of a block."""
    text = path.read_text(encoding="utf-8")
    return bool(re.search(rf'^(?:def {name}\(|class {name}\b|{name}\b.* = )|"{name}"', text, re.MULTILINE))


def test_the_map_answers_what_is_asked_first() -> None:
    (questions,) = re.findall(r"\| question \| answer \|\n(.*?)\n\n", (TOP / WHERE).read_text(), re.DOTALL)
    for words in ("equation (21)", "stewart_exact_forces.c", "status", "`choose-fidelity`", "add a robot"):
        assert words in questions
    assert "(21)" in (TOP / "derive/mechanics/legs/leg.py").read_text(encoding="utf-8")


def test_recipes_name_tests_that_there_are() -> None:
    text = (TOP / CONTRIBUTING).read_text(encoding="utf-8")
    for heading in ("Add a robot", "Add a reduced model", "Add an output", "Add a language"):
        (recipe,) = re.findall(rf"## {heading}\n(.*?)(?=\n## |\Z)", text, re.DOTALL)
        assert re.search(r"`tests/[\w/]+\.py`", recipe), heading
    assert "test_a_language_is_one_module_and_one_registration" in (
        TOP / "tests" / "kernel" / "test_kernel_tree.py"
    ).read_text(encoding="utf-8")


def test_the_readme_names_the_pages_for_contributors_and_of_changes() -> None:
    readme = (TOP / "README.md").read_text(encoding="utf-8")
    for page in (DOCS / "contributing.md", DOCS / "changelog.md"):
        assert page.exists()
        assert f"`{page.relative_to(TOP).as_posix()}`" in readme


def test_folders_have_at_most_14_modules_and_modules_500_lines() -> None:
    modules = [path for name in ("derive", "stewart_sym", "tests") for path in (TOP / name).rglob("*.py")]
    lines = {path: path.read_text(encoding="utf-8").count("\n") for path in modules}
    assert {str(path): count for path, count in lines.items() if count > 500} == {}
    inside = [path.parent for path in modules if path.name != "__init__.py"]
    assert {str(folder) for folder in inside if inside.count(folder) > 14} == set()
