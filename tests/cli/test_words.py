"""What users read, messages, reports, help and kits, has the field's words and none of our own."""

import ast
import re
from pathlib import Path

import pytest

import stewart_sym

PACKAGE = Path(stewart_sym.__file__).parent
PRIVATE = re.compile(
    r"\b(poles? of|near (the )?poles?|lost motion|refus(al|e|ed|es)|checked?|study|contestants?|subcommand|no answer"
    r"|without an answer|knows nothing|stands? (beside|above)|walks? into|(three|of) degrees of freedom"
    r"|what is left|alike all round|baselines|can be told|keeps? (its|their) bits)\b"
)
# One of these makes a string a name for programs: a key of JSON, an identifier.
NAMES = {"baselines"}


def texts(module: Path) -> list[str]:
    """String constants of a module that are no docstrings."""
    tree = ast.parse(module.read_text(encoding="utf-8"))
    alone = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    strings = (node for node in ast.walk(tree) if isinstance(node, ast.Constant) and id(node) not in alone)
    return [node.value for node in strings if isinstance(node.value, str)]


def shipped(*endings: str) -> list[Path]:
    """Files of the package, the derivation and the generated code among them."""
    roots = [PACKAGE, *(Path(path) for name in ("derive", "generated") for path in folder_of(name))]
    found = {path for root in roots for ending in endings for path in root.rglob(f"*{ending}")}
    return sorted(path for path in found if "studies" not in path.parts or path.suffix == ".py")


def folder_of(name: str) -> list[str]:
    """Folders of a subpackage, wherever an editable installation has it."""
    return list(__import__(f"stewart_sym.{name}", fromlist=["__path__"]).__path__)


def test_no_message_report_or_help_has_a_private_word() -> None:
    found = [
        f"{path.name}: {text}"
        for path in shipped(".py")
        for text in texts(path)
        if text not in NAMES and PRIVATE.search(text)
    ]
    assert found == []


@pytest.mark.parametrize("ending", [".in", ".c", ".h", ".cmake"])
def test_no_template_of_a_kit_and_no_generated_text_has_a_private_word(ending: str) -> None:
    lines = [
        f"{path.name}: {line.strip()}"
        for path in shipped(ending)
        for line in path.read_text(encoding="utf-8").splitlines()
        if PRIVATE.search(line)
    ]
    assert lines == []
