"""All drawings of the documentation, by the names of their files.

``python .docs/drawings/draw_all.py`` writes them.
"""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import conventions_drawing
import joint_drawings
import leg_drawings
import study_drawings
from drawing_sheet import save

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DRAWINGS: dict[str, Callable[[], "Figure"]] = {
    "conventions.png": conventions_drawing.figure,
    "drawings/data-flow.png": study_drawings.data_flow,
    "drawings/leg.png": leg_drawings.leg,
    "drawings/lower-part.png": leg_drawings.lower_part,
    "drawings/offset-joint.png": joint_drawings.offset_joint,
    "drawings/parts.png": leg_drawings.parts,
    "drawings/path-I.png": study_drawings.path_I,
    "drawings/platform.png": joint_drawings.platform,
    "drawings/tool-point.png": joint_drawings.tool_point,
    "drawings/universal-joint.png": joint_drawings.universal_joint,
    "drawings/upper-part.png": leg_drawings.upper_part,
}
"""Function that draws each file, below ``.docs``."""

if __name__ == "__main__":
    for name, draw in DRAWINGS.items():
        save(draw(), Path(__file__).parents[1] / name)
