"""The pages of help agree with the program: statuses, messages, extras, and terms."""

import ast
import re
import tomllib
from collections.abc import Iterator

import pytest
from pages import DOCS, TOP

from stewart_sym.derive.kernel.tree.constants import STATUSES
from stewart_sym.results import STATUS_TEXT

TROUBLES = (DOCS / "troubleshooting.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| `([^`]+)` \|", re.MULTILINE)
TERMS = """Gough-Stewart platform; parallel robot; 6-UPS; 6-SPS; end-effector; degree of freedom; inverse
kinematics; direct kinematics; forward kinematics; assembly mode; Jacobian; inverse Jacobian;
wrench; twist; mass matrix; bias; Coriolis matrix; gravity wrench; inverse dynamics; forward
dynamics; constant-orientation workspace; orientation workspace; total orientation workspace;
reachable workspace; dextrous workspace; isotropy; dexterity; condition number; manipulability;
singularity; base parameters; calibration; excitation trajectory; computed torque; feedforward;
reference trajectory; via point; path parameterization; continuous torque; peak torque; backlash;
kit; block; kernel; schedule; fidelity level; formulation; reference point; tool; bake; status"""


def section(title: str) -> str:
    """Return the text below a heading of the page."""
    (text,) = re.findall(rf"^## {title}\n(.*?)(?=^## |\Z)", TROUBLES, re.MULTILINE | re.DOTALL)
    return str(text)


def texts() -> Iterator[str]:
    """Yield every text of the program, adjacent pieces joined."""
    for path in (TOP / "stewart_sym").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.JoinedStr):
                yield "".join(str(part.value) for part in node.values if isinstance(part, ast.Constant))
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value


def test_every_status_is_explained() -> None:
    rows = re.findall(r"^\| (\d) \| (\S+)", section("Status of a pose"), re.MULTILINE)
    assert [int(code) for code, _ in rows] == sorted(STATUS_TEXT)
    names = dict(rows)
    assert all(names[str(code)].strip("`").endswith(name) for name, code, _ in STATUSES)


@pytest.mark.parametrize(
    ("title", "count"),
    [
        ("Installation messages", 4),
        ("Robot file messages", 7),
        ("Trajectory messages", 7),
        ("Messages of computations", 5),
    ],
)
def test_messages_are_those_of_the_program(title: str, count: int) -> None:
    program = "\n".join(texts())
    found = ROW.findall(section(title))
    assert len(found) == count
    pieces = [piece for message in found for piece in message.split("...") if piece]
    assert [piece for piece in pieces if piece not in program] == []


def test_every_extra_is_explained() -> None:
    page = (DOCS / "installation.md").read_text(encoding="utf-8")
    project = tomllib.loads((TOP / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    (table,) = re.findall(r"^\| extra \|.*?\n\n", page, re.MULTILINE | re.DOTALL)
    assert set(ROW.findall(table)) == set(project["optional-dependencies"])


def test_the_glossary_has_every_term_of_the_field() -> None:
    page = (DOCS / "glossary.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```\{glossary\}\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    terms = {line for block in blocks for line in block.splitlines() if line and not line.startswith(" ")}
    assert {" ".join(term.split()) for term in TERMS.split(";")} - terms == set()
