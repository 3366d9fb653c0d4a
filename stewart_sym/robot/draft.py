"""First robot file from a few dimensions of a symmetric machine; comments in the file mark assumptions."""

import json
import math
from dataclasses import dataclass, fields
from importlib.resources import files
from string import Template

from ..io.arguments import number_in, option, safe_text
from ..io.toml_reader import one_line
from ..motion.trajectory_format import LENGTH_UNITS

# Fractions: mass of the lower part, length of each part relative to the longest leg, and its limit relative
# to the shortest leg.
_LOWER_MASS, _PART, _CLEAR = 0.7, 0.6, 0.95
# Radii relative to the leg length at the home pose, and of the plate relative to the platform joints.
_LOWER_RADIUS, _UPPER_RADIUS, _WALL, _RIM = 0.03, 0.02, 0.8, 1.15
_THICKNESS = 0.1
_WIDEST = 120.0
_GRAVITY = 9.81


@dataclass(frozen=True)
class Draft:
    """Dimensions of a machine with pairs of joints around three axes 120 degrees apart.

    All lengths have the unit ``length_unit``, masses are in kg, and angles between the joints of a pair are
    in degrees. The height is the distance of the platform joints above the base joints at the home pose. The
    platform mass includes the payload. Half of the stroke is on each side of the home pose.
    """

    name: str
    length_unit: str
    base_radius: float
    platform_radius: float
    base_angle: float
    platform_angle: float
    height: float
    platform_mass: float
    leg_mass: float
    stroke: float
    z_down: bool = False

    def __post_init__(self) -> None:
        one_line(self.name, "name")
        option(self.length_unit, tuple(LENGTH_UNITS), "length_unit")
        for each in fields(self):
            value = getattr(self, each.name)
            if each.name.endswith("_angle"):
                number_in(value, each.name, f"0 to {_WIDEST:g} degrees", 0.0, _WIDEST, closed=True)
            elif each.name not in ("name", "length_unit", "z_down"):
                number_in(value, each.name, "a number > 0")
        longest = self.leg_length + 0.5 * self.stroke
        if self.stroke >= 0.5 * longest:
            unit = self.length_unit
            most = f"below {2.0 / 3.0 * self.leg_length:.4g} {unit}, since a leg is longer than its stroke"
            raise ValueError(f"stroke: expected a number {most}, got {self.stroke:g} {unit}")

    @property
    def leg_length(self) -> float:
        """Length of every leg at the home pose."""
        turn = math.radians(60.0 - 0.5 * (self.base_angle + self.platform_angle))
        b, p = self.base_radius, self.platform_radius
        return math.sqrt(b * b + p * p - 2.0 * b * p * math.cos(turn) + self.height**2)

    def text(self) -> str:
        """Return the text of the robot file."""
        L = self.leg_length
        lower, upper = _LOWER_RADIUS * L, _UPPER_RADIUS * L
        template = (files(__package__) / "draft.toml.in").read_text(encoding="utf-8")
        return Template(template).substitute(
            name=json.dumps(safe_text(self.name), ensure_ascii=False),
            unit=self.length_unit,
            gravity=_number(_GRAVITY if self.z_down else -_GRAVITY),
            z="down" if self.z_down else "up",
            height=_number(-self.height if self.z_down else self.height),
            base_radius=_number(self.base_radius),
            # Legs from different pairs of the base form a pair at the platform.
            base_angles=_angles((0.0, 120.0, 240.0), self.base_angle, 0),
            platform_radius=_number(self.platform_radius),
            platform_angles=_angles((-60.0, 60.0, 180.0), self.platform_angle, 1),
            plate_radius=_short(_RIM * self.platform_radius),
            thickness=_short(_THICKNESS * self.platform_radius),
            platform_mass=_number(self.platform_mass),
            lower_radius=_short(lower),
            bore=_short(_WALL * lower),
            upper_radius=_short(upper),
            # Both parts together exceed the longest leg, and each part is shorter than the shortest leg.
            part=_short(min(_PART * (L + 0.5 * self.stroke), _CLEAR * (L - 0.5 * self.stroke))),
            lower_mass=_short(_LOWER_MASS * self.leg_mass),
            upper_mass=_short((1.0 - _LOWER_MASS) * self.leg_mass),
            back=_number(-0.5 * self.stroke),
            forth=_number(0.5 * self.stroke),
            length=_short(L),
            speed=_short(1.0 / LENGTH_UNITS[self.length_unit]),
        )


def _angles(pairs: tuple[float, float, float], apart: float, shift: int) -> str:
    """Return the joint angles of six legs in pairs around three axes; ``shift`` 1 splits the first pair."""
    found = [axis + side * 0.5 * apart for axis in pairs for side in (-1.0, 1.0)][shift:]
    found += [pairs[0] + 360.0 - 0.5 * apart] * shift
    return "[" + ", ".join(map(_number, found)) + "]"


def _number(value: float) -> str:
    """Format a number with all its digits."""
    return repr(float(value) + 0.0)


def _short(value: float) -> str:
    """Format an assumed or displayed number with four digits."""
    return repr(float(f"{value:.4g}"))
