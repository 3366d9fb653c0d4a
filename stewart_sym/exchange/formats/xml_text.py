"""XML input without entities, external files, or deep nesting, and XML output with a fixed header."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from typing import Any
from xml.parsers import expat

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array
from ..model import Joint

HEADER = "<?xml version='1.0' encoding='utf-8'?>\n<!-- Written by stewart-sym export -->\n"
"""First lines of every XML file that is written."""

TENSOR = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
"""Indices of the elements of a symmetric tensor, by their names in SDF and URDF."""

NO_LIMIT = 1e16
"""Value that represents no limit in SDF and URDF, which require limits."""
CONTACTS = "contacts of shapes, which may limit the motion"
"""Message about shapes that can touch each other."""
_DEEPEST = 100
_NAMED = re.compile(r"(\w+) '([^']+)'")
_TAGS = {"body": "link", "link": "body"}


class Located(ET.Element):
    """Element with the number of its first line in the file."""

    line = 0


def parsed(text: str) -> ET.Element:
    """Parse a document to elements with line numbers.

    Raises
    ------
    ValueError
        If the text is not XML, is nested too deeply, or contains a document type declaration. Only document
        types define entities, which can grow without bound or refer to other files.
    """
    if not text.strip():
        raise ValueError("expected XML, the file is empty")
    if text.lstrip().startswith(("#usda", "PXR-USDC")):
        raise ValueError("expected MJCF, SDF, or URDF, got USD, which is exported but not read")
    if not text.lstrip().startswith("<"):
        raise ValueError(
            f"expected MJCF, SDF, or URDF, got text that begins with {shown(text.lstrip()[:40])}"
        )
    builder, parser, depth = ET.TreeBuilder(Located), expat.ParserCreate("utf-8"), 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > _DEEPEST:
            raise ValueError(f"line {parser.CurrentLineNumber}: element {shown(tag)}: nested too deeply")
        builder.start(tag, attributes).line = parser.CurrentLineNumber  # type: ignore[attr-defined]

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag)

    def doctype(name: str, *_: object) -> None:
        where = f"line {parser.CurrentLineNumber}"
        raise ValueError(
            f"{where}: expected XML without a document type declaration, got one of {shown(name)}"
        )

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = builder.data, doctype
    try:
        parser.Parse(text.encode("utf-8", "surrogatepass"), True)
    except expat.ExpatError as error:
        raise ValueError(f"not valid XML: {error}") from None
    return builder.close()


def line_named(text: str, root: ET.Element) -> int | None:
    """Return the line of the first element named in a message, as in ``joint 'x'``, or None."""
    for kind, name in _NAMED.findall(text):
        found = [each for each in root.iter() if each.get("name") == name]
        exact = [each for each in found if each.tag in (kind, _TAGS.get(kind))]
        if found:
            return getattr((exact or found)[-1], "line", None)
    return None


def document(root: ET.Element) -> str:
    """Return the indented text of a document with a newline at its end."""
    ET.indent(root, " ")
    return HEADER + ET.tostring(root, encoding="unicode") + "\n"


def added(parent: ET.Element, tag: str, text: object = None, /, **attributes: object) -> ET.Element:
    """Append an element with a text and attributes; attributes with the value None are omitted."""
    given = {name: spelled(each) for name, each in attributes.items() if each is not None}
    element = ET.SubElement(parent, tag, given)
    if text is not None:
        element.text = spelled(text)
    return element


def spelled(value: Any) -> str:
    """Convert a text, a number, or numbers to text with all digits."""
    if isinstance(value, str):
        return value
    return " ".join(repr(float(number) + 0.0) for number in np.ravel(value))


def numbers(text: str | None, count: int, where: str, default: Any = None, finite: bool = True) -> Array:
    """Return the numbers in a text, shape (count,), or ``default`` if the text is None.

    Raises
    ------
    ValueError
        If the text does not contain ``count`` numbers, or is None without a default.
    """
    if text is None and default is not None:
        return np.array(default, dtype=np.float64)
    expected = "a number" if count == 1 else f"{count} numbers"
    words = (text or "").split()
    try:
        found = np.array([float(word) for word in words])
    except ValueError:
        found = np.full(1, math.nan)
    bad = ~np.isfinite(found) if finite else np.isnan(found)
    if len(found) != count or np.any(bad):
        got = "nothing" if text is None else shown(text.strip())
        raise ValueError(f"{where}: expected {expected}, got {got}")
    return found


def tensor(
    given: Callable[[str], str | None], where: str, default: tuple[float, float] | None = None
) -> Array:
    """Return a symmetric tensor, (3, 3), from named elements; ``default`` is (diagonal, off-diagonal)."""
    found = np.zeros((3, 3))
    for key, (i, j) in TENSOR.items():
        missing = None if default is None else default[i != j]
        found[i, j] = found[j, i] = number(given(key), f"{where}: {key}", missing)
    return found


def number(text: str | None, where: str, default: float | None = None) -> float:
    """Return one number like ``numbers``."""
    return float(numbers(text, 1, where, None if default is None else [default])[0])


def joint_of(element: ET.Element, kinds: Mapping[str, str]) -> Joint:
    """Return a joint without bodies; raise ValueError for types not in ``kinds``."""
    name, kind = name_of(element, "joint"), element.get("type", "")
    if kind not in kinds:
        raise ValueError(f"joint {name!r}: expected type {', '.join(kinds)}, got {kind!r}")
    return Joint(name, kinds[kind], "", "")


def with_properties(joint: Joint, given: Callable[[str], str | None], left_out: list[str]) -> Joint:
    """Return a joint with damping, limits, and spring from the elements of SDF or URDF at its axis.

    Properties that a robot cannot represent are appended to ``left_out``.
    """
    where = f"joint {joint.name!r}"

    def value(path: str, default: float) -> float:
        text = given(path)
        return float(numbers(text, 1, f"{where}: {path.partition('/')[2]}", [default], finite=False)[0])

    friction, spring = value("dynamics/friction", 0.0), value("dynamics/spring_stiffness", 0.0)
    found = (("friction", friction), ("spring_stiffness", spring))
    left_out += [f"{key} {size:g} of {where}" for key, size in found if size]
    low, high = (value(f"limit/{key}", sign * np.inf) for key, sign in (("lower", -1.0), ("upper", 1.0)))
    low, high = (each if abs(each) < NO_LIMIT else math.copysign(math.inf, each) for each in (low, high))
    joint = replace(joint, damping=value("dynamics/damping", 0.0))
    turn = spring * value("dynamics/spring_reference", 0.0) * joint.axes[0]
    if joint.kind != "prismatic":
        left_out += turn_limits((low, high), where)
        return replace(joint, load=joint.load + np.append(np.zeros(3), turn))
    drive = {key: value(f"limit/{key}", NO_LIMIT) for key in ("effort", "velocity")}
    left_out += [f"limit {key} 0, taken as none, of {where}" for key, size in drive.items() if size == 0.0]
    effort, speed = (size if 0.0 < size < NO_LIMIT else math.inf for size in drive.values())
    load = np.append(turn, np.zeros(3))
    return replace(joint, limits=(low, high), effort=effort, speed=speed, load=load)


def ball_constraint(given: Callable[[str], str | None], i: int, links: Collection[str]) -> Joint:
    """Return the loop closure of a ball constraint of Drake, which has no name, from its elements."""
    where = f"ball_constraint {i}"
    one, other = (given(f"body_{end}") or "" for end in "AB")
    for link in (one, other):
        if link not in links:
            raise ValueError(f"{where}: link {link!r}: missing")
    here, there = (numbers(given(f"p_{key}"), 3, f"{where}: p_{key}") for key in ("AP", "BQ"))
    return Joint(f"ball_constraint_{i}", "spherical", one, other, there, cut=True, parent_point=here)


def turn_limits(limits: Any, joint: str) -> list[str]:
    """Return a message about limits (rad), shape (2,), of a rotary joint; a robot has leg limits only."""
    low, high = limits
    return [f"limits {low:.4g} to {high:.4g} rad of {joint}"] if np.isfinite([low, high]).any() else []


def others(element: ET.Element, known: Collection[str], where: str) -> list[str]:
    """Return messages about the elements in another one that are not known."""
    return [f"{tag} of {where}" for tag in dict.fromkeys(each.tag for each in element) if tag not in known]


def at_line(element: ET.Element) -> str:
    """Return `` at line N`` for an element of a file."""
    line = getattr(element, "line", 0)
    return f" at line {line}" if line else ""


def name_of(element: ET.Element, where: str) -> str:
    """Return the attribute ``name``; raise ValueError if it is missing."""
    found = element.get("name")
    if not found:
        raise ValueError(f"{where}: {element.tag}{at_line(element)}: expected a name, got none")
    return found
