"""Import of MJCF, the format of MuJoCo."""

import xml.etree.ElementTree as ET
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ...io import toml_reader
from ...io.arguments import shown
from ...io.array_types import Array
from ...motion.rotation import rotation_from_quaternion, rotation_from_vector, vector_from_rotation
from ...robot.bodies import Body as Solid
from ...robot.bodies import joined
from ...robot.fields import direction
from ..model import BETWEEN, WORLD, Body, Joint, Model, after
from ..notes import json_table
from .mjcf_attributes import (
    MOTOR,
    SWITCHED,
    Attributes,
    actuator,
    disabled,
    first,
    merged,
    over,
    stated,
    times,
)
from .mjcf_geoms import solid
from .xml_text import at_line, number, numbers, turn_limits

_KINDS = {"hinge": "revolute", "slide": "prismatic", "ball": "spherical", "free": "free"}
_ZERO = (0.0, 0.0, 0.0)
_ENDLESS = (-np.inf, np.inf)
_STRAIGHT = 1e-10
_JOINT_KEYS = (
    *("name", "class", "group", "user", "align", "type", "pos", "axis", "ref", "damping", "armature"),
    *("range", "limited", "margin", "actuatorfrcrange", "actuatorfrclimited", "actuatorgravcomp"),
    *("stiffness", "springref", "springyield", "springdamper", "frictionloss"),
    *("solreflimit", "solimplimit", "solreffriction", "solimpfriction"),
)
"""All attributes of a joint in MuJoCo."""
_PASSED_OVER = (
    *("compiler", "option", "size", "custom", "default", "asset", "visual", "statistic", "worldbody"),
    *("equality", "actuator", "keyframe", "sensor", "contact", "extension"),
)
"""Sections that are read, or that do not affect the passive motion of a robot."""
_ALIGNED = "freejoint align: MuJoCo moves to the center of mass, and turns, the frame"


class _Push(NamedTuple):
    """Effect of an actuator on its joint: range of the force (N), shape (2,), damping, and armature."""

    where: str
    forces: Array
    damping: float
    armature: float


def model(root: ET.Element, loops: str | None = None) -> Model:
    """Convert the elements of a file to a model; raise ValueError with a location on failure."""
    return _Reader(root).model()


class _Reader:
    """Reader of one file; repeated elements, for example of included files, are read in order."""

    def __init__(self, root: ET.Element) -> None:
        """Read the global settings of the file."""
        for element in root.iter():
            if element.tag in ("include", "replicate", "attach", "composite", "flexcomp"):
                where = f"{element.tag}{at_line(element)}"
                got = shown(element.get("file") or element.get("name") or element.tag)
                raise ValueError(f"{where}: expected a flat model, as mj_saveLastXML writes it, got {got}")
        self.root = root
        compiler = merged(root, ".//compiler")
        self.unit = 1.0 if compiler.get("angle", "degree") == "radian" else np.pi / 180.0
        self.order = compiler.get("eulerseq", "xyz")
        self.aligning = compiler.get("alignfree", "false")
        # Bodies whose frames MuJoCo moves, with True if the axes of the new frame are known.
        self.aligned: dict[str, bool] = {}
        self.autolimits = compiler.get("autolimits", "true") == "true"
        self.from_geoms = compiler.get("inertiafromgeom", "auto") == "true"
        self.groups = numbers(compiler.get("inertiagrouprange"), 2, "compiler: inertiagrouprange", (0.0, 5.0))
        if compiler.get("coordinate", "local") != "local":
            raise ValueError(f"compiler: coordinate: expected local, got {shown(compiler['coordinate'])}")
        if len(self.order) != 3 or not set(self.order.lower()) <= set("xyz"):
            raise ValueError(f"compiler: eulerseq: expected three of x, y, z, got {shown(self.order)}")
        self.option = merged(root, "option")
        self.disabled = disabled(root)
        self.off = {key for flag in self.disabled for key in SWITCHED.get(flag, ())}
        self.classes: dict[str, dict[str, dict[str, str]]] = {}
        for each in root.findall("default"):
            self._default(each, self.classes.get("main", {}), "main")
        self.bodies: list[Body] = [Body(WORLD)]
        self.joints: list[Joint] = []
        self.sites: dict[str, tuple[str, Array, Array]] = {}
        self.forces: dict[str, tuple[str, Array]] = {}
        self.total = number(compiler.get("settotalmass"), "compiler: settotalmass", -1.0)
        masses = ("boundmass", "boundinertia", "balanceinertia")
        self.left_out = [f"{key} of the compiler" for key in masses if key in compiler]
        if "actuation" in self.disabled or "actuatorgroupdisable" in self.option:
            self.left_out.append("that the option disables actuators")
        # Actuators by their limits in the two directions.
        self.uneven: dict[tuple[float, float], list[str]] = {}
        self.servos: list[str] = []

    def model(self) -> Model:
        """Read the model."""
        for world in self.root.findall("worldbody"):
            self._inside(world, WORLD, np.eye(3), np.zeros(3), None)
        if self.total > 0.0:
            scale = self.total / (sum(body.mass for body in self.bodies) or 1.0)
            self.bodies = [
                replace(body, mass=scale * body.mass, inertia=scale * body.inertia) for body in self.bodies
            ]
        for section in self.root.findall("equality"):
            for each in section:
                self._closure(each)
        for each in self.root:
            if each.tag not in _PASSED_OVER:
                self.left_out.append(f"section {each.tag!r} of the file")
        gravity = numbers(self.option.get("gravity"), 3, "option: gravity", (0.0, 0.0, -9.81))
        if "gravity" in self.disabled:
            gravity = np.zeros(3)
        for key in ("density", "viscosity"):
            if key not in self.off and number(self.option.get(key), f"option: {key}", 0.0):
                self.left_out.append(f"{key} of the medium around the machine")
        custom = self.root.find("custom/text[@name='stewart_sym']")
        # MuJoCo writes quotation marks as text inside the element.
        notes = None if custom is None else custom.get("data", custom.text)
        driven = tuple(self._driven())
        for (least, most), where in self.uneven.items():
            actuators, other = ", ".join(where), f"{most:g} N, the other's, is force_limit"
            self.left_out.append(f"the limit of {least:g} N in one direction of {actuators}: {other}")
        if self.servos:
            limited = "force_limit follows from limits of their forces, not of their controls"
            self.left_out.append(f"gain, bias and dynamics of {', '.join(self.servos)}: {limited}")
        return Model(
            self.root.get("model", "MuJoCo Model"),
            gravity,
            tuple(self.bodies),
            driven,
            json_table(notes, "custom: text 'stewart_sym'"),
            tuple(dict.fromkeys(self.left_out)),
            assumed={name: f"{_ALIGNED} of {name!r}, which is taken" for name in self.aligned},
            armatures=True,
        )

    # Defaults

    def _default(self, element: ET.Element, outer: dict[str, dict[str, str]], name: str) -> None:
        """Read the defaults of a class and of its subclasses."""
        own = {tag: dict(values) for tag, values in outer.items()}
        for each in element:
            if each.tag != "default":
                tag, given = stated(each)
                own[tag] = over(own.get(tag, {}), given)
        self.classes[element.get("class", name)] = own
        for each in element.findall("default"):
            self._default(each, own, "main")

    def _of(self, element: ET.Element, inherited: str | None) -> dict[str, str]:
        """Return the attributes of an element with the defaults of its class, without disabled ones."""
        name = element.get("class") or inherited or "main"
        if name not in self.classes and name != "main":
            raise ValueError(f"{element.tag} {element.get('name', '')!r}: class {name!r}: missing")
        tag, given = stated(element)
        found = over(self.classes.get(name, {}).get(tag, {}), given)
        return {key: value for key, value in found.items() if key not in self.off}

    # Tree

    def _inside(self, element: ET.Element, name: str, R: Array, t: Array, inherited: str | None) -> None:
        """Read sites and bodies of a body or frame with the pose R, t in the world frame."""
        for each in element:
            if each.tag == "body":
                self._body(each, name, R, t, inherited)
            elif each.tag == "frame":
                turn, place = self._pose(each.attrib, "frame")
                self._inside(each, name, R @ turn, t + R @ place, each.get("childclass") or inherited)
            elif each.tag == "site" and "name" in each.attrib:
                turn, place = self._pose(self._of(each, inherited), f"site {each.attrib['name']!r}")
                body = next(body for body in self.bodies if body.name == name)
                own = np.array_equal(R, body.R) and np.array_equal(t, body.t)
                inside = place if own else body.local(t + R @ place)
                self.sites[each.attrib["name"]] = name, R @ turn, inside

    def _body(self, element: ET.Element, parent: str, R: Array, t: Array, inherited: str | None) -> None:
        """Read a body with its joints, inertia, and children."""
        name = element.get("name") or f"body {len(self.bodies)}"
        where = f"body {name!r}"
        inherited = element.get("childclass") or inherited
        turn, place = self._pose(element.attrib, where)
        R, t = after((R, t), turn, place)
        if "gravcomp" not in self.off and number(element.get("gravcomp"), f"{where}: gravcomp", 0.0):
            self.left_out.append(f"gravcomp of {where}")
        joints = self._joints(element, name, inherited)
        at = parent
        for number_, (attributes, kind) in enumerate(joints, 1):
            last = number_ == len(joints)
            child = name if last else f"{name}{BETWEEN}{number_}"
            if not last:
                self.bodies.append(Body(child, R, t))
            self.joints.append(self._joint(attributes, kind, at, child, R, where))
            at = child
        if not joints:
            self.joints.append(Joint(f"{name}, fixed", "fixed", parent, name))
        body = self._with_inertia(Body(name, R, t), element, inherited, where)
        if self._aligns(element):
            body, self.aligned[name] = _in_inertial_frame(body, self._axes_of_inertia(element, where))
        self.bodies.append(body)
        self._inside(element, name, R, t, inherited)

    def _joints(self, element: ET.Element, name: str, inherited: str | None) -> list[tuple[Attributes, str]]:
        """Return attributes and kinds of the joints of a body."""
        found: list[tuple[Attributes, str]] = []
        for each in element:
            if each.tag == "freejoint":
                found.append((each.attrib, "free"))
            elif each.tag == "joint":
                attributes = self._of(each, inherited)
                kind = _KINDS.get(attributes.get("type", "hinge"))
                if kind is None:
                    where = f"body {name!r}: joint {attributes.get('name', '')!r}"
                    got = shown(attributes["type"])
                    raise ValueError(f"{where}: type: expected hinge, slide, ball or free, got {got}")
                found.append((attributes, kind))
            elif each.tag == "frame" and _has_joint(each):
                raise ValueError(
                    f"body {name!r}: frame{at_line(each)}: expected no joint in a frame, got one"
                )
        return found

    def _joint(self, given: Attributes, kind: str, parent: str, child: str, R: Array, where: str) -> Joint:
        """Create a joint from its attributes."""
        name = given.get("name") or f"joint {len(self.joints) + 1}"
        where = f"{where}: joint {name!r}"
        toml_reader.checked_table(given, f"{where}: ", _JOINT_KEYS)
        axes = np.zeros((0, 3))
        if kind in ("revolute", "prismatic"):
            axis = numbers(given.get("axis"), 3, f"{where}: axis", (0.0, 0.0, 1.0))
            axes = (R @ direction(axis, f"{where}: axis"))[None]
        for key in ("stiffness", "springdamper", "frictionloss"):
            if any(number(each, f"{where}: {key}") for each in given.get(key, "0").split()):
                self.left_out.append(f"{key} of joint {name!r}")
        limits = self._range(given, "range", "limited", where)
        if kind in ("revolute", "spherical"):
            self.left_out += turn_limits(self.unit * limits, f"joint {name!r}")
        self.forces[name] = where, self._range(given, "actuatorfrcrange", "actuatorfrclimited", where)
        return Joint(
            name,
            kind,
            parent,
            child,
            numbers(given.get("pos"), 3, f"{where}: pos", _ZERO),
            axes,
            number(given.get("damping"), f"{where}: damping", 0.0),
            number(given.get("armature"), f"{where}: armature", 0.0),
            number(given.get("ref"), f"{where}: ref", 0.0),
            (float(limits[0]), float(limits[1])),
        )

    def _range(self, given: Attributes, key: str, flag: str, where: str) -> Array:
        """Return lower and upper limits, shape (2,); infinite without limits."""
        stated = given.get(flag, "auto")
        limited = stated == "true" or (stated == "auto" and self.autolimits and key in given)
        default = (0.0, 0.0) if key == "range" else None
        return numbers(given.get(key), 2, f"{where}: {key}", default) if limited else np.array(_ENDLESS)

    def _larger(self, limits: Array, where: str) -> float:
        """Return one force limit for both directions, and record different limits."""
        low, high = np.abs(limits)
        if low != high:
            self.uneven.setdefault((min(low, high), max(low, high)), []).append(where)
        return float(max(low, high))

    def _with_inertia(self, body: Body, element: ET.Element, inherited: str | None, where: str) -> Body:
        """Return the body with its mass properties."""
        given = element.find("inertial")
        if given is None or self.from_geoms:
            parts = self._solids(element, inherited, where)
            whole = joined(parts) if parts else Solid(body.mass, body.center, body.inertia)
            return replace(body, mass=whole.mass, center=whole.center_of_mass, inertia=whole.inertia)
        where = f"{where}: inertial"
        mass = number(given.get("mass"), f"{where}: mass")
        R, center = self._pose(given.attrib, where)
        if "fullinertia" in given.attrib:
            xx, yy, zz, xy, xz, yz = numbers(given.get("fullinertia"), 6, f"{where}: fullinertia")
            inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        else:
            inertia = R @ np.diag(numbers(given.get("diaginertia"), 3, f"{where}: diaginertia")) @ R.T
        return replace(body, mass=mass, center=center, inertia=0.5 * (inertia + inertia.T))

    def _aligns(self, element: ET.Element) -> bool:
        """Return True if MuJoCo moves the body frame to the inertial frame (free body without children)."""
        free = element.find("freejoint")
        if free is None or element.find(".//body") is not None:
            return False
        stated = free.get("align", "auto")
        return (self.aligning if stated == "auto" else stated) == "true"

    def _axes_of_inertia(self, element: ET.Element, where: str) -> Array | None:
        """Return the principal axes in the body frame, (3, 3), or None if the file does not contain them."""
        given = element.find("inertial")
        if given is None or self.from_geoms or "fullinertia" in given.attrib:
            return None
        return self._turn(given.attrib, where)

    def _solids(self, element: ET.Element, inherited: str | None, where: str) -> list[Solid]:
        """Return the mass properties of the geoms of a body, including geoms in frames."""
        found = []
        for each in element:
            if each.tag == "geom":
                given, named = self._of(each, inherited), f"{where}: geom {each.get('name', '')!r}"
                if not self.groups[0] <= number(given.get("group"), f"{named}: group", 0.0) <= self.groups[1]:
                    continue
                if given.get("shellinertia", "false") == "true":
                    self.left_out.append(f"that {named} is a shell")
                part = solid(given, *self._pose(given, named), named)
                found += [] if part is None else [part]
            elif each.tag == "frame":
                R, t = self._pose(each.attrib, where)
                parts = self._solids(each, each.get("childclass") or inherited, where)
                found += [Solid(mass, t + R @ center, R @ inertia @ R.T) for mass, center, inertia in parts]
        return found

    def _pose(self, given: Attributes, where: str) -> tuple[Array, Array]:
        """Return orientation, shape (3, 3), and position, shape (3,)."""
        return self._turn(given, where), numbers(given.get("pos"), 3, f"{where}: pos", _ZERO)

    def _turn(self, given: Attributes, where: str) -> Array:
        """Return the orientation, shape (3, 3)."""
        if "quat" in given:
            quaternion = numbers(given["quat"], 4, f"{where}: quat")
            if not quaternion.any():
                raise ValueError(f"{where}: quat: expected a quaternion with a length, got {given['quat']!r}")
            return rotation_from_quaternion(quaternion)
        if "axisangle" in given:
            *axis, angle = numbers(given["axisangle"], 4, f"{where}: axisangle")
            return rotation_from_vector(self.unit * angle * direction(np.array(axis), f"{where}: axisangle"))
        if "euler" in given:
            return self._euler(self.unit * numbers(given["euler"], 3, f"{where}: euler"))
        if "xyaxes" in given:
            x, y = numbers(given["xyaxes"], 6, f"{where}: xyaxes").reshape(2, 3)
            x = direction(x, f"{where}: xyaxes")
            y = direction(y - (x @ y) * x, f"{where}: xyaxes")
            return np.stack([x, y, np.cross(x, y)], axis=-1)
        if "zaxis" in given:
            return _least_turn(direction(numbers(given["zaxis"], 3, f"{where}: zaxis"), f"{where}: zaxis"))
        return np.eye(3)

    def _euler(self, angles: Array) -> Array:
        """Compute the rotation by ``eulerseq``: small letters are moving axes, capital letters fixed axes."""
        R = np.eye(3)
        for letter, angle in zip(self.order, angles, strict=True):
            vector = angle * np.eye(3)["xyz".index(letter.lower())]
            turn = rotation_from_vector(vector)
            R = R @ turn if letter.islower() else turn @ R
        return R

    # Closures and drives

    def _closure(self, element: ET.Element) -> None:
        """Read a loop closure or a weld."""
        name = element.get("name") or f"{element.tag} {len(self.joints) + 1}"
        where = f"equality: {element.tag} {name!r}"
        if element.tag not in ("connect", "weld"):
            self.left_out.append(f"equality {element.tag} {name!r}")
            return
        if element.get("active") == "false":
            return
        kind, R, Q = "spherical" if element.tag == "connect" else "fixed", np.eye(3), np.eye(3)
        if "site1" in element.attrib or "site2" in element.attrib:
            ends = [self._site(element.get(key), where) for key in ("site1", "site2")]
            (one, R, here), (other, Q, there) = ends
        elif "body1" not in element.attrib:
            raise ValueError(f"{where}: expected body1, or site1 and site2, got none")
        else:
            one, other = element.attrib["body1"], element.get("body2", WORLD)
            placed = {body.name: body for body in self.bodies}
            for body in (one, other):
                if body not in placed:
                    raise ValueError(f"{where}: body {body!r}: missing")
            for body in (one, other):
                if not self.aligned.get(body, True):
                    expected = f"expected site1 and site2, since MuJoCo turns the frame of {body!r}"
                    raise ValueError(f"{where}: {expected} (freejoint align), got bodies")
            least = None if kind == "spherical" else _ZERO
            here = numbers(element.get("anchor"), 3, f"{where}: anchor", least)
            # The pose of the second body relative to the first one; the anchor is in the second body.
            pose = numbers(element.get("relpose"), 7, f"{where}: relpose", np.zeros(7))
            if kind == "fixed" and pose[3:].any():
                here, there = pose[:3], here
                R, Q = placed[one].R @ rotation_from_quaternion(pose[3:]), placed[other].R
            else:
                there = placed[other].local(placed[one].placed(here))
        angle = float(np.linalg.norm(vector_from_rotation(R.T @ Q)))
        cut = Joint(name, kind, one, other, there, position=angle, cut=True, parent_point=here)
        self.joints.append(cut)

    def _site(self, name: str | None, where: str) -> tuple[str, Array, Array]:
        """Return the body, orientation, and position of a site."""
        if name is None:
            raise ValueError(f"{where}: expected site1 and site2, got one")
        if name not in self.sites:
            raise ValueError(f"{where}: site {name!r}: missing")
        return self.sites[name]

    def _driven(self) -> list[Joint]:
        """Return the joints with the limits of their actuators."""
        pushes: dict[str, list[_Push]] = {}
        slides = {joint.name for joint in self.joints if joint.kind == "prismatic"}
        for section in self.root.findall("actuator"):
            for each in section:
                given = self._of(each, None)
                joint = given.get("joint", given.get("jointinparent"))
                where = actuator(given)
                if joint not in slides:
                    self.left_out.append(f"{where}, which does not drive a prismatic joint")
                else:
                    pushes.setdefault(joint, []).append(self._push(given, where))
        return [
            joint if joint.cut else self._pushed(joint, pushes.get(joint.name, [])) for joint in self.joints
        ]

    def _push(self, given: Attributes, where: str) -> _Push:
        """Return the effect of an actuator on its joint."""
        forces = self._range(given, "forcerange", "forcelimited", where)
        if all(given.get(key, usual) == usual for key, usual in MOTOR.items()):
            controls = self._range(given, "ctrlrange", "ctrllimited", where)
            forces = np.clip(times(first(given, "gainprm", where), controls), *forces)
        else:
            self.servos.append(where)
        gear = first(given, "gear", where)
        damping, armature = (
            gear**2 * number(given.get(key), f"{where}: {key}", 0.0) for key in ("damping", "armature")
        )
        return _Push(where, times(gear, forces), damping, armature)

    def _pushed(self, joint: Joint, pushes: list[_Push]) -> Joint:
        """Return the joint with the combined effect of its actuators, limited by its own force limits."""
        where, limits = self.forces.get(joint.name, ("", np.array(_ENDLESS)))
        if pushes:
            where = " and ".join(each.where for each in pushes)
            limits = np.clip(np.sum([each.forces for each in pushes], axis=0), *limits)
        return replace(
            joint,
            damping=joint.damping + sum(each.damping for each in pushes),
            armature=joint.armature + sum(each.armature for each in pushes),
            effort=self._larger(limits, where),
            driven=bool(pushes),
        )


def _in_inertial_frame(body: Body, axes: Array | None) -> tuple[Body, bool]:
    """Move the frame of a body to its inertial frame; return True as well if the axes in MuJoCo are known.

    The argument ``axes`` contains the principal axes in the body frame, shape (3, 3), or is None if MuJoCo
    computes them.
    """
    known = axes is not None
    if axes is None:
        # MuJoCo sorts the moments in descending order.
        axes = np.linalg.eigh(body.inertia)[1][:, ::-1]
        moments = np.diag(body.inertia)
        if not (body.inertia - np.diag(moments)).any() and np.all(np.diff(moments) <= 0.0):
            axes, known = np.eye(3), True
        axes = axes * np.sign(np.linalg.det(axes))
    inertia = axes.T @ body.inertia @ axes
    moved = Body(body.name, body.R @ axes, body.placed(body.center), body.mass)
    return replace(moved, inertia=0.5 * (inertia + inertia.T)), known


def _least_turn(z: Array) -> Array:
    """Return the smallest rotation of (0, 0, 1) to a direction, shape (3,); for (0, 0, -1) it is about x."""
    across = np.array([-z[1], z[0], 0.0])
    sine = float(np.linalg.norm(across))
    axis = across / sine if sine > _STRAIGHT else np.array([1.0, 0.0, 0.0])
    return rotation_from_vector(np.arctan2(sine, z[2]) * axis)


def _has_joint(frame: ET.Element) -> bool:
    """Return True if a frame, or a frame in it, contains a joint."""
    return any(
        each.tag in ("joint", "freejoint") or (each.tag == "frame" and _has_joint(each)) for each in frame
    )
