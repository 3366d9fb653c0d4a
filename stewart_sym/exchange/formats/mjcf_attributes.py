"""Attributes of MJCF elements: with classes, of actuators as general ones, and without disabled flags."""

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
"""Attributes without effect where a flag is disabled; ``passive``, an old one, is springs and dampers."""
_ACTUATORS = (
    *("general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle"),
    *("adhesion", "dcmotor", "plugin"),
)
"""Elements of one kind of thing: the defaults of a class are those of all of them."""
MOTOR = {"dyntype": "none", "gaintype": "fixed", "biastype": "none"}
"""What a general actuator is that pushes with its control times a gain."""
_SERVO = {"gaintype": "fixed", "biastype": "affine"}
_AS_GENERAL = {
    "general": {},
    "motor": {**MOTOR, "gainprm": "1"},
    "adhesion": {**MOTOR, "ctrllimited": "true"},
    "damper": {**MOTOR, "gaintype": "affine"},
    **dict.fromkeys(("position", "velocity", "intvelocity", "cylinder"), _SERVO),
}
"""What the other elements set of a general actuator."""
_TRANSMISSIONS = {"jointinparent": "joint", "cranksite": "site", "slidersite": "site"}
"""Attributes that name what an actuator acts on; others are called as what they name."""
_GAINS = {"position": "kp", "velocity": "kv", "intvelocity": "kp", "cylinder": "area", "adhesion": "gain"}

Attributes = Mapping[str, str]


def merged(root: ET.Element, path: str) -> dict[str, str]:
    """Attributes of all elements at a path, those of later ones over those of earlier ones."""
    return {key: value for each in root.findall(path) for key, value in each.attrib.items()}


def disabled(root: ET.Element) -> set[str]:
    """Flags that are disabled; ValueError for those without which nothing closes loops."""
    flags = {key for key, value in merged(root, "option/flag").items() if value == "disable"}
    for key in ("constraint", "equality"):
        if key in flags:
            raise ValueError(f"option: flag: {key}: expected enable, since it closes loops, got disable")
    return flags | {"passive"} if {"spring", "damper"} <= flags else flags


def stated(element: ET.Element) -> tuple[str, dict[str, str]]:
    """What an element is and its attributes; of an actuator those of a general one."""
    if element.tag not in _ACTUATORS:
        return element.tag, element.attrib
    found = {**element.attrib, **_AS_GENERAL.get(element.tag, {"biastype": element.tag})}
    gain = element.get(_GAINS.get(element.tag, ""))
    return "general", found if gain is None else {**found, "gainprm": gain}


def first(given: Attributes, key: str, where: str) -> float:
    """The first one of several numbers; 1 where there are none."""
    return number(next(iter(given.get(key, "1").split()), ""), f"{where}: {key}")


def times(factor: float, limits: Array) -> Array:
    """Limits from low to high, (2,), of what they limit times a factor."""
    return np.sort(factor * limits) if factor else np.zeros(2)


def actuator(given: Attributes) -> str:
    """What messages call an actuator: by its name, or by what it acts on."""
    if given.get("name"):
        return f"actuator {given['name']!r}"
    for key in ("joint", "tendon", "body", "site", *_TRANSMISSIONS):
        if key in given:
            return f"actuator of {_TRANSMISSIONS.get(key, key)} {given[key]!r}"
    return "actuator without a name"


def over(usual: Attributes, given: Attributes) -> dict[str, str]:
    """Attributes over those of a class: an orientation replaces any other, a size the first numbers alone."""
    turned = _TURNS if any(key in given for key in _TURNS) else ()
    found = {key: value for key, value in usual.items() if key not in turned} | dict(given)
    if "size" in usual and "size" in given:
        own = given["size"].split()
        found["size"] = " ".join(own + usual["size"].split()[len(own) :])
    return found
