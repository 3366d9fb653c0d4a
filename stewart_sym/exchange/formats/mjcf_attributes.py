"""Attributes of MJCF elements: class defaults, general actuators, and effects of disabled flags."""

import xml.etree.ElementTree as ET
from collections.abc import Mapping

import numpy as np

from ...io.array_types import Array
from .xml_text import number

_TURNS = ("quat", "axisangle", "euler", "xyaxes", "zaxis")
SWITCHED = {
    "spring": ("stiffness",),
    "damper": ("damping",),
    "passive": ("stiffness", "damping", "springdamper", "gravcomp", "density", "viscosity"),
    "frictionloss": ("frictionloss",),
    "limit": ("range", "limited"),
    "clampctrl": ("ctrlrange", "ctrllimited"),
}
"""Attributes without effect if a flag is disabled; the old flag ``passive`` disables springs and dampers."""
_ACTUATORS = (
    *("general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle"),
    *("adhesion", "dcmotor", "plugin"),
)
"""Elements of one kind, which share the defaults of a class."""
MOTOR = {"dyntype": "none", "gaintype": "fixed", "biastype": "none"}
"""Attributes of a general actuator whose force is its control times a gain."""
_SERVO = {"gaintype": "fixed", "biastype": "affine"}
_AS_GENERAL = {
    "general": {},
    "motor": {**MOTOR, "gainprm": "1"},
    "adhesion": {**MOTOR, "ctrllimited": "true"},
    "damper": {**MOTOR, "gaintype": "affine"},
    **dict.fromkeys(("position", "velocity", "intvelocity", "cylinder"), _SERVO),
}
"""Attributes of a general actuator that the other elements set."""
_TRANSMISSIONS = {"jointinparent": "joint", "cranksite": "site", "slidersite": "site"}
"""Attributes that name the object of an actuator by another word than the tag of the object."""
_GAINS = {"position": "kp", "velocity": "kv", "intvelocity": "kp", "cylinder": "area", "adhesion": "gain"}

Attributes = Mapping[str, str]


def merged(root: ET.Element, path: str) -> dict[str, str]:
    """Merge the attributes of all elements at a path; later elements override earlier ones."""
    return {key: value for each in root.findall(path) for key, value in each.attrib.items()}


def disabled(root: ET.Element) -> set[str]:
    """Return the disabled flags; ValueError if one of them is needed to close loops."""
    flags = {key for key, value in merged(root, "option/flag").items() if value == "disable"}
    for key in ("constraint", "equality"):
        if key in flags:
            raise ValueError(f"option: flag: {key}: expected enable, since it closes loops, got disable")
    return flags | {"passive"} if {"spring", "damper"} <= flags else flags


def stated(element: ET.Element) -> tuple[str, dict[str, str]]:
    """Return the tag and the attributes of an element; an actuator becomes a general one."""
    if element.tag not in _ACTUATORS:
        return element.tag, element.attrib
    found = {**element.attrib, **_AS_GENERAL.get(element.tag, {"biastype": element.tag})}
    gain = element.get(_GAINS.get(element.tag, ""))
    return "general", found if gain is None else {**found, "gainprm": gain}


def first(given: Attributes, key: str, where: str) -> float:
    """Return the first one of several numbers, or 1 if there is none."""
    return number(next(iter(given.get(key, "1").split()), ""), f"{where}: {key}")


def times(factor: float, limits: Array) -> Array:
    """Multiply limits by a factor and sort them from low to high, (2,)."""
    return np.sort(factor * limits) if factor else np.zeros(2)


def actuator(given: Attributes) -> str:
    """Return the name of an actuator for messages, from its own name or from its object."""
    if given.get("name"):
        return f"actuator {given['name']!r}"
    for key in ("joint", "tendon", "body", "site", *_TRANSMISSIONS):
        if key in given:
            return f"actuator of {_TRANSMISSIONS.get(key, key)} {given[key]!r}"
    return "actuator without a name"


def over(usual: Attributes, given: Attributes) -> dict[str, str]:
    """Override the attributes of a class: an orientation replaces any other, a size its first numbers."""
    turned = _TURNS if any(key in given for key in _TURNS) else ()
    found = {key: value for key, value in usual.items() if key not in turned} | dict(given)
    if "size" in usual and "size" in given:
        own = given["size"].split()
        found["size"] = " ".join(own + usual["size"].split()[len(own) :])
    return found
