"""XML input with line numbers, and XML output with a fixed header."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable, Collection
from typing import Any
from xml.parsers import expat

import numpy as np

from ...io.arguments import shown
from ...io.array_types import Array

HEADER = "<?xml version='1.0' encoding='utf-8'?>\n<!-- Written by stewart-sym export -->\n"
"""First lines of every XML file that is written."""

Leaf = Callable[..., ET.Element]
"""Function that appends an element with values: ``added`` as attributes, ``leaves`` as child elements."""

TENSOR = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
"""Indices of the elements of a symmetric tensor, by their names in SDF and URDF."""

NO_LIMIT = 1e16
"""Value that represents no limit in SDF and URDF, which require limits."""
CONTACTS = "contacts of shapes, which may limit the motion"
"""Message about shapes that can touch each other."""
_NAMED = re.compile(r"(\w+) '([^']+)'")
_TAGS = {"body": "link", "link": "body"}


class Located(ET.Element):
    """Element with the number of its first line in the file."""

    line = 0


def parsed(text: str) -> ET.Element:
    """Parse a document to elements with line numbers; raise ValueError if the text is not XML."""
    if not text.strip():
        raise ValueError("expected XML, the file is empty")
    if text.lstrip().startswith(("#usda", "PXR-USDC")):
        raise ValueError("expected MJCF, SDF, or URDF, got USD, which is exported but not read")
    builder, parser = ET.TreeBuilder(Located), expat.ParserCreate("utf-8")

    def start(tag: str, attributes: dict[str, str]) -> None:
        builder.start(tag, attributes).line = parser.CurrentLineNumber  # type: ignore[attr-defined]

    parser.StartElementHandler, parser.EndElementHandler = start, builder.end
    parser.CharacterDataHandler = builder.data
    try:
        parser.Parse(text.encode("utf-8", "surrogatepass"), True)
    except expat.ExpatError as error:
        raise ValueError(f"expected MJCF, SDF, or URDF, got no valid XML: {error}") from None
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


def leaves(parent: ET.Element, tag: str, /, **values: object) -> ET.Element:
    """Append an element whose values are child elements; values that are None are omitted."""
    element = added(parent, tag)
    for name, value in values.items():
        if value is not None:
            added(element, name, value)
    return element


def spelled(value: Any) -> str:
    """Convert a text, a number, or numbers to text with all digits."""
    if isinstance(value, str):
        return value
    return " ".join(repr(float(number) + 0.0) for number in np.ravel(value))


def numbers(text: str | None, count: int, where: str, default: Any = None, finite: bool = True) -> Array:
    """Return the numbers in a text, shape (count,), or ``default`` if the text is None."""
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
