"""A sheet of paper for technical drawings: arrows, moments, joints, dimensions, and labels in one style.

Every drawing has the opaque background ``PAPER``, so that it is legible on light and dark pages.
"""

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

PAPER, INK, GRAY = "#fbfbf8", "#2f2f2f", "#8a8a8a"
BASE, PLATFORM, LOWER, UPPER = "#3a3a3a", "#1f4e9c", "#2a8a4a", "#5aa873"
FORCE, MOMENT, AXIS = "#c1440e", "#b8860b", "#7a3fa0"
"""Colors of bodies, forces, moments, and axes, as in the drawing of the conventions."""

FONT = 12.0
"""Font size (pt)."""
DOTS = 150
"""Resolution (dots per inch)."""
COLORS = 96
"""Number of colors of a file."""
_SETTINGS = {"mathtext.fontset": "stixsans", "font.family": "DejaVu Sans", "font.size": FONT}


class Sheet:
    """A drawing in plane coordinates with equal scales.

    Parameters
    ----------
    width, height : float
        Size of the drawing (inches); one inch is one unit of the coordinates.
    """

    def __init__(self, width: float, height: float) -> None:
        from matplotlib import rc_context
        from matplotlib.figure import Figure

        with rc_context(_SETTINGS):
            self.figure: Figure = Figure(figsize=(width, height), facecolor=PAPER)
            self.axes: Any = self.figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.axes.set(xlim=(0.0, width), ylim=(0.0, height), aspect="equal")
        self.axes.set_axis_off()

    def line(self, *points: ArrayLike, color: str = INK, width: float = 1.5, style: str = "-") -> None:
        """Draw a line through points."""
        x, y = np.array([np.asarray(point, float) for point in points]).T
        self.axes.plot(x, y, color=color, linewidth=width, linestyle=style, solid_capstyle="round", zorder=2)

    def area(self, *points: ArrayLike, color: str, alpha: float = 0.25) -> None:
        """Fill a polygon and draw its outline."""
        from matplotlib.patches import Polygon

        corners = np.array([np.asarray(point, float) for point in points])
        self.axes.add_patch(Polygon(corners, closed=True, facecolor=color, alpha=alpha, zorder=1))
        self.axes.add_patch(
            Polygon(corners, closed=True, facecolor="none", edgecolor=color, linewidth=1.6, zorder=2)
        )

    def arrow(
        self, start: ArrayLike, end: ArrayLike, color: str = FORCE, width: float = 2.0, **style: Any
    ) -> None:
        """Draw an arrow from ``start`` to ``end``."""
        from matplotlib.patches import FancyArrowPatch

        shape = {"arrowstyle": "-|>", "mutation_scale": 16, "shrinkA": 0, "shrinkB": 0, "zorder": 4} | style
        ends = (tuple(np.asarray(start, float)), tuple(np.asarray(end, float)))
        self.axes.add_patch(FancyArrowPatch(*ends, color=color, linewidth=width, **shape))

    def turn(self, center: ArrayLike, radius: float, start: float, end: float, color: str = MOMENT) -> None:
        """Draw the arrow of a rotation about a point, between two angles (degrees)."""
        angles = np.radians(np.linspace(start, end, 40))
        curve = np.asarray(center, float) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        self.axes.plot(*curve[:-1].T, color=color, linewidth=2.0, zorder=4)
        self.arrow(curve[-3], curve[-1], color)

    def moment(self, start: ArrayLike, end: ArrayLike, color: str = MOMENT) -> None:
        """Draw a moment as an arrow with two heads along its axis."""
        start, end = np.asarray(start, float), np.asarray(end, float)
        back = (end - start) / float(np.linalg.norm(end - start))
        self.arrow(start, end - 0.12 * back, color)
        self.arrow(end - 0.2 * back, end, color)

    def text(self, at: ArrayLike, words: str, color: str = INK, side: str = "center", **style: Any) -> None:
        """Write words at a point."""
        looks = {"fontsize": FONT, "va": "center", "zorder": 6, "linespacing": 1.25} | style
        self.axes.text(*np.asarray(at, float), words, color=color, ha=side, **looks)

    def dot(self, at: ArrayLike, color: str = INK, size: float = 6.0) -> None:
        """Mark a point."""
        self.axes.plot(*np.asarray(at, float), "o", color=color, markersize=size, zorder=5)

    def joint(self, at: ArrayLike, color: str = INK) -> None:
        """Draw a joint as a circle."""
        self.axes.plot(
            *np.asarray(at, float),
            "o",
            color=color,
            markersize=11,
            markerfacecolor=PAPER,
            markeredgewidth=2.0,
            zorder=5,
        )

    def mass(self, at: ArrayLike, color: str = INK) -> None:
        """Draw a center of mass: a circle with two filled quarters."""
        from matplotlib.patches import Circle, Wedge

        x, y = np.asarray(at, float)
        self.axes.add_patch(Circle((x, y), 0.085, facecolor=PAPER, edgecolor=color, linewidth=1.4, zorder=5))
        for angle in (0.0, 180.0):
            self.axes.add_patch(Wedge((x, y), 0.085, angle, angle + 90.0, color=color, zorder=5))

    def dimension(
        self, start: ArrayLike, end: ArrayLike, words: str, away: ArrayLike, color: str = INK
    ) -> None:
        """Draw a dimension between two points, displaced by the vector ``away``, with words on its line."""
        start, end, away = (np.asarray(vector, float) for vector in (start, end, away))
        for point in (start, end):
            self.line(point + 0.15 * away, point + 1.12 * away, color=GRAY, width=0.8)
        self.arrow(start + away, end + away, color, 1.2, arrowstyle="<|-|>", mutation_scale=11)
        patch = {"facecolor": PAPER, "edgecolor": "none", "pad": 1.5}
        self.text(0.5 * (start + end) + away, words, color, fontsize=FONT - 1.0, bbox=patch)

    def body(self, start: ArrayLike, end: ArrayLike, width: float, color: str) -> None:
        """Draw a straight body between two points."""
        start, end = np.asarray(start, float), np.asarray(end, float)
        side = 0.5 * width * across(end - start)
        self.area(start + side, end + side, end - side, start - side, color=color)

    def ground(self, at: ArrayLike, width: float = 0.9) -> None:
        """Draw the fixed base below a point."""
        x, y = np.asarray(at, float)
        self.line((x - width / 2, y), (x + width / 2, y), color=BASE, width=2.0)
        for place in np.arange(x - width / 2 + 0.12, x + width / 2 + 0.01, 0.14):
            self.line((place, y), (place - 0.12, y - 0.14), color=BASE, width=1.0)

    def frame(
        self, at: ArrayLike, angle: float, length: float, names: Sequence[str], color: str, out: bool = True
    ) -> None:
        """Draw the axes of a frame, rotated by ``angle`` (degrees); a third axis points at the reader."""
        at = np.asarray(at, float)
        for turn, name in zip((angle, angle + 90.0), names, strict=False):
            way = direction(turn)
            self.arrow(at, at + length * way, color, 1.7, mutation_scale=13)
            self.text(at + (length + 0.2) * way, name, color)
        if out and len(names) > 2:
            self.dot(at, color, 4.0)
            self.text(at - 0.25 * direction(angle + 45.0), names[2], color)


def direction(angle: float) -> Array:
    """Return the unit vector at an angle (degrees) from the x axis."""
    return np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])


def across(vector: ArrayLike) -> Array:
    """Return the unit vector at 90 degrees, counterclockwise, from a vector of the plane."""
    x, y = np.asarray(vector, float)
    return np.array([-y, x]) / float(np.hypot(x, y))


def save(figure: "Figure", target: Path) -> None:
    """Write a drawing as PNG with a palette."""
    from matplotlib import rc_context
    from PIL import Image

    buffer = BytesIO()
    with rc_context(_SETTINGS):
        figure.savefig(buffer, dpi=DOTS, facecolor=PAPER, format="png")
    picture = Image.open(buffer).convert("RGB")
    picture.quantize(colors=COLORS, dither=Image.Dither.NONE).save(target, optimize=True)
