"""XML as elements: read without entities, external files or endless depth, and written with one header."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection, Mapping
from typing import Any
from xml.parsers import expat

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array

HEADER = "<?xml version='1.0' encoding='utf-8'?>\n<!-- Written by stewart-sym export -->\n"
"""First lines of every XML file that is written."""

TENSOR = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
"""Places of a symmetric tensor's numbers, by their names in SDF and URDF."""

NO_LIMIT = 1e16
"""A limit of this size in SDF and URDF, which need some, is none."""
_DEEPEST = 100
_NAMED = re.compile(r"(\w+) '([^']+)'")
_TAGS = {"body": "link", "link": "body"}


class Located(ET.Element):
    """An element that says in which line of its file it begins."""

    line = 0


def parsed(text: str) -> ET.Element:
    """The root of a document, of elements with their lines.

    Raises ValueError for what is no XML, is nested too deeply or declares a document type: entities, which
    can grow without bound or name other files, come from there alone.
    """
    if not text.strip():
        raise ValueError("expected XML, the file is empty")
    if text.lstrip().startswith(("#usda", "PXR-USDC")):
        raise ValueError("expected MJCF, SDF or URDF, got USD, which is exported but not read")
    if not text.lstrip().startswith("<"):
        raise ValueError(f"not valid XML: expected an element, got {shown(text.lstrip()[:40])}")
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
    """Line of the element that a message names first, as in ``joint 'x'``; None where it names none."""
    for kind, name in _NAMED.findall(text):
        found = [each for each in root.iter() if each.get("name") == name]
        exact = [each for each in found if each.tag in (kind, _TAGS.get(kind))]
        if found:
            return getattr((exact or found)[-1], "line", None)
    return None


def document(root: ET.Element) -> str:
    """Indented text of a document with a newline at its end."""
    ET.indent(root, " ")
    return HEADER + ET.tostring(root, encoding="unicode") + "\n"


def added(parent: ET.Element, tag: str, text: object = None, /, **attributes: object) -> ET.Element:
    """A new last element with a text and attributes; those that are None are left out."""
    given = {name: spelled(each) for name, each in attributes.items() if each is not None}
    element = ET.SubElement(parent, tag, given)
    if text is not None:
        element.text = spelled(text)
    return element


def spelled(value: Any) -> str:
    """A text, a number or numbers with all their digits."""
    if isinstance(value, str):
        return value
    return " ".join(repr(float(number) + 0.0) for number in np.ravel(value))


def numbers(text: str | None, count: int, where: str, default: Any = None, finite: bool = True) -> Array:
    """Numbers of a text, (count,); ``default`` where there is none, ValueError without one."""
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
    """A symmetric tensor, (3, 3), of its numbers by name; ``default``: on the diagonal and beside it."""
    found = np.zeros((3, 3))
    for key, (i, j) in TENSOR.items():
        missing = None if default is None else default[i != j]
        found[i, j] = found[j, i] = number(given(key), f"{where}: {key}", missing)
    return found


def number(text: str | None, where: str, default: float | None = None) -> float:
    """One number, as ``numbers``."""
    return float(numbers(text, 1, where, None if default is None else [default])[0])


def joint_of(element: ET.Element, kinds: Collection[str]) -> tuple[str, str, str]:
    """Name and type of a joint, and how errors call it; ValueError for a type that is none of ``kinds``."""
    name, kind = element.attrib["name"], element.get("type", "")
    where = f"joint {name!r}"
    if kind not in kinds:
        raise ValueError(f"{where}: expected type {', '.join(kinds)}, got {kind!r}")
    return name, kind, where


def interval(low: str | None, high: str | None, where: str) -> tuple[float, float]:
    """Limits on both sides; infinite where there is none, as one of ``NO_LIMIT`` says."""
    found = [
        float(numbers(text, 1, f"{where}: {name}", default, finite=False)[0])
        for text, name, default in ((low, "lower", [-NO_LIMIT]), (high, "upper", [NO_LIMIT]))
    ]
    least, most = (each if abs(each) < NO_LIMIT else math.copysign(math.inf, each) for each in found)
    return least, most


def largest(text: str | None, where: str) -> float:
    """A limit of a size; infinite where there is none: not stated, of ``NO_LIMIT``, 0 or negative."""
    found = float(numbers(text, 1, where, [NO_LIMIT], finite=False)[0])
    return found if 0.0 < found < NO_LIMIT else math.inf


def turn_limits(limits: Any, joint: str) -> list[str]:
    """What is left out where the angle of a joint has limits, rad, (2,); those of a robot are of its legs."""
    low, high = limits
    return [f"limits {low:.4g} to {high:.4g} rad of {joint}"] if np.isfinite([low, high]).any() else []


def no_limits(given: Mapping[str, str | None], joint: str) -> list[str]:
    """What is left out where limits of a drive are 0, by their names: ``largest`` takes them for none."""
    return [
        f"limit {key} 0, taken as none, of {joint}"
        for key in ("effort", "velocity")
        if not numbers(given.get(key), 1, f"{joint}: {key}", [NO_LIMIT], finite=False).any()
    ]


def at_line(element: ET.Element) -> str:
    """`` at line N``, of an element that a file has."""
    line = getattr(element, "line", 0)
    return f" at line {line}" if line else ""


def name_of(element: ET.Element, where: str) -> str:
    """Attribute ``name``; ValueError without one."""
    found = element.get("name")
    if not found:
        raise ValueError(f"{where}: {element.tag}{at_line(element)}: expected a name, got none")
    return found
