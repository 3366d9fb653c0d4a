"""Picture of a workspace: planes through the pose in the middle, by condition number and broken limit."""

from typing import Any

import numpy as np

from ...design.pose_limits import INSIDE, REASONS
from ...design.workspace import Workspace
from ..common.drawing import DARK, Axes, Figure, as_written, legend_below, new_figure
from ..common.report import SMALL, Picture
from .workspace import AXES, Slice, title

_OUTSIDE = ("#ffffff", "#d9d9d9", "#c6d8ee", "#e6cfe8", "#f3d9b1", "#f4c2c2", "#d5e8c8")
"""Colours of the limits, in the order of ``REASONS``; what is inside is coloured by its condition number."""
_MOST = 100.0
# The colours span at least this ratio of condition numbers.
_LEAST_RATIO = 1.5
# Width of a row of panels, inches; least and greatest width over height of a panel.
_WIDTH, _SHAPES = 9.4, (0.4, 2.5)


def pictures(name: str, found: Workspace, planes: list[Slice]) -> dict[str, Picture]:
    """``slices``."""
    return {"slices": Picture(lambda: figure(name, found, planes), SMALL)}


def figure(name: str, found: Workspace, planes: list[Slice]) -> Figure:
    """A panel for each plane; ``name``: of the robot."""
    shapes = np.array([_shape(plane) for plane in planes]).reshape(-1, 3)
    # A row is as wide as the picture; a picture of one row has panels of one height.
    widths = _WIDTH * shapes.mean(axis=0) / shapes.mean(axis=0).sum()
    heights = (widths / shapes).max(axis=1)
    drawn = new_figure(12.0, 1.6 + float(np.sum(heights + 0.6)))
    from matplotlib.patches import Patch
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    panels = drawn.subplots(
        len(shapes), 3, squeeze=False, width_ratios=widths.tolist(), height_ratios=heights.tolist()
    )
    norm = _norm(planes)
    mesh: Any = None
    for axes, plane in zip(panels.ravel(), planes, strict=True):
        mesh = _draw(axes, plane, norm)
        middle = np.concatenate([found.position, found.angles])
        scale = _scale(plane)
        axes.plot(*(scale * middle[list(plane.axes)]), marker="+", color=DARK, markersize=9.0)
    bar = drawn.colorbar(mesh, ax=panels, label="scaled condition number", shrink=0.8, extend="max")
    bar.ax.yaxis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.4g}"))
    bar.ax.yaxis.set_minor_formatter(NullFormatter())
    size = f"{found.volume:.4g} ± {found.error:.1g} {found.unit.replace('^3', '³')}"
    drawn.suptitle(
        f"{as_written(name)}: {title(found)}\n{size}; planes through the pose marked +", fontsize=10.0
    )
    broken = sorted({int(code) for plane in planes for code in np.unique(plane.codes)} - {INSIDE})
    handles = [Patch(facecolor=_OUTSIDE[code], label=REASONS[code]) for code in broken]
    if handles:
        legend_below(drawn, handles, title="first limit that breaks")
    return drawn


def _shape(plane: Slice) -> float:
    """Width over height of a panel, within what a picture has room for."""
    return float(np.clip(np.ptp(plane.first) / np.ptp(plane.second), *_SHAPES))


def _norm(planes: list[Slice]) -> Any:
    from matplotlib.colors import LogNorm

    inside = np.concatenate([plane.condition[plane.codes == INSIDE] for plane in planes])
    inside = inside[np.isfinite(inside)]
    low = float(inside.min(initial=_MOST))
    high = float(np.quantile(inside, 0.99)) if inside.size else _MOST
    return LogNorm(low, min(max(high, _LEAST_RATIO * low), max(_MOST, _LEAST_RATIO * low)))


def _scale(plane: Slice) -> float:
    return 1.0 if plane.axes[0] < 3 else float(np.degrees(1.0))


def _draw(axes: Axes, plane: Slice, norm: Any) -> Any:
    from matplotlib.colors import ListedColormap

    first, second = _scale(plane) * plane.first, _scale(plane) * plane.second
    colors = ListedColormap(list(_OUTSIDE))
    axes.grid(False)
    axes.pcolormesh(
        first, second, plane.codes.T, cmap=colors, vmin=-0.5, vmax=len(_OUTSIDE) - 0.5, rasterized=True
    )
    shown = np.ma.masked_where(plane.codes != INSIDE, plane.condition)
    mesh = axes.pcolormesh(first, second, shown.T, cmap="viridis_r", norm=norm, rasterized=True)
    if 0 < np.count_nonzero(plane.codes == INSIDE) < plane.codes.size:
        axes.contour(
            first, second, (plane.codes == INSIDE).T.astype(float), levels=[0.5], colors=DARK, linewidths=0.9
        )
    axes.set_aspect("equal")
    unit = "m" if plane.axes[0] < 3 else "degrees"
    names = [AXES[i] if i < 3 else ("roll", "pitch", "yaw")[i - 3] for i in plane.axes]
    axes.set(xlabel=f"{names[0]}, {unit}", ylabel=f"{names[1]}, {unit}")
    return mesh
